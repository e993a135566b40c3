"""The answer for one line, as a value, and what an engineer should know before using it."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field, fields, replace
from functools import cached_property
from itertools import count
from typing import TYPE_CHECKING, Annotated, Any, Literal, NotRequired, Self, TypedDict

from catopt.catenary.layout import (
    LowestPoint,
    Profile,
    Stretch,
    TouchdownPoint,
    lowest_point,
    sag_of,
    sample,
    touchdowns_of,
)
from catopt.catenary.state import Regime
from catopt.display import Displayable
from catopt.errors import FloatsUpError
from catopt.model import Line
from catopt.model.kinds import Angle, Factor, Force, Height, Length, NotNegative, Place, SomeForce
from catopt.model.line import INEXTENSIBLE, StrainTable
from catopt.records import Counted, From, FromZero, Record
from catopt.words import Measure, Message

__all__ = [
    "EndState",
    "FoundQuantity",
    "PointLoadState",
    "Residual",
    "SegmentState",
    "Solution",
    "SwarmDifference",
    "SwarmReport",
]


@dataclass(frozen=True)
class EndState(Record):
    """Effective forces at one end of the line.

    The vertical force is positive where the line rises towards the fairlead (at the anchor: where
    the line pulls the anchor up).
    """

    DOCUMENT = "tension horizontal_force vertical_force angle"

    tension: SomeForce
    """Effective tension."""
    horizontal_force: SomeForce
    """Horizontal part of the tension."""
    vertical_force: Force
    """Vertical part of the tension, positive where the line rises towards the fairlead."""
    angle: Angle
    """Inclination of the line above the horizontal, with the sign of the vertical force."""


@dataclass(frozen=True)
class SegmentState(Record):
    """One segment of the line under load."""

    DOCUMENT = "name length max_tension utilisation"

    name: str
    """As in the case file; may be empty."""
    length: Length
    """Unstretched."""
    max_tension: SomeForce
    """Largest effective tension in the segment."""
    MBL: float | None

    def utilisation(self, safety_factor: float = 1.0) -> NotNegative | None:
        """Largest tension times the safety factor over MBL; None where that is not known."""
        return None if self.MBL is None else self.max_tension * safety_factor / self.MBL


def end_state(H: float, V: float) -> EndState:
    """Return the state of an end by the horizontal and the vertical force there, N."""
    return EndState(math.hypot(H, V), H, V, math.atan2(V, H))


def segment_states(line: Line, largest: Iterable[float]) -> tuple[SegmentState, ...]:
    """Return the state of each segment of a line by the largest tension in it, N."""
    each = zip(line.segments, largest, strict=True)
    return tuple(SegmentState(s.name, s.length, tension, s.MBL) for s, tension in each)


@dataclass(frozen=True)
class PointLoadState(Record):
    """One clump weight or buoy under load: where it is and what the bed carries of it."""

    DOCUMENT = "name position x y? z seabed_reaction"

    name: str
    """As in the case file; may be empty."""
    position: Length
    """Unstretched arc length from the anchor."""
    x: Place
    """Horizontal distance from the anchor."""
    z: Place
    """Above the seabed."""
    seabed_reaction: Force
    """What the seabed carries of its weight; 0 when it hangs."""
    y: Place | None = None
    """Across x, to the left seen from the anchor; only in a current."""


@dataclass(frozen=True)
class Residual(Record):
    """How exactly the equilibrium is met: the line is laid out piece by piece from its anchor.

    The rounding of the input to double precision leaves more of the forces open on a nearly taut
    line that does not stretch.
    """

    DOCUMENT = "height span force_uncertainty~"

    height: Place
    """By how much it misses the fairlead, upwards."""
    span: Place
    """By how much it misses the fairlead, away from the anchor."""
    force_uncertainty: SomeForce = 0.0
    """By how much the rounding of the input to double precision may move the forces there."""


class SwarmDifference(TypedDict):
    """Swarm less closed form."""

    angle_rad: NotRequired[float]
    """rad: inclination at the anchor, for a line off the bed."""
    grounded_length_m: NotRequired[float]
    """m: length on the bed, for a line partly on it."""
    span_m: float
    """m: span."""
    tension_N: float
    """N: tension at the fairlead."""


@dataclass(frozen=True)
class SwarmReport(Record):
    """How the swarm got to its answer."""

    DOCUMENT = (
        "objective evaluations iterations runs seed converged_runs best_run span_consistency "
        "closed_form_difference"
    )

    objective: NotNegative
    """Smallest f that a run reached, m."""
    evaluations: Counted
    """Evaluations of f over all runs."""
    iterations: Counted
    """Iterations that a run may take."""
    runs: Counted
    """Independent runs."""
    seed: FromZero
    """Run k draws from the generator seeded with (seed, k)."""
    converged_runs: FromZero
    """Runs that ended with f below 1e-9 m."""
    best_run: Counted
    """The run that won, counted from 1."""
    objectives: tuple[float, ...]  # f at the end of each run, m
    span_consistency: Height
    """Distance of the span found from the span that the angle found gives, S1 (11) and (5); must
    stay below 1e-3."""
    closed_form_difference: Annotated[dict[str, float], SwarmDifference]
    """Swarm less closed form."""
    best_objective_history: tuple[float, ...]  # after each iteration of the best run, m
    tension_history: tuple[float, ...]  # at the fairlead, in those places, N
    iterations_flown: tuple[int, ...] = ()  # by each run: fewer where f could not fall any more


@dataclass(frozen=True)
class FoundQuantity(Record):
    """An unknown that meets a condition."""

    DOCUMENT = "quantity value condition residual number unit"

    quantity: Literal["length", "clump_weight", "horizontal_force"]
    """What was sought: the length of a segment, the submerged weight of a clump weight, or the
    horizontal force."""
    value: float
    """In unit."""
    condition: str
    """What it has to give, in words."""
    residual: float
    """By how much the condition is missed, as a part of the quantity that it is put on."""
    number: Counted | None = None
    """Which segment or clump weight, counted from 1 at the anchor; None for a force."""

    @cached_property
    def unit(self) -> Literal["m", "N"]:
        """Of value: m for a length, N for a weight or a force."""
        return "m" if self.quantity == "length" else "N"


class LaidOutLater:
    """A frozen dataclass of which some fields are made when they are first read.

    Who asks a thousand lines for their forces does not pay for a thousand shapes. The default of
    such a field comes from a factory: a plain one stands on the class, and would be read for it.
    """

    @classmethod
    def with_later(cls, later: Mapping[str, Callable[[Self], Any]], **known: Any) -> Self:
        """Return one with the fields that are known, and what makes each of the others of it."""
        made = object.__new__(cls)
        made.__dict__.update(known, _later=later)
        return made

    if not TYPE_CHECKING:  # a checker of types would take any attribute to be there

        def __getattr__(self, name: str) -> Any:
            """Make a field and keep it; Python asks here for what it does not find."""
            make = self.__dict__.get("_later", {}).get(name)
            if make is None:
                raise AttributeError(
                    f"{type(self).__name__!r} has no {name!r}", name=name, obj=self
                )
            self.__dict__[name] = made = make(self)
            return made

    def __getstate__(self) -> dict[str, Any]:
        """Return every field, made: what is pickled or copied is whole."""
        return {each.name: getattr(self, each.name) for each in fields(self)}  # type: ignore[arg-type]


@dataclass(frozen=True, repr=False)
class Solution(LaidOutLater, Displayable, Record):
    """Equilibrium of one mooring line.

    Angles are inclinations above the horizontal, positive where the line rises towards the
    fairlead. Heights are above the seabed.
    """

    SCHEMA = "catopt.solution/1"
    DOCUMENT = (
        "title method status regime horizontal_force span fairlead_height anchor_height "
        "seabed_friction fairlead anchor lowest_point touchdowns sag grounded_length "
        "suspended_length stretched_length line.mass=line_mass_kg safety_factor segments "
        "point_loads residual warnings found? swarm=pso? profile*"
    )

    line: Line
    method: Literal["closed-form", "pso", "shooting"]
    """How the line was solved; by shooting in a current."""
    regime: Regime
    """How the line hangs (docs/regimes.md)."""
    fairlead_height: Height
    """Of the fairlead above the seabed."""
    anchor_height: Height
    """Of the anchor above the seabed."""
    seabed_friction: NotNegative
    """Coulomb coefficient of line on seabed, a pure number."""
    span: Place
    """Horizontal distance from the anchor to the fairlead."""
    fairlead: EndState
    """Forces at the fairlead."""
    anchor: EndState
    """Forces at the anchor, after seabed friction; the vertical force is positive where the line
    pulls the anchor up."""
    grounded_length: Height
    """Unstretched length of line on the seabed."""
    suspended_length: Height
    """Unstretched length of line off the seabed."""
    stretched_length: Height
    """Length of the whole line under its tension."""
    segments: Annotated[tuple[SegmentState, ...], From(1)]
    """From the anchor to the fairlead."""
    point_loads: tuple[PointLoadState, ...]
    """Clump weights and buoys, by position."""
    stretches: tuple[Stretch, ...]  # from the anchor up, cut where anything changes
    residual: Residual
    """By how much the line, laid out from the anchor, misses the fairlead."""
    warnings: tuple[str, ...] = field(default_factory=tuple)
    """What an engineer should know before using the answer."""
    safety_factor: Factor = 1.0
    """Factor on the tension in every utilisation; 1 when none was asked for."""
    title: str = ""
    """Title of the case; empty when it has none."""
    swarm: SwarmReport | None = None
    """Only with method pso."""
    found: FoundQuantity | None = None
    """Only when the case seeks something: what was found. The rest is the line that has it."""

    @cached_property
    def status(self) -> Literal["converged"]:
        """A solve that does not converge gives no answer."""
        return "converged"

    @property
    def horizontal_force(self) -> SomeForce:
        """Horizontal force at the fairlead; the same along all that hangs from it in still water.

        Seabed friction and a current change it along the line; anchor has that at the anchor.
        """
        return self.fairlead.horizontal_force

    @property
    def force_varies(self) -> bool:
        """Whether the horizontal force at the anchor is another than that at the fairlead."""
        here, there = self.horizontal_force, self.anchor.horizontal_force
        return abs(here - there) > VARIES * max(self.fairlead.tension, self.anchor.tension)

    @property
    def lowest_point(self) -> LowestPoint:
        """Where the line is lowest; of what lies on the bed the end towards the fairlead."""
        return lowest_point(self.stretches)

    @property
    def touchdowns(self) -> tuple[TouchdownPoint, ...]:
        """Where the line comes to the bed or leaves it, from the anchor; none where it does not."""
        return touchdowns_of(self.stretches)

    @property
    def sag(self) -> Height:
        """Largest vertical distance of the line below the straight one between its ends.

        Where they are one above the other, below the lower of them.
        """
        return sag_of(self.stretches, self.span, self.fairlead_height)

    @property
    def least_tension(self) -> SomeForce:
        """At the fairlead; at rest there is one, in motion the least of all is judged."""
        return self.fairlead.tension

    def profile(self, points: int = 101) -> Profile:
        """Sample the shape and the tension at about so many points, evenly along the arc.

        Every joint and touchdown is always among them.
        """
        return sample(self.stretches, points)

    def to_dict(self, *, profile: bool = False) -> dict[str, Any]:
        """Build the document that ``catopt solve --json`` prints (schema catopt.solution/1)."""
        document = super().to_dict()
        for part, segment in zip(document["segments"], self.segments, strict=True):
            part["utilisation"] = segment.utilisation(self.safety_factor)
        return document | ({"profile": self.profile().to_dict()} if profile else {})

    def with_found(self, found: FoundQuantity) -> Solution:
        """Return the same answer with what was sought."""
        return replace(self, found=found)

    def lowered(self, lift: float) -> Solution:
        """Return the same answer with every height less, m."""
        return replace(
            self,
            fairlead_height=self.fairlead_height - lift,
            anchor_height=self.anchor_height - lift,
            point_loads=tuple(replace(each, z=each.z - lift) for each in self.point_loads),
            stretches=tuple(replace(each, z=each.z - lift) for each in self.stretches),
        )

    def with_warnings(self, warnings: tuple[str, ...]) -> Solution:
        """Return the same answer with warnings added."""
        return replace(self, warnings=(*self.warnings, *warnings)) if warnings else self


VARIES = 1e-9
"""Of the tension: by less two horizontal forces are one, and differ by rounding."""

OPEN_FORCE = 1e-6
"""Beyond this part of the tension the rounding of the input shows in the digits printed."""

LARGE_STRAIN = 0.05
"""Beyond a few percent, chain and rope no longer stretch in proportion to the tension."""

IN_AIR = 0.05
"""Part of the water depth by which a fairlead is above the water and is remarked on."""

ROUNDING = 1e-9
"""How far above the surface, over the water depth, a buoy may be by rounding."""


def plausibility(solution: Solution) -> Iterator[Message]:
    """Warnings that follow from the line alone."""
    if solution.regime == "slack":
        yield Message("catenary.slack", length=solution.grounded_length, span=solution.span)
    parts = list(zip(count(1), solution.segments, solution.line.segments))
    for number, state, _ in parts:
        if state.MBL is not None and state.max_tension > state.MBL:
            carried, MBL = Measure("tension", state.max_tension), Measure("MBL", state.MBL)
            yield Message("catenary.beyond_MBL", number=number, tension=carried, MBL=MBL)
    for number, state, segment in parts:
        if isinstance(segment.EA, StrainTable):
            continue  # whose strains are its own
        if INEXTENSIBLE < segment.EA < math.inf:
            yield Message("catenary.inextensible", number=number, EA=segment.EA)
        strain = state.max_tension / segment.EA
        if strain > LARGE_STRAIN:
            values = {"number": number, "strain": 100 * strain, "limit": 100 * LARGE_STRAIN}
            yield Message("catenary.large_strain", **values)
    if solution.anchor.tension == 0.0 and solution.horizontal_force > 0.0:
        yield Message("catenary.held_by_friction")
    open_force = solution.residual.force_uncertainty
    if open_force > OPEN_FORCE * solution.fairlead.tension:
        yield Message("catenary.nearly_straight", force=open_force)


def above_water(solution: Solution, water_depth: float) -> tuple[Message, ...]:
    """Warn when the line rises above both the water and its fairlead; refuse a buoy above it."""
    check_buoys(solution.line, (state.z for state in solution.point_loads), water_depth)
    # Only a buoyant part can rise above both of its ends.
    floats = any(stretch.submerged_weight < 0.0 for stretch in solution.stretches)
    ends = (solution.fairlead_height, *(stretch.z for stretch in solution.stretches))
    top = max(solution.profile(201).z) if floats else max(ends)
    limit = max(water_depth, solution.fairlead_height)
    if top <= limit * (1.0 + 1e-9):
        return ()
    return (Message("catenary.rises", height=top - limit),)


def weighs_as_in_water(fairlead_height: float, water_depth: float) -> tuple[Message, ...]:
    """Remark on a fairlead well above the water, m: a line weighs there what it weighs below."""
    over = fairlead_height - water_depth
    return (Message("catenary.fairlead_above_water", height=over),) * (over > IN_AIR * water_depth)


def check_buoys(line: Line, heights: Iterable[float], water_depth: float) -> None:
    """Refuse a line of which a buoy would be above the water surface under its full lift.

    The heights are those of its point loads above the bed, m; those of negative weight are buoys.
    FloatsUpError names the first such buoy, how far it would be above the surface, and the way out.
    """
    for index, (load, height) in enumerate(zip(line.point_loads, heights, strict=True)):
        above = height - water_depth
        if load.submerged_weight < 0.0 and above > ROUNDING * water_depth:
            name = f" ({load.name})" if load.name else ""
            path = f"line.point_loads[{index}]{name}"
            values = {"position": load.position, "above": above, "lift": -load.submerged_weight}
            said = Message("catenary.floats_up", path=path, **values, depth=water_depth)
            raise FloatsUpError(said)


@contextmanager
def named_line(number: int) -> Iterator[None]:
    """Name the line of a system, counted from 1, whose buoy is refused within."""
    try:
        yield
    except FloatsUpError as stop:
        said = Message("mooring.of_line", number=number, warning=stop.message)
        raise FloatsUpError(said) from None
