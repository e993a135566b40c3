"""Which tests are not among the quick ones, by the processor time that they take.

The quick tests tell a user that his installation is right, and who changes catopt that the physics
is: README's commands, the cases that come with it, closed forms, prints, refusals. They are to end
within two minutes on two cores, so a file of tests that takes more than `LIMIT_OF_FILE` is slow, as
is a test function above `LIMIT` with all its parameters, but for those of `KEPT`; `.ci/run` runs
them. Of sessions as they are typed each counts for itself.

After ``pip install -e ".[test]"``, ``python -m tests.longer`` measures the quick tests as on a new
machine, which compiles first, and adds to longer.txt what takes longer; with ``anew`` it begins
with none on the list. What one test no longer compiles another one does: go on until nothing is
added.
"""

from __future__ import annotations

import os
import resource
import subprocess
import sys
import tempfile
from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

import pytest

LONGER = Path(__file__).with_name("longer.txt")
LIMIT_OF_FILE = 2.5
"""Processor time of a file of quick tests, with what its first tests compile and solve, s."""
LIMIT = 0.5
"""Processor time of a quick test function with all its parameters, s."""
ONE_BY_ONE = ("tests/cli/test_transcripts.py::test_what_is_said",)
LIMIT_OF_ONE = 0.1
"""Processor time of one of `ONE_BY_ONE`, s."""
KEPT = (
    "tests/test_docs.py::test_what_readme_shows_runs_and_prints_it",
    "tests/verify/test_cases.py::test_every_case_of_the_project_agrees",
    "tests/fem/test_dyn_frequencies.py::test_hanging_chain",
    "tests/reproduce/test_buoy_9p5m.py::test_each_computed_number_is_that_of_the_closed_form",
    "tests/reproduce/test_calmar.py::test_every_printed_digit_of_both_releases",
    "tests/peers/test_moorpy_reads_decks.py::test_it_still_finds_what_is_kept_of_public_decks",
    "tests/verify/test_lines.py::test_the_models_agree_with_second_order",
    "tests/casefile/test_broken.py::test_the_message_is_exactly_this",
    "tests/catalogue/test_chain.py::test_break_loads_are_vryhof_s",
    "tests/test_architecture.py::test_no_import_points_up",
)
_TIMES = "CATOPT_TIMES_OF_TESTS"


def names_of(test: str) -> tuple[str, str, str]:
    """Give the names that a list may have a test by: its file's, its function's, its own."""
    function = test.partition("[")[0]
    return function.partition("::")[0], function, test


def read(path: Path) -> frozenset[str]:
    """Read the names of a list, without what it says at its head."""
    return frozenset(each for each in path.read_text("utf-8").splitlines() if each[:1] != "#")


def longer(times: Sequence[tuple[str, float]]) -> list[str]:
    """Find what is not quick, of the name of each test and its processor time in s."""
    total: dict[str, float] = defaultdict(float)
    for test, seconds in times:
        for name in {*names_of(test)}:
            total[name] += seconds
    kept_files = {names_of(each)[0] for each in (*KEPT, *ONE_BY_ONE)}

    def is_long(test: str) -> Iterator[str]:
        file, function, _ = names_of(test)
        if file not in kept_files and total[file] > LIMIT_OF_FILE:
            yield file
        elif function in ONE_BY_ONE:
            if total[test] > LIMIT_OF_ONE:
                yield test
        elif function not in KEPT and total[function] > LIMIT:
            yield function

    return sorted({name for test, _ in times for name in is_long(test)})


def _processor_time() -> float:
    used = [resource.getrusage(each) for each in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(each.ru_utime + each.ru_stime for each in used)


@pytest.hookimpl(wrapper=True)
def pytest_runtest_protocol(item: pytest.Item) -> Iterator[None]:
    """Write down what a test took; in use only where this module is pytest's plugin."""
    began = _processor_time()
    result = yield
    with Path(os.environ[_TIMES]).open("a", encoding="utf-8") as file:
        file.write(f"{_processor_time() - began}\t{item.nodeid}\n")
    return result


def measure() -> list[tuple[str, float]]:
    """Run the quick tests without anything compiled and give the processor time of each in s."""
    with (
        tempfile.TemporaryDirectory() as empty,
        tempfile.NamedTemporaryFile("r", encoding="utf-8") as times,
    ):
        command = [sys.executable, "-m", "pytest", "-q", "-p", "tests.longer"]
        environment = {**os.environ, _TIMES: times.name, "NUMBA_CACHE_DIR": empty}
        subprocess.run(command, env=environment, check=True)
        lines = [each.rstrip("\n").partition("\t") for each in times]
    return [(name, float(seconds)) for seconds, _, name in lines]


def write(names: Iterable[str]) -> None:
    """Write the list with its head."""
    head = [each for each in LONGER.read_text("utf-8").splitlines() if each[:1] == "#"]
    LONGER.write_text("\n".join([*head, *sorted(names)]) + "\n", "utf-8")


if __name__ == "__main__":
    before = frozenset[str]() if "anew" in sys.argv[1:] else read(LONGER)
    write(before)
    found = longer(measure())
    write({*before, *found})
    sys.stdout.write(f"{len(found)} names added to {LONGER.name}\n")
