"""Solve a case: by the method wanted, under its load, or for what it seeks."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import replace
from typing import Final, Literal

from catopt.catenary.find import find_case
from catopt.catenary.solution import Solution
from catopt.catenary.solve import solve, under_case
from catopt.errors import InputError, refused
from catopt.model import Case, Load
from catopt.model.network import Network, require_case
from catopt.model.wear import diameter_loss
from catopt.words import Message

Method = Literal["closed-form", "pso"]


STRENGTH_OF_NEW: Final = "catenary.strength_of_new"
"""Key of what is said where wear is not taken off strengths."""


def solve_case(
    case: Case | Network,
    method: Method = "closed-form",
    *,
    progress: Callable[[int], None] | None = None,
) -> Solution:
    """Solve a case; errors as for `solve`, and FloatsUpError for a buoy above the water surface.

    When the case seeks something (`case.find`), the answer is the line with what was found. A case
    without load is solved under its first load case, with a warning that says so.

    Parameters
    ----------
    case : Case
        As read by `catopt.read_case`.
    method : {"closed-form", "pso"}
        The particle swarm takes what docs/theory.md says it carries, and refuses the rest.
    progress : callable, optional
        Called after each run of the swarm with the number of runs done.

    Raises
    ------
    InputError, NoEquilibriumError, NotConvergedError
        As for `solve`.
    FloatsUpError
        A buoy of the line would be above the water.

    Examples
    --------
    >>> import catopt
    >>> solution = catopt.solve_case(catopt.read_case("cases/buoy-9.5m/case.toml"))
    >>> f"{solution.span:.3f} m, {solution.fairlead.tension / 9806.65:.3f} tf"  # S1: 17.430, 0.446
    '17.430 m, 0.446 tf'
    """
    case = require_case(case)
    if case.site.is_in_air:
        if method == "pso":
            case.site.check_water()
        lifted, lift = case.clear_of_the_ground
        return solve_case(lifted).lowered(lift)
    case.site.check_level()
    if method == "pso":
        case.check_still_water()
    case, warnings = under_a_load(case)
    return _solved(case, method, progress).with_warnings(
        (*of_accepted(case), *warnings, *of_wear(case))
    )


def of_accepted(case: Case | Network) -> Iterator[Message]:
    """Say which ranges values of a case may go beyond."""
    if case.accept:
        yield Message("catenary.accepted", names=", ".join(case.accept))


def of_wear(case: Case) -> Iterator[Message]:
    """Say that strengths are those of the new line, where the checks take wear off them."""
    with suppress(InputError):  # a rate that is missing is for the checks to ask for
        lost = [
            diameter_loss(each, case.service)
            for each in case.line.segments
            if each.MBL is not None or each.proof_load is not None
        ]
        if any(lost):
            yield Message(STRENGTH_OF_NEW, loss=1e3 * max(lost))


def as_found(case: Case) -> Case:
    """Put what a case seeks in its place, so that it is an ordinary case."""
    if case.find is None:
        return case
    solution = solve_case(case)
    load = Load(horizontal_force=solution.horizontal_force)
    return replace(case, line=solution.line, load=load, find=None)


def under_a_load(case: Case) -> tuple[Case, tuple[str, ...]]:
    """Return the case under its first load case where it has no load, with the warning to give."""
    if case.load is not None or case.find is not None:
        return case, ()
    if not case.load_cases:
        wanted = Message("refused_motion.this_case_body_with_several")
        raise refused("system", Message("refused_motion.instead_of_load"), wanted)
    first, *others = case.load_cases
    if not others:
        return case.under(first), ()
    names = ", ".join(f'"{each.name}"' for each in others)
    warning = Message("catenary.first_load_case", name=first.name, count=len(others), others=names)
    return case.under(first), (warning,)


def _solved(case: Case, method: Method, progress: Callable[[int], None] | None) -> Solution:
    """Solve a case that has a load or seeks something."""
    if method == "pso":
        from catopt.catenary.swarm.solve import solve_case_by_swarm

        return under_case(solve_case_by_swarm(case, progress=progress), case)
    if case.find is not None:
        found = find_case(case)
        return under_case(found.solution, case).with_found(found.alone())
    assert case.load is not None
    if case.current_at_rest is not None:
        from catopt.catenary.in_current import solve_in_current

        return under_case(solve_in_current(case), case)
    return under_case(solve(case.line, **vars(case.load), **case.place), case)
