"""Notes in a browser: desktop and phone, light and dark, on paper, without scripts.

Wants Chromium (Debian's package ``chromium``).
"""

from __future__ import annotations

import re
import zlib
from collections.abc import Callable, Iterator
from contextlib import ExitStack, suppress
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from catopt.words import Language

from .browser import CHROMIUM, FONTS, Tab, chromium
from .notes import TURRET, note_named, page_of

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(not CHROMIUM, reason="no chromium on this machine"),
]

VIETNAMESE = ("leg", "harmonic", "arms", "given")
NAMES = (*VIETNAMESE, "slack", "designed", "swarm", "idle", "six")
"""Notes whose pages are looked at, some of them in Vietnamese."""
IN_PAGE = (Path(__file__).parent / "in_page.js").read_text("utf-8")
A4 = (210.0 / 25.4 * 72.0, 297.0 / 25.4 * 72.0)
"""In points."""


@pytest.fixture(scope="session")
def browsers(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Callable[[str], Tab]]:
    """Start a browser for each font that is asked for."""
    with ExitStack() as started:
        yield cache(
            lambda font: started.enter_context(chromium(tmp_path_factory.mktemp("browser"), font))
        )


@pytest.fixture
def font() -> str:
    """Name the font of the pages; tests that measure words take all of `FONTS`."""
    return FONTS[0]


@pytest.fixture
def tab(browsers: Callable[[str], Tab], font: str) -> Tab:
    return browsers(font)


@pytest.fixture
def quiet(tab: Tab) -> Iterator[Tab]:
    """Give the tab, and see afterwards that nothing was said and nothing else was asked for."""
    tab.messages.clear()
    tab.requests.clear()
    yield tab
    assert tab.messages == []
    assert len(set(tab.requests)) == 1


@pytest.fixture(params=NAMES)
def page(request: pytest.FixtureRequest, tmp_path: Path) -> Path:
    return written(tmp_path, request.param, "vi" if request.param in VIETNAMESE else "en")


def written(folder: Path, name: str, language: Language = "en") -> Path:
    path = folder / f"{name}.html"
    path.write_bytes(page_of(note_named(name), language))
    return path


def asked(tab: Tab, question: str) -> Any:
    """Ask the page that is open what one of the functions in in_page.js answers."""
    return tab.value(f"{IN_PAGE}\n{question}")


@pytest.mark.parametrize("font", FONTS)
@pytest.mark.parametrize("width", [1200, 390])
def test_nothing_sticks_out(quiet: Tab, page: Path, width: int, font: str) -> None:
    """A page is no wider than its window, and drawings hold their words apart."""
    quiet.open(page, width, scheme="dark" if font == "Liberation Sans" else "light")
    assert quiet.value("document.documentElement.scrollWidth") <= width
    for found in ("beyond()", "offPaper()", "clashes()"):
        assert asked(quiet, found) == []


def test_the_colours_follow_the_readers_choice_and_every_text_stands_out(
    quiet: Tab, page: Path
) -> None:
    """By the contrast that WCAG asks of small text, 4.5, in both schemes."""

    def brightness(element: str, of: str) -> int:
        found = re.findall(r"\d+", asked(quiet, f"styleOf('{element}').{of}"))
        return sum(int(part) for part in found[:3])

    quiet.open(page, 1200, scheme="light")
    frame = brightness(".frame", "stroke")
    assert brightness("body", "backgroundColor") > brightness("body", "color")
    assert asked(quiet, "faint()") == []
    quiet.open(page, 1200, scheme="dark")
    assert brightness("body", "backgroundColor") < brightness("body", "color")
    assert brightness(".frame", "stroke") != frame
    assert asked(quiet, "faint()") == []


@pytest.mark.parametrize("width", [1200, 390])
def test_pointing_at_a_figure_reads_it(quiet: Tab, page: Path, width: int) -> None:
    quiet.open(page, width)
    hint = "Di con trỏ" if page.stem in VIETNAMESE else "Point at"
    figures = asked(quiet, "figures()")
    assert figures
    assert all(height > 100 for _, height in figures)
    for figure, _ in figures:
        assert asked(quiet, f"readout('{figure}')").startswith(hint)
        for share in (0.0, 0.4, 1.0):
            x, y, texts = asked(quiet, f"place('{figure}', {share})")
            quiet.point_at(x, y)
            assert asked(quiet, f"readout('{figure}')") in texts
    assert asked(quiet, "styleOf('figure.on .pointer').visibility") == "visible"


def test_the_arrow_keys_walk_from_end_to_end(quiet: Tab, page: Path) -> None:
    quiet.open(page, 1200)
    figure, height = asked(quiet, "figures()")[0]
    assert height > 100
    said = [asked(quiet, f"focused('{figure}')")]
    for key in ("End", "ArrowLeft", "Home"):
        quiet.press(key)
        said.append(asked(quiet, f"readout('{figure}')"))
    assert said[0] == said[-1]
    assert len(set(said)) == 3


def test_the_arrow_keys_go_round_the_watch_circle(quiet: Tab, tmp_path: Path) -> None:
    quiet.open(written(tmp_path, TURRET), 1200)
    assert asked(quiet, "focused('system_watch')").startswith("force towards 0.00 deg")
    quiet.press("End")
    assert asked(quiet, "readout('system_watch')").startswith("force towards 357.00 deg")


def test_everything_is_readable_without_scripts(quiet: Tab, page: Path) -> None:
    """But for the hint about pointing, which would be of no use then."""
    quiet.open(page, 1200)
    with_scripts = asked(quiet, "words()")
    quiet.open(page, 1200, scripts=False)
    assert asked(quiet, "words()") == with_scripts
    assert quiet.value("document.querySelector('.readout').textContent") == ""
    assert len(with_scripts) > 14


@pytest.mark.parametrize("font", FONTS)
def test_it_prints_on_a4(quiet: Tab, page: Path) -> None:
    quiet.open(page, 1200, scheme="dark")
    boxes, count = pages_of(quiet.pdf())
    assert 4 <= count <= 26  # four load cases with two bodies take the most
    for width, height in boxes:
        assert (width, height) == pytest.approx(A4, abs=1.0)  # a point, by which sizes are rounded


def pages_of(pdf: bytes) -> tuple[set[tuple[float, float]], int]:
    """Return the sizes of a PDF's pages, and how many there are."""
    text = pdf
    for each in re.findall(rb"stream\r?\n(.*?)\r?\nendstream", pdf, re.DOTALL):
        with suppress(zlib.error):
            text += zlib.decompress(each)
    boxes = {
        (float(box[1]), float(box[2]))
        for box in re.finditer(rb"/MediaBox ?\[ ?0 0 ([\d.]+) ([\d.]+) ?\]", text)
    }
    return boxes, len(re.findall(rb"/Type ?/Page\b", text))


@pytest.mark.parametrize("font", FONTS)
def test_tables_fit_the_paper(quiet: Tab, page: Path) -> None:
    """On paper nothing scrolls: what is wider than its box would be cut off."""
    quiet.open(page, 680)  # 180 mm at 96 dots an inch, what the margins leave
    quiet.call("Emulation.setEmulatedMedia", media="print")
    assert asked(quiet, "wideTables()") == []
    quiet.call("Emulation.setEmulatedMedia", media="")


def test_a_message_and_a_box_that_sticks_out_are_noticed(tab: Tab, tmp_path: Path) -> None:
    path = tmp_path / "broken.html"
    path.write_text(
        "<!DOCTYPE html><body><div style='width:3000px'>wide</div>"
        "<figure><svg viewBox='0 0 100 100'><text x='90' y='50'>far too long</text>"
        "<text x='90' y='50'>on it</text></svg></figure>"
        "<script>console.log('said'); throw new Error('thrown')</script>"
    )
    tab.messages.clear()
    tab.open(path, 800)
    assert len(tab.messages) == 2
    assert tab.value("document.documentElement.scrollWidth") > 800
    assert len(asked(tab, "beyond()")) == 1
    assert "far too long" in asked(tab, "offPaper()")
    assert len(asked(tab, "clashes()")) == 1
    tab.messages.clear()


@pytest.mark.parametrize("font", FONTS)
def test_a_page_is_shown_in_one_font(tab: Tab, font: str, tmp_path: Path) -> None:
    """All three are required: Debian's fonts-dejavu-core, fonts-liberation and fonts-noto-core."""
    tab.open(written(tmp_path, "leg"), 800)
    assert tab.fonts() == {font}
