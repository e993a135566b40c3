"""The loop over many loads on one system; compiled for many, plain for few."""

from __future__ import annotations

from typing import Any

from catopt.mooring.arrangement import Arrangement, Lines
from catopt.mooring.balance import pull_at
from catopt.mooring.descent import BodyLoad, BodyProblem, Freedom
from catopt.mooring.static_equilibrium import static_equilibrium

BODY, PER_LINE = 14, 6
"""Columns that are written of the body: x, y, yaw, force_error, moment_error as in Rest and x, y,
moment, xx, xy, yy, xm, ym, mm as in Pull; of each line: H, V, span, grounded, H_anchor, V_anchor
as in Lines."""


def static_equilibria(
    x: float,
    y: float,
    yaw: float,
    force_x: Any,
    force_y: Any,
    moment: Any,
    freedom: Freedom,
    arrangement: Arrangement,
    start: Lines,
    lines: Lines,
    status: Any,
    line: Any,
    steps: Any,
    body: Any,
    per_line: Any,
) -> None:
    """Bring the body to rest under each load, every time from the same start.

    x, y, yaw are where the body starts. `start`, what is known of the lines near there, is written
    to; `lines` is work space. Also written: status, line, steps as in Rest; `body` load after load
    by BODY; `per_line` for each load, for each column of PER_LINE, line after line.
    """
    count = len(arrangement.anchor_x)
    pull = pull_at(x, y, yaw, arrangement, start, True)
    for i in range(len(force_x)):
        for k in range(count):
            lines.H[k], lines.V[k], lines.span[k] = start.H[k], start.V[k], start.span[k]
            lines.H_S[k], lines.V_S[k] = start.H_S[k], start.V_S[k]
            lines.grounded[k] = start.grounded[k]
            lines.H_anchor[k], lines.V_anchor[k] = start.H_anchor[k], start.V_anchor[k]
        load = BodyLoad(force_x[i], force_y[i], moment[i])
        problem = BodyProblem(load, freedom, arrangement, lines)
        rest = static_equilibrium(x, y, yaw, pull, problem)
        status[i], line[i], steps[i] = rest.status, rest.line, rest.steps
        end = rest.pull
        at = i * 14
        body[at], body[at + 1], body[at + 2] = rest.x, rest.y, rest.yaw
        body[at + 3], body[at + 4] = rest.force_error, rest.moment_error
        body[at + 5], body[at + 6], body[at + 7] = end.x, end.y, end.moment
        body[at + 8], body[at + 9], body[at + 10] = end.xx, end.xy, end.yy
        body[at + 11], body[at + 12], body[at + 13] = end.xm, end.ym, end.mm
        for k in range(count):
            at = i * 6 * count + k
            per_line[at] = lines.H[k]
            per_line[at + count] = lines.V[k]
            per_line[at + 2 * count] = lines.span[k]
            per_line[at + 3 * count] = lines.grounded[k]
            per_line[at + 4 * count] = lines.H_anchor[k]
            per_line[at + 5 * count] = lines.V_anchor[k]
