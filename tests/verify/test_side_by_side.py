"""Seeds in processes of their own: the digits of one after the other, and an orderly end."""

from __future__ import annotations

import gc
import os
import pickle
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from multiprocessing.synchronize import SemLock
from pathlib import Path

import numpy as np
import pytest

from catopt.errors import CatoptError, InputError, NoEquilibriumError, NotConvergedError
from catopt.model import Case, Motion, WaveState
from catopt.verify import dynamic
from catopt.verify.dynamic import verify_dynamic
from catopt.verify.motion_words import stopped_sentence
from catopt.verify.side_by_side import Crew, side_by_side

from . import tasks
from .tasks import ends, fails, has_nothing_yet, refuses, says_it_is_through, silent
from .test_dynamic import EXAMPLE, chain


def sea(runs: int, duration: float = 20.0) -> Case:
    waves = WaveState("jonswap", 2.0, 6.0, components=20)
    return chain(
        Motion(period=6.0, surge=0.2), duration, waves=waves, runs=runs, time_step=0.1, elements=10
    )


def test_the_digits_are_those_of_one_after_the_other() -> None:
    told: list[float] = []
    first = verify_dynamic(sea(3))
    second = verify_dynamic(sea(3), workers=2, progress=lambda at, end: told.append(at / end))
    alone, together = first.parts[0], second.parts[0]
    assert [run.number for run in together.runs] == [0, 1, 2]
    for one, other in zip(alone.runs, together.runs, strict=True):
        assert np.array_equal(one.history.fairlead_tension, other.history.fairlead_tension)
        assert np.array_equal(one.history.max_tension, other.history.max_tension)
        # The proof at half the step goes along.
        assert one.again == other.again != ()
    assert first.to_dict() == second.to_dict()
    # Progress is of all runs together.
    assert told == sorted(told)
    assert told[-1] == 1.0


@pytest.mark.slow
def test_what_is_whole_is_kept_when_it_is_stopped() -> None:
    """Stopped when two of six are through: none is short, and the answer says how many."""

    def stop(at: int, end: int) -> None:
        if at / end > 0.45:
            raise KeyboardInterrupt

    found = verify_dynamic(sea(6, 400.0), convergence_check="none", workers=2, progress=stop)
    (part,) = found.parts
    assert not found.is_complete
    assert 0 < len(part.runs) < 6
    assert part.is_complete
    assert f"stopped after {len(part.runs)} of 6 runs" in part.remarks
    assert f"after {len(part.runs)} of 6 runs; results computed" in stopped_sentence(found)


@pytest.mark.slow
def test_one_stopped_run_is_kept_when_none_is_whole() -> None:
    def stop(at: int, end: int) -> None:
        if at / end > 0.2:  # one of the two at least is beyond its ramp, a tenth of the run
            raise KeyboardInterrupt

    found = verify_dynamic(sea(2, 12000.0), convergence_check="none", workers=2, progress=stop)
    (run,) = found.parts[0].runs
    assert not run.history.is_complete
    assert "stopped in run 1 of 2" in found.parts[0].remarks


def test_a_run_that_is_stopped_at_its_very_end_is_whole() -> None:
    """Its last word is that it is through: Ctrl-C then takes nothing from it."""

    def stop(at: int, end: int) -> None:
        if at == end:
            raise KeyboardInterrupt

    found = verify_dynamic(sea(1), convergence_check="step", workers=1, progress=stop)
    assert found.is_complete
    assert len(found.parts[0].runs[0].again) == 1


def test_every_run_may_be_stopped_at_its_very_end() -> None:
    assert side_by_side(says_it_is_through, 2, 2, stop_at_once) == [0, 1]


def stop_at_once(*_: int) -> None:
    raise KeyboardInterrupt


def test_a_run_that_has_nothing_when_it_is_stopped_is_left_out() -> None:
    assert side_by_side(has_nothing_yet, 2, 2, stop_at_once) == []


def test_an_error_of_a_run_is_that_of_all() -> None:
    with pytest.raises(NotConvergedError, match="t = 3 s"):
        side_by_side(fails, 3, 2, silent)


def test_every_problem_of_an_input_comes_through() -> None:
    with pytest.raises(InputError) as caught:
        side_by_side(refuses, 2, 2, silent)
    (problem,) = caught.value.problems
    assert (problem.key, problem.found) == ("workers", "0")


@pytest.mark.slow
@pytest.mark.parametrize("task", ["fails", "ends"])
def test_nothing_shared_outlives_an_error(task: str) -> None:
    """A semaphore that a collection of garbage takes away may come in the way of a new one."""
    gc.collect()
    gc.disable()
    try:
        with pytest.raises(CatoptError):
            side_by_side(getattr(tasks, task), 2, 2, silent)
        assert not [each for each in gc.get_objects() if issubclass(type(each), SemLock)]
    finally:
        gc.enable()


def test_what_is_missing_comes_through_with_the_error() -> None:
    error = pickle.loads(pickle.dumps(NoEquilibriumError("too short", "length", 2.5)))
    assert (str(error), error.quantity, error.missing) == ("too short", "length", 2.5)


def test_a_process_that_ends_on_its_own_is_told() -> None:
    with pytest.raises(CatoptError, match="--workers 1"):
        side_by_side(ends, 2, 2, silent)


def test_short_work_is_done_in_one_process(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[int] = []

    def aside(*args: object) -> list[object]:
        asked.append(args[2])  # type: ignore[arg-type]
        raise KeyboardInterrupt

    monkeypatch.setattr(dynamic, "side_by_side", aside)
    monkeypatch.setattr(os, "cpu_count", lambda: 4)
    assert len(verify_dynamic(sea(2), convergence_check="none").parts[0].runs) == 2
    assert asked == []
    with pytest.raises(KeyboardInterrupt):
        verify_dynamic(sea(3, 1e5), convergence_check="none")
    assert asked == [3]


def test_a_script_without_a_guard_may_run_seeds_side_by_side(tmp_path: Path) -> None:
    script = tmp_path / "script.py"
    script.write_text(
        "from tests.verify.test_side_by_side import sea\n"
        "from catopt import verify_dynamic\n"
        "print('once')\n"
        "print(len(verify_dynamic(sea(2), convergence_check='none', workers=2).parts[0].runs))\n",
        encoding="utf-8",
    )
    done = subprocess.run(
        [sys.executable, str(script)],
        env={**os.environ, "PYTHONPATH": str(Path(__file__).parents[2])},
        capture_output=True,
        text=True,
        check=False,
        timeout=300,
    )
    assert (done.returncode, done.stdout.split()) == (0, ["once", "2"]), done.stderr


@pytest.mark.slow
@pytest.mark.skipif(sys.platform == "win32", reason="sends a signal")
def test_ctrl_c_ends_all_in_order(tmp_path: Path) -> None:
    """As a terminal sends it, to every process of the command at once."""
    path = tmp_path / "sea.toml"
    text = EXAMPLE.read_text("utf-8").replace('"5 min"', '"12 h"\nruns = 4\nelements = 10')
    path.write_text(text.replace("rao.csv", str(EXAMPLE.parent / "rao.csv")), encoding="utf-8")
    command = [
        sys.executable, "-m", "catopt", "verify", str(path), "--dynamic", "--once", "--workers",
        "2", "--full",
    ]  # fmt: skip
    started = subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True
    )
    time.sleep(25.0)
    os.killpg(started.pid, signal.SIGINT)
    out, err = started.communicate(timeout=60.0)
    assert started.returncode == 130, err
    assert "stopped in load case load" in err
    assert "Traceback" not in err
    assert "NOT PROVEN" in out


@pytest.mark.slow
@pytest.mark.skipif(not Path("/proc/self/stat").exists(), reason="looks in /proc")
def test_runs_end_with_the_process_that_started_them(tmp_path: Path) -> None:
    script = tmp_path / "script.py"
    script.write_text(
        "from tests.verify.tasks import silent, writes_on\n"
        "from catopt.verify.side_by_side import side_by_side\n"
        "side_by_side(writes_on, 2, 2, silent)\n",
        encoding="utf-8",
    )
    env = {
        **os.environ,
        "PYTHONPATH": str(Path(__file__).parents[2]),
        "CATOPT_TEST_ALIVE": str(tmp_path),
    }
    started = subprocess.Popen([sys.executable, str(script)], env=env)
    _until(lambda: (tmp_path / "0").exists() and (tmp_path / "1").exists())
    runs = [int((tmp_path / name).read_text("utf-8") or 0) for name in "01"]
    started.kill()
    started.wait()
    _until(lambda: not any(_lives(run) for run in runs))


def _until(is_so: Callable[[], bool], seconds: float = 120.0) -> None:
    end = time.monotonic() + seconds
    while not is_so():
        assert time.monotonic() < end
        time.sleep(0.1)


def _lives(process: int) -> bool:
    try:
        return "(python" in Path(f"/proc/{process}/stat").read_text("utf-8")
    except (FileNotFoundError, ProcessLookupError):
        return False


@pytest.mark.parametrize("workers", [1, 2])
def test_a_crew_does_one_thing_after_another(workers: int) -> None:
    with Crew(workers) as crew:
        first = crew.each(tasks.double, 3, silent)
        assert crew.each(tasks.double, 2, silent) == first[:2] == [0, 2]
