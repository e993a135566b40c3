"""A user's own families: a good file, and broken ones with every error at once."""

from __future__ import annotations

from pathlib import Path

import pytest

from catopt import catalogue
from catopt.catalogue.reading import parse_families
from catopt.constants import STANDARD_GRAVITY
from catopt.errors import InputError

GOOD = """
schema = "catopt.families/1"

[sources.CERT]
title = "Certificate no. 4711 of 12 March 2024"
place = "office, folder 7"

[[family]]
name = "aramid rope"
also = ["our aramid"]
title = "Aramid rope of our stock"
grades = ["T1", "T2"]
range_mm = [30, 80]
[family.sizes]
mm = [30, 40, 80]
source = "CERT"
place = "page 1"
confidence = "A"

[[figure]]
family = "aramid rope"
quantity = "mass"
formula = { rows = [[30, 0.80], [40, 1.40], [80, 5.60]], unit = "kg/m" }
source = "CERT"
place = "page 1"
confidence = "A"

[[figure]]
family = "aramid rope"
quantity = "volume_diameter"
formula = { density = 1440 }
source = "CERT"
place = "page 2"
confidence = "A"

[[figure]]
family = "aramid rope"
quantity = "MBL"
grade = "T1"
formula = { rows = [[30, 500], [80, 3200]], unit = "kN" }
source = "CERT"
place = "page 2"
confidence = "A"

[[figure]]
family = "aramid rope"
quantity = "MBL"
grade = "T2"
formula = { d2 = 600e6 }
range_mm = [40, 80]
source = ["CERT", "TUD"]
place = "page 3"
confidence = "C"

[[figure]]
family = "aramid rope"
quantity = "EA"
variant = "certificate"
default = true
reason = "measured"
formula = { times = 40, of = "MBL" }
source = "CERT"
place = "page 3"
confidence = "A"

[[figure]]
family = "aramid rope"
quantity = "EA"
variant = "guess"
default = false
formula = { d0 = 1e6, d2 = 2e10 }
source = "CERT"
place = "the back of it"
confidence = "R"

[[figure]]
family = "aramid rope"
quantity = "drag_normal"
formula = { coefficient = 1.6, diameter = "d" }
source = "CERT"
place = "page 4"
confidence = "C"
"""


@pytest.fixture
def own(tmp_path: Path) -> catalogue.Catalogue:
    path = tmp_path / "own.toml"
    path.write_bytes(b"\xef\xbb\xbf" + GOOD.replace("\n", "\r\n").encode())  # as Windows saves it
    return catalogue.read_families(path)


def test_a_good_file(own: catalogue.Catalogue) -> None:
    """1.40 kg/m at 40 mm; weight (1.40 - 1025 x 1.40/1440) g0; T1 at 40 mm by interpolation."""
    rope = catalogue.component("our aramid T1", 0.040, among=own)
    assert rope.name == "aramid rope T1 40 mm"
    assert rope.mass == 1.40
    weight = 1.40 * (1.0 - 1025.0 / 1440.0) * STANDARD_GRAVITY
    assert rope.submerged_weight == pytest.approx(weight, rel=1e-12)
    # value/d^2: 500/30^2 at 30 mm, 3200/80^2 = 0.5 at 80 mm, a fifth of the way from 30 to 80.
    ratio = 500.0 / 900.0 + 0.2 * (0.5 - 500.0 / 900.0)
    assert rope.MBL == pytest.approx(ratio * 1600e3, rel=1e-12)
    assert rope.EA == pytest.approx(40.0 * ratio * 1600e3, rel=1e-12)
    assert [source.key for source in rope.provenance["EA"].sources] == ["CERT"]
    assert rope.drag_normal == catalogue.Hydrodynamic(1.6, 0.040, "d")


def test_recalled_figures_of_one_s_own_are_off_too(own: catalogue.Catalogue) -> None:
    with pytest.raises(InputError, match="recalled"):
        catalogue.component("aramid rope T1", 0.040, variants={"EA": "guess"}, among=own)
    guess = catalogue.component(
        "aramid rope T1", 0.040, variants={"EA": "guess"}, allow_recalled=True, among=own
    )
    assert guess.EA == pytest.approx(1e6 + 2e10 * 0.0016, rel=1e-12)


def test_beside_catopt_s_own(own: catalogue.Catalogue) -> None:
    both = catalogue.standard().with_families(own)
    assert len(both.families) == len(catalogue.families()) + 1
    assert both.parse_name("aramid rope T2") == ("aramid rope", "T2")
    found = catalogue.search(MBL_at_least=3e6, family="aramid rope", among=both)
    assert [component.name for component in found] == [
        "aramid rope T1 80 mm", "aramid rope T2 80 mm",
    ]  # fmt: skip
    # T2 is made from 40 mm.
    assert len(both.sold("aramid rope T2")) == 2


def test_a_name_that_is_taken_is_an_error(own: catalogue.Catalogue) -> None:
    twice = GOOD.replace('"our aramid"', '"studless chain"')
    with pytest.raises(InputError, match='"studless chain"; a name of "chain studless" already'):
        catalogue.standard().with_families(parse_families(twice, known=KNOWN))
    with pytest.raises(InputError, match="already"):
        own.with_families(own)


KNOWN = {"TUD": catalogue.Source("TUD", "a source of catopt's", "there")}


def wrong(text: str) -> list[str]:
    """Read a file that is wrong; every problem as it is told."""
    with pytest.raises(InputError) as error:
        parse_families(text, "own.toml", KNOWN)
    assert str(error.value).startswith("own.toml: ")
    return [str(problem) for problem in error.value.problems]


def test_the_good_text_is_right_as_it_stands() -> None:
    assert len(parse_families(GOOD, known=KNOWN).families) == 1


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ('schema = "catopt.families/1"', "", "schema: missing; text in quotes is required"),
        (
            "catopt.families/1",
            "catopt.families/2",
            'schema: found "catopt.families/2"; "catopt.families/1" is required',
        ),
        ("[[family]]", "[family]", "family: found a table; tables that each begin with [[family]]"),
        ('name = "aramid rope"', 'nme = "aramid rope"', "family[0].nme: found an unknown key; did"),
        ('name = "aramid rope"', "name = 7", "family[0].name: found 7; text in quotes is required"),
        (
            "range_mm = [30, 80]",
            "range_mm = [80, 30]",
            "family[0].range_mm: found an array of 2; the smallest and the largest diameter in mm",
        ),
        (
            "range_mm = [30, 80]",
            "",
            "family[0].range_mm: missing; an array of 2 numbers is required",
        ),
        (
            "mm = [30, 40, 80]",
            "mm = [30, 80, 40]",
            "family[0].sizes.mm: found an array of 3; must rise, and be above 0",
        ),
        (
            "mm = [30, 40, 80]",
            "mm = [30, 90]",
            "family[0].sizes.mm: found an array of 2; 90 mm lies outside the family's range_mm",
        ),
        (
            'grades = ["T1", "T2"]',
            'grades = ["T1", "T1"]',
            "family[0].grades: found an array of 2; a text or an array of different texts",
        ),
        (
            'confidence = "A"\n\n[[figure]]\nfamily = "aramid rope"\nquantity = "volume_diameter"',
            'confidence = "D"\n\n[[figure]]\nfamily = "aramid rope"\nquantity = "volume_diameter"',
            'figure[0].confidence: found "D"; one of A, B, C, R is required',
        ),
        (
            'place = "page 2"\nconfidence = "A"\n\n[[figure]]\nfamily = "aramid rope"\n'
            'quantity = "MBL"\ngrade = "T2"',
            'confidence = "A"\n\n[[figure]]\nfamily = "aramid rope"\n'
            'quantity = "MBL"\ngrade = "T2"',
            "figure[2].place: missing; text in quotes is required",
        ),
        (
            'source = ["CERT", "TUD"]',
            'source = ["CERT", "TU"]',
            'figure[3].source: found an array of 2; no source "TU"; those of [sources] are: TUD',
        ),
        (
            'quantity = "EA"\nvariant = "guess"',
            'quantity = "EAs"\nvariant = "guess"',
            'figure[5].quantity: found "EAs"; one of mass, volume_diameter, MBL',
        ),
        (
            'grade = "T2"',
            'grade = "T3"',
            'figure[3].grade: found "T3"; "aramid rope" has no grade T3; it has: T1, T2',
        ),
        (
            'family = "aramid rope"\nquantity = "drag_normal"',
            'family = "aramide rope"\nquantity = "drag_normal"',
            'figure[6].family: found "aramide rope"; no family "aramide rope" in this file',
        ),
        (
            "range_mm = [40, 80]",
            "range_mm = [40, 90]",
            'figure[3].range_mm: found an array of 2; must lie within range_mm of "aramid rope"',
        ),
        (
            "formula = { d2 = 600e6 }\nrange_mm = [40, 80]",
            'formula = { rows = [[50, 1], [80, 2]], unit = "N" }\nrange_mm = [40, 80]',
            "figure[3].range_mm: found an array of 2; must lie within the rows of the formula",
        ),
        ("density = 1440", "densty = 1440", "figure[1].formula.densty: found an unknown key; did"),
        ("density = 1440", "density = -1", "figure[1].formula.density: found -1; must be above 0"),
        (
            "density = 1440",
            'density = "1440 kg/m^3"',
            "figure[1].formula.density: found '1440 kg/m^3'; a number is required",
        ),
        ("{ d2 = 600e6 }", "7", "figure[3].formula: found 7; a table is required"),
        (
            "{ d2 = 600e6 }",
            "{ d2 = 600e6, chain_load = 0.02 }",
            "figure[3].formula: found a table; exactly one of d0, d1, d2, d3, chain_load, rows",
        ),
        (
            "{ d2 = 600e6 }",
            "{ d2 = -600e6 }",
            "family[0]: found -960000 N; MBL of grade T2 must be",
        ),
        ('unit = "kN"', 'unit = "tons"', 'figure[2].formula.unit: found "tons"; one of N, kN, MN'),
        ("[30, 500]", "[90, 500]", "figure[2].formula.rows[1]: found 80 mm; the diameters of the"),
        ("[30, 500]", "30", "figure[2].formula.rows[0]: found 30; a row [diameter in mm, value]"),
        ('of = "MBL"', 'of = "mass"', 'figure[4].formula.of: found "mass"; one of MBL is required'),
        ('diameter = "d" }', 'diameter = "D" }', 'figure[6].formula.diameter: found "D"; "d", a'),
        (
            'quantity = "volume_diameter"',
            'quantity = "price"',
            "figure[1].formula.density: found an unknown key",
        ),
        ("default = true\n", "", ""),
        ('reason = "measured"\n', "", "family[0]: EA of grade T1 has a choice: give the default"),
        ("default = false", "default = true", "family[0]: EA of grade T1 has 2 defaults"),
        ('variant = "guess"', "", "family[0]: EA of grade T1 has 2 figures: give each a variant"),
        ("default = true", 'default = "yes"', 'figure[4].default: found "yes"; true or false is'),
        ('title = "Certificate no. 4711 of 12 March 2024"', "", "sources.CERT.title: missing"),
    ],
)
def test_what_is_wrong_is_told_with_its_path(old: str, new: str, message: str) -> None:
    text = GOOD.replace(old, new, 1)
    assert text != GOOD
    if not message:
        parse_families(text, known=KNOWN)
        return
    assert any(problem.startswith(message) for problem in wrong(text)), wrong(text)


def test_a_family_without_mass_or_volume_is_told() -> None:
    text = GOOD.replace('quantity = "mass"', 'quantity = "price"').replace(
        'unit = "kg/m"', 'unit = "USD/m"'
    )
    assert sorted(wrong(text)) == [
        *(
            f'family[0]: "aramid rope" has no default figure for mass of grade {grade}'
            for grade in ("T1", "T2")
        ),
        *(
            f"family[0]: volume_diameter of grade {grade} is derived from mass, for which there is "
            "no figure"
            for grade in ("T1", "T2")
        ),
    ]


def test_all_errors_are_told_at_once() -> None:
    text = (
        GOOD.replace("range_mm = [30, 80]", "range_mm = 30")
        .replace("density = 1440", "density = 0")
        .replace('confidence = "C"', 'confidence = "E"')
        .replace('of = "MBL"', 'of = "mbl"')
    )
    told = wrong(text)
    assert len(told) == 5
    assert sorted({line.partition(":")[0] for line in told}) == [
        "family[0].range_mm",
        "figure[1].formula.density",
        "figure[3].confidence",
        "figure[4].formula.of",
        "figure[6].confidence",
    ]
    with pytest.raises(InputError, match=r"own\.toml: 5 errors"):
        parse_families(text, "own.toml", KNOWN)


def test_a_file_that_is_no_toml_or_not_there(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"line 2, column 8"):
        parse_families("a = 1\nb = [1 2]\n")
    with pytest.raises(InputError, match="families file: there is no such file"):
        catalogue.read_families(tmp_path / "gone.toml")
    path = tmp_path / "latin.toml"
    path.write_bytes("title = 'Größe'".encode("latin-1"))
    with pytest.raises(InputError, match="save the file as UTF-8"):
        catalogue.read_families(path)


def test_an_empty_file_is_told() -> None:
    assert wrong("") == ["schema: missing; text in quotes is required"]
