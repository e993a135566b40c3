"""What fatigue of a line consists of."""

from __future__ import annotations

from collections.abc import Iterator
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
    measured,
    texts,
)
from catopt.constants import YEAR
from catopt.quantities import QUANTITIES, Quantity
from catopt.words import Message

if TYPE_CHECKING:
    from catopt.verify.fatigue import FatigueReport, SegmentFatigue

_DAMAGE = Quantity("damage", "Damage", "", "-", "-", 1.0, 3, "significant")
_YEARS = Quantity("years", "Life", "", "s", "years", YEAR, 4, "significant")
_PERIOD = Quantity("period", "Period", "", "s", "s", 1.0, 2)
_PART = Quantity("part", "Part", "", "-", "-", 1.0, 4)
_AREA = Quantity("area", "Area", "", "m^2", "mm²", 1e-6, 0)


def fatigue_answer(report: FatigueReport) -> Answer:
    """Lay out fatigue by segment and by sea state."""
    said: tuple[Block, ...] = (
        Verdict(fatigue_sentence(report), report.passes and report.verdict == "converged"),
        *(Text(each) for each in (*_sentences(report), *_convergence(report))),
        Text(Message("fatigue.counting"), is_small=True),
        Text(Message("fatigue.spectrum"), is_small=True),
        Warnings(report.remarks),
    )
    return Answer(
        "fatigue",
        report.case.title or Message("captions.mooring_line"),
        (
            Section(Message("fatigue.by_segment"), (_segments(report), _strengths(report), *said)),
            Section(Message("fatigue.by_state"), (_states(report), _damages(report))),
        ),
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
    return Message("fatigue.not_proven", said=said, verdict=_proven(report.verdict))


def _convergence(report: FatigueReport) -> Iterator[Message]:
    """Say how far the ranges behind the damage hang on the step, where they were run again."""
    changes = [each.change for each in report.segments if each.change is not None]
    if changes:
        yield Message("fatigue.change", part=max(changes))


_PROVEN = {
    "converged": "fatigue.converged",
    "not converged": "fatigue.not_converged",
    "not proven": "fatigue.run_once",
}


def _proven(verdict: str) -> Message:
    return Message(_PROVEN[verdict])


def _sentences(report: FatigueReport) -> Iterator[Message]:
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


def _name(each: SegmentFatigue) -> Message:
    words = each.segment.name or each.segment.component
    key = "checks.named_segment" if words else "checks.segment"
    segment = Message(key, number=each.number, name=words)
    if each.line is None:
        return segment
    return Message("fatigue.of_line", line=each.line, segment=segment)


def _column(name: str, values: list[float | None], quantity: Quantity) -> Column:
    return Column(Message(f"fatigue.{name}"), tuple(values), quantity)


def _segments(report: FatigueReport) -> Table:
    found = report.segments
    return Table(
        "fatigue",
        (
            texts("segment", [_name(each) for each in found]),
            _column("damage", [each.damage for each in found], _DAMAGE),
            _column(
                "life",
                [None if each.years is None else each.years * YEAR for each in found],
                _YEARS,
            ),
            _column("wanted", [each.life for each in found], _YEARS),
            _column("design_factor", [each.factor for each in found], _DAMAGE),
            measured("utilisation", [each.utilisation for each in found]),
            Column(
                Message("columns.verdict"),
                tuple(
                    Message("answers.passes" if each.utilisation <= 1.0 else "answers.fails")
                    for each in found
                ),
                passes=tuple(each.utilisation <= 1.0 for each in found),
            ),
        ),
        marked=found.index(report.governing),
    )


def _strengths(report: FatigueReport) -> Table:
    """Say by which curve and reference, and where in the segment."""
    found = report.segments
    areas = [
        each.strength.reference if each.strength.curve.kind == "S-N" else None for each in found
    ]
    MBL = [each.strength.reference if each.strength.curve.kind == "T-N" else None for each in found]
    return Table(
        "fatigue_strength",
        (
            texts("segment", [_name(each) for each in found]),
            Column(Message("fatigue.curve"), tuple(_curve(each) for each in found)),
            Column(
                Message("fatigue.changes"), tuple(_changes(each) for each in found), only="files"
            ),
            measured("nominal_diameter", [each.strength.diameter for each in found]),
            _column("area", areas, _AREA),
            _column("strength", MBL, QUANTITIES["MBL"]),
            measured("s", [each.arc for each in found]),
            _column("along", [each.along for each in found], _PART),
            Column(
                Message("fatigue.factor_by"),
                tuple(each.factor_source.text for each in found),
            ),
        ),
        Message("fatigue.half_loss"),
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


def _states(report: FatigueReport) -> Table:
    states = report.states
    return Table(
        "fatigue_sea_states",
        (
            texts("no", range(1, len(states) + 1)),
            _column("height", [each.height for each in states], _HEIGHT),
            _column("period", [each.period for each in states], _PERIOD),
            _column("share", [each.share for each in states], _PART),
            Column(Message("fatigue.runs"), tuple(len(run.parts[0].runs) for run in report.runs)),
            Column(
                Message("fatigue.convergence"), tuple(_proven(run.verdict) for run in report.runs)
            ),
        ),
    )


_HEIGHT = Quantity("height", "Height", "", "m", "m", 1.0, 2)


def _damages(report: FatigueReport) -> Table:
    """Tabulate what each sea state does to each segment."""
    rows = [(each, k) for each in report.segments for k in range(len(report.states))]
    at = [each.states[k] for each, k in rows]
    return Table(
        "fatigue_damage",
        (
            texts("segment", [_name(each) for each, _ in rows]),
            Column(Message("fatigue.sea_state"), tuple(k + 1 for _, k in rows)),
            _column("damage", [each.damage for each in at], _DAMAGE),
            _column("mean", [each.mean for each in at], QUANTITIES["tension"]),
            _column("cycles", [each.cycles for each in at], _DAMAGE),
            _column("at_half_step", [each.at_half_step for each in at], _DAMAGE),
            _column("by_spectrum", [each.by_spectrum for each in at], _DAMAGE),
        ),
        Message("fatigue.mean_there"),
    )
