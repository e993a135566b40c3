"""What people type is found: any order, English or Vietnamese, with or without accents."""

from __future__ import annotations

import pytest

from catopt.catalogue.family import split_size, words_of
from catopt.catalogue.finding import MOST_ROWS, find, read_query, standard
from catopt.catalogue.fittings import fittings
from catopt.errors import InputError

STUDLESS_76 = [f"chain studless {g} 76 mm" for g in ("ORQ", "R3", "R3S", "R4", "R4S", "R5")]
WIRE_60 = [f"wire 6x36 {core} {g} 60 mm" for core in ("FC", "IWRC") for g in ("1770", "1960")]


@pytest.mark.parametrize(
    ("words", "names"),
    [
        ("76 R4 studless", ["chain studless R4 76 mm"]),
        ("chain studless R4 76mm", ["chain studless R4 76 mm"]),
        ("Studless chain, grade r4, dn 76", ["chain studless R4 76 mm"]),
        ("xích không ngáng 76", STUDLESS_76),
        ("xich khong ngang 76", STUDLESS_76),
        ("xích không ngáng cấp R4 cỡ 76", ["chain studless R4 76 mm"]),
        ("60 mm 6x36 wire", WIRE_60),
        ("cáp thép 6x36 60", WIRE_60),
        ("6x36 IWRC 1960 60 mm", ["wire 6x36 IWRC 1960 60 mm"]),
        ("polyester 160mm", ["polyester 160 mm"]),
        ("short link 30 8mm", ["chain short-link 30 8 mm"]),
        ("8 short-link 30", ["chain short-link 30 8 mm"]),
    ],
)
def test_components(words: str, names: list[str]) -> None:
    assert [component.name for component in find(words).components] == names


def test_open_link_chain_of_28_mm() -> None:
    """Four lengths of link in three grades, and the long-link chain, which has no grades."""
    found = find("DN 28 open link chain").components
    assert len(found) == 4 * 3 + 1
    assert {each.nominal_diameter for each in found} == {0.028}
    assert found == find("xích phao 28").components


def test_anchors_and_fittings() -> None:
    found = find("Stevpris 5 t sand")
    assert [each.name for each in found.anchors] == ["Stevpris Mk5", "Stevpris Mk6"]
    assert (found.query.mass, found.query.soil) == (5000.0, "sand")
    said = find("neo Stevpris 5 tấn cát")
    assert (said.anchors, said.query.mass, said.query.soil) == (found.anchors, 5000.0, "sand")
    assert [(f.name, f.size) for f in find("kenter 76").fittings] == [("chain joining link", 0.076)]
    assert [f.name for f in find("ma ní 38").fittings] == ["bow shackle"]


def test_how_a_query_is_read() -> None:
    assert read_query("1.5 in chain").size == pytest.approx(0.0381)
    assert read_query("DN28").size == pytest.approx(0.028)
    assert read_query("anchor 500kg mud").soil == "soft clay"
    assert read_query("76,5 mm chain").size == pytest.approx(0.0765)


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ("polyestr 160", 'did you mean "polyester" for "polyestr"'),
        ("chain studless 300", "not in this size: chain studless from 19 mm to 185 mm"),
        (
            "shackle 20",
            "not in this size: bow shackle: 17 sizes from 22 mm to 150 mm; joining shackle",
        ),
        ("shackle 1/0", "no such name; catopt catalog list shows the families"),
        ("zzzzzz", "no such name; catopt catalog list shows the families"),
    ],
)
def test_what_is_not_there(words: str, said: str) -> None:
    with pytest.raises(InputError, match=said):
        find(words)


def test_an_answer_has_an_end() -> None:
    assert len(find("chain").components) == MOST_ROWS


def test_what_an_answer_leaves_out_is_counted() -> None:
    known = standard()
    family = known.family("chain studless")
    every = [c for grade in family.grades for c in known.sold(family.name, grade=grade)]
    assert find("chain studless").left_out == len(every) - MOST_ROWS > 0
    shackles = [f for f in fittings() if "shackle" in " ".join((f.title, *f.also)).lower()]
    assert find("shackle").left_out == len(shackles) - MOST_ROWS > 0
    assert find("76 R4 studless").left_out == 0


@pytest.mark.parametrize(
    ("name", "rest", "size"),
    [
        ("polyester 160mm", "polyester", "160mm"),
        ("chain studless R4 76 mm", "chain studless R4", "76 mm"),
        ("DN 28 chain open-link 3D", "chain open-link 3D", "DN 28"),
        ("wire 6x36 IWRC 1770", "wire 6x36 IWRC 1770", None),
        ("chain open-link 3.5D", "chain open-link 3.5D", None),
        ("76", "", "76"),
    ],
)
def test_a_size_is_told_from_a_name(name: str, rest: str, size: str | None) -> None:
    assert split_size(name) == (rest, size)


def test_words_are_compared_without_accents() -> None:
    assert words_of("Xích có ngáng, Đá") == ("xich", "co", "ngang", "da")
