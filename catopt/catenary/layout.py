"""The line laid out from the anchor up: its uniform stretches, its shape and its tension."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Annotated

from catopt.catenary.pieces import LineProblem
from catopt.catenary.runs import Runs, most_runs, run_reach, runs_of, slack_share
from catopt.catenary.state import State
from catopt.model.kinds import Force, Place
from catopt.records import From, Record


@dataclass(frozen=True)
class Stretch:
    """A uniform part of the line that either hangs or lies on the bed throughout.

    All of its lower-s end: `start` the unstretched arc length there, x and z (m, z above the
    seabed) and the forces on it (N). compliance is 1/EA (1/N), friction what its tension gains per
    unstretched length towards the fairlead (N/m), `piece` counts from the anchor. `gathered` is the
    part of its reach that is used: below 1 where a slack line lies in bights on the bed. `slope` is
    the sine of the inclination of a stretch that has neither weight nor force.
    """

    start: float
    length: float
    submerged_weight: float
    compliance: float
    x: float
    z: float
    horizontal_force: float
    vertical_force: float
    friction: float
    on_bed: bool
    piece: int = 0
    gathered: float = 1.0
    slope: float = 0.0


@dataclass(frozen=True)
class Profile(Record):
    """Shape and tension at the same points in each list, from the anchor to the fairlead."""

    DOCUMENT = "s x z tension y?"

    s: Annotated[tuple[Place, ...], From(2)]
    """Unstretched arc length from the anchor."""
    x: Annotated[tuple[Place, ...], From(2)]
    """Horizontal distance from the anchor."""
    z: Annotated[tuple[Place, ...], From(2)]
    """Above the seabed."""
    tension: Annotated[tuple[Force, ...], From(2)]
    """Effective tension."""
    y: Annotated[tuple[Place, ...], From(2)] | None = None
    """Across x, to the left seen from the anchor; only in a current."""


def lay_out(state: State, problem: LineProblem) -> tuple[Stretch, ...]:
    """Place every run of the line, from the anchor up."""
    pieces = problem.pieces
    room = most_runs(len(pieces.length))
    columns = [[0.0] * room for _ in range(5)]
    runs = Runs([0] * room, [0] * room, *columns)
    count = runs_of(state, problem, runs)
    stretches: list[Stretch] = []
    start, x, z = 0.0, 0.0, problem.anchor_height
    for row in range(count - 1, -1, -1):
        piece = runs.piece[row]
        stretch = Stretch(
            start,
            runs.length[row],
            pieces.weight[piece],
            pieces.compliance[piece],
            x,
            z,
            runs.H[row],
            runs.V[row],
            runs.friction[row],
            runs.on_bed[row] == 1,
            piece,
            slope=runs.slope[row],
        )
        stretches.append(stretch)
        x, z = end_of(stretch, stretch.length)
        start += stretch.length
    return _gathered(state, stretches, x)


def _gathered(state: State, stretches: list[Stretch], span: float) -> tuple[Stretch, ...]:
    """Draw the ends of a slack line together: what carries no tension lies in bights."""
    part = slack_share(state, span)
    if part == 1.0:
        return tuple(stretches)
    return tuple(replace(each, x=each.x * part, gathered=part) for each in stretches)


def end_of(stretch: Stretch, length: float) -> tuple[float, float]:
    """Place of the point `length` (m, unstretched) above the lower end of a stretch."""
    dx, dz = run_reach(
        stretch.horizontal_force,
        stretch.vertical_force,
        length,
        stretch.submerged_weight,
        stretch.compliance,
        stretch.friction,
        stretch.slope,
        stretch.on_bed,
    )
    return stretch.x + dx * stretch.gathered, stretch.z + dz


def sample(stretches: Sequence[Stretch], points: int) -> Profile:
    """Sample a laid-out line at about `points` places, every joint and touchdown among them."""
    total = math.fsum(stretch.length for stretch in stretches)
    s: list[float] = []
    x: list[float] = []
    z: list[float] = []
    tension: list[float] = []
    for index, stretch in enumerate(stretches):
        parts = max(1, round((points - 1) * stretch.length / total)) if total > 0.0 else 1
        first = 0 if index == 0 or _jumps(stretches[index - 1], stretch) else 1
        for part in range(first, parts + 1):
            local = stretch.length * part / parts
            place = end_of(stretch, local)
            s.append(stretch.start + local)
            x.append(place[0])
            z.append(place[1])
            tension.append(tension_at(stretch, local))
    return Profile(tuple(s), tuple(x), tuple(z), tuple(tension))


def _jumps(lower: Stretch, upper: Stretch) -> bool:
    """Whether the tension jumps at a joint, so that both of its sides are sampled."""
    below, above = tension_at(lower, lower.length), tension_at(upper, 0.0)
    return abs(above - below) > 1e-9 * max(above, below)


def tension_at(stretch: Stretch, length: float) -> float:
    """Effective tension `length` (m, unstretched) above the lower end of a stretch, N."""
    if stretch.on_bed:
        return stretch.horizontal_force + stretch.friction * length
    return math.hypot(
        stretch.horizontal_force, stretch.vertical_force + stretch.submerged_weight * length
    )


def max_tension(stretch: Stretch) -> float:
    """Largest tension in a stretch, N: at one of its ends, for tension is convex along it."""
    return max(tension_at(stretch, 0.0), tension_at(stretch, stretch.length))


def stretched_length(stretch: Stretch) -> float:
    """Length of a stretch under its tension, m: l + (1/EA) times the integral of T."""
    H, V1, length = stretch.horizontal_force, stretch.vertical_force, stretch.length
    if length == 0.0 or stretch.compliance == 0.0:
        return length
    T1, T2 = tension_at(stretch, 0.0), tension_at(stretch, length)
    if stretch.on_bed:
        return length * (1.0 + stretch.compliance * 0.5 * (T1 + T2))
    S = 2.0 * V1 + stretch.submerged_weight * length
    m = T1 + T2
    if m == 0.0:
        return length
    dx = end_of(stretch, length)[0] - stretch.x - stretch.compliance * H * length
    integral = 0.5 * (H * dx + 0.5 * length * m + 0.5 * length * S * S / m)
    return length + stretch.compliance * integral
