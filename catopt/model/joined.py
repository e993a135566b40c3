"""What lines between points hang together by, and what nothing holds."""

from __future__ import annotations

import itertools
from collections import Counter
from collections.abc import Iterable, Sequence

from catopt.errors import Problem
from catopt.model.kinds import Findings
from catopt.words import Message


def network_misfits(
    names: list[str],
    joints: list[str],
    ends: list[tuple[str, str]],
    tied: Iterable[Sequence[str]],
) -> list[Problem]:
    """List ends that are no points, names given twice, joints and bodies that nothing holds.

    `tied`: the fairleads of each body that is free.
    """
    found = Findings()
    for k, name in enumerate(names):
        if name in names[:k]:
            found.add(
                f"points[{k}].name", name, Message("refused_case.another_point_has_this_name")
            )
    for k, (start, end) in enumerate(ends):
        for key, name in (("start", start), ("end", end)):
            if name not in names:
                allowed = Message("refused_case.no_such_point_there_are", names=", ".join(names))
                found.add(f"lines[{k}].{key}", name, allowed)
        if start == end:
            found.add(f"lines[{k}].end", end, Message("refused_case.line_begins_there_too"))
    meeting = Counter(name for pair in ends for name in {*pair})
    of_bodies = [*tied]
    free = {*joints, *itertools.chain(*of_bodies)}
    ties = [pair for each in of_bodies for pair in itertools.pairwise(each)]
    held = joined({*names} - free, [*ends, *ties])
    return found.problems or [
        Problem(f"points[{k}]", name, why)
        for k, name in enumerate(names)
        if (why := _loose(meeting[name], name in held))
    ]


def joined(to: Iterable[str], ends: Iterable[Iterable[str]]) -> set[str]:
    """Gather the points that lines join to some, by way of any others; these among them."""
    found, pairs = {*to}, [{*pair} for pair in ends]
    while more := {end for pair in pairs if pair & found for end in pair} - found:
        found |= more
    return found


def _loose(meeting: int, is_held: bool) -> str:
    """Say why nothing holds a point, or what it is for; empty where that is in order."""
    if not meeting:
        return Message("refused_case.no_line_ends_here")
    return "" if is_held else Message("refused_case.no_line_leads_to_an_anchor")
