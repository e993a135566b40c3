"""Sizings that are run in motion from the page."""

from __future__ import annotations

import zipfile
from base64 import b64decode
from collections.abc import Iterator
from io import BytesIO
from threading import Event, Thread
from typing import Any

import pytest

import catopt
from catopt.page_api import ask, runs, shell
from catopt.page_api.fields import DOORS, START, Door
from catopt.progress import watched, watcher

QUESTION: dict[str, Any] = {"door": "buoy", "values": START["buoy"], "app": True}


@pytest.fixture(autouse=True)
def nothing_is_kept() -> Iterator[None]:
    yield
    runs._found.clear()


def test_a_watcher_is_told_while_the_body_runs_and_no_longer() -> None:
    told: list[tuple[float, float]] = []
    with watched(lambda *each: told.append(each)):
        watcher()(1, 4)
    watcher()(2, 4)
    assert told == [(1, 4)]


def test_a_run_says_how_far_it_is_and_stops_at_its_next_step(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The bar never goes back; what was answered before still stands."""
    reached, goes_on, found = Event(), Event(), {}

    def sized(_: Any) -> None:
        watcher()(3, 8)
        watcher()(2, 8)
        reached.set()
        assert goes_on.wait(30.0)
        watcher()(4, 8)

    monkeypatch.setattr(runs, "sized", sized)
    assert ask("progress", {}) == {}
    one = Thread(target=lambda: found.update(ask("run", QUESTION)))
    one.start()
    assert reached.wait(30.0)
    assert ask("progress", {}) == {"done": 3, "total": 8}
    assert ask("stop", {}) == {}
    goes_on.set()
    one.join()
    assert found == {"stopped": True}
    assert ask("progress", {}) == {}
    assert "Not judged: motion (button Run in motion)" in ask("live", QUESTION)["card"]


def test_what_was_run_is_what_card_document_and_note_have(monkeypatch: pytest.MonkeyPatch) -> None:
    """Another line than at rest, so that one sees which of them is shown."""
    other = catopt.size_buoy(buoy="pillar 1.8 m", depth="12 m", prefer="lightest", at_rest=True)
    monkeypatch.setattr(runs, "sized", lambda _: other)
    before = ask("whole", QUESTION)
    after = ask("run", QUESTION)
    assert other.one_line in after["card"]
    assert other.one_line not in before["card"]
    assert ask("whole", QUESTION)["card"] == after["card"]
    assert ask("size", QUESTION) == other.to_dict()
    assert ask("live", QUESTION | {"values": START["buoy"] | {"title": "other"}})["card"] not in {
        after["card"]
    }


def test_a_form_that_asks_for_runs_waits_for_the_button() -> None:
    values = START["buoy"] | {"motion.run": "true", "motion.seeds": "3"}
    asked = QUESTION | {"values": values}
    assert ask("live", asked)["card"] == ask("live", QUESTION)["card"]
    assert "[motion]" in ask("file", asked)["text"]


@pytest.mark.parametrize("door", DOORS)
def test_files_are_those_of_the_command(door: Door) -> None:
    reply = ask("files", {"door": door, "values": START[door], "lang": "vi"})
    with zipfile.ZipFile(BytesIO(b64decode(reply["base64"]))) as packed:
        names = packed.namelist()
        assert packed.testzip() is None
    ends = {name.rpartition(".")[2] for name in names}
    assert {"xlsx", "csv", "json", "svg"} <= ends
    assert reply["name"] == f"{door}.zip"


def test_buttons_for_runs_stand_where_lines_can_be_run() -> None:
    for name in ("run", "stop", "files"):
        assert f'data-do="{name}"' in shell(runs=True)
        assert f'data-do="{name}"' not in shell(runs=False)
