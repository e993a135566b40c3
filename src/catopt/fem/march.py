"""Many steps in time, in compiled code: halving where a step does not close, and taking samples."""

from __future__ import annotations

from typing import Final, NamedTuple

from catopt.fem.moving import BodyNode, Moving, MovingLines
from catopt.fem.newmark import close_step, predict
from catopt.fem.sampling import Record, Room, Rules, take_sample
from catopt.fem.seabed import drag_feet
from catopt.fem.series import SeriesRows, fill_series
from catopt.fem.water_at import fill_water
from catopt.waves.kinematics import Flow

__all__ = ["MarchReport", "march"]

_TREMOR: Final = 0.1
"""Change of acceleration within a step that is not looked at, m/s2: rounding of lines at rest."""


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
    ringing : int
        Steps in which accelerations changed by more than velocities over the step: motion that is
        not resolved carries the most energy.
    shortest : float
        Shortest step, s.
    worst : float
        Where it stopped: force left over, over the largest tension or what a line weighs.
    node : int
        With its node, -1 for the body.
    """

    done: bool
    time: float
    steps: int
    iterations: int
    halvings: int
    ringing: int
    shortest: float
    worst: float
    node: int


def march(
    first: int, end: int, rules: Rules, lines: MovingLines, body: BodyNode, led: SeriesRows,
    load: SeriesRows, flow: Flow, has_sea: bool, before: Moving, room: Room, record: Record,
) -> MarchReport:  # fmt: skip
    """Step from sample `first` to sample `end`, and take the samples after the first.

    Parameters
    ----------
    first, end : int
        Samples; sample i is taken at i `every` steps.
    rules : Rules
        How to step.
    lines, body : MovingLines, BodyNode
        What moves.
    led, load : SeriesRows
        Where the ends are led; the force on the body, of one end.
    flow, has_sea : Flow, bool
        The sea, and whether there is one.
    before : Moving
        State at sample `first`, and then where the steps have come to.
    room, record
        Work space, and where the samples go.
    """
    steps = iterations = halvings = ringing = 0
    shortest = rules.step
    for sample in range(first + 1, end + 1):
        for j in range(rules.every):
            start = ((sample - 1) * rules.every + j) * rules.step
            level, part, done = 0, 1.0, 0.0
            while done < 1.0:
                h = part * rules.step
                closed, used, worst, node = attempt(
                    start + done * rules.step, h, rules, lines, body, led, load, flow, has_sea,
                    before, room,
                )  # fmt: skip
                iterations += used
                if not closed:
                    level += 1
                    halvings += 1
                    part *= 0.5
                    if level > rules.halvings:
                        return MarchReport(
                            False, start + done * rules.step, steps, iterations, halvings,
                            ringing, shortest, worst, node,
                        )  # fmt: skip
                    shortest = min(shortest, part * rules.step)
                    continue
                steps += 1
                done += part
                ringing += accept(start + done * rules.step, h, rules, lines, before, room, record)
                # Longer again where the step then ends with one twice as long.
                if level > 0 and (done / (2.0 * part)) % 1.0 == 0.0:
                    level -= 1
                    part *= 2.0
        take_sample(sample, rules, lines, led, body, before, room, record)
    time = end * rules.every * rules.step
    return MarchReport(True, time, steps, iterations, halvings, ringing, shortest, 0.0, 0)


def attempt(
    t: float, h: float, rules: Rules, lines: MovingLines, body: BodyNode, led: SeriesRows,
    load: SeriesRows, flow: Flow, has_sea: bool, before: Moving, room: Room,
) -> tuple[bool, int, float, int]:  # fmt: skip
    """Take one step into `room.now`; the state at its start stays as it is."""
    scheme = (rules.alpha_m, rules.alpha_f, rules.beta, rules.gamma)
    now, water = room.now, room.water
    predict(t, h, scheme, lines, body, led, before, now, room.small)
    now.foot[:] = before.foot
    if has_sea:
        fill_water(t + h, now.x, lines.start, flow, rules.alpha_f, room.water_before, water)
    fill_series(t + h, load, 0, room.small[0])
    room.force[:] = room.small[0, 0]
    return close_step(
        h, scheme, rules.limit, rules.tolerance, lines, body, water, room.force, before, now,
        room.equations, room.small,
    )  # fmt: skip


def accept(
    t: float, h: float, rules: Rules, lines: MovingLines, before: Moving, room: Room,
    record: Record,
) -> int:  # fmt: skip
    """Make the end of the step the start of the next; keep what was largest.

    Returns 1 when accelerations changed by more than velocities over the step.
    """
    now, latest = room.now, room.water.latest
    if lines.friction > 0.0:
        drag_feet(lines, now, h)
        before.foot[:] = now.foot
    # For the ends: accelerations at the step's end itself.
    shift = rules.alpha_m - rules.alpha_f
    x, v, a, force, at_end = now.x, now.v, now.a, now.force, room.equations.acceleration
    x_0, v_0, a_0, force_0, water_0 = before.x, before.v, before.a, before.force, room.water_before
    swing = speed = 0.0
    for n in range(x.shape[0]):
        for i in range(3):
            swing += (a[n, i] - a_0[n, i]) ** 2
            speed += v[n, i] ** 2
            at_end[n, i] = a[n, i] - shift * (a[n, i] - a_0[n, i])
            x_0[n, i] = x[n, i]
            v_0[n, i] = v[n, i]
            a_0[n, i] = a[n, i]
            force_0[n, i] = force[n, i]
            water_0[n, i] = latest[n, i]
    before.reaction[:] = now.reaction
    before.body_force[:] = now.body_force
    before.axis[:] = now.axis
    before.tension[:] = now.tension
    rings = int(swing > x.shape[0] * _TREMOR**2 and h * h * swing > speed)
    if t < rules.since - 1e-9 * rules.step:
        return rings
    tension, highest, lowest, slack = now.tension, record.highest, record.lowest, record.slack_time
    for e in range(tension.shape[0]):
        T = tension[e]
        highest[e] = max(highest[e], T)
        lowest[e] = min(lowest[e], T)
        if T <= 0.0:
            slack[e] += h
    return rings
