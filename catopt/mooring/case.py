"""A case with a moored body: its equilibrium, and what else is asked of it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Annotated

from catopt.catenary.case import of_accepted
from catopt.catenary.solution import above_water, named_line, weighs_as_in_water
from catopt.display import Displayable
from catopt.errors import InputError, NoAnswerError, Problem
from catopt.model import Case, System
from catopt.model.kinds import Findings, Place, SomeForce, Stiffness
from catopt.model.network import Network
from catopt.mooring.fixed_body import at_displacement
from catopt.mooring.network_rest import FloatingBody, HeldBody, LinesAtRest
from catopt.mooring.restoring import (
    Response,
    RestoringCurve,
    WatchCircle,
    response_of,
    restoring_curve,
    unloaded,
    watch_circle,
)
from catopt.mooring.solution import SystemSolution, of_line, solution_at, solve_system
from catopt.mooring.zero_load import zero_load_position
from catopt.old_names import OldName
from catopt.progress import paced
from catopt.records import OrNull, Record, within
from catopt.words import Message

FEWEST_LINES = 4
"""Two lines carry FT = F, not the half of F that N / 4 would say."""


def load_sharing_factor(lines: int) -> float:
    """Force that the lines carry together, over the horizontal force of the most loaded one.

    The rule of practice (ARGEMA) that S4 quotes: for N evenly spaced lines and a force along one of
    them, that line carries F and the others of the loaded half F cos(angle), each along itself.
    Lines a quarter turn or more away carry nothing. The sum along the force is (N / 4) F.

    It is the balance of equal lines without pretension whose pull grows in proportion to how far
    they are drawn out. It is no equilibrium of catenaries, which stiffen as they are drawn out and
    pull on the other side too. InputError: fewer than 4 lines, or an odd number.

    Examples
    --------
    >>> round(load_sharing_factor(6), 12)
    1.5
    """
    if lines < FEWEST_LINES or lines % 2:
        problem = Problem("lines", str(lines), Message("refused_motion.sharing_rule"))
        raise InputError([problem], "load sharing")
    last = (lines - 1) // 4
    shares = [math.cos(2.0 * math.pi * k / lines) for k in range(-last, last + 1)]
    return math.fsum(share * share for share in shares)


SAME_ANGLE = 1e-6
"""rad within which lines count as evenly spaced, and a force as along one of them."""


@dataclass(frozen=True)
class SharingRule(Record):
    """What the rule of practice for load sharing says of the most loaded line.

    In Python lines count from 0.
    """

    DOCUMENT = "applies line+1=line horizontal_force why_not"

    horizontal_force: SomeForce | None
    """Of that line; None where the rule does not apply."""
    line: int | None = None
    """The line that lies against the force; None where the rule does not apply."""
    why_not: str = ""
    """What bars the rule; empty where it applies."""

    @property
    def applies(self) -> bool:
        """Whether the system is one that the rule is made for."""
        return self.horizontal_force is not None


def sharing_rule(system: System) -> SharingRule:
    """Put the rule of practice on a system under its load.

    It wants an even number of equal, evenly spaced lines, 4 or more, and a force along one of
    them: then that line carries the force over N/4 (catopt.mooring.case).
    """
    count = len(system.legs)
    if count < FEWEST_LINES or count % 2:
        return _not("even", count=count)
    first = system.legs[0]
    for leg in system.legs:
        is_same = leg.line == first.line and leg.anchor_radius == first.anchor_radius
        if not is_same or leg.fairlead_height != first.fairlead_height:
            return _not("equal")
    turns = sorted((leg.azimuth - first.azimuth) % (2.0 * math.pi) for leg in system.legs)
    for index, turn in enumerate(turns):
        even = 2.0 * math.pi * index / count
        if min(abs(turn - even), abs(turn - even - 2.0 * math.pi)) > SAME_ANGLE:
            return _not("spaced")
    force = math.hypot(*system.force)
    if force == 0.0 or system.moment != 0.0:
        return _not("force")
    against = math.atan2(-system.force[1], -system.force[0])
    for index, leg in enumerate(system.legs):
        away = math.remainder(leg.azimuth - against, 2.0 * math.pi)
        if abs(away) <= SAME_ANGLE:
            return SharingRule(force / load_sharing_factor(count), index)
    return _not("along")


def _not(wanted: str, **values: object) -> SharingRule:
    return SharingRule(None, None, Message(f"mooring.wants_{wanted}", **values))


@dataclass(frozen=True)
class AtLevel(Record):
    """The system under its own load at one water level."""

    DOCUMENT = "level response stiffness floating?"

    level: Place
    """Above that of the case."""
    response: Response
    """The body and its lines at that level, from the zero-load position there."""
    stiffness: tuple[
        Annotated[tuple[Stiffness, Stiffness], OrNull],
        Annotated[tuple[Stiffness, Stiffness], OrNull],
    ]
    """-d(Fx, Fy)/d(x, y) of a body that is free."""
    floating: FloatingBody | None = None
    """How the body floats there; None of one that is held, or on lines of its own."""


def at_levels(mooring: System | Network, levels: Sequence[float]) -> tuple[AtLevel, ...]:
    """Solve a mooring at several water levels; every fairlead rises and falls with the water.

    The body is under its load; levels are above that of the case, m. Fairleads that are held go up
    and down, too, and floats of their own.

    Raises
    ------
    InputError
        When a level brings a fairlead below the bed, or free bodies are several.
    NoEquilibriumError, NotConvergedError
        As for `solve_system`.
    """
    found = Findings("water levels")
    for index, level in enumerate(levels):
        found.number(f"levels[{index}]", float(level), "m", at_least=-mooring.lowest_fairlead)
    found.raise_if_any()
    answers = []
    for level in paced(Message("words.levels", total=len(levels)), levels):
        loaded = unloaded(mooring.raised(float(level)), "level", by_own_load=True).own()
        at = (loaded.response, loaded.stiffness, loaded.floating)
        answers.append(AtLevel(float(level), *at))
    return tuple(answers)


@dataclass(frozen=True)
class LineOut(Record):
    """The system without one of its lines, under its own load; in Python lines count from 0."""

    DOCUMENT = "missing+1=missing_line response refusal"

    missing: int
    """The line that is gone."""
    response: Response | None
    """The body and its lines at rest: the offset counts from the intact system's zero-load
    position, lines as the intact system's; None where there is no equilibrium."""
    refusal: str = ""
    """Why there is no equilibrium; empty where there is one."""
    solution: SystemSolution | None = None
    """The lines that are left, in their order; None where there is no equilibrium."""

    def intact_number(self, index: int) -> int:
        """Turn the number of a line among those left into that of the intact system, from 0."""
        return index + (index >= self.missing)


def one_line_out(system: System) -> tuple[LineOut, ...]:
    """Take each line away in turn, the load as it is, and let the body come to rest anew.

    What happens on the way there, when the line parts, is dynamics and not looked at.

    Raises
    ------
    NoEquilibriumError, NotConvergedError
        When the intact system has no zero-load position, or a solver stopped short.
    """
    zero = zero_load_position(system).neutral
    found = []
    count = len(system.legs)
    for missing in paced(Message("words.lines_out", total=count), range(count)):
        if len(system.legs) == 1:
            found.append(LineOut(missing, None, Message("mooring.no_line_left")))
            continue
        try:
            left = zero_load_position(system.without([missing]))
            rest, lines = left.under(system.force, system.moment)
        except NoAnswerError as error:
            found.append(LineOut(missing, None, error.args[0]))
            continue
        response = response_of(left, rest, lines, zero)
        out = LineOut(missing, response, solution=solution_at(left, rest, lines))
        most_loaded = out.intact_number(response.most_loaded)
        found.append(replace(out, response=replace(response, most_loaded=most_loaded)))
    return tuple(found)


CURVE_POINTS = 41


@dataclass(frozen=True, repr=False)
class SystemReport(Displayable, Record):
    """A body moored by several lines, at rest, by closed form, and what else was asked of it.

    Directions are counter-clockwise from x; lines count from 1, in the order of the case.
    """

    SCHEMA = SystemSolution.SCHEMA
    DOCUMENT = (
        f"{within('solution', SystemSolution.DOCUMENT)} rule=sharing_rule line_out=one_line_out? "
        "circle=watch_circle? curves=restoring_curves? levels=water_levels? "
        "at_displacement=held_body?"
    )

    case: Case
    solution: SystemSolution
    rule: SharingRule
    """What the rule of practice for load sharing says of the most loaded line."""
    line_out: tuple[LineOut, ...] = ()
    """Only when asked for: the system without each of its lines, under the same load. Offsets count
    from the intact system's zero-load position."""
    circle: WatchCircle | None = None
    """Only when asked for: a force of the size of the case's, from all sides; None where it has
    none."""
    curves: tuple[RestoringCurve, ...] = ()
    """Only when asked for: the body held at offsets along a direction."""
    levels: tuple[AtLevel, ...] = ()
    """Only when asked for: the same load at other water levels."""
    at_displacement: tuple[HeldBody, ...] = ()
    """Only when asked for: load and linearised stiffness of the lines in six freedoms. Surge, sway,
    heave along x, y, z (up); roll, pitch, yaw about them."""

    held = OldName("at_displacement")


def report_system(
    case: Case,
    *,
    with_line_out: bool = False,
    with_circle: bool = False,
    directions: Sequence[float] = (),
    levels: Sequence[float] = (),
    with_stiffness: bool = False,
    displacements: Sequence[tuple[float, ...]] = (),
) -> SystemReport:
    """Solve the system of a case, and what else is asked.

    Directions of restoring curves in rad, water levels above that of the case in m. The stiffness
    in six freedoms is of where the body rests, and of each displacement: surge, sway, heave (m),
    roll, pitch, yaw (rad). Errors as for `solve_system` and `at_displacement`; FloatsUpError for a
    buoy that would float above the water surface.
    """
    system = case.own_system
    solution = solve_system(system)
    above: list[str] = [*weighs_as_in_water(case.fairlead_height, case.site.water_depth)]
    for number, line in enumerate(solution.lines, start=1):
        with named_line(number):
            warnings = above_water(line.solution, case.site.water_depth)
        above += (of_line(number, warning) for warning in warnings)
    solution = replace(
        solution,
        title=case.title,
        safety_factor=case.checks.safety_factor,
        warnings=(*of_accepted(case), *solution.warnings, *above),
    )
    size = math.hypot(*system.force)
    rest = solution.position
    own = [(rest.x, rest.y, 0.0, 0.0, 0.0, rest.yaw)] if with_stiffness else []
    places = [*own, *displacements]
    offsets = _offsets(math.hypot(*solution.offset), max(leg.anchor_radius for leg in system.legs))
    return SystemReport(
        case,
        solution,
        sharing_rule(system),
        line_out=one_line_out(system) if with_line_out else (),
        circle=watch_circle(system, force=size) if with_circle and size > 0.0 else None,
        curves=tuple(
            restoring_curve(system, direction=each, offsets=offsets) for each in directions
        ),
        levels=at_levels(system, levels),
        at_displacement=tuple(
            at_displacement(system, origin_height=case.site.water_depth, displacement=each)
            for each in paced(Message("words.held_places", total=len(places)), places)
        ),
    )


def _offsets(offset: float, radius: float) -> list[float]:
    """Go both ways, half as far again as under a load, or else a hundredth of a radius; m."""
    far = 1.5 * offset if 1.5 * offset >= 1e-6 else 0.01 * radius
    middle = CURVE_POINTS // 2
    return [far * (k - middle) / middle for k in range(CURVE_POINTS)]


def network_curves(rest: LinesAtRest, directions: Sequence[float]) -> tuple[RestoringCurve, ...]:
    """Move the one free body of a network, or all that is held, along directions, rad."""
    network = rest.network
    ends = [p for p in network.points if p.kind == "fairlead"]
    middle = [math.fsum(p.place[i] for p in ends) / max(len(ends), 1) for i in (0, 1)]
    offset = 0.0
    if len(rest.bodies) == 1:
        (body,) = rest.bodies
        middle, offset = [body.body.x, body.body.y], math.hypot(*body.offset)
    anchors = [p.place[:2] for p in network.points if p.kind == "anchor"]
    radius = max((math.dist(place, middle) for place in anchors), default=0.0)
    offsets = _offsets(offset, radius)
    return tuple(restoring_curve(network, direction=each, offsets=offsets) for each in directions)
