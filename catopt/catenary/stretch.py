"""The line laid out: its uniform stretches, and points sampled along them."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Stretch:
    """A uniform part of the line that either hangs or lies on the bed throughout.

    Attributes
    ----------
    start, length : float
        Unstretched arc length of its lower-s end, and its unstretched length, m.
    submerged_weight, compliance : float
        N/m and 1/EA in 1/N.
    x, z : float
        Where its lower-s end is, m (z above the seabed).
    horizontal_force, vertical_force : float
        On its lower-s end, N.
    friction : float
        What its tension gains per unstretched length towards the fairlead by bed friction, N/m.
    on_bed : bool
        Whether it lies on the bed.
    piece : int
        Which piece of the line it belongs to, counted from the anchor.
    gathered : float
        Part of its reach that is used: below 1 where a slack line lies in bights on the bed.
    slope : float
        Sine of the inclination of a stretch that has neither weight nor force.
    """

    start: float
    length: float
    submerged_weight: float
    compliance: float
    x: float
    z: float
    horizontal_force: float
    vertical_force: float
    friction: float
    on_bed: bool
    piece: int = 0
    gathered: float = 1.0
    slope: float = 0.0


@dataclass(frozen=True)
class Profile:
    """The line's shape and effective tension at rising unstretched arc lengths; m and N."""

    s: tuple[float, ...]
    x: tuple[float, ...]
    z: tuple[float, ...]
    tension: tuple[float, ...]
