"""The loop over many loads on one system; compiled for many, plain for few."""

from __future__ import annotations

from typing import Any, Final

from catopt.mooring.arrangement import Arrangement, Lines
from catopt.mooring.balance import pull_at
from catopt.mooring.descent import BodyLoad, BodyProblem, Freedom
from catopt.mooring.static_equilibrium import static_equilibrium

BODY: Final = (
    "x",
    "y",
    "yaw",
    "force_error",
    "moment_error",
    "pull_x",
    "pull_y",
    "pull_moment",
    "xx",
    "xy",
    "yy",
    "xm",
    "ym",
    "mm",
)
"""Columns that `static_equilibria` writes of the body, as in Rest and Pull."""

PER_LINE: Final = ("H", "V", "span", "grounded", "H_anchor", "V_anchor")
"""Columns that it writes of each line, as in Lines."""


def static_equilibria(
    x: Any,
    y: Any,
    yaw: Any,
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

    x, y, yaw are where the body starts, or is held. `start`, what is known of the lines near there,
    is written to; `lines` is work space. Also written: status, line, steps as in Rest; `body` load
    after load by BODY; `per_line` for each load, for each column of PER_LINE, line after line.
    """
    count = len(arrangement.anchor_x)
    pull = pull_at(x[0], y[0], yaw[0], arrangement, start, True)
    for i in range(len(x)):
        if i > 0 and (x[i] != x[i - 1] or y[i] != y[i - 1] or yaw[i] != yaw[i - 1]):
            pull = pull_at(x[i], y[i], yaw[i], arrangement, start, True)
        for k in range(count):
            lines.H[k], lines.V[k], lines.span[k] = start.H[k], start.V[k], start.span[k]
            lines.H_S[k], lines.V_S[k] = start.H_S[k], start.V_S[k]
            lines.grounded[k] = start.grounded[k]
            lines.H_anchor[k], lines.V_anchor[k] = start.H_anchor[k], start.V_anchor[k]
        load = BodyLoad(force_x[i], force_y[i], moment[i])
        rest = static_equilibrium(
            x[i], y[i], yaw[i], pull, BodyProblem(load, freedom, arrangement, lines)
        )
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
