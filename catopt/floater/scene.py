"""How buoy, lines and water looked around the largest tension of a run, for pictures and film.

All is seen from the side, on the upright plane through x, or where the buoy does not stay in that,
through the line with the largest tension.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import numpy as np

from catopt.arrays import Array
from catopt.fem.history import History
from catopt.fem.mesh import LineMesh
from catopt.waves.sea import Sea

if TYPE_CHECKING:
    from catopt.floater.alone import HullHistory

_AROUND: Final = 30.0
"""s before and after the largest tension."""
_MOMENTS: Final = 300
"""At most."""
_NODES: Final = 33
"""Of the line, at most."""
_PLACES: Final = 49
"""Of the surface."""
_BEYOND: Final = 0.1
"""How far beyond what is drawn the surface goes, over its breadth."""


@dataclass(frozen=True, eq=False)
class Scene:
    """Moments around the largest tension at a fairlead; x on the plane, z above the bed, m.

    `time` (n,), s; `lines`, each (n, nodes, 2): x and z from the anchor up; `loaded`: which has the
    largest tension; `place` (n, 3): x and z of the hull's centre of gravity, and how it leans on
    the plane, rad; `tension` (n,): at the fairlead of that line, N; `x` (m,), `surface` (n, m): of
    the water, above the bed; `outline` (k, 2): of the hull about its centre of gravity; `worst`:
    which moment has the largest tension; `towards`: direction of x on the plane, rad.
    """

    time: Array
    lines: tuple[Array, ...]
    loaded: int
    place: Array
    tension: Array
    x: Array
    surface: Array
    outline: Array
    worst: int
    towards: float

    def hull(self, moment: int) -> Array:
        """Outline of the hull at a moment, (k, 2)."""
        x, z, pitch = self.place[moment]
        sine, cosine = np.sin(pitch), np.cos(pitch)
        across, along = self.outline.T
        turned = np.column_stack([across * cosine + along * sine, along * cosine - across * sine])
        return np.asarray(turned + np.array([x, z]))


def kept_nodes(meshes: Sequence[LineMesh]) -> tuple[tuple[int, ...], ...]:
    """Choose the nodes of each line, counted over all, whose places a run keeps for its scene."""
    most, kept, start = _NODES if len(meshes) == 1 else _NODES // 2, [], 0
    for mesh in meshes:
        count = min(most, mesh.elements + 1)
        at = start + np.linspace(0, mesh.elements, count).round().astype(int)
        kept.append(tuple(np.unique(at).tolist()))
        start += mesh.elements + 1
    return tuple(kept)


def scene_of(
    history: History, kept: Sequence[Sequence[int]], body: HullHistory, outline: Array, sea: Sea
) -> Scene:
    """Take the scene out of a run that kept the nodes of `kept_nodes`; `outline`: as of it."""
    counted = np.flatnonzero(history.counted) if history.counts else np.arange(history.time.size)
    row, loaded = divmod(int(history.fairlead_tension[counted].argmax()), len(kept))
    peak = int(counted[row])
    near = np.flatnonzero(np.abs(history.time - history.time[peak]) <= _AROUND)
    chosen = np.unique(np.append(near[:: max(1, -(-near.size // _MOMENTS))], peak))
    time, nodes = history.time[chosen], history.nodes[chosen]
    ends = np.cumsum([len(each) for each in kept])
    towards = 0.0
    if body.free[1]:
        last = nodes[int(np.searchsorted(chosen, peak)), ends[loaded] - 1]
        away = last - history.nodes[peak, ends[loaded] - len(kept[loaded])]
        towards = math.atan2(away[1], away[0])
    ahead, aside = math.cos(towards), math.sin(towards)
    flat = np.stack([nodes[:, :, 0] * ahead + nodes[:, :, 1] * aside, nodes[:, :, 2]], axis=2)
    lines = tuple(np.split(flat, ends[:-1], axis=1))
    x_0, y_0, z_0, roll, pitch, _ = body.place[chosen].T
    leans = np.cos(roll) * np.sin(pitch) * ahead - np.sin(roll) * aside
    lean = np.arctan2(leans, np.cos(roll) * np.cos(pitch))
    place = np.stack([x_0 * ahead + y_0 * aside, z_0 + sea.depth, lean], axis=1)
    off = float(np.mean(y_0 * ahead - x_0 * aside))  # of the hull across the plane

    widest = float(outline[:, 0].max())
    ways = np.concatenate([flat[:, :, 0].ravel(), place[:, 0] - widest, place[:, 0] + widest])
    least, most = float(ways.min()), float(ways.max())
    room = _BEYOND * (most - least)
    x = np.linspace(least - room, most + room, _PLACES)
    at = x[np.newaxis, :] * ahead - off * aside, x[np.newaxis, :] * aside + off * ahead
    surface = sea.depth + sea.elevation(time[:, np.newaxis], *at)
    tension, worst = history.fairlead_tension[chosen, loaded], int(np.searchsorted(chosen, peak))
    return Scene(time, lines, loaded, place, tension, x, surface, outline, worst, towards)
