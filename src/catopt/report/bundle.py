"""Everything that ``--out`` writes, as file names and contents."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.figure import Figure

    from catopt.catalogue.document import Answer
    from catopt.catenary.case_curve import CaseCurve
    from catopt.catenary.solution import Solution
    from catopt.model import Case
    from catopt.reproduce import Reproduction

__all__ = ["catalogue_bundle", "curve_bundle", "reproduction_bundle", "solution_bundle"]


def solution_bundle(case: Case, solution: Solution) -> dict[str, bytes]:
    """Make the files of ``catopt solve CASE --out DIR``.

    Parameters
    ----------
    case : Case
        What was given.
    solution : Solution
        What came out.

    Returns
    -------
    dict of str to bytes
        The document, tables (CSV), a workbook and figures (PNG and SVG) by file name.
    """
    from catopt.report import plots, tables
    from catopt.report.workbook import solution_workbook

    files = {
        "solution.json": _json(solution.to_dict(profile=True)),
        "solution.xlsx": solution_workbook(case, solution),
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


def curve_bundle(result: CaseCurve) -> dict[str, bytes]:
    """Make the files of ``catopt curve CASE --out DIR``: document, tables, workbook and figure."""
    from catopt.report import plots, tables
    from catopt.report.workbook import curve_workbook

    return {
        "curve.json": _json(result.to_dict()),
        "curve.xlsx": curve_workbook(result),
        "curve.csv": _csv(tables.curve_points(result)),
        "curve_marks.csv": _csv(tables.curve_marks(result)),
        **_figure("curve", plots.load_curve(result)),
    }


def reproduction_bundle(result: Reproduction) -> dict[str, bytes]:
    """Make the files of ``catopt reproduce --out DIR``: page, document, tables and figures."""
    from catopt.report import tables
    from catopt.report.workbook import reproduction_workbook
    from catopt.reproduce import book

    files = {
        "reproduction.md": book(result).encode(),
        "reproduction.json": _json(result.to_dict()),
        "reproduction.csv": _csv(tables.reproduction(result)),
        "reproduction.xlsx": reproduction_workbook(result),
    }
    for study in result.studies:
        if study.by_swarm is not None:
            files |= _swarm(study.by_swarm, study.name)
    return files


def catalogue_bundle(answer: Answer) -> dict[str, bytes]:
    """Make the files of ``catopt catalog ... --out DIR``: document, tables and workbook."""
    from catopt.report.catalogue import catalogue_tables
    from catopt.report.workbook import catalogue_workbook

    frames = catalogue_tables(answer)
    return {
        "catalog.json": _json(answer.to_dict()),
        "catalog.xlsx": catalogue_workbook(frames),
        **{f"{name}.csv": _csv(frame) for name, frame in frames.items()},
    }


def _json(document: dict[str, Any]) -> bytes:
    return (json.dumps(document, indent=2, ensure_ascii=False, allow_nan=False) + "\n").encode()


def _csv(frame: pd.DataFrame) -> bytes:
    """Write every digit of a number, so that nothing is lost on the way to other programs."""
    return str(frame.to_csv(index=False, lineterminator="\n")).encode()


def _figure(name: str, figure: Figure) -> dict[str, bytes]:
    from catopt.report.figures import render

    return {f"{name}.png": render(figure, "png"), f"{name}.svg": render(figure, "svg")}
