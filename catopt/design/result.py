"""The answer of a design search, and of what its designs are made."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import Annotated, Any, TypedDict

from catopt.checks.result import CheckReport, CheckResult, ChecksInMotion
from catopt.checks.verdict import Judgement, Matter, verdict_of
from catopt.design.mooring_point import MooringPoint
from catopt.display import Displayable
from catopt.model import Anchor, Case, Line
from catopt.model.design import FoundBy
from catopt.model.kinds import (
    Angle,
    Height,
    Length,
    NotNegative,
    OneOf,
    Place,
    Size,
    SomeForce,
    SomeMass,
)
from catopt.model.load import LoadCaseKind
from catopt.model.network import Network
from catopt.records import Counted, From, FromZero, Record
from catopt.words import Measure, Message, Several
from catopt.words.message_records import messages_in

__all__ = ["DesignPoint", "DesignResult", "InDraws", "NearMiss", "Neighbour"]


def segment_words(line: Line) -> list[str]:
    """Say what each segment is: ``"chain studless R3 76 mm, 45 m"``."""
    return [
        Message(
            "design.segment_words",
            segment=segment.name or Message("checks.segment", number=number),
            length=segment.length,
        )
        for number, segment in enumerate(line.segments, start=1)
    ]


def clump_weight_words(line: Line) -> list[str]:
    """Say what hangs on the line: ``"2 t at 7 m"``, with the mass in air."""
    return [
        Message("design.weight_at", mass=load.mass / 1e3, position=load.position)
        if load.mass is not None
        else Message(
            "design.force_at",
            force=Measure("point_weight", load.submerged_weight),
            position=load.position,
        )
        for load in line.point_loads
    ]


def anchor_words(point: DesignPoint) -> str:
    """Say what holds the line; empty when the case has no anchor."""
    anchor = point.anchor
    if anchor is None:
        return ""
    if anchor.kind != "sinker":
        return Message("design.drag_anchor")
    if anchor.mass is not None:
        return Message("design.sinker", mass=anchor.mass / 1e3)
    force = Measure("point_weight", anchor.submerged_weight or 0.0)
    return Message("design.sinker_force", force=force)


def layout_words(point: DesignPoint) -> Iterator[Message]:
    """Say how many lines there are and how far away their anchors; nothing of a single line."""
    if point.mooring is not None:
        legs = point.mooring.system.legs
        yield Message("design.around", count=len(legs), radius=legs[0].anchor_radius)
        if point.mooring.pretension is not None:
            force = Measure("horizontal_force", point.mooring.pretension)
            yield Message("design.at_pretension", force=force)


def made_of(point: DesignPoint) -> Several:
    """Say of what a design is made, from the anchor."""
    parts = (
        *layout_words(point),
        *segment_words(point.line),
        *clump_weight_words(point.line),
        anchor_words(point),
    )
    return Several(part for part in parts if part)


OBJECTIVES_MADE = ("mass_kg", "offset_m", "excursion_m", "cost_USD", "length_m", "anchor_load_N")
"""Keys of what is made small."""
_WORTH = (
    "point.mass~ point.largest_span=offset_m~ point.excursion~ point.cost=cost_USD~ "
    "point.length~ point.anchor_load~"
)
"""Of a design beside the front; those that the front has are kept (`DesignResult.to_dict`)."""


@dataclass(frozen=True)
class InDraws(Record):
    """How a design does where values of the case are drawn."""

    DOCUMENT = "failing interval share samples"

    failing: NotNegative
    """Part of the draws in which it fails a check."""
    interval: Annotated[tuple[float, ...], Size(2, 2)]
    """Of the probability to fail: 95 %, by Clopper and Pearson."""
    share: NotNegative
    """Part of the draws in which it has to pass; what is made small is not exceeded in that."""
    samples: Counted
    """Draws in all."""

    @property
    def passes(self) -> bool:
        """Whether it passes in as many as it has to."""
        return round((1.0 - self.failing) * self.samples) >= needed(self.share, self.samples)


@dataclass(frozen=True)
class PointInMotion(Record):
    """What a design came to in motion."""

    DOCUMENT = "largest_tension quasi_static_tension amplification runs verdict in_motion=checks"

    largest_tension: SomeForce | None
    """At the fairlead, N, in the load case or the line where it is largest."""
    quasi_static_tension: SomeForce | None
    """The largest, N, had the line moved infinitely slowly."""
    amplification: float | None
    """The former over the latter: the allowance for motion of this design."""
    runs: FromZero
    """Seeds in which it was run; one alone where it fails there."""
    verdict: str
    """Whether a second run bears out the maxima: of the recommended design, which is run again."""
    checks: CheckReport | None
    """Of it in motion; None where there is no answer."""
    failure: str = ""
    """Why there is no answer; empty where there is one."""

    @property
    def in_motion(self) -> ChecksInMotion | None:
        """Its checks; None where there is no answer."""
        return None if self.checks is None else self.checks.in_motion

    @property
    def tightest(self) -> CheckResult | None:
        """The check in motion that is nearest to its limit; None where there is none."""
        return None if self.checks is None else self.checks.governing


@dataclass(frozen=True)
class FailsInMotion(Record):
    """A design that passes at rest, and fails in motion."""

    DOCUMENT = f"{_WORTH} made reason"

    point: DesignPoint
    """As it is at rest."""
    reason: str
    """The check that it overruns most, or why it has no answer."""

    @property
    def made(self) -> str:
        """Of what it is made, from the anchor."""
        return made_of(self.point)


@dataclass(frozen=True)
class SearchInMotion(Record):
    """How a front came about whose designs pass in motion, too."""

    DOCUMENT = "run complete proven failing"

    run: Counted
    """Designs that were run: each that no design beats which passes in motion."""
    failing: tuple[FailsInMotion, ...]
    """Those of them that fail there, in the order in which they were run."""
    complete: bool
    """False: `max_run` or Ctrl-C ended it, and others might have been better."""
    proven: bool
    """Whether the recommended design was run again, which bears out its maxima."""


def needed(share: float, samples: int) -> int:
    """Return how many of some draws a share of them is, at least."""
    return max(1, math.ceil(share * samples - 1e-9))


@dataclass(frozen=True, repr=False)
class DesignPoint(Displayable, Record):
    """One line of the front."""

    DOCUMENT = (
        "mass largest_span=offset_m excursion? cost=cost_USD? length? anchor_load? "
        "line.segments(name catalogued=component nominal_diameter length "
        "submerged_weight mass EA MBL proof_load price wear_rate wear_zone~) "
        "line.point_loads(name position submerged_weight mass) "
        "sinker(mass submerged_weight friction base_holding? safety_factor) checks.results=checks "
        "checks.nearest=governing passes=feasible spans genes "
        "in_motion? mooring=system(azimuths anchor_radius pretension? state=farthest_state "
        "farthest.system.force=farthest_force_N load.water_level=farthest_water_level_m~ "
        "load.fairlead_rise=farthest_fairlead_rise_m~ load.line_out=farthest_line_out~)? draws?"
    )

    line: Line  # with component and nominal diameter in each segment
    anchor: Anchor | None  # the sinker that was chosen for it, or the anchor of the case
    genes: tuple[FromZero, ...]
    """Its place in the design space."""
    # by the keys of OBJECTIVES_MADE: mass, offset, excursion and cost where they are known, wanted
    # as objective or not; the others where they are required
    objectives: Mapping[str, float]
    checks: CheckReport
    """As catopt check gives them, by load case; of a whole mooring the hardest of each over all
    lines, headings and states."""
    mooring: MooringPoint | None = None
    """Only of whole moorings: the layout of its equal lines, and what takes the body farthest."""
    draws: InDraws | None = None
    """Only where values of the case are drawn: all else is by its own values."""
    in_motion: PointInMotion | None = None
    """Only where designs have to pass in motion: what it came to there."""

    @property
    def matter(self) -> Matter:
        """What its verdict is on: its checks at rest and, where it was run, in motion."""
        moved = None if self.in_motion is None else self.in_motion.checks
        if moved is not None and self.in_motion is not None:
            moved = replace(moved, is_proven=self.in_motion.verdict == "converged")
        return replace(self.checks.matter, in_motion=moved)

    @property
    def passes(self) -> bool:
        """Whether it passes every check, and as many draws as it has to where values are drawn."""
        return self.checks.passes and (self.draws is None or self.draws.passes)

    @property
    def governing(self) -> CheckResult | None:
        """The check that is nearest to its limit."""
        return self.checks.governing

    @property
    def mass(self) -> SomeMass | None:
        """In air, of segments and clump weights, of a whole mooring those of all lines.

        None when one of them is not known.
        """
        return self.objectives.get("mass_kg", self.line.mass)

    @property
    def largest_span(self) -> Height:
        """The largest span over the load cases.

        Of a whole mooring the largest offset of the body from where it rests without a load.
        """
        return self.objectives["offset_m"]

    @property
    def excursion(self) -> Place | None:
        """The largest span less the span in the reference load case."""
        return self.objectives.get("excursion_m")

    @property
    def cost(self) -> float | None:
        """USD, of the line's material; None where a price is not known."""
        return self.objectives.get("cost_USD")

    @property
    def length(self) -> Length | None:
        """Unstretched, of the line, of a whole mooring of all lines; where it is made small."""
        return self.objectives.get("length_m")

    @property
    def anchor_load(self) -> SomeForce | None:
        """The largest tension at an anchor, of any line in any state; where it is made small."""
        return self.objectives.get("anchor_load_N")

    @property
    def sinker(self) -> Anchor | None:
        """The sinker at the anchor; None when there is none."""
        is_sinker = self.anchor is not None and self.anchor.kind == "sinker"
        return self.anchor if is_sinker else None

    @property
    def spans(self) -> tuple[Place, ...]:
        """The span in each load case, in the order of load_cases; empty of a whole mooring."""
        solutions = () if self.mooring or self.checks.places else self.checks.solutions
        return tuple(solution.span for _, solution in solutions)

    @property
    def largest_force(self) -> SomeForce:
        """Horizontal, on the line in any load case."""
        return max(solution.horizontal_force for _, solution in self.checks.solutions)

    def to_dict(self) -> dict[str, Any]:
        """Lay it out with the objectives first, as they were made small."""
        return {"mass_kg": self.mass, **self.objectives} | super().to_dict()


@dataclass(frozen=True)
class Neighbour(Record):
    """What one step of one variable would do to a design."""

    DOCUMENT = f"change {_WORTH} feasible governing utilisation reason"

    change: str
    """In words: ``"segment 1: chain studless R3 81 mm for 76 mm"``."""
    point: DesignPoint | None  # the changed design; None where it has no equilibrium
    reason: str = ""
    """Why it has no equilibrium; else empty."""

    @property
    def feasible(self) -> bool:
        """Whether the changed design passes every check."""
        return self.point is not None and self.point.passes

    @property
    def governing(self) -> str:
        """The check that is nearest to its limit or furthest beyond it, with its load case."""
        return "" if self.point is None else self.point.checks.nearest

    @property
    def utilisation(self) -> NotNegative | None:
        """Of that check, a pure number; None without one, or where its capacity is 0 or less."""
        found = None if self.point is None else self.point.governing
        return None if found is None else found.utilisation


@dataclass(frozen=True)
class NearMiss:
    """The design that misses feasibility by least, when none is feasible."""

    line: Line  # the design
    # the checks that it fails, the worst first; empty where it has no equilibrium
    failing: tuple[CheckResult, ...]
    reason: str = ""  # why there is no equilibrium; else empty


@dataclass(frozen=True)
class DesignLoadCase(Record):
    """A load case that every design is checked in."""

    DOCUMENT = "name kind water_level horizontal_force direction? fairlead_height line_out?"

    name: str
    """As the case has it."""
    kind: LoadCaseKind
    """Which factors of the codes are taken."""
    water_level: Place
    """Above the level of the site's water depth."""
    horizontal_force: SomeForce
    """At the fairlead; of a whole mooring on the body."""
    fairlead_height: Height
    """Above the seabed, at this water level."""
    direction: Angle | None = None
    """Only of whole moorings: towards which the force acts, counter-clockwise from x."""
    line_out: bool | None = None
    """Only of whole moorings: whether each line is gone in turn under it, too."""


class Excluded(TypedDict):
    """How many designs each bound proves needless."""

    reach: FromZero
    """Whose lines do not reach their anchors, or do not pull against the force."""
    strength: FromZero
    """Whose hardest loaded line bears more than it is allowed at the least share of the force."""
    least_offset: FromZero
    """Whose least possible offset is beaten by a lighter design that passes."""
    offset_so_far: FromZero
    """Whose offset in the states solved so far is beaten by a lighter design that passes."""


@dataclass(frozen=True, repr=False)
class DesignResult(Displayable, Record):
    """The front of a design search, and how it was found.

    Lines that pass every check in every load case, of which none is beaten in all objectives.
    Heights are above the seabed.
    """

    SCHEMA = "catopt.design/1"
    DOCUMENT = (
        "case.title objectives load_cases front recommended_index=recommended recommendation ends "
        "neighbours present method is_exact designs evaluations feasible hypervolume "
        "reference_point seed interrupted warnings excluded? in_motion? judgement=verdict~"
    )

    case: Case | Network  # what was asked
    load_cases: Annotated[tuple[DesignLoadCase, ...], From(1)]
    """Every design is checked in each."""
    objectives: Annotated[tuple[Annotated[str, OneOf(OBJECTIVES_MADE)], ...], Size(2, 3)]
    """Keys of each design that were made small."""
    front: Annotated[tuple[DesignPoint, ...], From(1)]
    """By rising first objective; every one is feasible, none is beaten in all objectives. Tables
    and --design count it from 1."""
    recommended: int  # number of the recommended design, from 1 as everywhere: see `best`
    recommendation: str
    """Why, in words."""
    method: FoundBy
    """How the designs were searched."""
    is_exact: bool
    """Whether every design of the space was evaluated, or proved needless."""
    designs: Counted
    """Designs that the space holds."""
    evaluations: Counted
    """Designs that were evaluated, each in all load cases."""
    feasible: FromZero
    """How many of these passed every check."""
    hypervolume: NotNegative
    """Of the front up to reference_point, in the units of the objectives multiplied."""
    reference_point: tuple[float, ...]
    """For each objective in its unit: the worst corner, that the hypervolume is measured from."""
    seed: FromZero
    """Of the random numbers."""
    interrupted: bool
    """Whether the search was stopped before its end."""
    ends: tuple[str, ...]
    """For each objective which check the end of the front runs into there, in words."""
    neighbours: tuple[Neighbour, ...]
    """What one size or one step up or down of each variable would do to the recommended design."""
    present: Neighbour
    """The line that stands in the case file, by the same checks; no part of the front."""
    seconds: float  # wall time of the search
    warnings: tuple[str, ...] = ()
    """What an engineer should know before using the answer."""
    excluded: Annotated[Mapping[str, int], Excluded] = field(default_factory=dict)
    """Only of whole moorings: how many designs each bound proves needless
    (`catopt.design.assess.BOUNDS`); these were not evaluated."""
    in_motion: SearchInMotion | None = None
    """Only where designs have to pass in motion, too: which were run, and which fail."""

    @property
    def best(self) -> DesignPoint:
        """The recommended design: the knee of the front."""
        return self.front[self.recommended - 1]

    @property
    def judgement(self) -> Judgement:
        """What the recommended design comes to, and what was not judged."""
        return verdict_of(self.best.matter)

    @property
    def recommended_index(self) -> FromZero:
        """Index into front, counted from 0: the knee."""
        return self.recommended - 1

    def to_dict(self) -> dict[str, Any]:
        """Build the document that ``catopt design --json`` prints (schema catopt.design/1)."""
        document = super().to_dict()
        document["neighbours"] = [self._beside(each) for each in self.neighbours]
        document["present"] = self._beside(self.present)
        if self.in_motion is not None:
            failing = [self._beside(each) for each in self.in_motion.failing]
            document["in_motion"]["failing"] = failing
        front = [{"governing": point["governing"]} for point in document["front"]]
        return document | {"messages": messages_in(document | {"front": front})}

    def _beside(self, each: Neighbour | FailsInMotion) -> dict[str, Any]:
        """Lay a design out by the objectives of the front, in their order."""
        found = each.to_dict()
        values = {key: found.pop(key, None) for key in OBJECTIVES_MADE}
        first = {key: found.pop(key) for key in ("change",) if key in found}
        return first | {key: values[key] for key in self.front[0].objectives} | found
