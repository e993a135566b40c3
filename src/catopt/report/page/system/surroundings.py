"""The surroundings of the body, larger than on the plan: where the load has taken it."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from catopt.quantities import QUANTITIES
from catopt.report.page.figure import WIDTH, Figure, Frame, Legend, Point, Shape, line, path, shape
from catopt.report.page.figure import text as written
from catopt.report.page.system.from_above import (
    arrow,
    axes_mark,
    beside,
    cross,
    force_size,
    middle_beside,
    scale_bar,
    scaled,
    spread,
)
from catopt.report.texts import Words
from catopt.ties import largest

if TYPE_CHECKING:
    from catopt.mooring.solution import SystemSolution

__all__ = ["HEIGHT", "body_words", "disc", "round_body", "surroundings"]

_RADIUS = 190.0
_TOP = 40.0
_NUMBERS = 18.0
_MIDDLE = (WIDTH / 2.0, _TOP + _RADIUS)
"""Of the disc that is drawn; above it; from its edge to the numbers of the lines; its middle."""
HEIGHT = _TOP + 2.0 * _RADIUS + 62.0
"""Of the figure, in its units."""
_ROOM = 1.8
"""Radius of what is drawn over the offset: the force begins where the body is."""
_ARMS = 1.35


def surroundings(solution: SystemSolution, words: Words) -> Figure:
    """Draw the body with its offset from the zero-load position, to scale."""
    offset = math.hypot(*solution.offset)
    frame = disc(solution, _ROOM * offset)
    here = frame.at(solution.position.x, solution.position.y)
    zero = frame.at(solution.neutral.x, solution.neutral.y)
    size = force_size(solution.system.force)
    shapes = [
        *round_body(solution, frame),
        line("offset-mark", *zero, *here),
        *beside(QUANTITIES["offset"].format(offset, unit=True), zero, here, side=-1.0),
        *cross("neutral", *zero),
        *_force(solution, frame, size),
        shape("circle", "fairlead", cx=here[0], cy=here[1], r=8.0),
    ]
    legend = [
        Legend("fairlead", words("system_plan.body")),
        Legend("neutral", words("system_plan.neutral")),
        Legend("offset-mark", words("system_plan.offset")),
        Legend("leg", words("system_plan.hangs")),
    ]
    if any(solution.system.force):
        legend.append(Legend("push", words("system_plan.force")))
    zero_words = words("system_plan.neutral")
    return Figure(
        "system_near",
        words("system_plan.near"),
        HEIGHT,
        tuple(shapes),
        (Point(*here, body_words(solution, words)), Point(*zero, zero_words)),
        tuple(legend),
    )


def disc(solution: SystemSolution, reach: float) -> Frame:
    """Lay out a disc round the zero-load position that reaches so far (m), and round all arms."""
    arms = max(leg.fairlead_radius for leg in solution.system.legs)
    if arms > 0.0:
        reach = max(reach, _ARMS * (arms + math.hypot(*solution.offset)))
    x, y = solution.neutral.x, solution.neutral.y
    middle = WIDTH / 2.0
    box = (middle - _RADIUS, middle + _RADIUS, _TOP, _TOP + 2.0 * _RADIUS)
    return scaled((x - reach, x + reach), (y - reach, y + reach), box)


def round_body(solution: SystemSolution, frame: Frame) -> Iterator[Shape]:
    """Draw the disc, what of the lines lies in it, their numbers, the axes and a scale bar."""
    yield shape("circle", "frame", cx=_MIDDLE[0], cy=_MIDDLE[1], r=_RADIUS)
    ends = _ends(solution, frame)
    for each, (x, y) in zip(solution.lines, ends, strict=True):
        start = frame.at(*each.fairlead)
        yield path("leg", [start, (_MIDDLE[0] + x, _MIDDLE[1] + y)])
        if each.leg.fairlead_radius > 0.0:
            here = frame.at(solution.position.x, solution.position.y)
            yield path("arm", [here, start])
    for number, (x, y) in enumerate(_numbers(ends), start=1):
        style = "measure loaded" if number == solution.most_loaded + 1 else "measure"
        yield written(str(number), x, y + 5.0, style=style)
    yield from axes_mark(34.0, HEIGHT - 18.0)
    yield from scale_bar(frame, WIDTH - 30.0, HEIGHT - 18.0)


def _ends(solution: SystemSolution, frame: Frame) -> list[tuple[float, float]]:
    """Find where each line leaves the disc, from its middle."""
    starts = [frame.at(*each.fairlead) for each in solution.lines]
    return [
        _edge((x - _MIDDLE[0], y - _MIDDLE[1]), each.direction)
        for (x, y), each in zip(starts, solution.lines, strict=True)
    ]


def _numbers(ends: Sequence[tuple[float, float]]) -> list[tuple[float, float]]:
    """Place the numbers of the lines beyond the places where these leave the disc."""
    radius = _RADIUS + _NUMBERS
    angles = spread([math.atan2(-y, x) for x, y in ends], radius)
    return [
        (_MIDDLE[0] + radius * math.cos(angle), _MIDDLE[1] - radius * math.sin(angle))
        for angle in angles
    ]


def _edge(start: tuple[float, float], direction: float) -> tuple[float, float]:
    """Follow a direction from a place in the disc to its edge; both from its middle."""
    ux, uy = math.cos(direction), -math.sin(direction)
    along = start[0] * ux + start[1] * uy
    out = max(along * along - start[0] ** 2 - start[1] ** 2 + _RADIUS**2, 0.0)
    way = math.sqrt(out) - along
    return start[0] + way * ux, start[1] + way * uy


def _force(solution: SystemSolution, frame: Frame, words: str) -> Iterator[Shape]:
    """Draw the force from the body outwards."""
    force = solution.system.force
    if not any(force):
        return
    size = math.hypot(*force)
    ux, uy = force[0] / size, -force[1] / size
    x, y = frame.at(solution.position.x, solution.position.y)
    start, end = (x + 11.0 * ux, y + 11.0 * uy), (x + 0.4 * _RADIUS * ux, y + 0.4 * _RADIUS * uy)
    yield from arrow("push", start, end)
    numbers = _numbers(_ends(solution, frame))

    def clear(side: float) -> float:
        place = middle_beside(start, end, side=side, share=0.8)
        return min(math.dist(place, number) for number in numbers)

    yield from beside(words, start, end, side=largest((1.0, -1.0), clear), share=0.8)


def body_words(solution: SystemSolution, words: Words) -> str:
    """Say where the body is: ``"body: x = -21.738 m, y = 0.000 m, offset 21.738 m"``."""
    length = QUANTITIES["offset"]
    return words(
        "system_plan.body_point",
        x=length.format(solution.position.x, unit=True),
        y=length.format(solution.position.y, unit=True),
        offset=length.format(math.hypot(*solution.offset), unit=True),
    )
