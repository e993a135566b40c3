"""What a study consists of: its plan, its members, and what came of them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from catopt.answers.blocks import (
    Answer,
    Block,
    Column,
    Fact,
    Facts,
    Section,
    Table,
    Text,
    Verdict,
    Warnings,
    texts,
)
from catopt.constants import YEAR
from catopt.quantities import Quantity
from catopt.words import Cited, Message

if TYPE_CHECKING:
    from catopt.study.base import Kept
    from catopt.study.result import ByChoice, Statistic, StudyResult
    from catopt.study.run import Plan
    from catopt.study.store import Computed
    from catopt.study.study import Study

_SHARE = Quantity("share", "Share", "", "-", "-", 1.0, 4, "significant")
_INDEX = Quantity("index", "Reliability index", "", "-", "-", 1.0, 3)
_HOURS = Quantity("hours", "Hours", "", "s", "h", 3600.0, 2)
_TIME = Quantity("time", "Time", "", "s", "s", 1.0, 3, "significant")
_DISK = Quantity("disk", "Disk", "", "byte", "MB", 1e6, 3, "significant")


def study_answer(result: StudyResult) -> Answer:
    """Lay out what came of a study."""
    return Answer(
        "study",
        result.study.title or Message("study.title"),
        (Section(Message("study.results"), tuple(_blocks(result))),),
    )


def _blocks(result: StudyResult) -> Iterator[Block]:
    yield _state(result)
    if result.is_complete and len(result.study) <= _FEW:
        yield _few(result)
    if result.statistics:
        yield _statistics(result)
        if any(each.limit is not None for each in result.statistics):
            yield _limits(result)
            if result.by_choice:
                yield _by_choice(result)
            yield from _first_orders(result)
        yield _worst(result)
    unknown = result.study.limits.keys() - {each.kept.name for each in result.statistics}
    if unknown:
        names = ", ".join(sorted(unknown))
        yield Warnings((Message("study.limit_unknown", names=names),))
    if result.influences:
        yield _influences(result)
        yield Text(Message("study.influence_note"), is_small=True)
    for name, counted in result.counted().items():
        if counted:
            yield _counts(name, counted)
    if result.reasons:
        yield _failures(result)
    yield from _reach(result)


def _reach(result: StudyResult) -> Iterator[Block]:
    """Say what the numbers do not cover."""
    base = result.study.base
    if base.compute == "linear":
        slack = dict(result.counted().get("taut", [])).get("no", 0)
        if slack:
            yield Warnings((Message("study.may_go_slack", count=slack),))
        yield Text(Message("study.linear_note"), is_small=True)
    if base.compute == "motion" and base.proof == "none":
        yield Verdict(Message("study.once"), passes=False)


_FEW = 40
"""Members that are shown one by one."""

_TOLD = (
    "title", "line", "holding_mass", "fairlead_tension", "fairlead_probable", "utilisation"
)  # fmt: skip
"""What is shown of each of few members where there is little room, the first before the others."""


def _few(result: StudyResult) -> Table:
    """Tabulate few members, for people: files have them in a table of their own."""
    parts = [members_table(result.study, each) for each in result.store.pieces()]
    columns = [
        replace(column, values=tuple(value for part in parts for value in part.columns[at].values))
        for at, column in enumerate(parts[0].columns)
    ]
    told = [column for column in columns if any(_is_known(each) for each in column.values)]
    names = ["no", *result.study.keys, *(each.name for each in _in_table(result.study))]
    order = {id(column): name for column, name in zip(columns, names, strict=False)}
    shown = tuple(
        replace(each, priority=0 if order.get(id(each), "") in ("no", *_TOLD) else at + 1)
        for at, each in enumerate(told)
    )
    return Table("few_members", shown, only="people")


def _is_known(value: Any) -> bool:
    return value == value and value not in ("", None)  # nan is not itself


def _in_table(study: Study) -> list[Kept]:
    """List what is kept as the table of members has it: numbers, then words."""
    return sorted(study.base.kept, key=lambda each: not each.quantity)


def _state(result: StudyResult) -> Verdict:
    values = {"members": len(result.study), "failed": len(result.reasons)}
    if result.is_complete:
        return Verdict(Message("study.done", **values), passes=True if not result.reasons else None)
    return Verdict(Message("study.not_done", done=result.done, **values), passes=False)


def _of_rows(name: str, values: Iterator[Any], found: tuple[Statistic, ...], **said: Any) -> Column:
    units = tuple(replace(each.kept.measure, symbol="") for each in found)
    return Column(Message(f"study.{name}", **said), tuple(values), units=units)


def _statistics(result: StudyResult) -> Table:
    found = result.statistics
    shares = result.levels
    return Table(
        "study",
        (
            Column(Message("study.quantity"), tuple(each.kept.words for each in found)),
            Column(Message("study.members"), tuple(each.count for each in found), priority=3),
            _of_rows("mean", (each.mean for each in found), found),
            replace(_of_rows("deviation", (e.deviation for e in found), found), priority=1),
            _of_rows("least", (each.least for each in found), found),
            *(
                replace(
                    _of_rows("level", (each.levels[k] for each in found), found, share=share),
                    priority=2 if share < 0.9 else 0,
                )
                for k, share in enumerate(shares)
            ),
            _of_rows("largest", (each.largest for each in found), found),
        ),
        Message("study.statistics"),
    )


def _limits(result: StudyResult) -> Table:
    found = tuple(each for each in result.statistics if each.limit is not None)
    shares = tuple(each.beyond for each in found)
    hours = tuple(None if each is None else each * YEAR for each in shares)
    return Table(
        "study_limits",
        (
            Column(Message("study.quantity"), tuple(each.kept.words for each in found)),
            _of_rows("limit", (each.limit for each in found), found),
            Column(Message("study.share_beyond"), shares, _SHARE),
            Column(Message("study.hours_beyond"), hours, _HOURS),
            *_intervals(found),
            *_first_beyond(result, found),
        ),
        Message("study.limits"),
    )


def _first_beyond(result: StudyResult, found: Sequence[Statistic]) -> Iterator[Column]:
    """Yield the first member beyond each limit, such as the first year in which a check fails."""
    study = result.study
    members = [each.first_beyond for each in found]
    if study.distributions or all(each is None for each in members):
        return
    said = (
        "" if each is None else ", ".join(
            study.written(key, value) for key, value in study.told_of(each).items()
        )
        for each in members
    )  # fmt: skip
    yield Column(Message("study.first_beyond"), _cells(said))


def _intervals(found: Sequence[Statistic | ByChoice]) -> Iterator[Column]:
    """Yield both ends of the intervals of the shares, where they are probabilities."""
    for end, name in enumerate(("probable_from", "probable_to")):
        cells = tuple(None if each.interval is None else each.interval[end] for each in found)
        if any(each is not None for each in cells):
            yield Column(Message(f"study.{name}"), cells, _SHARE)


def _by_choice(result: StudyResult) -> Table:
    """Tabulate how often the limits are passed by each choice of what is not drawn."""
    found, study = result.by_choice, result.study
    keys = [key for axis in study.axes if not axis.is_drawn for key in axis.columns]
    values = [study.values_of(each.member) for each in found]
    return Table(
        "study_by_choice",
        (
            Column(Message("study.quantity"), tuple(each.kept.words for each in found)),
            *(
                Column(Cited(key), _cells(study.written(key, each[key]) for each in values))
                for key in keys
            ),
            Column(Message("study.share_beyond"), tuple(each.share for each in found), _SHARE),
            *_intervals(found),
        ),
        Message("study.by_choice"),
        only="all" if len(found) <= _FEW else "files",
    )


def _first_orders(result: StudyResult) -> Iterator[Block]:
    """Yield reliability by the first order, and where each limit is most likely passed."""
    kept = {each.kept.name: each.kept for each in result.statistics}
    found = [(kept[name], each) for name, each in result.first_orders.items() if each is not None]
    if found:
        yield Table(
            "study_first_order",
            (
                Column(Message("study.quantity"), tuple(of.words for of, _ in found)),
                Column(Message("study.index"), tuple(each.index for _, each in found), _INDEX),
                Column(
                    Message("study.probability"), tuple(e.probability for _, e in found), _SHARE
                ),
            ),
            Message("study.first_order"),
        )
        rows = [(of, each, key) for of, each in found for key in each.point]
        yield Table(
            "study_failure_point",
            (
                Column(Message("study.quantity"), tuple(of.words for of, _, _ in rows)),
                texts_of_keys([(key,) for _, _, key in rows]),
                Column(
                    Message("study.value"),
                    _cells(result.study.written(key, each.point[key]) for _, each, key in rows),
                ),
                Column(
                    Message("study.importance"),
                    tuple(each.importance[key] for _, each, key in rows),
                    _SHARE,
                ),
            ),
            Message("study.failure_point"),
        )
    missing = [str(kept[name].name) for name, each in result.first_orders.items() if each is None]
    if missing:
        yield Warnings((Message("study.no_first_order", names=", ".join(missing)),))


def _worst(result: StudyResult) -> Table:
    rows = [
        (each, key, value)
        for each in result.statistics
        if each.least < each.largest
        for key, value in result.study.told_of(each.worst).items()
    ]
    return Table(
        "study_worst",
        (
            Column(Message("study.at"), tuple(each.kept.words for each, _, _ in rows)),
            Column(Message("study.member"), tuple(each.worst + 1 for each, _, _ in rows)),
            Column(Message("study.key"), tuple(Cited(key) for _, key, _ in rows)),
            Column(
                Message("study.value"),
                _cells(result.study.written(key, value) for _, key, value in rows),
            ),
        ),
        Message("study.worst_members"),
    )


def _influences(result: StudyResult) -> Table:
    found = result.influences
    of = replace(result.statistics[0].kept.measure, symbol="")
    return Table(
        "study_influences",
        (
            texts_of_keys([each.keys for each in found]),
            Column(Message("study.share"), tuple(each.share for each in found), _SHARE),
            Column(Message("study.least_mean"), tuple(each.low for each in found), of),
            Column(Message("study.largest_mean"), tuple(each.high for each in found), of),
        ),
        Message("study.influences"),
    )


def texts_of_keys(rows: list[tuple[str, ...]]) -> Column:
    """Make a column of key paths that vary together."""
    return Column(Message("study.key"), tuple(Cited(", ".join(keys)) for keys in rows))


def _counts(name: str, counted: list[tuple[str, int]]) -> Table:
    return Table(
        f"study_{name}",
        (
            Column(Message(f"study.{name}"), _cells(text for text, _ in counted)),
            Column(Message("study.members"), tuple(n for _, n in counted)),
        ),
        Message("study.counts"),
    )


def _failures(result: StudyResult) -> Table:
    found = result.failures()
    return Table(
        "study_failures",
        (
            Column(Message("study.reason"), _cells(why.split("\n", 1)[0] for why, _, _ in found)),
            Column(Message("study.members"), tuple(n for _, n, _ in found)),
            Column(Message("study.first"), tuple(first + 1 for _, _, first in found)),
        ),
        Message("study.failures"),
    )


def members_table(study: Study, found: Computed) -> Table:
    """Tabulate the members of a piece: what varies, what came of each, and why there is none."""
    first = study.piece_start(found.number)
    count = len(found.numbers)
    values = study.values(first, first + count)
    kept = _in_table(study)
    measured = [each for each in kept if each.quantity]
    named = [each for each in kept if not each.quantity]
    columns = [texts("no", range(first + 1, first + count + 1))]
    for key, column in values.items():
        plain = column if isinstance(column, list) else getattr(column, "tolist", list)()
        columns.append(
            Column(Message("study.of_key", key=key), _cells(plain), study.quantity_of(key))
        )
    for at, each in enumerate(measured):
        numbers = found.numbers[:, at].tolist()
        quantity = replace(each.measure, symbol="")
        columns.append(Column(each.words, tuple(numbers), quantity))
    for at, each in enumerate(named):
        words = _cells(row[at] for row in found.words)
        columns.append(Column(each.words, words))
    reasons = _cells(found.reasons.get(member, "") for member in range(count))
    columns.append(Column(Message("study.reason"), reasons))
    return Table("members", tuple(columns))


def _cells(values: Iterable[Any]) -> tuple[Any, ...]:
    """Take words as they were stored, or as the user has them."""
    return tuple(Cited(each) if isinstance(each, str) else each for each in values)


def plan_answer(plan: Plan) -> Answer:
    """Lay out how much a study asks for."""
    study = plan.study
    axes = study.axes
    varied = Table(
        "study_axes",
        (
            texts_of_keys([tuple(axis.columns) for axis in axes]),
            Column(Message("study.values"), tuple(len(axis) for axis in axes)),
            Column(
                Message("study.drawn"),
                tuple(Message("answers.yes" if a.is_drawn else "answers.no") for a in axes),
            ),
        ),
    )
    facts = (
        Fact(Message("study.members"), len(study)),
        Fact(Message("study.sample"), plan.timed),
        Fact(Message("study.time"), plan.seconds, _TIME),
        Fact(Message("study.disk"), plan.size, _DISK),
    )
    blocks = (varied, Facts("study_plan", facts))
    title = study.title or Message("study.title")
    return Answer("study_plan", title, (Section(Message("study.plan"), blocks),))
