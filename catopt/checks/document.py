"""A report of checks as the JSON document catopt.check/1."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from catopt.catenary.solution import Solution
    from catopt.checks.result import CheckReport, CheckResult
    from catopt.model import LoadCase

__all__ = ["check_document", "result_document"]


def check_document(report: CheckReport) -> dict[str, Any]:
    """Build the document of a report."""
    governing = report.governing
    return {
        "schema": "catopt.check/1",
        "title": report.title,
        "passes": report.passes,
        "governing": None if governing is None else report.results.index(governing),
        "load_cases": [
            _load_case(name, solution, report.load_cases[index] if report.load_cases else None)
            for index, (name, solution) in enumerate(report.solutions)
        ],
        "checks": [result_document(result) for result in report.results],
        "warnings": list(report.warnings),
    }


def result_document(result: CheckResult) -> dict[str, Any]:
    """Lay one check out, in SI."""
    return {
        "name": result.name,
        "kind": result.kind,
        "load_case": result.load_case,
        "demand": result.demand,
        "capacity": result.capacity,
        "unit": result.unit,
        "utilisation": result.utilisation,
        "excess": result.excess,
        "passes": result.passes,
        "source": result.source.text,
        "code": result.source.code,
        "confidence": result.source.confidence,
        "note": result.note,
    }


def _load_case(name: str, solution: Solution, state: LoadCase | None) -> dict[str, Any]:
    return {
        "name": name,
        "kind": "extreme" if state is None else state.kind,
        "water_level_m": 0.0 if state is None else state.water_level,
        "horizontal_force_N": solution.horizontal_force,
        "fairlead_height_m": solution.fairlead_height,
        "span_m": solution.span,
        "fairlead_tension_N": solution.fairlead.tension,
        "anchor_horizontal_force_N": solution.anchor.horizontal_force,
        "anchor_vertical_force_N": solution.anchor.vertical_force,
        "anchor_angle_rad": solution.anchor.angle,
        "grounded_length_m": solution.grounded_length,
    }
