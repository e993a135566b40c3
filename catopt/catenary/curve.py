"""The load curve of one line: span, forces and grounded length over a range of force or span.

A curve is some fifty lines and a few closings-in on marks. The plain kernel does that in less time
than it takes to load the compiled one; `solve_many` is for more.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, field, replace
from itertools import pairwise
from typing import Annotated, Literal, get_args

import numpy as np

from catopt.arrays import Array
from catopt.catenary.equilibrium import BY_FORCE, BY_SPAN, given_force
from catopt.catenary.find import find_limit_force
from catopt.catenary.pieces import LineProblem, cut
from catopt.catenary.solution import Solution
from catopt.catenary.solve import by_first_rows, has_table, solution_of, solve, solve_by_table
from catopt.catenary.span_or_tension import given_span
from catopt.catenary.state import CONVERGED, REGIMES, Regime, State
from catopt.display import Tabled
from catopt.errors import NoAnswerError, NoEquilibriumError, NotConvergedError
from catopt.model import Line
from catopt.model.kinds import Findings, Measured, Place, SomeForce
from catopt.progress import paced
from catopt.records import From, OrNull, Record
from catopt.units import Dimension
from catopt.words import Message, Several, term

__all__ = ["Curve", "Mark", "check_range", "load_curve"]

Over = Literal["span", "horizontal_force"]
MarkKind = Literal["regime", "clump_weight", "limit"]

MOST_POINTS = 10_000
BEYOND = 1.05
LEAST = 0.01
"""A range that is not given runs from this part of a force to that, which shows its mark."""


@dataclass(frozen=True)
class Mark(Record):
    """A point of the curve at which something changes."""

    DOCUMENT = "kind event horizontal_force span fairlead_tension"

    kind: MarkKind
    """What changes: the regime, whether a clump weight lies on the bed, or whether a limit is
    kept."""
    event: str
    """What happens as the force grows, in words."""
    horizontal_force: SomeForce
    """At the fairlead."""
    span: Place
    """Where it happens."""
    fairlead_tension: SomeForce
    """Effective tension."""


Spans = Annotated[Array, Measured(Dimension.LENGTH), From(2)]
Forces = Annotated[Array, Measured(Dimension.FORCE), From(2)]


@dataclass(frozen=True)
class Curve(Tabled):
    """A load curve, by rising span; arrays of shape (points,)."""

    over: Over  # which was stepped evenly
    span: Spans
    """Horizontal distance from the anchor to the fairlead, rising."""
    horizontal_force: Forces
    """At the fairlead."""
    fairlead_tension: Forces
    """Effective tension at the fairlead."""
    anchor_tension: Forces
    """Effective tension at the anchor, after seabed friction."""
    anchor_angle: Annotated[Array, Measured(Dimension.ANGLE), From(2)]
    """Inclination at the anchor."""
    grounded_length: Spans
    """Unstretched length of line on the seabed."""
    stiffness: Annotated[Array, Measured(Dimension.FORCE_PER_LENGTH), From(2), OrNull]
    """Slope of the horizontal force over the span at a fixed height: 0 where the line is slack;
    nan, in documents None, where the span does not change with the force."""
    regime: Annotated[tuple[Regime, ...], From(2)]
    """How the line hangs."""
    marks: tuple[Mark, ...]
    """Where something changes, by rising span; between the points, too."""


def load_curve(
    line: Line,
    *,
    height: float,
    over: Over = "horizontal_force",
    start: float | None = None,
    stop: float | None = None,
    points: int = 50,
    seabed_friction: float = 0.0,
    anchor_height: float = 0.0,
    safety_factor: float = 1.0,
    max_anchor_angle: float | None = None,
) -> Curve:
    """Compute a line's load curve.

    Parameters
    ----------
    line : Line
        The line.
    height, seabed_friction, anchor_height
        As for `solve`.
    over : {"span", "horizontal_force"}
        What is stepped.
    start, stop : float, optional
        Its range: m or N. What is left out is taken from a horizontal force: 1 % and 105 % of the
        one at which a segment reaches MBL over the safety factor, or of what the line weighs.
    points : int
        From 2 to 10 000.
    safety_factor : float
        For the limit MBL over safety factor of each segment whose MBL is known.
    max_anchor_angle : float, optional
        Limit of the inclination at the anchor, rad.

    Raises
    ------
    InputError
        When the range is empty or there are too few or too many points.
    NoEquilibriumError, NotConvergedError
        When a point of the range has no answer; as `solve` has it there.

    Examples
    --------
    >>> from catopt import Line, Segment, load_curve
    >>> curve = load_curve(Line([Segment(200.0, 1500.0, MBL=6e6)]), height=30.0, safety_factor=2.0)
    >>> round(float(curve.horizontal_force[-1]) / 1e3), len(curve.marks)
    (3087, 2)
    """
    found = Findings("load_curve")
    height = found.taken("height", height, "m", at_least=0.0)
    anchor_height = found.taken("anchor_height", anchor_height, "m", at_least=0.0)
    seabed_friction = found.taken("seabed_friction", seabed_friction, "", at_least=0.0)
    found.word("over", over, get_args(Over))
    unit = "m" if over == "span" else "N"
    if isinstance(start, str):
        start = found.taken("start", start, unit, at_least=0.0)
    if isinstance(stop, str):
        stop = found.taken("stop", stop, unit, at_least=0.0)
    found.raise_if_any()
    if start is None or stop is None:
        place = {"height": height, "anchor_height": anchor_height}
        place["seabed_friction"] = seabed_friction
        force, _ = limit_force(line, place, safety_factor) or weight_force(line)
        ends = [part * force for part in (LEAST, BEYOND)]
        if over == "span":
            ends = [solve(line, horizontal_force=each, **place).span for each in ends]
        start, stop = ends[0] if start is None else start, ends[1] if stop is None else stop
    check_range(start, stop, points, "m" if over == "span" else "N")
    pieces, segment_of = cut(by_first_rows(line) if has_table(line) else line)
    problem = LineProblem(pieces, anchor_height, height, seabed_friction)
    way = _Way(line, problem, segment_of, over)
    values = [float(value) for value in np.linspace(start, stop, points)]
    way.solution(values[-1])  # checks the arguments, and tells a range too long by its end
    pace = Message("words.curve_points", total=points)
    states = [way.state(value) for value in paced(pace, values)]
    marks = [
        *_regime_changes(way, values),
        *_clump_weights_lift(way, values),
        *_strength_limits(way, values, safety_factor),
        *_anchor_limit(way, values, max_anchor_angle),
    ]
    return Curve(
        over=over,
        span=np.array([s.span for s in states]),
        horizontal_force=np.array([s.H for s in states]),
        fairlead_tension=np.array([math.hypot(s.H, s.V) for s in states]),
        anchor_tension=np.array([math.hypot(s.H_anchor, s.V_anchor) for s in states]),
        anchor_angle=np.array([_anchor_angle(s) for s in states]),
        grounded_length=np.array([s.grounded for s in states]),
        stiffness=np.array([_stiffness(s) for s in states]),
        regime=tuple(REGIMES[s.regime] for s in states),
        marks=tuple(sorted(marks, key=lambda mark: (mark.span, mark.horizontal_force))),
    )


def limit_force(
    line: Line, place: Mapping[str, float], safety_factor: float
) -> tuple[float, Message] | None:
    """Return the horizontal force at which a segment is first at its limit, and what it is.

    None where no MBL is known, or none is reached.
    """
    if any(segment.MBL is not None for segment in line.segments):
        with suppress(NoAnswerError):
            found = find_limit_force(line, safety_factor=safety_factor, segment=None, **place)
            return found.value, Message("catenary.limit_force", condition=found.condition)
    return None


def weight_force(line: Line) -> tuple[float, Message]:
    """Return what a line weighs, as the force of a curve of which nothing else is known, N."""
    weight = math.fsum(abs(each.submerged_weight) * each.length for each in line.segments)
    return weight, Message("catenary.line_weight")


def check_range(start: float, stop: float, points: int, unit: str, zero: float = 0.0) -> None:
    """Raise InputError unless a range rises above 0 in a sensible number of points.

    Parameters
    ----------
    start, stop : float
        m or N.
    points : int
        How many.
    unit : str
        Of the range.
    zero : float
        Where the user counts from, for the messages.
    """
    found = Findings("curve")
    for key, value in (("start", start), ("stop", stop)):
        if not 0.0 < value < math.inf:
            key_ = "refused_motion.above_zero_span" if zero else "refused_motion.above_least"
            allowed = Message(key_, least=0.0 - zero, unit=unit)
            found.add(key, f"{value - zero:.6g} {unit}", allowed)
    if not found.problems and not start < stop:
        above = Message("refused_motion.must_be_above_start_range", start=start - zero, unit=unit)
        found.add("stop", f"{stop - zero:.6g} {unit}", above)
    if not 2 <= points <= MOST_POINTS:
        allowed = Message("refused_motion.must_be_from_2", most_points=MOST_POINTS)
        found.add("points", str(points), allowed)
    found.raise_if_any()


def _anchor_angle(state: State) -> float:
    return math.atan2(state.V_anchor, state.H_anchor)


def _stiffness(state: State) -> float:
    """Slope dH/dS at a fixed height, from the derivatives of span and height by H and V; N/m."""
    if state.H == 0.0:
        return 0.0
    # The height stays when V follows H by dV/dH = -z_H / z_V; nothing lifts where z_V is 0.
    follows = state.z_H / state.z_V if state.z_V != 0.0 else 0.0
    flexibility = state.x_H - state.x_V * follows
    return 1.0 / flexibility if flexibility > 0.0 else math.nan


# ------------------------------------------------------------------ the line at a value


@dataclass(frozen=True)
class _Way:
    """The line along its curve: solved at any value of what is stepped, once at each."""

    line: Line
    problem: LineProblem
    segment_of: tuple[int, ...]
    over: Over
    known: dict[float, State] = field(default_factory=dict)

    def state(self, value: float) -> State:
        """Solve at a value; raise what `solve` raises where there is no answer."""
        if value not in self.known:
            self.known[value] = self._solved(value)
        return self.known[value]

    def largest_tension(self, value: float, segment: int) -> float:
        """Largest tension in a segment at a value, N."""
        if has_table(self.line):
            return self.solution(value).segments[segment].max_tension
        state = self.state(value)
        known = BY_SPAN if self.over == "span" else BY_FORCE
        laid = solution_of(
            state, self.line, self.problem, self.segment_of, method="closed-form", known=known
        )
        return laid.segments[segment].max_tension

    def _by_table(self, value: float) -> State:
        """Solve with tables; what a line of parts gives way by is what the whole line does."""
        found, parts = solve_by_table(self.line, lambda of: replace(self, line=of).solution(value))
        of = self.problem
        held = LineProblem(cut(parts)[0], of.anchor_height, of.fairlead_height, of.friction)
        state = given_force(found.horizontal_force, held)
        return state._replace(span=found.span, grounded=found.grounded_length)

    def _solved(self, value: float) -> State:
        if has_table(self.line):
            return self._by_table(value)
        if self.over == "span":
            state = given_span(value, self.problem, math.nan, math.nan)
        else:
            state = given_force(value, self.problem)
        if state.status != CONVERGED:
            self.solution(value)  # raises, with the reason
            raise NotConvergedError(self._at(value, Message("catenary.curve_not_converged")))
        return state

    def solution(self, value: float) -> Solution:
        """Solve at a value, with the whole line laid out; errors say at which value they arose."""
        is_span = self.over == "span"
        try:
            return solve(
                self.line,
                height=self.problem.fairlead_height,
                horizontal_force=None if is_span else value,
                span=value if is_span else None,
                seabed_friction=self.problem.friction,
                anchor_height=self.problem.anchor_height,
            )
        except NoEquilibriumError as stop:
            reported = self._at(value, Several((stop.message, *self._farthest()), " "))
            raise NoEquilibriumError(reported, stop.quantity, stop.missing) from stop
        except NotConvergedError as stop:
            raise type(stop)(self._at(value, stop.message)) from stop

    def mark(self, kind: MarkKind, event: str, at: float) -> Mark:
        """Make a mark at a value."""
        there = self.state(at)
        return Mark(kind, event, there.H, there.span, math.hypot(there.H, there.V))

    def _at(self, value: float, what: str) -> Message:
        key = "catenary.at_span" if self.over == "span" else "catenary.at_force"
        return Message(key, value=value, what=what)

    def _farthest(self) -> Iterator[Message]:
        rise = self.problem.fairlead_height - self.problem.anchor_height
        room = self.line.length**2 - rise**2
        is_stiff = all(segment.is_inextensible for segment in self.line.segments)
        if self.over == "span" and room > 0.0 and is_stiff:
            yield Message("catenary.end_the_range", span=math.sqrt(room))


# ------------------------------------------------------------------ where something changes


def _regime_changes(way: _Way, values: list[float]) -> Iterator[Mark]:
    for place, before, after in _changes(way, values, lambda state: state.regime):
        words = {"before": term(REGIMES[before]), "after": term(REGIMES[after])}
        yield way.mark("regime", Message("catenary.regime_change", **words), place)


def _clump_weights_lift(way: _Way, values: list[float]) -> Iterator[Mark]:
    """Find where a clump weight begins to lift and where it is off the bed.

    Only with the anchor on the bed, where the grounded length tells the touchdown: while a clump
    weight lifts, the line leaves the bed at it.
    """
    if way.problem.anchor_height > 0.0:
        return
    tolerance = 1e-12 * way.line.length
    for number, load in enumerate(way.line.point_loads, start=1):
        if load.submerged_weight <= 0.0:
            continue

        def stage(state: State, position: float = load.position) -> int:
            hanging = position - state.grounded
            return (hanging > -tolerance) + (hanging > tolerance)

        for place, _, after in _changes(way, values, stage):
            event = _named("weight_lifts" if after == 1 else "weight_off", load.name, number=number)
            yield way.mark("clump_weight", event, place)


def _strength_limits(way: _Way, values: list[float], safety_factor: float) -> Iterator[Mark]:
    """Find where the largest tension of a segment passes its MBL over the safety factor."""
    for index, segment in enumerate(way.line.segments):
        if segment.MBL is None:
            continue

        def is_beyond(value: float, index: int = index, MBL: float = segment.MBL) -> int:
            return way.largest_tension(value, index) > MBL / safety_factor

        event = _named("reaches_MBL", segment.name, number=index + 1, factor=safety_factor)
        for place, _, after in _crossings(values, is_beyond):
            if after:
                yield way.mark("limit", event, place)


def _anchor_limit(way: _Way, values: list[float], limit: float | None) -> Iterator[Mark]:
    """Find where the inclination at the anchor passes its limit."""
    if limit is None:
        return
    for place, _, after in _changes(way, values, lambda state: _anchor_angle(state) > limit):
        if after:
            event = Message("catenary.reaches_angle", angle=math.degrees(limit))
            yield way.mark("limit", event, place)


_EVENTS = {
    "weight_lifts": ("catenary.weight_lifts", "catenary.named_weight_lifts"),
    "weight_off": ("catenary.weight_off", "catenary.named_weight_off"),
    "reaches_MBL": ("catenary.reaches_MBL", "catenary.named_reaches_MBL"),
}
"""Keys of events, of a part without a name and of one with it."""


def _named(event: str, name: str, **values: object) -> Message:
    plain, named = _EVENTS[event]
    return Message(named, name=name, **values) if name else Message(plain, **values)


def _changes(
    way: _Way, values: list[float], code: Callable[[State], int]
) -> Iterator[tuple[float, int, int]]:
    """Yield where a code of the state changes, as `_crossings` does."""
    return _crossings(values, lambda value: code(way.state(value)))


def _crossings(
    values: list[float], code: Callable[[float], int]
) -> Iterator[tuple[float, int, int]]:
    """Yield every change of a code between neighbours: where, and the code before and after.

    Several changes between the same neighbours are found one after the other.
    """
    codes = [code(value) for value in values]
    for (low, high), (now, last) in zip(pairwise(values), pairwise(codes), strict=True):
        before = low
        while now != last:
            before, after = _last_before(before, high, code, now)
            new = code(after)
            yield 0.5 * (before + after), now, new
            before, now = after, new


def _last_before(
    low: float, high: float, code: Callable[[float], int], now: int
) -> tuple[float, float]:
    """Bisect to the last value with the code `now`, to 1e-13 of itself, and the first without."""
    while high - low > 1e-13 * high:
        middle = 0.5 * (low + high)
        low, high = (middle, high) if code(middle) == now else (low, middle)
    return low, high
