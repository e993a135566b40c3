"""Lines of public decks, by the numbers that decide their statics."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

__all__ = ["PUBLIC", "deck_text"]

PUBLIC: list[dict[str, Any]] = tomllib.loads(
    (Path(__file__).parent / "public.toml").read_text("utf-8")
)["deck"]


def deck_text(of: dict[str, Any]) -> str:
    """Write a line as a MoorDyn deck, as short as it can be."""
    g, rho, depth = of["site"]
    rows = ["one line", "--- LINE TYPES ---", "names", "units"]
    for number, (d, m, EA) in enumerate(of["types"]):
        rows.append(f"t{number} {d!r} {m!r} {EA!r} 0 0 1 1 0 0")
    rows += ["--- POINTS ---", "names", "units"]
    places = ["Fixed", *("Free" for _ in of["pieces"][1:]), "Coupled"]
    hung = [(0.0, 0.0), *((m, v) for _, _, m, v in of["pieces"])]
    for number, (kind, (m, v)) in enumerate(zip(places, hung, strict=True)):
        x, y, z = (
            a + (b - a) * number / len(of["pieces"])
            for a, b in zip(of["anchor"], of["fairlead"], strict=True)
        )
        rows.append(f"{number + 1} {kind} {x!r} {y!r} {z!r} {m!r} {v!r} 0 0")
    rows += ["--- LINES ---", "names", "units"]
    for number, (kind, length, _, _) in enumerate(of["pieces"], start=1):
        rows.append(f"{number} t{kind} {number} {number + 1} {length!r} 10 -")
    rows += ["--- OPTIONS ---", f"{g!r} g", f"{rho!r} rho", f"{depth!r} WtrDpth", "--- END ---", ""]
    return "\n".join(rows)
