"""Twenty tankers as sized in motion, beside the cable and the anchor that each carries.

    python -m benchmarks.ships [--out benchmarks/results/ships.md]

Each lies at the depth stated in the weather that a sizing takes if nothing is said (wind of 25 m/s
over 30 s, current of 1 m/s, Hs of 2 m), judged in motion as by default. Practice is her equipment
number (UR A1). The last column is the wind over 30 s from ahead, without sea and current, whose
force at rest is what her own stockless anchor holds in sand: sailors see anchors drag from some
20 m/s on, in motion. That the static figure is far above this is why a ship is judged in motion.
"""

from __future__ import annotations

import argparse
import math
import time
from collections.abc import Iterator
from itertools import chain
from typing import Any

import catopt
from benchmarks.common import page
from catopt.catalogue.practice import EquipmentRow, equipment_rows
from catopt.errors import CatoptError
from catopt.loads.drag_anchor import holding_capacity, masses_sold

SHIPS = (
    *((5_000, 12.0), (7_500, 14.0), (10_000, 15.0), (15_000, 18.0), (20_000, 15.0)),
    *((25_000, 20.0), (30_000, 20.0), (40_000, 20.0), (50_000, 20.0), (60_000, 25.0)),
    *((70_000, 25.0), (80_000, 25.0), (100_000, 25.0), (120_000, 30.0), (150_000, 30.0)),
    *((180_000, 30.0), (200_000, 35.0), (250_000, 35.0), (280_000, 40.0), (300_000, 35.0)),
)
"""DWT, t, and depth, m."""


def main() -> None:
    """Run and print."""
    page(argparse.ArgumentParser(description=__doc__), lambda of: report(of.smoke))


def report(smoke: bool) -> Iterator[str]:
    """Yield the page; of a smoke one ship at rest."""
    began = time.process_time()
    yield "# Tankers at anchor beside their own cable"
    yield ""
    yield (
        "| DWT (t) | depth (m) | catopt, in motion | anchor (t) | tension, 3 h, kN (90 %) "
        "| of the allowable | her own cable, anchor | her own size in motion | wind that drags "
        "her own anchor at rest, from ahead (m/s) |"
    )
    yield "|---|---|---|---|---|---|---|---|---|"
    own = answered = 0
    for dwt, depth in SHIPS[:1] if smoke else SHIPS:
        options: dict[str, Any] = {"at_rest": True} if smoke else {}
        try:
            of = catopt.size_tanker(dwt=f"{dwt} t", depth=depth, **options).to_dict()
        except CatoptError as error:
            yield f"| {dwt:,} | {depth:g} | NO ANSWER: {error.message} | | | | | | |"
            continue
        answered += 1
        own += bool(((of["in_motion"] or {}).get("own") or {}).get("passes"))
        yield f"| {dwt:,} | {depth:g} | {_row(of)} |"
    yield ""
    yield (
        f"Of {answered} with an answer {own} are held by a line of the size of their own cable. "
        f"{time.process_time() - began:.0f} s of processor."
    )


def _row(of: dict[str, Any]) -> str:
    line, moved, anchor = of["chain"], of["in_motion"], of["drag_anchor"]
    cells = [f"{1e3 * line['nominal_diameter_m']:g} mm x {line['length_m']:g} m"]
    cells.append(f"{anchor['mass_kg'] / 1e3:g} {anchor['anchor']}")
    if moved is None:
        cells += ["not run", ""]
    else:
        low, high = moved["interval_N"]
        most = moved["most_probable_tension_N"]
        cells.append(f"{most / 1e3:.0f} ({low / 1e3:.0f} to {high / 1e3:.0f})")
        used = max(each["utilisation"] for each in moved["checks"] if each["kind"] == "tension")
        cells.append(f"{used:.0%}")
    cells.append(of["practice"].partition(": ")[2] or of["practice"])
    cells.append(_own(moved))
    cells.append(_drags(of))
    return " | ".join(cells)


def _own(moved: dict[str, Any] | None) -> str:
    """Say what the line of the size of her own cable came to."""
    own = None if moved is None else moved["own"]
    if own is None:
        return "not run"
    size = f"{1e3 * own['nominal_diameter_m']:g} mm x {own['length_m']:g} m"
    return f"{size} {'passes' if own['passes'] else 'fails: ' + own['fails']}"


def _drags(of: dict[str, Any]) -> str:
    """Give the wind from ahead whose force at rest is what her own anchor holds, m/s."""
    row = _equipment(of)
    if row is None:
        return "no row of her number"
    sold = masses_sold("stockless")
    if not sold[0] <= row.stockless <= sold[-1]:
        return "no curve"
    holds = holding_capacity("stockless", "sand", row.stockless).capacity
    parts = chain.from_iterable(each["parts"] for each in of["loads"])
    pieces = chain.from_iterable(each["components"] for each in parts)
    winds = [each for each in pieces if each["kind"] == "wind" and each["axis"] == "surge"]
    most = max(winds, key=lambda each: abs(each["force_N"]))
    speed = next(each["value"] for each in most["numbers"] if each["symbol"] == "V")
    return f"{speed * math.sqrt(holds / abs(most['force_N'])):.0f}"


def _equipment(of: dict[str, Any]) -> EquipmentRow | None:
    """Find the row of the table that her practice is from, by the number that it names."""
    _, _, after = of["practice"].rpartition("(EN ")
    number = float(after.rstrip(")").replace(",", "").split(")")[0])
    return next((each for each in equipment_rows() if each.above < number <= each.up_to), None)


if __name__ == "__main__":
    main()
