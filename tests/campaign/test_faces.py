"""A slice of the moorings of every shape, by every command and face."""

from __future__ import annotations

import pytest

from catopt.answers.blocks import Answer, Section, Table, measured
from catopt.words import Message
from tests.campaign import faces
from tests.campaign.shapes import SHAPES, drawn

CHEAP = ("buoy on legs", "plumb", "plumb in a current", "hanging line")


@pytest.mark.parametrize("seed", [SHAPES.index(each) for each in CHEAP])
def test_every_face_has_the_numbers_of_the_record(seed: int) -> None:
    tally = faces.Tally()
    faces.try_mooring(drawn(seed), seed, tally)
    assert tally.faults == []
    assert tally.answered.total() > 20


@pytest.mark.slow
@pytest.mark.parametrize("seed", [k for k, shape in enumerate(SHAPES) if shape not in CHEAP])
def test_every_other_shape_has_every_face(seed: int) -> None:
    tally = faces.Tally()
    faces.try_mooring(drawn(seed), seed, tally)
    assert tally.faults == []


def test_moorings_are_of_every_size() -> None:
    """Forces from millinewtons to meganewtons, water from half a metre to hundreds of metres."""
    texts = [drawn(seed).text for seed in range(130)]
    weights = [
        float(line.split(" = ")[1])
        for text in texts
        for line in text.splitlines()
        if line.startswith("submerged_weight")
    ]
    assert min(map(abs, weights)) < 1e-3
    assert max(map(abs, weights)) > 1e4


def answer_of(*values: float) -> Answer:
    title = Message("captions.results")
    table = Table("lines", (measured("tension", values),))
    return Answer("network", title, (Section(title, (table,)),))


def test_a_face_that_shows_another_number_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    """The check itself fails where a number is zero, cut short, or missing from the record."""
    answer = answer_of(4500.0, 6343.0)
    assert faces._of_all(answer, "en", "") == ""
    assert faces._of_document(answer, {"a": [4500.0, {"b": 6343.0}]}) == ""
    assert "not in the record" in faces._of_document(answer, {"a": [4500.0]})
    for wrong in ("0.000", "4.6", "4"):
        monkeypatch.setattr(faces, "cell", lambda _, __, text=wrong: text)
        assert wrong in faces._of_all(answer, "en", "")


def test_a_refusal_that_names_what_does_not_exist_is_found() -> None:
    assert faces._of_refusal("the line is too short: give it more length") == ""
    assert "--no-such" in faces._of_refusal("the line is too short: take --no-such option then")
    assert faces._of_refusal("no") != ""
