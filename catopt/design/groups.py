"""Lines between points evaluated by groups that are made alike: mooring, checks and objectives."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from types import SimpleNamespace
from typing import Any

import numpy as np

from catopt.checks.evaluation import NO_CHECK
from catopt.checks.system import check_network, criteria_of_network
from catopt.design.evaluation import OBJECTIVE_KEYS, Assessed, DesignProblem
from catopt.design.front import Floats, Genes
from catopt.design.result import DesignLoadCase, DesignPoint
from catopt.design.space import resolve
from catopt.errors import NoAnswerError, NotConvergedError
from catopt.model import Line, LoadCase
from catopt.model.kinds import Findings
from catopt.model.network import Network
from catopt.mooring.fixed_body import at_rest
from catopt.words import Message

_FAILS = 1e9
"""Excess of a mooring that finds no rest: beyond that of any check."""


@dataclass(frozen=True)
class GroupProblem(DesignProblem):
    """Lines between points with their design space; each design is brought to rest and checked."""

    case: Any  # a Network

    @classmethod
    def of(cls, case: Any) -> GroupProblem:
        """Make the problem of lines between points.

        InputError: a figure that objectives or checks need is missing, or no body is free whose
        offset could be made small; all at once.
        """
        network: Network = case
        found, design = Findings("design"), network.design
        if design is None:
            found.add("design", "", Message("refused_case.missing_table_design_says_what"))
            found.raise_if_any()
            raise AssertionError
        if "offset" in design.objectives and not network.bodies:
            allowed = Message("refused_case.offset_wants_a_body")
            found.add("design.objectives", "offset", allowed)
        varied = {(name, group.segment) for group in design.groups for name in group.lines}
        for k, (name, each) in enumerate(network.named_lines):
            for i, segment in enumerate(each.line.segments, start=1):
                for objective, quantity in (("mass", "mass"), ("cost", "price")):
                    lacks = objective in design.objectives and getattr(segment, quantity) is None
                    if lacks and (name, i) not in varied:
                        allowed = Message(f"refused_case.no_{quantity}_for_it", objective=objective)
                        found.add(f"lines[{k}].segments[{i - 1}].{quantity}", "", allowed)
        found.raise_if_any()
        criteria = criteria_of_network(network)
        states = (LoadCase("load", 1.0),)  # whose kind and state say which factors hold
        space, remarks = resolve(network, criteria, states)
        nothing = () if criteria.all else (Message(NO_CHECK),)
        steps: Any = SimpleNamespace(step=np.zeros(len(OBJECTIVE_KEYS)))
        return cls(network, states, space, steps, (*remarks, *criteria.warnings, *nothing))

    @property
    def known(self) -> tuple[str, ...]:
        """The objectives; others are not looked up."""
        return self.names

    def assess(
        self,
        genes: Genes,
        *,
        stops_early: bool = False,  # noqa: ARG002 - a mooring is checked as a whole
        workers: int = 1,  # noqa: ARG002
        of: int = 0,  # noqa: ARG002
        best: Floats | None = None,  # noqa: ARG002
    ) -> Assessed:
        """Bring many designs to rest and check them, one after the other."""
        keys = list(OBJECTIVE_KEYS.values())
        objectives = np.full((len(genes), len(keys)), np.nan)
        exceedance = np.full(len(genes), _FAILS)
        unsolved = 0
        for row, each in enumerate(genes.tolist()):
            try:
                point = self.point(tuple(each))
            except NotConvergedError:
                unsolved += 1
                continue
            except NoAnswerError:
                continue
            objectives[row] = [point.objectives.get(key, np.nan) for key in keys]
            results = point.checks.results
            exceedance[row] = max((each.exceedance for each in results), default=0.0)
        return Assessed(objectives, exceedance, np.full(len(genes), -1), unsolved)

    def point(self, genes: tuple[int, ...]) -> DesignPoint:
        """Bring a design to rest and check it; errors as for `solve_system`."""
        line = self.space.line(genes)
        return self._of(line, self.case.made_of(line.segments), genes)

    def present(self) -> DesignPoint:
        """Check the lines of the file."""
        design = self.case.design
        line = Line([self.case.segment_for(k) for k in range(len(design.groups))])
        return self._of(line, self.case, ())

    def _of(self, line: Line, network: Network, genes: tuple[int, ...]) -> DesignPoint:
        rest = at_rest(network)
        checks = check_network(network, rest)
        lines = network.every_line
        segments = [segment for each in lines for segment in each.segments]
        pulls = (each.anchor.tension for k, each in enumerate(rest.lines) if rest.is_anchored(k))
        values: Mapping[str, float] = {
            "mass": math.fsum(each.mass or 0.0 for each in lines),
            "offset": max((math.hypot(*each.offset) for each in rest.bodies), default=0.0),
            "cost": math.fsum(each.length * (each.price or 0.0) for each in segments),
            "length": math.fsum(each.length for each in lines),
            "anchor_load": max(pulls, default=0.0),
        }
        objectives = {OBJECTIVE_KEYS[name]: values[name] for name in self.names}
        return DesignPoint(line, network.anchor, genes, objectives, checks)

    def load_cases(self, best: DesignPoint) -> tuple[DesignLoadCase, ...]:
        """Its own loads alone."""
        del best
        force, height = math.hypot(*self.case.own_force), self.case.lowest_fairlead
        level = height if math.isfinite(height) else 0.0
        return (DesignLoadCase("load", "extreme", 0.0, force, level),)
