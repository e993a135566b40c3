"""Results as one line in Python, and as their tables in a notebook."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    import pandas as pd
    from matplotlib.figure import Figure

LONGEST = 60
"""Letters of a text that still go into a line."""

_WIDEST = 200
"""Letters of a value that still go into a cell."""

renderers: dict[str, Callable[[Any], Any]] = {}
"""What shows a result: ``"html"``, ``"screen"``, ``"table"``, ``"figure"``; `catopt` fills it."""


class Displayable:
    """A result, a dataclass, that says its own numbers in a line and leaves what they hold out.

    A property that returns a ``Literal`` is a `functools.cached_property`: of a result with another
    one IPython's completer, jedi, completes nothing at all.
    """

    def __repr__(self) -> str:
        said = (f"{name}={_short(value)}" for name, value in _own(self) if _is_short(value))
        return f"{type(self).__name__}({', '.join(said)})"

    def _repr_html_(self) -> str:
        """Lay out all that the command prints, for a notebook."""
        html: str = renderers["html"](self)
        return html

    def plot(self) -> Figure:
        """Draw what the command draws, as a figure of matplotlib."""
        figure: Figure = renderers["figure"](self)
        return figure

    def to_dataframe(self) -> pd.DataFrame:
        """Return the main table of what the command writes, with the unit in each heading."""
        table: pd.DataFrame = renderers["table"](self)
        return table


class Tabled:
    """A result, a dataclass, that a notebook shows as a table of what it holds, in SI units."""

    def _repr_html_(self) -> str:
        """Lay out names and values; of an array its shape with its least and greatest value."""
        from html import escape

        rows = "".join(
            f"<tr><td>{escape(name)}</td><td>{escape(_in_a_cell(value))}</td></tr>"
            for name, value in _own(self)
        )
        return f"<table><caption>{type(self).__name__} (SI)</caption>{rows}</table>"


def _in_a_cell(value: Any) -> str:
    if hasattr(value, "shape") and value.size > 1:
        return f"array {value.shape}: {value.min():.6g} to {value.max():.6g}"
    if isinstance(value, float):
        return f"{value:.6g}"
    said = repr(value) if hasattr(value, "__dataclass_fields__") else str(value)
    return said if len(said) <= _WIDEST else f"{said[:_WIDEST]}..."


def _own(value: Any) -> list[tuple[str, Any]]:
    from dataclasses import fields

    return [(each.name, getattr(value, each.name)) for each in fields(value)]


def _is_short(value: Any) -> bool:
    """Whether it is a number, a short text, or a few numbers under one name."""
    if isinstance(value, str):
        return 0 < len(value) <= LONGEST
    if hasattr(value, "__dataclass_fields__"):
        own = [each for _, each in _own(value)]
        return all(isinstance(each, (int, float)) and not isinstance(each, bool) for each in own)
    return isinstance(value, (bool, int, float))


def _short(value: Any) -> str:
    if hasattr(value, "__dataclass_fields__"):
        return f"({', '.join(f'{name}={each:.6g}' for name, each in _own(value))})"
    return f"{value:.6g}" if isinstance(value, float) else repr(value)
