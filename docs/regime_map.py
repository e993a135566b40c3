"""Draws docs/regime-map.svg: how a uniform line that does not stretch hangs, over force and height.

``python docs/regime_map.py`` writes it anew. The boundaries are formulas of their own, so that a
test can hold the solver against them.
"""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

__all__ = ["draw", "lift_off", "regime"]

PICTURE = Path(__file__).with_name("regime-map.svg")
ANCHOR = 0.2
"""Height of the raised anchor, as a part of the length of the line."""
FORCES = (0.01, 10.0)
COLOURS = {
    "grounded": "#E4DACB",
    "grounded-between": "#E4DACB",
    "below-anchor": "#CFE8F7",
    "suspended": "#FFFFFF",
    "none": "#BBBBBB",
}


def lift_off(rise: float) -> float:
    """Return H/(wL) at which the line is level at its anchor: (L/r - r/L) / 2, S2 and S3.

    Parameters
    ----------
    rise : float
        r/L, height of the fairlead above the anchor as a part of the length, above 0.
    """
    return 0.5 * (1.0 / rise - rise)


def reaches_the_bed(force: float, height: float, anchor: float) -> bool:
    """Whether a line hung from two points above the bed lies on it in between.

    What hangs from a height h down to where it is level is sqrt(h2 + 2 a h) long, a = H/w. The line
    reaches the bed when it is longer than that from both ends together.

    Parameters
    ----------
    force : float
        H/(wL).
    height, anchor : float
        Of fairlead and anchor above the bed, as parts of the length.
    """
    hanging = [math.sqrt(z * z + 2.0 * force * z) for z in (height, anchor)]
    return sum(hanging) < 1.0


def regime(force: float, height: float, anchor: float) -> str:
    """Name the regime; ``"none"`` where the line is too short. Arguments as above."""
    rise = height - anchor
    if abs(rise) >= 1.0:
        return "none"
    if rise > 0.0 and force >= lift_off(rise):
        return "suspended"
    if anchor == 0.0:
        return "grounded"
    return "grounded-between" if reaches_the_bed(force, height, anchor) else "below-anchor"


def draw() -> Figure:
    """Draw one map for an anchor on the bed and one for a raised anchor."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(7.2, 3.9), layout="constrained")
    left, right = figure.subplots(1, 2)
    _map(left, 0.0, 1.1)
    left.set_title("Anchor on the bed", fontsize=10, loc="left")
    _map(right, ANCHOR, 1.3)
    right.set_title(f"Anchor {ANCHOR:g} L above the bed", fontsize=10, loc="left")
    left.set_ylabel("Height of the fairlead above the bed, h / L")
    _words(left, {"grounded": (0.02, 0.3), "suspended": (0.9, 0.75)})
    left.annotate(
        "on-bed: h = 0", (0.3, 0.0), (0.08, 0.1), arrowprops={"arrowstyle": "->"}, fontsize=9
    )
    left.annotate("too short: h ≥ L", (0.02, 1.04), va="center", fontsize=9, annotation_clip=False)
    _words(
        right,
        {"grounded-between": (0.013, 0.17), "below-anchor": (0.03, 0.9), "suspended": (1.1, 1.0)},
    )
    right.annotate("too short: h - b ≥ L", (0.02, 1.25), va="center", fontsize=9)
    return figure


def _map(axes: Axes, anchor: float, top: float) -> None:
    from matplotlib.colors import ListedColormap

    forces = np.geomspace(*FORCES, 400)
    heights = np.linspace(1e-3, top, 400)
    names = list(COLOURS)
    codes = [[names.index(regime(force, h, anchor)) for force in forces] for h in heights]
    colours = ListedColormap(list(COLOURS.values()))
    axes.pcolormesh(
        forces, heights, codes, cmap=colours, vmin=0, vmax=len(names) - 1, rasterized=True
    )
    axes.contour(
        forces,
        heights,
        codes,
        levels=[k + 0.5 for k in range(len(names) - 1)],
        colors="black",
        linewidths=1.0,
    )
    axes.set_xscale("log")
    axes.set_xlabel("Horizontal force over weight, H / (w L)")
    axes.set_ylim(0.0, top)


def _words(axes: Axes, words: dict[str, tuple[float, float]]) -> None:
    for text, place in words.items():
        axes.annotate(text, place, fontsize=10, weight="bold")


if __name__ == "__main__":
    from matplotlib import rc_context

    with rc_context({"svg.hashsalt": "catopt", "font.size": 9}):
        draw().savefig(PICTURE, metadata={"Date": None}, dpi=150)
