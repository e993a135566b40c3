"""What a study consists of: its plan, its members, and what came of them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from operator import itemgetter
from typing import TYPE_CHECKING, Any

from catopt.answers import blocks
from catopt.answers.blocks import Rows, if_known, measured, section, stated, tabulate, texts
from catopt.constants import YEAR
from catopt.quantities import Quantity
from catopt.words import Cited, Message, Several

if TYPE_CHECKING:
    from catopt.study.member import Output
    from catopt.study.reliability import FirstOrder
    from catopt.study.result import ByChoice, Statistic, StudyResult
    from catopt.study.run import Plan
    from catopt.study.store import Computed
    from catopt.study.study import Study

_SHARE = Quantity("share", "Share", "", "-", "-", 1.0, 4, "significant")
_INDEX = Quantity("index", "Reliability index", "", "-", "-", 1.0, 3)
_HOURS = Quantity("hours", "Hours", "", "s", "h", 3600.0, 2)
_TIME = Quantity("time", "Time", "", "s", "s", 1.0, 3, "significant")
_DISK = Quantity("disk", "Disk", "", "byte", "MB", 1e6, 3, "significant")


def study_answer(result: StudyResult) -> blocks.Answer:
    """Lay out what came of a study."""
    title = result.study.title or Message("study.title")
    return blocks.answered("study", title, section("study.results", *_blocks(result)))


def _blocks(result: StudyResult) -> Iterator[blocks.Block]:
    yield from _heads(result)
    if result.is_complete and len(result.study) <= _FEW:
        yield _few(result)
    if result.statistics:
        yield _statistics(result)
        yield from _of_fewer(result)
        if any(each.limit is not None for each in result.statistics):
            yield _limits(result)
            if result.by_choice:
                yield _by_choice(result)
            yield from _first_orders(result)
        yield _worst(result)
    unknown = result.study.limits.keys() - {each.kept.name for each in result.statistics}
    if unknown:
        names = ", ".join(sorted(unknown))
        yield blocks.Warnings((Message("study.limit_unknown", names=names),))
    if result.influences:
        yield _influences(result)
        yield blocks.Text(Message("study.influence_note"), is_small=True)
    for name, counted in result.counted().items():
        if counted:
            words, counts = zip(*counted, strict=True)
            columns = (texts(f"study.{name}", _cells(words)), texts("study.members", counts))
            yield tabulate(f"study_{name}", *columns, caption=Message("study.counts"))
    if result.reasons:
        yield _failures(result)
    yield from _reach(result)


def _reach(result: StudyResult) -> Iterator[blocks.Block]:
    """Say what the numbers do not cover."""
    base = result.study.base
    if base.compute == "linear":
        slack = dict(result.counted().get("taut", [])).get("no", 0)
        if slack:
            yield blocks.Warnings((Message("study.may_go_slack", count=slack),))
        yield blocks.Text(Message("study.linear_note"), is_small=True)
    if base.compute == "motion" and base.convergence_check == "none":
        yield blocks.Verdict(Message("study.once"), passes=False)


_FEW = 40
"""Members that are shown one by one."""

_TOLD = {"title", "line", "holding_mass", "fairlead_tension", "fairlead_probable", "utilisation"}
"""What is shown of each of few members where there is little room, the first before the others."""


def _few(result: StudyResult) -> blocks.Table:
    """Tabulate few members, for people: files have them in a table of their own."""
    parts = [members_table(result.study, each) for each in result.store.pieces()]
    names = ["no", *result.study.keys, *(each.name for each in _in_table(result.study)), "reason"]
    every = zip(names, blocks.stacked(parts), strict=True)
    reported = [(name, each) for name, each in every if any(map(_is_known, each.values))]
    shown = tuple(
        replace(each, priority=0 if name in _TOLD | {"no"} else at)
        for at, (name, each) in enumerate(reported, start=1)
    )
    return blocks.Table("few_members", shown, only="people")


def _is_known(value: Any) -> bool:
    return value == value and value not in ("", None)  # nan is not itself


def _in_table(study: Study) -> list[Output]:
    """List what is kept as the table of members has it: numbers, then words."""
    return sorted(study.base.kept, key=lambda each: not each.quantity)


def _heads(result: StudyResult) -> Iterator[blocks.Verdict]:
    yield _state(result)
    if heights := result.study.heights_that_stay:
        said = Message("study.heights_stay", keys=Cited(", ".join(heights)))
        yield blocks.Verdict(said, None)


def _state(result: StudyResult) -> blocks.Verdict:
    values = {"members": len(result.study), "failed": len(result.reasons)}
    state = Message("study.done", **values)
    if not result.is_complete:
        state = Message("study.not_done", done=result.done, **values)
    said = Several((state, *(axis.counted for axis in result.study.axes if axis.counted)), " ")
    # That every member has an answer is no pass: what each comes to is among the numbers.
    return blocks.Verdict(said, None if result.is_complete else False)


_QUANTITY = ("study.quantity", "kept.words")
"""Heading of what a row is of, and where a row has it."""


def _statistics(result: StudyResult) -> blocks.Table:
    of, units = Rows(result.statistics), _units(result.statistics)
    levels = (
        texts(
            Message("study.level", share=share),
            [each.levels[k] for each in result.statistics],
            units=units,
            priority=2 if share < 0.9 else 0,
        )
        for k, share in enumerate(result.levels)
    )
    return tabulate(
        "study",
        of.texts(*_QUANTITY),
        of.texts("study.members", "count", priority=0 if _fewest(result) else 3),
        of.texts("study.mean", "mean", units=units),
        of.texts("study.deviation", "deviation", units=units, priority=1),
        of.texts("study.least", "least", units=units),
        *levels,
        of.texts("study.largest", "largest", units=units),
        caption=Message("study.statistics"),
    )


def _fewest(result: StudyResult) -> list[Statistic]:
    """List the statistics that are of fewer members than others are."""
    most = max(each.count for each in result.statistics)
    return [each for each in result.statistics if each.count < most]


def _of_fewer(result: StudyResult) -> Iterator[blocks.Verdict]:
    """Say which rows are of fewer members, and whether those that are left out fail."""
    most = max(each.count for each in result.statistics)
    for each in _fewest(result):
        said = Message("study.of_fewer", name=each.kept.words, count=each.count, members=most)
        yield blocks.Verdict(said, None)
    if result.fails_unused:
        yield blocks.Verdict(Message("study.fails_unused", count=result.fails_unused), passes=False)


def _units(found: Sequence[Statistic]) -> tuple[Quantity, ...]:
    return tuple(replace(each.kept.measure, symbol="") for each in found)


def _limits(result: StudyResult) -> blocks.Table:
    found = [each for each in result.statistics if each.limit is not None]
    of = Rows(found)
    hours = (None if each is None else each * YEAR for each in of.read("beyond"))
    return tabulate(
        "study_limits",
        of.texts(*_QUANTITY),
        of.texts("study.limit", "limit", units=_units(found)),
        of.measured(_SHARE, "beyond", "study.share_beyond"),
        measured(_HOURS, hours, "study.hours_beyond"),
        *_intervals(found),
        *_first_beyond(result, found),
        caption=Message("study.limits"),
    )


def _first_beyond(result: StudyResult, found: Sequence[Statistic]) -> Iterator[blocks.Column]:
    """Yield the first member beyond each limit, such as the first year in which a check fails."""
    study = result.study
    members = [each.first_beyond for each in found]
    if study.distributions or all(each is None for each in members):
        return
    said = (
        ", ".join(study.written(key, value) for key, value in study.reported_of(each).items())
        if each is not None
        else ""
        for each in members
    )
    yield texts("study.first_beyond", _cells(said))


def _intervals(found: Sequence[Statistic | ByChoice | FirstOrder]) -> Iterator[blocks.Column]:
    """Yield both ends of the intervals of the shares, where they are probabilities."""
    intervals = Rows(each.interval for each in found)
    for end, name in enumerate(("probable_from", "probable_to")):
        yield from if_known(intervals.measured(_SHARE, itemgetter(end), f"study.{name}"))


def _by_choice(result: StudyResult) -> blocks.Table:
    """Tabulate how often the limits are passed by each choice of what is not drawn."""
    found, study = result.by_choice, result.study
    of = Rows(found)
    keys = [key for axis in study.axes if not axis.is_drawn for key in axis.columns]
    values = [study.values_of(each.member) for each in found]
    return tabulate(
        "study_by_choice",
        of.texts(*_QUANTITY),
        *(
            blocks.Column(Cited(key), _cells(study.written(key, each[key]) for each in values))
            for key in keys
        ),
        of.measured(_SHARE, "share", "study.share_beyond"),
        *_intervals(found),
        caption=Message("study.by_choice"),
        only="all" if len(found) <= _FEW else "files",
    )


def _first_orders(result: StudyResult) -> Iterator[blocks.Block]:
    """Yield reliability by the first order, and where each limit is most likely passed."""
    kept = {each.kept.name: each.kept for each in result.statistics}
    found = [(kept[name], each) for name, each in result.first_orders.items() if each is not None]
    if found:
        every = Rows(each for _, each in found)
        yield tabulate(
            "study_first_order",
            texts("study.quantity", [of.words for of, _ in found]),
            every.measured(_INDEX, "index", "study.index"),
            every.measured(_SHARE, "probability", "study.probability"),
            *if_known(every.measured(_SHARE, "sampled", "study.sampled")),
            *_intervals([each for _, each in found]),
            caption=Message("study.first_order"),
        )
        rows = [(of, each, key) for of, each in found for key in each.point]
        written = _cells(result.study.written(key, each.point[key]) for _, each, key in rows)
        yield tabulate(
            "study_failure_point",
            texts("study.quantity", [of.words for of, _, _ in rows]),
            _keys([(key,) for _, _, key in rows]),
            texts("study.value", written),
            measured(_SHARE, [each.importance[key] for _, each, key in rows], "study.importance"),
            caption=Message("study.failure_point"),
        )
    reported = [
        Message(
            "study.other_point",
            name=of.name,
            index=index,
            values=", ".join(f"{key} {result.study.written(key, v)}" for key, v in point.items()),
        )
        for of, each in found
        for index, point in each.others
    ]
    reported += (
        Message("study.no_first_order", name=name, why=why)
        for name, why in result.no_first_orders.items()
    )
    if reported:
        yield blocks.Warnings(tuple(reported))


def _worst(result: StudyResult) -> blocks.Table:
    study, varied = result.study, Rows(e for e in result.statistics if e.least < e.largest)
    of, reported = varied.within(lambda each: study.reported_of(each.worst).items())
    return tabulate(
        "study_worst",
        of.texts("study.at", "kept.words"),
        of.texts("study.member", lambda each: each.worst + 1),
        _keys((key,) for key, _ in reported.rows),
        texts("study.value", _cells(study.written(*each) for each in reported.rows)),
        caption=Message("study.worst_members"),
    )


def _influences(result: StudyResult) -> blocks.Table:
    of = Rows(result.influences)
    measure = replace(result.statistics[0].kept.measure, symbol="")
    return tabulate(
        "study_influences",
        _keys(of.read("keys")),
        of.measured(_SHARE, "share", "study.share"),
        of.measured(measure, "low", "study.least_mean"),
        of.measured(measure, "high", "study.largest_mean"),
        caption=Message("study.influences"),
    )


def _keys(rows: Iterable[Iterable[str]]) -> blocks.Column:
    """Make a column of key paths that vary together."""
    return texts("study.key", [Cited(", ".join(keys)) for keys in rows])


def _failures(result: StudyResult) -> blocks.Table:
    found = result.failures()
    return tabulate(
        "study_failures",
        texts("study.reason", _cells(why.split("\n", 1)[0] for why, _, _ in found)),
        texts("study.members", [count for _, count, _ in found]),
        texts("study.first", [first + 1 for _, _, first in found]),
        caption=Message("study.failures"),
    )


def members_table(study: Study, found: Computed) -> blocks.Table:
    """Tabulate the members of a piece: what varies, what came of each, and why there is none."""
    first = study.piece_start(found.number)
    count = len(found.numbers)
    values = study.values(first, first + count)
    kept = _in_table(study)
    columns = [texts("no", range(first + 1, first + count + 1))]
    for key, column in values.items():
        plain = column if isinstance(column, list) else getattr(column, "tolist", list)()
        quantity = study.quantity_of(key)
        columns.append(texts(Message("study.of_key", key=key), _cells(plain), quantity=quantity))
    numbers = found.numbers.T.tolist()
    for each, own in zip((each for each in kept if each.quantity), numbers, strict=True):
        columns.append(blocks.Column(each.words, tuple(own), replace(each.measure, symbol="")))
    for at, each in enumerate(each for each in kept if not each.quantity):
        columns.append(blocks.Column(each.words, _cells(row[at] for row in found.words)))
    reasons = _cells(found.reasons.get(member, "") for member in range(count))
    return tabulate("members", *columns, texts("study.reason", reasons))


def _cells(values: Iterable[Any]) -> tuple[Any, ...]:
    """Take words as they were stored, or as the user has them."""
    return tuple(Cited(each) if isinstance(each, str) else each for each in values)


def plan_answer(plan: Plan) -> blocks.Answer:
    """Lay out how much a study asks for."""
    study = plan.study
    axes = study.axes
    varied = tabulate(
        "study_axes",
        _keys(axis.columns for axis in axes),
        texts("study.values", map(len, axes)),
        texts("study.drawn", [blocks.yes_or_no(axis.is_drawn) for axis in axes]),
    )
    facts = (
        stated("study.members", len(study)),
        stated("study.sample", plan.timed),
        stated("study.time", plan.seconds, quantity=_TIME),
        stated("study.disk", plan.size, quantity=_DISK),
    )
    title = study.title or Message("study.title")
    of_plan = (varied, blocks.Facts("study_plan", facts))
    return blocks.answered("study_plan", title, section("study.plan", *of_plan))
