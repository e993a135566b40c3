"""Every way a command ends: its status, what it says, and where it says it."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from pathlib import Path

import pytest

from catopt._version import identity
from catopt.errors import CatoptError, InputError, Problem

from .conftest import BUOY, NAMED, Run, refused


@pytest.mark.parametrize("error", [RuntimeError("a bolt\nis loose"), CatoptError("a bolt")])
def test_a_fault_of_ours_is_1_and_asks_for_debug(
    run: Run, monkeypatch: pytest.MonkeyPatch, error: Exception
) -> None:
    def fail(_: object) -> None:
        raise error

    monkeypatch.setattr("catopt.catenary.case.solve_case", fail)
    ran = run("solve", BUOY)
    assert (ran.status, ran.out) == (1, "")
    assert "a bolt" in ran.err
    assert "--debug" in ran.err
    assert "Traceback" not in ran.err

    ran = run("--debug", "solve", BUOY)
    assert (ran.status, ran.out) == (1, "")
    assert "Traceback" in ran.err


def test_a_case_with_nothing_to_check_is_3_under_strict_as_the_page_says(run: Run) -> None:
    assert run("check", BUOY).status == 0
    strict = run("check", BUOY, "--strict")
    assert strict.status == 3
    assert strict.out
    page = (Path(__file__).parents[2] / "docs" / "commands.md").read_text("utf-8")
    assert "3 if a check fails, there is none, or the models do not agree" in page


def test_another_function_s_input_error_is_passed_on(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Only problems of the range take the names of the options."""

    def refuse(*_: object, **__: object) -> None:
        raise InputError([Problem("site.water_depth", "0", "must be above 0 m")], "Site")

    monkeypatch.setattr("catopt.catenary.case_curve.solve_case", refuse)
    ran = run("curve", BUOY)
    assert (ran.status, "site.water_depth: found 0" in ran.err) == (2, True)


@pytest.mark.slow
def test_a_damage_that_hangs_on_the_step_is_status_4(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    """By a limit that nothing keeps: the runs themselves have converged."""
    monkeypatch.setattr("catopt.verify.fatigue.LIMIT", -1.0)
    ran = run("fatigue", NAMED["FATIGUE"])
    assert ran.status == 4
    assert "NOT PROVEN; the simulations: NOT CONVERGED" in " ".join(ran.out.split())
    assert "NOT CONVERGED" in ran.err


def test_without_rainflow_the_way_out_is_named(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("importlib.util.find_spec", lambda _: None)
    ran = refused(run, "fatigue", NAMED["FATIGUE"])
    assert "pip install 'catopt[fatigue]'" in ran.err


def test_an_interrupt_is_130_and_one_line(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupt(_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("catopt.catenary.case.solve_case", interrupt)
    ran = run("solve", BUOY)
    assert (ran.status, ran.out, ran.err) == (130, "", "catopt: interrupted\n")


INTERRUPTED_AT = """
import sys
class Interrupt:
    def find_spec(self, name, path=None, target=None):
        if name == "{module}":
            raise KeyboardInterrupt
sys.meta_path.insert(0, Interrupt())
from catopt.__main__ import main
sys.exit(main(["--version"]))
"""


@pytest.mark.parametrize("module", ["catopt.errors", "catopt.cli.output", "catopt.cli.app"])
def test_an_interrupt_while_the_program_is_loaded_is_told_in_one_line(module: str) -> None:
    code = INTERRUPTED_AT.format(module=module)
    ran = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert (ran.returncode, ran.stdout, ran.stderr) == (130, "", "catopt: interrupted\n")


@pytest.mark.skipif(sys.platform == "win32", reason="pipes break otherwise there")
@pytest.mark.parametrize("arguments", [["solve", str(BUOY)], ["solve", str(BUOY), "--json"]])
def test_a_reader_that_goes_away_is_no_error_message(arguments: list[str]) -> None:
    command = subprocess.Popen(
        [sys.executable, "-m", "catopt", *arguments],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    )
    assert command.stdout is not None
    assert command.stderr is not None
    command.stdout.close()  # before it has had the time to write anything
    said = command.stderr.read()
    command.stderr.close()
    assert (command.wait(), said) == (141, b"")


def test_version_and_help_are_0(run: Run) -> None:
    ran = run("--version")
    assert (ran.status, ran.err) == (0, "")
    own, beside = ran.out.splitlines()
    assert own == f"catopt {identity()}"
    assert re.fullmatch(r"Python \S+, numpy \S+, scipy \S+, numba \S+", beside)
    for arguments in (["--help"], ["-h"], ["solve", "--help"], ["new", "-h"]):
        ran = run(*arguments)
        assert (ran.status, ran.err) == (0, "")
        assert ran.out.startswith("Usage: catopt")


def test_as_a_process() -> None:
    """The installed entry point and ``python -m catopt`` give the status to the shell."""
    command = [sys.executable, "-m", "catopt", "solve", "no-such-file.toml"]
    ran = subprocess.run(command, capture_output=True, check=False)
    assert (ran.returncode, ran.stdout) == (2, b"")


needs_a_full_device = pytest.mark.skipif(
    not Path("/dev/full").exists(), reason="needs a device that is always full"
)
SOLVE = f"{sys.executable} -m catopt solve {BUOY} --json"


def shell(command: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(["sh", "-c", command], capture_output=True, text=True, check=False)


@needs_a_full_device
@pytest.mark.parametrize("where", ["> /dev/full", ">&-"])
@pytest.mark.parametrize("rest", ["solve CASE", "solve CASE --json", "--version", "solve --help"])
def test_an_answer_that_cannot_be_written_is_2_and_says_so(where: str, rest: str) -> None:
    ran = shell(f"{sys.executable} -m catopt {rest.replace('CASE', str(BUOY))} {where}")
    assert (ran.returncode, ran.stdout) == (2, "")
    assert ran.stderr.startswith("catopt: 1 error\n  standard output: ")
    assert ran.stderr.count("\n") == 2


@needs_a_full_device
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


@needs_a_full_device
@pytest.mark.parametrize("where", ["2> /dev/full", "2>&-"])
@pytest.mark.parametrize("rest", ["solve gone.toml", "solve", "sovle"])
def test_so_is_the_status_of_a_refusal(where: str, rest: str) -> None:
    ran = shell(f"{sys.executable} -m catopt {rest} {where}")
    assert (ran.returncode, ran.stdout, ran.stderr) == (2, "", "")


def test_a_name_that_is_too_long_is_wrong_input(run: Run) -> None:
    for command in ("solve", "check", "curve", "study", "import"):
        ran = run(command, "a" * 5000 + ".toml")
        assert ran.status == 2, (command, ran.err[:200])
        assert "too long" in ran.err
        assert len(ran.err) < 12_000


@pytest.mark.skipif(
    sys.version_info[:3] == (3, 13, 0), reason="this Python cannot import without a directory"
)
def test_a_working_directory_that_is_gone(tmp_path: Path) -> None:
    """What needs none is done; what does ends in words."""
    code = (
        "import os, sys, shutil; os.mkdir('gone'); os.chdir('gone'); os.rmdir('../gone');"
        "from catopt.__main__ import main; sys.exit(main(sys.argv[1:]))"
    )
    for status, *arguments in ((0, "solve", str(BUOY)), (2, "reproduce")):
        ran = subprocess.run([sys.executable, "-c", code, *arguments], cwd=tmp_path, check=False,
                             capture_output=True, text=True)  # fmt: skip
        assert ran.returncode == status, ran.stderr
        assert "fault of catopt" not in ran.stderr
