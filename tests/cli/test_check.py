"""``catopt check``: what it judges, and how it ends."""

from __future__ import annotations

from .conftest import OWN, Run, document_of

CASE = OWN / "strength.toml"
"""T = H + w h: 30 + 20 = 50 kN of 200 / 2 in the storm; 10 + 25 = 35 kN of 200 / 3 by day."""


def test_the_document(run: Run) -> None:
    document = document_of(run, "check", CASE)
    assert document["passes"] is True
    tensions = [each for each in document["checks"] if each["kind"] == "tension"]
    # Six digits, far above rounding, for numbers done by hand.
    assert [round(each["demand"], 6) for each in tensions] == [50e3, 35e3]
    assert [round(each["utilisation"], 6) for each in tensions] == [0.5, 0.525]
    assert document["checks"][document["governing"]] == tensions[1]
    angles = [each["utilisation"] for each in document["checks"] if each["unit"] == "rad"]
    assert angles == [None, None]


def test_a_failed_check_is_an_answer_unless_strict(run: Run) -> None:
    """A fifth of 200 kN is 40 kN, less than the storm's 50."""
    plain = run("check", CASE, "--code", "break/5")
    strict = run("check", CASE, "--code", "break/5", "--strict")
    assert (plain.status, plain.err) == (0, "")
    assert (strict.status, strict.err) == (3, "catopt: 1 of 4 checks fails.\n")
    assert strict.out == plain.out
    assert run("check", CASE, "--strict").status == 0


def test_codes_of_the_option_take_the_place_of_the_case_s(run: Run) -> None:
    document = document_of(run, "check", CASE, "--code", "break/5", "--code", "API-RP-2SK")
    assert {each["code"] for each in document["checks"]} == {"user", "break/5", "API-RP-2SK"}
    assert {each["confidence"] for each in document["checks"]} == {None, "A", "B"}


def test_a_line_that_cannot_be_lost_fails_by_the_code_for_that(run: Run) -> None:
    leg = OWN / "one-leg.toml"
    for language, said in (("en", "no line is left"), ("vi", "không còn dây nào")):
        ran = run("check", leg, "--strict", "--lang", language)
        assert (ran.status, said in ran.out) == (3, True)
    assert document_of(run, "check", leg)["checks"][-1]["kind"] == "equilibrium"
