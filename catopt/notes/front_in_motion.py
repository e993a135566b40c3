"""Every design of a front run in time: which pass their checks in motion, too, and the best."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from catopt.checks.criteria import criteria_of
from catopt.design.front import knee
from catopt.errors import InputError, NoAnswerError, NotConvergedError, Problem
from catopt.notes.motion import checks_in_motion, lines_at_rest
from catopt.ties import largest
from catopt.words import Message

if TYPE_CHECKING:
    from catopt.checks.result import CheckReport, CheckResult
    from catopt.model import Case
    from catopt.verify.dynamic_result import DynamicPart, DynamicVerification
    from catopt.verify.proof import Proof


@dataclass(frozen=True)
class DesignInMotion:
    """One design of a front in motion, by its number from 1, as in the tables of the front.

    The objectives are those of the search, in SI, lower being better. Nothing was found where there
    is no answer, for the reason of `failure`; the checks are of the tensions in motion, and
    `at_rest` is the tension at the fairlead under the mean loads, N, where it is largest in motion.
    """

    number: int
    objectives: tuple[float, ...]
    found: DynamicVerification | None = None
    checks: CheckReport | None = None
    at_rest: float | None = None
    failure: str = ""

    @property
    def passes(self) -> bool:
        """Whether it was run to its end, is not doubted, and every check passes."""
        found, checks = self.found, self.checks
        is_sure = found is not None and found.is_complete and found.verdict != "not converged"
        return is_sure and checks is not None and bool(checks.results) and checks.passes

    @property
    def governing(self) -> DynamicPart | None:
        """The load case, or the line of a body, with the largest tension at the fairlead."""
        return None if self.found is None else self.found.governing

    @property
    def tightest(self) -> CheckResult | None:
        """The check that is nearest to its limit."""
        results = () if self.checks is None else self.checks.results
        return largest(results, lambda each: each.utilisation or 0.0) if results else None


@dataclass(frozen=True)
class FrontInMotion:
    """A front in motion; not complete when it was stopped (Ctrl-C), later designs being left out.

    `of_search` is the number of the design that the search recommends, which passes at rest.
    """

    designs: tuple[DesignInMotion, ...]
    of_search: int
    is_complete: bool

    @property
    def recommended(self) -> int | None:
        """Number of the best design that passes at rest and in motion; None if there is none.

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
        """Whether every design has an answer that its proof does not contradict."""
        return all(
            each.found is not None and each.found.verdict != "not converged"
            for each in self.designs
        )

    def to_dict(self) -> dict[str, Any]:
        """Build what ``catopt verify DIR --all --dynamic --json`` has under ``dynamic``."""
        return {
            "recommended_by_search": self.of_search,
            "recommended": self.recommended,
            "complete": self.is_complete,
            "designs": [_document(each) for each in self.designs],
        }


def front_in_motion(
    cases: Sequence[tuple[int, Case, tuple[float, ...]]],
    of_search: int,
    *,
    proof: Proof = "step",
    workers: int | None = None,
    progress: Callable[[int, int], None] | None = None,
) -> FrontInMotion:
    """Run designs in time, one after the other, in every load case, and check their tensions.

    A case is a design's number, case and objectives; `progress` is told the designs done and all,
    the rest is as for `verify_dynamic`.

    Raises InputError as `verify_dynamic` and `check_motion` do, and where the case has no check of
    a tension. A design without an answer does not stop the others.
    """
    from catopt.verify.dynamic import verify_dynamic

    for _, case, _ in cases[:1]:
        if not any(each.check == "tension" for each in criteria_of(case, analysis="dynamic").all):
            allowed = Message("refused_command.codes_or_safety_factor_are")
            raise InputError(
                [Problem("checks", Message("refused_command.no_tension_limit"), allowed)],
                "case file",
            )
    designs: list[DesignInMotion] = []
    for done, (number, case, objectives) in enumerate(cases):
        if progress is not None:
            progress(done, len(cases))
        try:
            found = verify_dynamic(case, proof=proof, workers=workers)
            still = lines_at_rest(found)
            checks = checks_in_motion(found, still)
        except (NoAnswerError, NotConvergedError) as error:
            designs.append(DesignInMotion(number, objectives, failure=error.message))
            continue
        solution = still[found.parts.index(found.governing)]
        tension = None if solution is None else solution.fairlead.tension
        designs.append(DesignInMotion(number, objectives, found, checks, tension))
        if not found.is_complete:
            break
    is_complete = len(designs) == len(cases) and all(
        each.found is None or each.found.is_complete for each in designs
    )
    return FrontInMotion(tuple(designs), of_search, is_complete)


def _document(each: DesignInMotion) -> dict[str, Any]:
    part = each.governing
    return {
        "design": each.number,
        "verdict": "no answer" if each.found is None else each.found.verdict,
        "failure": each.failure,
        "passes": each.passes,
        "tension_at_rest_N": each.at_rest,
        "largest_tension_N": None if part is None else part.of("fairlead_tension").maximum,
        "quasi_static_tension_N": None if part is None else part.quasi_static_max,
        "amplification": None if part is None else part.amplification,
        "checks": None if each.checks is None else each.checks.motion_document(),
    }
