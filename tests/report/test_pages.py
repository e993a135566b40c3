"""The page of every note: well formed, safe, its numbers the rounding of what is behind them."""

from __future__ import annotations

import base64
import hashlib
import math
import re
from dataclasses import replace

import pytest

from catopt.notes.line import Note
from catopt.notes.origin import SourceFile
from catopt.notes.system import SystemNote
from catopt.quantities import QUANTITIES
from catopt.units import UNITS

from .notes import each_note, note_named, page_named, shown
from .page_reader import ReadCell, ReadPage


@pytest.fixture(params=each_note())
def page(request: pytest.FixtureRequest) -> ReadPage:
    return page_named(request.param)


def test_the_page_is_well_formed_and_refers_to_nothing(page: ReadPage) -> None:
    assert page.unclosed == []
    assert not {element.tag for element in page.elements} & {"link", "img", "iframe", "object"}
    for element in page.elements:
        assert not {"src", "srcset", "style", "onclick"} & set(element.attributes), element
        assert element.attributes.get("href", "#").startswith("#"), element  # in the page itself
        assert "://" not in " ".join(element.attributes.values()), element
    for element in (*page.tagged("style"), *page.tagged("script")):
        assert not re.search(r"url\(|@import|https?:|fetch|XMLHttp|import\(", element.text)


def test_only_the_pages_own_script_may_run(page: ReadPage) -> None:
    (policy,) = (
        element.attributes["content"]
        for element in page.tagged("meta")
        if element.attributes.get("http-equiv") == "Content-Security-Policy"
    )
    (script,) = (each for each in page.tagged("script") if "type" not in each.attributes)
    digest = base64.b64encode(hashlib.sha256(script.text.encode()).digest()).decode()
    assert f"script-src 'sha256-{digest}'" in policy
    assert "default-src 'none'" in policy


FIELD = {
    **{unit: factor for table in UNITS.values() for unit, factor in table.items()},
    **{each.field_unit: each.factor for each in QUANTITIES.values()},
    **dict.fromkeys(("", "J", "m/m", "N m", "N*m", "m2", "kg/m^3", "kg/m³", "kg/m3"), 1.0),
    **dict.fromkeys(("kJ", "kN/rad", "kN*m/rad"), 1e3),
    "°": math.pi / 180.0,
}


NUMBER = re.compile(
    r"(?P<number>-?\d+(?:\.(?P<decimals>\d+))?(?:e(?P<power>[+-]?\d+))?) ?(?P<unit>\S*)"
)


def in_si(cell: ReadCell, heading: str) -> tuple[float, float]:
    """Return what a cell shows first, in SI, and half a unit of its last digit."""
    match = NUMBER.match(cell.text.replace("−", "-").replace(",", ""))
    assert match is not None, cell
    in_heading = re.search(r"\(([^()]*)\)$", heading)
    unit = match["unit"] or (in_heading[1] if in_heading else "")
    factor = FIELD[unit]
    power = 10.0 ** int(match["power"] or 0)
    half = 0.5 * 10.0 ** -len(match["decimals"] or "") * power * factor
    return float(match["number"]) * factor, half


def test_every_number_is_the_rounding_of_the_value_behind_it(page: ReadPage) -> None:
    """Within half of its last digit, and 1e-9 of itself, to which SI values are written."""
    count = 0
    for table in page.tables:
        for row in table.rows:
            for cell, heading in zip(row, table.headings or [""] * len(row), strict=True):
                if cell.value is not None:
                    rounded, half = in_si(cell, heading)
                    assert abs(rounded - cell.value) <= half * (1 + 1e-9) + 1e-9 * abs(cell.value)
                    count += 1
    assert count > 50


HOSTILE = [
    "<script>alert(1)</script>",
    '"><img src=x onerror=alert(1)>',
    "</title></style></script><b>",
    "$math$ {{ 7*7 }} {% raw %}",
    'it\'s "quoted" & <b>bold</b> &amp;',
    "phao luồng Hải Phòng – số 1",
]


@pytest.mark.parametrize("text", HOSTILE)
@pytest.mark.parametrize("name", ["states", "arms"])
def test_what_the_user_writes_is_text_and_nothing_else(name: str, text: str) -> None:
    note = note_named(name)
    assert isinstance(note, Note | SystemNote)
    files = (SourceFile(text, f"title = '''{text}'''", "0" * 64),)
    case = replace(note.case, title=text, source=text)
    origin = replace(note.origin, files=files, date=text)
    page = shown(replace(note, case=case, origin=origin))
    assert page.unclosed == []
    assert {each.tag for each in page.elements} == {each.tag for each in page_named(name).elements}
    assert page.tagged("h1")[0].text == text
    assert page.table("identity").row("Source")[1].text == text
    assert page.tagged("pre")[0].text == files[0].text
