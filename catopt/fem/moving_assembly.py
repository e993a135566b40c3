"""The balance of all nodes of lines in motion at one time, linearised."""

from __future__ import annotations

import math
from typing import Any

from catopt.fem.moving import Blend, BodyNode, Equations, Moving, MovingLines
from catopt.fem.moving_bar import add_bars, add_loads
from catopt.fem.sampling import Room, first_joint
from catopt.fem.seabed import across_bed, push_and_rub


def assemble_moving(
    lines: MovingLines,
    body: BodyNode,
    now: Moving,
    before: Moving,
    blend: Blend,
    room: Room,
    slopes: bool = True,
) -> tuple[float, int]:
    """Write what is left over at every node, and its derivatives, to `room.equations`.

    Without `slopes` the derivatives are of no use: half the time, for a last look at the balance.

    `now`, `before`: at the step's end, whose forces are written, and at its start. Returns the
    largest force left over at a node that moves, over the largest tension or what a line weighs,
    and its node, -1 for the body.
    """
    to, force = room.equations, room.force
    _clear(lines, now, before, blend, to)
    add_loads(lines, now, before, room.water, blend, to)
    largest = add_bars(lines, now, before, room.water, blend, slopes, to)
    x, v, a, old_x, old_a = now.x, now.v, now.a, before.x, before.a
    bed, held, start, ahead = lines.bed_stiffness, lines.held, lines.start, 0.5 * blend.step
    late, early = 1.0 - blend.before_force, blend.before_force
    at = start[1]
    left0 = left1 = left2 = 0.0
    square, place = 0.0, 0
    for k in range(start.shape[0] - 1):
        first, last = start[k] + k, start[k + 1] + k
        for n in range(first, last + 1):
            falls = ahead * min(across_bed(v, n, lines), 0.0)
            low = min(across_bed(x, n, lines) + falls, across_bed(old_x, n, lines))
            if (low < 0.0 and bed[n] > 0.0) or held[n]:
                push_and_rub(n, lines, now, before, blend, to)
        held_end = first if lines.of_end[k, 0] >= 0 or not lines.lower_free[k] else -1
        worst, node = _leave_over(first, last, held_end, late, now.force, before.force, to.rest)
        if not worst <= square:
            square, place = worst, node
        left0 += to.rest[last, 0]
        left1 += to.rest[last, 1]
        left2 += to.rest[last, 2]
    if room.at_joints.shape[0] > 0:
        worst, node = _left_at_joints(lines, late, now.force, before.force, room)
        if not worst <= square:
            square, place = worst, node
    total = 0.0
    for i in range(3):
        now.body_force[i] = force[i] - body.damping[i] * v[at, i]
        left = left0 if i == 0 else left1 if i == 1 else left2
        left += late * now.body_force[i] + early * before.body_force[i]
        acc = (1.0 - blend.before_inertia) * a[at, i] + blend.before_inertia * old_a[at, i]
        total += body.free[i] * (left - body.mass[i] * acc) ** 2
    if not total <= square:
        square, place = total, -1
    return math.sqrt(square) / max(largest, lines.force_scale), place


def _clear(lines: MovingLines, now: Moving, before: Moving, blend: Blend, to: Equations) -> None:
    """Start with constant forces and point masses; find what inertia acts by."""
    v, a, old_v, old_a, force, reaction = now.v, now.a, before.v, before.a, now.force, now.reaction
    rub = now.rub
    diagonal, rest, acc = to.diagonal, to.rest, to.acceleration
    node_force, node_mass, alpha = lines.node_force, lines.node_mass, lines.mass_factor
    late, early = 1.0 - blend.before_force, blend.before_force
    late_a, early_a = 1.0 - blend.before_inertia, blend.before_inertia
    by_inertia = blend.by_a + alpha * blend.by_v
    for n in range(v.shape[0]):
        reaction[n] = rub[n, 0] = rub[n, 1] = 0.0
        for i in range(3):
            force[n, i] = node_force[n, i]
            acc[n, i] = late_a * a[n, i] + early_a * old_a[n, i]
            if alpha > 0.0:
                acc[n, i] += alpha * (late * v[n, i] + early * old_v[n, i])
            rest[n, i] = node_mass[n] * acc[n, i]
            for j in range(3):
                diagonal[n, i, j] = 0.0
            diagonal[n, i, i] = node_mass[n] * by_inertia


def _left_at_joints(
    lines: MovingLines, late: float, force: Any, old_force: Any, room: Room
) -> tuple[float, int]:
    """Turn the inertia of joints into what forces exceed it by, and sum what lines leave over.

    Writes the sum to `room.at_joints`; returns the largest square, and its node.
    """
    rest, total, base = room.equations.rest, room.at_joints, first_joint(lines)
    joints = total.shape[0] // 3
    for p in range(joints):
        n = base + p
        for i in range(3):
            left = late * force[n, i] + (1.0 - late) * old_force[n, i] - rest[n, i]
            rest[n, i] = total[3 * p + i] = left
    for k in range(lines.start.shape[0] - 1):
        for side in range(2):
            p, n = lines.of_end[k, side], lines.start[k + side] + k
            for i in range(3 if p >= 0 else 0):
                total[3 * p + i] += rest[n, i]
    largest, place = 0.0, base
    for p in range(joints):
        square = total[3 * p] ** 2 + total[3 * p + 1] ** 2 + total[3 * p + 2] ** 2
        if not square <= largest:
            largest, place = square, base + p
    return largest, place


def _leave_over(
    first: int, last: int, held: int, late: float, force: Any, old_force: Any, rest: Any
) -> tuple[float, int]:
    """Turn the inertia in `rest` into what forces exceed it by; largest square, and its node.

    Node `held` and the last one are left out of that.
    """
    largest, place = 0.0, first
    for n in range(first, last + 1):
        square = 0.0
        for i in range(3):
            left = late * force[n, i] + (1.0 - late) * old_force[n, i] - rest[n, i]
            rest[n, i] = left
            square += left * left
        if n != held and n != last and not square <= largest:
            largest, place = square, n
    return largest, place
