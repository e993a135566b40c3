"""Reading the published figures that come with the package."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from typing import Any, Final

from catopt.reproduce.items import Heading, Input, Printed
from catopt.units import UNITS, Dimension
from catopt.words import Cited, Language, Told

KN: Final = UNITS[Dimension.FORCE]["kN"]
TF: Final = UNITS[Dimension.FORCE]["tf"]

Given = Mapping[str, float | tuple[float, ...]]


@dataclass(frozen=True)
class Published(Heading):
    """One table of ``published.toml`` with its source.

    `inputs`, `series`: numbers that went in, and those that were varied, with the unit in the key;
    `stated`: what is said of them; `printed`: by the source's method, then by quantity with its
    unit.
    """

    inputs: dict[str, float]
    series: dict[str, tuple[float, ...]]
    stated: tuple[Input, ...]
    printed: dict[str, dict[str, Printed]]


@cache
def _data() -> dict[str, Any]:
    text = files("catopt.reproduce").joinpath("published.toml").read_text(encoding="utf-8")
    return tomllib.loads(text)


def _said(text: str | dict[Language, str]) -> str:
    return text if isinstance(text, str) else Told(text)


def published(name: str) -> Published:
    """Look up a published calculation by the name of its table in ``published.toml``."""
    table = _data()[name]
    source = _data()["sources"][table["source"]]
    inputs = table.get("inputs", {})
    series = {key: tuple(values) for key, values in table.get("series", {}).items()}
    return Published(
        name=name,
        title=_said(table["title"]),
        where=_said(table["where"]),
        source=table["source"],
        source_title=Cited(source["title"]),
        source_where=Cited(source["where"]),
        inputs=inputs,
        series=series,
        stated=tuple(_stated(row, series | inputs) for row in table.get("stated", inputs)),
        printed={
            method: {quantity: Printed(text) for quantity, text in numbers.items()}
            for method, numbers in table["printed"].items()
        },
    )


def _stated(row: str | list[Any], given: Given) -> Input:
    """Say what went in, by a row of ``stated`` as the head of ``published.toml`` describes it."""
    if isinstance(row, str):
        words, unit = _data()["labels"][row]
        row = [words, row, unit]
    words, value, unit, *origin = row
    if isinstance(value, str):
        value = ", ".join(_written(given.get(key, key)) for key in value.split(", "))
    return Input(_said(words), _said(value), unit, *map(_said, origin))


def _written(value: str | float | tuple[float, ...]) -> str:
    """Write numbers with the digits that they have; words stay as they are."""
    if isinstance(value, tuple):
        return ", ".join(map(_written, value))
    return value if isinstance(value, str) else f"{value:.9g}"
