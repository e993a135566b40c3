"""Steps in time by Newmark's method, the balance that each closes, and the line's own damping."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Final, Literal

import numpy as np

from catopt.arrays import Array
from catopt.compiled import inlined
from catopt.fem.banded import (
    back_substitute_blocks,
    copy_rows,
    eliminate_blocks,
    hold,
    invert_3,
    reach_of_first_block,
    solve_dense,
    take_block_aside,
)
from catopt.fem.moving import Blend, BodyNode, Equations, Moving, MovingLines
from catopt.fem.moving_bar import add_bars, add_loads
from catopt.fem.sampling import Room, Setting, first_joint
from catopt.fem.seabed import across_bed, push_and_rub
from catopt.fem.series import fill_series
from catopt.model.dynamics import BARS
from catopt.model.kinds import Findings
from catopt.words import Message


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


_LEAST: Final = 1.0 / 32.0
"""Least part of a Newton step that is taken where the forces left over do not get smaller."""


@dataclass(frozen=True)
class Scheme:
    """How time is stepped."""

    alpha_m: float = 0.0  # of Chung and Hulbert's method, as all of them
    alpha_f: float = 0.0
    beta: float = 0.25
    gamma: float = 0.5

    @classmethod
    def average_acceleration(cls) -> Scheme:
        """Newmark's method that neither damps nor feeds a linear vibration: S4's, delta = 0.5.

        S4 has gamma = delta, beta = (delta + 0.5)^2/4; a larger delta damps high frequencies, and
        the order falls to one.
        """
        return cls()

    @classmethod
    def generalised_alpha(cls, spectral_radius: float = 0.5) -> Scheme:
        """Chung and Hulbert's method: second order, with the damping of high frequencies given.

        `spectral_radius`: what is left of a vibration much faster than the step after one step,
        from 0 to 1.
        """
        found = Findings("Scheme.generalised_alpha")
        found.number("spectral_radius", spectral_radius, "", at_least=0.0, at_most=1.0)
        found.raise_if_any()
        r = spectral_radius
        m, f = (2.0 * r - 1.0) / (r + 1.0), r / (r + 1.0)
        return cls(m, f, 0.25 * (1.0 - m + f) ** 2, 0.5 - m + f)


def predict(t: float, h: float, setting: Setting, before: Moving, room: Room) -> None:
    """Set the state at the end of a step of h from t, s, as if accelerations went on.

    They change as `room.change` expects; led ends go to where they are led.
    """
    rules, lines, prescribed_motion, free = (
        setting.rules,
        setting.lines,
        setting.prescribed_motion,
        setting.body.free,
    )
    shift = (rules.alpha_m - rules.alpha_f) * h
    beta, gamma = rules.beta, rules.gamma
    x, v, a, small, change = room.now.x, room.now.v, room.now.a, room.small, room.change
    x_0, v_0, a_0 = before.x, before.v, before.a
    for n in range(x.shape[0]):
        for i in range(3):
            same, more = a_0[n, i], change[n, i]
            a[n, i] = same + more
            v[n, i] = v_0[n, i] + h * (same + gamma * more)
            x[n, i] = x_0[n, i] + h * (v_0[n, i] + h * (0.5 * same + beta * more))
    for k in range(lines.start.shape[0] - 1):
        first, last = lines.start[k] + k, lines.start[k + 1] + k
        if not lines.lower_free[k]:
            _lead_first(k, first, t + h, shift, setting, before, room)
        if free[0] * free[1] * free[2] == 0.0 and lines.of_end[k, 1] < 0:
            fill_series(t + h, prescribed_motion, k, small[0])
            if shift != 0.0:
                fill_series(t + h + shift, prescribed_motion, k, small[1])
            else:
                copy_rows(small[0], small[1])
            for i in range(3):
                if free[i] == 0.0:
                    x[last, i] = small[0, 0, i]
                    v[last, i] = small[0, 1, i]
                    a[last, i] = small[1, 2, i]


def _lead_first(
    k: int, first: int, t: float, shift: float, setting: Setting, before: Moving, room: Room
) -> None:
    """Put the first node of line k where it is led, or leave it where it is held."""
    prescribed_motion, now, small = setting.prescribed_motion, room.now, room.small
    row = setting.lines.start.shape[0] - 1 + k
    if row < prescribed_motion.base.shape[0]:
        fill_series(t, prescribed_motion, row, small[0])
        fill_series(t + shift, prescribed_motion, row, small[1])
        for i in range(3):
            now.x[first, i], now.v[first, i] = small[0, 0, i], small[0, 1, i]
            now.a[first, i] = small[1, 2, i]
    else:
        for i in range(3):
            now.x[first, i] = before.x[first, i]
            now.v[first, i] = now.a[first, i] = 0.0


def solve_moving(
    lines: MovingLines, body: BodyNode, now: Moving, before: Moving, blend: Blend, room: Room
) -> bool:
    """Turn the equations into displacements, in their `rest`; False when they have no solution."""
    if room.at_joints.shape[0] > 0:
        return _solve_with_joints(lines, room)
    to, matrix, pull = room.equations, room.small[0], room.small[1, 0]
    moves = body.free[0] + body.free[1] + body.free[2] > 0.0
    _start_body(lines.start[1], body, now, before, blend, matrix, pull)
    regular = True
    for k in range(lines.start.shape[0] - 1):
        first, last = lines.start[k] + k + (not lines.lower_free[k]), lines.start[k + 1] + k
        regular = eliminate_blocks(to, first, last) and regular
        for i in range(3):
            pull[i] += to.rest[last, i]
            for j in range(3):
                matrix[i, j] += to.diagonal[last, i, j]
    if moves:
        hold(body.free, matrix, pull)
        regular = invert_3(room.small, 0) and regular
    for k in range(lines.start.shape[0] - 1):
        first, last = lines.start[k] + k + (not lines.lower_free[k]), lines.start[k + 1] + k
        for i in range(3):
            move = 0.0
            if moves and body.free[i] == 1.0:
                move = matrix[i, 0] * pull[0] + matrix[i, 1] * pull[1] + matrix[i, 2] * pull[2]
            to.rest[last, i] = move
        back_substitute_blocks(to, first, last)
    return regular


def _solve_with_joints(lines: MovingLines, room: Room) -> bool:
    """Solve the equations of lines that meet in joints, those of joints first."""
    to, total = room.equations, room.at_joints
    base = first_joint(lines)
    for p in range(total.shape[0] // 3):
        for i in range(3):
            for c in range(total.shape[0]):
                room.joints[3 * p + i, c] = 0.0
            total[3 * p + i] = to.rest[base + p, i]
            for j in range(3):
                room.joints[3 * p + i, 3 * p + j] = to.diagonal[base + p, i, j]
    regular = True
    for k in range(lines.start.shape[0] - 1):
        regular = _hand_over(k, lines, room) and regular
    regular = solve_dense(room.joints, total) and regular
    for k in range(lines.start.shape[0] - 1):
        _move_line(k, lines, room)
    for p in range(total.shape[0] // 3):
        for i in range(3):
            to.rest[base + p, i] = total[3 * p + i]
    return regular


@inlined
def _begin(k: int, lines: MovingLines) -> int:
    """Return the first node of a line that its own equations move: not one held, nor a joint's."""
    first = lines.start[k] + k
    return int(first + (lines.of_end[k, 0] >= 0 or not lines.lower_free[k]))


def _hand_over(k: int, lines: MovingLines, room: Room) -> bool:
    """Eliminate a line and add it to the equations of its joints; say if all was regular."""
    to, side, matrix, total = room.equations, room.side, room.joints, room.at_joints
    first, last = lines.start[k] + k, lines.start[k + 1] + k
    a, b = lines.of_end[k, 0], lines.of_end[k, 1]
    regular = eliminate_blocks(to, _begin(k, lines), last)
    none = np.zeros(3)
    if a >= 0:
        take_block_aside(to, side, first, last)
        own = reach_of_first_block(to, side, first, last)
        _add_to_joint(matrix, total, (a, a), own[:, :3], own[:, 6])
        if b >= 0:
            _add_to_joint(matrix, total, (a, b), own[:, 3:6], none)
            _add_to_joint(matrix, total, (b, a), side[last], none)
    if b >= 0:
        _add_to_joint(matrix, total, (b, b), to.diagonal[last], to.rest[last])
    return regular


def _move_line(k: int, lines: MovingLines, room: Room) -> None:
    """Put the displacements of its joints back into the equations of a line."""
    rest, total = room.equations.rest, room.at_joints
    first, last = lines.start[k] + k, lines.start[k + 1] + k
    a, b = lines.of_end[k, 0], lines.of_end[k, 1]
    for i in range(3):
        rest[last, i] = total[3 * b + i] if b >= 0 else 0.0
        if a >= 0:
            rest[first, i] = total[3 * a + i]
    for n in range(first + 1, last if a >= 0 else first):
        for i in range(3):
            for j in range(3):
                rest[n, i] -= room.side[n, i, j] * total[3 * a + j]
    back_substitute_blocks(room.equations, _begin(k, lines), last)


def _add_to_joint(matrix: Any, total: Any, at: tuple[int, int], block: Any, rest: Any) -> None:
    """Add to the equations of one joint what a line has there of the place of another."""
    p, q = at
    for i in range(3):
        total[3 * p + i] += rest[i]
        for j in range(3):
            matrix[3 * p + i, 3 * q + j] += block[i, j]


def _start_body(
    at: int, body: BodyNode, now: Moving, before: Moving, blend: Blend, matrix: Any, pull: Any
) -> None:
    """Write the body's own equations, before what the lines hand over; node `at` moves with it."""
    early_f, early_m = blend.before_force, blend.before_inertia
    for i in range(3):
        acc = (1.0 - early_m) * now.a[at, i] + early_m * before.a[at, i]
        pull[i] = (1.0 - early_f) * now.body_force[i] + early_f * before.body_force[i]
        pull[i] -= body.mass[i] * acc
        for j in range(3):
            matrix[i, j] = 0.0
        matrix[i, i] = blend.by_a * body.mass[i] + blend.by_v * body.damping[i]


def close_step(
    h: float, setting: Setting, before: Moving, room: Room, expected: int
) -> tuple[bool, int, float, int]:
    """Iterate on what `predict` left until the forces balance at every node.

    After as many solutions as are `expected` the first look is without derivatives.

    Returns whether they do, how many equations were solved, and the largest force left over, over
    the largest tension or what a line weighs, with its node (-1: the body).
    """
    rules, lines, body, now = setting.rules, setting.lines, setting.body, room.now
    alpha_m, alpha_f, beta, gamma = rules.alpha_m, rules.alpha_f, rules.beta, rules.gamma
    by_v, by_a = gamma / (beta * h), 1.0 / (beta * h * h)
    late = 1.0 - alpha_f
    blend = Blend(alpha_f, alpha_m, late, late * by_v, (1.0 - alpha_m) * by_a, h)
    x, rest, start = now.x, room.equations.rest, lines.start
    worst, node, part = math.inf, 0, 1.0
    for iteration in range(rules.limit + 1):
        last = worst
        may_be_last = 0 < expected <= iteration
        worst, node = assemble_moving(lines, body, now, before, blend, room, not may_be_last)
        # One solution at least: a guess that is good enough once feeds on itself over many steps.
        if worst <= rules.tolerance and iteration > 0:
            return True, iteration, worst, node
        if may_be_last:
            assemble_moving(lines, body, now, before, blend, room)
        if iteration == rules.limit or not worst < 1e3 * max(last, 1.0):
            break
        if not solve_moving(lines, body, now, before, blend, room):
            break
        # Bars that go taut and slack by turns, or nodes on and off the bed, settle in between.
        part = min(2.0 * part, 1.0) if worst < last else max(0.5 * part, _LEAST)
        for k in range(start.shape[0] - 1):
            for n in range(start[k] + k + (not lines.lower_free[k]), start[k + 1] + k + 1):
                _move_node(n, part, by_v, by_a, now, rest)
        for n in range(first_joint(lines), x.shape[0]):
            _move_node(n, part, by_v, by_a, now, rest)
    return False, rules.limit, worst, node


@inlined
def _move_node(n: int, part: float, by_v: float, by_a: float, now: Moving, rest: Any) -> None:
    """Move a node by a part of a Newton step; its velocity and acceleration follow."""
    for i in range(3):
        move = part * rest[n, i]
        now.x[n, i] += move
        now.v[n, i] += by_v * move
        now.a[n, i] += by_a * move


@dataclass(frozen=True)
class LineDamping:
    """What damps a line beside the water.

    The first three add up to an axial force per rate of strain. Rayleigh's C = alpha M + beta K,
    S4 [3.17], takes for K the tangent of the bars' forces, those across the bar included; alpha
    damps motion as a whole, too.
    """

    internal: float = 0.0  # axial force per rate of strain, N s, of every bar
    critical_ratio: float = 0.0  # as a part of what is critical for a bar on its own, l0 sqrt(EA m)
    critical_length: float | Literal["bar"] | None = None  # of that bar, m; None: a hundredth of
    # its line, whatever the mesh; "bar": of each bar itself, so that the damping falls as bars get
    # shorter (MoorDyn's negative BA), and a run with twice the bars is one of another line
    stiffness_time: float = 0.0  # as a multiple of EA, s: c = stiffness_time EA
    mass_factor: float = 0.0  # alpha, 1/s
    stiffness_factor: float = 0.0  # beta, s

    def __post_init__(self) -> None:
        found = Findings("LineDamping")
        for key, unit in (
            ("internal", "N s"),
            ("critical_ratio", ""),
            ("stiffness_time", "s"),
            ("mass_factor", "1/s"),
            ("stiffness_factor", "s"),
        ):
            found.number(key, getattr(self, key), unit, at_least=0.0)
        if self.critical_length not in (None, "bar"):
            found.number("critical_length", self.critical_length, "m", above=0.0)
        found.raise_if_any()

    def per_bar(self, length: Array, EA: Array, mass: Array, line_length: Array) -> Array:
        """Axial force per rate of strain of each bar, N s, Rayleigh's share included.

        Every bar has its unstretched length, m, axial stiffness, N, mass, kg/m, and the length of
        the line that it is of, m.
        """
        of: Array | float = length
        if self.critical_length != "bar":
            given = self.critical_length
            of = line_length / BARS if given is None else given
        critical = self.critical_ratio * of * np.sqrt(EA * mass)
        total: Array = self.internal + critical + (self.stiffness_time + self.stiffness_factor) * EA
        return total


def rayleigh_factors(
    first: float, second: float, ratio: float, ratio_second: float | None = None
) -> tuple[float, float]:
    """Alpha (1/s) and beta (s) that damp two angular frequencies by given ratios, S4 [3.17].

    From ratio = alpha/(2 omega) + beta omega/2 at both; for one ratio
    alpha = 2 ratio w1 w2/(w1 + w2), beta = 2 ratio/(w1 + w2).

    Parameters
    ----------
    first, second : float
        Angular frequencies, rad/s, such as the two lowest of `natural_frequencies`.
    ratio, ratio_second : float
        Of critical damping; the same at both unless given.

    Raises
    ------
    InputError
        When a frequency is not above 0 or both are the same.
    """
    found = Findings("rayleigh_factors")
    found.number("first", first, "rad/s", above=0.0)
    found.number("second", second, "rad/s", above=0.0)
    found.number("ratio", ratio, "", at_least=0.0)
    if not found.problems and math.isclose(first, second, rel_tol=1e-9):
        found.add("second", f"{second:g} rad/s", Message("refused_motion.differs_from_first"))
    found.raise_if_any()
    other = ratio if ratio_second is None else ratio_second
    over = 2.0 / (second**2 - first**2)
    alpha = over * first * second * (ratio * second - other * first)
    beta = over * (other * second - ratio * first)
    return alpha, beta
