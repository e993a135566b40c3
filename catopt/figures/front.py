"""The front of a design search over its first two objectives."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from catopt.figures.chart import Chart, Mark, Point, axis, span_of
from catopt.figures.studies import lines_to_scale
from catopt.quantities import QUANTITIES, Quantity
from catopt.ties import largest
from catopt.words import Measure, Message, Several, term

if TYPE_CHECKING:
    from catopt.design.result import DesignResult

Document = Mapping[str, Any]

OBJECTIVES: Mapping[str, Quantity] = MappingProxyType(
    {
        "mass_kg": replace(QUANTITIES["mass"], name="Mass in air", symbol=""),
        "offset_m": replace(QUANTITIES["offset"], name="Largest span", symbol="S"),
        "excursion_m": QUANTITIES["excursion"],
        "cost_USD": QUANTITIES["cost"],
        "length_m": QUANTITIES["length"],
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
