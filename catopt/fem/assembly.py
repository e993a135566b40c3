"""The equations of a line's nodes and bars at one shape, linearised.

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
from typing import Any, Final

from catopt.fem.banded import DIAGONAL
from catopt.fem.friction import add_friction
from catopt.fem.loads import axis
from catopt.fem.resting import Law, Net, kept, row_of_bar
from catopt.fem.seabed import (
    ABSENT,
    FREE,
    HELD,
    ON_BED,
    PULLED,
    SHARING,
    SLACK,
    Ground,
    touches,
)
from catopt.fem.sloped_rest import hanging_node, own_rest, share_slope, share_weight, shift_slope

_SPARE: Final = 1e-3
"""Part of the d asked for by its tension that a bar is taken to have at least when its stiffness is
sought: one that is longer than its length is all but as stiff as a taut one."""
_SLACK: Final = 1e-6
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
    """Let bars that lie in part on a rigid bed share their weight (`touchdown`)."""
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
    if law.carries_compression or law.ease > 0.0 or tension + _SLACK * misfit > -_ROUNDING:
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
