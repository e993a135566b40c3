"""A case with a moored body: its equilibrium, and what else is asked of it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

from catopt.catenary.solution import above_water, named_line, weighs_as_in_water
from catopt.errors import InputError, Problem
from catopt.model import Case, System
from catopt.mooring.circle import WatchCircle, watch_circle
from catopt.mooring.held import at_displacement
from catopt.mooring.line_out import LineOut, one_line_out
from catopt.mooring.network_rest import HeldBody, LinesAtRest
from catopt.mooring.restoring import RestoringCurve, network_curve, restoring_curve
from catopt.mooring.sharing_rule import SharingRule, sharing_rule
from catopt.mooring.solution import SystemSolution
from catopt.mooring.solve import of_line, solve_system
from catopt.mooring.water_level import AtLevel, at_levels
from catopt.old_names import OldName
from catopt.patience import paced
from catopt.records import Record, within
from catopt.shown import Displayable
from catopt.words import Message

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
    system = case.system
    if system is None:
        wanted = Message("refused_motion.missing_table_system_with_anchor")
        raise InputError([Problem("system", "", wanted)])
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
        warnings=(*solution.warnings, *above),
    )
    size = math.hypot(*system.force)
    rest = solution.position
    own = [(rest.x, rest.y, 0.0, 0.0, 0.0, rest.yaw)] if with_stiffness else []
    places = [*own, *displacements]
    return SystemReport(
        case,
        solution,
        sharing_rule(system),
        line_out=one_line_out(system) if with_line_out else (),
        circle=watch_circle(system, force=size) if with_circle and size > 0.0 else None,
        curves=tuple(_curve(system, solution, direction) for direction in directions),
        levels=at_levels(system, levels),
        at_displacement=tuple(
            at_displacement(system, origin_height=case.site.water_depth, displacement=each)
            for each in paced(Message("words.held_places", total=len(places)), places)
        ),
    )


def _curve(system: System, solution: SystemSolution, direction: float) -> RestoringCurve:
    """Hold the body at offsets both ways, half as far again as under the load of the case."""
    radius = max(leg.anchor_radius for leg in system.legs)
    offsets = _offsets(math.hypot(*solution.offset), radius)
    return restoring_curve(system, direction=direction, offsets=offsets)


def _offsets(offset: float, radius: float) -> list[float]:
    """Go both ways, half as far again as under a load, or else a hundredth of a radius; m."""
    far = 1.5 * offset
    if far < 1e-6:
        far = 0.01 * radius
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
    return tuple(network_curve(network, direction=each, offsets=offsets) for each in directions)
