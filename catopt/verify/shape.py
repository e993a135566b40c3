"""How far the truss's nodes are from the closed form's line."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from catopt.catenary.layout import end_of, tension_at
from catopt.catenary.solution import Solution
from catopt.fem import TrussSolution
from catopt.verify.compared import ORDER

Array = npt.NDArray[np.float64]

_AT_JOINT = 1e-12
"""How far below a joint, over the line's length, a place counts as above it."""


def closed_form_at(closed: Solution, arc: Sequence[float] | Array) -> Array:
    """Place and tension of points of the closed form's line.

    `arc` (points,): unstretched arc lengths from the anchor, m. Returns: x and z, m, and tension,
    N. At a joint those of its upper side, shape (points, 3).
    """
    stretches = [stretch for stretch in closed.stretches if stretch.length > 0.0]
    starts = [stretch.start for stretch in stretches]
    found = np.empty((len(arc), 3))
    for index, s in enumerate(arc):
        above = bisect_right(starts, float(s) + _AT_JOINT * closed.line.length)
        stretch = stretches[max(above - 1, 0)]
        local = min(max(float(s) - stretch.start, 0.0), stretch.length)
        found[index, :2] = end_of(stretch, local)
        found[index, 2] = tension_at(stretch, local)
    return found


def flat(truss: TrussSolution) -> Array:
    """Nodes in the line's own plane: horizontal distance from the anchor and height, m."""
    away = truss.nodes[:, :2] - truss.nodes[0, :2]
    return np.column_stack([np.hypot(away[:, 0], away[:, 1]), truss.nodes[:, 2]])


def largest_distances(
    closed: Solution, trusses: Sequence[TrussSolution]
) -> tuple[tuple[float, ...], float]:
    """Largest distance between a node and the closed form's point of the same arc length.

    This is not less than the distance of the node from the curve. It is taken at the nodes of the
    coarsest mesh, which all meshes share.

    Returns: on each mesh, and with the nodes themselves extrapolated; m.
    """
    exact = closed_form_at(closed, trusses[0].arc)[:, :2]
    shapes = [flat(truss)[:: 2**k] for k, truss in enumerate(trusses)]
    if len(shapes) > 1:
        shapes.append(shapes[-1] + (shapes[-1] - shapes[-2]) / (2.0**ORDER - 1.0))
    *found, limit = [float(np.linalg.norm(s - exact, axis=1).max()) for s in shapes]
    return (tuple(found), limit) if len(trusses) > 1 else ((limit,), limit)
