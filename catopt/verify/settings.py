"""How finely and how strictly the two models are compared; light, for the command line."""

from __future__ import annotations

from catopt.model.kinds import Findings

ELEMENTS = 200
"""Bars of a line on the coarsest mesh."""

TOLERANCE = 1e-4
"""Of the fairlead tension, of the line's length, in rad."""

_FEWEST, _MOST = 4, 20000
_LOOSEST = 0.1


def check_settings(elements: int, tolerance: float, *, source: str, prefix: str = "") -> None:
    """Refuse settings that are out of range, all at once.

    `tolerance`: largest difference that counts as agreement; `source`, `prefix`: who was given
    them, and what stands before their names there, such as ``"--"``. Raises InputError with every
    one that is wrong.
    """
    found = Findings(source)
    found.number(f"{prefix}elements", elements, "", at_least=_FEWEST, at_most=_MOST)
    found.number(f"{prefix}tolerance", tolerance, "", above=0.0, at_most=_LOOSEST)
    found.raise_if_any()
