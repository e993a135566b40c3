"""What is said of floats: how far a current knocks them down, and what is used of their lift."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, cast

from catopt.answers import blocks
from catopt.answers.blocks import Rows, if_known, tabulate
from catopt.mooring.afloat_words import bodies_said, floats_said
from catopt.words import Measure, Message

if TYPE_CHECKING:
    from catopt.mooring.network_rest import (
        FloatsInCurrent,
        LinesAtRest,
        LinesInCurrent,
    )


def floats_tables(rest: LinesAtRest) -> Iterator[blocks.Table]:
    """Tabulate how far a current knocks floats down; nothing without one."""
    if rest.network.current_at_rest is None:
        return
    if not rest.network.has_lone_floats:
        yield from _moved_tables(cast("LinesInCurrent", rest))
        return
    heights = cast("FloatsInCurrent", rest).heights
    of = Rows(zip(rest.runs, rest.lines, heights, strict=True))
    yield tabulate(
        "floats",
        of.texts("point", lambda each: rest.network.points[each[0].second].name),
        of.measured("height", lambda each: each[2], "height_in_still_water", symbol=""),
        of.measured("height", lambda each: each[1].fairlead_height, symbol="z"),
        of.measured("excursion", lambda each: each[2] - each[1].fairlead_height, "knocked_down_by"),
        of.measured("span", lambda each: each[1].span, "pushed_aside_by", symbol=""),
        of.measured("angle", lambda each: each[1].anchor.angle, "inclination_at_the_anchor"),
        caption=Message("captions.floats"),
    )


def _moved_tables(rest: LinesInCurrent) -> Iterator[blocks.Table]:
    """Tabulate how far a current moves joints from where they are in still water."""
    both = zip(rest.still_places, rest.points, strict=True)
    joints = [each for each in both if each[1].of.kind == "joint"]
    of = Rows(joints)
    if joints:
        yield tabulate(
            "moved",
            of.texts("point", lambda each: each[1].of.name),
            of.measured("height", lambda each: each[0][2], "height_in_still_water", symbol=""),
            of.measured("height", lambda each: each[1].place[2], symbol="z"),
            of.measured(
                "excursion",
                lambda each: math.dist(each[0][:2], each[1].place[:2]),
                "pushed_aside_by",
            ),
            caption=Message("captions.moved"),
        )


def _moved(rest: LinesInCurrent) -> Message:
    """Say of the one joint where a current takes it."""
    ((still, point),) = (
        both
        for both in zip(rest.still_places, rest.points, strict=True)
        if both[1].of.kind == "joint"
    )
    lengths = {
        "z": point.place[2],
        "still": still[2],
        "aside": math.dist(still[:2], point.place[:2]),
    }
    measures = {key: Measure("height", value) for key, value in lengths.items()}
    return Message("mooring.joint_lies", name=point.of.name, **measures)


def floats_on_card(rest: LinesAtRest) -> Iterator[blocks.CardBlock]:
    """Say of one float in a sentence how far a current knocks it down; of several in a table."""
    for table in floats_tables(rest):
        if table.length > 1:
            yield table
            continue
        if not rest.network.has_lone_floats or any(rest.joints.lost):
            yield blocks.Text(_moved(cast("LinesInCurrent", rest)))
            continue
        (line,), (still,) = rest.lines, cast("FloatsInCurrent", rest).heights
        values = {
            "z": line.fairlead_height,
            "down": still - line.fairlead_height,
            "aside": line.span,
        }
        lengths = {key: Measure("height", value) for key, value in values.items()}
        angle = Measure("angle", line.anchor.angle)
        name = rest.network.points[rest.runs[0].second].name
        yield blocks.Text(Message("mooring.float_lies", name=name, angle=angle, **lengths))


def buoyancy_tables(rest: LinesAtRest) -> Iterator[blocks.Table]:
    """Tabulate what lines use of the buoyancy of floats, and what is left; nothing without one."""
    of = Rows(rest.floats)
    if rest.floats:
        yield tabulate(
            "buoyancy",
            of.texts("point", "name"),
            of.measured("vertical_force", "buoyancy", "buoyancy", symbol=""),
            of.measured("vertical_force", "used", "buoyancy_used", symbol=""),
            of.measured("vertical_force", "left", "buoyancy_left", symbol=""),
            of.measured("utilisation", lambda each: each.used / each.buoyancy, "share_used"),
            *if_known(
                of.measured("height", lambda each: each.under or None, "under", symbol=""),
                of.measured("height", "draught", "draught", symbol=""),
                of.measured("height", "freeboard", "freeboard", symbol=""),
            ),
            caption=Message("captions.buoyancy"),
        )


def floating_tables(rest: LinesAtRest) -> Iterator[blocks.Table]:
    """Tabulate how bodies float as their lines pull; nothing where no reserve is known."""
    if all(each.floating.reserve is None for each in rest.bodies):
        return
    of = Rows(rest.bodies)
    yield tabulate(
        "floating",
        of.texts("body", "body.name"),
        of.measured("vertical_force", "floating.pull", "pulled_down_with", symbol=""),
        of.measured("vertical_force", "floating.reserve", "reserve_buoyancy", symbol=""),
        of.measured("vertical_force", "floating.left", "buoyancy_left", symbol=""),
        of.measured("utilisation", "floating.share", "share_used"),
        *if_known(
            of.measured(
                "height",
                lambda each: None if each.floating.draught is None else -each.rise,
                "deeper_by",
                symbol="",
            ),
            of.measured("height", "floating.draught", "draught", symbol=""),
            of.measured("height", "floating.freeboard", "freeboard", symbol=""),
            of.measured(
                "vertical_force",
                lambda each: each.floating.bed_reaction or None,
                "reaction_of_the_bed",
                symbol="",
            ),
        ),
        caption=Message("captions.floating"),
    )


def afloat_on_card(rest: LinesAtRest) -> Iterator[blocks.Text]:
    """Say how deep bodies float, and what is used of the buoyancy of floats that are afloat.

    What is under water is said before, with the checks.
    """
    for said in (*bodies_said(rest, under=False), *floats_said(rest, under=False)):
        yield blocks.Text(said)
