"""The answer of a sizing, as a value and as the JSON document catopt.size/1."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final, Literal

from catopt.catalogue.choice import chosen
from catopt.catalogue.family import chain_words
from catopt.catenary.solution import Solution
from catopt.design.result import DesignPoint
from catopt.documents import figures
from catopt.loads.buoy_shape import BuoyShape
from catopt.loads.component import CALMAR
from catopt.loads.document import loads_document
from catopt.loads.drag_anchor import DragAnchorSize
from catopt.loads.sinker import SinkerSize
from catopt.model import Case
from catopt.shown import Displayable
from catopt.sizing.alternatives import Alternative, Candidate, Limit, trade
from catopt.sizing.in_motion import InMotion
from catopt.sizing.known import ReadInput, estimated_dimensions
from catopt.sizing.pattern import Pattern, system_case
from catopt.sizing.settle import ConvergedSizing, point_diameter
from catopt.ties import largest
from catopt.units import UNITS, Dimension
from catopt.words import Cited, Measure, Message, Sentence, Several, term

if TYPE_CHECKING:
    from catopt.sizing.pattern import PatternState
    from catopt.sizing.posed import LoadsAt


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


SHOT: Final = UNITS[Dimension.LENGTH]["shot"]
"""m: a shot of chain."""


@dataclass(frozen=True)
class SwingRadius:
    """How far the floating end swings round the anchor."""

    load_case: str  # in which it is the largest
    parts: tuple[tuple[str, float], ...]  # what it is made of, with lengths, m

    @property
    def total(self) -> float:
        """Sum of the parts, m."""
        return math.fsum(length for _, length in self.parts)


@dataclass(frozen=True, repr=False)
class Sizing(Displayable):
    """A mooring sized for its place and its weather."""

    kind: Literal["buoy", "tanker"]  # of what
    settled: ConvergedSizing  # loads, case, front and the recommended design
    swing: SwingRadius  # at low water
    dynamic_factor: float  # allowance for motion on the steady forces, in all load cases
    motion: str  # where it is from, and what stands for motion
    # the recommended size between its neighbours; as the next two empty of one that was run in
    # motion, for they are at rest
    candidates: tuple[Candidate, ...] = ()
    alternatives: tuple[Alternative, ...] = ()  # the lines that other preferences would recommend
    limits: tuple[Limit, ...] = ()  # steps to less that fail
    # for the pull of the recommended line; its mass is that of the design's sinker
    sinker: SinkerSize | None = None
    # by the rule that was not chosen, for comparison; None where there is none
    other_sinker: SinkerSize | None = None
    drag_anchor: DragAnchorSize | None = None  # for the largest horizontal force
    reserve_buoyancy: float | None = None  # of the buoy, N; None without one
    pattern: Pattern | None = None  # the mooring equilibrium of several lines
    assumptions: tuple[str, ...] = ()  # what the answer rests on
    defaults: tuple[str, ...] = ()  # what was not given and was taken
    inputs: tuple[ReadInput, ...] = ()  # all that was known, as it was read
    departures: tuple[str, ...] = ()  # from the method of the code that it is checked by
    practice: str = ""  # the recommendation beside what is laid
    chain_life: float | None = None  # until wear has it changed, s: `advice` says why
    fittings: tuple[str, ...] = ()  # shackles, swivels and the like that go with the line
    advice: tuple[str, ...] = ()  # what a code asks for beyond the checks
    afloat: Case | None = None  # the case with buoy and sea, to be run in motion; None without
    ship_case: Case | None = None  # that of ship and sea on all her lines, likewise
    in_motion: InMotion | None = None  # what its runs came to; None: sized at rest alone
    shape: BuoyShape | None = None  # of the buoy that is moored, where it is known

    @property
    def case(self) -> Case:
        """A whole case with the recommended line: design, check and solve take it."""
        return self.settled.case

    @property
    def whole_case(self) -> Case:
        """The case to keep: of several lines that of the whole pattern, else of the one line."""
        if self.pattern is None:
            return self.line_case
        return self.ship_case or system_case(self.case, self.pattern)

    @property
    def line_case(self) -> Case:
        """The case of the one line to keep: with buoy and sea, where they are known."""
        return self.afloat or self.case

    @property
    def point(self) -> DesignPoint:
        """The recommended design."""
        return self.settled.point

    @property
    def one_line(self) -> Message:
        """The recommendation in one sentence: the line, and what holds it."""
        line, pattern = self.point.line, self.pattern
        (first, *_), lines = line.segments, 1 if pattern is None else pattern.lines
        weights = (
            Message("sizing.with_weight", mass=Measure("mass", load.mass), place=load.position)
            for load in line.point_loads
            if load.mass is not None
        )
        return Message(
            "sizing.one_line" if lines == 1 else "sizing.one_of_lines",
            lines=lines,
            chain=chain_words(first.component, first.nominal_diameter),
            length=line.length,
            weights=Several(weights, ""),
            held=self._held,
        )

    @property
    def _held(self) -> str:
        """Say on what the line lies; empty where nothing was sized."""
        size = self.drag_anchor or self.sinker
        if size is None:
            return ""
        anchor = self.point.anchor
        mass = Measure("mass", (None if anchor is None else anchor.mass) or size.mass)
        if self.drag_anchor is not None:
            values = {"anchor": self.drag_anchor.anchor, "soil": term(self.drag_anchor.soil)}
            return Message("sizing.on_anchor", mass=mass, **values)
        assert self.sinker is not None
        return Message(f"sizing.on_{self.sinker.material}", mass=mass)

    @property
    def shots(self) -> float:
        """Length of the line in shots of chain."""
        return self.point.line.length / SHOT

    @property
    def excursion(self) -> float | None:
        """Way from the everyday place, or of the body of several lines, m; None for a buoy."""
        if self.pattern is not None:
            return max(state.offset for state in self.pattern.states)
        return self.point.objectives.get("excursion_m")

    @property
    def why(self) -> str:
        """Why this design of the front is recommended."""
        prefer = self.settled.choice.looks_for
        if prefer == "least-swing":
            return Message("sizing.least_swing")
        if prefer == "practice":
            aim, length = self.settled.choice.aim, self.point.line.length
            if length <= aim:
                return Message("sizing.practice", aim=aim)
            return Message("sizing.shortest")
        if prefer == "balanced":
            aim = self.settled.choice.aim
            is_short = self.point.objectives["offset_m"] <= aim
            return Message("sizing.balanced" if is_short else "sizing.least_swept", aim=aim)
        if prefer == "shortest":
            return Message("sizing.shortest")
        said = self._why_cheapest if prefer == "cheapest" else Message("sizing.lightest")
        if not self._is_smallest:
            return said
        size = 1e3 * point_diameter(self.point)
        return Several((said, Message("sizing.smallest_looked_at", size=size)), " ")

    @property
    def _why_cheapest(self) -> Message:
        segment, case = self.point.line.segments[0], self.case
        catalogue = chosen(case.catalogue, case.site.water_density)
        origin = catalogue.component(segment.component, point_diameter(self.point)).provenance[
            "price"
        ]
        source = Cited(f"{'; '.join(each.title for each in origin.sources)} [{origin.confidence}]")
        values = {"cost": Measure("cost", self.cost or 0.0), "source": source}
        price = self.settled.choice.swing_price
        if price:
            return Message("sizing.cheapest_with_swing", price=price, **values)
        return Message("sizing.cheapest", **values)

    @property
    def cost(self) -> float | None:
        """Of the line's material, USD; None where a price is not known."""
        return self.point.objectives.get("cost_USD")

    @property
    def _is_smallest(self) -> bool:
        """Whether a smaller size is sold, but was not looked at."""
        bound = self.case.design.segments[0].diameter_min if self.case.design else None
        smaller = [each.diameter for each in self.candidates if each.role == "smaller"]
        return bound is not None and bool(smaller) and smaller[0] < bound

    @property
    def hardest(self) -> tuple[str, Solution]:
        """Load case and line of the largest tension at the fairlead, with all lines there."""
        return largest(self.intact, lambda each: each[1].fairlead.tension)

    @property
    def intact(self) -> tuple[tuple[str, Solution], ...]:
        """The line in each load case in which the mooring has all its lines."""
        whole = {each.name for each in self.case.load_cases if each.state == "intact"}
        return tuple(each for each in self.point.checks.solutions if each[0] in whole)

    @property
    def largest_tension(self) -> float:
        """In any part of the line, with all lines there, N."""
        return max(
            segment.max_tension for _, solution in self.intact for segment in solution.segments
        )

    @property
    def break_factor(self) -> float | None:
        """MBL of the new line over its largest tension; None where no MBL is known."""
        return self._factor("MBL")

    @property
    def proof_factor(self) -> float | None:
        """Proof load of the new line over its largest tension; None where none is known."""
        return self._factor("proof_load")

    @property
    def recalled(self) -> tuple[str, ...]:
        """Loads that rest on what was read in no document."""
        parts = (part for each in self.settled.posed.loads for part in each.parts)
        return tuple(dict.fromkeys(name for part in parts for name in part.recalled))

    @property
    def other_rule(self) -> str:
        """Document of the rule that `other_sinker` is by."""
        source = None if self.other_sinker is None else self.other_sinker.friction_source
        return CALMAR if source is None else source.document

    def trade(self, of: Alternative) -> Message:
        """Say what one of `alternatives` that has a line gives and takes beside the own one."""
        return trade(of.swing, of.mass, self.swing.total, self.point.objectives["mass_kg"])

    @property
    def warnings(self) -> tuple[str, ...]:
        """What an engineer should know before using the answer, each once."""
        parts = (part for each in self.settled.posed.loads for part in each.parts)
        notes = [
            *estimated_dimensions(self.inputs),
            *(warning for part in parts for warning in part.warnings),
            *map(Sentence, self.settled.warnings),
            *(Sentence(note, capital=True) for note in (self.sinker.notes if self.sinker else ())),
        ]
        if self.pattern is not None:
            notes += self.pattern.warnings
            tensions = (each for each in self.point.checks.results if each.kind == "tension")
            if "one_line_out" not in {each.place.state for each in tensions}:
                codes = ", ".join(self.case.checks.codes)
                notes.append(Message("sizing.no_factor_line_out", codes=codes))
        if self.drag_anchor is not None:
            notes.append(Message("sizing.holding_after", note=self.drag_anchor.capacity.note))
        return tuple(dict.fromkeys(notes))

    def to_dict(self) -> dict[str, Any]:
        """Build the document that ``catopt size --json`` prints (schema catopt.size/1)."""
        return sizing_document(self)

    def _factor(self, strength: str) -> float | None:
        strengths = [getattr(segment, strength) for segment in self.point.line.segments]
        if None in strengths or not self.largest_tension:
            return None
        return float(min(strengths) / self.largest_tension)
