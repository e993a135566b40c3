"""``catopt system --lang vi``: what is said."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import openpyxl
import pytest

from catopt.catenary.state import TOO_SHORT
from catopt.model import Line, Segment, System
from catopt.mooring.balance import Pull
from catopt.mooring.descent import TURNS_OVER, Rest
from catopt.mooring.line_out import one_line_out
from catopt.mooring.refusal import refusal, turns_over
from catopt.mooring.sharing_rule import sharing_rule
from catopt.words import Message

from .conftest import CASES, Run
from .test_system import SPREAD, TWO_HEADINGS
from .vietnamese import in_vietnamese

FSO = CASES / "fso-rang-dong" / "case.toml"
EVERYTHING = (
    "--line-out", "--watch-circle", "--curve", "180 deg", "--curve", "1.0", "--level", "-2 m",
    "--level", "2",
)  # fmt: skip
TWO = 'azimuths = ["0 deg", "180 deg"]'
FOUR = 'azimuths = ["0 deg", "90 deg", "180 deg", "270 deg"]'
CASE_TEXTS = {
    "four lines": SPREAD,
    "with strength": SPREAD.replace('EA = "800 MN"', 'EA = "800 MN"\nMBL = "2 MN"'),
    "untitled, two lines": SPREAD.replace('title = "Buoy on four lines"\n', "").replace(FOUR, TWO),
    "one line": SPREAD.replace(FOUR, 'azimuths = ["180 deg"]').replace(
        'fairlead_radius = "10 m"\n', ""
    ),
    "two headings": TWO_HEADINGS,
    "no force": SPREAD.replace('force = ["200 kN", "0 kN"]', ""),
    "taut": SPREAD.replace('EA = "800 MN"\n', "").replace("600 m", "563 m"),
}


def test_the_answer_in_vietnamese(run: Run, tmp_path: Path) -> None:
    ran = run("system", FSO, *EVERYTHING, "--lang", "vi", "--out", tmp_path)
    shown = " ".join(ran.out.split())
    for part in (
        "Giải bằng nghiệm giải tích; 9 dây, vật nổi tự do theo x và y.",
        "Độ dạt theo phương x -21.738 m",
        "Lực 4281.000 kN tác dụng theo mọi hướng",
        "Giữ tại các độ dạt theo hướng 180.00 deg",
        "cần số dây chẵn, từ 4 trở lên; hệ này có 9 dây",
    ):
        assert part in shown
    assert openpyxl.load_workbook(tmp_path / "system.xlsx").sheetnames == [
        "Vật nổi", "Các dây neo", "Đứt một dây", "Vòng dịch chuyển", "Lực phục hồi 1",
        "Lực phục hồi 2", "Các mực nước",
    ]  # fmt: skip


def test_what_is_not_there_is_said_in_vietnamese(run: Run, tmp_path: Path) -> None:
    path = tmp_path / "case.toml"
    path.write_text(CASE_TEXTS["no force"], encoding="utf-8")
    ran = run("system", path, "--watch-circle", "--lang", "vi")
    assert "không có vòng dịch chuyển" in ran.err


# ------------------------------------------------------------------ sentences


def ring(
    azimuths: list[float], force: float = 2e5, EA: float = 8e8, length: float = 600.0
) -> System:
    """Lines around a body, azimuths in degrees."""
    return System.around(
        Line([Segment(length, 1000.0, EA=EA)]),
        azimuths=[math.radians(azimuth) for azimuth in azimuths],
        anchor_radius=570.0,
        fairlead_radius=10.0,
        fairlead_height=50.0,
        force=(force, 0.0),
    )


EVEN = ring([0.0, 90.0, 180.0, 270.0])
NO_RULE = [
    ring([0.0, 120.0, 240.0]),
    replace(EVEN, legs=(*EVEN.legs[:3], ring([270.0], length=610.0).legs[0])),
    ring([0.0, 80.0, 180.0, 270.0]),
    ring([0.0, 90.0, 180.0, 270.0], force=0.0),
    ring([45.0, 135.0, 225.0, 315.0]),
]


@pytest.mark.parametrize("system", NO_RULE)
def test_every_reason_against_the_rule_is_said(system: System) -> None:
    why = sharing_rule(system).why_not
    assert why
    assert in_vietnamese(why)


def refusals() -> list[Message]:
    """List what a line that is gone may leave behind; what stops one line alone is verify's."""
    short = ring([0.0, 180.0], EA=math.inf, length=563.0)
    pull = Pull(0, -1, *([0.0] * (len(Pull._fields) - 2)))
    rest = Rest(TOO_SHORT, 1, 30.0, 0.0, 0.0, 3, 1.0, 0.0, pull)
    said = [
        refusal(rest, short).args[0],
        turns_over(9e8, Rest(TURNS_OVER, -1, 30.0, 0.0, 0.0, 3, 1.0, 8e8, pull)).args[0],
        *(each.refusal for each in one_line_out(ring([180.0]))),
    ]
    assert all(isinstance(each, Message) for each in said)
    return said


@pytest.mark.parametrize("refused", refusals())
def test_every_refusal_is_said(refused: Message) -> None:
    said = Message("mooring.lost", number=2, refusal=refused)
    assert in_vietnamese(said).startswith("Không có dây 2")
