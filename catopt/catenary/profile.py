"""Shape and tension along the line, sampled from its stretches."""

from __future__ import annotations

import math
from collections.abc import Sequence

from catopt.catenary.layout import end_of
from catopt.catenary.stretch import Profile, Stretch


def sample(stretches: Sequence[Stretch], points: int) -> Profile:
    """Sample a laid-out line at about `points` places, every joint and touchdown among them."""
    total = math.fsum(stretch.length for stretch in stretches)
    s: list[float] = []
    x: list[float] = []
    z: list[float] = []
    tension: list[float] = []
    for index, stretch in enumerate(stretches):
        parts = max(1, round((points - 1) * stretch.length / total)) if total > 0.0 else 1
        first = 0 if index == 0 or _jumps(stretches[index - 1], stretch) else 1
        for part in range(first, parts + 1):
            local = stretch.length * part / parts
            place = end_of(stretch, local)
            s.append(stretch.start + local)
            x.append(place[0])
            z.append(place[1])
            tension.append(tension_at(stretch, local))
    return Profile(tuple(s), tuple(x), tuple(z), tuple(tension))


def _jumps(lower: Stretch, upper: Stretch) -> bool:
    """Whether the tension jumps at a joint, so that both of its sides are sampled."""
    below, above = tension_at(lower, lower.length), tension_at(upper, 0.0)
    return abs(above - below) > 1e-9 * max(above, below)


def tension_at(stretch: Stretch, length: float) -> float:
    """Effective tension `length` (m, unstretched) above the lower end of a stretch, N."""
    if stretch.on_bed:
        return stretch.horizontal_force + stretch.friction * length
    return math.hypot(
        stretch.horizontal_force, stretch.vertical_force + stretch.submerged_weight * length
    )


def max_tension(stretch: Stretch) -> float:
    """Largest tension in a stretch, N: at one of its ends, for tension is convex along it."""
    return max(tension_at(stretch, 0.0), tension_at(stretch, stretch.length))


def stretched_length(stretch: Stretch) -> float:
    """Length of a stretch under its tension, m: l + (1/EA) times the integral of T."""
    H, V1, length = stretch.horizontal_force, stretch.vertical_force, stretch.length
    if length == 0.0 or stretch.compliance == 0.0:
        return length
    T1, T2 = tension_at(stretch, 0.0), tension_at(stretch, length)
    if stretch.on_bed:
        return length * (1.0 + stretch.compliance * 0.5 * (T1 + T2))
    S = 2.0 * V1 + stretch.submerged_weight * length
    m = T1 + T2
    if m == 0.0:
        return length
    dx = end_of(stretch, length)[0] - stretch.x - stretch.compliance * H * length
    integral = 0.5 * (H * dx + 0.5 * length * m + 0.5 * length * S * S / m)
    return length + stretch.compliance * integral
