"""How what has a role looks in a drawing, and round values along an axis."""

from __future__ import annotations

import math
import tomllib
from collections.abc import Iterator, Mapping, Sequence
from importlib.resources import files
from typing import Any, NamedTuple

from catopt.figures.chart import Axis, Scale
from catopt.quantities import Quantity


class Look(NamedTuple):
    """How a role looks; what the fields are is said in the table."""

    stroke: str = ""
    width: float = 1.0
    dash: tuple[float, ...] = ()
    fill: str = ""
    opacity: float = 1.0
    sign: str = ""
    size: float = 6.0


_TABLE = tomllib.loads(files(__package__).joinpath("looks.toml").read_text("utf-8"))

COLOURS: Mapping[str, tuple[str, str]] = {
    name: (light, dark) for name, (light, dark) in _TABLE["colours"].items()
}
"""Each colour on light paper and on dark."""
SIGNS: Mapping[str, Mapping[str, Any]] = _TABLE["signs"]
"""Each sign, as every renderer draws it."""
LOOKS: Mapping[str, Look] = {role: Look(**look) for role, look in _TABLE["looks"].items()}
"""The look of each role."""


def stylesheet() -> str:
    """Write the looks as CSS, in light and in dark colours."""
    return "\n".join(_rules()) + "\n"


def _rules() -> Iterator[str]:
    light, dark = (
        "".join(f"--{name}:{pair[index]};" for name, pair in COLOURS.items()) for index in (0, 1)
    )
    yield f":root{{{light}}}"
    yield f"@media screen and (prefers-color-scheme: dark){{:root{{{dark}}}}}"
    for role, look in LOOKS.items():
        rule = f"fill:var(--{look.fill});" if look.fill else "fill:none;"
        if look.opacity < 1.0:
            rule += f"fill-opacity:{look.opacity:g};"
        if look.stroke:
            rule += f"stroke:var(--{look.stroke});stroke-width:{look.width:g};"
        if look.dash:
            rule += f"stroke-dasharray:{' '.join(f'{each:g}' for each in look.dash)};"
        yield f"svg .{role}{{{rule}}}"


Tick = tuple[float, str]
"""A value in SI, and how it is written."""

_POWERS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def axis_title(of: Axis | Scale) -> str:
    """Say what is along an axis, with its unit."""
    unit = of.quantity.field_unit
    return of.label if unit == "-" else f"{of.label} ({unit})".strip()


def tick_marks(axis: Axis, most: int = 6) -> list[Tick]:
    """List the values that are written along an axis, about so many at most."""
    if axis.foot is not None:
        field = axis.quantity.to_field
        return [(value, _power(field(value))) for value in axis.ticks or _decades(axis, most)]
    if axis.ticks:
        return _written(axis.quantity, [axis.quantity.to_field(value) for value in axis.ticks])
    return _round(axis.quantity, *(axis.within or (axis.low, axis.high)), most)


def scale_ticks(axis: Axis, most: int = 6) -> list[Tick]:
    """List the same of the other reading of an axis; values are those of the axis."""
    second = axis.second
    if second is None:
        return []
    marks = _round(second.quantity, axis.low - second.zero, axis.high - second.zero, most)
    return [(value + second.zero, words) for value, words in marks]


def _round(quantity: Quantity, low: float, high: float, most: int) -> list[Tick]:
    return _written(quantity, ticks(quantity.to_field(low), quantity.to_field(high), most))


def _written(quantity: Quantity, values: Sequence[float]) -> list[Tick]:
    words = tick_words(values)
    return [(quantity.to_si(value), said) for value, said in zip(values, words, strict=True)]


def _decades(axis: Axis, most: int) -> list[float]:
    """List powers of ten in the unit of the field: all of a few, each second, third ... of many."""
    low, high = (math.log10(axis.quantity.to_field(end)) for end in (axis.low, axis.high))
    first, last = math.ceil(low - 1e-9), math.floor(high + 1e-9)
    step = max(1, math.ceil((last - first + 1) / most))
    return [axis.quantity.to_si(10.0**power) for power in range(last, first - 1, -step)]


def _power(value: float) -> str:
    if value <= 0.0:
        return "0"
    power = round(math.log10(value))
    return "1" if power == 0 else f"10{str(power).translate(_POWERS)}"


def ticks(low: float, high: float, most: int = 6) -> list[float]:
    """List round values in a range, at most so many: multiples of 1, 2 or 5 times a power of ten.

    `most` is at least 2.
    """
    if not high > low:
        return [low]
    raw = (high - low) / most
    power = 10.0 ** math.floor(math.log10(raw))
    step = next(each * power for each in (1, 2, 5, 10, 20) if each * power >= raw * (1 - 1e-9))
    first, last = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9)
    return [step * index for index in range(first, last + 1)]


def tick_words(values: Sequence[float]) -> list[str]:
    """Write round values, all with the digits that the finest step needs."""
    step = values[1] - values[0] if len(values) > 1 else abs(values[0]) if values else 1.0
    digits = max(0, -math.floor(math.log10(step or 1.0) + 1e-9))
    return [f"{round(value, digits) + 0.0:.{digits}f}" for value in values]
