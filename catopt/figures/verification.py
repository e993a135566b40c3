"""A line by both models: shapes, tensions, and what is between them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Literal

from catopt.figures.chart import Area, Axis, Chart, Series, axis, span_of
from catopt.quantities import Quantity
from catopt.words import Message

if TYPE_CHECKING:
    from catopt.verify.result import LinePair

_MARKERS = 40
"""How many nodes of a mesh are drawn, so that the line below them stays in sight."""
_DECADES = 1e-5
"""Lower end of a logarithmic axis, over the largest value on it."""
_DISTANCE = Quantity("distance", "Distance", "", "m", "mm", 1e-3, 3, "scientific")
_FORCE = Quantity("force", "Difference", "", "N", "N", 1.0, 3, "scientific")
_MESHES = ("third", "first", "second")
"""Role of each mesh, from the coarsest."""


def comparison(pair: LinePair) -> tuple[Chart, Chart, Chart, Chart]:
    """Draw shape and tension by both models, and the differences of both for each mesh."""
    gaps = pair.gaps()
    distances = [(each.arc.tolist(), each.distance.tolist()) for each in gaps]
    differences = [(each.middles.tolist(), each.tension.tolist()) for each in gaps]
    return (
        _shapes(pair),
        _tensions(pair),
        _differences("distance", _DISTANCE, distances, pair),
        _differences("difference", _FORCE, differences, pair),
    )


def _shapes(pair: LinePair) -> Chart:
    profile = pair.closed.profile(401)
    nodes = pair.finest_shape()
    x, z = nodes[:, 0].tolist(), nodes[:, 1].tolist()
    low, high = span_of([*z, *profile.z])
    bed = (Area("bed", (low,), (0.0,)),) if low < 0.0 <= high and min(z) <= -low else ()
    return Chart(
        "shapes",
        Message("figures.shapes"),
        axis("x", span_of([*x, *profile.x], 0.02, 0.02)),
        axis("z", (low, high)),
        series=(_closed(profile.x, profile.z), _truss(x, z)),
        areas=bed,
    )


def _closed(x: Sequence[float], y: Sequence[float]) -> Series:
    return Series("mooring", x, y, Message("figures.by_closed_form"))


def _truss(x: Sequence[float], y: Sequence[float]) -> Series:
    step = max(1, len(x) // _MARKERS)
    return Series("nodes", x[::step], y[::step], Message("figures.by_truss"))


def _tensions(pair: LinePair) -> Chart:
    profile, finest = pair.closed.profile(401), pair.finest
    middles = (0.5 * (finest.arc[1:] + finest.arc[:-1])).tolist()
    tensions = finest.tension.tolist()
    return Chart(
        "tensions",
        Message("figures.tensions"),
        axis("s", (0.0, pair.closed.line.length)),
        axis("tension", span_of([*tensions, *profile.tension])),
        series=(_closed(profile.s, profile.tension), _truss(middles, tensions)),
    )


def _differences(
    name: Literal["distance", "difference"],
    quantity: Quantity,
    found: Sequence[tuple[Sequence[float], Sequence[float]]],
    pair: LinePair,
) -> Chart:
    """Draw over the arc length how far something is off, for each mesh; an exact 0 is a gap."""
    top = max(max(values) for _, values in found) or 1.0
    bars = pair.trusses[0].mesh.elements
    return Chart(
        name,
        Message(f"figures.{name}"),
        axis("s", (0.0, pair.closed.line.length)),
        Axis(Message(f"figures.{name}_axis"), quantity, _DECADES * top, 3.0 * top, foot=0.0),
        series=tuple(
            Series(
                _MESHES[number % len(_MESHES)],
                s,
                [value if value > _DECADES * top else math.nan for value in values],
                Message("figures.bars", number=bars * 2**number),
            )
            for number, (s, values) in enumerate(found)
        ),
    )
