"""Random lines on beds that slope, at rest in the truss model, which alone can have them.

A bed turned by an angle is a level one under weights that lean: there is no oracle of the whole.
What holds is tested: on a slope of nothing the closed form; everything ten times as heavy, as stiff
and pulled is the same line; so is one of which each segment is two; twice as long, as high and as
strong is twice as large; the steeper the bed falls from the fairlead, the less of the line lies;
more force takes the fairlead farther; pulled and laid friction enclose none.
`python -m tests.campaign.test_sloped_beds FIRST COUNT` draws more of them.
"""

from __future__ import annotations

import math
import sys
from dataclasses import dataclass, replace

import numpy as np
import pytest

from catopt.catenary.solve import solve
from catopt.errors import NotConvergedError
from catopt.fem import LineProperties, mesh_line
from catopt.fem.dynamics import line_at_rest
from catopt.fem.seabed import Seabed
from catopt.model import Line, Segment
from catopt.model.dynamics import InitialFriction

pytestmark = pytest.mark.slow

BARS = 60


@dataclass(frozen=True)
class Sloped:
    """A line on a bed: pulled by `force` (N) at `height` above the anchor (m)."""

    line: Line
    force: float
    height: float
    friction: float
    slope: float
    stiffness: float
    initial: InitialFriction = "pulled"


@dataclass(frozen=True)
class Rest:
    """Span (m), length on the bed (m), tension at both ends (N)."""

    span: float
    lying: float
    anchor: float
    fairlead: float


def drawn(seed: int) -> Sloped:
    """Draw a line of one to three segments, part of it on the bed."""
    rng = np.random.default_rng([12, seed])
    height = float(rng.uniform(20.0, 90.0))
    slope = math.radians(float(rng.uniform(-8.0, 5.0)))
    count = int(rng.integers(1, 4))
    length = height * float(rng.uniform(3.0, 5.0))
    parts = rng.uniform(0.5, 1.0, count)
    parts *= length / parts.sum()
    weight = 10.0 ** float(rng.uniform(2.3, 3.4))
    segments = [
        Segment(float(part), w := weight * float(rng.uniform(0.6, 1.6)), EA=1e5 * w, mass=w / 8.5)
        for part in parts
    ]
    return Sloped(
        Line(segments),
        weight * height * float(rng.uniform(0.3, 1.2)),
        height,
        float(rng.choice([0.0, 0.3, 0.8])),
        slope,
        1e4 * weight,
    )


def at_rest(of: Sloped, bars: int = BARS) -> Rest:
    """Bring it to rest."""
    bed = Seabed(of.stiffness, friction=of.friction, initial_friction=of.initial, slope=of.slope)
    mesh = mesh_line(of.line, bars)
    simulation = line_at_rest(
        mesh, height=of.height, horizontal_force=of.force, properties=LineProperties(seabed=bed)
    )
    at = simulation.state
    lies = np.flatnonzero(at.reaction > 0.0)
    s = np.concatenate([[0.0], np.cumsum(simulation.lines.length[: len(at.tension)])])
    return Rest(
        float(at.x[-1, 0] - at.x[0, 0]),
        float(s[lies[-1]]) if lies.size else 0.0,
        float(at.tension[0]),
        float(at.tension[-1]),
    )


def scaled(of: Sloped, by: float) -> Sloped:
    """Make everything so much heavier, stiffer and pulled harder."""
    segments = [
        replace(
            part, submerged_weight=by * part.submerged_weight, EA=by * part.EA, mass=by * part.mass
        )
        for part in of.line.segments
        if part.mass is not None
    ]
    return replace(of, line=Line(segments), force=by * of.force, stiffness=by * of.stiffness)


def larger(of: Sloped, by: float) -> Sloped:
    """Make everything so much longer; its force is then that much larger for the same weight."""
    segments = [
        replace(part, length=by * part.length, EA=by * part.EA) for part in of.line.segments
    ]
    # The bed gives way by weight over stiffness, and that is to grow, too.
    return replace(
        of,
        line=Line(segments),
        force=by * of.force,
        height=by * of.height,
        stiffness=of.stiffness / by,
    )


def halved(of: Sloped) -> Sloped:
    """Make two of each segment."""
    segments = [
        replace(part, length=0.5 * part.length) for part in of.line.segments for _ in range(2)
    ]
    return replace(of, line=Line(segments))


def faults(seed: int) -> list[str] | None:
    """Say what is wrong with a line on a slope; None of one that slides down past its anchor."""
    try:
        return _faults(seed)
    except NotConvergedError as error:
        return None if "slides" in str(error) else [str(error)]


def _faults(seed: int) -> list[str]:
    of = drawn(seed)
    length = of.line.length
    found = []

    def unlike(name: str, one: float, other: float, most: float) -> None:
        if not abs(one - other) <= most:
            found.append(f"{name}: {one!r} for {other!r}")

    due = at_rest(of)
    level = at_rest(replace(of, slope=0.0))
    closed = solve(
        of.line, height=of.height, horizontal_force=of.force, seabed_friction=of.friction
    )
    # The truss's own error falls with the square of a bar; the touchdown is anywhere in a bar.
    bar = length / BARS
    unlike("level, span", level.span, closed.span, 0.05 * bar)
    # The last bar has the tension of its middle.
    last = of.line.segments[-1].submerged_weight * bar
    unlike("level, fairlead", level.fairlead, closed.fairlead.tension - 0.4 * last, 0.3 * last)
    unlike("level, lying", level.lying, closed.grounded_length, 2.0 * bar)
    heavy = at_rest(scaled(of, 10.0))
    unlike("ten times the weight, span", heavy.span, due.span, 1e-6 * length)
    unlike("ten times the weight, anchor", heavy.anchor, 10.0 * due.anchor, 1e-4 * heavy.fairlead)
    twice = at_rest(larger(of, 2.0))
    unlike("twice the size, span", twice.span, 2.0 * due.span, 1e-5 * length)
    unlike("twice the size, fairlead", twice.fairlead, 2.0 * due.fairlead, 1e-5 * twice.fairlead)
    cut = at_rest(halved(of))
    unlike("of halves, span", cut.span, due.span, 0.05 * bar)
    unlike("of halves, fairlead", cut.fairlead, due.fairlead, 2e-3 * due.fairlead)
    finer = at_rest(of, 2 * BARS)
    unlike("twice the bars, span", finer.span, due.span, 0.05 * bar)
    more = at_rest(replace(of, force=1.2 * of.force))
    if more.span <= due.span:
        found.append(f"more force: span {more.span!r} for {due.span!r}")
    if more.lying > due.lying + bar:
        found.append(f"more force: {more.lying!r} m lie for {due.lying!r}")
    # The bed rises along x, towards the fairlead, and lifts the line with it.
    rising = at_rest(replace(of, slope=of.slope + math.radians(2.0), friction=0.0))
    smooth = at_rest(replace(of, friction=0.0))
    if rising.lying < smooth.lying - bar:
        found.append(f"a bed that rises more: {rising.lying!r} m lie for {smooth.lying!r}")
    laid = at_rest(replace(of, initial="laid"))
    if not laid.span - 1e-6 * length <= smooth.span <= due.span + 1e-6 * length and not (
        due.span - 1e-6 * length <= smooth.span <= laid.span + 1e-6 * length
    ):
        found.append(
            f"span without friction {smooth.span!r}, pulled {due.span!r}, laid {laid.span!r}"
        )
    if due.anchor > smooth.anchor * (1.0 + 1e-6) + 1.0:
        found.append(f"pulled friction leaves {due.anchor!r} at the anchor, none {smooth.anchor!r}")
    return found


def test_a_line_on_a_slope_is_the_same_said_in_another_way() -> None:
    found = {seed: faults(seed) for seed in range(5)}
    assert {seed: each for seed, each in found.items() if each} == {}
    assert sum(each is None for each in found.values()) <= 2  # that slide down


if __name__ == "__main__":
    begin, number = map(int, sys.argv[1:])
    slid = 0
    for each in range(begin, begin + number):
        said = faults(each)
        slid += said is None
        if said:
            sys.stdout.write(f"{each}: {said}\n")
    sys.stdout.write(f"{number} lines on slopes, {slid} of which slide down\n")
