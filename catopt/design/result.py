"""The answer of a design search, as a value and as the JSON document catopt.design/1."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from catopt.checks.result import CheckReport, CheckResult
from catopt.design.mooring_point import MooringPoint, under
from catopt.documents import figures
from catopt.model import Anchor, Case, Line
from catopt.model.design import loads_of
from catopt.model.kinds import Height, SomeForce
from catopt.records import Counted, FromZero
from catopt.shown import Displayable
from catopt.words.saved import messages_in

__all__ = ["DesignPoint", "DesignResult", "NearMiss", "Neighbour"]


@dataclass(frozen=True, repr=False)
class DesignPoint(Displayable):
    """One line of the front."""

    # its segments and clump weights, with component and nominal diameter in each segment
    line: Line
    anchor: Anchor | None  # the sinker that was chosen for it, or the anchor of the case
    genes: tuple[int, ...]  # its place in the design space
    # ``mass_kg``, ``offset_m``, ``excursion_m``, ``cost_USD``: all that are known, wanted as
    # objective or not
    objectives: Mapping[str, float]
    # the same report that ``catopt check`` gives for this line; of a whole mooring the
    # hardest of each check over all lines, headings and states
    checks: CheckReport
    # of a whole mooring: the state that takes the body farthest
    mooring: MooringPoint | None = None

    @property
    def governing(self) -> CheckResult | None:
        """The check that is nearest to its limit."""
        return self.checks.governing

    @property
    def cost(self) -> float | None:
        """USD, of the line's material; None where a price is not known."""
        return self.objectives.get("cost_USD")

    @property
    def largest_span(self) -> Height:
        """Of all load cases."""
        return self.objectives["offset_m"]

    @property
    def largest_force(self) -> SomeForce:
        """Horizontal, on the line in any load case."""
        return max(solution.horizontal_force for _, solution in self.checks.solutions)


@dataclass(frozen=True)
class Neighbour:
    """What one step of one variable would do to a design."""

    change: str  # in words: ``"segment 1: chain studless R3 81 mm for 76 mm"``
    point: DesignPoint | None  # the changed design; None where it has no equilibrium
    reason: str = ""  # why there is none; else empty


@dataclass(frozen=True)
class NearMiss:
    """The design that misses feasibility by least, when none is feasible."""

    line: Line  # the design
    # the checks that it fails, the worst first; empty where it has no equilibrium
    failing: tuple[CheckResult, ...]
    reason: str = ""  # why there is no equilibrium; else empty


@dataclass(frozen=True, repr=False)
class DesignResult(Displayable):
    """The front and how it was found."""

    case: Case  # what was asked
    objectives: tuple[str, ...]  # keys of `DesignPoint.objectives` that were made small
    # by rising first objective; every one is feasible, none is beaten in all objectives
    front: tuple[DesignPoint, ...]
    recommended: int  # number of the recommended design, from 1 as everywhere: see `best`
    recommendation: str  # why, in words
    method: str  # ``"enumeration"``, ``"nsga2"`` or ``"swarm"``
    is_exact: bool  # whether every design of the space was evaluated, or proved needless
    designs: Counted
    """Designs that the space holds."""
    evaluations: Counted
    """Designs that were evaluated, each in all load cases."""
    feasible: FromZero
    """How many of these passed every check."""
    # of the front, in the units of the objectives multiplied, up to `reference_point`
    hypervolume: float
    reference_point: tuple[float, ...]  # the worst corner that the hypervolume is measured from
    seed: int  # of the random numbers
    interrupted: bool  # whether the search was stopped before its end
    # for each objective: which check the end of the front runs into there, in words
    ends: tuple[str, ...]
    # what one size or one step up or down would do to the recommended design
    neighbours: tuple[Neighbour, ...]
    # the line that stands in the case file, by the same checks; no part of the front
    present: Neighbour
    seconds: float  # wall time of the search
    # what an engineer should know, such as figures that were read in no document
    warnings: tuple[str, ...] = ()
    # of whole moorings: how many designs were not evaluated because a bound proves them
    # needless, by bound (`catopt.design.assess.BOUNDS`)
    excluded: Mapping[str, int] = field(default_factory=dict)

    @property
    def best(self) -> DesignPoint:
        """The recommended design: the knee of the front."""
        return self.front[self.recommended - 1]

    def to_dict(self) -> dict[str, Any]:
        """Build the document that ``catopt design --json`` prints (schema catopt.design/1)."""
        return design_document(self)


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
