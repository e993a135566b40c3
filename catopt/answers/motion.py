"""What a line in motion consists of, or all lines of a body."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from catopt.answers.blocks import (
    Answer,
    Block,
    Column,
    Section,
    Table,
    Text,
    Value,
    Verdict,
    bare,
    in_si,
    keyed,
    measured,
    named,
    of_row,
    texts,
    where_known,
    yes_or_no,
)
from catopt.answers.check import checks_in_motion
from catopt.answers.verification import label, remarks
from catopt.quantities import Quantity
from catopt.units import lasting
from catopt.verify.motion_words import DYNAMIC_QUANTITY_OF, motion_sentences, proof_sentences
from catopt.words import Message, Several, term

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    from catopt.checks.result import CheckReport
    from catopt.fem import Extreme, TailFit
    from catopt.fem.energy_balance import EnergyBalance
    from catopt.verify.dynamic_result import (
        DynamicPart,
        DynamicRun,
        DynamicVerification,
        OverRuns,
    )

_TIME = Quantity("time", "Time", "", "s", "s", 1.0, 4)
_SLACK = replace(_TIME, digits=1)
_RATIO = Quantity("ratio", "Ratio", "", "-", "-", 1.0, 2)
_PART = Quantity("part", "Part", "", "-", "-", 1.0, 2, "scientific")
_PERCENT = Quantity("change", "Change", "", "-", "%", 0.01, 2)
_ENERGY = Quantity("energy", "Energy", "", "J", "J", 1.0, 1)

_PROOF = {
    "none": "motion.proof_none",
    "step": "motion.proof_step",
    "bars": "motion.how_both",
}

ENERGIES: tuple[tuple[str, Callable[[EnergyBalance], float]], ...] = (
    ("Work put in", lambda of: of.put_in),
    ("Work of the ends", lambda of: of.ends),
    ("Work of the water's pressure", lambda of: of.water),
    ("Kinetic energy gained", lambda of: of.kinetic),
    ("Strain energy gained", lambda of: of.elastic),
    ("Potential energy gained", lambda of: of.potential),
    ("Taken by drag", lambda of: of.drag),
    ("Taken by the bed", lambda of: of.bed),
    ("Taken by friction", lambda of: of.friction),
    ("Taken by line damping", lambda of: of.damping),
    ("Numerical", lambda of: of.numerical),
)
"""What the energy balance of a run consists of."""

_Rows = Iterable[float | None]


def motion_answer(
    found: DynamicVerification, checks: CheckReport | None = None, *, with_series: bool = False
) -> Answer:
    """Lay out a case in motion.

    `checks` are of its tensions; nothing is said of them when left out. Files have every sample
    `with_series`.
    """
    said = _of_body(found) if found.case.system is not None else _of_load_cases(found)
    judged = () if checks is None else tuple(checks_in_motion(checks))
    return Answer(
        "dynamic",
        found.case.title or Message("captions.mooring_line"),
        (
            Section(Message("captions.motion"), tuple(said)),
            *((Section(Message("captions.checks_in_motion"), judged),) if judged else ()),
            *_files(found, with_series=with_series),
        ),
    )


# ------------------------------------------------------------------ for people


def _of_load_cases(found: DynamicVerification) -> Iterator[Block]:
    """Say of every load case what the motion does to the line."""
    for part in found.parts:
        title = Message("motion.title")
        if found.case.load_cases:
            title = Message("motion.title_of_load_case", name=part.name)
        yield _quantities(part, title)
        yield Text(_runs(part))
        yield Text(Message("motion.drag_area"))
        yield from (Text(each) for each in motion_sentences(part))
        yield from (Verdict(each, part.verdict == "converged") for each in proof_sentences(part))
        yield from remarks(part.remarks)


def _quantities(part: DynamicPart, caption: str) -> Table:
    found = part.quantities
    time = lasting(part.duration_of_interest)
    probable = Message("columns.most_prob_in", time=time)
    changes = tuple(part.change_of(each.quantity) for each in found)
    columns = (
        *_over_runs(found),
        _bare(probable, found, (each.most_probable_maximum for each in found)),
        Column(Message("columns.change"), changes, _PERCENT),
    )
    return Table("motion", columns, caption, only="people")


def _over_runs(found: Sequence[OverRuns]) -> tuple[Column, ...]:
    """List mean, deviation and ends of quantities, a row each."""
    values: dict[str, _Rows] = {
        "mean": (each.mean for each in found),
        "standard_deviation": (each.std for each in found),
        "min": (each.minimum for each in found),
        "max": (each.maximum for each in found),
    }
    return (
        texts("quantity", [label(DYNAMIC_QUANTITY_OF[each.quantity]) for each in found]),
        *(_bare(Message(f"columns.{key}"), found, rows) for key, rows in values.items()),
    )


def _bare(name: str, found: Sequence[OverRuns], values: _Rows) -> Column:
    units = tuple(bare(DYNAMIC_QUANTITY_OF[each.quantity]) for each in found)
    return Column(name, tuple(values), units=units)


def _of_body(found: DynamicVerification) -> Iterator[Block]:
    """Say what all lines of a body carry, where the body goes, and how it was proven."""
    governing, doubted = found.governing, found.least_proven
    yield _lines(found.parts)
    yield Table("motion_body", _over_runs(found.body), Message("motion.the_body"), only="people")
    yield Text(_runs(governing))
    yield Text(Message("motion.drag_area"))
    for said in motion_sentences(governing):
        yield Text(_of_line(governing, said))
    for said in proof_sentences(doubted):
        yield Verdict(_of_line(doubted, said), doubted.verdict == "converged")
    yield from remarks(dict.fromkeys(each for part in found.parts for each in part.remarks))


def _of_line(part: DynamicPart, said: str) -> Message:
    return Message("motion.said_of_line", number=part.line, said=said)


def _lines(parts: Sequence[DynamicPart]) -> Table:
    found = [part.of("fairlead_tension") for part in parts]
    values: dict[str, _Rows] = {
        "mean": (each.mean for each in found),
        "standard_deviation": (each.std for each in found),
        "max": (each.maximum for each in found),
        "quasi_static": (part.quasi_static_max for part in parts),
    }
    others: dict[str, tuple[Quantity, _Rows]] = {
        "amplification": (_RATIO, (part.amplification for part in parts)),
        "slack": (_SLACK, (part.slack_time for part in parts)),
        "change": (_PERCENT, (part.change_of("fairlead_tension") for part in parts)),
    }
    return Table(
        "motion_lines",
        (
            texts("line", [part.line for part in parts]),
            *(measured("tension", rows, key, symbol="") for key, rows in values.items()),
            *(
                Column(Message(f"columns.{key}"), tuple(rows), quantity)
                for key, (quantity, rows) in others.items()
            ),
        ),
        Message("motion.lines_of_body"),
        only="people",
    )


def _runs(part: DynamicPart) -> Message:
    history = part.runs[-1].history
    return Message(
        "motion.runs",
        count=len(part.runs),
        time=float(history.time[-1]),
        step=history.step,
        bars=part.elements,
        since=history.since,
    )


# ------------------------------------------------------------------ files, in SI


def _files(found: DynamicVerification, *, with_series: bool) -> Iterator[Section]:
    tables = {
        "statistics": _statistics(found.parts),
        "summary": _summary(found.parts),
        "runs": _runs_in_files(found.parts),
        "envelope": _envelope(found.parts),
    }
    if with_series:
        tables["series"] = _series(found.parts)
        if found.body:
            tables["body"] = _track(found.parts[0])
    for key, columns in tables.items():
        yield Section(Message(f"captions.{key}"), (Table(f"dynamic_{key}", columns, only="files"),))


def _of(parts: Iterable[DynamicPart]) -> Column:
    """Say what each row is of: a load case, or a line of a body."""
    rows = list(parts)
    if rows[0].line is None:
        return texts("load_case", [part.name for part in rows])
    return texts("line", [part.line for part in rows])


def _si(key: str, values: _Rows, name: str = "", *, symbol: str | None = None) -> Column:
    """Make a column of a quantity in SI."""
    made = measured(key, values, name, symbol=symbol)
    return replace(made, quantity=in_si(named(key, symbol), 2 if key == "tension" else 3))


def _pure(name: str, values: _Rows, quantity: Quantity = _RATIO) -> Column:
    return Column(Message(f"columns.{name}"), tuple(values), quantity)


def _statistics(parts: Sequence[DynamicPart]) -> tuple[Column, ...]:
    rows = [(part, each) for part in parts for each in part.quantities]
    found = [each for _, each in rows]
    names = [DYNAMIC_QUANTITY_OF[each.quantity].name for each in found]
    changes = [part.change_of(each.quantity) for part, each in rows]
    return (
        _of(part for part, _ in rows),
        texts("quantity", [keyed(each.quantity, term(name))
                           for each, name in zip(found, names, strict=True)]),
        texts("unit", [each.unit for each in found]),
        of_row("mean", (each.mean for each in found)),
        of_row("standard_deviation", (each.std for each in found)),
        of_row("minimum", (each.minimum for each in found)),
        of_row("maximum", (each.maximum for each in found)),
        _pure("change_of_the_maximum", changes, replace(_RATIO, digits=3)),
        *_extreme_columns(found),
    )  # fmt: skip


def _extreme_columns(found: Sequence[OverRuns]) -> tuple[Column, ...]:
    """List what the extremes are, and what they rest on."""
    tails = [each.tail for each in found]
    of_tails = where_known(tails, lambda tail: tail.extreme)
    of_runs = where_known([each.gumbel for each in found], lambda fit: fit.extreme)

    def at(of: Iterable[Extreme | None], value: Callable[[Extreme], float]) -> list[float | None]:
        return where_known(of, value)

    def by(value: Callable[[TailFit], float]) -> list[float | None]:
        return where_known(tails, value)

    return (
        _pure("duration_of_interest", at(of_tails, lambda each: each.duration), _TIME),
        of_row("most_probable_maximum", at(of_tails, lambda each: each.most_probable)),
        of_row("interval_from", at(of_tails, lambda each: each.low)),
        of_row("interval_to", at(of_tails, lambda each: each.high)),
        _pure("confidence_of_the_interval", at(of_tails, lambda each: each.confidence)),
        of_row("expected_maximum", at(of_tails, lambda each: each.expected)),
        of_row("threshold_of_the_tail", by(lambda tail: tail.threshold)),
        texts("peaks_above_the_threshold", by(lambda tail: len(tail.clusters))),
        of_row("weibull_scale", by(lambda tail: tail.scale)),
        _pure("weibull_shape", by(lambda tail: tail.shape)),
        of_row("gumbel_most_probable_maximum", at(of_runs, lambda each: each.most_probable)),
        of_row("gumbel_interval_from", at(of_runs, lambda each: each.low)),
        of_row("gumbel_interval_to", at(of_runs, lambda each: each.high)),
    )


def _summary(parts: Sequence[DynamicPart]) -> tuple[Column, ...]:
    still = "largest_quasi_static_fairlead_tension"
    return (
        _of(parts),
        texts("runs", [len(part.runs) for part in parts]),
        texts("bars", [part.elements for part in parts]),
        texts("complete", [yes_or_no(part.is_complete) for part in parts]),
        _si("tension", (part.max_tension for part in parts), "largest_tension_anywhere", symbol=""),
        _si("tension", (part.quasi_static_max for part in parts), still, symbol=""),
        _pure("dynamic_amplification", (part.amplification for part in parts)),
        _pure("slack_in_all", (part.slack_time for part in parts), _TIME),
        _pure("longest_slack", (part.longest_slack for part in parts), _TIME),
        texts("verdict", [term(part.verdict) for part in parts]),
        texts("proof", [Message(_PROOF[part.proof]) for part in parts]),
        _pure(
            "change_of_the_largest_tension",
            (part.change_of("largest_tension") for part in parts),
            replace(_RATIO, digits=3),
        ),
        *(
            _si("tension", (part.anchor_at_rest.get(state) for part in parts),
                f"anchor_at_rest_{state}", symbol="")
            for state in ("pulled", "none", "laid")
        ),
        _pure("numerical_part_of_the_work", (part.numerical_part for part in parts), _PART),
        texts("remarks", [Several(part.remarks) for part in parts]),
    )  # fmt: skip


def _runs_in_files(parts: Sequence[DynamicPart]) -> tuple[Column, ...]:
    rows = [(part, run) for part in parts for run in part.runs]
    runs = [run for _, run in rows]
    of = [run.history for run in runs]
    largest = [run.statistics("fairlead_tension") for run in runs]
    still = "largest_quasi_static_fairlead_tension"
    return (
        _of(part for part, _ in rows),
        texts("run", [run.number + 1 for run in runs]),
        _pure("reached", (float(each.time[-1]) for each in of), _TIME),
        _pure("statistics_since", (each.since for each in of), _TIME),
        _pure("time_step", (each.step for each in of), _TIME),
        _pure("shortest_step", (each.shortest_step for each in of), _TIME),
        texts("steps", [each.steps for each in of]),
        texts("newton_iterations", [each.iterations for each in of]),
        texts("halvings", [each.halvings for each in of]),
        _si("tension", (each.maximum for each in largest), "largest_fairlead_tension", symbol=""),
        _pure("at", (each.time_of_maximum for each in largest), _TIME),
        _si("tension", (run.quasi_static_max for run in runs), still, symbol=""),
        _pure("slack_in_all", (each.line_slack_time() for each in of), _TIME),
        _pure("longest_slack", (each.line_longest_slack() for each in of), _TIME),
        *(
            Column(term(name), tuple(energy(each.balance) for each in of), _ENERGY)
            for name, energy in ENERGIES
        ),
        _pure(
            "numerical_part_of_the_work", (each.balance.numerical_part for each in of), _PART
        ),
    )  # fmt: skip


def _envelope(parts: Sequence[DynamicPart]) -> tuple[Column, ...]:
    found = [part.envelope for part in parts]
    rows = (part for part, of in zip(parts, found, strict=True) for _ in of.arc)
    return (
        _of(rows),
        _si("s", _joined(of.arc for of in found)),
        _si("tension", _joined(of.largest for of in found), "largest_tension", symbol=""),
        _si("tension", _joined(of.smallest for of in found), "smallest_tension", symbol=""),
        _pure("slack_in_all", _joined(of.slack for of in found), _TIME),
        _pure("longest_slack", _joined(of.longest_slack for of in found), _TIME),
    )


def _joined(arrays: Iterable[npt.NDArray[np.float64]]) -> Iterator[float]:
    for each in arrays:
        yield from each.tolist()


def _series(parts: Sequence[DynamicPart]) -> tuple[Column, ...]:
    pairs = [(part, run) for part in parts for run in part.runs]
    of = [run.history for _, run in pairs]
    still = (run.quasi_static for _, run in pairs)
    return (
        _of(part for part, run in pairs for _ in run.history.time),
        _numbers([run for _, run in pairs]),
        _pure("time", _joined(each.time for each in of), _TIME),
        _si("tension", _joined(each.fairlead_tension[:, 0] for each in of), "fairlead_tension"),
        _si("tension", _joined(still), "quasi_static_fairlead_tension", symbol=""),
        _si("tension", _joined(each.anchor_tension[:, 0] for each in of), "anchor_tension",
            symbol="TA"),
        _si("grounded_length", _joined(each.grounded_length[:, 0] for each in of)),
        *(
            _si("offset", _joined(each.fairlead[:, 0, axis] for each in of), f"fairlead_{name}")
            for axis, name in enumerate("xyz")
        ),
        _si("offset", _joined(each.offset[:, 0] for each in of), "fairlead_offset"),
    )  # fmt: skip


def _numbers(runs: Iterable[DynamicRun]) -> Column:
    numbers: list[Value] = [run.number + 1 for run in runs for _ in run.history.time]
    return texts("run", numbers)


def _track(part: DynamicPart) -> tuple[Column, ...]:
    """Tabulate where the origin of a moored body was."""
    found = [(run, run.track) for run in part.runs if run.track is not None]
    return (
        _numbers([run for run, _ in found]),
        _pure("time", _joined(run.history.time for run, _ in found), _TIME),
        *(
            _si("offset", _joined(track[:, axis] for _, track in found), f"body_{name}")
            for axis, name in enumerate("xyz")
        ),
    )
