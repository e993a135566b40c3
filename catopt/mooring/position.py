"""Where a body is that lies on the water."""

from __future__ import annotations

from dataclasses import dataclass

from catopt.model.kinds import Angle, Place
from catopt.records import Record


@dataclass(frozen=True)
class Position(Record):
    """Where the body is."""

    DOCUMENT = "x y yaw"

    x: Place
    """Of its origin."""
    y: Place
    """Of its origin."""
    yaw: Angle = 0.0
    """Counter-clockwise."""
