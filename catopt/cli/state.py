"""The state of a case that ``--load-case`` asks for."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from catopt.model import Case

__all__ = ["in_state"]


def in_state(case: Case, name: str | None) -> Case:
    """Return a case under one of its load cases.

    Parameters
    ----------
    case : Case
        Returned as it is where no name is given.
    name : str or None
        Of the load case.

    Raises
    ------
    InputError
        The case has no such load case, or it seeks something.
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
