"""Series that other programs printed for a chain in heave and for a hanging cable.

Chains: MoorDyn's tests/Mooring/WD*, whose reference program is OrcaFlex. Cable: Low and Langley's,
by OrcaFlex, with the series as read from the figures of FRyDoM's documentation (about 1 kN).
"""

from __future__ import annotations

import math
import tomllib
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest

from catopt.fem import solve_line
from catopt.model import Line, Segment
from catopt.reproduce.items import published
from catopt.reproduce.reference_moorings import (
    CableCase,
    Depth,
    Heave,
    cable_sea,
    run_cable,
    run_chain,
)

Array = npt.NDArray[np.float64]

DATA = Path(__file__).parent / "data"
GIVEN = tomllib.loads((DATA / "chains_in_heave_and_hanging_cable.toml").read_text(encoding="utf-8"))


def _series(name: str) -> Array:
    return np.loadtxt(DATA / f"{name}.csv", delimiter=",", skiprows=1)


def _weight(f: dict[str, Any], g: float) -> float:
    return float((f["m"] - 0.25 * math.pi * f["d_vol"] ** 2 * f["rho"]) * g)


# ------------------------------------------------------------------ chains in heave


@pytest.mark.parametrize("depth", [50, 600])
def test_chains_at_rest(depth: Depth) -> None:
    """OrcaFlex's static tensions within 0.2 %, once its line lies as high above the bed."""
    history, of = run_chain(depth, 2), GIVEN["wd"][f"wd{depth:04}"]
    assert history.fairlead_tension[0, 0] == pytest.approx(1e3 * of["static_fairlead_kN"], rel=2e-3)
    assert history.anchor_tension[0, 0] == pytest.approx(1e3 * of["static_anchor_kN"], rel=2e-3)


@pytest.mark.parametrize(
    ("name", "depth", "amplitude", "within"),
    [
        ("WD0050_heave_A1", 50, 2, 0.012),
        ("WD0050_heave_A2", 50, 5, 0.02),
        ("WD0600_heave_A1", 600, 2, 0.01),
        ("WD0600_heave_A2", 600, 5, 0.06),
    ],
)
def test_chains_in_heave(name: str, depth: Depth, amplitude: Heave, within: float) -> None:
    """Largest tension between OrcaFlex's and MoorDyn's, which differ by 1.3 to 6.7 %.

    Smallest ones of these two differ by up to 35 % and depend on the friction: not compared.
    """
    series = _series(name)
    printed = GIVEN["wd"]["fairlead_kN"]
    orcaflex, moordyn = (1e3 * printed[of][name][0] for of in ("orcaflex", "moordyn_c"))
    assert series[:, 2].max() == pytest.approx(orcaflex / 1e3, abs=0.06)  # printed to 0.1 kN
    study = published("chain_in_waves")
    judged = study.printed["OrcaFlex, fairlead tension in heave"]
    assert [
        judged[f"{which}_{depth}m_heave_{amplitude}m_kN"].value for which in ("max", "min")
    ] == printed["orcaflex"][name]
    assert moordyn / 1e3 in study.series["moordyn_max_kN"]
    ours = run_chain(depth, amplitude).tension_statistics().maximum
    assert orcaflex < ours < moordyn
    assert ours == pytest.approx(orcaflex, rel=within)


# ------------------------------------------------------------------ a hanging cable


def _top_tension(case: CableCase) -> tuple[Array, Array]:
    """Time, s, and top tension, kN."""
    history = run_cable(case)
    return history.time, history.fairlead_tension[:, 0] / 1e3


def test_cable_at_rest() -> None:
    """The catenary's tensions as printed, and those of OrcaFlex, which bends, to 0.08 kN."""
    f = GIVEN["hanging_cable"]
    rest = solve_line(
        Line([Segment(f["length"], _weight(f, f["g"]), EA=f["EA"])]),
        height=f["fairlead"][2] + f["depth"],
        anchor_height=f["anchor"][2] + f["depth"],
        span=-f["anchor"][0],
        elements=136,
    )
    found = {
        "top": rest.fairlead.tension,
        "V_top": rest.fairlead.vertical_force,
        "H": rest.fairlead.horizontal_force,
        "bottom": rest.anchor.tension,
    }
    for key, value in found.items():
        digits = 0.05 if key == "bottom" else 0.005
        assert value / 1e3 == pytest.approx(f["static_kN"]["catenary"][key], abs=1.1 * digits)
        assert value / 1e3 == pytest.approx(f["static_kN"]["orcaflex"][key], abs=0.08)


def _apart(series: Array, time: Array, ours: Array, late: float) -> tuple[float, float, float]:
    """Root mean square of the difference from `late` on, and differences of both extremes, kN."""
    counted = series[:, 0] >= late
    t, theirs = series[counted, 0], series[counted, 1]
    found = np.interp(t, time, ours)
    rms = float(np.sqrt(np.mean((found - theirs) ** 2)))
    return rms, float(abs(found.max() - theirs.max())), float(abs(found.min() - theirs.min()))


@pytest.mark.parametrize(
    ("name", "case"), [("hanging_cable_case1", "surge"), ("hanging_cable_case3", "heave")]
)
def test_cable_whose_top_is_led(name: str, case: CableCase) -> None:
    """10 m of surge or heave in 27 s: within 0.15 kN rms and 0.4 kN at the extremes.

    In heave the upper end comes 5 m out of the water, where it loses its lift: the surface counts.
    """
    rms, most, least = _apart(_series(name), *_top_tension(case), 40.0)
    assert rms < 0.15
    assert most < 0.4
    assert least < 0.4


@pytest.mark.parametrize(
    ("name", "case", "direction", "phase"),
    [
        ("hanging_cable_case4", "waves_along", 0.0, 230.0),
        ("hanging_cable_case5", "waves_at_45_deg", 45.0, 165.0),
    ],
)
def test_cable_in_waves(name: str, case: CableCase, direction: float, phase: float) -> None:
    """Waves of 5 m amplitude and 10 s: within 0.5 kN rms and 0.6 kN of the extremes.

    Their phase counts at the upper end, a cos(k x + phase - omega t), which puts the crest over the
    lower one at t = 0 to 3 degrees; ours counts there. Water ends at the still surface, as there.
    """
    k = float(cable_sea(case).wave_numbers[0])
    over_span = k * -GIVEN["hanging_cable"]["anchor"][0] * math.cos(math.radians(direction))
    assert math.degrees(over_span) == pytest.approx(phase, abs=3.0)
    time, ours = _top_tension(case)
    settled = time >= 50.0  # five whole periods after their start
    rms, most, least = _apart(_series(name), time[settled] - 50.0, ours[settled], 0.0)
    assert rms < 0.5
    assert most < 0.6
    assert least < 0.6
