"""One step in time of a hull, and of a hull with its lines: the hull is one more block of unknowns.

A line's last node is fixed to the hull at its mooring eye, by a rigid arm. Each line hands its
equations for that node over, as to a body without rotation; turned by the arm into force and
moment, they and the hull's own are solved for its six unknowns, which are put back into every
line. So hull and lines are one Newton iteration. Rows of the scheme as in `newmark`.
"""

from __future__ import annotations

import math
from typing import Any, Final, NamedTuple

from catopt.compiled import inlined, packed
from catopt.fem.banded import (
    back_substitute_blocks,
    copy_rows,
    copy_values,
    eliminate_blocks,
    hold,
    solve_dense,
)
from catopt.fem.moving import Blend, BodyNode, Moving, MovingLines
from catopt.fem.newmark import assemble_moving, predict
from catopt.fem.sampling import Room, Setting, take_water
from catopt.hydro.hull import (
    PARTS,
    Hull,
    HullRecord,
    HullRoom,
    HullState,
    attitude,
    carry_memory,
    cross,
    fill_forces_on_hull,
    fill_sea,
    fill_sea_between,
    hull_inertia,
    rotate_axes,
)
from catopt.waves.kinematics import Flow

_LEAST: Final = 1.0 / 32.0
"""As `newmark._LEAST`."""


@packed
class Afloat(NamedTuple):
    """A hull that is stepped in time, with its lines or alone."""

    hull: Hull
    now: HullState
    before: HullState
    room: HullRoom
    record: HullRecord
    held: BodyNode  # the lines' last nodes in their own equations: they go where the hull goes


def attempt_afloat(
    start: float,
    done: float,
    part: float,
    setting: Setting,
    before: Moving,
    room: Room,
    body: Afloat,
    expected: int,
) -> tuple[bool, int, float, int]:
    """Take one step of hull and lines into their `now`, as `march.attempt`."""
    now, lines, step = room.now, setting.lines, setting.rules.step
    h = part * step
    predict(start + done * step, h, setting, before, room)
    _predict_hull(h, body)
    _place_ends(lines, now, body)
    copy_rows(before.foot, now.foot)
    take_water(start, done, part, setting, before, room)
    if part == 1.0:
        fill_sea(start + step, body.hull, body.now, setting.flow, body.room)
    else:
        at, ahead = body.before, (1.0 - done) * step
        fill_sea_between(start + step, done + part, ahead, at, body.hull, setting.flow, body.room)
    carry_memory(h, body.hull, body.before, body.room)
    return _close(h, setting, before, room, body, expected)


def step_hull(t: float, h: float, rules: Any, flow: Flow, body: Afloat) -> tuple[bool, int]:
    """Take one step of a hull without lines; `rules` has the scheme, limit and tolerance."""
    _predict_hull(h, body)
    fill_sea(t + h, body.hull, body.now, flow, body.room)
    carry_memory(h, body.hull, body.before, body.room)
    blend = _blend(h, rules)
    for iteration in range(rules.limit + 1):
        _start_hull(flow.depth, blend, body)
        worst = _left_over(body)
        if worst <= rules.tolerance and iteration > 0:
            return True, iteration
        if iteration == rules.limit or not _solve_hull(body):
            break
        _move_hull(1.0, h, rules, body)
    return False, rules.limit


def run_hull(samples: int, every: int, rules: Any, flow: Flow, body: Afloat) -> tuple[int, int]:
    """Step a hull without lines; return the samples taken after the first, and iterations."""
    used = 0
    for step in range(samples * every):
        t = step * rules.step
        closed, more = step_hull(t, rules.step, rules, flow, body)
        used += more
        if not closed:
            return step // every, used
        accept_hull(t + rules.step, rules.since, body)
        if (step + 1) % every == 0:
            sample_hull((step + 1) // every, body)
    return samples, used


def start_hull(t: float, flow: Flow, body: Afloat) -> None:
    """Find the forces with which a hull without lines sets off, and its acceleration."""
    room, before, now = body.room, body.before, body.now
    fill_sea(t, body.hull, before, flow, room)
    for m in range(room.carried.shape[0]):
        for i in range(2):
            room.carried[m, i], room.by_speed[m, i] = before.memory[m, i], 0.0
    _start_hull(flow.depth, Blend(0.0, 0.0, 0.0, 0.0, 1.0), body)
    _solve_hull(body)
    for i in range(6):
        before.a[i] += room.rest[i]
        before.force[i], now.a[i] = now.force[i], before.a[i]
    copy_rows(now.parts, before.parts)
    copy_values(now.wet, before.wet)
    sample_hull(0, body)


@inlined
def _blend(h: float, rules: Any) -> Blend:
    late, by_a = 1.0 - rules.alpha_f, (1.0 - rules.alpha_m) / (rules.beta * h * h)
    return Blend(rules.alpha_f, rules.alpha_m, late, late * rules.gamma / (rules.beta * h), by_a, h)


def _predict_hull(h: float, body: Afloat) -> None:
    """Go on as if accelerations stayed."""
    now, before = body.now, body.before
    for i in range(6):
        now.a[i] = before.a[i]
        now.v[i] = before.v[i] + h * before.a[i]
    for i in range(3):
        now.q[i] = before.q[i] + h * (before.v[i] + 0.5 * h * before.a[i])
        now.turn[i] = h * (before.v[3 + i] + 0.5 * h * before.a[3 + i])
    rotate_axes(now.turn, before.axes, now.axes)


def _place_ends(lines: MovingLines, now: Moving, body: Afloat) -> None:
    """Put the last node of every line to its mooring eye, with its velocity and acceleration."""
    at = body.now
    turning, spun = (at.v[3], at.v[4], at.v[5]), (at.a[3], at.a[4], at.a[5])
    for k in range(lines.start.shape[0] - 1):
        n = lines.start[k + 1] + k
        arm = _arm(body.hull, at, k)
        swung = cross(turning, arm)
        towards, faster = cross(turning, swung), cross(spun, arm)
        for i in range(3):
            now.x[n, i] = at.q[i] + arm[i]
            now.v[n, i] = at.v[i] + swung[i]
            now.a[n, i] = at.a[i] + faster[i] + towards[i]


@inlined
def _arm(hull: Hull, at: HullState, k: int) -> tuple[float, float, float]:
    """From the centre of gravity to a mooring eye, m."""
    x, y, z, axes = hull.eye[k, 0], hull.eye[k, 1], hull.eye[k, 2], at.axes
    return (
        axes[0, 0] * x + axes[0, 1] * y + axes[0, 2] * z,
        axes[1, 0] * x + axes[1, 1] * y + axes[1, 2] * z,
        axes[2, 0] * x + axes[2, 1] * y + axes[2, 2] * z,
    )


@inlined
def _blended_arm(body: Afloat, early: float, k: int) -> tuple[float, float, float]:
    """Arm by which the lines' forces, that balance within the step, turn the hull."""
    x, y, z = _arm(body.hull, body.now, k)
    x_0, y_0, z_0 = _arm(body.hull, body.before, k)
    late = 1.0 - early
    return late * x + early * x_0, late * y + early * y_0, late * z + early * z_0


def _close(
    h: float, setting: Setting, before: Moving, room: Room, body: Afloat, expected: int
) -> tuple[bool, int, float, int]:
    """Iterate on hull and lines until all forces balance; as `newmark.close_step`."""
    rules, lines, now = setting.rules, setting.lines, room.now
    blend = _blend(h, rules)
    by_v = rules.gamma / (rules.beta * h)
    by_a = 1.0 / (rules.beta * h * h)
    x, v, a, rest, start = now.x, now.v, now.a, room.equations.rest, lines.start
    worst, node, part = math.inf, 0, 1.0
    for iteration in range(rules.limit + 1):
        last = worst
        may_be_last = 0 < expected <= iteration
        worst, node = assemble_moving(lines, body.held, now, before, blend, room, not may_be_last)
        _start_hull(setting.flow.depth, blend, body)
        _take_lines(lines, rest, blend, body)
        own = _left_over(body)
        if not own <= worst:
            worst, node = own, -1
        if worst <= rules.tolerance and iteration > 0:
            return True, iteration, worst, node
        if may_be_last:
            assemble_moving(lines, body.held, now, before, blend, room)
        if iteration == rules.limit or not worst < 1e3 * max(last, 1.0):
            break
        if not _solve_all(lines, blend, room, body):
            break
        part = min(2.0 * part, 1.0) if worst < last else max(0.5 * part, _LEAST)
        _move_hull(part, h, rules, body)
        for k in range(start.shape[0] - 1):
            for n in range(start[k] + k + (not lines.lower_free[k]), start[k + 1] + k):
                for i in range(3):
                    move = part * rest[n, i]
                    x[n, i] += move
                    v[n, i] += by_v * move
                    a[n, i] += by_a * move
        _place_ends(lines, now, body)
    return False, rules.limit, worst, node


def _start_hull(depth: float, blend: Blend, body: Afloat) -> None:
    """Write what of its own forces a hull leaves over, and its derivatives."""
    hull, now, before, room = body.hull, body.now, body.before, body.room
    fill_forces_on_hull(hull, now, depth, room)
    early_f, early_m = blend.before_force, blend.before_inertia
    for i in range(6):
        left = (1.0 - early_f) * now.force[i] + early_f * before.force[i]
        for j in range(6):
            mass = hull_inertia(hull, now.axes, i, j)
            left -= mass * ((1.0 - early_m) * now.a[j] + early_m * before.a[j])
            room.matrix[i, j] = mass * blend.by_a + room.by_v[i, j] * blend.by_v
            room.matrix[i, j] += hull.stiffness[i, j] * blend.by_x
        room.rest[i] = left
        now.line[i] = 0.0


def _take_lines(lines: MovingLines, rest: Any, blend: Blend, body: Afloat) -> None:
    """Add force and moment of the lines, with their inertia, to what is left over."""
    now, to = body.now, body.room.rest
    for k in range(lines.start.shape[0] - 1):
        pull = rest[lines.start[k + 1] + k]
        moment = cross(_blended_arm(body, blend.before_force, k), pull)
        for i in range(3):
            now.line[i] += pull[i]
            now.line[3 + i] += moment[i]
            to[i] += pull[i]
            to[3 + i] += moment[i]


def _left_over(body: Afloat) -> float:
    """Largest force left over, over the hull's weight; a moment by the hull's own length."""
    hull, rest = body.hull, body.room.rest
    long = math.sqrt(max(hull.inertia, 1e-12) / hull.mass)
    worst = 0.0
    for i in range(6):
        size = abs(rest[i]) * hull.free[i]
        worst = max(worst, size / long if i > 2 else size)
    return worst / (hull.mass * hull.gravity)


def _solve_all(lines: MovingLines, blend: Blend, room: Room, body: Afloat) -> bool:
    """Turn the equations of hull and lines into displacements, in their `rest`."""
    to, hull, now, mine = room.equations, body.hull, body.now, body.room
    regular = True
    for i in range(6):
        mine.rest[i] -= now.line[i]
    for k in range(lines.start.shape[0] - 1):
        first, last = lines.start[k] + k + (not lines.lower_free[k]), lines.start[k + 1] + k
        regular = eliminate_blocks(to, first, last) and regular
        arm, blended = _arm(hull, now, k), _blended_arm(body, blend.before_force, k)
        pull, stiff = to.rest[last], to.diagonal[last]
        moment = cross(blended, pull)
        for i in range(3):
            mine.rest[i] += pull[i]
            mine.rest[3 + i] += moment[i]
        for j in range(6):
            way = _way_of_eye(arm, j)
            force = (
                stiff[0, 0] * way[0] + stiff[0, 1] * way[1] + stiff[0, 2] * way[2],
                stiff[1, 0] * way[0] + stiff[1, 1] * way[1] + stiff[1, 2] * way[2],
                stiff[2, 0] * way[0] + stiff[2, 1] * way[1] + stiff[2, 2] * way[2],
            )
            moment = cross(blended, force)
            for i in range(3):
                mine.matrix[i, j] += force[i]
                mine.matrix[3 + i, j] += moment[i]
    regular = _solve_hull(body) and regular
    move = mine.rest
    for k in range(lines.start.shape[0] - 1):
        first, last = lines.start[k] + k + (not lines.lower_free[k]), lines.start[k + 1] + k
        swung = cross((move[3], move[4], move[5]), _arm(hull, now, k))
        for i in range(3):
            to.rest[last, i] = move[i] + swung[i]
        back_substitute_blocks(to, first, last)
    return regular


@inlined
def _way_of_eye(arm: Any, freedom: int) -> tuple[float, float, float]:
    """Say how far a mooring eye goes when the hull moves by 1 m, or turns by 1 rad."""
    x, y, z = arm[0], arm[1], arm[2]
    if freedom == 3:
        return 0.0, -z, y
    if freedom == 4:
        return z, 0.0, -x
    if freedom == 5:
        return -y, x, 0.0
    return 1.0 if freedom == 0 else 0.0, 1.0 if freedom == 1 else 0.0, 1.0 if freedom == 2 else 0.0


def _solve_hull(body: Afloat) -> bool:
    """Turn what is left over into the move of the hull; False where it has none."""
    matrix, rest = body.room.matrix, body.room.rest
    hold(body.hull.free, matrix, rest)
    return solve_dense(matrix, rest)


def _move_hull(part: float, h: float, rules: Any, body: Afloat) -> None:
    now, by_v, by_a = body.now, rules.gamma / (rules.beta * h), 1.0 / (rules.beta * h * h)
    for i in range(6):
        move = part * body.room.rest[i]
        if i < 3:
            now.q[i] += move
        else:
            now.turn[i - 3] += move
        now.v[i] += by_v * move
        now.a[i] += by_a * move
    rotate_axes(now.turn, body.before.axes, now.axes)


def accept_hull(t: float, since: float, body: Afloat) -> None:
    """Make the end of a step its start; book works and keep what was largest."""
    now, before, record = body.now, body.before, body.record
    works, put_in = record.works, 0.0
    for i in range(PARTS):
        work = 0.0
        for j in range(3):
            work += 0.5 * (now.parts[i, j] + before.parts[i, j]) * (now.q[j] - before.q[j])
            work += 0.5 * (now.parts[i, 3 + j] + before.parts[i, 3 + j]) * now.turn[j]
        works[i] += work
        put_in += max(work, 0.0)
    by_lines = 0.0
    for j in range(3):
        by_lines += now.line[j] * (now.q[j] - before.q[j]) + now.line[3 + j] * now.turn[j]
    works[PARTS] += by_lines
    works[PARTS + 1] += put_in + max(by_lines, 0.0)
    if t >= since - 1e-9:
        angles = attitude(now.axes)
        for i in range(3):
            _stretch(record.extreme[i], now.q[i])
            _stretch(record.extreme[3 + i], angles[i])
        _stretch(record.extreme[6], now.wet[0])
    copy_values(now.q, before.q)
    copy_rows(now.axes, before.axes)
    copy_values(now.v, before.v)
    copy_values(now.a, before.a)
    copy_values(now.force, before.force)
    copy_rows(now.parts, before.parts)
    copy_rows(now.memory, before.memory)
    copy_values(now.wet, before.wet)
    copy_values(now.line, before.line)


@inlined
def _stretch(ends: Any, value: float) -> None:
    """Let a least and a largest value reach as far as another."""
    ends[0], ends[1] = min(ends[0], value), max(ends[1], value)


def sample_hull(sample: int, body: Afloat) -> None:
    """Write a sample."""
    at, record = body.before, body.record
    angles = attitude(at.axes)
    for i in range(3):
        record.q[sample, i], record.q[sample, 3 + i] = at.q[i], angles[i]
    for i in range(6):
        record.v[sample, i] = at.v[i]
        record.line[sample, i] = at.line[i]
    record.wet[sample] = at.wet[0]
    record.surface[sample] = body.room.sea[0]


def hull_kinetic_energy(hull: Hull, at: HullState) -> float:
    """Energy of motion, with that of the added mass, J."""
    total = 0.0
    for i in range(6):
        for j in range(6):
            total += 0.5 * at.v[i] * hull_inertia(hull, at.axes, i, j) * at.v[j]
    return float(total)
