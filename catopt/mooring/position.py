"""Where a body is that lies on the water."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Position:
    """Where the body is: x and y of its origin (m), yaw counter-clockwise (rad)."""

    x: float
    y: float
    yaw: float = 0.0

    def to_dict(self) -> dict[str, float]:
        """Lay it out as the documents have it."""
        return {"x_m": self.x, "y_m": self.y, "yaw_rad": self.yaw}
