"""``--lang vi``: what a person reads is Vietnamese, and no text is missing."""

from __future__ import annotations

from pathlib import Path

import openpyxl
import pytest

from .conftest import BUOY, CASES, Run

DESIGN = CASES / "design-buoy-9.5m" / "case.toml"
TANKER = CASES / "tanker-20m-sinker" / "case.toml"

SOLVED: list[list[object]] = [
    ["solve", BUOY, "--profile"],
    ["solve", BUOY, "--method", "pso", "--runs", "2", "--iterations", "50"],
    ["solve", CASES / "buoy-9.5m-slack" / "case.toml"],
    ["solve", CASES / "ship-200m" / "case.toml"],
    ["solve", CASES / "tanker-20m-find-length" / "case.toml"],
    ["solve", TANKER],
    ["check", BUOY],
    ["check", TANKER],
    ["check", DESIGN],
    ["design", DESIGN],
]


@pytest.mark.parametrize("arguments", SOLVED, ids=lambda arguments: " ".join(map(str, arguments)))
def test_80_columns_carry_every_table(
    run: Run, monkeypatch: pytest.MonkeyPatch, arguments: list[object]
) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    shown = run(*arguments, "--lang", "vi").out
    assert "…" not in shown
    assert max(map(len, shown.splitlines())) <= 80


def test_the_document_is_the_same_in_both_languages(run: Run) -> None:
    for command in (["solve", TANKER], ["check", TANKER]):
        assert run(*command, "--json", "--lang", "vi").out == run(*command, "--json").out


def test_the_answer_in_vietnamese(run: Run) -> None:
    shown = " ".join(run("solve", BUOY, "--lang", "vi").out.split())
    for part in (
        "Giải bằng nghiệm giải tích; toàn bộ dây treo, không chạm đáy.",
        "Góc nghiêng dây neo tại đáy theta0 15.57 deg",
        "Độ dạt ngang S 17.430 m",
        "Lực căng tại điểm treo T 4.377 kN 0.4463 tf",
    ):
        assert part in shown
    shown = " ".join(run("check", TANKER, "--lang", "vi").out.split())
    assert "Kiểm tra duy nhất đạt." in shown


def test_the_workbook_in_vietnamese_has_the_same_numbers(run: Run, tmp_path: Path) -> None:
    for language in ("en", "vi"):
        run("solve", TANKER, "--lang", language, "--out", tmp_path / language)
    english, said = (
        openpyxl.load_workbook(tmp_path / language / "solution.xlsx") for language in ("en", "vi")
    )
    assert said.sheetnames == ["Số liệu đầu vào", "Kết quả", "Hình dạng dây"]
    for ours, theirs in zip(english, said, strict=True):
        for row, other in zip(ours.iter_rows(), theirs.iter_rows(), strict=True):
            for cell, there in zip(row, other, strict=True):
                if cell.data_type == "n":
                    assert (there.value, there.number_format) == (cell.value, cell.number_format)
    document = "solution.json"
    assert (tmp_path / "en" / document).read_bytes() == (tmp_path / "vi" / document).read_bytes()


def test_another_language_is_refused(run: Run) -> None:
    ran = run("solve", BUOY, "--lang", "fr")
    assert ran.status == 2
    assert "'fr' is not one of" in ran.err
