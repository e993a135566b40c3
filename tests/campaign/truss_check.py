"""A campaign over networks by both models: the truss model beside the closed form.

    python -m tests.campaign --lines 0 --trusses 200

Networks that the closed form refuses are looked at by `network_check`.
"""

from __future__ import annotations

from collections.abc import Callable

from catopt.errors import FloatsUpError, NoEquilibriumError, NotConvergedError
from catopt.mooring.fixed_body import at_rest
from catopt.verify.case import verify_network
from tests.campaign.networks import counted, drawn

ELEMENTS = 40
"""Bars of the coarsest mesh of each line."""

TOLERANCE = 1e-4
"""Part of tensions and lengths within which the models agree."""

FINER = 3
"""How many times as many bars are tried where the first meshes show no agreement."""


def judge(seed: int) -> tuple[str, str]:
    """Solve one network by both models; what became of it, and what is wrong."""
    network = drawn(seed)
    try:
        closed = at_rest(network)
    except (NoEquilibriumError, FloatsUpError):
        return "refused", ""
    try:
        for finer in (1, FINER):
            part = verify_network(network, elements=ELEMENTS * finer, tolerance=TOLERANCE)
            if part.verdict == "agrees":
                return "agrees", ""
    except NotConvergedError as error:
        # A float straight above its anchor: what piles up there has no stiffness in the truss.
        if any(closed.joints.lost) and any(each.regime == "slack" for each in closed.lines):
            return "not at rest", ""
        return "not at rest", str(error)
    return part.verdict, f"{part.worst.quantity} by {part.worst.gap:.1e}"


def run(count: int, first: int, tell: Callable[[str], object]) -> int:
    """Judge networks; tell of each that failed, and how many came to what. How many failed."""

    def judged(seed: int) -> tuple[str, str]:
        came, fault = judge(seed)
        return came, fault and f"{came}: {fault}"

    return counted(count, first, tell, judged)
