"""Where all that is free of lines between points comes to rest: Newton's method, kept downhill.

The energy of lines that only pull, over a bed that only pushes, is convex in the places of their
ends, so that there is one equilibrium; Newton's method goes down to it. A step is cut back while
the forces at its end push back by more than a part of what they pulled at its start. In the yaw of
a body the energy need not be convex: there the step is turned downhill, and the equilibrium is the
one that the body comes to from where it was.

Plain functions of lists, or of arrays in compiled code.
"""

from __future__ import annotations

import math
from typing import Final, NamedTuple

from catopt.catenary.state import CONVERGED, NOT_CONVERGED
from catopt.compiled import inlined
from catopt.mooring.net import (
    FORCES,
    GUESS,
    OVER_THE_BED,
    PINNED,
    STATE,
    TURNS,
    Known,
    Net,
    chord_of,
    hang,
    slopes_of,
    stiffen,
)

TURNS_OVER: Final = 100
"""Status beside those of a line: the lines stop a body at no heading."""

TOLERANCE: Final = 1e-9
"""Force left over at a joint, over the largest end force of a line."""

_NEAR, _ROUGHLY = 3e-3, 1e-5
"""The same from which on each line is solved exactly; and what means nothing when it was not."""

ROUNDING: Final = 2e-15
"""Of the longest line, by which rounding moves an end: over the stiffness that is a force."""

WORTH_A_STEP: Final = 1e-3
"""Of what may be left over beside forces in plan: more is brought down while a step halves it."""

STEPS: Final = 200
_CUTS: Final = 60
OVERSHOOT: Final = 0.3
"""Of what the forces pulled at the start of a step, what they may push back at its end."""
_SETTLED: Final = 0.02
"""The same once a step has been cut back: a line that comes taut on the way stops it there, and the
next step has to know how stiff it is."""
HELD_BACK: Final = 1e-9
"""Spring to where a joint is in one step, over the largest stiffness: nothing else may hold it."""

_GENTLE: Final = 1e-6
"""The same, over what the forces would make of it along the longest line."""
MOST_TURN, _NUDGE = 0.5, 0.01
"""rad: of a body in one step; and off a ridge on which it balances."""
_GROWTH: Final = 1.5
"""Longest step over the one before."""
_BLOWN_UP: Final = 1e3
"""Of the forces at the start, what is left over where a body that comes upon the end of a line that
does not stretch can hardly slide along it."""
_RIDGE: Final = 1e-9
"""Of the largest stiffness: by so much a pivot may be below 0 from rounding."""


class Found(NamedTuple):
    """What came of it: status, line or freedom that stopped it, steps; what is left over, N."""

    status: int
    number: int
    steps: int
    left: float


def add_up(net: Net, known: Known) -> tuple[float, float]:
    """Sum what is left over by freedom, and what bed and pins carry; the largest of each, N.

    The largest left over at a joint or a body, and the largest end force of a line.
    """
    largest, flat = 0.0, 0.0
    for i in range(len(net.pull)):
        known.left[i], known.laid[i], known.held[i] = net.pull[i], 0.0, 0
        known.lost[i] = 0.0
    for k in range(net.used[0]):
        at = FORCES * k
        if known.plan[k] == 0:
            _add_force(at, net.first[k], net, known)
        _add_force(at + 3, net.second[k], net, known)
        x, y, z = known.force[at], known.force[at + 1], known.force[at + 2]
        u, v, w = known.force[at + 3], known.force[at + 4], known.force[at + 5]
        along, other = x * x + y * y, u * u + v * v
        largest, flat = max(largest, along + z * z, other + w * w), max(flat, along, other)
    for i in range(len(net.pull)):
        if net.buoyancy[i] > 0.0:
            _float(i, net, known)
        is_on_bed = net.kind[i] == OVER_THE_BED and known.q[i] <= 0.0 and known.left[i] <= 0.0
        if is_on_bed or net.kind[i] == PINNED:
            known.laid[i], known.left[i], known.held[i] = 0.0 - known.left[i], 0.0, 1
    most = 0.0
    for g in range(len(net.group) - 1):
        total = 0.0
        for i in range(net.group[g], net.group[g + 1]):
            total += known.left[i] * known.left[i]
        most = max(most, total)
    known.most[0], known.most[1] = math.sqrt(most), math.sqrt(largest)
    known.most[2] = math.sqrt(flat)
    return known.most[0], known.most[1]


def _hang_anew(net: Net, known: Known) -> tuple[int, int]:
    """Solve every line where all is, and sum up; status and line."""
    status, line = hang(net, known, False)
    if status == CONVERGED:
        add_up(net, known)
    return status, line


@inlined
def _float(i: int, net: Net, known: Known) -> None:
    """Take off a float what it loses of its buoyancy; a flat one is held while it loses a part."""
    out, height, most = known.q[i] - net.surface[i], net.height[i], net.buoyancy[i]
    if height > 0.0:
        known.lost[i] = most * min(max(out / height + 1.0, 0.0), 1.0)
    elif out > 0.0:
        known.lost[i] = most
    elif out == 0.0 and known.left[i] > 0.0:
        known.lost[i] = min(known.left[i], most)
        known.held[i] = 1 if known.left[i] <= most else 0
    known.left[i] -= known.lost[i]


@inlined
def _add_force(at: int, p: int, net: Net, known: Known) -> None:
    """Add a force on a point to what is left over of its freedoms."""
    along, across, up = net.freedom[4 * p], net.freedom[4 * p + 1], net.freedom[4 * p + 2]
    if along >= 0:
        known.left[along] += known.force[at]
    if across >= 0:
        known.left[across] += known.force[at + 1]
    if up >= 0:
        known.left[up] += known.force[at + 2]
    turn = net.freedom[4 * p + 3]
    if turn >= 0:
        moment = known.lever[2 * p] * known.force[at + 1]
        moment -= known.lever[2 * p + 1] * known.force[at]
        known.left[turn] += moment / net.scale[turn]


def _assemble(net: Net, known: Known) -> float:
    """Sum the stiffness of the lines, and what their pulls add as a body turns; the largest, N/m.

    That is of any line at one of its ends, free or not.
    """
    stiffest = 0.0
    begin(net, known)
    for k in range(net.used[0]):
        if known.plan[k] == 1:
            stiffest = max(stiffest, _add_in_plan(k, net, known))
            continue
        stiffen(k, net, known)
        add_line(k, net, known)
        for i in range(6):
            stiffest = max(stiffest, known.block[7 * i])
    return stiffest


def begin(net: Net, known: Known) -> None:
    """Begin the stiffness with that of floats that come out of the water over their height."""
    n = len(net.pull)
    for i in range(n * n):
        known.stiffness[i] = 0.0
    for i in range(n):
        if 0.0 < known.lost[i] < net.buoyancy[i] and net.height[i] > 0.0:
            known.stiffness[i * n + i] += net.buoyancy[i] / net.height[i]


def add_line(k: int, net: Net, known: Known) -> None:
    """Add the stiffness of a line, as `stiffen` writes it, to that of the freedoms."""
    a, b = net.first[k], net.second[k]
    _add_block(0, a, a, net, known)
    _add_block(3, a, b, net, known)
    _add_block(18, b, a, net, known)
    _add_block(21, b, b, net, known)
    _add_turn(FORCES * k, a, net, known)
    _add_turn(FORCES * k + 3, b, net, known)


def _add_in_plan(k: int, net: Net, known: Known) -> float:
    """Add the stiffness of a line whose upper end moves along x and y and turns; the largest, N/m.

    It is that of the line along it, and H over the span across it.
    """
    at, p = FORCES * k + 3, net.second[k]
    along, _, _, up = slopes_of(k, net, known)
    i, turn = net.freedom[4 * p], net.freedom[4 * p + 3]
    if i >= 0:
        x, y, span = chord_of(k, net, known)
        n, H = len(net.pull), known.state[STATE * k + 3]
        fx, fy = known.force[at], known.force[at + 1]
        ux, uy, across = (x / span, y / span, H / span) if span > 0.0 else (1.0, 0.0, 0.0)
        xx = along * ux * ux + across * uy * uy
        xy = (along - across) * ux * uy
        yy = along * uy * uy + across * ux * ux
        at, j = i * n, (i + 1) * n
        known.stiffness[at + i] += xx
        known.stiffness[at + i + 1] += xy
        known.stiffness[j + i] += xy
        known.stiffness[j + i + 1] += yy
        if turn >= 0:
            arm, lever_x, lever_y = net.scale[turn], known.lever[2 * p], known.lever[2 * p + 1]
            xm, ym = xy * lever_x - xx * lever_y, yy * lever_x - xy * lever_y
            known.stiffness[at + turn] += xm / arm
            known.stiffness[turn * n + i] += xm / arm
            known.stiffness[j + turn] += ym / arm
            known.stiffness[turn * n + i + 1] += ym / arm
            by_turning = ym * lever_x - xm * lever_y + fx * lever_x + fy * lever_y
            known.stiffness[turn * n + turn] += by_turning / (arm * arm)
    return max(along, up)


@inlined
def _add_turn(at: int, p: int, net: Net, known: Known) -> None:
    """Add what a force on a point does as the lever there turns."""
    turn = net.freedom[4 * p + 3]
    if turn >= 0:
        along = known.lever[2 * p] * known.force[at]
        along += known.lever[2 * p + 1] * known.force[at + 1]
        n, arm = len(net.pull), net.scale[turn]
        known.stiffness[turn * n + turn] += along / (arm * arm)


def _add_block(at: int, p: int, q: int, net: Net, known: Known) -> None:
    """Add what moving point q does to the force on point p, over their freedoms."""
    n, block = len(net.pull), known.block
    for i in range(4):
        row = net.freedom[4 * p + i]
        if row < 0:
            continue
        from_here = at + 6 * i
        if i < 3:
            x, y, z = block[from_here], block[from_here + 1], block[from_here + 2]
        else:
            by_x = -known.lever[2 * p + 1] / net.scale[row]
            by_y = known.lever[2 * p] / net.scale[row]
            x = by_x * block[at] + by_y * block[at + 6]
            y = by_x * block[at + 1] + by_y * block[at + 7]
            z = by_x * block[at + 2] + by_y * block[at + 8]
        _add_row(row * n, x, y, z, q, net, known)


@inlined
def _add_row(at: int, x: float, y: float, z: float, q: int, net: Net, known: Known) -> None:
    """Add to a row what moving a point along x, y and z does."""
    along, across, up = net.freedom[4 * q], net.freedom[4 * q + 1], net.freedom[4 * q + 2]
    if along >= 0:
        known.stiffness[at + along] += x
    if across >= 0:
        known.stiffness[at + across] += y
    if up >= 0:
        known.stiffness[at + up] += z
    turn = net.freedom[4 * q + 3]
    if turn >= 0:
        moment = known.lever[2 * q] * y - known.lever[2 * q + 1] * x
        known.stiffness[at + turn] += moment / net.scale[turn]


def descend(net: Net, known: Known, is_even: bool) -> float:
    """Solve for a step that goes down: pivots are kept above 0; and return the least of them.

    What is held stays. `is_even`: the stiffness is made symmetric, which friction's is not. A
    symmetric matrix has as many pivots below 0 as directions in which the forces push on.
    """
    n, rows, way = len(net.pull), known.pivots, known.way
    floor, least = HELD_BACK * _lay_rows(known, n, is_even), math.inf
    for j in range(n):
        pivot = rows[j * n + j]
        least = min(least, pivot)
        if pivot < floor:
            pivot = rows[j * n + j] = max(-pivot, floor)
        for r in range(j + 1, n):
            if rows[r * n + j] != 0.0:
                factor = rows[r * n + j] / pivot
                for c in range(j + 1, n):
                    rows[r * n + c] -= factor * rows[j * n + c]
                way[r] -= factor * way[j]
    for j in range(n - 1, -1, -1):
        for c in range(j + 1, n):
            way[j] -= rows[j * n + c] * way[c]
        way[j] /= rows[j * n + j]
    return least


def _lay_rows(known: Known, n: int, is_even: bool) -> float:
    """Lay out the equations of a step; the largest number on the diagonal."""
    rows, largest = known.pivots, 0.0
    for i in range(n):
        known.way[i] = known.left[i]
        for j in range(n):
            if known.held[i] == 1:
                rows[i * n + j] = 1.0 if i == j else 0.0
            elif is_even:
                rows[i * n + j] = 0.5 * (known.stiffness[i * n + j] + known.stiffness[j * n + i])
            else:
                rows[i * n + j] = known.stiffness[i * n + j]
        largest = max(largest, rows[i * n + i])
    return largest


def is_stable(net: Net, known: Known) -> bool:
    """Whether no body turns on from where it is in balance."""
    n, stiffest, does_turn = len(net.pull), 0.0, False
    for i in range(n):
        does_turn = does_turn or net.kind[i] == TURNS
        stiffest = max(stiffest, known.stiffness[i * n + i])
    if not does_turn or not stiffest > 0.0:  # or every line is slack
        return True
    return descend(net, known, False) >= -_RIDGE * stiffest


@inlined
def remember(net: Net, known: Known) -> None:
    """Keep where the freedoms are, what they are pulled with, and the lines as guesses."""
    for i in range(len(net.pull)):
        known.before[i], known.pulled[i] = known.q[i], known.left[i]
    for k in range(net.used[0]):
        H_s, H_b, V_s, V_b = slopes_of(k, net, known)
        at, state = GUESS * k, STATE * k + 3
        known.guess[at], known.guess[at + 1] = known.state[state], known.state[state + 1]
        known.guess[at + 2] = known.state[state + 2]
        high, low = known.place[3 * net.second[k] + 2], known.place[3 * net.first[k] + 2]
        known.guess[at + 3] = high - low
        known.guess[at + 4], known.guess[at + 5] = H_s, H_b
        known.guess[at + 6], known.guess[at + 7] = V_s, V_b


def _step(net: Net, known: Known, stride: float, is_rough: bool) -> tuple[int, int]:
    """Take a step of Newton's method, or as much of it as goes down; status and line."""
    n, stiffest, strongest = len(net.pull), 0.0, 0.0
    for i in range(n):
        stiffest = max(stiffest, known.stiffness[i * n + i])
        strongest = max(strongest, abs(known.left[i]))
    for i in range(n):
        known.stiffness[i * n + i] += HELD_BACK * stiffest + _GENTLE * strongest / stride
    descend(net, known, False)
    downhill, farthest = 0.0, 0.0
    for i in range(n):
        downhill += known.left[i] * known.way[i]
    if not downhill > 0.0:  # friction's derivatives are lopsided
        descend(net, known, True)
    for i in range(n):
        farthest = max(farthest, abs(known.way[i]))
    part = min(1.0, stride / farthest)
    for i in range(n):
        if net.kind[i] == TURNS and known.way[i] != 0.0:
            part = min(part, MOST_TURN * net.scale[i] / abs(known.way[i]))
    remember(net, known)
    return _go_down(net, known, part, is_rough)


def _go_down(net: Net, known: Known, part: float, is_rough: bool) -> tuple[int, int]:
    """Go a part of the way, cut back while the forces push back there; status and line.

    So it is where a line does not reach.
    """
    short, far, pull, push, last = 0.0, math.inf, 0.0, 0.0, part
    status, line, before = CONVERGED, -1, 0.0
    for i in range(len(net.pull)):
        before += known.pulled[i] * known.pulled[i]
    for cut_back in range(_CUTS):
        downhill = go(net, known, part)
        if short == 0.0:
            pull = downhill / part
        status, line = hang(net, known, is_rough)
        slope = -pull * part  # as if it pushed back as much
        if status == CONVERGED:
            add_up(net, known)
            slope, left = 0.0, 0.0
            for i in range(len(net.pull)):
                slope += known.left[i] * (known.q[i] - known.before[i])
                left += known.left[i] * known.left[i]
            if left <= 0.25 * before:
                break
            most = _SETTLED if cut_back > 0 else OVERSHOOT
            if abs(slope) <= most * downhill or (slope > 0.0 and math.isinf(far)):
                break
        # Illinois: regula falsi between where the forces still pull on and where they push back;
        # the end that stays counts half, so that a kink between them is closed in on.
        if slope > 0.0:
            push = 0.5 * push if short == last else push
            short, pull = part, slope / part
        else:
            pull = 0.5 * pull if far == last else pull
            far, push = part, slope / part
        last = part
        part = short + min(max(pull / (pull - push), 0.01), 0.99) * (far - short)
    return status, line


def go(net: Net, known: Known, part: float) -> float:
    """Move the freedoms by a part of the way; by how much the forces before pull along it, N m."""
    downhill = 0.0
    for i in range(len(net.pull)):
        there = known.before[i] + part * known.way[i]
        if net.kind[i] == OVER_THE_BED:  # none goes below it
            there = max(there, 0.0)
        if net.buoyancy[i] > 0.0 and net.height[i] == 0.0:  # or through the surface at once
            off = known.before[i] - net.surface[i]
            is_under = off < 0.0 or (off == 0.0 and known.pulled[i] <= 0.0)
            there = min(there, net.surface[i]) if is_under else max(there, net.surface[i])
        known.q[i] = there
        downhill += known.pulled[i] * (there - known.before[i])
    return downhill


def rest(net: Net, known: Known, hung: tuple[int, int], tolerance: float) -> Found:
    """Step until the forces are in balance, and as long as that still gets better.

    From where the freedoms are, of which `hang` said `hung`; `tolerance` as TOLERANCE, or coarser,
    beside forces in plan, which then will do. TURNS_OVER, with its freedom: a moment turns a body
    round once.
    """
    length = longest(net)
    for i in range(len(net.pull)):
        known.begun[i] = known.q[i]
    status, number = hung
    add_up(net, known)
    stride = _first_stride(length, net, known)
    best, most, left, is_nudged, is_rough = math.inf, math.inf, math.nan, False, False
    for step in range(STEPS):
        if status != CONVERGED:
            return Found(status, number, step, left)
        left, largest = known.most[0], known.most[1]
        most = _BLOWN_UP * (left + largest) if step == 0 else most
        if left > most:
            return Found(NOT_CONVERGED, -1, step, left)
        stiffest = _assemble(net, known)
        if is_rough and left <= max(_ROUGHLY, tolerance) * largest:
            remember(net, known)
            is_rough = False
            status, number = _hang_anew(net, known)
            continue
        rounding = ROUNDING * length * stiffest
        limit, little = tolerance * largest + rounding, tolerance * known.most[2] + rounding
        is_enough = tolerance > TOLERANCE or not WORTH_A_STEP * little < left < 0.5 * best
        if left <= (little if tolerance > TOLERANCE else limit) and is_enough:
            if is_nudged or is_stable(net, known):
                return Found(CONVERGED, -1, step, left)
            is_nudged, best = True, math.inf
            status, number = _nudged(net, known)
            continue
        best = min(best, left)
        is_rough = left > _NEAR * largest
        status, number = _step(net, known, stride, is_rough)
        stride = min(_GROWTH * stride, length)
        over = _turned_over(net, known)
        if over >= 0:
            return Found(TURNS_OVER, over, step, left)
        if left > limit and not _has_moved(net, known):
            break
    return Found(NOT_CONVERGED, -1, STEPS, left)


def longest(net: Net) -> float:
    """Unstretched length of the longest line, m."""
    most = 0.0
    for k in range(net.used[0]):
        most = max(most, _length(k, net))
    return most


@inlined
def _length(k: int, net: Net) -> float:
    length = 0.0
    for piece in range(net.piece[k], net.piece[k + 1]):
        length += net.length[piece]
    return length


def _first_stride(most: float, net: Net, known: Known) -> float:
    """Longest first step, m.

    Where every line has one end that moves, in plan, half of what a line can spare: beyond it the
    line is another one, stiff or slack.
    """
    least = most
    for k in range(net.used[0]):
        if known.plan[k] == 0:
            return most
        a, b, square = 3 * net.first[k], 3 * net.second[k], 0.0
        for i in range(3):
            off = known.place[a + i] - known.place[b + i]
            square += off * off
        length = _length(k, net)
        least = min(least, max(0.5 * abs(length - math.sqrt(square)), 0.01 * length))
    return least


def _nudged(net: Net, known: Known) -> tuple[int, int]:
    """Turn every body a little, off a ridge on which it balances; status and line."""
    remember(net, known)
    for i in range(len(net.pull)):
        if net.kind[i] == TURNS:
            known.q[i] += _NUDGE * net.scale[i]
    return _hang_anew(net, known)


def _turned_over(net: Net, known: Known) -> int:
    """Which yaw has gone round once; -1: none."""
    for i in range(len(net.pull)):
        if net.kind[i] == TURNS and abs(known.q[i] - known.begun[i]) > 2.0 * math.pi * net.scale[i]:
            return i
    return -1


def _has_moved(net: Net, known: Known) -> bool:
    """Whether the last step was one."""
    far = 0.0
    for i in range(len(net.pull)):
        far = max(far, abs(known.q[i] - known.before[i]))
    return far > 0.0
