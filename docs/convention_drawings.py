"""Draws the pictures of docs/conventions.md: ends, signs at the anchor, lengths, diameters.

``python docs/convention_drawings.py`` writes them anew. The lines in them are catopt's own answers,
so that an angle or a length in a picture is what the names in the picture say.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from catopt import Line, PointLoad, Segment, Solution, solve

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["DRAWINGS", "STYLE", "draw_anchor", "draw_diameters", "draw_lengths", "draw_line"]

FOLDER = Path(__file__).parent
STYLE: dict[Any, Any] = {"svg.hashsalt": "catopt", "font.size": 9, "font.family": "DejaVu Sans"}
INK, QUIET = "#1A1A1A", "#595959"
BLUE, ORANGE, GREEN = "#0072B2", "#C04F00", "#00795A"
WATER, BED, BED_EDGE, SURFACE = "#E6F2FA", "#E4DACB", "#7A6A55", "#3B86B5"

Point = tuple[float, float]

CHAIN = 1.0e3
"""Submerged weight of the lines that are drawn, N/m."""


# -- the line, its ends and the forces on them ----------------------------------------------------


def moored() -> Solution:
    """Solve the line of the first picture: chain with a clump weight, in part on the bed."""
    line = Line([Segment(62.0, CHAIN)], [PointLoad(36.0, 5.0e3, name="clump weight")])
    return solve(line, height=20.0, horizontal_force=3.0e4)


def draw_line() -> Figure:
    """Draw a line with its axes, lengths, heights and the forces at its fairlead."""
    solution = moored()
    span, height, angle = solution.span, solution.fairlead_height, solution.fairlead.angle
    figure, axes = _paper(7.2, 3.6, (-8.0, span + 16.0), (-6.0, height + 11.5))
    _sea(axes, height)
    _hang(axes, solution)

    _dimension(axes, (0.0, -4.4), (span, -4.4), "span S", feet=(0.0, 0.0))
    _dimension(axes, (span + 6.0, 0.0), (span + 6.0, height), "fairlead height")
    _dimension(axes, (span + 13.0, 0.0), (span + 13.0, height), "water depth")
    touchdown = _touchdown(solution)
    axes.annotate(
        "touchdown", (touchdown, 0.0), (touchdown + 2.5, -2.9), fontsize=8.5, color=QUIET,
        arrowprops=_leader(),
    )  # fmt: skip
    axes.annotate("grounded length", (touchdown / 2.0 + 3.0, 0.9), ha="center", color=BLUE)
    middle = _at(solution, 50.0)
    axes.annotate(
        "suspended length", middle, (middle[0] - 5.0, middle[1] + 2.8), ha="right", color=BLUE,
        arrowprops=_leader(BLUE),
    )  # fmt: skip

    load = solution.point_loads[0]
    axes.annotate(
        "clump weight at position s,\nunstretched length from the anchor",
        (load.x, load.z), (load.x - 13.0, load.z + 6.5), fontsize=8.5, color=QUIET, ha="center",
        arrowprops=_leader(),
    )  # fmt: skip

    pull = 13.0
    tip = (span + pull * math.cos(angle), height + pull * math.sin(angle))
    _force(axes, (span, height), tip, "T", (0.6, 0.6))
    _force(axes, (span, height), (tip[0], height), "H", (0.7, 0.0), GREEN)
    _force(axes, (span, height), (span, tip[1]), "V", (-2.0, 0.0), GREEN)
    _arc(axes, (span, height), 4.4, 0.0, angle, "θ > 0")
    axes.annotate("fairlead", (span, height), (span - 1.2, height + 1.0), ha="right")
    axes.annotate("anchor", (0.0, 0.0), (-1.2, 1.3), ha="right")

    _force(axes, (0.0, 0.0), (6.0, 0.0), "x", (-0.6, 1.3), INK)
    _force(axes, (0.0, 0.0), (0.0, 6.0), "z", (-1.0, 0.2), INK)
    return figure


# -- signs at the anchor --------------------------------------------------------------------------


def draw_anchor() -> Figure:
    """Draw the three ways in which a line leaves its anchor, with the signs of V and theta."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(7.2, 2.0), layout="constrained")
    chain = Line([Segment(22.0, CHAIN)])
    ways = (
        ("rises: pulls the anchor up", "V > 0,  θ > 0", {"horizontal_force": 3.0e4}, 0.0),
        ("lies on the bed", "V = 0,  θ = 0", {"horizontal_force": 5.0e3}, 0.0),
        ("raised anchor, hangs down", "V < 0,  θ < 0", {"horizontal_force": 5.0e3}, 5.0),
    )
    for axes, (title, signs, load, raised) in zip(figure.subplots(1, 3), ways, strict=True):
        solution = solve(chain, height=12.0, anchor_height=raised, **load)
        _frame(axes, (-6.0, 24.0), (-1.2, 16.5))
        _sea(axes, 12.0)
        if raised:
            axes.plot([0.0, 0.0], [0.0, raised], color=BED_EDGE, lw=4.0, solid_capstyle="butt")
        _hang(axes, solution)
        axes.set_title(title, fontsize=9, loc="left")
        axes.annotate(signs, (-5.3, 14.0), fontsize=10, color=GREEN)
        at = (0.0, raised)
        way = solution.anchor.angle
        tip = (7.5 * math.cos(way), raised + 7.5 * math.sin(way))
        axes.plot([0.0, 8.0], [raised, raised], color=QUIET, lw=0.8, ls=(0, (4, 3)))
        _force(axes, at, tip, "", (0.0, 0.0))
        if way:
            _arc(axes, at, 6.0, min(0.0, way), max(0.0, way), "θ", 1.25 if way > 0.0 else 0.55)
        axes.plot(*at, "s", color=INK, ms=5)
    return figure


# -- lengths --------------------------------------------------------------------------------------


def draw_lengths() -> Figure:
    """Draw a line on deck and under its tension."""
    figure, axes = _paper(7.2, 1.9, (-1.5, 26.5), (-1.5, 5.4))
    _bar(axes, 3.6, 20.0, 8.0)
    axes.annotate("on deck, without load", (0.0, 4.7), color=QUIET)
    _dimension(axes, (0.0, 2.7), (8.0, 2.7), "position s")
    _dimension(axes, (8.0, 2.7), (20.0, 2.7), "length L counts to here")
    _bar(axes, 0.6, 23.5, 8.0 * 23.5 / 20.0)
    axes.annotate("under its tension", (0.0, 1.4), color=QUIET)
    _dimension(axes, (0.0, -0.5), (23.5, -0.5), "stretched length")
    for low, high in ((8.0, 8.0 * 23.5 / 20.0), (20.0, 23.5)):
        axes.plot([low, high], [3.3, 0.9], color=QUIET, lw=0.8, ls=(0, (4, 3)))
    return figure


def _bar(axes: Axes, z: float, length: float, load: float) -> None:
    axes.plot([0.0, length], [z, z], color=BLUE, lw=2.2, solid_capstyle="butt")
    axes.plot(0.0, z, "s", color=INK, ms=6)
    axes.plot(length, z, "o", color=INK, ms=6)
    axes.plot(load, z, "o", color=ORANGE, ms=7)


# -- diameters ------------------------------------------------------------------------------------


def draw_diameters() -> Figure:
    """Draw the three diameters of a studless chain to one scale."""
    figure, axes = _paper(7.2, 2.1, (-2.0, 25.2), (-3.5, 3.4))
    _links(axes, (3.6, 0.0))
    _dimension(axes, (-0.6, 0.675), (-0.6, 1.675), "d", beside=True, gap=-12.0)
    for z in (0.675, 1.675):
        axes.plot([-0.9, 3.6], [z, z], color=QUIET, lw=0.6)
    _words(axes, 3.6, "nominal diameter d", "of the bar of the links:\nby it a chain is bought")
    _cylinder(axes, 10.4, 14.4, 0.9, WATER)
    _dimension(axes, (15.2, -0.9), (15.2, 0.9), "1.80 d", beside=True)
    _words(
        axes, 12.4, "volume-equivalent diameter", "of the cylinder that displaces\nas much water"
    )  # fmt: skip
    _cylinder(axes, 18.9, 22.3, 0.5, "#F6E3D6")
    _cylinder(axes, 18.9, 22.3, 1.325, "none", (0, (4, 3)))
    _dimension(axes, (23.2, -1.325), (23.2, 1.325), "2.65 d", beside=True)
    axes.annotate("d", (20.6, 0.0), ha="center", va="center", color=INK)
    coefficients = "goes with its coefficient: 2.4 on d\nor 1.2 on 2.65 d, by source"
    _words(axes, 20.6, "drag diameter", coefficients)
    return figure


def _links(axes: Axes, middle: Point) -> None:
    """Draw a studless link, 6 d by 3.35 d, and the ends of two more seen from the side."""
    x, z = middle
    for inset, colour in ((0.0, "#B9C3CC"), (1.0, "white")):
        _rounded(axes, middle, 6.0 - 2.0 * inset, 3.35 - 2.0 * inset, colour)
    for side in (-1.0, 1.0):
        _rounded(axes, (x + side * 2.9, z), 3.8, 1.0, "#D8DDE2")


def _rounded(axes: Axes, middle: Point, wide: float, tall: float, colour: str) -> None:
    from matplotlib.patches import FancyBboxPatch

    style = f"round,pad=0,rounding_size={0.5 * tall - 1e-3}"
    corner = (middle[0] - 0.5 * wide, middle[1] - 0.5 * tall)
    axes.add_patch(FancyBboxPatch(corner, wide, tall, boxstyle=style, fc=colour, ec=INK, lw=1.0))


def _cylinder(
    axes: Axes, left: float, right: float, radius: float, colour: str, line: object = "-"
) -> None:
    from matplotlib.patches import Ellipse, Rectangle

    edge = INK if line == "-" else ORANGE
    axes.add_patch(Rectangle((left, -radius), right - left, 2.0 * radius, fc=colour, ec="none"))
    for z in (-radius, radius):
        axes.plot([left, right], [z, z], color=edge, lw=1.0, ls=line)
    for x in (left, right):
        axes.add_patch(
            Ellipse((x, 0.0), 0.5 * radius, 2.0 * radius, fc=colour, ec=edge, lw=1.0, ls=line)
        )


def _words(axes: Axes, x: float, title: str, text: str) -> None:
    axes.annotate(title, (x, 2.5), ha="center", weight="bold")
    axes.annotate(text, (x, -2.0), ha="center", va="top", fontsize=8.5, color=QUIET)


# -- what the pictures are made of ----------------------------------------------------------------


def _paper(
    width: float, height: float, across: tuple[float, float], up: tuple[float, float]
) -> tuple[Figure, Axes]:
    from matplotlib.figure import Figure

    figure = Figure(figsize=(width, height), layout="constrained")
    axes = figure.subplots()
    _frame(axes, across, up)
    return figure, axes


def _frame(axes: Axes, across: tuple[float, float], up: tuple[float, float]) -> None:
    axes.set_xlim(*across)
    axes.set_ylim(*up)
    axes.set_aspect("equal")
    axes.axis("off")


def _sea(axes: Axes, level: float) -> None:
    left, right = axes.get_xlim()
    bottom, _ = axes.get_ylim()
    axes.axhspan(0.0, level, color=WATER, lw=0.0, zorder=0)
    axes.axhspan(bottom if bottom > -3.0 else -1.2, 0.0, color=BED, lw=0.0, zorder=0)
    axes.plot([left, right], [level, level], color=SURFACE, lw=1.0)
    axes.plot([left, right], [0.0, 0.0], color=BED_EDGE, lw=1.0)


def _hang(axes: Axes, solution: Solution) -> None:
    profile = solution.profile(200)
    axes.plot(profile.x, profile.z, color=BLUE, lw=2.2)
    axes.plot(0.0, solution.anchor_height, "s", color=INK, ms=6)
    axes.plot(solution.span, solution.fairlead_height, "o", color=INK, ms=6)
    for load in solution.point_loads:
        axes.plot(load.x, load.z, "o", color=ORANGE, ms=7)


def _touchdown(solution: Solution) -> float:
    """Place where the line leaves the bed; without stretch it lies straight up to there."""
    return solution.grounded_length


def _at(solution: Solution, s: float) -> Point:
    profile = solution.profile(400)
    index = next(i for i, each in enumerate(profile.s) if each >= s)
    return profile.x[index], profile.z[index]


def _leader(colour: str = QUIET) -> dict[str, object]:
    return {"arrowstyle": "-", "color": colour, "lw": 0.8, "shrinkB": 4.0}


def _force(
    axes: Axes, start: Point, tip: Point, name: str, shift: Point, colour: str = ORANGE
) -> None:
    axes.annotate(
        "", tip, start, arrowprops={"arrowstyle": "-|>", "color": colour, "lw": 1.5, "shrinkA": 0.0,
                                    "shrinkB": 0.0},
    )  # fmt: skip
    if name:
        place = (tip[0] + shift[0], tip[1] + shift[1])
        axes.annotate(name, place, va="center", fontsize=11, color=colour, style="italic")


def _arc(
    axes: Axes,
    middle: Point,
    radius: float,
    low: float,
    high: float,
    name: str,
    outwards: float = 1.25,
) -> None:
    from matplotlib.patches import Arc

    axes.add_patch(
        Arc(middle, 2.0 * radius, 2.0 * radius, theta1=math.degrees(low),
            theta2=math.degrees(high), color=ORANGE, lw=1.2)
    )  # fmt: skip
    way = 0.5 * (low + high)
    far = outwards * radius
    place = (middle[0] + far * math.cos(way), middle[1] + far * math.sin(way))
    axes.annotate(name, place, va="center", color=ORANGE)


def _dimension(
    axes: Axes,
    start: Point,
    end: Point,
    name: str,
    *,
    beside: bool = False,
    gap: float = 5.0,
    feet: Point | None = None,
) -> None:
    """Draw a dimension with its name; `feet` are the heights that its witness lines come from."""
    axes.annotate(
        "", end, start, arrowprops={"arrowstyle": "<|-|>", "color": QUIET, "lw": 0.9,
                                    "shrinkA": 0.0, "shrinkB": 0.0, "mutation_scale": 7.0},
    )  # fmt: skip
    upright = start[0] == end[0]
    for foot, (x, z) in zip(feet or (), (start, end), strict=False):
        axes.plot([x, x], [foot, z], color=QUIET, lw=0.6)
    middle = (0.5 * (start[0] + end[0]), 0.5 * (start[1] + end[1]))
    if beside:
        axes.annotate(name, middle, (gap, 0.0), textcoords="offset points", va="center", color=INK)
    else:
        axes.annotate(
            name, middle, ha="center", va="center", color=INK,
            rotation=90.0 if upright else 0.0,
            bbox={"fc": "white", "ec": "none", "pad": 1.5},
        )  # fmt: skip


DRAWINGS: dict[str, Callable[[], Figure]] = {
    "conventions-line.svg": draw_line,
    "conventions-anchor.svg": draw_anchor,
    "conventions-lengths.svg": draw_lengths,
    "conventions-diameters.svg": draw_diameters,
}
"""Each picture, by its file in docs/."""

if __name__ == "__main__":
    from matplotlib import rc_context

    with rc_context(STYLE):
        for name, draw in DRAWINGS.items():
            draw().savefig(FOLDER / name, metadata={"Date": None}, dpi=150)
