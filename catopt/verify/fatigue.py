"""Fatigue of the lines of a case: a run in time for each of its sea states, and their damage."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, partial
from pathlib import Path
from typing import Annotated, Any

import numpy as np

from catopt.checks.fatigue import FatigueStrength, design_factor, fatigue_strengths, need_rainflow
from catopt.checks.kinds import CheckSource
from catopt.constants import YEAR
from catopt.errors import InputError, refused
from catopt.largest import largest
from catopt.model import Case, FatigueSeaState, Segment
from catopt.model.dynamics import share_misfits
from catopt.model.kinds import Force, NotNegative, Place, Positive, Share
from catopt.model.network import Network
from catopt.old_names import renamed
from catopt.progress import Progress
from catopt.records import Counted, From, FromZero, Record
from catopt.tables import Column, read_numbers, read_sheet
from catopt.units import Dimension
from catopt.verify.case import load_states
from catopt.verify.convergence_check import LIMIT, ConvergenceCheck
from catopt.verify.dynamic import LONG, verify_dynamic
from catopt.verify.dynamic_lines import lines_at_rest
from catopt.verify.dynamic_result import DynamicPart, DynamicVerification, Verdict, worst_verdict
from catopt.verify.dynamic_setup import check_for_motion, read_drive
from catopt.verify.motion_file import OfTotal
from catopt.verify.side_by_side import effort_of, share_of
from catopt.words import Message, given_keys

_WHOLE = 1e-6
"""By which the shares may miss the whole year before that is said."""


@dataclass(frozen=True)
class StateDamage(Record):
    """What a sea state does to a segment in a year, with its share of it."""

    DOCUMENT = (
        "damage=damage_per_year mean=mean_tension_N cycles=cycles_per_year "
        "at_half_step=damage_per_year_at_half_step by_spectrum=damage_per_year_by_spectrum"
    )

    damage: float
    """With its share of the year."""
    mean: Force
    """Tension at that bar."""
    cycles: float
    """With its share of the year."""
    at_half_step: float | None
    """By the runs at half the step; None where there are none."""
    by_spectrum: float | None = None
    """By dual narrow band; None without waves."""


@dataclass(frozen=True)
class SegmentFatigue(Record):
    """Fatigue of a segment, at its bar of the largest damage; the segment is as new."""

    DOCUMENT = (
        "line number=segment segment.component strength.curve.source.code=curve "
        "strength.curve.kind strength.curve.factor strength.curve.slope strength.curve.per_mean "
        "strength.curve.source.text=source strength.diameter strength.area "
        "strength.breaking_strength=strength_N arc along damage=damage_per_year years=life_years "
        "wanted_years factor=design_factor factor_source.text=design_factor_source utilisation "
        "change=change_of_ranges worst+1=worst_sea_state states=sea_states"
    )

    line: Counted | None
    """Of a body with several lines; None otherwise."""
    number: Counted
    """From the anchor."""
    segment: Segment
    strength: FatigueStrength
    """Its curve and reference."""
    states: Annotated[tuple[StateDamage, ...], From(1)]
    """In the order of sea_states."""
    arc: Place
    """Arc length from the anchor of the bar of the largest damage."""
    along: Share
    """The same as a part of the segment, from its lower end."""
    factor: float
    """On the damage."""
    factor_source: CheckSource
    life: float
    """That is required, s."""

    @property
    def wanted_years(self) -> float:
        """Years of service."""
        return self.life / YEAR

    @property
    def damage(self) -> float:
        """Miner's sum in a year."""
        return sum(each.damage for each in self.states)

    @property
    def change(self) -> NotNegative | None:
        """By how much ranges would have to change for the damage at half the step, or None."""
        finer = [each.at_half_step for each in self.states if each.at_half_step is not None]
        if len(finer) < len(self.states) or self.damage == 0.0:
            return None
        ranges: float = (sum(finer) / self.damage) ** (1.0 / self.strength.curve.slope)
        return abs(ranges - 1.0)

    @property
    def years(self) -> float | None:
        """Years until the damage is 1, without the factor; None without damage."""
        return 1.0 / self.damage if self.damage > 0.0 else None

    @property
    def utilisation(self) -> float:
        """Damage in the service life times the design factor."""
        return self.damage * self.life / YEAR * self.factor

    @property
    def worst(self) -> FromZero:
        """Which does most damage."""
        return largest(range(len(self.states)), lambda k: self.states[k].damage)


@dataclass(frozen=True)
class StateRun(Record):
    """A sea state and its runs."""

    DOCUMENT = (
        "state.height state.period state.share=share state.direction run.verdict=verdict runs"
    )

    state: FatigueSeaState
    run: DynamicVerification

    @property
    def runs(self) -> Counted:
        """Runs, each of its own seed."""
        return len(self.run.parts[0].runs)


@dataclass(frozen=True)
class FatigueReport(Record):
    """Fatigue of the lines of a case over the sea states of a year.

    Lines, segments and sea states count from 1; there is one run of a case a sea state.
    """

    SCHEMA = "catopt.fatigue/1"
    DOCUMENT = (
        "case.title verdict passes counting share=share_of_year by_state=sea_states segments "
        "remarks"
    )

    case: Case | Network
    states: tuple[FatigueSeaState, ...]
    runs: tuple[DynamicVerification, ...]

    @property
    def counting(self) -> str:
        """How cycles are counted."""
        return "rainflow, ASTM E1049, what is left over as half cycles"

    @property
    def by_state(self) -> Annotated[tuple[StateRun, ...], From(1)]:
        """In the order of the case."""
        return tuple(map(StateRun, self.states, self.runs))

    @cached_property
    def segments(self) -> Annotated[tuple[SegmentFatigue, ...], From(1)]:
        """Of every line, from the anchor to the fairlead."""
        return tuple(
            self._segment(line, index, strength)
            for line, part in enumerate(self.runs[0].parts)
            for index, strength in enumerate(fatigue_strengths(self.case, part.own_line))
        )

    def _segment(self, line: int, index: int, strength: FatigueStrength) -> SegmentFatigue:
        segments = self.runs[0].parts[line].own_line.segments
        first = sum(each.length for each in segments[:index])
        parts = [run.parts[line] for run in self.runs]
        arcs = parts[0].envelope.arc
        bars = np.flatnonzero((arcs > first) & (arcs < first + segments[index].length)).tolist()
        by_bar = {bar: self._states(parts, bar, strength) for bar in bars}
        bar = largest(bars, lambda bar: sum(each.damage for each in by_bar[bar]))
        factor, source = design_factor(self.case, strength.curve)
        assert self.case.service is not None
        return SegmentFatigue(
            line=parts[0].line,
            number=index + 1,
            segment=segments[index],
            strength=strength,
            states=by_bar[bar],
            arc=float(arcs[bar]),
            along=float(arcs[bar] - first) / segments[index].length,
            factor=factor,
            factor_source=source,
            life=self.case.service.life,
        )

    def _states(
        self, parts: Sequence[DynamicPart], bar: int, strength: FatigueStrength
    ) -> tuple[StateDamage, ...]:
        found = []
        for state, part in zip(self.states, parts, strict=True):
            cycles = [run.cycles[bar] for run in part.runs]
            again = [
                a.cycles[bar] for r in part.runs for a in r.again if a.way == "step" and a.cycles
            ]
            finer = state.share * strength.damage(again) if len(again) == len(cycles) else None
            quick = strength.damage_by_spectrum(cycles)
            time = sum(each.time for each in cycles)
            count = sum(float(each.counts.sum()) for each in cycles)
            found.append(
                StateDamage(
                    state.share * strength.damage(cycles),
                    sum(each.mean * each.time for each in cycles) / time,
                    state.share * count * YEAR / time,
                    finer,
                    None if quick is None else state.share * quick,
                )
            )
        return tuple(found)

    @property
    def governing(self) -> SegmentFatigue:
        """The segment that is used furthest."""
        return largest(self.segments, lambda each: each.utilisation)

    @property
    def passes(self) -> bool:
        """Whether the utilisation of every segment is at most 1."""
        return all(each.utilisation <= 1.0 for each in self.segments)

    @cached_property
    def verdict(self) -> Verdict:
        """What the runs say of their maxima, and of the ranges behind a damage at half the step."""
        if any(each.change is not None and each.change > LIMIT for each in self.segments):
            return "not converged"
        return worst_verdict(run.verdict for run in self.runs)

    @property
    def share(self) -> Positive:
        """Part of the year that the sea states make up; the rest is without damage."""
        return sum(state.share for state in self.states)

    @property
    def remarks(self) -> tuple[str, ...]:
        """What to know before the figures are used."""
        said: list[str] = []
        if self.share < 1.0 - _WHOLE:
            said.append(Message("fatigue.rest_of_year", part=1.0 - self.share))
        if any(each.factor_source.confidence == "R" for each in self.segments):
            said.append(Message("fatigue.recalled"))
        motion = self.case.motion
        if motion is not None and not motion.rao_file:
            said.append(Message("fatigue.same_motion"))
        said.append(Message("fatigue.as_new"))
        said += [each for run in self.runs for part in run.parts for each in part.remarks]
        return tuple(dict.fromkeys(said))


@renamed(proof="convergence_check")
def verify_fatigue(
    case: Case | Network,
    *,
    load_case: str | None = None,
    convergence_check: ConvergenceCheck = "step",
    workers: int | None = None,
    progress: Progress | None = None,
    announce: Callable[[str], None] = lambda _: None,
) -> FatigueReport:
    """Run the lines of a case in each of its sea states, and find the damage of their segments.

    Cycles of the tension of every bar are counted by rainflow after the ramp; a segment's damage
    is that of its bar that is damaged most. Its curve and its reference are those at half the loss
    of diameter; the line that is run is new.

    `case`: with `fatigue`, `dynamics`, `waves` and `service`; `load_case`: under which the line
    lies, needed where there are several; `announce`: told beforehand, in words, what all sea states
    take, where that is minutes. The others, and what is raised, are as for `verify_dynamic`.
    """
    if case.fatigue is None:
        allowed = Message("refused_motion.fatigue_missing_sea_states_are")
        raise refused("fatigue", "", allowed)
    need_rainflow()
    check_for_motion(case)
    if case.dynamics is not None and case.dynamics.broken_line is not None:
        allowed = Message("refused_motion.leave_out_year_run_with")
        raise refused("dynamics.broken_line", "", allowed)
    for key, line in dict.fromkeys(case.keyed_lines):
        for strength in fatigue_strengths(case, line, key):
            design_factor(case, strength.curve)
    loads = load_states(case, load_case)
    if len(loads) > 1:
        names = ", ".join(name for name, _ in loads)
        allowed = Message("refused_motion.one_wanted_year_run_under", names=names)
        raise refused("--load-case", "", allowed, "options")
    states = sea_states(case)
    seas = [_in_sea(case, state) for state in states]
    seconds = 0.0
    for sea in seas:
        ((_, state),) = load_states(sea, load_case)
        drive = read_drive(state)
        effort = effort_of(lines_at_rest(drive), convergence_check)
        effort.check(drive.dynamics.duration)
        seconds += effort.seconds
    if seconds > LONG:
        announce(Message("fatigue.takes", count=len(states), minutes=seconds / 60.0))
    run = partial(
        verify_dynamic,
        load_case=load_case,
        convergence_check=convergence_check,
        workers=workers,
        counts_cycles=True,
        compares_at_rest=False,
    )
    runs = []
    for done, sea in enumerate(seas):
        runs.append(run(sea, progress=share_of(progress, done, len(seas))))
        if not runs[-1].is_complete:
            raise KeyboardInterrupt
    return FatigueReport(case, states, tuple(runs))


def _in_sea(case: Case | Network, state: FatigueSeaState) -> Case | Network:
    """Put a sea state in the place of the waves; all are run with as many bars."""
    assert case.waves is not None
    assert case.dynamics is not None
    waves = replace(case.waves, height=state.height, period=state.period)
    if state.direction is not None:
        waves = replace(waves, direction=state.direction)
    dynamics = replace(case.dynamics, elements=case.dynamics.bars)
    return replace(case, waves=waves, dynamics=dynamics)


_COLUMNS = {
    "height": Column(Dimension.LENGTH),
    "period": Column(Dimension.TIME),
    "time": Column(Dimension.TIME),
    "direction": Column(Dimension.ANGLE),
    "share": Column(bare=1.0),
    "occurrences": OfTotal(),
}
"""Columns of a file of sea states."""
_LASTING = ("share", "time", "occurrences")
"""Columns of which one says how long a sea state lasts."""


def sea_states(case: Case | Network) -> tuple[FatigueSeaState, ...]:
    """Take the sea states of a case, or read them from its file; InputError with all its faults."""
    fatigue = case.fatigue
    assert fatigue is not None
    path = fatigue.sea_states_file
    if not path:
        return fatigue.sea_states
    sheet = read_sheet(Path(path), path, keeps_broken=True)
    columns = read_numbers(sheet, _COLUMNS, needed=("height", "period"), some_of=_LASTING)
    given = [key for key in _LASTING if key in columns]
    if len(given) > 1:
        allowed = Message("refused_motion.one_them_wanted")
        raise refused("headings", given_keys(given), allowed, path)
    whole = YEAR if given == ["time"] else 1.0
    shares = [each / whole for each in columns[given[0]]]
    states, problems = [], share_misfits(shares)
    for k, (row, share) in enumerate(zip(sheet.rows, shares, strict=True)):
        sea = columns.keys() & {"height", "period", "direction"}
        at: dict[str, Any] = {key: columns[key][k] for key in sea}
        try:
            states.append(FatigueSeaState(share=share, **at))
        except InputError as error:
            problems += [replace(p, key=f"line {row.line}, {p.key}") for p in error.problems]
    if problems:
        raise InputError(problems, path)
    return tuple(states)
