"""The vertical force at the fairlead that lifts it to a given height."""

from __future__ import annotations

import math

from catopt.catenary.pieces import Pieces, total_length, total_weight
from catopt.catenary.walk import drop

__all__ = ["grounded_guess", "suspended_guess", "vertical_force"]


def vertical_force(
    H: float, height: float, pieces: Pieces, touchdown: int, guess: float, low: float
) -> float:
    """Vertical force at the fairlead that lifts it to `height` above the end of the walk.

    Newton's method on a rising function, kept inside a bracket that every evaluation narrows.

    Parameters
    ----------
    H, height, pieces, touchdown
        As for `walk.drop`.
    guess, low : float
        Where to start, and a lower bound; N.

    Returns
    -------
    float
        N; nan when it does not converge.
    """
    scale = max(total_length(pieces), abs(height))
    high = math.inf
    stride = H + abs(guess)
    V = guess
    for _ in range(200):
        z, z_V = drop(H, V, pieces, touchdown)
        error = z - height
        if abs(error) <= 2e-16 * scale:
            return V
        if error > 0.0:
            high = min(high, V)
        else:
            low = max(low, V)
        new = V - error / z_V if z_V > 0.0 else math.inf
        if abs(new - V) <= 2.3e-16 * max(abs(V), H) or not low < high:
            # The last digit of V is reached: what its rounding leaves of the height decides.
            return V if abs(error) <= 1e-10 * scale else math.nan
        if not low < new < high:
            if math.isinf(low) or math.isinf(high):
                new = V - math.copysign(stride, error)
                stride *= 4.0
                new = max(new, low)
            else:
                new = 0.5 * (low + high)
                if new in (low, high):
                    return V if abs(error) <= 1e-10 * scale else math.nan
        V = new
    return math.nan


def grounded_guess(H: float, pieces: Pieces, rise: float) -> float:
    """V at the fairlead of a uniform line of the same mean weight, touchdown or not."""
    weight = total_weight(pieces)
    lifted = max(weight / total_length(pieces) * rise, 0.0)
    V = math.sqrt(lifted * (lifted + 2.0 * H))
    return V if V < weight else suspended_guess(H, pieces, rise)


def suspended_guess(H: float, pieces: Pieces, rise: float) -> float:
    """V at the fairlead of a hanging line whose mean direction is that of its chord."""
    slope = max(-0.999, min(0.999, rise / total_length(pieces)))
    return H * slope / math.sqrt(1.0 - slope * slope) + 0.5 * total_weight(pieces)
