"""A hull by itself in the sea, let go, pushed or in waves; and in how many ways it moves."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from catopt.arrays import Array, Flags
from catopt.compiled import compiled
from catopt.errors import NotConvergedError
from catopt.fem.afloat import Afloat, hull_kinetic_energy, run_hull, start_hull
from catopt.fem.moving import BodyNode
from catopt.fem.run_settings import TimeStepping
from catopt.fem.solve import Leg
from catopt.floater.scene import Scene
from catopt.hydro.build import ALONG, SteppedHull, record_of, room_of, state_of
from catopt.hydro.hull import PARTS
from catopt.waves import Sea
from catopt.words import Message

_SAME_PLACE: Final = 1e-6
"""Part of the anchors' radius within which places mirror each other."""


def freedoms(
    hull: SteppedHull, legs: Sequence[Leg], sea: Sea, lost: int | None = None
) -> tuple[bool, ...]:
    """Say which freedoms a hull has: all six, or those of the plane of x and z.

    Weather along x, and lines that x mirrors, leave it in that plane; `lost`: a line, from 0, that
    parts, without which they are to do so, too. Nothing turns a body of revolution about its axis
    but lines that are fast to it away from that.
    """
    across = waves_across(sea) or current_across(sea)
    lines = unmirrored(hull, legs) or (lost is not None and unmirrored(hull, legs, lost))
    return hull.freedoms(in_plane=not (across or lines))


def waves_across(sea: Sea) -> bool:
    """Whether waves go in another direction than along x."""
    waves = sea.waves
    return waves is not None and float(np.abs(np.sin(waves.direction)).max()) > ALONG


def current_across(sea: Sea) -> bool:
    """Whether the current has a part across x."""
    flow = sea.flow
    sideways = (flow.current[:, 2], flow.power_currents[:, 1], flow.current_series[:, 2])
    return float(np.abs(np.concatenate(sideways)).max(initial=0.0)) > ALONG


def unmirrored(hull: SteppedHull, legs: Sequence[Leg], lost: int | None = None) -> tuple[int, ...]:
    """Which lines, from 0, have not as many mirrored by x as there are in their own place.

    `lost`: a line that does not count.
    """
    if not legs:
        return ()
    ends = [np.array([leg.anchor, eye]) for leg, eye in zip(legs, hull.eyes, strict=True)]
    near = _SAME_PLACE * max(float(np.abs(each).max()) for each in ends)

    def alike(number: int, side: float) -> int:
        """Count the lines of its kind in its place, or in that on the other side."""
        there = ends[number] * [1.0, side, 1.0]
        return sum(
            legs[k].line == legs[number].line and float(np.abs(ends[k] - there).max()) <= near
            for k in left
        )

    left = [k for k in range(len(legs)) if k != lost]
    return tuple(k for k in left if alike(k, 1.0) != alike(k, -1.0))


_A_SLICE: Final = 1e-5
"""Time that a slice takes in one step as plain Python, s; and so a wave."""


ROLL, PITCH = 3, 4
"""Columns of a hull's place, and rows of its extremes."""


@dataclass(frozen=True, eq=False)
class HullHistory:
    """How a hull moved.

    `time` (n,), s; `place` (n, 6): of its centre of gravity, x, y and height above still water, m,
    and roll, pitch, yaw, rad, as if it had been turned about its axis, then about x, then about y;
    `velocity` (n, 6); `free` (6,): in which it moves; `wet` (n,): volume under water, m3; `surface`
    (n,): elevation over it, m; `lines` (n, 6): force and moment of its lines with their inertia, N
    and N m; `extreme` (7, 2): least and largest of place and volume of every step; `works`: of
    weight and pressure, diffraction, the waves that it makes, drag, wind, linear damping and lines,
    J; `numerical_part`: energy that the steps lost or gained, over what was put in; `volume`: of
    all its slices, m3, 0 without any; `scene`: how it looked around its lines' largest tension;
    `mean` (7,): of place and volume over the samples that count, where these are no longer kept.
    """

    time: Array
    place: Array
    velocity: Array
    free: Flags
    wet: Array
    surface: Array
    lines: Array
    extreme: Array
    works: Array
    numerical_part: float
    volume: float
    scene: Scene | None = None
    mean: Array | None = None

    def mean_heel(self, counted: Flags) -> float:
        """Heel of its mean place, rad; `counted` (n,): samples that count."""
        mean = self.place[counted].mean(axis=0) if self.mean is None else self.mean
        return math.acos(min(1.0, math.cos(mean[ROLL]) * math.cos(mean[PITCH])))


def history_of(body: Afloat, time: Array, depth: float, volume: float) -> HullHistory:
    """Take out of a hull that was stepped from rest what is kept of it."""
    record = body.record
    gained = hull_kinetic_energy(body.hull, body.before)
    off = abs(float(record.works[: PARTS + 1].sum()) - gained)
    put_in = float(record.works[PARTS + 1])
    level = np.array([0.0, 0.0, depth, 0.0, 0.0, 0.0])
    return HullHistory(
        time,
        record.q - level,
        record.v,
        body.hull.free > 0.0,
        record.wet,
        record.surface,
        record.line,
        record.extreme - np.append(level, 0.0)[:, np.newaxis],
        record.works[: PARTS + 1].copy(),
        off / put_in if put_in > 0.0 else 0.0,
        volume,
    )


def run_alone(
    hull: SteppedHull,
    stepping: TimeStepping,
    *,
    sea: Sea,
    offset: tuple[float, float, float] = (0.0, 0.0, 0.0),
) -> HullHistory:
    """Let a hull go from an offset to its place at rest, and step it in time.

    Parameters
    ----------
    hull : SteppedHull
        At its draught at rest.
    stepping : TimeStepping
        Steps all as long as its `step`; samples at its output interval.
    sea : Sea
        Waves without a ramp take that of `stepping`.
    offset : tuple of float
        Surge and heave, m, and pitch, rad, at first.

    Raises
    ------
    NotConvergedError
        When a step does not close.
    """
    flow = sea.flow
    laid = hull.lay_out(flow, freedoms(hull, (), sea))
    x, z, turn = offset
    height = flow.depth + hull.level
    samples, every = stepping.samples, stepping.every
    none = np.zeros(3)
    body = Afloat(
        laid,
        state_of(laid, (x, 0.0, height + z), turn),
        state_of(laid, (x, 0.0, height + z), turn),
        room_of(laid),
        record_of(samples + 1),
        BodyNode(none, none, none),
    )
    rules = stepping.rules()._replace(halvings=0, refinements=0)
    start_hull(0.0, flow, body)
    work = _A_SLICE * (laid.foot.size * (3 + flow.waves.shape[0])) * samples * every
    done, _ = compiled(run_hull, work)(samples, every, rules, flow, body)
    if done < samples:
        reached = done * every * stepping.step
        raise NotConvergedError(Message("truss.not_closed", time=reached))
    time = np.asarray(every * float(stepping.step) * np.arange(samples + 1.0))
    return history_of(body, time, flow.depth, hull.volume_of_all)
