"""Every equilibrium of a line in a current under its load, from the taut line down.

Where the current is strong beside the load, the way from the line in still water may end in a fold
before the full current. Pulled hard enough, though, a line is nearly straight in any current. From
there the horizontal force is taken back, and on to as much the other way, in the full current; the
span, the tension or the force that is given is passed as often as it has answers.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import pairwise
from typing import TYPE_CHECKING, NamedTuple

from catopt.catenary.along_current import Node, Vector
from catopt.errors import NoEquilibriumError, NotConvergedError
from catopt.words import Measure, Message

if TYPE_CHECKING:
    from catopt.catenary.in_current import Shot
    from catopt.model import Load

_TAUT = 3.0
"""Of drag and weight together: a force with which a line is nearly straight."""
_CLOSER = 4.0
"""How much shorter strides of the force are where it is small: they grow by sinh of this."""
_STRIDE, _LEAST = 1.0 / 20.0, 1e-5
"""Of the way from one force to none: usual, and below which the way is lost."""


_REFINED = 6
"""Parabolas through the three lowest tensions, where none is below the given one."""


class _Stop(NamedTuple):
    """A place on the way: horizontal force at the fairlead, N, what is sought, and upper end."""

    force: float
    known: list[float]
    top: Node


def swept(shot: Shot, load: Load, height: float) -> list[list[float]]:
    """Find what is sought of every equilibrium in the full current, the largest span first.

    `height`: of the fairlead. NoEquilibriumError where the tension at the fairlead is above the
    given one all the way. NotConvergedError where the way is lost before an answer.
    """
    aim, shot.part = shot.missed_by, 1.0
    (key,) = load.given
    given: float = getattr(load, key)

    def off(stop: _Stop) -> float:
        of: dict[str, float] = {"span": stop.top.x, "horizontal_force": stop.top.fx}
        return of.get(key, stop.top.tension) - given

    stops: list[_Stop] = []
    for stop in _way(shot, 0.0 if key == "span" else given, height):
        stops.append(stop)
        # No tension is below its horizontal part; a span or a force is passed once.
        if stop.force < -given if key == "fairlead_tension" else off(stop) < 0.0:
            break
    if key == "fairlead_tension":
        _to_least(shot, stops, given, height)
    shot.missed_by = aim
    found = []
    for one, other in pairwise(stops):
        if (off(one) > 0.0) != (off(other) > 0.0):
            share = off(one) / (off(one) - off(other))
            pairs = zip(one.known, other.known, strict=True)
            found.append(shot.newton([a + share * (b - a) for a, b in pairs]))
    answers = [each for each in found if each is not None]
    least = min((stop.top.tension for stop in stops), default=0.0)
    if key == "fairlead_tension" and least > given and stops[-1].force < -given:
        said = Message("catenary.current_takes_more", least=Measure("tension", least))
        raise NoEquilibriumError(said, "force", least - given)
    if not answers:
        raise NotConvergedError(Message("catenary.current_not_converged", part=1.0))
    return answers


def _way(shot: Shot, given: float, height: float) -> Iterator[_Stop]:
    """Go from a taut line to one as taut the other way, as far as the way leads."""
    flows = (shot.flow(0.05 * k * shot.site.water_depth) for k in range(21))
    fastest = max(u * u + v * v for u, v in flows)
    drag = math.fsum(p.across * p.length + p.load_drag for p in shot.parts) * fastest
    taut = given + _TAUT * (shot.scale + drag)
    rise = height - shot.anchor_height
    reach = math.sqrt(max(shot.length**2 - rise**2, 0.01 * shot.length**2))
    before = here = _stop(shot, taut, [taut, 0.0, taut * rise / reach], height)
    at, stride = 1.0, _STRIDE
    while here is not None and before is not None:
        yield here
        there = None
        while there is None:
            to = max(at - stride, -1.0)
            if at <= -1.0 or stride < _LEAST:
                return
            force = taut * math.sinh(_CLOSER * to) / math.sinh(_CLOSER)
            there = _stop(shot, force, _between(before, here, force), height)
            stride *= 1.5 if there else 0.5
        before, here, at, stride = here, there, to, min(stride, _STRIDE)


def _stop(shot: Shot, force: float, start: list[float], height: float) -> _Stop | None:
    """Find the line with a horizontal force at its fairlead; None where that does not settle."""

    def missed(top: Node) -> Vector:
        return (top.fx - force) * shot.per_force, top.y, top.z - height

    shot.missed_by = missed
    known = shot.newton(start)
    laid = None if known is None else shot.laid(known, shot.length)
    return None if known is None or laid is None else _Stop(force, known, laid.top)


def _between(one: _Stop, other: _Stop, force: float) -> list[float]:
    """Estimate what is sought at a force from two stops, between them or beyond."""
    if one.force == other.force:
        return other.known
    share = (force - one.force) / (other.force - one.force)
    return [a + share * (b - a) for a, b in zip(one.known, other.known, strict=True)]


def _to_least(shot: Shot, stops: list[_Stop], given: float, height: float) -> None:
    """Add stops towards the least tension, until one is below the given."""
    for _ in range(_REFINED):
        k = min(range(len(stops)), key=lambda j: stops[j].top.tension, default=0)
        if not 0 < k < len(stops) - 1 or stops[k].top.tension <= given:
            return
        (a, A), (b, B), (c, C) = ((s.force, s.top.tension) for s in stops[k - 1 : k + 2])
        above, below = (b - a) * (B - C), (b - c) * (B - A)
        force = b - 0.5 * ((b - a) * above - (b - c) * below) / (above - below or math.inf)
        if not c < force < a or abs(force - b) < 1e-6 * (a - c):
            force = 0.5 * (b + (a if a - b > b - c else c))
        near = stops[k - 1] if force > b else stops[k + 1]
        new = _stop(shot, force, _between(near, stops[k], force), height)
        if new is None:
            return
        stops.insert(k if force > b else k + 1, new)
        if abs(new.top.tension - B) < _LEAST * B:
            return
