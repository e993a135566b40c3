"""``--lang vi``: what a person reads is Vietnamese, and no text is missing."""

from __future__ import annotations

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


def test_another_language_is_refused(run: Run) -> None:
    ran = run("solve", BUOY, "--lang", "fr")
    assert ran.status == 2
    assert "'fr' is not one of" in ran.err
