"""``catopt reproduce --lang vi``: every text is there, and a shared reason is printed once."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator

import pytest

from catopt.answers.blocks import Table
from catopt.answers.reproduction import notes_of, reproduction_answer
from catopt.cli.output import Printer
from catopt.render.terminal import show
from catopt.reproduce import Reproduction, fso_rang_dong_dynamic, names, reproduce
from catopt.reproduce.fso_rang_dong_dynamic import Maxima
from catopt.words import Language, say

pytestmark = pytest.mark.slow  # every study is recomputed

PROPER = (
    "catopt|MoorDyn-C|OrcaFlex|S4, JONSWAP|S4, PM|22TCN-222-95|UFC-4-159-03|UFC-Blendermann|"
    "MOORING_2017(, JONSWAP|, Pierson-Moskowitz)?"
)
UNITS = r"[-\d., ]+ (kN/m3|kN|kg/m3|kg/m|kg|kgf/m|N/m|deg|rad|mm|tf)"
SAME = re.compile(f"{PROPER}|{UNITS}")
"""Names of programs and of sources, and numbers with a unit: the same in both languages."""
WORDS = re.compile(r"[^\W\d_]{2}")
"""What tells words from a number, with its exponent or without."""
KEYS = {"Source", "Name", "Quantity", "Unit", "Study"}
"""Columns of names that are the same in both languages."""


@pytest.fixture(scope="module")
def everything() -> Iterator[Reproduction]:
    """Recompute every study; the slow runs in time are made up, for their numbers are not read."""
    with pytest.MonkeyPatch.context() as patched:
        made_up = Maxima(tension=(4.3e6,) * 9, offset=6.2)
        patched.setattr(fso_rang_dong_dynamic, "run", lambda *_, **__: made_up)
        yield reproduce()


@pytest.fixture
def shown(
    everything: Reproduction, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> Callable[[Language], str]:
    """Print all of it in a language on a terminal of 80 columns."""
    monkeypatch.setenv("COLUMNS", "80")

    def printed(language: Language) -> str:
        show(Printer(), reproduction_answer(everything), language)
        return capsys.readouterr().out

    return printed


def test_no_text_is_missing(everything: Reproduction) -> None:
    """Every sentence and name has its Vietnamese, but for those of programs and sources."""
    for block in reproduction_answer(everything).blocks:
        for column in block.columns if isinstance(block, Table) else ():
            texts = (each for each in column.values if isinstance(each, str))
            english = (each for each in texts if WORDS.search(each) and say(each, "vi") == each)
            assert str(column.name) in KEYS or all(map(SAME.fullmatch, english))


def test_it_fits_the_terminal(everything: Reproduction, shown: Callable[[Language], str]) -> None:
    assert {study.name for study in everything.studies} == set(names())
    for language in ("en", "vi"):
        printed = shown(language)
        assert "…" not in printed
        assert max(map(len, printed.splitlines())) <= 80


def test_what_is_found_is_in_vietnamese_with_its_numbers(shown: Callable[[Language], str]) -> None:
    printed = " ".join(shown("vi").split())
    for part in (
        "Trong 274 số công bố, 125 trùng khớp, 118 không khớp, 31 không tái lập được.",
        "lực căng 0.446 tf cần 9.386 đến 9.526.",
        "lệch -162 kN (-35.99 %); tính được 288 kN, không phù hợp với 450 kN công bố",
        "lệch -0.066 m (-0.26 %); 554.5 - 529.5 theo các độ dạt ngang công bố",
        "Cả 10 số: thiếu số liệu: chuỗi lực FT(t) là một hình đã mất.",
    ):
        assert part in printed


LOST = "inputs missing: the load series FT(t) is a lost figure"


def test_a_reason_is_printed_once_for_the_rows_that_share_it(
    everything: Reproduction, shown: Callable[[Language], str]
) -> None:
    """Thirty numbers in three tables have it; the document has it with each of them."""
    assert [item.to_dict()["note"] for item in everything.items].count(LOST) == 30
    printed = shown("en")
    assert printed.count(f"All 10 numbers: {LOST}.") == 3
    assert printed.count("FT(t) is a lost figure") == 3
    for item in everything.items:
        if item.note:
            assert f"{item.note}." in " ".join(printed.split())


def test_rows_that_share_a_reason_are_named(everything: Reproduction) -> None:
    lost = [item for item in everything.items if item.note == LOST][:10]
    plain = next(item for item in everything.items if not item.note)
    first, of = "line_1_tension_max_kN", "line_{}_tension_max_kN".format
    for items, named in (
        (lost[:1], [first]),
        (lost, ["All 10 numbers"]),
        ([plain, *lost[:3], plain, lost[4]], [f"{first} to {of(3)}", of(5)]),
        ([plain, plain], []),
    ):
        assert [which for which, _ in notes_of(items)] == named
    ((which, _),) = notes_of([plain, *lost[:2]])
    assert say(which, "vi") == f"{first} đến {of(2)}"
