"""Random questions turned round, held against a scan that knows nothing of the search.

A question is a line of any kind and what is required of it: an angle or a grounded length by the
length of a segment or a clump weight, the force of touchdown or of a strength; some of them ask for
a contact state, where the touchdown is at a joint, at a clump weight or at the anchor. The line is
solved at many values of the unknown. An answer has to give what was asked for, a refusal is wrong
where two neighbouring values of the scan close in on what was asked for.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from catopt.catenary.find import (
    Found,
    find_clump_weight,
    find_length,
    find_limit_force,
    find_touchdown_force,
    with_segment_length,
)
from catopt.catenary.solution import Solution
from catopt.catenary.solve import solve
from catopt.errors import InputError, NoAnswerError, NoEquilibriumError, NotConvergedError
from catopt.model import Line, PointLoad, Segment

KINDS = ("length angle", "length grounded", "clump weight", "touchdown", "limit")
LOADS = ("horizontal_force", "fairlead_tension", "span")


class Question(NamedTuple):
    """What is asked, how the answer is read, and the unknown's values to be scanned."""

    ask: Callable[[], Found]
    at: Callable[[float], Solution]
    reading: Callable[[Solution], float]
    wanted: float
    tolerance: float
    values: np.ndarray


def question(seed: int) -> Question | None:
    """Draw a question; None where the line drawn has no answer itself."""
    rng = np.random.default_rng([42, seed])
    kind = KINDS[seed % len(KINDS)]
    height = 10.0 ** rng.uniform(0.7, 2.5)
    count = int(rng.integers(1, 4))
    length = height * rng.uniform(1.1, 6.0)
    parts = rng.uniform(0.2, 1.0, count)
    parts *= length / parts.sum()
    buoyant = rng.random() < 0.5
    weights = 10.0 ** rng.uniform(1.5, 3.0, count)
    if buoyant and rng.random() < 0.5:
        weights[int(rng.integers(count))] *= -0.3
    total = float(np.abs(weights) @ parts)
    EA = total * 10.0 ** rng.uniform(1.5, 4.0) if rng.random() < 0.4 else math.inf
    segments = [
        Segment(float(a), float(w), EA, MBL=3.0 * total)
        for a, w in zip(parts, weights, strict=True)
    ]
    places = rng.uniform(0.05, 0.95, int(rng.integers(0, 3)) + (kind == "clump weight"))
    signs = np.where(rng.random(len(places)) < (0.5 if buoyant else 0.0), -0.5, 1.0)
    loads = [
        PointLoad(float(p) * length, float(s) * total * 10.0 ** rng.uniform(-2.0, -0.3))
        for p, s in zip(sorted(places), signs, strict=True)
    ]
    line = Line(segments, loads)
    anchored = kind == "touchdown" or rng.random() < 0.8
    place = {
        "height": height,
        "anchor_height": 0.0 if anchored else 0.3 * height * rng.random(),
        "seabed_friction": float(rng.choice([0.0, 0.6])),
    }
    force = total * 10.0 ** rng.uniform(-1.5, 1.5)
    try:
        here = solve(line, horizontal_force=force, **place)
    except (NoEquilibriumError, NotConvergedError):
        return None
    known = LOADS[int(rng.integers(3 if kind == "clump weight" else 2))]
    load = {known: {"horizontal_force": force, "span": here.span}.get(known, here.fairlead.tension)}
    angle = math.radians(float(rng.choice([0.0, rng.uniform(0.2, 20.0)])))
    return _of(kind, rng, line, place, load, angle)


def _of(kind, rng, line, place, load, angle) -> Question:  # type: ignore[no-untyped-def]
    if kind.startswith("length"):
        index = int(rng.integers(len(line.segments)))

        def longer(value: float) -> Solution:
            return solve(with_segment_length(line, index, value), **load, **place)

        # Point loads keep their place on the segment: it is no shorter than up to the last of them.
        start = math.fsum(part.length for part in line.segments[:index])
        end = start + line.segments[index].length
        held = max((q.position - start for q in line.point_loads if start < q.position <= end),
                   default=0.0)  # fmt: skip
        values = np.geomspace(1e-3, 1e2, 160) * line.length + held
        if kind == "length angle":
            return Question(
                lambda: find_length(line, segment=index, anchor_angle=angle, **load, **place),
                longer, _angle, angle, 1e-6, values)  # fmt: skip
        below = np.cumsum([part.length for part in line.segments])
        # Half of them a contact state: the touchdown at a joint that another segment ends in.
        wanted = float(rng.choice([below[0], rng.uniform(0.1, 1.5) * line.length]))
        return Question(
            lambda: find_length(line, segment=index, grounded_length=wanted, **load, **place),
            longer, lambda at: at.grounded_length, wanted, 1e-6 * line.length, values)  # fmt: skip
    if kind == "clump weight":
        index = int(rng.integers(len(line.point_loads)))

        def heavier(value: float) -> Solution:
            loads = list(line.point_loads)
            loads[index] = replace(loads[index], submerged_weight=value)
            return solve(Line(line.segments, loads), **load, **place)

        return Question(
            lambda: find_clump_weight(line, point_load=index, anchor_angle=angle, **load, **place),
            heavier, _angle, angle, 1e-6,
            np.geomspace(1e-4, 1e4, 160) * abs(line.submerged_weight))  # fmt: skip

    def pulled(value: float) -> Solution:
        return solve(line, horizontal_force=value, **place)

    weight = math.fsum(abs(part.submerged_weight) * part.length for part in line.segments)
    values = np.geomspace(1e-4, 1e4, 160) * weight
    if kind == "touchdown":
        friction = place["seabed_friction"]
        return Question(
            lambda: find_touchdown_force(line, height=place["height"], seabed_friction=friction),
            pulled, _angle, 0.0, 1e-6, values)  # fmt: skip
    MBL = line.segments[0].MBL
    assert MBL is not None
    return Question(
        lambda: find_limit_force(line, safety_factor=2.0, **place),
        pulled, lambda at: max(s.max_tension for s in at.segments), 0.5 * MBL, 1e-6 * MBL,
        values)  # fmt: skip


def _angle(solution: Solution) -> float:
    return solution.anchor.angle


def fault(asked: Question) -> str:
    """Say what is wrong with what is found; empty where nothing is."""
    try:
        found = asked.ask()
    except NoAnswerError as refusal:
        return _wrongly_refused(asked, str(refusal))
    except (NotConvergedError, NoEquilibriumError, InputError) as error:
        return f"{type(error).__name__}: {error}"
    read = asked.reading(asked.at(found.value))
    right = abs(read - asked.wanted) <= asked.tolerance
    return "" if right else f"{found.value!r} gives {read!r}, not {asked.wanted!r}"


def _read(asked: Question, value: float) -> float:
    try:
        return asked.reading(asked.at(value)) - asked.wanted
    except (NoEquilibriumError, NotConvergedError, InputError):
        return math.nan


def _wrongly_refused(asked: Question, said: str) -> str:
    """Look for what was asked for between neighbouring values of the scan."""
    if said.startswith(("every", "no clump weight is needed")):
        return ""
    read = [_read(asked, float(value)) for value in asked.values]
    for k in range(len(read) - 1):
        if read[k] * read[k + 1] < 0.0:
            low, high = float(asked.values[k]), float(asked.values[k + 1])
            for _ in range(80):
                middle = 0.5 * (low + high)
                if _read(asked, middle) * read[k] > 0.0:
                    low = middle
                else:
                    high = middle
            if abs(_read(asked, low)) <= 1e3 * asked.tolerance:
                return f"refused ({said}), but {low!r} gives it"
    if asked.wanted == 0.0:
        for value, each in zip(asked.values, read, strict=True):
            if each == 0.0:
                return f"refused ({said}), but {float(value)!r} gives 0"
    return ""


def run(first: int, count: int) -> tuple[int, dict[int, str]]:
    """Ask `count` questions from a seed on; how many had an answer at all, and the faults."""
    faults, asked = {}, 0
    seed = first
    while asked < count:
        each = question(seed)
        if each is not None:
            asked += 1
            if said := fault(each):
                faults[seed] = said
        seed += 1
    return asked, faults
