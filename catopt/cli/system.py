"""``catopt system``: a body moored by several lines."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING, Annotated, Any, NamedTuple

import typer

from catopt.answers.system import network_answer, system_answer
from catopt.casefile.reading import read_mooring_or_design
from catopt.cli.answering import Asked, answering
from catopt.cli.options import CaseArgument, DesignOption, OutOption
from catopt.cli.values import for_one_line, in_si, refused
from catopt.model.network import Network
from catopt.progress import paced
from catopt.units import Dimension
from catopt.words import Message, say

if TYPE_CHECKING:
    from catopt.model import Case


@answering(OutOption)
def system(
    asked: Asked,
    case: CaseArgument,
    design: DesignOption = None,
    line_out: Annotated[bool, typer.Option("--line-out")] = False,
    watch_circle: Annotated[bool, typer.Option("--watch-circle")] = False,
    curve: Annotated[list[str] | None, typer.Option(metavar="ANGLE")] = None,
    level: Annotated[list[str] | None, typer.Option(metavar="HEIGHT")] = None,
    stiffness: Annotated[bool, typer.Option("--stiffness")] = False,
    held: Annotated[list[str] | None, typer.Option(metavar="SIX")] = None,
) -> None:
    """Find where a moored body comes to rest, and what each of its lines carries."""
    asked.check_place()
    wanted = Wanted(
        _in_si("--curve", curve, Dimension.ANGLE),
        _in_si("--level", level, Dimension.LENGTH),
        [_displacement(text) for text in held or []],
        line_out=line_out,
        circle=watch_circle,
        stiffness=stiffness,
    )
    answer_mooring(asked, read_mooring_or_design(case, design), wanted)


class Wanted(NamedTuple):
    """What is required of a mooring beside where it comes to rest."""

    directions: Sequence[float] = ()
    levels: Sequence[float] = ()
    displacements: Sequence[tuple[float, ...]] = ()
    line_out: bool = False
    circle: bool = False
    stiffness: bool = False


def answered_as_mooring(
    asked: Asked, read: Any, wanted: Wanted, of_one_line: Mapping[str, object]
) -> bool:
    """Answer for a body or lines between points; False for one line, whose options are given."""
    if not read.several_lines:
        return False
    for_one_line(of_one_line)
    answer_mooring(asked, read, wanted)
    return True


def answer_mooring(asked: Asked, read: Case | Network, wanted: Wanted) -> None:
    """Bring a body, or lines between points, to rest, and answer."""
    from catopt.checks.system import check_at_levels, check_system, with_circle
    from catopt.mooring.case import report_system
    from catopt.report.bundle import system_pictures

    if isinstance(read, Network):
        _network(asked, read, wanted)
        return
    report = report_system(
        read,
        with_line_out=wanted.line_out,
        with_circle=wanted.circle,
        directions=wanted.directions,
        levels=wanted.levels,
        with_stiffness=wanted.stiffness,
        displacements=wanted.displacements,
    )
    checks = with_circle(check_system(read, report), report.circle)
    at_levels = check_at_levels(checks, check_system, read, wanted.levels)
    if wanted.circle and report.circle is None:
        asked.output.note(say(Message("mooring.no_circle"), asked.language))

    def document() -> dict[str, Any]:
        return report.to_dict() | {"checks": at_levels.whole.brief.to_dict()}

    answer = system_answer(report, checks, at_levels)
    asked.give(answer, document, read, partial(system_pictures, report))


def _network(asked: Asked, network: Network, wanted: Wanted) -> None:
    """Bring points, lines and bodies to rest, and hold their body where that is asked for."""
    from catopt.checks.system import check_at_levels, check_network, with_circle
    from catopt.mooring.case import at_levels, network_curves
    from catopt.mooring.fixed_body import at_rest, hold
    from catopt.mooring.network_out import each_line_out
    from catopt.mooring.network_rest import LinesAtRest, NetworkReport
    from catopt.mooring.restoring import watch_circle

    is_held = wanted.stiffness or bool(wanted.displacements) or network.has_fairlead
    if network.bodies or network.current_at_rest is not None or not is_held:
        free = at_rest(network)
        here = [body.moved for body in free.bodies if wanted.stiffness]
        if wanted.stiffness and network.current_at_rest is not None:
            here = [(0.0,) * 6]  # which is refused
    else:
        free, here = None, [(0.0,) * 6]
    places = [*here, *wanted.displacements]
    total = Message("words.held_places", total=len(places))
    held = [hold(network, place) for place in paced(total, places)]
    rest: LinesAtRest = free or held[0]
    away = held[len(here) :]
    gone = each_line_out(network) if wanted.line_out else ()
    judged = check_network(network, rest, gone or None)
    bodies = [of_body.body for of_body in (held if wanted.stiffness else away)]
    force = math.hypot(*(network.bodies[0].force if network.bodies else ()))
    circle = None
    if wanted.circle and network.bodies and not force > 0.0:
        asked.output.note(say(Message("mooring.no_circle"), asked.language))
    elif wanted.circle:
        circle = watch_circle(network, force=force or 1.0)
    curves = network_curves(rest, wanted.directions)
    levels = at_levels(network, wanted.levels)
    judged = with_circle(judged, circle)
    everywhere = check_at_levels(judged, check_network, network, wanted.levels)
    answer = network_answer(
        rest,
        away,
        judged,
        bodies,
        line_out=gone,
        circle=circle,
        curves=curves,
        levels=levels,
        at_levels=everywhere,
    )
    more: dict[str, Any] = {"checks": everywhere.whole.brief.to_dict()}
    if wanted.line_out:
        more["one_line_out"] = [out.to_dict() for out in gone]
    if circle is not None:
        more["watch_circle"] = circle.to_dict()
    if levels:
        more["water_levels"] = [level.to_dict() for level in levels]
    if curves:
        more["restoring_curves"] = [curve.to_dict() for curve in curves]
    states = (rest, *(held if free else away))
    asked.give(answer, lambda: NetworkReport(states).to_dict() | more, network)


def _in_si(option: str, texts: list[str] | None, dimension: Dimension) -> list[float]:
    return [in_si({option: (text, dimension)})[option] for text in texts or ()]


def _displacement(text: str) -> tuple[float, ...]:
    """Read six values of a displacement: three lengths, three angles."""
    from catopt.mooring.network_rest import FREEDOMS

    parts = [word.strip() for word in text.split(",")]
    if len(parts) != len(FREEDOMS):
        wanted = Message("refused_command.must_be_six_values_with", freedoms=", ".join(FREEDOMS))
        raise refused("--held", repr(text), wanted)
    dimensions = (Dimension.LENGTH,) * 3 + (Dimension.ANGLE,) * 3
    given = {
        f"--held, {name}": (part, dimension)
        for name, part, dimension in zip(FREEDOMS, parts, dimensions, strict=True)
    }
    return tuple(in_si(given).values())
