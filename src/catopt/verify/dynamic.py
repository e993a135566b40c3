"""Run a case's line in time: what a quasi-static answer leaves out."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import numpy.typing as npt

from catopt.catenary.batch import solve_many
from catopt.catenary.case import solve_case
from catopt.errors import InputError, Problem, TouchesTwiceError
from catopt.fem.dynamics import run_dynamics
from catopt.fem.history import History
from catopt.fem.solve import solve_line
from catopt.interrupt import waiting_interrupt
from catopt.model import Case, Load
from catopt.verify.case import load_states
from catopt.verify.dynamic_result import DynamicPart, DynamicRun, DynamicVerification
from catopt.verify.dynamic_setup import Drive, check_for_motion, read_drive

__all__ = ["verify_dynamic"]

Array = npt.NDArray[np.float64]
Progress = Callable[[int, int], None]

_MILLI = 1000
"""Progress is told in thousandths of a second."""

_LEFT_OUT = 0.01
"""Part of the waves' energy beyond a table of RAOs from which it is remarked on."""


def verify_dynamic(
    case: Case, *, load_case: str | None = None, progress: Progress | None = None
) -> DynamicVerification:
    """Run the line of a case in the time domain, in its waves, its current and its motion.

    The line comes to rest under its load first; then motion and waves grow smoothly. Each run of a
    random sea has a seed of its own.

    Parameters
    ----------
    case : Case
        With `dynamics`, and `motion` or `waves`.
    load_case : str, optional
        Name of one load case; all of them when left out, or the load where there are none.
    progress : callable, optional
        Told how far it is and how far it goes.

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
    """
    check_for_motion(case)
    states = [(name, read_drive(state)) for name, state in load_states(case, load_case)]
    parts: list[DynamicPart] = []
    with waiting_interrupt() as ask:
        for done, (name, drive) in enumerate(states):
            part = _part(name, drive, _telling(_share(progress, done, len(states)), ask))
            if part is None:
                break
            parts.append(part)
            if not part.is_complete or len(part.runs) < drive.dynamics.runs:
                break
    if not parts:
        raise KeyboardInterrupt
    is_whole = len(parts) == len(states) and len(parts[-1].runs) == states[-1][1].dynamics.runs
    return DynamicVerification(case, tuple(parts), is_whole and parts[-1].is_complete)


def _part(name: str, drive: Drive, progress: Progress) -> DynamicPart | None:
    """Run one load case; None when it was stopped before anything was there."""
    runs: list[DynamicRun] = []
    remarks: list[str] = []
    total = drive.dynamics.runs
    try:
        load, span = _at_rest(drive.case)
        for number in range(total):
            run, said = _run(drive, load, span, number, _share(progress, number, total))
            if run.history.time.size < 2:
                break
            runs.append(run)
            remarks += [each for each in said if each not in remarks]
            if not run.history.is_complete:
                break
    except KeyboardInterrupt:
        pass
    if not runs:
        return None
    if len(runs) < total or not runs[-1].history.is_complete:
        remarks.append(f"stopped in run {len(runs)} of {total}")
    remarks += _remarks(drive, runs)
    return DynamicPart(name, tuple(runs), drive.is_random, drive.dynamics.elements, tuple(remarks))


def _run(
    drive: Drive, load: Load, span: float, number: int, progress: Progress
) -> tuple[DynamicRun, list[str]]:
    case, sea = drive.case, drive.sea(number)
    motion = drive.motion(sea, span)
    stepping = drive.stepping(sea, motion)
    end = round(_MILLI * stepping.duration)
    progress(0, end)
    try:
        history = run_dynamics(
            case.line,
            stepping,
            height=case.fairlead_height,
            span=load.span,
            horizontal_force=load.horizontal_force,
            anchor_height=case.anchor_height,
            motion=motion,
            properties=drive.properties,
            sea=sea,
            elements=drive.dynamics.elements,
            progress=lambda t: progress(min(round(_MILLI * t), end), end),
        )
    except InputError as error:
        raise InputError([_as_in_file(each) for each in error.problems], "--dynamic") from None
    said = [each for each in history.warnings if not each.startswith("stopped")]
    if drive.raos is not None and sea.waves is not None:
        beyond = drive.raos.energy_beyond(sea.waves)
        if beyond > _LEFT_OUT:
            said.append(
                f"{beyond:.0%} of the waves' energy is beyond the periods of the RAOs; there the "
                "first and the last one hold"
            )
    return DynamicRun(history, _quasi_static(case, history)), said


def _as_in_file(problem: Problem) -> Problem:
    """Name the truss model's argument by the key that gives it."""
    return replace(problem, key="dynamics.time_step") if problem.key == "step" else problem


def _at_rest(case: Case) -> tuple[Load, float]:
    """Load by which the truss model is brought to rest, and the span that it gives."""
    load = case.load
    assert load is not None
    try:
        closed = solve_case(case)
    except TouchesTwiceError:
        if load.fairlead_tension is not None:
            raise
        truss = solve_line(
            case.line,
            height=case.fairlead_height,
            span=load.span,
            horizontal_force=load.horizontal_force,
            anchor_height=case.anchor_height,
            seabed_friction=case.site.seabed_friction,
        )
        return load, truss.span
    if load.fairlead_tension is not None:
        load = Load(horizontal_force=closed.horizontal_force)
    return load, closed.span


def _quasi_static(case: Case, history: History) -> Array:
    """Tension at the fairlead in closed form at each of its places; nan where it has none."""
    at = history.fairlead[:, 0]
    solved = solve_many(
        case.line,
        height=np.ascontiguousarray(at[:, 2]),
        span=np.hypot(at[:, 0], at[:, 1]),
        seabed_friction=case.site.seabed_friction,
        anchor_height=case.anchor_height,
    )
    return np.where(solved.converged, solved.tension, np.nan)


def _remarks(drive: Drive, runs: list[DynamicRun]) -> list[str]:
    remarks = []
    if any(run.history.counted.sum() < 2 for run in runs):
        remarks.append("stopped before the ramp was over: statistics are over all samples")
    if any(np.isnan(run.quasi_static).all() for run in runs):
        remarks.append("the closed form refuses this line, so that there is no amplification")
    elif drive.case.current is not None:
        remarks.append("the quasi-static tension is without the current")
    return remarks


def _share(progress: Progress | None, done: int, total: int) -> Progress:
    """Tell of one of several equal parts as of the whole."""
    if progress is None:
        return lambda *_: None
    return lambda at, end: progress(done * end + at, total * end)


def _telling(progress: Progress, ask: Callable[[], None]) -> Progress:
    """Tell, and stop there if Ctrl-C was pressed."""

    def tell(at: int, end: int) -> None:
        ask()
        progress(at, end)

    return tell
