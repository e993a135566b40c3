"""Reach of a hanging piece by quadrature of its differential equations; nothing of the kernel.

    dx/ds = H/T + c H,    dz/ds = V/T + c V,    dV/ds = w,    T = hypot(H, V)

Gauss-Legendre of 16 points on panels whose edges lie where |V| is 0, H, 4 H, 16 H, ...: on each
of them the integrands are analytic within an ellipse that leaves an error below 1e-16 of a panel.
"""

from __future__ import annotations

import hashlib
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple, TypeVar

import numba
import numpy as np

NODES, WEIGHTS = np.polynomial.legendre.leggauss(16)

F = TypeVar("F", bound=Callable[..., Any])

_SOURCES = b"".join(Path(__file__).with_name(n).read_bytes() for n in ("quadrature.py", "walks.py"))


def fast(function: F) -> F:
    """Compile a function and keep the machine code.

    Numba looks only at a function's own file to see whether what it kept is out of date; a digest
    of the compiled files in the name makes it look at both.
    """
    function.__qualname__ += "_" + hashlib.sha256(_SOURCES).hexdigest()[:12]
    compiled: F = numba.njit(function, cache=True, error_model="numpy")
    return compiled


class Reach(NamedTuple):
    """What a piece contributes, from its lower-s to its upper-s end.

    Attributes
    ----------
    x, z, low : float
        Reach, and the lowest place above the lower-s end, m (at most 0).
    x_H, x_V, z_V : float
        Derivatives by H and by V (the same all along the piece), m/N; z_H = x_V.
    doubt : float
        How far the upper end moves when the forces are off by `error`, m: the integral of
        min(2, error/T) + c error.
    """

    x: float
    z: float
    low: float
    x_H: float
    x_V: float
    z_V: float
    doubt: float


@fast
def hanging(H: float, V: float, w: float, c: float, length: float, error: float) -> Reach:
    """Reach of a piece under horizontal force.

    Parameters
    ----------
    H, V : float
        Forces on the lower-s end, N; H above 0.
    w, c, length : float
        N/m, 1/N, m.
    error : float
        By how much the forces may be off, N.
    """
    sign = 1.0 if w >= 0.0 else -1.0
    start, end = sign * V, sign * (V + w * length)
    level = _level(start, H)
    last = _level(end, H)
    x, z, low, x_H, x_V, z_V, doubt = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    a = 0.0
    while a < length:
        b = length
        if level < last:
            level += 1
            b = min(max((_edge(level, H) - start) / abs(w), a), length)
        half = 0.5 * (b - a)
        for i in range(len(NODES)):
            v = V + w * (a + half * (1.0 + NODES[i]))
            T = math.sqrt(H * H + v * v)
            ds = half * WEIGHTS[i]
            x += ds * (H / T + c * H)
            z += ds * (v / T + c * v)
            x_H += ds * ((v / T) * (v / T) / T + c)
            x_V -= ds * (H / T) * (v / T) / T
            z_V += ds * ((H / T) * (H / T) / T + c)
            doubt += ds * (min(2.0, error / T) + c * error)
        low = min(low, z)
        a = b
        if level >= last and b == length:
            break
    return Reach(x, z, low, x_H, x_V, z_V, doubt)


@fast
def _edge(level: int, H: float) -> float:
    """Value of V on the edge between panels, N."""
    if level == 0:
        return 0.0
    return math.copysign(H * 4.0 ** (abs(level) - 1), level)


@fast
def _level(V: float, H: float) -> int:
    """Return the number of the last edge that is not above V."""
    if abs(V) < H:
        return 0 if V >= 0.0 else -1
    level = math.floor(math.log(abs(V) / H) / math.log(4.0)) + 1
    return level if V > 0.0 else -level - 1


@fast
def upright(V: float, w: float, c: float, length: float, error: float) -> Reach:
    """Reach of a piece without horizontal force: straight up where V > 0, down where V < 0."""
    middle = min(max(-V / w, 0.0), length) if w != 0.0 else 0.0
    turns = V * (V + w * length) <= 0.0 or min(abs(V), abs(V + w * length)) <= error
    low = 0.0
    z = 0.0
    for part in (middle, length - middle):
        mean = V + 0.5 * w * part
        direction = 1.0 if mean > 0.0 else (-1.0 if mean < 0.0 else 0.0)
        z += part * (direction + c * mean)
        low = min(low, z)
        V += w * part
    doubt = c * error * length
    z_V = c * length
    if w != 0.0:
        # V is now that of the upper end.
        start = V - w * length
        far = _turned_by(V, error) - math.copysign(1.0, V * start) * _turned_by(start, error)
        doubt += min(abs(far) / abs(w), 2.0 * length)
        if turns:
            # The limit of the integral of H^2/T^3 over what is next to V = 0.
            z_V += 1.0 / abs(w)
    elif abs(V) > 0.0:
        doubt += min(2.0, error / abs(V)) * length
    else:
        doubt += 2.0 * length
    return Reach(0.0, z, low, 0.0, 0.0, z_V, doubt)


@fast
def _turned_by(V: float, error: float) -> float:
    """Integral of min(2, error/v) over v from 0 to |V|, N."""
    flat = 0.5 * error
    if abs(V) <= flat or flat == 0.0:
        return 2.0 * min(abs(V), flat)
    return error * (1.0 + math.log(abs(V) / flat))
