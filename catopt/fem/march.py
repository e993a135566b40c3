"""Many steps in time, in compiled code: halving where a step does not close, and taking samples."""

from __future__ import annotations

import math
from typing import Any, Final, NamedTuple

from catopt.fem.energy_balance import add_works, fill_forces
from catopt.fem.moving import BodyNode, Moving, MovingLines
from catopt.fem.newmark import close_step, predict
from catopt.fem.rows import copy_blocks, copy_rows
from catopt.fem.sampling import Record, Room, Rules, fill_end_forces, take_sample
from catopt.fem.seabed import drag_feet
from catopt.fem.series import SeriesRows, fill_series
from catopt.fem.water_at import fill_water
from catopt.waves.kinematics import Flow

_LONGER: Final = 0.2
"""Part of the allowed surprise below which the next step may be twice as long."""


class MarchReport(NamedTuple):
    """What became of the steps.

    Attributes
    ----------
    done : bool
        Whether all were taken.
    time : float
        Reached, s.
    steps, iterations, halvings : int
        Taken; Newton iterations; times that a step was halved.
    refinements : int
        Times that a step was halved because a tension surprised.
    unresolved : int
        Steps accepted as short as allowed with a tension that still surprised.
    ringing, strain : float
        Strain energy over time, J s: of what in the tensions changes from step to step, and all.
    shortest : float
        Shortest step, s.
    worst : float
        Where it stopped: force left over, over the largest tension or what a line weighs.
    node : int
        With its node, -1 for the body.
    level : int
        How often the step is halved at the end.
    """

    done: bool
    time: float
    steps: int
    iterations: int
    halvings: int
    refinements: int
    unresolved: int
    ringing: float
    strain: float
    shortest: float
    worst: float
    node: int
    level: int


def march(
    first: int, end: int, level: int, rules: Rules, lines: MovingLines, body: BodyNode,
    led: SeriesRows, load: SeriesRows, flow: Flow, has_sea: bool, before: Moving, room: Room,
    record: Record,
) -> MarchReport:  # fmt: skip
    """Step from sample `first` to sample `end`, and take the samples after the first.

    `first`, `end`: samples; sample i is taken at i `every` steps; `led`, `load`: where the ends are
    led; the force on the body, of one end; `before`: state at sample `first`, and then where the
    steps have come to; `room`, `record`: work space, and where the samples go.
    """
    steps = iterations = halvings = refinements = unresolved = 0
    ringing = strain = 0.0
    shortest = rules.step
    for sample in range(first + 1, end + 1):
        for j in range(rules.every):
            start = ((sample - 1) * rules.every + j) * rules.step
            done = 0.0
            while done < 1.0:
                part = 0.5**level
                h = part * rules.step
                closed, used, worst, node = attempt(
                    start + done * rules.step, h, rules, lines, body, led, load, flow, has_sea,
                    before, room,
                )  # fmt: skip
                iterations += used
                if not closed:
                    level += 1
                    halvings += 1
                    if level > rules.halvings:
                        return MarchReport(
                            False, start + done * rules.step, steps, iterations, halvings,
                            refinements, unresolved, ringing, strain, shortest, worst, node, level,
                        )  # fmt: skip
                    continue
                surprise, rings, held = tension_surprise(h, lines, before, room.now, room.slope)
                highest = max(room.highest[0], largest_size(room.now.tension))
                allowed = rules.surprise * max(highest, lines.force_scale)
                if surprise > allowed:
                    if level < rules.refinements:
                        level += 1
                        refinements += 1
                        continue
                    unresolved += 1
                room.highest[0] = highest
                shortest = min(shortest, h)
                steps += 1
                done += part
                ringing += rings
                strain += held
                accept(start + done * rules.step, h, rules, lines, has_sea, before, room, record)
                # Longer again where the step then ends with one twice as long.
                ends_evenly = (done / (2.0 * part)) % 1.0 == 0.0
                if level > 0 and ends_evenly and surprise < _LONGER * allowed:
                    level -= 1
        take_sample(sample, rules, lines, led, body, before, room, record)
    time = end * rules.every * rules.step
    return MarchReport(
        True, time, steps, iterations, halvings, refinements, unresolved, ringing, strain,
        shortest, 0.0, 0, level,
    )  # fmt: skip


def largest_size(values: Any) -> float:
    """Largest of values without their signs."""
    largest = 0.0
    for e in range(values.shape[0]):
        largest = max(largest, abs(values[e]))
    return largest


def tension_surprise(
    h: float, lines: MovingLines, before: Moving, now: Moving, slope: Any
) -> tuple[float, float, float]:
    """Compare tensions at a step's end with what they were heading for.

    `h`: length of the step, s; `slope` (bars,): rate of the tensions in the last step, N/s.
    Returns: surprise, ringing, strain: largest difference, N; energy of the differences and of the
    tensions, times h, J s.
    """
    largest = ringing = strain = 0.0
    old, new, length, EA = before.tension, now.tension, lines.length, lines.EA
    for e in range(new.shape[0]):
        off = new[e] - old[e] - h * slope[e]
        largest = max(largest, abs(off))
        over = 0.5 * h * length[e] / EA[e]
        ringing += over * off * off
        strain += over * new[e] * new[e]
    return largest, ringing, strain


def attempt(
    t: float, h: float, rules: Rules, lines: MovingLines, body: BodyNode, led: SeriesRows,
    load: SeriesRows, flow: Flow, has_sea: bool, before: Moving, room: Room,
) -> tuple[bool, int, float, int]:  # fmt: skip
    """Take one step into `room.now`; the state at its start stays as it is."""
    scheme = (rules.alpha_m, rules.alpha_f, rules.beta, rules.gamma)
    now, water = room.now, room.water
    predict(t, h, scheme, lines, body, led, before, now, room.change, room.small)
    copy_rows(before.foot, now.foot)
    if has_sea:
        fill_water(t + h, now.x, lines.start, flow, rules.alpha_f, room.water_before, water)
    fill_series(t + h, load, 0, room.small[0])
    for i in range(3):
        room.force[i] = room.small[0, 0, i]
    return close_step(
        h, scheme, rules.limit, rules.tolerance, lines, body, water, room.force, before, now,
        room.equations, room.small,
    )  # fmt: skip


def accept(
    t: float, h: float, rules: Rules, lines: MovingLines, has_sea: bool, before: Moving, room: Room,
    record: Record,
) -> None:  # fmt: skip
    """Make the end of the step the start of the next; keep what was largest."""
    now, water, slope = room.now, room.water, room.slope
    if largest_size(lines.friction) > 0.0:
        drag_feet(lines, now, h)
        copy_rows(now.foot, before.foot)
    # For the ends: accelerations at the step's end itself.
    shift = rules.alpha_m - rules.alpha_f
    x, v, a, force, at_end = now.x, now.v, now.a, now.force, room.equations.acceleration
    x_0, v_0, a_0, force_0, change = before.x, before.v, before.a, before.force, room.change
    for n in range(v.shape[0]):
        for i in range(3):
            change[n, i] = a[n, i] - a_0[n, i]
            at_end[n, i] = a[n, i] - shift * change[n, i]
    fill_forces(lines, now, water, has_sea, room.booked)
    fill_end_forces(lines, now, at_end, room, room.ends)
    is_booked = has_sea or lines.mass_factor > 0.0 or lines.stiffness_factor > 0.0
    add_works(h, lines, before, now, water, is_booked, room, record.works)
    tension, over, reaction, rub, rub_0 = now.tension, 1.0 / h, now.reaction, now.rub, before.rub
    latest, water_0 = water.latest, room.water_before
    for n in range(v.shape[0]):
        before.reaction[n] = reaction[n]
        rub_0[n, 0], rub_0[n, 1] = rub[n, 0], rub[n, 1]
        for i in range(3):
            x_0[n, i] = x[n, i]
            v_0[n, i] = v[n, i]
            a_0[n, i] = a[n, i]
            force_0[n, i] = force[n, i]
            water_0[n, i] = latest[n, i]
    for e in range(tension.shape[0]):
        slope[e] = (tension[e] - before.tension[e]) * over
        before.tension[e] = tension[e]
    for i in range(3):
        before.body_force[i] = now.body_force[i]
    copy_rows(now.axis, before.axis)
    if is_booked:
        copy_blocks(room.booked, room.booked_before)
        copy_rows(water.wet, room.wet_before)
    copy_blocks(room.ends, room.ends_before)
    if t >= rules.since - 1e-9 * rules.step:
        keep_extremes(t, h, tension, room.ends, record)


def keep_extremes(t: float, h: float, tension: Any, ends: Any, record: Record) -> None:
    """Keep what was largest and least of the bars' tensions and of the forces at the ends."""
    highest, lowest, slack = record.highest, record.lowest, record.slack_time
    longest, stretch = record.longest_slack, record.slack_now
    for e in range(tension.shape[0]):
        T = tension[e]
        highest[e] = max(highest[e], T)
        lowest[e] = min(lowest[e], T)
        if T <= 0.0:
            slack[e] += h
            stretch[e] += h
            longest[e] = max(longest[e], stretch[e])
        else:
            stretch[e] = 0.0
    for k in range(ends.shape[0]):
        for j in range(2):
            square = ends[k, j, 0] ** 2 + ends[k, j, 1] ** 2 + ends[k, j, 2] ** 2
            if square > record.end_highest[k, j] ** 2:
                record.end_highest[k, j] = math.sqrt(square)
                record.end_time[k, j] = t
