"""A solution and its case as pandas tables; every heading carries its unit."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

import pandas as pd

from catopt.quantities import QUANTITIES, Quantity
from catopt.report.tables.load_curve import at_marks, at_points
from catopt.report.tables.summary import (
    columns,
    found,
    given,
    in_tonne_force,
    named,
    residuals,
    results,
)

if TYPE_CHECKING:
    from catopt.catenary.case_curve import CaseCurve
    from catopt.catenary.solution import Solution, SwarmReport
    from catopt.model import Case, Line
    from catopt.reproduce import Reproduction

__all__ = [
    "column",
    "curve_marks",
    "curve_points",
    "inputs",
    "point_load_inputs",
    "point_loads",
    "profile",
    "reproduction",
    "segment_inputs",
    "segments",
    "summary",
    "swarm_history",
    "swarm_runs",
    "swarm_settings",
]

_LARGEST = named("tension", "Largest tension")
_FAIRLEAD = named("tension", "Fairlead tension")


def inputs(case: Case) -> pd.DataFrame:
    """Tabulate what a case gives beside its line, in one row."""
    return pd.DataFrame([{"Title": case.title, "Source": case.source, **columns(given(case))}])


def segment_inputs(line: Line) -> pd.DataFrame:
    """Tabulate the segments as given, a row each from the anchor to the fairlead."""
    parts = line.segments
    return pd.DataFrame(
        {
            "Segment": range(1, len(parts) + 1),
            "Name": [segment.name for segment in parts],
            **column("length", (segment.length for segment in parts)),
            **column("submerged_weight", (segment.submerged_weight for segment in parts)),
            **column("EA", (segment.EA for segment in parts)),
            **column("mass_per_length", (segment.mass for segment in parts)),
            **column("MBL", (segment.MBL for segment in parts)),
        }
    )


def point_load_inputs(line: Line) -> pd.DataFrame:
    """Tabulate clump weights and buoys as given, a row each by position."""
    parts = line.point_loads
    own = [load.friction for load in parts]
    return pd.DataFrame(
        {
            "Point load": range(1, len(parts) + 1),
            "Name": [load.name for load in parts],
            **column("position", (load.position for load in parts)),
            **column("point_weight", (load.submerged_weight for load in parts)),
            **column("mass", (load.mass for load in parts)),
            **(column("friction", own) if any(mu is not None for mu in own) else {}),
        }
    )


def swarm_settings(case: Case) -> pd.DataFrame:
    """Tabulate the settings of the swarm, in one row."""
    swarm = case.swarm
    return pd.DataFrame(
        [
            {
                "Particles": swarm.particles,
                "Iterations": swarm.iterations,
                "Runs": swarm.runs,
                "Seed": swarm.seed,
                "Cognitive coefficient c1 (-)": swarm.cognitive,
                "Social coefficient c2 (-)": swarm.social,
                "Inertia w (-)": swarm.inertia,
                "Boundary handling": swarm.boundary,
            }
        ]
    )


def summary(solution: Solution) -> pd.DataFrame:
    """Tabulate the line as a whole, in one row."""
    words = {
        "Title": solution.title,
        "Method": solution.method,
        "Regime": solution.regime,
    }
    if solution.found is not None:
        words["Condition"] = solution.found.condition
    values = columns((*found(solution), *results(solution), *residuals(solution)))
    if solution.found is not None:
        values["Residual of the condition, relative (-)"] = solution.found.residual
    return pd.DataFrame([{**words, **values, "Warnings": "; ".join(solution.warnings)}])


def segments(solution: Solution) -> pd.DataFrame:
    """Tabulate the segments under load, a row each from the anchor to the fairlead."""
    parts = solution.segments
    tensions = [segment.max_tension for segment in parts]
    factor = solution.safety_factor
    return pd.DataFrame(
        {
            "Segment": range(1, len(parts) + 1),
            "Name": [segment.name for segment in parts],
            **column("length", (segment.length for segment in parts)),
            **column(_LARGEST, tensions),
            **column(in_tonne_force(_LARGEST), tensions),
            **column("MBL", (segment.MBL for segment in parts)),
            **column("safety_factor", [factor] * len(parts)),
            **column("utilisation", (segment.utilisation(factor) for segment in parts)),
        }
    )


def point_loads(solution: Solution) -> pd.DataFrame:
    """Tabulate clump weights and buoys under load, a row each by position."""
    parts = solution.point_loads
    return pd.DataFrame(
        {
            "Point load": range(1, len(parts) + 1),
            "Name": [load.name for load in parts],
            **column("position", (load.position for load in parts)),
            **column("x", (load.x for load in parts)),
            **column("z", (load.z for load in parts)),
            **column("seabed_reaction", (load.seabed_reaction for load in parts)),
        }
    )


def profile(solution: Solution, points: int = 101) -> pd.DataFrame:
    """Tabulate the shape and the tension along the line, from the anchor to the fairlead.

    Parameters
    ----------
    solution : Solution
        The answer.
    points : int
        About how many rows.
    """
    shape = solution.profile(points)
    return pd.DataFrame(
        {
            **column("s", shape.s),
            **column("x", shape.x),
            **column("z", shape.z),
            **column("tension", shape.tension),
        }
    )


def curve_points(result: CaseCurve) -> pd.DataFrame:
    """Tabulate a load curve, a row each point by rising span."""
    laid: dict[str, Any] = {}
    for quantity, values in at_points(result):
        laid |= column(quantity, values)
    return pd.DataFrame({**laid, "Regime": result.curve.regime})


def curve_marks(result: CaseCurve) -> pd.DataFrame:
    """Tabulate where something changes along a load curve, a row each by rising span."""
    marks = result.curve.marks
    laid: dict[str, Any] = {
        "Kind": [mark.kind for mark in marks],
        "What happens": [mark.event for mark in marks],
    }
    for quantity, values in at_marks(result):
        laid |= column(quantity, values)
    return pd.DataFrame(laid)


def swarm_runs(swarm: SwarmReport) -> pd.DataFrame:
    """Tabulate the runs of the swarm: where each ended, and after how many iterations."""
    numbers = range(1, len(swarm.objectives) + 1)
    return pd.DataFrame(
        {
            "Run": numbers,
            **column("objective", swarm.objectives),
            "Iterations flown": swarm.iterations_flown or [swarm.iterations] * len(numbers),
            "Best run": ["yes" if number == swarm.best_run else "" for number in numbers],
        }
    )


def swarm_history(swarm: SwarmReport) -> pd.DataFrame:
    """Tabulate the best run: objective and tension after each iteration."""
    tensions = swarm.tension_history
    return pd.DataFrame(
        {
            "Iteration": range(1, len(tensions) + 1),
            **column(named("objective", "Best objective"), swarm.best_objective_history),
            **column(_FAIRLEAD, tensions),
            **column(in_tonne_force(_FAIRLEAD), tensions),
        }
    )


def reproduction(result: Reproduction) -> pd.DataFrame:
    """Tabulate printed numbers beside computed ones; a unit column, for each row has its own."""
    headings = {
        "source": "Source",
        "name": "Name",
        "quantity": "Quantity",
        "method": "Method",
        "unit": "Unit",
        "published_text": "Printed (unit of the row)",
        "computed_text": "Computed, rounded as printed (unit of the row)",
        "computed": "Computed (unit of the row)",
        "computed_by": "Computed by",
        "verdict": "Verdict",
        "note": "Note",
    }
    rows = [item.to_dict() for item in result.items]
    return pd.DataFrame(rows, columns=list(headings)).rename(columns=headings)


def column(quantity: Quantity | str, values: Iterable[float | None]) -> dict[str, pd.Series[float]]:
    """Give values in SI the heading and the unit of a quantity; what is not known stays empty."""
    known = QUANTITIES[quantity] if isinstance(quantity, str) else quantity
    in_field = [math.nan if value is None else known.to_field(value) for value in values]
    return {known.heading: pd.Series(in_field, dtype="float64")}
