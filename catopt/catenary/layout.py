"""The line laid out from the anchor up: its uniform stretches, its shape and its tension.

The line as uniform runs that hang or lie on the bed throughout, from the fairlead down.

The kernel says of a line its ends; here its answer is followed along the line. Laid out from the
anchor up, where the runs end against where the fairlead is, is a check and not a repetition.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Annotated, Any, NamedTuple

from catopt.catenary.lower_part import Touchdown, lower_part, on_bed, touchdown_of
from catopt.catenary.pieces import LineProblem, Pieces, piece_reach, piece_rise, tension_past_clump
from catopt.catenary.sliding import (
    Onset,
    from_its_anchor,
    loose_below,
    onset_of,
    start_below,
    tight_above,
)
from catopt.catenary.state import IN_PARTS, LOOSE, SLACK, TURNED, State
from catopt.catenary.suspended import (
    NO_TOUCHDOWN,
    Part,
    at_clump,
    inside,
    part_reach,
    share,
    with_force,
)
from catopt.catenary.upper_part import lying_end, upper_part
from catopt.model.kinds import Force, Place
from catopt.records import From, Record

_UPRIGHT = 1e-6
"""Of the length of a line: with less span its ends are one above the other."""
_RUNS_PER_PIECE = 4
"""A piece may hang, lie with tension, lie without it and hang again."""


class LineIntervals(NamedTuple):
    """Work space for the runs of one line: lists, or arrays in compiled code.

    Of each run the piece, on_bed (1 on the bed), the unstretched length (m), the forces on its
    lower end (N), what friction on the bed adds to its tension towards the fairlead (N/m), and
    `slope`, the sine of the inclination of one without weight or force.
    """

    piece: Any
    on_bed: Any
    length: Any
    H: Any
    V: Any
    friction: Any
    slope: Any


def most_runs(pieces: int) -> int:
    """Room that the runs of a line take at most; its loose part may begin within a piece."""
    return _RUNS_PER_PIECE * (pieces + 1)


def runs_of(state: State, problem: LineProblem, runs: LineIntervals) -> int:
    """Write the runs of a solved line, from the fairlead down, and count them."""
    if state.touchdown == IN_PARTS:
        return _in_parts(_upper_part(state.H, state.V, problem), problem, runs, 0)
    if state.touchdown == TURNED:
        other_way = from_its_anchor(problem)
        upper = _upper_part(state.H_anchor, -state.V_anchor, other_way)
        count = _in_parts(upper, other_way, runs, 0)
        _turn(other_way.pieces, runs, count)
        return count
    if state.touchdown == LOOSE:
        return _loose(onset_of(state.span, problem), problem, runs)
    return _descending(state, problem, runs)


def _upper_part(H: float, V: float, problem: LineProblem) -> Part:
    """Find the part at the fairlead of a line with known forces there."""
    part = upper_part(H, problem)
    # All but a few lines nearly taut have the very force that is found again here.
    shift = V - part_reach(part, problem.pieces).V_top
    return with_force(part, part.piece, part.V + shift) if shift != 0.0 else part


def _loose(onset: Onset, problem: LineProblem, runs: LineIntervals) -> int:
    """Write the runs of a line above the place where its tight part begins, and below it."""
    tight, below = tight_above(onset, problem), loose_below(onset, problem)
    count = _in_parts(lying_end(onset.part.H, tight.pieces), tight, runs, 0)
    _turn(tight.pieces, runs, count)
    for row in range(count):
        runs.piece[row] += len(problem.pieces.length) - len(tight.pieces.length)
    return _in_parts(start_below(onset, below), below, runs, count)


def _in_parts(part: Part, problem: LineProblem, runs: LineIntervals, count: int) -> int:
    """Write the runs of a line in parts from a row on, beginning with the part at its fairlead."""
    pieces = problem.pieces
    count = _hanging(part, pieces, runs, count)
    while part.touchdown != NO_TOUCHDOWN:
        down = touchdown_of(part, part_reach(part, pieces).V_bottom, pieces)
        part = lower_part(down, problem)
        count = _lying(down, part.top, part.top_length, problem, runs, count)
        if part.bottom < 0:
            break
        count = _hanging(part, pieces, runs, count)
    return count


def _turn(pieces: Pieces, runs: LineIntervals, count: int) -> None:
    """Turn the runs of a line that was counted from its anchor: order, ends and signs."""
    for row in range((count + 1) // 2):
        other = count - 1 - row
        here, there = _turned_row(pieces, runs, row), _turned_row(pieces, runs, other)
        _write(runs, row, *there)
        _write(runs, other, *here)


def _turned_row(
    pieces: Pieces, runs: LineIntervals, row: int
) -> tuple[int, float, float, float, float, float, int]:
    """Return one run as seen from the other end of the line."""
    k, length, friction = runs.piece[row], runs.length[row], runs.friction[row]
    H = runs.H[row] + friction * length
    V = -(runs.V[row] + pieces.weight[k] * length) if runs.on_bed[row] == 0 else 0.0
    own = len(pieces.length) - 1 - k
    return own, length, H, V, -friction, -runs.slope[row], runs.on_bed[row]


def _descending(state: State, problem: LineProblem, runs: LineIntervals) -> int:
    """Write the runs of a line of a single part, with the forces counted from the fairlead."""
    pieces = problem.pieces
    H, V = state.H, state.V
    row = 0
    for k in range(len(pieces.length) - 1, -1, -1):
        length = pieces.length[k]
        if state.touchdown == inside(k):
            hanging = max(V, 0.0) / pieces.weight[k] if pieces.weight[k] > 0.0 else 0.0
            hanging = min(hanging, length)
            _write(runs, row, k, hanging, H, 0.0, 0.0, 0.0, 0)
            down = Touchdown(H, k, length - hanging, -1, 0.0)
            return _lying(down, 0, 0.0, problem, runs, row + 1)
        V -= pieces.weight[k] * length
        _write(runs, row, k, length, H, V, 0.0, 0.0, 0)
        row += 1
        if state.touchdown == at_clump(k):
            down = Touchdown(H, k - 1, pieces.length[k - 1], k, pieces.load[k] - V)
            return _lying(down, 0, 0.0, problem, runs, row)
        V -= pieces.load[k]
    return row


def _write(
    runs: LineIntervals,
    row: int,
    piece: int,
    length: float,
    H: float,
    V: float,
    friction: float,
    slope: float,
    on_bed: int,
) -> None:
    runs.piece[row] = piece
    runs.length[row] = length
    runs.H[row] = H
    runs.V[row] = V
    runs.friction[row] = friction
    runs.slope[row] = slope
    runs.on_bed[row] = on_bed


def _hanging(part: Part, pieces: Pieces, runs: LineIntervals, first: int) -> int:
    """Write the runs of a part, with the forces counted from where they are known."""
    V = part.V
    for k in range(part.piece, part.top + 1):
        if k > part.piece:
            V += pieces.load[k]
        length = share(part, pieces, k)
        _write(runs, first + part.top - k, k, length, part.H, V, 0.0, part.slope, 0)
        V += pieces.weight[k] * length
    V = part.V
    for k in range(part.piece - 1, part.bottom - 1, -1):
        length = share(part, pieces, k)
        V -= pieces.load[k + 1] + pieces.weight[k] * length
        _write(runs, first + part.top - k, k, length, part.H, V, 0.0, part.slope, 0)
    return first + part.top - part.bottom + 1


def _lying(
    down: Touchdown,
    end: int,
    end_rest: float,
    problem: LineProblem,
    runs: LineIntervals,
    first: int,
) -> int:
    """Write the runs of a stretch on the bed, with what friction leaves of the tension."""
    pieces, friction = problem.pieces, problem.friction
    row = first
    T = on_bed(down, problem)
    for k in range(down.piece, end - 1, -1):
        length = down.rest if k == down.piece else pieces.length[k]
        if k == end:
            length -= end_rest
        loss = friction * pieces.weight[k]
        held = length if loss * length <= T else T / loss
        T = max(T - loss * held, 0.0)
        if held > 0.0:
            _write(runs, row, k, held, T, 0.0, loss, 0.0, 1)
            row += 1
        if length > held:
            _write(runs, row, k, length - held, 0.0, 0.0, 0.0, 0.0, 1)
            row += 1
            T = 0.0
        T = tension_past_clump(T, pieces, k, friction, pieces.load[k])
    return row


def run_reach(
    H: float,
    V: float,
    length: float,
    weight: float,
    compliance: float,
    friction: float,
    slope: float,
    on_bed: bool,
) -> tuple[float, float]:
    """How far and how high the lower `length` (m) of a run reaches, m.

    H and V are the forces on its lower end, N; the rest as in `LineIntervals`.
    """
    if length == 0.0:
        return 0.0, 0.0
    if on_bed:
        return length * (1.0 + compliance * (H + 0.5 * friction * length)), 0.0
    V2 = V + weight * length
    if H == 0.0:
        loose = V == 0.0 and V2 == 0.0
        dx = length * math.sqrt(1.0 - slope * slope) if loose else 0.0
        return dx, piece_rise(0.0, V, V2, length, compliance, slope)
    T1, T2 = math.sqrt(H * H + V * V), math.sqrt(H * H + V2 * V2)
    reach = piece_reach(H, V, V2, T1, T2, length, compliance)
    return reach.dx, reach.dz


def runs_misfit(
    state: State, problem: LineProblem, runs: LineIntervals, count: int, span: float
) -> tuple[float, float]:
    """By how much a line laid out from its anchor misses its fairlead in height and span, m.

    Reached less wanted, of the runs that `runs_of` has written.
    """
    pieces = problem.pieces
    x = 0.0
    z = problem.anchor_height
    for row in range(count - 1, -1, -1):
        k = runs.piece[row]
        dx, dz = run_reach(
            runs.H[row],
            runs.V[row],
            runs.length[row],
            pieces.weight[k],
            pieces.compliance[k],
            runs.friction[row],
            runs.slope[row],
            runs.on_bed[row] == 1,
        )
        x += dx
        z += dz
    x *= slack_share(state, x)
    return z - problem.fairlead_height, x - span


def slack_share(state: State, span: float) -> float:
    """Span of a slack line as a part of the largest that it can have; 1 for other lines."""
    return state.span / span if state.regime == SLACK and span > 0.0 else 1.0


@dataclass(frozen=True)
class Stretch:
    """A uniform part of the line that either hangs or lies on the bed throughout.

    All of its lower-s end: `start` the unstretched arc length there, x and z (m, z above the
    seabed) and the forces on it (N). compliance is 1/EA (1/N), friction what its tension gains per
    unstretched length towards the fairlead (N/m), `piece` counts from the anchor. `gathered` is the
    part of its reach that is used: below 1 where a slack line lies in bights on the bed. `slope` is
    the sine of the inclination of a stretch that has neither weight nor force. `natural` is the
    length without tension, by the law that its strain follows there, as a part of `length`.
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
    natural: float = 1.0


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


def listed_runs(state: State, problem: LineProblem) -> tuple[LineIntervals, int]:
    """List the runs of a solved line, from the fairlead down, and how many they are."""
    room = most_runs(len(problem.pieces.length))
    runs = LineIntervals([0] * room, [0] * room, *([0.0] * room for _ in range(5)))
    return runs, runs_of(state, problem, runs)


def lay_out(
    state: State, problem: LineProblem, runs: LineIntervals, count: int
) -> tuple[Stretch, ...]:
    """Place every run of the line, from the anchor up."""
    pieces = problem.pieces
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
    part = slack_share(state, x)
    if part != 1.0:
        # The ends of a slack line are drawn together: what carries no tension lies in bights.
        stretches = [replace(each, x=each.x * part, gathered=part) for each in stretches]
    return tuple(stretches)


def end_of(stretch: Stretch, length: float) -> tuple[float, float]:
    """Place of the point `length` (m, unstretched) above the lower end of a stretch."""
    natural = stretch.natural
    dx, dz = run_reach(
        stretch.horizontal_force,
        stretch.vertical_force,
        length * natural,
        stretch.submerged_weight / natural,
        stretch.compliance / natural,
        stretch.friction / natural,
        stretch.slope,
        stretch.on_bed,
    )
    return stretch.x + dx * stretch.gathered, stretch.z + dz


_SAME = 1e-12
"""Of the length of a line: places as far apart in height are one."""


@dataclass(frozen=True)
class LowestPoint(Record):
    """Where a line is lowest; of what lies on the bed the end towards the fairlead."""

    DOCUMENT = "s x z"

    s: Place
    """Unstretched arc length from the anchor."""
    x: Place
    """Horizontal distance from the anchor."""
    z: Place
    """Above the seabed."""


class TouchdownPoint(LowestPoint):
    """Where a line comes to the bed, or leaves it."""


def touchdowns_of(stretches: Sequence[Stretch]) -> tuple[TouchdownPoint, ...]:
    """Find where a laid-out line comes to the bed or leaves it, from the anchor up.

    Examples
    --------
    >>> from catopt import Line, Segment, solve
    >>> line = solve(Line([Segment(100.0, 100.0)]), height=20.0, horizontal_force=1e3)
    >>> [round(each.s, 6) for each in line.touchdowns]  # 100 - sqrt(20 (20 + 2 a)), a = 10 m
    [71.715729]
    """
    return tuple(
        TouchdownPoint(each.start, each.x, each.z)
        for before, each in pairwise(stretches)
        if before.on_bed != each.on_bed
    )


def lowest_point(stretches: Sequence[Stretch]) -> LowestPoint:
    """Find where a laid-out line is lowest.

    Examples
    --------
    >>> from catopt import Line, Segment, solve
    >>> line = solve(Line([Segment(10.0, 100.0)]), height=20.0, anchor_height=20.0, span=8.0)
    >>> round(line.lowest_point.s, 6), round(line.lowest_point.x, 6)
    (5.0, 4.0)
    """
    places = _turning_at(stretches, 0.0)
    least = min(each.z for each in places) + _SAME * places[-1].s
    return max((each for each in places if each.z <= least), key=lambda each: each.s)


def highest_afloat(stretches: Sequence[Stretch]) -> float:
    """Return the height of the highest point of what is buoyant of a line, m; -inf without it."""
    buoyant = [each for each in stretches if each.submerged_weight < 0.0]
    return max((each.z for each in _turning_at(buoyant, 0.0)), default=-math.inf)


def sag_of(stretches: Sequence[Stretch], span: float, height: float) -> float:
    """Return the largest vertical distance of a line below the straight one between its ends, m.

    That is where it is parallel to it; of a line whose ends are one above the other it counts from
    the lower end. `height`: of the upper end above the bed, m.
    """
    first = stretches[0]
    if span <= _UPRIGHT * (stretches[-1].start + stretches[-1].length):
        return max(min(first.z, height) - lowest_point(stretches).z, 0.0)
    slope = (height - first.z) / span
    below = (first.z + slope * (p.x - first.x) - p.z for p in _turning_at(stretches, slope))
    return max(*below, 0.0)


def _turning_at(stretches: Sequence[Stretch], slope: float) -> list[LowestPoint]:
    """List the ends of all stretches, and where those that hang have a slope, by arc length."""
    found = []
    for each in stretches:
        ways = [0.0, each.length]
        if not each.on_bed and each.submerged_weight:
            turn = (each.horizontal_force * slope - each.vertical_force) / each.submerged_weight
            ways[1:1] = [turn] if 0.0 < turn < each.length else []
        found += [LowestPoint(each.start + way, *end_of(each, way)) for way in ways]
    return found


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


def stretched_length(stretch: Stretch, end: float) -> float:
    """Length of a stretch under its tension, m: l + (1/EA) times the integral of T.

    `end`: x of its upper end, m.
    """
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
    dx = end - stretch.x - stretch.compliance * H * length
    integral = 0.5 * (H * dx + 0.5 * length * m + 0.5 * length * S * S / m)
    return length + stretch.compliance * integral
