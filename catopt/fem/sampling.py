"""What is kept of a run: samples of forces and places, and energies."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from catopt.fem.moving import BodyNode, Equations, Moving, MovingLines, WaterAt
from catopt.fem.moving_bar import inertia_of_half
from catopt.fem.moving_load import immersion
from catopt.fem.seabed import across_bed
from catopt.fem.series import SeriesRows, fill_series

Array = npt.NDArray[np.float64]


class Rules(NamedTuple):
    """How to step.

    Attributes
    ----------
    alpha_m, alpha_f, beta, gamma : float
        Of `newmark.Scheme`.
    step : float
        s.
    every : int
        Steps from one sample to the next.
    limit : int
        Newton iterations of a step before it is halved.
    halvings : int
        Times that a step may be halved.
    refinements : int
        Times that it is halved at most because a tension surprises.
    surprise : float
        Difference of a tension from what it was heading for beyond which that is done, over the
        largest tension of the run so far or what a line weighs.
    tolerance : float
        Largest force left over at a node, over the largest tension or what a line weighs.
    since : float
        Time from which envelopes and slack times are taken, s.
    """

    alpha_m: float
    alpha_f: float
    beta: float
    gamma: float
    step: float
    every: int
    limit: int
    halvings: int
    refinements: int
    surprise: float
    tolerance: float
    since: float


class Record(NamedTuple):
    """What is kept of a run; the first axis of the first eight counts samples.

    Attributes
    ----------
    time : array, shape (samples,)
        s.
    end_force : array, shape (samples, lines, 2, 3)
        Force of each line on what holds its anchor (0) and its fairlead (1), N.
    end_tension : array, shape (samples, lines, 2)
        Of the first and the last bar, N.
    fairlead : array, shape (samples, lines, 3)
        Place of each line's last node, m.
    grounded : array, shape (samples, lines)
        Unstretched length that nodes on the bed carry, m.
    place : array, shape (samples, chosen nodes, 3)
        m.
    energy : array, shape (samples or 0, 4)
        Kinetic, of strain, of weight, of the bed, J.
    tension : array, shape (samples or 0, bars)
        N.
    chosen : array of int, shape (chosen nodes,)
        Which.
    highest, lowest : array, shape (bars,)
        Tension, N.
    slack_time, longest_slack, slack_now : array, shape (bars,)
        s without tension: in all, at a stretch, and at the stretch that goes on.
    end_highest, end_time : array, shape (lines, 2)
        Largest size of the forces at the ends, N, and when, s, of every step.
    works : array, shape (8,)
        As `energy_balance.add_works` adds them, of every step, J.
    rest : array, shape (nodes, 3)
        Places from which the energies of strain, weight and bed count, m.
    """

    time: Array
    end_force: Array
    end_tension: Array
    fairlead: Array
    grounded: Array
    place: Array
    energy: Array
    tension: Array
    chosen: npt.NDArray[np.int64]
    highest: Array
    lowest: Array
    slack_time: Array
    longest_slack: Array
    slack_now: Array
    end_highest: Array
    end_time: Array
    works: Array
    rest: Array


class Room(NamedTuple):
    """Work space: the state and the water at a step's end, equations, small matrices, a force.

    `slope` is the rate of each bar's tension in the last step, N/s, `highest` the largest of all,
    and `change` that of the accelerations, m/s2;
    `booked` and `booked_before` are the forces whose work is booked, shape (4, nodes, 3), N, `ends`
    and `ends_before` those at the ends, shape (lines, 2, 3), at a step's end and at its start, and
    `wet_before` what is in the water at its start.
    """

    now: Moving
    water: WaterAt
    water_before: Array
    equations: Equations
    small: Array
    force: Array
    slope: Array
    highest: Array
    change: Array
    booked: Array
    booked_before: Array
    ends: Array
    ends_before: Array
    wet_before: Array


def take_sample(
    sample: int, rules: Rules, lines: MovingLines, led: SeriesRows, body: BodyNode, at: Moving,
    room: Room, record: Record,
) -> None:  # fmt: skip
    """Write a sample.

    `room`: accelerations at its time are in `room.equations.acceleration`; `record`: written to.
    """
    t = sample * rules.every * rules.step
    record.time[sample] = t
    a = room.equations.acceleration
    for k in range(lines.start.shape[0] - 1):
        first, last = lines.start[k] + k, lines.start[k + 1] + k
        lower = lines.start.shape[0] - 1 + k
        if lower < led.base.shape[0] and not lines.lower_free[k]:
            fill_series(t, led, lower, room.small[0])
            for i in range(3):
                a[first, i] = room.small[0, 2, i]
        fill_series(t, led, k, room.small[0])
        for i in range(3):
            if body.free[i] == 0.0:
                a[last, i] = room.small[0, 2, i]
            record.fairlead[sample, k, i] = at.x[last, i]
        bar, bar_last = lines.start[k], lines.start[k + 1] - 1
        record.end_tension[sample, k, 0] = at.tension[bar]
        record.end_tension[sample, k, 1] = at.tension[bar_last]
        record.grounded[sample, k] = length_on_bed(k, lines, at)
    fill_end_forces(lines, at, a, room, record.end_force[sample])
    for c in range(record.chosen.shape[0]):
        for i in range(3):
            record.place[sample, c, i] = at.x[record.chosen[c], i]
    keep_tensions(sample, at, record)
    if record.energy.shape[0] > 0:
        fill_energy(lines, at, room, record.rest, record.energy[sample])


def keep_tensions(sample: int, at: Moving, record: Record) -> None:
    """Write the tension of every bar, N, where they are asked for."""
    if record.tension.shape[0] > 0:
        for e in range(record.tension.shape[1]):
            record.tension[sample, e] = at.tension[e]


def fill_end_forces(lines: MovingLines, at: Moving, a: Any, room: Room, to: Any) -> None:
    """Write the forces of all lines on what holds their anchors and fairleads, N.

    `a` (nodes, 3): accelerations, m/s2; `to` (lines, 2, 3): written to.
    """
    for k in range(lines.start.shape[0] - 1):
        first, last = lines.start[k] + k, lines.start[k + 1] + k
        if lines.lower_free[k]:
            for i in range(3):
                to[k, 0, i] = 0.0
        else:
            fill_end_force(lines.start[k], first, first + 1, lines, at, a, room, to[k, 0])
        fill_end_force(lines.start[k + 1] - 1, last, last - 1, lines, at, a, room, to[k, 1])


def fill_end_force(
    bar: int, node: int, other: int, lines: MovingLines, at: Moving, a: Any, room: Room, force: Any
) -> None:
    """Write the force of a line on what holds its end `node`, N: all of it but the inertia."""
    inertia = inertia_of_half(bar, node, other, lines, at, a, room.water)
    mass = lines.node_mass[node]
    force[0] = at.force[node, 0] - inertia[0] - mass * a[node, 0]
    force[1] = at.force[node, 1] - inertia[1] - mass * a[node, 1]
    force[2] = at.force[node, 2] - inertia[2] - mass * a[node, 2]


def length_on_bed(line: int, lines: MovingLines, at: Moving) -> float:
    """Unstretched length that a line's nodes on the bed carry, m."""
    lies = 0.0
    for e in range(lines.start[line], lines.start[line + 1]):
        for n in (e + line, e + line + 1):
            if at.reaction[n] > 0.0:
                lies += 0.5 * lines.length[e]
    return lies


def fill_energy(lines: MovingLines, at: Moving, room: Room, rest: Any, energy: Any) -> None:
    """Write kinetic energy and what strain, weight and bed hold more than at rest, J.

    `rest` (nodes, 3): places at rest, m; `energy` (4,): written to. Added mass counts in the
    kinetic energy.
    """
    for i in range(4):
        energy[i] = 0.0
    for k in range(lines.start.shape[0] - 1):
        for e in range(lines.start[k], lines.start[k + 1]):
            a, b = e + k, e + k + 1
            energy[0] += kinetic_energy(e, a, lines, at, room.water)
            energy[1] += strain_energy(e, a, lines, at, rest)
            rise = (at.x[a, 2] - rest[a, 2]) + (at.x[b, 2] - rest[b, 2])
            energy[2] += 0.5 * lines.weight[e] * lines.length[e] * rise
        for n in range(lines.start[k] + k, lines.start[k + 1] + k + 1):
            for i in range(3):
                energy[0] += 0.5 * lines.node_mass[n] * at.v[n, i] ** 2
                energy[2] -= lines.node_force[n, i] * (at.x[n, i] - rest[n, i])
            deep = max(-across_bed(at.x, n, lines), 0.0)
            deep_0 = max(-across_bed(rest, n, lines), 0.0)
            energy[3] += 0.5 * lines.bed_stiffness[n] * (deep * deep - deep_0 * deep_0)
    for j in range(lines.load_node.shape[0]):
        n = lines.load_node[j]
        part, _ = immersion(room.water.surface[n] - at.x[n, 2], lines.load_radius[j])
        for i in range(3):
            energy[0] += 0.5 * part * lines.load_added[j] * at.v[n, i] ** 2


def strain_energy(e: int, a: int, lines: MovingLines, at: Moving, rest: Any) -> float:
    """Give what a bar holds more by its strain than at rest, J, without losing small changes."""
    b = a + 1
    l0 = lines.length[e]
    more, both = 0.0, 0.0
    for i in range(3):
        d_0 = rest[b, i] - rest[a, i]
        by = (at.x[b, i] - rest[b, i]) - (at.x[a, i] - rest[a, i])
        more += by * (by + 2.0 * d_0)
        both += d_0 * d_0
    size_0, size = math.sqrt(both), math.sqrt(both + more)
    half = 0.5 * lines.EA[e] / l0
    if lines.pushes or (size > l0 and size_0 > l0):
        return float(half * more / (size + size_0) * (size + size_0 - 2.0 * l0))
    over, over_0 = max(size - l0, 0.0), max(size_0 - l0, 0.0)
    return float(half * (over * over - over_0 * over_0))


def kinetic_energy(e: int, a: int, lines: MovingLines, at: Moving, water: WaterAt) -> float:
    """Give a bar's kinetic energy with that of its added mass, J; `a` is its first node."""
    l0, b = lines.length[e], a + 1
    part = 0.5 * (water.wet[e, 0] + water.wet[e, 1])
    added_n, added_t = lines.added_normal[e] * part, lines.added_tangential[e] * part
    aa, ab, bb, along_a, along_b = 0.0, 0.0, 0.0, 0.0, 0.0
    for i in range(3):
        v_a, v_b = at.v[a, i], at.v[b, i]
        aa, ab, bb = aa + v_a * v_a, ab + v_a * v_b, bb + v_b * v_b
        along_a += at.axis[e, i] * v_a
        along_b += at.axis[e, i] * v_b
    near, far = 0.5 * l0 * lines.near, l0 * lines.far
    total = near * (aa + bb) + far * ab
    axial = near * (along_a * along_a + along_b * along_b) + far * along_a * along_b
    return float((lines.mass[e] + added_n) * total + (added_t - added_n) * axial)
