"""The document that ``catopt system --json`` prints."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
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
