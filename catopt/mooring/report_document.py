"""The document of a moored body with what else was asked of it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from catopt.mooring.case import SystemReport
    from catopt.mooring.response import Response
    from catopt.mooring.restoring import RestoringCurve


def report_document(report: SystemReport) -> dict[str, Any]:
    """Add to the document of the solution what else was asked for; all in SI, lines from 1."""
    rule = report.rule
    document = report.solution.to_dict()
    document["sharing_rule"] = {
        "applies": rule.horizontal_force is not None,
        "line": None if rule.line is None else rule.line + 1,
        "horizontal_force_N": rule.horizontal_force,
        "why_not": rule.why_not,
    }
    if report.line_out:
        document["one_line_out"] = [
            {
                "missing_line": each.missing + 1,
                "response": None if each.response is None else _response(each.response),
                "refusal": each.refusal,
            }
            for each in report.line_out
        ]
    if report.circle is not None:
        document["watch_circle"] = {
            "force_N": report.circle.force,
            "directions_rad": list(report.circle.directions),
            "responses": [_response(each) for each in report.circle.responses],
        }
    if report.curves:
        document["restoring_curves"] = [_curve(curve) for curve in report.curves]
    if report.levels:
        document["water_levels"] = [
            {
                "level_m": each.level,
                "response": _response(each.response),
                "stiffness_N_per_m": [list(row) for row in each.stiffness],
            }
            for each in report.levels
        ]
    return document


def _response(response: Response) -> dict[str, Any]:
    return {
        "x_m": response.x,
        "y_m": response.y,
        "yaw_rad": response.yaw,
        "offset_m": response.offset,
        "largest_tension_N": response.largest_tension,
        "most_loaded_line": response.most_loaded + 1,
        "largest_anchor_tension_N": response.largest_anchor_tension,
        "largest_anchor_vertical_force_N": response.largest_uplift,
        "least_grounded_length_m": response.least_grounded,
    }


def _curve(curve: RestoringCurve) -> dict[str, Any]:
    return {
        "direction_rad": curve.direction,
        "offset_m": list(curve.offset),
        "force_N": list(curve.force),
        "force_across_N": list(curve.force_across),
        "largest_tension_N": [each.largest_tension for each in curve.responses],
        "most_loaded_line": [each.most_loaded + 1 for each in curve.responses],
    }
