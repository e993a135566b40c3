"""The note of a moored body: what it computes, what decides, and its balance by hand."""

from __future__ import annotations

import math

import pytest

from catopt.notes.origin import Asked
from catopt.notes.system import directions_of, heading_of, read_system_note

from .notes import BODIES, TURRET, case_path, note_named, page_named, shown, stop
from .page_reader import calculate

LAST_DIGIT = 1e-15
"""Relative: sums in another order, and a change of unit."""
SOLVED = 1e-9
"""Relative: solved twice, from another start."""
NINE_DIGITS = 1e-8
"""Relative, of the largest term: numbers that are put in are written with nine digits."""


def test_a_line_that_is_gone_loads_the_others_more() -> None:
    """The utilisation is that of the fairlead's segment at least, by API 1.43 with a line out."""
    note = note_named(TURRET)
    allowed = note.case.line.segments[-1].MBL / 1.43
    for each, used in zip(note.report.line_out, note.left, strict=True):
        assert used >= each.response.largest_tension / allowed * (1.0 - SOLVED)


def test_a_restoring_curve_goes_half_as_far_again_as_the_load_or_nearly_as_far() -> None:
    """Lines that do not stretch and are nearly taut are too short for more."""
    for name, share in ((TURRET, 1.5), ("lee", 0.9)):
        note = note_named(name)
        far = share * math.hypot(*note.solution.offset)
        for curve in note.report.curves:
            assert curve.offset[-1] == pytest.approx(far, rel=LAST_DIGIT)
            assert -curve.offset[0] == curve.offset[-1]


@pytest.mark.parametrize(
    ("force", "expected"),
    [
        ((-4e6, 0.0), (180.0, 90.0)),
        ((1e5, 1e5), (45.0, 135.0)),
        ((0.0, -1.0), (-90.0, 0.0)),
        ((-1e5, 1e5), (135.0, 45.0)),
        ((0.0, 0.0), (0.0, 90.0)),
    ],
)
def test_curves_go_along_the_force_and_across_it(
    force: tuple[float, float], expected: tuple[float, float]
) -> None:
    found = [math.degrees(angle) for angle in directions_of(force)]
    assert found == pytest.approx(expected, abs=1e-12)


def test_a_body_that_turns_is_free_to_turn_along_the_curves() -> None:
    """The moments of its lines vanish on both curves, whatever the moment of the case."""
    system = note_named("arms").solution.system
    assert system.turns
    assert system.moment != 0.0
    # Its four lines are alike, so that all sides are: a moment would break the mirror.
    around = note_named("arms").report.circle.responses
    assert around[10].largest_tension == pytest.approx(around[20].largest_tension, rel=SOLVED)


def test_the_rule_of_practice_stands_beside_the_balance() -> None:
    note, page = note_named("pulled"), page_named("pulled")
    H = note.solution.lines[0].horizontal_force
    told = f"line 1 would carry H = 666.667 kN; by the balance it carries {H / 1e3:.3f} kN"
    assert told in page.sections["system_results"]


@pytest.mark.parametrize("name", BODIES)
def test_the_pulls_balance_the_force_with_the_numbers_of_the_page(name: str) -> None:
    system, table = note_named(name).solution.system, page_named(name).table("pulls")
    columns = ("H (N)", "φ (deg)", "H cos φ (N)", "H sin φ (N)")
    H, angle, along, across = map(table.column, columns)
    for force, turn, x, y in zip(H, angle, along, across, strict=True):
        assert (x, y) == (force * math.cos(turn), force * math.sin(turn))
    for axis, values in enumerate((along, across)):
        total = math.fsum(values)
        assert total + system.force[axis] == pytest.approx(0.0, abs=1e-9 * max(H))


@pytest.mark.parametrize("name", BODIES)
def test_every_step_of_the_balance_gives_what_it_says(name: str) -> None:
    solution = note_named(name).solution
    largest = max(line.horizontal_force for line in solution.lines)
    for row in page_named(name).table("balance").rows:
        put_in = row[1].text.split("=")[-1]
        value = row[2].value
        if "…" not in put_in:
            arm = max(leg.anchor_radius for leg in solution.system.legs)
            scale = {"m": arm, "N": largest, "N m": largest * arm}[row[2].text.partition(" ")[2]]
            assert calculate(put_in) == pytest.approx(value, rel=NINE_DIGITS, abs=1e-8 * scale)
        if row[3].value is not None:
            scale = max(abs(row[3].value), largest if row[2].text.endswith("N") else 1.0)
            moments = largest * 100.0 if row[2].text.endswith("N m") else 0.0
            assert value == pytest.approx(row[3].value, abs=1e-9 * max(scale, moments))


def test_what_cannot_be_computed_is_left_out_and_said(monkeypatch: pytest.MonkeyPatch) -> None:
    for curve in ("watch_circle", "restoring_curve"):
        stop(monkeypatch, f"catopt.mooring.case.{curve}", "it wanders")
    beside = "is left out, because somewhere on it it wanders"
    note = read_system_note(case_path(TURRET), asked=Asked(verify=False))
    of_codes = note.checks.warnings
    # The third: not for transients.
    codes = ["API-RP-2SK", "DNV-OS-E301-2008-CC1", "API-RP-2SK", "the fairlead"]
    assert [each.partition(":")[0].partition(" is ")[0] for each in of_codes] == codes
    assert note.warnings == (
        *of_codes,
        "the watch circle is left out: it wanders",
        f"the restoring curve towards 180.00 deg {beside}",
        f"the restoring curve towards 90.00 deg {beside}",
    )
    assert not {"system_watch_circle", "system_restoring"} & set(shown(note).sections)


def test_what_rounding_leaves_is_no_direction() -> None:
    assert heading_of(-21.7, -4.7e-14) == math.pi
    assert heading_of(0.0, 0.0) == 0.0
    assert heading_of(1.0, 1.0) == math.pi / 4.0
