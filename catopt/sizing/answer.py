"""What the sizings of a buoy and of a tanker share: the case that is put, and the answer."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace
from typing import Any, Final, Literal

from catopt.loads.buoy import buoy_loads
from catopt.loads.buoy_shape import BuoyShape
from catopt.loads.component import Loads
from catopt.loads.environment import WaterLevels
from catopt.loads.sinker import SinkerSize
from catopt.model import Case, LoadCase, Service, Site
from catopt.model.plausible_ranges import NAMES
from catopt.sizing.alternatives import alternatives, beside, candidates, chain_life, limits
from catopt.sizing.buoy_request import BuoyRequest
from catopt.sizing.converge import Assumed, ConvergedSizing
from catopt.sizing.environment import Environment
from catopt.sizing.in_motion import InMotion
from catopt.sizing.line_choice import LineChoice, Prefer, first_line
from catopt.sizing.pattern import SinkerGround
from catopt.sizing.result import Sizing, SwingRadius
from catopt.sizing.tanker_request import TankerRequest
from catopt.words import Message, Several, is_said, term

_LIFE_AT_REST: Final = ("sizing.worn_to_discard", "sizing.worn_to_check")


def case_of(
    request: BuoyRequest | TankerRequest, *, body: str, length: float, rest: float, **own: Any
) -> Case:
    """Make the case of one line, which has a length to begin with, m.

    `body` is what is moored, and `rest` what of the swing radius is not of the line, m.
    """
    env, line = request.environment, request.line
    kind = "buoy" if isinstance(request, BuoyRequest) else "tanker"
    return Case(
        site=Site(env.levels.high, water_density=env.water_density, accept=NAMES),
        line=first_line(line, env.water_density, length),
        load=None,
        checks=line.checks_beyond(rest),
        title=request.title or Message("sizing.title", body=body, depth=_depth(request)),
        source=request.source or f"catopt size {kind}",
        document=request.document,
        service=line.service,
        catalogue=line.catalogue,
        **own,
    )


def _depth(request: BuoyRequest | TankerRequest) -> str:
    """Say the depth in the unit in which it was given."""
    for each in request.inputs:
        if each.of.name == "depth":
            return each.said
    return Message("sizing.in_unit", value=request.environment.levels.high, unit="m")


def worn_name(load_case: str) -> Message:
    """Name a load case of the line at the end of its service life."""
    return Several((load_case, term("worn chain")), ", ")


def new_and_worn(states: Iterable[LoadCase], service: Service | None) -> tuple[LoadCase, ...]:
    """Put each state on the new line, and on the worn one where it wears.

    An everyday state is one of the new line alone.
    """
    if service is None:
        return tuple(states)
    made = []
    for each in states:
        made.append(replace(each, condition="new"))
        if each.kind == "extreme":
            made.append(replace(each, name=worn_name(each.name), condition="worn"))
    return tuple(made)


def loads_on(
    buoy: BuoyShape, env: Environment, levels: WaterLevels, assumed: Assumed, **own: Any
) -> Loads:
    """Compute the loads on a buoy and its chain; the code's own but for departures in `own`."""
    return buoy_loads(
        buoy,
        env.wind,
        env.current,
        env.sea,
        levels,
        chain_diameter=assumed.diameter,
        pull=assumed.pull,
        water_density=env.water_density,
        **own,
    )


def sizing_of(
    kind: Literal["buoy", "tanker"],
    request: BuoyRequest | TankerRequest,
    settled: ConvergedSizing,
    *,
    swing: Callable[[ConvergedSizing], SwingRadius],
    of_size: Callable[[LineChoice, float], ConvergedSizing] | None = None,
    of_line: Callable[[LineChoice], ConvergedSizing] | None = None,
    **own: Any,
) -> Sizing:
    """Put the recommended line beside others, and its sinker beside that of another rule.

    `of_size` settles the line of one size, m, `of_line` that of another preference; left out where
    the line was run in motion: others at rest say nothing beside it.
    """
    line, density, ground = request.line, request.environment.water_density, request.ground
    if isinstance(ground, SinkerGround):
        ends = [solution.anchor for _, solution in settled.point.checks.solutions]
        own["sinker"] = ground.sized_for(ends, density)
        own["other_sinker"] = ground.by_other_rule(own["sinker"], density)
    own = beside(request, settled) | own
    # What growth leaves of it, where there is any.
    posed = settled.posed.case.buoy
    if of_size is not None and of_line is not None:

        def by(prefer: Prefer) -> tuple[ConvergedSizing, float]:
            other = of_line(line.by(prefer))
            return other, swing(other).total

        but: set[Prefer] = set()
        if not request.is_priced or len(line.components) == 1:
            but.add("cheapest")  # not known, or the lightest
        if isinstance(request, TankerRequest) and request.lines > 1:
            but.add("least-swing")
        own |= {
            "candidates": candidates(
                settled, lambda name, size: of_size(line.only(name, size), size)
            ),
            "alternatives": alternatives(
                kind, line.looks_for, by, (settled, swing(settled).total), but=but
            ),
            "limits": limits(settled),
        }
    return Sizing(
        kind=kind,
        settled=settled,
        swing=swing(settled),
        dynamic_factor=line.allowance,
        motion=line.motion,
        reserve_buoyancy=request.reserve_buoyancy if posed is None else posed.reserve_buoyancy,
        defaults=request.defaults,
        inputs=request.inputs,
        **own,
    )


def in_place_of_allowance(
    of: Sizing, in_motion: InMotion, motion: Message, sinker: SinkerSize | None
) -> Sizing:
    """Put what runs in motion say in the place of what an allowance for motion would.

    A chain may wear no further than it was run. The sinker is that of the runs.
    """
    life, worn = chain_life(of.settled, in_motion.checks)
    of = replace(
        of,
        in_motion=in_motion,
        dynamic_factor=1.0,
        motion=motion,
        chain_life=life,
        advice=(
            *worn,
            *(e for e in of.advice if not any(is_said(e, key) for key in _LIFE_AT_REST)),
        ),
    )
    return of if sinker is None else replace(of, sinker=sinker)
