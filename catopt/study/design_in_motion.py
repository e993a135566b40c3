"""The front of designs that pass at rest and in motion: those that fail make room for the next."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, field, replace
from functools import partial
from time import perf_counter
from typing import TYPE_CHECKING

import numpy as np

from catopt.checks.case import check_strengths
from catopt.design.evaluation import OBJECTIVE_KEYS, DesignProblem, design_point
from catopt.design.front import Genes, Outcome
from catopt.design.neighbours import NoFeasibleDesignError, no_feasible_design
from catopt.design.result import (
    DesignPoint,
    DesignResult,
    FailsInMotion,
    NearMiss,
    SearchInMotion,
    made_of,
)
from catopt.design.search import (
    MOST_ENUMERATED,
    Found,
    answer,
    enumerate_designs,
    estimate,
    problem_of,
)
from catopt.errors import InputError, NotConvergedError, Problem, refused
from catopt.interrupt import waiting_interrupt
from catopt.model import Case
from catopt.notes.front_in_motion import (
    Asked,
    DesignInMotion,
    design_once,
    processes_of,
    refuse_without_tension,
    run_design,
)
from catopt.progress import Progress
from catopt.verify.convergence_check import ConvergenceCheck
from catopt.verify.dynamic_setup import check_for_motion, read_drive
from catopt.verify.side_by_side import Crew, silent
from catopt.words import Message, Sentence

if TYPE_CHECKING:
    from catopt.checks.result import CheckResult

Announce = Callable[[str], None]

_WHOLE = 1000
"""Progress of one design is told in so many parts."""


def design_in_motion(
    case: Case,
    *,
    convergence_check: ConvergenceCheck = "step",
    workers: int | None = None,
    progress: Progress | None = None,
    announce: Announce | None = None,
) -> DesignResult:
    """Find the lines, or the moorings, of which none that passes in motion beats another.

    Every design is checked at rest; those on the front are run in time, side by side, first in one
    seed and where they pass that in the others, and checked by the factors for motion. One that
    fails is taken out, and those come up that it alone kept off the front, until all that are left
    pass. Designs that one which passes beats need no run. The recommended one is run again, which
    has to bear out its maxima.

    Parameters
    ----------
    case : Case
        With `design`, and `dynamics` with what moves the line.
    convergence_check : {"step", "bars", "none"}, optional
        Of the recommended design, as of `catopt.verify.dynamic.verify_dynamic`.
    workers : int, optional
        Processes that run designs; those of this machine when left out.
    progress : callable, optional
        Called with the designs that were run, and those that are known to be run.
    announce : callable, optional
        Told how large the space is, and how many designs each round runs.

    Returns
    -------
    DesignResult
        Its `in_motion` says which were run and which fail, that of each design what it came to.
        Ctrl-C and the design's `max_run` end it with the front of those that were run.

    Raises
    ------
    InputError
        As `design_case` and `verify_dynamic`; for a case without a check of a tension, and a space
        too large to be enumerated.
    NoFeasibleDesignError
        No design passes at rest, or none of those that were run in motion.

    Examples
    --------
    >>> from catopt import read_case
    >>> from catopt.study.design_in_motion import design_in_motion
    >>> found = design_in_motion(read_case("cases/dynamic-chain-56m/design.toml"))
    >>> all(each.in_motion.checks.passes for each in found.front)
    True
    """
    check_for_motion(case)
    read_drive(case)
    check_strengths(case)
    refuse_without_tension(case)
    problem = problem_of(case)
    _refuse_search(problem)
    _refuse_rigid(problem)
    tell, said = progress or silent, announce or (lambda _: None)
    begun, size = perf_counter(), estimate(problem, workers=os.cpu_count() or 1)
    said(Message("beside.enumeration", size=size.words))
    with waiting_interrupt() as ask:
        runs = _Runs(problem, convergence_check, workers, tell, said, ask)
        outcome = runs.front()
    return runs.answer(outcome, perf_counter() - begun)


def _refuse_search(problem: DesignProblem) -> None:
    """Refuse what is not enumerated: only then it is known what comes up behind a design."""
    design, designs = problem.design, problem.space.count
    if design.method not in ("auto", "enumeration"):
        allowed = Message("refused_case.enumeration_in_motion")
        raise refused("design.method", design.method, allowed, "design")
    most = design.max_enumerated if design.method == "auto" else MOST_ENUMERATED
    if designs > most:
        allowed = Message("refused_case.too_many_in_motion", most=most)
        raise refused("design.max_enumerated", f"{designs:,}", allowed, "design")


def _refuse_rigid(problem: DesignProblem) -> None:
    """Refuse options that do not stretch: a bar of the truss model has an axial stiffness."""
    allowed = Message("refused_case.no_EA_in_motion")
    problems = []
    for index, variable in enumerate(problem.space.segments):
        rigid = dict.fromkeys(
            each.component or each.name for each in variable.options if each.is_inextensible
        )
        if rigid:
            names = ", ".join(each or "a segment" for each in rigid)
            problems.append(Problem(f"design.segments[{index}]", names, allowed))
    if problems:
        raise InputError(problems, "design")


@dataclass
class _Runs:
    """What is known in motion of the designs of a space, by their genes as bytes."""

    problem: DesignProblem
    convergence_check: ConvergenceCheck
    workers: int | None
    tell: Progress
    announce: Announce
    ask: Callable[[], None]
    known: dict[bytes, DesignInMotion] = field(default_factory=dict)
    points: dict[bytes, DesignPoint] = field(default_factory=dict)
    is_complete: bool = True
    is_interrupted: bool = False
    feasible: int = 0
    """Designs that pass at rest."""

    def front(self) -> Outcome:
        """Run designs until all on the front pass, the recommended one borne out."""
        crew: Crew | None = None
        with ExitStack() as stack:
            while True:
                outcome = self._at_rest()
                new = [each for each in outcome.genes if each.tobytes() not in self.known]
                room = self.problem.design.max_run - len(self.known)
                self.is_complete = self.is_complete and len(new) <= room
                asked = [each for each in map(self._asked, new[:room]) if each is not None]
                if asked:
                    if crew is None:
                        cases = [case for _, case in asked]
                        crew = stack.enter_context(Crew(processes_of(cases, self.workers)))
                    self._run(crew, asked)
                if not self.is_complete:
                    outcome = self._passing(outcome)
                elif new:
                    continue
                if self.is_interrupted or self._run_recommended_again(outcome):
                    return outcome

    def _at_rest(self) -> Outcome:
        """Find the front at rest of all designs that do not fail in motion."""
        failing = {key for key, each in self.known.items() if not each.passes}
        outcome = enumerate_designs(self.problem, workers=os.cpu_count() or 1, without=failing)
        if not self.known:
            self.feasible = outcome.feasible
            if not len(outcome.genes):
                raise no_feasible_design(self.problem, outcome)
        self._interrupt(if_so=outcome.interrupted)
        return outcome

    def _interrupt(self, *, if_so: bool) -> None:
        if if_so:
            self.is_interrupted, self.is_complete = True, False

    def _asked(self, genes: Genes) -> tuple[bytes, Asked] | None:
        """Return what runs a design; None where the closed form does not confirm it."""
        key = genes.tobytes()
        number = len(self.points) + 1
        try:
            point = self.points[key] = design_point(self.problem, tuple(genes.tolist()))
        except NotConvergedError as error:
            self.known[key] = DesignInMotion(number, (), failure=error.message)
            return None
        worth = tuple(point.objectives[OBJECTIVE_KEYS[name]] for name in self.problem.names)
        return key, (number, case_of(self.problem.case, point), worth)

    def _run(self, crew: Crew, asked: Sequence[tuple[bytes, Asked]]) -> None:
        done, count, cases = len(self.known), len(asked), [case for _, case in asked]
        said = "designs_run_after" if done else "designs_run"
        self.announce(Message(f"beside.{said}", count=count, done=done))

        def tell(at: int, end: int) -> None:
            self._tell(round(_WHOLE * (done + at / end * count)), _WHOLE * (done + count))

        found = crew.each(partial(design_once, cases), count, tell)
        keys = {number: key for key, (number, *_) in asked}
        self.known |= {keys[each.number]: each for each in found}
        self._interrupt(if_so=len(found) < count)

    def _tell(self, at: int, end: int) -> None:
        self.ask()
        self.tell(at, end)

    def _passing(self, outcome: Outcome) -> Outcome:
        """Keep of a front what was run and passes."""
        runs = [self.known.get(genes.tobytes()) for genes in outcome.genes]
        passes = [k for k, run in enumerate(runs) if run is not None and run.passes]
        genes, objectives = outcome.genes[passes], outcome.objectives[passes]
        return replace(outcome, genes=genes, objectives=objectives)

    def _run_recommended_again(self, outcome: Outcome) -> bool:
        """Run the design that is recommended again; return whether it passes then, too."""
        if self.convergence_check == "none" or not len(outcome.genes):
            return True
        best = answer(self.problem, self._found(outcome, 0.0)).best
        key = self._key(best)
        if not self.known[key].is_run_once:
            return True
        self.announce(Message("beside.recommended_again"))
        before, case = self.known[key], case_of(self.problem.case, best)
        how = self.convergence_check, self.workers, None, self._tell
        try:
            self.known[key] = run_design(before.number, before.objectives, case, *how)
        except KeyboardInterrupt:
            self._interrupt(if_so=True)
            return True
        return self.known[key].passes

    def _key(self, point: DesignPoint) -> bytes:
        return np.array(point.genes, dtype=np.int64).tobytes()

    def _found(self, outcome: Outcome, seconds: float) -> Found:
        whole = replace(outcome, feasible=self.feasible, interrupted=self.is_interrupted)
        return Found(whole, "enumeration", seconds)

    def answer(self, outcome: Outcome, seconds: float) -> DesignResult:
        """Lay out the front with what its designs came to, and what fails."""
        if not len(outcome.genes):
            raise self._none_passes()
        found = answer(self.problem, self._found(outcome, seconds))
        moved = [self.known[self._key(each)] for each in found.front]
        failing = tuple(
            FailsInMotion(self.points[key], reason_of(each))
            for key, each in self.known.items()
            if not each.passes and key in self.points
        )
        best = moved[found.recommended - 1]
        of = SearchInMotion(len(self.known), failing, self.is_complete, not best.is_run_once)
        front = (replace(p, in_motion=e.in_brief) for p, e in zip(found.front, moved, strict=True))
        whole = found.is_exact and self.is_complete
        return replace(found, front=tuple(front), in_motion=of, is_exact=whole)

    def _none_passes(self) -> NoFeasibleDesignError:
        """Put a search of which nothing passes in motion into words."""
        run_ones = [key for key in self.points if key in self.known]
        if not run_ones:
            said = Message("design.none_run", feasible=self.feasible)
            return NoFeasibleDesignError(Sentence(said), None, interrupted=True)
        nearest = min(
            run_ones,
            key=lambda key: (
                (worst := self.known[key].tightest) is None,
                0.0 if worst is None else worst.exceedance,
            ),
        )
        point, run = self.points[nearest], self.known[nearest]
        said = Message(
            "design.none_passes_in_motion" if self.is_complete else "design.none_run_passes",
            run=len(self.known),
            feasible=self.feasible,
            made=made_of(point),
            reason=reason_of(run),
        )
        failing = () if run.checks is None else run.checks.failed
        miss = NearMiss(point.line, failing, run.failure)
        return NoFeasibleDesignError(Sentence(said), miss, interrupted=self.is_interrupted)


def case_of(case: Case, point: DesignPoint) -> Case:
    """Make the case of a design: a whole mooring under the force that takes it farthest."""
    made = replace(case, line=point.line, anchor=point.anchor, design=None)
    if point.mooring is None:
        return made
    lift, level = point.mooring.load.lift, point.mooring.load.water_level
    site = replace(case.site, water_depth=case.site.water_depth + level)
    lines_out = point.mooring.load.line_out
    system = replace(point.mooring.farthest.system, judged_line_out=lines_out)
    return replace(made, site=site, fairlead_height=case.fairlead_height + lift, system=system)


def reason_of(run: DesignInMotion) -> str:
    """Say by what a design fails in motion."""
    worst: CheckResult | None = run.tightest
    if worst is None:
        return run.failure
    if run.checks is not None and run.checks.passes:
        return Message("design.not_borne_out")
    return worst.fails_as(worst.name)
