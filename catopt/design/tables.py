"""The design space, the load cases and the limits as plain arrays, for compiled code."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from catopt.catenary.batch import room_for_runs
from catopt.catenary.layout import LineIntervals
from catopt.checks.criteria import Criteria, Limits
from catopt.design.front import Floats
from catopt.design.mooring_point import states_of, widest_gap
from catopt.design.space import DesignSpace
from catopt.model import Case, DesignLoad, LoadCase, SinkerChoice
from catopt.model.line import weight_in_water
from catopt.model.wear import left_of_section
from catopt.mooring.net import FREE, PINNED, TURNS, Known, Net, room_for
from catopt.mooring.under_loads import as_arrays

RESOLUTION = 2.0**-40
"""Part of the largest value of an objective that two designs must differ by to differ at all.

The same line made up in two ways (20 m and 30 m of one chain, or 30 m and 20 m) has the same mass
but for the last digits; without this the worse of two such lines could stay on the front. It is a
thousand times the rounding of a double, and a power of 2, so that round masses stay as they are."""


class Tables(NamedTuple):
    """All that the value of a line follows from.

    Tables of segments and clump weights are filled up to the longest row; of load cases the largest
    force comes first.
    """

    # shape (segments,): 1 where the segment may be absent
    segment_optional: Any
    # shape (segments, lengths): m
    length: Any
    # shape (segments, options): N/m, 1/N, kg/m, USD/m; nan where not known
    weight: Any
    compliance: Any
    mass: Any
    price: Any
    # shape (segments, options): share of the cross-section left at the end of the service life
    left: Any
    # shape (load cases, segments, options): largest tension allowed, N; infinite: not checked
    allowed: Any
    # shape (clump weights,): 1 where it may be absent; the segment at whose upper end it hangs or 0
    clump_optional: Any
    joint: Any
    # shape (clump weights, masses): kg, N
    clump_mass: Any
    clump_weight: Any
    # shape (clump weights,): Coulomb coefficients on the bed; below 0 for that of the bed
    clump_friction: Any
    # shape (clump weights, positions): m
    position: Any
    # shape (load cases,): at the fairlead, N; its height above the bed, m; 1 where excursions start
    force: Any
    height: Any
    is_reference: Any
    is_worn: Any  # shape (load cases,): 1 where the line is at the end of its service life
    # shape (load cases, 7): the columns of `catopt.checks.criteria.Limits`
    limit: Any
    # shape (sinkers,): in water, N, rising; the anchor's own where nothing is to be chosen
    sinker_weight: Any
    # what the soil holds on the base of each, N; infinite where friction alone holds
    sinker_base: Any
    sinker_friction: float
    holding_capacity: float  # of the drag anchor, N, infinite when there is none
    anchor_height: float  # m above the bed
    friction: float  # Coulomb coefficient of the bed
    # shape (6,): what mass (kg), offset, excursion (m), cost (USD), length (m) and the
    # anchor's load (N) are rounded to
    step: Any


class Room(NamedTuple):
    """Work space for one design, so that the loop over designs makes nothing anew."""

    # the line's segments and clump weights (pieces.split), and which segments of the space they are
    length: Any
    weight: Any
    compliance: Any
    position: Any
    point_weight: Any
    point_friction: Any
    place: Any
    # what each segment is made of; the segment of each piece
    option: Any
    owner: Any
    # the line's pieces, and its runs
    piece_length: Any
    piece_weight: Any
    piece_compliance: Any
    piece_load: Any
    runs: LineIntervals
    # the largest tension of each segment, N
    tension: Any


class MooringTables(NamedTuple):
    """All that the value of a mooring follows from, beside `Tables` of its line.

    In `Tables` the first load case is the whole mooring, the second one line out.
    """

    # shape (layouts,): how many lines there are
    lines: Any
    # shape (layouts, lines): rad
    azimuth: Any
    # shape (layouts, 1 + lines): cosine of half the widest angle between neighbours, with all lines
    # and without each
    gap: Any
    # shape (radii,) of the anchors, m; or instead shape (pretensions,): horizontal force in each
    # line with the body at its origin, N
    radius: Any
    pretension: Any
    moment: float  # N m
    # shape (layouts + 1,): first state of each layout
    first: Any
    # shape (states,): which line is gone, -1 for none; none in the first state of each height
    missing: Any
    # shape (states,): towards which the force acts, rad, its size, N, and the height of the
    # fairleads above the bed, m
    direction: Any
    force: Any
    height: Any
    # shape (2,): largest vertical pull of all lines together, N: all there, and one out
    reserve: Any
    fairlead_radius: float  # m
    turns: bool  # whether the body is free in yaw
    # whether the span of every line is proved to rise with its horizontal force, and the fairleads
    # are at one height in all states
    is_monotone: bool


def _whole(size: int) -> NDArray[np.int64]:
    return np.empty(size, dtype=np.int64)


def room(tables: Tables) -> Room:
    """Make work space."""
    segments, weights = len(tables.segment_optional), len(tables.clump_optional)
    count = segments + weights
    return Room(
        length=np.empty(segments),
        weight=np.empty(segments),
        compliance=np.empty(segments),
        position=np.empty(weights),
        point_weight=np.empty(weights),
        point_friction=np.full(weights, -1.0),
        place=_whole(segments),
        option=_whole(segments),
        owner=_whole(count),
        piece_length=np.empty(count),
        piece_weight=np.empty(count),
        piece_compliance=np.empty(count),
        piece_load=np.empty(2 * count + 2),
        runs=room_for_runs(count),
        tension=np.empty(segments),
    )


def body_room(tables: MooringTables, line: Tables) -> tuple[Net, Known, Known]:
    """Make work space for a mooring of the largest number of lines and pieces.

    Its lines as the kernel takes them, as `catopt.mooring.zero_load` lays them out; what is known
    of them without a load, and under one.
    """
    lines = int(tables.lines.max())
    pieces = lines * (len(line.segment_optional) + len(line.clump_optional))
    net = Net(
        used=[lines],
        first=list(range(0, 2 * lines, 2)),
        second=list(range(1, 2 * lines, 2)),
        piece=[0] * (lines + 1),
        length=[0.0] * pieces,
        weight=[0.0] * pieces,
        compliance=[0.0] * pieces,
        load=[0.0] * (2 * pieces + 2 * lines),
        friction=[line.friction] * lines,
        base=[0.0] * (6 * lines),
        freedom=[-1, -1, -1, -1, 0, 1, -1, 2] * lines,
        arm=[0.0] * (4 * lines),
        pull=[0.0] * 3,
        scale=[1.0, 1.0, tables.fairlead_radius or 1.0],
        kind=[FREE, FREE, TURNS if tables.turns else PINNED],
        group=[0, 3],
        surface=[math.inf] * 3,
        buoyancy=[0.0] * 3,
        height=[0.0] * 3,
    )
    known = room_for(net)
    return as_arrays(net), as_arrays(known), as_arrays(known)


def tables_of(
    case: Case,
    states: Sequence[LoadCase],
    space: DesignSpace,
    criteria: Criteria,
    sinkers: SinkerChoice | None,
) -> Tables:
    """Lay out lines, load cases and limits."""
    states = sorted(states, key=lambda state: -state.horizontal_force)
    segments, weights = space.segments, space.clump_weights
    is_worn = [state.condition == "worn" for state in states]
    sinker_weight, sinker_base, sinker_friction, capacity = _holding(case, sinkers)

    def of_options(name: str) -> Floats:
        figures = [[getattr(option, name) for option in each.options] for each in segments]
        return _padded([[math.nan if x is None else x for x in row] for row in figures])

    tables = Tables(
        segment_optional=np.array([v.is_optional for v in segments], dtype=np.int64),
        length=_padded([v.lengths for v in segments]),
        weight=of_options("submerged_weight"),
        compliance=1.0 / of_options("EA"),
        mass=of_options("mass"),
        price=of_options("price"),
        left=_padded(
            [[left_of_section(x, case.service) for x in each.options] for each in segments]
        )
        if any(is_worn)
        else np.ones_like(of_options("submerged_weight")),
        allowed=_allowed(states, space, criteria),
        clump_optional=np.array([v.is_optional for v in weights], dtype=np.int64),
        joint=np.array([v.joint for v in weights], dtype=np.int64),
        clump_mass=_padded([v.masses for v in weights]),
        clump_weight=_padded([v.submerged_weights for v in weights]),
        clump_friction=np.array([-1.0 if v.friction is None else v.friction for v in weights]),
        position=_padded([v.positions or (math.nan,) for v in weights]),
        force=np.array([state.horizontal_force for state in states]),
        height=np.array([case.fairlead_height + each.lift for each in states]),
        is_reference=np.array([state.kind == "reference" for state in states], dtype=np.int64),
        is_worn=np.array(is_worn, dtype=np.int64),
        limit=np.array(
            [criteria.limits(state.kind, state.state) for state in states], dtype=np.float64
        ),
        sinker_weight=np.array(sinker_weight, dtype=np.float64),
        sinker_base=np.array(sinker_base, dtype=np.float64),
        sinker_friction=sinker_friction,
        holding_capacity=capacity,
        anchor_height=float(case.anchor_height),
        friction=float(case.site.seabed_friction),
        step=_steps(space, states),
    )
    assert tables.limit.shape == (len(states), len(Limits._fields))
    return tables


def mooring_tables(
    case: Case, loads: Sequence[DesignLoad], space: DesignSpace, line: Tables, criteria: Criteria
) -> tuple[Tables, MooringTables]:
    """Lay out numbers of lines, radii and the states under all loads, beside the tables of a line.

    The reserve of buoyancy, which all lines share, is taken from the limits of each.
    """
    system = case.own_system
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
    limits = (criteria.limits("extreme"), criteria.limits("extreme", "one_line_out"))
    limit = line.limit.copy()
    limit[:, Limits._fields.index("reserve_buoyancy")] = math.inf
    return line._replace(limit=limit), MooringTables(
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
        reserve=np.array([each.reserve_buoyancy for each in limits]),
        fairlead_radius=float(system.legs[0].fairlead_radius),
        turns=system.turns,
        is_monotone=_is_monotone(line) and len({load.lift for load in loads}) == 1,
    )


def _is_monotone(line: Tables) -> bool:
    """Whether docs/theory.md proves of every line that its span rises with its force."""
    is_smooth = line.friction == 0.0 and not (line.clump_friction > 0.0).any()
    floats = (line.weight <= 0.0).any()
    is_plain = line.anchor_height == 0.0 and len(line.clump_optional) == 0 and not floats
    return bool(is_smooth or is_plain)


def _padded(rows: Sequence[Sequence[float]]) -> Floats:
    """Put rows of different length into one array."""
    width = max((len(row) for row in rows), default=1)
    table = np.full((len(rows), width), np.nan)
    for index, row in enumerate(rows):
        table[index, : len(row)] = row
    return table


def _holding(
    case: Case, sinkers: SinkerChoice | None
) -> tuple[list[float], Sequence[float], float, float]:
    """Weights of the sinkers in water, what their bases hold, friction; a drag anchor's capacity.

    All but the friction in N.
    """
    if sinkers is not None:
        water = case.site.water_density
        weights = [weight_in_water(mass, sinkers.density, water) for mass in sinkers.masses]
        bases = sinkers.base_holdings or [math.inf] * len(weights)
        return weights, bases, sinkers.friction, math.inf
    anchor = case.anchor
    if anchor is None:
        return [], [], 1.0, math.inf
    if anchor.kind == "sinker":
        assert anchor.submerged_weight is not None
        assert anchor.friction is not None
        base = math.inf if anchor.base_holding is None else anchor.base_holding
        return [anchor.submerged_weight], [base], anchor.friction, math.inf
    assert anchor.holding_capacity is not None
    return [], [], 1.0, anchor.holding_capacity


def _allowed(states: Sequence[LoadCase], space: DesignSpace, criteria: Criteria) -> Floats:
    """Largest tension of every option in every load case, N."""
    width = max(len(variable.options) for variable in space.segments)
    allowed = np.full((len(states), len(space.segments), width), np.inf)
    for row, variable in enumerate(space.segments):
        for column, option in enumerate(variable.options):
            strengths = {
                each: criteria.in_condition(each).strength(option)
                for each in {state.condition for state in states}
            }
            for state, of_state in zip(states, allowed, strict=True):
                own = strengths[state.condition]
                here = criteria.allowed_tension(own, state.kind, state.state)
                of_state[row, column] = here.tension
    return allowed


def _steps(space: DesignSpace, states: Sequence[LoadCase]) -> Floats:
    """Choose what each objective is rounded to: a power of 2, RESOLUTION of its largest or less."""
    lengths = [max(variable.lengths) for variable in space.segments]
    masses = [max((s.mass or 0.0) for s in variable.options) for variable in space.segments]
    prices = [max((s.price or 0.0) for s in variable.options) for variable in space.segments]
    clumps = sum(max(variable.masses) for variable in space.clump_weights)
    lines = 1 if space.layout is None else max(map(len, space.layout.azimuths))
    mass = lines * (sum(m * length for m, length in zip(masses, lengths, strict=True)) + clumps)
    cost = lines * sum(p * length for p, length in zip(prices, lengths, strict=True))
    largest = [mass, sum(lengths), sum(lengths), cost, lines * sum(lengths)]
    largest.append(max(state.horizontal_force for state in states))
    powers = [2.0 ** math.floor(math.log2(x)) if x > 0.0 else 1.0 for x in largest]
    return np.array(powers) * RESOLUTION
