"""The seabed under the line: one that only pushes, and the source's that also holds.

A node on a rigid bed has its height given and a reaction R for its unknown, which is never below 0;
a bed of finite stiffness k per length and area of line pushes with R = k l (-z) on a node that
carries the length l. Coulomb's friction takes up to mu R along the bed (`friction`).
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final, Literal, NamedTuple, get_args

from catopt.arrays import Array
from catopt.model.kinds import Findings

FREE: Final = 0  # a node that hangs
ON_BED: Final = 1  # one that the bed pushes
HELD: Final = 2  # one that the bed holds in height both ways
ABSENT: Final = 3  # one under which there is no bed

SHARING: Final = 0  # a line whose bars share their weight where they touch down (`touchdown`)
HALVING: Final = 1  # one of which half of each bar's weight stays at either end
SLACK: Final = 2  # the same, and it hangs slack: its bars keep next to no tension, and do not rub

NO_FRICTION: Final = 0
PULLED: Final = 1
SPRING: Final = 2
LAID: Final = 3

FrictionLaw = Literal["pulled", "laid", "history"]
FRICTION_LAWS: tuple[str, ...] = get_args(FrictionLaw)


@dataclass(frozen=True)
class Bed:
    """A flat bed at height 0 that only pushes.

    Friction laws: ``"pulled"``: the line was last pulled towards the fairlead, so that friction is
    fully mobilised wherever tension is left, and takes off no more than there is. ``"laid"``: it
    was laid under a greater tension and slackened since, so that friction holds that in it: fully
    mobilised the other way, tension grows towards the anchor. ``"history"``: each node on the bed
    drags a spring that slips at mu R and remembers where it is.
    """

    normal_stiffness: float = math.inf  # force per length of line and per depth of penetration,
    # N/m2; infinite for a rigid bed, which no node passes
    friction_law: FrictionLaw = "pulled"
    tangential_stiffness: float = 1e6  # of the spring of "history", per length of line, N/m2

    def __post_init__(self) -> None:
        found = Findings("Bed")
        found.number("normal_stiffness", self.normal_stiffness, "N/m2", above=0.0, infinite=True)
        found.number("tangential_stiffness", self.tangential_stiffness, "N/m2", above=0.0)
        found.word("friction_law", self.friction_law, FRICTION_LAWS)
        found.raise_if_any()


@dataclass(frozen=True)
class HeldBed:
    """The restraint of source S4, for reproducing its figures only: not how a bed works.

    Nodes near the anchor are held at height 0 both ways, so that the bed also pulls; there is no
    bed under the other nodes, and no friction.
    """

    grounded_length: float  # arc length from the anchor up to which nodes are held, m
    EA_multiplier: float = 1.0  # on every segment's EA

    def __post_init__(self) -> None:
        found = Findings("HeldBed")
        found.number("grounded_length", self.grounded_length, "m", at_least=0.0)
        found.number("EA_multiplier", self.EA_multiplier, "", above=0.0)
        found.raise_if_any()


class Ground(NamedTuple):
    """The bed as the kernels take it; arrays have the shape (nodes,)."""

    stiffness: Array  # of the bed under each node, normal to it, N/m; infinite where rigid
    friction: Array  # Coulomb coefficient: that of the bed, or of the point load on the node
    beside: Array  # (nodes, 2): what the bars towards the anchor and the fairlead, which rub with
    # the bed's coefficient, add to that where they lie, N; 0 without a point load of its own
    bed_friction: float  # Coulomb coefficient of the line itself
    law: int  # NO_FRICTION, PULLED, LAID or SPRING
    tangential: Array  # stiffness of each node's friction spring, N/m
    spring_foot: Array  # (nodes, 2): where that has its foot, m


def friction_sense(law: int) -> float:
    """Return 1.0 where friction takes tension off towards the anchor, -1.0 where it adds, or 0."""
    return 1.0 if law == PULLED else -1.0 if law == LAID else 0.0


def touches(contact: int, z: float, reaction: float, depth: float) -> int:
    """State of a node at the height z, m, under which a rigid bed would carry `reaction`, N.

    `depth`: penetration that is rounding, m.
    """
    if contact == FREE and z < -depth:
        return ON_BED
    if contact == ON_BED and reaction < 0.0 and z >= -depth:
        return FREE
    return contact
