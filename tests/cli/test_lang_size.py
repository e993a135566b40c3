"""``catopt size --lang vi``: every text is there, fits, and leaves the numbers alone."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

import catopt.cli.size_answer
from catopt.answers.size import size_answer
from catopt.loads.drag_anchor import holding_capacity
from catopt.render.workbook import workbook
from catopt.sizing import Sizing
from catopt.words import Message, say

from .conftest import Run
from .test_size import answering
from .vietnamese import numbers

SHIP = (
    *("size", "tanker", "--length", "120 m", "--breadth", "18 m", "--draught", "7 m"),
    *("--depth", "22 m"),
)
SIZED: dict[str, tuple[str, ...]] = {
    "defaults": ("size", "buoy", "pillar 1.8 m", "--depth", "12 m"),
    "given": (
        *("size", "buoy", "--depth", "12 m", "--low-water", "10 m", "--force", "8 kN"),
        *("--reserve-buoyancy", "25 kN", "--hs", "1.5 m", "--period", "6 s", "--life", "3 years"),
        *("--wear", "0.2 mm/year", "--soil", "gravel or coarse sand", "--prefer", "lightest"),
        *("--chain", "chain open-link 4D Q2", "--code", "IALA-CALMAR"),
    ),
    "both draughts": (*SHIP, "--ballast-draught", "4 m", "--dwt", "9000 t", "--draught", "7 m"),
    "little water": (*SHIP, "--low-water", "7.5 m", "--anchor", "stockless", "--soil", "soft clay"),
    "sinker": (*SHIP, "--anchor", "sinker", "--clump-weight", "5 t", "--clump-weight", "10 t"),
    "around": (*SHIP, "--buoy", "mooring buoy 5.0 m", "--lines", "4", "--low-water", "20 m"),
}
"""A buoy and a tanker by everything that changes the words: with defaults and without them, by one
line and by several, with a drag anchor and a sinker."""


QUICK = {"given", "sinker"}


@pytest.fixture
def sized(monkeypatch: pytest.MonkeyPatch) -> list[Sizing]:
    """Keep what a run found, so that nothing is sized twice; on a terminal of 80 columns."""
    monkeypatch.setenv("COLUMNS", "80")
    kept: list[Sizing] = []
    show = catopt.cli.size_answer.give

    def kept_and_given(output: object, of: Sizing, language: str, **where: object) -> None:
        kept.append(of)
        show(output, of, language, **where)  # type: ignore[arg-type]

    monkeypatch.setattr(catopt.cli.size_answer, "give", kept_and_given)
    return kept


@pytest.mark.parametrize(
    "arguments",
    [
        pytest.param(arguments, id=name, marks=[pytest.mark.slow] * (name not in QUICK))
        for name, arguments in SIZED.items()
    ],
)
def test_a_sizing_in_vietnamese(
    run: Run, sized: list[Sizing], arguments: tuple[str, ...], tmp_path: Path
) -> None:
    ran = run(*arguments, "--lang", "vi", "--out", tmp_path)
    assert ran.status == 0
    assert "…" not in ran.out
    assert max(map(len, ran.out.splitlines())) <= 80
    (of,) = sized
    written = (tmp_path / "size.xlsx").read_bytes()
    assert numbers(written) == numbers(workbook(size_answer(of)))
    document = json.loads((tmp_path / "size.json").read_text("utf-8"))
    assert document.pop("case_sha256")
    assert document == of.to_dict()


def test_the_document_is_the_same_in_both_languages(run: Run) -> None:
    arguments = SIZED["given"]
    assert run(*arguments, "--json", "--lang", "vi").out == run(*arguments, "--json").out


def test_the_words_of_a_sizing(run: Run) -> None:
    shown = " ".join(run(*SIZED["defaults"], "--lang", "vi").out.split())
    for part in (
        "Neo pillar 1.8 m ở độ sâu nước 12 m",
        "chain open-link 4D Q2 20 mm, 87 m = 3.16 đường lỉn",
        "Rùa neo rùa neo bê tông 15 t (cần 14 t)",
        "xích: 86 m thay cho 87 m: không đạt về góc nghiêng dây neo tại đáy (bão, mực nước cao).",
        "dòng chảy lên thân phao theo hướng tải 11.295 A",
        "Lấy theo mặc định vì không cho trước: gió 25 m/s;",
    ):
        assert part in shown


def test_questions_in_vietnamese(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    left = answering(monkeypatch, "raft", "own", "8 kN", "25 kN", "12 m", "", "", "")
    ran = run("size", "buoy", "--lang", "vi")
    assert (ran.status, left) == (0, [])
    assert '"raft" không có trong danh sách' in ran.err
    assert "Độ sâu nước ở mực nước thấp [12 m]: " in ran.err
    left = answering(monkeypatch, "", "120 m", "18 m", "7 m", "22 m", "", "", "", "")
    ran = run("size", "tanker", "--lang", "vi")
    assert (ran.status, left) == (0, [])
    assert "Chiều dài toàn bộ của tàu: " in ran.err


def test_what_a_sentence_holds_is_said_with_it() -> None:
    segment = Message("checks.named_segment", number=1, name="a b")
    check = Message(
        "checks.in_case",
        check=Message("checks.tension", segment=segment),
        load_case=Message("sizing.storm_low"),
    )
    change = Message("design.changed", part=Message("sizing.chain_part"), new="28 m", old="28.5 m")
    said = Message("sizing.step_fails", change=change, check=check)
    assert (
        said == "chain: 28 m for 28.5 m: fails by the tension, segment 1 (a b) (storm, low water)."
    )
    assert say(said, "vi") == (
        "xích: 28 m thay cho 28.5 m: không đạt về lực căng, đoạn 1 (a b) (bão, mực nước thấp)."
    )


def test_what_a_drag_anchor_holds_is_said() -> None:
    held = holding_capacity("stockless", "sand", 5000.0)
    said = Message("sizing.holding_after", note=held.note)
    assert "; DTOcean has " in said
    assert "; DTOcean cho " in say(said, "vi")
