"""Run a case's lines in time: what a quasi-static answer leaves out."""

from __future__ import annotations

import os
from collections import defaultdict
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import partial
from typing import NamedTuple

import numpy as np

from catopt.checks.fatigue import count_cycles
from catopt.errors import InputError, NoAnswerError, NotConvergedError, refused
from catopt.fem.history import STOPPED
from catopt.floater.alone import HullHistory
from catopt.interrupt import waiting_interrupt
from catopt.model import Case
from catopt.model.dynamics import InitialFriction
from catopt.model.network import Network
from catopt.old_names import renamed
from catopt.progress import Progress
from catopt.verify.case import load_states
from catopt.verify.convergence_check import (
    DAMPINGS,
    FINER,
    Again,
    ConvergenceCheck,
    Damped,
    Way,
    work_of_check,
)
from catopt.verify.dynamic_lines import (
    LinesAtRest,
    LinesOfPoints,
    OneLine,
    lines_at_rest,
    parted_words,
    quasi_static,
)
from catopt.verify.dynamic_result import DynamicPart, DynamicVerification
from catopt.verify.dynamic_run import DynamicRun
from catopt.verify.dynamic_setup import Excitation, check_for_motion, read_drive
from catopt.verify.motion_file import energy_beyond
from catopt.verify.side_by_side import Crew, effort_of, share_of, side_by_side
from catopt.verify.verdicts import with_verdicts
from catopt.waves import Sea
from catopt.words import Message, is_said

Known = Mapping[int, list[Again]]

_MILLI = 1000
"""Progress is told in thousandths of a second."""

_WORTH = 4e6
"""Bars times steps from which seeds are run side by side: some 15 to 30 s on one core."""

LONG = 60.0
"""Seconds from which what a load case, or a year, takes is announced."""


@renamed(proof="convergence_check")
def verify_dynamic(
    case: Case | Network,
    *,
    load_case: str | None = None,
    convergence_check: ConvergenceCheck = "step",
    workers: int | None = None,
    seeds: Sequence[int] | None = None,
    counts_cycles: bool = False,
    compares_at_rest: bool = True,
    progress: Progress | None = None,
    announce: Callable[[str], None] = lambda _: None,
) -> DynamicVerification:
    """Run the lines of a case in the time domain, in their waves, their current and their motion.

    They come to rest under their load first; then motion, force and waves grow smoothly. Each run
    of a random sea has a seed of its own, and is run again at half the step to show how far its
    maxima hang on that; where a line goes slack, with twice the bars, too, and with half and twice
    its damping. Where the bars change what decides too much, all is run anew with twice as many,
    unless cycles are counted.

    Parameters
    ----------
    case : Case or Network
        With `dynamics`, and `motion` or `waves`; with `system`, all lines of the body.
    load_case : str, optional
        Name of one load case; all of them when left out, or the load where there are none.
    convergence_check : {"step", "bars", "none"}
        "bars" runs every line again with twice the bars; "none" runs it once.
    workers : int, optional
        Processes that run the seeds of a load case side by side, at most; all cores when left out,
        where that is worth it. The digits do not hang on it.
    seeds : sequence of int, optional
        Numbers, from 0, of the runs that are made; all of them when left out.
    counts_cycles : bool
        Whether the cycles of every bar's tension are counted by rainflow.
    compares_at_rest : bool
        Whether the tension of a line that hangs at rest is found for every place of its end, and
        that at the anchor for every past of the line; without, both are left out of the answer.
    progress : callable, optional
        Told how far it is and how far it goes.
    announce : callable, optional
        Told beforehand, in words, what a load case takes that takes minutes.

    Returns
    -------
    DynamicVerification
        Series and statistics. After Ctrl-C what was computed until then.

    Raises
    ------
    InputError
        For what a line in motion lacks, or what is wrong in the files of its motion.
    NoEquilibriumError
        When there is no equilibrium to start from.
    NotConvergedError
        When a step does not close, or what is computed is the scheme's own ringing.

    Examples
    --------
    >>> import catopt
    >>> case = catopt.read_case("tests/answers/cases/at-sea.toml")
    >>> moved = catopt.verify_dynamic(case, convergence_check="none")
    >>> moved.verdict  # for nothing was run again at a finer step
    'not proven'
    """
    if workers is not None and workers < 1:
        allowed = Message("refused_command.n_1_or_more_processes")
        raise refused("workers", f"{workers}", allowed, "options")
    check_for_motion(case)
    states = load_states(case, load_case)
    drives = [
        replace(read_drive(state), counts_cycles=counts_cycles, compares_at_rest=compares_at_rest)
        for _, state in states
    ]
    parts: list[DynamicPart] = []
    is_whole = True
    with waiting_interrupt() as ask:
        for done, ((name, _), drive) in enumerate(zip(states, drives, strict=True)):
            tell = _telling(share_of(progress, done, len(states)), ask)

            def run(
                drive: Excitation, tell: Progress, known: Known | None = None, name: str = name
            ) -> list[DynamicPart]:
                found = _parts(
                    name, convergence_check, workers, seeds, announce, known or {}, drive, tell
                )
                return with_verdicts(case, found) if found else found

            found = run(drive, tell)
            if not counts_cycles and any(map(_wants_more_bars, found)):
                found = _with_twice_the_bars(found, drive, run, tell)
            found = _with_dampings(found, workers, share_of(tell, 7, 9, part=2))
            parts += found
            count = drive.dynamics.runs if seeds is None else len(seeds)
            is_whole = bool(found) and all(
                part.is_complete and len(part.runs) == count for part in found
            )
            if not is_whole:
                break
    if not parts:
        raise KeyboardInterrupt
    return DynamicVerification(case, tuple(parts), is_whole)


def _wants_more_bars(part: DynamicPart) -> bool:
    """Whether a part has not converged, and that for its bars more than for its step."""
    if not part.is_complete or part.verdict != "not converged":
        return False
    size: dict[str, float] = {"step": 0.0, "bars": 0.0}
    deciding = {each.quantity for each in part.added_changes if part.decides(each)}
    for change in part.changes:
        if change.quantity in deciding or not deciding:
            size[change.way] = max(size[change.way], change.size)
    return size["bars"] > size["step"]


def _with_twice_the_bars(
    found: list[DynamicPart],
    drive: Excitation,
    run: Callable[[Excitation, Progress, Known], list[DynamicPart]],
    progress: Progress,
) -> list[DynamicPart]:
    """Run a load case anew with twice the bars; keep what there is where that gives no answer.

    What was run with twice the bars at half the step is then the run again at half the step.
    """
    bars = 2 * drive.dynamics.bars
    case = replace(drive.case, dynamics=replace(drive.dynamics, elements=bars))
    of_seeds = zip(*(part.runs for part in found), strict=True)
    known = {
        runs[0].number: [replace(run.again[-1], way="step") for run in runs]
        for runs in of_seeds
        if runs[0].again and runs[0].again[-1].way == "bars"
    }
    try:
        finer = run(replace(drive, case=case), share_of(progress, 1, 3, part=2), known)
    except NotConvergedError:
        return found
    if not finer or not all(part.is_complete for part in finer):
        return found
    said = Message("motion.too_few_bars", few=drive.dynamics.bars, bars=bars)
    return [replace(part, remarks=(said, *part.remarks)) for part in finer]


def _with_dampings(
    found: list[DynamicPart], workers: int | None, progress: Progress
) -> list[DynamicPart]:
    """Run what was run with twice the bars with other dampings, too: last, for it judges nothing.

    Stopped, what there is: a part is whole without.
    """
    if not found or not all(part.is_complete for part in found):
        return found
    drive = found[0].drive
    proven = [run.number for run in found[0].runs if any(e.way == "bars" for e in run.again)]
    is_damped = drive.dynamics.critical_ratio > 0.0 or drive.dynamics.damping_time > 0.0
    tasks = [(number, factor) for number in proven for factor in DAMPINGS if is_damped]
    if not tasks:
        return found
    lines = lines_at_rest(drive)
    side = min(processes_for(effort_of(lines, "none").work * len(DAMPINGS), workers), len(tasks))
    damped = side_by_side(partial(_damped, lines, tasks), len(tasks), side, progress)
    # Beside each run those of the same seed; stopped, there are fewer than tasks.
    of_seed: dict[int, list[list[Damped]]] = defaultdict(list)
    for (number, _), lines_damped in zip(tasks, damped, strict=False):
        of_seed[number].append(lines_damped)
    return [
        replace(
            part,
            runs=tuple(
                replace(run, damped=tuple(each[k] for each in of_seed[run.number]))
                for run in part.runs
            ),
        )
        for k, part in enumerate(found)
    ]


class _Seed(NamedTuple):
    """What came of one seed: the run of each line, what is to be said, and whether it was whole."""

    runs: list[DynamicRun]
    remarks: list[str]
    is_whole: bool


def _parts(
    name: str,
    convergence_check: ConvergenceCheck,
    workers: int | None,
    numbers: Sequence[int] | None,
    announce: Callable[[str], None],
    known: Known,
    drive: Excitation,
    progress: Progress,
) -> list[DynamicPart]:
    """Run one load case, a part a line; none when it was stopped before anything was there.

    `numbers`: of the seeds; `known`: runs again that are there already, by the number of theirs.
    """
    numbers = range(drive.dynamics.runs) if numbers is None else numbers
    total, lines = len(numbers), lines_at_rest(drive)
    effort = effort_of(lines, convergence_check)
    effort.check(drive.dynamics.duration)
    if effort.seconds > LONG:
        announce(f"{name}: {effort.words}" if name else effort.words)
    most = processes_for(effort.work, workers)
    side = min(most, total)
    # A single seed leaves the processes to its runs again.
    task = partial(_seed, lines, convergence_check, known, most if total == 1 else 1, numbers)
    if side == 1:
        seeds = _in_turn(task, total, progress)
    else:
        # Stopped, keep those that are whole, or else what there is.
        there = [each for each in side_by_side(task, total, side, progress) if each is not None]
        seeds = [each for each in there if each.is_whole] or there[:1]
    if not seeds:
        return []
    remarks = list(dict.fromkeys(said for each in seeds for said in each.remarks))
    if not seeds[-1].runs[0].is_complete(convergence_check):
        remarks.append(Message("motion.stopped_in_run", run=len(seeds), runs=total))
    elif len(seeds) < total:
        remarks.append(Message("motion.stopped_after_runs", done=len(seeds), runs=total))
    at_rest: Mapping[InitialFriction, float] = {}
    if drive.compares_at_rest and isinstance(lines, OneLine):
        at_rest = lines.anchor_at_rest()
    return [
        DynamicPart(
            name,
            drive,
            of_line,
            leg.line,
            convergence_check,
            (*remarks, *lines.remarks(), *_remarks(drive, of_line)),
            k if drive.case.several_lines else None,
            at_rest,
            between=lines.between(k) if isinstance(lines, LinesOfPoints) else None,
        )
        for k, (leg, of_line) in enumerate(
            zip(lines.legs, zip(*(each.runs for each in seeds), strict=True), strict=True), start=1
        )
    ]


class Wanted(NamedTuple):
    """Seeds of a load case that are to be run once, by their numbers."""

    name: str
    drive: Excitation
    seeds: tuple[int, ...]


def run_once(
    wanted: Sequence[Wanted], crew: Crew, progress: Progress
) -> list[DynamicPart | NotConvergedError | NoAnswerError]:
    """Run seeds of load cases with one line side by side, without samples, check and remarks.

    What has no answer says why in its place. Raises KeyboardInterrupt where it was stopped, else
    what `verify_dynamic` raises.
    """
    jobs = [(each.drive, seed) for each in wanted for seed in each.seeds]
    found = crew.each(partial(_once, jobs), len(jobs), progress)
    if len(found) < len(jobs):
        raise KeyboardInterrupt
    parts: list[DynamicPart | NotConvergedError | NoAnswerError] = []
    for name, drive, seeds in wanted:
        runs, found = found[: len(seeds)], found[len(seeds) :]
        failed = [each for each in runs if not isinstance(each, DynamicRun)]
        made = tuple(each for each in runs if isinstance(each, DynamicRun))
        line = drive.one.line
        parts += failed[:1] or [DynamicPart(name, drive, made, line, "none")]
    return parts


def _once(
    jobs: Sequence[tuple[Excitation, int]], at: int, progress: Progress
) -> DynamicRun | NotConvergedError | NoAnswerError:
    drive, seed = jobs[at]
    try:
        ((run,), _) = _run(lines_at_rest(drive), seed, progress)
    except (NotConvergedError, NoAnswerError) as error:
        return error
    if not run.history.is_complete:
        raise KeyboardInterrupt
    return _without_samples(run)


def run_again(parts: Sequence[DynamicPart], crew: Crew, progress: Progress) -> list[DynamicPart]:
    """Run every run of parts with one line again side by side, as `verify_dynamic` proves them.

    A run that has no answer then says so. Raises KeyboardInterrupt where it was stopped.
    """
    jobs = [
        (k, run.number, way)
        for k, part in enumerate(parts)
        for run in part.runs
        for way in _ways_again("step", [run])
    ]
    drives = [part.drive for part in parts]
    found = crew.each(partial(_again_once, drives, jobs), len(jobs), progress)
    if len(found) < len(jobs):
        raise KeyboardInterrupt
    again: dict[tuple[int, int], list[Again]] = defaultdict(list)
    for (k, number, _), each in zip(jobs, found, strict=True):
        again[k, number].append(each)
    return [
        replace(
            part,
            convergence_check="step",
            runs=tuple(replace(run, again=tuple(again[k, run.number])) for run in part.runs),
        )
        for k, part in enumerate(parts)
    ]


def _again_once(
    drives: Sequence[Excitation],
    jobs: Sequence[tuple[int, int, Way]],
    at: int,
    progress: Progress,
) -> Again:
    k, number, way = jobs[at]
    (found,) = _again(lines_at_rest(drives[k]), number, [way], 0, progress)
    return found


def _ways_again(convergence_check: ConvergenceCheck, runs: Sequence[DynamicRun]) -> list[Way]:
    """List the ways in which the lines of a seed are run again."""
    if convergence_check == "none":
        return []
    is_slack = any(run.history.line_slack_time() > 0.0 for run in runs)
    return ["step", "bars"] if convergence_check == "bars" or is_slack else ["step"]


def work_of(case: Case | Network) -> float:
    """Bars times steps of all runs of a case with one load, each made once."""
    return effort_of(lines_at_rest(read_drive(case)), "none").work


def processes_for(work: float, workers: int | None) -> int:
    """Say how many processes at most; more than one save nothing where there is little to do."""
    worth = 1 if work < _WORTH else os.cpu_count() or 1
    return worth if workers is None else workers


def _in_turn(
    task: Callable[[int, Progress], _Seed | None], total: int, progress: Progress
) -> list[_Seed]:
    """Run the seeds one after the other, until one is stopped."""
    seeds: list[_Seed] = []
    for number in range(total):
        seed = task(number, share_of(progress, number, total))
        if seed is not None:
            seeds.append(seed)
        if seed is None or not seed.is_whole:
            break
    return seeds


def _seed(
    lines: LinesAtRest,
    convergence_check: ConvergenceCheck,
    known: Known,
    side: int,
    numbers: Sequence[int],
    at: int,
    progress: Progress,
) -> _Seed | None:
    """Run one of the seeds and prove it; stopped, what there is of it, or None."""
    number = numbers[at]
    total = 2 + work_of_check(convergence_check)  # the last part is its end
    try:
        runs, said = _run(lines, number, share_of(progress, 0, total))
    except KeyboardInterrupt:
        return None
    history = runs[0].history
    if not history.is_complete:  # stopped in its ramp, nothing of it counts
        return _Seed(runs, said, is_whole=False) if history.counts else None
    ways = _ways_again(convergence_check, runs)
    there = [known[number]] if number in known else []
    left = ways[len(there) :]
    task, rest = partial(_again, lines, number, left), share_of(progress, 1, total, total - 2)
    made = [*there, *(side_by_side(task, len(left), side, rest) if left else [])]
    runs = [replace(run, again=tuple(each[k] for each in made)) for k, run in enumerate(runs)]
    with suppress(KeyboardInterrupt):  # what there is of the check is kept
        progress(1, 1)
    return _Seed(runs, said, is_whole=len(made) == len(ways))


def _again(
    lines: LinesAtRest, number: int, ways: Sequence[Way], at: int, progress: Progress
) -> list[Again]:
    """Run once more in one of the ways, in the same sea."""
    way = ways[at]
    finer, more = FINER[way]
    elements = more * lines.drive.dynamics.bars
    sea = lines.drive.sea(number)
    step = lines.drive.stepping(sea, lines.driven_by(sea), finer).step
    try:
        runs, _ = _run(lines, number, progress, finer, elements)
    except NotConvergedError as error:
        return [Again(way, step, elements, {}, error.message)] * len(lines.legs)
    if not runs[0].history.is_complete:
        raise KeyboardInterrupt
    return [
        Again(way, step, elements, run.maxima, cycles=run.cycles, run=_without_samples(run))
        for run in runs
    ]


def _damped(
    lines: LinesAtRest, tasks: Sequence[tuple[int, float]], at: int, progress: Progress
) -> list[Damped]:
    """Run a seed once more with another damping of the lines."""
    (number, factor), dynamics = tasks[at], lines.drive.dynamics
    ratio, time = factor * dynamics.critical_ratio, factor * dynamics.damping_time
    changed = replace(dynamics, line_damping=ratio, damping_time=time)
    case = replace(lines.drive.case, dynamics=changed)
    drive = replace(lines.drive, case=case, counts_cycles=False)
    try:
        runs, _ = _run(replace(lines, drive=drive), number, progress, elements=dynamics.bars)
    except NotConvergedError:
        return [Damped(factor, {})] * len(lines.legs)
    if not runs[0].history.is_complete:
        raise KeyboardInterrupt
    return [Damped(factor, run.maxima) for run in runs]


def _without_samples(run: DynamicRun) -> DynamicRun:
    """Keep of a run again what it is judged by."""
    of, none = run.history, slice(0, 0)
    sampled = ("fairlead_force", "anchor_force", "bar_tension", "fairlead", "grounded_length")
    cut = {key: getattr(of, key)[none] for key in (*sampled, "nodes", "energy", "tension")}
    hull = run.hull
    if hull is not None:
        samples = ("time", "place", "velocity", "wet", "surface", "lines")
        of_all = np.column_stack([hull.place, hull.wet])[run.counted].mean(axis=0)
        rest = {key: getattr(hull, key)[none] for key in samples}
        hull = replace(hull, scene=None, mean=of_all, **rest)
    return DynamicRun(replace(of, **cut), run.quasi_static[none], run.number, hull=hull)


def _run(
    lines: LinesAtRest,
    number: int,
    progress: Progress,
    finer: int = 1,
    elements: int | None = None,
) -> tuple[list[DynamicRun], list[str]]:
    """Run all lines together; return what each did, and what is to be said of all."""
    drive = lines.drive
    sea = drive.sea(number)
    stepping = drive.stepping(sea, lines.driven_by(sea), finer)
    is_compared = drive.has_rest and finer == 1 and elements is None
    end = round(_MILLI * stepping.duration)
    progress(0, end)
    try:
        history, track = lines.run(
            sea,
            stepping,
            elements or drive.dynamics.bars,
            lambda t: progress(min(round(_MILLI * t), end), end),
        )
    except InputError as error:
        # The truss model's argument has another name in a case file.
        step = "dynamics.time_step"
        problems = [replace(p, key=step) if p.key == "step" else p for p in error.problems]
        raise InputError(problems, "--dynamic") from None
    said = [each for each in history.warnings if not is_said(each, STOPPED)]
    raos = drive.raos or drive.vessel
    if raos is not None and sea.waves is not None:
        if beyond := energy_beyond(raos.omega, sea.waves):
            said.append(Message("motion.beyond_raos", share=beyond))
        if drive.raos is not None and np.unique(sea.waves.direction).size > 1:
            said.append(Message("motion.raos_of_one_heading"))
    hull, way = (track, None) if isinstance(track, HullHistory) else (None, track)
    runs = []
    for k, leg in enumerate(lines.legs):
        of_line = history.of_line(k)
        still = np.full(of_line.time.size, np.nan)
        if is_compared:
            still = quasi_static(leg, of_line, drive.case.site.seabed_friction)
        if drive.dynamics.broken_line == k + 1 and history.parted is not None:
            still[of_line.time >= history.parted.time] = np.nan
        run = DynamicRun(of_line, still, number, track=way, hull=hull)
        if stepping.tensions:
            run = _counted(run, sea)
        runs.append(run)
    return runs, said


def _counted(run: DynamicRun, sea: Sea) -> DynamicRun:
    """Put the cycles of each bar's tension in the place of its series and its turning points."""
    history, at = run.history, run.counted
    waves, split = sea.waves, None
    if waves is not None:
        # Of the waves, hardly any is half as fast as their mean.
        split = 0.5 * float(np.average(waves.omega, weights=waves.amplitude**2))
    if history.counts:
        cycles = tuple(
            count_cycles(each.value, each.duration, split, samples=samples, mean=each.mean)
            for each, samples in zip(history.bar_courses, history.tension[at].T, strict=True)
        )
    else:
        time = float(np.ptp(history.time[at]))
        cycles = tuple(count_cycles(series, time, split) for series in history.tension[at].T)
    history = replace(history, tension=history.tension[:0], bar_courses=())
    return replace(run, history=history, cycles=cycles)


def _remarks(drive: Excitation, runs: Sequence[DynamicRun]) -> list[str]:
    remarks = [*drive.remarks, *parted_words(drive.dynamics, runs)]
    if not all(run.history.counts for run in runs):
        remarks.append(Message("motion.within_ramp"))
    if drive.has_rest and any(np.isnan(run.quasi_static).all() for run in runs):
        remarks.append(Message("motion.no_amplification"))
    elif drive.compares_at_rest and drive.case.current is not None:
        remarks.append(Message("motion.still_without_current"))
    return remarks


def _telling(progress: Progress, ask: Callable[[], None]) -> Progress:
    """Tell, and stop there if Ctrl-C was pressed."""

    def tell(at: int, end: int) -> None:
        ask()
        progress(at, end)

    return tell
