"""The answer of a sizing."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from typing import Final, Literal, NamedTuple

from catopt.catalogue.choice import chosen
from catopt.catalogue.family import chain_words
from catopt.catenary.solution import Solution
from catopt.checks.verdict import Judgement
from catopt.design.result import DesignPoint, DesignResult
from catopt.display import Displayable, renderers
from catopt.largest import largest
from catopt.loads.buoy_shape import BuoyShape
from catopt.loads.drag_anchor import DragAnchorSize
from catopt.loads.sinker import SinkerSize
from catopt.model import Case, Line, LoadCase, Segment
from catopt.model.kinds import Duration, Factor, Height, Positive, SomeForce, SomeMass
from catopt.records import Counted, Record
from catopt.sizing.alternatives import Alternative, Candidate, Limit
from catopt.sizing.converge import ConvergedSizing, point_diameter
from catopt.sizing.floating import FloatsInStorm
from catopt.sizing.in_motion import InMotion
from catopt.sizing.input_values import ReadInput, estimated_dimensions, small_craft
from catopt.sizing.maintenance import Upkeep, UpkeepInputs
from catopt.sizing.pattern import Pattern, system_case
from catopt.sizing.verdict import judgement_of
from catopt.units import UNITS, Dimension
from catopt.waves import breaking_warning
from catopt.words import Cited, Measure, Message, Sentence, Several, is_said, term

SHOT: Final = UNITS[Dimension.LENGTH]["shot"]
"""m: a shot of chain."""


class SwingPart(NamedTuple):
    """A part of a swing radius."""

    name: str
    """Which part."""
    length: Height
    """In plan."""


@dataclass(frozen=True)
class SwingRadius(Record):
    """How far the floating end swings round the anchor, or round the middle of several lines."""

    DOCUMENT = "total load_case parts(name length)"

    load_case: str
    """In which it is the largest, at low water."""
    parts: tuple[SwingPart, ...]
    """What it is made of."""

    @property
    def total(self) -> Height:
        """Sum of the parts."""
        return math.fsum(part.length for part in self.parts)


@dataclass(frozen=True)
class SizedChain(Record):
    """The recommended line."""

    DOCUMENT = (
        "segment.component segment.nominal_diameter line.length shots line.mass cost=cost_USD "
        "segment.MBL segment.proof_load"
    )

    line: Line
    shots: Positive
    """Its length in shots of 27.5 m."""
    cost: float | None
    """USD, of the line's material; None where a price is not known."""

    @property
    def segment(self) -> Segment:
        """Of what it is."""
        return self.line.segments[0]


@dataclass(frozen=True)
class LoadCaseLine(Record):
    """How the recommended line hangs in a load case."""

    DOCUMENT = (
        "state.name state.kind state.state state.water_level solution.horizontal_force "
        "solution.fairlead_height solution.fairlead.tension solution.fairlead.vertical_force "
        "solution.anchor.horizontal_force=anchor_horizontal_force_N "
        "solution.anchor.vertical_force=anchor_vertical_force_N solution.span "
        "solution.grounded_length"
    )

    state: LoadCase
    solution: Solution


@dataclass(frozen=True)
class Search(Record):
    """The search that the line comes from."""

    DOCUMENT = "result.designs result.feasible front number=recommended recommendation"

    result: DesignResult
    number: Counted
    """Which of the front, counted from 1 by rising mass."""
    recommendation: str
    """Why, in words."""

    @property
    def front(self) -> Counted:
        """Designs that nothing beats in both mass and span."""
        return len(self.result.front)


@dataclass(frozen=True, repr=False)
class Sizing(Displayable, Record):
    """The mooring of a buoy or a tanker, sized from its place and its weather.

    Heights are above the seabed.
    """

    SCHEMA = "catopt.size/1"
    DOCUMENT = (
        "kind case.title one_line inputs chain point.line.point_loads=clump_weights(mass position) "
        "own_sinker=sinker other_sinker(mass needed_mass friction rule) drag_anchor "
        "swing=swing_radius excursion largest_tension dynamic_factor motion in_motion~ practice "
        "chain_life departures fittings advice break_factor proof_factor reserve_buoyancy floats~ "
        "upkeep~ "
        "load_cases settled.posed.loads settled=assumed point.checks.results=checks "
        "point.checks.nearest=governing limits alternatives candidates pattern search=design "
        "assumptions defaults recalled warnings judgement=verdict~"
    )

    kind: Literal["buoy", "tanker"]
    """What was sized."""
    settled: ConvergedSizing
    """The line that the loads were computed for; the recommended one comes to no more."""
    swing: SwingRadius
    """Round the anchor, or round the middle of several lines; at low water."""
    dynamic_factor: Factor
    """Allowance for motion, a pure number: tension in waves over that under the steady forces."""
    motion: str
    """What stands for motion, and where the allowance is from."""
    candidates: tuple[Candidate, ...] = ()
    """The recommended size between its neighbours, by rising size; as the next two empty of one
    that was run in motion, for they are at rest."""
    alternatives: tuple[Alternative, ...] = ()
    """The lines that other preferences would recommend, each under its own loads."""
    limits: tuple[Limit, ...] = ()
    """Steps to a smaller size or a shorter length that fail."""
    sinker: SinkerSize | None = None
    """For the pull of the recommended line."""
    other_sinker: SinkerSize | None = None
    """By the rule that was not chosen, for comparison: friction of the soil, or phi = 45 deg. None
    where there is none."""
    drag_anchor: DragAnchorSize | None = None
    """What holds the line, by the largest horizontal force; None where it is a sinker."""
    reserve_buoyancy: SomeForce | None = None
    """Of the buoy; None without one."""
    pattern: Pattern | None = None
    """The mooring equilibrium of several lines; None for one."""
    assumptions: tuple[str, ...] = ()
    """What the answer rests on."""
    defaults: tuple[str, ...] = ()
    """What was not given and was taken."""
    inputs: tuple[ReadInput, ...] = ()
    """All that was known, as it was read; empty where a request was made in Python."""
    departures: tuple[str, ...] = ()
    """Where the request departs from the method of the code that it is checked by."""
    practice: str = ""
    """The recommendation beside what is laid; empty where nothing is known to be."""
    chain_life: Duration | None = None
    """Until the first check is overrun by wear; None where that is not known."""
    fittings: tuple[str, ...] = ()
    """What goes with the line: shackles, swivels."""
    advice: tuple[str, ...] = ()
    """What a code asks for beyond its checks."""
    afloat: Case | None = None  # the case with buoy and sea, to be run in motion; None without
    ship_case: Case | None = None  # that of ship and sea on all her lines, likewise
    in_motion: InMotion | None = None
    """What the recommended line came to in runs with its buoy or ship afloat; None where it is
    sized at rest alone."""
    shape: BuoyShape | None = None  # of the buoy that is moored, where it is known
    prices: UpkeepInputs = field(default_factory=UpkeepInputs)  # given, and wear by zone
    upkeep: Upkeep | None = None
    """The chain by zone, its renewal and its cost; None where its life is not known."""
    crane: float | None = None  # what the tender's crane lifts, kg; None: not known
    floats: FloatsInStorm | None = None
    """How the buoy floats on the recommended line in the storm; None where its shape is not known.
    """

    def __repr__(self) -> str:
        """Lay out what ``catopt size`` prints first."""
        screen: str = renderers["screen"](self)
        return screen

    @property
    def judgement(self) -> Judgement:
        """What the recommended line comes to, and what was not judged."""
        return judgement_of(self)

    @property
    def passes(self) -> bool | None:
        """Whether what was judged passes: at rest and, where it was run, in motion."""
        return self.judgement.passes

    @property
    def case(self) -> Case:
        """A whole case with the recommended line: design, check and solve take it."""
        return self.settled.case

    @property
    def whole_case(self) -> Case:
        """The case to keep: of several lines all, of a ship that was run she and the sea."""
        whole = self.system_case
        is_whole = self.pattern is not None or self.in_motion is not None
        return self.line_case if whole is None or not is_whole else whole

    @property
    def system_case(self) -> Case | None:
        """The case of a ship in her sea, or else of all lines around a body; None without."""
        if self.ship_case is not None or self.pattern is None:
            return self.ship_case
        return system_case(self.case, self.pattern)

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
        if isinstance(size, SinkerSize):
            return Message(f"sizing.on_{size.material}", mass=mass)
        return Message("sizing.on_anchor", mass=mass, anchor=size.anchor, soil=term(size.soil))

    @property
    def chain(self) -> SizedChain:
        """The recommended line."""
        return SizedChain(self.point.line, self.shots, self.cost)

    @property
    def shots(self) -> float:
        """Length of the line in shots of chain."""
        return self.point.line.length / SHOT

    @property
    def own_sinker(self) -> SinkerSize | None:
        """What holds the line, with the mass of the design's sinker; None for a drag anchor."""
        anchor = self.point.anchor
        if self.sinker is None or anchor is None or anchor.mass is None:
            return self.sinker
        return replace(self.sinker, mass=anchor.mass)

    @property
    def lift(self) -> SomeMass | None:
        """What a tender lifts of a buoy's mooring, in air: the sinker with all of its chain."""
        sinker, chain = self.own_sinker, self.point.line.mass
        if self.kind != "buoy" or sinker is None or chain is None:
            return None
        return sinker.mass + chain

    @property
    def load_cases(self) -> tuple[LoadCaseLine, ...]:
        """How the recommended line hangs in each."""
        states = {each.name: each for each in self.case.load_cases}
        return tuple(LoadCaseLine(states[name], at) for name, at in self.point.checks.solutions)

    @property
    def search(self) -> Search:
        """The search that the line comes from."""
        return Search(self.settled.result, self.settled.index + 1, self.why)

    @property
    def excursion(self) -> Height | None:
        """Way of the fairlead from its everyday place, or of the body of several lines.

        That from its place under no load; None for a buoy.
        """
        if self.pattern is not None:
            return max(state.offset for state in self.pattern.states)
        return self.point.objectives.get("excursion_m")

    @property
    def why(self) -> str:
        """Why this design of the front is recommended."""
        prefer, aim = self.settled.choice.looks_for, self.settled.choice.aim
        if prefer == "least-swing":
            return Message("sizing.least_swing")
        if prefer == "practice" and self.point.line.length <= aim:
            return Message("sizing.practice", aim=aim)
        if prefer in ("practice", "shortest"):
            return Message("sizing.shortest")
        if prefer == "balanced":
            is_short = self.point.objectives["offset_m"] <= aim
            return Message("sizing.balanced" if is_short else "sizing.least_swept", aim=aim)
        said = self._why_cheapest if prefer == "cheapest" else Message("sizing.lightest")
        if not self._is_smallest:
            return said
        size = 1e3 * point_diameter(self.point)
        return Several((said, Message("sizing.smallest_looked_at", size=size)), " ")

    @property
    def _why_cheapest(self) -> Message:
        component, case = self.point.line.segments[0].component, self.case
        catalogue = chosen(case.catalogue, case.site.water_density)
        sold = catalogue.component(component, point_diameter(self.point))
        origin = sold.provenance["price"]
        source = Cited(f"{'; '.join(each.title for each in origin.sources)} [{origin.confidence}]")
        values = {"cost": Measure("cost", self.cost or 0.0), "source": source}
        price = self.settled.choice.swing_price
        if price:
            return Message("sizing.cheapest_with_swing", price=price, **values)
        return Message("sizing.cheapest", **values)

    @property
    def cost(self) -> float | None:
        """Of the line's material, USD; None where a price is not known."""
        return self.point.cost

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
    def largest_tension(self) -> SomeForce:
        """Anywhere in the line, in any load case with all lines there."""
        return max(
            segment.max_tension for _, solution in self.intact for segment in solution.segments
        )

    @property
    def break_factor(self) -> Positive | None:
        """MBL of the new line over its largest tension, a pure number; None where none is known."""
        return self._factor("MBL")

    @property
    def proof_factor(self) -> Positive | None:
        """Proof load of the new line over its largest tension; None where none is known."""
        return self._factor("proof_load")

    @property
    def recalled(self) -> tuple[str, ...]:
        """Names of the loads that rest on figures read in no document."""
        parts = (part for each in self.settled.posed.loads for part in each.parts)
        return tuple(dict.fromkeys(name for part in parts for name in part.recalled))

    @property
    def warnings(self) -> tuple[str, ...]:
        """What an engineer should know before using the answer, each once."""
        parts = (part for each in self.settled.posed.loads for part in each.parts)
        said = self.point.checks.warnings
        first = [each for each in said if is_said(each, "checks.no_strength_criterion")]
        first += self.breaking_seas()
        notes = [
            *(Sentence(each, capital=True) for each in first),
            *estimated_dimensions(self.inputs),
            *small_craft(self.inputs),
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
        lift = self.lift
        if lift is not None and self.crane is not None and lift > self.crane:
            values = {"lift": lift / 1e3, "crane": self.crane / 1e3}
            notes.append(Message("sizing.above_crane", **values))
        if self.drag_anchor is not None:
            notes.append(Message("sizing.holding_after", note=self.drag_anchor.capacity.note))
        return tuple(dict.fromkeys(notes))

    def breaking_seas(self) -> Iterator[str]:
        """Say of the seas that lines were run in which cannot be, where waves break first."""
        moved = self.in_motion
        if moved is None or moved.case.waves is None:
            return
        from catopt.verify.dynamic_setup import read_drive

        waves = moved.case.waves
        for sea in moved.how.seas(waves.height or 0.0, waves.period or 0.0):
            own = replace(waves, height=sea.height, period=sea.period)
            said = breaking_warning(read_drive(replace(moved.case, waves=own)).sea(0))
            if said is not None:
                yield said

    def _factor(self, strength: str) -> float | None:
        strengths = [getattr(segment, strength) for segment in self.point.line.segments]
        if None in strengths or not self.largest_tension:
            return None
        return float(min(strengths) / self.largest_tension)
