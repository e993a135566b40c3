"""The question turned round: what is sought instead of how the line hangs."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass
from typing import Annotated, Literal, get_args

from catopt.errors import Problem
from catopt.model.kinds import Length, OneSegment, Uplift, Whole
from catopt.model.load import LOADS
from catopt.model.validity import Checked, Findings
from catopt.words import Message

FindQuantity = Literal["length", "clump_weight", "touchdown_force", "limit_force"]
FIND_QUANTITIES: tuple[str, ...] = get_args(FindQuantity)

FORCES = ("touchdown_force", "limit_force")
"""Quantities that are a horizontal force, so that neither load nor condition is given."""
CONDITIONS = ("anchor_angle", "grounded_length")


@dataclass(frozen=True)
class Find(Checked):
    """What is sought, and the condition that it has to meet."""

    quantity: FindQuantity
    """``"length"`` of a segment or ``"clump_weight"`` of a point load under the case's load;
    ``"touchdown_force"``, the horizontal force at which the touchdown reaches the anchor;
    ``"limit_force"``, the one at which a segment reaches MBL over the safety factor."""
    segment: OneSegment | None = None
    """Which one, counted from 1 at the anchor. None is, for a length, the last one, at the
    fairlead; for a limit force, whichever reaches its limit first."""
    point_load: Annotated[int, Whole("point_load", example=1)] | None = None
    """For a clump weight: which one, counted from 1 at the anchor; None is the first."""
    anchor_angle: Uplift | None = None
    """For length and clump weight: inclination at the anchor, rad."""
    grounded_length: Length | None = None
    """For length, instead of the angle: unstretched length on the bed, m."""

    def _check(self, found: Findings) -> None:
        found.check()
        self._check_keys(found)

    def _check_keys(self, found: Findings) -> None:
        """Note a condition too few or too many, and keys that this quantity does not heed."""
        given = [key for key in CONDITIONS if getattr(self, key) is not None]
        what = " and ".join(given) or "no condition"
        if self.quantity == "length" and len(given) != 1:
            found.add("find", what, Message("refused.one_condition"))
        elif self.quantity == "clump_weight" and given != ["anchor_angle"]:
            found.add("find", what, Message("refused.anchor_angle_only"))
        elif self.seeks_force and given:
            found.add("find", what, Message("refused.takes_no_condition", what=self.quantity))
        if self.segment is not None and self.quantity not in ("length", "limit_force"):
            allowed = Message("refused.with_length_or_limit")
            found.add("segment", str(self.segment), allowed)
        if self.point_load is not None and self.quantity != "clump_weight":
            found.add(
                "point_load", str(self.point_load), Message("refused.goes_with", way="clump_weight")
            )

    @property
    def seeks_force(self) -> bool:
        """Whether a horizontal force is sought, so that neither load nor condition is given."""
        return self.quantity in FORCES


def inconsistencies(
    find: Find | None,
    *,
    load: Collection[str] | None,
    MBL_known: Sequence[bool],
    point_loads: int,
    anchor_height: float,
    has_load_cases: bool = False,
) -> list[Problem]:
    """List what does not fit between what is sought and the rest of a case.

    `load` has the keys of the load that are given, None without a load; load cases stand in for it
    where nothing is sought. Segments and point loads count from 1 in keys as ``find.segment``.
    """
    found = Findings()
    seeks_force = find is not None and find.seeks_force
    seeks_length = find is not None and find.quantity == "length"
    if load is None and not seeks_force and not (has_load_cases and find is None):
        keys = "horizontal_force, fairlead_tension" if seeks_length else ", ".join(LOADS)
        table = Message("refused.table_with_one_of", line="[load]", keys=keys)
        found.add("load", "", Message("refused.missing", wanted=table))
    if find is None:
        return found.problems
    if load is not None and seeks_force:
        allowed = Message("refused.seeks_force", what=find.quantity)
        found.add("load", " and ".join(load) or "a load", allowed)
    if seeks_length and load is not None and "span" in load:
        allowed = Message("refused.length_sought")
        found.add("load.span", "a span", allowed)
    _count(found, "segment", find.segment, len(MBL_known))
    if find.quantity == "clump_weight" and point_loads == 0:
        found.add("find.quantity", find.quantity, Message("refused.no_point_load"))
    else:
        _count(found, "point_load", find.point_load, point_loads)
    if find.quantity == "touchdown_force" and anchor_height > 0.0:
        allowed = Message("refused.on_bed")
        found.add("line.anchor_height", f"{anchor_height:g} m", allowed)
    if find.quantity == "limit_force":
        _strength(found, find.segment, MBL_known)
    return found.problems


def _count(found: Findings, key: str, number: int | None, count: int) -> None:
    if number is not None and number > count:
        said = Message(f"refused.has_{key}" if count else f"refused.has_no_{key}", count=count)
        found.add(f"find.{key}", str(number), said)


def _strength(found: Findings, segment: int | None, MBL_known: Sequence[bool]) -> None:
    """Note when no segment in question has a minimum breaking load."""
    if segment is None and not any(MBL_known):
        found.add("find.quantity", "limit_force", Message("refused.needs_MBL"))
    elif segment is not None and segment <= len(MBL_known) and not MBL_known[segment - 1]:
        found.add(f"line.segments[{segment - 1}].MBL", "", Message("refused.limit_force_needs"))
