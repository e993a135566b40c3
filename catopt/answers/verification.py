"""What the closed form beside the truss model consists of: of a case, and of a front."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from catopt.answers import blocks
from catopt.answers.blocks import Rows, answered, measured, section, tabulate, texts, yes_or_no
from catopt.quantities import Quantity
from catopt.verify.truss_words import QUANTITY_OF, name_of, part_sentence, rough_sentence
from catopt.words import Message, Several, Unit, term

if TYPE_CHECKING:
    from catopt.verify.case import DesignVerification, FrontVerification
    from catopt.verify.compared import Compared
    from catopt.verify.result import StaticComparison, Verification

GAP = Quantity("gap", "Difference", "", "-", "-", 1.0, 1, "scientific", floor=1e-10)
"""Difference over its scale; what is below the truss model's own tolerance is chance, even a 0."""
_RESIDUAL = replace(GAP, key="residual", floor=0.0)
_ORDER = Quantity("order", "Order", "", "-", "-", 1.0, 2)

_Named = tuple[str, "StaticComparison"]
"""A load case under its name in files."""


def verification_answer(found: Verification) -> blocks.Answer:
    """Lay out a case by both models."""
    several = len(found.parts) > 1
    is_named = several or bool(found.case.load_cases)
    said = [block for part in found.parts for block in _part(part, is_named=is_named)]
    if several:
        said.append(blocks.Verdict(verdict_sentence(found), found.is_settled))
    parts = [(part.name, part) for part in found.parts]
    return answered(
        "verify",
        found.case.title or Message("captions.mooring_line"),
        section("captions.verification", *said),
        *_files(parts),
        section("captions.shapes", _shapes(parts)),
    )


def front_answer(front: FrontVerification) -> blocks.Answer:
    """Lay out a front by both models."""
    parts = [
        (Message("truss.design_in_case", number=each.design.number, name=part.name), part)
        for each in front.designs
        if each.verification is not None
        for part in each.verification.parts
    ]
    failures = (
        blocks.Text(Message("truss.design_failed", number=each.design.number, why=each.failure))
        for each in front.designs
        if each.failure
    )
    verdict = blocks.Verdict(front_sentence(front), front.is_settled)
    tables = _designs(front), _designs_in_files(front)
    return answered(
        "verify",
        front.title or Message("captions.front"),
        section("captions.designs", *tables, *failures, verdict),
        *_files(parts),
    )


# ------------------------------------------------------------------ one load case


def _part(part: StaticComparison, *, is_named: bool) -> Iterator[blocks.Block]:
    found = [each for each in part.quantities if each.line is None]
    if part.kind == "system":
        yield _compared(found, Message("truss.body_by_both"))
        yield _lines(part)
    else:
        caption = Message("captions.load_case", name=part.name)
        yield _compared(found, caption if is_named else Message("truss.by_both"))
    yield _meshes_of(part)
    yield blocks.Text(Message("truss.scales"), only="people")
    yield blocks.Verdict(part_sentence(part), part.is_settled)
    yield from _rough(part)
    yield from remarks(part.remarks)


def _rough(part: StaticComparison) -> Iterator[blocks.Text]:
    """Say what was not extrapolated."""
    rough = rough_sentence(part)
    if rough:
        yield blocks.Text(rough)


def remarks(said: Iterable[str]) -> Iterator[blocks.Text]:
    """Say what is to be known before an answer is used."""
    return (blocks.Text(Message("answers.note", remark=each)) for each in said)


def compared_in_note(found: Sequence[Compared], caption: str = "") -> blocks.Table:
    """Tabulate quantities by both models in a note, with a verdict on each."""
    table = _compared(found, caption)
    names, closed, truss, before, after, order = table.columns
    units = tuple(QUANTITY_OF[each.quantity] for each in found)
    named = replace(names, values=tuple(map(quantity_in_note, units)))
    closed = replace(closed, units=units)
    truss = replace(truss, units=units, name=Message("columns.truss_extrapolated"))
    after = replace(after, name=Message("columns.difference_over_scale"))
    verdicts = _verdict_column([each.agrees for each in found])
    columns = (named, closed, truss, before, after, order, verdicts)
    return replace(table, name="verification", columns=columns, only="not csv")


def lines_in_note(part: StaticComparison, caption: str) -> blocks.Table:
    """Tabulate each line's tensions and worst quantity in a note, with a verdict on each."""
    numbers = range(len(part.lines))
    worst = [term(QUANTITY_OF[part.worst_of(k).quantity].name) for k in numbers]
    agree = [all(e.agrees for e in part.quantities if e.line == k) for k in numbers]
    table = _lines(part)
    columns = (*table.columns, texts("worst_quantity", worst), _verdict_column(agree))
    return replace(table, columns=columns, caption=caption, only="not csv")


def closing_in_note(part: StaticComparison) -> Iterator[blocks.Block]:
    """Say what was not extrapolated and what was remarked on, and tabulate the meshes."""
    yield from _rough(part)
    yield blocks.Warnings(tuple(part.remarks))
    meshes = _meshes_of(part)
    bars, _, *others = meshes.columns  # how often is iterated is another count on each machine
    yield replace(meshes, name="meshes", columns=(bars, *others), only="not csv")


def _verdict_column(agree: Iterable[bool]) -> blocks.Column:
    passes = tuple(agree)
    words = (term("agrees" if each else "DIFFERS") for each in passes)
    return texts("verdict", words, passes=passes)


def _compared(found: Sequence[Compared], caption: str) -> blocks.Table:
    """Tabulate what is of the line, or of the body, by both models."""
    of = Rows(found)
    units = tuple(blocks.bare(QUANTITY_OF[each.quantity]) for each in found)
    return tabulate(
        "compared",
        of.texts("quantity", _label),
        of.texts("closed_form", units=units),
        of.texts("truss_extrapol", "extrapolated", units=units),
        of.measured(GAP, "gap_before", "diff_finest"),
        of.measured(GAP, "gap", "diff_extrapol"),
        of.measured(_ORDER, "order", "order"),
        caption=caption,
        only="people",
    )


def label(quantity: Quantity, *, with_symbol: bool = False) -> Message:
    """Name a quantity with its unit, where its values stand without."""
    name = term(quantity.name)
    if with_symbol:
        name = Message("words.label", name=name, symbol=quantity.symbol)
    return Message("words.heading", label=name, unit=Unit(quantity))


def quantity_in_note(quantity: Quantity) -> str:
    """Name a quantity with its symbol, where it has one."""
    name = term(quantity.name)
    return Message("words.label", name=name, symbol=quantity.symbol) if quantity.symbol else name


def _label(each: Compared) -> Message:
    return label(QUANTITY_OF[each.quantity], with_symbol=each.quantity.startswith("position"))


def _lines(part: StaticComparison) -> blocks.Table:
    """Tabulate each line's tensions, and the largest difference of all its quantities."""
    numbers = range(len(part.lines))
    fairlead, anchor = (
        Rows(part.of(f"{end}_tension", k) for k in numbers) for end in ("fairlead", "anchor")
    )
    worst = Rows(part.worst_of(k) for k in numbers)
    return tabulate(
        "compared_lines",
        texts("line", [k + 1 for k in numbers]),
        fairlead.measured("tension", "closed_form", "fairlead_by_closed_form", symbol=""),
        fairlead.measured("tension", "extrapolated", "fairlead_by_truss", symbol=""),
        anchor.measured("tension", "closed_form", "anchor_by_closed_form", symbol=""),
        anchor.measured("tension", "extrapolated", "anchor_by_truss", symbol=""),
        worst.measured(GAP, "gap", "largest_difference"),
        fairlead.measured(_ORDER, "order", "order"),
        caption=Message("captions.lines"),
        only="people",
    )


def _meshes_of(part: StaticComparison) -> blocks.Table:
    of, gaps = Rows(part.meshes), map(part.mesh_gap, range(len(part.meshes)))
    return tabulate(
        "meshes_of_load_case",
        of.texts("bars", "elements"),
        of.texts("iterations"),
        of.measured(_RESIDUAL, "residual", "residual_over_tension"),
        measured(GAP, gaps, "largest_difference_over_scale"),
        caption=Message("captions.meshes_of_truss"),
        only="people",
    )


# ------------------------------------------------------------------ a front


def _designs(front: FrontVerification) -> blocks.Table:
    """Tabulate the designs in the load case that governs each."""
    designs, found = Rows(front.designs), _governing(front)
    tension = Rows(found.read(lambda part: part.of("fairlead_tension")))
    return tabulate(
        "compared_designs",
        designs.texts("design", "design.number"),
        designs.texts("load_case", _load_case),
        tension.measured("tension", "closed_form", "fairlead_tension"),
        tension.measured("tension", "extrapolated", "truss", symbol=""),
        found.measured(GAP, "worst.gap", "difference_over_scale"),
        tension.measured(_ORDER, "order", "order"),
        designs.texts("verdict", _verdict),
        caption=Message("captions.designs"),
        only="people",
    )


def _governing(front: FrontVerification) -> Rows:
    """Take each design in the load case that governs it; None where there is no answer."""
    return Rows(Rows(front.designs).read("verification.static"))


def _load_case(each: DesignVerification) -> str:
    if each.verification is None:
        return each.design.load_case or ""
    return each.verification.static.name


def _verdict(each: DesignVerification) -> Message:
    if each.verification is None:
        return term("NO ANSWER")
    verdict = each.verification.static.verdict
    return term(verdict if verdict == "agrees" else verdict.upper())


def _designs_in_files(front: FrontVerification) -> blocks.Table:
    of, found = Rows(front.designs), _governing(front)
    verdicts = (term(each or "no answer") for each in of.read("verification.verdict"))
    worst = (name_of(each) if each else "" for each in found.read("worst"))
    return tabulate(
        "designs",
        of.texts("design", "design.number"),
        of.texts("governing_load_case", lambda each: each.design.load_case or ""),
        texts("verdict", verdicts),
        texts("worst_quantity", worst),
        found.measured(GAP, "worst.gap", "largest_difference_over_its_scale"),
        of.texts("failure"),
        only="files",
    )


# ------------------------------------------------------------------ files


def _files(parts: Sequence[_Named]) -> Iterator[blocks.Section]:
    """Lay out every number on every mesh."""
    for key, made in (("verdicts", _verdicts), ("quantities", _quantities), ("meshes", _meshes)):
        yield section(f"captions.{key}", made(parts))


def _verdicts(parts: Sequence[_Named]) -> blocks.Table:
    of = Rows(part for _, part in parts)
    return tabulate(
        "verdicts",
        texts("load_case", [name for name, _ in parts]),
        of.texts("verdict", lambda part: term(part.verdict)),
        of.texts("worst_quantity", lambda part: name_of(part.worst)),
        of.measured(GAP, "worst.gap", "largest_difference_over_its_scale"),
        of.measured(_RESIDUAL, "tolerance", "tolerance"),
        of.measured(_RESIDUAL, "residual", "residual_of_the_truss_over_its_tension"),
        of.texts("remarks", lambda part: Several(part.remarks)),
        only="files",
    )


def _quantities(parts: Sequence[_Named]) -> blocks.Table:
    found = [each for _, part in parts for each in part.quantities]
    of = Rows(found)
    meshes = range(max((len(each.fem) for each in found), default=0))
    return tabulate(
        "quantities",
        texts("load_case", [name for name, part in parts for _ in part.quantities]),
        texts("line", [None if each.line is None else each.line + 1 for each in found]),
        of.texts("quantity", lambda each: blocks.keyed(each.quantity, _said_name(each.quantity))),
        of.texts("unit"),
        of.of_row("closed_form"),
        *(_on_mesh(number, [each.fem[number] for each in found]) for number in meshes),
        of.of_row("truss_extrapolated", "extrapolated"),
        of.measured(_ORDER, "order", "observed_order"),
        of.texts("smooth", lambda each: yes_or_no(each.is_smooth)),
        of.of_row("difference_of_the_finest_mesh", "difference_before"),
        of.of_row("difference_after_extrapolation", "difference"),
        of.of_row("scale"),
        of.measured(GAP, "gap", "difference_over_the_scale"),
        of.texts("agrees", lambda each: yes_or_no(each.agrees)),
        only="files",
    )


def _on_mesh(number: int, values: Sequence[float]) -> blocks.Column:
    return blocks.of_row(Message("columns.truss_on_mesh", number=number + 1), values, only="files")


def _said_name(quantity: str) -> Message:
    """Name a quantity in a table; where a body is has the same name along x and y."""
    if quantity.startswith("position"):
        return Message(f"truss.{quantity}")
    return term(QUANTITY_OF[quantity].name)


def _meshes(parts: Sequence[_Named]) -> blocks.Table:
    of = Rows(mesh for _, part in parts for mesh in part.meshes)
    numbers = [number for _, part in parts for number, _ in enumerate(part.meshes, start=1)]
    return tabulate(
        "meshes",
        texts("load_case", [name for name, part in parts for _ in part.meshes]),
        texts("mesh", numbers),
        of.texts("bars", "elements"),
        of.texts("newton_iterations", "iterations"),
        of.measured(_RESIDUAL, "residual", "residual_over_the_largest_tension"),
        of.measured("residual", "penetration", "penetration"),
        only="files",
    )


def _shapes(parts: Sequence[_Named]) -> blocks.Table:
    pairs = [
        (name, number, pair)
        for name, part in parts
        for number, pair in enumerate(part.lines, start=1)
    ]
    nodes = [(name, number) for name, number, pair in pairs for _ in pair.finest.arc]
    truss = [place for *_, pair in pairs for place in pair.finest_shape().tolist()]
    exact = [place for *_, pair in pairs for place in pair.closed_form_there().tolist()]

    def along(key: str, places: list[Any], axis: int, name: str) -> blocks.Column:
        return measured(key, [place[axis] for place in places], name)

    return tabulate(
        "shapes",
        texts("load_case", [name for name, _ in nodes]),
        texts("line", [number for _, number in nodes]),
        measured("s", (s for *_, pair in pairs for s in pair.finest.arc)),
        along("x", truss, 0, "truss"),
        along("z", truss, 1, "truss"),
        along("x", exact, 0, "closed_form"),
        along("z", exact, 1, "closed_form"),
        along("tension", exact, 2, "closed_form"),
        only="files",
    )


# ------------------------------------------------------------------ sentences


def verdict_sentence(found: Verification) -> Message:
    """Say in one line what came of a case."""
    count = len(found.parts)
    settled = sum(part.is_settled for part in found.parts)
    if count == 1:
        return part_sentence(found.parts[0])
    if settled == count:
        return Message("truss.all_cases_agree", count=count)
    return Message("truss.cases_differ", differing=count - settled, count=count)


def front_sentence(front: FrontVerification) -> Message:
    """Say in one line what came of a front."""
    count = len(front.designs)
    settled = sum(each.is_settled for each in front.verified)
    failed = count - len(front.verified)
    if settled == count:
        return Message("truss.all_designs_agree", count=count)
    differing = count - settled - failed
    values = {"count": count, "differing": differing, "failed": failed}
    if not failed:
        return Message("truss.designs_differ", **values)
    if not differing:
        return Message("truss.designs_fail", **values)
    return Message("truss.designs_differ_and_fail", **values)
