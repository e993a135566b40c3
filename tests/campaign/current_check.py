"""Networks in a current: each answer is checked by forces from another integration of every line.

Each line is followed by scipy's DOP853 from the place and the force at one end; it must arrive at
the other with the force there, and the forces at every joint must sum up with its drag.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

from catopt.errors import CatoptError, NotConvergedError
from catopt.model import Line
from catopt.model.network import Network
from catopt.model.sea import CurrentProfile
from catopt.mooring.fixed_body import at_rest
from catopt.mooring.joints import pulls_of, reversed_line
from catopt.mooring.network_rest import LinesAtRest, LinesInCurrent
from tests.campaign import network_check
from tests.campaign.networks import drawn_afloat

ARRIVES, BALANCE = 1e-7, 1e-6
"""Part of a line's length, and of the largest tension, that may be left over."""


def drawn_in_current(seed: int) -> Network:
    """Draw a network with floats in a current up to 1 m/s on ropes and chains of usual drag."""
    network, draw = drawn_afloat(seed), random.Random(f"current {seed}")
    depth = network.site.water_depth
    speeds = sorted(draw.uniform(0.0, 1.0) for _ in range(3))[::-1]
    current = CurrentProfile(
        "table",
        depths=(0.0, 0.4 * depth, depth),
        speeds=tuple(speeds),
        direction=draw.uniform(0.0, math.tau),
    )
    lines = []
    for line in network.lines:
        segments = [
            replace(
                part,
                drag_diameter=math.sqrt(max(part.submerged_weight, 1.0) / 5e4),
                drag_normal=draw.uniform(0.8, 2.4),
                drag_axial=draw.choice([0.0, 0.1]),
            )
            for part in line.line.segments
        ]
        lines.append(replace(line, line=Line(segments, line.line.point_loads)))
    # A line in a current lies on the bed from an anchor there, or not at all.
    points = [replace(p, height=0.0) if p.kind == "anchor" else p for p in network.points]
    points = [
        replace(point, drag_area=draw.uniform(0.0, 5.0), drag_coefficient=1.0)
        if point.kind == "joint" and draw.random() < 0.5
        else point
        for point in points
    ]
    return replace(network, points=tuple(points), lines=tuple(lines), current=current)


def faults_in_current(found: LinesInCurrent) -> Iterator[str]:
    """Say what is wrong with an answer."""
    network, kept = found.network, found.joints
    pulls = [*pulls_of(found.runs, kept.ends)]
    strongest = max(math.hypot(*pull) for _, pull in pulls)
    for k, run in enumerate(found.runs):
        for fault in _line_faults(found, k):
            yield f"line {run.name}: {fault}"
    flow, depth = _flow(found), network.site.water_depth
    left: dict[str, Any] = {}
    for k, point in enumerate(network.points):
        if point.kind == "joint":
            u = flow(min(kept.places[k][2], depth))
            drag = 0.5 * network.site.water_density * point.drag_product * np.linalg.norm(u) * u
            bears = [0.0, 0.0, kept.reactions[k] - kept.lost[k]]
            left[point.name] = sum(map(np.array, (bears, point.hung, drag)))
    left |= {body.body.name: np.array([*body.body.force, 0.0]) for body in found.bodies}
    for k, pull in pulls:
        if network.points[k].body:
            left[network.points[k].body] += [*pull[:2], 0.0]
        elif network.points[k].kind == "joint":
            left[network.points[k].name] += pull
    for name, over in left.items():
        if np.linalg.norm(over) > BALANCE * strongest:
            yield f"{np.linalg.norm(over):.3g} N left at {name} of {strongest:.3g} N"


def _flow(found: LinesAtRest) -> Any:
    current, depth = found.network.current, found.network.site.water_depth
    assert current is not None
    way = np.array([math.cos(current.direction), math.sin(current.direction), 0.0])
    return lambda z: np.interp(depth - z, current.depths, current.speeds) * way


def _line_faults(found: LinesInCurrent, number: int) -> Iterator[str]:
    """Follow a line down from its second end to its first, or to where it lies."""
    network, run, ends = found.network, found.runs[number], found.joints.ends[number]
    (given,) = [
        each.line for k, each in enumerate(network.lines) if (each.name or f"{k + 1}") == run.name
    ]
    first, second = (np.array(found.joints.places[k]) for k in (run.first, run.second))
    line = given if run.line == given else reversed_line(given)
    tension = max(float(np.linalg.norm(each)) for each in (ends.first, ends.second))
    hangs = line.length - found.lines[number].grounded_length
    end = _followed(found, line, second, -np.array(ends.second), hangs)
    if hangs == line.length:
        if (miss := np.linalg.norm(end[:3] - first)) > ARRIVES * line.length:
            yield f"misses its first end by {miss:.3g} m"
        if (off := np.linalg.norm(end[3:] - ends.first)) > BALANCE * tension:
            yield f"pulls its first end otherwise, by {off:.3g} N"
        return
    if abs(end[2]) > ARRIVES * line.length:
        yield f"comes to the bed at {end[2]:.3g} m"
    flat = first[:2] - end[:2]
    if np.linalg.norm(end[3:]) < 1e-5 * max(tension, line.submerged_weight):  # it lies loosely
        if np.linalg.norm(flat) > (line.length - hangs) * (1.0 + ARRIVES):
            yield "does not reach what hangs of it"
        return
    across = flat[0] * end[4] - flat[1] * end[3]
    if abs(across) > ARRIVES * line.length * np.linalg.norm(end[3:5]):
        yield "does not lie straight on"


def _followed(found: LinesInCurrent, line: Line, top: Any, force: Any, length: float) -> Any:
    """Place and force so far below the upper end; the force is that of what is above."""
    network = found.network
    flow, half = _flow(found), 0.5 * network.site.water_density
    surface = network.site.water_depth
    under = max(found.joints.places[k][2] for k in range(len(network.points))) <= surface
    state, s = np.concatenate([top, force]), line.length
    start, cuts = 0.0, [line.length - length]
    for segment in line.segments:
        start += segment.length
        cuts.append(start)
    cuts += [load.position for load in line.point_loads]
    places = sorted({each for each in cuts if line.length - length <= each < line.length})[::-1]

    def water(z: float) -> Any:
        return flow(min(z, surface)) if under or z <= surface * (1.0 + 1e-12) else np.zeros(3)

    for low in places:
        start, part = 0.0, line.segments[0]
        for segment in line.segments:
            if start <= low:
                part = segment
            start += segment.length
        w, EA = part.submerged_weight, part.EA
        area = half * (part.drag_diameter or 0.0)
        normal, axial = area * (part.drag_normal or 0.0), area * (part.drag_axial or 0.0)

        def slope(
            _: float, y: Any, w: float = w, EA: float = EA, n: float = normal, t: float = axial
        ) -> Any:
            T = np.linalg.norm(y[3:])
            e, u = y[3:] / T, water(y[2])
            along = (u @ e) * e
            across = u - along
            drag = n * np.linalg.norm(across) * across + t * np.linalg.norm(along) * along
            return np.concatenate([-(1.0 + T / EA) * e, drag - np.array([0.0, 0.0, w])])

        scale = np.array([1e-9 * line.length] * 3 + [1e-10 * np.linalg.norm(force)] * 3)
        came = solve_ivp(slope, (0.0, s - low), state, "DOP853", rtol=1e-11, atol=scale)
        state, s = came.y[:, -1], low
        for load in line.point_loads:
            if load.position == low and low > line.length - length:
                state[5] -= load.submerged_weight
    return state


def judge_in_current(seed: int) -> tuple[str, list[str]]:
    """Solve one network; what became of it, and what is wrong."""
    network = drawn_in_current(seed)
    try:
        found = at_rest(network)
    except NotConvergedError as error:
        return "not converged", [str(error)]
    except CatoptError as error:
        return f"refused: {str(error)[:60]}", []
    assert isinstance(found, LinesInCurrent)
    return "answered", [*faults_in_current(found)]


def run(count: int, first: int, tell: Callable[[str], object]) -> int:
    """Judge networks; as `network_check.run`."""
    return network_check.run(count, first, tell, judge_in_current)
