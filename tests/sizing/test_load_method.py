"""A tanker sized by loads of a named method: what is recalled counts only by its name."""

from __future__ import annotations

from typing import Any

import pytest

from catopt.errors import InputError
from tests.sizing.at_rest import size_tanker

TANKER: dict[str, Any] = {
    "length": "234 m", "breadth": "31.3 m", "draught": "12.4 m", "moulded_depth": "16 m",
    "depth": "20 m", "wind": "20 m/s", "current": "1.2 m/s", "hmax": "3.5 m", "period": "8 s",
}  # fmt: skip
TCN = "22TCN-222-95"


def sized(**more: Any) -> dict[str, Any]:
    return size_tanker(**TANKER, **more).to_dict()


def test_by_22tcn_without_waves() -> None:
    """329.75 kN of current and 108.36 kN of wind, by hand in tests/loads/test_tcn_222_95.py."""
    found = sized(load_method=TCN, wave_coefficient=0)
    (part,) = found["loads"][0]["parts"]
    assert part["method"] == TCN
    assert part["horizontal_force_N"] / 1e3 == pytest.approx(438.1, abs=0.05)
    assert "current along the ship" in found["recalled"]


def test_of_several_the_largest_and_nothing_recalled_unless_it_is_named() -> None:
    both = sized(load_method=["UFC-Blendermann", TCN], wave_coefficient=0)
    plain = sized()
    (largest,), (usual,) = (found["loads"][0]["parts"] for found in (both, plain))
    assert (largest["method"], usual["method"]) == (TCN, "UFC-Blendermann")
    assert "UFC-Blendermann 288.0 kN, 22TCN-222-95 438.1 kN" in largest["assumptions"][0]
    assert plain["recalled"] == []


def test_waves_are_not_left_out_unless_it_is_said() -> None:
    with pytest.raises(InputError, match="wave_coefficient: missing; 22TCN-222-95 wants its chi"):
        sized(load_method=TCN)
    with pytest.raises(InputError, match="or name 22TCN-222-95 among the load methods"):
        sized(wave_coefficient=0.1)
    with pytest.raises(InputError, match=r"load_method.*OCIMF"):
        sized(load_method="OCIMF")
