"""Printed numbers beside computed ones, of one published calculation."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from catopt.reproduce.items import Drawn, Input, Item, Study
from catopt.reproduce.printed import Printed
from catopt.reproduce.published import Published
from catopt.reproduce.verdict import Judgement, by_digits, not_reproducible
from catopt.words import term

_KNOWN = ("m", "N", "kN", "MN", "tf", "rad", "deg", "s", "kN/m", "MN/rad", "MN*m/rad")
_UNITS = {unit: unit for unit in _KNOWN} | {"percent": "%"}
_PURE_NUMBER = "-"


def compare(
    source: Published,
    method: str,
    computed: Mapping[str, float],
    remarks: Mapping[str, str] | None = None,
    computed_by: str = "closed-form",
) -> tuple[Item, ...]:
    """Judge every number that a source printed in the table of a method, digit for digit."""
    said = remarks or {}
    return tuple(
        by_print(
            source,
            method,
            quantity,
            printed,
            computed[quantity],
            computed_by,
            said.get(quantity, ""),
        )
        for quantity, printed in source.printed[method].items()
    )


def by_print(
    source: Published,
    method: str,
    quantity: str,
    printed: Printed,
    computed: float,
    computed_by: str,
    remark: str = "",
) -> Item:
    """Judge one printed number digit for digit."""
    judgement = by_digits(printed, computed, _unit(quantity).strip(_PURE_NUMBER))
    return item_of(source, method, quantity, printed, judgement, computed, computed_by, remark)


def item_of(
    source: Published,
    method: str,
    quantity: str,
    printed: Printed,
    judgement: Judgement,
    computed: float | None = None,
    computed_by: str = "",
    remark: str = "",
) -> Item:
    """Put a printed number and its judgement together; its unit is the end of the quantity."""
    return Item(
        source.source,
        source.name,
        quantity,
        _unit(quantity),
        method,
        computed_by,
        printed,
        computed,
        judgement,
        term(remark),
    )


def set_aside(source: Published, method: str, reason: str) -> tuple[Item, ...]:
    """Tell of every number in the table of a method that nothing computed can be compared with."""
    return tuple(
        item_of(source, method, quantity, printed, not_reproducible(reason))
        for quantity, printed in source.printed[method].items()
    )


def study_of(
    source: Published,
    inputs: Sequence[Input],
    items: Sequence[Item],
    findings: Sequence[str],
    drawn: Sequence[Drawn] = (),
) -> Study:
    """Put a study together that has no swarm."""
    return Study(
        name=source.name,
        title=source.title,
        source=source.source,
        source_title=source.source_title,
        source_where=source.source_where,
        where=source.where,
        inputs=tuple(inputs),
        items=tuple(items),
        findings=tuple(findings),
        drawn=tuple(drawn),
    )


def _unit(quantity: str) -> str:
    """Read the unit off the end of a quantity's name; a pure number has none."""
    return _UNITS.get(quantity.rpartition("_")[2], _PURE_NUMBER)
