"""``catopt app`` in Chromium: every button of every door, and a run in motion with bar and stop."""

from __future__ import annotations

import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from catopt.page_api import ask, runs
from catopt.page_api.fields import DOORS, START
from catopt.web.build import PageServer
from catopt.words import LANGUAGES
from tests.report.browser import CHROMIUM, Tab, chromium
from tests.web.test_in_browser import choose, displayed, wait

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(not CHROMIUM, reason="no chromium on this machine"),
]

KEEP = """(() => {
  window.made = [];
  URL.createObjectURL = (blob) => { made.push(blob.type); return "#"; };
  HTMLAnchorElement.prototype.click = () => {};
  navigator.clipboard.writeText = async (text) => { window.copied = text; };
})()"""
SHOWN = "[...document.querySelectorAll('.actions button')].filter((e) => !e.hidden)"
TYPES = ["text/html", "application/toml", "application/json", "application/zip"]
MOST = 300.0
"""s, that a run of a ship may take on a busy machine, the first with what it compiles."""


@pytest.fixture(scope="module", autouse=True)
def no_runs_left() -> Iterator[None]:
    """Forget what was run."""
    yield
    runs._found.clear()


@pytest.fixture
def tab(tmp_path: Path, server: PageServer) -> Iterator[Tab]:
    with chromium(tmp_path) as opened:
        opened.call("Page.navigate", url=server.address)
        time.sleep(1.0)
        wait(opened)
        opened.value(KEEP)
        yield opened


def press(tab: Tab, name: str) -> None:
    tab.value(f"document.querySelector('[data-do={name}]').click()")


def state(tab: Tab) -> str:
    said: str = tab.value("document.querySelector('.status').dataset.now")
    return said


def until(tab: Tab, wanted: str, most: float = 60.0) -> None:
    end = time.monotonic() + most
    while state(tab) != wanted:
        assert time.monotonic() < end, (state(tab), wanted)
        time.sleep(0.1)


@pytest.mark.parametrize("door", DOORS)
def test_every_button_but_the_run_gives_what_it_says(tab: Tab, door: str) -> None:
    choose(tab, "door", door)
    for language in LANGUAGES:
        choose(tab, "lang", language)
        names = tab.value(f"{SHOWN}.map((each) => each.dataset.do)")
        own = ["run"] if door in ("buoy", "tanker") else []
        assert names == ["note", "save", "compare", "link", "document", "files", *own]
        tab.value("window.made = []")
        for name in ("note", "save", "document", "files"):
            count = tab.value("made.length")
            press(tab, name)
            end = time.monotonic() + 60.0
            while tab.value("made.length") == count:
                assert time.monotonic() < end, (name, state(tab))
                time.sleep(0.1)
        assert tab.value("made") == TYPES
        press(tab, "compare")
        wait(tab)
        assert tab.value("document.querySelector('.compared').textContent.trim()") != ""
        press(tab, "link")
        assert language in tab.value("window.copied")
    assert tab.messages == []


def test_a_unit_is_that_of_every_value_and_assumptions_open_by_keyboard(tab: Tab) -> None:
    choose(tab, "door", "buoy")
    field = "document.getElementById('buoy-motion.peak_periods')"
    menu = "document.querySelector('[data-unit-of=\"buoy-motion.peak_periods\"]')"
    tab.value(f"{field}.closest('details').open = true")
    tab.value(f"{field}.value = '6 s; 8 s'; {menu}.value = 'min'")
    tab.value(f"{menu}.dispatchEvent(new Event('change', {{ bubbles: true }}))")
    assert tab.value(f"{field}.value") == "6 min; 8 min"
    tab.value(
        f"{field}.value = ''; {field}.dispatchEvent(new Event('change', {{ bubbles: true }}))"
    )
    wait(tab)
    brief = "document.querySelector('.card .brief')"
    clamp = f"getComputedStyle({brief}).webkitLineClamp"
    assert tab.value(clamp) in ("1", "2")
    tab.value(f"{brief}.focus()")
    assert tab.value(clamp) == "none"
    tab.value(f"{brief}.blur()")
    tab.call("Emulation.setEmulatedMedia", media="print")
    assert tab.value(clamp) == "none"


def test_a_run_has_a_bar_is_stopped_and_ends_in_the_verdict_of_the_command(tab: Tab) -> None:
    choose(tab, "door", "tanker")
    before = displayed(tab)
    assert "Not judged: motion (button Run in motion)" in before
    press(tab, "run")
    until(tab, "running")
    assert not tab.value("document.querySelector('.progress').hidden")
    assert not tab.value("document.querySelector('[data-do=stop]').hidden")
    press(tab, "stop")
    until(tab, "stopped", MOST)
    assert displayed(tab) == before
    assert tab.value("document.querySelector('[data-do=stop]').hidden")
    press(tab, "run")
    until(tab, "running")
    parts = set()
    end = time.monotonic() + MOST
    while state(tab) == "running":
        assert time.monotonic() < end
        parts.add(tab.value("document.querySelector('.progress').value"))
        time.sleep(0.2)
    assert state(tab) == "ready"
    assert len(parts) > 2
    question = {"door": "tanker", "values": START["tanker"], "app": True}
    found = ask("size", question)
    assert found["verdict"]["colour"] == "green"
    assert found["verdict"]["said"] in displayed(tab)
    assert found["in_motion"]["checks"]
    for language in LANGUAGES:  # in the same words as before, and without another run
        choose(tab, "lang", language)
        assert "motion (button" not in displayed(tab)
    assert tab.messages == []
