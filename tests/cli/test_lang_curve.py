"""``catopt curve --lang vi``: every text is there, fits, and leaves the numbers alone."""

from __future__ import annotations

import re
from pathlib import Path

import openpyxl
import pytest

from .conftest import BUOY, CASES, SLACK, Run

SOUGHT = CASES / "tanker-20m-find-length" / "case.toml"
SINKER = CASES / "tanker-20m-sinker" / "case.toml"
SHIP = CASES / "ship-200m-sinker" / "case.toml"
STATES = CASES / "design-buoy-9.5m" / "case.toml"

BUOYED = """
[site]
water_depth = "50 m"
[line]
[[line.segments]]
length = "300 m"
submerged_weight = "1000 N/m"
EA = "500 MN"
[[line.point_loads]]
position = "150 m"
submerged_weight = "-50 kN"
[load]
horizontal_force = "300 kN"
[checks]
max_anchor_uplift_angle = "3 deg"
"""

BIGHTS = """
[site]
water_depth = "50 m"
[line]
[[line.segments]]
length = "80 m"
submerged_weight = "1000 N/m"
[load]
span = "10 m"
"""

CURVES: list[list[object]] = [
    [BUOY],
    [BUOY, "--over", "span", "--from", "15 m"],
    [BUOY, "--to", "1 kN", "--points", "4"],
    [BUOY, "--from", "1 kN", "--to", "2 kN"],
    [SLACK, "--over", "offset"],
    [SOUGHT],
    [SOUGHT, "--over", "offset"],
    [SINKER],
    [SHIP],
    [STATES],
    ["chain-and-wire.toml"],
    ["buoyed.toml"],
    ["buoyed.toml", "--to", "400 kN"],
    ["bights.toml"],
]


@pytest.fixture(autouse=True)
def here(tmp_path: Path, chain_and_wire: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Work where the cases of this module are, on a terminal of 80 columns."""
    (tmp_path / "buoyed.toml").write_text(BUOYED, encoding="utf-8")
    (tmp_path / "bights.toml").write_text(BIGHTS, encoding="utf-8")
    monkeypatch.chdir(chain_and_wire.parent)
    monkeypatch.setenv("COLUMNS", "80")


def said_alike(english: str, vietnamese: str) -> set[str]:
    """Lines with words that are the same in both languages."""
    in_words = re.compile(r"[^\W\d_]{3,}")
    lines = (set(text.splitlines()) for text in (english, vietnamese))
    return {line for line in set.intersection(*lines) if in_words.search(line)}


@pytest.mark.parametrize("arguments", CURVES, ids=lambda arguments: " ".join(map(str, arguments)))
def test_it_fits_and_only_the_title_is_as_in_english(run: Run, arguments: list[object]) -> None:
    english, shown = (run("curve", *arguments, "--lang", lang).out for lang in ("en", "vi"))
    assert "…" not in shown
    assert max(map(len, shown.splitlines())) <= 80
    assert said_alike(english, shown) <= {english.splitlines()[0]}


def test_the_answer_in_vietnamese(run: Run) -> None:
    shown = " ".join(run("curve", SOUGHT, "--over", "offset", "--lang", "vi").out.split())
    for part in (
        "50 điểm cách đều theo độ dạt so với trạng thái gốc.",
        "từ 1 % đến 105 % của 1334.544 kN, lực ngang khi một đoạn đạt lực kéo đứt / 5.",
        "Chiều dài tìm được của đoạn 1: 47.208 m, với điều kiện góc nghiêng dây neo tại đáy 0°.",
        "Độ dạt bằng 0 ứng với độ dạt ngang 41.906 m.",
        "20 trên 50 điểm",
        "khối gia tải 1 bắt đầu nhấc (sinker)",
        "nằm một phần trên đáy → treo hoàn toàn 0.000 450.000 540.354",
        "đoạn 1 đạt lực kéo đứt / 5 (chain 105 mm)",
    ):
        assert part in shown


def test_documents_and_tables_are_the_same_in_both_languages(run: Run, tmp_path: Path) -> None:
    printed = [
        run("curve", SOUGHT, "--json", "--lang", lang, "--out", lang).out for lang in ("en", "vi")
    ]
    assert printed[0] == printed[1]
    for name in ("curve.json", "curve.csv", "curve_marks.csv", "curve.svg"):
        assert (tmp_path / "en" / name).read_bytes() == (tmp_path / "vi" / name).read_bytes()


@pytest.mark.slow
@pytest.mark.parametrize("case", [SOUGHT, STATES, "buoyed.toml"], ids=str)
def test_both_workbooks_have_the_same_numbers(run: Run, tmp_path: Path, case: object) -> None:
    for lang in ("en", "vi"):
        run("curve", case, "--lang", lang, "--out", tmp_path / lang)
    english, said = (
        openpyxl.load_workbook(tmp_path / lang / "curve.xlsx") for lang in ("en", "vi")
    )
    assert said.sheetnames == ["Đường cong", "Điểm đánh dấu", "Số liệu đầu vào", "Kết quả"]
    numbers = 0
    for ours, theirs in zip(english, said, strict=True):
        for row, other in zip(ours.iter_rows(), theirs.iter_rows(), strict=True):
            for cell, there in zip(row, other, strict=True):
                assert cell.data_type == there.data_type
                if cell.data_type == "n":
                    numbers += cell.value is not None
                    assert (there.value, there.number_format) == (cell.value, cell.number_format)
    assert numbers > 300  # 50 points of at least seven quantities
