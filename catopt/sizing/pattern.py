"""Several equal lines around a body: the rule of practice, and the equilibrium that checks it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, Final, NamedTuple

from catopt.catenary.solve import solve
from catopt.errors import InputError, NoAnswerError
from catopt.model import Case, Line, System
from catopt.mooring.line_out import one_line_out
from catopt.mooring.sharing_rule import load_sharing_factor
from catopt.mooring.solution import SystemSolution
from catopt.mooring.solve import solve_system
from catopt.ties import largest
from catopt.words import Message, Sentence

_DIRECTIONS: Final = 3
"""From against a line to half way to the next one; the rest follows by symmetry."""


class BodyState(NamedTuple):
    """A load case of the body."""

    load_case: str
    force: float  # on the body, N
    fairlead_height: float  # above the seabed, m


@dataclass(frozen=True)
class AtRest:
    """The body at rest under the force from its hardest side."""

    # between the most loaded line, without one between line 1, and where the force comes from, rad
    direction: float
    line_force: float  # horizontal, of the most loaded line at the fairlead, N
    tension: float  # of that line at the fairlead, N
    # of the body from its place with all lines under no load, m: the largest, wherever the force
    # comes from and whichever line is gone
    offset: float
    pull: float  # the largest of the lines together downwards on the body, N


@dataclass(frozen=True)
class WithoutLine(AtRest):
    """The body at rest anew without one of its lines."""

    missing: int  # the line that is gone, from 1: the force comes nearest to line 1


@dataclass(frozen=True)
class PatternState(AtRest):
    """The body at rest in one load case."""

    load_case: str
    force: float  # on the body, N
    # of the most loaded line by the rule of practice, N; None where the rule wants another number
    rule_force: float | None
    fairlead_height: float  # above the seabed, m
    line_out: WithoutLine  # the same load case with any one line gone


@dataclass(frozen=True)
class Pattern:
    """A symmetric pattern of equal lines."""

    lines: int  # how many
    pretension: float  # horizontal, of every line under no load, at high water without a crest, N
    anchor_radius: float  # from the body to the anchors, m
    states: tuple[PatternState, ...]  # one for each load case
    system: System  # under the load case of the largest force in a line
    warnings: tuple[str, ...] = ()

    @property
    def hardest(self) -> PatternState:
        """The load case of the largest horizontal force in a line."""
        return largest(self.states, lambda state: state.line_force)

    @property
    def largest_pull(self) -> float:
        """Of all lines downwards on the body, with each there or one gone, N."""
        return max(max(state.pull, state.line_out.pull) for state in self.states)


def shared_force(force: float, lines: int) -> float:
    """Estimate the horizontal force of the most loaded of 3 or more lines, N.

    The rule of practice of S4, F = FT/(N/4), where it applies; for other numbers of lines F =
    4 FT/N, and never more than all of it. It is where the sizing begins: the equilibrium decides.
    """
    rule = _rule(force, lines)
    return min(force, 4.0 * force / lines) if rule is None else rule


def pattern(
    line: Line,
    lines: int,
    states: Sequence[BodyState],
    *,
    pretension: float,
    still_height: float,
    seabed_friction: float = 0.0,
) -> Pattern:
    """Solve the body at rest in every load case, under forces from the sides that count.

    The lines are evenly spaced; the pretension is the horizontal force under no load, N, with the
    fairlead at `still_height`, m. Raises what `solve_system` raises.
    """
    reach = solve(
        line, height=still_height, horizontal_force=pretension, seabed_friction=seabed_friction
    ).span
    azimuths = [2.0 * math.pi * k / lines for k in range(lines)]
    base = System.around(
        line,
        azimuths=azimuths,
        anchor_radius=reach,
        fairlead_height=still_height,
        seabed_friction=seabed_friction,
    )
    hardest: list[tuple[PatternState, SystemSolution]] = [
        _hardest(base.raised(state.fairlead_height - still_height), state, lines)
        for state in states
    ]
    worst = largest(hardest, lambda each: each[0].line_force)
    return Pattern(
        lines,
        pretension,
        reach,
        tuple(state for state, _ in hardest),
        worst[1].system,
        tuple(dict.fromkeys(Sentence(w) for _, solution in hardest for w in solution.warnings)),
    )


def system_case(case: Case, of: Pattern) -> Case:
    """Make the case of the whole pattern, for ``catopt system``; it has the hardest load case."""
    state = of.hardest
    rise = state.fairlead_height - case.fairlead_height
    return replace(
        case,
        title=f"{case.title}: {of.lines} lines, {state.load_case}",
        site=replace(case.site, water_depth=case.site.water_depth + rise),
        fairlead_height=state.fairlead_height,
        load_cases=(),
        design=None,
        system=of.system,
    )


class _Solved(NamedTuple):
    """The body under the force from one side, rad off line 1, and its offset, m."""

    off: float
    solution: SystemSolution
    offset: float
    missing: int = 0


def _hardest(system: System, state: BodyState, lines: int) -> tuple[PatternState, SystemSolution]:
    """Let the force come from against a line, and on to half way to the next one."""
    pushed = [
        (off, system.under(_from(off, state.force)))
        for off in (math.pi / lines * step / (_DIRECTIONS - 1) for step in range(_DIRECTIONS))
    ]
    solutions = [(off, solve_system(each)) for off, each in pushed]
    worst, figures = _worst([_Solved(*each, math.hypot(*each[1].offset)) for each in solutions])
    made = PatternState(
        **figures,
        **state._asdict(),
        rule_force=_rule(state.force, lines),
        line_out=_without_line(pushed, state.load_case),
    )
    return made, worst.solution


def _worst(found: Sequence[_Solved]) -> tuple[_Solved, dict[str, Any]]:
    """Pick the side of the largest force in a line, with the figures of `AtRest`."""
    worst = largest(found, lambda each: _line_force(each.solution))
    return worst, {
        "direction": worst.off,
        "line_force": _line_force(worst.solution),
        "tension": max(line.tension for line in worst.solution.lines),
        "offset": max(each.offset for each in found),
        "pull": max(_pull(each.solution) for each in found),
    }


def _from(off: float, force: float) -> tuple[float, float]:
    """Force on the body from a direction off that of the first line, N."""
    towards = math.pi + off
    return force * math.cos(towards), force * math.sin(towards) if off else 0.0


def _without_line(pushed: Sequence[tuple[float, System]], load_case: str) -> WithoutLine:
    """Take each line away under the force from each side; what symmetry adds is the same again."""
    found = []
    for off, system in pushed:
        for each in one_line_out(system):
            if each.solution is None or each.response is None:
                number, why = each.missing + 1, each.refusal
                raise NoAnswerError(
                    Message("sizing.no_rest", number=number, load_case=load_case, why=why)
                )
            found.append(_Solved(off, each.solution, each.response.offset, each.missing + 1))
    worst, figures = _worst(found)
    return WithoutLine(**figures, missing=worst.missing)


def _rule(force: float, lines: int) -> float | None:
    try:
        return force / load_sharing_factor(lines)
    except InputError:
        return None


def _line_force(solution: SystemSolution) -> float:
    return max(line.horizontal_force for line in solution.lines)


def _pull(solution: SystemSolution) -> float:
    return math.fsum(line.solution.fairlead.vertical_force for line in solution.lines)
