"""Drag of a wire by its roughness: named by the user, and marked in every answer."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import pytest

from catopt.answers.note_motion import segments_table
from catopt.casefile import parse_case
from catopt.errors import InputError
from catopt.fem.energy_balance import EnergyBalance
from catopt.model import Case, Line, Motion, Segment, WaveState
from catopt.notes.motion import InMotion
from catopt.verify.dynamic import verify_dynamic
from catopt.verify.dynamic_result import DynamicVerification
from catopt.verify.dynamic_setup import Excitation
from catopt.words import say

from .test_dynamic import chain, run

WIRE = Segment(
    120.0, 200.0, EA=1.5e8, mass=27.0, drag_diameter=0.08, drag_method="roughness",
    roughness=8e-5, keulegan_carpenter=8.0,
)  # fmt: skip

REMARK = (
    "drag of segment 1 by its roughness: C_D 0.851, C_A 0.780, along the line C_D (0.03 + 0.05 sin)"
    " cos of the angle to the flow; these formulas of S4 are recalled and not verified"
)


def wire(segment: Segment = WIRE, **changes: Any) -> Case:
    waves = WaveState("regular", 2.0, 8.0)
    return chain(Motion(period=8.0, surge=0.5), 24.0, line=Line([segment]), waves=waves, **changes)


def test_the_coefficients_by_hand() -> None:
    """k/D = 1e-3: C_DS = 17/20, C_pi = 1.5 - 0.024 (12/0.85 - 10) = 1.40118, psi = C_pi - 0.4.

    C_A = 1 - 0.044 · 5.
    """
    (section,) = Excitation(wire()).properties.sections or ()
    C_pi = 1.5 - 0.024 * (12.0 / 0.85 - 10.0)
    assert section.drag_normal == pytest.approx(0.85 * (C_pi - 0.4), rel=1e-12)
    assert section.added_mass_normal == pytest.approx(0.78, rel=1e-12)
    assert (section.drag_tangential, section.oblique) == (0.0, (0.03, 0.05))
    large = replace(WIRE, keulegan_carpenter=40.0, wake_amplification=1.1)
    (section,) = Excitation(wire(large)).properties.sections or ()
    assert section.drag_normal == pytest.approx(1.1 * 0.85, rel=1e-12)
    assert section.added_mass_normal == pytest.approx(0.4, rel=1e-12)  # 0.6 - (0.85 - 0.65)


def test_every_answer_says_that_it_is_not_verified() -> None:
    part = run(wire(time_step=0.1))
    assert REMARK in part.remarks
    remark = next(each for each in part.remarks if each == REMARK)
    assert say(remark, "vi") != REMARK
    moved = InMotion(DynamicVerification(wire(), (), True), Excitation(wire()), (), ())
    drag = (
        each.values
        for each in segments_table(moved).columns
        if each.quantity is not None and each.quantity.symbol == "C_D"
    )
    (across,), (along,) = drag
    assert across == pytest.approx(0.851, abs=1e-3)
    assert along is None  # along the line it is not one number


def test_the_drag_along_is_booked() -> None:
    """Energy of a wire shaken along itself: what the steps lose stays below a thousandth."""
    balance = run(wire(time_step=0.05)).runs[0].history.balance
    assert isinstance(balance, EnergyBalance)
    assert balance.drag != 0.0
    assert balance.numerical_part < 1e-3


def test_the_drag_diameter_is_needed() -> None:
    with pytest.raises(InputError, match="drag_diameter: missing; the drag by the roughness"):
        verify_dynamic(wire(replace(WIRE, drag_diameter=None)))


CASE = """
[site]
water_depth = "20 m"
[line]
[[line.segments]]
length = "120 m"
{segment}
[load]
horizontal_force = "300 kN"
"""


def test_a_wire_of_the_catalogue_keeps_its_diameter_alone() -> None:
    rope = 'component = "wire 6-strand wire-core"\ndiameter = "80 mm"\ndrag_method = "roughness"\n'
    text = CASE.format(segment=rope + 'roughness = "0.1 mm"\nkeulegan_carpenter = 5')
    (segment,) = parse_case(f"{text}[catalogue]\nallow_recalled = true\n").line.segments
    assert segment.drag_diameter == pytest.approx(0.08)
    assert (segment.drag_normal, segment.drag_axial, segment.added_mass_normal) == (None,) * 3
    assert math.isclose(segment.roughness or 0.0, 1e-4)


@pytest.mark.parametrize(
    ("segment", "expected"),
    [
        (
            'component = "chain studless R3"\ndiameter = "76 mm"\ndrag_method = "roughness"\n'
            'roughness = "1 mm"\nkeulegan_carpenter = 5',
            [
                'line.segments[0].drag_method: found "roughness"; is for round wires and ropes, '
                "not chain: give drag_normal, or leave it out"
            ],
        ),
        (
            'submerged_weight = 200\ndrag_method = "roughness"\ndrag_normal = 1.2',
            [
                "line.segments[0].drag_normal: found 1.2; follows from the roughness; leave it out",
                'line.segments[0].roughness: missing; drag_method = "roughness" needs it',
                'line.segments[0].keulegan_carpenter: missing; drag_method = "roughness" needs it',
            ],
        ),
        (
            'submerged_weight = 200\ndrag_method = "roughness"\nroughness = 0\n'
            "keulegan_carpenter = 12",
            [
                "line.segments[0].wake_amplification: missing; for a KC of 12 or more S4 gives it "
                "in a graph (figure 2.10)"
            ],
        ),
        (
            'submerged_weight = 200\nroughness = "1 mm"',
            [
                'line.segments[0].roughness: found "1 mm"; goes with drag_method = "roughness", '
                "which is missing"
            ],
        ),
    ],
)
def test_what_does_not_go_with_it_is_refused(segment: str, expected: list[str]) -> None:
    with pytest.raises(InputError) as caught:
        parse_case(CASE.format(segment=segment))
    assert [str(problem) for problem in caught.value.problems] == expected
