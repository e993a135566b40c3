"""Printed numbers beside computed ones, of one published calculation."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from catopt.reproduce.items import Drawn, Input, Item, Study
from catopt.reproduce.published import Published
from catopt.reproduce.verdict import by_digits, not_reproducible
from catopt.words import term

_UNITS = ("m", "kN", "tf")
_PURE_NUMBER = "-"


def compare(
    source: Published,
    method: str,
    computed: Mapping[str, float],
    remarks: Mapping[str, str] | None = None,
    computed_by: str = "closed-form",
) -> tuple[Item, ...]:
    """Judge every number that a source printed for a method, digit for digit.

    `method`: which of its tables of printed numbers.
    """
    said = remarks or {}
    return tuple(
        Item(
            source=source.source,
            name=source.name,
            quantity=quantity,
            unit=_unit(quantity),
            method=method,
            computed_by=computed_by,
            printed=printed,
            computed=computed[quantity],
            judgement=by_digits(printed, computed[quantity], _unit(quantity).strip(_PURE_NUMBER)),
            remark=term(said.get(quantity, "")),
        )
        for quantity, printed in source.printed[method].items()
    )


def set_aside(source: Published, method: str, reason: str) -> tuple[Item, ...]:
    """Tell of every number printed for a method that nothing computed can be held against it.

    `method`: which of its tables of printed numbers.
    """
    return tuple(
        Item(
            source=source.source,
            name=source.name,
            quantity=quantity,
            unit=_unit(quantity),
            method=method,
            computed_by="",
            printed=printed,
            computed=None,
            judgement=not_reproducible(reason),
        )
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
    unit = quantity.rpartition("_")[2]
    return unit if unit in _UNITS else _PURE_NUMBER
