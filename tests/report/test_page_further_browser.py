"""The swarm and the line in motion in a browser: nothing sticks out, and the figures are read.

Wants Chromium (Debian's package ``chromium``).
"""

from __future__ import annotations

from pathlib import Path

import pytest

from catopt.report.page.render import render_page

from .browser import CHROMIUM, FONTS, Tab, assert_nothing_sticks_out
from .further_cases import further_note
from .test_page_browser import READOUT, pages_of, place_on

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(not CHROMIUM, reason="no chromium on this machine"),
]

FIGURES = {"swarm": ["swarm"], "harmonic": ["motion", "envelope"], "random": ["motion", "envelope"]}


@pytest.fixture(params=FIGURES)
def page(request: pytest.FixtureRequest, tmp_path: Path) -> Path:
    name = str(request.param)
    path = tmp_path / f"{name}.html"
    path.write_bytes(render_page(further_note(name), "vi" if name == "random" else "en"))
    return path


@pytest.mark.parametrize("font", FONTS)
@pytest.mark.parametrize("width", [1200, 390])
def test_nothing_sticks_out(quiet: Tab, page: Path, width: int, font: str) -> None:
    assert_nothing_sticks_out(quiet, page, width, font)


@pytest.mark.parametrize("width", [1200, 390])
def test_pointing_at_a_figure_reads_it(quiet: Tab, page: Path, width: int) -> None:
    quiet.open(page, width)
    for figure in FIGURES[page.stem]:
        drawn = f"document.querySelector('figure[data-figure={figure}] .first')"
        assert quiet.value(f"{drawn}.getBoundingClientRect().width") > 250
        for share in (0.0, 0.3, 0.7, 1.0):
            x, y, texts = place_on(quiet, figure, share)
            quiet.point_at(x, y)
            assert quiet.value(READOUT.format(figure)) in texts


def test_the_arrow_keys_walk_from_end_to_end(quiet: Tab, page: Path) -> None:
    quiet.open(page, 1200)
    figure = FIGURES[page.stem][0]
    quiet.value(f"document.querySelector('figure[data-figure={figure}] svg').focus()")
    first = quiet.value(READOUT.format(figure))
    quiet.press("End")
    last = quiet.value(READOUT.format(figure))
    quiet.press("Home")
    assert quiet.value(READOUT.format(figure)) == first != last


@pytest.mark.parametrize("font", FONTS)
def test_it_prints_on_a4(quiet: Tab, page: Path) -> None:
    quiet.open(page, 1200, scheme="dark")
    _, count = pages_of(quiet.pdf())
    assert 4 <= count <= 18
