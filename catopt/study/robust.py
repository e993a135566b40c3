"""The best designs where values of the case are drawn: each is judged by all draws.

A design is on the front if it passes every check by the case's own values and in a share of the
draws; what is made small is the value that is not exceeded in that share of them. All designs see
the same draws, so that one is not preferred to another by chance.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from catopt.checks.kinds import ROUNDING
from catopt.design.evaluation import (
    OBJECTIVE_KEYS,
    Assessed,
    DesignProblem,
    design_point,
    sinker_of,
)
from catopt.design.front import Floats, Genes
from catopt.design.result import DesignPoint, DesignResult, InDraws, needed
from catopt.design.search import search_design
from catopt.errors import InputError, Problem
from catopt.model import Case
from catopt.progress import Progress
from catopt.study.file import read_study
from catopt.study.member import read_member
from catopt.study.reliability import counted_interval
from catopt.study.study import Study
from catopt.words import Listed, Message

_NONE: Final = np.iinfo(np.int64).max
"""Above every sinker: the draw is not passed."""

_AT_ONCE: Final = 2_000
"""Designs whose draws are kept at a time."""


class _ByDraw(NamedTuple):
    """What some designs come to in each draw."""

    objectives: Floats  # (draws, designs, objectives); infinite where one was not looked at
    exceedance: Floats  # (draws, designs); nan there
    sinkers: NDArray[np.int64]  # (draws, designs): `_NONE` where the draw is not passed
    unsolved: int


@dataclass(frozen=True)
class DrawnProblem(DesignProblem):
    """A design space whose designs are judged by draws of the case's values.

    `own`: the problem by the case's own values; `members`: those of each draw; `share`: of the
    draws in which a design has to pass.
    """

    own: DesignProblem = field(kw_only=True)
    members: tuple[DesignProblem, ...] = field(kw_only=True)
    share: float = field(kw_only=True)

    def assess(
        self,
        genes: Genes,
        *,
        stops_early: bool = False,
        workers: int = 1,
        of: int = 0,
        best: Floats | None = None,  # noqa: ARG002 - bounds are those of one load
    ) -> Assessed:
        """Judge many designs, of shape (n, genes), by all draws.

        Stopping early, those that have failed in too many draws are not looked at in further ones.
        """
        parts = [
            self._at_share(
                self._by_draw(genes[at : at + _AT_ONCE], workers, of, stops_early=stops_early)
            )
            for at in range(0, max(len(genes), 1), _AT_ONCE)
        ]
        return Assessed(
            np.concatenate([each.objectives for each in parts]),
            np.concatenate([each.exceedance for each in parts]),
            np.concatenate([each.sinker for each in parts]),
            sum(each.unsolved for each in parts),
        )

    @property
    def _at(self) -> int:
        """Place of the value that is not exceeded in the share of the draws, of those in order."""
        return needed(self.share, len(self.members)) - 1

    def _by_draw(self, genes: Genes, workers: int, of: int, *, stops_early: bool) -> _ByDraw:
        """Assess some designs in one draw after the other."""
        draws, count = len(self.members), len(genes)
        exceedance, unsolved = np.full((draws, count), np.nan), 0
        objectives = np.full((draws, count, len(OBJECTIVE_KEYS)), np.inf)
        sinkers = np.full((draws, count), _NONE)
        failed = np.zeros(count, dtype=np.int64)
        for draw, member in enumerate(self.members):
            left = np.flatnonzero(failed < draws - self._at) if stops_early else np.arange(count)
            if not left.size:
                break
            found = member.assess(genes[left], stops_early=stops_early, workers=workers, of=of)
            exceedance[draw, left], objectives[draw, left] = found.exceedance, found.objectives
            passes = found.exceedance <= ROUNDING
            failed[left] += ~passes
            sinkers[draw, left] = np.where(passes, found.sinker, _NONE)
            unsolved += found.unsolved
        return _ByDraw(objectives, exceedance, sinkers, unsolved)

    def _at_share(self, of: _ByDraw) -> Assessed:
        """Take of each design what is not exceeded in the share of the draws.

        Its sinker is the lightest that holds in as many of the draws in which all else passes, or
        the heaviest.
        """
        at = self._at
        # What was not looked at further has failed in too many draws: by the worst of those.
        worst = np.nanmax(of.exceedance, axis=0, initial=-np.inf)
        exceedance = np.where(np.isnan(of.exceedance), worst, of.exceedance)
        objectives = np.where(np.isnan(of.objectives), np.inf, of.objectives)
        objectives = np.partition(objectives, at, axis=0)[at]
        objectives[~np.isfinite(objectives)] = np.nan
        sinker = np.partition(of.sinkers, at, axis=0)[at]
        choice = self.design.sinker
        sinker[sinker == _NONE] = -1 if choice is None else len(choice.masses) - 1
        return Assessed(objectives, np.partition(exceedance, at, axis=0)[at], sinker, of.unsolved)

    def point(self, genes: tuple[int, ...]) -> DesignPoint:
        """Check a design by the case's own values in plain closed form, and count its draws."""
        design_point(self.own, genes)  # so that the compiled loop's answer is the closed form's
        by_draw = self._by_draw(np.array([genes]), 1, 1, stops_early=False)
        assessed = self._at_share(by_draw)
        anchor, sinker = self.case.anchor, int(assessed.sinker[0])
        if self.design.sinker is not None:
            anchor = sinker_of(self.case, self.design.sinker, sinker)
        point = self._point(self.space.line(genes), anchor, genes)
        samples = len(self.members)
        failing = int((by_draw.sinkers[:, 0] > sinker).sum())  # that fails has none
        values = assessed.objectives[0, self.columns].tolist()
        keys = [OBJECTIVE_KEYS[name] for name in self.names]
        return replace(
            point,
            objectives={**point.objectives, **dict(zip(keys, values, strict=True))},
            draws=InDraws(
                failing / samples, counted_interval(failing, samples), self.share, samples
            ),
        )


def design_in_draws(
    study: Study | str | os.PathLike[str],
    *,
    progress: Progress | None = None,
    announce: Callable[[str], None] | None = None,
) -> DesignResult:
    """Find the best designs of a case whose values are drawn.

    Parameters
    ----------
    study : Study or path
        With `compute` "design": a case with a design of one line, and what is drawn.
    progress, announce
        As of `catopt.design.search.design_case`.

    Returns
    -------
    DesignResult
        The front; `draws` of each design says in what part of the draws it fails.

    Raises
    ------
    InputError, NoFeasibleDesignError
        As `design_case`; a whole mooring is not drawn.

    Examples
    --------
    >>> from catopt.study.robust import design_in_draws
    >>> found = design_in_draws("cases/design-buoy-9.5m/in-draws.toml")
    >>> all(each.draws.failing <= 0.05 for each in found.front)
    True
    """
    read = study if isinstance(study, Study) else read_study(study)
    return search_design(drawn_problem(read), progress, announce)


def drawn_problem(study: Study) -> DrawnProblem:
    """Make the problem of a study of a design; InputError with all that stands in its way."""
    case = read_member(study.base, {})
    assert isinstance(case, Case)
    problems = []
    if case.design is None:
        allowed = Message("refused_case.missing_table_design_says_what")
        problems.append(Problem("design", "", allowed))
    if case.design is not None and case.design.in_motion:
        said = Message("refused_study.no_motion_in_draws")
        problems.append(Problem("design.in_motion", "true", said))
    if case.several_lines:
        problems.append(Problem("system", "", Message("refused_study.no_mooring_in_draws")))
    if problems:
        raise InputError(problems, study.base.source)
    own = DesignProblem.of(case)
    drawn = (read_member(study.base, study.values_of(member)) for member in range(len(study)))
    members = tuple(DesignProblem.of(each) for each in drawn if isinstance(each, Case))
    said = Message(
        "design.in_draws",
        share=100.0 * study.share,
        samples=len(members),
        keys=Listed(study.keys, "and"),
        unseen=100.0 * counted_interval(0, len(members))[1],
    )
    parts = {name: getattr(own, name) for name in ("case", "states", "space", "tables")}
    warnings = (*own.warnings, said)
    return DrawnProblem(**parts, warnings=warnings, own=own, members=members, share=study.share)
