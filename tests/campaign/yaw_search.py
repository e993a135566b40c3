"""Headings at which a body rests, sought over all yaws at once: no step of the solver is used.

Each line is a table of horizontal force over span, made from `solve_many(horizontal_force=)`. At
each yaw the potential of the tables is convex in x and y and has one least place. The moment left
there over the yaw tells where the body rests: where it passes from above to below zero.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from catopt import Line, System, solve_many

__all__ = ["Headings", "stable_headings"]

Array = npt.NDArray[np.float64]

YAWS, CLOSER = 60, 9
FORCES = 160
STEPS, MOST_STEPS, HALVINGS = 100, 3000, 30
ENOUGH = 1e-7
HIGHEST = 60.0
"""Logarithm of the largest force (N) that a trial far off may ask of a table."""


@dataclass(frozen=True)
class Headings:
    """What the search found.

    Attributes
    ----------
    places : ndarray, shape (n, 3)
        x, y, yaw of each stable heading: m, m, rad, as exact as the tables.
    least, largest : float
        Of the moment left over all yaws, N m: both of one sign where the body turns over.
    scale : float
        Forces times arm, N m.
    unresolved : float
        Part of the yaws at which no place of rest was found.
    """

    places: Array
    least: float
    largest: float
    scale: float
    unresolved: float


class Tables:
    """Horizontal force over span of every line, and where its ends are."""

    def __init__(self, system: System) -> None:
        legs = system.legs
        self.anchors = np.array([leg.anchor for leg in legs])
        self.arms = np.array([leg.fairlead for leg in legs])
        known: dict[tuple[Line, float, float], tuple[Array, Array]] = {}
        for leg in legs:
            key = (leg.line, leg.fairlead_height, leg.anchor_height)
            if key not in known:
                known[key] = _table(*key, system)
        tables = [known[leg.line, leg.fairlead_height, leg.anchor_height] for leg in legs]
        self.spans = [table[0] for table in tables]
        self.small = 1e3 * min(math.exp(table[1][0]) for table in tables)
        self.logs = [table[1] for table in tables]

    def force(self, spans: Array) -> tuple[Array, Array]:
        """H and dH/dS of lines at spans of shape (yaws, lines); beyond the table, straight on."""
        H, slope = np.empty_like(spans), np.empty_like(spans)
        for k, (table, logs) in enumerate(zip(self.spans, self.logs, strict=True)):
            at = np.minimum(np.maximum(table.searchsorted(spans[:, k]), 1), len(table) - 1)
            steep = (logs[at] - logs[at - 1]) / (table[at] - table[at - 1])
            log = logs[at - 1] + steep * (spans[:, k] - table[at - 1])
            H[:, k] = np.exp(np.minimum(log, HIGHEST))
            slope[:, k] = steep * H[:, k]
        return H, slope


def _table(line: Line, height: float, anchor: float, system: System) -> tuple[Array, Array]:
    weight = sum(abs(s.length * s.submerged_weight) for s in line.segments)
    weight += sum(abs(load.submerged_weight) for load in line.point_loads)
    force = math.hypot(*system.force)
    arm = max((leg.fairlead_radius for leg in system.legs), default=0.0)
    most = 30.0 * (weight + force + (abs(system.moment) / arm if arm > 0.0 else 0.0))
    forces = np.geomspace(1e-5 * weight, most, FORCES)
    answers = solve_many(
        line,
        height=height,
        anchor_height=anchor,
        horizontal_force=forces,
        seabed_friction=system.seabed_friction,
    )
    good = answers.converged
    spans, logs = answers.span[good], np.log(forces[good])
    rising = np.concatenate([[True], spans[1:] > np.maximum.accumulate(spans)[:-1] + 1e-12])
    return spans[rising], logs[rising]


def stable_headings(system: System) -> Headings:
    """Search all yaws of a system whose body turns."""
    tables = Tables(system)
    arm = max(leg.fairlead_radius for leg in system.legs) or 1.0
    yaws = np.linspace(0.0, 2.0 * math.pi, YAWS, endpoint=False)
    places, lefts, total = _at_rest(tables, system, yaws, np.zeros((len(yaws), 2)))
    scale = arm * (total + math.hypot(*system.force)) + abs(system.moment)
    unresolved = float(np.isnan(lefts).mean())
    if unresolved == 1.0:
        return Headings(np.empty((0, 3)), math.nan, math.nan, scale, unresolved)
    least, largest = float(np.nanmin(lefts)), float(np.nanmax(lefts))
    after = np.roll(lefts, -1)
    is_turning = np.abs(lefts + after) < 8.0 * np.abs(lefts - after)
    is_low = np.minimum(np.abs(lefts), np.abs(after)) < 0.05 * scale
    is_low |= np.isnan(lefts) != np.isnan(after)
    for peak in (np.nanargmin(lefts), np.nanargmax(lefts)):
        is_low[[peak - 1, peak]] = True
    look = np.flatnonzero(((lefts > 0.0) & (after <= 0.0)) | is_turning | is_low)
    if not look.size:
        return Headings(np.empty((0, 3)), least, largest, scale, unresolved)
    near: Array = (yaws[look, None] + np.linspace(0.0, 2.0 * math.pi / YAWS, CLOSER)).ravel()
    starts = np.where(np.isnan(places), np.roll(places, -1, axis=0), places)
    inner: Array
    closer: Array
    inner, closer, _ = _at_rest(tables, system, near, starts[look].repeat(CLOSER, axis=0))
    near, inner = near.reshape(-1, CLOSER), inner.reshape(-1, CLOSER, 2)
    closer = closer.reshape(-1, CLOSER)
    found = []
    for k, j in zip(*np.nonzero((closer[:, :-1] > 0.0) & (closer[:, 1:] <= 0.0)), strict=True):
        share = closer[k, j] / (closer[k, j] - closer[k, j + 1])
        x, y = inner[k, j] + share * (inner[k, j + 1] - inner[k, j])
        found.append((x, y, near[k, j] + share * (near[k, j + 1] - near[k, j])))
    return Headings(
        np.array(found).reshape(-1, 3),
        min(least, float(np.nanmin(closer))),
        max(largest, float(np.nanmax(closer))),
        scale,
        unresolved,
    )


def _at_rest(
    tables: Tables, system: System, yaws: Array, start: Array
) -> tuple[Array, Array, float]:
    """X and y of rest at each yaw, the moment left there, and the least sum of forces.

    A body that has to slide along lines that do not stretch takes many steps; nan in the end where
    it does not come to rest.
    """
    places, lefts, total = _descended(tables, system, yaws, start, STEPS)
    is_lost = np.isnan(lefts)
    if is_lost.any():
        again = _descended(tables, system, yaws[is_lost], start[is_lost], MOST_STEPS)
        places[is_lost], lefts[is_lost] = again[0], again[1]
    return places, lefts, total


def _descended(
    tables: Tables, system: System, yaws: Array, start: Array, steps: int
) -> tuple[Array, Array, float]:
    cosine, sine = np.cos(yaws)[:, None], np.sin(yaws)[:, None]
    arm_x = cosine * tables.arms[:, 0] - sine * tables.arms[:, 1]
    arm_y = sine * tables.arms[:, 0] + cosine * tables.arms[:, 1]
    x, y = start[:, 0].copy(), start[:, 1].copy()
    far = float(np.linalg.norm(tables.anchors, axis=1).max())
    out_x, out_y, stiff, total = _plane(tables, system, x, y, arm_x, arm_y)
    for _ in range(steps):
        if (np.hypot(out_x, out_y) <= ENOUGH * total).all():
            break
        xx, xy, yy = stiff
        floor = 1e-12 * (xx + yy) + 1e-9
        plane = (xx + floor) * (yy + floor) - xy * xy
        move_x = ((yy + floor) * out_x - xy * out_y) / plane
        move_y = ((xx + floor) * out_y - xy * out_x) / plane
        short = np.minimum(1.0, 0.1 * far / np.maximum(np.hypot(move_x, move_y), 1e-300))
        move_x, move_y = short * move_x, short * move_y
        slope = out_x * move_x + out_y * move_y
        share = np.ones_like(x)
        for _ in range(HALVINGS):
            to_x, to_y = x + share * move_x, y + share * move_y
            out_x, out_y, stiff, total = _plane(tables, system, to_x, to_y, arm_x, arm_y)
            is_too_far = out_x * move_x + out_y * move_y < -0.5 * slope
            if not is_too_far.any():
                break
            share = np.where(is_too_far, 0.5 * share, share)
        x, y = to_x, to_y
    H, _, along_x, along_y, _ = _pulls(tables, x, y, arm_x, arm_y)
    lefts = system.moment + np.sum(H * (arm_x * along_y - arm_y * along_x), axis=1)
    is_lost = np.hypot(out_x, out_y) > 10.0 * ENOUGH * total
    places = np.where(is_lost[:, None], math.nan, np.column_stack([x, y]))
    return places, np.where(is_lost, math.nan, lefts), float(H.sum(axis=1).min())


def _pulls(tables: Tables, x: Array, y: Array, arm_x: Array, arm_y: Array) -> Any:
    to_x = tables.anchors[:, 0] - x[:, None] - arm_x
    to_y = tables.anchors[:, 1] - y[:, None] - arm_y
    spans = np.maximum(np.hypot(to_x, to_y), 1e-9)
    H, steep = tables.force(spans)
    return H, steep, to_x / spans, to_y / spans, spans


def _plane(tables: Tables, system: System, x: Array, y: Array, arm_x: Array, arm_y: Array) -> Any:
    """Force left, its stiffness and the sum of all forces, a small one of these lines added."""
    H, steep, along_x, along_y, spans = _pulls(tables, x, y, arm_x, arm_y)
    across = H / spans
    out_x = system.force[0] + np.sum(H * along_x, axis=1)
    out_y = system.force[1] + np.sum(H * along_y, axis=1)
    xx = np.sum(steep * along_x**2 + across * along_y**2, axis=1)
    yy = np.sum(steep * along_y**2 + across * along_x**2, axis=1)
    xy = np.sum((steep - across) * along_x * along_y, axis=1)
    total = H.sum(axis=1) + math.hypot(*system.force) + tables.small
    return out_x, out_y, (xx, xy, yy), total
