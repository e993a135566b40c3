"""What the note of one line consists of, that of the line which a sizing recommends included."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from operator import itemgetter
from typing import TYPE_CHECKING, Any

from catopt.answers import blocks
from catopt.answers import solution as solved
from catopt.answers.blocks import (
    Block,
    Column,
    Figure,
    Rows,
    Table,
    Text,
    Verdict,
    about,
    tabulate,
    texts,
)
from catopt.answers.check import checked, failing_checks, load_case_table
from catopt.answers.design import listed_designs
from catopt.answers.note import (
    basis_section,
    by_both,
    case_sections,
    note_answer,
    opening,
    section,
    sheet_sections,
    small,
)
from catopt.answers.note_motion import motion_blocks
from catopt.answers.solution import marks_table, points_table
from catopt.answers.trail import equation_trail
from catopt.figures.line import line_in_water, load_curve, on_sinker, tension_along
from catopt.figures.sizing import OBJECTIVES, composition, front
from catopt.figures.swarm import fitness, swarm_tension
from catopt.words import Measure, Message, Several, term

if TYPE_CHECKING:
    from catopt.answers.blocks import Section
    from catopt.notes.line import Note
    from catopt.notes.origin import Chosen

_ROWS = 15
"""Points of the curve that people see, about."""
_CONVERGED = 1e-9
"""m: a run of the swarm that ends with f below it counts as converged."""
_MOST_RUNS = 30
"""Of the swarm that people see; the workbook has all."""


def line_note_answer(note: Note) -> blocks.Answer:
    """Lay out the note of one line."""
    line, chosen = note.solution.line, note.chosen
    sections = (
        *_opening(note),
        basis_section(note.sheet),
        *of_the_line(note, "checks", "load_cases", "results"),
        *sheet_sections(note.sheet),
        *of_the_line(note, "tension", "curve"),
        section("front", () if chosen is None else of_the_front(chosen)),
        *case_sections(note, note.case, line, None if chosen is None else chosen.number),
        *of_the_line(note, "equations", "verification", "swarm"),
        section("in_motion", motion_blocks(note), "note_motion"),
    )
    return note_answer(note, "note.kind", sections)


def of_the_line(note: Note, *names: str) -> Iterator[Section]:
    """Lay sections out that a sizing's note has, too; without blocks where there is nothing."""
    parts = {
        "results": _results(note),
        "checks": _checks(note),
        "load_cases": _load_cases(note),
        "tension": _tension(note),
        "curve": _curve(note),
        "equations": equation_trail(note.solution),
        "verification": by_both(note, "note"),
        "swarm": _swarm(note),
    }
    return (section(name, parts[name]) for name in names)


def _opening(note: Note) -> Iterator[Section]:
    solution, intact = note.solution, note.sheet.intact
    force = max(each.horizontal_force for each in intact)
    said = Message(
        "note_first.line",
        length=about("length", solution.line.length),
        span=about("span", solution.span),
        tension=about("tension", solution.fairlead.tension),
    )
    facts = (
        ("note.identity_load_case", note.load_case if note.case.load is not None else ""),
        ("note.identity_design", "" if note.chosen is None else str(note.chosen.number)),
        ("note.identity_regime", solved.how_it_hangs(solution)),
        ("note.identity_method", solved.method_name(solution.method)),
    )
    depth, failing = note.case.site.water_depth, failing_checks(note.checks)
    drawn = line_in_water(solution, depth, failing)
    if note.case.anchor is not None and note.case.anchor.kind == "sinker":
        drawn = on_sinker(drawn, solution)
    return opening(
        note,
        facts,
        said,
        drawing=(Text(Message("note.line_scale")), Figure(drawn)),
        force=(solved.force_name(intact), "horizontal_force", force),
        reach=(Message("quantities.span"), "span", max(each.span for each in intact)),
        tension=max(part.max_tension for each in intact for part in each.segments),
        in_motion=note.motion is not None,
        moved=None if note.motion is None else note.motion.checks,
    )


def _results(note: Note) -> Iterator[Block]:
    solution = note.solution
    if solution.found is not None:
        said = (Message("note.results_sought"), solution.found.condition)
        yield Text(Several(said, " "))
    kinds = (solved.found_facts, solved.result_facts, solved.residual_facts)
    every = (each for facts in kinds for each in facts(solution) if each.value is not None)
    yield blocks.Facts("results", tuple(every))
    yield replace(solved.segments_table(solution), only="workbook")
    if solution.point_loads:
        yield solved.point_loads_table(solution)


def _checks(note: Note) -> Iterator[Block]:
    report = note.checks
    if not report.results:
        return
    governing = report.governing
    marked = next((k for k, each in enumerate(report.results) if each is governing), None)
    checks, criteria = checked(report)
    yield replace(checks, marked=marked)
    yield criteria
    yield small("note.checks_legend")


def _load_cases(note: Note) -> Iterator[Block]:
    names = [name for name, _ in note.checks.solutions]
    if len(names) < 2:
        return
    marked = names.index(note.load_case) if note.load_case in names else None
    yield replace(load_case_table(note.checks), only="all", marked=marked)
    yield small("note.load_cases_marked")


def _tension(note: Note) -> Iterator[Block]:
    yield Figure(tension_along(note.solution, note.allowed))
    yield solved.profile_table(note.solution, only="workbook")


def _curve(note: Note) -> Iterator[Block]:
    """Draw the curve, and tabulate its marks and some of its points, both ends among them."""
    curve = note.curve
    if curve is None:
        return
    # The table of marks says what their numbers are.
    yield Figure(replace(load_curve(curve), notes=()))
    marks, points = _for_all(marks_table(curve)), _for_all(points_table(curve))
    numbers = texts("no", range(1, marks.length + 1))
    yield replace(marks, columns=(numbers, *marks.columns[1:]))
    count = points.length
    shown = sorted({*range(0, count, max(1, round(count / _ROWS))), count - 1})
    yield replace(points, shown=tuple(shown), caption=Message("note.curve_points"))


def _for_all(table: Table) -> Table:
    """Show people spans and offsets, whichever was stepped."""
    columns = (replace(each, only="all") if each.quantity else each for each in table.columns)
    return replace(table, columns=tuple(columns))


# ------------------------------------------------------------------ the particle swarm


def _swarm(note: Note) -> Iterator[Block]:
    """Lay the same line out by the swarm; nothing where nobody asked for it."""
    report = None if note.swarm is None else note.swarm.swarm
    if report is None:
        return
    said = [Message("note.swarm_about")]
    if note.load_case:
        said.append(Message("note.swarm_load_case", name=note.load_case))
    yield Text(Several(said, " "))
    verdict = Message(
        "note.swarm_verdict",
        converged=report.converged_runs,
        runs=report.runs,
        best=report.best_run,
        f=Measure("objective", report.objective),
    )
    yield Verdict(verdict, report.converged_runs > 0)
    yield _both(note)
    yield Figure(fitness(report))
    flown = tuple(solved.flown_facts(report))
    yield blocks.Facts("swarm_outcome", flown, Message("note.swarm_outcome"))
    history, runs = solved.swarm_tables(report)
    converged = (blocks.yes_or_no(f < _CONVERGED) for f in report.objectives)
    yield replace(
        runs,
        columns=(*runs.columns[:3], texts("note.swarm_converged", converged)),
        caption=Message("note.swarm_runs"),
        shown=tuple(range(min(runs.length, _MOST_RUNS))),
        marked=report.best_run - 1,
        only="all",
    )
    if runs.length > _MOST_RUNS:
        yield small("note_motion.left_out", count=runs.length - _MOST_RUNS)
    settings = solved.swarm_settings(note.case.swarm)
    yield replace(settings, caption=Message("note.swarm_settings"), only="all")
    yield small("note.swarm_legend")
    yield replace(history, only="workbook")
    yield Figure(swarm_tension(report, note.solution.fairlead.tension))


def _both(note: Note) -> Table:
    """Put the results of the swarm beside those in closed form."""
    assert note.swarm is not None
    results = (solved.result_facts(each) for each in (note.swarm, note.solution))
    pairs = [
        (one, one.value, other.value)
        for one, other in zip(*results, strict=True)
        if isinstance(one.value, float) and isinstance(other.value, float)
    ]
    units = tuple(one.quantity for one, _, _ in pairs if one.quantity is not None)
    found = texts("captions.particle_swarm", (a for _, a, _ in pairs), units=units)
    exact = texts("closed_form", (b for _, _, b in pairs), units=units)
    differences = texts(
        "note.swarm_difference",
        (a - b for _, a, b in pairs),
        units=tuple(replace(each, notation="scientific", digits=1) for each in units),
        formula=(found, "-", exact),
    )
    names, caption = texts("quantity", (one.name for one, *_ in pairs)), "note.swarm_results"
    return tabulate("swarm_results", names, found, exact, differences, caption=Message(caption))


# ------------------------------------------------------------------ the front


def of_the_front(chosen: Chosen, left_out: str = "note.front_left_out") -> Iterator[Block]:
    """Lay out the front of a search with the design that a note is of.

    `left_out` is the key of what is said of designs that the table leaves out.
    """
    document, designs = chosen.document, chosen.document["front"]
    keys = [*document["objectives"]]
    keys += [key for key in OBJECTIVES if key in designs[0] and key not in keys]
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
    yield blocks.Points(tuple(document.get("ends", ())))
    present = document.get("present")
    if present is not None:
        yield Text(_present(present, keys))
    shown = listed_designs(len(designs), chosen.number - 1, best)
    yield replace(_designs(designs, keys), shown=shown, marked=chosen.number - 1)
    if len(shown) < len(designs):
        yield small(left_out, count=len(designs) - len(shown))
    steps = document.get("neighbours", [])
    if not steps:
        return
    of = Rows(steps)
    yield tabulate(
        "neighbours",
        of.texts("note.front_change", itemgetter("change")),
        *_objectives(keys, steps),
        of.texts("verdict", _said, passes=tuple(each["feasible"] for each in steps)),
        caption=Message("note.front_neighbours", number=document["recommended"] + 1),
    )


def _present(present: Mapping[str, Any], keys: Sequence[str]) -> Message:
    """Say how the line of the case file does beside the front."""
    values = Several(
        (
            Message("note.front_value", name=term(quantity.name), value=Measure(quantity.key, si))
            for key, quantity in OBJECTIVES.items()
            if key in keys and (si := present.get(key)) is not None
        ),
        ", ",
    )
    return Message("note.front_present", values=values or "-", verdict=_said(present))


def _designs(designs: Sequence[Mapping[str, Any]], keys: Sequence[str]) -> Table:
    of = Rows(designs)
    sinker = of.texts("note.front_sinker", _sinker)
    return tabulate(
        "front",
        texts("note.identity_design", range(1, len(designs) + 1)),
        *_objectives(keys, designs),
        of.texts("note.front_made", composition),
        *([sinker] if any(sinker.values) else []),
        of.texts("note.checks_governing", itemgetter("governing")),
        caption=Message("note.front_table"),
    )


def _objectives(keys: Sequence[str], points: Sequence[Mapping[str, Any]]) -> Iterator[Column]:
    for key in keys:
        quantity = OBJECTIVES[key]
        yield Column(term(quantity.name), tuple(each.get(key) for each in points), quantity)


def _sinker(point: Mapping[str, Any]) -> str:
    """Say the mass in air of a design's sinker; empty where there is none."""
    sinker = point.get("sinker")
    return f"{sinker['mass_kg'] / 1e3:g} t" if sinker and sinker["mass_kg"] else ""


def _said(step: Mapping[str, Any]) -> str:
    """Say whether a changed design passes, or why not."""
    if step["feasible"]:
        return Message("answers.passes")
    return Message("note.front_fails", why=step["reason"] or step["governing"])
