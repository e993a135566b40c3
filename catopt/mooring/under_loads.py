"""Lines between points under each of many loads, as plain Python or compiled."""

from __future__ import annotations

from typing import Any, Final, NamedTuple

from catopt.compiled import compiled, is_compiled
from catopt.mooring.heading import rest_at_heading
from catopt.mooring.net import FORCES, GROUNDED, SPAN, STATE, WHOLE, Known, Net, hang

PER_LINE: Final = FORCES + 2
"""Numbers that are written of a line under a load: FORCES, its length on the bed and its span."""

_A_LINE: Final = 1e-3
"""Time that a line takes to come to rest as plain Python, s."""


class Under(NamedTuple):
    """What came of each load, one after the other; written to.

    `codes`: status, number and steps of Found; `left`: what is left over (N), by freedom in
    `unbalanced`; where the freedoms are (m), the stiffness (N/m), and of each line PER_LINE.
    """

    codes: Any
    left: Any
    q: Any
    unbalanced: Any
    stiffness: Any
    lines: Any


def rest_under_each(loads: Any, net: Net, start: Known, known: Known, under: Under) -> None:
    """Bring all to rest under each load (a row: N for each freedom), every time from the start.

    `known` is work space.
    """
    n, count = len(net.pull), net.used[0]
    hung = hang(net, start, False)
    for m in range(len(under.left)):
        for i in range(n):
            net.pull[i], known.q[i] = loads[m * n + i], start.q[i]
        known.place[:], known.lever[:] = start.place, start.lever
        known.state[:], known.guess[:], known.force[:] = start.state, start.guess, start.force
        found = rest_at_heading(net, known, hung)
        under.codes[3 * m], under.codes[3 * m + 1] = found.status, found.number
        under.codes[3 * m + 2], under.left[m] = found.steps, found.left
        for i in range(n):
            under.q[m * n + i], under.unbalanced[m * n + i] = known.q[i], known.left[i]
        for i in range(n * n):
            under.stiffness[m * n * n + i] = known.stiffness[i]
        for k in range(count):
            at = (m * count + k) * PER_LINE
            for i in range(FORCES):
                under.lines[at + i] = known.force[FORCES * k + i]
            under.lines[at + FORCES] = known.state[STATE * k + GROUNDED]
            under.lines[at + FORCES + 1] = known.state[STATE * k + SPAN]


def rested(net: Net, room: Known, loads: Any, count: int) -> tuple[Known, Under]:
    """Bring a net to rest under each load, as plain Python or compiled, whichever is sooner done.

    Returns what is known under the last of them, too.
    """
    n, lines = len(net.pull), len(net.first)
    sizes = (count, count * n, count * n, count * n * n, count * PER_LINE * lines)
    under = Under([0] * (3 * count), *([0.0] * size for size in sizes))
    run = compiled(rest_under_each, _A_LINE * lines * count)
    if is_compiled(rest_under_each):
        net, room, under = map(as_arrays, (net, room, under))
        loads = _as_array(loads)
    known = room if count == 1 else Known(*(each.copy() for each in room))
    run(loads, net, room, known, under)
    return known, under


def as_arrays(columns: Any) -> Any:
    """Copy a named tuple of lists and numbers, its lists as arrays; for compiled code."""
    named = columns._asdict().items()
    return type(columns)(
        *(
            each if isinstance(each, float) else _as_array(each, is_whole=name in WHOLE)
            for name, each in named
        )
    )


def as_lists(columns: Any) -> Any:
    """Copy arrays as lists; lists stay."""
    return type(columns)(*(x if isinstance(x, list) else x.tolist() for x in columns))


def _as_array(values: Any, *, is_whole: bool = False) -> Any:
    import numpy as np

    return np.array(values, np.int64 if is_whole else np.float64)
