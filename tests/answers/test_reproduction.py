"""``catopt reproduce --lang vi``: every text is there, and a shared reason is printed once."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

import pytest

from catopt.answers.blocks import Table
from catopt.answers.reproduction import notes_of, reproduction_answer
from catopt.cli.output import Output
from catopt.render.terminal import show
from catopt.reproduce import Item, Reproduction, fso_rang_dong_dynamic, names, reproduce
from catopt.reproduce.fso_rang_dong_dynamic import Maxima
from catopt.words import Language, say

pytestmark = pytest.mark.slow  # every study is recomputed

PROPER = {
    "catopt", "MOORING_2017", "OrcaFlex", "MOORING_2017, Pierson-Moskowitz",
    "MOORING_2017, JONSWAP", "MoorDyn-C", "S4, PM", "S4, JONSWAP",
    "UFC-Blendermann", "UFC-4-159-03", "22TCN-222-95",
}  # fmt: skip
"""Names of programs and of sources, which are the same in both languages."""
UNITS = re.compile(r"[-\d., ]+ (kN/m3|kN|kg/m3|kg/m|kgf/m|N/m|deg|rad|mm|tf)")
"""Numbers with a unit."""


@pytest.fixture(scope="module")
def everything() -> Iterator[Reproduction]:
    """Recompute every study; the slow runs in time are made up, for their numbers are not read."""
    with pytest.MonkeyPatch.context() as patched:
        made_up = Maxima(tension=(4.3e6,) * 9, offset=6.2)
        patched.setattr(fso_rang_dong_dynamic, "run", lambda *_, **__: made_up)
        yield reproduce()


def shown_of(result: Reproduction, language: Language, capsys: pytest.CaptureFixture[str]) -> str:
    capsys.readouterr()
    show(Output(), reproduction_answer(result), language)
    return capsys.readouterr().out


@pytest.fixture(autouse=True)
def narrow(monkeypatch: pytest.MonkeyPatch) -> None:
    """Print on a terminal of 80 columns."""
    monkeypatch.setenv("COLUMNS", "80")


WORDS = re.compile(r"[^\W\d_]{2}")
"""What tells words from a number, with its exponent or without."""
KEYS = {"Source", "Name", "Quantity", "Unit", "Study"}
"""Columns of names that are the same in both languages."""


def test_no_text_is_missing(everything: Reproduction) -> None:
    """Every sentence and name has its Vietnamese, but for those of programs and sources."""
    english = set()
    for block in reproduction_answer(everything).blocks:
        for column in block.columns if isinstance(block, Table) else ():
            if str(column.name) not in KEYS:
                texts = [each for each in column.values if isinstance(each, str)]
                english |= {
                    text for text in texts if WORDS.search(text) and say(text, "vi") == text
                }
    assert {text for text in english if not UNITS.fullmatch(text)} <= PROPER


def test_it_fits_the_terminal(everything: Reproduction, capsys: pytest.CaptureFixture[str]) -> None:
    assert {study.name for study in everything.studies} == set(names())
    for language in ("en", "vi"):
        shown = shown_of(everything, language, capsys)
        assert "…" not in shown
        assert max(map(len, shown.splitlines())) <= 80


def test_what_is_found_is_in_vietnamese_with_its_numbers(
    everything: Reproduction, capsys: pytest.CaptureFixture[str]
) -> None:
    shown = " ".join(shown_of(everything, "vi", capsys).split())
    for part in (
        "Trong 180 số công bố, 97 trùng khớp, 52 không khớp, 31 không tái lập được.",
        "lực căng 0.446 tf cần 9.386 đến 9.526.",
        "lệch -162 kN (-35.99 %); tính được 288 kN, không phù hợp với 450 kN công bố",
        "lệch -0.066 m (-0.26 %); 554.5 - 529.5 theo các độ dạt ngang công bố",
        "Cả 10 số: thiếu số liệu: chuỗi lực FT(t) là một hình đã mất.",
    ):
        assert part in shown


# ------------------------------------------------------------------ the same reason once


LOST = "inputs missing: the load series FT(t) is a lost figure"


def test_a_reason_is_printed_once_for_the_rows_that_share_it(
    everything: Reproduction, capsys: pytest.CaptureFixture[str]
) -> None:
    """Thirty numbers in three tables have it; the document has it with each of them."""
    assert [item.to_dict()["note"] for item in everything.items].count(LOST) == 30
    shown = shown_of(everything, "en", capsys)
    assert shown.count(f"All 10 numbers: {LOST}.") == 3
    assert shown.count("FT(t) is a lost figure") == 3


def described(items: Sequence[Item], language: Language = "en") -> list[str]:
    return [say(which, language) for which, _ in notes_of(items)]


def test_rows_that_share_a_reason_are_named(everything: Reproduction) -> None:
    lost = [item for item in everything.items if item.note == LOST][:10]
    plain = next(item for item in everything.items if not item.note)
    assert described(lost[:1]) == ["line_1_tension_max_kN"]
    assert described(lost) == ["All 10 numbers"]
    assert described([plain, *lost[:3], plain, lost[4]]) == [
        "line_1_tension_max_kN to line_3_tension_max_kN",
        "line_5_tension_max_kN",
    ]
    assert described([plain, *lost[:2]], "vi") == [
        "line_1_tension_max_kN đến line_2_tension_max_kN"
    ]
    assert described([plain, plain]) == []


def test_reasons_that_differ_are_all_printed(
    everything: Reproduction, capsys: pytest.CaptureFixture[str]
) -> None:
    shown = " ".join(shown_of(everything, "en", capsys).split())
    for item in everything.items:
        if item.note:
            assert f"{item.note}." in shown
