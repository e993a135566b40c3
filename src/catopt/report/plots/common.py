"""What all figures have in common: for print, told apart by shape and dash as well as by colour.

Nothing here touches pyplot, so that no window, backend or global figure list is involved.
"""

from __future__ import annotations

from collections.abc import Callable
from io import BytesIO
from textwrap import wrap
from typing import TYPE_CHECKING, Any, Literal

from matplotlib import rc_context
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from catopt.quantities import Quantity
from catopt.report.tables.summary import in_tonne_force

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = [
    "BED",
    "BED_EDGE",
    "BELOW",
    "BLUE",
    "DPI",
    "GREEN",
    "LEFT",
    "ORANGE",
    "PURPLE",
    "RIGHT",
    "SIZE",
    "SKY",
    "STYLE",
    "blank",
    "folded",
    "label_axes",
    "legend_below",
    "render",
    "second_force_axis",
    "set_title",
    "water_and_bed",
]

DPI = 200
SIZE = (7.2, 4.4)
"""Width and height in inches: the text width of an A4 page."""

BLUE, SKY, ORANGE, GREEN, PURPLE = "#0072B2", "#CFE8F7", "#D55E00", "#009E73", "#CC79A7"
"""From the palette of Okabe and Ito, which every kind of colour vision tells apart."""
BED, BED_EDGE = "#E4DACB", "#7A6A55"

STYLE: Any = {
    "font.size": 10,
    "axes.grid": True,
    "grid.color": "#D0D0D0",
    "grid.linewidth": 0.6,
    "axes.axisbelow": True,
    "axes.spines.top": False,
    "lines.linewidth": 1.8,
    "svg.hashsalt": "catopt",
}

LEFT, RIGHT, BELOW = 0.75, 0.15, 1.25
"""Inches around the frame of the line in the water; three rows of legend fit below it."""


def render(figure: Figure, kind: Literal["png", "svg"]) -> bytes:
    """Turn a figure into the bytes of a file, the same for the same figure."""
    stream = BytesIO()
    metadata = {"Date": None} if kind == "svg" else {"Software": None}
    with rc_context(STYLE):
        figure.savefig(stream, format=kind, dpi=DPI, metadata=metadata)
    return stream.getvalue()


def water_and_bed(axes: Axes, water_depth: float) -> None:
    """Show still water and seabed behind what is drawn."""
    low, _ = axes.get_ylim()
    axes.axhspan(0.0, water_depth, color=SKY, linewidth=0.0, zorder=0.5)
    axes.axhspan(low, 0.0, color=BED, linewidth=0.0, zorder=0.5)
    axes.axhline(water_depth, color=BLUE, linewidth=1.4, dashes=(6, 2), label="Still water")
    axes.axhline(0.0, color=BED_EDGE, linewidth=1.4, label="Seabed")
    axes.grid(False)


def blank(size: tuple[float, float], x: Quantity, y: Quantity) -> tuple[Figure, Axes]:
    """Make empty axes in a figure of its own, labelled."""
    with rc_context(STYLE):
        figure = Figure(figsize=size, layout="constrained")
        FigureCanvasAgg(figure)
        axes = figure.add_subplot()
    label_axes(axes, x, y)
    return figure, axes


def label_axes(axes: Axes, x: Quantity, y: Quantity) -> None:
    """Label the axes with quantities and their field units."""
    axes.set_xlabel(x.heading)
    axes.set_ylabel(y.heading)


def second_force_axis(axes: Axes, quantity: Quantity) -> None:
    """Read a force in tf at the right."""
    tonnes = in_tonne_force(quantity)
    there: Callable[[Any], Any] = lambda kN: tonnes.to_field(quantity.to_si(kN))  # noqa: E731
    back: Callable[[Any], Any] = lambda tf: quantity.to_field(tonnes.to_si(tf))  # noqa: E731
    second = axes.secondary_yaxis("right", functions=(there, back))
    second.set_ylabel(tonnes.heading)
    second.ticklabel_format(useOffset=False)


def folded(title: str) -> str:
    """Fold a title to two lines of the page at most."""
    return "\n".join(wrap(title, 78, max_lines=2, placeholder=" ..."))


def set_title(axes: Axes, title: str) -> None:
    """Set a title as text, never as mathematics."""
    axes.set_title(title, fontsize=11, loc="left", parse_math=False)


def legend_below(figure: Figure, most_columns: int) -> None:
    """Set the legend under the axis label, in the middle."""
    handles, labels = figure.axes[0].get_legend_handles_labels()
    place: dict[str, Any] = {"loc": "outside lower center"}
    if figure.get_layout_engine() is None:
        top = (BELOW - 0.45) / figure.get_size_inches()[1]
        place = {"loc": "upper center", "bbox_to_anchor": (0.5, top)}
    columns = min(most_columns, len(labels))
    figure.legend(handles, labels, ncols=columns, handlelength=2.6, frameon=False, **place)
