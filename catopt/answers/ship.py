"""What a ship on its lines, on two time scales, consists of."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from catopt.answers import blocks
from catopt.answers.blocks import Rows, answered, named, section, tabulate, texts
from catopt.answers.check import checks_in_motion, verdict_blocks
from catopt.quantities import QUANTITIES
from catopt.units import lasting
from catopt.words import Message

if TYPE_CHECKING:
    from catopt.verify.two_scales import ShipVerification

_ON_CARD = 3
"""Lines of the mooring that the card has, the most loaded ones."""


def ship_answer(found: ShipVerification) -> blocks.Answer:
    """Lay out a ship in motion: where it goes, what its lines carry, and on what that rests."""
    remarks = tuple(found.remarks)
    whole = answered(
        "ship",
        found.case.title or Message("captions.moored_body"),
        section("captions.motion", *_means(found), _body(found), _lines(found), _rule(found)),
        section("captions.checks_in_motion", *checks_in_motion(found.checks)),
        section("captions.remarks", blocks.Points(remarks)),
    )
    return replace(whole, card=tuple(_card(found)))


def _card(found: ShipVerification) -> Iterator[blocks.CardBlock]:
    yield from verdict_blocks(found.checks)
    yield from _means(found)
    yield _body(found)
    yield _lines(found, most=_ON_CARD)
    yield blocks.Brief(tuple(found.remarks), Message("answers.card_to_be_known"), 4)


def _means(found: ShipVerification) -> Iterator[blocks.Text]:
    """Say what the mean weather is and where the ship lies in it."""
    rest = found.rest
    x, y = rest.force
    values = {
        "x": blocks.about("horizontal_force", x),
        "y": blocks.about("horizontal_force", y),
        "yaw": blocks.about("angle", found.heading),
    }
    yield blocks.Text(Message("floater.mean_weather", **values))


def _rule(found: ShipVerification) -> blocks.Text:
    dynamics = found.case.dynamics
    assert dynamics is not None
    said = Message(
        "floater.rule",
        count=len(found.runs),
        time=lasting(dynamics.duration),
        storm=lasting(dynamics.duration_of_interest),
    )
    return blocks.Text(said, is_small=True)


def _body(found: ShipVerification) -> blocks.Table:
    """Tabulate the parts of offset and yaw."""
    units = (named("offset", ""), named("angle", ""))
    of = Rows((found.offset, found.yaw))
    names = (Message("floater.offset_row"), Message("floater.yaw_row"))
    columns = [texts("quantity", names)]
    columns += [of.texts(key, what, units=units) for key, what in _COLUMNS.items()]
    return tabulate("ship_body", *columns, caption=Message("floater.the_ship"))


def _lines(found: ShipVerification, most: int | None = None) -> blocks.Table:
    """Tabulate the parts of every line's tension at its fairlead, and the combined largest."""
    of = Rows(found.lines)
    combined = [each.fairlead.combined for each in found.lines]
    tension = blocks.rounded("tension", max(combined))
    used = [None if each.MBL is None else each.fairlead.combined / each.MBL for each in found.lines]
    shown = None
    if most is not None and len(combined) > most:
        order = sorted(range(len(combined)), key=lambda k: -round(combined[k], 3))
        shown = tuple(sorted(order[:most]))
    return tabulate(
        "ship_lines",
        of.texts("line", "number"),
        *(of.measured(tension, f"fairlead.{what}", key) for key, what in _COLUMNS.items()),
        of.measured(tension, "anchor.combined", "floater.at_anchor", priority=1),
        blocks.measured(QUANTITIES["utilisation"], used, "floater.of_MBL"),
        caption=Message("floater.line_tensions"),
        shown=shown,
        marked=found.most_loaded,
    )


_COLUMNS = {
    "mean": "mean",
    "floater.slow_deviation": "slow_deviation",
    "floater.slow_largest": "slow_largest",
    "floater.fast_deviation": "fast_deviation",
    "floater.fast_largest": "fast_largest",
    "floater.combined": "combined",
}
