"""What ``catopt loads --json`` prints."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from catopt.loads.component import Loads
from catopt.loads.weathervane import ShipHeading
from catopt.records import Record


@dataclass(frozen=True)
class ComparedLoads(Record):
    """Horizontal forces of wind, current and waves on a buoy or a ship, each with its formula.

    Its source stands beside it.
    """

    SCHEMA = "catopt.loads/1"
    DOCUMENT = (
        "loads.title loads.horizontal_force loads.all_along=along_N loads.all_surge=surge_N "
        "loads.all_sway=sway_N loads.components loads.assumptions loads.recalled loads.warnings "
        "loads.method others headings?"
    )

    loads: Loads
    others: tuple[ComparedLoads, ...] = ()
    """The same by every other method that applies, for comparison; of a buoy, none."""
    headings: tuple[ShipHeading, ...] | None = None
    """Conditions, directions and headings that were computed, of which the largest force is laid
    out; absent where there is one."""


def loads_document(of: Loads, *others: Loads, lyings: Sequence[ShipHeading] = ()) -> dict[str, Any]:
    """Lay loads out for JSON, in SI: others are by other methods, of the lyings it is the worst."""
    return ComparedLoads(of, tuple(map(ComparedLoads, others)), tuple(lyings) or None).to_dict()
