"""Many steps in time, in compiled code: halving where a step does not close, and taking samples."""

from __future__ import annotations

import math
from typing import Any, Final, NamedTuple

from catopt.fem.energy_balance import add_works, fill_forces
from catopt.fem.moving import Moving, MovingLines
from catopt.fem.newmark import close_step, predict
from catopt.fem.rows import copy_blocks, copy_rows, copy_values
from catopt.fem.sampling import Record, Room, Setting, fill_end_forces, take_sample
from catopt.fem.seabed import drag_feet
from catopt.fem.series import fill_series
from catopt.fem.water_at import fill_water

_LONGER: Final = 0.2
"""Part of the allowed surprise below which the next step may be twice as long."""


class StepCounts(NamedTuple):
    """What steps took."""

    steps: int = 0
    iterations: int = 0  # of Newton's method
    halvings: int = 0  # times that a step was halved because it did not close
    refinements: int = 0  # times that it was halved because a tension surprised
    unresolved: int = 0  # steps as short as allowed with a tension that still surprised
    ringing: float = 0.0  # strain energy over time, J s: of what in the tensions changes from step
    strain: float = 0.0  # to step; and all
    shortest: float = math.inf  # step, s

    def with_more(self, more: StepCounts) -> StepCounts:
        """Return these counts and those of a further piece of the run together."""
        sums: list[Any] = [a + b for a, b in zip(self[:-1], more[:-1], strict=True)]
        return StepCounts(*[*sums, min(self.shortest, more.shortest)])


class MarchReport(NamedTuple):
    """What became of the steps."""

    done: bool  # whether all were taken
    time: float  # reached, s
    counts: StepCounts
    worst: float  # where it stopped: force left over, over the largest tension or a line's weight
    node: int  # with its node, -1 for the body
    level: int  # how often the step is halved at the end


def march(
    first: int, end: int, level: int, setting: Setting, before: Moving, room: Room, record: Record
) -> MarchReport:
    """Step from sample `first` to sample `end`, and take the samples after the first.

    `before`: state at sample `first`, and then where the steps have come to.
    """
    steps = iterations = halvings = refinements = unresolved = 0
    ringing = strain = 0.0
    rules, lines = setting.rules, setting.lines
    shortest = rules.step
    for sample in range(first + 1, end + 1):
        for j in range(rules.every):
            start = ((sample - 1) * rules.every + j) * rules.step
            done = 0.0
            while done < 1.0:
                part = 0.5**level
                h, time = part * rules.step, start + done * rules.step
                closed, used, worst, node = attempt(time, h, setting, before, room)
                iterations += used
                if not closed:
                    level += 1
                    halvings += 1
                    if level > rules.halvings:
                        counts = StepCounts(
                            steps,
                            iterations,
                            halvings,
                            refinements,
                            unresolved,
                            ringing,
                            strain,
                            shortest,
                        )
                        return MarchReport(False, time, counts, worst, node, level)
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
                accept(start + done * rules.step, h, setting, before, room, record)
                # Longer again where the step then ends with one twice as long.
                ends_evenly = (done / (2.0 * part)) % 1.0 == 0.0
                if level > 0 and ends_evenly and surprise < _LONGER * allowed:
                    level -= 1
        take_sample(sample, setting, before, room, record)
    counts = StepCounts(
        steps, iterations, halvings, refinements, unresolved, ringing, strain, shortest
    )
    return MarchReport(True, end * rules.every * rules.step, counts, 0.0, 0, level)


def largest_size(values: Any) -> float:
    """Largest of values without their signs."""
    largest = 0.0
    for e in range(values.shape[0]):
        largest = max(largest, abs(values[e]))
    return largest


def tension_surprise(
    h: float, lines: MovingLines, before: Moving, now: Moving, slope: Any
) -> tuple[float, float, float]:
    """Compare tensions at the end of a step of h, s, with what they were heading for.

    `slope` (bars,): their rate in the last step, N/s. Returns the largest difference, N; and the
    energy of the differences and of the tensions, times h, J s.
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
    t: float, h: float, setting: Setting, before: Moving, room: Room
) -> tuple[bool, int, float, int]:
    """Take one step into `room.now`, as `close_step`; the state at its start stays as it is."""
    now = room.now
    predict(t, h, setting, before, room)
    copy_rows(before.foot, now.foot)
    if setting.has_sea:
        early, water_0 = setting.rules.alpha_f, room.water_before
        fill_water(t + h, now.x, setting.lines.start, setting.flow, early, water_0, room.water)
    fill_series(t + h, setting.load, 0, room.small[0])
    for i in range(3):
        room.force[i] = room.small[0, 0, i]
    return close_step(h, setting, before, room)


def accept(
    t: float, h: float, setting: Setting, before: Moving, room: Room, record: Record
) -> None:
    """Make the end of the step the start of the next; keep what was largest."""
    rules, lines, now, water = setting.rules, setting.lines, room.now, room.water
    if largest_size(lines.friction) > 0.0:
        drag_feet(lines, now, h)
        copy_rows(now.foot, before.foot)
    # For the ends: accelerations at the step's end itself.
    shift = rules.alpha_m - rules.alpha_f
    a, a_0, change, at_end = now.a, before.a, room.change, room.equations.acceleration
    for n in range(a.shape[0]):
        for i in range(3):
            change[n, i] = a[n, i] - a_0[n, i]
            at_end[n, i] = a[n, i] - shift * change[n, i]
    fill_forces(lines, now, water, setting.has_sea, room.booked)
    fill_end_forces(lines, now, at_end, room, room.ends)
    is_booked = setting.has_sea or lines.mass_factor > 0.0 or lines.stiffness_factor > 0.0
    add_works(h, lines, before, is_booked, room, record.works)
    copy_rows(now.x, before.x)
    copy_rows(now.v, before.v)
    copy_rows(a, a_0)
    copy_rows(now.force, before.force)
    copy_rows(now.rub, before.rub)
    copy_rows(now.axis, before.axis)
    copy_rows(water.latest, room.water_before)
    copy_values(now.reaction, before.reaction)
    copy_values(now.body_force, before.body_force)
    over, tension, slope = 1.0 / h, now.tension, room.slope
    for e in range(tension.shape[0]):
        slope[e] = (tension[e] - before.tension[e]) * over
    copy_values(tension, before.tension)
    if is_booked:
        copy_blocks(room.booked, room.booked_before)
        copy_rows(water.wet, room.wet_before)
    copy_blocks(room.ends, room.ends_before)
    if t >= rules.since - 1e-9 * rules.step:
        keep_extremes(t, h, tension, room.ends, record)


def keep_extremes(t: float, h: float, tension: Any, ends: Any, record: Record) -> None:
    """Keep what was largest and least of the bars' tensions and of the forces at the ends."""
    highest, lowest, slack = record.max_tension, record.min_tension, record.slack_time
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
            if square > record.max_end_force[k, j] ** 2:
                record.max_end_force[k, j] = math.sqrt(square)
                record.time_of_max_end_force[k, j] = t
