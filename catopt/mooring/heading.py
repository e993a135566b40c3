"""Which way a body heads: downhill from where it is, or else round in yaw.

With all else at rest, the moment left on the body is minus the slope of one potential over the yaw.
Where it passes from turning the body on to turning it back, the body rests and stays. Over a full
turn the moment of the lines has a mean of zero, so that such a heading exists for every moment
between their largest one in either sense.

Plain functions of lists, or of arrays in compiled code.
"""

from __future__ import annotations

import math
from typing import Final, NamedTuple

from catopt.catenary.state import CONVERGED, NOT_CONVERGED, TOO_SHORT
from catopt.compiled import inlined
from catopt.mooring.net import PINNED, TURNS, Known, Net, hang
from catopt.mooring.rest import TOLERANCE, TURNS_OVER, Found, add_up, descend, is_stable, rest

_STRIDE: Final = math.pi / 18.0
"""rad, from one yaw looked at to the next, as a rule."""
_LEAST_STRIDE: Final = 1e-8
"""The same where lines bar the way."""
_FINEST: Final = _STRIDE / 24.0
"""rad, below which a stride is not halved for the moment's bends."""

_COARSE: Final = 1e-4
"""Part of the forces that may be left on the way round when only other headings are looked for."""
_CLOSE: Final = 1e-6
"""How far the last steps to a heading may take it from where it was found, rad."""

_FIRST_PART, _LEAST_PART, _PARTS = 1e-2, 1e-7, 100
"""Of the load, where it has to be put on in parts; and how many."""

_STRIDES: Final = 2000
_NARROWINGS: Final = 80


class Heading(NamedTuple):
    """A body at one yaw (rad), all else at rest if the status says so.

    `left` is the moment that nothing balances, over the arm of the yaw (N), above 0 where it turns
    the body on; `stiffness` says by how much it falls as the body turns, N; `largest` is the
    largest end force of a line in plan, N.
    """

    yaw: float
    status: int
    number: int
    left: float
    stiffness: float
    largest: float


def rest_at_heading(net: Net, known: Known, hung: tuple[int, int]) -> Found:
    """Bring all to rest, one body that turns at the first stable heading its load turns it to.

    As `rest`; TURNS_OVER, with the least moment left over the arm of the yaw (N), when no heading
    stops that body; what barred the way where some yaws have no answer.
    """
    turning = turning_of(net)
    for i in range(len(net.pull)):
        known.kept[i] = known.q[i]
    found = rest(net, known, hung, TOLERANCE)
    if found.steps == 0 and found.status != CONVERGED:
        return found
    is_barred = found.status == NOT_CONVERGED or found.status == TOO_SHORT
    if is_barred and _is_stiff(net):
        _go_back(net, known)
        found = _by_parts(net, known)
    if turning < 0 or (found.status == CONVERGED and is_stable(net, known)):
        return found
    _go_back(net, known)
    return _first_heading(turning, net, known)


def _is_stiff(net: Net) -> bool:
    """Whether some line does not stretch."""
    for k in range(net.used[0]):
        softest = 0.0
        for piece in range(net.piece[k], net.piece[k + 1]):
            softest = max(softest, net.compliance[piece])
        if softest == 0.0:
            return True
    return False


@inlined
def _go_back(net: Net, known: Known) -> None:
    for i in range(len(net.pull)):
        known.q[i] = known.kept[i]


def _by_parts(net: Net, known: Known) -> Found:
    """Put the load on in parts from what is in balance at the start, each from where the last led.

    For lines that do not stretch: a body that comes upon the end of one under full load can hardly
    slide along it.
    """
    n, done, part = len(net.pull), 0.0, _FIRST_PART
    status, number = hang(net, known, False)
    if status != CONVERGED:
        return Found(status, number, 0, math.nan)
    add_up(net, known)
    for i in range(n):
        known.asked[i], known.off[i] = net.pull[i], known.left[i]
    found = Found(NOT_CONVERGED, -1, 0, math.nan)
    for _ in range(_PARTS):
        level = min(done + part, 1.0)
        for i in range(n):
            net.pull[i] = known.asked[i] - (1.0 - level) * known.off[i]
        found = rest(net, known, (status, number), TOLERANCE)
        status, number = CONVERGED, -1
        if found.status == CONVERGED:
            done = level
            part *= 2.0
            if level == 1.0:
                break
        elif part > _LEAST_PART and (found.status in (NOT_CONVERGED, TOO_SHORT)):
            part *= 0.25
            for i in range(n):
                known.q[i] = known.begun[i]
            status, number = hang(net, known, False)
        else:
            break
    for i in range(n):
        net.pull[i] = known.asked[i]
    return found


def turning_of(net: Net) -> int:
    """Say which yaw is free; -1 where none is, or several are."""
    found = -1
    for i in range(len(net.pull)):
        if net.kind[i] == TURNS:
            if found >= 0:
                return -1
            found = i
    return found


def _first_heading(turning: int, net: Net, known: Known) -> Found:
    """Turn a body from where it is the way its load turns it, until a heading stops it."""
    here = _pinned(turning, net, known)
    if here.status == NOT_CONVERGED:
        net.kind[turning] = TURNS
        return Found(here.status, here.number, 0, math.nan)
    sense = -1.0 if here.left < 0.0 else 1.0
    # A stride more than a turn: a start that is itself the heading is met at the end.
    way = 2.0 * math.pi + _STRIDE
    here = _with_left(here, sense * here.left)
    found = _go_round(turning, here, sense, way, math.inf, TOLERANCE, net, known)
    net.kind[turning] = TURNS
    add_up(net, known)
    return found


def next_heading(net: Net, known: Known, way: float) -> Found:
    """Find the next stable heading counter-clockwise of where all is, no farther than `way` rad on.

    As `rest_at_heading`.
    """
    turning = turning_of(net)
    here = _with_left(_pinned(turning, net, known), 0.0)
    found = _go_round(turning, here, 1.0, way, 0.0, _COARSE, net, known)
    net.kind[turning] = TURNS
    add_up(net, known)
    return found


def _pinned(turning: int, net: Net, known: Known) -> Heading:
    """Pin a yaw where it is."""
    net.kind[turning] = PINNED
    for i in range(len(net.pull)):
        known.follow[i] = 0.0
    yaw = known.q[turning] / net.scale[turning]
    here = _at(turning, yaw, 1.0, TOLERANCE, net, known)
    if (
        here.status == NOT_CONVERGED
        and _is_stiff(net)
        and _by_parts(net, known).status == CONVERGED
    ):
        here = _at(turning, yaw, 1.0, TOLERANCE, net, known)
    return here


@inlined
def _with_left(of: Heading, left: float) -> Heading:
    return Heading(of.yaw, of.status, of.number, left, of.stiffness, of.largest)


def _go_round(
    turning: int,
    here: Heading,
    sense: float,
    way: float,
    least: float,
    tolerance: float,
    net: Net,
    known: Known,
) -> Found:
    """Turn the body on until a heading stops it.

    `least` is the moment left below which a turning point of the moment is worth a closer look,
    `tolerance` the part of the forces at which all else is at rest.
    """
    start_yaw, best = here.yaw, here.left
    status, number = here.status, here.number
    stride, gap = _STRIDE, 0.0
    for _ in range(_STRIDES):
        ahead = gap if gap > 0.0 else stride
        there = _at(turning, here.yaw + sense * ahead, sense, tolerance, net, known)
        is_answered = there.status == CONVERGED
        if is_answered and gap == 0.0 and here.status == CONVERGED:
            small = 10.0 * max(tolerance, _CLOSE) * there.largest
            if stride > _FINEST and _may_hide(here, there, least, small):
                stride *= 0.5
                continue
            here, there = _narrowed(turning, here, there, sense, least, net, known)
            if here.left > 0.0 >= there.left:
                return _rest_between(turning, here, there, sense, net, known)
            for each in (here, there):
                if each.left < least:
                    least = best = each.left
        if is_answered:
            here, stride, gap = there, min(2.0 * stride, _STRIDE), 0.0
        elif gap > 0.0 or stride <= _LEAST_STRIDE or here.status != CONVERGED:
            status, number, gap = there.status, there.number, gap + _STRIDE
        else:
            stride *= 0.25
        if abs(here.yaw - start_yaw) + gap >= way:
            why = TURNS_OVER if status == CONVERGED else status
            return Found(why, turning if status == CONVERGED else number, 0, abs(best))
    return Found(NOT_CONVERGED, -1, 0, abs(best))


@inlined
def _may_hide(here: Heading, there: Heading, least: float, small: float) -> bool:
    """Whether the moment bends so much between two yaws that it may turn back in between.

    It bends where a line becomes slack. Above zero what matters is whether it falls below `least`.
    """
    if here.left > 0.0 >= there.left:
        return False
    room = 0.0
    if here.left > 0.0 and there.left > 0.0:
        room = max(min(here.left, there.left) - least, 0.0)
    elif here.left <= 0.0 and there.left <= 0.0:
        room = -max(here.left, there.left)
    width = abs(there.yaw - here.yaw)
    bend = there.left - here.left + 0.5 * width * (here.stiffness + there.stiffness)
    return abs(bend) > 0.5 * room + small


def _narrowed(
    turning: int,
    here: Heading,
    there: Heading,
    sense: float,
    least: float,
    net: Net,
    known: Known,
) -> tuple[Heading, Heading]:
    """Close in on a turning point of the moment between two yaws, where one may matter.

    Above zero it is one at which the moment left is least, below zero one at which it is largest.
    Ends with yaws between which the moment passes through zero, or close to the turning point.
    """
    for _ in range(_NARROWINGS):
        is_on = here.left > 0.0
        width = abs(there.yaw - here.yaw)
        if is_on != (there.left > 0.0) or width <= _LEAST_STRIDE:
            break
        if (here.stiffness > 0.0) != is_on or (there.stiffness > 0.0) == is_on:
            break
        # The tangents at both ends meet at a level that the moment does not pass where it curves
        # to one side only.
        way = (there.stiffness * width + there.left - here.left) / (
            there.stiffness - here.stiffness
        )
        way = min(max(way, 0.0), width)
        level = here.left - here.stiffness * way
        nearest = min(here.left, there.left)
        if (level >= min(least, nearest - TOLERANCE * abs(nearest))) if is_on else (level <= 0.0):
            break
        turn = sense * min(max(way, 0.1 * width), 0.9 * width)
        middle = _at(turning, here.yaw + turn, sense, TOLERANCE, net, known)
        if middle.status != CONVERGED:
            break
        if (middle.left > 0.0) != is_on:
            return (here, middle) if is_on else (middle, there)
        if (middle.stiffness > 0.0) == (here.stiffness > 0.0):
            here = middle
        else:
            there = middle
    return here, there


def _rest_between(
    turning: int, here: Heading, there: Heading, sense: float, net: Net, known: Known
) -> Found:
    """Come to rest between a yaw from which the body is turned on and one that turns it back."""
    before, width = math.inf, math.inf
    for _ in range(_NARROWINGS):
        near = here if here.left < -there.left else there
        last_width, width = width, abs(there.yaw - here.yaw)
        if abs(near.left) <= TOLERANCE * near.largest or width <= 1e-14:
            break
        # Newton's step from the nearer end, halving where it leaves the two or is slow.
        way = 0.0
        if near.stiffness > 0.0:
            way = abs(near.yaw - here.yaw) + near.left / near.stiffness
        is_slow = abs(near.left) > 0.25 * before and width > 0.5 * last_width
        if not 0.0 < way < width or is_slow:
            way = 0.5 * width
        before = abs(near.left)
        middle = _at(turning, here.yaw + sense * way, sense, TOLERANCE, net, known)
        if middle.status != CONVERGED:
            break
        if middle.left > 0.0:
            here = middle
        else:
            there = middle
    near = here if here.left < -there.left else there
    _at(turning, near.yaw, sense, TOLERANCE, net, known)
    net.kind[turning] = TURNS
    found = rest(net, known, hang(net, known, False), TOLERANCE)
    is_near = abs(known.q[turning] / net.scale[turning] - near.yaw) <= max(width, _CLOSE)
    if found.status == CONVERGED and is_near and is_stable(net, known):
        return found
    net.kind[turning] = PINNED
    last = _at(turning, near.yaw, sense, TOLERANCE, net, known)
    is_done = last.status == CONVERGED and abs(near.left) <= TOLERANCE * near.largest
    return Found(CONVERGED if is_done else NOT_CONVERGED, -1, found.steps, abs(near.left))


def _at(
    turning: int, yaw: float, sense: float, tolerance: float, net: Net, known: Known
) -> Heading:
    """Turn the body to a yaw, rad, and let all else follow; where that fails all stays."""
    n, arm = len(net.pull), net.scale[turning]
    turn = yaw * arm - known.q[turning]
    for i in range(n):
        known.kept[i] = known.q[i]
        known.q[i] += turn * known.follow[i]
    known.q[turning] = yaw * arm
    found = rest(net, known, hang(net, known, False), tolerance)
    if found.status != CONVERGED:
        for i in range(n):
            known.q[i] = known.kept[i]
        return Heading(yaw, found.status, found.number, math.nan, math.nan, math.nan)
    left = -sense * known.laid[turning]
    for i in range(n):
        known.left[i] = 1.0 if i == turning else 0.0
    descend(net, known, False)
    stiffness = 0.0
    for i in range(n):
        known.follow[i] = known.way[i]
        stiffness += known.stiffness[turning * n + i] * known.way[i]
    add_up(net, known)
    return Heading(yaw, CONVERGED, -1, left, stiffness * arm, known.most[2])
