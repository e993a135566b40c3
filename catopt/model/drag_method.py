"""How the drag and the added mass of a segment are found: given, or by its roughness."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Final, Literal, get_args

from catopt.errors import Problem

DragMethod = Literal["given", "roughness"]
DRAG_METHODS: tuple[str, ...] = get_args(DragMethod)

STEADY_FROM: Final = 12.0
"""KC from which S4 has the wake amplification in a graph (figure 2.10), which is not at hand."""

_GIVEN = ("drag_normal", "drag_axial", "added_mass_normal")
_ROUGH = ("roughness", "keulegan_carpenter", "wake_amplification")


def drag_misfits(given: Mapping[str, Any]) -> list[Problem]:
    """List what does not go with the way in which a segment's drag is found.

    By its name in `Segment`, what the segment is given; a value that cannot be read is None.
    """
    if given.get("drag_method") != "roughness":
        allowed = 'goes with drag_method = "roughness", which is missing'
        return [Problem(key, repr(given[key]), allowed) for key in _ROUGH if key in given]
    problems = [
        Problem(key, repr(given[key]), "follows from the roughness; leave it out")
        for key in _GIVEN
        if key in given
    ]
    if str(given.get("component") or "").startswith("chain"):
        allowed = "is for round wires and ropes; a chain is none: give drag_normal, or leave it out"
        problems.append(Problem("drag_method", "'roughness'", allowed))
    problems += [
        Problem(key, "", 'missing; drag_method = "roughness" needs it')
        for key in _ROUGH[:2]
        if key not in given
    ]
    KC = given.get("keulegan_carpenter")
    if KC is not None and KC >= STEADY_FROM and "wake_amplification" not in given:
        graph = f"missing; for a KC of {STEADY_FROM:g} or more S4 has it in a graph (figure 2.10)"
        problems.append(Problem("wake_amplification", "", graph))
    return problems
