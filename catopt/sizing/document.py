"""The answer of a sizing as the JSON document catopt.size/1."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from catopt.documents import figures
from catopt.loads.document import loads_document
from catopt.units import Dimension

if TYPE_CHECKING:
    from catopt.loads.sinker import SinkerSize
    from catopt.sizing.alternatives import Alternative, Candidate
    from catopt.sizing.known import ReadInput
    from catopt.sizing.pattern import PatternState
    from catopt.sizing.posed import LoadsAt
    from catopt.sizing.result import Sizing


def sizing_document(of: Sizing) -> dict[str, Any]:
    """Lay a sizing out for JSON, in SI."""
    settled, point, line = of.settled, of.point, of.point.line
    segment, governing, pattern = line.segments[0], point.governing, of.pattern
    other, drag = of.other_sinker, of.drag_anchor
    return {
        "schema": "catopt.size/1",
        "kind": of.kind,
        "title": of.case.title,
        "one_line": of.one_line,
        "inputs": [_input(each) for each in of.inputs],
        "chain": {
            **figures(segment, "component nominal_diameter_m"),
            "length_m": line.length,
            "shots": of.shots,
            "mass_kg": line.mass,
            "cost_USD": of.cost,
            **figures(segment, "MBL_N proof_load_N"),
        },
        "clump_weights": [figures(load, "mass_kg position_m") for load in line.point_loads],
        "sinker": None if of.sinker is None else _sinker(of.sinker, of),
        "other_sinker": None
        if other is None
        else figures(other, "mass_kg needed_mass_kg friction") | {"rule": of.other_rule},
        "drag_anchor": None
        if drag is None
        else figures(drag, "anchor soil mass_kg needed_mass_kg")
        | {
            "smaller_mass_kg": drag.smaller,
            "larger_mass_kg": drag.larger,
            "holding_capacity_N": drag.capacity.capacity,
            "capacity_note": drag.capacity.note,
            "wanted_factor": drag.safety_factor,
            "factor": drag.factor,
        },
        "swing_radius": {
            **figures(of.swing, "total_m load_case"),
            "parts": [{"name": name, "length_m": length} for name, length in of.swing.parts],
        },
        **figures(of, "excursion_m largest_tension_N dynamic_factor"),
        "motion": of.motion,
        "in_motion": None if of.in_motion is None else of.in_motion.to_dict(),
        **figures(of, "practice chain_life_s"),
        "departures": list(of.departures),
        "fittings": list(of.fittings),
        "advice": list(of.advice),
        **figures(of, "break_factor proof_factor reserve_buoyancy_N"),
        "load_cases": [_load_case(index, of) for index in range(len(point.checks.solutions))],
        "loads": [_loads(each) for each in settled.posed.loads],
        "assumed": {
            "nominal_diameter_m": settled.assumed.diameter,
            "pull_N": settled.assumed.pull,
            "line_forces_N": list(settled.assumed.forces),
            "rounds": settled.rounds,
        },
        "checks": [check.to_dict() for check in point.checks.results],
        "governing": "" if governing is None else governing.in_case,
        "limits": [{"change": each.change, "fails": each.words} for each in of.limits],
        "alternatives": [_alternative(each, of) for each in of.alternatives],
        "candidates": [_candidate(each) for each in of.candidates],
        "pattern": None
        if pattern is None
        else figures(pattern, "lines pretension_N anchor_radius_m")
        | {"states": [_state(each) for each in pattern.states]},
        "design": {
            **figures(settled.result, "designs feasible"),
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


def _load_case(index: int, of: Sizing) -> dict[str, Any]:
    name, solution = of.point.checks.solutions[index]
    state = next(each for each in of.case.load_cases if each.name == name)
    return {
        **figures(state, "name kind state water_level_m"),
        **figures(solution, "horizontal_force_N fairlead_height_m"),
        **figures(solution.fairlead, "tension_N vertical_force_N"),
        "anchor_horizontal_force_N": solution.anchor.horizontal_force,
        "anchor_vertical_force_N": solution.anchor.vertical_force,
        **figures(solution, "span_m grounded_length_m"),
    }


def _loads(of: LoadsAt) -> dict[str, Any]:
    return {
        **figures(of, "load_case depth_m horizontal_force_N given_N"),
        "heading": None if of.lying is None else of.lying.to_dict(),
        "parts": [loads_document(part) for part in of.parts],
    }


def _sinker(of: SinkerSize, sizing: Sizing) -> dict[str, Any]:
    anchor, source = sizing.point.anchor, of.friction_source
    return {
        "mass_kg": of.mass if anchor is None else anchor.mass,
        "needed_mass_kg": of.needed_mass,
        "smaller_mass_kg": of.smaller,
        "larger_mass_kg": of.larger,
        **figures(of, "material density_kg_per_m3 submerged_weight_N friction"),
        "friction_source": None if source is None else source.text,
        "wanted_factor": of.safety_factor,
        "factor": of.factor,
    }


def _candidate(of: Candidate) -> dict[str, Any]:
    document: dict[str, Any] = {
        **figures(of, "role component"),
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
    line = None if of.settled is None else of.settled.point.line
    segment = None if line is None else line.segments[0]
    return {
        "prefer": of.prefer,
        "feasible": line is not None,
        "component": segment and segment.component,
        "nominal_diameter_m": segment and segment.nominal_diameter,
        "length_m": line and line.length,
        "mass_kg": line and of.mass,
        "cost_USD": of.cost,
        "swing_radius_m": line and of.swing,
        "trade": line and sizing.trade(of),
        "reason": of.reason,
    }


def _state(of: PatternState) -> dict[str, Any]:
    out = "direction_rad line_force_N tension_N offset_m pull_N"
    return {
        **figures(of, "load_case force_N rule_force_N line_force_N tension_N direction_rad"),
        **figures(of, "offset_m pull_N"),
        "one_line_out": {"missing_line": of.line_out.missing, **figures(of.line_out, out)},
    }
