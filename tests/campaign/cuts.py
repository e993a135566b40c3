"""Random lines cut at joints, held against the line itself, and bridles of three lines and more."""

from __future__ import annotations

import math
import time

import numpy as np

from catopt.catenary.solution import Solution
from catopt.catenary.solve import solve
from catopt.errors import CatoptError, InputError
from catopt.model import Line, PointLoad, Segment, Site
from catopt.model.network import LineBetween, Network, Point
from catopt.mooring.fixed_body import hold

SECONDS = 1.0


def drawn(seed: int) -> tuple[Network, Line, float, float, float]:
    """Draw a line, cut at joints and given part by part, some from their other end.

    Returns the network, the line itself, its span and height, and the friction of the bed.
    """
    rng = np.random.default_rng([7, seed])
    count = int(rng.integers(2, 5))
    height = float(rng.uniform(8.0, 300.0))
    lengths = height * rng.uniform(0.2, 3.0, count)
    lengths *= max(1.0, 1.05 * height / lengths.sum())
    weights = 10.0 ** rng.uniform(1.5, 3.5, count)
    EA = 10.0 ** rng.uniform(6.5, 9.0)
    parts = [
        Line([Segment(float(length), float(weight), EA=EA)])
        for length, weight in zip(lengths, weights, strict=True)
    ]
    clumps = np.where(rng.random(count - 1) < 0.4, rng.uniform(-0.3, 1.0, count - 1), 0.0)
    clumps *= float(lengths @ weights) * 0.3
    length = float(lengths.sum())
    span = math.sqrt(length**2 - height**2) * float(rng.choice([rng.uniform(0.6, 1.0), 0.999]))
    friction = float(rng.choice([0.0, 0.5]))
    names = ["anchor", *(f"joint {k}" for k in range(1, count)), "fairlead"]
    points = [
        Point("anchor", "anchor", span, 0.0, 0.0),
        Point("fairlead", "fairlead", 0.0, 0.0, height),
        *(
            Point(name, "joint", submerged_weight=float(clump))
            for name, clump in zip(names[1:-1], clumps, strict=True)
        ),
    ]
    lines = [
        LineBetween(part, *(ends if rng.random() < 0.5 else ends[::-1]))
        for part, *ends in zip(parts, names, names[1:], strict=False)
    ]
    loads = [
        PointLoad(float(place), float(clump))
        for place, clump in zip(np.cumsum(lengths), clumps, strict=False)
    ]
    whole = Line([part.segments[0] for part in parts], loads)
    order = rng.permutation(count)
    network = Network(Site(2.0 * height + length, friction), tuple(points),
                      tuple(lines[k] for k in order))  # fmt: skip
    return network, whole, span, height, friction


def fault(seed: int) -> str:
    """Say what is wrong with the network of a line; empty where nothing is."""
    network, line, span, height, friction = drawn(seed)
    try:
        alone: Solution | None = solve(line, height=height, span=span, seabed_friction=friction)
    except CatoptError as error:
        return f"the line itself: {error}"
    assert alone is not None
    start = time.process_time()
    try:
        found = hold(network)
    except InputError as refusal:
        return "" if alone.horizontal_force == 0.0 else f"refused: {refusal}"
    except CatoptError as error:
        return f"{type(error).__name__}: {error}"
    if (seconds := time.process_time() - start) > SECONDS:
        return f"{seconds:.1f} s"
    H, V = found.body.load[0], -found.body.load[2]
    size = alone.fairlead.tension
    off = max(abs(H - alone.horizontal_force), abs(V - alone.fairlead.vertical_force)) / size
    anchored = next(
        each for each, run in zip(found.lines, found.runs, strict=True)
        if network.points[run.first].kind == "anchor"
    )  # fmt: skip
    off = max(off, abs(anchored.anchor.tension - alone.anchor.tension) / size)
    return "" if off <= 1e-6 else f"off by {off:.1e} of {size:g} N"


def bridle(seed: int) -> Network:
    """Draw lines from two to four anchors and one or two fairleads to one or two joints."""
    rng = np.random.default_rng([8, seed])
    depth = float(rng.uniform(20.0, 300.0))
    joints = int(rng.integers(1, 3))
    anchors = []
    for k in range(int(rng.integers(2, 5))):
        x, y = depth * rng.uniform(-4.0, 4.0, 2)
        height = float(rng.choice([0.0, rng.uniform(0.0, 0.5) * depth]))
        anchors.append(Point(f"a{k}", "anchor", float(x), float(y), height))
    fairleads = []
    for k in range(int(rng.integers(1, 3))):
        x, y = rng.uniform(-10.0, 10.0, 2)
        fairleads.append(Point(f"f{k}", "fairlead", float(x), float(y), 0.95 * depth))
    free = [
        Point(f"j{k}", "joint", submerged_weight=float(rng.choice([0.0, rng.uniform(-2e4, 5e4)])))
        for k in range(joints)
    ]
    pairs = [(end, free[k % joints]) for k, end in enumerate((*anchors, *fairleads))]
    if joints == 2:
        pairs.append((free[0], free[1]))
    scale = depth * float(rng.uniform(1.0, 4.0))
    lines = tuple(
        LineBetween(
            Line([Segment(scale * float(rng.uniform(0.3, 2.0)), 10.0 ** rng.uniform(1.0, 3.5),
                          EA=10.0 ** rng.uniform(6.0, 9.0))]),
            a.name, b.name)
        for a, b in pairs
    )  # fmt: skip
    return Network(Site(20.0 * depth), (*anchors, *fairleads, *free), lines)


def bridle_fault(seed: int) -> str:
    """Say whether a bridle comes to rest, or is refused for a true reason, within a second."""
    network = bridle(seed)
    start = time.process_time()
    said = ""
    try:
        hold(network)
    except InputError as refusal:
        said = "" if "hangs slack" in str(refusal) else str(refusal)
    except CatoptError as error:
        said = f"{type(error).__name__}: {error}"
    seconds = time.process_time() - start
    return said or (f"{seconds:.1f} s" if seconds > SECONDS else "")
