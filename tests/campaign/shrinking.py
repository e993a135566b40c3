"""A failing line made as simple as it can be while it still fails."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import replace

from catopt.errors import CatoptError
from catopt.model import Line, PointLoad, Segment
from tests.campaign.lines import Trial


def shrunk(trial: Trial, fails: Callable[[Trial], bool], tries: int = 2000) -> Trial:
    """Take parts away, then digits, as long as the line fails.

    Parameters
    ----------
    trial : Trial
        A line that fails.
    fails : callable
        Whether a line still does.
    tries : int
        How many lines to look at, at the most.
    """
    left = tries
    goes_on = True
    while goes_on:
        goes_on = False
        for simpler in _simpler(trial):
            if left <= 0:
                return trial
            left -= 1
            if fails(simpler):
                trial, goes_on = simpler, True
                break
    return trial


def _simpler(trial: Trial) -> Iterator[Trial]:
    for change in (_without_a_part, _without_a_property, _with_rounder_numbers):
        candidates = change(trial)
        while True:
            try:
                candidate = next(candidates, None)
            except CatoptError:
                break
            if candidate is None:
                break
            if candidate != trial:
                yield candidate


def _without_a_part(trial: Trial) -> Iterator[Trial]:
    line = trial.line
    for k in range(len(line.point_loads)):
        yield _of(trial, line.segments, line.point_loads[:k] + line.point_loads[k + 1 :])
    for k in range(len(line.segments) if len(line.segments) > 1 else 0):
        rest = line.segments[:k] + line.segments[k + 1 :]
        length = math.fsum(segment.length for segment in rest)
        if all(load.position < length for load in line.point_loads):
            yield _of(trial, rest, line.point_loads)
        merged = k - 1 if k > 0 else 1
        longer = replace(
            line.segments[merged], length=line.segments[merged].length + line.segments[k].length
        )
        segments = list(line.segments)
        segments[merged] = longer
        del segments[k]
        yield _of(trial, tuple(segments), line.point_loads)


def _without_a_property(trial: Trial) -> Iterator[Trial]:
    yield replace(trial, friction=0.0)
    if trial.friction not in (0.0, 1.0):
        yield replace(trial, friction=1.0)
    if trial.anchor_height > 0.0:
        yield replace(trial, anchor_height=0.0)
    for k, segment in enumerate(trial.line.segments):
        if math.isfinite(segment.EA):
            yield _with_segment(trial, k, replace(segment, EA=math.inf))


def _with_rounder_numbers(trial: Trial) -> Iterator[Trial]:
    for digits in (1, 2, 3, 5, 8):
        for key in ("height", "anchor_height", "friction", "value"):
            rounder = rounded(getattr(trial, key), digits)
            if rounder != getattr(trial, key):
                yield replace(trial, **{key: rounder})  # type: ignore[arg-type]
        for k, segment in enumerate(trial.line.segments):
            for key in ("length", "submerged_weight", "EA"):
                rounder = rounded(getattr(segment, key), digits)
                if rounder != getattr(segment, key):
                    yield _with_segment(trial, k, replace(segment, **{key: rounder}))  # type: ignore[arg-type]
        for k, load in enumerate(trial.line.point_loads):
            for key in ("position", "submerged_weight"):
                rounder = rounded(getattr(load, key), digits)
                if rounder != getattr(load, key):
                    loads = list(trial.line.point_loads)
                    loads[k] = replace(load, **{key: rounder})  # type: ignore[arg-type]
                    yield _of(trial, trial.line.segments, tuple(loads))


def rounded(value: float, digits: int) -> float:
    """Round to a number of significant digits, unless the value has no more than them."""
    return float(f"{value:.{digits}g}") if math.isfinite(value) else value


def _with_segment(trial: Trial, k: int, segment: Segment) -> Trial:
    segments = list(trial.line.segments)
    segments[k] = segment
    return _of(trial, tuple(segments), trial.line.point_loads)


def _of(trial: Trial, segments: tuple[Segment, ...], loads: tuple[PointLoad, ...]) -> Trial:
    return replace(trial, line=Line(segments, loads))
