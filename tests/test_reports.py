"""The notes in reports/ are what catopt makes of the cases today."""

from __future__ import annotations

import math
import re

import pytest

from catopt.report.bundle import reproduction_pictures
from catopt.reproduce import reproduce
from tests.reports import CASES, NOTES, REPORTS, SIZINGS, note_page

LAST_DIGITS = 1e-9
"""Relative, and in SI: notes carry every digit, of which another C library may round the last."""
LARGEST = 4_100_000
"""Bytes of all reports: the repository is to stay small."""

NUMBER = re.compile(r"(?<![\w#])[-−]?\d+(?:\.\d+)?(?:e[-+]?\d+)?")
OF_A_SEARCH = re.compile(r"(?<=design\.json, SHA-256 )[0-9a-f]{64}")
"""Hash of a document with every digit of a search."""


def differences(committed: str, made: str) -> list[str]:
    """List where two pages differ by more than the last digits of a number."""
    pages = [OF_A_SEARCH.sub("", page) for page in (committed, made)]
    if pages[0] == pages[1]:
        return []
    words = [NUMBER.split(page) for page in pages]
    if words[0] != words[1]:
        return [f"{a!r} is now {b!r}" for a, b in zip(*words, strict=False) if a != b][:5] or [
            "one is longer"
        ]
    numbers = [NUMBER.findall(page) for page in pages]
    return [
        f"{a} is now {b}"
        for a, b in zip(*numbers, strict=True)
        if not math.isclose(_value(a), _value(b), rel_tol=LAST_DIGITS, abs_tol=LAST_DIGITS)
    ][:5]


def _value(text: str) -> float:
    return float(text.replace("−", "-"))


@pytest.mark.parametrize(
    "name",
    [
        pytest.param(name, marks=pytest.mark.slow) if name.startswith("design-") else name
        for name in (*CASES, *SIZINGS)
    ],
)
def test_a_note_is_fresh(name: str) -> None:
    """Byte for byte where the C library is the same; else but for the last digits."""
    committed = (NOTES / f"{name}.html").read_bytes()
    made = note_page(name)
    if committed != made:
        found = differences(committed.decode(), made.decode())
        assert found == [], "write them anew: python -m tests.reports"


@pytest.mark.slow
def test_the_swarms_figures_are_fresh() -> None:
    """What is drawn of a search ends where rounding begins to decide it."""
    made = reproduction_pictures(reproduce("buoy_9p5m"))
    for name in ("buoy_9p5m_fitness.svg", "buoy_9p5m_tension.svg"):
        committed = (REPORTS / name).read_text("utf-8")
        assert differences(committed, made[name].decode()) == [], name


def test_every_case_has_a_note_and_every_note_a_case() -> None:
    assert sorted(path.stem for path in NOTES.iterdir()) == sorted((*CASES, *SIZINGS))
    assert len(CASES) >= 10


def test_reports_stay_small() -> None:
    assert sum(path.stat().st_size for path in REPORTS.rglob("*.*")) < LARGEST


def test_a_difference_is_noticed() -> None:
    page = (NOTES / "buoy-9.5m.html").read_text("utf-8")
    value = re.findall(r'<data value="(17\.42\d+)"', page)[0]
    assert differences(page, page) == []
    assert differences(page, page.replace(value, f"{float(value) * (1 + 1e-12)!r}")) == []
    assert len(differences(page, page.replace(value, f"{float(value) * 1.0001!r}"))) > 0
    assert len(differences(page, page.replace("Span", "Offset", 1))) > 0
    assert len(differences(page, page.replace("17.430 m", "17.431 m", 1))) > 0
