"""What holds the lines at the bed, and several equal lines around a body."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Annotated, Any, Final, Literal, NamedTuple

from catopt.catenary.solve import solve
from catopt.errors import InputError, NoAnswerError
from catopt.largest import largest
from catopt.loads.drag_anchor import DataSet, DragAnchorSize, size_drag_anchor
from catopt.loads.ship import SINKER_MASSES
from catopt.loads.sinker import (
    DENSITIES,
    FACTOR_SOURCE,
    SAFETY_FACTOR,
    Bond,
    Material,
    SinkerSize,
    bond_of,
    friction_of,
    size_sinker,
)
from catopt.model import Anchor, Case, DesignLoad, Line, SinkerChoice, System
from catopt.model.kinds import Angle, Findings, Force, Height, SomeForce
from catopt.mooring.case import load_sharing_factor
from catopt.mooring.solution import SystemSolution, solution_at
from catopt.mooring.zero_load import BodyRest, Lines, ZeroLoadPosition, zero_load_position
from catopt.records import Counted, From, Record
from catopt.sizing.kinds import usual
from catopt.words import Message, Sentence

if TYPE_CHECKING:
    from catopt.catenary.solution import EndState
    from catopt.checks.case import Pull

HEAVY_SINKERS: Final = (
    *SINKER_MASSES,
    *(1e3 * tonnes for tonnes in (80, 100, 125, 150, 200, 250, 300, 400, 500, 600, 800, 1000)),
)
"""kg, in air: `SINKER_MASSES` and what is cast for ships; catopt's own list."""

CALMAR_SOIL: Final = "IALA default"
"""The friction of IALA's CALMAR, 1.0 on any ground."""

SAND: Final = "fine or silty sand"
"""Taken of a ground of which nothing is said, by a code that has no friction of its own."""


@dataclass(frozen=True)
class SinkerGround:
    """A sinker on a soil."""

    # a key of `catopt.loads.sinker.SOIL_FRICTION` or `ADHESION`; None where `friction` is given
    soil: str | None = CALMAR_SOIL
    friction: float | None = None  # tan(delta) of one's own
    material: Material = "concrete"  # of the sinker
    density: float | None = None  # kg/m3; None: that of the material
    base_area: float | None = None  # of its base, m2; None: that of a cast block
    embedment: float = 0.0  # how deep it has sunk into a clay, m
    safety_factor: float = SAFETY_FACTOR  # on sliding; used where the code has none of its own

    def __post_init__(self) -> None:
        self.sized(0.0, 0.0, 1025.0)

    @property
    def mu(self) -> float:
        """Friction on the soil."""
        if self.friction is not None:
            return self.friction
        assert self.soil is not None
        return friction_of(self.soil, self.material)[0]

    @property
    def bond(self) -> Bond | None:
        """What a clay holds on the base; None of any other soil."""
        return bond_of(self.soil, self.material, self.base_area, self.embedment)

    @property
    def rho(self) -> float:
        """Density of the sinker, kg/m3."""
        return DENSITIES[self.material] if self.density is None else self.density

    @property
    def is_usual_factor(self) -> bool:
        """Whether the factor on sliding is IALA's, which is taken unless another is given."""
        return self.safety_factor == SAFETY_FACTOR

    def choice(self, *, coded: bool, heavy: bool = False) -> SinkerChoice:
        """Make the sinkers that a design chooses from, with those for ships where `heavy`.

        `coded`: the code that is checked has a factor on sliding, which then holds.
        """
        masses = HEAVY_SINKERS if heavy else SINKER_MASSES
        bond = self.bond
        return SinkerChoice(
            masses=masses,
            density=self.rho,
            friction=self.mu,
            base_holdings=()
            if bond is None
            else tuple(bond.holding(mass, self.rho) for mass in masses),
            safety_factor=None if coded else self.safety_factor,
            factor_source="" if coded or not self.is_usual_factor else FACTOR_SOURCE.text,
        )

    def by_other_rule(self, of: SinkerSize, water_density: float) -> SinkerSize | None:
        """Size it for the same pull by the rule that was not chosen; None beyond what is cast.

        One rule takes the friction of the soil (NAVFAC), the other phi = 45 deg whatever the soil
        (IALA CALMAR). They differ by a factor of two and more.
        """
        soil = SAND if self.soil == CALMAR_SOIL else CALMAR_SOIL
        try:
            other = replace(self, soil=soil, friction=None, embedment=0.0)
            return other.sized(of.horizontal_force, of.vertical_force, water_density)
        except NoAnswerError:
            return None

    def sized(
        self, horizontal_force: float, vertical_force: float, water_density: float
    ) -> SinkerSize:
        """Size a sinker for a pull of the line on it, N, with its sources and notes."""
        return size_sinker(
            horizontal_force,
            vertical_force,
            soil=self.soil,
            friction=self.friction,
            material=self.material,
            density=self.density,
            base_area=self.base_area,
            embedment=self.embedment,
            safety_factor=self.safety_factor,
            water_density=water_density,
            series=HEAVY_SINKERS,
        )

    def sized_for(self, ends: Sequence[EndState | Pull], water_density: float) -> SinkerSize:
        """Size a sinker for the largest pulls of lines, each at its end on the bed."""
        pull = max((each.horizontal_force for each in ends), default=0.0)
        lift = max((0.0, *(each.vertical_force for each in ends)))
        return self.sized(pull, lift, water_density)


@dataclass(frozen=True)
class DragGround:
    """A drag anchor in a soil."""

    # one of `catopt.loads.drag_anchor.ANCHORS` and of `SOILS`
    anchor: str = field(default_factory=lambda: usual("anchor", "tanker"))
    soil: str = field(default_factory=lambda: usual("soil", "tanker"))
    # data set, or "lower": the lowest of those that have the anchor
    data: DataSet | Literal["lower"] = "lower"
    # on the ultimate capacity; None: that of UFC table 3-7 for its kind
    safety_factor: float | None = None
    allow_recalled: bool = False  # whether recalled figures (R) may stand alone

    def __post_init__(self) -> None:
        found = Findings("DragGround")
        found.numbers(self, "", "safety_factor", at_least=1.0)
        found.raise_if_any()
        self.sized(0.0)

    def sized(self, horizontal_force: float) -> DragAnchorSize:
        """Size an anchor for a horizontal pull, N."""
        return size_drag_anchor(
            self.anchor,
            self.soil,
            horizontal_force,
            safety_factor=self.safety_factor,
            data=self.data,
            allow_recalled=self.allow_recalled,
        )

    def held(self, size: DragAnchorSize) -> Anchor:
        """Make the anchor of a case out of what `sized` gave."""
        return Anchor(
            kind="drag",
            holding_capacity=size.capacity.capacity,
            safety_factor=size.safety_factor,
            factor_source="" if size.factor_source is None else size.factor_source.text,
            mass=size.mass,
        )


_SAMPLES: Final = 5
"""Directions of the force from against a line to half way to the next one."""

_HEADINGS: Final = 4
"""Directions of the force a line, of the search for whole moorings."""

_GOLDEN: Final = (math.sqrt(5.0) - 1.0) / 2.0
_SECTIONS: Final = 12
"""Golden sections: to a hundredth of a sample's step, about which a largest value is level."""


class BodyState(NamedTuple):
    """A load case of the body."""

    load_case: str
    force: float  # on the body, N
    fairlead_height: float  # above the seabed, m


@dataclass(frozen=True)
class AtRest:
    """The body at rest under the force from its hardest side."""

    direction: Angle
    """Between the most loaded line, without one between line 1, and where the force comes from."""
    line_force: SomeForce
    """Horizontal, of the most loaded line at the fairlead."""
    tension: SomeForce
    """Of that line at the fairlead."""
    offset: Height
    """Of the body from its place with all lines under no load: the largest, wherever the force
    comes from and whichever line is gone."""
    pull: Force
    """The largest of the lines together downwards on the body."""
    solution: SystemSolution  # under the force that is hardest on a line


@dataclass(frozen=True)
class WithoutLine(AtRest, Record):
    """The body at rest anew without one of its lines."""

    DOCUMENT = "missing=missing_line direction line_force tension offset pull"

    missing: Counted
    """The line without which another one carries the most; the force comes nearest to line 1."""


@dataclass(frozen=True)
class PatternState(AtRest, Record):
    """The body at rest in one load case."""

    DOCUMENT = (
        "load_case force rule_force line_force tension direction offset pull line_out=one_line_out"
    )

    load_case: str
    """Its name."""
    force: SomeForce
    """On the body."""
    rule_force: SomeForce | None
    """Horizontal, of the most loaded line by the rule of practice of S4; None where it wants
    another number of lines."""
    fairlead_height: float  # above the seabed, m
    line_out: WithoutLine
    """The same with any one line gone."""


@dataclass(frozen=True)
class Pattern(Record):
    """A symmetric pattern of equal lines."""

    DOCUMENT = "lines pretension anchor_radius states"

    lines: Annotated[int, From(3)]
    """How many, evenly spaced."""
    pretension: SomeForce
    """Horizontal, of every line under no load, at high water without a crest."""
    anchor_radius: Height
    """From the body to the anchors."""
    states: tuple[PatternState, ...]
    """One for each load case."""

    @property
    def system(self) -> System:
        """With all lines, under the load case of the largest force in a line."""
        return self.hardest.solution.system

    @property
    def warnings(self) -> tuple[str, ...]:
        """What is to be known of the equilibrium, each once."""
        said = (w for each in self.states for w in each.solution.warnings)
        return tuple(dict.fromkeys(map(Sentence, said)))

    @property
    def hardest(self) -> PatternState:
        """The load case of the largest horizontal force in a line."""
        return largest(self.states, lambda state: state.line_force)

    def state_in(self, load_case: str) -> PatternState:
        """Return the body at rest in a load case, by its name."""
        return next(each for each in self.states if each.load_case == load_case)

    @property
    def largest_pull(self) -> float:
        """Of all lines downwards on the body, with each there or one gone, N."""
        return max(max(state.pull, state.line_out.pull) for state in self.states)


def shared_force(force: float, lines: int) -> float:
    """Estimate the horizontal force of the most loaded of 3 or more lines, N.

    The rule of practice of S4, F = FT/(N/4), where it applies; for other numbers of lines F =
    4 FT/N, and never more than all of it. It is where the sizing begins: the equilibrium decides.
    """
    rule = _rule(force, lines)
    return min(force, 4.0 * force / lines) if rule is None else rule


def pattern(
    line: Line,
    lines: int,
    states: Sequence[BodyState],
    *,
    pretension: float,
    still_height: float,
    seabed_friction: float = 0.0,
) -> Pattern:
    """Solve the body at rest in every load case, under forces from the sides that count.

    The lines are evenly spaced; the pretension is the horizontal force under no load, N, with the
    fairlead at `still_height`, m. Raises what `solve_system` raises.
    """
    reach = solve(
        line, height=still_height, horizontal_force=pretension, seabed_friction=seabed_friction
    ).span
    azimuths = [2.0 * math.pi * k / lines for k in range(lines)]
    base = System.around(
        line,
        azimuths=azimuths,
        anchor_radius=reach,
        fairlead_height=still_height,
        seabed_friction=seabed_friction,
    )
    found = (
        _state(base.raised(each.fairlead_height - still_height), each, lines) for each in states
    )
    return Pattern(lines, pretension, reach, tuple(found))


def system_case(case: Case, of: Pattern) -> Case:
    """Make the case of the whole pattern, which every command takes; it has the hardest load case.

    Its design is the search for whole moorings, under every load from all sides.
    """
    state = of.hardest
    rise = state.fairlead_height - case.fairlead_height
    design = case.design
    if design is not None:
        base = state.fairlead_height
        design = replace(
            design,
            sinker=None,  # a mooring is searched with the anchor of the case
            pretensions=(of.pretension,),
            loads=tuple(
                DesignLoad(
                    each.load_case,
                    each.force,
                    direction=math.pi,
                    headings=_HEADINGS * of.lines,
                    fairlead_rise=each.fairlead_height - base,
                    line_out=True,
                )
                for each in of.states
            ),
        )
    return replace(
        case,
        title=f"{case.title}: {of.lines} lines, {state.load_case}",
        site=replace(case.site, water_depth=case.site.water_depth + rise),
        fairlead_height=state.fairlead_height,
        load_cases=(),
        design=design,
        system=of.system,
    )


class _Under(NamedTuple):
    """The body at rest under the force towards an angle, counter-clockwise from line 1, rad."""

    towards: float
    rest: BodyRest
    lines: Lines
    offset: float  # from where it rests with all lines and no load, m

    @property
    def line_force(self) -> float:
        """Horizontal force of the most loaded line, N."""
        return float(max(self.lines.H))

    @property
    def pull(self) -> float:
        """Of all lines downwards, N."""
        return math.fsum(self.lines.V)


def _state(system: System, state: BodyState, lines: int) -> PatternState:
    """Find what is hardest on the lines in a load case, with all of them and without any one.

    Equal lines evenly spaced: with all there a force from between a line and half way to the next
    says all, and with one gone it does not matter which, so that line 1 goes and the force comes
    from either side of it.
    """
    zero = zero_load_position(system)
    whole = _hardest(zero, zero, state.force, (0.0, math.pi / lines), _SAMPLES)
    try:
        left = zero_load_position(system.without([0]))
        without = _hardest(left, zero, state.force, (0.0, math.pi), 4 * lines + 1)
    except NoAnswerError as error:
        values = {"number": 1, "load_case": state.load_case, "why": error.args[0]}
        raise NoAnswerError(Message("sizing.no_rest", **values)) from error
    missing, off = _seen_from_nearest(without.pop("towards"), lines)
    towards = whole.pop("towards")
    return PatternState(
        **whole,
        **state._asdict(),
        direction=abs(math.remainder(towards + math.pi, 2.0 * math.pi / lines)),
        rule_force=_rule(state.force, lines),
        line_out=WithoutLine(**without, direction=off, missing=missing),
    )


def _hardest(
    of: ZeroLoadPosition,
    whole: ZeroLoadPosition,
    force: float,
    between: tuple[float, float],
    samples: int,
) -> dict[str, Any]:
    """Find the figures of `AtRest`, each towards the direction that makes it the largest."""
    neutral = whole.neutral

    def under(towards: float) -> _Under:
        pushed = force * math.cos(towards), force * math.sin(towards)
        rest, lines = of.under(pushed)
        return _Under(towards, rest, lines, math.hypot(rest.x - neutral.x, rest.y - neutral.y))

    first, last = between
    step = (last - first) / (samples - 1)
    sampled = [under(first + step * k) for k in range(samples)]

    def worst(measure: Callable[[_Under], float]) -> _Under:
        best = largest(sampled, measure)
        if best is sampled[0] or best is sampled[-1]:
            return best  # both ends are directions of symmetry, where a largest value is level
        low, high = max(first, best.towards - step), min(last, best.towards + step)
        return largest((best, _climbed(under, measure, low, high)), measure)

    hardest = worst(lambda each: each.line_force)
    pushed = force * math.cos(hardest.towards), force * math.sin(hardest.towards)
    at = replace(of, system=of.system.under(pushed))
    solution = solution_at(at, hardest.rest, hardest.lines, looks_round=False)
    return {
        "towards": hardest.towards,
        "line_force": hardest.line_force,
        "tension": max(line.tension for line in solution.lines),
        "offset": worst(lambda each: each.offset).offset,
        "pull": worst(lambda each: each.pull).pull,
        "solution": solution,
    }


def _climbed(
    under: Callable[[float], _Under], measure: Callable[[_Under], float], low: float, high: float
) -> _Under:
    """Climb to the largest value between two directions by golden sections."""
    inner = [high - _GOLDEN * (high - low), low + _GOLDEN * (high - low)]
    found = [under(each) for each in inner]
    for _ in range(_SECTIONS):
        if measure(found[0]) >= measure(found[1]):
            high = found[1].towards
            found = [under(high - _GOLDEN * (high - low)), found[0]]
        else:
            low = found[0].towards
            found = [found[1], under(low + _GOLDEN * (high - low))]
    return largest(found, measure)


def _seen_from_nearest(towards: float, lines: int) -> tuple[int, float]:
    """Return the number of the lost line, from 1, where the force comes nearest to line 1.

    And how far off line 1 it comes, rad.

    `towards` is where the force acts where line 1 is the one that is gone, rad.
    """
    gap = 2.0 * math.pi / lines
    comes_from = towards + math.pi
    nearest = round(comes_from / gap)
    off = comes_from - nearest * gap
    gone = -nearest if off >= 0.0 else nearest  # the mirror image, so that it comes from one side
    return gone % lines + 1, abs(off)


def _rule(force: float, lines: int) -> float | None:
    try:
        return force / load_sharing_factor(lines)
    except InputError:
        return None
