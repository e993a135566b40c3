"""Buoys as CALMAR saves them: the test buoy of its manuals, and everything that can be wrong."""

from __future__ import annotations

import math
import os
import re
from pathlib import Path

import pytest

from catopt.errors import InputError
from catopt.loads import read_calmar_buoy
from catopt.loads.calmar_file import parse_calmar_buoy
from tests.cli.conftest import Run, run

from . import ROUNDING

__all__ = ("run",)

FILE = """<?xml version="1.0" encoding="UTF-8" ?>
<Calmar version="1.0.0.0">
  <Buoy Name="Test" ChaineMin="14" ChaineMax="30" MasseLestUnitaire="25" NombreLestMin="2"
    NombreLestMax="4">
    <Structure Name="Pole" Masse="50" OffsetFlotteur="0.7" OffsetOrganeau="0.65">
      <ElementDimItem H="2" D0="0.15" D1="0.15" DI="0" Volume="0.0353429173528852" />
    </Structure>
    <Flotteur Name="Float" Masse="60">
      <ElementDimItem H="0.4" D0="0.4" D1="0.6" DI="0.15" Volume="0" />
      <ElementDimItem H="0.3" D0="0.6" D1="0.6" DI="0.15" Volume="0" />
      <ElementDimItem H="0.6" D0="0.6" D1="0.4" DI="0.15" Volume="0" />
    </Flotteur>
    <Pylone Name="Support" Height="0.1" WidthHigh="0.4" WidthLow="0.4" Masse="10" />
    <Equipement Name="Mark" Height="0.1" WidthHigh="0" WidthLow="0.4" Masse="5" />
  </Buoy>
</Calmar>"""
"""Figures of the manual's pages 7 to 16, in the form of the program's files."""

PRINTED = 0.260817640094903 + 0.0353429173528852
"""m3: the volumes of float and pole on the manual's screens."""


def test_the_manual_s_buoy() -> None:
    buoy = parse_calmar_buoy(FILE, "folder/test.xmlMB")
    # 15 digits are printed of the float's volume, which is computed here from its diameters.
    assert buoy.volume == pytest.approx(PRINTED, rel=1e-13)
    assert (buoy.name, buoy.origin) == ("Test", "IALA CALMAR, test.xmlMB")
    assert (buoy.mass, buoy.ballast) == (125.0, 50.0)
    assert (buoy.chain_min, buoy.chain_max) == (0.014, 0.03)
    assert (buoy.lowest, buoy.eye, buoy.deck) == pytest.approx((-0.7, -0.65, 1.3), rel=ROUNDING)
    assert (buoy.tower_area, buoy.marks_area) == pytest.approx((0.04, 0.02), rel=ROUNDING)


def test_what_displaces_more_is_the_hull() -> None:
    """A steel body that is entered as structure, with a ring for a float 0.8 m above its foot."""
    text = FILE.replace('H="2" D0="0.15" D1="0.15"', 'H="2" D0="2" D1="2"').replace(
        'Volume="0.0353429173528852"', 'Volume="5"'
    )
    buoy = parse_calmar_buoy(text)
    assert [each.volume for each in buoy.hull] == [5.0]
    # The float stands 0.7 m above the body's foot, and the ring 0.05 m above it.
    assert (buoy.lowest, buoy.eye) == pytest.approx((0.0, 0.05), rel=1e-9)
    top = buoy.outline(low=1.99, high=2.0)
    assert top == pytest.approx(0.01 * (2.0 + 0.4), rel=0.01)  # the float tapers by 1/3


def test_a_buoy_without_a_structure_is_made_fast_at_its_bottom() -> None:
    start, _, rest = FILE.partition("<Structure")
    _, _, after = rest.partition("</Structure>")
    empty = '<Structure Name="" Masse="0" OffsetFlotteur="0" OffsetOrganeau="0"></Structure>'
    buoy = parse_calmar_buoy(start + empty + after.replace('Masse="60"', 'Masse="100"'))
    assert buoy.structure == ()
    assert buoy.afloat().eye_depth == buoy.afloat().keel_depth == buoy.afloat().draught


def test_offsets_have_either_sign(run: Run, tmp_path: Path) -> None:
    """A maker's eye 0.092 m above the keel, and a pole whose foot is 0.2 m above it."""
    text = FILE.replace('OffsetOrganeau="0.65"', 'OffsetOrganeau="-0.092"')
    buoy = parse_calmar_buoy(text)
    assert (buoy.eye, buoy.lowest) == pytest.approx((0.092, -0.7), rel=ROUNDING)
    own = text.replace('OffsetFlotteur="0.7"', 'OffsetFlotteur="-0.2"')
    assert parse_calmar_buoy(own).lowest == 0.0
    (tmp_path / "own.xmlMB").write_text(text, encoding="utf-8")
    ran = run("loads", "buoy", tmp_path / "own.xmlMB", "--depth", "5 m", "--wind", "10 m/s")
    assert ran.status == 0, ran.err


def test_a_file_of_a_sizing_file_lies_beside_it(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Wherever one stands."""
    folder, elsewhere = tmp_path / "buoys", tmp_path / "elsewhere"
    folder.mkdir()
    elsewhere.mkdir()
    (folder / "own.xmlMB").write_text(FILE, encoding="utf-8")
    sizing = '[buoy]\nname = "own.xmlMB"\n[site]\nwater_depth = "5 m"\n'
    (folder / "size.toml").write_text(sizing, encoding="utf-8")
    monkeypatch.chdir(elsewhere)
    ran = run("loads", "buoy", folder / "size.toml", "--wind", "10 m/s")
    assert ran.status == 0, ran.err
    beside = run("loads", "buoy", folder / "own.xmlMB", "--depth", "5 m", "--wind", "10 m/s")
    assert ran.out.splitlines()[2:6] == beside.out.splitlines()[2:6]


def test_the_ballast_can_be_chosen_as_far_as_the_buoy_may_have_it(tmp_path: Path) -> None:
    path = tmp_path / "test.xmlMB"
    path.write_text(FILE, encoding="utf-8")
    assert read_calmar_buoy(path, ballast_pieces=4).ballast == 100.0
    with pytest.raises(InputError, match="ballast_pieces: found 5; this buoy has 2 to 4"):
        read_calmar_buoy(path, ballast_pieces=5)


def test_every_problem_is_told_at_once_by_the_file_s_own_names() -> None:
    wrong = (
        FILE.replace('H="0.3"', 'H="0,3"')
        .replace('Masse="60"', 'Masse="-60"')
        .replace(' ChaineMax="30"', ' ChainMax="30"')
        .replace("<Pylone ", '<Lampe Name="L" /><Pylone ')
        .replace('NombreLestMin="2"', 'NombreLestMin="1.5"')
        .replace("Equipement Name=", "Equipement Colour=")
    )
    with pytest.raises(InputError) as caught:
        parse_calmar_buoy(wrong, "wrong.xmlMB")
    assert {(each.key, each.found) for each in caught.value.problems} == {
        ("Buoy.ChaineMax", ""),
        ("Buoy.ChainMax", "an unknown attribute"),
        ("Buoy.NombreLestMin", '"1.5"'),
        ("Buoy.Flotteur.Masse", "-60.0"),
        ("Buoy.Flotteur.ElementDimItem[1].H", '"0,3"'),
        ("Buoy.Lampe[0]", "an unknown element"),
        ("Buoy.Equipement[0].Name", ""),
        ("Buoy.Equipement[0].Colour", "an unknown attribute"),
    }


def test_slices_that_cannot_be_are_told_by_their_place() -> None:
    wrong = FILE.replace('H="0.3"', 'H="0"').replace('Height="0.1" WidthHigh="0.4"', HIGH)
    with pytest.raises(InputError) as caught:
        parse_calmar_buoy(wrong)
    keys = {each.key for each in caught.value.problems}
    assert keys == {"Buoy.Flotteur.ElementDimItem[1].H", "Buoy.Pylone[0].Height"}


HIGH = 'Height="100" WidthHigh="0.4"'


def test_a_buoy_that_does_not_float_is_refused_by_the_file() -> None:
    with pytest.raises(InputError, match=r"heavy\.xmlMB: 1 error\n  mass: found 1065 kg"):
        parse_calmar_buoy(FILE.replace('Masse="60"', 'Masse="1000"'), "heavy.xmlMB")


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("<Calmar", "it is not XML"),
        ("<Buoy/>", "begins with <Calmar>"),
        ('<Calmar version="1"></Calmar>', "Buoy: found 0 of them; one is required"),
        ('<!DOCTYPE x [<!ENTITY a "b">]>' + FILE[39:], "has no declarations"),
        (FILE.replace('"Test"', f'"a{chr(0x202E)}b"'), "remove it"),
        (FILE.replace("</Calmar>", ""), "it is not XML: no element found"),
        (FILE.replace("</Buoy>", "stray</Buoy>"), "Buoy: found text between its elements"),
        (re.sub("<ElementDimItem.*/>", "", FILE), "Buoy.Flotteur: found no ElementDimItem"),
    ],
)
def test_what_is_no_buoy_of_calmar_is_refused(text: str, words: str) -> None:
    with pytest.raises(InputError, match=words):
        parse_calmar_buoy(text, "x.xmlMB")


def test_a_file_that_is_too_large_or_not_there(tmp_path: Path) -> None:
    path = tmp_path / "large.xmlMB"
    path.write_text(FILE + " " * 300_000, encoding="utf-8")
    with pytest.raises(InputError, match=r"at most 0\.25 MB are allowed"):
        read_calmar_buoy(path)
    with pytest.raises(InputError, match="buoy of CALMAR: there is no such file"):
        read_calmar_buoy(os.fspath(tmp_path / "none.xmlMB"))


def test_it_floats_as_its_manual_prints_without_a_chain() -> None:
    """178.9 - 3.9 kg less 7.0 of ballast in the water: 0.163902 m3, to be found by hand.

    The pole up to the float has 0.012370 m3, the lower slice 0.072518 m3 with 0.4 m of pole in
    its hole 0.079587; the rest of the height is in slices that are counted by hand below.
    """
    afloat = parse_calmar_buoy(FILE).afloat()
    mass = 175.0 - 50.0 * 1025.0 / 7320.0
    cone = math.pi / 12.0 * 0.4 * (0.16 + 0.24 + 0.36)
    cylinder = math.pi / 4.0 * 0.36 * 0.3
    pole = math.pi / 4.0 * 0.15**2 * 0.7
    # Hole and pole cancel inside the float, so that the float is solid from its bottom up.
    left = mass / 1025.0 - pole - cone - cylinder
    assert left < 0.0  # the water stands in the middle slice
    height = 0.4 + (left + cylinder) / (math.pi / 4.0 * 0.36)
    assert afloat.draught == pytest.approx(height, rel=1e-11)
