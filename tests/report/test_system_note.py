"""The note of a moored body: what it computes, what decides, and its balance by hand."""

from __future__ import annotations

import math

import pytest

from catopt.answers.note_system import system_note_answer
from catopt.errors import NotConvergedError
from catopt.notes.directory import Asked
from catopt.notes.system import directions_of, heading_of, read_system_note

from .notes import BODIES, TURRET, body_note, case_path, page_named, shown
from .page_reader import calculate
from .said import assert_said, blocks

LAST_DIGIT = 1e-15
"""Relative: sums in another order, and a change of unit."""
SOLVED = 1e-9
"""Relative: solved twice, from another start."""
NINE_DIGITS = 1e-8
"""Relative, of the largest term: numbers that are put in are written with nine digits."""


@pytest.mark.parametrize(("name", "place", "lines"), blocks("bodies"))
def test_what_is_said(name: str, place: str, lines: list[str]) -> None:
    assert_said(name, place, lines)


def test_a_line_that_is_gone_loads_the_others_more() -> None:
    """The utilisation is that of the fairlead's segment at least, by API 1.43 with a line out."""
    note = body_note(TURRET)
    MBL = note.case.line.segments[-1].MBL
    assert MBL is not None
    allowed = MBL / 1.43
    for each, used in zip(note.report.line_out, note.left, strict=True):
        assert each.response is not None
        assert used is not None
        assert used >= each.response.largest_tension / allowed * (1.0 - SOLVED)


def test_a_restoring_curve_goes_half_as_far_again_as_the_load_or_nearly_as_far() -> None:
    """Lines that do not stretch and are nearly taut are too short for more."""
    for name, share in ((TURRET, 1.5), ("lee", 0.9)):
        note = body_note(name)
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
    system = body_note("arms").solution.system
    assert system.turns
    assert system.moment != 0.0
    # Its four lines are alike, so that all sides are: a moment would break the mirror.
    circle = body_note("arms").report.circle
    assert circle is not None
    mirrored = [circle.responses[k].largest_tension for k in (10, 20)]
    assert mirrored[0] == pytest.approx(mirrored[1], rel=SOLVED)


def test_the_rule_of_practice_stands_beside_the_balance() -> None:
    note, page = body_note("pulled"), page_named("pulled")
    H = note.solution.lines[0].horizontal_force
    told = f"line 1 would carry H = 666.667 kN; by the balance it carries {H / 1e3:.3f} kN"
    assert told in page.sections["system_results"]


@pytest.mark.parametrize("name", BODIES)
def test_the_pulls_balance_the_force_with_the_numbers_of_the_page(name: str) -> None:
    system, table = body_note(name).solution.system, page_named(name).table("pulls")
    H, angle, along, across = (
        [row[table.headings.index(name)].value for row in table.rows]
        for name in ("H (N)", "φ (deg)", "H cos φ (N)", "H sin φ (N)")
    )
    largest = max(value for value in H if value is not None)
    for force, turn, x, y in zip(H, angle, along, across, strict=True):
        assert force is not None
        assert turn is not None
        assert (x, y) == (force * math.cos(turn), force * math.sin(turn))
    for axis, values in enumerate((along, across)):
        total = math.fsum(value for value in values if value is not None)
        assert total + system.force[axis] == pytest.approx(0.0, abs=1e-9 * largest)


@pytest.mark.parametrize("name", BODIES)
def test_every_step_of_the_balance_gives_what_it_says(name: str) -> None:
    solution = body_note(name).solution
    largest = max(line.horizontal_force for line in solution.lines)
    for row in page_named(name).table("balance").rows:
        put_in = row[1].text.split("=")[-1]
        value = row[2].value
        assert value is not None
        if "…" not in put_in:
            arm = max(leg.anchor_radius for leg in solution.system.legs)
            scale = {"m": arm, "N": largest, "N m": largest * arm}[row[2].text.partition(" ")[2]]
            assert calculate(put_in) == pytest.approx(value, rel=NINE_DIGITS, abs=1e-8 * scale)
        if row[3].value is not None:
            scale = max(abs(row[3].value), largest if row[2].text.endswith("N") else 1.0)
            moments = largest * 100.0 if row[2].text.endswith("N m") else 0.0
            assert value == pytest.approx(row[3].value, abs=1e-9 * max(scale, moments))


def test_a_truss_without_an_answer_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    def stops(*_: object, **__: object) -> None:
        raise NotConvergedError("it stopped short")

    monkeypatch.setattr("catopt.verify.case.verify_case", stops)
    note = read_system_note(case_path("idle"))
    page = shown(note)
    assert "it stopped short" in page.sections["warnings"]
    assert "NOT VERIFIED" in page.sections["system_verification"]


def test_what_cannot_be_computed_is_left_out_and_said(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def stops(*_: object, **__: object) -> None:
        raise NotConvergedError("it wanders")

    monkeypatch.setattr("catopt.mooring.case.watch_circle", stops)
    monkeypatch.setattr("catopt.mooring.case.restoring_curve", stops)
    beside = "is left out, for somewhere on it it wanders"
    note = read_system_note(case_path(TURRET), asked=Asked(verify=False))
    of_codes = note.checks.warnings
    codes = ["API-RP-2SK", "DNV-OS-E301-2008-CC1", "API-RP-2SK"]  # the last: not for transients
    assert [each.partition(":")[0] for each in of_codes] == codes
    assert note.warnings == (
        *of_codes,
        "the watch circle is left out: it wanders",
        f"the restoring curve towards 180.00 deg {beside}",
        f"the restoring curve towards 90.00 deg {beside}",
    )
    shown = {section.name for section in system_note_answer(note).sections}
    assert not {"system_watch_circle", "system_restoring"} & shown


def test_what_rounding_leaves_is_no_direction() -> None:
    assert heading_of(-21.7, -4.7e-14) == math.pi
    assert heading_of(0.0, 0.0) == 0.0
    assert heading_of(1.0, 1.0) == math.pi / 4.0
