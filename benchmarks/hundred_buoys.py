"""Random buoys sized in motion, and what is recommended run again with its proof.

    python -m benchmarks.hundred_buoys [--seed 1] [--count 100] [--minutes 600] [--rows FILE]

Each is `catopt size buoy ... --in-motion` and then `catopt verify DIR/case.toml --dynamic`, as a
user types them; buoy number k of a seed is the same whatever was run before. It passes where the
verdict of `verify` says so, and is refused where the sizing says why it has no answer; the rest is
a fault. Each row is written to the file as it is made: what is in it is not run again, so that a
run which is stopped goes on where it was. It stops by itself where its minutes are over.
"""

from __future__ import annotations

import argparse
import csv
import json
import resource
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Final

import numpy as np

from benchmarks.common import RESULTS, page

BUOYS: Final = (
    *("pillar 1.2 m", "pillar 1.8 m", "pillar 2.4 m", "pillar 3.0 m", "spar 0.8 m"),
    *("T-1000l-1.24m", "T-1800l-1.24m", "T-2500l-1.85m", "T-5000l-2.4m", "T-9000l-3.0m"),
    *("LT-9000l-3.0m", "SP-3200l-1.2m", "2S5PL", "2S5PL +2"),
)
SOILS: Final = ("", "", "rock", "sand", "gravel", "stiff clay", "mud")
"""Empty: the friction of the code."""

COLUMNS: Final = ("seed", "number", "given", "found", "outcome", "said", "processor")
FAULT: Final = "FAULT"
PASSES: Final = "passes"
REFUSED: Final = "refused"
REFUSALS: Final = (2, 3)
"""Exit status of an input that is refused, and of a right one without an answer."""


def main() -> None:
    """Run and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rows", type=Path, help="file of the rows that were made")
    page(parser, report, seed=(1, 1), count=(100, 0), minutes=(600.0, 1.0))


def report(of: argparse.Namespace) -> Iterator[str]:
    """Yield the page: what came of how many, and each of them."""
    path = of.rows or RESULTS / "hundred_buoys.csv"
    rows = {} if of.smoke else _read(path, of.seed)
    until = time.monotonic() + 60.0 * of.minutes
    for number in range(of.count):
        if number not in rows and time.monotonic() < until:
            rows[number] = _made(of.seed, number)
            _append(path, rows[number])
    made = [rows[number] for number in sorted(rows) if number < of.count]
    counts = Counter(each["outcome"] for each in made)
    yield "# Random buoys sized in motion, verified with the proof"
    yield ""
    said = ", ".join(f"{counts[word]} {word}" for word in sorted(counts)) or "none"
    cost = sum(float(each["processor"]) for each in made)
    yield f"Seed {of.seed}, {len(made)} of {of.count} run: {said}; {cost:.0f} s of processor."
    yield ""
    yield "| | given | recommended | outcome | what was said |"
    yield "|---|---|---|---|---|"
    for each in made:
        cells = ("number", "given", "found", "outcome", "said")
        yield "| " + " | ".join(each[cell].replace("|", "/") for cell in cells) + " |"


def drawn(seed: int, number: int) -> list[str]:
    """Draw a buoy and its place: the words of the command."""
    draw = np.random.default_rng((seed, number))
    depth = float(np.exp(draw.uniform(np.log(4.0), np.log(60.0))))
    hs = float(draw.uniform(0.5, min(4.0, 0.35 * depth)))
    given = {
        "depth": f"{depth:.1f} m",
        "hs": f"{hs:.2f} m",
        "current": f"{draw.uniform(0.1, 2.5):.2f} m/s",
        "wind": f"{draw.uniform(10.0, 35.0):.1f} m/s",
        "soil": SOILS[draw.integers(len(SOILS))],
    }
    options = [word for key, text in given.items() if text for word in (f"--{key}", text)]
    return [BUOYS[draw.integers(len(BUOYS))], *options]


def _made(seed: int, number: int) -> dict[str, str]:
    """Size one and verify it."""
    words, began = drawn(seed, number), _processor()
    with tempfile.TemporaryDirectory() as out:
        sized = _run("size", "buoy", *words, "--in-motion", "--out", out, "--json")
        if sized.returncode:
            outcome = REFUSED if sized.returncode in REFUSALS else FAULT
            found, said = "", sized.stderr or sized.stdout
        else:
            found = json.loads(sized.stdout)["one_line"]
            run = _run("verify", str(Path(out, "case.toml")), "--dynamic", "--json")
            try:
                judged = json.loads(run.stdout)["verdict"]
            except (ValueError, KeyError):
                judged = {"colour": "none", "said": run.stderr or run.stdout}
            outcome = PASSES if judged["colour"] in ("green", "amber") else FAULT
            said = judged["said"]
    texts = (seed, number, " ".join(words), found, outcome, " ".join(said.split())[:300])
    return dict(zip(COLUMNS, [*map(str, texts), f"{_processor() - began:.0f}"], strict=True))


def _run(*words: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "catopt", *words]
    return subprocess.run(command, capture_output=True, text=True, check=False)


def _processor() -> float:
    spent = resource.getrusage(resource.RUSAGE_CHILDREN)
    return spent.ru_utime + spent.ru_stime


def _read(path: Path, seed: int) -> dict[int, dict[str, str]]:
    if not path.exists():
        return {}
    with path.open(encoding="utf-8", newline="") as file:
        rows = [each for each in csv.DictReader(file) if each["seed"] == str(seed)]
    return {int(each["number"]): each for each in rows}


def _append(path: Path, row: dict[str, str]) -> None:
    is_new = not path.exists()
    with path.open("a", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS)
        if is_new:
            writer.writeheader()
        writer.writerow(row)


if __name__ == "__main__":
    main()
