"""Files that commands are typed with: the cases beside these tests, and decks of others."""

from __future__ import annotations

from pathlib import Path

from tests.catalogue.test_user_families import GOOD
from tests.decks.own import BRIDLE, MAP, MAP_BRIDLE, MOORDYN

from .conftest import CASES, OWN

RAOS = CASES / "dynamic-chain-56m"
OC3 = {
    "types": "0.09 77.7066 384.243e6 0.001 0 0 0 0", "anchor": "853.87 0",
    "fairlead": "5.2 0 -70", "length": 902.2,
}  # fmt: skip

FILES = {path.name: path.read_text("utf-8") for path in sorted(OWN.iterdir())} | {
    # Waves of the example that are shorter than its table of RAOs goes.
    "raos.toml": (RAOS / "case.toml")
    .read_text("utf-8")
    .replace('"5 min"', '"20 s"\nelements = 10')
    .replace('period = "9 s"', 'period = "4 s"'),
    "rao.csv": (RAOS / "rao.csv").read_text("utf-8"),
    "oc3.txt": MOORDYN,
    "oc3.map": MAP.format(**OC3),
    "bridle.txt": BRIDLE,
    "bridle.map": MAP_BRIDLE,
    "own-families.toml": GOOD,
}
LED, SHIP, PUSHED, FORCE = (
    FILES[name] for name in ("led.toml", "ship.csv", "pushed.toml", "force.csv")
)


def write_files(folder: Path) -> None:
    for name, text in FILES.items():
        (folder / name).write_text(text, encoding="utf-8")
