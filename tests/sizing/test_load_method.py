"""A tanker sized by loads of a named method: what is recalled counts only by its name."""

from __future__ import annotations

from typing import Any

import pytest

from catopt.errors import InputError
from catopt.loads.buoy import BreakingSeaError
from tests.sizing.at_rest import size_buoy, size_tanker

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
    with pytest.raises(
        InputError, match="wave_coefficient: missing; 22TCN-222-95 needs the wave coefficient chi"
    ):
        sized(load_method=TCN)
    with pytest.raises(InputError, match="or name 22TCN-222-95 among the load methods"):
        sized(wave_coefficient=0.1)
    with pytest.raises(InputError, match=r"load_method.*OCIMF"):
        sized(load_method="OCIMF")


# ------------------------------------------------------------------ a sea that breaks, on a buoy

# CALMAR 6.3.1: the largest wave, 1.85 Hs, breaks at 0.14 x 1.56 T^2 or at 0.78 (d + H/2).
BREAKING = [
    ({"depth": "12 m", "hs": "20 m"}, "37.00 m breaks in 12 m", "at 15.34 m"),  # 9.36/0.61
    ({"depth": "12 m", "hs": "2 m", "period": "2 s"}, "3.70 m breaks", "at 0.87 m"),  # 0.2184 x 4
    ({"depth": "4 m", "hs": "4 m"}, "7.40 m breaks in 4 m", "at 5.11 m"),  # 3.12/0.61
]


@pytest.mark.parametrize(("place", "breaks", "limit"), BREAKING)
def test_what_calmar_refuses_is_refused_under_its_name(
    place: dict[str, Any], breaks: str, limit: str
) -> None:
    with pytest.raises(BreakingSeaError) as refused:
        size_buoy(buoy="pillar 1.8 m", **place)
    said = str(refused.value)
    assert said.startswith("IALA CALMAR does not apply")
    assert breaks in said
    assert limit in said
    assert "load_method catopt-buoy" in said
    assert refused.value.exit_status == 3


def test_the_way_out_says_what_it_is_and_what_it_did_not_judge() -> None:
    found = size_buoy(
        buoy="pillar 1.8 m", depth="4 m", hs="4 m", load_method="catopt-buoy"
    ).judgement
    assert "of IALA-CALMAR under loads by catopt-buoy" in found.said
    assert "breaking" in [each.subject for each in found.not_judged]
    assert found.colour == "amber"


def test_a_force_that_is_given_stands_in_no_sea_that_breaks() -> None:
    place: dict[str, Any] = {
        "depth": "4 m",
        "hs": "4 m",
        "force": "5 kN",
        "reserve_buoyancy": "20 kN",
    }
    with pytest.raises(BreakingSeaError):
        size_buoy(**place)
    found = size_buoy(**place, load_method="catopt-buoy").judgement
    assert "breaking" in [each.subject for each in found.not_judged]


def test_the_error_keeps_what_it_says_in_another_process() -> None:
    import pickle

    with pytest.raises(BreakingSeaError) as refused:
        size_buoy(buoy="pillar 1.8 m", depth="4 m", hs="4 m")
    assert "--load-method catopt-buoy" in str(refused.value.spelt("--load-method"))
    assert str(pickle.loads(pickle.dumps(refused.value))) == str(refused.value)
