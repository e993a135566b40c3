"""What the front of a design search consists of."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

from catopt.answers.blocks import (
    Answer,
    Block,
    Column,
    Fact,
    Facts,
    Graph,
    Section,
    Table,
    Text,
    Value,
    Verdict,
    Warnings,
    measured,
    texts,
    yes_or_no,
)
from catopt.answers.check import (
    check_columns,
    governing_sentence,
    tightest_checks,
    tightest_table,
)
from catopt.checks.kinds import QUANTITY_OF
from catopt.figures.front import objective
from catopt.quantities import Quantity
from catopt.words import Measure, Message, Several, term

if TYPE_CHECKING:
    from catopt.design.result import DesignPoint, DesignResult, Neighbour
    from catopt.model import Line

_MOST = 25
"""Designs of a front that people see all of; of a longer one they see some."""


def design_answer(result: DesignResult) -> Answer:
    """Lay out a front, its recommended design and how it was found."""
    return Answer(
        "design",
        result.case.title or Message("captions.mooring_line"),
        (
            Section(Message("captions.front"), tuple(_front(result))),
            Section(Message("captions.recommended"), tuple(_recommended(result))),
            Section(Message("captions.components"), (_components(result),)),
            Section(Message("captions.checks"), (_checks(result),)),
            *_loads(result),
            Section(Message("captions.search"), (_search(result),)),
        ),
    )


def shown_designs(count: int, *named: int) -> tuple[int, ...]:
    """Choose the designs of a front that people see: all of few; of many some, evenly.

    Those that are named by their indices are among them in any case, as the two ends are.

    Examples
    --------
    >>> shown_designs(3, 1)
    (0, 1, 2)
    >>> shown_designs(100, 42)[:4], len(shown_designs(100, 42))
    ((0, 4, 8, 12), 27)
    """
    if count <= _MOST:
        return tuple(range(count))
    return tuple(sorted({*range(0, count, -(-count // _MOST)), count - 1, *named}))


# ------------------------------------------------------------------ the front


def _front(result: DesignResult) -> Iterator[Block]:
    """Tabulate the front, a row each design, with the tightest check of each kind in files."""
    points = result.front
    shown = shown_designs(len(points), result.recommended)
    yield Text(_how(result))
    yield Table(
        "front",
        (
            _numbers(range(1, len(points) + 1)),
            texts("recommended", _is_recommended(result), only="files"),
            *_objectives(result, points),
            texts("line_from_the_anchor", map(_composition, points), only="people"),
            *_in_words(points),
            *_utilisations(points),
            texts("governing_check", map(_governing, points), only="files"),
        ),
        Message("captions.front_of", shown=len(shown), count=len(points))
        if len(shown) < len(points)
        else Message("captions.front_recommended"),
        shown,
        result.recommended,
    )
    yield Graph(Message("captions.front"), "front", x=2, y=(3,), points=True)


def _how(result: DesignResult) -> Message:
    if result.excluded and result.is_exact:
        return Message(
            "design.exact_by_bounds",
            designs=result.designs,
            evaluations=result.evaluations,
            method=term(result.method),
            excluded=sum(result.excluded.values()),
            bounds=_bounds(result),
            feasible=result.feasible,
            front=len(result.front),
        )
    return Message(
        "design.exact" if result.is_exact else "design.found",
        designs=result.designs,
        evaluations=result.evaluations,
        method=term(result.method),
        feasible=result.feasible,
        front=len(result.front),
    )


def _bounds(result: DesignResult) -> Several:
    """Say how many designs each bound has excluded."""
    said = (Message(f"design.bound_{name}", count=count) for name, count in result.excluded.items())
    return Several(said)


def _numbers(numbers: Iterable[int]) -> Column:
    return texts("design", numbers)


def _is_recommended(result: DesignResult) -> Iterator[str]:
    for index in range(len(result.front)):
        yield Message("answers.yes") if index == result.recommended else ""


def _objectives(result: DesignResult, points: Sequence[DesignPoint | None]) -> Iterator[Column]:
    """Yield a column for each objective: those wanted first, then what else is known."""
    for key, quantity in _known_objectives(result):
        values = tuple(None if each is None else each.objectives.get(key) for each in points)
        yield Column(term(quantity.name), values, quantity)


def _known_objectives(result: DesignResult) -> list[tuple[str, Quantity]]:
    known = result.front[0].objectives
    keys = [*result.objectives, *(key for key in known if key not in result.objectives)]
    of_body = result.case.system is not None
    return [(key, objective(key, of_body=of_body)) for key in keys]


def _in_words(points: Sequence[DesignPoint]) -> tuple[Column, ...]:
    """Say of what each design is made, in files."""
    segments = [Several(segment_words(each.line)) for each in points]
    weights = [Several(clump_weight_words(each.line)) for each in points]
    return (
        texts("segments_from_the_anchor", segments, only="files"),
        texts("clump_weights", weights, only="files"),
        texts("anchor", map(_anchor_words, points), only="files"),
        *_layouts(points),
    )


def _layouts(points: Sequence[DesignPoint]) -> Iterator[Column]:
    """Yield the layout of whole moorings and what takes them farthest, in files."""
    far = [each.mooring for each in points]
    if all(far):
        layouts = (Several(_layout_words(each)) for each in points)
        yield texts("layout", layouts, only="files")
        yield texts("farthest_in", (each.state for each in far if each), only="files")


def _utilisations(points: Sequence[DesignPoint]) -> Iterator[Column]:
    """Yield a column for each kind of check that was made: the tightest of each design."""
    found = [tightest_checks(each.checks) for each in points]
    for kind in (kind for kind in QUANTITY_OF if any(kind in each for each in found)):
        used = (each[kind].utilisation if kind in each else None for each in found)
        yield measured("utilisation", used, f"{kind}_utilisation", only="files")


def _governing(point: DesignPoint) -> str:
    return "" if point.governing is None else point.governing.in_case


def segment_words(line: Line) -> list[str]:
    """Say what each segment is: ``"chain studless R3 76 mm, 45 m"``."""
    return [
        Message(
            "design.segment_words",
            segment=segment.name or Message("checks.segment", number=number),
            length=segment.length,
        )
        for number, segment in enumerate(line.segments, start=1)
    ]


def clump_weight_words(line: Line) -> list[str]:
    """Say what hangs on the line: ``"2 t at 7 m"``, with the mass in air."""
    return [
        Message(
            "design.force_at",
            force=Measure("point_weight", load.submerged_weight),
            position=load.position,
        )
        if load.mass is None
        else Message("design.weight_at", mass=load.mass / 1e3, position=load.position)
        for load in line.point_loads
    ]


def _anchor_words(point: DesignPoint) -> str:
    """Say what holds the line; empty when the case has no anchor."""
    anchor = point.anchor
    if anchor is None:
        return ""
    if anchor.kind != "sinker":
        return Message("design.drag_anchor")
    if anchor.mass is not None:
        return Message("design.sinker", mass=anchor.mass / 1e3)
    return Message(
        "design.sinker_force", force=Measure("point_weight", anchor.submerged_weight or 0.0)
    )


def _layout_words(point: DesignPoint) -> Iterator[Message]:
    """Say how many lines there are and how far away their anchors; nothing of a single line."""
    if point.mooring is not None:
        legs = point.mooring.system.legs
        yield Message("design.around", count=len(legs), radius=legs[0].anchor_radius)
        if point.mooring.pretension is not None:
            force = Measure("horizontal_force", point.mooring.pretension)
            yield Message("design.at_pretension", force=force)


def _composition(point: DesignPoint) -> Several:
    parts = (
        *_layout_words(point),
        *segment_words(point.line),
        *clump_weight_words(point.line),
        _anchor_words(point),
    )
    return Several(part for part in parts if part)


# ------------------------------------------------------------------ the recommended design


def _recommended(result: DesignResult) -> Iterator[Block]:
    point = result.front[result.recommended]
    yield Verdict(Message("design.recommended", number=result.recommended + 1), point.checks.passes)
    yield Text(result.recommendation)
    yield Facts("recommended", tuple(_made_of(result, point)), only="not csv")
    yield tightest_table(point.checks)
    yield Text(governing_sentence(point.checks))
    if point.mooring is not None:
        far = point.mooring
        yield Text(Message("design.farthest", offset=far.offset, state=far.state))
    yield from map(Text, result.ends)
    yield _neighbours(result)
    yield Warnings(result.warnings)


def _made_of(result: DesignResult, point: DesignPoint) -> Iterator[Fact]:
    """List the parts of a design and what its objectives come to."""
    for layout in _layout_words(point):
        yield Fact(Message("columns.layout"), layout)
    for number, said in enumerate(segment_words(point.line), start=1):
        yield Fact(Message("columns.segment_number", number=number), said)
    for said in clump_weight_words(point.line):
        yield Fact(Message("columns.clump_weight"), said)
    if point.anchor is not None:
        yield Fact(Message("columns.anchor"), _anchor_words(point))
    for key, quantity in _known_objectives(result):
        yield Fact(term(quantity.name), point.objectives[key], quantity)


def _neighbours(result: DesignResult) -> Table:
    """Tabulate what one step of each variable would do to the recommended design.

    The last row is the line in the case file.
    """
    steps = (*result.neighbours, result.present)
    return Table(
        "neighbours",
        (
            texts("change_to_the_recommended_design", (step.change for step in steps)),
            *_objectives(result, [step.point for step in steps]),
            texts("verdict", map(_verdict, steps)),
        ),
        Message("captions.neighbours"),
    )


def _verdict(step: Neighbour) -> str:
    """Say whether a changed design is feasible, and by what it fails when it is not."""
    if step.point is None:
        return step.reason
    report = step.point.checks
    worst = report.governing
    if report.passes or worst is None:
        return Message("answers.passes")
    if worst.utilisation is None:
        return Message("checks.fails", check=worst.in_case)
    return Message("checks.fails_used", check=worst.in_case, used=worst.utilisation)


# ------------------------------------------------------------------ in files alone


def _components(result: DesignResult) -> Table:
    """Tabulate the segments of every design, a row each from the anchor to the fairlead."""
    rows = [
        (number, place, segment)
        for number, point in enumerate(result.front, start=1)
        for place, segment in enumerate(point.line.segments, start=1)
    ]
    segments = [segment for _, _, segment in rows]
    return Table(
        "components",
        (
            _numbers(number for number, _, _ in rows),
            texts("segment", (place for _, place, _ in rows)),
            texts("component", (each.component or each.name for each in segments)),
            measured("nominal_diameter", (each.nominal_diameter for each in segments)),
            measured("length", (each.length for each in segments)),
            measured("submerged_weight", (each.submerged_weight for each in segments)),
            measured("mass_per_length", (each.mass for each in segments)),
            measured("EA", (each.EA for each in segments)),
            measured("MBL", (each.MBL for each in segments)),
            measured("proof_load", (each.proof_load for each in segments)),
            measured("price", (each.price for each in segments)),
        ),
        only="files",
    )


def _checks(result: DesignResult) -> Table:
    """Tabulate every check of every design, a row each."""
    rows = [
        (number, check)
        for number, point in enumerate(result.front, start=1)
        for check in point.checks.results
    ]
    numbers = _numbers(number for number, _ in rows)
    columns = (numbers, *check_columns([check for _, check in rows]))
    return Table("checks", columns, only="files")


def _loads(result: DesignResult) -> Iterator[Section]:
    """Tabulate what a body had to meet, where it is more than one force."""
    loads = () if result.case.design is None else result.case.design.loads
    if loads:
        columns = (
            texts("load_case", (load.name for load in loads)),
            measured("horizontal_force", (load.force for load in loads), "force", symbol="F"),
            measured("angle", (load.direction for load in loads), "direction", symbol=""),
            texts("from_so_many_sides", (load.headings for load in loads)),
            measured("height", (load.water_level for load in loads), "water_level", symbol=""),
            measured("height", (load.fairlead_rise for load in loads), "fairlead_rise", symbol=""),
            texts("each_line_out", (yes_or_no(load.line_out) for load in loads)),
        )
        yield Section(
            Message("captions.load_cases"),
            (Table("loads", columns, Message("captions.load_cases")),),
        )


def _search(result: DesignResult) -> Facts:
    """List how the front was found."""
    reference = ", ".join(f"{value:.6g}" for value in result.reference_point)
    listed: dict[str, Value] = {
        "title": result.case.title,
        "method": result.method,
        "exact_front": yes_or_no(result.is_exact),
        "designs_in_the_space": result.designs,
        "designs_evaluated": result.evaluations,
        "of_these_feasible": result.feasible,
        **({"designs_proved_needless": _bounds(result)} if result.excluded else {}),
        "designs_on_the_front": len(result.front),
        "recommended_design": result.recommended + 1,
        "why": result.recommendation,
        "ends_of_the_front": Several(result.ends),
        "hypervolume": result.hypervolume,
        "reference_point": reference,
        "seed": result.seed,
        "interrupted": yes_or_no(result.interrupted),
        "warnings": Several(result.warnings),
    }
    facts = (Fact(Message(f"columns.{name}"), value) for name, value in listed.items())
    return Facts("search", tuple(facts), only="files")
