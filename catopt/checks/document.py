"""A report of checks as the JSON document catopt.check/1."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from catopt.catenary.solution import Solution
    from catopt.checks.result import CheckReport, CheckResult
    from catopt.checks.state import Place
    from catopt.model import LoadCase


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
            | (_place(report.places[index]) if report.places else {})
            for index, (name, solution) in enumerate(report.solutions)
        ],
        "checks": [
            result_document(result) | (_place(result.place) if report.places else {})
            for result in report.results
        ],
        "warnings": list(report.warnings),
    }


def verdict_document(report: CheckReport) -> dict[str, Any]:
    """Build the verdict of a body as ``catopt system --json`` has it."""
    found = report.governing
    return {
        "checks": len(report.results),
        "failed": len(report.failed),
        "passes": report.passes,
        "governing": None if found is None else result_document(found) | _place(found.place),
        "warnings": list(report.warnings),
    }


def motion_document(report: CheckReport) -> dict[str, Any]:
    """Build the checks of lines in motion as ``catopt verify --dynamic --json`` has them."""
    governing = report.governing
    return {
        "passes": report.verdict,
        "governing": None if governing is None else report.results.index(governing),
        "checks": [result_document(each) | _place(each.place) for each in report.results],
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


def _place(place: Place) -> dict[str, Any]:
    return {"state": place.state, "line": place.line, "missing_line": place.missing}


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
