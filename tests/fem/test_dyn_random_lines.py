"""Random mooring lines as they are built, shaken: they run, and what they do repeats itself."""

from __future__ import annotations

import math

import numpy as np
import pytest

from catopt.fem import (
    Harmonic,
    History,
    LineDamping,
    LineProperties,
    MorisonSection,
    Seabed,
    TimeStepping,
    run_dynamics,
)
from catopt.model import Line, PointLoad, Segment
from tests.fem.lines import moored_line

CYCLES, STEPS = 12, 80


def _shaken(seed: int) -> History:
    """Line of `moored_line` of 60 bars, its fairlead led by 0.2 to 1 % of its length in 4 to 14 s.

    Inextensible segments get the stiffness of steel of their weight; clump weights their mass.
    """
    moored = moored_line(seed)
    rng = np.random.default_rng(seed + 1000)
    segments = [
        Segment(
            s.length,
            s.submerged_weight,
            EA=s.EA if math.isfinite(s.EA) else 3e4 * s.submerged_weight,
            mass=s.submerged_weight / 9.81 / 0.87,
        )
        for s in moored.line.segments
    ]
    loads = [
        PointLoad(p.position, p.submerged_weight, mass=p.submerged_weight / 9.81 / 0.6)
        for p in moored.line.point_loads
    ]
    period = float(rng.uniform(4.0, 14.0))
    amplitude = float(rng.uniform(0.002, 0.01)) * moored.line.length
    sections = [MorisonSection(0.1 * math.sqrt(s.submerged_weight / 1e3), 1.2, 0.3)
                for s in segments]  # fmt: skip
    return run_dynamics(
        Line(segments, loads),
        TimeStepping(CYCLES * period, period / STEPS, ramp_time=3 * period),
        height=moored.setting["height"],
        horizontal_force=moored.horizontal_force,
        anchor_height=moored.setting["anchor_height"],
        motion=Harmonic(period, (amplitude, 0.3 * amplitude, 0.5 * amplitude)),
        properties=LineProperties(
            sections,
            LineDamping(critical_ratio=0.3),
            seabed=Seabed(friction=moored.setting["seabed_friction"]),
        ),
        elements=60,
    )


@pytest.mark.parametrize("seed", range(24))
def test_random_line(seed: int) -> None:
    history = _shaken(seed)
    tension = history.fairlead_tension[:, 0]
    assert np.isfinite(tension).all()
    assert (history.min_tension >= 0.0).all()
    last, before = tension[-STEPS:], tension[-2 * STEPS : -STEPS]
    if history.line_slack_time() == 0.0:
        # What started with the ramp has died away; lines that snap taut need not repeat.
        assert last == pytest.approx(before, abs=0.01 * np.ptp(last))
