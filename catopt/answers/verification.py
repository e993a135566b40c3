"""What the closed form beside the truss model consists of: of a case, and of a front."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from catopt.answers.blocks import (
    Answer,
    Block,
    Column,
    Section,
    Table,
    Text,
    Verdict,
    Warnings,
    bare,
    keyed,
    measured,
    of_row,
    texts,
    where_known,
    yes_or_no,
)
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


def verification_answer(found: Verification) -> Answer:
    """Lay out a case by both models."""
    several = len(found.parts) > 1
    is_named = several or bool(found.case.load_cases)
    said: list[Block] = []
    for part in found.parts:
        said += _part(part, is_named=is_named)
    if several:
        said.append(Verdict(verdict_sentence(found), found.is_settled))
    parts = [(part.name, part) for part in found.parts]
    return Answer(
        "verify",
        found.case.title or Message("captions.mooring_line"),
        (
            Section(Message("captions.verification"), tuple(said)),
            *_files(parts),
            Section(Message("captions.shapes"), (_shapes(parts),)),
        ),
    )


def front_answer(front: FrontVerification) -> Answer:
    """Lay out a front by both models."""
    parts = [
        (Message("truss.design_in_case", number=each.design.number, name=part.name), part)
        for each in front.designs
        if each.verification is not None
        for part in each.verification.parts
    ]
    failures = [
        Text(Message("truss.design_failed", number=each.design.number, why=each.failure))
        for each in front.designs
        if each.failure
    ]
    verdict = Verdict(front_sentence(front), front.is_settled)
    said: list[Block] = [_designs(front), _designs_in_files(front), *failures, verdict]
    return Answer(
        "verify",
        front.title or Message("captions.front"),
        (Section(Message("captions.designs"), tuple(said)), *_files(parts)),
    )


# ------------------------------------------------------------------ one load case


def _part(part: StaticComparison, *, is_named: bool) -> Iterator[Block]:
    found = [each for each in part.quantities if each.line is None]
    yield _compared(found, _caption(part, is_named=is_named))
    if part.kind == "system":
        yield _lines(part)
    yield _meshes_of(part)
    yield Text(Message("truss.scales"), only="people")
    yield Verdict(part_sentence(part), part.is_settled)
    rough = rough_sentence(part)
    if rough:
        yield Text(rough)
    yield from remarks(part.remarks)


def remarks(said: Iterable[str]) -> Iterator[Text]:
    """Say what is to be known before an answer is used."""
    for each in said:
        yield Text(Message("answers.note", remark=each))


def _caption(part: StaticComparison, *, is_named: bool) -> Message:
    if part.kind == "system":
        return Message("truss.body_by_both")
    if not is_named:
        return Message("truss.by_both")
    return Message("captions.load_case", name=part.name)


def compared_in_note(found: Sequence[Compared], caption: str = "") -> Table:
    """Tabulate quantities by both models in a note, with a verdict on each."""
    table = _compared(found, caption)
    names, closed, truss, before, after, order = table.columns
    units = tuple(QUANTITY_OF[each.quantity] for each in found)
    named = replace(names, values=tuple(map(_name, units)))
    closed = replace(closed, units=units)
    truss = replace(truss, units=units, name=Message("columns.truss_extrapolated"))
    after = replace(after, name=Message("columns.difference_over_scale"))
    verdicts = _verdict_column([each.agrees for each in found])
    columns = (named, closed, truss, before, after, order, verdicts)
    return replace(table, name="verification", columns=columns, only="not csv")


def lines_in_note(part: StaticComparison, caption: str) -> Table:
    """Tabulate each line's tensions and worst quantity in a note, with a verdict on each."""
    numbers = range(len(part.lines))
    worst = [term(QUANTITY_OF[part.worst_of(k).quantity].name) for k in numbers]
    agree = [all(e.agrees for e in part.quantities if e.line == k) for k in numbers]
    table = _lines(part)
    further = (texts("worst_quantity", worst), _verdict_column(agree))
    return replace(table, columns=(*table.columns, *further), caption=caption, only="not csv")


def closing_in_note(part: StaticComparison) -> Iterator[Block]:
    """Say what was not extrapolated and what was remarked on, and tabulate the meshes."""
    rough = rough_sentence(part)
    if rough:
        yield Text(rough)
    yield Warnings(tuple(part.remarks))
    meshes = _meshes_of(part)
    bars, _, *others = meshes.columns  # how often is iterated is another count on each machine
    yield replace(meshes, name="meshes", columns=(bars, *others), only="not csv")


def _verdict_column(agree: Iterable[bool]) -> Column:
    passes = tuple(agree)
    words = tuple(term("agrees" if each else "DIFFERS") for each in passes)
    return Column(Message("columns.verdict"), words, passes=passes)


def _compared(found: Sequence[Compared], caption: str) -> Table:
    """Tabulate what is of the line, or of the body, by both models."""
    units = tuple(bare(QUANTITY_OF[each.quantity]) for each in found)
    closed = tuple(each.closed_form for each in found)
    truss = tuple(each.extrapolated for each in found)
    return Table(
        "compared",
        (
            texts("quantity", [_label(each) for each in found]),
            Column(Message("columns.closed_form"), closed, units=units),
            Column(Message("columns.truss_extrapol"), truss, units=units),
            _gaps("diff_finest", (each.gap_before for each in found)),
            _gaps("diff_extrapol", (each.gap for each in found)),
            _orders("order", found),
        ),
        caption,
        only="people",
    )


def label(quantity: Quantity, *, with_symbol: bool = False) -> Message:
    """Name a quantity with its unit, where its values stand without."""
    name = term(quantity.name)
    if with_symbol:
        name = Message("words.label", name=name, symbol=quantity.symbol)
    return Message("words.heading", label=name, unit=Unit(quantity))


def _name(quantity: Quantity) -> str:
    name = term(quantity.name)
    return Message("words.label", name=name, symbol=quantity.symbol) if quantity.symbol else name


def _label(each: Compared) -> Message:
    return label(QUANTITY_OF[each.quantity], with_symbol=each.quantity.startswith("position"))


def _gaps(name: str, values: Iterable[float | None]) -> Column:
    return Column(Message(f"columns.{name}"), tuple(values), GAP)


def _orders(name: str, found: Iterable[Compared]) -> Column:
    return Column(Message(f"columns.{name}"), tuple(each.order for each in found), _ORDER)


def _lines(part: StaticComparison) -> Table:
    """Tabulate each line's tensions, and the largest difference of all its quantities."""
    numbers = range(len(part.lines))
    fairlead = [part.of("fairlead_tension", k) for k in numbers]
    anchor = [part.of("anchor_tension", k) for k in numbers]

    def tensions(name: str, values: Iterable[float]) -> Column:
        return measured("tension", values, name, symbol="")

    return Table(
        "compared_lines",
        (
            texts("line", [k + 1 for k in numbers]),
            tensions("fairlead_by_closed_form", (each.closed_form for each in fairlead)),
            tensions("fairlead_by_truss", (each.extrapolated for each in fairlead)),
            tensions("anchor_by_closed_form", (each.closed_form for each in anchor)),
            tensions("anchor_by_truss", (each.extrapolated for each in anchor)),
            _gaps("largest_difference", (part.worst_of(k).gap for k in numbers)),
            _orders("order", fairlead),
        ),
        Message("captions.lines"),
        only="people",
    )


def _meshes_of(part: StaticComparison) -> Table:
    numbers = range(len(part.meshes))
    residuals = tuple(mesh.residual for mesh in part.meshes)
    return Table(
        "meshes_of_load_case",
        (
            texts("bars", [mesh.elements for mesh in part.meshes]),
            texts("iterations", [mesh.iterations for mesh in part.meshes]),
            Column(Message("columns.residual_over_tension"), residuals, _RESIDUAL),
            _gaps("largest_difference_over_scale", (part.mesh_gap(k) for k in numbers)),
        ),
        Message("captions.meshes_of_truss"),
        only="people",
    )


# ------------------------------------------------------------------ a front


def _designs(front: FrontVerification) -> Table:
    """Tabulate the designs in the load case that governs each."""
    found = where_known((each.verification for each in front.designs), lambda of: of.static)
    tension = where_known(found, lambda part: part.of("fairlead_tension"))
    names = [
        each.design.load_case or "" if part is None else part.name
        for each, part in zip(front.designs, found, strict=True)
    ]
    closed = where_known(tension, lambda each: each.closed_form)
    truss = where_known(tension, lambda each: each.extrapolated)
    order = where_known(tension, lambda each: each.order)
    return Table(
        "compared_designs",
        (
            texts("design", [each.design.number for each in front.designs]),
            texts("load_case", names),
            measured("tension", closed, "fairlead_tension"),
            measured("tension", truss, "truss", symbol=""),
            _gaps("difference_over_scale", where_known(found, lambda part: part.worst.gap)),
            Column(Message("columns.order"), tuple(order), _ORDER),
            texts("verdict", [_verdict(part) for part in found]),
        ),
        Message("captions.designs"),
        only="people",
    )


def _verdict(part: StaticComparison | None) -> Message:
    if part is None:
        return term("NO ANSWER")
    return term(part.verdict if part.verdict == "agrees" else part.verdict.upper())


def _designs_in_files(front: FrontVerification) -> Table:
    worst = where_known((each.verification for each in front.designs), lambda of: of.static.worst)
    gaps = where_known(worst, lambda each: each.gap)
    return Table(
        "designs",
        (
            texts("design", [each.design.number for each in front.designs]),
            texts("governing_load_case", [each.design.load_case or "" for each in front.designs]),
            texts("verdict", [_verdict_in_files(each) for each in front.designs]),
            texts("worst_quantity", [name_of(each) if each else "" for each in worst]),
            _gaps("largest_difference_over_its_scale", gaps),
            texts("failure", [each.failure for each in front.designs]),
        ),
        only="files",
    )


def _verdict_in_files(each: DesignVerification) -> Message:
    return term("no answer" if each.verification is None else each.verification.verdict)


# ------------------------------------------------------------------ files


def _files(parts: Sequence[_Named]) -> Iterator[Section]:
    """Lay out every number on every mesh."""
    for key, made in (("verdicts", _verdicts), ("quantities", _quantities), ("meshes", _meshes)):
        yield Section(Message(f"captions.{key}"), (made(parts),))


def _verdicts(parts: Sequence[_Named]) -> Table:
    found = [part for _, part in parts]
    tolerance, residual = (
        Column(Message(f"columns.{key}"), tuple(values), _RESIDUAL)
        for key, values in (
            ("tolerance", [part.tolerance for part in found]),
            ("residual_of_the_truss_over_its_tension", [part.residual for part in found]),
        )
    )
    return Table(
        "verdicts",
        (
            texts("load_case", [name for name, _ in parts]),
            texts("verdict", [term(part.verdict) for part in found]),
            texts("worst_quantity", [name_of(part.worst) for part in found]),
            _gaps("largest_difference_over_its_scale", (part.worst.gap for part in found)),
            tolerance,
            residual,
            texts("remarks", [Several(part.remarks) for part in found]),
        ),
        only="files",
    )


def _quantities(parts: Sequence[_Named]) -> Table:
    rows = [(name, each) for name, part in parts for each in part.quantities]
    found = [each for _, each in rows]
    meshes = range(max((len(each.fem) for each in found), default=0))
    return Table(
        "quantities",
        (
            texts("load_case", [name for name, _ in rows]),
            texts("line", [None if each.line is None else each.line + 1 for each in found]),
            texts("quantity", [keyed(each.quantity, _said_name(each.quantity)) for each in found]),
            texts("unit", [each.unit for each in found]),
            of_row("closed_form", (each.closed_form for each in found)),
            *(_on_mesh(number, [each.fem[number] for each in found]) for number in meshes),
            of_row("truss_extrapolated", (each.extrapolated for each in found)),
            _orders("observed_order", found),
            texts("smooth", [yes_or_no(each.is_smooth) for each in found]),
            of_row("difference_of_the_finest_mesh", (each.difference_before for each in found)),
            of_row("difference_after_extrapolation", (each.difference for each in found)),
            of_row("scale", (each.scale for each in found)),
            _gaps("difference_over_the_scale", (each.gap for each in found)),
            texts("agrees", [yes_or_no(each.agrees) for each in found]),
        ),
        only="files",
    )


def _on_mesh(number: int, values: Sequence[float]) -> Column:
    name = Message("columns.truss_on_mesh", number=number + 1)
    return Column(Message("columns.of_row", name=name), tuple(values), only="files")


def _said_name(quantity: str) -> Message:
    """Name a quantity in a table; where a body is has the same name along x and y."""
    if quantity.startswith("position"):
        return Message(f"truss.{quantity}")
    return term(QUANTITY_OF[quantity].name)


def _meshes(parts: Sequence[_Named]) -> Table:
    rows = [
        (name, number, mesh)
        for name, part in parts
        for number, mesh in enumerate(part.meshes, start=1)
    ]
    residual = tuple(mesh.residual for *_, mesh in rows)
    return Table(
        "meshes",
        (
            texts("load_case", [name for name, *_ in rows]),
            texts("mesh", [number for _, number, _ in rows]),
            texts("bars", [mesh.elements for *_, mesh in rows]),
            texts("newton_iterations", [mesh.iterations for *_, mesh in rows]),
            Column(Message("columns.residual_over_the_largest_tension"), residual, _RESIDUAL),
            measured("residual", (mesh.penetration for *_, mesh in rows), "penetration"),
        ),
        only="files",
    )


def _shapes(parts: Sequence[_Named]) -> Table:
    pairs = [
        (name, number, pair)
        for name, part in parts
        for number, pair in enumerate(part.lines, start=1)
    ]
    nodes = [(name, number) for name, number, pair in pairs for _ in pair.finest.arc]
    truss = [place for *_, pair in pairs for place in pair.finest_shape().tolist()]
    exact = [place for *_, pair in pairs for place in pair.closed_form_there().tolist()]
    return Table(
        "shapes",
        (
            texts("load_case", [name for name, _ in nodes]),
            texts("line", [number for _, number in nodes]),
            measured("s", (s for *_, pair in pairs for s in pair.finest.arc.tolist())),
            measured("x", (place[0] for place in truss), "truss"),
            measured("z", (place[1] for place in truss), "truss"),
            measured("x", (place[0] for place in exact), "closed_form"),
            measured("z", (place[1] for place in exact), "closed_form"),
            measured("tension", (place[2] for place in exact), "closed_form"),
        ),
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
    if not failed:
        return Message("truss.designs_differ", count=count, differing=differing)
    if not differing:
        return Message("truss.designs_fail", count=count, failed=failed)
    values = {"count": count, "differing": differing, "failed": failed}
    return Message("truss.designs_differ_and_fail", **values)
