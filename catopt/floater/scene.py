"""How buoy, line and water looked around the largest tension of a run, for pictures and film."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from catopt.arrays import Array
from catopt.fem.history import History
from catopt.fem.mesh import LineMesh
from catopt.hydro.build import FloatingHull
from catopt.waves.sea import Sea

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
    """Moments around the largest tension at the fairlead; x from the anchor, z above the bed, m.

    `time` (n,), s; `line` (n, nodes, 2): x and z from the anchor up; `place` (n, 3): x and z of the
    hull's centre of gravity, and pitch, rad; `tension` (n,): at the fairlead, N; `x` (m,),
    `surface` (n, m): of the water, above the bed; `outline` (k, 2): of the hull about its centre of
    gravity; `worst`: which moment has the largest tension.
    """

    time: Array
    line: Array
    place: Array
    tension: Array
    x: Array
    surface: Array
    outline: Array
    worst: int

    def hull(self, moment: int) -> Array:
        """Outline of the hull at a moment, (k, 2)."""
        x, z, pitch = self.place[moment]
        sine, cosine = np.sin(pitch), np.cos(pitch)
        across, along = self.outline.T
        turned = np.column_stack([across * cosine + along * sine, along * cosine - across * sine])
        place: Array = turned + np.array([x, z])
        return place


def kept_nodes(mesh: LineMesh) -> tuple[int, ...]:
    """Choose the nodes whose places a run keeps for its scene."""
    count = min(_NODES, mesh.elements + 1)
    return tuple(np.unique(np.linspace(0, mesh.elements, count).round().astype(int)).tolist())


def scene_of(history: History, places: Array, hull: FloatingHull, sea: Sea) -> Scene:
    """Take the scene out of a run that kept `kept_nodes`; `places` as of `HullHistory.place`."""
    counted = np.flatnonzero(history.counted) if history.counts else np.arange(history.time.size)
    tension = history.fairlead_tension[:, 0]
    peak = int(counted[tension[counted].argmax()])
    near = np.flatnonzero(np.abs(history.time - history.time[peak]) <= _AROUND)
    chosen = np.unique(np.append(near[:: max(1, -(-near.size // _MOMENTS))], peak))
    time, line = history.time[chosen], history.nodes[chosen][:, :, [0, 2]]
    place = places[chosen][:, [0, 2, 4]] + [0.0, sea.depth, 0.0]
    widest = float(hull.radius.max())
    least = min(0.0, float(line[:, :, 0].min()), float(place[:, 0].min()) - widest)
    most = max(float(line[:, :, 0].max()), float(place[:, 0].max()) + widest)
    room = _BEYOND * (most - least)
    x = np.linspace(least - room, most + room, _PLACES)
    surface = sea.depth + sea.elevation(time[:, np.newaxis], x[np.newaxis, :])
    heights = np.column_stack([hull.foot, hull.top]).ravel() - hull.centre
    radius = np.repeat(hull.radius, 2)
    right, left = np.column_stack([radius, heights]), np.column_stack([-radius, heights])
    outline = np.concatenate([right, left[::-1]])
    return Scene(
        time, line, place, tension[chosen], x, surface, outline, int(np.searchsorted(chosen, peak))
    )
