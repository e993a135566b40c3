"""The answer of a design search as the JSON document catopt.design/1."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from catopt.design.mooring_point import under
from catopt.model.design import loads_of
from catopt.words.saved import messages_in

if TYPE_CHECKING:
    from catopt.design.mooring_point import MooringPoint
    from catopt.design.result import DesignPoint, DesignResult, Neighbour
    from catopt.model import Anchor, PointLoad, Segment


def design_document(result: DesignResult) -> dict[str, Any]:
    """Build the document that ``catopt design --json`` prints."""
    document: dict[str, Any] = {
        "schema": "catopt.design/1",
        "title": result.case.title,
        "objectives": list(result.objectives),
        "load_cases": _load_cases(result),
        "front": [_point(point) for point in result.front],
        "recommended": result.recommended,
        "recommendation": result.recommendation,
        "ends": list(result.ends),
        "neighbours": [_neighbour(each, result) for each in result.neighbours],
        "present": _neighbour(result.present, result),
        "method": result.method,
        "is_exact": result.is_exact,
        "designs": result.designs,
        "evaluations": result.evaluations,
        "feasible": result.feasible,
        "hypervolume": result.hypervolume,
        "reference_point": list(result.reference_point),
        "seed": result.seed,
        "interrupted": result.interrupted,
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
        documents.append(
            {
                "name": name,
                "kind": kind,
                "water_level_m": level,
                "horizontal_force_N": solution.horizontal_force,
                "fairlead_height_m": solution.fairlead_height,
            }
        )
    return documents


def _point(point: DesignPoint) -> dict[str, Any]:
    governing = point.governing
    return {
        "mass_kg": point.line.mass,
        **point.objectives,
        "segments": [_segment(segment) for segment in point.line.segments],
        "point_loads": [_point_load(load) for load in point.line.point_loads],
        "sinker": _sinker(point.anchor),
        "checks": [check.to_dict() for check in point.checks.results],
        "governing": "" if governing is None else governing.in_case,
        "feasible": point.checks.passes,
        "spans_m": []
        if point.mooring
        else [solution.span for _, solution in point.checks.solutions],
        "genes": list(point.genes),
        **({"system": _system(point.mooring)} if point.mooring else {}),
    }


def _system(mooring: MooringPoint) -> dict[str, Any]:
    """Say how many lines there are, where, and what takes the body farthest."""
    legs = mooring.system.legs
    return {
        "azimuths_rad": [leg.azimuth for leg in legs],
        "anchor_radius_m": legs[0].anchor_radius,
        **({} if mooring.pretension is None else {"pretension_N": mooring.pretension}),
        "farthest_state": mooring.state,
        "farthest_force_N": list(mooring.farthest.system.force),
        "farthest_water_level_m": mooring.load.water_level,
        "farthest_fairlead_rise_m": mooring.load.fairlead_rise,
    }


def _segment(segment: Segment) -> dict[str, Any]:
    return {
        "name": segment.name,
        "component": segment.component or None,
        "nominal_diameter_m": segment.nominal_diameter,
        "length_m": segment.length,
        "submerged_weight_N_per_m": segment.submerged_weight,
        "mass_kg_per_m": segment.mass,
        "EA_N": segment.EA if math.isfinite(segment.EA) else None,
        "MBL_N": segment.MBL,
        "proof_load_N": segment.proof_load,
        "price_USD_per_m": segment.price,
        "wear_rate_m_per_s": segment.wear_rate,
        "wear_zone": segment.wear_zone,
    }


def _point_load(load: PointLoad) -> dict[str, Any]:
    return {
        "name": load.name,
        "position_m": load.position,
        "submerged_weight_N": load.submerged_weight,
        "mass_kg": load.mass,
    }


def _sinker(anchor: Anchor | None) -> dict[str, Any] | None:
    if anchor is None or anchor.kind != "sinker":
        return None
    return {
        "mass_kg": anchor.mass,
        "submerged_weight_N": anchor.submerged_weight,
        "friction": anchor.friction,
        "safety_factor": anchor.safety_factor,
    }


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
