"""The tables of docs/validation.md: what is compared with what, from the data that the tests use.

``python -m tests.validation_page`` brings the page up to date.
"""

from __future__ import annotations

import ast
import math
import re
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from functools import cache
from pathlib import Path

from catopt import catalogue, read_case, verify_case
from catopt.constants import STANDARD_GRAVITY
from catopt.model.network import Network
from catopt.reproduce import Reproduction, reproduce
from catopt.verify.result import StaticComparison
from tests import beside
from tests.catalogue.printed import CALMAR_OPEN, PILOTFITS, VRYHOF, rows

ROOT = Path(__file__).parents[1]
PAGE = ROOT / "docs" / "validation.md"

EVIDENCE = {
    "Printed results": (
        "reproduce/test_buoy_9p5m",
        "reproduce/test_ship_200m",
        "reproduce/test_tanker_20m",
        "reproduce/test_tanker_20m_sinker",
        "reproduce/test_calmar",
        "fem/test_rang_dong",
        "waves/test_table_4_4",
        "loads/test_ship_current",
        "catalogue/test_chain",
        "catalogue/test_buoy_chain",
        "catalogue/test_rope",
        "checks/test_profiles",
    ),
    "Textbook formulas, written out once more in the test": (
        "catenary/test_uniform",
        "catenary/test_practice_formulas",
        "catenary/test_regime_map",
        "fem/test_catenary_limit",
        "mooring/test_load_sharing",
        "waves/test_kinematics",
    ),
    "Another method": (
        "campaign/test_campaign",
        "campaign/test_oracle",
        "campaign/test_networks",
        "catenary/test_swarm_any_line",
        "fem/test_closed_form",
        "fem/test_joint",
        "fem/test_equations",
        "verify/test_lines",
        "verify/test_touches_twice",
        "verify/test_network",
        "verify/test_system",
        "waves/test_spectrum",
        "design/test_enumeration",
        "design/test_evaluation",
    ),
    "Another program": (
        "peers/test_moorpy",
        "peers/test_moorpy_joints",
        "fem/test_dyn_other_programs",
        "export/test_moorpy_finds_it",
        "export/test_moordyn_finds_it",
        "design/test_hypervolume",
    ),
    "Worked by hand": (
        "checks/test_by_hand",
        "checks/test_strength",
        "loads/test_buoy",
        "loads/test_page",
        "sizing/test_page",
        "report/test_trail",
    ),
    "Limits, symmetry and order": (
        "catenary/test_properties",
        "catenary/test_refusals_and_extremes",
        "catenary/test_small_forces",
        "fem/test_bar",
        "fem/test_time",
        "mooring/test_system",
        "mooring/test_random_systems",
        "verify/test_richardson",
    ),
}
"""Tests by what they hold catopt against; each is listed with the first words of its docstring."""

FLOOR = 1e-9
"""Smaller differences are not told apart: they are rounding, which is another on each machine."""

_PART = re.compile(
    r"(<!-- (?P<name>[a-z]+): python -m tests\.validation_page -->\n)(?P<text>.*?)(<!-- end -->)",
    re.DOTALL,
)


def up_to_date(page: str) -> str:
    """Put the real tables in the place of what a page shows."""
    return _PART.sub(lambda found: f"{found[1]}\n{PARTS[found['name']]()}\n{found[4]}", page)


def parts(page: str) -> list[tuple[str, str]]:
    """Names of the parts that a page has, each with what it shows."""
    return [(found["name"], found["text"].strip("\n")) for found in _PART.finditer(page)]


# ------------------------------------------------------------------ published results


@cache
def _reproduction() -> Reproduction:
    return reproduce()


def _studies() -> str:
    def line(study: str, verdicts: Iterable[str]) -> tuple[str, ...]:
        count = Counter(verdicts)
        kinds = ("reproduces", "differs", "not reproducible")
        return (study, str(count.total()), *(str(count[kind]) for kind in kinds))

    studies = _reproduction().studies
    lines = [
        line(f"{study.source}: {study.title}", (item.verdict for item in study.items))
        for study in studies
    ]
    everything = (item.verdict for study in studies for item in study.items)
    return _table(
        ("Study", "Printed", "Reproduce", "Differ", "Cannot be"),
        [*lines, line("**all**", everything)],
    )


def _beside() -> str:
    columns = (
        "Source",
        "How",
        "What, the furthest off",
        "Numbers",
        "catopt",
        "Theirs",
        "Off (%)",
        "Side",
    )
    none = ", ".join(
        f"{count} of `{name}`" for name, count in beside.set_aside(_reproduction()).items()
    )
    told = f"Printed, and nothing of ours beside it: {none}."
    return f"{_table(columns, beside.lines(_reproduction()))}\n{told}\n"


# ------------------------------------------------------------------ closed form and truss model


def _models() -> str:
    lines = []
    for path in sorted((ROOT / "cases").glob("*/case.toml")):
        place = path.relative_to(ROOT).as_posix()
        name = f"[{path.parent.name}](../{place})"
        note = f"reports/notes/{path.parent.name}.html"
        link = f"[note](../{note})" if (ROOT / note).exists() else ""
        case = read_case(path)
        if isinstance(case, Network) and case.current_at_rest is not None:
            continue  # the truss of points and lines rests in still water, and says so
        lines += [(name, *_compared(part), link) for part in verify_case(case).parts]
    columns = (
        "Case",
        "Load",
        "Largest tension at a fairlead (kN)",
        "Worst difference",
        "Verdict",
        "Calculation note",
    )
    return _table(columns, lines)


def _compared(part: StaticComparison) -> tuple[str, ...]:
    tensions = [pair.closed.fairlead.tension for pair in part.lines if pair.closed is not None]
    load = "" if part.name == "load" else part.name
    return load, f"{max(tensions) / 1e3:.3f}", below(part.worst.gap), part.verdict


def below(gap: float) -> str:
    """Name the power of ten above a difference."""
    return f"below 1e{math.floor(math.log10(max(gap, 0.999 * FLOOR))) + 1}"


# ------------------------------------------------------------------ catalogue


Compared = tuple[float, float]
KN = 1e3
TF = 1e3 * STANDARD_GRAVITY


def _catalogue() -> str:
    lines = [
        ("Vryhof manual, offshore chain: break loads of 5 grades", *_worst(_vryhof())),
        ("the same, R5 of 132 mm alone: a misprint", *_worst(_vryhof(misprint=True))),
        ("Pilotfits, offshore chain: proof and break loads of R3, R3S, R4", *_worst(_pilotfits())),
        ("CALMAR, open-link buoy chain: mass and proof loads of 4 kinds", *_worst(_calmar())),
        ("the same, Q3 of 38 mm alone: a misprint", *_worst(_calmar(misprint=True))),
    ]
    return _table(("Printed table", "Figures", "Largest difference"), lines)


def _vryhof(*, misprint: bool = False) -> Iterator[Compared]:
    for diameter, *loads in rows(VRYHOF):
        for grade, load in zip(("ORQ", "R3", "R3S", "R4", "R5"), loads, strict=False):
            if ((diameter, grade) == (132.0, "R5")) is misprint:
                yield load, _figure(f"chain studless {grade}", diameter, "MBL") / KN


def _pilotfits() -> Iterator[Compared]:
    kinds = (
        ("studless R3", "proof_load"),
        ("studless R3", "MBL"),
        ("studless R3S", "proof_load"),
        ("stud-link R3S", "proof_load"),
        ("studless R3S", "MBL"),
        ("studless R4", "proof_load"),
        ("stud-link R4", "proof_load"),
        ("studless R4", "MBL"),
    )
    for diameter, *loads in rows(PILOTFITS):
        for (chain, quantity), load in zip(kinds, loads, strict=True):
            yield load, _figure(f"chain {chain}", diameter, quantity) / KN


def _calmar(*, misprint: bool = False) -> Iterator[Compared]:
    for diameter, *figures in rows(CALMAR_OPEN):
        for link, mass in zip(("3D", "3.5D", "4D", "5D"), figures[:4], strict=True):
            name = f"chain open-link {link}"
            if not misprint:
                yield mass, _figure(f"{name} Q1", diameter, "mass")
            for grade, load in zip(("Q1", "Q2", "Q3"), figures[4:], strict=True):
                if ((diameter, grade) == (38.0, "Q3")) is misprint:
                    yield load, _figure(f"{name} {grade}", diameter, "proof_load") / TF


def _figure(name: str, diameter_mm: float, quantity: str) -> float:
    return float(getattr(catalogue.component(name, diameter_mm / 1e3), quantity))


def _worst(compared: Iterable[Compared]) -> tuple[str, str]:
    """Count the figures, and take the largest difference over its print."""
    gaps = [abs(ours / printed - 1.0) for printed, ours in compared]
    worst = max(gaps)
    return str(len(gaps)), "none" if worst < FLOOR else f"{100.0 * worst:.2g} %"


# ------------------------------------------------------------------ tests and benchmarks


def _tests() -> str:
    lines = []
    for kind, modules in EVIDENCE.items():
        shown = kind
        for module in modules:
            path = ROOT / "tests" / f"{module}.py"
            lines.append((shown, first_words(path), f"[{module}](../tests/{module}.py)"))
            shown = ""
    return _table(("Compared with", "What", "Test"), lines)


def first_words(path: Path) -> str:
    """First paragraph of a module's docstring, in one line."""
    text = ast.get_docstring(ast.parse(path.read_text("utf-8"))) or ""
    return " ".join(text.partition("\n\n")[0].split()).replace("|", r"\|")


def _benchmarks() -> str:
    lines = []
    for path in sorted((ROOT / "benchmarks" / "results").glob("*.md")):
        title = path.read_text("utf-8").splitlines()[0].removeprefix("# ")
        by = f"benchmarks/{path.stem}.py"
        by = by if (ROOT / by).exists() else "python -m tests.campaign"
        lines.append((f"[{title}](../benchmarks/results/{path.name})", f"`{by}`"))
    return _table(("What was measured", "By"), lines)


def _table(columns: Iterable[str], lines: Iterable[Iterable[str]]) -> str:
    heading = list(columns)
    every = [heading, ["---"] * len(heading), *lines]
    return "".join(f"| {' | '.join(cells)} |\n" for cells in every)


PARTS: dict[str, Callable[[], str]] = {
    "beside": _beside,
    "studies": _studies,
    "models": _models,
    "catalogue": _catalogue,
    "tests": _tests,
    "benchmarks": _benchmarks,
}

if __name__ == "__main__":
    PAGE.write_text(up_to_date(PAGE.read_text("utf-8")), encoding="utf-8")
