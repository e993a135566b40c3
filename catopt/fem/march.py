"""Many steps in time, in compiled code: halving where a step does not close, and taking samples."""

from __future__ import annotations

import math
from typing import Any, Final, NamedTuple

from catopt.fem.afloat import Afloat, accept_hull, attempt_afloat, sample_hull
from catopt.fem.banded import copy_blocks, copy_rows, copy_values
from catopt.fem.energy_balance import add_works, fill_forces, own_kinetic_energy
from catopt.fem.moving import Moving, MovingLines
from catopt.fem.newmark import close_step, predict
from catopt.fem.sampling import (
    Record,
    Room,
    Rules,
    Setting,
    begin_whole_step,
    fill_end_forces,
    fill_energy,
    follow_all,
    take_sample,
    take_water,
)
from catopt.fem.seabed import drag_feet
from catopt.fem.series import fill_series
from catopt.hydro.hull import fill_sea, keep_sea

SLIDING: Final = 5
"""Figures of a block: 0 its speed, m/s; 1 the way of the slide that goes on, m; 2 the ways of all
slides, 3 the sum of their squares, 4 how many there were."""


def slide(h: float, before: Any, now: Any, blocks: Any, state: Any) -> None:
    """Let every block on the bed slide for a step of h, s: rigid, held by Coulomb's friction.

        m dv/dt = H - min(mu max(W - V, 0), B),   v >= 0

    with the horizontal pull H and the pull upwards V of a line on what holds its anchor, and what
    the soil holds on its base at most, B. The run
    holds the anchor, which does not give: its pulls are above those on a block that slides, and
    the mass of the water that the block takes along, which would slow it, is left out.

    `before`, `now` (lines, 2, 3): forces at the lines' ends at its start and end, the anchors'
    first, N; `blocks` (blocks, 4): mass, kg, weight in water, N, friction and B, N; `state`
    (lines, blocks, SLIDING).
    """
    for k in range(state.shape[0]):
        x_0, y_0, x_1, y_1 = before[k, 0, 0], before[k, 0, 1], now[k, 0, 0], now[k, 0, 1]
        pull = 0.5 * (math.sqrt(x_0 * x_0 + y_0 * y_0) + math.sqrt(x_1 * x_1 + y_1 * y_1))
        lift = 0.5 * (before[k, 0, 2] + now[k, 0, 2])
        for b in range(blocks.shape[0]):
            at = state[k, b]
            most = min(blocks[b, 2] * max(blocks[b, 1] - lift, 0.0), blocks[b, 3])
            speed, faster = at[0], (pull - most) / blocks[b, 0]
            if speed == 0.0 and faster <= 0.0:
                continue
            end = speed + h * faster
            if end > 0.0:
                at[1] += 0.5 * h * (speed + end)
                at[0] = end
                continue
            way = at[1] - 0.5 * speed * speed / faster
            at[2] += way
            at[3] += way * way
            at[4] += 1.0
            at[0] = at[1] = 0.0


_LONGER: Final = 0.2
"""Part of the allowed surprise below which the next step may be twice as long."""
_TAUT: Final = 0.01
"""Part of the largest tension above which a slack bar has gone taut."""
_PASSES: Final = 20.0
"""Bars through which the wave of that goes with steps as short."""
_FINEST: Final = 0.5
"""Part of the longest step in which a bar goes taut below which no tension shortens one."""


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

    closed: bool  # whether the last one did
    full: bool  # whether there is no more room for turning points
    at: int  # where they stopped: whole steps taken since the start
    part: float  # and what is done of the next one
    counts: StepCounts
    worst: float  # where one did not close: force left over, over the largest tension or a line's
    node: int  # weight, with its node, -1 for the body
    level: int  # how often the step is halved at the end
    parted: int  # bar that has reached its strength; -1: none


def march(
    at: int,
    part_done: float,
    end: int,
    most: int,
    level: int,
    setting: Setting,
    before: Moving,
    room: Room,
    record: Record,
    body: Afloat | None,
) -> MarchReport:
    """Step from a part of the whole step `at` on, and take the samples on the way.

    Up to the whole step `end`; until so many steps were tried; until there is no more room for
    turning points; or until a bar has reached its strength. `before`: state there, and then where
    the steps have come to; `body`: what floats at the lines' last nodes; None where these are led
    or pushed.
    """
    used = 0
    steps = iterations = halvings = refinements = unresolved = tried = 0
    ringing = strain = worst = 0.0
    node, parted = 0, -1
    rules, lines = setting.rules, setting.lines
    shortest = rules.step
    done, full, closed = part_done, False, True
    if at == 0 and done == 0.0 and level == 0:  # a first step that was refused is halved by now
        begin(setting, before, room, record, body)
    while at < end and closed and not full and tried < most and parted < 0:
        start = at * rules.step
        while done < 1.0 and closed and not full and tried < most and parted < 0:
            tried += 1
            part = 0.5**level
            h = part * rules.step
            closed, used, worst, node = attempt(
                start, done, part, setting, before, room, body, used
            )
            iterations += used
            if not closed:
                level += 1
                halvings += 1
                closed = level <= rules.halvings
                continue
            seen = compare_tensions(h, rules.transits, lines, before, room)
            highest = max(room.highest[0], largest_size(room.now.tension))
            allowed = rules.surprise * max(highest, lines.force_scale)
            if h > seen.longest or (seen.surprise > allowed and h > seen.least):
                if level < rules.refinements:
                    level = shorter(level, seen.longest, rules)
                    refinements += 1
                    continue
                unresolved += 1
            room.highest[0] = highest
            shortest = min(shortest, h)
            steps += 1
            done += part
            ringing += seen.ringing
            strain += seen.strain
            time = start + done * rules.step
            full = accept(time, h, setting, before, room, record, body)
            parted = beyond_strength(before.tension, setting.strength)
            # Longer again where the step then ends with one twice as long.
            ends_evenly = (done / (2.0 * part)) % 1.0 == 0.0
            may_grow = passed_by(time, 2.0 * h, seen, room) and seen.surprise < _LONGER * allowed
            level -= level > 0 and ends_evenly and may_grow
        if done >= 1.0:
            at, done = at + 1, 0.0
            end_whole_step(at, setting, before, room, record, body)
    fill_energy(lines, before, room, record.at_rest, record.stored)
    record.stored[4] = own_kinetic_energy(lines, before)
    counts = StepCounts(
        steps, iterations, halvings, refinements, unresolved, ringing, strain, shortest
    )
    return MarchReport(closed, full, at, done, counts, worst, node, level, parted)


def beyond_strength(tension: Any, strength: Any) -> int:
    """Return the bar whose tension exceeds its strength by most, over that; -1 for none."""
    most, bar = 1.0, -1
    for e in range(strength.shape[0]):
        over = tension[e] / strength[e]
        if over >= most:
            most, bar = over, e
    return bar


def shorter(level: int, longest: float, rules: Rules) -> int:
    """Halve the step once, and further until it is no longer than `longest`, s."""
    level += 1
    while level < rules.refinements and 0.5**level * rules.step > longest:
        level += 1
    return level


def passed_by(t: float, h: float, seen: Seen, room: Room) -> bool:
    """Say whether at t, s, no wave of a bar that went taut forbids steps of h, s."""
    short = room.short
    if seen.passes > 0.0:
        short[1] = min(short[1], seen.longest) if t < short[0] else seen.longest
        short[0] = max(short[0], t + seen.passes)
    return bool(t >= short[0] or h <= short[1])


def largest_size(values: Any) -> float:
    """Largest of values without their signs."""
    largest = 0.0
    for e in range(values.shape[0]):
        largest = max(largest, abs(values[e]))
    return largest


class Seen(NamedTuple):
    """What the tensions of a step say of its length."""

    surprise: float  # largest difference of one from what it was heading for, N
    ringing: float  # energy of the differences and of the tensions, times the step, J s
    strain: float
    longest: float  # step in which those bars may go taut that did, s; infinite without any
    passes: float  # time in which the wave of that passes its line, s; 0 without any
    least: float  # step below which the bar that surprised resolves nothing more, s


def compare_tensions(
    h: float, transits: float, lines: MovingLines, before: Moving, room: Room
) -> Seen:
    """Compare tensions at the end of a step of h, s, with what they were heading for.

    `room.slope` (bars,): their rate in the last step, N/s. A bar that was slack goes taut where it
    carries more than a part of the largest tension so far.
    """
    worst = ringing = strain = 0.0
    longest, passes, least = math.inf, 0.0, 0.0
    old, new, length, EA = before.tension, room.now.tension, lines.length, lines.EA
    mass, slope, loose = lines.mass, room.slope, room.loose
    taut = _TAUT * max(room.highest[0], lines.force_scale)
    for e in range(new.shape[0]):
        off = new[e] - old[e] - h * slope[e]
        over = 0.5 * h * length[e] / EA[e]
        ringing += over * off * off
        strain += over * new[e] * new[e]
        if abs(off) > worst:
            worst = abs(off)
            least = _FINEST * transits * length[e] * math.sqrt(mass[e] / EA[e])
        if loose[e] and new[e] > taut:
            transit = length[e] * math.sqrt(mass[e] / EA[e])
            longest = min(longest, transits * transit)
            passes = max(passes, _PASSES * transit)
    return Seen(worst, ringing, strain, longest, passes, least)


def begin(setting: Setting, at: Moving, room: Room, record: Record, body: Afloat | None) -> None:
    """Take stock of the state from which a run sets off, and the first sample of it."""
    lines = setting.lines
    fill_end_forces(lines, at, at.a, room, room.ends)
    take_sample(0, setting, at, room, record)
    if setting.rules.since <= 0.0:
        follow_all(0.0, setting, at, room, record)
    fill_forces(lines, at, room.water, setting.has_sea, room.booked_before)
    record.works[6] = -own_kinetic_energy(lines, at)
    copy_blocks(room.ends, room.ends_before)
    copy_rows(room.water.wet, room.wet_before)
    for e in range(at.tension.shape[0]):
        room.loose[e] = at.tension[e] <= 0.0
    if body is not None:
        fill_sea(0.0, body.hull, body.before, setting.flow, body.room)
        keep_sea(body.room)
    begin_whole_step(setting, room)


def end_whole_step(
    at: int, setting: Setting, before: Moving, room: Room, record: Record, body: Afloat | None
) -> None:
    """Take a sample where one is due after `at` steps, and begin the next step."""
    begin_whole_step(setting, room)
    if body is not None:
        keep_sea(body.room)
    every = setting.rules.every
    if at % every == 0:
        take_sample(at // every, setting, before, room, record)
        if body is not None:
            sample_hull(at // every, body)


def attempt(
    start: float,
    done: float,
    part: float,
    setting: Setting,
    before: Moving,
    room: Room,
    body: Afloat | None,
    expected: int,
) -> tuple[bool, int, float, int]:
    """Take one step into `room.now`, as `close_step`; the state at its start stays as it is.

    It is a part of a whole step that begins at `start`, s, of which some is done; `expected`:
    solutions that it takes, as the step before did.
    """
    if body is not None:
        return attempt_afloat(start, done, part, setting, before, room, body, expected)
    now = room.now
    t, h = start + done * setting.rules.step, part * setting.rules.step
    predict(t, h, setting, before, room)
    copy_rows(before.foot, now.foot)
    take_water(start, done, part, setting, before, room)
    fill_series(t + h, setting.load, 0, room.small[0])
    for i in range(3):
        room.force[i] = room.small[0, 0, i]
    return close_step(h, setting, before, room, expected)


def accept(
    t: float,
    h: float,
    setting: Setting,
    before: Moving,
    room: Room,
    record: Record,
    body: Afloat | None,
) -> bool:
    """Make the end of the step the start of the next; keep what was largest.

    Says whether there is no room for one more turning point of a quantity.
    """
    rules, lines, now, water = setting.rules, setting.lines, room.now, room.water
    if body is not None:
        accept_hull(t, rules.since, body)
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
    lead_accelerations(t, setting, at_end, room)
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
    over, tension, slope, loose = 1.0 / h, now.tension, room.slope, room.loose
    taut = _TAUT * max(room.highest[0], lines.force_scale)
    for e in range(tension.shape[0]):
        slope[e] = (tension[e] - before.tension[e]) * over
        loose[e] = tension[e] <= 0.0 or (loose[e] and tension[e] <= taut)
    copy_values(tension, before.tension)
    if is_booked:
        copy_blocks(room.booked, room.booked_before)
        copy_rows(water.wet, room.wet_before)
    if rules.since - 1e-9 * rules.step <= t <= rules.until + 1e-9 * rules.step:
        slide(h, room.ends_before, room.ends, setting.blocks, record.slides)
        keep_extremes(h, tension, record)
        follow_all(t, setting, now, room, record)
    copy_blocks(room.ends, room.ends_before)
    for n in range(record.turn_count.shape[0]):
        if record.turn_count[n] >= record.turns.shape[1]:
            return True
    return False


def lead_accelerations(t: float, setting: Setting, a: Any, room: Room) -> None:
    """Put the accelerations of led ends at t, s, into `a`."""
    lines, prescribed_motion, free = setting.lines, setting.prescribed_motion, setting.body.free
    count = lines.start.shape[0] - 1
    for k in range(count):
        first, last = lines.start[k] + k, lines.start[k + 1] + k
        if count + k < prescribed_motion.base.shape[0] and not lines.lower_free[k]:
            fill_series(t, prescribed_motion, count + k, room.small[0])
            for i in range(3):
                a[first, i] = room.small[0, 2, i]
        if free[0] * free[1] * free[2] == 0.0 and lines.of_end[k, 1] < 0:
            fill_series(t, prescribed_motion, k, room.small[0])
            for i in range(3):
                if free[i] == 0.0:
                    a[last, i] = room.small[0, 2, i]


def keep_extremes(h: float, tension: Any, record: Record) -> None:
    """Keep what was largest and least of the bars' tensions, and how long they had none."""
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
