"""What is to come to rest, laid out as the kernels take it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np

from catopt.arrays import Array, Codes
from catopt.constants import STANDARD_GRAVITY
from catopt.fem.loads import Current
from catopt.fem.mesh import (
    SAME_PLACE,
    LineMesh,
    bar_nodes,
    by_bar,
    end_nodes,
    first_bars,
    heaviest,
    to_nodes,
)
from catopt.fem.resting import Bars, Body, State
from catopt.fem.seabed import (
    ABSENT,
    FREE,
    HELD,
    LAID,
    NO_FRICTION,
    ON_BED,
    PULLED,
    SHARING,
    SPRING,
    Bed,
    Ground,
    HeldBed,
)
from catopt.words import Message

_LAWS = {"pulled": PULLED, "laid": LAID, "history": SPRING}


@dataclass(frozen=True)
class Water:
    """Where the water is, when it matters."""

    surface: float = math.inf  # height of still water, m; above it the line has its weight in air,
    # for which every segment needs its mass. Infinite: all is taken to be submerged.
    current: Current | None = None
    gravity: float = STANDARD_GRAVITY  # m/s2, for the weight in air


@dataclass(frozen=True)
class Problem:
    """What is to come to rest, and where the water is."""

    bars: Bars
    nodal: Array  # (nodes, 3): point loads, N
    ground: Ground
    contact: Codes  # (nodes,): what the bed does to each node before anything has moved
    body: Body
    carries_compression: bool
    soft: float  # stiffness of the first springs, N: what lines and loads weigh
    surface: float  # height of still water, m
    current: Current | None

    @cached_property
    def first_node(self) -> Codes:
        """First node of each bar, shape (bars,)."""
        return bar_nodes(self.bars.start)

    @cached_property
    def carried(self) -> Array:
        """Unstretched length that each node carries, m, shape (nodes,)."""
        return to_nodes(self.bars.length, self.bars.start)


def one_point(free: Array, force: Array, place: Array, lines: int) -> Body:
    """Return one point in which all lines end; of three values each."""
    of_end = np.array([[-1, 0]] * lines, dtype=np.int64)
    lies = np.zeros(1, dtype=np.int64)
    return Body(free[np.newaxis], force[np.newaxis], place[np.newaxis], of_end, lies)


def build(
    meshes: Sequence[LineMesh],
    body: Body,
    bed: Bed | HeldBed,
    friction: float,
    water: Water,
    carries_compression: bool,
) -> Problem:
    """Lay out all lines, one after the other; they meet in the points of `body`."""
    start = first_bars(meshes)
    length = np.concatenate([mesh.length for mesh in meshes])
    multiplier = bed.EA_multiplier if isinstance(bed, HeldBed) else 1.0
    with np.errstate(divide="ignore"):
        compliance = 1.0 / (multiplier * by_bar(meshes, "EA"))
    submerged = length * by_bar(meshes, "submerged_weight")
    in_air = submerged
    if math.isfinite(water.surface):
        in_air = length * water.gravity * by_bar(meshes, "mass")
    nodal = np.concatenate([_point_loads(mesh) for mesh in meshes])
    bars = Bars(length, compliance, start, submerged, in_air, *_drag(meshes, water.current))
    pulls = np.linalg.norm(body.free * body.force, axis=1)
    most = heaviest(start, submerged, nodal) + float(pulls.sum())
    return Problem(
        bars=bars,
        nodal=nodal,
        ground=_ground(meshes, bars, bed, friction),
        contact=np.concatenate([_contact(mesh, bed) for mesh in meshes]),
        body=body,
        carries_compression=carries_compression,
        soft=most if most > 0.0 else 1.0,
        surface=water.surface,
        current=water.current,
    )


def straight(problem: Problem, anchors: Array, fairleads: Array) -> State:
    """Every line straight from its anchor to its fairlead, (lines, 3), m, without tension."""
    bars, nodes = problem.bars, problem.nodal.shape[0]
    x = np.empty((nodes, 3))
    for k, (first, end) in enumerate(pairwise(bars.start)):
        arc = np.concatenate([[0.0], np.cumsum(bars.length[first:end])])
        part = (arc / arc[-1])[:, np.newaxis]
        x[first + k : end + k + 1] = (1.0 - part) * anchors[k] + part * fairleads[k]
    contact = problem.contact.copy()
    ends = np.concatenate(end_nodes(bars.start))
    contact[ends[(contact[ends] == FREE) & (x[ends, 2] <= 0.0)]] = ON_BED
    tension = np.zeros(bars.length.size)
    laid = np.full(bars.start.size - 1, SHARING, dtype=np.int64)
    return State(x, tension, contact, np.zeros(nodes), np.zeros((nodes, 3)), laid)


def place_of(node: int, start: Codes, x: Array, points: int = 1) -> Message:
    """Words for where a node is, in which line; below 0 are the points in which lines meet."""
    if node < 0:
        return Message("truss.the_body" if points == 1 else "truss.the_point", number=-node)
    firsts = start + np.arange(start.size)
    line = int(np.searchsorted(firsts, node, side="right")) - 1
    here = dict(zip("xyz", map(float, x[node]), strict=True))
    return Message("truss.at_node", **here, node=node - int(firsts[line]), line=line + 1)


def _point_loads(mesh: LineMesh) -> Array:
    nodal = np.zeros((mesh.elements + 1, 3))
    for load, node in mesh.loads:
        nodal[node, 2] -= load.submerged_weight
    return nodal


def _drag(meshes: Sequence[LineMesh], current: Current | None) -> tuple[Array, Array]:
    """0.5 rho D C of each bar, across and along."""
    if current is None:
        return np.empty(0), np.empty(0)
    half = 0.5 * current.water_density
    across = np.array([half * s.diameter * s.normal for s in current.sections])
    along = np.array([half * s.diameter * s.tangential for s in current.sections])
    owner = np.concatenate([mesh.segment for mesh in meshes])
    return across[owner], along[owner]


def _contact(mesh: LineMesh, bed: Bed | HeldBed) -> Codes:
    if isinstance(bed, Bed):
        return np.full(mesh.elements + 1, FREE, dtype=np.int64)
    is_held = mesh.arc <= bed.grounded_length + SAME_PLACE * mesh.line.length
    return np.where(is_held, HELD, ABSENT).astype(np.int64)


def node_friction(mesh: LineMesh, friction: float) -> Array:
    """Coulomb coefficient of each node: that of its point load, where that has its own."""
    rough = np.full(mesh.elements + 1, float(friction))
    for load, node in mesh.loads:
        if load.friction is not None:
            rough[node] = load.friction
    return rough


def _ground(meshes: Sequence[LineMesh], bars: Bars, bed: Bed | HeldBed, friction: float) -> Ground:
    carried = to_nodes(bars.length, bars.start)
    zero, none = np.zeros(carried.size), np.zeros((carried.size, 2))
    foot = np.full((carried.size, 2), np.nan)
    if isinstance(bed, HeldBed):
        held = np.full(carried.size, np.inf)
        return Ground(held, zero, none, 0.0, NO_FRICTION, zero, foot)
    rough = np.concatenate([node_friction(mesh, friction) for mesh in meshes])
    half, first = 0.5 * np.maximum(bars.submerged, 0.0), bar_nodes(bars.start)
    beside = none
    beside[first + 1, 0] = half
    beside[first, 1] = half
    return Ground(
        stiffness=bed.normal_stiffness * carried,
        friction=rough,
        beside=(friction - rough)[:, np.newaxis] * beside,
        bed_friction=float(friction),
        law=_LAWS[bed.friction_law] if rough.any() else NO_FRICTION,
        tangential=bed.tangential_stiffness * carried,
        spring_foot=foot,
    )
