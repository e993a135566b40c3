"""Of what a design is made, in words."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from catopt.words import Measure, Message, Several

if TYPE_CHECKING:
    from catopt.design.result import DesignPoint
    from catopt.model import Line


def segment_words(line: Line) -> list[str]:
    """Say what each segment is: ``"chain studless R3 76 mm, 45 m"``."""
    return [
        Message(
            "design.segment_words",
            segment=segment.name or Message("checks.segment", number=number),
            length=segment.length,
        )
        for number, segment in enumerate(line.segments, start=1)
    ]


def clump_weight_words(line: Line) -> list[str]:
    """Say what hangs on the line: ``"2 t at 7 m"``, with the mass in air."""
    return [
        Message("design.weight_at", mass=load.mass / 1e3, position=load.position)
        if load.mass is not None
        else Message(
            "design.force_at",
            force=Measure("point_weight", load.submerged_weight),
            position=load.position,
        )
        for load in line.point_loads
    ]


def anchor_words(point: DesignPoint) -> str:
    """Say what holds the line; empty when the case has no anchor."""
    anchor = point.anchor
    if anchor is None:
        return ""
    if anchor.kind != "sinker":
        return Message("design.drag_anchor")
    if anchor.mass is not None:
        return Message("design.sinker", mass=anchor.mass / 1e3)
    force = Measure("point_weight", anchor.submerged_weight or 0.0)
    return Message("design.sinker_force", force=force)


def layout_words(point: DesignPoint) -> Iterator[Message]:
    """Say how many lines there are and how far away their anchors; nothing of a single line."""
    if point.mooring is not None:
        legs = point.mooring.system.legs
        yield Message("design.around", count=len(legs), radius=legs[0].anchor_radius)
        if point.mooring.pretension is not None:
            force = Measure("horizontal_force", point.mooring.pretension)
            yield Message("design.at_pretension", force=force)


def made_of(point: DesignPoint) -> Several:
    """Say of what a design is made, from the anchor."""
    parts = (
        *layout_words(point),
        *segment_words(point.line),
        *clump_weight_words(point.line),
        anchor_words(point),
    )
    return Several(part for part in parts if part)
