"""Whole lines against another program and against a model test, with the figures as printed."""

from __future__ import annotations

import math
import tomllib
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
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
)
from catopt.fem.newmark import Scheme
from catopt.model import Line, Segment
from catopt.waves import Sea

DATA = Path(__file__).parent / "data"


def _figures(name: str) -> dict[str, Any]:
    return tomllib.loads((DATA / name).read_text(encoding="utf-8"))


@cache
def _moordyn_chain(elements: int, step: float, scheme: Scheme) -> History:
    """600 m of chain whose fairlead is in surge, as MoorDyn-C 2.7.2 was given it."""
    f = _figures("moordyn_chain_600m.toml")
    D = f["volume_diameter_m"]
    line = Line(
        [
            Segment(
                f["length_m"],
                f["submerged_weight_N_per_m"],
                EA=f["EA_N"],
                mass=f["mass_kg_per_m"],
            )
        ]
    )
    properties = LineProperties(
        # MoorDyn's axial coefficient refers to pi D.
        [MorisonSection(D, f["Cd_normal"], math.pi * f["Cd_axial"], f["Ca_normal"], f["Ca_axial"])],
        LineDamping(critical_ratio=f["damping_ratio"], critical_length="bar"),
        Fluid(f["water_density_kg_per_m3"], f["g"]),
        Seabed(f["seabed_stiffness_Pa_per_m"] * D, f["seabed_damping_Pa_s_per_m"] * D),
    )
    period, amplitude = f["surge_period_s"], f["surge_amplitude_m"]
    # Towards the anchor first.
    motion = Harmonic(period, (-amplitude, 0.0, 0.0), (-math.pi / 2, 0.0, 0.0))
    return run_dynamics(
        line,
        TimeStepping(
            100.0, step, ramp_time=period, output_interval=0.05, since=50.0, scheme=scheme
        ),
        height=-f["anchor_m"][2],
        span=f["anchor_m"][0],
        motion=motion,
        properties=properties,
        elements=elements,
    )


def _moordyn_series() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Time, place of the fairlead and size of the end force."""
    data = np.loadtxt(DATA / "moordyn_chain_600m.csv", delimiter=",", skiprows=1)
    return data[:, 0], data[:, 1], np.hypot(data[:, 2], data[:, 4])


@pytest.mark.parametrize("scheme", [Scheme.average_acceleration(), Scheme.generalised_alpha(0.5)])
def test_moordyn_chain(scheme: Scheme) -> None:
    """End force within 1 % of its range at every time after the ramp, extremes within 0.5 %."""
    history = _moordyn_chain(80, 0.05, scheme)
    time, x, reference = _moordyn_series()
    ours = np.interp(time, history.time, history.fairlead_tension[:, 0])
    place = np.interp(time, history.time, 554.5 - history.fairlead[:, 0, 0])
    # The series is printed to six digits.
    assert place == pytest.approx(x, abs=2e-5)
    late = time > 10.0
    apart = np.abs(ours - reference)[late].max() / np.ptp(reference[late])
    assert apart < 0.01
    f = _figures("moordyn_chain_600m.toml")["statistics"]
    statistics = history.tension_statistics()
    assert statistics.maximum == pytest.approx(1e3 * f["end_force_max_kN"], rel=0.005)
    assert statistics.minimum == pytest.approx(1e3 * f["end_force_min_kN"], rel=0.005)
    # Static end force by the closed form, printed to 10 N; order of (bar/length)^2 beside it.
    at_rest = history.fairlead_tension[0, 0]
    assert at_rest == pytest.approx(1e3 * f["static_end_force_kN"], rel=2e-4)


def test_moordyn_chain_over_meshes() -> None:
    """Largest end force with 20 and 40 bars, each beside MoorDyn's with as many."""
    printed = _figures("moordyn_chain_600m.toml")["statistics"]["mesh_convergence_max_kN"]
    for elements in (20, 40):
        history = _moordyn_chain(elements, 0.05, Scheme.generalised_alpha(0.5))
        largest = history.tension_statistics().maximum
        assert largest == pytest.approx(1e3 * printed[f"N{elements}"], rel=0.005)


def test_half_a_step_changes_little() -> None:
    """What the comparison rests on is settled in the step: peaks to 1e-3."""
    peaks = [
        _moordyn_chain(80, step, Scheme.generalised_alpha(0.5)).tension_statistics().maximum
        for step in (0.05, 0.025)
    ]
    assert peaks[0] == pytest.approx(peaks[1], rel=1e-3)


def _lindahl(period: float, cycles: int, step: float) -> History:
    """Bergdahl et al., J. Mar. Sci. Eng. 3, 2015: chain of 33 m, fairlead on a circle of 0.2 m.

    All coefficients as printed; the internal damping of the chain, too.
    """
    f = _figures("lindahl_chain.toml")
    g = f["g"]
    rho = f["water_density_kg_per_m3"]
    mass = f["mass_kg_per_m"]
    weight = mass * g * (1.0 - rho / f["material_density_kg_per_m3"])
    D = f["drag_diameter_m"]
    section = MorisonSection(D, f["Cd_normal"], f["Cd_tangential"], f["CM_normal"] - 1.0)
    properties = LineProperties(
        [section],
        LineDamping(internal=f["internal_damping_N_s"]),
        Fluid(rho, g),
        Seabed(f["seabed_stiffness_Pa_per_m"] * D, friction=f["seabed_friction"]),
    )
    depth = f["water_depth_m"]
    motion = Harmonic(period, (0.2, 0.0, 0.2), (0.0, 0.0, math.pi / 2))
    return run_dynamics(
        Line([Segment(f["length_m"], weight, EA=f["EA_N"], mass=mass)]),
        TimeStepping(cycles * period, step, ramp_time=2 * period, since=(cycles - 4) * period),
        height=depth + f["fairlead_centre_m"][2],
        span=f["fairlead_centre_m"][0],
        motion=motion,
        properties=properties,
        sea=Sea(depth),
        elements=66,
    )


_PHASES = 200
"""Of a cycle, in which runs and measurement are laid over each other."""


def _measured(column: int, period: float, first: int) -> np.ndarray:
    """Fold the measured tension into cycles, (cycles, phases); its start is left out."""
    time, *series = np.loadtxt(DATA / "lindahl_series.csv", delimiter=",", skiprows=3, unpack=True)
    cycles = range(first, int(time[-1] / period))
    return np.array([np.interp(_folded(k, period), time, series[column]) for k in cycles])


def _folded(cycle: int, period: float) -> np.ndarray:
    return np.asarray((cycle + np.arange(_PHASES) / _PHASES) * period)


def _beside(history: History, period: float, cycles: int, measured: np.ndarray) -> np.ndarray:
    """Mean cycle of a run, turned to where it is nearest the measured one."""
    tension = history.fairlead_tension[:, 0]
    last = range(cycles - 4, cycles)
    own = np.mean([np.interp(_folded(k, period), history.time, tension) for k in last], axis=0)
    turned = [np.roll(own, k) for k in range(_PHASES)]
    return np.asarray(min(turned, key=lambda each: np.square(each - measured).sum()))


def test_lindahl_slow_circle() -> None:
    """T = 3.5 s: largest tension within 2 % of the measured 51.4 N, the cycle within 1.3 N."""
    history = _lindahl(3.5, 8, 0.01)
    every = _measured(1, 3.5, 1)
    # As printed: 51.4 N of the paper's figure, 51.43 N of the series.
    printed = _figures("lindahl_chain.toml")["measured"]["T_3p5_s"]["tension_max_N"]
    assert every.max(axis=1).mean() == pytest.approx(printed, abs=0.1)
    assert history.tension_statistics().maximum == pytest.approx(printed, rel=0.02)
    cycle = every.mean(axis=0)
    off = _beside(history, 3.5, 8, cycle) - cycle
    assert np.sqrt(np.square(off).mean()) < 1.3


def test_lindahl_fast_circle_where_it_departs() -> None:
    """T = 1.25 s: the peak is 7 to 9 % low, on the unsafe side, whatever bars and steps.

    Measured 72.6 N. By the phase of the cycle: the line slackens as measured; it takes up its load
    0.15 of a cycle too early, 4 to 10 N where 1 to 2 N are measured, so that it is caught more
    gently: 3 to 7 N are missing at the peak; on the falling side there are 2 to 6 N too many.
    """
    period, cycles = 1.25, 10
    every = _measured(0, period, 0)
    peak, cycle = every.max(axis=1).mean(), every.mean(axis=0)
    assert peak == pytest.approx(72.6, abs=0.3)  # 12 cycles between 71.5 and 73.7
    ours = _beside(_lindahl(period, cycles, 0.005), period, cycles, cycle)
    assert 0.91 < ours.max() / peak < 0.93
    off = ours - cycle
    at = {phase: off[round(phase * _PHASES)] for phase in (0.35, 0.55, 0.7, 0.9)}
    assert -8.0 < at[0.35] < -3.0
    assert 2.0 < at[0.55] < 7.0
    assert abs(at[0.7]) < 1.0
    assert 4.0 < at[0.9] < 10.0


def test_lindahl_fast_circle_goes_slack() -> None:
    """T = 1.25 s: bars at the fairlead lose their tension in every cycle, as measured."""
    period, cycles = 1.25, 10
    history = _lindahl(period, cycles, 0.005)
    at_rest = history.fairlead_tension[0, 0]
    for cycle in range(cycles - 4, cycles):
        during = (history.time >= cycle * period) & (history.time < (cycle + 1) * period)
        # What is left is the weight of the few bars between a slack one and the fairlead.
        assert history.bar_tension[during, 0, 1].min() < 0.01 * at_rest
        assert history.bar_tension[during, 0, 1].max() > 2.0 * at_rest
    assert (history.min_tension == 0.0).sum() > 33
    assert history.line_slack_time() > 0.1 * 4 * period
