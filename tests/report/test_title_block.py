"""A firm's document: its title block, what stands on every page, the contents, the page as PDF."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import pytest

from catopt import read_sizing, size_buoy
from catopt.casefile import parse_case, write_case
from catopt.cli.note_kind import answer_of, note_of_sizing
from catopt.errors import InputError
from catopt.notes.line import read_note
from catopt.notes.origin import Asked
from catopt.render.page import page
from catopt.report.pdf import BROWSER, browser, printed
from catopt.sizing import BuoyRequest

from .page_reader import read_page

CASE = (Path(__file__).parents[2] / "cases" / "buoy-9.5m" / "case.toml").read_text("utf-8")
LOGO = b'<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9"/>'
BLOCK = """
[document]
client = 'Port of "Hai Phong"'
project = "Phao luồng; </style>"
number = "MO-2041-01"
logo = "logo.svg"
[[document.revisions]]
revision = "A"
date = "2026-10-01"
[[document.revisions]]
revision = "B"
date = "2026-11-29"
changed = "Issued"
prepared = "N. V. An"
checked = "T. T. Binh"
approved = "L. H. Cuong"
"""


@pytest.fixture
def case(tmp_path: Path) -> Path:
    (tmp_path / "logo.svg").write_bytes(LOGO)
    path = tmp_path / "case.toml"
    path.write_text(CASE + BLOCK, "utf-8")
    return path


def test_the_note_is_a_document_of_the_firm(case: Path) -> None:
    html = page(answer_of(read_note(case, verify=False))).decode()
    shown = read_page(html)
    assert shown.unclosed == []
    rows = [[cell.text for cell in row] for row in shown.table("signed").rows]
    last = ["B", "2026-11-29", "Issued", "N. V. An", "T. T. Binh", "L. H. Cuong"]
    assert rows == [["A", "2026-10-01", "", "", "", ""], last]
    identity = shown.sections["identity"]
    for said in ('Port of "Hai Phong"', "Phao luồng; </style>", "MO-2041-01"):
        assert said in identity
        assert said not in shown.sections["inputs"]
    (logo,) = shown.tagged("img")
    assert logo.attributes["src"].startswith("data:image/svg+xml;base64,")
    assert "img-src data:;" in html
    links = [each.attributes["href"] for each in shown.tagged("a")]
    assert links == [f"#{name}" for name in shown.sections]


def test_every_page_has_the_document_and_its_number(case: Path) -> None:
    """A style sheet's string, in which nothing of a text can end it."""
    html = page(answer_of(read_note(case, verify=False))).decode()
    (margins,) = re.findall(r"@page \{ (@top-left.*) \}\n", html)
    said = {
        place: _text(words) for place, words in re.findall(r'@([\w-]+) { content: "(.*?)"', margins)
    }
    assert said["top-left"] == 'Port of "Hai Phong" · Phao luồng; </style>'
    assert said["top-right"] == "MO-2041-01, revision B"
    assert said["bottom-left"] == "Marker buoy, 9.5 m"
    assert '@bottom-right { content: counter(page) " / " counter(pages); }' in margins


def _text(quoted: str) -> str:
    return re.sub(r"\\([0-9a-f]+) ", lambda found: chr(int(found[1], 16)), quoted)


def test_a_sizing_hands_its_title_block_to_note_and_case(tmp_path: Path) -> None:
    (tmp_path / "logo.svg").write_bytes(LOGO)
    path = tmp_path / "sizing.toml"
    sized = '[buoy]\nname = "pillar 1.8 m"\n[site]\nwater_depth = "12 m"\n'
    path.write_text(sized + "[motion]\nleft_out = true\n" + BLOCK, "utf-8")
    answer = answer_of(note_of_sizing(path, "buoy", Asked(verify=False)))
    html = page(answer).decode()
    assert "data:image/svg+xml;base64," in html
    assert "MO-2041-01" in read_page(html).sections["identity"]
    request = read_sizing(path)
    assert isinstance(request, BuoyRequest)
    of = size_buoy(request)
    assert of.case.document is not None
    assert of.case.document.revisions[-1].approved == "L. H. Cuong"
    assert parse_case(write_case(of.whole_case)).document == of.case.document
    path.write_text(path.read_text("utf-8").replace("client", "cleint"), "utf-8")
    with pytest.raises(InputError, match=r"document\.cleint.*did you mean client"):
        read_sizing(path)


def test_a_case_keeps_its_title_block(case: Path) -> None:
    read = parse_case(case.read_text("utf-8"), folder=str(case.parent))
    assert parse_case(write_case(read)) == read
    assert read.document is not None
    assert read.document.present == "B"


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ('"logo.svg"', '"none.svg"', r"document\.logo: found .*none\.svg.*a picture is required"),
        ('"logo.svg"', '"case.toml"', r"document\.logo: found .*case\.toml.*\.png, \.jpg or \.svg"),
        ("client", "cleint", r"document\.cleint.*did you mean client"),
        ('revision = "A"\n', "", r"document\.revisions\[0\]\.revision"),
    ],
)
def test_what_is_wrong_is_told_by_its_key(case: Path, old: str, new: str, said: str) -> None:
    case.write_text(case.read_text("utf-8").replace(old, new, 1), "utf-8")
    with pytest.raises(InputError, match=said):
        read_note(case, verify=False)


def test_where_no_browser_is_the_way_out_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", "")
    monkeypatch.delenv(BROWSER, raising=False)
    monkeypatch.setattr("catopt.report.pdf._browsers", lambda: iter(["chromium", "msedge"]))
    with pytest.raises(InputError, match="install Chromium, Chrome or Edge"):
        browser()
    monkeypatch.setenv(BROWSER, "no-such-program")
    with pytest.raises(InputError, match="no-such-program"):
        browser()


@pytest.mark.slow
@pytest.mark.skipif(not shutil.which("pdftotext"), reason="reads what was printed")
def test_the_printed_page_has_its_number(case: Path, tmp_path: Path) -> None:
    if not any(map(shutil.which, ("chromium", "google-chrome"))):
        pytest.skip("no browser")
    target = tmp_path / "note.pdf"
    target.write_bytes(printed(page(answer_of(read_note(case, verify=False))), browser()))
    command = ["pdftotext", "-layout", str(target), "-"]
    text = subprocess.run(command, capture_output=True, check=True).stdout.decode()
    *sheets, _ = text.split("\f")
    assert len(sheets) > 2
    for number, sheet in enumerate(sheets, start=1):
        assert "MO-2041-01, revision B" in sheet
        assert re.search(rf"\b{number} */ *{len(sheets)}\b", sheet)
