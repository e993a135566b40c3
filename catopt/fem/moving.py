"""Lines in motion as the kernels take them: what they are made of, and how they move.

Nodes and bars of all lines follow one another, as in `resting`: bar e of line k lies between the
nodes e + k and e + k + 1. The first node of a line is its anchor, the last its fairlead. Behind the
nodes of all lines comes one for each joint, with what is fixed to it; ends of lines that meet there
move with it.
"""

from __future__ import annotations

from typing import NamedTuple

from catopt.arrays import Array, Codes, Flags
from catopt.compiled import packed


@packed
class MovingLines(NamedTuple):
    """What does not change in a run."""

    start: Codes  # (lines + 1,): first bar of each line
    # Of each bar, shape (bars,), per unstretched length:
    length: Array  # unstretched, m
    EA: Array  # axial stiffness, N
    damping: Array  # force per rate of strain, N s
    mass: Array  # in air, kg/m
    displaced: Array  # mass of the water whose place the bar takes, kg/m
    added_normal: Array  # added mass, kg/m
    added_tangential: Array
    drag_normal: Array  # 0.5 rho D C, N s2/m3
    drag_tangential: Array
    drag_by_speed: Array  # 0.5 rho D C_n m of the drag along the bar, see `morison`, N s2/m3
    drag_by_across: Array  # 0.5 rho D C_n n of it
    weight: Array  # submerged, N/m
    weight_in_air: Array  # N/m
    # Of each node:
    node_force: Array  # (nodes, 3): constant forces, N
    node_mass: Array  # (nodes,): of what is fixed to it, kg
    # Of each point load, shape (loads,):
    load_node: Codes
    load_displaced: Array  # mass of the water whose place it takes, kg
    load_added: Array  # added mass, kg
    load_drag: Array  # 0.5 rho Cd A, N s2/m2
    load_radius: Array  # of a sphere of its volume, m
    load_gravity: float  # by which displaced water lifts, m/s2
    # Of the bed under each node, shape (nodes,):
    bed_stiffness: Array  # N/m; 0 where there is none
    bed_damping: Array  # N s/m
    bed_depth: Array  # from which the damping acts fully, m
    held: Flags  # whether the bed also holds the node down, as source S4 has it
    drag_spring: Array  # of the friction along the bed before it slips, N/m
    drag_dashpot: Array  # N s/m
    bed_cos: float  # of the angle by which the bed rises along x; it passes through x = z = 0
    bed_sin: float
    friction: Array  # Coulomb; of a point load and the half bars beside it by their weights
    mass_factor: float  # Rayleigh's alpha, 1/s
    stiffness_factor: float  # Rayleigh's beta, s
    # Share of a bar's mass in the inertia of a node by its own acceleration and by that of the
    # bar's other node: 1/3 and 1/6 when consistent, 1/2 and 0 when lumped.
    near: float
    far: float
    pushes: bool  # whether a bar carries compression
    lower_free: Flags  # (lines,): whether the first node moves, freely or with a joint; held or
    # led otherwise
    of_end: Codes  # (lines, 2): joint with which the first and the last node move; -1: with none
    force_scale: float  # what the heaviest line weighs, N: forces are small against it or the
    # largest tension


@packed
class BodyNode(NamedTuple):
    """What the last nodes of all lines are fixed to; along x, y and z, shape (3,)."""

    free: Array  # 1.0 for each direction in which it moves under forces; 0.0 where it is led
    mass: Array  # its own, kg
    damping: Array  # linear, N s/m


@packed
class Moving(NamedTuple):
    """Where the lines are at one time."""

    x: Array  # (nodes, 3): coordinates, velocities and accelerations
    v: Array
    a: Array
    axis: Array  # (bars, 3): directions
    tension: Array  # (bars,): with its damping, N
    force: Array  # (nodes, 3): all forces but inertia, N
    reaction: Array  # (nodes,): force of the bed away from it, N
    rub: Array  # (nodes, 2): friction of the bed, along the bed and along y, N
    foot: Array  # (nodes, 2): of the friction springs, along the bed and along y, m; nan for a
    # node that does not lie
    body_force: Array  # (3,): on the body, but inertia and forces of the lines, N


@packed
class WaterAt(NamedTuple):
    """The water at the nodes, taken once a step."""

    velocity: Array  # (nodes, 3): at the step's end, m/s
    acceleration: Array  # (nodes, 3): at the time at which the step balances inertia, m/s2
    latest: Array  # (nodes, 3): acceleration at the step's end
    surface: Array  # (nodes,): height up to which there is water, m
    wet: Array  # (bars, 2): part of each half bar that is in the water


class Blend(NamedTuple):
    """Where in a step the forces and the inertia balance, and what a displacement brings with it.

    The last but one are derivatives by the displacement at the step's end of the blended
    displacement (1), velocity (1/s) and acceleration (1/s2).
    """

    before_force: float  # weight alpha_f of the step's start
    before_inertia: float  # weight alpha_m of it
    by_x: float
    by_v: float
    by_a: float
    step: float = 0.0  # length of the step, s; 0 at rest


@packed
class Equations(NamedTuple):
    """Room for one set of linear equations, three a node."""

    diagonal: Array  # (nodes, 3, 3): derivatives of a node's balance by its own displacement
    lower: Array  # by that of the node before it
    upper: Array  # by that of the node after it
    rest: Array  # (nodes, 3): what is left over, N; then the displacements, m
    acceleration: Array  # (nodes, 3): what inertia acts by, m/s2, Rayleigh's mass damping included
