"""What drawings from above share: labels around a circle, arrows, the axes and a scale bar."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from catopt.quantities import QUANTITIES
from catopt.report.page.figure import WIDTH, Frame, Shape, breadth, line, shape, text
from catopt.ties import first_largest

__all__ = [
    "arrow",
    "axes_mark",
    "beside",
    "cross",
    "force_size",
    "middle_beside",
    "scale_bar",
    "scaled",
    "spread",
]

_HEAD = 11.0
"""Length of an arrow's head."""
_LEAST = 25.0
"""Room that a number takes on the circle that it stands on."""
_WORDS = 36.0
"""Half the length of a force in words, about."""


def scaled(
    x: tuple[float, float],
    y: tuple[float, float],
    box: tuple[float, float, float, float],
) -> Frame:
    """Lay ranges of x and y into a box, to one scale, in its middle.

    Parameters
    ----------
    x, y : tuple of float
        Ends, m.
    box : tuple of float
        Left, right, top and bottom, in units of the figure.
    """
    left, right, top, bottom = box
    wide, tall = right - left, bottom - top
    scale = min(
        wide / max(x[1] - x[0], 1e-9),
        tall / max(y[1] - y[0], 1e-9),
    )
    middle_x, middle_y = (x[0] + x[1]) / 2.0, (y[0] + y[1]) / 2.0
    half_x, half_y = 0.5 * wide / scale, 0.5 * tall / scale
    return Frame(
        left, right, top, bottom,
        (middle_x - half_x, middle_x + half_x), (middle_y - half_y, middle_y + half_y),
    )  # fmt: skip


def spread(angles: Sequence[float], radius: float) -> list[float]:
    """Move directions apart until numbers on a circle do not stand on each other.

    Parameters
    ----------
    angles : sequence of float
        rad.
    radius : float
        Of the circle, in units of the figure.

    Returns
    -------
    list of float
        In the order of `angles`, each as near its own as the others let it.
    """
    count = len(angles)
    if count == 0:
        return []
    whole = 2.0 * math.pi
    room = min(_LEAST / radius, whole / count)
    order = _from_widest_gap([angle % whole for angle in angles])
    unrolled: list[float] = []
    turn = 0.0
    for place, index in enumerate(order):
        angle = angles[index] % whole
        if place and angle + turn < unrolled[-1]:
            turn = whole
        unrolled.append(angle + turn)
    moved = [0.0] * count
    for index, angle in zip(order, _apart(unrolled, room), strict=True):
        moved[index] = angle
    return moved


def _from_widest_gap(angles: Sequence[float]) -> list[int]:
    """Order directions counter-clockwise, from the one behind the widest gap."""
    order = sorted(range(len(angles)), key=lambda index: angles[index])
    gaps = [
        (angles[index] - angles[order[place - 1]]) % (2.0 * math.pi)
        for place, index in enumerate(order)
    ]
    start = first_largest(gaps)
    return order[start:] + order[:start]


def _apart(values: Sequence[float], room: float) -> list[float]:
    """Move rising values apart, as little as can be: those that crowd share a mean."""
    # Less their places in the row they have to rise; what falls is pooled into its mean.
    pools: list[tuple[float, int]] = []
    for place, value in enumerate(values):
        mean, size = value - place * room, 1
        while pools and pools[-1][0] > mean:
            other, count = pools.pop()
            mean, size = (mean * size + other * count) / (size + count), size + count
        pools.append((mean, size))
    level = [mean for mean, size in pools for _ in range(size)]
    return [mean + place * room for place, mean in enumerate(level)]


def arrow(style: str, start: tuple[float, float], end: tuple[float, float]) -> Iterator[Shape]:
    """Draw an arrow; its head is filled."""
    (x1, y1), (x2, y2) = start, end
    length = math.hypot(x2 - x1, y2 - y1)
    if length == 0.0:
        return
    ux, uy = (x2 - x1) / length, (y2 - y1) / length
    head = min(_HEAD, length)
    bx, by = x2 - head * ux, y2 - head * uy
    side = 0.42 * head
    yield line(style, x1, y1, bx, by)
    corners = ((x2, y2), (bx - side * uy, by + side * ux), (bx + side * uy, by - side * ux))
    places = " L ".join(f"{x:.2f} {y:.2f}" for x, y in corners)
    yield shape("path", f"{style}-head", d=f"M {places} z")


def cross(style: str, x: float, y: float, size: float = 8.0) -> Iterator[Shape]:
    """Draw an upright cross."""
    yield line(style, x - size, y, x + size, y)
    yield line(style, x, y - size, x, y + size)


def beside(
    words: str,
    start: tuple[float, float],
    end: tuple[float, float],
    *,
    side: float = 1.0,
    share: float = 0.5,
) -> Iterator[Shape]:
    """Write words beside a place of a line: above it or, when it is steep, on its right.

    Parameters
    ----------
    words : str
        What to write.
    start, end : tuple of float
        Of the line.
    side : float
        -1 for the other side.
    share : float
        Of the way from start to end.
    """
    x = start[0] + share * (end[0] - start[0])
    y = start[1] + share * (end[1] - start[1])
    if _is_steep(start, end):
        if not 0.0 < x + side * (11.0 + breadth(words)) < WIDTH:
            side = -side
        anchor = "start" if side > 0.0 else "end"
        yield text(words, x + side * 11.0, y + 5.0, anchor=anchor, style="measure")
    else:
        half = breadth(words) / 2.0
        x = min(max(x, half), WIDTH - half)
        yield text(words, x, y - 11.0 if side > 0.0 else y + 24.0, style="measure")


def middle_beside(
    start: tuple[float, float], end: tuple[float, float], *, side: float = 1.0, share: float = 0.5
) -> tuple[float, float]:
    """Find about where the middle of the words is that `beside` would write."""
    x = start[0] + share * (end[0] - start[0])
    y = start[1] + share * (end[1] - start[1])
    if _is_steep(start, end):
        return x + side * (11.0 + _WORDS), y
    return x, y - side * 17.0


def _is_steep(start: tuple[float, float], end: tuple[float, float]) -> bool:
    return abs(end[1] - start[1]) > abs(end[0] - start[0])


def force_size(force: Sequence[float]) -> str:
    """Write the size of a force (N) for a drawing, in four digits or so: ``"4281 kN"``."""
    size = math.hypot(*force)
    return QUANTITIES["horizontal_force"].format(size, unit=True, digits=0 if size >= 1e5 else 1)


def axes_mark(x: float, y: float) -> Iterator[Shape]:
    """Draw where the axes point, from a corner: azimuths count from x towards y."""
    reach = 40.0
    yield from arrow("axis-mark", (x, y), (x + reach, y))
    yield from arrow("axis-mark", (x, y), (x, y - reach))
    yield text("x", x + reach + 10.0, y + 5.0, style="axis")
    yield text("y", x, y - reach - 8.0, style="axis")


def scale_bar(frame: Frame, right: float, y: float) -> Iterator[Shape]:
    """Draw a bar of a round length that ends at a place, about a quarter of the frame."""
    most = (frame.x[1] - frame.x[0]) / 4.0
    power = 10.0 ** math.floor(math.log10(most) + 1e-9)
    long = max(each * power for each in (0.5, 1.0, 2.0, 5.0) if each * power <= most * (1 + 1e-9))
    length = frame.across(long) - frame.across(0.0)
    left = right - length
    yield shape("rect", "bar-scale", x=left, y=y - 5.0, width=length, height=5.0)
    yield shape("rect", "bar-scale-half", x=left, y=y - 5.0, width=length / 2.0, height=5.0)
    yield text(f"{long:g} m", right, y - 13.0, anchor="end", style="tick")
