"""Codes that a case names are known, also where a command does not judge by them."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from catopt.model import Case

__all__ = ["with_known_codes"]


def with_known_codes(case: Case) -> Case:
    """Return a case whose codes all are known.

    Raises
    ------
    InputError
        With every name that is no profile's, or whose profile the case does not allow.
    """
    if case.checks.codes:
        from catopt.checks.profiles import profiles_of

        profiles_of(case.checks)
    return case
