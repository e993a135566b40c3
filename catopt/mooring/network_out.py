"""One line out of lines between points: what the others carry; a body that is held stays."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace
from itertools import pairwise

from catopt.errors import NoAnswerError, NoEquilibriumError, NotConvergedError
from catopt.largest import first_largest
from catopt.model.joined import joined
from catopt.model.kinds import SomeForce
from catopt.model.load import Checks
from catopt.model.network import LineBetween, Network, Point
from catopt.mooring.fixed_body import at_rest
from catopt.mooring.network_rest import LinesAtRest
from catopt.progress import paced
from catopt.records import Counted, Record
from catopt.words import Message


@dataclass(frozen=True)
class NetworkOut(Record):
    """Lines between points without one of them; in Python lines count from 0."""

    DOCUMENT = (
        "missing+1=missing_line lines_left loose_lines largest_tension most_loaded_line refusal"
    )

    missing: int
    """Which is gone."""
    left: tuple[int, ...] = ()  # those that carry
    # those that hang or lie from one end alone since then: their weight in water, and what hangs on
    # them, stands at the joint where they hang
    loose: tuple[int, ...] = ()
    rest: LinesAtRest | None = None  # None where the joints find no rest, or their solver none
    refusal: str = ""
    """Why the joints find no rest; empty where they do."""
    stopped_short: bool = False  # their solver: nothing is known of that state, its checks fail

    @property
    def why_lost(self) -> Message:
        """Say that there is no equilibrium without this line, or that none was found, and why."""
        key = "mooring.out_not_converged" if self.stopped_short else "mooring.lost"
        return Message(key, number=self.missing + 1, refusal=self.refusal)

    @property
    def lines_left(self) -> tuple[Counted, ...]:
        """Which carry then; none where the joints find no rest."""
        return tuple(number + 1 for number in self.left)

    @property
    def loose_lines(self) -> tuple[Counted, ...]:
        """Which hang or lie from one end alone then, and are not judged."""
        return tuple(number + 1 for number in self.loose)

    @property
    def largest_tension(self) -> SomeForce | None:
        """Of the lines that are left; None where the joints find no rest."""
        return None if self.rest is None else largest_tensions(self.rest)[self._hardest]

    @property
    def most_loaded_line(self) -> Counted | None:
        """The line that has it, the first of several, from 1."""
        return None if self.rest is None else self.left[self._hardest] + 1

    @property
    def _hardest(self) -> int:
        assert self.rest is not None
        return first_largest(largest_tensions(self.rest))


def largest_tensions(rest: LinesAtRest) -> tuple[float, ...]:
    """Return the largest tension of each line, N."""
    return tuple(max(part.max_tension for part in line.segments) for line in rest.lines)


def each_line_out(network: Network) -> tuple[NetworkOut, ...]:
    """Take each line away in turn; a body that is held stays, and the joints rest anew.

    Free bodies come to rest anew, too. Where a solver stops short, that is said of this line, and
    the others are looked at all the same. What happens on the way there, when the line parts, is
    dynamics and not looked at.
    """
    count, still = len(network.lines), replace(network.without_motion(), design=None)
    return tuple(
        _without(still, missing)
        for missing in paced(Message("words.lines_out", total=count), range(count))
    )


def _without(network: Network, missing: int) -> NetworkOut:
    left = {k: line for k, line in enumerate(network.lines) if k != missing}
    points = {point.name: point for point in network.points}
    meeting = Counter(end for line in network.lines for end in (line.start, line.end))
    alone = {name for name, lines in meeting.items() if lines == 1}  # what hangs there may
    loose: list[int] = []
    while (found := _hanging(points, left, alone)) is not None:
        number, end, held = found
        line = left.pop(number)
        loose.append(number)
        if points[held].kind == "joint":
            weight = points[held].submerged_weight - points[end].hung[2]
            weight += line.line.submerged_weight
            points[held] = replace(points[held], submerged_weight=weight)
        points[end] = Point(end, "joint")
    if adrift := _adrift(network, points, left):
        refusal = Message("mooring.adrift", names=", ".join(adrift))
        return NetworkOut(missing, loose=tuple(sorted(loose)), refusal=refusal)
    if not left:
        refusal = Message("mooring.no_line_left")
        return NetworkOut(missing, loose=tuple(sorted(loose)), refusal=refusal)
    ends = {end for line in left.values() for end in (line.start, line.end)}
    lines = tuple(replace(line, name=line.name or f"{k + 1}") for k, line in left.items())
    kept = tuple(point for name, point in points.items() if name in ends)
    made = NetworkOut(missing, tuple(left), tuple(sorted(loose)))
    try:
        return replace(made, rest=at_rest(_left_of(network, kept, lines)))
    except NoAnswerError as error:
        return replace(made, left=(), refusal=error.args[0])
    except NotConvergedError as error:
        return replace(made, left=(), refusal=error.args[0], stopped_short=True)


def _hanging(
    points: Mapping[str, Point], lines: Mapping[int, LineBetween], alone: Collection[str]
) -> tuple[int, str, str] | None:
    """Find a line that ends in a joint with no other line and no pull: its free end, the other.

    `alone`: joints in which no other line ended before.
    """
    for point in points.values():
        along, across, up = point.hung
        if point.kind != "joint" or point.name in alone or up > 0.0 or along or across:
            continue
        ending = [k for k, line in lines.items() if point.name in (line.start, line.end)]
        if len(ending) == 1:
            line = lines[ending[0]]
            return ending[0], point.name, line.end if line.start == point.name else line.start
    return None


def _left_of(
    network: Network, points: tuple[Point, ...], lines: tuple[LineBetween, ...]
) -> Network:
    """Moor the bodies by the lines that are left; each turns as it did while an arm is left.

    NoEquilibriumError: a moment on one that has no arm left.
    """
    bodies = []
    for body in network.bodies:
        ends = (point.place[:2] for point in points if point.body == body.name)
        has_arm = any(end != (body.x, body.y) for end in ends)
        if body.moment and not has_arm:
            said = Message("mooring.body_turns_over", name=body.name, moment=body.moment)
            raise NoEquilibriumError(said, "moment", abs(body.moment))
        bodies.append(replace(body, yaw_free=network.turns(body) and has_arm))
    return replace(
        network, points=points, lines=lines, bodies=tuple(bodies), checks=Checks(), anchor=None
    )


def _adrift(
    network: Network, points: Mapping[str, Point], lines: Mapping[int, LineBetween]
) -> list[str]:
    """List joints that something pulls or lines end in, and bodies, that no line holds any more."""
    pairs = [(line.start, line.end) for line in lines.values()]
    tied = {
        body.name: [p.name for p in points.values() if p.body == body.name]
        for body in network.bodies
    }
    pairs += [pair for each in tied.values() for pair in pairwise(each)]
    fixed = (name for name, p in points.items() if p.kind != "joint" and not p.body)
    held = joined(fixed, pairs)
    ends = {end for line in lines.values() for end in (line.start, line.end)}
    joints = [
        name
        for name, point in points.items()
        if point.kind == "joint"
        and name not in held
        and (name in ends or point.hung[2] > 0.0 or any(point.hung[:2]))
    ]
    return joints + [name for name, own in tied.items() if not held & {*own}]
