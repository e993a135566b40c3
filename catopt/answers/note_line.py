"""What the note of one line consists of."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from catopt.answers.blocks import (
    Answer,
    Block,
    Column,
    Facts,
    Figure,
    Points,
    Section,
    Table,
    Text,
    Verdict,
)
from catopt.answers.check import (
    checked,
    failing_checks,
    load_case_table,
)
from catopt.answers.curve import marks_table, points_table
from catopt.answers.design import shown_designs
from catopt.answers.note import (
    column,
    components_section,
    file_section,
    inputs_section,
    note_section,
)
from catopt.answers.note_first import FirstPage, Number, about, opening
from catopt.answers.note_motion import motion_section
from catopt.answers.note_sheet import basis_section, sheet_sections
from catopt.answers.note_swarm import swarm_section
from catopt.answers.solution import (
    found_facts,
    how_it_hangs,
    method_name,
    point_loads_table,
    profile_table,
    residual_facts,
    result_facts,
    segments_table,
)
from catopt.answers.trail import equation_trail
from catopt.answers.verification import closing_in_note, compared_in_note
from catopt.figures.curve import load_curve
from catopt.figures.front import OBJECTIVES, composition, front
from catopt.figures.line import line_in_water, tension_along
from catopt.verify.truss_words import part_sentence
from catopt.words import Measure, Message, Several, term

if TYPE_CHECKING:
    from catopt.catenary.case_curve import CaseCurve
    from catopt.notes.line import Chosen, Note

_ROWS = 15
"""Points of the curve that people see, about."""


def line_note_answer(note: Note) -> Answer:
    """Lay out the note of one line."""
    return Answer(
        "note",
        note.title or Message("note.untitled"),
        (
            *opening(_first(note), note.sheet, _facts(note), note.origin, note.warnings),
            basis_section(note.sheet),
            *of_the_line(note, "results", "checks", "load_cases"),
            *sheet_sections(note.sheet),
            *of_the_line(note, "tension", "curve"),
            *_front(note.chosen),
            components_section(note.case, note.solution.line),
            inputs_section(note.origin, None if note.chosen is None else note.chosen.number),
            *of_the_line(note, "equations", "verification", "swarm"),
            *motion_section(note),
            *file_section(note.origin, "case_file", "note.case_file_heading"),
        ),
        Message("note.kind"),
    )


def of_the_line(note: Note, *names: str) -> Iterator[Section]:
    """Lay sections out that the note of a sizing has, too, but those with nothing to show."""
    for name in names:
        if name == "swarm":
            yield from swarm_section(note)
        else:
            blocks = tuple(_BUILD[name](note))
            if blocks:
                yield note_section(name, blocks, f"note.{name}_heading")


def _first(note: Note) -> FirstPage:
    solution = note.solution
    said = Message(
        "note_first.line",
        length=about("length", solution.line.length),
        span=about("span", solution.span),
        tension=about("tension", solution.fairlead.tension),
    )
    return FirstPage(
        said,
        drawn(note),
        Number(
            Message("quantities.horizontal_force"),
            "horizontal_force",
            max(each.horizontal_force for each in note.sheet.intact),
        ),
        Number(Message("quantities.span"), "span", max(each.span for each in note.sheet.intact)),
        max(part.max_tension for each in note.sheet.intact for part in each.segments),
        in_motion=note.motion is not None,
    )


def _facts(note: Note) -> tuple[tuple[str, str], ...]:
    load_case = note.load_case if note.case.load is not None else ""
    return (
        ("note.identity_source", note.case.source),
        ("note.identity_load_case", load_case),
        ("note.identity_design", "" if note.chosen is None else str(note.chosen.number)),
        ("note.identity_regime", how_it_hangs(note.solution)),
        ("note.identity_method", method_name(note.solution.method)),
    )


def drawn(note: Note) -> Iterator[Block]:
    """Draw the line to scale, with its dimensions."""
    yield Text(Message("note.line_scale"))
    depth = note.case.site.water_depth
    yield Figure(line_in_water(note.solution, depth, failing_checks(note.checks)))


def _results(note: Note) -> Iterator[Block]:
    solution = note.solution
    if solution.found is not None:
        said = (Message("note.results_sought"), solution.found.condition)
        yield Text(Several(said, " "))
    every = (*found_facts(solution), *result_facts(solution), *residual_facts(solution))
    yield Facts("results", tuple(each for each in every if each.value is not None))
    yield replace(segments_table(solution), only="workbook")
    if solution.point_loads:
        yield point_loads_table(solution)


def _checks(note: Note) -> Iterator[Block]:
    report = note.checks
    if not report.results:
        return
    governing = report.governing
    marked = next((k for k, each in enumerate(report.results) if each is governing), None)
    checks, criteria = checked(report)
    yield replace(checks, marked=marked)
    yield criteria
    yield Text(Message("note.checks_legend"), is_small=True)


def _load_cases(note: Note) -> Iterator[Block]:
    states = note.checks.solutions
    if len(states) < 2:
        return
    names = [name for name, _ in states]
    marked = names.index(note.load_case) if note.load_case in names else None
    yield replace(load_case_table(note.checks), only="all", marked=marked)
    yield Text(Message("note.load_cases_marked"), is_small=True)


def _tension(note: Note) -> Iterator[Block]:
    yield Figure(tension_along(note.solution, note.allowed))
    yield profile_table(note.solution, only="workbook")


def _curve(note: Note) -> Iterator[Block]:
    curve = note.curve
    if curve is None:
        return
    # The table of marks says what their numbers are.
    yield Figure(replace(load_curve(curve), notes=()))
    marks = _for_all(marks_table(curve))
    numbers = column("columns.no", range(1, marks.length + 1))
    yield replace(marks, columns=(numbers, *marks.columns[1:]))
    yield _points(curve)


def _points(curve: CaseCurve) -> Table:
    """Tabulate some points of the curve, both ends among them."""
    table = _for_all(points_table(curve))
    count = table.length
    shown = sorted({*range(0, count, max(1, round(count / _ROWS))), count - 1})
    return replace(table, shown=tuple(shown), caption=Message("note.curve_points"))


def _for_all(table: Table) -> Table:
    """Show people spans and offsets, whichever was stepped."""
    columns = (replace(each, only="all") if each.quantity else each for each in table.columns)
    return replace(table, columns=tuple(columns))


def _verification(note: Note) -> Iterator[Block]:
    """Lay one line out by both models, or say that there is no answer; nothing where left out."""
    if note.verification_failure:
        yield Verdict(Message("note.verification_no_answer"), passes=False)
        yield Text(note.verification_failure)
    elif note.verification is not None:
        part = note.verification.static
        yield Text(Message("note.verification_about"))
        yield Verdict(part_sentence(part), part.is_settled)
        yield compared_in_note(part.quantities)
        yield from closing_in_note(part)
        yield Text(Message("note.verification_legend"), is_small=True)


_BUILD: Mapping[str, Callable[[Note], Iterator[Block]]] = {
    "results": _results,
    "checks": _checks,
    "load_cases": _load_cases,
    "tension": _tension,
    "curve": _curve,
    "equations": lambda note: equation_trail(note.solution),
    "verification": _verification,
}


# ------------------------------------------------------------------ the front


def _front(chosen: Chosen | None) -> Iterator[Section]:
    if chosen is not None:
        yield note_section("front", of_the_front(chosen), "note.front_heading")


def of_the_front(chosen: Chosen, left_out: str = "note.front_left_out") -> Iterator[Block]:
    """Lay out the front of a search with the design that a note is of.

    `left_out` is the key of what is said of designs that the table leaves out.
    """
    document, designs = chosen.document, chosen.document["front"]
    first = designs[0]
    further = (key for key in OBJECTIVES if key in first and key not in document["objectives"])
    keys = [*document["objectives"], *further]
    found = Message(
        "note.front_found",
        count=len(designs),
        method=term(document["method"]),
        evaluations=document["evaluations"],
    )
    how = "note.front_exact" if document.get("is_exact", False) else "note.front_not_exact"
    yield Text(Several((found, Message(how)), " "))
    yield Figure(front(document, chosen.number))
    best = document["recommended"]
    if document.get("recommendation", ""):
        why = Message("note.front_why", number=best + 1)
        yield Text(Several((why, document["recommendation"]), " "))
    yield Points(tuple(document.get("ends", ())))
    yield from _present(document.get("present"), keys)
    yield from _designs(chosen, keys, left_out)
    yield from _neighbours(document, keys)


def _present(present: Mapping[str, Any] | None, keys: Sequence[str]) -> Iterator[Text]:
    """Say how the line of the case file does beside the front, where that is known."""
    if present is None:
        return
    values = Several(
        (
            Message("note.front_value", name=term(quantity.name), value=Measure(quantity.key, si))
            for key, quantity in OBJECTIVES.items()
            if key in keys and (si := present.get(key)) is not None
        ),
        ", ",
    )
    said = Message("note.front_present", values=values or "-", verdict=_said(present))
    yield Text(said)


def _designs(chosen: Chosen, keys: Sequence[str], left_out: str) -> Iterator[Block]:
    designs, best = chosen.document["front"], chosen.document["recommended"]
    shown = shown_designs(len(designs), chosen.number - 1, best)
    sinkers = [_sinker(each) for each in designs]
    yield Table(
        "front",
        (
            column("note.identity_design", range(1, len(designs) + 1)),
            *_objectives(keys, designs),
            column("note.front_made", map(composition, designs)),
            *([column("note.front_sinker", sinkers)] if any(sinkers) else []),
            column("note.checks_governing", (each["governing"] for each in designs)),
        ),
        Message("note.front_table"),
        shown,
        chosen.number - 1,
        only="not csv",
    )
    if len(shown) < len(designs):
        yield Text(Message(left_out, count=len(designs) - len(shown)), is_small=True)


def _objectives(keys: Sequence[str], points: Sequence[Mapping[str, Any]]) -> Iterator[Column]:
    for key in keys:
        quantity = OBJECTIVES[key]
        yield Column(term(quantity.name), tuple(each.get(key) for each in points), quantity)


def _sinker(point: Mapping[str, Any]) -> str:
    """Say the mass in air of a design's sinker; empty where there is none."""
    sinker = point.get("sinker")
    return f"{sinker['mass_kg'] / 1e3:g} t" if sinker and sinker["mass_kg"] else ""


def _neighbours(document: Mapping[str, Any], keys: Sequence[str]) -> Iterator[Table]:
    steps = document.get("neighbours", [])
    if not steps:
        return
    verdicts = Column(
        Message("columns.verdict"),
        tuple(map(_said, steps)),
        passes=tuple(each["feasible"] for each in steps),
    )
    yield Table(
        "neighbours",
        (
            column("note.front_change", (each["change"] for each in steps)),
            *_objectives(keys, steps),
            verdicts,
        ),
        Message("note.front_neighbours", number=document["recommended"] + 1),
        only="not csv",
    )


def _said(step: Mapping[str, Any]) -> str:
    """Say whether a changed design passes, or why not."""
    if step["feasible"]:
        return Message("answers.passes")
    why = step["reason"] or step["governing"]
    return Message("note.front_fails", why=why)
