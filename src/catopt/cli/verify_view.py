"""How a verification looks on a terminal."""

from __future__ import annotations

from typing import TYPE_CHECKING

from catopt.report.verify import (
    QUANTITY_OF,
    in_parts,
    part_sentence,
    rough_sentence,
    verdict_sentence,
)

if TYPE_CHECKING:
    from catopt.cli.output import Output
    from catopt.verify.compared import Compared
    from catopt.verify.front import DesignVerification, FrontVerification
    from catopt.verify.result import StaticComparison, Verification

__all__ = ["show_verification"]

_SCALES = (
    "Differences (Diff.) are over the fairlead tension, the line's length or a radian "
    "(docs/verify.md)."
)


def show_verification(output: Output, found: Verification | FrontVerification) -> None:
    """Print a verification for a reader.

    Parameters
    ----------
    output : Output
        Where to.
    found : Verification or FrontVerification
        What came out.
    """
    from catopt.verify.front import FrontVerification

    if isinstance(found, FrontVerification):
        _front(output, found)
        return
    output.text(found.case.title or "Mooring line", bold=True)
    output.line()
    for part in found.parts:
        _part(output, part, with_name=len(found.parts) > 1 or bool(found.case.load_cases))
    if len(found.parts) > 1:
        output.text(verdict_sentence(found), bold=True)


def _part(output: Output, part: StaticComparison, *, with_name: bool) -> None:
    title = f"Load case {part.name}" if with_name else "Closed form and truss model"
    if part.refusal:
        title = f"Load case {part.name}: truss model" if with_name else "Truss model"
        output.text(f"The closed form refuses: {part.refusal}")
        output.line()
    body = [each for each in part.quantities if each.line is None]
    if part.kind == "system":
        _table(output, "Body: closed form and truss model" if not part.refusal else "Body", body)
        _lines(output, part)
    else:
        _table(output, title, body)
    _meshes(output, part)
    if not part.refusal:
        output.text(_SCALES)
    output.text(part_sentence(part), bold=True)
    rough = rough_sentence(part)
    if rough:
        output.text(rough)
    for remark in part.remarks:
        output.text(f"Note: {remark}.")
    output.line()


def _table(output: Output, title: str, quantities: list[Compared]) -> None:
    rows = [
        (
            _label(each),
            _value(each, each.closed_form),
            _value(each, each.extrapolated),
            _part_of(each, each.difference_before),
            _part_of(each, each.difference),
            _order(each),
        )
        for each in quantities
    ]
    output.table(
        ["", "Closed\nform", "Truss\nextrapol.", "Diff.,\nfinest", "Diff.,\nextrapol.", "\nOrder"],
        rows,
        title=title,
        numbers=[1, 2, 3, 4, 5],
    )  # fmt: skip


def _lines(output: Output, part: StaticComparison) -> None:
    """Show each line's tensions, and the largest difference of all its quantities."""
    rows = []
    for k in range(len(part.lines)):
        own = [each for each in part.quantities if each.line == k]
        fairlead, anchor = part.of("fairlead_tension", k), part.of("anchor_tension", k)
        worst = max(own, key=lambda each: each.gap)
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
            "\n\nLine",
            "Fairlead\nclosed form\n(kN)",
            "tension\ntruss\n(kN)",
            "Anchor\nclosed form\n(kN)",
            "tension\ntruss\n(kN)",
            "Largest\ndifference\nover scale",
            "\n\nOrder",
        ],
        rows,
        title="Lines",
        numbers=range(7),
    )


def _meshes(output: Output, part: StaticComparison) -> None:
    rows = [
        (
            str(mesh.elements),
            str(mesh.iterations),
            f"{mesh.residual:.1e}",
            _largest(part, number),
        )
        for number, mesh in enumerate(part.meshes)
    ]
    output.table(
        ["\nBars", "\nIterations", "Residual\nover tension", "Largest differ-\nence over scale"],
        rows,
        title="Meshes of the truss model",
        numbers=[0, 1, 2, 3],
    )


def _largest(part: StaticComparison, mesh: int) -> str:
    gap = part.mesh_gap(mesh)
    return "-" if gap is None else in_parts(gap)


def _label(each: Compared) -> str:
    quantity = QUANTITY_OF[each.quantity]
    symbol = f" {quantity.symbol}" if each.quantity.startswith("position") else ""
    return f"{quantity.name}{symbol} ({quantity.field_unit})"


def _value(each: Compared, value: float | None) -> str:
    return QUANTITY_OF[each.quantity].format(value)


def _part_of(each: Compared, difference: float | None) -> str:
    return "-" if difference is None else in_parts(abs(difference) / each.scale)


def _order(each: Compared) -> str:
    return "-" if each.order is None else f"{each.order:.2f}"


def _front(output: Output, front: FrontVerification) -> None:
    output.text(front.title or "Front", bold=True)
    output.line()
    output.table(
        [
            "\nDesign",
            "\nLoad case",
            "Fairlead T\n(kN)",
            "\nTruss (kN)",
            "Difference\nover scale",
            "\nOrder",
            "\nVerdict",
        ],
        [_design(each) for each in front.designs],
        title="Designs",
        numbers=[0, 2, 3, 4, 5],
    )
    for each in front.designs:
        if each.failure:
            output.text(f"Design {each.design.number}: {each.failure}")
    output.text(verdict_sentence(front), bold=True)


def _design(each: DesignVerification) -> tuple[str, ...]:
    number, found = str(each.design.number), each.verification
    if found is None:
        return number, each.design.load_case or "", "-", "-", "-", "-", "NO ANSWER"
    part = found.static
    tension = part.of("fairlead_tension")
    verdict = "DIFFERS" if part.verdict == "differs" else part.verdict
    return (
        number,
        part.name,
        _value(tension, tension.closed_form),
        _value(tension, tension.extrapolated),
        in_parts(part.worst.gap),
        _order(tension),
        verdict,
    )
