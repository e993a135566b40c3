"""Every shipped note: words apart and whole on screen and paper, no page nearly empty.

Wants Chromium and pdftotext (Debian's packages ``chromium`` and ``poppler-utils``).
"""

from __future__ import annotations

import re
import shutil
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest

from .browser import CHROMIUM, Tab, chromium

ROOT = Path(__file__).parents[2]
NOTES = sorted((ROOT / "reports" / "notes").glob("*.html"))
IN_PAGE = (Path(__file__).parent / "in_page.js").read_text("utf-8")
LEAST_FULL = 0.4
"""Part of a page down to which it is written at least, but for the last."""

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(not CHROMIUM, reason="no chromium on this machine"),
]


@pytest.fixture(scope="module")
def tab(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Tab]:
    with chromium(tmp_path_factory.mktemp("browser")) as opened:
        yield opened


def named(path: Path) -> str:
    return path.stem


def clashes(tab: Tab) -> list[object]:
    """Words of drawings that are cut off or stand on each other."""
    return [
        *tab.value(f"{IN_PAGE}\noffPaper()"),
        *tab.value(f"{IN_PAGE}\nclashes()"),
    ]


@pytest.mark.parametrize("path", NOTES, ids=named)
def test_labels_stand_apart_on_screen_and_paper(tab: Tab, path: Path) -> None:
    tab.open(path, 1200)
    assert clashes(tab) == []
    tab.open(path, 680)  # 180 mm at 96 dots an inch, what the margins leave
    tab.call("Emulation.setEmulatedMedia", media="print")
    found = clashes(tab)
    tab.call("Emulation.setEmulatedMedia", media="")
    assert found == []


@pytest.mark.skipif(not shutil.which("pdftotext"), reason="no pdftotext on this machine")
@pytest.mark.parametrize("path", NOTES, ids=named)
def test_no_page_is_nearly_empty(tab: Tab, path: Path, tmp_path: Path) -> None:
    tab.open(path, 1000)
    pdf = tmp_path / "note.pdf"
    pdf.write_bytes(tab.pdf())
    command = ["pdftotext", "-bbox", str(pdf), "-"]
    found = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    *pages, last = found.split("<page ")[1:]
    assert pages
    assert last
    for number, page in enumerate(pages, start=1):
        (tall,) = re.findall(r'^.*?height="([\d.]+)"', page)
        lowest = max(float(each) for each in re.findall(r'yMax="([\d.]+)"', page))
        assert lowest > LEAST_FULL * float(tall), f"page {number} of {path.name}"
