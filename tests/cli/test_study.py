"""``catopt study``: several processes and machines, and that it goes on where it was stopped."""

from __future__ import annotations

import os
import random
import signal
import sqlite3
import subprocess
import sys
import time
from contextlib import closing
from pathlib import Path

import pytest

from .conftest import CASES, NAMED, OWN, Run, refused

CHAIN = CASES / "study-chain-56m" / "study.toml"
MANY = OWN / "many.toml"


def started(study: Path, out: Path, *options: str) -> subprocess.Popen[str]:
    words = [sys.executable, "-m", "catopt", "study", str(study), "--out", str(out), *options]
    return subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)


def wait_for(out: Path, pieces: int, process: subprocess.Popen[str]) -> None:
    """Wait until so many pieces are stored; fail where the command ends before."""
    while pieces_in(out) < pieces:
        assert process.poll() is None
        time.sleep(0.02)


def pieces_in(out: Path) -> int:
    if not (out / "study.sqlite").exists():
        return 0
    try:
        with closing(sqlite3.connect(out / "study.sqlite")) as database:
            (count,) = database.execute("SELECT count(*) FROM pieces").fetchone()
    except sqlite3.OperationalError:  # it is being made
        return 0
    return int(count)


@pytest.mark.slow
@pytest.mark.skipif(os.name == "nt", reason="there is no SIGKILL")
@pytest.mark.parametrize("workers", ["1", "2"])
def test_killed_at_any_moment_it_ends_with_the_same_bytes(tmp_path: Path, workers: str) -> None:
    started(MANY, tmp_path / "whole").communicate(timeout=300)
    rng = random.Random(3)
    for number in range(5):
        killed = started(MANY, tmp_path / "killed", "--workers", workers)
        wait_for(tmp_path / "killed", 10 * number + 1, killed)
        time.sleep(rng.uniform(0.0, 0.3))
        killed.kill()
        killed.communicate(timeout=60)
        assert 10 * number < pieces_in(tmp_path / "killed") < 60
    started(MANY, tmp_path / "killed", "--workers", workers).communicate(timeout=300)
    assert pieces_in(tmp_path / "killed") == 60
    for name in ("members.csv", "study.json", "study.csv"):
        ours = (tmp_path / "killed" / name).read_bytes()
        assert ours == (tmp_path / "whole" / name).read_bytes(), name


@pytest.mark.slow
@pytest.mark.skipif(os.name == "nt", reason="no Ctrl-C can be sent to another console there")
@pytest.mark.parametrize("workers", ["1", "2"])
def test_ctrl_c_says_how_to_go_on(tmp_path: Path, workers: str) -> None:
    stopped = started(MANY, tmp_path / "out", "--workers", workers)
    wait_for(tmp_path / "out", 5, stopped)
    stopped.send_signal(signal.SIGINT)
    _, err = stopped.communicate(timeout=60)
    assert stopped.returncode == 130
    assert "the same command continues" in err
    assert "Traceback" not in err


@pytest.mark.slow
def test_a_cluster_gives_the_same_bytes(run: Run, tmp_path: Path) -> None:
    distributed = pytest.importorskip("distributed")
    assert run("study", CHAIN, "--out", tmp_path / "here", "--workers", "2").status == 0
    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, dashboard_address=None
    ) as cluster:
        ran = run("study", CHAIN, "--out", tmp_path / "there",
                  "--scheduler", cluster.scheduler_address)  # fmt: skip
    assert ran.status == 0
    there = (tmp_path / "there" / "members.csv").read_bytes()
    assert there == (tmp_path / "here" / "members.csv").read_bytes()


@pytest.mark.slow
def test_no_scheduler_answers(run: Run) -> None:
    pytest.importorskip("distributed")
    ran = refused(run, "study", CHAIN, "--scheduler", "tcp://127.0.0.1:9")
    assert "no scheduler answers" in ran.err


@pytest.mark.slow
def test_parquet_is_the_table_of_members(run: Run, tmp_path: Path) -> None:
    pytest.importorskip("pyarrow")
    pandas = pytest.importorskip("pandas")
    ran = run("study", NAMED["STUDY"], "--out", tmp_path, "--parquet")
    assert ran.status == 0
    found = pandas.read_parquet(tmp_path / "members.parquet")
    assert found.equals(pandas.read_csv(tmp_path / "members.csv"))
    assert len(found) == 2000
