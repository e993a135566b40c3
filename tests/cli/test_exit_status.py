"""Every way a command ends: its status, what it says, and where it says it."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from catopt.errors import CatoptError

from .conftest import BUOY, Run


def test_done_is_0_with_nothing_beside_the_answer(run: Run) -> None:
    ran = run("solve", BUOY)
    assert (ran.status, ran.err) == (0, "")
    assert "17.430 m" in ran.out


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["solve", "no-such-file.toml"], "there is no such file"),
        (["solve", BUOY, "--runs", "3"], "--runs: found 3; needs --method pso"),
        (["solve", BUOY, "--method", "pso", "--particles", "1"], "--particles: found 1; must be 2"),
        (["solve", BUOY, "--method", "pso", "--boundary", "wall"], "--boundary: found 'wall'"),
        (["reproduce", "bouy_9p5m"], "did you mean buoy_9p5m?"),
        (["new", "ship"], "one of buoy, tanker, leg,"),
        (["solve"], "Missing argument"),
        (["solve", BUOY, "--method", "magic"], "'magic' is not one of"),
        (["solve", BUOY, "--bogus"], "No such option: --bogus"),
        (["solve", BUOY, "--method", "pso", "--runs", "many"], "--runs"),
        (["sovle", BUOY], "No such command"),
    ],
)
def test_wrong_input_is_2(run: Run, arguments: list[object], said: str) -> None:
    ran = run(*arguments)
    assert (ran.status, ran.out) == (2, "")
    assert said in ran.err
    assert "Traceback" not in ran.err


def test_every_wrong_option_is_named_at_once(run: Run) -> None:
    ran = run("solve", BUOY, "--method", "pso", "--particles", "1", "--runs", "0", "--seed", "-1")
    assert ran.status == 2
    assert [word in ran.err for word in ("--particles", "--runs", "--seed")] == [True] * 3


def test_a_swarm_needs_the_horizontal_force_and_the_bed(run: Run, tmp_path: Path) -> None:
    text = BUOY.read_text("utf-8").replace('horizontal_force = "0.343 tf"', 'span = "17 m"')
    text = text.replace('anchor_height = "0 m"', 'anchor_height = "1 m"')
    path = tmp_path / "case.toml"
    path.write_text(text, encoding="utf-8")
    ran = run("solve", path, "--method", "pso")
    assert ran.status == 2
    for key in ("load", "line.anchor_height"):
        assert f"\n  {key}: " in ran.err


def test_a_swarm_seeks_nothing(run: Run, sought: Path) -> None:
    ran = run("solve", sought, "--method", "pso")
    assert (ran.status, ran.out) == (2, "")
    assert "find: found length; the swarm method seeks nothing" in ran.err


@pytest.mark.parametrize(
    "command",
    [
        ["solve"], ["solve", "--method", "pso"], ["curve"], ["verify"], ["report"],
        ["export", "--to", "dxf"],
    ],
    ids=" ".join,
)  # fmt: skip
def test_no_equilibrium_is_3_says_how_much_is_missing_and_writes_nothing(
    run: Run, too_short: Path, tmp_path: Path, command: list[str]
) -> None:
    ran = run(command[0], too_short, *command[1:], "--out", tmp_path / "out")
    assert (ran.status, ran.out) == (3, "")
    assert "1 m" in ran.err
    assert "Traceback" not in ran.err
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("command", "computes"),
    [
        (["solve", BUOY], "catopt.catenary.case.solve_case"),
        (["check", BUOY], "catopt.checks.case.check_case"),
        (["curve", BUOY], "catopt.catenary.case_curve.curve_case"),
        (["verify", BUOY], "catopt.verify.case.verify_case"),
        (["reproduce"], "catopt.reproduce.reproduce"),
        (["catalog", "list"], ""),
    ],
    ids=lambda each: each[0] if isinstance(each, list) else "",
)
def test_a_file_in_the_way_is_2_before_anything_is_computed(
    run: Run,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    command: list[object],
    computes: str,
) -> None:
    def never(*_: object, **__: object) -> None:
        raise AssertionError("computed, although nothing can be written")

    if computes:
        monkeypatch.setattr(computes, never)
    path = tmp_path / "file"
    path.write_text("mine", encoding="utf-8")
    for out in (path, path / "below"):
        ran = run(*command, "--json", "--out", out)
        assert (ran.status, ran.out) == (2, "")
        assert "--out: " in ran.err
    assert path.read_text("utf-8") == "mine"


def test_not_converged_is_4_and_no_result(run: Run) -> None:
    """Two particles and one iteration do not find a minimum but by a miracle; seed 1 has none."""
    few = ("--method", "pso", "--particles", 2, "--iterations", 1, "--seed", 1)
    for further in ((), ("--json",)):
        ran = run("solve", BUOY, *few, *further)
        assert (ran.status, ran.out) == (4, "")
        assert "did not converge" in ran.err


@pytest.mark.parametrize("status", [2, 3, 4])
def test_with_json_a_failure_prints_nothing_on_standard_output(
    run: Run, status: int, tmp_path: Path, too_short: Path
) -> None:
    arguments: dict[int, list[object]] = {
        2: [tmp_path / "missing.toml"],
        3: [too_short],
        4: [BUOY, "--method", "pso", "--particles", 2, "--iterations", 1],
    }
    ran = run("solve", *arguments[status], "--json")
    assert (ran.status, ran.out) == (status, "")
    assert ran.err.startswith("catopt: ")


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


def test_debug_shows_no_traceback_of_a_user_s_mistake(run: Run) -> None:
    ran = run("--debug", "solve", "no-such-file.toml")
    assert ran.status == 2
    assert "Traceback" not in ran.err


def test_an_interrupt_is_130_and_one_line(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupt(_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("catopt.catenary.case.solve_case", interrupt)
    ran = run("solve", BUOY)
    assert (ran.status, ran.out, ran.err) == (130, "", "catopt: interrupted\n")


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
    from catopt import __version__

    ran = run("--version")
    assert (ran.status, ran.out, ran.err) == (0, f"catopt {__version__}\n", "")
    for arguments in (["--help"], ["-h"], ["solve", "--help"], ["new", "-h"]):
        ran = run(*arguments)
        assert (ran.status, ran.err) == (0, "")
        assert ran.out.startswith("Usage: catopt")


def test_as_a_process() -> None:
    """The installed entry point and ``python -m catopt`` give the status to the shell."""
    command = [sys.executable, "-m", "catopt", "solve", "no-such-file.toml"]
    ran = subprocess.run(command, capture_output=True, check=False)
    assert (ran.returncode, ran.stdout) == (2, b"")


@pytest.mark.parametrize("command", ["solve", "check", "curve", "verify", "system", "report"])
def test_wrong_input_leaves_no_empty_directory(run: Run, tmp_path: Path, command: str) -> None:
    case = tmp_path / "wrong.toml"
    case.write_text("[site]\nwater_depht = 3\n", encoding="utf-8")
    ran = run(command, case, "--out", tmp_path / "out")
    assert ran.status == 2
    assert "water_depht" in ran.err
    assert [path.name for path in tmp_path.iterdir()] == ["wrong.toml"]
