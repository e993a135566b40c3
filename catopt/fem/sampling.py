"""What is kept of a run: samples of forces and places, and energies."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from catopt.arrays import Array, Codes, Flags
from catopt.compiled import inlined, packed
from catopt.fem.banded import copy_blocks, copy_values
from catopt.fem.extremes import follow
from catopt.fem.morison import fill_water, wet_bars
from catopt.fem.moving import BodyNode, Equations, Moving, MovingLines, WaterAt
from catopt.fem.moving_bar import immersion, inertia_of_half
from catopt.fem.seabed import across_bed
from catopt.fem.series import SeriesRows
from catopt.waves.kinematics import Flow, WaterEnds, fill_between, keep_start, look_ahead


class Rules(NamedTuple):
    """How to step."""

    alpha_m: float  # of `newmark.Scheme`
    alpha_f: float
    beta: float
    gamma: float
    step: float  # s
    every: int  # steps from one sample to the next
    limit: int  # Newton iterations of a step before it is halved
    halvings: int  # times that a step may be halved
    refinements: int  # times that it is halved at most because a tension surprises
    surprise: float  # difference of a tension from what it was heading for beyond which that is
    # done, over the largest tension of the run so far or what a line weighs
    transits: float  # longest step in which a bar goes taut, over a wave's way through it
    tolerance: float  # largest force left over at a node, over the same
    since: float  # time from which courses, envelopes and slack times are taken, s
    until: float  # and up to which


@packed
class Setting(NamedTuple):
    """What steps in time are taken of: none of it changes meanwhile."""

    rules: Rules
    lines: MovingLines
    body: BodyNode
    prescribed_motion: SeriesRows  # where the ends are led
    load: SeriesRows  # force on the body, of one end
    flow: Flow
    has_sea: bool
    blocks: Array  # (blocks, 3): on the bed, as `march.slide` takes them
    strength: Array  # (bars,): tension at which a bar parts, N; of no bar where none may


@packed
class Record(NamedTuple):
    """What is kept of a run; the first axis of the first eight counts samples."""

    time: Array  # (samples,), s
    end_force: Array  # (samples, lines, 2, 3): on what holds anchor (0) and fairlead (1), N
    bar_tension: Array  # (samples, lines, 2): of the first and the last bar, N
    fairlead: Array  # (samples, lines, 3): place of the last node, m
    grounded_length: Array  # (samples, lines): unstretched, of nodes on the bed, m
    nodes: Array  # (samples, chosen nodes, 3): places, m
    energy: Array  # (samples or 0, 4): kinetic, of strain, of weight, of the bed, J
    tension: Array  # (samples or 0, bars), N
    chosen: Codes  # (chosen nodes,)
    max_tension: Array  # (bars,), of every step, N
    min_tension: Array
    slack_time: Array  # (bars,): without tension in all, s
    longest_slack: Array  # at a stretch
    slack_now: Array  # at the stretch that goes on
    course: Array  # (quantities, STATE): of each line those of `FOLLOWED`, then the bars' tensions,
    # as `course.follow` keeps them of every step
    turns: Array  # (quantities, room, 2): time, s, and value of their turning points
    turn_count: Codes  # (quantities,): how many there are
    works: Array  # (8,): as `energy_balance.add_works` adds them, of every step, J
    stored: Array  # (5,): as `fill_energy` at the end; and the lines' own kinetic energy there, J
    at_rest: Array  # (nodes, 3): places from which energies of strain, weight and bed count, m
    slides: Array  # (lines, blocks, SLIDING): of each block, were it what holds the line's anchor


@packed
class Room(NamedTuple):
    """Work space of a step."""

    now: Moving  # at its end
    water: WaterAt
    water_before: Array  # (nodes, 3): acceleration of the water at its start, m/s2
    water_ends: WaterEnds  # of the nodes, over the whole step
    equations: Equations
    small: Array  # (2, 3, 3)
    force: Array  # (3,): on the body at its end, N
    slope: Array  # (bars,): rate of the tensions in the last step, N/s
    loose: Flags  # (bars,): slack, and since then not taut again
    highest: Array  # (1,): largest tension of all, N
    short: Array  # (2,): time up to which steps stay short after a bar went taut, and how short, s
    change: Array  # (nodes, 3): of the accelerations, m/s2
    booked: Array  # (4, nodes, 3): forces whose work is booked, N
    booked_before: Array  # at its start
    ends: Array  # (lines, 2, 3): forces at the ends, N
    ends_before: Array
    wet_before: Array  # (bars, 2): `WaterAt.wet` at its start
    side: Array  # (nodes, 3, 3): derivatives of each balance by the place of its line's first node
    # where that moves with a joint; of no node where there are no joints
    joints: Array  # (3 joints, 3 joints): their equations, and what is left over at them, N
    at_joints: Array  # (3 joints,)


def take_sample(sample: int, setting: Setting, at: Moving, room: Room, record: Record) -> None:
    """Write a sample; forces at the ends are in `room.ends`."""
    rules, lines = setting.rules, setting.lines
    t = sample * rules.every * rules.step
    record.time[sample] = t
    for k in range(lines.start.shape[0] - 1):
        last = lines.start[k + 1] + k
        for i in range(3):
            record.fairlead[sample, k, i] = at.x[last, i]
        record.bar_tension[sample, k, 0] = at.tension[lines.start[k]]
        record.bar_tension[sample, k, 1] = at.tension[lines.start[k + 1] - 1]
        record.grounded_length[sample, k] = length_on_bed(k, lines, at)
    copy_blocks(room.ends, record.end_force[sample])
    for c in range(record.chosen.shape[0]):
        for i in range(3):
            record.nodes[sample, c, i] = at.x[record.chosen[c], i]
    if record.tension.shape[0] > 0:
        copy_values(at.tension, record.tension[sample])
    if record.energy.shape[0] > 0:
        fill_energy(lines, at, room, record.at_rest, record.energy[sample])


@inlined
def _size(a: float, b: float) -> float:
    """Size of a vector; by products, whose digits are the same in both forms."""
    return math.sqrt(a * a + b * b)


def follow_all(t: float, setting: Setting, at: Moving, room: Room, record: Record) -> None:
    """Follow what `FOLLOWED` names of each line, and the bars' tensions where there is room."""
    lines, ends, rest = setting.lines, room.ends, record.at_rest
    state, turns, count = record.course, record.turns, record.turn_count
    n = 0
    for k in range(lines.start.shape[0] - 1):
        first, last = lines.start[k] + k, lines.start[k + 1] + k
        x, y = at.x[last, 0], at.x[last, 1]
        along = _size(ends[k, 0, 0], ends[k, 0, 1])
        across = _size(ends[k, 1, 0], ends[k, 1, 1])
        up = max(ends[k, 0, 2], 0.0)
        # A lower end that carries no more than its half bar weighs is not lifted at any angle.
        bar = lines.start[k]
        lifted = up > 0.0 and along + up > 0.5 * abs(lines.weight[bar]) * lines.length[bar]
        values = (
            _size(across, ends[k, 1, 2]),
            _size(along, ends[k, 0, 2]),
            length_on_bed(k, lines, at),
            _size(x - rest[last, 0], y - rest[last, 1]),
            x,
            y,
            _size(x - at.x[first, 0], y - at.x[first, 1]),
            along,
            up,
            math.atan2(up, along) if lifted else 0.0,
            -ends[k, 1, 2],
        )
        for value in values:
            follow(n, t, value, state, turns, count)
            n += 1
    if n < state.shape[0]:
        for e in range(at.tension.shape[0]):
            follow(n + e, t, at.tension[e], state, turns, count)


def fill_end_forces(lines: MovingLines, at: Moving, a: Any, room: Room, to: Any) -> None:
    """Write the forces on what holds anchors and fairleads, N, to `to`; `a`: accelerations."""
    for k in range(lines.start.shape[0] - 1):
        first, last = lines.start[k] + k, lines.start[k + 1] + k
        if lines.lower_free[k] and lines.of_end[k, 0] < 0:
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

    `rest` (nodes, 3): places at rest, m. Added mass counts in the kinetic energy.
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
    for n in range(at.x.shape[0]):
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


@inlined
def first_joint(lines: MovingLines) -> int:
    """Return the node of the first joint, behind those of all lines."""
    return int(lines.start[lines.start.shape[0] - 1] + lines.start.shape[0] - 1)


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


def begin_whole_step(setting: Setting, room: Room) -> None:
    """Keep the water at hand as that at the next whole step's start."""
    if setting.has_sea:
        water = room.water
        keep_start(water.velocity, water.latest, water.surface, room.water_ends)


def take_water(
    start: float, done: float, part: float, setting: Setting, before: Moving, room: Room
) -> None:
    """Write the water at the end of a part of the whole step from `start`, s, some of it done.

    It is taken where the nodes are expected. Whole steps are short beside the waves; parts of them,
    in which a line snaps, need no closer look at the sea than these: `fill_between`.
    """
    if not setting.has_sea:
        return
    now, water, rules, first = room.now, room.water, setting.rules, setting.lines.start
    early, water_0 = rules.alpha_f, room.water_before
    if part == 1.0:
        fill_water(start + rules.step, now.x, first, setting.flow, early, water_0, water)
        return
    ends = room.water_ends
    if ends.is_known[0] == 0.0:
        ahead, x, v = (1.0 - done) * rules.step, before.x, before.v
        for n in range(x.shape[0]):
            for i in range(3):
                ends.points[n, i] = x[n, i] + ahead * v[n, i]
        look_ahead(start + rules.step, setting.flow, ends)
    fill_between(done + part, ends, water.velocity, water.latest, water.surface)
    wet_bars(now.x, first, early, water_0, water)
