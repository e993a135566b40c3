"""Series that other programs printed for a chain in heave and for a hanging cable.

Chains: MoorDyn's tests/Mooring/WD*, whose reference program is OrcaFlex. Cable: Low and Langley's,
by OrcaFlex, with the series as read from the figures of FRyDoM's documentation (about 1 kN).
"""

from __future__ import annotations

import math
import tomllib
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest

from catopt.fem import (
    Fluid,
    Harmonic,
    History,
    LineDamping,
    LineProperties,
    MorisonSection,
    Seabed,
    TimeStepping,
    run_dynamics,
    solve_line,
)
from catopt.model import Line, Segment
from catopt.waves import Sea, regular_wave

Array = npt.NDArray[np.float64]

DATA = Path(__file__).parent / "data"
GIVEN = tomllib.loads((DATA / "chains_in_heave_and_hanging_cable.toml").read_text(encoding="utf-8"))
SINE = -0.5 * math.pi


def _series(name: str) -> Array:
    return np.loadtxt(DATA / f"{name}.csv", delimiter=",", skiprows=1)


def _weight(f: dict[str, Any], g: float) -> float:
    return float((f["m"] - 0.25 * math.pi * f["d_vol"] ** 2 * f["rho"]) * g)


# ------------------------------------------------------------------ chains in heave

CONTACT = 0.469
"""Outer diameter of the chain, 3.35 bars of 0.14 m: OrcaFlex lays its centre line half of that
above the bed, less what it sinks in."""


@cache
def _chain(depth: str, amplitude: float) -> History:
    """Run a chain with its fairlead in heave; the bed's friction begins without any, as there.

    MoorDyn's axial coefficient goes with pi D, and its damping is critical for each bar.
    """
    f, of = GIVEN["wd"], GIVEN["wd"][depth]
    D = f["d_vol"]
    section = MorisonSection(
        D, f["Cd_normal"], math.pi * f["Cd_axial_on_pi_d"], f["Ca_normal"], 0.0
    )
    bed = Seabed(
        f["bed_stiffness_Pa_per_m"] * CONTACT,
        friction=f["seabed_friction"],
        initial_friction="none",
    )
    return run_dynamics(
        Line([Segment(of["length"], _weight(f, 9.80665), EA=f["EA"], mass=f["m"])]),
        TimeStepping(40.0, 0.05, ramp_time=15.0, since=30.0),
        height=of["depth"] - 0.5 * CONTACT,
        span=of["span"],
        motion=Harmonic(10.0, (0.0, 0.0, amplitude), (0.0, 0.0, SINE)),
        properties=LineProperties(
            [section], LineDamping(critical_ratio=f["damping_ratio"]), Fluid(f["rho"]), bed
        ),
        elements=80,
    )


@pytest.mark.parametrize("depth", ["wd0050", "wd0600"])
def test_chains_at_rest(depth: str) -> None:
    """OrcaFlex's static tensions within 0.2 %, once its line lies as high above the bed."""
    history, of = _chain(depth, 2.0), GIVEN["wd"][depth]
    assert history.fairlead_tension[0, 0] == pytest.approx(1e3 * of["static_fairlead_kN"], rel=2e-3)
    assert history.anchor_tension[0, 0] == pytest.approx(1e3 * of["static_anchor_kN"], rel=2e-3)


@pytest.mark.parametrize(
    ("name", "depth", "amplitude", "within"),
    [
        ("WD0050_heave_A1", "wd0050", 2.0, 0.012),
        ("WD0050_heave_A2", "wd0050", 5.0, 0.02),
        ("WD0600_heave_A1", "wd0600", 2.0, 0.01),
        ("WD0600_heave_A2", "wd0600", 5.0, 0.06),
    ],
)
def test_chains_in_heave(name: str, depth: str, amplitude: float, within: float) -> None:
    """Largest tension between OrcaFlex's and MoorDyn's, which differ by 1.3 to 6.7 %.

    Smallest ones of these two differ by up to 35 % and depend on the friction: not compared.
    """
    series = _series(name)
    printed = GIVEN["wd"]["fairlead_kN"]
    orcaflex, moordyn = (1e3 * printed[of][name][0] for of in ("orcaflex", "moordyn_c"))
    assert series[:, 2].max() == pytest.approx(orcaflex / 1e3, abs=0.06)  # printed to 0.1 kN
    ours = _chain(depth, amplitude).tension_statistics().maximum
    assert orcaflex < ours < moordyn
    assert ours == pytest.approx(orcaflex, rel=within)


# ------------------------------------------------------------------ a hanging cable


def _cable(
    motion: Harmonic | None, sea: Sea | None, duration: float, ramp: float
) -> tuple[Array, Array, History]:
    """Run the cable between its two ends, without bending; time and top tension in kN."""
    f = GIVEN["hanging_cable"]
    anchor, fairlead = f["anchor"], f["fairlead"]
    section = MorisonSection(f["d_vol"], f["Cd_normal"], 0.0, f["Ca_normal"], 0.0)
    history = run_dynamics(
        Line([Segment(f["length"], _weight(f, f["g"]), EA=f["EA"], mass=f["m"])]),
        TimeStepping(duration, 0.05, ramp_time=ramp),
        height=f["depth"] + fairlead[2],
        anchor_height=f["depth"] + anchor[2],
        span=fairlead[0] - anchor[0],
        motion=motion,
        properties=LineProperties(
            [section], LineDamping(critical_ratio=1.0), Fluid(f["rho"], f["g"])
        ),
        sea=sea,
        elements=68,
    )
    return history.time, history.fairlead_tension[:, 0] / 1e3, history


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
    ("name", "along"),
    [("hanging_cable_case1", (10.0, 0.0, 0.0)), ("hanging_cable_case3", (0.0, 0.0, 10.0))],
)
def test_cable_whose_top_is_led(name: str, along: tuple[float, float, float]) -> None:
    """10 m of surge or heave in 27 s: within 0.15 kN rms and 0.4 kN at the extremes.

    In heave the upper end comes 5 m out of the water, where it loses its lift: the surface counts.
    """
    motion = Harmonic(27.0, along, (SINE, 0.0, SINE))
    time, ours, _ = _cable(motion, Sea(GIVEN["hanging_cable"]["depth"]), 80.0, 27.0)
    rms, most, least = _apart(_series(name), time, ours, 40.0)
    assert rms < 0.15
    assert most < 0.4
    assert least < 0.4


@pytest.mark.parametrize(
    ("name", "direction", "phase"),
    [("hanging_cable_case4", 0.0, 230.0), ("hanging_cable_case5", 45.0, 165.0)],
)
def test_cable_in_waves(name: str, direction: float, phase: float) -> None:
    """Waves of 5 m amplitude and 10 s: within 0.5 kN rms and 0.6 kN of the extremes.

    Their phase counts at the upper end, a cos(k x + phase - omega t), which puts the crest over the
    lower one at t = 0 to 3 degrees; ours counts there. Water ends at the still surface, as there.
    """
    f = GIVEN["hanging_cable"]
    flow = regular_wave(10.0, 10.0, direction=math.radians(direction))
    sea = Sea(f["depth"], flow, ramp_time=20.0)
    over_span = math.degrees(
        float(sea.wave_numbers[0]) * -f["anchor"][0] * math.cos(math.radians(direction))
    )
    assert over_span == pytest.approx(phase, abs=3.0)
    time, ours, _ = _cable(None, sea, 90.0, 20.0)
    settled = time >= 50.0  # five whole periods after their start
    rms, most, least = _apart(_series(name), time[settled] - 50.0, ours[settled], 0.0)
    assert rms < 0.5
    assert most < 0.6
    assert least < 0.6
