"""The note of a sizing in a browser: desktop and phone, light and dark, on paper.

Wants Chromium (Debian's package ``chromium``).
"""

from __future__ import annotations

from pathlib import Path
from typing import Literal

import pytest

from catopt.report.page.render import render_page

from .browser import CHROMIUM, FONTS, Tab, assert_nothing_sticks_out
from .size_page_cases import known_size_note
from .test_page_browser import A4, READOUT, pages_of, place_on

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(not CHROMIUM, reason="no chromium on this machine"),
]

NAMES = {"size-buoy": "en", "size-tanker": "vi", "six": "en", "hawser": "vi", "given": "en"}
"""Sizings with the language of their page."""


@pytest.fixture(params=NAMES)
def page(request: pytest.FixtureRequest, tmp_path: Path) -> Path:
    name = str(request.param)
    path = tmp_path / f"{name}.html"
    language: Literal["en", "vi"] = "vi" if NAMES[name] == "vi" else "en"
    path.write_bytes(render_page(known_size_note(name), language))
    return path


@pytest.mark.parametrize("font", FONTS)
@pytest.mark.parametrize("width", [1200, 390])
def test_nothing_sticks_out(quiet: Tab, page: Path, width: int, font: str) -> None:
    assert_nothing_sticks_out(quiet, page, width, font)


def test_every_text_stands_out_from_its_ground(quiet: Tab, page: Path) -> None:
    """By the contrast that WCAG asks of small text, 4.5, in both schemes."""
    for scheme in ("light", "dark"):
        quiet.open(page, 1200, scheme="dark" if scheme == "dark" else "light")
        assert quiet.value(FAINT) == []


FAINT = """(() => {
  const parts = (colour) => colour.match(/[\\d.]+/g).map(Number);
  const light = ([r, g, b]) => [r, g, b].map((each) => {
    const part = each / 255;
    return part <= 0.03928 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4;
  }).reduce((sum, part, index) => sum + part * [0.2126, 0.7152, 0.0722][index], 0);
  const ground = (element) => {
    for (let each = element; each; each = each.parentElement) {
      const colour = parts(getComputedStyle(each).backgroundColor);
      if (colour.length < 4 || colour[3] > 0) return colour;
    }
    return [255, 255, 255];
  };
  return [...document.querySelectorAll("p, li, td, th, h1, h2, h3, span, caption, dt, dd")]
    .filter((each) => {
      const [a, b] = [light(parts(getComputedStyle(each).color)), light(ground(each))];
      return (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05) < 4.5;
    }).map((each) => each.outerHTML.slice(0, 100));
})()"""
"""Elements whose words are too near in brightness to what is behind them."""


@pytest.mark.parametrize("width", [1200, 390])
def test_pointing_at_a_figure_reads_it(quiet: Tab, page: Path, width: int) -> None:
    quiet.open(page, width)
    for figure in ("front", "line", "tension", "curve"):
        hint = "Di con trỏ" if NAMES[page.stem] == "vi" else "Point at"
        assert quiet.value(READOUT.format(figure)).startswith(hint)
        for share in (0.0, 0.5, 1.0):
            x, y, texts = place_on(quiet, figure, share)
            quiet.point_at(x, y)
            assert quiet.value(READOUT.format(figure)) in texts


def test_everything_is_readable_without_scripts(quiet: Tab, page: Path) -> None:
    words = (
        "[...document.querySelectorAll('h1, h2, h3, table, figcaption, pre')]"
        ".map((e) => e.innerText)"
    )
    quiet.open(page, 1200)
    with_scripts = quiet.value(words)
    quiet.open(page, 1200, scripts=False)
    assert quiet.value(words) == with_scripts
    assert len(with_scripts) > 30


@pytest.mark.parametrize("font", FONTS)
def test_it_prints_on_a4(quiet: Tab, page: Path) -> None:
    quiet.open(page, 1200, scheme="dark")
    boxes, count = pages_of(quiet.pdf())
    assert 6 <= count <= 24  # four load cases with two bodies take the most
    for width, height in boxes:
        assert (width, height) == pytest.approx(A4, abs=1.0)  # a point, by which sizes are rounded


@pytest.mark.parametrize("font", FONTS)
def test_tables_fit_the_paper(quiet: Tab, page: Path) -> None:
    """On paper nothing scrolls: what is wider than its box would be cut off."""
    quiet.open(page, 680)  # 180 mm at 96 dots an inch, what the margins leave
    quiet.call("Emulation.setEmulatedMedia", media="print")
    wide = (
        "[...document.querySelectorAll('.scroll > table')].filter((each) => "
        "each.getBoundingClientRect().width > each.parentElement.getBoundingClientRect().width + 1)"
        ".map((each) => each.dataset.key)"
    )
    assert quiet.value(wide) == []
    quiet.call("Emulation.setEmulatedMedia", media="")
