"""What ``--out`` writes beside document, tables and workbook, as file names and contents."""

from __future__ import annotations

from typing import TYPE_CHECKING

from catopt.casefile.design_directory import DESIGN_CASE
from catopt.render.plain import csv_of
from catopt.ties import first_largest
from catopt.words import Message

if TYPE_CHECKING:
    from catopt.catenary.case_curve import CaseCurve
    from catopt.catenary.solution import Solution
    from catopt.design.result import DesignResult
    from catopt.model import Case
    from catopt.mooring.case import SystemReport
    from catopt.notes.size import Given
    from catopt.reproduce import Reproduction
    from catopt.reproduce.items import Study
    from catopt.sizing import Sizing
    from catopt.verify.dynamic_result import DynamicPart, DynamicVerification
    from catopt.verify.result import Verification
    from catopt.words import Language

SYSTEM_CASE = "system.toml"
"""The whole pattern of several lines, for ``catopt system``."""


def solution_pictures(case: Case, solution: Solution) -> dict[str, bytes]:
    """Draw the line in the water, the tension along it and, of a swarm, S1's figures 3 and 4."""
    from catopt.figures.line import line_in_water, tension_along
    from catopt.render.picture import pictures

    factor, title = solution.safety_factor, solution.title
    allowed = [each.MBL and each.MBL / factor for each in solution.segments]
    basis = Message("figures.MBL_over", factor=factor)
    return {
        **pictures("line", line_in_water(solution, case.site.water_depth), title),
        **pictures("tension", tension_along(solution, allowed, basis), title),
        **_swarm_pictures(solution, "swarm"),
    }


def _swarm_pictures(solution: Solution, name: str) -> dict[str, bytes]:
    """Draw S1's figures 3 and 4; nothing when there was no swarm."""
    from catopt.figures.swarm import fitness, swarm_tension
    from catopt.render.picture import pictures

    swarm = solution.swarm
    if swarm is None:
        return {}
    exact = solution.fairlead.tension - swarm.closed_form_difference["tension_N"]
    return {
        **pictures(f"{name}_fitness", fitness(swarm), solution.title),
        **pictures(f"{name}_tension", swarm_tension(swarm, exact), solution.title),
    }


def _swarm(solution: Solution, name: str) -> dict[str, bytes]:
    from catopt.answers.solution import swarm_tables

    assert solution.swarm is not None
    history, runs = swarm_tables(solution.swarm)
    return {
        f"{name}_runs.csv": csv_of(runs.to_dataframe()),
        f"{name}_history.csv": csv_of(history.to_dataframe()),
        **_swarm_pictures(solution, name),
    }


def reproduction_pictures(result: Reproduction) -> dict[str, bytes]:
    """Draw the studies; of a swarm with the tables of its runs."""
    files: dict[str, bytes] = {}
    for study in result.studies:
        if study.by_swarm is not None:
            files |= _swarm(study.by_swarm, study.name)
        files |= _drawn(study)
    return files


def _drawn(study: Study) -> dict[str, bytes]:
    """Make the figures of a study: its lines to scale, and a body by several models."""
    from catopt.figures import studies
    from catopt.render.picture import pictures

    files: dict[str, bytes] = {}
    if study.drawn:
        lines = [(each.name, each.solution) for each in study.drawn]
        depth = max(each.depth or each.solution.fairlead_height for each in study.drawn)
        charts = studies.lines_to_scale(lines, depth)
        files |= pictures(f"{study.name}_lines", charts, study.title)
    if study.moorings:
        of = study.moorings
        views = (studies.models_from_above(of), studies.models_near(of))
        side = studies.models_from_the_side(of, study.loaded_line)
        files |= pictures(f"{study.name}_plan", views, study.title, columns=2)
        files |= pictures(f"{study.name}_elevation", side, study.title)
    return files


def design_pictures(result: DesignResult) -> dict[str, bytes]:
    """Draw the front and three of its lines; of whole moorings the recommended one in plan."""
    from catopt.design.document import design_document
    from catopt.figures.front import front, front_lines
    from catopt.render.picture import pictures

    document = design_document(result)
    title, mooring = result.case.title, result.front[result.recommended].mooring
    if mooring is not None:
        from catopt.figures.mooring import plan

        return pictures("front", front(document), title) | pictures(
            "plan", plan(mooring.farthest), title
        )
    return pictures("front", (front(document), front_lines(result, document)), title)


def curve_pictures(result: CaseCurve) -> dict[str, bytes]:
    """Draw a load curve."""
    from catopt.figures.curve import load_curve
    from catopt.render.picture import pictures

    return pictures("curve", load_curve(result), result.case.title)


def system_pictures(report: SystemReport) -> dict[str, bytes]:
    """Draw a body on its lines; the figures of what was not asked for are left out."""
    from catopt.figures import mooring
    from catopt.render.picture import pictures

    title, solution = report.case.title, report.solution
    around = mooring.near(solution)
    plans = (mooring.plan(solution), *(() if around is None else (around,)))
    files = pictures("plan", plans, title)
    if report.circle is not None:
        circle = report.circle
        views = (mooring.watch_track(solution, circle), mooring.watch_round(solution, circle))
        files |= pictures("watch_circle", views, title)
    if report.curves:
        files |= pictures("restoring", mooring.restoring(report.curves, solution), title)
    return files


def verification_pictures(found: Verification) -> dict[str, bytes]:
    """Draw every load case; of a body the most loaded line."""
    from catopt.figures.verification import comparison
    from catopt.render.picture import pictures

    files: dict[str, bytes] = {}
    for number, part in enumerate(found.parts, start=1):
        titles = [found.case.title, part.name if found.case.load_cases else ""]
        line = first_largest([pair.finest.fairlead.tension for pair in part.lines])
        if part.kind == "system":
            titles.append(Message("figures.most_loaded", line=line + 1))
        name = f"comparison_{number}" if len(found.parts) > 1 else "comparison"
        title = ", ".join(each for each in titles if each)
        files |= pictures(name, comparison(part.lines[line]), title, columns=2)
    return files


def motion_pictures(found: DynamicVerification) -> dict[str, bytes]:
    """Draw every load case in motion, or the governing line of a body."""
    title = found.case.title
    if found.case.system is not None:
        part = found.governing
        return _in_motion("dynamic", part, f"{title}, {part.where}")
    files = _on_slope(found)
    if len(found.parts) == 1:
        return files | _in_motion("dynamic", found.parts[0], title)
    for number, part in enumerate(found.parts, start=1):
        files |= _in_motion(f"dynamic_{number}", part, f"{title}, {part.name}".strip(", "))
    return files


def _on_slope(found: DynamicVerification) -> dict[str, bytes]:
    """Draw the line at rest on a bed that slopes, under its first load."""
    from catopt.figures.motion import on_slope
    from catopt.render.picture import pictures

    site = found.case.site
    if site.seabed_slope == 0.0:
        return {}
    part = found.parts[0]
    levels = {each.name: each.water_level for each in found.case.load_cases}
    depth = site.water_depth + levels.get(part.name, 0.0)
    chart = on_slope(part, depth, site.seabed_slope)
    return pictures("line", chart, found.case.title)


def _in_motion(name: str, part: DynamicPart, title: str) -> dict[str, bytes]:
    from catopt.figures import motion
    from catopt.render.picture import pictures

    peaks = motion.exceedance(part)
    charts = [motion.whole_history(part), motion.spectrum(part), motion.envelope_chart(part)]
    return pictures(name, charts if peaks is None else [*charts, peaks], title)


def size_files(
    of: Sizing, language: Language = "en", given: Given | None = None
) -> dict[str, bytes]:
    """Make the files of ``catopt size ... --out DIR`` beside document, tables and workbook.

    The line in the water, the calculation note in a language, and the case that all commands take;
    of several lines the case of the whole pattern, too.
    No note where nothing says what was asked for.
    """
    from catopt.casefile import write_case
    from catopt.figures.line import line_in_water
    from catopt.render.picture import pictures
    from catopt.sizing.pattern import system_case

    name, solution = of.hardest
    state = next(each for each in of.case.load_cases if each.name == name)
    files = {
        DESIGN_CASE: write_case(of.case).encode(),
        **pictures(
            "line",
            line_in_water(solution, of.case.site.water_depth + state.water_level),
            of.case.title,
        ),
    }
    if given is not None:
        from catopt.answers.note_size import size_note_answer
        from catopt.notes.size import size_note
        from catopt.render.page import page

        files["note.html"] = page(size_note_answer(size_note(of, given)), language)
    if of.pattern is not None:
        files[SYSTEM_CASE] = write_case(system_case(of.case, of.pattern)).encode()
    return files
