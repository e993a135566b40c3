"""What is said of bodies and floats: how they float under the pull of their lines, or are under."""

from __future__ import annotations

from typing import TYPE_CHECKING

from catopt.words import Measure, Message, Several

if TYPE_CHECKING:
    from catopt.mooring.network_rest import BodyAtRest, FloatAtRest, LinesAtRest


def bodies_said(rest: LinesAtRest, *, under: bool) -> tuple[Message, ...]:
    """Say which bodies their lines take under, or how deep the others float; of none nothing."""
    said = tuple(_floats(each) for each in rest.bodies if each.floating.under is under)
    key = "mooring.bodies_under" if under else "mooring.bodies_afloat"
    return (Message(key, bodies=Several(said, "; ")),) if said else ()


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


def floats_said(rest: LinesAtRest, *, under: bool) -> tuple[Message, ...]:
    """Say which floats are under water, or what is used of those that are not; of none nothing.

    Those under water that each have a line of their own in a current are said by how it knocks
    them down.
    """
    if under and rest.network.current_at_rest is not None and rest.network.has_lone_floats:
        return ()
    said = tuple(_used(each) for each in rest.floats if (each.under > 0.0) is under)
    key = "mooring.floats_under" if under else "mooring.floats_afloat"
    return (Message(key, floats=Several(said, "; ")),) if said else ()


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
