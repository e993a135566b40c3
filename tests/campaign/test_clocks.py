"""A clock that is set back or forward, and other zones: the same files to the last byte.

A machine wakes up, asks for the time and finds itself in another year; nothing that catopt answers
hangs on it. What measures how long something takes may see a night pass between two looks.
`python -m tests.campaign.test_clocks COUNT` tries more clocks.
"""

from __future__ import annotations

import contextlib
import io
import os
import random
import sys
import time
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest

from catopt import compiled, progress
from catopt.__main__ import main
from catopt.catenary import batch
from catopt.design import search
from catopt.mooring import zero_load
from catopt.report import bundle as files
from catopt.study import run as study_run

pytestmark = pytest.mark.slow

ROOT = Path(__file__).parents[2]
CASES = ROOT / "cases"
DESIGN = (CASES / "design-buoy-9.5m/case.toml").read_text(encoding="utf-8").replace(
    'length_step = "0.5 m"', 'length_step = "8 m"'
)  # fmt: skip
STUDY = (
    (CASES / "study-buoy-9.5m/study.toml")
    .read_text(encoding="utf-8")
    .replace("samples = 1000", "samples = 30000")
    .replace("../buoy-9.5m", (CASES / "buoy-9.5m").as_posix())
)
COMMANDS = (
    ("solve", str(CASES / "tanker-20m-sinker/case.toml")),
    ("report", str(CASES / "tanker-20m-sinker/case.toml")),
    ("curve", str(CASES / "tanker-20m/case.toml")),
    ("system", str(CASES / "fso-rang-dong/case.toml"), "--line-out", "--watch-circle"),
    ("design", "design.toml"),
    ("study", "study.toml", "--workers", "1"),
)
DAY = 86400.0
ZONES = ("UTC", "Asia/Ho_Chi_Minh", "Pacific/Kiritimati", "America/St_Johns")

Clock = Callable[[], float]


def jumping(seed: int, clock: Clock, *, back: bool) -> Clock:
    """Make a clock that now and then is set forward by up to years, or back too."""
    rng = random.Random(seed)
    ahead = 0.0

    def now() -> float:
        nonlocal ahead
        if rng.random() < 0.3:
            ahead += 10.0 ** rng.uniform(0.0, 8.0) * (rng.choice([-1.0, 1.0]) if back else 1.0)
        return clock() + ahead

    return now


def answers(folder: Path) -> dict[str, bytes]:
    """Run every command with --out; all files but the store, whose pages are SQLite's own."""
    (folder / "design.toml").write_text(DESIGN, encoding="utf-8")
    (folder / "study.toml").write_text(STUDY, encoding="utf-8")
    before = Path.cwd()
    os.chdir(folder)
    try:
        for number, command in enumerate(COMMANDS):
            assert main([*command, "--out", f"out-{number}"]) == 0, command
        # What was begun before the clock was set is gone on with after it.
        assert main([*COMMANDS[-1], "--out", f"out-{len(COMMANDS) - 1}"]) == 0
    finally:
        os.chdir(before)
    return {
        str(path.relative_to(folder)): path.read_bytes()
        for path in sorted(folder.rglob("*"))
        if path.is_file() and path.suffix != ".sqlite"
    }


@pytest.fixture(scope="module")
def due(tmp_path_factory: pytest.TempPathFactory) -> dict[str, bytes]:
    return answers(tmp_path_factory.mktemp("due"))


@pytest.mark.parametrize("seed", range(2))
def test_a_clock_that_jumps_changes_no_byte(
    seed: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, due: dict[str, bytes]
) -> None:
    found = with_jumps(seed, tmp_path, monkeypatch)
    assert sorted(found) == sorted(due)
    assert [name for name in due if found[name] != due[name]] == []


def with_jumps(seed: int, folder: Path, patch: pytest.MonkeyPatch) -> dict[str, bytes]:
    """Answer everything by clocks that jump, in another zone."""
    patch.setattr(files, "time", jumping(seed, time.time, back=True))
    patch.setattr(time, "time", jumping(seed, time.time, back=True))
    passing = jumping(seed, time.perf_counter, back=False)
    for part in (progress, zero_load, batch, study_run):
        patch.setattr(part, "perf_counter", passing)
    assert vars(search)["time"] is time
    patch.setattr(time, "perf_counter", passing)
    patch.setattr(compiled, "_now", jumping(seed, time.process_time, back=False))
    patch.setenv("TZ", ZONES[seed % len(ZONES)])
    time.tzset()
    try:
        return answers(folder)
    finally:
        patch.undo()
        time.tzset()


def test_a_temporary_file_of_another_run_outlives_a_clock_set_back(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """And one of a run that was killed days ago is swept away when the clock is right again."""
    place = tmp_path / ".solve.json.1.tmp"
    place.write_bytes(b"half of it")
    monkeypatch.setattr(files, "time", lambda: time.time() - 400.0 * DAY)
    files.write_files(tmp_path, {"a.txt": b"a"})
    assert place.exists()
    monkeypatch.setattr(files, "time", lambda: time.time() + 400.0 * DAY)
    files.write_files(tmp_path, {"a.txt": b"a"})
    assert not place.exists()
    assert (tmp_path / "a.txt").read_bytes() == b"a"


if __name__ == "__main__":
    with TemporaryDirectory() as made, contextlib.redirect_stdout(io.StringIO()):
        (Path(made) / "due").mkdir()
        expected = answers(Path(made) / "due")
        for number in range(int(sys.argv[1])):
            place = Path(made) / str(number)
            place.mkdir()
            same = with_jumps(number, place, pytest.MonkeyPatch()) == expected
            sys.stderr.write(f"{number}: {'the same' if same else 'differs'}\n")
