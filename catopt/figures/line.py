"""A line in the water, the tension along it, and its load curve."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import accumulate, pairwise
from typing import TYPE_CHECKING, Any, NamedTuple

from catopt.figures.chart import (
    IN_TONNES,
    Area,
    Chart,
    Dimension,
    Level,
    Mark,
    Place,
    Point,
    Scale,
    Series,
    axis,
    pointed,
    span_of,
)
from catopt.quantities import QUANTITIES
from catopt.words import Measure, Message

if TYPE_CHECKING:
    from catopt.catenary.case_curve import CaseCurve
    from catopt.catenary.curve import Mark as Event
    from catopt.catenary.layout import Profile
    from catopt.catenary.solution import Solution
    from catopt.model import PointLoad

FAR = 2.5
"""A capacity above this multiple of the largest tension would press the curve to the axis."""
_POINTS = 161
_FLAT = 0.2
"""Height over span below which a line to scale shows little of its shape."""
_WIDE, _TALL = 536.0, 440.0
"""Size of a drawing to scale in units; room for its dimensions is measured in them."""
_LEAST = 200.0
"""Least length of a line on a drawing for which there is room."""
_SHORTEST = 60.0
"""Least length of a grounded part that is dimensioned."""
_BED, _ROW = 16.0, 34.0
"""Thickness of the bed, and height of a row of dimensions below it."""


def grounded_ends(solution: Solution) -> list[Place]:
    """Find where the line lies on the bed: from and to, m; parts that touch are one."""
    ends = [stretch.x for stretch in solution.stretches[1:]] + [solution.span]
    found: list[Place] = []
    for stretch, end in zip(solution.stretches, ends, strict=True):
        if stretch.on_bed and end > stretch.x:
            start = stretch.x
            if found and math.isclose(found[-1][1], start, abs_tol=1e-9 * max(end, 1.0)):
                start = found.pop()[0]
            found.append((start, end))
    return found


def touchdowns(solution: Solution) -> list[Place]:
    """Find where the line leaves the bed: x and arc length, m."""
    real = [stretch for stretch in solution.stretches if stretch.length > 0.0]
    return [
        (upper.x, upper.start) for lower, upper in pairwise(real) if lower.on_bed != upper.on_bed
    ]


def joints(solution: Solution) -> list[float]:
    """List the arc lengths at which one segment ends and the next begins, m."""
    return list(accumulate(segment.length for segment in solution.segments[:-1]))


class Failing(NamedTuple):
    """A check that fails: its kind, the segment that it is of, if of one, and its name."""

    kind: str
    segment: int | None
    name: str


def line_in_water(
    solution: Solution, depth: float, failing: Sequence[Failing] = (), *, readout: bool = True
) -> Chart:
    """Draw a line in water of a depth (m), to scale; checks that fail are marked where they do.

    An infinite depth is that of a line in air, without water and bed.

    `readout`: whether it says what is known at the places that a reader points at.
    """
    profile = solution.profile(_POINTS)
    left, right = _ends(solution, profile)
    in_air = depth == math.inf
    low = min(0.0, *profile.z) if in_air else 0.0
    top = max(0.0 if in_air else depth, solution.fairlead_height, *profile.z)
    unit = room_around(right - left, top - low)
    half, middle = max(right - left, _LEAST * unit) / 2.0, (left + right) / 2.0
    ends = middle - half - 60.0 * unit, middle + half + 60.0 * unit
    dimensions = tuple(_dimensions(solution, depth, unit, low))
    foot = min(end[1] for each in dimensions for end in (each.start, each.end))
    return _drawn(
        solution,
        profile,
        depth,
        _fails(solution, profile, failing),
        name="line",
        title=Message("figures.line", span=Measure("span", solution.span)),
        x=axis("x", ends, within=(left, right)),
        y=axis("z", (foot - 12.0 * unit, top + 44.0 * unit), within=(low, top)),
        areas=water(depth, _BED * unit),
        points=_along(profile, profile.x, profile.z) if readout else (),
        dimensions=dimensions,
        to_scale=1.0,
    )


def on_sinker(chart: Chart, solution: Solution) -> Chart:
    """Put a block in the place of the triangle where a sinker holds the line that is drawn."""
    angle = Measure("angle", solution.anchor.angle)
    said = Message("figures.sinker_at", angle=angle)
    marks = (
        mark._replace(role="sinker", label=said) if mark.role == "anchor" else mark
        for mark in chart.marks
    )
    return replace(chart, marks=tuple(marks))


def _ends(solution: Solution, profile: Profile) -> Place:
    return min(*profile.x, 0.0), max(*profile.x, solution.span)


def room_around(wide: float, tall: float) -> float:
    """Return how many metres a unit of a drawing to scale is; 536 units are its width."""
    return max(wide / (_WIDE - 120.0), tall / (_TALL - 130.0))


def magnified(solution: Solution, depth: float) -> Chart | None:
    """Draw a flat line with its heights magnified; None for one that is steep enough."""
    profile = solution.profile(_POINTS)
    left, right = _ends(solution, profile)
    top = max(depth, *profile.z)
    if top > _FLAT * (right - left):
        return None
    factor = float(f"{0.5 * (right - left) / top:.1g}")
    at_joints = (_at(profile, s) for s in joints(solution))
    return _drawn(
        solution,
        profile,
        depth,
        (Mark("joint-spot", x, z, Message("figures.joint")) for x, z in at_joints),
        name="system_magnified",
        title=Message("figures.magnified", factor=factor),
        x=axis("x", span_of((left, right), 0.02, 0.02)),
        y=axis("z", (-0.06 * top, 1.06 * top)),
        areas=water(depth, math.inf),
        points=_along(profile, profile.x, profile.z),
        to_scale=factor,
    )


def _drawn(
    solution: Solution, profile: Profile, depth: float, marks: Iterable[Mark], **how: Any
) -> Chart:
    """Draw a line in the water with further marks below its own; `how` are fields of the chart."""
    lying = (
        Series("grounded", ends, (0.0, 0.0), Message("figures.lies"))
        for ends in grounded_ends(solution)
    )
    return Chart(
        series=(*lying, Series("mooring", profile.x, profile.z, Message("figures.mooring_line"))),
        marks=(*marks, *_marks(solution)),
        levels=surface_and_bed(depth),
        **how,
    )


def _along(profile: Profile, x: Sequence[float], y: Sequence[float]) -> tuple[Point, ...]:
    """Say at places what is known along the line."""
    along = {"s": ("s", profile.s), "x": ("x", profile.x), "z": ("z", profile.z)}
    return pointed("figures.along_line", x, y, **along, T=("tension", profile.tension))


def water(depth: float, thickness: float) -> tuple[Area, ...]:
    """Fill the water and the bed below it; nothing of a line in air, whose depth is infinite."""
    if depth == math.inf:
        return ()
    return Area("water", (0.0,), (depth,)), Area("bed", (-thickness,), (0.0,))


def surface_and_bed(depth: float) -> tuple[Level, ...]:
    """Draw the water level and the bed as lines; none of a line in air."""
    if depth == math.inf:
        return ()
    bed = Level("bed-edge", "y", 0.0, Message("figures.bed"))
    return Level("surface", "y", depth, Message("figures.water_level")), bed


def _at(profile: Profile, s: float) -> Place:
    """Find the point of a profile at an arc length that is among its own."""
    index = min(range(len(profile.s)), key=lambda k: abs(profile.s[k] - s))
    return profile.x[index], profile.z[index]


def _dimensions(solution: Solution, depth: float, unit: float, low: float) -> Iterator[Dimension]:
    row = low - (_BED + _ROW - 8.0) * unit
    grounded = [each for each in grounded_ends(solution) if each[1] - each[0] > _SHORTEST * unit]
    for start, end in grounded:
        yield _across(start, end, row, Measure("span", end - start))
    if grounded:
        row -= _ROW * unit
    span = Message("figures.span", span=Measure("span", solution.span))
    yield _across(0.0, solution.span, row, span)
    fairlead, right = solution.fairlead_height, max(solution.span, 0.0)
    yield _upright(fairlead, right + 34.0 * unit, right)
    if depth < math.inf and not math.isclose(depth, fairlead, rel_tol=1e-9):
        yield _upright(depth, min(0.0, solution.span) - 44.0 * unit)
    if solution.anchor_height > 0.0:
        yield _upright(solution.anchor_height, -24.0 * unit, 0.0)


def _across(left: float, right: float, z: float, words: object) -> Dimension:
    return Dimension((left, z), (right, z), f"{words}", ((left, 0.0), (right, 0.0)))


def _upright(top: float, x: float, measured: float | None = None) -> Dimension:
    """Draw a height, with a line from where it is measured."""
    led = () if measured is None else ((measured, top),)
    return Dimension((x, 0.0), (x, top), f"{Measure('height', top)}", led)


def _marks(solution: Solution) -> Iterator[Mark]:
    angle = Measure("angle", solution.anchor.angle)
    yield Mark("anchor", 0.0, solution.anchor_height, Message("figures.anchor_at", angle=angle))
    for x, _ in touchdowns(solution):
        yield Mark("touchdown", x, 0.0, Message("figures.touchdown_at", x=Measure("x", x)))
    for state, load in zip(solution.point_loads, solution.line.point_loads, strict=True):
        place, sinks = (state.x, state.z), load.submerged_weight >= 0.0
        weight = Measure("point_weight", abs(load.submerged_weight))
        key = "figures.clump_at" if sinks else "figures.buoy_at"
        s = Measure("position", load.position)
        said = Message(key, name=_called(load), weight=weight, s=s)
        yield Mark("clump" if sinks else "buoy", *place, said)
    yield Mark("fairlead", solution.span, solution.fairlead_height, Message("figures.fairlead"))


def _fails(solution: Solution, profile: Profile, failing: Sequence[Failing]) -> Iterator[Mark]:
    for each in failing:
        at = _where(solution, profile, each)
        if at is not None:
            yield Mark("failing", *at, Message("figures.fails", check=each.name))


def _where(solution: Solution, profile: Profile, check: Failing) -> Place | None:
    """Find the place on the line that a check is of; None for a line that cannot hang."""
    if check.kind == "tension" and check.segment is not None:
        ends = [0.0, *joints(solution), solution.line.length]
        first, last = ends[check.segment - 1 : check.segment + 1]
        near = 1e-9 * solution.line.length
        own = [k for k, s in enumerate(profile.s) if first - near <= s <= last + near]
        most = max(own, key=lambda k: profile.tension[k])
        return profile.x[most], profile.z[most]
    if check.kind == "grounded_length":
        return next(((x, 0.0) for x, _ in touchdowns(solution)), (0.0, solution.anchor_height))
    if check.kind in ("span", "buoyancy"):
        return solution.span, solution.fairlead_height
    return None if check.kind == "equilibrium" else (0.0, solution.anchor_height)


def _called(load: PointLoad) -> str:
    """Say what a load is, with its own name where that says more: ``clump weight: A``."""
    kind = Message("figures.clump" if load.submerged_weight >= 0.0 else "figures.buoy")
    is_named = load.name and load.name.casefold() != kind
    return Message("figures.named", what=kind, name=load.name) if is_named else kind


def tension_along(
    solution: Solution,
    allowed: Sequence[float | None],
    basis: str = "",
    *,
    readout: bool = True,
) -> Chart:
    """Draw the tension over the arc length beside what each segment may carry.

    `allowed` is of each segment, N; `basis` is what these are called; `readout` as above.
    """
    profile = solution.profile(_POINTS)
    largest = max(profile.tension)
    levels, notes = capacities(solution, allowed, largest, basis)
    top = 1.08 * max([largest, *(each.at for each in levels)])
    at_joints, at_bed = joints(solution), [s for _, s in touchdowns(solution)]
    at_loads = [each.position for each in solution.point_loads]
    levels += [Level("joint", "x", s, Message("figures.joint")) for s in at_joints]
    levels += [Level("touchdown-at", "x", s, Message("figures.touchdown")) for s in at_bed]
    levels += [Level("load-at", "x", s, Message("figures.point_load")) for s in at_loads]
    return Chart(
        "tension",
        Message("figures.tension_along", tension=Measure("tension", largest)),
        axis("s", (0.0, solution.line.length)),
        axis("tension", (0.0, top or 1.0), second=IN_TONNES),
        series=(Series("first", profile.s, profile.tension, Message("figures.tension")),),
        levels=tuple(levels),
        points=_along(profile, profile.s, profile.tension) if readout else (),
        notes=tuple(notes),
    )


def capacities(
    solution: Solution, allowed: Sequence[float | None], largest: float, basis: str = ""
) -> tuple[list[Level], list[str]]:
    """Draw what each segment may carry; say where it is not known or far above the largest."""
    levels: list[Level] = []
    notes: list[str] = []
    end, name = 0.0, basis or Message("figures.allowed")
    for number, (segment, capacity) in enumerate(zip(solution.segments, allowed, strict=True), 1):
        start, end = end, end + segment.length
        shown = Measure("tension", capacity or 0.0)
        if capacity is None:
            notes.append(Message("figures.no_capacity", number=number))
        elif capacity > FAR * largest:
            notes.append(Message("figures.off_scale", number=number, what=name, capacity=shown))
        else:
            said = Message("sizing.measure", value=shown)
            levels.append(Level("capacity", "y", capacity, name, start, end, said))
    return levels, notes


_STEEP = 0.35
"""Part of the largest tension above which the curves are in the way of what stands at the top."""


def load_curve(curve: CaseCurve) -> Chart:
    """Draw the curve, what happens along it, and the case itself."""
    spans, forces, tensions = curve.outline()
    case, most = curve.reference, max(tensions)
    zero, offset = case.span, Message("figures.offset")
    marks: tuple[Mark, ...] = ()
    if curve.curve.span[0] <= case.span <= curve.curve.span[-1]:
        said = Message("figures.case_at", H=_force(case))
        forces_there = (case.horizontal_force, case.fairlead.tension)
        marks = tuple(Mark("reference", case.span, each, said) for each in forces_there)
    return Chart(
        "curve",
        Message("figures.curve"),
        axis("span", span_of(spans, 0.03, 0.03), second=Scale(offset, QUANTITIES["offset"], zero)),
        axis("tension", (0.0, 1.06 * most or 1.0), Message("figures.force"), second=IN_TONNES),
        series=(
            Series("first", spans, forces, Message("figures.horizontal")),
            Series("second", spans, tensions, Message("figures.fairlead_tension")),
        ),
        marks=marks,
        levels=tuple(_events(curve.curve.marks, most)),
        points=pointed(
            "figures.on_curve",
            spans,
            forces,
            S=("span", spans),
            offset=("offset", [span - zero for span in spans]),
            H=("horizontal_force", forces),
            T=("tension", tensions),
        ),
        notes=tuple(
            Message("figures.event", number=number, event=mark.event, H=_force(mark))
            for number, mark in enumerate(curve.curve.marks, start=1)
        ),
    )


def _force(of: Event | Solution) -> Measure:
    return Measure("horizontal_force", of.horizontal_force)


def _events(marks: Sequence[Event], most: float) -> Iterator[Level]:
    """Yield the events by their numbers, staggered and clear of the curves."""
    above = below = 0
    for number, mark in enumerate(marks, start=1):
        if mark.fairlead_tension > _STEEP * most:
            share, below = 0.06 + 0.08 * (below % 6), below + 1
        else:
            share, above = 0.94 - 0.08 * (above % 6), above + 1
        yield Level("joint", "x", mark.span, words=str(number), share=share)
