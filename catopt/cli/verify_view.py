"""How a verification looks on a terminal."""

from __future__ import annotations

from typing import TYPE_CHECKING

from catopt.report.tables.verify import (
    QUANTITY_OF,
    in_parts,
    part_sentence,
    rough_sentence,
    verdict_sentence,
)
from catopt.verify.compared import worst_of

if TYPE_CHECKING:
    from catopt.cli.output import Output
    from catopt.render.texts import Words
    from catopt.verify.compared import Compared
    from catopt.verify.front import DesignVerification, FrontVerification
    from catopt.verify.result import StaticComparison, Verification

__all__ = ["show_verification"]


def show_verification(
    output: Output, found: Verification | FrontVerification, words: Words
) -> None:
    """Print a verification for a reader.

    Parameters
    ----------
    output : Output
        Where to.
    found : Verification or FrontVerification
        What came out.
    words : Words
        Language.
    """
    from catopt.verify.front import FrontVerification

    if isinstance(found, FrontVerification):
        _front(output, words, found)
        return
    output.text(found.case.title or words.name("Mooring line"), bold=True)
    output.line()
    for part in found.parts:
        with_name = len(found.parts) > 1 or bool(found.case.load_cases)
        _part(output, words, part, with_name=with_name)
    if len(found.parts) > 1:
        output.text(words.sentence(verdict_sentence(found)).text, bold=True)


def _part(output: Output, words: Words, part: StaticComparison, *, with_name: bool) -> None:
    body = [each for each in part.quantities if each.line is None]
    _table(output, words, _title(words, part, with_name=with_name), body)
    if part.kind == "system":
        _lines(output, words, part)
    _meshes(output, words, part)
    output.text(words("verified.scales"))
    output.text(words.sentence(part_sentence(part)).text, bold=True)
    rough = rough_sentence(part)
    if rough:
        output.text(words.sentence(rough).text)
    for remark in part.remarks:
        output.text(words("verified.note", remark=words.sentence(remark).text))
    output.line()


def _title(words: Words, part: StaticComparison, *, with_name: bool) -> str:
    """Say what is compared in the first table."""
    if part.kind == "system":
        return words("verified.body_both")
    if not with_name:
        return words("verified.both")
    return words("checks.under", name=part.name)


def _table(output: Output, words: Words, title: str, quantities: list[Compared]) -> None:
    rows = [
        (
            _label(words, each),
            _value(each, each.closed_form),
            _value(each, each.extrapolated),
            _part_of(each, each.difference_before),
            _part_of(each, each.difference),
            _order(each),
        )
        for each in quantities
    ]
    output.table(
        [
            "",
            words("verified.head_closed"),
            words("verified.head_truss"),
            words("verified.head_finest"),
            words("verified.head_gap"),
            words("verified.head_order"),
        ],
        rows,
        title=title,
        numbers=[1, 2, 3, 4, 5],
    )


def _lines(output: Output, words: Words, part: StaticComparison) -> None:
    """Show each line's tensions, and the largest difference of all its quantities."""
    rows = []
    for k in range(len(part.lines)):
        own = [each for each in part.quantities if each.line == k]
        fairlead, anchor = part.of("fairlead_tension", k), part.of("anchor_tension", k)
        worst = worst_of(own)
        rows.append(
            (
                str(k + 1),
                _value(fairlead, fairlead.closed_form),
                _value(fairlead, fairlead.extrapolated),
                _value(anchor, anchor.closed_form),
                _value(anchor, anchor.extrapolated),
                in_parts(worst.gap),
                _order(fairlead),
            )
        )
    output.table(
        [
            words("verified.head_line"),
            words("verified.head_fairlead"),
            words("verified.head_fairlead_truss"),
            words("verified.head_anchor"),
            words("verified.head_anchor_truss"),
            words("verified.head_largest"),
            words("verified.head_line_order"),
        ],
        rows,
        title=words("verified.lines"),
        numbers=range(7),
    )


def _meshes(output: Output, words: Words, part: StaticComparison) -> None:
    rows = [
        (
            str(mesh.elements),
            str(mesh.iterations),
            f"{mesh.residual:.1e}",
            in_parts(part.mesh_gap(number)),
        )
        for number, mesh in enumerate(part.meshes)
    ]
    output.table(
        [
            words("verified.head_bars"),
            words("verified.head_iterations"),
            words("verified.head_residual"),
            words("verified.head_mesh_gap"),
        ],
        rows,
        title=words("verification.meshes"),
        numbers=[0, 1, 2, 3],
    )


def _label(words: Words, each: Compared) -> str:
    quantity = QUANTITY_OF[each.quantity]
    symbol = f" {quantity.symbol}" if each.quantity.startswith("position") else ""
    return words.heading(f"{quantity.name}{symbol} ({quantity.field_unit})")


def _value(each: Compared, value: float) -> str:
    return QUANTITY_OF[each.quantity].format(value)


def _part_of(each: Compared, difference: float) -> str:
    return in_parts(abs(difference) / each.scale)


def _order(each: Compared) -> str:
    return "-" if each.order is None else f"{each.order:.2f}"


def _front(output: Output, words: Words, front: FrontVerification) -> None:
    output.text(front.title or words.name("Front"), bold=True)
    output.line()
    output.table(
        [
            words("verified.head_design"),
            words("verified.head_load_case"),
            words("verified.head_tension"),
            words("verified.head_truss_tension"),
            words("verified.head_difference"),
            words("verified.head_order"),
            words("verified.head_verdict"),
        ],
        [_design(words, each) for each in front.designs],
        title=words("verified.designs"),
        numbers=[0, 2, 3, 4, 5],
    )
    for each in front.designs:
        if each.failure:
            why = words.sentence(each.failure).text
            output.text(words("verified.failed", number=each.design.number, why=why))
    output.text(words.sentence(verdict_sentence(front)).text, bold=True)


def _design(words: Words, each: DesignVerification) -> tuple[str, ...]:
    number, found = str(each.design.number), each.verification
    if found is None:
        none = words("verified.no_answer")
        return number, each.design.load_case or "", "-", "-", "-", "-", none
    part = found.static
    tension = part.of("fairlead_tension")
    verdict = part.verdict.upper() if part.verdict in ("differs", "not resolved") else part.verdict
    return (
        number,
        part.name,
        _value(tension, tension.closed_form),
        _value(tension, tension.extrapolated),
        in_parts(part.worst.gap),
        _order(tension),
        words.name(verdict),
    )
