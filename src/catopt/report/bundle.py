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
    from catopt.report.texts import Language
    from catopt.reproduce import Reproduction
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
    "solution_bundle",
    "system_bundle",
    "verification_bundle",
]


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
    from catopt.report import plots, tables
    from catopt.report.workbook import solution_workbook

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
    from catopt.report import plots, tables

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
    from catopt.report import plots, tables
    from catopt.report.workbook import curve_workbook

    return {
        "curve.json": _json(result.to_dict()),
        "curve.xlsx": curve_workbook(result, language),
        "curve.csv": _csv(tables.curve_points(result)),
        "curve_marks.csv": _csv(tables.curve_marks(result)),
        **_figure("curve", plots.load_curve(result)),
    }


def reproduction_bundle(result: Reproduction, language: Language = "en") -> dict[str, bytes]:
    """Make the files of ``catopt reproduce --out DIR``: page, document, tables and figures."""
    from catopt.report import tables
    from catopt.report.workbook import reproduction_workbook
    from catopt.reproduce import book

    files = {
        "reproduction.md": book(result).encode(),
        "reproduction.json": _json(result.to_dict()),
        "reproduction.csv": _csv(tables.reproduction(result)),
        "reproduction.xlsx": reproduction_workbook(result, language),
    }
    for study in result.studies:
        if study.drawn:
            from catopt.report.study_views import lines_to_scale

            files |= _figure(f"{study.name}_lines", lines_to_scale(study))
        if study.by_swarm is not None:
            files |= _swarm(study.by_swarm, study.name)
        if study.moorings:
            from catopt.report import mooring_views

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
    from catopt.report import design
    from catopt.report.design_plots import design_front
    from catopt.report.workbook import design_workbook

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
    from catopt.report import checks
    from catopt.report.workbook import check_workbook

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
    from catopt.report import system, system_plots
    from catopt.report.workbook import system_workbook

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
    from catopt.report import verify, verify_plots
    from catopt.report.texts import Words
    from catopt.report.workbook import verification_workbook
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
    from catopt.report import dynamic, dynamic_plots
    from catopt.report.texts import Words
    from catopt.report.workbook import verification_workbook

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
    from catopt.report.catalogue import catalogue_tables
    from catopt.report.workbook import catalogue_workbook

    frames = catalogue_tables(answer)
    return {
        "catalog.json": _json(answer.to_dict()),
        "catalog.xlsx": catalogue_workbook(frames, language),
        **{f"{name}.csv": _csv(frame) for name, frame in frames.items()},
    }


def loads_bundle(of: Loads, language: Language = "en") -> dict[str, bytes]:
    """Make the files of ``catopt loads ... --out DIR``: document, tables and workbook."""
    from catopt.loads.document import loads_document
    from catopt.report import loads
    from catopt.report.workbook import loads_workbook

    return {
        "loads.json": _json(loads_document(of)),
        "loads.xlsx": loads_workbook(of, language),
        "loads.csv": _csv(loads.loads_table(of)),
        "numbers.csv": _csv(loads.load_numbers(of)),
        "notes.csv": _csv(loads.load_notes(of)),
    }


def _json(document: dict[str, Any]) -> bytes:
    return (json.dumps(document, indent=2, ensure_ascii=False, allow_nan=False) + "\n").encode()


def _csv(frame: pd.DataFrame) -> bytes:
    """Write every digit of a number, so that nothing is lost on the way to other programs."""
    return str(frame.to_csv(index=False, lineterminator="\n")).encode()


def _figure(name: str, figure: Figure) -> dict[str, bytes]:
    from catopt.report.figures import render

    return {f"{name}.png": render(figure, "png"), f"{name}.svg": render(figure, "svg")}
