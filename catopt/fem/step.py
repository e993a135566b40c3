"""One Newton step for all lines and the body where they meet, and the equations that it solves.

Tension is an unknown of its own beside the displacements, so that a line which does not stretch
(1/EA = 0) is no special case and a stiff one costs no digits. Of bar j between nodes j and j + 1:

    strain   l - l*(T) = 0, l*(T) = l0 (1 - e) (1 + T/EA) + l0 e T/K     or T = 0 where it is slack
    balance  T_j t_j - T_(j-1) t_(j-1) + loads + bed = 0                 at each node

e is 0 in the end. A bar too long by d l0 may keep a little tension, T = K keep / d (`kept`), which
makes l*(T) shorter by that d. With e = 1 bars are springs without a length of their own, and the
balance is linear in the coordinates: that is where the solution starts (`settle`).
"""

from __future__ import annotations

import math
from typing import Any, Final, NamedTuple

import numpy as np

from catopt.fem.banded import (
    DIAGONAL,
    back_substitute,
    eliminate,
    reach_of_first,
    solve_dense,
    take_aside,
)
from catopt.fem.friction import add_friction
from catopt.fem.loads import axis, bar_loads
from catopt.fem.seabed import (
    ABSENT,
    FREE,
    HELD,
    NO_FRICTION,
    ON_BED,
    PULLED,
    SHARING,
    SLACK,
    Ground,
    touches,
)
from catopt.fem.sloped_rest import hanging_node, own_rest, share_slope, share_weight, shift_slope
from catopt.fem.static_model import Bars, Body, Law, Net, State, kept, row_of_bar

_SPARE: Final = 1e-3
"""Part of the d asked for by its tension that a bar is taken to have at least when its stiffness is
sought: one that is longer than its length is all but as stiff as a taut one."""
_COUNTS_AS_SLACK: Final = 1e-6
"""A slack bar is taut again where it is longer than its length; small, so that a bar with tension
is not taken for slack before its length has followed."""
_ROUNDING: Final = 1e-11
_BIGHT: Final = 0.9
"""On a bed with friction a bar goes slack only where it is folded up, shorter by this part. Where
friction has used up the tension of a line that was pulled straight, it stays straight."""


def assemble(line: int, net: Net) -> tuple[int, float]:
    """Write the equations of a line, and bring contact, reaction and balance up to date.

    Returns the number of nodes and bars whose state changed, and the largest misfit of a bar's
    length relative to it.
    """
    bars, state, _, nodal, _, law, band, rhs, _ = net
    first, end = bars.start[line], bars.start[line + 1]
    for row in range(row_of_bar(first, line) - 3, row_of_bar(end, line)):
        rhs[row] = 0.0
        for c in range(band.shape[1]):
            band[row, c] = 0.0
    for node in range(first + line, end + line + 1):
        for i in range(3):
            state.balance[node, i] = nodal[node, i]
    strain = _add_bars(line, first, end, net)
    if law.ease == 0.0 and state.laid[line] == SHARING:
        _touch_down(line, first, end, net)
    changed = _lay_on_bed(line, first, end, net)
    for node in range(first + line, end + line + 1):
        row = row_of_bar(node - line, line) - 3
        for i in range(3):
            rhs[row + i] -= state.balance[node, i] / law.soft
    return changed, strain


def _add_bars(line: int, first: int, end: int, net: Net) -> float:
    """Add bars to the balance of their nodes, write their strain equations; largest misfit.

    Arrays are taken out of their tuples before the loop: numba counts references within it.
    """
    bars, state, loads, _, ground, law, band, rhs, _ = net
    x, tension, contact, _, balance, _ = state
    force, first_by, second_by = loads
    length, compliance = bars.length, bars.compliance
    varies, strain, keep = first_by.shape[0] > 0, 0.0, kept(line, state, law)
    for e in range(first, end):
        a = e + line
        size, tx, ty, tz = axis(x, a)
        t = (tx, ty, tz)
        T = tension[e]
        l0 = length[e]
        misfit, slope = _misfit(size, l0, T, compliance[e], law, keep)
        slack = keep == 0.0 and _is_slack(a, T / law.soft, misfit / l0, contact, ground, law)
        across = (T if law.carries_compression else max(T, 0.0)) / (size * law.soft)
        row = row_of_bar(e, line)
        if slack:
            band[row, DIAGONAL] = 1.0
            rhs[row] = -T / law.soft
        else:
            band[row, DIAGONAL] = -l0 * slope * law.soft
            rhs[row] = -misfit
        for i in range(3):
            # Rows of the first node stand 3 to 1 above the bar's, those of the second 1 to 3 below.
            up, down = row - 3 + i, row + 1 + i
            balance[a, i] += T * t[i] + force[e, i]
            balance[a + 1, i] += force[e, i] - T * t[i]
            band[down, DIAGONAL - 1 - i] = -t[i]
            if not slack:
                band[row, DIAGONAL + 1 + i] = t[i]
                band[row, DIAGONAL - 3 + i] = -t[i]
            band[up, DIAGONAL + 3 - i] = t[i]
            for j in range(3):
                g = across * ((1.0 if i == j else 0.0) - t[i] * t[j])
                by_first, by_second = 0.0, 0.0
                if varies:
                    by_first = first_by[e, i, j] / law.soft
                    by_second = second_by[e, i, j] / law.soft
                band[down, DIAGONAL + j - i] += by_second - g
                band[up, DIAGONAL + j - i] += by_first - g
                band[up, DIAGONAL + 4 + j - i] += by_second + g
                band[down, DIAGONAL - 4 + j - i] += by_first + g
        counts = 0.0 if slack else _counts(T / law.soft, size / l0, keep)
        strain = max(strain, counts * abs(misfit) / l0)
    return strain


def _touch_down(line: int, first: int, end: int, net: Net) -> None:
    """Let bars that lie in part on a rigid bed share their weight (`hanging_part`)."""
    _, state, loads, _, ground, law, band, _, _ = net
    for e in range(first, end):
        a = e + line
        hangs = hanging_node(a, state.contact)
        if hangs >= 0 and math.isinf(ground.stiffness[a]):
            rise = state.tension[e] * axis(state.x, a)[3]
            share_weight(a, hangs, rise, -2.0 * loads.force[e, 2], state.balance)
    # Only now is it known what each hanging node is left with.
    for e in range(first, end):
        a = e + line
        hangs = hanging_node(a, state.contact)
        if hangs >= 0 and math.isinf(ground.stiffness[a]):
            size, tx, ty, tz = axis(state.x, a)
            T = state.tension[e]
            lift = T * tz if hangs > a else -T * tz
            is_end = hangs in (first + line, end + line)
            left = 0.0 if is_end else state.balance[hangs, 2]
            slope = shift_slope(lift, -2.0 * loads.force[e, 2], left)
            across = (T if law.carries_compression else max(T, 0.0)) / (size * law.soft)
            share_slope(row_of_bar(e, line), slope, (tx, ty, tz), across, band)


def _misfit(
    size: float, l0: float, T: float, compliance: float, law: Law, keep: float
) -> tuple[float, float]:
    """By how much a bar is longer than its tension makes it, m, and how that length grows, 1/N.

    Where it keeps T = K keep / d at the end, it is as stiff as T and the d that it has make it, not
    as the d that T asks for: so both close up (a primal-dual interior point).
    """
    slope = (1.0 - law.ease) * compliance + law.ease / law.soft
    wanted = 1.0 - law.ease + slope * T
    if keep > 0.0:
        short = keep * law.soft / T
        if law.ease > 0.0:
            slope += short / T
        else:
            slope += max(wanted - size / l0, _SPARE * min(short, 1.0)) / T
        wanted -= short
    return size - l0 * wanted, slope


def _counts(tension: float, size: float, keep: float) -> float:
    """Give the part of a misfit that counts; `tension` over K, `size` over the bar's length.

    Where a bar keeps T by being too short, a misfit of length is only one of T, by T^2/keep.
    """
    return min(1.0, tension * tension / keep) if keep > 0.0 and size < 1.0 else 1.0


def _is_slack(
    a: int, tension: float, misfit: float, contact: Any, ground: Ground, law: Law
) -> bool:
    """Whether a bar has no tension; `tension` and `misfit` over K and over its length."""
    if (
        law.carries_compression
        or law.ease > 0.0
        or tension + _COUNTS_AS_SLACK * misfit > -_ROUNDING
    ):
        return False
    if ground.law == PULLED and contact[a] == ON_BED and contact[a + 1] == ON_BED:
        return misfit < -_BIGHT
    return True


def _lay_on_bed(line: int, first: int, end: int, net: Net) -> int:
    """Let the bed act on the inner nodes; returns how many changed their state."""
    bars, state, loads, _, ground, law, band, rhs, _ = net
    x, _, contact, reaction, balance, laid = state
    force, length, stiffness, changed = loads.force, bars.length, ground.stiffness, 0
    for e in range(first + 1, end):
        node, row = e + line, row_of_bar(e, line) - 3
        for i in range(3):
            band[row + i, DIAGONAL] -= law.drag_in / law.soft
        was = contact[node]
        reaction[node] = 0.0
        if was == ABSENT:
            continue
        rigid = math.isinf(stiffness[node])
        z = x[node, 2]
        pushed = -balance[node, 2] if rigid or was == HELD else -stiffness[node] * z
        rest = 0.0
        if rigid and law.ease == 0.0 and laid[line] == SHARING:
            rest = own_rest(node, -2.0 * force[e - 1, 2], -2.0 * force[e, 2], contact)
        now = touches(was, z, pushed - rest, 1e-12 * length[e])
        contact[node] = now
        changed += int(was != now)
        if now == FREE:
            continue
        if was == FREE:
            pushed = max(pushed, 0.0)
        reaction[node] = pushed
        if now == ON_BED and pushed > 0.0 and laid[line] != SLACK:
            add_friction(e, node, pushed, rigid, net)
        if rigid or now == HELD:
            balance[node, 2] = 0.0
            for c in range(band.shape[1]):
                band[row + 2, c] = 0.0
            band[row + 2, DIAGONAL] = 1.0
            rhs[row + 2] = -z
        else:
            balance[node, 2] += pushed
            band[row + 2, DIAGONAL] -= stiffness[node] / law.soft
    return changed


_ASTRAY: Final = 1e4
"""Turn of a bar, rad, after which nothing is to be hoped for with friction: it has no energy."""
_SLACK: Final = 1e-11
"""Push, over K, that is rounding: that of a bar which goes slack."""


class StepReport(NamedTuple):
    """What a step found at the shape from which it started."""

    imbalance: float  # largest force left over at a node, N
    node: int  # where; -1 for the body
    strain: float  # largest misfit of a bar's length, relative to it
    tension: float  # largest tension, N
    changed: int  # nodes that touched down or lifted off
    away: float  # distance by which the body is not yet where it is held, m
    turn: float  # largest change of a bar's direction that the step asks for, rad
    singular: bool  # whether the equations had no solution


class Water(NamedTuple):
    """The water about bars at rest."""

    first_node: Any  # (bars,): first node of each bar
    surface: float  # height of still water, m
    velocity: Any  # (bars, 3): at the bars' middles, m/s; of no bar without a current


class StepsReport(NamedTuple):
    """What became of some steps."""

    is_settled: bool  # whether the forces balance
    is_over: bool  # whether further steps are of no use
    used: int  # how often the equations were solved
    last: StepReport


def take_steps(
    net: Net, body: Body, water: Water, limit: int, left: int, tolerance: float
) -> StepsReport:
    """Take steps until the forces balance, `limit` at most.

    `left`: solutions that may be used up; `tolerance`: largest force left over at a node over the
    largest tension.
    """
    law, used = net.law, 0
    if law.ease == 1.0:
        _pull_springs(net, water.first_node)
    for _ in range(limit):
        report = _look(net, body, water)
        used += 1
        if _is_settled(report, tolerance):
            # Forces that balance where no step is defined, in a line that hangs straight, are it.
            if law.ease > 0.0 or report.singular:
                return StepsReport(True, False, used, report)
            # The step that is at hand: near the answer it leaves rounding errors only.
            take_step(net, 1.0)
            report = _look(net, body, water)
            used += 1
            # Where a node touches down or lifts off within the tolerance, there is more to do.
            if _is_settled(report, tolerance):
                return StepsReport(True, False, used, report)
        is_astray = report.turn > _ASTRAY and net.ground.law != NO_FRICTION
        if report.singular or used >= left or is_astray:
            return StepsReport(False, True, used, report)
        # A step that turns a bar by more than a radian is not to be followed all the way.
        part = 1.0 if law.ease == 1.0 or report.turn <= 1.0 else 1.0 / math.sqrt(report.turn)
        take_step(net, part)
        if law.ease == 1.0:
            _pull_springs(net, water.first_node)
    return StepsReport(False, False, used, report)


def _look(net: Net, body: Body, water: Water) -> StepReport:
    """Measure what is left over at the present shape, and find the step that balances it."""
    bar_loads(net.state.x, water.first_node, net.bars, water.surface, water.velocity, net.loads)
    return newton_step(net, body)


def _is_settled(report: StepReport, tolerance: float) -> bool:
    return (
        report.changed == 0
        and report.away <= tolerance
        and report.imbalance <= tolerance * report.tension
        and report.strain <= tolerance
    )


def _pull_springs(net: Net, first_node: Any) -> None:
    """Tension of springs without a length of their own at the present shape."""
    for e in range(first_node.shape[0]):
        size, _, _, _ = axis(net.state.x, first_node[e])
        net.state.tension[e] = net.law.soft * size / net.bars.length[e]


def newton_step(net: Net, body: Body) -> StepReport:
    """Assemble, measure what is left over, and solve; the step is left in `net.rhs`.

    Of each line it has the displacement of its first node, then bar by bar the change of its
    tension over `law.soft` and the displacement of its second node.
    """
    bars, state, rhs = net.bars, net.state, net.rhs
    lines, size = bars.start.shape[0] - 1, 3 * body.free.shape[0]
    schur = np.zeros((size, size))
    total = -body.force.copy().reshape(size) / net.law.soft
    left = body.force.copy()
    changed = 0
    strain = 0.0
    singular = False
    for k in range(lines):
        news, worst = assemble(k, net)
        if news > 0:
            # How a bar shares its weight depends on the states of both its nodes.
            _, worst = assemble(k, net)
        changed += news
        strain = max(strain, worst)
        for side in range(2):
            at = body.of_end[k, side]
            for i in range(3):
                if at >= 0:
                    left[at, i] += state.balance[bars.start[k + side] + k, i]
        singular = _reduce(k, net, body, schur, total) or singular
    changed += _lay_joints(net, body, left, schur, total)
    imbalance, node = _largest_imbalance(bars, state, left, body)
    away = _gap_to_place(net, body, total)
    _move_points(schur, total, body, net.law)
    for k in range(lines):
        _move_line(k, net, body, total)
    turn = _largest_turn(bars, state, rhs)
    tension = 0.0
    for e in range(state.tension.shape[0]):
        tension = max(tension, abs(state.tension[e]))
    singular = singular or not math.isfinite(turn)
    return StepReport(imbalance, node, strain, tension, changed, away, turn, singular)


def _reduce(k: int, net: Net, body: Body, schur: Any, total: Any) -> bool:
    """Eliminate a line and add it to the equations of its points; whether that has no solution."""
    bars, band, rhs = net.bars, net.band, net.rhs
    first, end = row_of_bar(bars.start[k], k), row_of_bar(bars.start[k + 1], k)
    a, b = body.of_end[k, 0], body.of_end[k, 1]
    side = net.side if a >= 0 else net.side[:0]
    if a >= 0:
        take_aside(band, side, first, end)
    if eliminate(band, rhs, side, first, end) >= 0:
        return True
    if b >= 0:
        for i in range(3):
            total[3 * b + i] += rhs[end - 3 + i]
            for j in range(3):
                schur[3 * b + i, 3 * b + j] += band[end - 3 + i, DIAGONAL + j - i]
    if a >= 0:
        _add_first(net, first, end, (a, b), schur, total)
    return False


def _add_first(net: Net, first: int, end: int, of: tuple[int, int], schur: Any, total: Any) -> None:
    """Add to the equations of its points what a line has of its first node, which moves."""
    a, b = of
    own = np.zeros((3, 7))
    reach_of_first(net.band, net.rhs, net.side, first, end, own)
    for i in range(3):
        total[3 * a + i] += own[i, 6]
        for j in range(3):
            schur[3 * a + i, 3 * a + j] += own[i, j]
            if b >= 0:
                schur[3 * a + i, 3 * b + j] += own[i, 3 + j]
                schur[3 * b + i, 3 * a + j] += net.side[end - 3 + i, j]


def _move_line(k: int, net: Net, body: Body, moves: Any) -> None:
    """Put the displacements of a line's ends back into its equations."""
    bars, rhs = net.bars, net.rhs
    first, end = row_of_bar(bars.start[k], k), row_of_bar(bars.start[k + 1], k)
    a, b = body.of_end[k, 0], body.of_end[k, 1]
    for i in range(3):
        rhs[first - 3 + i] = moves[3 * a + i] if a >= 0 else 0.0
    if a >= 0:
        for r in range(first, end - 3):
            for i in range(3):
                rhs[r] -= net.side[r, i] * moves[3 * a + i]
    for i in range(3):
        rhs[end - 3 + i] = moves[3 * b + i] if b >= 0 else 0.0
    back_substitute(net.band, rhs, first, end)


def _lay_joints(net: Net, body: Body, left: Any, schur: Any, total: Any) -> int:
    """Let the bed act on joints; returns how many changed their state."""
    changed = 0
    for p in range(body.lies.shape[0]):
        if body.lies[p] == 1:
            changed += _lay_joint(p, net, body, left, schur, total)
    return changed


def _lay_joint(p: int, net: Net, body: Body, left: Any, schur: Any, total: Any) -> int:
    """Let the bed act on a joint; returns whether it changed its state."""
    bars, state, law = net.bars, net.state, net.law
    stiffness, rest = _bed_of_joint(p, net, body)
    rigid, at, up = math.isinf(stiffness), _node_of(p, bars, body), 3 * p + 2
    was, z = state.contact[at], state.x[at, 2]
    pushed = -left[p, 2] if rigid else -stiffness * z
    now = touches(was, z, pushed - rest * (1.0 - 1e-9), 1e-12 * bars.length[0])
    for k in range(bars.start.shape[0] - 1):
        for side in range(2):
            if body.of_end[k, side] == p:
                state.contact[bars.start[k + side] + k] = now
                state.reaction[bars.start[k + side] + k] = 0.0
    if now == FREE:
        return int(was != now)
    if was == FREE:
        pushed = max(pushed, 0.0)
    state.reaction[at] = pushed
    if rigid:
        left[p, 2] = 0.0
        for c in range(schur.shape[0]):
            schur[up, c] = 0.0
        schur[up, up] = 1.0
        total[up] = -z
    else:
        left[p, 2] += pushed
        total[up] -= pushed / law.soft
        schur[up, up] -= stiffness / law.soft
    return int(was != now)


def _bed_of_joint(p: int, net: Net, body: Body) -> tuple[float, float]:
    """Stiffness of the bed under a joint, N/m, and half of each bar there that lies wholly, N."""
    bars, contact = net.bars, net.state.contact
    stiffness, rest = 0.0, 0.0
    for k in range(bars.start.shape[0] - 1):
        for side in range(2):
            if body.of_end[k, side] == p:
                node, bar = bars.start[k + side] + k, bars.start[k + side] - side
                stiffness += net.ground.stiffness[node]
                shares = net.law.ease == 0.0 and net.state.laid[k] == SHARING
                if shares and contact[node + 1 - 2 * side] == ON_BED:
                    rest -= min(net.loads.force[bar, 2], 0.0)
    return stiffness, rest


def take_step(net: Net, part: float) -> None:
    """Move the state by a part of the step that `newton_step` left.

    A tension falls to a tenth at most on the way (e above 0), where bars keep some, and off a rough
    bed: it gives the bar its stiffness across itself, and a step too far would take that away.
    """
    bars, state, law, rhs = net.bars, net.state, net.law, net.rhs
    rubs = net.ground.law != NO_FRICTION
    for k in range(bars.start.shape[0] - 1):
        keeps = law.ease > 0.0 or kept(k, state, law) > 0.0
        for e in range(bars.start[k], bars.start[k + 1]):
            row = row_of_bar(e, k)
            T = state.tension[e] + part * law.soft * rhs[row]
            lies = state.contact[e + k] == ON_BED and state.contact[e + k + 1] == ON_BED
            falls = keeps or (rubs and T < -_SLACK * law.soft and not lies)
            if falls and not law.carries_compression and state.tension[e] > 0.0:
                T = max(T, 0.1 * state.tension[e])
            state.tension[e] = T
            for i in range(3):
                state.x[e + k + 1, i] += part * rhs[row + 1 + i]
        for i in range(3):
            first = bars.start[k]
            state.x[first + k, i] += part * rhs[row_of_bar(first, k) - 3 + i]


def _gap_to_place(net: Net, body: Body, total: Any) -> float:
    """Ask for the way to each point's place where it is held; its largest part, m."""
    away = 0.0
    for p in range(body.free.shape[0]):
        at = _node_of(p, net.bars, body)
        for i in range(3):
            if body.free[p, i] == 0.0:
                total[3 * p + i] = body.place[p, i] - net.state.x[at, i]
                away = max(away, abs(total[3 * p + i]))
    return away


def _node_of(p: int, bars: Bars, body: Body) -> int:
    """Give the first end that moves with a point."""
    for k in range(bars.start.shape[0] - 1):
        for side in range(2):
            if body.of_end[k, side] == p:
                return int(bars.start[k + side] + k)
    return -1


def _move_points(schur: Any, total: Any, body: Body, law: Law) -> None:
    """Turn what lines and forces leave over into displacements of the points; nan for none."""
    for p in range(body.free.shape[0]):
        for i in range(3):
            row = 3 * p + i
            if body.free[p, i] == 0.0:
                for j in range(schur.shape[0]):
                    schur[row, j] = 0.0
                schur[row, row] = 1.0
            else:
                schur[row, row] -= law.drag_in / law.soft
    if not solve_dense(schur, total):
        total[:] = math.nan


def _largest_imbalance(bars: Bars, state: State, left: Any, body: Body) -> tuple[float, int]:
    """Size and place of the largest force left over at a node that may move."""
    largest, place = 0.0, -1
    for p in range(body.free.shape[0]):
        square = 0.0
        for i in range(3):
            square += body.free[p, i] * left[p, i] ** 2
        if square > largest:
            largest, place = square, -1 - p
    for k in range(bars.start.shape[0] - 1):
        for node in range(bars.start[k] + k + 1, bars.start[k + 1] + k):
            square = 0.0
            for i in range(3):
                square += state.balance[node, i] ** 2
            if square > largest:
                largest, place = square, node
    return math.sqrt(largest), place


def _largest_turn(bars: Bars, state: State, rhs: Any) -> float:
    """Largest relative displacement of two neighbours, over the distance between them."""
    largest = 0.0
    for k in range(bars.start.shape[0] - 1):
        for e in range(bars.start[k], bars.start[k + 1]):
            a, row = e + k, row_of_bar(e, k)
            square = 0.0
            size = 0.0
            for i in range(3):
                by = rhs[row + 1 + i] - rhs[row - 3 + i]
                square += by * by
                size += (state.x[a + 1, i] - state.x[a, i]) ** 2
            if not square <= largest * largest * size:
                largest = math.sqrt(square / size) if size > 0.0 else math.inf
    return largest
