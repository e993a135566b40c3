"""The load curve of a case: its range when none is given, and the document catopt.curve/1."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Literal, get_args

import numpy as np

from catopt.catenary.case import solve_case, under_a_load
from catopt.catenary.curve import (
    BEYOND,
    LEAST,
    Curve,
    Over,
    Spans,
    check_range,
    limit_force,
    load_curve,
    weight_force,
)
from catopt.catenary.solution import Solution, check_buoys
from catopt.catenary.solve import solve
from catopt.display import Displayable
from catopt.errors import FloatsUpError, refused
from catopt.model import Case
from catopt.model.kinds import Findings, Place, SomeForce
from catopt.model.network import Network, require_case
from catopt.records import Record
from catopt.words import Measure, Message

__all__ = ["STEPPED", "CaseCurve", "Stepped", "curve_case"]

Stepped = Literal["force", "span", "offset"]
STEPPED: tuple[Stepped, ...] = get_args(Stepped)


@dataclass(frozen=True)
class CurvePoint(Record):
    """The equilibrium that a case gives by itself."""

    DOCUMENT = "horizontal_force span fairlead_tension"

    horizontal_force: SomeForce
    """At the fairlead."""
    span: Place
    """Horizontal distance from the anchor to the fairlead."""
    fairlead_tension: SomeForce
    """Effective tension."""


@dataclass(frozen=True, repr=False)
class CaseCurve(Displayable, Record):
    """Load curve of one mooring line, by closed form; the lists have one entry a point.

    Points stand by rising span. Angles are inclinations above the horizontal, positive where the
    line rises towards the fairlead. Heights are above the seabed. The offset counts from the span
    of the case as `solve_case` answers it, whose line has what the case seeks, if anything.
    """

    SCHEMA = "catopt.curve/1"
    DOCUMENT = (
        "case.title over range_words=range reference.fairlead_height reference.anchor_height "
        "reference.seabed_friction reference.safety_factor at_reference=reference curve.span "
        "offset curve.horizontal_force curve.fairlead_tension curve.anchor_tension "
        "curve.anchor_angle curve.grounded_length curve.stiffness curve.regime curve.marks "
        "reference.found?"
    )

    case: Case
    over: Stepped
    """What was stepped evenly."""
    range_words: str
    """Where the range comes from, in words."""
    reference: Solution
    curve: Curve

    @property
    def at_reference(self) -> CurvePoint:
        """The equilibrium that the case gives by itself; the offset counts from its span."""
        of = self.reference
        return CurvePoint(of.horizontal_force, of.span, of.fairlead.tension)

    @property
    def offset(self) -> Spans:
        """Span less the span of the reference; negative towards the anchor."""
        return self.curve.span - self.reference.span

    def outline(self, points: int = 200) -> tuple[list[float], list[float], list[float]]:
        """Sample the curve for drawing: its own points and `points` more, evenly over the force.

        Near the taut line a step of the span may be a multiple of the force. By rising span: span
        (m), horizontal force and fairlead tension (N).
        """
        own = self.curve
        most = float(own.horizontal_force[-1])
        least = max(float(own.horizontal_force[0]), 1e-3 * most)
        between = _load_curve(self.case, self.reference, "horizontal_force", least, most, points)
        both = [
            np.concatenate([getattr(curve, key) for curve in (own, between)])
            for key in ("span", "horizontal_force", "fairlead_tension")
        ]
        order = np.lexsort((both[1], both[0]))
        span, force, tension = (values[order].tolist() for values in both)
        return span, force, tension


def curve_case(
    case: Case | Network,
    *,
    over: Stepped = "force",
    start: float | None = None,
    stop: float | None = None,
    points: int = 50,
) -> CaseCurve:
    """Compute the load curve of a case.

    Parameters
    ----------
    case : Case
        As read by `catopt.read_case`. Its load, or what it seeks, is the reference.
    over : {"force", "span", "offset"}
        What is stepped evenly: the horizontal force, the span, or the offset, which is the span
        less that of the reference.
    start, stop : float, optional
        Its range: m or N. What is left out is taken from a horizontal force: 1 % and 105 % of the
        larger of the reference's and the one at which a segment reaches MBL over the safety factor.
    points : int
        From 2 to 10 000.

    Raises
    ------
    InputError, NoAnswerError, NotConvergedError
        As for `solve_case` and `load_curve`; the range's problems have the keys ``start``,
        ``stop`` and ``points``.

    Examples
    --------
    >>> import catopt
    >>> case = catopt.read_case("cases/tanker-20m-sinker/case.toml")
    >>> frame = catopt.curve_case(case, points=3).to_dataframe()
    >>> list(frame.columns[:2]), len(frame)
    (['Span S (m)', 'Offset (m)'], 3)
    """
    found = Findings("curve")
    found.word("over", over, STEPPED)
    found.raise_if_any()
    unit = "N" if over == "force" else "m"
    start, stop = (
        found.taken(key, value, unit) if isinstance(value, str) else value
        for key, value in (("start", start), ("stop", stop))
    )
    found.raise_if_any()
    case = require_case(case)
    if case.site.is_in_air:
        lifted, lift = case.clear_of_the_ground
        found_above = curve_case(lifted, over=over, start=start, stop=stop, points=points)
        return replace(found_above, case=case, reference=found_above.reference.lowered(lift))
    case.check_still_water()
    case, warnings = under_a_load(case)
    reference = solve_case(case).with_warnings(warnings)
    zero = reference.span if over == "offset" else 0.0
    first = None if start is None else start + zero
    last = None if stop is None else stop + zero
    words: str = Message("catenary.range_given")
    if first is None or last is None:
        force, what = _size(case, reference)
        least, why = _least_force(case, reference, LEAST * force)
        words = _words(first, last, {"force": _force(force), "what": what}, why)
        first = _stepped(case, reference, over, least) if first is None else first
        last = _stepped(case, reference, over, BEYOND * force) if last is None else last
        if first == last and start is None and stop is None:
            reported = Message("refused_motion.span_this_line_does_not")
            raise refused("over", over, reported, "curve")
    check_range(first, last, points, unit, zero)
    kernel_over: Over = "horizontal_force" if over == "force" else "span"
    curve = _load_curve(case, reference, kernel_over, first, last, points)
    if any(load.submerged_weight < 0.0 for load in reference.line.point_loads):
        for force in curve.horizontal_force:
            _at(case, reference, float(force))
    return CaseCurve(case, over, words, reference, curve)


def _load_curve(
    case: Case, reference: Solution, over: Over, start: float, stop: float, points: int
) -> Curve:
    return load_curve(
        reference.line,
        over=over,
        start=start,
        stop=stop,
        points=points,
        **case.place,
        safety_factor=case.checks.safety_factor,
        max_anchor_angle=case.checks.max_anchor_uplift_angle,
    )


def _size(case: Case, reference: Solution) -> tuple[float, str]:
    """Return the horizontal force that sets the range, N, and what it is."""
    size = (reference.horizontal_force, Message("catenary.case_force"))
    if case.find is None or case.find.quantity != "limit_force":
        size = max(size, limit_force(reference.line, case.place, case.checks.safety_factor) or size)
    return size if size[0] > 0.0 else weight_force(reference.line)


def _least_force(case: Case, reference: Solution, least: float) -> tuple[float, str]:
    """Return a force from `least` up at which no buoy floats up, N, and why if it is above."""
    low, high = least, max(reference.horizontal_force, least)
    try:
        _at(case, reference, low)
        return low, ""
    except FloatsUpError:
        pass
    while high > 1.001 * low:
        middle = math.sqrt(low * high)
        try:
            _at(case, reference, middle)
            high = middle
        except FloatsUpError:
            low = middle
    return high, Message("catenary.range_afloat", low=_force(high))


def _at(case: Case, reference: Solution, force: float) -> Solution:
    found = solve(reference.line, horizontal_force=force, **case.place)
    check_buoys(found.line, (load.z for load in found.point_loads), case.site.water_depth)
    return found


def _stepped(case: Case, reference: Solution, over: Stepped, force: float) -> float:
    """Return what is stepped at a force: the force itself, or the span."""
    return force if over == "force" else _at(case, reference, force).span


def _words(first: float | None, last: float | None, size: Mapping[str, object], why: str) -> str:
    """Say where a range comes from, of which one end may be given."""
    low, high = 100 * LEAST, 100 * BEYOND
    if first is not None:
        return Message("catenary.range_up_to", high=high, **size)
    if last is not None:
        return why or Message("catenary.range_from", low=low, **size)
    if why:
        return Message("catenary.range_afloat_to", afloat=why, high=high, **size)
    return Message("catenary.range", low=low, high=high, **size)


def _force(force: float) -> Measure:
    return Measure("horizontal_force", force)
