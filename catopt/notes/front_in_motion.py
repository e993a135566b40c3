"""Designs of a front in motion: run side by side, each once; the one that is recommended proven."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import FIRST_COMPLETED, Executor, wait
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cached_property, partial
from typing import TYPE_CHECKING, Literal

import numpy as np

from catopt.checks.criteria import criteria_of
from catopt.checks.result import CheckReport, ChecksInMotion
from catopt.design.front import knee
from catopt.design.result import PointInMotion
from catopt.errors import NoAnswerError, NotConvergedError, refused
from catopt.interrupt import waiting_interrupt
from catopt.model.kinds import SomeForce
from catopt.notes.motion import checks_in_motion
from catopt.progress import Progress
from catopt.records import Counted, FromZero, Record
from catopt.verify.dynamic_result import DynamicVerification, Verdict
from catopt.words import Message

if TYPE_CHECKING:
    from catopt.checks.result import CheckResult
    from catopt.model import Case
    from catopt.verify.convergence_check import ConvergenceCheck
    from catopt.verify.dynamic_result import DynamicPart

Asked = tuple[int, "Case", tuple[float, ...]]
"""A design's number, its case, and its objectives in SI."""

_LOOK = 0.1
"""Seconds between two looks at what an executor has done."""


@dataclass(frozen=True)
class DesignInMotion(Record):
    """One design of a front in motion."""

    DOCUMENT = (
        "number=design verdict failure passes at_rest=tension_at_rest_N largest_tension "
        "quasi_static_tension amplification run_count=runs in_motion=checks"
    )

    number: Counted
    """Number, from 1, as in the tables of the front."""
    objectives: tuple[float, ...]
    """Of the search, in SI, lower being better."""
    found: DynamicVerification | None = None
    """None where there is no answer."""
    checks: CheckReport | None = None
    """Of the tensions in motion."""
    at_rest: SomeForce | None = None
    """Tension at the fairlead under the mean loads, N, where it is largest in motion; None on a bed
    that slopes."""
    failure: str = ""
    """Why there is no answer; empty where there is one."""

    @cached_property
    def verdict(self) -> Verdict | Literal["no answer"]:
        """Whether a second run bears out the maxima."""
        return "no answer" if self.found is None else self.found.verdict

    @property
    def largest_tension(self) -> SomeForce | None:
        """At the fairlead, N, in the load case or the line where it is largest."""
        part = self.governing
        return None if part is None else part.of("fairlead_tension").maximum

    @property
    def quasi_static_tension(self) -> SomeForce | None:
        """The largest, N, had the line moved infinitely slowly."""
        return None if self.governing is None else self.governing.quasi_static_max

    @property
    def amplification(self) -> float | None:
        """The former over the latter: the allowance for motion of this design."""
        return None if self.governing is None else self.governing.dynamic_amplification

    @property
    def run_count(self) -> FromZero:
        """Seeds in which it was run; one alone where it fails there."""
        return 0 if self.governing is None else len(self.governing.runs)

    @property
    def in_motion(self) -> ChecksInMotion | None:
        """Of it in motion."""
        return None if self.checks is None else self.checks.in_motion

    @property
    def passes(self) -> bool:
        """Whether the maxima are borne out, and every check passes by them."""
        found, checks = self.found, self.checks
        is_sure = found is not None and found.is_complete and found.verdict != "not converged"
        return is_sure and checks is not None and bool(checks.results) and checks.passes

    @property
    def is_run_once(self) -> bool:
        """Whether it was run, but no run again says what its maxima hang on."""
        return self.found is not None and self.found.verdict == "not proven"

    @property
    def in_brief(self) -> PointInMotion:
        """What the design of a search came to."""
        return PointInMotion(
            self.largest_tension,
            self.quasi_static_tension,
            self.amplification,
            self.run_count,
            self.verdict,
            self.checks,
            self.failure,
        )

    @property
    def governing(self) -> DynamicPart | None:
        """The load case, or the line of a body, with the largest tension at the fairlead."""
        return None if self.found is None else self.found.governing

    @property
    def tightest(self) -> CheckResult | None:
        """The check that fails by most, or else that is nearest to its limit."""
        return None if self.checks is None else self.checks.governing


@dataclass(frozen=True)
class FrontInMotion(Record):
    """A front in motion."""

    DOCUMENT = "of_search=recommended_by_search recommended is_complete=complete designs"

    designs: tuple[DesignInMotion, ...]
    """Every design that was run, by its number."""
    of_search: Counted
    """Number of the design that the search recommends, from 1: it passes at rest."""
    is_complete: bool
    """False: it was stopped (Ctrl-C); the designs after that are missing."""

    @property
    def recommended(self) -> Counted | None:
        """Number of the best design that passes at rest and in motion; None: none does.

        That of the search if it passes in motion, else the knee of those that do.
        """
        passing = [each for each in self.designs if each.passes]
        if self.of_search in {each.number for each in passing}:
            return self.of_search
        if not passing:
            return None
        return passing[knee(np.array([each.objectives for each in passing])).index].number

    @property
    def has_converged(self) -> bool:
        """Whether every design has an answer that its convergence check does not contradict."""
        return all(
            each.found is not None and each.found.verdict != "not converged"
            for each in self.designs
        )


def front_in_motion(
    cases: Sequence[Asked],
    of_search: int,
    *,
    convergence_check: ConvergenceCheck = "step",
    workers: int | None = None,
    executor: Executor | None = None,
    progress: Progress | None = None,
) -> FrontInMotion:
    """Run designs in time, side by side, in every load case, and check their tensions.

    Each is run once: first in one seed, by its largest values, which all of them together are never
    judged below; in the others where it passes. Then the design that is recommended is run again to
    prove it, and where that speaks against it the one that is recommended instead.

    A case is a design's number, case and objectives. `convergence_check`: of the one that is
    recommended; "bars" proves every design that passes. `executor`: what runs the designs, as of
    `concurrent.futures`; `workers` processes of this machine when left out. The rest is as for
    `verify_dynamic`.

    Raises InputError as `verify_dynamic` and `check_motion` do, and where the case has no check of
    a tension. A design without an answer does not stop the others.
    """
    from catopt.verify.side_by_side import Crew, share_of

    for _, case, _ in cases[:1]:
        refuse_without_tension(case)
    with waiting_interrupt() as ask:

        def tell(at: int, end: int) -> None:
            ask()
            if progress is not None:
                progress(at, end)

        once, proof = share_of(tell, 0, 2), share_of(tell, 1, 2)
        task = partial(design_once, cases)
        if executor is None:
            with Crew(min(processes_of(cases, workers), len(cases))) as crew:
                designs = crew.each(task, len(cases), once)
        else:
            designs = _on(executor, task, len(cases), once)
        front = FrontInMotion(tuple(designs), of_search, len(designs) == len(cases))
        if convergence_check == "none":
            return front
        proven: set[int] = set()
        try:
            while (wanted := _to_prove(front, convergence_check, proven)) is not None:
                number, case, objectives = cases[wanted]
                again = run_design(
                    number, objectives, case, convergence_check, workers, None, proof
                )
                proven.add(number)
                kept = (again if each.number == number else each for each in front.designs)
                front = replace(front, designs=tuple(kept))
        except KeyboardInterrupt:
            front = replace(front, is_complete=False)
        return front


def refuse_without_tension(case: Case) -> None:
    """Refuse designs in motion that no check of a tension judges."""
    if not any(each.check == "tension" for each in criteria_of(case, analysis="dynamic").all):
        allowed = Message("refused_command.codes_or_safety_factor_are")
        found = Message("refused_command.no_tension_limit")
        raise refused("checks", found, allowed, "case file")


def processes_of(cases: Sequence[Asked], workers: int | None) -> int:
    """Say how many processes run the designs, at most: one where there is little to do."""
    from catopt.verify.case import load_states
    from catopt.verify.dynamic import processes_for, work_of

    for _, case, _ in cases:
        with suppress(NoAnswerError, NotConvergedError):
            work = sum(work_of(state) for _, state in load_states(case, None))
            return processes_for(len(cases) * work, workers)
    return 1


def _on(
    executor: Executor, task: Callable[[int, Progress], DesignInMotion], count: int, tell: Progress
) -> list[DesignInMotion]:
    """Do a task for each number by an executor; stopped, what was done by then."""
    from catopt.verify.side_by_side import silent

    futures = [executor.submit(task, number, silent) for number in range(count)]
    waiting = set(futures)
    try:
        while waiting:
            done, waiting = wait(waiting, _LOOK, FIRST_COMPLETED)
            for each in done:
                each.result()
            tell(count - len(waiting), count)
    except KeyboardInterrupt:
        for each in futures:
            each.cancel()
    return [each.result() for each in futures if each.done() and not each.cancelled()]


def _to_prove(
    front: FrontInMotion, convergence_check: ConvergenceCheck, proven: set[int]
) -> int | None:
    """Find the design, by its place, that passes and is to be proven next; not those that were."""
    wanted = [front.recommended]
    if convergence_check == "bars":
        wanted += [each.number for each in front.designs if each.passes]
    for k, each in enumerate(front.designs):
        if each.number in wanted and each.number not in proven:
            return k
    return None


def design_once(cases: Sequence[Asked], at: int, progress: Progress) -> DesignInMotion:
    """Run a design in one seed and, where it passes that, in the others."""
    from catopt.verify.side_by_side import share_of

    number, case, objectives = cases[at]
    assert case.dynamics is not None
    runs = case.dynamics.runs
    first = run_design(
        number, objectives, case, "none", 1, range(min(1, runs)), share_of(progress, 0, runs)
    )
    if runs == 1 or not first.passes:
        return first
    rest = share_of(progress, 1, runs, runs - 1)
    return run_design(number, objectives, case, "none", 1, range(1, runs), rest, first.found)


def run_design(
    number: int,
    objectives: tuple[float, ...],
    case: Case,
    convergence_check: ConvergenceCheck,
    workers: int | None,
    seeds: Sequence[int] | None,
    progress: Progress,
    before: DynamicVerification | None = None,
) -> DesignInMotion:
    """Run a design and check what its runs came to; raises KeyboardInterrupt where it is stopped.

    `seeds`: as of `verify_dynamic`, those of the first ones being judged by their largest values;
    `before`: what the seeds came to that were run before these.
    """
    from catopt.verify.dynamic import verify_dynamic
    from catopt.verify.verdicts import (
        solutions_at_rest,
        with_more_runs,
        with_settings,
        with_verdicts,
    )

    try:
        found = verify_dynamic(
            case,
            convergence_check=convergence_check,
            workers=workers,
            seeds=seeds,
            progress=progress,
        )
        if not found.is_complete:
            raise KeyboardInterrupt
        if before is not None:
            parts = [with_more_runs(*e) for e in zip(before.parts, found.parts, strict=True)]
            found = replace(found, parts=tuple(with_verdicts(case, parts)))
        judged = found
        if seeds is not None and before is None:
            assert case.dynamics is not None
            largest_values = replace(case.dynamics, judged_by="largest")
            parts = [with_settings(each, largest_values) for each in found.parts]
            judged = replace(found, parts=tuple(parts))
        still = solutions_at_rest(case, found.parts)
        checks = checks_in_motion(judged, still)
    except (NoAnswerError, NotConvergedError) as error:
        return DesignInMotion(number, objectives, failure=error.message)
    solution = still[found.parts.index(found.governing)]
    tension = None if solution is None else solution.fairlead.tension
    return DesignInMotion(number, objectives, found, checks, tension)
