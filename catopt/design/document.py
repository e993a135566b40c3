"""The answer of a design search as the JSON document catopt.design/1."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from catopt.design.mooring_point import under
from catopt.documents import figures
from catopt.model.design import loads_of
from catopt.words.saved import messages_in

if TYPE_CHECKING:
    from catopt.design.result import DesignPoint, DesignResult, Neighbour


def design_document(result: DesignResult) -> dict[str, Any]:
    """Build the document that ``catopt design --json`` prints."""
    document: dict[str, Any] = {
        "schema": "catopt.design/1",
        "title": result.case.title,
        "objectives": list(result.objectives),
        "load_cases": _load_cases(result),
        "front": [_point(point) for point in result.front],
        "recommended": result.recommended - 1,  # an index, as documents have it
        "recommendation": result.recommendation,
        "ends": list(result.ends),
        "neighbours": [_neighbour(each, result) for each in result.neighbours],
        "present": _neighbour(result.present, result),
        **figures(result, "method is_exact designs evaluations feasible hypervolume"),
        "reference_point": list(result.reference_point),
        **figures(result, "seed interrupted"),
        "warnings": list(result.warnings),
    }
    if result.excluded:
        document["excluded"] = dict(result.excluded)
    front = [{"governing": point["governing"]} for point in document["front"]]
    return document | {"messages": messages_in(document | {"front": front})}


def _load_cases(result: DesignResult) -> list[dict[str, Any]]:
    system, design = result.case.system, result.case.design
    if system is not None and design is not None:
        return [
            {
                "name": under(load, angle),
                "kind": "extreme",
                "water_level_m": load.water_level,
                "horizontal_force_N": load.force,
                "direction_rad": angle,
                "fairlead_height_m": result.case.fairlead_height + load.lift,
                "line_out": load.line_out,
            }
            for load in loads_of(design, system)
            for angle in load.directions
        ]
    kinds = {state.name: (state.kind, state.water_level) for state in result.case.load_cases}
    documents = []
    for name, solution in result.front[0].checks.solutions:
        kind, level = kinds.get(name, ("extreme", 0.0))
        document = {"name": name, "kind": kind, "water_level_m": level}
        documents.append(document | figures(solution, "horizontal_force_N fairlead_height_m"))
    return documents


def _point(point: DesignPoint) -> dict[str, Any]:
    governing, mooring = point.governing, point.mooring
    solutions = () if mooring else point.checks.solutions
    document: dict[str, Any] = {
        "mass_kg": point.line.mass,
        **point.objectives,
        "segments": [
            {
                "name": segment.name,
                "component": segment.component or None,
                **figures(segment, "nominal_diameter_m length_m submerged_weight_N_per_m"),
                **figures(segment, "mass_kg_per_m"),
                "EA_N": segment.EA if math.isfinite(segment.EA) else None,
                **figures(
                    segment, "MBL_N proof_load_N price_USD_per_m wear_rate_m_per_s wear_zone"
                ),
            }
            for segment in point.line.segments
        ],
        "point_loads": [
            figures(load, "name position_m submerged_weight_N mass_kg")
            for load in point.line.point_loads
        ],
        "sinker": None,
        "checks": [check.to_dict() for check in point.checks.results],
        "governing": "" if governing is None else governing.in_case,
        "feasible": point.checks.passes,
        "spans_m": [solution.span for _, solution in solutions],
        "genes": list(point.genes),
    }
    if point.anchor is not None and point.anchor.kind == "sinker":
        keys = "mass_kg submerged_weight_N friction safety_factor"
        document["sinker"] = figures(point.anchor, keys)
    if mooring is not None:
        legs = mooring.system.legs
        document["system"] = {
            "azimuths_rad": [leg.azimuth for leg in legs],
            "anchor_radius_m": legs[0].anchor_radius,
            **({} if mooring.pretension is None else {"pretension_N": mooring.pretension}),
            "farthest_state": mooring.state,
            "farthest_force_N": list(mooring.farthest.system.force),
            "farthest_water_level_m": mooring.load.water_level,
            "farthest_fairlead_rise_m": mooring.load.fairlead_rise,
            "farthest_line_out": mooring.load.line_out,
        }
    return document


def _neighbour(each: Neighbour, result: DesignResult) -> dict[str, Any]:
    point = each.point
    governing = None if point is None else point.governing
    values = {} if point is None else point.objectives
    return {
        "change": each.change,
        **{key: values.get(key) for key in result.front[0].objectives},
        "feasible": point is not None and point.checks.passes,
        "governing": "" if governing is None else governing.in_case,
        "utilisation": None if governing is None else governing.utilisation,
        "reason": each.reason,
    }
