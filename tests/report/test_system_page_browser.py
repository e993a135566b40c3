"""The note of a moored body in a browser: desktop and phone, light and dark, on paper, no scripts.

Wants Chromium (Debian's package ``chromium``).
"""

from __future__ import annotations

from pathlib import Path

import pytest

from catopt.report.page.render import render_page

from .browser import CHROMIUM, FONTS, Tab, assert_nothing_sticks_out
from .system_page_cases import EVERY, TURRET, known_note
from .test_page_browser import A4, READOUT, pages_of, place_on

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(not CHROMIUM, reason="no chromium on this machine"),
]

VIETNAMESE = "arms"
"""The case whose page is looked at in Vietnamese."""
OF_A_LOAD = ("system_near", "system_watch", "system_round")
"""Figures that only a body under a force has."""


@pytest.fixture(params=EVERY)
def name(request: pytest.FixtureRequest) -> str:
    return str(request.param)


@pytest.fixture
def page(name: str, tmp_path: Path) -> Path:
    path = tmp_path / f"{name}.html"
    path.write_bytes(render_page(known_note(name), "vi" if name == VIETNAMESE else "en"))
    return path


LEFT_OUT = {
    "raised": {"system_magnified"},
    "idle": {*OF_A_LOAD},
    "lee": {"system_near"},
    "lone": {"system_near"},
}
"""Of a steep line, without a load, of an offset that the plan shows well."""


def figures_of(name: str) -> set[str]:
    every = {"system_plan", "system_elevation", "system_magnified", "system_restoring"}
    return (every | {*OF_A_LOAD}) - LEFT_OUT.get(name, set())


@pytest.mark.parametrize("font", FONTS)
@pytest.mark.parametrize("width", [1200, 390])
def test_nothing_sticks_out(quiet: Tab, page: Path, width: int, font: str) -> None:
    assert_nothing_sticks_out(quiet, page, width, font)


def test_every_figure_is_drawn(quiet: Tab, page: Path, name: str) -> None:
    quiet.open(page, 1200)
    drawn = quiet.value(
        "[...document.querySelectorAll('figure')].map((each) => [each.dataset.figure, "
        "each.querySelector('svg').getBoundingClientRect().height])"
    )
    assert {key for key, _ in drawn} == figures_of(name)
    assert all(height > 120 for _, height in drawn)


@pytest.mark.parametrize("font", FONTS)
def test_a_desktop_shows_tables_without_scrolling_sideways(quiet: Tab, page: Path) -> None:
    """But for those of arms, where the balance has a column more for each."""
    quiet.open(page, 1200)
    wide = quiet.value(
        "[...document.querySelectorAll('.scroll')].filter((each) => each.scrollWidth > "
        "each.clientWidth + 1).map((each) => each.querySelector('table').dataset.key)"
    )
    assert set(wide) <= {"pulls", "pieces"}


@pytest.mark.parametrize("width", [1200, 390])
def test_pointing_at_a_figure_reads_it(quiet: Tab, page: Path, name: str, width: int) -> None:
    quiet.open(page, width)
    hint = "Di con trỏ" if name == VIETNAMESE else "Point at"
    for figure in sorted(figures_of(name)):
        assert quiet.value(READOUT.format(figure)).startswith(hint)
        for share in (0.0, 0.4, 1.0):
            x, y, texts = place_on(quiet, figure, share)
            quiet.point_at(x, y)
            assert quiet.value(READOUT.format(figure)) in texts
    style = "getComputedStyle(document.querySelector('figure.on .pointer')).visibility"
    assert quiet.value(style) == "visible"


def test_the_arrow_keys_go_round_the_watch_circle(quiet: Tab, tmp_path: Path) -> None:
    path = tmp_path / "turret.html"
    path.write_bytes(render_page(known_note(TURRET)))
    quiet.open(path, 1200)
    quiet.value("document.querySelector('figure[data-figure=system_watch] svg').focus()")
    read = READOUT.format("system_watch")
    assert quiet.value(read).startswith("force towards 0.00 deg")
    quiet.press("End")
    assert quiet.value(read).startswith("force towards 357.00 deg")
    quiet.press("ArrowLeft")
    assert quiet.value(read).startswith("force towards 354.00 deg")


def test_the_colours_follow_the_readers_choice(quiet: Tab, page: Path) -> None:
    strokes = {}
    for scheme in ("light", "dark"):
        quiet.open(page, 1200, scheme="dark" if scheme == "dark" else "light")
        strokes[scheme] = [
            quiet.value(f"getComputedStyle(document.querySelector('.{style}')).{what}")
            for style, what in (("leg", "stroke"), ("neutral", "stroke"), ("frame", "stroke"))
        ]
    for light, dark in zip(strokes["light"], strokes["dark"], strict=True):
        assert light != dark


def test_everything_is_readable_without_scripts(quiet: Tab, page: Path) -> None:
    """But for the hint about pointing, which would be of no use then."""
    words = (
        "[...document.querySelectorAll('h1, h2, table, figcaption, pre')].map((e) => e.innerText)"
    )
    quiet.open(page, 1200)
    with_scripts = quiet.value(words)
    quiet.open(page, 1200, scripts=False)
    assert quiet.value(words) == with_scripts
    assert quiet.value("document.querySelector('.readout').textContent") == ""
    assert len(with_scripts) > 20


@pytest.mark.parametrize("font", FONTS)
def test_it_prints_on_a4(quiet: Tab, page: Path) -> None:
    quiet.open(page, 1200, scheme="dark")
    boxes, count = pages_of(quiet.pdf())
    assert 6 <= count <= 17  # with the near view of the body in a frame of its own
    for width, height in boxes:
        assert (width, height) == pytest.approx(A4, abs=1.0)  # a point, by which sizes are rounded
