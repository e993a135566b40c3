"""What the truss model says: beside the closed form, and of fatigue."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from functools import partial
from operator import itemgetter
from typing import TYPE_CHECKING, Any

from catopt.answers import blocks
from catopt.answers.blocks import Rows, answered, measured, section, tabulate, texts, yes_or_no
from catopt.answers.check import verdict_column
from catopt.constants import YEAR
from catopt.quantities import Quantity
from catopt.verify.motion_words import QUANTITY_OF, name_of, part_sentence, rough_sentence
from catopt.words import Message, Several, Unit, term

if TYPE_CHECKING:
    from catopt.verify.case import DesignVerification, FrontVerification
    from catopt.verify.comparison import Compared
    from catopt.verify.fatigue import FatigueReport, SegmentFatigue
    from catopt.verify.result import StaticComparison, Verification

GAP = Quantity("gap", "Difference", "", "-", "-", 1.0, 1, "scientific", floor=1e-10)
"""Difference over its scale; what is below the truss model's own tolerance is chance, even a 0."""
_RESIDUAL = replace(GAP, key="residual", floor=0.0)
_AGREE = "terms.agrees", "terms.differs_title"
_ORDER = Quantity("order", "Order", "", "-", "-", 1.0, 2)

_Named = tuple[str, "StaticComparison"]
"""A load case under its name in files."""


def verification_answer(found: Verification) -> blocks.Answer:
    """Lay out a case by both models."""
    several = len(found.parts) > 1
    is_named = several or found.is_named
    said = [block for part in found.parts for block in _part(part, is_named=is_named)]
    if several:
        said.append(blocks.Verdict(verdict_sentence(found), found.is_settled))
    parts = [(part.name, part) for part in found.parts]
    answer = answered(
        "verify",
        found.case.title or Message("captions.mooring_line"),
        section("captions.verification", *said),
        *_files(parts),
        section("captions.shapes", _shapes(parts)),
    )
    of_points = any(part.kind == "network" for part in found.parts)
    return replace(answer, next="verify_points" if of_points else "")


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
    return answered(
        "verify",
        front.title or Message("captions.front"),
        section("captions.designs", _designs(front), *failures, verdict),
        *_files(parts),
    )


# ------------------------------------------------------------------ one load case


def _part(part: StaticComparison, *, is_named: bool) -> Iterator[blocks.Block]:
    found = [each for each in part.quantities if each.line is None]
    if part.kind != "line":
        about = "body" if part.kind == "system" else "points"
        if found:
            yield _compared(found, Message(f"truss.{about}_by_both"))
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
    rough = rough_sentence(part)
    if rough:
        yield blocks.Text(rough)


def remarks(said: Iterable[str]) -> Iterator[blocks.Text]:
    """Say what is to be known before an answer is used."""
    return (blocks.Text(Message("answers.note", remark=each)) for each in said)


def closing_in_note(part: StaticComparison) -> Iterator[blocks.Block]:
    """Say what was not extrapolated and what was remarked on, and tabulate the meshes."""
    yield from _rough(part)
    yield blocks.Warnings(tuple(part.remarks))
    meshes = _meshes_of(part)
    bars, _, *others = meshes.columns  # how often is iterated is another count on each machine
    yield replace(meshes, name="meshes", columns=(bars, *others), only="not csv")


def _compared(
    found: Sequence[Compared], caption: str = "", *, in_note: bool = False
) -> blocks.Table:
    """Tabulate quantities by both models; in a note with units beside them, and a verdict."""
    of, own = Rows(found), tuple(QUANTITY_OF[each.quantity] for each in found)
    units = own if in_note else tuple(map(blocks.bare, own))
    verdict = verdict_column(of.read("agrees"), *_AGREE)
    return tabulate(
        "verification" if in_note else "compared",
        texts("quantity", map(quantity_in_note, own)) if in_note else of.texts("quantity", _label),
        of.texts("closed_form", units=units),
        of.texts(
            "truss_extrapolated" if in_note else "truss_extrapol", "extrapolated", units=units
        ),
        of.measured(GAP, "gap_before", "diff_finest"),
        of.measured(GAP, "gap", "difference_over_scale" if in_note else "diff_extrapol"),
        of.measured(_ORDER, "order", "order"),
        *([verdict] if in_note else []),
        caption=caption,
        only="not csv" if in_note else "people",
    )


compared_in_note = partial(_compared, in_note=True)


def label(quantity: Quantity, *, with_symbol: bool = False) -> Message:
    """Name a quantity with its unit, where its values stand without."""
    name = quantity_in_note(quantity) if with_symbol else term(quantity.name)
    return Message("words.heading", label=name, unit=Unit(quantity))


def quantity_in_note(quantity: Quantity) -> str:
    """Name a quantity with its symbol, where it has one."""
    return blocks.labelled(term(quantity.name), quantity.symbol)


def _label(each: Compared) -> Message:
    """Name a quantity, of a network by its joint or body."""
    of = QUANTITY_OF[each.quantity]
    if each.point:
        named = blocks.labelled(each.point, of.symbol or term(of.name))
        return Message("words.heading", label=named, unit=Unit(of))
    return label(of, with_symbol=each.quantity.startswith("position"))


def lines_in_note(part: StaticComparison, caption: str) -> blocks.Table:
    """Tabulate each line's tensions and worst quantity in a note, with a verdict on each."""
    numbers = range(len(part.lines))
    worst = [term(QUANTITY_OF[part.worst_of(k).quantity].name) for k in numbers]
    agree = [all(e.agrees for e in part.quantities if e.line == k) for k in numbers]
    table = _lines(part)
    columns = (*table.columns, texts("worst_quantity", worst), verdict_column(agree, *_AGREE))
    return replace(table, columns=columns, caption=caption, only="not csv")


def _lines(part: StaticComparison) -> blocks.Table:
    """Tabulate each line's tensions, and the largest difference of all its quantities."""
    numbers = range(len(part.lines))
    is_network = part.kind == "network"
    ends = ("to", "from") if is_network else ("fairlead", "anchor")
    fairlead, anchor = (Rows(part.of(f"{end}_tension", k) for k in numbers) for end in ends)
    worst = Rows(part.worst_of(k) for k in numbers)
    return tabulate(
        "compared_lines",
        texts("line", [part.name_of_line(k) for k in numbers]),
        fairlead.measured("tension", "closed_form", f"{ends[0]}_by_closed_form", symbol=""),
        fairlead.measured("tension", "extrapolated", f"{ends[0]}_by_truss", symbol=""),
        anchor.measured("tension", "closed_form", f"{ends[1]}_by_closed_form", symbol=""),
        anchor.measured("tension", "extrapolated", f"{ends[1]}_by_truss", symbol=""),
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
    of = Rows(front.designs)
    found = Rows(of.read("verification.static"))
    tension = Rows(found.read("fairlead_tension"))
    verdicts = (term(each or "no answer") for each in of.read("verification.verdict"))
    load_cases = (
        each.verification.static.name if each.verification else each.design.load_case or ""
        for each in front.designs
    )
    people: dict[str, Any] = {"only": "people"}
    files: dict[str, Any] = {"only": "files"}
    return tabulate(
        "designs",
        of.texts("design", "design.number"),
        texts("load_case", load_cases, **people),
        tension.measured("tension", "closed_form", "fairlead_tension", **people),
        tension.measured("tension", "extrapolated", "truss", symbol="", **people),
        found.measured(GAP, "worst.gap", "difference_over_scale", **people),
        tension.measured(_ORDER, "order", "order", **people),
        of.texts("verdict", _verdict, **people),
        of.texts("governing_load_case", lambda each: each.design.load_case or "", **files),
        texts("verdict", verdicts, **files),
        *_worst(found, **files),
        of.texts("failure", **files),
        caption=Message("captions.designs"),
    )


def _verdict(each: DesignVerification) -> Message:
    if each.verification is None:
        return term("NO ANSWER")
    verdict = each.verification.static.verdict
    return term(verdict if verdict == "agrees" else verdict.upper())


# ------------------------------------------------------------------ files


def _files(parts: Sequence[_Named]) -> Iterator[blocks.Section]:
    """Lay out every number on every mesh."""
    for key, made in (("verdicts", _verdicts), ("quantities", _quantities), ("meshes", _meshes)):
        yield section(f"captions.{key}", made(parts))


def _worst(of: Rows, **how: Any) -> Iterator[blocks.Column]:
    names = [name_of(each) if each else "" for each in of.read("worst")]
    yield texts("worst_quantity", names, **how)
    yield of.measured(GAP, "worst.gap", "largest_difference_over_its_scale", **how)


def _verdicts(parts: Sequence[_Named]) -> blocks.Table:
    of = Rows(part for _, part in parts)
    return tabulate(
        "verdicts",
        texts("load_case", [name for name, _ in parts]),
        of.texts("verdict", lambda part: term(part.verdict)),
        *_worst(of),
        of.measured(_RESIDUAL, "tolerance", "tolerance"),
        of.measured(_RESIDUAL, "residual", "residual_of_the_truss_over_its_tension"),
        of.texts("remarks", lambda part: Several(part.remarks)),
        only="files",
    )


def _quantities(parts: Sequence[_Named]) -> blocks.Table:
    named, of = Rows(parts).within(lambda row: row[1].quantities)
    fem = Rows(of.read("fem"))
    meshes = range(max(map(len, fem.rows), default=0))
    return tabulate(
        "quantities",
        named.texts("load_case", itemgetter(0)),
        of.texts("line", lambda each: None if each.line is None else each.line + 1),
        *([of.texts("point")] if any(each.point for each in of.rows) else []),
        of.texts("quantity", lambda each: blocks.keyed(each.quantity, _said_name(each.quantity))),
        of.texts("unit"),
        of.of_row("closed_form"),
        *(
            fem.of_row(Message("columns.truss_on_mesh", number=k + 1), itemgetter(k))
            for k in meshes
        ),
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


def _said_name(quantity: str) -> Message:
    """Name a quantity in a table; where a body is has the same name along x and y."""
    if quantity.startswith(("position", "place")):
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
    nodes = [
        (name, number, *node)
        for name, part in parts
        for number, pair in enumerate(part.lines, start=1)
        for node in zip(
            pair.finest.arc, *pair.finest_shape().T, *pair.closed_form_there().T, strict=True
        )
    ]
    names, numbers, s, x, z, exact_x, exact_z, tension = zip(*nodes, strict=True)
    return tabulate(
        "shapes",
        texts("load_case", names),
        texts("line", numbers),
        measured("s", s),
        measured("x", x, "truss"),
        measured("z", z, "truss"),
        measured("x", exact_x, "closed_form"),
        measured("z", exact_z, "closed_form"),
        measured("tension", tension, "closed_form"),
        only="files",
    )


# ------------------------------------------------------------------ sentences


def verdict_sentence(found: Verification) -> Message:
    """Say in one line what came of a case."""
    count = len(found.parts)
    differing = sum(not part.is_settled for part in found.parts)
    if count == 1:
        return part_sentence(found.parts[0])
    key = "cases_differ" if differing else "all_cases_agree"
    return Message(f"truss.{key}", differing=differing, count=count)


def front_sentence(front: FrontVerification) -> Message:
    """Say in one line what came of a front."""
    count = len(front.designs)
    settled = sum(each.is_settled for each in front.verified)
    failed = count - len(front.verified)
    if settled == count:
        return Message("truss.all_designs_agree", count=count)
    differing = count - settled - failed
    come_to = "differ_and_fail" if differing and failed else "fail" if failed else "differ"
    values = {"count": count, "differing": differing, "failed": failed}
    return Message(f"truss.designs_{come_to}", **values)


_DAMAGE = Quantity("damage", "Damage", "", "-", "-", 1.0, 3, "significant")
_YEARS = Quantity("years", "Life", "", "s", "years", YEAR, 4, "significant")
_PERIOD = Quantity("period", "Period", "", "s", "s", 1.0, 2)
_PART = Quantity("part", "Part", "", "-", "-", 1.0, 4)
_AREA = Quantity("area", "Area", "", "m^2", "mm²", 1e-6, 0)
_HEIGHT = Quantity("height", "Height", "", "m", "m", 1.0, 2)
_PROVEN = {
    "converged": Message("fatigue.converged"),
    "not converged": Message("fatigue.not_converged"),
    "not proven": Message("fatigue.run_once"),
}


def fatigue_answer(report: FatigueReport) -> blocks.Answer:
    """Lay out fatigue by segment and by sea state."""
    said: tuple[blocks.Block, ...] = (
        blocks.Verdict(fatigue_sentence(report), report.passes and report.verdict == "converged"),
        *map(blocks.Text, _sentences(report)),
        blocks.Text(Message("fatigue.counting"), is_small=True),
        blocks.Text(Message("fatigue.spectrum"), is_small=True),
        blocks.Warnings(report.remarks),
    )
    return answered(
        "fatigue",
        report.case.title or Message("captions.mooring_line"),
        section("fatigue.by_segment", _segments(report), _strengths(report), *said),
        section("fatigue.by_state", _states(report), _damages(report)),
    )


def fatigue_sentence(report: FatigueReport) -> Message:
    """Say whether the line lasts, and whether that is proven."""
    worst = report.governing
    key = "lasts" if report.passes else "does_not_last"
    said = Message(
        f"fatigue.{key}", segment=_name(worst), used=worst.utilisation, years=worst.life / YEAR
    )
    if report.verdict == "converged":
        return said
    return Message("fatigue.not_proven", said=said, verdict=_PROVEN[report.verdict])


def _sentences(report: FatigueReport) -> Iterator[Message]:
    """Say which sea state harms each segment most, and how far its ranges hang on the step."""
    for each in report.segments:
        if each.damage > 0.0:
            worst = report.states[each.worst]
            yield Message(
                "fatigue.worst_state",
                segment=_name(each),
                number=each.worst + 1,
                height=worst.height,
                period=worst.period,
                part=each.states[each.worst].damage / each.damage,
            )
    changes = [each.change for each in report.segments if each.change is not None]
    if changes:  # where they were run again
        yield Message("fatigue.change", part=max(changes))


def _name(each: SegmentFatigue) -> Message:
    words = each.segment.name or each.segment.component
    key = "checks.named_segment" if words else "checks.segment"
    segment = Message(key, number=each.number, name=words)
    if each.line is None:
        return segment
    return Message("fatigue.of_line", line=each.line, segment=segment)


def _segments(report: FatigueReport) -> blocks.Table:
    of = Rows(report.segments)
    years = [None if each is None else each * YEAR for each in of.read("years")]
    return tabulate(
        "fatigue",
        of.texts("segment", _name),
        of.measured(_DAMAGE, "damage", "fatigue.damage"),
        measured(_YEARS, years, "fatigue.life"),
        of.measured(_YEARS, "life", "fatigue.wanted"),
        of.measured(_DAMAGE, "factor", "fatigue.design_factor"),
        *of.own("utilisation"),
        verdict_column(each.utilisation <= 1.0 for each in report.segments),
        marked=report.segments.index(report.governing),
    )


def _strengths(report: FatigueReport) -> blocks.Table:
    """Say by which curve and reference, and where in the segment."""
    of = Rows(report.segments)

    def reference(kind: str) -> list[float | None]:
        strengths = of.read("strength")
        return [each.reference if each.curve.kind == kind else None for each in strengths]

    return tabulate(
        "fatigue_strength",
        of.texts("segment", _name),
        of.texts("fatigue.curve", _curve),
        of.texts("fatigue.changes", _changes, only="files"),
        of.measured("nominal_diameter", "strength.diameter"),
        measured(_AREA, reference("S-N"), "fatigue.area"),
        measured("MBL", reference("T-N"), "fatigue.strength"),
        of.measured("s", "arc"),
        of.measured(_PART, "along", "fatigue.along"),
        of.texts("fatigue.factor_by", "factor_source.text"),
        caption=Message("fatigue.half_loss"),
    )


def _curve(each: SegmentFatigue) -> Message:
    curve = each.strength.curve
    key = "of_stress" if curve.kind == "S-N" else "of_mean" if curve.per_mean else "of_tension"
    values = {"factor": curve.factor, "slope": curve.slope, "fall": curve.per_mean}
    return Message(f"fatigue.{key}", source=curve.source.text, name=curve.source.code, **values)


def _changes(each: SegmentFatigue) -> Message:
    curve = each.strength.curve
    key = "changes_stress" if curve.kind == "S-N" else "changes_ORQ" if curve.ORQ else "changes_MBL"
    return Message(f"fatigue.{key}")


def _states(report: FatigueReport) -> blocks.Table:
    of, runs = Rows(report.states), Rows(report.runs)
    return tabulate(
        "fatigue_sea_states",
        texts("no", range(1, len(report.states) + 1)),
        of.measured(_HEIGHT, "height", "fatigue.height"),
        of.measured(_PERIOD, "period", "fatigue.period"),
        of.measured(_PART, "share", "fatigue.share"),
        runs.texts("fatigue.runs", lambda run: len(run.parts[0].runs)),
        runs.texts("fatigue.convergence", lambda run: _PROVEN[run.verdict]),
    )


def _damages(report: FatigueReport) -> blocks.Table:
    segments, of = Rows(report.segments).within("states")
    return tabulate(
        "fatigue_damage",
        segments.texts("segment", _name),
        texts("fatigue.sea_state", [*range(1, len(report.states) + 1)] * len(report.segments)),
        of.measured(_DAMAGE, "damage", "fatigue.damage"),
        of.measured("tension", "mean", "fatigue.mean"),
        of.measured(_DAMAGE, "cycles", "fatigue.cycles"),
        of.measured(_DAMAGE, "at_half_step", "fatigue.at_half_step"),
        of.measured(_DAMAGE, "by_spectrum", "fatigue.by_spectrum"),
        caption=Message("fatigue.mean_there"),
    )
