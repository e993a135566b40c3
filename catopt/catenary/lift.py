"""The vertical force at the fairlead that lifts it to a given height."""

from __future__ import annotations

import math

from catopt.catenary.pieces import Pieces
from catopt.catenary.suspended import suspended_height
from catopt.compiled import inlined

LAST_STEP = 1e-8
"""A Newton step this small, relatively, leaves its square: less than the last digit."""


def vertical_force(
    H: float,
    height: float,
    pieces: Pieces,
    length: float,
    weight: float,
    guess: float,
    last_step: float,
) -> float:
    """Vertical force at the fairlead that lifts it to `height` above anchor or first touchdown, N.

    Newton's method from `guess` on a rising function, kept inside a bracket that every evaluation
    narrows; nan when it does not converge. The line, of whole `length` (m) and `weight` (N), has no
    buoyant parts. After a Newton step of the relative size `last_step` no other is taken: 0 to go
    on to the last digit, or LAST_STEP where the caller looks at what is left of the height.
    """
    scale = max(length, height)
    low, high = 0.0, math.inf
    stride = H + abs(guess)
    last_error = math.inf
    V = guess
    for _ in range(200):
        z, z_V = suspended_height(H, V, pieces)
        error = z - height
        is_slow = abs(error) > 0.5 * last_error
        if abs(error) <= 2e-16 * scale or (
            is_slow and abs(error) <= 1e-12 * scale and last_step > 0.0
        ):
            return V
        last_error = abs(error)
        if error > 0.0:
            high = min(high, V)
        else:
            low = max(low, V)
        new = _step(H, V, error, z_V, V < weight)
        step = abs(new - V)
        if step <= last_step * abs(V) and low < new < high:
            return new
        if step <= 2.3e-16 * max(abs(V), H) or not low < high:
            # The last digit of V is reached: what its rounding leaves of the height decides.
            return V if abs(error) <= 1e-10 * scale else math.nan
        if is_slow or not low < new < high:
            if math.isinf(high):
                new = max(V - math.copysign(stride, error), low)
                stride *= 4.0
            else:
                new = 0.5 * (low + high)
                if new in (low, high):
                    return V if abs(error) <= 1e-10 * scale else math.nan
        V = new
    return math.nan


@inlined
def _step(H: float, V: float, error: float, z_V: float, is_grounded: bool) -> float:
    """Newton's next V; inf where the height does not answer.

    From a touchdown the height of a uniform line is (T - H)/w: linear in T, not in V. Taken in T,
    the step of such a line needs no second one, and that of others few.
    """
    if z_V <= 0.0:
        return math.inf
    if not is_grounded or V <= 0.0:
        return V - error / z_V
    T = math.sqrt(H * H + V * V)
    rise = -error * V / (z_V * T)
    square = V * V + rise * (2.0 * T + rise)
    # A tension below 0 would come back as its mirror image, and then the step as no step at all.
    return math.sqrt(square) if square > 0.0 and T + rise > 0.0 else 0.5 * V


@inlined
def grounded_guess(H: float, pieces: Pieces, rise: float, length: float, weight: float) -> float:
    """V at the fairlead of a uniform line of the same mean weight, touchdown or not.

    Its tension at the fairlead is H + p with p + c p (p + 2 H) / 2 = w rise; a line of several
    pieces is taken not to stretch, for its mean weight is the greater error.
    """
    p = max(weight / length * rise, 0.0)
    if len(pieces.length) == 1:
        stiff = 1.0 + pieces.compliance[0] * H
        p *= 2.0 / (stiff + math.sqrt(stiff * stiff + 2.0 * pieces.compliance[0] * p))
    V = math.sqrt(p * (p + 2.0 * H))
    return V if V < weight else _suspended_guess(H, rise, length, weight)


@inlined
def _suspended_guess(H: float, rise: float, length: float, weight: float) -> float:
    """V at the fairlead of a hanging line whose mean direction is that of its chord."""
    slope = max(-0.999, min(0.999, rise / length))
    return H * slope / math.sqrt(1.0 - slope * slope) + 0.5 * weight


def top_weight(pieces: Pieces, length: float) -> float:
    """Submerged weight of the uppermost `length` (m, unstretched) of the line, N."""
    weight = 0.0
    for k in range(len(pieces.length) - 1, -1, -1):
        if pieces.length[k] >= length:
            weight += pieces.weight[k] * length
            break
        weight += pieces.weight[k] * pieces.length[k] + pieces.load[k]
        length -= pieces.length[k]
    return weight
