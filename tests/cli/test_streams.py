"""Where the answer and the messages go, when one of the two places is not there or full."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

from .conftest import BUOY, Run

pytestmark = pytest.mark.skipif(
    not Path("/dev/full").exists(), reason="needs a device that is always full"
)

SOLVE = f"{sys.executable} -m catopt solve {BUOY} --json"


def shell(command: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(["sh", "-c", command], capture_output=True, text=True, check=False)


@pytest.mark.parametrize("where", ["> /dev/full", ">&-"])
@pytest.mark.parametrize("rest", ["solve CASE", "solve CASE --json", "--version", "solve --help"])
def test_an_answer_that_cannot_be_written_is_2_and_says_so(where: str, rest: str) -> None:
    ran = shell(f"{sys.executable} -m catopt {rest.replace('CASE', str(BUOY))} {where}")
    assert (ran.returncode, ran.stdout) == (2, "")
    assert ran.stderr.startswith("catopt: 1 error\n  standard output: ")
    assert ran.stderr.count("\n") == 2


@pytest.mark.slow
@pytest.mark.parametrize("where", ["2> /dev/full", "2>&-"])
def test_the_answer_is_the_same_where_no_message_can_be_written(
    run: Run, where: str, tmp_path: Path
) -> None:
    plain = run("solve", BUOY, "--json")
    assert (plain.status, json.loads(plain.out)["status"]) == (0, "converged")
    ran = shell(f"{SOLVE} --out {tmp_path / 'out'} {where}")
    assert (ran.returncode, ran.stdout) == (0, plain.out)
    assert json.loads((tmp_path / "out" / "solution.json").read_text("utf-8"))["status"]


@pytest.mark.parametrize("where", ["2> /dev/full", "2>&-"])
@pytest.mark.parametrize("rest", ["solve gone.toml", "solve", "sovle"])
def test_so_is_the_status_of_a_refusal(where: str, rest: str) -> None:
    ran = shell(f"{sys.executable} -m catopt {rest} {where}")
    assert (ran.returncode, ran.stdout, ran.stderr) == (2, "", "")
