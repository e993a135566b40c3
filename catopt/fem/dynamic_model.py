"""Lines laid out for the kernels of their motion."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from catopt.arrays import Array, Codes, Flags
from catopt.constants import SEA_WATER_DENSITY, STANDARD_GRAVITY
from catopt.fem.mesh import (
    SAME_PLACE,
    LineMesh,
    by_bar,
    first_bars,
    heaviest,
    node_friction,
    to_nodes,
)
from catopt.fem.morison import MorisonSection
from catopt.fem.moving import MovingLines
from catopt.fem.newmark import LineDamping
from catopt.fem.seabed import RestrainedBed, Seabed
from catopt.model import PointLoad
from catopt.model.kinds import Findings
from catopt.model.network import Point
from catopt.words import Message

MassMatrix = Literal["consistent", "lumped"]

_OF_WATER = [
    "added_normal",
    "added_tangential",
    "drag_normal",
    "drag_tangential",
    "drag_by_speed",
    "drag_by_across",
]
_OF_LOADS = ("load_displaced", "load_added", "load_drag", "load_radius")
"""Figures of `MovingLines` of each bar in the water and of each point load, as their rows are."""
_OF_BED = ("bed_stiffness", "bed_damping", "bed_depth", "drag_spring", "drag_dashpot")
_SHARES = {"consistent": (1.0 / 3.0, 1.0 / 6.0), "lumped": (0.5, 0.0)}
_OWN_DEPTH = 0.01
"""Depth to which a line's own weight presses a bed of no given stiffness, m."""
_HOLDING = 1e4
"""Factor on that stiffness where a `RestrainedBed` holds."""
_LEAST_RADIUS = 1e-6
"""Of a point load without volume, m."""
_FRICTION_REACH = 0.001
"""Displacement along a bed of no given stiffness after which friction is mobilised, m."""


@dataclass(frozen=True)
class Fluid:
    """Water and gravity."""

    density: float = SEA_WATER_DENSITY  # kg/m3
    gravity: float = STANDARD_GRAVITY  # m/s2


@dataclass(frozen=True)
class LineProperties:
    """What lines need for their dynamics beside their segments' figures."""

    sections: Sequence[MorisonSection] | None = None  # one for each segment from the anchor, for
    # every line; None: the water does nothing but carry
    damping: LineDamping = field(default_factory=LineDamping)  # of the line itself
    fluid: Fluid = field(default_factory=Fluid)
    # None: no bed. A `RestrainedBed` is that of source S4, for comparison with its figures.
    seabed: Seabed | RestrainedBed | None = field(default_factory=Seabed)
    mass_matrix: MassMatrix = "consistent"  # how a bar's mass acts on its nodes
    of_lines: Sequence[Sequence[MorisonSection]] | None = None  # sections of each line, in the
    # place of those of all


def lay_out_moving(
    meshes: Sequence[LineMesh],
    of: LineProperties,
    joints: Sequence[Point] = (),
    of_end: Codes | None = None,
) -> MovingLines:
    """Arrays of all lines, one after the other; raises InputError for what is missing.

    `of_end`: as of `MovingLines`; without, no line ends at a joint.
    """
    fluid, seabed, damping = of.fluid, of.seabed, of.damping
    sections = of.of_lines
    if sections is None and of.sections is not None:
        sections = [of.sections] * len(meshes)
    _check(meshes, sections, joints, fluid)
    start = first_bars(meshes)
    length = np.concatenate([mesh.length for mesh in meshes])
    EA, mass, weight = (by_bar(meshes, name) for name in ("EA", "mass", "submerged_weight"))
    of_line = np.concatenate([np.full(mesh.length.size, mesh.line.length) for mesh in meshes])
    in_air = mass * fluid.gravity
    displaced = (in_air - weight) / fluid.gravity
    water = np.zeros((6, length.size))
    if sections is not None:
        rows = [np.array([_section_row(s, fluid.density) for s in own]).T for own in sections]
        cut = zip(rows, meshes, strict=True)
        water = np.concatenate([row[:, mesh.segment] for row, mesh in cut], axis=1)
        water[:2] *= np.maximum(displaced, 0.0)
    carried, pressing, heavy = (
        to_nodes(length * each, start) for each in (1.0, np.maximum(weight, 0.0), mass + water[0])
    )
    force = np.zeros((carried.size + len(joints), 3))
    node_mass = np.zeros(carried.size + len(joints))
    loads: list[tuple[PointLoad | Point, int]] = [
        (load, int(start[k]) + k + node)
        for k, mesh in enumerate(meshes)
        for load, node in mesh.loads
    ]
    for n, joint in enumerate(joints, start=carried.size):
        force[n] = joint.force
        loads.append((joint, n))
    for load, n in loads:
        force[n, 2] -= load.submerged_weight
        node_mass[n] += load.mass or 0.0
    bodies = np.array([_body_row(load, fluid) for load, _ in loads]).reshape(-1, 4).T
    held = np.zeros(carried.size, dtype=bool)
    if isinstance(seabed, RestrainedBed):
        EA = EA * seabed.EA_multiplier
        reach = seabed.grounded_length
        held = np.concatenate([m.arc <= reach * (1.0 + SAME_PLACE) for m in meshes])
    rise = float(seabed.slope) if isinstance(seabed, Seabed) else 0.0
    near, far = _SHARES[of.mass_matrix]
    ends = np.full((len(meshes), 2), -1) if of_end is None else of_end
    bed = dict(zip(_OF_BED, _bed_rows(seabed, carried, pressing, heavy, held), strict=True))
    bed["friction"] = _friction(meshes, seabed, pressing)
    # The bed carries a joint by the ends of its lines.
    bed = {name: np.append(row, np.zeros(len(joints))) for name, row in bed.items()}
    return MovingLines(
        start=start,
        length=length,
        EA=EA,
        damping=damping.per_bar(length, EA, mass, of_line),
        mass=mass,
        displaced=displaced if sections is not None else np.zeros(length.size),
        **{name: row.copy() for name, row in zip(_OF_WATER, water, strict=True)},
        weight=weight,
        weight_in_air=in_air,
        node_force=force,
        node_mass=node_mass,
        load_node=np.array([n for _, n in loads], dtype=np.int64),
        **{name: row.copy() for name, row in zip(_OF_LOADS, bodies, strict=True)},
        load_gravity=float(fluid.gravity),
        **bed,
        held=np.append(held, np.zeros(len(joints), dtype=bool)),
        bed_cos=math.cos(rise),
        bed_sin=math.sin(rise),
        mass_factor=float(damping.mass_factor),
        stiffness_factor=float(damping.stiffness_factor),
        near=near,
        far=far,
        pushes=False,
        lower_free=ends[:, 0] >= 0,
        of_end=ends,
        force_scale=max(heaviest(start, weight * length, force), 1e-9 * float(EA.max())),
    )


def _section_row(section: MorisonSection, density: float) -> tuple[float, ...]:
    """Figures as `_OF_WATER`, those of added mass over the mass of displaced water."""
    half = 0.5 * density * section.diameter
    return (
        section.added_mass_normal,
        section.added_mass_tangential,
        half * section.drag_normal,
        half * section.drag_tangential,
        *(half * section.drag_normal * part for part in section.oblique),
    )


def _body_row(load: PointLoad | Point, fluid: Fluid) -> tuple[float, float, float, float]:
    """Figures of a point load, or of what is fixed to a joint, as `_OF_LOADS`."""
    displaced = max((load.mass or 0.0) - load.submerged_weight / fluid.gravity, 0.0)
    volume = displaced / fluid.density if fluid.density > 0.0 else 0.0
    return (
        displaced,
        load.added_mass_coefficient * displaced,
        0.5 * fluid.density * load.drag_product,
        max((0.75 * volume / math.pi) ** (1.0 / 3.0), _LEAST_RADIUS),
    )


def _bed_rows(
    seabed: Seabed | RestrainedBed | None,
    carried: Array,
    pressing: Array,
    heavy: Array,
    held: Flags,
) -> tuple[Array, Array, Array, Array, Array]:
    """Stiffness, damping, depth of full damping, friction spring and dashpot of `_OF_BED`."""
    k, none = np.zeros(carried.size), np.zeros(carried.size)
    usual = max(float((pressing / carried).mean()), 1e-12)
    if not isinstance(seabed, Seabed):
        if seabed is not None:
            k = np.where(held, _HOLDING * usual / _OWN_DEPTH * carried, 0.0)
        return k, 2.0 * np.sqrt(k * heavy), np.ones(carried.size), none, none
    per_length = seabed.normal_stiffness
    k = (per_length if per_length is not None else usual / _OWN_DEPTH) * carried
    critical = 2.0 * np.sqrt(k * heavy)
    c = critical if seabed.normal_damping is None else seabed.normal_damping * carried
    along = seabed.tangential_stiffness
    if along is None:
        along = max(seabed.friction, 1e-3) * usual / _FRICTION_REACH
    spring = along * carried
    depth = np.maximum(pressing, 1e-3 * usual * carried) / k
    return k, c, depth, spring, 2.0 * np.sqrt(spring * heavy)


def _friction(
    meshes: Sequence[LineMesh], seabed: Seabed | RestrainedBed | None, pressing: Array
) -> Array:
    """Coulomb coefficient of each node, by what the line and its point load weigh there."""
    if not isinstance(seabed, Seabed):
        return np.zeros(pressing.size)
    bed = float(seabed.friction)
    rough = np.concatenate([node_friction(mesh, bed) for mesh in meshes])
    loads = np.concatenate([_pressing_loads(mesh) for mesh in meshes])
    weight = np.maximum(pressing + loads, 1e-300)
    mixed: Array = (pressing * bed + loads * rough) / weight
    return np.where(loads > 0.0, mixed, bed)


def _pressing_loads(mesh: LineMesh) -> Array:
    """Submerged weight of the clump weights on each node, N."""
    weight = np.zeros(mesh.elements + 1)
    for load, node in mesh.loads:
        weight[node] += max(load.submerged_weight, 0.0)
    return weight


def _check(
    meshes: Sequence[LineMesh],
    sections: Sequence[Sequence[MorisonSection]] | None,
    joints: Sequence[Point],
    fluid: Fluid,
) -> None:
    found = Findings("dynamics")
    found.number("fluid.density", fluid.density, "kg/m3", at_least=0.0)
    found.number("fluid.gravity", fluid.gravity, "m/s2", above=0.0)
    for i, mesh in enumerate(meshes):
        for j, segment in enumerate(mesh.line.segments):
            key = f"lines[{i}].segments[{j}]"
            if segment.mass is None or segment.mass == 0.0:
                found.add(f"{key}.mass", "", Message("refused_motion.needed_line_s_inertia"))
            elif segment.mass * fluid.gravity < segment.submerged_weight * (1.0 - 1e-6):
                weight = segment.submerged_weight
                words = Message("refused_motion.per_metre", mass=segment.mass, weight=weight)
                found.add(f"{key}.mass", words, Message("refused_motion.line_weighs_more_air_than"))
            if segment.is_inextensible:
                allowed = Message("refused_motion.line_motion_needs_axial_stiffness")
                found.add(f"{key}.EA", "inf", allowed)
        for j, load in enumerate(mesh.line.point_loads):
            _check_mass(f"lines[{i}].point_loads[{j}].mass", load, fluid, found)
        if sections is not None and len(sections[i]) != len(mesh.line.segments):
            count = len(mesh.line.segments)
            wanted = Message("refused_motion.one_for_each_segment", count=count, line=i + 1)
            found.add("sections", str(len(sections[i])), wanted)
    for i, joint in enumerate(joints):
        if joint.mass is not None or joint.submerged_weight:
            _check_mass(f"joints[{i}].mass", joint, fluid, found)
    found.raise_if_any()


def _check_mass(key: str, load: PointLoad | Point, fluid: Fluid, found: Findings) -> None:
    """Find a body without mass, or lighter in air than in water."""
    if load.mass is None:
        found.add(key, "", Message("refused_motion.needed_inertia"))
    elif load.mass * fluid.gravity < load.submerged_weight * (1.0 - 1e-6):
        weight = load.submerged_weight
        words = Message("refused_motion.mass_and_weight", mass=load.mass, weight=weight)
        found.add(key, words, Message("refused_motion.body_weighs_more_air_than"))
