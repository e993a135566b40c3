"""What ``--out`` writes beside document, tables and workbook, as file names and contents."""

from __future__ import annotations

from typing import TYPE_CHECKING

from catopt.casefile.design_directory import DESIGN_CASE
from catopt.render.plain import csv_of
from catopt.report.drawings import (
    Drawing,
    of_comparison,
    of_curve,
    of_front,
    of_line,
    of_motion,
    of_plan,
    of_sizing,
    of_study,
    of_tension,
)

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
    from catopt.study.result import StudyResult
    from catopt.verify.dynamic_result import DynamicVerification
    from catopt.verify.result import Verification
    from catopt.words import Language

SYSTEM_CASE = "system.toml"
"""The whole pattern of several lines, for ``catopt system``."""


def _drawn_as(name: str, drawing: Drawing) -> dict[str, bytes]:
    from catopt.render.picture import pictures

    return pictures(name, drawing.charts, drawing.title, columns=drawing.columns)


def solution_pictures(case: Case, solution: Solution) -> dict[str, bytes]:
    """Draw the line in the water, the tension along it and, of a swarm, S1's figures 3 and 4."""
    return {
        **_drawn_as("line", of_line(solution, case.site.water_depth, solution.title)),
        **_drawn_as("tension", of_tension(solution)),
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


def study_pictures(result: StudyResult) -> dict[str, bytes]:
    """Draw how often values are exceeded; nothing where all members are alike."""
    drawing = of_study(result)
    return _drawn_as("study", drawing) if drawing.charts else {}


def design_pictures(result: DesignResult) -> dict[str, bytes]:
    """Draw the front and three of its lines; of whole moorings the recommended one in plan."""
    files = _drawn_as("front", of_front(result))
    mooring = result.front[result.recommended].mooring
    if mooring is None:
        return files
    plan = of_plan(mooring.farthest, result.case.title)
    return files | _drawn_as("plan", plan._replace(charts=plan.charts[:1]))


def curve_pictures(result: CaseCurve) -> dict[str, bytes]:
    """Draw a load curve."""
    return _drawn_as("curve", of_curve(result))


def system_pictures(report: SystemReport) -> dict[str, bytes]:
    """Draw a body on its lines; the figures of what was not asked for are left out."""
    from catopt.figures import mooring
    from catopt.render.picture import pictures

    title, solution = report.case.title, report.solution
    files = _drawn_as("plan", of_plan(solution, title))
    if report.circle is not None:
        circle = report.circle
        views = (mooring.watch_track(solution, circle), mooring.watch_round(solution, circle))
        files |= pictures("watch_circle", views, title)
    if report.curves:
        files |= pictures("restoring", mooring.restoring(report.curves, solution), title)
    return files


def verification_pictures(found: Verification) -> dict[str, bytes]:
    """Draw every load case; of a body the most loaded line."""
    files: dict[str, bytes] = {}
    for number, part in enumerate(found.parts, start=1):
        name = f"comparison_{number}" if len(found.parts) > 1 else "comparison"
        files |= _drawn_as(name, of_comparison(found, part))
    return files


def motion_pictures(found: DynamicVerification) -> dict[str, bytes]:
    """Draw every load case in motion, or the governing line of a body."""
    title = found.case.title
    if found.case.system is not None:
        part = found.governing
        return _drawn_as("dynamic", of_motion(part, f"{title}, {part.where}"))
    files = _on_slope(found)
    if len(found.parts) == 1:
        return files | _drawn_as("dynamic", of_motion(found.parts[0], title))
    for number, part in enumerate(found.parts, start=1):
        of = of_motion(part, f"{title}, {part.name}".strip(", "))
        files |= _drawn_as(f"dynamic_{number}", of)
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


def size_files(
    of: Sizing, language: Language = "en", given: Given | None = None
) -> dict[str, bytes]:
    """Make the files of ``catopt size ... --out DIR`` beside document, tables and workbook.

    The line in the water, the calculation note in a language, and the case that all commands take;
    of several lines the case of the whole pattern, too.
    No note where nothing says what was asked for.
    """
    from catopt.casefile import write_case
    from catopt.sizing.pattern import system_case

    files = {DESIGN_CASE: write_case(of.case).encode(), **_drawn_as("line", of_sizing(of))}
    if given is not None:
        from catopt.answers.note_size import size_note_answer
        from catopt.notes.size import size_note
        from catopt.render.page import page

        files["note.html"] = page(size_note_answer(size_note(of, given)), language)
    if of.pattern is not None:
        files[SYSTEM_CASE] = write_case(system_case(of.case, of.pattern)).encode()
    return files
