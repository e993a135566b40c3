"""What quantities do over all steps of a run: turning points, mean, deviation and extremes.

A sample every so often misses what comes and goes between two. So every step is followed: of each
quantity its turning points are kept, from which peaks, crossings and cycles are those of all steps
whatever the samples; only turns by less than a ten-thousandth of its largest size are passed over.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Final

import numpy as np

from catopt.arrays import Array
from catopt.errors import refused
from catopt.fem.extremes import SeriesStatistics, peaks_above_mean
from catopt.words import Message

FOLLOWED: Final = (
    "fairlead_tension",
    "anchor_tension",
    "grounded_length",
    "offset",
    "fairlead_x",
    "fairlead_y",
    "span",
    "anchor_horizontal",
    "uplift_force",
    "uplift_angle",
    "fairlead_vertical",
)
"""Quantities of each line: sizes of the forces at its ends, N; unstretched length on the bed, m;
horizontal way of its fairlead from rest, its place, and its horizontal distance from the lower end,
m; horizontal pull on its anchor and that upwards, N, and their angle, rad; pull down on its
fairlead, N."""

LEAST_TURN: Final = 1e-4
"""Of a quantity, over its largest size: turns by less are no turning points."""

STATE: Final = 14
"""Figures of `follow` for each quantity: 0 direction, 1 candidate for a turning point and 2 its
time, 3 largest size, 4 maximum, 5 its time, 6 minimum, 7 first value and 8 its time, 9 last value
and 10 its time, 11 and 12 integrals of the value less the first one and of its square, 13 whether
anything was followed."""


def follow(course: int, t: float, value: float, state: Any, turns: Any, count: Any) -> None:
    """Follow a quantity to its value at t, s.

    `state` (quantities, STATE), `turns` (quantities, room, 2): time and value of its turning
    points, of which `count` are there; a step adds one at most.
    """
    at = state[course]
    if at[13] == 0.0:
        at[1] = at[4] = at[6] = at[7] = at[9] = value
        at[2] = at[5] = at[8] = at[10] = t
        at[3], at[13] = abs(value), 1.0
        return
    h = t - at[10]
    old, new = at[9] - at[7], value - at[7]
    at[11] += 0.5 * h * (old + new)
    at[12] += 0.5 * h * (old * old + new * new)
    at[9], at[10] = value, t
    at[3] = max(at[3], abs(value))
    if value > at[4]:
        at[4], at[5] = value, t
    at[6] = min(at[6], value)
    least, way = LEAST_TURN * at[3], at[0]
    if way == 0.0:
        if abs(value - at[7]) > least:
            at[0] = 1.0 if value > at[7] else -1.0
            at[1], at[2] = value, t
    elif way * (value - at[1]) >= 0.0:
        at[1], at[2] = value, t
    elif way * (at[1] - value) > least:
        n = count[course]
        turns[course, n, 0], turns[course, n, 1] = at[2], at[1]
        count[course] = n + 1
        at[0], at[1], at[2] = -way, value, t


@dataclass(frozen=True, eq=False)
class Course:
    """One quantity over all steps from where statistics begin, in its own unit."""

    time: Array  # (n,): s, of the first value, the turning points and the last value
    value: Array  # (n,)
    mean: float  # over time
    std: float
    maximum: float
    minimum: float
    time_of_maximum: float  # s

    @property
    def duration(self) -> float:
        """From the first value to the last, s."""
        return float(self.time[-1] - self.time[0]) if self.time.size else 0.0

    def statistics(self) -> SeriesStatistics:
        """Say what it does; refused where nothing was followed."""
        if self.duration <= 0.0:
            allowed = Message("refused_motion.two_steps_or_more_are")
            raise refused("time", "nothing", allowed, "statistics")
        return SeriesStatistics(
            mean=self.mean,
            std=self.std,
            maximum=self.maximum,
            minimum=self.minimum,
            time_of_maximum=self.time_of_maximum,
            duration=self.duration,
            peaks=peaks_above_mean(self.value, self.mean).size,
        )


def course_of(state: Array, turns: Array, count: int) -> Course:
    """Make a value of what `follow` kept of one quantity."""
    if state[13] == 0.0:
        none = np.empty(0)
        return Course(none, none, *[math.nan] * 5)
    time, value = turns[:count].T
    ends = [state[8:9], time], [state[7:8], value]
    if state[0] != 0.0 and state[2] < state[10]:
        ends[0].append(state[2:3])
        ends[1].append(state[1:2])
    if state[10] > state[8]:
        ends[0].append(state[10:11])
        ends[1].append(state[9:10])
    duration = max(float(state[10] - state[8]), 1e-300)
    mean = float(state[11]) / duration
    square = max(float(state[12]) / duration - mean * mean, 0.0)
    return Course(
        np.concatenate(ends[0]),
        np.concatenate(ends[1]),
        mean=float(state[7]) + mean,
        std=math.sqrt(square),
        maximum=float(state[4]),
        minimum=float(state[6]),
        time_of_maximum=float(state[5]),
    )


def taken_together(courses: list[Course]) -> float:
    """Mean over the time of all of them."""
    times = np.array([each.duration for each in courses])
    return float(np.average([each.mean for each in courses], weights=times))
