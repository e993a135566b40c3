"""What lines in motion consist of: one, all of a body, a ship on them, the designs of a front."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from operator import itemgetter
from typing import TYPE_CHECKING

from catopt.answers import blocks
from catopt.answers.blocks import (
    Rows,
    answered,
    measured,
    named,
    section,
    tabulate,
    texts,
    yes_or_no,
)
from catopt.answers.check import checks_in_motion, tightest_table, verdict_blocks
from catopt.answers.verification import label, quantity_in_note, remarks
from catopt.quantities import QUANTITIES, Quantity
from catopt.units import lasting
from catopt.verify.motion_words import DYNAMIC_QUANTITY_OF, motion_sentences, proof_sentences
from catopt.words import Measure, Message, Several, term

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    from catopt.checks.result import CheckReport
    from catopt.verify.dynamic_result import DynamicPart, DynamicVerification, JointInMotion
    from catopt.verify.dynamic_run import DynamicRun, OverRuns
    from catopt.verify.ship_result import LineOfShip, ShipVerification

_TIME = Quantity("time", "Time", "", "s", "s", 1.0, 4)
_SLACK = replace(_TIME, digits=1)
RATIO = Quantity("ratio", "Ratio", "", "-", "-", 1.0, 2)
_CHANGE = replace(RATIO, digits=3)
_PART = Quantity("part", "Part", "", "-", "-", 1.0, 2, "scientific")
PERCENT = Quantity("change", "Change", "", "-", "%", 0.01, 2)
_ENERGY = Quantity("energy", "Energy", "", "J", "J", 1.0, 1)

FORCE = replace(QUANTITIES["tension"], symbol="")

_PROOF = {"none": "motion.proof_none", "step": "motion.proof_step", "bars": "motion.how_both"}

ENERGIES = {
    "Work put in": "put_in",
    "Work of the ends": "ends",
    "Work of the water's pressure": "water",
    "Kinetic energy gained": "kinetic",
    "Strain energy gained": "elastic",
    "Potential energy gained": "potential",
    "Taken by drag": "drag",
    "Taken by the bed": "bed",
    "Taken by friction": "friction",
    "Taken by line damping": "damping",
    "Numerical": "numerical",
}
"""What the energy balance of a run consists of: names, and attributes of `EnergyBalance`."""


def motion_answer(
    found: DynamicVerification, checks: CheckReport | None = None, *, with_series: bool = False
) -> blocks.Answer:
    """Lay out a case in motion.

    `checks` are of its tensions; nothing is said of them when left out. Files have every sample
    `with_series`.
    """
    said = _of_lines(found) if by_lines(found) else _of_load_cases(found)
    judged = () if checks is None else tuple(checks_in_motion(checks))
    whole = answered(
        "dynamic",
        found.case.title or Message("captions.mooring_line"),
        section("captions.motion", *said),
        *([section("captions.checks_in_motion", *judged)] if judged else []),
        *_files(found, with_series=with_series),
    )
    if found.joints:
        return replace(whole, next="verify_points")
    if len(found.parts) > 1 and checks is not None and not by_lines(found):
        return replace(whole, card=tuple(_card_of_load_cases(found, checks)))
    return whole


def by_lines(found: DynamicVerification) -> bool:
    """Whether its parts are lines of one mooring; else they are load cases of one line."""
    return found.case.several_lines


def _card_of_load_cases(
    found: DynamicVerification, checks: CheckReport
) -> Iterator[blocks.CardBlock]:
    """Say what the checks come to, what is not proven, and what the hardest load case is like."""
    yield from verdict_blocks(checks)
    unproven: dict[str, list[str]] = {}
    for part in found.parts:
        if part.verdict != "converged":
            first, *_ = proof_sentences(part)
            unproven.setdefault(first, []).append(part.name)
    for said, names in unproven.items():
        name = '", "'.join(names)
        is_all = len(names) == len(found.parts)
        whole = said if is_all else Message("checks.in_load_case", name=name, said=said)
        yield blocks.Verdict(whole, passes=False)
    if checks.results:
        yield tightest_table(checks)
    hardest = found.governing
    yield quantities_table(hardest, Message("motion.title_of_load_case", name=hardest.name))
    if found.body:
        yield tabulate("motion_body", *over_runs(found.body), caption=Message("motion.the_buoy"))
    remarked = dict.fromkeys(each for part in found.parts for each in part.remarks)
    yield blocks.Brief((*checks.warnings, *remarked), blocks.TO_BE_KNOWN, 3)


# ------------------------------------------------------------------ for people


def _of_load_cases(found: DynamicVerification) -> Iterator[blocks.Block]:
    """Say of every load case what the motion does to the line."""
    for part in found.parts:
        title = Message("motion.title")
        if found.case.load_cases:
            title = Message("motion.title_of_load_case", name=part.name)
        yield quantities_table(part, title)
        if part is found.parts[0] and found.body:
            caption = Message("motion.the_buoy")
            yield tabulate("motion_body", *over_runs(found.body), caption=caption, only="people")
        yield from _said(part, part, part.remarks)
        yield from _beyond_MBL([part] if part.beyond_MBL else [])


def _said(
    part: DynamicPart, proven: DynamicPart, remarked: Iterable[str]
) -> Iterator[blocks.Block]:
    """Say what the motion does to a line, how far that is proven, and what was remarked on."""
    history = part.runs[-1].history
    yield blocks.Text(
        Message(
            "motion.runs",
            count=len(part.runs),
            time=float(history.time[-1]),
            step=history.step,
            bars=part.elements,
            since=history.since,
        )
    )
    yield blocks.Text(Message("motion.drag_area"))
    for said in motion_sentences(part):
        yield blocks.Text(_of_line(part, said))
    for said in proof_sentences(proven):
        yield blocks.Verdict(_of_line(proven, said), proven.verdict == "converged")
    yield from remarks(remarked)


def _of_line(part: DynamicPart, said: str) -> str:
    if part.line is None:
        several = len(part.drive.case.load_cases) > 1 or part.name != "load"
        return Message("checks.in_load_case", name=part.name, said=said) if several else said
    return Message("motion.said_of_line", number=part.shown, said=said)


def quantities_table(
    part: DynamicPart, caption: str, at_rest: Sequence[float] = ()
) -> blocks.Table:
    """Tabulate what each quantity came to; in a note beside what it is at rest."""
    of = Rows(part.quantities)
    *columns, largest = over_runs(part.quantities, at_rest, in_note=bool(at_rest))
    probable = Message("columns.most_prob_in", time=lasting(part.duration_of_interest))
    return tabulate(
        "motion",
        *columns,
        largest,
        of.texts(probable, "most_probable_maximum", units=largest.units),
        of.measured(PERCENT, lambda each: part.change_of(each.quantity), "change"),
        caption=caption,
        only="people",
    )


def over_runs(
    found: Sequence[OverRuns], at_rest: Sequence[float] = (), *, in_note: bool = False
) -> Iterator[blocks.Column]:
    """List mean, deviation and ends of quantities, a row each; in a note with units beside them."""
    of, own = Rows(found), [DYNAMIC_QUANTITY_OF[each.quantity] for each in found]
    units = tuple(own if in_note else map(blocks.bare, own))
    yield texts("quantity", map(quantity_in_note if in_note else label, own))
    if at_rest:
        yield texts("note_motion.rest", at_rest, units=units)
    yield of.texts("mean", units=units)
    yield of.texts("standard_deviation", "std", units=units)
    yield of.texts("min", "minimum", units=units)
    yield of.texts("max", "maximum", units=units)


def _of_lines(found: DynamicVerification) -> Iterator[blocks.Block]:
    """Say what all lines carry, where their body goes, if they have one, and how it was proven."""
    if found.body:
        yield lines_of_body(found.parts)
        caption = Message("motion.the_body")
        yield tabulate("motion_body", *over_runs(found.body), caption=caption, only="people")
    else:
        yield from lines_of_points(found)
    remarked = dict.fromkeys(each for part in found.parts for each in part.remarks)
    yield from _said(found.governing, found.least_proven, remarked)
    yield from _beyond_MBL(found.beyond_MBL)


def _beyond_MBL(parts: Sequence[DynamicPart]) -> Iterator[blocks.Block]:
    """Say, whatever is checked, that the tension exceeds the MBL: where by most, and of which."""
    if not parts or (found := parts[0].beyond_MBL) is None:
        return
    part = parts[0]
    reported: str = Message(
        "motion.beyond_MBL",
        tension=Measure("tension", found.tension),
        MBL=Measure("tension", found.MBL),
        segment=found.segment,
    )
    if len(parts) > 1:
        numbers = ", ".join(each.shown for each in sorted(parts, key=lambda each: each.line or 0))
        reported = Several((reported, Message("motion.beyond_MBL_lines", numbers=numbers)), " ")
    if part.drive.case.load_cases:
        reported = Message("motion.why_of", where=part.where, why=reported)
    yield blocks.Verdict(_of_line(part, reported), False)


def lines_of_body(parts: Sequence[DynamicPart], at_rest: Sequence[float] = ()) -> blocks.Table:
    """Tabulate what every line of a body, or a line in every load case, came to at both ends.

    In a note beside the tension at its fairlead at rest, N.
    """
    of, fairlead = Rows(parts), Rows(part.of("fairlead_tension") for part in parts)
    anchor = Rows(part.of("anchor_tension") for part in parts)
    probable = Message("columns.most_prob_in", time=lasting(parts[0].duration_of_interest))
    return tabulate(
        "motion_lines",
        of.texts("load_case", "name") if parts[0].line is None else of.texts("line"),
        *([measured(FORCE, at_rest, "note_motion.rest")] if at_rest else []),
        fairlead.measured(FORCE, "mean", "mean"),
        fairlead.measured(FORCE, "std", "standard_deviation"),
        fairlead.measured(FORCE, "minimum", "min", priority=3),
        fairlead.measured(FORCE, "maximum", "max"),
        *blocks.if_known(fairlead.measured(FORCE, "most_probable_maximum", probable, priority=3)),
        *_by_damping(
            parts, "fairlead_tension", "motion.least_by_damping", "motion.most_by_damping"
        ),
        anchor.measured(FORCE, "maximum", "motion.max_at_anchor"),
        *_by_damping(
            parts,
            "anchor_tension",
            "motion.least_at_anchor_by_damping",
            "motion.most_at_anchor_by_damping",
        ),
        of.measured(FORCE, "quasi_static_max", "quasi_static", priority=1),
        of.measured(RATIO, "dynamic_amplification", "amplification"),
        of.measured(_SLACK, "slack_time", "slack"),
        of.measured(PERCENT, lambda part: part.change_of("fairlead_tension"), "change"),
        of.texts("verdict", lambda part: term(part.verdict)),
        caption=Message("motion.lines_of_body"),
        only="people",
    )


def lines_of_points(found: DynamicVerification) -> Iterator[blocks.Table]:
    """Tabulate what lines between points came to, and where joints went."""
    yield _between_points(found.parts)
    if found.joints:
        yield _joints(found.joints)


def _between_points(parts: Sequence[DynamicPart]) -> blocks.Table:
    """Tabulate what every line between points came to at its ends, and least of all."""
    of, there = Rows(parts), Rows(part.of("anchor_tension") for part in parts)
    here = Rows(part.of("fairlead_tension") for part in parts)
    between = Rows(of.read("between"))
    return tabulate(
        "motion_points",
        of.texts("line", "shown"),
        between.texts("from_point", "start"),
        between.texts("to_point", "end"),
        there.measured(FORCE, "maximum", "motion.max_there"),
        here.measured(FORCE, "mean", "motion.mean_here"),
        here.measured(FORCE, "minimum", "motion.min_here"),
        here.measured(FORCE, "maximum", "motion.max_here"),
        of.measured(_SLACK, "slack_time", "slack"),
        of.measured(PERCENT, lambda part: part.change_of("largest_tension"), "change"),
        caption=Message("motion.lines_of_points"),
        only="people",
    )


def _joints(found: Sequence[JointInMotion]) -> blocks.Table:
    """Tabulate where joints went."""
    of = Rows(found)
    return tabulate(
        "motion_joints",
        of.texts("point", "name"),
        of.measured("height", lambda each: each.least[2], "motion.lowest", symbol=""),
        of.measured("height", lambda each: each.largest[2], "motion.highest", symbol=""),
        of.measured("offset", "way", "motion.farthest", symbol=""),
        caption=Message("motion.joints"),
        only="people",
    )


def _by_damping(
    parts: Sequence[DynamicPart], quantity: str, *headings: str
) -> Iterator[blocks.Column]:
    """List least and largest maximum by damping of each line that snaps; none where none does."""
    of = Rows(part.damping_range(quantity) or (None, None) for part in parts)
    for k, heading in enumerate(headings):
        column = of.measured(FORCE, itemgetter(k), heading, priority=2)
        yield from blocks.if_known(column)


# ------------------------------------------------------------------ files, in SI


def _files(found: DynamicVerification, *, with_series: bool) -> Iterator[blocks.Section]:
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
        yield section(f"captions.{key}", tabulate(f"dynamic_{key}", *columns, only="files"))


def _of(of: Rows) -> blocks.Column:
    """Say what each row is of: a load case, or a line of a body."""
    return of.texts("load_case", "name") if of.rows[0].line is None else of.texts("line", "shown")


def _in_si(key: str, symbol: str | None = None) -> Quantity:
    return blocks.in_si(blocks.named(key, symbol), 2 if key == "tension" else 3)


_NEWTON = _in_si("tension", "")
_STILL = "largest_quasi_static_fairlead_tension"


def _statistics(parts: Sequence[DynamicPart]) -> Iterator[blocks.Column]:
    parts_of, of = Rows(parts).within("quantities")
    yield _of(parts_of)
    quantities = of.read("quantity")
    names = (term(DYNAMIC_QUANTITY_OF[each].name) for each in quantities)
    yield texts("quantity", map(blocks.keyed, quantities, names))
    yield from of.own("unit")
    yield of.of_row("mean")
    yield of.of_row("standard_deviation", "std")
    yield of.of_row("minimum")
    yield of.of_row("maximum")
    changes = (part.change_of(each.quantity) for part in parts for each in part.quantities)
    yield measured(_CHANGE, changes, "change_of_the_maximum")
    # what the extremes are, and what they rest on
    yield of.measured(_TIME, "tail.extreme.duration", "duration_of_interest")
    yield of.of_row("most_probable_maximum", "tail.extreme.most_probable")
    yield of.of_row("interval_from", "tail.extreme.low")
    yield of.of_row("interval_to", "tail.extreme.high")
    yield of.measured(RATIO, "tail.extreme.confidence", "confidence_of_the_interval")
    yield of.of_row("expected_maximum", "tail.extreme.expected")
    yield of.of_row("threshold_of_the_tail", "tail.threshold")
    yield Rows(of.read("tail.clusters")).texts("peaks_above_the_threshold", len)
    yield of.of_row("weibull_scale", "tail.scale")
    yield of.measured(RATIO, "tail.shape", "weibull_shape")
    yield of.of_row("gumbel_most_probable_maximum", "gumbel.extreme.most_probable")
    yield of.of_row("gumbel_interval_from", "gumbel.extreme.low")
    yield of.of_row("gumbel_interval_to", "gumbel.extreme.high")


def _summary(parts: Sequence[DynamicPart]) -> Iterator[blocks.Column]:
    of = Rows(parts)
    yield _of(of)
    yield of.texts("runs", lambda part: len(part.runs))
    yield of.texts("bars", "elements")
    yield of.texts("complete", lambda part: yes_or_no(part.is_complete))
    yield of.measured(_NEWTON, "max_tension", "largest_tension_anywhere")
    yield of.measured(_NEWTON, "quasi_static_max", _STILL)
    yield of.measured(RATIO, "dynamic_amplification", "dynamic_amplification")
    yield of.measured(_TIME, "slack_time", "slack_in_all")
    yield of.measured(_TIME, "longest_slack", "longest_slack")
    yield of.texts("verdict", lambda part: term(part.verdict))
    yield of.texts("proof", lambda part: Message(_PROOF[part.convergence_check]))
    changes = (part.change_of("largest_tension") for part in parts)
    yield measured(_CHANGE, changes, "change_of_the_largest_tension")
    for end in ("fairlead", "anchor"):
        ranges = [part.damping_range(f"{end}_tension") or (None, None) for part in parts]
        for k, which in enumerate(("least", "most")):
            key = f"motion.{which}_{end}_by_damping"
            yield measured(_NEWTON, [each[k] for each in ranges], key)
    for state in ("pulled", "none", "laid"):
        forces = (part.anchor_at_rest.get(state) for part in parts)
        yield measured(_NEWTON, forces, f"anchor_at_rest_{state}")
    yield of.measured(_PART, "numerical_part", "numerical_part_of_the_work")
    yield of.texts("remarks", lambda part: Several(part.remarks))


def _runs_in_files(parts: Sequence[DynamicPart]) -> Iterator[blocks.Column]:
    parts_of, runs = Rows(parts).within("runs")
    largest = Rows(run.statistics("fairlead_tension") for run in runs.rows)
    of = Rows(runs.read("history"))
    yield _of(parts_of)
    yield runs.texts("run", lambda run: run.number + 1)
    yield of.measured(_TIME, lambda each: each.time[-1], "reached")
    yield of.measured(_TIME, "since", "statistics_since")
    yield of.measured(_TIME, "step", "time_step")
    yield of.measured(_TIME, "shortest_step", "shortest_step")
    yield of.texts("steps")
    yield of.texts("newton_iterations", "iterations")
    yield of.texts("halvings")
    yield largest.measured(_NEWTON, "maximum", "largest_fairlead_tension")
    yield largest.measured(_TIME, "time_of_maximum", "at")
    yield runs.measured(_NEWTON, "quasi_static_max", _STILL)
    yield of.measured(_TIME, lambda each: each.line_slack_time(), "slack_in_all")
    yield of.measured(_TIME, lambda each: each.line_longest_slack(), "longest_slack")
    for name, energy in ENERGIES.items():
        yield of.measured(_ENERGY, f"balance.{energy}", term(name))
    yield of.measured(_PART, "balance.numerical_part", "numerical_part_of_the_work")


def _envelope(parts: Sequence[DynamicPart]) -> Iterator[blocks.Column]:
    of = Rows(part.envelope for part in parts)
    yield _of(Rows(parts).within("envelope.arc")[0])
    yield _joined(_in_si("s"), of.read("arc"))
    yield _joined(_NEWTON, of.read("largest"), "largest_tension")
    yield _joined(_NEWTON, of.read("smallest"), "smallest_tension")
    yield _joined(_TIME, of.read("slack"), "slack_in_all")
    yield _joined(_TIME, of.read("longest_slack"), "longest_slack")


def _joined(
    quantity: Quantity, arrays: Iterable[npt.NDArray[np.float64]], name: str = ""
) -> blocks.Column:
    """Make a column of arrays, one below the other."""
    return measured(quantity, (value for each in arrays for value in each.tolist()), name)


def _series(parts: Sequence[DynamicPart]) -> Iterator[blocks.Column]:
    runs = [run for part in parts for run in part.runs]
    of = [run.history for run in runs]
    yield _of(Rows(part for part in parts for run in part.runs for _ in run.history.time))
    yield from _times(runs)
    tension, at_anchor = _in_si("tension"), _in_si("tension", "TA")
    lying, offset = _in_si("grounded_length"), _in_si("offset")
    yield _joined(tension, (each.fairlead_tension[:, 0] for each in of), "fairlead_tension")
    yield _joined(_NEWTON, (run.quasi_static for run in runs), "quasi_static_fairlead_tension")
    yield _joined(at_anchor, (each.anchor_tension[:, 0] for each in of), "anchor_tension")
    yield _joined(lying, (each.grounded_length[:, 0] for each in of))
    for axis, name in enumerate("xyz"):
        yield _joined(offset, (each.fairlead[:, 0, axis] for each in of), f"fairlead_{name}")
    yield _joined(offset, (each.offset[:, 0] for each in of), "fairlead_offset")


def _times(runs: Sequence[DynamicRun]) -> Iterator[blocks.Column]:
    """Yield number of the run and time of each step."""
    yield texts("run", [run.number + 1 for run in runs for _ in run.history.time])
    yield _joined(_TIME, (run.history.time for run in runs), "time")


def _track(part: DynamicPart) -> Iterator[blocks.Column]:
    """Tabulate where the origin of a moored body was."""
    found = [(run, run.track) for run in part.runs if run.track is not None]
    yield from _times([run for run, _ in found])
    for axis, name in enumerate("xyz"):
        yield _joined(_in_si("offset"), (track[:, axis] for _, track in found), f"body_{name}")


_ON_CARD = 3
"""Lines of the mooring that the card has, the most loaded ones."""


def ship_answer(found: ShipVerification) -> blocks.Answer:
    """Lay out a ship in motion: where it goes, what its lines carry, and on what that rests."""
    remarks, dynamics = tuple(found.remarks), found.case.dynamics
    assert dynamics is not None
    rule = Message(
        "floater.rule",
        count=len(found.runs),
        time=lasting(dynamics.duration),
        storm=lasting(dynamics.duration_of_interest),
    )
    whole = answered(
        "ship",
        found.case.title or Message("captions.moored_body"),
        section(
            "captions.motion",
            _mean_weather(found),
            _body(found),
            _lines(found),
            *_lines_out(found),
            blocks.Text(rule, is_small=True),
        ),
        section("captions.checks_in_motion", *checks_in_motion(found.checks)),
        section("captions.remarks", blocks.Points(remarks)),
    )
    return replace(whole, card=tuple(_card(found)))


def _card(found: ShipVerification) -> Iterator[blocks.CardBlock]:
    yield from verdict_blocks(found.checks)
    yield _mean_weather(found)
    yield _body(found)
    yield _lines(found, most=_ON_CARD)
    yield from _hardest_out(found)
    yield blocks.Brief(tuple(found.remarks), blocks.TO_BE_KNOWN, 4)


def _mean_weather(found: ShipVerification) -> blocks.Text:
    """Say what the mean weather is and where the ship lies in it."""
    x, y = (blocks.about("horizontal_force", each) for each in found.rest.force)
    yaw = blocks.about("angle", found.heading)
    return blocks.Text(Message("floater.mean_weather", x=x, y=y, yaw=yaw))


def _body(found: ShipVerification) -> blocks.Table:
    """Tabulate the parts of offset and yaw."""
    units = (named("offset", ""), named("angle", ""))
    of = Rows((found.offset, found.yaw))
    names = (Message("floater.offset_row"), Message("floater.yaw_row"))
    columns = [texts("quantity", names)]
    columns += [of.texts(key, what, units=units) for key, what in _COLUMNS.items()]
    return tabulate("ship_body", *columns, caption=Message("floater.the_ship"))


def _lines(found: ShipVerification, most: int | None = None) -> blocks.Table:
    """Tabulate the parts of every line's tension at its fairlead, and the combined largest."""
    combined = [each.fairlead.combined for each in found.lines]
    shown = None
    if most is not None and len(combined) > most:
        order = sorted(range(len(combined)), key=lambda k: -round(combined[k], 3))
        shown = tuple(sorted(order[:most]))
    return tabulate(
        "ship_lines",
        Rows(found.lines).texts("line", "number"),
        *_tensions(found.lines),
        caption=Message("floater.line_tensions"),
        shown=shown,
        marked=found.most_loaded,
    )


def _lines_out(found: ShipVerification) -> Iterator[blocks.Table]:
    """Tabulate what the most loaded line carries without each that was lost; none: nothing."""
    lost = [each for each in found.lost if each.lines]
    if found.hardest_loss is None:
        return
    of, lines = Rows(lost), [each.hardest for each in lost]
    yield tabulate(
        "ship_lines_out",
        of.texts("line_out", "missing"),
        Rows(lines).texts("line", "number"),
        *_tensions(lines),
        of.measured("offset", "offset.combined", symbol=""),
        caption=Message("floater.line_out_tensions"),
        marked=lost.index(found.hardest_loss),
    )


def _hardest_out(found: ShipVerification) -> Iterator[blocks.Text]:
    """Say in a line what the loss of the worst line comes to."""
    lost = found.hardest_loss
    if lost is not None and lost.offset is not None:
        said = Message(
            "floater.hardest_out",
            missing=lost.missing,
            number=lost.hardest.number,
            tension=blocks.about("tension", lost.hardest.fairlead.combined),
            offset=blocks.about("offset", lost.offset.combined),
        )
        yield blocks.Text(said)


def _tensions(lines: Sequence[LineOfShip]) -> Iterator[blocks.Column]:
    """List the parts of tensions at fairleads, combined at both ends, and as part of the MBL."""
    of, combined = Rows(lines), [each.fairlead.combined for each in lines]
    tension = blocks.rounded("tension", max(combined))
    for key, what in _COLUMNS.items():
        yield of.measured(tension, f"fairlead.{what}", key)
    yield of.measured(tension, "anchor.combined", "floater.at_anchor", priority=1)
    used = [None if each.MBL is None else each.fairlead.combined / each.MBL for each in lines]
    yield blocks.measured(QUANTITIES["utilisation"], used, "floater.of_MBL")


_COLUMNS = {
    "mean": "mean",
    "floater.slow_deviation": "slow_deviation",
    "floater.slow_largest": "slow_largest",
    "floater.fast_deviation": "fast_deviation",
    "floater.fast_largest": "fast_largest",
    "floater.combined": "combined",
}
