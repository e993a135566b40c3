"""The design space, the load cases and the limits as plain arrays, for compiled code."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from catopt.catenary.batch import room_for_runs
from catopt.catenary.runs import Runs
from catopt.checks.criteria import Criteria, Limits
from catopt.design.problem import Floats
from catopt.design.space import DesignSpace
from catopt.model import Case, LoadCase, SinkerChoice
from catopt.model.immersion import weight_in_water

RESOLUTION = 2.0**-40
"""Part of the largest value of an objective that two designs must differ by to differ at all.

The same line made up in two ways (20 m and 30 m of one chain, or 30 m and 20 m) has the same mass
but for the last digits; without this the worse of two such lines could stay on the front. It is a
thousand times the rounding of a double, and a power of 2, so that round masses stay as they are."""


class Tables(NamedTuple):
    """All that the value of a design follows from.

    Tables of segments and clump weights are filled up to the longest row.

    Attributes
    ----------
    segment_optional : array of int, shape (segments,)
        1 where the segment may be absent.
    length : array, shape (segments, lengths)
        m.
    weight, compliance, mass, price : array, shape (segments, options)
        N/m, 1/N, kg/m, USD/m; nan where not known.
    allowed : array, shape (load cases, segments, options)
        Largest tension that is allowed, N; infinite when not checked.
    clump_optional, joint : array of int, shape (clump weights,)
        1 where it may be absent; the segment at whose upper end it hangs, or 0.
    clump_friction : array, shape (clump weights,)
        Coulomb coefficients on the bed; below 0 for that of the bed.
    clump_mass, clump_weight : array, shape (clump weights, masses)
        kg, N.
    position : array, shape (clump weights, positions)
        m.
    force, height : array, shape (load cases,)
        At the fairlead, N, and its height above the bed, m; the largest force comes first.
    is_reference : array of int, shape (load cases,)
        1 where excursions start.
    limit : array, shape (load cases, 7)
        The columns of `catopt.checks.criteria.Limits`.
    sinker_weight : array, shape (sinkers,)
        In water, N, rising; the anchor's own where nothing is to be chosen; else empty.
    sinker_friction, holding_capacity : float
        Of the sinkers on the soil; of the drag anchor, N, infinite when there is none.
    anchor_height, friction : float
        m above the bed; Coulomb coefficient of the bed.
    step : array, shape (4,)
        What mass (kg), offset, excursion (m) and cost (USD) are rounded to.
    """

    segment_optional: Any
    length: Any
    weight: Any
    compliance: Any
    mass: Any
    price: Any
    allowed: Any
    clump_optional: Any
    joint: Any
    clump_mass: Any
    clump_weight: Any
    clump_friction: Any
    position: Any
    force: Any
    height: Any
    is_reference: Any
    limit: Any
    sinker_weight: Any
    sinker_friction: float
    holding_capacity: float
    anchor_height: float
    friction: float
    step: Any


class Room(NamedTuple):
    """Work space for one design, so that the loop over designs makes nothing anew.

    Attributes
    ----------
    length, weight, compliance, position, point_weight, point_friction : array
        The line's segments and clump weights (pieces.split).
    option, owner : array of int
        What each segment is made of and which it was; the segment of each piece.
    piece_length, piece_weight, piece_compliance, piece_load : array
        The line's pieces.
    runs : Runs
        The line's runs.
    tension : array
        The largest tension of each segment.
    """

    length: Any
    weight: Any
    compliance: Any
    position: Any
    point_weight: Any
    point_friction: Any
    place: Any
    option: Any
    owner: Any
    piece_length: Any
    piece_weight: Any
    piece_compliance: Any
    piece_load: Any
    runs: Runs
    tension: Any


def room(tables: Tables) -> Room:
    """Make work space."""
    segments, weights = len(tables.segment_optional), len(tables.clump_optional)
    count = segments + weights

    def floats(size: int) -> Floats:
        return np.empty(size)

    def whole(size: int) -> Any:
        return np.empty(size, dtype=np.int64)

    return Room(
        length=floats(segments),
        weight=floats(segments),
        compliance=floats(segments),
        position=floats(weights),
        point_weight=floats(weights),
        point_friction=np.full(weights, -1.0),
        place=whole(segments),
        option=whole(segments),
        owner=whole(count),
        piece_length=floats(count),
        piece_weight=floats(count),
        piece_compliance=floats(count),
        piece_load=floats(2 * count + 2),
        runs=room_for_runs(count),
        tension=floats(segments),
    )


def tables_of(
    case: Case,
    states: Sequence[LoadCase],
    space: DesignSpace,
    criteria: Criteria,
    sinkers: SinkerChoice | None,
) -> Tables:
    """Lay everything out."""
    states = sorted(states, key=lambda state: -state.horizontal_force)
    segments, weights = space.segments, space.clump_weights
    made = [variable.options for variable in segments]
    sinker_weight, sinker_friction, capacity = _holding(case, sinkers)
    tables = Tables(
        segment_optional=np.array([v.is_optional for v in segments], dtype=np.int64),
        length=_padded([v.lengths for v in segments]),
        weight=_padded([[s.submerged_weight for s in row] for row in made]),
        compliance=_padded([[1.0 / s.EA for s in row] for row in made]),
        mass=_padded([[_or_nan(s.mass) for s in row] for row in made]),
        price=_padded([[_or_nan(s.price) for s in row] for row in made]),
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
        limit=np.array(
            [criteria.limits(state.kind, state.state) for state in states], dtype=np.float64
        ),
        sinker_weight=np.array(sinker_weight, dtype=np.float64),
        sinker_friction=sinker_friction,
        holding_capacity=capacity,
        anchor_height=float(case.anchor_height),
        friction=float(case.site.seabed_friction),
        step=_steps(space),
    )
    assert tables.limit.shape == (len(states), len(Limits._fields))
    return tables


def _padded(rows: Sequence[Sequence[float]]) -> Floats:
    """Put rows of different length into one array."""
    width = max((len(row) for row in rows), default=1)
    table = np.full((len(rows), width), np.nan)
    for index, row in enumerate(rows):
        table[index, : len(row)] = row
    return table


def _or_nan(value: float | None) -> float:
    return math.nan if value is None else value


def _holding(case: Case, sinkers: SinkerChoice | None) -> tuple[list[float], float, float]:
    """Weights of the sinkers in water (N), their friction, and a drag anchor's capacity (N)."""
    if sinkers is not None:
        water = case.site.water_density
        weights = [weight_in_water(mass, sinkers.density, water) for mass in sinkers.masses]
        return weights, sinkers.friction, math.inf
    anchor = case.anchor
    if anchor is None:
        return [], 1.0, math.inf
    if anchor.kind == "sinker":
        assert anchor.submerged_weight is not None
        assert anchor.friction is not None
        return [anchor.submerged_weight], anchor.friction, math.inf
    assert anchor.holding_capacity is not None
    return [], 1.0, anchor.holding_capacity


def _allowed(states: Sequence[LoadCase], space: DesignSpace, criteria: Criteria) -> Floats:
    """Largest tension of every option in every load case, N."""
    width = max(len(variable.options) for variable in space.segments)
    allowed = np.full((len(states), len(space.segments), width), np.inf)
    for row, variable in enumerate(space.segments):
        for column, option in enumerate(variable.options):
            strength = criteria.strength(option)
            for state, of_state in zip(states, allowed, strict=True):
                allowed_here = criteria.allowed_tension(strength, state.kind, state.state)
                of_state[row, column] = allowed_here.tension
    return allowed


def _steps(space: DesignSpace) -> Floats:
    """Choose what each objective is rounded to: a power of 2, RESOLUTION of its largest or less."""
    lengths = [max(variable.lengths) for variable in space.segments]
    masses = [max((s.mass or 0.0) for s in variable.options) for variable in space.segments]
    prices = [max((s.price or 0.0) for s in variable.options) for variable in space.segments]
    clumps = sum(max(variable.masses) for variable in space.clump_weights)
    lines = 1 if space.layout is None else max(map(len, space.layout.azimuths))
    mass = lines * (sum(m * length for m, length in zip(masses, lengths, strict=True)) + clumps)
    cost = lines * sum(p * length for p, length in zip(prices, lengths, strict=True))
    largest = [mass, sum(lengths), sum(lengths), cost]
    powers = [2.0 ** math.floor(math.log2(x)) if x > 0.0 else 1.0 for x in largest]
    return np.array(powers) * RESOLUTION
