"""``catopt curve --lang vi``: what is said."""

from __future__ import annotations

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
