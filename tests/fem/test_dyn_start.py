"""A motion that begins at speed, and damping that no mesh changes: chains in heave of 1 m."""

from __future__ import annotations

import math
from functools import cache

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
    StepControls,
    TimeStepping,
    run_dynamics,
)
from catopt.model import Line, Segment
from catopt.reproduce.items import published
from catopt.reproduce.reference_moorings import CHAIN, Depth, chain_of, segment_of
from catopt.waves import Sea, regular_wave
from catopt.words import Message, is_said

GIVEN = published(CHAIN).inputs


@cache
def heaving(depth: Depth, bars: int, step: float, ramp: float) -> History:
    """MoorDyn's chains of tests/Mooring/WD*, in heave of 1 m in 10 s instead of 2 and 5 m."""
    D = GIVEN["contact_diameter_m"]
    source = chain_of(depth, 0.5 * D)
    section = MorisonSection(
        GIVEN["volume_diameter_m"], GIVEN["drag_coefficient"],
        math.pi * GIVEN["axial_drag_on_pi_D"], GIVEN["added_mass_coefficient"], 0.0,
    )  # fmt: skip
    bed = Seabed(
        GIVEN["bed_stiffness_kN_per_m3"] * 1e3 * D,
        friction=GIVEN["friction_in_motion"],
        initial_friction="none",
    )
    water = Fluid(GIVEN["water_density_kg_per_m3"])
    return run_dynamics(
        Line([segment_of(source)]),
        TimeStepping(60.0, step, ramp_time=ramp, since=30.0),
        height=source.inputs["fairlead_height_m"],
        span=source.inputs["span_m"],
        motion=Harmonic(10.0, (0.0, 0.0, 1.0), (0.0, 0.0, -0.5 * math.pi)),
        properties=LineProperties([section], LineDamping(critical_ratio=1.0), water, bed),
        elements=bars,
    )


@pytest.mark.parametrize("depth", [50, 600])
def test_finer_meshes_and_a_start_at_speed_change_little(depth: Depth) -> None:
    """76 bars and twice as many at half the step, without a ramp, beside 76 with one of 20 s.

    Least and largest tension from 30 s on agree to 0.2 %; bars of 6 and 12 m are off by their
    square, and what the start leaves has died away.
    """
    runs = ((76, 0.1, 20.0), (76, 0.1, 0.0), (152, 0.05, 0.0))
    found = [heaving(depth, *each).tension_statistics() for each in runs]
    for one in found[1:]:
        assert one.maximum == pytest.approx(found[0].maximum, rel=2e-3)
        assert one.minimum == pytest.approx(found[0].minimum, rel=2e-3)


@pytest.mark.parametrize("depth", [50, 600])
def test_the_first_samples_do_not_ring(depth: Depth) -> None:
    """0.63 m/s times sqrt(EA m) are 508 kN, half the tension at rest in 50 m."""
    gentle, sudden = (heaving(depth, 76, 0.1, ramp) for ramp in (20.0, 0.0))
    speed, segment = 2.0 * math.pi / 10.0, segment_of(chain_of(depth))
    assert segment.mass is not None
    jump = speed * math.sqrt(segment.EA * segment.mass)
    assert jump == pytest.approx(508e3, rel=1e-3)
    at_rest = gentle.fairlead_tension[0, 0]
    assert sudden.fairlead_tension[0, 0] == pytest.approx(at_rest, rel=1e-3)
    assert np.abs(np.diff(sudden.fairlead_tension[:20, 0])).max() < 0.05 * jump


@pytest.mark.parametrize("EA", [1e9, 1e5])
def test_a_line_too_stiff_for_sixteen_digits_says_so(EA: float) -> None:
    """A string of 1 mg/m: 4 eps EA over bars of 1 m, 12 m away, are 1e-5 N of its 1.6e-4 N."""
    mass = 1e-6
    line = Line([Segment(20.0, mass * 9.80665, EA=EA, mass=mass)])
    history = run_dynamics(
        line, TimeStepping(0.4, 0.02, ramp_time=0.2), height=10.0, span=12.0,
        motion=Harmonic(2.0, (0.2, 0.0, 0.0)), properties=LineProperties(None, seabed=None),
        elements=20,
    )  # fmt: skip
    said = [each for each in history.warnings if is_said(each, "motion.too_stiff")]
    assert bool(said) == (EA == 1e9)
    if said:
        assert isinstance(said[0], Message)
        assert said[0].values["part"] == pytest.approx(4 * 2.2e-16 * 1e9 * 12.0 / 1.57e-4, rel=0.05)


def test_a_first_step_that_is_refused_leaves_the_first_sample_alone() -> None:
    """Waves that are there at once: a step refused has seen them already, the start has not."""

    def run(surprise: float) -> History:
        controls = StepControls(surprise=surprise, max_refinements=3, max_ringing=math.inf)
        return run_dynamics(
            Line([Segment(60.0, 270.0, EA=1.2e8, mass=31.6)]),
            TimeStepping(0.4, 0.1, controls=controls),
            height=20.0,
            span=55.0,
            sea=Sea(20.0, regular_wave(3.0, 6.0)),
            properties=LineProperties([MorisonSection(0.07, 2.4)], LineDamping(critical_ratio=1.0)),
            elements=12,
        )

    loose, tight = run(100.0), run(1e-9)
    assert loose.refinements == 0 < tight.refinements
    assert (loose.fairlead_force[0] == tight.fairlead_force[0]).all()
    assert (loose.anchor_force[0] == tight.anchor_force[0]).all()
