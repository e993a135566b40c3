"""What is to come to rest, laid out as the kernels take it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
import numpy.typing as npt

from catopt.constants import STANDARD_GRAVITY
from catopt.fem.assembly import Bars, State
from catopt.fem.bed import (
    ABSENT,
    FREE,
    HELD,
    LAID,
    NO_FRICTION,
    ON_BED,
    PULLED,
    SPRING,
    Bed,
    Ground,
    HeldBed,
)
from catopt.fem.loads import Current, Weights
from catopt.fem.mesh import LineMesh, by_bar
from catopt.fem.step import Body

Array = npt.NDArray[np.float64]

_SAME_PLACE = 1e-9


@dataclass(frozen=True)
class Water:
    """Where the water is, when it matters.

    Attributes
    ----------
    surface : float
        Height of the still water surface, m; above it the line has its weight in air, for which
        every segment needs its mass. Infinite: all is taken to be submerged.
    current : Current or None
        Moving water.
    gravity : float
        m/s2, for the weight in air.
    """

    surface: float = math.inf
    current: Current | None = None
    gravity: float = STANDARD_GRAVITY


@dataclass(frozen=True)
class Problem:
    """What is to come to rest.

    Attributes
    ----------
    bars, weights, nodal, ground, body
        As the kernels take them.
    contact : ndarray of int, shape (nodes,)
        What the bed does to each node before anything has moved.
    carries_compression : bool
        Whether bars push when they are shorter than their length.
    soft : float
        Stiffness of the first springs, N: what lines and loads weigh.
    across, along : ndarray, shape (bars,)
        0.5 rho D C, N s2/m3; empty without a current.
    current : Current or None
        Moving water.
    """

    bars: Bars
    weights: Weights
    nodal: Array
    ground: Ground
    contact: npt.NDArray[np.int64]
    body: Body
    carries_compression: bool
    soft: float
    across: Array
    along: Array
    current: Current | None

    @property
    def first_node(self) -> npt.NDArray[np.int64]:
        """First node of each bar, shape (bars,)."""
        start = self.bars.start
        return np.arange(start[-1]) + np.repeat(np.arange(start.size - 1), np.diff(start))

    @property
    def carried(self) -> Array:
        """Unstretched length that each node carries, m, shape (nodes,)."""
        half = np.zeros(self.nodal.shape[0])
        half[self.first_node] += 0.5 * self.bars.length
        half[self.first_node + 1] += 0.5 * self.bars.length
        return half

    def with_body(self, body: Body) -> Problem:
        """Return the same problem with another force on the body or another place for it."""
        return replace(self, body=body)

    def with_ground(self, ground: Ground) -> Problem:
        """Return the same problem on another bed."""
        return replace(self, ground=ground)


def build(
    meshes: Sequence[LineMesh],
    body: Body,
    bed: Bed | HeldBed,
    friction: float,
    water: Water,
    carries_compression: bool,
) -> Problem:
    """Lay out all lines, one after the other.

    `body`: where they meet.
    """
    counts = [mesh.elements for mesh in meshes]
    start = np.concatenate([[0], np.cumsum(counts)]).astype(np.int64)
    length = np.concatenate([mesh.length for mesh in meshes])
    multiplier = bed.EA_multiplier if isinstance(bed, HeldBed) else 1.0
    with np.errstate(divide="ignore"):
        compliance = 1.0 / (multiplier * by_bar(meshes, "EA"))
    submerged = length * by_bar(meshes, "submerged_weight")
    in_air = submerged
    if math.isfinite(water.surface):
        in_air = length * water.gravity * by_bar(meshes, "mass")
    nodal = np.concatenate([_point_loads(mesh) for mesh in meshes])
    across, along = _drag(meshes, water.current)
    soft = _weight_scale(start, submerged, nodal, body)
    problem = Problem(
        bars=Bars(length, compliance, start),
        weights=Weights(submerged, in_air, water.surface),
        nodal=nodal,
        ground=_frictionless(np.empty(0)),
        contact=np.concatenate([_contact(mesh, bed) for mesh in meshes]),
        body=body,
        carries_compression=carries_compression,
        soft=soft,
        across=across,
        along=along,
        current=water.current,
    )
    rough = np.concatenate([node_friction(mesh, friction) for mesh in meshes])
    return problem.with_ground(_ground(problem, bed, friction, rough))


def straight(problem: Problem, anchors: Array, fairleads: Array) -> State:
    """Every line straight from its anchor to its fairlead, without tension.

    `anchors`, `fairleads` (lines, 3): their ends, m.
    """
    bars = problem.bars
    nodes = problem.nodal.shape[0]
    x = np.empty((nodes, 3))
    for k, (first, end) in enumerate(pairwise(bars.start)):
        arc = np.concatenate([[0.0], np.cumsum(bars.length[first:end])])
        part = (arc / arc[-1])[:, np.newaxis]
        x[first + k : end + k + 1] = (1.0 - part) * anchors[k] + part * fairleads[k]
    contact = problem.contact.copy()
    ends = np.concatenate([bars.start[:-1], bars.start[1:]])
    ends += np.tile(np.arange(bars.start.size - 1), 2)
    lies = ends[(contact[ends] == FREE) & (x[ends, 2] <= 0.0)]
    contact[lies] = ON_BED
    return State(
        x=x,
        tension=np.zeros(bars.length.size),
        contact=contact,
        reaction=np.zeros(nodes),
        balance=np.zeros((nodes, 3)),
    )


def _point_loads(mesh: LineMesh) -> Array:
    nodal = np.zeros((mesh.elements + 1, 3))
    for load, node in zip(mesh.line.point_loads, mesh.load_node, strict=True):
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


def _contact(mesh: LineMesh, bed: Bed | HeldBed) -> npt.NDArray[np.int64]:
    if isinstance(bed, Bed):
        return np.full(mesh.elements + 1, FREE, dtype=np.int64)
    is_held = mesh.arc <= bed.grounded_length + _SAME_PLACE * mesh.line.length
    return np.where(is_held, HELD, ABSENT).astype(np.int64)


def node_friction(mesh: LineMesh, friction: float) -> Array:
    """Coulomb coefficient of each node: that of its point load, where that has its own."""
    rough = np.full(mesh.elements + 1, float(friction))
    for load, node in zip(mesh.line.point_loads, mesh.load_node, strict=True):
        if load.friction is not None:
            rough[node] = load.friction
    return rough


def _frictionless(stiffness: Array) -> Ground:
    nodes = stiffness.size
    zero, foot = np.zeros(nodes), np.full((nodes, 2), np.nan)
    return Ground(stiffness, zero, np.zeros((nodes, 2)), 0.0, NO_FRICTION, zero, foot)


def _ground(problem: Problem, bed: Bed | HeldBed, friction: float, rough: Array) -> Ground:
    carried = problem.carried
    if isinstance(bed, HeldBed):
        return _frictionless(np.full(carried.size, np.inf))
    beside = np.zeros((carried.size, 2))
    half = 0.5 * np.maximum(problem.weights.submerged, 0.0)
    beside[problem.first_node + 1, 0] = half
    beside[problem.first_node, 1] = half
    law = {"pulled": PULLED, "laid": LAID, "history": SPRING}[bed.friction_law]
    return _frictionless(bed.normal_stiffness * carried)._replace(
        friction=rough,
        beside=(friction - rough)[:, np.newaxis] * beside,
        bed_friction=float(friction),
        law=law if rough.any() else NO_FRICTION,
        tangential=bed.tangential_stiffness * carried,
    )


def _weight_scale(
    start: npt.NDArray[np.int64], submerged: Array, nodal: Array, body: Body
) -> float:
    """Return what the heaviest line weighs, with the force on the body."""
    largest = 0.0
    for k, (first, end) in enumerate(pairwise(start)):
        loads = np.abs(nodal[first + k : end + k + 1]).sum()
        largest = max(largest, float(np.abs(submerged[first:end]).sum() + loads))
    force = float(np.linalg.norm(body.free * body.force))
    return largest + force if largest + force > 0.0 else 1.0
