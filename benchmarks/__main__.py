"""All benchmarks: listed, run one after the other, and gathered on one page.

    python -m benchmarks [NAME ...] [--list] [--smoke] [--out DIR]

Each writes its result file, at sizes that let all of them end within 20 minutes on two cores; the
page beside them has every row with a ratio to a peer or a limit. `guard`, `hundred_buoys`,
`mutants` and `newcomer` ask for more than this machine in 20 minutes (a commit, hours, a part, a
package index) and are run by name.
"""

from __future__ import annotations

import argparse
import ast
import subprocess
import sys
import time
from pathlib import Path

from benchmarks.common import RESULTS, ROOT, stamp

SIZES = {
    "afloat": "--seeds 2",
    "beside_moordyn": "",
    "catenary": "",
    "cold_start": "--rounds 5",
    "design": "--rounds 3",
    "dynamics": "--storm 1800",
    "extremes": "--sections study speed",
    "front": "",
    "house": "",
    "intervals": "",
    "joints": "",
    "linear": "--seas 5",
    "linear_afloat": "--lines 20 --seas 1",
    "moorings": "",
    "page": "",
    "practice": "",
    "ships": "",
    "quick": "--ships 2 --buoys 1 --minutes 2",
    "reliability": "",
    "search": "--seeds 2",
    "series": "",
    "sizing": "--rounds 3",
    "slack": "--lines 2",
    "study": "--runs 10",
    "swarm": "--seeds 10 --lines 10",
    "system": "",
    "truss": "--rounds 3",
    "waves": "--rounds 3",
}
"""Options of each within the 20 minutes."""

BY_NAME = ("guard", "hundred_buoys", "newcomer")
TELLING = ("ratio", "limit", "times", "MoorPy", "MoorDyn")
"""Words by which a table's head says that it compares."""


def main() -> None:
    """List, or run and gather."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("names", nargs="*", metavar="NAME", help="those alone")
    parser.add_argument("--list", action="store_true", help="name all, and what each measures")
    parser.add_argument("--smoke", action="store_true", help="see each run, within seconds")
    parser.add_argument("--out", type=Path, default=RESULTS, help="folder for the pages")
    of = parser.parse_args()
    if of.list:
        for name in sorted((*SIZES, *BY_NAME)):
            print(f"{name:12} {said(name)}")
        return
    failed = [name for name in of.names or all_of(of.smoke) if not ran(name, of.smoke, of.out)]
    if not of.smoke:
        (of.out / "all.md").write_text(gathered(of.out), encoding="utf-8")
    if failed:
        sys.exit("failed: " + ", ".join(failed))


def all_of(smoke: bool) -> list[str]:
    """Names of what is run when none is given; a smoke runs those that ask for more, too."""
    return sorted((*SIZES, *BY_NAME)) if smoke else list(SIZES)


def said(name: str) -> str:
    """First sentence of a benchmark's text."""
    text = (ROOT / "benchmarks" / f"{name}.py").read_text(encoding="utf-8")
    return (ast.get_docstring(ast.parse(text)) or "").splitlines()[0]


def ran(name: str, smoke: bool, out: Path) -> bool:
    """Run one; say what it took and whether it ended well."""
    options = ["--smoke"] if smoke else [*SIZES.get(name, "").split(), "--out", f"{out}/{name}.md"]
    began = time.perf_counter()
    done = subprocess.run(
        [sys.executable, "-m", f"benchmarks.{name}", *options],
        cwd=ROOT,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        text=True,
        check=False,
    )
    well = done.returncode == 0
    told = "" if well else "\n" + done.stderr[-2000:]
    print(
        f"{name:12} {time.perf_counter() - began:7.1f} s  {'' if well else 'FAILED'}{told}",
        flush=True,
    )
    return well


def gathered(folder: Path) -> str:
    """Put every table that compares with a peer or a limit on one page, as its own file has it."""
    rows = ["# Beside peers and limits", "", stamp(), ""]
    for path in sorted(folder.glob("*.md")):
        if path.name == "all.md":
            continue
        lines = path.read_text(encoding="utf-8").splitlines()
        title = next((line[2:] for line in lines if line.startswith("# ")), path.stem)
        run = next((line for line in lines if line.startswith("`python -m")), "no command named")
        found = comparisons(lines)
        if found:
            rows += [f"## [{title}]({path.name})", "", run, "", *found]
    return "\n".join(rows).rstrip() + "\n"


def comparisons(lines: list[str]) -> list[str]:
    """Tables whose head, or whose rows, name a ratio, a limit or a peer."""
    found: list[str] = []
    table: list[str] = []
    for line in [*lines, ""]:
        if line.startswith("|"):
            table.append(line)
            continue
        if table and any(word in "\n".join(table) for word in TELLING):
            found += [*table, ""]
        table = []
    return found


if __name__ == "__main__":
    main()
