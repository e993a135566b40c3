"""The vertical force at the fairlead that lifts it to a given height."""

from __future__ import annotations

import math

from catopt.catenary.pieces import Pieces, total_length, total_weight
from catopt.catenary.walk import drop

__all__ = ["SETTLED", "grounded_guess", "suspended_guess", "top_weight", "vertical_force"]

SETTLED = 1e-8
"""A Newton step this small, relatively, leaves its square: less than the last digit."""


def vertical_force(
    H: float,
    height: float,
    pieces: Pieces,
    touchdown: int,
    guess: float,
    low: float,
    last_step: float,
) -> float:
    """Vertical force at the fairlead that lifts it to `height` above the end of the walk.

    Newton's method on a rising function, kept inside a bracket that every evaluation narrows.

    Parameters
    ----------
    H, height, pieces, touchdown
        As for `walk.drop`.
    guess, low : float
        Where to start, and a lower bound; N.
    last_step : float
        Relative size of a Newton step after which no other is taken: 0 to go on to the last
        digit, or SETTLED where the caller looks at what is left of the height.

    Returns
    -------
    float
        N; nan when it does not converge.
    """
    scale = max(total_length(pieces), abs(height))
    high = math.inf
    stride = H + abs(guess)
    last_error = math.inf
    V = guess
    for _ in range(200):
        z, z_V = drop(H, V, pieces, touchdown)
        error = z - height
        is_slow = abs(error) > 0.5 * last_error
        if abs(error) <= 2e-16 * scale or (is_slow and abs(error) <= 1e-12 * scale):
            return V
        last_error = abs(error)
        if error > 0.0:
            high = min(high, V)
        else:
            low = max(low, V)
        new = V - error / z_V if z_V > 0.0 else math.inf
        step = abs(new - V)
        if step <= last_step * abs(V) and low < new < high:
            return new
        if step <= 2.3e-16 * max(abs(V), H) or not low < high:
            # The last digit of V is reached: what its rounding leaves of the height decides.
            return V if abs(error) <= 1e-10 * scale else math.nan
        if is_slow or not low < new < high:
            if math.isinf(low) or math.isinf(high):
                new = max(V - math.copysign(stride, error), low)
                stride *= 4.0
            else:
                new = 0.5 * (low + high)
                if new in (low, high):
                    return V if abs(error) <= 1e-10 * scale else math.nan
        V = new
    return math.nan


def grounded_guess(H: float, pieces: Pieces, rise: float) -> float:
    """V at the fairlead of a uniform line as heavy as the part that hangs, touchdown or not."""
    length = total_length(pieces)
    hanging = length
    V = 0.0
    for _ in range(2):
        lifted = max(top_weight(pieces, hanging) / hanging * rise, 0.0)
        V = math.sqrt(lifted * (lifted + 2.0 * H))
        if lifted == 0.0:
            break
        hanging = min(V * rise / lifted, length)
    return V if V < total_weight(pieces) else suspended_guess(H, pieces, rise)


def suspended_guess(H: float, pieces: Pieces, rise: float) -> float:
    """V at the fairlead of a hanging line whose mean direction is that of its chord."""
    slope = max(-0.999, min(0.999, rise / total_length(pieces)))
    return H * slope / math.sqrt(1.0 - slope * slope) + 0.5 * total_weight(pieces)


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
