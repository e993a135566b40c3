"""The answer of a design search as pandas tables; every heading carries its unit."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import pandas as pd

from catopt.quantities import QUANTITIES
from catopt.report.tables.checks import check_rows_in_si
from catopt.report.tables.solution import column
from catopt.report.wording.design import (
    CHECK_KINDS,
    anchor_words,
    check_kinds,
    clump_weight_words,
    governing_words,
    objective_quantities,
    segment_words,
    tightest,
    verdict,
)

if TYPE_CHECKING:
    from catopt.design.result import DesignPoint, DesignResult

__all__ = ["components", "design_checks", "front", "neighbours", "search_summary"]


def front(result: DesignResult) -> pd.DataFrame:
    """Tabulate the front, a row each design by its number, with the tightest check of each kind."""
    points = result.front
    laid: dict[str, Any] = {
        "Design": range(1, len(points) + 1),
        "Recommended": [_yes(index == result.recommended) for index in range(len(points))],
    }
    for key, quantity in objective_quantities(result):
        laid |= column(quantity, (point.objectives[key] for point in points))
    laid["Segments, from the anchor"] = ["; ".join(segment_words(p.line)) for p in points]
    laid["Clump weights (mass in air)"] = ["; ".join(clump_weight_words(p.line)) for p in points]
    laid["Anchor"] = [anchor_words(point) for point in points]
    for kind in check_kinds(point.checks for point in points):
        heading = f"{CHECK_KINDS[kind]} utilisation (-)"
        laid[heading] = [_utilisation(point, kind) for point in points]
    laid["Governing check (load case)"] = [governing_words(point.governing) for point in points]
    return pd.DataFrame(laid)


def components(result: DesignResult) -> pd.DataFrame:
    """Tabulate the segments of every design, a row each from the anchor to the fairlead."""
    rows = [
        (number, place, segment)
        for number, point in enumerate(result.front, start=1)
        for place, segment in enumerate(point.line.segments, start=1)
    ]
    segments = [segment for _, _, segment in rows]
    return pd.DataFrame(
        {
            "Design": [number for number, _, _ in rows],
            "Segment": [place for _, place, _ in rows],
            "Component": [segment.component or segment.name for segment in segments],
            **column(QUANTITIES["nominal_diameter"], (s.nominal_diameter for s in segments)),
            **column(QUANTITIES["length"], (s.length for s in segments)),
            **column(QUANTITIES["submerged_weight"], (s.submerged_weight for s in segments)),
            **column(QUANTITIES["mass_per_length"], (s.mass for s in segments)),
            **column(QUANTITIES["EA"], (s.EA for s in segments)),
            **column(QUANTITIES["MBL"], (s.MBL for s in segments)),
            **column(QUANTITIES["proof_load"], (s.proof_load for s in segments)),
            **column(QUANTITIES["price"], (s.price for s in segments)),
        }
    )


def design_checks(result: DesignResult) -> pd.DataFrame:
    """Tabulate every check of every design, a row each, in SI."""
    rows = [
        {"Design": number, **row}
        for number, point in enumerate(result.front, start=1)
        for row in check_rows_in_si(point.checks.results)
    ]
    return pd.DataFrame(rows)


def neighbours(result: DesignResult) -> pd.DataFrame:
    """Tabulate what one step of each variable would do to the recommended design.

    The last row is the line in the case file.
    """
    steps = (*result.neighbours, result.present)
    laid: dict[str, Any] = {"Change to the recommended design": [step.change for step in steps]}
    for key, quantity in objective_quantities(result):
        values = (None if s.point is None else s.point.objectives.get(key) for s in steps)
        laid |= column(quantity, values)
    laid["Verdict"] = [verdict(step) for step in steps]
    return pd.DataFrame(laid)


def search_summary(result: DesignResult) -> pd.DataFrame:
    """Tabulate how the front was found, in one row."""
    return pd.DataFrame(
        [
            {
                "Title": result.case.title,
                "Method": result.method,
                "Exact front": _yes(result.is_exact) or "no",
                "Designs in the space": result.designs,
                "Designs evaluated": result.evaluations,
                "Of these feasible": result.feasible,
                "Designs on the front": len(result.front),
                "Recommended design": result.recommended + 1,
                "Why": result.recommendation,
                "Ends of the front": "; ".join(result.ends),
                "Hypervolume (product of the objectives' SI units)": result.hypervolume,
                "Reference point (SI units)": ", ".join(f"{x:.6g}" for x in result.reference_point),
                "Seed": result.seed,
                "Interrupted": _yes(result.interrupted) or "no",
                "Warnings": "; ".join(result.warnings),
            }
        ]
    )


def _utilisation(point: DesignPoint, kind: str) -> float:
    check = tightest(point.checks, kind)
    use = None if check is None else check.utilisation
    return math.nan if use is None else use


def _yes(value: bool) -> str:
    return "yes" if value else ""
