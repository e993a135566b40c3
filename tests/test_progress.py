"""What takes long is announced once, by the time of its first steps."""

from __future__ import annotations

import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from catopt import progress
from catopt.__main__ import main
from catopt.mooring import zero_load
from catopt.progress import expect, in_words, paced, when_long
from catopt.words import Message, say

WHAT = Message("words.curve_points", total=50)
CASE = """
[site]
water_depth = "100 m"
[line]
[[line.segments]]
length = "600 m"
submerged_weight = "1000 N/m"
EA = "800 MN"
[system]
anchor_radius = "560 m"
azimuths = ["0 deg", "90 deg", "180 deg", "270 deg"]
force = ["400 kN", "0 kN"]
fairlead_radius = "10 m"
moment = "100 kN m"
"""


@pytest.fixture
def told() -> Iterator[list[str]]:
    found: list[str] = []
    when_long(found.append)
    yield found
    progress._when_long.clear()


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> list[float]:
    now = [0.0]
    monkeypatch.setattr(progress, "perf_counter", lambda: now[0])
    return now


def walk(clock: list[float], seconds: list[float]) -> list[int]:
    """Take the steps of a search, each with its own time; how many were done when it was told."""
    done = []
    for step in paced(WHAT, range(len(seconds))):
        clock[0] += seconds[step]
        done.append(step)
    return done


def test_a_long_search_says_so_once_and_how_long(told: list[str], clock: list[float]) -> None:
    assert walk(clock, [1.5] * 50) == list(range(50))
    assert told == ["curve of 50 points: some 75 s on this machine"]


def test_a_short_one_says_nothing(told: list[str], clock: list[float]) -> None:
    walk(clock, [0.19] * 50)
    assert told == []


def test_a_first_step_that_compiles_is_not_taken_for_all(
    told: list[str], clock: list[float]
) -> None:
    walk(clock, [1.9, *[0.1] * 49])
    assert told == []


def test_a_first_step_of_a_minute_is_told_before_the_second(
    told: list[str], clock: list[float]
) -> None:
    steps = paced(WHAT, iter("ab"), 2)
    next(steps)
    clock[0] = 60.0
    next(steps)
    assert told == ["curve of 50 points: some 2 min on this machine"]


def test_it_is_said_in_the_language_of_the_user() -> None:
    message = Message("words.takes_long", what=WHAT, time=in_words(7200.0))
    assert say(message, "vi") == "đường cong với 50 điểm: khoảng 2 giờ trên máy này"
    assert [str(in_words(each)) for each in (11.0, 150.0, 3e5)] == ["11 s", "2 min", "3 days"]


def test_what_is_estimated_at_ten_seconds_is_not_long(told: list[str]) -> None:
    expect(WHAT, 10.0)
    assert told == []
    expect(WHAT, 10.1)
    assert len(told) == 1


def test_commands_announce_their_searches(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """As on a machine ten thousand times slower: its clock runs so."""
    for part in (progress, zero_load):
        monkeypatch.setattr(part, "perf_counter", lambda: 1e4 * time.perf_counter())
    path = tmp_path / "case.toml"
    path.write_text(CASE)
    asked = ["--line-out", "--watch-circle", "--curve", "0 deg", "--level", "1 m", "--level", "2 m"]
    assert main(["system", str(path), *asked, "--json"]) == 0
    said = capsys.readouterr().err
    wanted = (
        "each of 4 lines out",
        "120 directions",
        "41 offsets",
        "2 water levels",
        "other headings",
    )
    assert [part for part in wanted if said.count(part) != 1] == []
