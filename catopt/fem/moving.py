"""Lines in motion as the kernels take them: what they are made of, and how they move.

Nodes and bars of all lines follow one another, as in `assembly.Bars`: bar e of line k lies between
the nodes e + k and e + k + 1. The first node of a line is its anchor, the last its fairlead.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]


class MovingLines(NamedTuple):
    """What does not change in a run.

    Attributes
    ----------
    start : array of int, shape (lines + 1,)
        First bar of each line.
    length : array, shape (bars,)
        Unstretched, m.
    EA, damping : array, shape (bars,)
        Axial stiffness, N, and force per rate of strain, N s.
    mass, displaced : array, shape (bars,)
        Per unstretched length, kg/m: in air, and of the water whose place the bar takes.
    added_normal, added_tangential : array, shape (bars,)
        Added mass, kg/m.
    drag_normal, drag_tangential : array, shape (bars,)
        0.5 rho D C, N s2/m3.
    drag_by_speed, drag_by_across : array, shape (bars,)
        0.5 rho D C_n m and 0.5 rho D C_n n of the drag along the bar, see `morison`, N s2/m3.
    weight, weight_in_air : array, shape (bars,)
        N/m.
    node_force : array, shape (nodes, 3)
        Constant forces on the nodes, N.
    node_mass : array, shape (nodes,)
        Mass of what is fixed to the nodes, kg.
    load_node : array of int, shape (loads,)
        Node of each point load.
    load_displaced, load_added, load_drag, load_radius : array, shape (loads,)
        Of each: water whose place it takes and added mass, kg; 0.5 rho Cd A, N s2/m2; radius of a
        sphere of its volume, m.
    load_gravity : float
        By which displaced water lifts, m/s2.
    bed_stiffness, bed_damping : array, shape (nodes,)
        Of the bed under each node, N/m and N s/m; 0 where there is none.
    bed_depth : array, shape (nodes,)
        Depth from which the damping acts fully, m.
    held : array of bool, shape (nodes,)
        Whether the bed also holds the node down, as source S4 has it.
    drag_spring, drag_dashpot : array, shape (nodes,)
        Of the friction along the bed before it slips, N/m and N s/m.
    bed_cos, bed_sin : float
        Of the angle by which the bed rises along x; it passes through x = z = 0.
    friction : array, shape (nodes,)
        Coulomb coefficient; of a point load and the half bars beside it by their weights.
    mass_factor, stiffness_factor : float
        Rayleigh's alpha (1/s) and beta (s).
    near, far : float
        Share of a bar's mass in the inertia of a node by its own acceleration and by that of the
        bar's other node: 1/3 and 1/6 when consistent, 1/2 and 0 when lumped.
    pushes : bool
        Whether a bar carries compression.
    lower_free : array of bool, shape (lines,)
        Whether the first node of each line moves freely; held or led otherwise.
    force_scale : float
        What the heaviest line weighs, N: forces are small against it or the largest tension.
    """

    start: npt.NDArray[np.int64]
    length: Array
    EA: Array
    damping: Array
    mass: Array
    displaced: Array
    added_normal: Array
    added_tangential: Array
    drag_normal: Array
    drag_tangential: Array
    drag_by_speed: Array
    drag_by_across: Array
    weight: Array
    weight_in_air: Array
    node_force: Array
    node_mass: Array
    load_node: npt.NDArray[np.int64]
    load_displaced: Array
    load_added: Array
    load_drag: Array
    load_radius: Array
    load_gravity: float
    bed_stiffness: Array
    bed_damping: Array
    bed_depth: Array
    held: npt.NDArray[np.bool_]
    drag_spring: Array
    drag_dashpot: Array
    bed_cos: float
    bed_sin: float
    friction: Array
    mass_factor: float
    stiffness_factor: float
    near: float
    far: float
    pushes: bool
    lower_free: npt.NDArray[np.bool_]
    force_scale: float


class BodyNode(NamedTuple):
    """What the last nodes of all lines are fixed to.

    `free` (3,): 1.0 for each direction in which it moves under the forces on it; 0.0 where it is
    led; `mass`, `damping` (3,): its own inertia, kg, and linear damping, N s/m, along x, y and z.
    """

    free: Array
    mass: Array
    damping: Array


class Moving(NamedTuple):
    """Where the lines are at one time.

    Attributes
    ----------
    x, v, a : array, shape (nodes, 3)
        Coordinates, velocities and accelerations.
    axis : array, shape (bars, 3)
        Directions of the bars.
    tension : array, shape (bars,)
        With its damping, N.
    force : array, shape (nodes, 3)
        All forces on the nodes but inertia, N.
    reaction : array, shape (nodes,)
        Force of the bed away from it, N.
    rub : array, shape (nodes, 2)
        Friction of the bed on the nodes, along the bed and along y, N.
    foot : array, shape (nodes, 2)
        Where the friction springs have their feet, along the bed and along y, m; nan for a node
        that does not lie.
    body_force : array, shape (3,)
        All forces on the body but inertia and those of the lines, N.
    """

    x: Array
    v: Array
    a: Array
    axis: Array
    tension: Array
    force: Array
    reaction: Array
    rub: Array
    foot: Array
    body_force: Array


class WaterAt(NamedTuple):
    """The water at the nodes, taken once a step.

    Attributes
    ----------
    velocity : array, shape (nodes, 3)
        m/s, at the step's end.
    acceleration : array, shape (nodes, 3)
        m/s2, at the time at which the step balances inertia.
    latest : array, shape (nodes, 3)
        Acceleration at the step's end.
    surface : array, shape (nodes,)
        Height up to which there is water, m.
    wet : array, shape (bars, 2)
        Part of each half bar that is in the water.
    """

    velocity: Array
    acceleration: Array
    latest: Array
    surface: Array
    wet: Array


class Blend(NamedTuple):
    """Where in a step the forces and the inertia balance, and what a displacement brings with it.

    `before_force`, `before_inertia`: weights alpha_f and alpha_m of the step's start; `by_x`,
    `by_v`, `by_a`: derivatives by the displacement at the step's end of the blended displacement
    (1), velocity (1/s) and acceleration (1/s2); `step`: length of the step, s; 0 at rest.
    """

    before_force: float
    before_inertia: float
    by_x: float
    by_v: float
    by_a: float
    step: float = 0.0


class Equations(NamedTuple):
    """Room for one set of linear equations, three a node.

    Attributes
    ----------
    diagonal, lower, upper : array, shape (nodes, 3, 3)
        Derivatives of a node's balance by its own displacement and those of the nodes before and
        after it.
    rest : array, shape (nodes, 3)
        What is left over, N; then the displacements, m.
    acceleration : array, shape (nodes, 3)
        Work space: what inertia acts by, m/s2, Rayleigh's mass damping included.
    """

    diagonal: Array
    lower: Array
    upper: Array
    rest: Array
    acceleration: Array
