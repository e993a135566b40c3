"""The lower end of a line in a case file: led, or lost."""

from __future__ import annotations

import math

import pytest

from catopt.casefile import parse_case
from catopt.errors import InputError

LINE = """
[site]
water_depth = "20 m"
[line]
[[line.segments]]
length = "60 m"
submerged_weight = "245 N/m"
mass = "28.8 kg/m"
EA = "100 MN"
drag_normal = 0.0
[load]
horizontal_force = "20 kN"
"""
LED = (
    LINE
    + """
[anchor_motion]
period = "8 s"
heave = "0.5 m"
heave_phase = "90 deg"
[dynamics]
duration = "24 s"
"""
)
LOST = (
    LINE
    + """
[motion]
period = "8 s"
surge = "0.5 m"
[dynamics]
duration = "24 s"
broken_line = 1
broken_at = "10 s"
broken_end = "anchor"
"""
)


def test_what_a_file_says_is_read() -> None:
    led, lost = parse_case(LED), parse_case(LOST)
    assert led.anchor_motion is not None
    assert (led.anchor_motion.heave, led.anchor_motion.heave_phase) == (0.5, 0.5 * math.pi)
    assert lost.dynamics is not None
    assert (lost.dynamics.broken_at, lost.dynamics.broken_end) == (10.0, "anchor")


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (LED[: LED.index("[dynamics]")], "anchor_motion: needs [dynamics], which is missing"),
        (LED.replace('period = "8 s"\n', ""), "exactly one of period, file is required"),
        (LED.replace("heave = ", "rao_file = "), "anchor_motion.rao_file"),
        (LOST.replace("broken_line = 1", "broken_line = 2"), "there is one line"),
        (
            LOST.replace("broken_line = 1\n", "").replace('broken_at = "10 s"\n', ""),
            "dynamics.broken_line: missing; broken_end needs it",
        ),
    ],
)
def test_what_does_not_fit_is_refused(text: str, message: str) -> None:
    with pytest.raises(InputError) as caught:
        parse_case(text)
    assert message in str(caught.value)
