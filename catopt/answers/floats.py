"""What is said of floats: how far a current knocks them down, and what is used of their lift."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, cast

from catopt.answers import blocks
from catopt.answers.blocks import Rows, if_known, tabulate
from catopt.words import Measure, Message, Several

if TYPE_CHECKING:
    from catopt.mooring.network_rest import (
        BodyAtRest,
        FloatAtRest,
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


def floating_on_card(rest: LinesAtRest) -> Iterator[blocks.Text]:
    """Say which bodies their lines take under, and how deep the others float."""
    for is_under in (True, False):
        said = [_floats(each) for each in rest.bodies if each.floating.under is is_under]
        if said:
            key = "bodies_under" if is_under else "bodies_afloat"
            yield blocks.Text(Message(f"mooring.{key}", bodies=Several(tuple(said), "; ")))


def _floats(body: BodyAtRest) -> Message:
    """Say how a body floats: its freeboard where it is known, and what is used of its reserve."""
    floating = body.floating
    assert floating.reserve is not None
    is_lifted = floating.pull < 0.0
    values = {"pull": Measure("vertical_force", abs(floating.pull))}
    if not is_lifted:
        values["reserve"] = Measure("vertical_force", floating.reserve)
    if floating.freeboard is None or floating.draught is None:
        key = "lifted_up" if is_lifted else "pulled_down"
        return Message(f"mooring.{key}", name=body.body.name, **values)
    freeboard = floating.freeboard
    values |= {
        "draught": Measure("height", floating.draught),
        "freeboard": Measure("height", abs(freeboard)),
    }
    key = "sunk_by" if freeboard < 0.0 else "floats_lifted" if is_lifted else "floats_at"
    if floating.bed_reaction > 0.0:
        values["reaction"] = Measure("vertical_force", floating.bed_reaction)
        key = "lies_on_bed"
    return Message(f"mooring.{key}", name=body.body.name, **values)


def _used(afloat: FloatAtRest) -> Message:
    """Say what is used of the buoyancy of a float, or how far it is under."""
    if afloat.used < 0.0:
        lifted = Measure("vertical_force", -afloat.used)
        return Message("mooring.float_raised", name=afloat.name, used=lifted)
    return Message(
        "mooring.float_under" if afloat.under > 0.0 else "mooring.float_afloat",
        name=afloat.name,
        under=Measure("height", afloat.under),
        used=Measure("vertical_force", afloat.used),
        buoyancy=Measure("vertical_force", afloat.buoyancy),
    )


def buoyancy_on_card(rest: LinesAtRest) -> Iterator[blocks.Text]:
    """Say which floats are under water, and what is used of those that are not."""
    is_told = rest.network.current_at_rest is not None and rest.network.has_lone_floats
    for key, is_under in (("floats_under", True), ("floats_afloat", False)):
        floats = [_used(each) for each in rest.floats if (each.under > 0.0) is is_under]
        if floats and not (is_under and is_told):
            yield blocks.Text(Message(f"mooring.{key}", floats=Several(tuple(floats), "; ")))
