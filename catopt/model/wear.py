"""What corrosion and wear leave of a line: less diameter, and with it less weight."""

from __future__ import annotations

from dataclasses import replace
from typing import Literal

from catopt.errors import refused
from catopt.model.line import Line, Segment, line_kind
from catopt.model.service import Service
from catopt.words import Message

Condition = Literal["new", "worn"]
"""Of a line: as it was laid, or at the end of its service life."""


def diameter_loss(segment: Segment, service: Service | None) -> float:
    """Return the loss of nominal diameter over the service life, m.

    A fibre rope does not corrode: it loses nothing unless the segment has a wear rate of its own.
    InputError: the table of wear has no rate for the segment's zone.
    """
    has_own = segment.wear_rate is not None or segment.wear_zone
    if service is None or (line_kind(segment.component) == "rope" and not has_own):
        return 0.0
    return service.diameter_loss(segment.wear_rate, segment.wear_zone)


def end_diameter(segment: Segment, service: Service | None) -> float | None:
    """Return the nominal diameter at the end of the service life, m; None when it is not known.

    InputError: there is wear but no diameter to take it off, or the wear takes all of it.
    """
    loss, new = diameter_loss(segment, service), segment.nominal_diameter
    if loss == 0.0:
        return new
    if new is None:
        allowed = Message("refused_case.missing_wear_taken_off_give")
        raise refused("diameter", "", allowed, "wear")
    if not new > loss:
        allowed = Message("checks.worn_away", loss=loss * 1e3)
        raise refused("diameter", f"{new * 1e3:g} mm", allowed, "wear")
    return new - loss


def worn_line(line: Line, service: Service | None) -> Line:
    """Return the line at the end of its service life.

    Weight, mass and stiffness are those of the cross-section that is left, (d_end/d)^2 of the new
    one; the nominal diameter stays that of the new line, as sizes are named by it. Strengths stay,
    for the checks take the wear off them. What it weighs with clump weights does not wear.
    """
    return Line((_worn(each, service) for each in line.segments), line.point_loads)


def left_of_section(segment: Segment, service: Service | None) -> float:
    """Return the share of the cross-section that is left at the end of the service life."""
    end, new = end_diameter(segment, service), segment.nominal_diameter
    return 1.0 if end is None or new is None else (end / new) ** 2


def _worn(segment: Segment, service: Service | None) -> Segment:
    left = left_of_section(segment, service)
    if left == 1.0:
        return segment
    return replace(
        segment,
        submerged_weight=left * segment.submerged_weight,
        EA=left * segment.EA,
        mass=None if segment.mass is None else left * segment.mass,
    )
