"""What fatigue of a line consists of."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from catopt.answers import blocks
from catopt.answers.blocks import Rows, answered, measured, section, tabulate, texts
from catopt.answers.check import verdict_column
from catopt.constants import YEAR
from catopt.quantities import Quantity
from catopt.words import Message

if TYPE_CHECKING:
    from catopt.verify.fatigue import FatigueReport, SegmentFatigue

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
