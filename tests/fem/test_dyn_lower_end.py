"""The lower end of a line that is led, and one that is let go."""

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
from catopt.model import Line, Segment
from catopt.waves import Sea

CHAIN = Line([Segment(60.0, 245.0, EA=1e8, mass=28.8)])
WATER = LineProperties(
    [MorisonSection(0.038, 2.4, 0.4, 1.0)],
    LineDamping(critical_ratio=0.5),
    seabed=Seabed(friction=0.3),
)


def hung(duration: float = 12.0, step: float = 0.05, **other: object) -> History:
    """Run a line between a higher and a lower place, off the bed, in still water."""
    given: dict[str, object] = {
        "height": 70.0, "anchor_height": 50.0, "span": 50.0, "properties": WATER, "elements": 20,
        "sea": Sea(80.0),
    }  # fmt: skip
    stepping = TimeStepping(duration, step, ramp_time=4.0, since=0.0, nodes=(0,))
    return run_dynamics(CHAIN, stepping, **{**given, **other})  # type: ignore[arg-type]


def test_both_ends_led_alike_are_a_line_that_moves_as_a_whole() -> None:
    """Without water: a line shaken as a whole is one in a field of gravity that changes.

    By d'Alembert, from the line at rest: shaken upwards its ends carry m L a more, together.
    """
    dry = LineProperties(None, LineDamping(critical_ratio=0.5))
    motion = Harmonic(4.0, (0.0, 0.0, 0.3), (0.0, 0.0, -0.5 * math.pi))
    found = hung(properties=dry, sea=None, motion=motion, anchor_motion=motion)
    t = found.time
    assert np.allclose(found.nodes[:, 0, 2] - 50.0, found.fairlead[:, 0, 2] - 70.0, atol=1e-9)
    w = 2.0 * math.pi / 4.0
    late = t >= 8.0
    inertia = 28.8 * 60.0 * -0.3 * w * w * np.sin(w * t)
    carried = -(found.fairlead_force[:, 0, 2] + found.anchor_force[:, 0, 2])
    shape = 245.0 * 60.0 + inertia
    # What the line swings on its own is small: it is stiff, and its sag moves little.
    assert np.abs(carried - shape)[late].max() < 0.05 * 245.0 * 60.0


def test_leading_the_lower_end_is_leading_the_upper_one_seen_from_it() -> None:
    """Turned upside down by symmetry: a level line whose one or other end is led in surge."""
    level = {"height": 60.0, "anchor_height": 60.0}
    away = Harmonic(4.0, (0.5, 0.0, 0.2), (-0.5 * math.pi, 0.0, 0.3))
    mirrored = Harmonic(4.0, (-0.5, 0.0, 0.2), (-0.5 * math.pi, 0.0, 0.3))
    upper = hung(**level, motion=away)
    lower = hung(**level, anchor_motion=mirrored)
    assert lower.anchor_tension[:, 0] == pytest.approx(upper.fairlead_tension[:, 0], rel=1e-7)
    assert lower.fairlead_tension[:, 0] == pytest.approx(upper.anchor_tension[:, 0], rel=1e-7)
    assert np.ptp(upper.fairlead_tension) > 100.0


def test_the_work_of_a_led_lower_end_is_booked() -> None:
    """What both ends put in is stored or taken: below 1e-3 of the work is left over."""
    motion = Harmonic(4.0, (0.8, 0.0, 0.4), (-0.5 * math.pi, 0.0, 0.0))
    found = hung(anchor_motion=motion, step=0.02)
    assert found.balance.put_in > 100.0
    assert found.balance.numerical_part < 1e-3


def test_a_lower_end_that_is_let_go_flies_up_as_the_wave_equation_has_it() -> None:
    """Without water, upright between its ends and pulled by T0 at the lower one.

    What comes down the line to its free end at the time t set off at s = c t with the tension
    T0 + w s there: v = (T0 + w c t)/sqrt(EA m) - (w/m) t = T0/sqrt(EA m), until the wave is back.
    """
    dry = LineProperties(None, LineDamping(critical_ratio=0.3))
    line = Line([Segment(50.0, 10.0, EA=1e5, mass=10.0)])
    found = run_dynamics(
        line,
        TimeStepping(0.7, 0.001, since=0.0, nodes=(0,)),
        height=58.0, anchor_height=7.0, span=1e-6, anchor_lost=0.2, properties=dry, elements=400,
    )  # fmt: skip
    wave = math.sqrt(1e5 / 10.0)  # 100 m/s: 0.5 s up the line
    before = found.time < 0.2
    pull = found.anchor_tension[before, 0].mean()
    assert pull == pytest.approx(1e5 * (1.0 / 50.0) - 10.0 * 50.0 / 2.0, rel=2e-2)
    speed = pull / math.sqrt(1e5 * 10.0)
    during = (found.time > 0.3) & (found.time < 0.2 + 0.9 * 50.0 / wave)
    risen = found.nodes[:, 0, 2] - 7.0
    since = found.time - 0.2
    assert np.allclose(risen[during], (speed * since)[during], rtol=0.02)
    assert not found.anchor_tension[found.time > 0.201].any()
    assert (risen[before] == 0.0).all()


def test_a_line_without_an_anchor_comes_to_hang_straight_down() -> None:
    """In still water its fairlead then carries its weight, and the end hangs a length below.

    It still swings by a few degrees.
    """
    drag = LineProperties([MorisonSection(0.3, 5.0, 1.0, 1.0)], LineDamping(critical_ratio=0.5))
    found = hung(duration=120.0, step=0.1, anchor_lost=5.0, properties=drag, sea=Sea(80.0))
    assert found.fairlead_tension[-1, 0] == pytest.approx(245.0 * 60.0, rel=0.01)
    assert found.nodes[-1, 0, 2] == pytest.approx(70.0 - 60.0, abs=0.2)
    assert found.nodes[-1, 0, 0] == pytest.approx(50.0, abs=5.0)
    # The weight that came down is what was put in.
    assert found.balance.put_in == pytest.approx(-found.balance.potential, rel=0.01)
    assert found.balance.numerical_part < 1e-3


def test_an_anchor_that_is_lost_on_the_bed_is_dragged_along() -> None:
    """The line slides towards the fairlead until friction and drag hold it: it stays on the bed."""
    found = hung(
        duration=20.0, height=20.0, anchor_height=0.0, span=52.0, sea=Sea(20.0), anchor_lost=5.0
    )
    end = found.nodes[:, 0]
    assert end[-1, 0] > 1.0
    assert end[:, 2].min() > -0.5
    assert found.fairlead_tension[-1, 0] < found.fairlead_tension[0, 0]
