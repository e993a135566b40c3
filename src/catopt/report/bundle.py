"""Everything that ``--out`` writes, as file names and contents."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

from catopt.casefile.design_directory import DESIGN_CASE, DESIGN_DOCUMENT

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.figure import Figure

    from catopt.catalogue.document import Answer
    from catopt.catenary.case_curve import CaseCurve
    from catopt.catenary.solution import Solution
    from catopt.checks.result import CheckReport
    from catopt.design.result import DesignResult
    from catopt.loads.component import Loads
    from catopt.model import Case
    from catopt.mooring.case import SystemReport
    from catopt.report.page.sizing.note import Given
    from catopt.report.texts import Language
    from catopt.reproduce import Reproduction
    from catopt.sizing import Sizing
    from catopt.verify.dynamic_result import DynamicVerification
    from catopt.verify.front import FrontVerification
    from catopt.verify.result import Verification

__all__ = [
    "catalogue_bundle",
    "check_bundle",
    "curve_bundle",
    "design_bundle",
    "loads_bundle",
    "reproduction_bundle",
    "size_bundle",
    "solution_bundle",
    "system_bundle",
    "verification_bundle",
]


SYSTEM_CASE = "system.toml"
"""The whole pattern of several lines, for ``catopt system``."""


def solution_bundle(case: Case, solution: Solution, language: Language = "en") -> dict[str, bytes]:
    """Make the files of ``catopt solve CASE --out DIR``.

    Parameters
    ----------
    case : Case
        What was given.
    solution : Solution
        What came out.
    language : {"en", "vi"}
        Of the workbook; tables and figures stay in English.

    Returns
    -------
    dict of str to bytes
        The document, tables (CSV), a workbook and figures (PNG and SVG) by file name.
    """
    from catopt.report.plots import line as plots
    from catopt.report.tables import solution as tables
    from catopt.report.workbook.books import solution_workbook

    files = {
        "solution.json": _json(solution.to_dict(profile=True)),
        "solution.xlsx": solution_workbook(case, solution, language),
        "inputs.csv": _csv(tables.inputs(case)),
        "summary.csv": _csv(tables.summary(solution)),
        "segments.csv": _csv(tables.segments(solution)),
        "profile.csv": _csv(tables.profile(solution)),
        **_figure("line", plots.line_in_water(solution, case.site.water_depth)),
        **_figure("tension", plots.tension(solution)),
    }
    if solution.point_loads:
        files["point_loads.csv"] = _csv(tables.point_loads(solution))
    return files | _swarm(solution, "swarm")


def _swarm(solution: Solution, name: str) -> dict[str, bytes]:
    """Make the swarm's tables and S1's figures 3 and 4; nothing when there was no swarm."""
    from catopt.report.plots import line as plots
    from catopt.report.tables import solution as tables

    swarm = solution.swarm
    if swarm is None:
        return {}
    exact = solution.fairlead.tension - swarm.closed_form_difference["tension_N"]
    return {
        f"{name}_runs.csv": _csv(tables.swarm_runs(swarm)),
        f"{name}_history.csv": _csv(tables.swarm_history(swarm)),
        **_figure(f"{name}_fitness", plots.fitness(swarm)),
        **_figure(f"{name}_tension", plots.swarm_tension(swarm, exact)),
    }


def curve_bundle(result: CaseCurve, language: Language = "en") -> dict[str, bytes]:
    """Make the files of ``catopt curve CASE --out DIR``: document, tables, workbook and figure."""
    from catopt.report.plots import line as plots
    from catopt.report.tables import solution as tables
    from catopt.report.workbook.books import curve_workbook

    return {
        "curve.json": _json(result.to_dict()),
        "curve.xlsx": curve_workbook(result, language),
        "curve.csv": _csv(tables.curve_points(result)),
        "curve_marks.csv": _csv(tables.curve_marks(result)),
        **_figure("curve", plots.load_curve(result)),
    }


def reproduction_bundle(result: Reproduction, language: Language = "en") -> dict[str, bytes]:
    """Make the files of ``catopt reproduce --out DIR``: page, document, tables and figures."""
    from catopt.report.tables import solution as tables
    from catopt.report.workbook.books import reproduction_workbook
    from catopt.reproduce import book

    files = {
        "reproduction.md": book(result).encode(),
        "reproduction.json": _json(result.to_dict()),
        "reproduction.csv": _csv(tables.reproduction(result)),
        "reproduction.xlsx": reproduction_workbook(result, language),
    }
    for study in result.studies:
        if study.drawn:
            from catopt.report.plots.studies import lines_to_scale

            files |= _figure(f"{study.name}_lines", lines_to_scale(study))
        if study.by_swarm is not None:
            files |= _swarm(study.by_swarm, study.name)
        if study.moorings:
            from catopt.report.plots import moorings as mooring_views

            files |= _figure(f"{study.name}_plan", mooring_views.plan(study))
            files |= _figure(f"{study.name}_elevation", mooring_views.elevation(study))
    return files


def design_bundle(result: DesignResult, language: Language = "en") -> dict[str, bytes]:
    """Make the files of ``catopt design CASE --out DIR``.

    Beside document, tables, workbook and figure there is the case itself, so that
    ``catopt solve DIR --design K`` needs nothing else.
    """
    from catopt.casefile import write_case
    from catopt.design.document import design_document
    from catopt.report.plots.design import design_front
    from catopt.report.tables import design
    from catopt.report.workbook.books import design_workbook

    return {
        DESIGN_DOCUMENT: _json(design_document(result)),
        DESIGN_CASE: write_case(result.case).encode(),
        "design.xlsx": design_workbook(result, language),
        "front.csv": _csv(design.front(result)),
        "components.csv": _csv(design.components(result)),
        "checks.csv": _csv(design.design_checks(result)),
        "neighbours.csv": _csv(design.neighbours(result)),
        "search.csv": _csv(design.search_summary(result)),
        **_figure("front", design_front(result)),
    }


def check_bundle(report: CheckReport, language: Language = "en") -> dict[str, bytes]:
    """Make the files of ``catopt check CASE --out DIR``: document, tables and workbook."""
    from catopt.report.tables import checks
    from catopt.report.workbook.books import check_workbook

    return {
        "check.json": _json(report.to_dict()),
        "check.xlsx": check_workbook(report, language),
        "checks.csv": _csv(checks.checks(report)),
        "load_cases.csv": _csv(checks.load_cases(report)),
    }


def system_bundle(report: SystemReport, language: Language = "en") -> dict[str, bytes]:
    """Make the files of ``catopt system CASE --out DIR``: document, tables, workbook and figures.

    The tables and figures of what was not asked for are left out.
    """
    from catopt.report.plots import system as system_plots
    from catopt.report.tables import system
    from catopt.report.workbook.books import system_workbook

    title = report.case.title
    frames = system.frames(report)
    files = {
        "system.json": _json(report.to_dict()),
        "system.xlsx": system_workbook(title, frames, language),
        **{f"{name}.csv": _csv(frame) for name, frame in frames.items()},
        **_figure("plan", system_plots.plan(report)),
    }
    if report.circle is not None:
        files |= _figure("watch_circle", system_plots.watch_circle(report.circle, title))
    if report.curves:
        files |= _figure("restoring", system_plots.restoring(report.curves, title))
    return files


def verification_bundle(
    found: Verification | FrontVerification,
    dynamic: DynamicVerification | None = None,
    language: Language = "en",
) -> dict[str, bytes]:
    """Make the files of ``catopt verify ... --out DIR``: document, tables, workbook and figures.

    A front has no figures. A line in motion has tables, a workbook and figures of its own.
    """
    from catopt.report.plots import verify as verify_plots
    from catopt.report.tables import verify
    from catopt.report.texts import Words
    from catopt.report.workbook.books import verification_workbook
    from catopt.verify.result import Verification

    frames = verify.frames(found)
    sheets = verify.said_frames(frames, Words(language))
    document = found.to_dict()
    files = {
        "verify.xlsx": verification_workbook(verify.title_of(found), sheets, language),
        **{f"{name}.csv": _csv(frame) for name, frame in frames.items()},
    }
    if isinstance(found, Verification):
        for name, figure in verify_plots.figures(found).items():
            files |= _figure(name, figure)
    if dynamic is not None:
        document["dynamic"] = dynamic.to_dict()
        files |= _dynamic(dynamic, language)
    return {"verify.json": _json(document), **files}


def _dynamic(found: DynamicVerification, language: Language) -> dict[str, bytes]:
    from catopt.report.plots import dynamic as dynamic_plots
    from catopt.report.tables import dynamic
    from catopt.report.texts import Words
    from catopt.report.workbook.books import verification_workbook

    frames = dynamic.frames(found)
    sheets = dynamic.workbook_frames(frames, Words(language))
    files = {
        "dynamic.xlsx": verification_workbook(found.case.title, sheets, language),
        **{f"{name}.csv": _csv(frame) for name, frame in frames.items()},
    }
    for name, figure in dynamic_plots.figures(found).items():
        files |= _figure(name, figure)
    return files


def catalogue_bundle(answer: Answer, language: Language = "en") -> dict[str, bytes]:
    """Make the files of ``catopt catalog ... --out DIR``: document, tables and workbook."""
    from catopt.report.tables.catalogue import catalogue_tables
    from catopt.report.workbook.books import catalogue_workbook

    frames = catalogue_tables(answer)
    return {
        "catalog.json": _json(answer.to_dict()),
        "catalog.xlsx": catalogue_workbook(frames, language),
        **{f"{name}.csv": _csv(frame) for name, frame in frames.items()},
    }


def loads_bundle(of: Loads, language: Language = "en") -> dict[str, bytes]:
    """Make the files of ``catopt loads ... --out DIR``: document, tables and workbook."""
    from catopt.loads.document import loads_document
    from catopt.report.tables import loads
    from catopt.report.workbook.books import loads_workbook

    return {
        "loads.json": _json(loads_document(of)),
        "loads.xlsx": loads_workbook(of, language),
        "loads.csv": _csv(loads.loads_table(of)),
        "numbers.csv": _csv(loads.load_numbers(of)),
        "notes.csv": _csv(loads.load_notes(of)),
    }


def size_bundle(
    of: Sizing, language: Language = "en", given: Given | None = None
) -> dict[str, bytes]:
    """Make the files of ``catopt size ... --out DIR``.

    Document, tables, workbook, the line in the water, the calculation note, and the case that all
    commands take; of several lines the case of the whole pattern, too.

    Parameters
    ----------
    of : Sizing
        Of a buoy or a tanker.
    language : {"en", "vi"}
        Of workbook and note; the rest is the same in both.
    given : Given, optional
        What was asked for; no note without it.
    """
    from catopt.casefile import write_case
    from catopt.report.plots.line import line_in_water
    from catopt.report.tables.size import size_tables
    from catopt.report.workbook.books import size_workbook
    from catopt.sizing.pattern import system_case

    tables = size_tables(of)
    name, solution = of.hardest
    state = next(each for each in of.case.load_cases if each.name == name)
    files = {
        "size.json": _json(of.to_dict()),
        "size.xlsx": size_workbook(of.case.title, tables, language),
        **{f"{key}.csv": _csv(frame) for key, frame in tables.items()},
        DESIGN_CASE: write_case(of.case).encode(),
        **_figure("line", line_in_water(solution, of.case.site.water_depth + state.water_level)),
    }
    if given is not None:
        from catopt.report.page.render import render_page
        from catopt.report.page.sizing.note import size_note

        files["note.html"] = render_page(size_note(of, given), language)
    if of.pattern is not None:
        files[SYSTEM_CASE] = write_case(system_case(of.case, of.pattern)).encode()
    return files


def _json(document: dict[str, Any]) -> bytes:
    return (json.dumps(document, indent=2, ensure_ascii=False, allow_nan=False) + "\n").encode()


def _csv(frame: pd.DataFrame) -> bytes:
    """Write every digit of a number, so that nothing is lost on the way to other programs."""
    return str(frame.to_csv(index=False, lineterminator="\n")).encode()


def _figure(name: str, figure: Figure) -> dict[str, bytes]:
    from catopt.report.plots.common import render

    return {f"{name}.png": render(figure, "png"), f"{name}.svg": render(figure, "svg")}
