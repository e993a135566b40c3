"""Where lines of a mooring, and what hangs on them, are: lowest point, touchdowns, sag, loads."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

from catopt.answers import blocks
from catopt.answers.blocks import Rows, tabulate, texts
from catopt.words import Measure, Message

if TYPE_CHECKING:
    from catopt.catenary.solution import Solution
    from catopt.mooring.network_rest import LinesAtRest, PlacedLoad
    from catopt.mooring.solution import SystemSolution


def hung_table(placed: Sequence[Sequence[PlacedLoad]], names: Sequence[str]) -> blocks.Table:
    """Tabulate where clump weights and buoys of lines hang or lie, by the names of the lines."""
    lines, of = Rows(zip(names, placed, strict=True)).within(lambda each: each[1])
    numbers = [k for each in placed for k in range(1, len(each) + 1)]
    named = zip(of.read("state.name"), numbers, strict=True)
    return tabulate(
        "hung",
        lines.texts("line", lambda each: each[0]),
        texts("point_load", [name or number for name, number in named]),
        of.measured("position", "state.position", "position_along", symbol=""),
        of.measured("offset", lambda each: each.place[0], "position", symbol="x"),
        of.measured("offset", lambda each: each.place[1], "position", symbol="y"),
        of.measured("height", lambda each: each.place[2], symbol="z"),
        of.measured("seabed_reaction", "state.seabed_reaction", priority=1),
        caption=Message("captions.hung"),
    )


def shapes_table(solutions: Sequence[Solution], names: Sequence[str]) -> blocks.Table:
    """Tabulate where lines are lowest and touch the bed, their sag, and vertical forces."""
    of = Rows(solutions)
    return tabulate(
        "shapes",
        texts("line", names),
        of.measured("height", "lowest_point.z", "lowest_point", symbol=""),
        of.measured("s", "lowest_point.s", "lowest_along", symbol=""),
        of.measured("x", "lowest_point.x", "lowest_point_from_the_anchor", symbol=""),
        of.measured("height", "sag", "sag", symbol=""),
        of.texts("touchdowns", _touchdowns, only="all" if any(of.read("touchdowns")) else "files"),
        of.measured("vertical_force", "anchor.vertical_force", "vertical_there", symbol=""),
        of.measured("vertical_force", "fairlead.vertical_force", "vertical_here", symbol=""),
        caption=Message("captions.lowest_and_sag"),
    )


def _touchdowns(solution: Solution) -> str:
    """Say how far from its first end a line comes to the bed or leaves it."""
    return ", ".join(f"{Measure('x', each.x):bare}" for each in solution.touchdowns)


def hung_on_card(placed: Iterable[Sequence[PlacedLoad]]) -> Iterator[blocks.Brief]:
    """Say where what hangs on the lines is, as far as there is room."""
    said = [
        Message(
            "mooring.hangs_at",
            name=each.state.name or Message("mooring.load_of_line", number=k, line=line),
            **_place(each),
        )
        for line, loads in enumerate(placed, start=1)
        for k, each in enumerate(loads, start=1)
    ]
    yield from blocks.briefly(said, Message("captions.hung"), 4)


_NOWHERE = 1e-6
"""Of the largest coordinate of a place: less is what solving a plumb line leaves of its span."""


def _place(load: PlacedLoad) -> dict[str, str]:
    least = _NOWHERE * max(map(abs, load.place))
    at = (value if abs(value) > least else 0.0 for value in load.place)
    return {key: f"{Measure('height', value):bare}" for key, value in zip("xyz", at, strict=True)}


def if_free(shapes: blocks.Table, solutions: Iterable[Solution]) -> Iterator[blocks.Table]:
    """Yield the table of sags for a screen, if a line hangs below both its ends, off the bed."""
    if any(each.regime == "below-anchor" for each in solutions):
        yield shapes


def _numbers(count: int) -> list[str]:
    return [f"{number}" for number in range(1, count + 1)]


def places_tables(rest: LinesAtRest) -> Iterator[blocks.Table]:
    """Tabulate where everything on the lines of a network is, and how they sag."""
    lines = rest.named_lines
    names = [each.name for each in lines]
    hung = hung_table([each.point_loads for each in lines], names)
    yield from [hung] if hung.length else []
    yield shapes_table([each.solution for each in lines], names)


def legs_tables(solution: SystemSolution) -> Iterator[blocks.Table]:
    """Tabulate the same of the lines of a body."""
    names = _numbers(len(solution.lines))
    hung = hung_table([each.placed_loads for each in solution.lines], names)
    yield from [hung] if hung.length else []
    yield shapes_table([each.solution for each in solution.lines], names)
