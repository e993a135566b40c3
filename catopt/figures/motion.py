"""The truss model drawn: beside the closed form at rest, and lines in motion."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Literal

import numpy as np

from catopt.arrays import Array
from catopt.figures.chart import (
    Area,
    Axis,
    Chart,
    Film,
    Level,
    Mark,
    Point,
    Series,
    axis,
    pointed,
    span_of,
)
from catopt.figures.line import capacities, room_around
from catopt.figures.mooring import from_above
from catopt.quantities import QUANTITIES, Quantity
from catopt.units import lasting
from catopt.words import Measure, Message

if TYPE_CHECKING:
    from catopt.catenary.solution import Solution
    from catopt.floater.scene import Scene
    from catopt.verify.dynamic_result import DynamicPart, DynamicVerification
    from catopt.verify.dynamic_run import DynamicRun
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


_TIME = Quantity("time", "Time", "t", "s", "s", 1.0, 2)
_FREQUENCY = Quantity("frequency", "Frequency", "f", "rad/s", "Hz", 2.0 * math.pi, 4)
_DENSITY = Quantity(
    "density", "Spectrum", "S", "N^2 s/rad", "kN²/Hz", 1e6 / (2.0 * math.pi), 3, "scientific"
)
_NUMBER = Quantity("number", "Number", "", "-", "-", 1.0, 2)
_CYCLES = 12.0
"""Cycles of the tension that are drawn around its largest value."""
_MOST = 600
"""Samples of a series that are drawn."""
_MOST_PEAKS = 300
"""Peaks that are drawn, from the highest down."""
_RARE = 0.1
"""Expected number down to which a tail is drawn."""
_FEW = 64
"""Samples below which there is no spectrum."""
_SHOWN = 0.999
"""Part of the energy up to which a spectrum is drawn."""
_TRACK = 2000
"""Samples of a track that are drawn."""


def around_the_largest(run: DynamicRun, most: int = _MOST) -> list[int]:
    """Choose the samples around the largest fairlead tension: a dozen cycles, the peak among them.

    Cycles are those between upward crossings of its mean; without any all samples are taken. Of too
    many, about `most` are left. Returns their indices, rising.
    """
    of = run.history
    found = run.statistics("fairlead_tension")
    counted = np.flatnonzero(run.counted)
    first, last = int(counted[0]), int(counted[-1])
    peak = first + int(abs(of.time[counted] - found.time_of_maximum).argmin())
    if found.peaks:
        half = 0.5 * _CYCLES * found.duration / found.peaks
        inside = np.flatnonzero(abs(of.time - of.time[peak]) <= half)
        first, last = max(first, int(inside[0])), min(last, int(inside[-1]))
    step = max(1, math.ceil((last - first + 1) / most))
    return sorted({*range(first, last + 1, step), peak, last})


def history(part: DynamicPart, at_rest: float) -> Chart:
    """Draw the fairlead tension of the governing run around its largest value.

    `at_rest` is the tension at the fairlead at rest, N.
    """
    run = part.governing
    of, chosen = run.history, around_the_largest(run)
    a, b = of.time[chosen[0]], of.time[chosen[-1]]
    tension = of.fairlead_tension[chosen, 0]
    at, drawn = _with_turns(run, "fairlead_tension", of.time[chosen], tension)
    inside = (at >= a) & (at <= b)
    times, tensions = at[inside].tolist(), drawn[inside].tolist()
    still = np.interp(times, of.time, run.quasi_static).tolist()
    largest = max(tensions)
    when = times[tensions.index(largest)]
    said = Message("figures.largest_at", T=Measure("tension", largest), t=when)
    rest = Message("figures.at_rest", T=Measure("tension", at_rest))
    up = Message("figures.fairlead_tension_axis")
    series = [Series("first", times, tensions, Message("figures.in_motion"))]
    if np.isfinite(still).any():
        series.insert(0, Series("second", times, still, Message("figures.quasi_static")))
    return Chart(
        "motion",
        Message("figures.history", T=Measure("tension", largest), t=when),
        Axis(Message("figures.time"), _TIME, times[0], times[-1]),
        axis("tension", _from_zero([*tensions, *still, at_rest]), up),
        series=tuple(series),
        marks=(Mark("reference", when, largest, said),),
        levels=(Level("rest", "y", at_rest, rest),),
        points=tuple(map(_said, times, tensions, still)),
        notes=(Message("figures.window", a=times[0], b=times[-1], **_run(part)),),
    )


def _with_turns(run: DynamicRun, quantity: str, time: Array, values: Array) -> tuple[Array, Array]:
    """Draw the turning points between the samples, too; those of a sample's time take its place."""
    course = run.history.course(quantity)
    every = np.concatenate([course.time, time])
    times, first = np.unique(every, return_index=True)
    return times, np.concatenate([course.value, values])[first]


def _run(part: DynamicPart) -> dict[str, int]:
    return {"run": part.governing.number + 1, "runs": len(part.runs)}


def _said(t: float, tension: float, still: float) -> Point:
    measures = {"T": Measure("tension", tension)}
    if math.isnan(still):
        return Point(t, tension, Message("figures.at_time", t=t, **measures))
    measures["still"] = Measure("tension", still)
    return Point(t, tension, Message("figures.at_time_still", t=t, **measures))


def _from_zero(tensions: Sequence[float]) -> tuple[float, float]:
    """Find ends of an axis that hold tensions and 0."""
    known = [each for each in tensions if math.isfinite(each)]
    return min(0.0, 1.08 * min(known)), 1.08 * max(known) or 1.0


def whole_history(part: DynamicPart) -> Chart:
    """Draw the tensions at both ends in the governing run from its start to its end."""
    run = part.governing
    of = run.history
    at_anchor = _with_turns(run, "anchor_tension", of.time, of.anchor_tension[:, 0])
    at_fairlead = _with_turns(run, "fairlead_tension", of.time, of.fairlead_tension[:, 0])
    ends = (
        ("faint", *at_anchor, "figures.at_anchor"),
        ("first", *at_fairlead, "figures.at_fairlead"),
        ("second", of.time, run.quasi_static, "figures.quasi_static"),
    )
    return Chart(
        "series",
        Message("figures.whole_history", **_run(part)),
        Axis(Message("figures.time"), _TIME, 0.0, float(of.time[-1])),
        axis("tension", span_of(value for _, _, values, _ in ends for value in values.tolist())),
        series=tuple(
            Series(role, times.tolist(), values.tolist(), Message(key))
            for role, times, values, key in ends
        ),
        levels=(Level("joint", "x", of.since, Message("figures.since")),),
    )


def spectrum(part: DynamicPart) -> Chart:
    """Draw the spectrum of the fairlead tension of the governing run."""
    run = part.governing
    omega, density = np.zeros(2), np.zeros(2)
    notes: tuple[str, ...] = (Message("figures.too_short"),)
    if run.counted.sum() >= _FEW:
        omega, density = run.tension_spectrum()
        energy = np.cumsum(density)
        last = int(np.searchsorted(energy, _SHOWN * energy[-1])) + 2
        omega, density, notes = omega[:last], density[:last], ()
    return Chart(
        "spectrum",
        Message("figures.spectrum"),
        Axis(Message("figures.frequency"), _FREQUENCY, 0.0, float(omega[-1]) or 1.0),
        Axis(Message("figures.density"), _DENSITY, 0.0, 1.08 * float(density.max()) or 1.0),
        series=(Series("first", omega.tolist(), density.tolist()),) if not notes else (),
        notes=notes,
    )


def envelope_chart(
    part: DynamicPart, at_rest: Solution | None = None, allowed: Sequence[float | None] = ()
) -> Chart:
    """Draw the largest and the smallest tension along the line.

    `allowed` is what its segments may carry, N; the line at rest is drawn beside where it is given.
    """
    found = part.envelope
    arc, high, low = (each.tolist() for each in (found.arc, found.largest, found.smallest))
    largest = max(high)
    series: list[Series] = []
    levels: list[Level] = []
    notes: list[str] = []
    step = max(1, math.ceil(len(arc) / _MOST))
    s, top, bottom = arc[::step], high[::step], low[::step]
    key, rests = "figures.from_to", {}
    if at_rest is not None:
        profile = at_rest.profile(161)
        levels, notes = capacities(at_rest, allowed, largest)
        series = [Series("third", profile.s, profile.tension, Message("figures.still"))]
        at = np.interp(s, profile.s, profile.tension).tolist()
        key, rests = "figures.from_to_still", {"still": ("tension", at)}
    tensions = [*high, *low, *(each.at for each in levels), *(T for one in series for T in one.y)]
    known = {"s": ("s", s), "low": ("tension", bottom), "high": ("tension", top)} | rests
    return Chart(
        "envelope",
        Message("figures.envelope", T=Measure("tension", largest)),
        axis("s", (0.0, part.own_line.length)),
        axis("tension", _from_zero(tensions)),
        series=(
            *series,
            Series("second", arc, low, Message("figures.smallest")),
            Series("first", arc, high, Message("figures.largest")),
        ),
        levels=tuple(levels),
        areas=(Area("between", low, high, arc),),
        points=pointed(key, s, top, **known),
        notes=tuple(notes),
    )


def peaks_above(part: DynamicPart) -> Chart | None:
    """Draw how many peaks of the fairlead tension are above each value, counted and by the tail.

    None where the tension has no tail.
    """
    tail = part.of("fairlead_tension").tail
    if tail is None:
        return None
    extreme, time = tail.extreme, lasting(tail.extreme.duration)
    peaks = list(tail.clusters[:_MOST_PEAKS])
    numbers = [k * extreme.duration / tail.time for k in range(1, len(peaks) + 1)]
    right = max(extreme.high, extreme.expected, tail.clusters[0])
    steps = np.linspace(tail.threshold, right, 101).tolist()
    fitted = [x for x in steps if tail.expected_above(x) >= _RARE]
    interval = Message(
        "figures.most_probable",
        T=Measure("tension", extreme.most_probable),
        low=Measure("tension", extreme.low),
        high=Measure("tension", extreme.high),
        confidence=extreme.confidence,
    )
    top = max(tail.expected_above(tail.threshold), numbers[-1])
    low = max(extreme.low, tail.threshold)
    ends = span_of((tail.threshold, right), 0.0, 0.02)
    counted = Message("figures.peaks_counted", count=len(peaks))
    by_tail = Message("figures.tail_fitted", shape=tail.shape)
    return Chart(
        "exceedance",
        Message("figures.exceedance", time=time),
        axis("tension", ends, Message("figures.fairlead_tension_axis")),
        Axis(Message("figures.peaks_above", time=time), _NUMBER, _RARE, 1.6 * top, foot=0.0),
        series=(Series("first", fitted, list(map(tail.expected_above, fitted)), by_tail),),
        marks=(
            *(Mark("peak", T, n, counted) for T, n in zip(peaks, numbers, strict=True)),
            Mark("probable", extreme.most_probable, 1.0),
        ),
        levels=(Level("interval", "y", 1.0, interval, low, extreme.high),),
        points=pointed(
            "figures.peak",
            peaks,
            numbers,
            T=("tension", peaks),
            number=("", numbers),
            time=("", [time] * len(peaks)),
        ),
    )


def on_slope(part: DynamicPart, depth: float, slope: float) -> Chart:
    """Draw a line at rest on a bed that slopes, to scale.

    `depth` is of the water at the anchor, m; `slope` of the bed, rad.
    """
    places = part.runs[0].history.at_rest
    x, z = places[:, 0].tolist(), places[:, 2].tolist()
    left, right = min(x), max(x)
    unit = room_around(right - left, max(depth, *z))
    ends = (left - 60.0 * unit, right + 60.0 * unit)
    bed = [each * math.tan(slope) for each in ends]
    low, top = min(*bed, *z) - 16.0 * unit, max(depth, *z)
    return Chart(
        "line",
        Message("figures.on_slope", angle=math.degrees(slope), span=Measure("span", x[-1])),
        axis("x", ends, within=(left, right)),
        axis("z", (low, top + 44.0 * unit), within=(min(0.0, *bed), top)),
        series=(
            Series("bed-edge", ends, bed, Message("figures.bed")),
            Series("mooring", x, z, Message("figures.mooring_line")),
        ),
        marks=(
            Mark("anchor", x[0], z[0], Message("figures.anchor")),
            Mark("fairlead", x[-1], z[-1], Message("figures.fairlead")),
        ),
        levels=(Level("surface", "y", depth, Message("figures.water_level")),),
        areas=(Area("water", bed, (depth, depth), ends), Area("bed", (low, low), bed, ends)),
        to_scale=1.0,
    )


def track(found: DynamicVerification) -> Chart:
    """Draw the way of the body's origin from above, to scale, and its place at rest."""
    way = found.governing.governing.track
    assert way is not None
    places = way[:: -(-way.shape[0] // _TRACK), :2].tolist()
    low, high = way[:, :2].min(axis=0), way[:, :2].max(axis=0)
    furthest = found.body[-1].maximum
    x, y = zip(*places, strict=True)
    corners = [tuple(low.tolist()), tuple(high.tolist())]
    room = 0.05 * max(float((high - low).max()), 1e-3)
    return Chart(
        "system_motion_track",
        Message("figures.track", way=Measure("offset", furthest)),
        *from_above(corners, room),
        series=(Series("first", x, y, Message("figures.way_of_body")),),
        marks=(Mark("reference", x[0], y[0], Message("figures.still")),),
        to_scale=1.0,
    )


_LEAST_SHARE = 0.34
"""Height over breadth of a drawing to scale."""
_BEFORE = (2.0, 1.0)
"""s before the worst moment at which the line is drawn, too."""


def worst_moment(scene: Scene) -> Chart:
    """Draw buoy, line and water at the largest tension, to scale, with the line just before."""
    k = scene.worst
    t, tension = float(scene.time[k]), float(scene.tension[k])
    loaded = scene.lines[scene.loaded]
    before = (loaded[int(np.abs(scene.time - (t - ago)).argmin())] for ago in _BEFORE)
    earlier = [_through("faint", each) for each in before]
    earlier[0] = earlier[0]._replace(label=Message("figures.line_before", longest=_BEFORE[0]))
    hull, x, surface = scene.hull(k), scene.x.tolist(), scene.surface[k].tolist()
    hull = np.concatenate([hull, hull[:1]])
    now = _through("mooring", loaded[k], Message("figures.mooring_line"))
    others = (each[k] for i, each in enumerate(scene.lines) if i != scene.loaded)
    # High enough for the words beside its axis.
    top = max(1.1 * max(*surface, float(hull[:, 1].max())), _LEAST_SHARE * (x[-1] - x[0]))
    foot = -0.06 * top
    return Chart(
        "moment",
        Message("figures.worst_moment", T=Measure("tension", tension), t=t),
        _level_axis(scene),
        axis("z", (foot, top)),
        series=(
            *earlier,
            *(_through("mooring", each) for each in others),
            now,
            Series("surface", x, surface, Message("figures.surface_then")),
            _through("first", hull, Message("figures.buoy_then")),
        ),
        areas=(Area("water", [0.0] * len(x), surface, x), Area("bed", (foot,), (0.0,))),
        levels=(Level("bed-edge", "y", 0.0, Message("figures.bed")),),
        to_scale=1.0,
    )


def _level_axis(scene: Scene) -> Axis:
    x = float(scene.x[0]), float(scene.x[-1])
    if len(scene.lines) == 1 and scene.towards == 0.0:
        return axis("x", x)
    said = Message("figures.along_the_plane", towards=math.degrees(scene.towards))
    return Axis(said, replace(QUANTITIES["x"], symbol=""), *x)


_CLEAR = 1.05
"""Room above the highest surface and hull, over their height."""


def film_of(scene: Scene) -> Film:
    """Make a film of buoy, line and water around the largest tension."""
    k, x = scene.worst, scene.x
    highest = max(float(scene.surface.max()), *(float(scene.hull(j)[:, 1].max()) for j in (0, k)))
    known = {"T": Measure("tension", float(scene.tension[k])), "t": float(scene.time[k])}
    title = Message("figures.film", seconds=float(scene.time[-1] - scene.time[0]), **known)
    values = {
        "time": scene.time.round(3).tolist(),
        "lines": [each.round(3).tolist() for each in scene.lines],
        "place": scene.place.round(4).tolist(),
        "tension": (scene.tension / 1e3).round(3).tolist(),
        "x": x.round(3).tolist(),
        "surface": scene.surface.round(3).tolist(),
        "outline": scene.outline.round(4).tolist(),
    }
    return Film(title, float(x[0]), float(x[-1] - x[0]), _CLEAR * highest, k, values)


def _through(role: str, places: Array, label: str = "") -> Series:
    """Draw a line through places, (n, 2)."""
    return Series(role, places[:, 0].tolist(), places[:, 1].tolist(), label)
