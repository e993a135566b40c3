"""The case that a command computes: with codes that are known, in the state that it asks for."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from catopt.model import Case


def with_known_codes(case: Case) -> Case:
    """Return a case whose codes all are known and allowed, also where none is judged by."""
    if case.checks.codes:
        from catopt.checks.profiles import profiles_of

        profiles_of(case.checks)
    return case


def in_state(case: Case, name: str | None) -> Case:
    """Return a case under the load case that ``--load-case`` names; as it is without a name.

    Raises InputError where the case has no such load case, or seeks something.
    """
    from catopt.errors import InputError, Problem
    from catopt.units import as_written

    if name is None:
        return case
    states = {state.name: state for state in case.load_cases}
    if name in states and case.find is None:
        return case.under(states[name])
    allowed = "the case has no [[load_cases]]"
    if name in states and case.find is not None:
        allowed = f"the case seeks something, {case.find.quantity}; leave out the option or [find]"
    elif states:
        allowed = f"one of {', '.join(states)} is wanted"
    raise InputError([Problem("--load-case", as_written(name), allowed)], "options")
