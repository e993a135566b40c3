"""The answer of a sizing as the JSON document catopt.size/1."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from catopt.loads.document import loads_document, lying_document
from catopt.units import Dimension

if TYPE_CHECKING:
    from catopt.catenary.solution import Solution
    from catopt.loads.drag_anchor import DragAnchorSize
    from catopt.loads.sinker import SinkerSize
    from catopt.sizing.alternatives import Alternative, Candidate
    from catopt.sizing.pattern import Pattern
    from catopt.sizing.posed import LoadsAt
    from catopt.sizing.read_input import ReadInput
    from catopt.sizing.result import Sizing

SCHEMA = "catopt.size/1"


def sizing_document(of: Sizing) -> dict[str, Any]:
    """Lay a sizing out for JSON, in SI."""
    segment = of.point.line.segments[0]
    governing = of.point.governing
    settled = of.settled
    return {
        "schema": SCHEMA,
        "kind": of.kind,
        "title": of.case.title,
        "inputs": [_input(each) for each in of.inputs],
        "chain": {
            "component": segment.component,
            "nominal_diameter_m": segment.nominal_diameter,
            "length_m": of.point.line.length,
            "shots": of.shots,
            "mass_kg": of.point.line.mass,
            "cost_USD": of.cost,
            "MBL_N": segment.MBL,
            "proof_load_N": segment.proof_load,
        },
        "clump_weights": [
            {"mass_kg": load.mass, "position_m": load.position}
            for load in of.point.line.point_loads
        ],
        "sinker": None if of.sinker is None else _sinker(of.sinker, of),
        "other_sinker": None
        if of.other_sinker is None
        else _other_sinker(of.other_sinker, of.other_rule),
        "drag_anchor": None if of.drag_anchor is None else _drag_anchor(of.drag_anchor),
        "swing_radius": {
            "total_m": of.swing.total,
            "load_case": of.swing.load_case,
            "parts": [{"name": name, "length_m": length} for name, length in of.swing.parts],
        },
        "excursion_m": of.excursion,
        "largest_tension_N": of.largest_tension,
        "dynamic_factor": of.dynamic_factor,
        "utilisation_in_motion": {key: of.in_motion.get(key) for key in ("tension", "holding")},
        "break_factor": of.break_factor,
        "proof_factor": of.proof_factor,
        "reserve_buoyancy_N": of.reserve_buoyancy,
        "load_cases": [_load_case(name, solution, of) for name, solution in _solutions(of)],
        "loads": [_loads(each) for each in settled.posed.loads],
        "assumed": {
            "nominal_diameter_m": settled.assumed.diameter,
            "pull_N": settled.assumed.pull,
            "line_forces_N": list(settled.assumed.forces),
            "rounds": settled.rounds,
        },
        "checks": [check.to_dict() for check in of.point.checks.results],
        "governing": "" if governing is None else governing.in_case,
        "limits": [{"change": each.change, "fails": each.words} for each in of.limits],
        "alternatives": [_alternative(each, of) for each in of.alternatives],
        "candidates": [_candidate(each) for each in of.candidates],
        "pattern": None if of.pattern is None else _pattern(of.pattern),
        "design": {
            "designs": settled.result.designs,
            "feasible": settled.result.feasible,
            "front": len(settled.result.front),
            "recommended": settled.index + 1,
            "recommendation": of.why,
        },
        "assumptions": list(of.assumptions),
        "defaults": list(of.defaults),
        "recalled": list(of.recalled),
        "warnings": list(of.warnings),
    }


def _input(of: ReadInput) -> dict[str, Any]:
    value = list(of.value) if isinstance(of.value, tuple) else of.value
    unit = Dimension[of.of.takes].si_unit if of.of.is_measure else ""
    return {"name": of.of.name, "value": value, "unit": unit, "origin": of.origin}


def _solutions(of: Sizing) -> tuple[tuple[str, Solution], ...]:
    return of.point.checks.solutions


def _load_case(name: str, solution: Solution, of: Sizing) -> dict[str, Any]:
    state = next(each for each in of.case.load_cases if each.name == name)
    return {
        "name": name,
        "kind": state.kind,
        "state": state.state,
        "water_level_m": state.water_level,
        "horizontal_force_N": solution.horizontal_force,
        "fairlead_height_m": solution.fairlead_height,
        "tension_N": solution.fairlead.tension,
        "vertical_force_N": solution.fairlead.vertical_force,
        "anchor_horizontal_force_N": solution.anchor.horizontal_force,
        "anchor_vertical_force_N": solution.anchor.vertical_force,
        "span_m": solution.span,
        "grounded_length_m": solution.grounded_length,
    }


def _loads(of: LoadsAt) -> dict[str, Any]:
    return {
        "load_case": of.load_case,
        "depth_m": of.depth,
        "horizontal_force_N": of.horizontal_force,
        "given_N": of.given,
        "heading": None if of.lying is None else lying_document(of.lying),
        "parts": [loads_document(part) for part in of.parts],
    }


def _sinker(of: SinkerSize, sizing: Sizing) -> dict[str, Any]:
    anchor = sizing.point.anchor
    source = of.friction_source
    return {
        "mass_kg": of.mass if anchor is None else anchor.mass,
        "needed_mass_kg": of.needed_mass,
        "smaller_mass_kg": of.smaller,
        "larger_mass_kg": of.larger,
        "material": of.material,
        "density_kg_per_m3": of.density,
        "submerged_weight_N": of.submerged_weight,
        "friction": of.friction,
        "friction_source": None if source is None else source.text,
        "wanted_factor": of.safety_factor,
        "factor": of.factor,
    }


def _other_sinker(of: SinkerSize, rule: str) -> dict[str, Any]:
    return {
        "mass_kg": of.mass,
        "needed_mass_kg": of.needed_mass,
        "friction": of.friction,
        "rule": rule,
    }


def _drag_anchor(of: DragAnchorSize) -> dict[str, Any]:
    return {
        "anchor": of.anchor,
        "soil": of.soil,
        "mass_kg": of.mass,
        "needed_mass_kg": of.needed_mass,
        "smaller_mass_kg": of.smaller,
        "larger_mass_kg": of.larger,
        "holding_capacity_N": of.capacity.capacity,
        "capacity_note": of.capacity.note,
        "wanted_factor": of.safety_factor,
        "factor": of.factor,
    }


def _candidate(of: Candidate) -> dict[str, Any]:
    document: dict[str, Any] = {
        "role": of.role,
        "component": of.component,
        "nominal_diameter_m": of.diameter,
        "feasible": of.settled is not None,
        "reason": of.reason,
    }
    keys = ("length_m", "mass_kg", "offset_m", "horizontal_force_N", "anchor_mass_kg", "governing")
    if of.settled is None:
        return document | dict.fromkeys(keys)
    point = of.settled.point
    governing = point.governing
    values = (
        point.line.length,
        point.line.mass,
        point.objectives["offset_m"],
        max(solution.horizontal_force for _, solution in point.checks.solutions),
        None if point.anchor is None else point.anchor.mass,
        "" if governing is None else governing.in_case,
    )
    return document | dict(zip(keys, values, strict=True))


def _alternative(of: Alternative, sizing: Sizing) -> dict[str, Any]:
    document: dict[str, Any] = {"prefer": of.prefer, "feasible": of.settled is not None}
    if of.settled is None:
        keys = ("component", "nominal_diameter_m", "length_m", "mass_kg", "cost_USD",
                "swing_radius_m", "trade")  # fmt: skip
        return document | dict.fromkeys(keys) | {"reason": of.reason}
    line = of.settled.point.line
    return document | {
        "component": line.segments[0].component,
        "nominal_diameter_m": line.segments[0].nominal_diameter,
        "length_m": line.length,
        "mass_kg": of.mass,
        "cost_USD": of.cost,
        "swing_radius_m": of.swing,
        "trade": sizing.trade(of),
        "reason": "",
    }


def _pattern(of: Pattern) -> dict[str, Any]:
    return {
        "lines": of.lines,
        "pretension_N": of.pretension,
        "anchor_radius_m": of.anchor_radius,
        "states": [
            {
                "load_case": state.load_case,
                "force_N": state.force,
                "rule_force_N": state.rule_force,
                "line_force_N": state.line_force,
                "tension_N": state.tension,
                "direction_rad": state.direction,
                "offset_m": state.offset,
                "pull_N": state.pull,
                "one_line_out": {
                    "missing_line": state.line_out.missing,
                    "direction_rad": state.line_out.direction,
                    "line_force_N": state.line_out.line_force,
                    "tension_N": state.line_out.tension,
                    "offset_m": state.line_out.offset,
                    "pull_N": state.line_out.pull,
                },
            }
            for state in of.states
        ],
    }
