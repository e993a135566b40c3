"""Run a case's line in time: what a quasi-static answer leaves out."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from types import MappingProxyType

import numpy as np
import numpy.typing as npt

from catopt.catenary.batch import solve_many
from catopt.catenary.case import solve_case
from catopt.errors import InputError, NotConvergedError, Problem
from catopt.fem.dynamics import run_dynamics
from catopt.fem.history import History
from catopt.interrupt import waiting_interrupt
from catopt.model import Case, Load
from catopt.verify.case import load_states
from catopt.verify.dynamic_result import DynamicPart, DynamicRun, DynamicVerification
from catopt.verify.dynamic_setup import Drive, check_for_motion, read_drive
from catopt.verify.proof import Again, Proof, Way

__all__ = ["verify_dynamic"]

Array = npt.NDArray[np.float64]
Progress = Callable[[int, int], None]

_MILLI = 1000
"""Progress is told in thousandths of a second."""

_LEFT_OUT = 0.01
"""Part of the waves' energy beyond a table of RAOs from which it is remarked on."""


def verify_dynamic(
    case: Case,
    *,
    load_case: str | None = None,
    proof: Proof = "step",
    progress: Progress | None = None,
) -> DynamicVerification:
    """Run the line of a case in the time domain, in its waves, its current and its motion.

    The line comes to rest under its load first; then motion and waves grow smoothly. Each run of a
    random sea has a seed of its own, and is run again at half the step to show how far its maxima
    hang on that; where the line goes slack, with twice the bars, too.

    Parameters
    ----------
    case : Case
        With `dynamics`, and `motion` or `waves`.
    load_case : str, optional
        Name of one load case; all of them when left out, or the load where there are none.
    proof : {"step", "bars", "none"}
        "bars" runs every line again with twice the bars; "none" runs it once.
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
            part = _part(name, drive, proof, _telling(_share(progress, done, len(states)), ask))
            if part is None:
                break
            parts.append(part)
            if not part.is_complete or len(part.runs) < drive.dynamics.runs:
                break
    if not parts:
        raise KeyboardInterrupt
    is_whole = len(parts) == len(states) and len(parts[-1].runs) == states[-1][1].dynamics.runs
    return DynamicVerification(case, tuple(parts), is_whole and parts[-1].is_complete)


def _part(name: str, drive: Drive, proof: Proof, progress: Progress) -> DynamicPart | None:
    """Run one load case; None when it was stopped before anything was there."""
    runs: list[DynamicRun] = []
    remarks: list[str] = []
    total = drive.dynamics.runs
    try:
        load, span = _at_rest(drive.case)
        for number in range(total):
            share = _share(progress, number, total)
            pieces = 1 if proof == "none" else 1 + len(_PARTS)
            run, said = _run(drive, load, span, number, _share(share, 0, pieces))
            if run.history.time.size < 2:
                break
            runs.append(run)
            remarks += [each for each in said if each not in remarks]
            if not run.history.is_complete:
                break
            for piece, way in enumerate(_ways(proof, run), start=1):
                again = _again(drive, load, span, number, way, _share(share, piece, pieces))
                runs[-1] = replace(runs[-1], again=(*runs[-1].again, again))
    except KeyboardInterrupt:
        pass
    if not runs:
        return None
    part = DynamicPart(
        name, tuple(runs), drive.is_random, drive.case.line.length, proof, drive.dynamics.elements
    )
    if len(runs) < total or not part.is_complete:
        remarks.append(f"stopped in run {len(runs)} of {total}")
    remarks += _remarks(drive, runs)
    return replace(part, remarks=tuple(remarks))


def _ways(proof: Proof, run: DynamicRun) -> list[Way]:
    """In which ways a run is made again."""
    if proof == "none":
        return []
    return ["step", "bars"] if proof == "bars" or run.history.line_slack_time() > 0.0 else ["step"]


def _again(
    drive: Drive, load: Load, span: float, number: int, way: Way, progress: Progress
) -> Again:
    """Run once more at half the step or with twice the bars, in the same sea."""
    finer, more = _PARTS[way]
    elements = more * drive.dynamics.elements
    sea = drive.sea(number)
    step = drive.stepping(sea, drive.motion(sea, span), finer).step
    try:
        run, _ = _run(drive, load, span, number, progress, finer, elements)
    except NotConvergedError as error:
        return Again(way, step, elements, {}, str(error))
    if not run.history.is_complete:
        raise KeyboardInterrupt
    return Again(way, step, elements, run.maxima)


def _run(
    drive: Drive,
    load: Load,
    span: float,
    number: int,
    progress: Progress,
    finer: int = 1,
    elements: int | None = None,
) -> tuple[DynamicRun, list[str]]:
    case, sea = drive.case, drive.sea(number)
    motion = drive.motion(sea, span)
    stepping = drive.stepping(sea, motion, finer)
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
            elements=elements or drive.dynamics.elements,
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


_PARTS: Mapping[Way, tuple[int, int]] = MappingProxyType({"step": (2, 1), "bars": (1, 2)})
"""Steps in place of one, and bars in place of one, by the way in which a run is made again."""


def _as_in_file(problem: Problem) -> Problem:
    """Name the truss model's argument by the key that gives it."""
    return replace(problem, key="dynamics.time_step") if problem.key == "step" else problem


def _at_rest(case: Case) -> tuple[Load, float]:
    """Load by which the truss model is brought to rest, and the span that it gives."""
    load = case.load
    assert load is not None
    closed = solve_case(case)
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
        remarks.append(
            "the closed form has no answer where the fairlead goes, so that there is no "
            "amplification"
        )
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
