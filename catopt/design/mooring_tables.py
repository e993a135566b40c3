"""What the value of a whole mooring follows from, as plain arrays for compiled code."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from catopt.checks.criteria import Criteria
from catopt.design.space import DesignSpace
from catopt.design.symmetry import distinct_states, widest_gap
from catopt.design.tables import Tables
from catopt.model import Case, DesignLoad
from catopt.mooring.arrangement import Arrangement, Lines


class MooringTables(NamedTuple):
    """All that the value of a mooring follows from, beside `Tables` of its line.

    In `Tables` the first load case is the whole mooring, the second one line out.

    Attributes
    ----------
    lines : array of int, shape (layouts,)
        How many lines there are.
    azimuth : array, shape (layouts, lines)
        rad.
    gap : array, shape (layouts, 1 + lines)
        Cosine of half the widest angle between neighbours: with all lines, and without each.
    radius : array, shape (radii,)
        Of the anchors, m; or empty.
    pretension : array, shape (pretensions,)
        Instead: horizontal force in each line with the body at its origin, N; or empty.
    moment : float
        N m.
    first : array of int, shape (layouts + 1,)
        First state of each layout.
    missing : array of int, shape (states,)
        Which line is gone, -1 for none; none is gone in the first state of each height.
    direction, force, height : array, shape (states,)
        Towards which the force acts, rad, its size, N, and the height of the fairleads above the
        bed, m.
    reserve : array, shape (2,)
        Largest vertical pull of all lines together, N: all there, and one out.
    fairlead_radius : float
        m.
    turns : bool
        Whether the body is free in yaw.
    is_monotone : bool
        Whether the span of every line is proved to rise with its horizontal force, and the
        fairleads are at one height in all states.
    """

    lines: Any
    azimuth: Any
    gap: Any
    radius: Any
    pretension: Any
    moment: float
    first: Any
    missing: Any
    direction: Any
    force: Any
    height: Any
    reserve: Any
    fairlead_radius: float
    turns: bool
    is_monotone: bool


class BodyRoom(NamedTuple):
    """Work space for one mooring.

    Attributes
    ----------
    arrangement : Arrangement
        For the largest number of lines and pieces.
    rest, under_load : Lines
        What is known of the lines without a load and under one.
    """

    arrangement: Arrangement
    rest: Lines
    under_load: Lines


def mooring_tables(
    case: Case, loads: Sequence[DesignLoad], space: DesignSpace, line: Tables
) -> MooringTables:
    """Lay out numbers of lines, radii and the states under all loads."""
    system = case.system
    assert system is not None
    assert space.layout is not None
    layouts = space.layout.azimuths
    most = max(map(len, layouts))
    azimuth, gap = np.zeros((len(layouts), most)), np.full((len(layouts), 1 + most), -1.0)
    for row, angles in enumerate(layouts):
        azimuth[row, : len(angles)] = angles
        gap[row, 0] = math.cos(0.5 * widest_gap(angles))
        for gone in range(len(angles) if len(angles) > 1 else 0):
            left = [*angles[:gone], *angles[gone + 1 :]]
            gap[row, 1 + gone] = math.cos(0.5 * widest_gap(left))
    states = [states_of(loads, angles, turns=system.turns) for angles in layouts]
    flat = [state for each in states for state in each]
    return MooringTables(
        lines=np.array([len(angles) for angles in layouts], dtype=np.int64),
        azimuth=azimuth,
        gap=gap,
        radius=np.array(space.layout.radii),
        pretension=np.array(space.layout.pretensions),
        moment=float(system.moment),
        first=np.cumsum([0, *map(len, states)], dtype=np.int64),
        missing=np.array([state.missing for state in flat], dtype=np.int64),
        direction=np.array([state.direction for state in flat]),
        force=np.array([state.load.force for state in flat]),
        height=np.array([case.fairlead_height + state.load.lift for state in flat]),
        reserve=np.full(2, math.inf),
        fairlead_radius=float(system.legs[0].fairlead_radius),
        turns=system.turns,
        is_monotone=_is_monotone(line) and len({load.lift for load in loads}) == 1,
    )


def with_reserve(
    tables: MooringTables, line: Tables, criteria: Criteria
) -> tuple[Tables, MooringTables]:
    """Take the reserve of buoyancy, which all lines share, from the limits of each line."""
    limits = (criteria.limits("extreme"), criteria.limits("extreme", "one_line_out"))
    reserve = np.array([each.reserve_buoyancy for each in limits])
    limit = line.limit.copy()
    limit[:, limits[0]._fields.index("reserve_buoyancy")] = math.inf
    return line._replace(limit=limit), tables._replace(reserve=reserve)


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


def _is_monotone(line: Tables) -> bool:
    """Whether docs/theory.md proves of every line that its span rises with its force."""
    is_smooth = line.friction == 0.0 and not (line.clump_friction > 0.0).any()
    floats = (line.weight <= 0.0).any()
    is_plain = line.anchor_height == 0.0 and len(line.clump_optional) == 0 and not floats
    return bool(is_smooth or is_plain)


def body_room(tables: MooringTables, line: Tables) -> BodyRoom:
    """Make work space."""
    lines = int(tables.lines.max())
    pieces = lines * (len(line.segment_optional) + len(line.clump_optional))

    def floats(size: int) -> Any:
        return np.zeros(size)

    own = {"first", "length", "weight", "compliance", "load", "friction"}
    by_line = {name: floats(lines) for name in Arrangement._fields if name not in own}
    return BodyRoom(
        Arrangement(
            **by_line,
            friction=line.friction,
            first=np.zeros(lines + 1, dtype=np.int64),
            length=floats(pieces),
            weight=floats(pieces),
            compliance=floats(pieces),
            load=floats(2 * pieces + 2 * lines),
        ),
        Lines(*(floats(lines) for _ in Lines._fields)),
        Lines(*(floats(lines) for _ in Lines._fields)),
    )
