"""A line cut into bars, with every joint on a node, and all that rests as the kernels take it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from numbers import Integral

import numpy as np

from catopt.arrays import Array, Codes
from catopt.constants import STANDARD_GRAVITY
from catopt.fem.loads import Current
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
    RestrainedBed,
)
from catopt.fem.static_model import Bars, Body, State
from catopt.model import Line, PointLoad
from catopt.model.kinds import Findings
from catopt.words import Message

SAME_PLACE = 1e-9
"""Two joints closer than this part of the line's length are one."""
_SHARP = 2.0
"""A bend is sharp whose radius of curvature is below this many bars."""
_SHARPEST = 1e-6
"""Radius of curvature, over the line's length, below which a bend is a kink."""
_BARS = 4.0
"""Bars over the radius of a sharp bend, and over the distance from it."""


@dataclass(frozen=True)
class LineMesh:
    """A line cut into bars."""

    line: Line
    joints: tuple[float, ...]  # arc lengths at which something changes, with both ends, m
    counts: tuple[int, ...]  # bars between one joint and the next

    @property
    def elements(self) -> int:
        """Number of bars."""
        return sum(self.counts)

    @cached_property
    def arc(self) -> Array:
        """Unstretched arc length of the nodes from the anchor, m, shape (elements + 1,)."""
        pieces = [
            np.linspace(start, end, count, endpoint=False)
            for (start, end), count in zip(pairwise(self.joints), self.counts, strict=True)
        ]
        return np.append(np.concatenate(pieces), self.joints[-1])

    @cached_property
    def length(self) -> Array:
        """Unstretched length of each bar, m, shape (elements,); the same within a piece."""
        sizes = np.diff(self.joints) / self.counts
        return np.repeat(sizes, self.counts)

    @cached_property
    def segment(self) -> Codes:
        """Index of the segment to which each bar belongs, shape (elements,)."""
        ends = np.cumsum([s.length for s in self.line.segments])[:-1]
        middles = 0.5 * (self.arc[1:] + self.arc[:-1])
        return np.searchsorted(ends, middles)

    @cached_property
    def load_node(self) -> Codes:
        """Node of each point load of the line, shape (point loads,)."""
        positions = [load.position for load in self.line.point_loads]
        return np.array([self.nearest(s) for s in positions], dtype=np.int64)

    def nearest(self, arc: float) -> int:
        """Node nearest to an arc length, m."""
        return int(np.abs(self.arc - arc).argmin())

    @property
    def loads(self) -> list[tuple[PointLoad, int]]:
        """Point loads of the line with their nodes."""
        return list(zip(self.line.point_loads, self.load_node.tolist(), strict=True))

    def refined(self, factor: int = 2) -> LineMesh:
        """Return the same line with every bar cut into `factor` equal parts."""
        return LineMesh(self.line, self.joints, tuple(count * factor for count in self.counts))


def mesh_line(
    line: Line,
    elements: int | Sequence[int] = 100,
    *,
    element_length: float | None = None,
    bends: Sequence[tuple[float, float]] = (),
) -> LineMesh:
    """Cut a line into bars of nearly one length, with a node at every joint and point load.

    Around a bend that is too sharp for them bars are shorter, and grow with the distance from it.

    Parameters
    ----------
    elements : int or sequence of int
        Bars of the whole line, shared by length; at least one falls on every piece, so that there
        may be a few more. Or bars of each segment, from the anchor.
    element_length : float, optional
        Largest length of a bar, m; instead of `elements`.
    bends : sequence of (float, float)
        Arc length and radius of curvature of every sharp bend, m.

    Raises
    ------
    InputError
        When the numbers do not fit the line.
    """
    _check(line, elements, element_length)
    bounds = np.concatenate([[0.0], np.cumsum([s.length for s in line.segments])])
    sizes = _target_lengths(line, elements, element_length)
    least = _SHARPEST * line.length
    sharp = [(at, max(r, least)) for at, r in bends if r < _SHARP * sizes.max()]
    joints = _joints(line, [*bounds, *_rings(line, sharp, float(sizes.max()))])
    owner = np.searchsorted(bounds[1:-1], 0.5 * (joints[1:] + joints[:-1]))
    pieces = np.diff(joints)
    wanted = np.minimum(sizes[owner], _beside(joints, sharp))
    counts = np.maximum(1, np.ceil(pieces / wanted - 1e-6)).astype(int)
    return LineMesh(line, tuple(joints.tolist()), tuple(counts.tolist()))


def _joints(line: Line, places: Sequence[float]) -> Array:
    """Arc lengths of segment ends, point loads and other places, each once."""
    tolerance = SAME_PLACE * line.length
    joints: list[float] = []
    for place in (0.0, line.length, *(load.position for load in line.point_loads), *places):
        if all(abs(place - joint) > tolerance for joint in joints):
            joints.append(place)
    return np.sort(np.array(joints))


def _rings(line: Line, bends: Sequence[tuple[float, float]], size: float) -> list[float]:
    """Places around bends between which the bars keep one length, each twice as far as the last."""
    places = []
    for place, radius in bends:
        away = radius
        places.append(place)
        while away < _BARS * size:
            places += [place - away, place + away]
            away *= 2.0
    return [place for place in places if 0.0 < place < line.length]


def _beside(joints: Array, bends: Sequence[tuple[float, float]]) -> Array:
    """Largest length of a bar between two joints that bends allow, m."""
    wanted = np.full(len(joints) - 1, np.inf)
    for place, radius in bends:
        away = np.maximum(0.0, np.maximum(joints[:-1] - place, place - joints[1:]))
        wanted = np.minimum(wanted, np.maximum(radius, away) / _BARS)
    return wanted


def _target_lengths(
    line: Line, elements: int | Sequence[int], element_length: float | None
) -> Array:
    """Wanted bar length in each segment, m."""
    if element_length is not None:
        return np.full(len(line.segments), element_length)
    if isinstance(elements, (int, Integral)):
        return np.full(len(line.segments), line.length / elements)
    sizes: Array = np.array([s.length for s in line.segments]) / np.array(elements)
    return sizes


def _check(line: Line, elements: int | Sequence[int], element_length: float | None) -> None:
    found = Findings("mesh_line")
    if element_length is not None and not element_length > 0.0:
        found.add("element_length", repr(element_length), Message("refused_motion.zero_metres"))
    counts = [elements] if isinstance(elements, (int, Integral)) else list(elements)
    if any(count < 1 for count in counts):
        found.add("elements", repr(elements), Message("refused_motion.one_bar"))
    if not isinstance(elements, (int, Integral)) and len(counts) != len(line.segments):
        wanted = Message("refused_motion.one_number_each", count=len(line.segments))
        found.add("elements", repr(elements), wanted)
    found.raise_if_any()


def by_bar(meshes: Sequence[LineMesh], name: str) -> Array:
    """Figure of the segment to which each bar of all lines belongs."""
    rows = (np.array([getattr(each, name) for each in m.line.segments], float) for m in meshes)
    return np.concatenate([row[m.segment] for row, m in zip(rows, meshes, strict=True)])


def first_bars(meshes: Sequence[LineMesh]) -> Codes:
    """First bar of each line, bars of all lines following one another; shape (lines + 1,)."""
    return np.concatenate([[0], np.cumsum([mesh.elements for mesh in meshes])]).astype(np.int64)


def bar_nodes(start: Codes) -> Codes:
    """First node of each bar, by the first bar of each line; shape (bars,)."""
    return np.arange(start[-1]) + np.repeat(np.arange(start.size - 1), np.diff(start))


def end_nodes(start: Codes) -> tuple[Codes, Codes]:
    """First and last node of each line, by its first bar; shape (lines,)."""
    lines = np.arange(start.size - 1)
    return start[:-1] + lines, start[1:] + lines


def to_nodes(per_bar: Array, start: Codes) -> Array:
    """Half of what each bar has, for either of its nodes; shape (nodes,)."""
    first = bar_nodes(start)
    total = np.zeros(first.size + start.size - 1)
    total[first] += 0.5 * per_bar
    total[first + 1] += 0.5 * per_bar
    return total


def heaviest(start: Codes, weight: Array, nodal: Array) -> float:
    """Return what the heaviest line weighs with the loads on its nodes, N."""
    largest = 0.0
    for k, (first, end) in enumerate(pairwise(start)):
        loads = np.abs(nodal[first + k : end + k + 1]).sum()
        largest = max(largest, float(np.abs(weight[first:end]).sum() + loads))
    return largest


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
    bed: Bed | RestrainedBed,
    friction: float,
    water: Water,
    carries_compression: bool,
) -> Problem:
    """Lay out all lines, one after the other; they meet in the points of `body`."""
    start = first_bars(meshes)
    length = np.concatenate([mesh.length for mesh in meshes])
    multiplier = bed.EA_multiplier if isinstance(bed, RestrainedBed) else 1.0
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


def _contact(mesh: LineMesh, bed: Bed | RestrainedBed) -> Codes:
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


def _ground(
    meshes: Sequence[LineMesh], bars: Bars, bed: Bed | RestrainedBed, friction: float
) -> Ground:
    carried = to_nodes(bars.length, bars.start)
    zero, none = np.zeros(carried.size), np.zeros((carried.size, 2))
    foot = np.full((carried.size, 2), np.nan)
    if isinstance(bed, RestrainedBed):
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
