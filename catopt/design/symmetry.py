"""Which states of a mooring of equal lines are the same one, turned or mirrored."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from catopt.model import DesignLoad

SAME_ANGLE = 1e-9
"""rad within which two directions are one: what rounding may add, and nothing that is meant."""


class BodyState(NamedTuple):
    """One state of a mooring under one heading of its force."""

    missing: int  # the line that is gone, from 0; -1 while all are there
    heading: int  # index of the direction of the force


class LoadedState(NamedTuple):
    """One state of a mooring: which line is gone, -1 for none, under which load, towards where."""

    missing: int
    load: DesignLoad
    direction: float


def states_of(
    loads: Sequence[DesignLoad], azimuths: Sequence[float], *, turns: bool
) -> tuple[LoadedState, ...]:
    """List the states of a layout that differ: height by height, with all lines first."""
    states = [
        LoadedState(state.missing, load, load.directions[state.heading])
        for load in loads
        for state in distinct_states(
            azimuths, load.directions, with_line_out=load.line_out, mirrors=not turns
        )
    ]
    heights = list(dict.fromkeys(load.lift for load in loads))
    return tuple(sorted(states, key=lambda each: (heights.index(each.load.lift), each.missing)))


def distinct_states(
    azimuths: Sequence[float],
    directions: Sequence[float],
    *,
    with_line_out: bool,
    mirrors: bool,
) -> tuple[BodyState, ...]:
    """List the states that differ: of those that a turn of the whole pattern brings to one, one.

    Of equal lines about a body and of directions of a force of one size, rad; with each line gone
    in turn, too, where `with_line_out`. Where the body does not turn and nothing turns it, mirror
    images count as one: `mirrors`.

    Examples
    --------
    >>> from math import radians
    >>> six, twelve = ([radians(360.0 / n * k) for k in range(n)] for n in (6, 12))
    >>> len(distinct_states(six, twelve, with_line_out=True, mirrors=False))
    14
    >>> len(distinct_states(six, twelve, with_line_out=True, mirrors=True))
    9
    """
    maps = list(_maps(azimuths, directions, mirrors))
    missing = range(-1, len(azimuths) if with_line_out and len(azimuths) > 1 else 0)
    found: list[BodyState] = []
    known: set[BodyState] = set()
    for state in (
        BodyState(line, heading) for line in missing for heading in range(len(directions))
    ):
        if state not in known:
            found.append(state)
            for lines, headings in maps:
                gone = -1 if state.missing < 0 else lines[state.missing]
                reached = headings[state.heading]
                if reached is not None:
                    known.add(BodyState(gone, reached))
    return tuple(found)


def _maps(
    azimuths: Sequence[float], directions: Sequence[float], mirrors: bool
) -> Iterator[tuple[list[int], list[int | None]]]:
    """Yield each turn (and mirroring) that leaves the pattern as it is, as where things go."""
    for sign in (1.0, -1.0) if mirrors else (1.0,):
        for target in azimuths:
            by = target - sign * azimuths[0]
            lines = [_place(sign * angle + by, azimuths) for angle in azimuths]
            if None not in lines and len(set(lines)) == len(lines):
                headings = [_place(sign * angle + by, directions) for angle in directions]
                yield [each for each in lines if each is not None], headings


def _place(angle: float, among: Sequence[float]) -> int | None:
    """Return the index of a direction among others, None where it is none of them."""
    for index, other in enumerate(among):
        if abs(math.remainder(angle - other, 2.0 * math.pi)) <= SAME_ANGLE:
            return index
    return None


def widest_gap(azimuths: Sequence[float]) -> float:
    """Return the largest angle between two neighbouring lines, rad; a full turn of one line."""
    around = sorted(angle % (2.0 * math.pi) for angle in azimuths)
    beside = [*around[1:], around[0] + 2.0 * math.pi]
    return max(after - before for before, after in zip(around, beside, strict=True))
