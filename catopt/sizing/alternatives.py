"""What stands beside the recommended line: other sizes, practice, steps that fail."""

from __future__ import annotations

from collections.abc import Callable, Container, Iterator, Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Any, Final, Literal

from catopt.casefile.reading import Moored
from catopt.catalogue.choice import chosen
from catopt.catalogue.fittings import OF_A_CHAIN, fittings_of
from catopt.catalogue.practice import Practice, practice_of_buoy, practice_of_ship
from catopt.catalogue.practice import condition as kept_condition
from catopt.checks.criteria import criteria_of
from catopt.checks.profiles import profiles_of
from catopt.checks.result import CheckReport, CheckResult
from catopt.checks.wear import least_diameters
from catopt.constants import SEA_WATER_DENSITY
from catopt.design.evaluation import DesignProblem
from catopt.design.neighbours import NoFeasibleDesignError, neighbour, steps
from catopt.errors import CatoptError, InputError, NoAnswerError
from catopt.loads.buoy_shape import BuoyShape
from catopt.loads.drag_anchor import laying_check
from catopt.loads.sinker import friction_of
from catopt.model import Anchor, Segment
from catopt.model.kinds import Height, Length, SomeMass
from catopt.quantities import QUANTITIES
from catopt.records import Record
from catopt.sizing.buoy_request import BuoyRequest
from catopt.sizing.converge import ConvergedSizing, point_diameter
from catopt.sizing.line_choice import Prefer
from catopt.sizing.pattern import SinkerGround
from catopt.sizing.tanker_request import TankerRequest
from catopt.words import Cited, Measure, Message, Several, term

Role = Literal["smaller", "recommended", "larger"]

_SAME_SIZE = 1e-6


@dataclass(frozen=True)
class Candidate(Record):
    """One size of chain, with the shortest line of it that passes under its own loads."""

    DOCUMENT = (
        "role component diameter=nominal_diameter_m feasible reason settled.point.line.length "
        "settled.point.line.mass settled.point.largest_span=offset_m "
        "settled.point.largest_force=horizontal_force_N settled.point.anchor.mass=anchor_mass_kg "
        "settled.point.checks.nearest=governing"
    )

    role: Role
    """Smaller than the recommended one, that, or larger."""
    component: str
    """Family and grade."""
    diameter: Length
    """Nominal."""
    settled: ConvergedSizing | None  # None where no length of it passes
    reason: str = ""
    """Why none passes; else empty."""

    @property
    def feasible(self) -> bool:
        """Whether a line of this size passes every check under its own loads."""
        return self.settled is not None


def candidates(
    settled: ConvergedSizing, of_size: Callable[[str, float], ConvergedSizing]
) -> tuple[Candidate, ...]:
    """Size the neighbours of a recommended line, by rising size.

    `of_size` settles loads and line for one size (m) of one component. They are less than three
    where no smaller or no larger one is sold.
    """
    component = settled.point.line.segments[0].component
    diameter = point_diameter(settled.point)
    case = settled.posed.case
    sold = chosen(case.catalogue, case.site.water_density).sold(component)
    sizes = [each.nominal_diameter for each in sold]
    smaller = [size for size in sizes if size < diameter - _SAME_SIZE][-1:]
    larger = [size for size in sizes if size > diameter + _SAME_SIZE][:1]

    def candidate(role: Role, size: float) -> Candidate:
        try:
            return Candidate(role, component, size, of_size(component, size))
        except (NoAnswerError, InputError) as error:
            return Candidate(role, component, size, None, _why_none(error))

    return (
        *(candidate("smaller", size) for size in smaller),
        Candidate("recommended", component, diameter, settled),
        *(candidate("larger", size) for size in larger),
    )


def _why_none(error: CatoptError) -> str:
    """Say in one line why no line of what was asked for passes."""
    said = error.message
    if isinstance(error, InputError):
        what = Several(problem.allowed for problem in error.problems)
        return Message("sizing.fails", what=what)
    if isinstance(error, NoFeasibleDesignError):
        if error.near_miss is not None and error.near_miss.failing:
            return Message("sizing.fails", what=error.near_miss.failing[0].in_case)
        if isinstance(said, Several):
            return said.parts[0]
    return said


@dataclass(frozen=True)
class Alternative(Record):
    """A line by another preference, under its own loads."""

    DOCUMENT = (
        "prefer feasible segment.component segment.nominal_diameter settled.point.line.length "
        "mass cost=cost_USD swing=swing_radius_m trade reason"
    )

    prefer: Prefer
    """Which line it is."""
    settled: ConvergedSizing | None  # None where no line passes
    swing: Height | None = None
    """Swing radius at low water; None without a line."""
    trade: str | None = None
    """What it gives for what beside the recommended line; None without a line."""
    reason: str = ""
    """Why none passes; else empty."""

    @property
    def feasible(self) -> bool:
        """Whether a line passes under its own loads."""
        return self.settled is not None

    @property
    def segment(self) -> Segment | None:
        """The chain of the line; None without a line."""
        return self.settled.point.line.segments[0] if self.settled else None

    @property
    def mass(self) -> SomeMass | None:
        """Of the line in air; None without a line."""
        return self.settled.point.line.mass if self.settled else None

    @property
    def cost(self) -> float | None:
        """USD, of the line's material; None without a line, or where a price is not known."""
        return self.settled.point.cost if self.settled else None


_LOOKED_AT: Final[Mapping[Moored, tuple[Prefer, ...]]] = MappingProxyType(
    {
        "buoy": ("practice", "shortest", "cheapest", "lightest"),
        "tanker": ("balanced", "cheapest", "lightest", "least-swing"),
    }
)
"""Preferences whose lines differ. Of a buoy the shortest line swings least."""


def alternatives(
    moored: Moored,
    own: Prefer,
    sized: Callable[[Prefer], tuple[ConvergedSizing, float]],
    beside: tuple[ConvergedSizing, float],
    *,
    but: Container[Prefer],
) -> tuple[Alternative, ...]:
    """Settle the lines of the preferences other than that of the recommended line.

    `sized` settles a line by a preference, and gives its swing radius, m; `beside` is the
    recommended line with its own; no line is looked for by what is in `but`.
    """
    own_line, own_swing = beside

    def alternative(prefer: Prefer) -> Alternative:
        try:
            line, swing = sized(prefer)
            if prefer == "least-swing" and swing > own_swing:
                return Alternative(prefer, None, reason=Message("sizing.swings_no_less"))
            masses = [each.point.objectives["mass_kg"] for each in (line, own_line)]
            given = trade(swing, masses[0], own_swing, masses[1])
            return Alternative(prefer, line, swing, given)
        except (NoAnswerError, InputError) as error:
            return Alternative(prefer, None, reason=_why_none(error))

    others = (each for each in _LOOKED_AT[moored] if each != own and each not in but)
    return tuple(map(alternative, others))


def trade(swing: float, mass: float, own_swing: float, own_mass: float) -> Message:
    """Say what a line gives and takes beside the recommended one.

    By the swing radius, m, and the mass in air, kg, of both.

    Examples
    --------
    >>> print(trade(369.0, 19.45e3, 382.0, 11.05e3))
    13 m less swing, 3.4 %, for 8.4 t more chain, 76 %
    """
    if (swing, mass) == (own_swing, own_mass):
        return Message("sizing.same_line")
    return Message(
        "sizing.trade",
        swing=_change("swing", "length", swing, own_swing),
        chain=_change("chain", "mass", mass, own_mass),
    )


def _change(what: str, quantity: str, own: float, other: float) -> Message:
    """Say a change in two digits or so, and its share of what changes."""
    way, change = "more" if own > other else "less", abs(own - other)
    digits = _digits(QUANTITIES[quantity].to_field(change))
    share = 100.0 * change / other
    amount = Measure(quantity, change, digits=digits)
    return Message(f"sizing.{way}_{what}", amount=amount, share=f"{share:.{_digits(share)}f}")


def _digits(value: float) -> int:
    return 0 if value >= 10.0 else 1


@dataclass(frozen=True)
class Limit(Record):
    """A step to less that the line cannot take."""

    DOCUMENT = "change words=fails"

    change: str
    """The step, in words."""
    check: CheckResult | None  # that fails by the most; None where there is no equilibrium
    reason: str = ""  # why there is none

    @property
    def words(self) -> str:
        """The check that it fails by the most with its load case, or why it has no equilibrium."""
        return self.reason if self.check is None else self.check.in_case


def limits(settled: ConvergedSizing) -> tuple[Limit, ...]:
    """List the steps to less that fail under the settled loads, each with its worst check."""
    problem = DesignProblem.of(settled.posed.case)
    found = []
    for step in steps(problem.space, settled.point.genes):
        if step.direction >= 0:
            continue
        tried = neighbour(problem, step)
        if tried.point is None:
            found.append(Limit(tried.change, None, tried.reason))
        elif not tried.point.checks.passes:
            found.append(Limit(tried.change, tried.point.checks.governing))
    return tuple(found)


def beside(request: BuoyRequest | TankerRequest, settled: ConvergedSizing) -> dict[str, Any]:
    """Gather it, by the names of the attributes of `catopt.sizing.result.Sizing`."""
    found = practice(request, settled)
    life, advice = chain_life(settled)
    if isinstance(request, BuoyRequest):
        advice += _laying(request, settled)
    return {
        "departures": tuple(departures(request)),
        "fittings": tuple(_fittings(settled)),
        "practice": "" if found is None else found.message,
        "chain_life": life,
        "advice": tuple(advice),
    }


def departures(request: BuoyRequest | TankerRequest) -> Iterator[Message]:
    """Say where the request departs from the method of the code that its line is checked by."""
    line, code = request.line, request.line.code
    method = profiles_of(line.checks)[0].method
    if method is None:
        return
    if line.allowance != method.dynamic_factor:
        yield Message("sizing.departs_factor", own=line.allowance, factor=method.dynamic_factor)
    if not isinstance(request, BuoyRequest):
        return
    if request.buoy.name and isinstance(request.buoy, BuoyShape):
        if not method.loads:
            yield Message("sizing.departs_loads", code=code)
        if request.wave_height != "hs":
            yield Message("sizing.departs_hmax")
        if request.chain_waves:
            yield Message("sizing.departs_chain")
        if request.marine_growth:
            yield Message("sizing.departs_growth")
    if method.soil:
        yield from _departs_on_soil(request.ground, method.soil)


def _departs_on_soil(ground: SinkerGround, soil: str) -> Iterator[Message]:
    """Say where a sinker on its own soil departs from the friction that the code has."""
    if ground.bond is not None:
        values = {"own": ground.mu, "adhesion": ground.bond.adhesion / 1e3}
        yield Message("sizing.departs_clay", **values)
    elif ground.mu != friction_of(soil)[0]:
        yield Message("sizing.departs_friction", own=ground.mu)


def practice(request: BuoyRequest | TankerRequest, settled: ConvergedSizing) -> Practice | None:
    """Set the line beside what is laid for such a buoy, or carried by such a ship."""
    diameter, length = point_diameter(settled.point), settled.point.line.length
    env = request.environment
    if isinstance(request, TankerRequest):
        # The equipment number is that of the loaded ship.
        loaded = (each.ship for each in request.ships if each.condition == "loaded")
        ship = next(loaded, None)
        if ship is None:
            return None
        return practice_of_ship(
            diameter,
            length,
            displacement=ship.displacement * SEA_WATER_DENSITY,
            front=ship.frontal_area,
            side=ship.lateral_area,
        )
    buoy = request.buoy
    if not isinstance(buoy, BuoyShape):
        return None
    known = buoy.chain_min is not None and buoy.chain_max is not None
    return practice_of_buoy(
        diameter,
        length,
        buoy_diameter=buoy.widest,
        depth=env.levels.high,
        current=env.current.speed,
        chain_limits=(buoy.chain_min or 0.0, buoy.chain_max or 0.0) if known else None,
    )


def chain_life(
    settled: ConvergedSizing, moved: CheckReport | None = None
) -> tuple[float | None, list[Message]]:
    """Find after which time the chain is to be changed, s, and say why; None where it stays new.

    It is to be changed when a check of its worn line is overrun, when so much of its diameter is
    gone that authorities discard it, or when it is thinner than it was run in motion, `moved`.
    """
    case, point = settled.case, settled.point
    service, new = case.service, point_diameter(point)
    if service is None or service.wear_rate == 0.0:
        return None, []
    anchor = point.anchor or case.anchor
    found = least_diameters(
        point.checks, criteria_of(replace(case, anchor=anchor)), point.line, case, moved
    )
    if not found or found[0].limit is None:
        return None, []
    life = (new - found[0].limit) / service.wear_rate
    key = "sizing.worn_to_check" if found[0].is_by_checks else "sizing.worn_to_discard"
    kept = kept_condition()
    values = {"diameter": 1e3 * found[0].limit, "part": 100.0 * kept.discard}
    return life, [Message(key, source=kept.origin.text, reason=found[0].reason, **values)]


def _fittings(settled: ConvergedSizing) -> Iterator[Message]:
    """Say which shackle, swivel and ring go with the chain, or which is missing."""
    segment = settled.point.line.segments[0]
    is_dragged = settled.posed.drag_anchor is not None
    uses = [use for use in OF_A_CHAIN if not (is_dragged and use == "sinker ring")]
    found = fittings_of(segment, uses)
    if found is None:
        return
    if found.weakest is not None:
        sizes = (
            Message("sizing.fitting_size", use=term(use), size=1e3 * each.size)
            for use, each in found.found.items()
        )
        weakest = Measure("MBL", found.weakest.MBL)
        yield Message("sizing.fittings", sizes=Several(sizes, ", "), MBL=weakest)
    for use, each in found.found.items():
        mass = Message("sizing.fitting_mass", mass=each.mass) if each.mass else ""
        yield Message(
            "sizing.fitting",
            use=term(use),
            title=each.title,
            size=1e3 * each.size,
            MBL=Measure("MBL", each.MBL),
            mass=mass,
            source=Cited(f"{each.sources[0].title} [{each.confidence}]"),
        )
    yield from found.missing.values()


def _laying(request: BuoyRequest, settled: ConvergedSizing) -> Iterator[Message]:
    """Say whether the buoy floats while chain and sinker hang on it, when it is laid."""
    anchor = settled.point.anchor
    if not isinstance(request.buoy, BuoyShape) or not isinstance(anchor, Anchor):
        return
    segment = settled.point.line.segments[0]
    check = laying_check(
        request.buoy,
        segment.length * segment.submerged_weight,
        anchor.submerged_weight or 0.0,
        water_density=request.environment.water_density,
    )
    key = "sizing.laid_hanging" if check.utilisation <= 1.0 else "sizing.laid_by_crane"
    yield Message(key, used=check.utilisation, source=check.source.text)
