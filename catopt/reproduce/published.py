"""Reading the published figures that come with the package."""

from __future__ import annotations

import tomllib
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from typing import Any

from catopt.reproduce.printed import Printed
from catopt.words import Cited, Language, Told


@dataclass(frozen=True)
class Published:
    """One table of ``published.toml`` with its source.

    Attributes
    ----------
    name, title, where : str
        By which it is looked up, what it is about and where in the source.
    source, source_title, source_where : str
        The source's short name, title and publication.
    inputs, swarm : dict
        Numbers that went in, with the unit in the key; settings of a swarm.
    series : dict of str to tuple of float
        Inputs that were varied, with the unit in the key.
    printed : dict of str to dict of str to Printed
        By the source's method, then by quantity with its unit.
    """

    name: str
    title: str
    where: str
    source: str
    source_title: str
    source_where: str
    inputs: dict[str, float]
    swarm: dict[str, int]
    series: dict[str, tuple[float, ...]]
    printed: dict[str, dict[str, Printed]]


@cache
def _data() -> dict[str, Any]:
    text = files("catopt.reproduce").joinpath("published.toml").read_text(encoding="utf-8")
    return tomllib.loads(text)


def _said(text: str | dict[Language, str]) -> str:
    return text if isinstance(text, str) else Told(text)


def published(name: str) -> Published:
    """Look up a published calculation.

    `name`: of its table in ``published.toml``.
    """
    table = _data()[name]
    source = _data()["sources"][table["source"]]
    return Published(
        name=name,
        title=_said(table["title"]),
        where=_said(table["where"]),
        source=table["source"],
        source_title=Cited(source["title"]),
        source_where=Cited(source["where"]),
        inputs=table.get("inputs", {}),
        swarm=table.get("swarm", {}),
        series={key: tuple(values) for key, values in table.get("series", {}).items()},
        printed={
            method: {quantity: Printed(text) for quantity, text in numbers.items()}
            for method, numbers in table["printed"].items()
        },
    )
