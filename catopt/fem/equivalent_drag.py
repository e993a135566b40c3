"""A linear force in the place of drag |r| r, for a velocity that is normally distributed.

With the mean m and the covariance S of r, the matrix D = E[|r| I + r r'/|r|] leaves the least mean
square error in |r| r - E[|r| r] - D (r - m). That line alone has too little force: of a velocity
without mean along one axis its variance is 8/(3 pi) of that of the drag, by which tensions come out
7 % too small. D is therefore raised until D (r - m) has the variance of the drag.
"""

from __future__ import annotations

import math
from typing import Any, Final

import numpy as np

from catopt.arrays import Array
from catopt.compiled import compiled

_REACH: Final = 6.0
"""Standard deviations to which the largest velocity is integrated over."""
_CELLS: Final = 96
"""Parts of that way either side together: |r| has a kink, which no rule of high order likes."""
_NODES: Final = 12
"""Nodes of Gauss's rule over the smaller ones."""
_FLAT: Final = 1e-3
"""Part of the largest deviation below which a smaller one is none."""
_AN_AXIS: Final = 1e-4
"""Time that one velocity takes as plain Python, s."""


def equivalent_drag(mean: Array, covariance: Array) -> Array:
    """Linear drag D, (n, 3, 3), m/s, in the place of |r| r: D (r - mean) about its mean.

    `mean` (n, 3), m/s, and `covariance` (n, 3, 3), (m/s)2, of the velocity r.
    """
    squares, axes = np.linalg.eigh(covariance)
    # The largest first.
    spread, axes = np.sqrt(np.maximum(squares[:, ::-1], 0.0)), axes[:, :, ::-1]
    along = np.einsum("nij,ni->nj", axes, mean)
    width = 2.0 * _REACH / _CELLS
    wide = -_REACH + width * (np.arange(_CELLS) + 0.5)
    parts = np.exp(-0.5 * wide**2)
    nodes, weights = np.polynomial.hermite_e.hermegauss(_NODES)
    rules = wide, parts / parts.sum(), nodes, weights / weights.sum()
    found = np.zeros((len(mean), 3, 3))
    compiled(fill_equivalents, _AN_AXIS * len(mean) * _CELLS)(along, spread, *rules, found)
    matrices: Array = np.einsum("nij,njk,nlk->nil", axes, found, axes)
    return matrices


def fill_equivalents(
    mean: Any, spread: Any, wide: Any, parts: Any, nodes: Any, weights: Any, to: Any
) -> None:
    """Write the matrices in their principal axes; `spread` (n, 3): standard deviations, falling."""
    for n in range(mean.shape[0]):
        least = _FLAT * spread[n, 0]
        second = nodes.shape[0] if spread[n, 1] > least else 1
        third = nodes.shape[0] if spread[n, 2] > least else 1
        first = wide.shape[0] if spread[n, 0] > 0.0 else 1
        xx = yy = zz = xy = xz = yz = fx = fy = fz = square = 0.0
        for i in range(first):
            x, own = mean[n, 0], 1.0
            if first > 1:
                x, own = x + spread[n, 0] * wide[i], parts[i]
            for j in range(second):
                y, both = mean[n, 1], own
                if second > 1:
                    y, both = y + spread[n, 1] * nodes[j], own * weights[j]
                for k in range(third):
                    z, w = mean[n, 2], both
                    if third > 1:
                        z, w = z + spread[n, 2] * nodes[k], both * weights[k]
                    size = math.sqrt(x * x + y * y + z * z)
                    over = w / size if size > 0.0 else 0.0
                    xx += w * size + over * x * x
                    yy += w * size + over * y * y
                    zz += w * size + over * z * z
                    xy += over * x * y
                    xz += over * x * z
                    yz += over * y * z
                    fx += w * size * x
                    fy += w * size * y
                    fz += w * size * z
                    square += w * size * size * (x * x + y * y + z * z)
        variance = square - fx * fx - fy * fy - fz * fz
        a, b, c = spread[n, 0] ** 2, spread[n, 1] ** 2, spread[n, 2] ** 2
        linear = a * (xx * xx + xy * xy + xz * xz) + b * (xy * xy + yy * yy + yz * yz)
        linear += c * (xz * xz + yz * yz + zz * zz)
        raised = math.sqrt(variance / linear) if variance > 0.0 and linear > 0.0 else 1.0
        to[n, 0, 0], to[n, 1, 1], to[n, 2, 2] = raised * xx, raised * yy, raised * zz
        to[n, 0, 1] = to[n, 1, 0] = raised * xy
        to[n, 0, 2] = to[n, 2, 0] = raised * xz
        to[n, 1, 2] = to[n, 2, 1] = raised * yz
