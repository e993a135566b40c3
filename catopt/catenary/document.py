"""A solution as the JSON document catopt.solution/1."""

from __future__ import annotations

from dataclasses import asdict
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from catopt.catenary.solution import EndState, Solution


def solution_document(solution: Solution, *, with_profile: bool = False) -> dict[str, Any]:
    """Build the document."""
    document: dict[str, Any] = {
        "schema": "catopt.solution/1",
        "title": solution.title,
        "method": solution.method,
        "status": "converged",
        "regime": solution.regime,
        "horizontal_force_N": solution.horizontal_force,
        "span_m": solution.span,
        "fairlead_height_m": solution.fairlead_height,
        "anchor_height_m": solution.anchor_height,
        "seabed_friction": solution.seabed_friction,
        "fairlead": _end(solution.fairlead),
        "anchor": _end(solution.anchor),
        "grounded_length_m": solution.grounded_length,
        "suspended_length_m": solution.suspended_length,
        "stretched_length_m": solution.stretched_length,
        "line_mass_kg": solution.line.mass,
        "safety_factor": solution.safety_factor,
        "segments": [
            {
                "name": segment.name,
                "length_m": segment.length,
                "max_tension_N": segment.max_tension,
                "utilisation": segment.utilisation(solution.safety_factor),
            }
            for segment in solution.segments
        ],
        "point_loads": [
            {
                "name": load.name,
                "position_m": load.position,
                "x_m": load.x,
                "z_m": load.z,
                "seabed_reaction_N": load.seabed_reaction,
            }
            for load in solution.point_loads
        ],
        "residual": {
            "height_m": solution.residual.height,
            "span_m": solution.residual.span,
            "force_uncertainty_N": solution.residual.force_uncertainty,
        },
        "warnings": list(solution.warnings),
    }
    if solution.found is not None:
        document["found"] = asdict(solution.found) | {"unit": solution.found.unit}
    if solution.swarm is not None:
        document["pso"] = _swarm(solution)
    if with_profile:
        profile = solution.profile()
        document["profile"] = {
            "s_m": list(profile.s),
            "x_m": list(profile.x),
            "z_m": list(profile.z),
            "tension_N": list(profile.tension),
        }
    return document


def _end(state: EndState) -> dict[str, float]:
    return {
        "tension_N": state.tension,
        "horizontal_force_N": state.horizontal_force,
        "vertical_force_N": state.vertical_force,
        "angle_rad": state.angle,
    }


def _swarm(solution: Solution) -> dict[str, Any]:
    assert solution.swarm is not None
    keys = ("objective", "evaluations", "iterations", "runs", "seed", "converged_runs", "best_run")
    report = asdict(solution.swarm)
    return {
        **{key: report[key] for key in keys},
        "span_consistency_m": solution.swarm.span_consistency,
        "closed_form_difference": dict(solution.swarm.closed_form_difference),
    }
