"""The way down to a place of rest: Newton's method on the body's position, kept downhill.

The potential energy of heavy lines is convex in x and y, so that a step that does not climb leads
to the one place of rest. In yaw it need not be convex: there the step is turned downhill.
"""

from __future__ import annotations

import math
from typing import Final, NamedTuple

from catopt.catenary.state import CONVERGED, NOT_CONVERGED
from catopt.compiled import inlined
from catopt.mooring.balance import Arrangement, Lines, RestoringForce, pull_at

TURNS_OVER: Final = 100
"""Status beside those of a line: the lines stop the body at no heading."""

NEAR, ROUGHLY = 3e-3, 1e-5
"""Residual from which on each line is solved exactly; one that means nothing when it was not."""

STEPS = 60
PARTS = 100
FIRST_PART, LEAST_PART = 1e-2, 1e-7
"""Of the load, where it has to be put on in parts."""
STRIDE_GROWTH = 1.5
LEAST_SHARE = 1e-13
"""Part of a step that is too small to be worth a try."""

EXACT, ENOUGH, HARDLY_ANY = 1e-12, 1e-9, 1e-6
"""Residual at which to stop; the largest that counts once rounding bars the way to it; and, as a
part of `Freedom.scale`, where lines all but slack let the body creep for ever."""


ROUNDING, LAST_DIGITS = 1e-9, 1e-14
"""Parts below which a stiffness, and a product of two, may be rounding."""


class BodyLoad(NamedTuple):
    """Force along x and y (N) and moment (N m) on the body."""

    x: float
    y: float
    moment: float


class Freedom(NamedTuple):
    """How the body may move: in_plane in x and y, in_yaw in yaw.

    arm is a length by which yaw counts as much as a move (m, above 0), stride the longest first
    step (m; each further one may be half as long again), scale a force that is small for these
    lines (N: below it a residual is judged by this one), floor the stiffness to go by where no line
    holds the body (N/m), exact the residual at which to stop, as a part of the forces.
    """

    in_plane: bool
    in_yaw: bool
    arm: float
    stride: float
    scale: float
    floor: float
    exact: float = EXACT


class BodyProblem(NamedTuple):
    """A body under a load, how it may move, and its lines; what is known of them is written to."""

    load: BodyLoad
    freedom: Freedom
    arrangement: Arrangement
    lines: Lines


class Rest(NamedTuple):
    """Where the body came to rest (m, m, rad) and the pull of all lines there.

    status is CONVERGED or what stopped it, `line` the one that has no answer (-1: none), steps
    those of Newton. The errors are what is left unbalanced, N and N m; with TURNS_OVER the least
    moment left at any heading.
    """

    status: int
    line: int
    x: float
    y: float
    yaw: float
    steps: int
    force_error: float
    moment_error: float
    pull: RestoringForce


def freedom_of(arrangement: Arrangement, in_yaw: bool, arm: float) -> Freedom:
    """Set the lengths and forces by which steps and residuals of these lines are judged.

    `arm` is the largest distance of a fairlead from the body's origin, m.
    """
    spare, weight, longest = math.inf, 0.0, 0.0
    for k in range(len(arrangement.anchor_x)):
        x = arrangement.anchor_x[k] - arrangement.arm_x[k]
        y = arrangement.anchor_y[k] - arrangement.arm_y[k]
        rise = arrangement.fairlead_height[k] - arrangement.anchor_height[k]
        chord = math.sqrt(x * x + y * y + rise * rise)
        length = 0.0
        for piece in range(arrangement.first[k], arrangement.first[k + 1]):
            length += arrangement.length[piece]
            weight += abs(arrangement.length[piece] * arrangement.weight[piece])
            # The load below each piece; the coefficients of friction come after all of them.
            weight += abs(arrangement.load[piece + arrangement.first[k] + 2 * k])
        # Half of what a line can spare: beyond it the line is another one, stiff or slack.
        spare = min(spare, max(0.5 * abs(length - chord), 0.01 * length))
        longest = max(longest, length)
    return Freedom(
        True,
        in_yaw,
        arm if arm > 0.0 else 1.0,
        spare,
        1e-3 * weight,
        1e-9 * weight / longest,
        EXACT,
    )


def newton(x: float, y: float, yaw: float, pull: RestoringForce, problem: BodyProblem) -> Rest:
    """Take Newton steps from a position (m, m, rad) until nothing is left unbalanced.

    What is not free stays; `pull` is that of the lines at the start.
    """
    load, freedom, arrangement, lines = problem
    start_yaw = yaw
    before = math.inf
    stride = freedom.stride
    is_exact = True
    force = math.sqrt(load.x * load.x + load.y * load.y)
    for step in range(STEPS):
        status = _status(pull, yaw - start_yaw)
        if status != CONVERGED:
            return stopped(status, pull.line, x, y, yaw, step, pull)
        out_x, out_y, out_m = _unbalanced(pull, load, freedom)
        size = math.sqrt(out_x * out_x + out_y * out_y + out_m * out_m)
        scale = pull.total + force + freedom.scale
        if not is_exact and size <= ROUGHLY * scale and freedom.exact < ROUGHLY:
            pull = pull_at(x, y, yaw, arrangement, lines, True)
            is_exact = True
            continue
        is_exact = size <= NEAR * scale
        if _is_done(size, before, scale, step, freedom):
            force_error = math.sqrt(out_x * out_x + out_y * out_y)
            moment_error = abs(out_m) * freedom.arm
            return Rest(CONVERGED, -1, x, y, yaw, step, force_error, moment_error, pull)
        before = size
        move_x, move_y, turn = _newton_step(out_x, out_y, out_m, pull, freedom, stride)
        stride *= STRIDE_GROWTH
        slope = out_x * move_x + out_y * move_y + out_m * turn * freedom.arm
        share = 1.0
        # What is left unbalanced along the step falls from `slope`; well below 0, the step went
        # too far, and so it did where a line was drawn far too hard across it.
        while True:
            pull = pull_at(
                x + share * move_x,
                y + share * move_y,
                yaw + share * turn,
                arrangement,
                lines,
                is_exact,
            )
            left, along = math.inf, 0.0
            if pull.status == CONVERGED:
                out_x, out_y, out_m = _unbalanced(pull, load, freedom)
                left = math.sqrt(out_x * out_x + out_y * out_y + out_m * out_m)
                along = out_x * move_x + out_y * move_y + out_m * turn * freedom.arm
                if left <= 0.5 * size or size <= ENOUGH * scale:
                    break
                if left <= 2.0 * size and along >= -0.5 * slope:
                    break
            if share <= LEAST_SHARE:
                status = NOT_CONVERGED if pull.status == CONVERGED else pull.status
                return stopped(status, pull.line, x, y, yaw, step, pull)
            share *= max(slope / (slope - along), 0.1) if along < -0.5 * slope else 0.5
        x += share * move_x
        y += share * move_y
        yaw += share * turn
    return stopped(NOT_CONVERGED, -1, x, y, yaw, STEPS, pull)


@inlined
def _status(pull: RestoringForce, turned: float) -> int:
    """Tell what bars the way on: a line without an answer, or a body that went round once."""
    is_over = abs(turned) > 2.0 * math.pi
    return TURNS_OVER if is_over and pull.status == CONVERGED else pull.status


@inlined
def _is_done(size: float, before: float, scale: float, step: int, freedom: Freedom) -> bool:
    """Whether a residual is as small as it gets."""
    is_stuck = size >= 0.5 * before and size <= ENOUGH * scale
    is_slow = step == STEPS - 1 and size <= HARDLY_ANY * freedom.scale
    return size <= freedom.exact * scale or is_stuck or is_slow


def stopped(
    status: int, line: int, x: float, y: float, yaw: float, step: int, pull: RestoringForce
) -> Rest:
    """Say where the body was when something stopped it."""
    return Rest(status, line, x, y, yaw, step, math.nan, math.nan, pull)


@inlined
def is_stable(pull: RestoringForce, freedom: Freedom) -> bool:
    """Whether the body, turned a little, does not turn on; with x and y following if free."""
    least = -ROUNDING * ((pull.xx + pull.yy) * freedom.arm * freedom.arm + abs(pull.mm))
    return yaw_stiffness(pull, freedom.in_plane) >= least


@inlined
def yaw_stiffness(pull: RestoringForce, in_plane: bool) -> float:
    """Stiffness in yaw, N m; with x and y following where they are free."""
    if not in_plane:
        return pull.mm
    trace = pull.xx + pull.yy
    plane = pull.xx * pull.yy - pull.xy * pull.xy
    if trace <= 0.0:
        return pull.mm
    if plane <= LAST_DIGITS * trace * trace:
        # The lines hold the body along one direction: that of the stiffness's only eigenvector.
        both = pull.xx * pull.xm * pull.xm + pull.yy * pull.ym * pull.ym
        return pull.mm - (both + 2.0 * pull.xy * pull.xm * pull.ym) / (trace * trace)
    x = (pull.yy * pull.xm - pull.xy * pull.ym) / plane
    y = (pull.xx * pull.ym - pull.xy * pull.xm) / plane
    return pull.mm - x * pull.xm - y * pull.ym


@inlined
def within_half_a_turn(rest: Rest) -> Rest:
    """Name the same place by a yaw above -pi and up to pi rad."""
    if -math.pi < rest.yaw <= math.pi:
        return rest
    turns = math.ceil((rest.yaw - math.pi) / (2.0 * math.pi))
    return Rest(
        rest.status,
        rest.line,
        rest.x,
        rest.y,
        rest.yaw - 2.0 * math.pi * turns,
        rest.steps,
        rest.force_error,
        rest.moment_error,
        rest.pull,
    )


@inlined
def _unbalanced(
    pull: RestoringForce, load: BodyLoad, freedom: Freedom
) -> tuple[float, float, float]:
    """Force and moment that nothing balances, in the free directions; all in N."""
    x = load.x + pull.x if freedom.in_plane else 0.0
    y = load.y + pull.y if freedom.in_plane else 0.0
    m = (load.moment + pull.moment) / freedom.arm if freedom.in_yaw else 0.0
    return x, y, m


@inlined
def _newton_step(
    out_x: float, out_y: float, out_m: float, pull: RestoringForce, freedom: Freedom, stride: float
) -> tuple[float, float, float]:
    """Solve K step = unbalanced by L D L^T, its pivots kept above 0; no longer than the stride."""
    arm, floor = freedom.arm, freedom.floor
    xx, xy, yy, xm, ym, mm = 1.0, 0.0, 1.0, 0.0, 0.0, 1.0
    if freedom.in_plane:
        xx, xy, yy = pull.xx, pull.xy, pull.yy
    if freedom.in_yaw:
        mm = pull.mm / (arm * arm)
    if freedom.in_plane and freedom.in_yaw:
        xm, ym = pull.xm / arm, pull.ym / arm
    first = max(xx, floor)
    xy_l, xm_l = xy / first, xm / first
    second = max(yy - xy * xy_l, floor)
    ym_r = ym - xy * xm_l
    ym_l = ym_r / second
    third = mm - xm * xm_l - ym_r * ym_l
    if third < floor:
        third = max(-third, floor)
    y = out_y - xy_l * out_x
    m = (out_m - xm_l * out_x - ym_l * y) / third
    y = y / second - ym_l * m
    x = out_x / first - xy_l * y - xm_l * m
    length = math.sqrt(x * x + y * y + m * m)
    shorter = min(1.0, stride / length) if length > 0.0 else 1.0
    return shorter * x, shorter * y, shorter * m / arm


def by_parts(x: float, y: float, yaw: float, problem: BodyProblem) -> Rest:
    """Put the load on in parts, each from where the last one left the body.

    For lines that do not stretch: a body that comes upon the end of one under full load can
    hardly slide along it.
    """
    load, freedom, arrangement, lines = problem
    done, part = 0.0, FIRST_PART
    pull = pull_at(x, y, yaw, arrangement, lines, True)
    rest = stopped(NOT_CONVERGED, -1, x, y, yaw, 0, pull)
    for _ in range(PARTS):
        level = min(done + part, 1.0)
        pull = pull_at(x, y, yaw, arrangement, lines, True)
        share = BodyLoad(level * load.x, level * load.y, level * load.moment)
        rest = newton(x, y, yaw, pull, BodyProblem(share, freedom, arrangement, lines))
        if rest.status == CONVERGED:
            if level == 1.0:
                return rest
            x, y, yaw, done = rest.x, rest.y, rest.yaw, level
            part *= 2.0
        elif rest.status == NOT_CONVERGED and part > LEAST_PART:
            part *= 0.25
        else:
            return rest
    return stopped(NOT_CONVERGED, -1, x, y, yaw, rest.steps, rest.pull)
