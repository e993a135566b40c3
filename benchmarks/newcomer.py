"""A newcomer's path, from ``git clone`` to a calculation note in the hand, stage by stage.

    python -m benchmarks.newcomer [--out benchmarks/results/newcomer.md]

Nothing is there but git, a Python and a package index: a fresh clone, an empty virtual environment
and an empty cache of compiled code. Beside it, in the same run, the peer: an empty environment and
``pip install MoorPy``. pip keeps the packages that it has fetched before in both alike.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from benchmarks.common import page

ROOT = Path(__file__).parents[1]
CASE = "cases/size-tanker/sizing.toml"
PIP = "pip install ."
PEER = "MoorPy"
AGAIN = "the same again"
LIMIT = 300.0
"""s: a newcomer who waits for longer has gone for coffee."""


def main() -> None:
    """Measure and print; fail where the path takes longer than it may."""
    total = [0.0]
    page(argparse.ArgumentParser(description=__doc__), lambda of: measured(total, of.smoke))
    if total[0] > LIMIT:
        sys.exit(f"the path takes longer than {LIMIT:g} s")


def measured(total: list[float], smoke: bool) -> list[str]:
    """Walk both paths; of a smoke the environment alone."""
    with tempfile.TemporaryDirectory() as folder:
        if smoke:
            made = once([sys.executable, "-m", "venv", "--without-pip", "ours"], Path(folder))
            return ["# A newcomer's path", "", f"An environment alone: {made:.1f} s."]
        ours, page_size = path(Path(folder))
        theirs = peer(Path(folder))
    total[0] = sum(ours.values())
    return report(ours, theirs, page_size)


def path(folder: Path) -> tuple[dict[str, float], int]:
    """Seconds of every stage from the clone to the page, and the size of the page in bytes."""
    clone, python = folder / "catopt", environment(folder / "ours")
    size = [str(python.parent / "catopt"), "size", "tanker", CASE, "--out", "answer"]
    seconds = {
        "git clone": once(["git", "clone", "-q", str(ROOT), str(clone)], folder),
        "python -m venv": once([sys.executable, "-m", "venv", str(folder / "ours")], folder),
        PIP: once([str(python), "-m", "pip", "install", "-q", "."], clone),
        f"catopt size tanker {CASE} --out answer": once(size, clone),
    }
    page = clone / "answer" / "note.html"
    seconds[AGAIN] = once(size, clone)
    return seconds, page.stat().st_size


def peer(folder: Path) -> dict[str, float]:
    """Seconds to an empty environment with the peer in it."""
    python = environment(folder / "theirs")
    return {
        "python -m venv": once([sys.executable, "-m", "venv", str(folder / "theirs")], folder),
        f"pip install {PEER}": once([str(python), "-m", "pip", "install", "-q", PEER], folder),
    }


def environment(folder: Path) -> Path:
    """Where the Python of a virtual environment stands once it is made."""
    windows = os.name == "nt"
    return folder / ("Scripts" if windows else "bin") / ("python.exe" if windows else "python")


def once(command: list[str], folder: Path) -> float:
    """Run a command as in a new shell; return its seconds."""
    kept = {key: value for key, value in os.environ.items() if not key.startswith("PYTHON")}
    kept.pop("VIRTUAL_ENV", None)
    start = time.perf_counter()
    subprocess.run(
        command,
        cwd=folder,
        env=kept | {"PIP_DISABLE_PIP_VERSION_CHECK": "1"},
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        check=True,
    )
    return time.perf_counter() - start


def report(ours: dict[str, float], theirs: dict[str, float], size: int) -> list[str]:
    """Lay the times out as a Markdown page."""
    total = sum(seconds for stage, seconds in ours.items() if stage != AGAIN)
    rows = [f"| {stage} | {seconds:.1f} |" for stage, seconds in ours.items() if stage != AGAIN]
    return [
        "# A newcomer's path: from git clone to the note of a tanker's mooring",
        "",
        "A fresh clone, an empty virtual environment, no compiled code yet.",
        "",
        "| stage | s |",
        "|---|---|",
        *rows,
        f"| **clone to page, {size / 1e3:.0f} kB** | **{total:.1f}** |",
        f"| {AGAIN} | {ours[AGAIN]:.1f} |",
        "",
        f"Of the path {100.0 * ours[PIP] / total:.0f} % are pip's.",
        "",
        f"An empty environment with {PEER} in it, in the same run: "
        f"{sum(theirs.values()):.1f} s; clone to page takes "
        f"{total / sum(theirs.values()):.2f} times as long. The limit is {LIMIT:g} s.",
    ]


if __name__ == "__main__":
    main()
