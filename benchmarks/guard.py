"""The tree as it is beside another commit: built apart, run in turn, and what became slower.

    python -m benchmarks.guard REV [--rounds 7] [--built DIR] [--no-cold] [--smoke] [--out FILE]

REV is taken out of git into a folder of its own and installed in a virtual environment of its own;
both versions do each task of `guard_tasks.py` in turn, and of each the least processor time counts.
Ratios are this tree's time to the other's. Ends with status 1 where one is above 1.05, beyond what
the clock tells apart.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from benchmarks.common import ROOT, page, processor_time
from benchmarks.guard_tasks import TASKS

LIMIT = 1.05
COLD = {
    "`import catopt`": ("-c", "import catopt"),
    "`catopt solve`": ("-m", "catopt", "solve", "cases/buoy-9.5m/case.toml"),
    "`catopt system`": ("-m", "catopt", "system", "cases/fso-rang-dong/case.toml"),
    "`catopt size buoy`": ("-m", "catopt", "size", "buoy", "cases/size-buoy/sizing.toml"),
}
"""Commands from the shell: with code compiled before, and two of them with none."""
FIRST = ("`catopt system`", "`catopt size buoy`")
IN_SMOKE = ("`solve` in a loop, force given",)


@dataclass(frozen=True)
class Side:
    """A version: its Python, and the folder with its cases."""

    name: str
    python: Path
    root: Path
    cache: Path
    path: str

    @property
    def environment(self) -> dict[str, str]:
        """Variables with which it is run; each has its own cache."""
        kept = {key: value for key, value in os.environ.items() if not key.startswith("PYTHON")}
        return {**kept, "PYTHONPATH": self.path, "NUMBA_CACHE_DIR": str(self.cache),
                "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}  # fmt: skip


def main() -> None:
    """Build, run in turn, print and judge."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("revision", nargs="?", default="HEAD")
    parser.add_argument("--no-cold", action="store_true", help="leave commands from the shell out")
    parser.add_argument("--only", default="", help="tasks whose name has this in it")
    parser.add_argument("--built", type=Path, help="folder to build it in, and to keep it")
    slower: list[str] = []
    page(parser, lambda of: _report(of, slower), rounds=(7, 1))
    if slower and "--smoke" not in sys.argv:
        sys.exit("slower than before: " + "; ".join(slower))


def built(revision: str, folder: Path) -> Side:
    """Take a commit out of git and install it; a folder that holds it is taken as it is."""
    tree, venv = folder / "tree", folder / "venv"
    python = venv / "bin" / "python"
    if python.exists():
        return Side(revision, python, tree, folder / "cache", "")
    tree.mkdir(parents=True)
    archive = subprocess.run(
        ["git", "-C", str(ROOT), "archive", revision], check=True, capture_output=True
    ).stdout
    subprocess.run(["tar", "-x", "-C", str(tree)], input=archive, check=True)
    subprocess.run([sys.executable, "-m", "venv", str(venv)], check=True)
    subprocess.run([str(python), "-m", "pip", "install", "-q", str(tree)], check=True)
    return Side(revision, python, tree, folder / "cache", "")


def _report(of: argparse.Namespace, slower: list[str]) -> Iterator[str]:
    with tempfile.TemporaryDirectory() as folder:
        here = Side("this tree", Path(sys.executable), ROOT, Path(folder) / "here", str(ROOT))
        there = here if of.smoke else built(of.revision, of.built or Path(folder))
        yield f"# Beside {of.revision}"
        yield ""
        yield f"Least processor time of {of.rounds} runs each, taken in turn."
        yield ""
        yield f"| | {of.revision} | this tree | ratio |"
        yield "|---|---|---|---|"
        names = IN_SMOKE if of.smoke else [name for name in TASKS if of.only in name]
        for name in names:
            yield from _row(name, of.rounds, there, here, slower)
        if not of.smoke and not of.no_cold:
            yield from _from_the_shell(of.rounds, there, here, slower)


def _row(name: str, rounds: int, there: Side, here: Side, slower: list[str]) -> Iterator[str]:
    """Run a task in both, each a process that stays, until the least times of both settle."""
    compiled = "auto" if name.startswith("`solve`") else "always"
    sides = [_Served(there, compiled), _Served(here, compiled)]
    taken: list[list[str]] = [[], []]
    for _ in range(rounds):
        for side, own in zip(sides, taken, strict=True):
            own.append(side.ask(name))
    for side in sides:
        side.close()
    _, times, unit = TASKS[name]
    per = {"us": 1e6, "ms": 1e3}[unit] / times
    failed = [own[0] for own in taken if own[0].startswith("-")]
    if failed:
        yield f"| {name} | {_cell(taken[0], per, unit)} | {_cell(taken[1], per, unit)} | |"
        return
    before, now = (min(map(float, own)) for own in taken)
    yield _said(name, before * per, now * per, unit, slower)


def _cell(own: list[str], per: float, unit: str) -> str:
    return own[0][2:] if own[0].startswith("-") else f"{min(map(float, own)) * per:.3g} {unit}"


def _said(name: str, before: float, now: float, unit: str, slower: list[str]) -> str:
    ratio = now / before
    if ratio > LIMIT:
        slower.append(f"{name} {ratio:.2f}")
    return f"| {name} | {before:.3g} {unit} | {now:.3g} {unit} | {ratio:.2f} |"


class _Served:
    """A process of a version that does the tasks, compiled, or as that version decides."""

    def __init__(self, side: Side, compiled: str) -> None:
        self._process = subprocess.Popen(
            [str(side.python), str(ROOT / "benchmarks" / "guard_tasks.py")],
            cwd=side.root, env=side.environment | {"CATOPT_COMPILE": compiled}, text=True,
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
        )  # fmt: skip

    def ask(self, name: str) -> str:
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        self._process.stdin.write(name + "\n")
        self._process.stdin.flush()
        return self._process.stdout.readline().strip() or "- ended"

    def close(self) -> None:
        assert self._process.stdin is not None
        self._process.stdin.close()
        self._process.wait()


def _from_the_shell(rounds: int, there: Side, here: Side, slower: list[str]) -> Iterator[str]:
    for name, words in COLD.items():
        times: list[list[float]] = [[], []]
        for _ in range(rounds + 1):
            for side, own in zip((there, here), times, strict=True):
                own.append(_command(side, words, side.cache))
        before, now = (min(own[1:]) for own in times)
        yield _said(name, before, now, "s", slower)
        if name in FIRST:
            before, now = (_first(side, words) for side in (there, here))
            yield _said(f"{name}, nothing compiled yet", before, now, "s", slower)


def _first(side: Side, words: tuple[str, ...]) -> float:
    with tempfile.TemporaryDirectory() as folder:
        return _command(side, words, Path(folder))


def _command(side: Side, words: tuple[str, ...], cache: Path) -> float:
    environment = side.environment | {"NUMBA_CACHE_DIR": str(cache)}
    return processor_time([str(side.python), *words], cwd=side.root, env=environment)


if __name__ == "__main__":
    main()
