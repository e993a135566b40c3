"""Designs drawn: a front, the lines on it, and a sizing with its swing circle."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from catopt.figures.chart import Area, Chart, Mark, Point, Series, axis, pointed, span_of
from catopt.figures.line import Failing, line_in_water, on_sinker
from catopt.figures.studies import lines_to_scale
from catopt.largest import largest
from catopt.quantities import QUANTITIES, Quantity
from catopt.words import Measure, Message, Several, term

if TYPE_CHECKING:
    from catopt.design.result import DesignResult
    from catopt.loads.buoy_shape import BuoyShape
    from catopt.sizing import Sizing
    from catopt.sizing.in_motion import InMotion

Document = Mapping[str, Any]

OBJECTIVES: Mapping[str, Quantity] = MappingProxyType(
    {
        "mass_kg": replace(QUANTITIES["mass"], name="Mass in air", symbol=""),
        "offset_m": replace(QUANTITIES["offset"], name="Largest span", symbol="S"),
        "excursion_m": QUANTITIES["excursion"],
        "cost_USD": QUANTITIES["cost"],
        "length_m": QUANTITIES["length"],
        "anchor_load_N": replace(QUANTITIES["tension"], name="Anchor load", symbol=""),
    }
)
"""What each objective is called and measured in, by its key in the document of a search."""
_OF_A_BODY = replace(QUANTITIES["offset"], name="Largest offset")
_PARTS = ("lowest", "middle", "highest")
"""Roles of designs by a third objective."""


def objective(key: str, *, of_body: bool) -> Quantity:
    """Return what an objective is called and measured in, of a line or of a body with several."""
    return _OF_A_BODY if of_body and key == "offset_m" else OBJECTIVES[key]


def objective_name(key: str, document: Document) -> str:
    """Name an objective by its key in the document of a search."""
    of_body = document["front"][0].get("system") is not None
    return term(objective(key, of_body=of_body).name)


def front(document: Document, chosen: int | None = None) -> Chart:
    """Draw the designs of a front.

    `document` is what ``catopt design --json`` prints; `chosen` is the number of a design that is
    pointed out beside the one that is recommended.
    """
    keys: list[str] = document["objectives"]
    points: list[Document] = document["front"]
    first, second = keys[:2]
    best = document["recommended"]
    across, up = [p[first] for p in points], [p[second] for p in points]
    marks = [
        Mark(role, across[k], up[k], label) for k, (role, label) in enumerate(_parts(document))
    ]
    for end in ends(document):
        label = Message("figures.end_of_front", number=end + 1)
        marks.append(Mark("end", across[end], up[end], label))
    recommended = Message("figures.recommended", number=best + 1)
    marks.append(Mark("recommended", across[best], up[best], recommended))
    failing = document.get("in_motion", {}).get("failing", ())
    if failing:
        said = Message("figures.fails_in_motion", count=len(failing))
        marks += [Mark("fails-in-motion", each[first], each[second], said) for each in failing]
    present = document.get("present")
    if present and None not in (present[first], present[second]):
        label = present["change"]
        if not present["feasible"]:
            label = Message("figures.present_fails", what=label)
        marks.append(Mark("present", present[first], present[second], label))
    if chosen is not None:
        label = Message("figures.chosen", number=chosen)
        marks.append(Mark("chosen", across[chosen - 1], up[chosen - 1], label))
    x, y = [mark.x for mark in marks] + across, [mark.y for mark in marks] + up
    if document.get("is_exact", False):
        title = Message("figures.exact_front", count=len(points))
    else:
        title = Message("figures.found_front", count=len(points), method=document["method"])
    return Chart(
        "front",
        title,
        axis(OBJECTIVES[first].key, span_of(x), objective_name(first, document)),
        axis(OBJECTIVES[second].key, span_of(y), objective_name(second, document)),
        marks=tuple(marks),
        points=tuple(
            Point(across[k], up[k], _said(k + 1, point, document)) for k, point in enumerate(points)
        ),
    )


def ends(document: Document) -> list[int]:
    """List the ends of a front that are not the recommended design, by index."""
    return sorted({0, len(document["front"]) - 1} - {document["recommended"]})


def front_lines(result: DesignResult, document: Document) -> Chart:
    """Draw the recommended line and those of the ends of the front, to scale.

    In the load case that takes the recommended design farthest from its anchor.
    """
    best = result.best
    name, _ = largest(best.checks.solutions, lambda state: state[1].span)
    levels = {state.name: state.water_level for state in result.case.load_cases}
    lines = [
        (
            Message("figures.design_number", number=k + 1, made=composition(document["front"][k])),
            dict(result.front[k].checks.solutions)[name],
        )
        for k in (result.recommended - 1, *ends(document))
    ]
    depth = result.case.site.water_depth + levels.get(name, 0.0)
    return lines_to_scale(lines, depth, Message("figures.under_load_case", name=name))


def _parts(document: Document) -> Iterator[tuple[str, str]]:
    """Say of each design in which third of the range of a third objective it is."""
    points: Sequence[Document] = document["front"]
    if len(document["objectives"]) < 3:
        yield from [("design", Message("figures.design"))] * len(points)
        return
    key = document["objectives"][2]
    values = [point[key] for point in points]
    least, size = min(values), (max(values) - min(values)) / 3.0
    name, quantity = objective_name(key, document), OBJECTIVES[key].key
    for value in values:
        part = min(int((value - least) / size), 2) if size > 0.0 else 0
        low, high = (Measure(quantity, least + k * size) for k in (part, part + 1))
        said = Message("figures.from_to_objective", objective=name, low=low, high=high)
        yield _PARTS[part], said


def _said(number: int, point: Document, document: Document) -> str:
    measures = {key: Measure(OBJECTIVES[key].key, point[key]) for key in document["objectives"]}
    said = [
        Message("figures.value", what=objective_name(key, document), value=value)
        for key, value in measures.items()
    ]
    values, made = Several(said, ", "), composition(point)
    return Message("figures.design_at", number=number, values=values, made=made)


def composition(point: Document) -> str:
    """Say what a design is made of: ``"chain studless R3 76 mm, 45 m; 2 t, s = 7 m"``."""
    layout = point.get("system")
    parts: list[str] = []
    if layout is not None:
        count, radius = len(layout["azimuths_rad"]), layout["anchor_radius_m"]
        parts.append(Message("design.around", count=count, radius=radius))
    parts += [
        f"{segment.get('name') or segment['component'] or '?'}, {segment['length_m']:g} m"
        for segment in point["segments"]
    ]
    parts += [
        Several((_load(load), f"s = {load['position_m']:g} m"), ", ")
        for load in point["point_loads"]
    ]
    return Several(parts)


def _load(load: Document) -> str:
    if load["mass_kg"] is not None:
        return f"{load['mass_kg'] / 1e3:g} t"
    return Message("figures.weight", weight=Measure("point_weight", load["submerged_weight_N"]))


_ROUND = 72
"""Places of a circle."""
_OF_SHIP = (-0.5, -0.5, 0.3, 0.42, 0.5), (0.42, 0.5, 0.5, 0.3, 0.0)
"""Half of a hull from above: along it over its length, and beside it over its breadth."""


def elevation(of: Sizing, failing: Sequence[Failing] = ()) -> Chart:
    """Draw the line of the largest tension, with the buoy or the bow of the ship that it holds."""
    name, solution = of.hardest
    state = next(each for each in of.case.load_cases if each.name == name)
    depth = of.case.site.water_depth + state.water_level
    drawn = line_in_water(solution, depth, failing)
    if of.sinker is not None:
        drawn = on_sinker(drawn, solution)
    x, z = solution.span, solution.fairlead_height
    shape = of.shape
    body = tuple(_bow(of, x, z, drawn.x.high)) if shape is None else tuple(_hull(shape, x, z))
    top = max((*(each for area in body for each in area.high), drawn.y.high))
    return replace(drawn, areas=(*drawn.areas, *body), y=replace(drawn.y, high=top))


def swing_circle(of: Sizing) -> Chart:
    """Draw from above how far what is moored swings round its anchor, to scale."""
    total, (_, line) = of.swing.total, of.swing.parts[0]
    around = [2.0 * math.pi * each / _ROUND for each in range(_ROUND + 1)]
    edge = [(total * math.cos(each), total * math.sin(each)) for each in around]
    x, y = zip(*edge, strict=True)
    ends = (-1.12 * total, 1.12 * total)
    length, breadth = _size(of)
    middle = total - length / 2.0 if of.kind == "tanker" else total
    said = Message("figures.swing_at", radius=Measure("length", total))
    series = [
        Series("swing", x, y, Message("figures.swing_of", radius=Measure("length", total))),
        Series("leg", (0.0, min(line, total)), (0.0, 0.0), Message("figures.mooring_line")),
    ]
    if of.kind == "tanker" and len(of.swing.parts) > 2:
        series.append(Series("arm", (line, total - length), (0.0, 0.0), Message("sizing.hawser")))
    return Chart(
        "swing",
        Message("figures.swing", radius=Measure("length", total)),
        axis("x", ends, Message("figures.from_anchor_east")),
        axis("x", ends, Message("figures.from_anchor_north")),
        tuple(series),
        (_spot(of),),
        areas=(_from_above(of, middle, length, breadth),),
        points=tuple(Point(*place, said) for place in edge),
        to_scale=1.0,
    )


def _spot(of: Sizing) -> Mark:
    """Mark what holds one line, or the middle of several, from above."""
    if of.sinker is not None and of.pattern is None:
        return Mark("sinker", 0.0, 0.0, Message("figures.sinker"))
    return Mark("anchor-spot", 0.0, 0.0, Message("figures.anchor_spot"))


def choices(of: Sizing) -> tuple[Chart, tuple[dict[str, str], ...]]:
    """Draw the lines between which one chooses, by swing radius and mass.

    Also what an input has to be for each of them, in the order of the points.
    """
    own = of.point
    said: list[Point] = []
    sets: list[dict[str, str]] = []
    marks: list[Mark] = []
    for prefer, settled, swing in (
        *((each.prefer, each.settled, each.swing) for each in of.alternatives),
        (of.settled.choice.looks_for, of.settled, of.swing.total),
    ):
        if settled is None or swing is None:
            continue
        is_own = settled.point is own
        mass = settled.point.line.mass or 0.0
        role = "recommended" if is_own else "design"
        marks.append(Mark(role, swing, mass, Message(f"figures.choice_{role}")))
        words = Message(
            "figures.choice",
            prefer=term(prefer),
            chain=settled.point.line.segments[0].name,
            length=Measure("length", settled.point.line.length),
            swing=Measure("length", swing),
            mass=Measure("mass", mass),
        )
        said.append(Point(swing, mass, words))
        sets.append({"line.prefer": prefer})
    radii = span_of([each.x for each in marks], 0.2, 0.2)
    masses = span_of([each.y for each in marks], 0.2, 0.2)
    drawn = Chart(
        "choices",
        Message("figures.choices"),
        axis("length", radii, term("Swing radius at low water")),
        axis("mass", masses, term("Mass in air")),
        marks=tuple(marks),
        points=tuple(said),
    )
    return drawn, tuple(sets)


def tension_by_length(of: InMotion) -> Chart:
    """Draw the tension in the storm, with its interval, and that at rest, by the line's length."""
    runs = [(each.tried.length, each.storm) for each in of.by_length if each.storm is not None]
    lengths = [length for length, _ in runs]
    storms = [storm for _, storm in runs]
    probable = [storm.tension for storm in storms]
    low = [storm.tension if storm.low is None else storm.low for storm in storms]
    high = [storm.tension if storm.high is None else storm.high for storm in storms]
    own = of.case.line.length
    return Chart(
        "by_length",
        Message("figures.by_length"),
        axis("length", span_of(lengths, 0.05, 0.05)),
        axis("tension", (0.0, 1.06 * max(high, default=1.0)), Message("figures.fairlead_tension")),
        series=(
            Series("first", lengths, probable, Message("figures.in_storm")),
            Series("peak", lengths, probable),
            Series("second", lengths, [each.at_rest for each in storms], Message("figures.steady")),
        ),
        marks=tuple(
            Mark("recommended", own, tension, Message("figures.choice_recommended"))
            for length, tension in zip(lengths, probable, strict=True)
            if length == own
        ),
        areas=(Area("between", low, high, lengths, Message("figures.storm_interval")),),
        points=pointed(
            "figures.at_length",
            lengths,
            probable,
            length=("length", lengths),
            tension=("tension", probable),
        ),
    )


def _read(of: Sizing) -> dict[str, object]:
    return {each.of.name: each.value for each in of.inputs}


def _size(of: Sizing) -> tuple[float, float]:
    """Length and breadth from above, m; a buoy of no shape is drawn as a tenth of its line."""
    read = _read(of)
    if of.kind == "tanker":
        length = of.swing.parts[-1][1]
        return length, float(str(read.get("breadth", 0.15 * length)))
    shape = of.shape
    width = 0.06 * of.swing.total if shape is None else shape.widest
    return width, width


def _hull(shape: BuoyShape, x: float, eye: float) -> Iterator[Area]:
    """Stand a buoy on the end of its line: truncated cones of the hull, then the tower."""
    label: str = Message("figures.moored_buoy")
    for foot, each in shape.parts:
        low, high = eye - shape.eye + foot, eye - shape.eye + foot + each.height
        narrow, wide = sorted((each.lower / 2.0, each.upper / 2.0))
        corners = (x - wide, x - narrow, x + narrow, x + wide)
        slope, flat = (high, low, low, high), (low, high, high, low)
        lows, highs = (slope, (high,) * 4) if each.upper > each.lower else ((low,) * 4, flat)
        yield Area("moored", lows, highs, corners, label)


def _bow(of: Sizing, x: float, deck: float, edge: float) -> Iterator[Area]:
    """Draw as much of a ship, or of the buoy that she lies to, as the drawing has room for."""
    read = _read(of)
    if of.kind != "tanker" or read.get("buoy") is not None:
        return
    moulded = float(str(read.get("moulded_depth") or 0.0))
    if not moulded:
        return
    end, low, high = min(edge, x + of.swing.parts[-1][1]), max(deck - moulded, 0.0), deck
    yield Area(
        "moored", (high, low, low), (high,) * 3, (x, x + min(0.4 * moulded, end - x), end),
        Message("figures.moored_ship"),
    )  # fmt: skip


def _from_above(of: Sizing, middle: float, length: float, breadth: float) -> Area:
    label = Message("figures.moored_ship" if of.kind == "tanker" else "figures.moored_buoy")
    if of.kind == "tanker":
        along, beside = _OF_SHIP
        # The bow points to the anchor.
        x = [middle - length * each for each in reversed(along)]
        half = [breadth * each for each in reversed(beside)]
    else:
        angles = [math.pi * each / 12 for each in range(13)]
        x = [middle - 0.5 * length * math.cos(each) for each in angles]
        half = [0.5 * breadth * math.sin(each) for each in angles]
    return Area("moored", [-each for each in half], half, x, label)
