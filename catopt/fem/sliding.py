"""How far blocks on the bed slide under a pull that is known: rigid, held by Coulomb's friction.

    m dv/dt = H - mu max(W - V, 0),   v >= 0

with the horizontal pull H and the pull upwards V of a line on what holds its anchor, at every step
of a run. The run holds the anchor, which does not give: its pulls are above those on a block that
slides, and the mass of the water that the block takes along, which would slow it, is left out.
"""

from __future__ import annotations

import math
from typing import Any, Final

SLIDING: Final = 5
"""Figures of a block: 0 its speed, m/s; 1 the way of the slide that goes on, m; 2 the ways of all
slides, 3 the sum of their squares, 4 how many there were."""


def slide(h: float, before: Any, now: Any, blocks: Any, state: Any) -> None:
    """Let every block slide for a step of h, s.

    `before`, `now` (lines, 2, 3): forces at the lines' ends at its start and end, the anchors'
    first, N; `blocks` (blocks, 3): mass, kg, weight in water, N, and friction; `state` (lines,
    blocks, SLIDING).
    """
    for k in range(state.shape[0]):
        x_0, y_0, x_1, y_1 = before[k, 0, 0], before[k, 0, 1], now[k, 0, 0], now[k, 0, 1]
        pull = 0.5 * (math.sqrt(x_0 * x_0 + y_0 * y_0) + math.sqrt(x_1 * x_1 + y_1 * y_1))
        lift = 0.5 * (before[k, 0, 2] + now[k, 0, 2])
        for b in range(blocks.shape[0]):
            at = state[k, b]
            most = blocks[b, 2] * max(blocks[b, 1] - lift, 0.0)
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
