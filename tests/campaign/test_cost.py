"""What a study costs with its members, a design with its designs: time in proportion, memory flat.

Processor time, the least of three, so that what else the machine does counts for little.
`python -m tests.campaign.test_cost` prints larger ones.
"""

from __future__ import annotations

import sys
import time
import tracemalloc
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from catopt.compile_jobs import JOBS, compile_always
from catopt.design.evaluation import DesignProblem
from catopt.design.mooring import MooringProblem
from catopt.design.search import enumerate_designs
from catopt.model import SegmentChoice
from catopt.study.run import run_study
from tests.design.mooring_cases import mooring_case
from tests.design.small_cases import small_case

pytestmark = pytest.mark.slow

ROOT = Path(__file__).parents[2]
STUDY = (ROOT / "cases/study-buoy-9.5m/study.toml").read_text(encoding="utf-8")


def study(folder: Path, members: int, compute: str) -> Callable[[], object]:
    """Study of so many members, two to a draw."""
    text = STUDY.replace("samples = 1000", f"samples = {members // 2}")
    text = text.replace('compute = "statics"', f'compute = "{compute}"')
    if compute == "checks":
        text = text.replace('limits = { anchor_uplift = "1.2 kN" }', "")
    case = (ROOT / "cases/buoy-9.5m/case.toml").read_text(encoding="utf-8")
    (folder / "case.toml").write_text(case + '\n[checks]\nmax_span = "30 m"\n', encoding="utf-8")
    text = text.replace("../buoy-9.5m/case.toml", "case.toml")
    path = folder / f"study-{members}-{compute}.toml"
    path.write_text(text, encoding="utf-8")
    return lambda: run_study(path, folder / f"{members}-{compute}-{time.time_ns()}", workers=1)


def cost(run: Callable[[], object], times: int = 3) -> float:
    """Processor time, s."""
    taken = []
    for _ in range(times):
        began = time.process_time()
        run()
        taken.append(time.process_time() - began)
    return min(taken)


def most_memory(run: Callable[[], object]) -> float:
    """Largest memory that Python's own objects and arrays take, bytes."""
    tracemalloc.start()
    try:
        run()
        return float(tracemalloc.get_traced_memory()[1])
    finally:
        tracemalloc.stop()


def moorings(lengths: int) -> Callable[[], object]:
    """Enumerate 24 moorings a length without bounds, so that every design is evaluated."""
    case = mooring_case(
        segments=(
            SegmentChoice(
                tuple(np.linspace(600.0, 660.0, lengths).tolist()),
                ("chain studless R3", "chain studless R4"),
                (0.076, 0.1, 0.12),
            ),
        ),
        headings=2,
    )
    problem = MooringProblem.of(case)
    return lambda: enumerate_designs(problem, bounds=False, workers=1)


def lines(lengths: int) -> Callable[[], object]:
    """Enumerate lines of so many lengths."""
    segment = SegmentChoice(
        tuple(np.linspace(200.0, 320.0, lengths).tolist()),
        ("chain studless R3", "chain studless R4"),
        tuple(np.arange(0.06, 0.12, 0.002).tolist()),
    )
    problem = DesignProblem.of(small_case(segments=(segment,), clump_weights=(), sinker=None))
    return lambda: enumerate_designs(problem, workers=1)


@pytest.fixture(scope="module", autouse=True)
def all_compiled() -> None:
    """Compile beforehand: what is measured are the members and the designs."""
    with compile_always():
        for name in ("many lines", "bodies of several lines", "design search"):
            JOBS[name]()


GROWTH = 1.5
"""Times in proportion: a square would give 4; what is done once, and noise, are below a half."""


def grows(of: Callable[[int], Callable[[], object]], few: int, times: int) -> tuple[float, float]:
    """How much more than in proportion time grows, and memory by how many times."""
    one, many = of(few), of(times * few)
    one()
    time_of = cost(many) / cost(one) / times
    return time_of, most_memory(many) / most_memory(one)


@pytest.mark.parametrize(("compute", "few"), [("statics", 40_000), ("checks", 100)])
def test_a_study_costs_as_much_as_its_members(tmp_path: Path, compute: str, few: int) -> None:
    longer, larger = grows(lambda count: study(tmp_path, count, compute), few, 4)
    assert longer < GROWTH
    assert larger < 3.0  # the numbers of all members are kept: a part of what a piece takes


@pytest.mark.parametrize(("of", "few"), [(lines, 50), (moorings, 8)])
def test_a_design_costs_as_much_as_its_designs(
    of: Callable[[int], Callable[[], object]], few: int
) -> None:
    longer, larger = grows(of, few, 4)
    assert longer < GROWTH
    assert larger < 4.5


if __name__ == "__main__":
    from tempfile import TemporaryDirectory

    with compile_always():
        for job in JOBS.values():
            job()
    with TemporaryDirectory() as made:
        for name, each, count in (
            ("statics", lambda n: study(Path(made), n, "statics"), 100_000),
            ("checks", lambda n: study(Path(made), n, "checks"), 500),
            ("lines", lines, 400),
            ("moorings", moorings, 40),
        ):
            found = grows(each, count, 8)
            sys.stdout.write(f"{name}, 8 times {count:,}: {found[0]:.2f}, {found[1]:.2f}\n")
