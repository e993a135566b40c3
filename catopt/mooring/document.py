"""The documents of a moored body: its equilibrium, and what else was asked of it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from catopt.mooring.case import SystemReport
    from catopt.mooring.held import HeldBody, NetworkAtRest
    from catopt.mooring.response import Response
    from catopt.mooring.restoring import RestoringCurve
    from catopt.mooring.solution import LegState, Position, SystemSolution


def system_document(solution: SystemSolution) -> dict[str, Any]:
    """Build the document of a moored body, schema catopt.system/1; all in SI."""
    system = solution.system
    return {
        "schema": "catopt.system/1",
        "title": solution.title,
        "method": "closed-form",
        "status": "converged",
        "force_N": list(system.force),
        "moment_Nm": system.moment,
        "yaw_is_free": system.turns,
        "position": _position(solution.position),
        "zero_load_position": _position(solution.neutral),
        "offset_m": list(solution.offset),
        "lines": [_line(index, line, solution) for index, line in enumerate(solution.lines)],
        "most_loaded_line": solution.most_loaded + 1,
        "stiffness_N_per_m": [list(row) for row in solution.stiffness],
        "stiffness_with_yaw": (
            [list(row) for row in solution.full_stiffness] if system.turns else None
        ),
        "residual_N": solution.residual.force,
        "residual_moment_Nm": solution.residual.moment if system.turns else None,
        "warnings": list(solution.warnings),
    }


def _position(position: Position) -> dict[str, float]:
    return {"x_m": position.x, "y_m": position.y, "yaw_rad": position.yaw}


def _line(index: int, line: LegState, solution: SystemSolution) -> dict[str, Any]:
    own = line.solution
    return {
        "line": index + 1,
        "name": line.leg.name,
        "azimuth_rad": line.leg.azimuth,
        "direction_rad": line.direction,
        "horizontal_force_N": line.horizontal_force,
        "fairlead_tension_N": line.tension,
        "fairlead_vertical_force_N": own.fairlead.vertical_force,
        "anchor_tension_N": own.anchor.tension,
        "anchor_horizontal_force_N": own.anchor.horizontal_force,
        "anchor_vertical_force_N": own.anchor.vertical_force,
        "span_m": own.span,
        "grounded_length_m": own.grounded_length,
        "utilisation": line.utilisation(solution.safety_factor),
    }


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
    if report.held:
        document["held_body"] = [_held(each) for each in report.held]
    return document


def _held(body: HeldBody) -> dict[str, Any]:
    return {
        "displacement": list(body.displacement),
        "origin_height_m": body.origin_height,
        "load": list(body.load),
        "stiffness": [list(row) for row in body.stiffness],
        "lines": [
            {
                "fairlead_m": list(line.fairlead),
                "span_m": line.span,
                "horizontal_force_N": line.horizontal_force,
                "vertical_force_N": line.vertical_force,
                "grounded_length_m": line.grounded,
            }
            for line in body.lines
        ],
    }


def network_document(states: Sequence[NetworkAtRest]) -> dict[str, Any]:
    """Build the document of lines that meet in joints, schema catopt.network/1; all in SI."""
    return {
        "schema": "catopt.network/1",
        "title": states[0].network.title,
        "status": "converged",
        "states": [_network(each) for each in states],
    }


def _network(state: NetworkAtRest) -> dict[str, Any]:
    points, found = state.network.points, state.joints
    return {
        "displacement": list(state.body.displacement),
        "points": [
            {"name": point.name, "kind": point.kind, "place_m": list(place), "bed_reaction_N": up}
            for point, place, up in zip(points, found.places, found.reactions, strict=True)
        ],
        "lines": [
            {
                "name": run.name,
                "from": points[run.first].name,
                "to": points[run.second].name,
                "span_m": line.span,
                "horizontal_force_N": line.horizontal_force,
                "from_tension_N": line.anchor.tension,
                "to_tension_N": line.fairlead.tension,
                "grounded_length_m": line.grounded_length,
            }
            for run, line in zip(state.runs, state.lines, strict=True)
        ],
        "load": list(state.body.load),
        "stiffness": [list(row) for row in state.body.stiffness],
        "residual_N": found.residual,
        "steps": found.steps,
    }


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
