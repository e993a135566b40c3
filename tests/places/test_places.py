"""What docs/architecture.md shows of a code, a grade, a load method, a hull, a deck, a language."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from catopt.casefile import template
from catopt.words import LANGUAGES
from tests.new_language import begun
from tests.places import Copy
from tests.snippets import ROOT

CASE = ROOT / "cases" / "tanker-20m" / "case.toml"


def test_a_language_begins_with_the_english() -> None:
    """In each form that a text has; what is no text stays."""
    text = """[a]
en = "one \\"two\\""
vi = "một"

[b]
en = { one = "a line", many = "{count} lines" }
vi = "{count} dây"

[c]
en = \"\"\"
Of "several"
lines.\"\"\"

[[d]]
title = { en = "Chain", vi = "Xích" }
length = "5 m"
"""
    assert begun(text, "fr") == text.replace(
        'two\\""\n', 'two\\""\nfr = "one \\"two\\""\n'
    ).replace('lines" }\n', 'lines" }\nfr = { one = "a line", many = "{count} lines" }\n').replace(
        'lines."""\n', 'lines."""\nfr = """\nOf "several"\nlines."""\n'
    ).replace('vi = "Xích" }', 'vi = "Xích", fr = "Chain" }')


@pytest.mark.slow
def test_a_code(tmp_path: Path) -> None:
    """The case has 770 tf, by hand 770 * 9.80665 / 4 = 1887.780 kN."""
    copy = Copy.changed(tmp_path / "copy", "### A code")
    case = tmp_path / "case.toml"
    text = CASE.read_text("utf-8").replace("safety_factor = 5.0", 'code = "HARBOUR-2026"')
    case.write_text(text, "utf-8")
    said = copy.run("catopt", "check", case)
    assert said.returncode == 0, said.stderr
    assert "1887.780 kN" in said.stdout
    assert "Harbour master's rules" in " ".join(said.stdout.split())


@pytest.mark.slow
def test_a_grade_of_chain(tmp_path: Path) -> None:
    """By hand 0.0360 * 76^2 * (44 - 0.08 * 76) kN = 7884.9 kN."""
    copy = Copy.changed(tmp_path / "copy", "### A grade of chain")
    found = copy.python(
        "import catopt; print(catopt.component('chain studless R6', '76 mm').MBL / 1e3)"
    )
    assert float(found) == pytest.approx(0.0360 * 76**2 * (44.0 - 0.08 * 76.0), rel=1e-12)
    listed = copy.run("catopt", "catalog", "show", "chain studless", "R6", "76 mm", "--full")
    assert listed.returncode == 0, listed.stderr
    assert "7884.9 kN" in listed.stdout


@pytest.mark.slow
def test_a_load_method(tmp_path: Path) -> None:
    """By hand 0.5 * 1.221 * A * 20^2 with the frontal area of S3's tanker."""
    copy = Copy.changed(tmp_path / "copy", "### A load method")
    force, area, method = copy.python(
        "from catopt.loads import *\n"
        "from catopt.loads.tanker_20m import tanker\n"
        "ship = tanker()\n"
        "of = ship_loads(ship, Wind(20.0), SurfaceCurrent(1.0), SeaState(1.0, 6.0), 20.0,\n"
        "                wind_on='tanker loaded', method='wind-alone')\n"
        "print(of.horizontal_force, ship.frontal_area, of.method)"
    ).split()
    assert float(force) == pytest.approx(0.5 * 1.221 * float(area) * 400.0, rel=1e-12)
    assert method == "wind-alone"


@pytest.mark.slow
def test_a_hull(tmp_path: Path) -> None:
    """By hand 1025 pi 1.5^2 1.2 kg; its heave is held by rho g A, and it runs on its line."""
    copy = Copy.changed(tmp_path / "copy", "### A hull")
    case = tmp_path / "case.toml"
    text = template("floater")
    first, rest = text.split("[floater]\n")
    *_, rest = rest.split("[waves]\n")
    drum = '[floater.drum]\nradius = "1.5 m"\ndraught = "1.2 m"\n\n[waves]\n'
    case.write_text((first + drum + rest).replace('"2 min"', '"20 s"'), "utf-8")
    mass, stiffness = copy.python(
        "from catopt import read_case\n"
        "from catopt.verify.hulls import hull_of\n"
        f"of = hull_of(read_case({str(case)!r}))\n"
        "print(of.mass, of.stiffness[1, 1])"
    ).split()
    area = math.pi * 1.5**2
    assert float(mass) == pytest.approx(1025.0 * area * 1.2, rel=1e-12)
    assert float(stiffness) == pytest.approx(1025.0 * 9.80665 * area, rel=1e-12)
    said = copy.run("catopt", "verify", case, "--dynamic", "--full")
    assert "a drum with a draught of 1.20 m" in " ".join(said.stdout.split()), said.stderr
    case.write_text(case.read_text("utf-8").replace('"1.2 m"', '"-1.2 m"'), "utf-8")
    refused = copy.run("catopt", "verify", case, "--dynamic")
    assert refused.returncode == 2
    assert "floater.drum.draught" in refused.stderr


@pytest.mark.slow
def test_a_deck(tmp_path: Path) -> None:
    """By hand (100 - 1025 pi 0.1^2 / 4) 9.80665 N/m; what is no number is told by its line."""
    copy = Copy.changed(tmp_path / "copy", "### A deck")
    deck = tmp_path / "one.txt"
    deck.write_text("ONE LINE\n50 150 170 0.1 100 4e8\n", "utf-8")
    span, length, weight = copy.python(
        "from catopt import read_case\n"
        f"case = read_case({str(deck)!r})\n"
        "line = case.line\n"
        "print(case.load.span, line.length, line.segments[0].submerged_weight)"
    ).split()
    assert (float(span), float(length)) == (150.0, 170.0)
    by_hand = (100.0 - 1025.0 * math.pi * 0.1**2 / 4.0) * 9.80665
    assert float(weight) == pytest.approx(by_hand, rel=1e-12)
    assert copy.run("catopt", "import", deck).returncode == 0
    deck.write_text("ONE LINE\n50 150 none 0.1 100 4e8\n", "utf-8")
    refused = copy.run("catopt", "solve", deck)
    assert refused.returncode == 2
    assert "line 2" in refused.stderr
    assert "length none" in refused.stderr


@pytest.mark.slow
def test_a_language(tmp_path: Path) -> None:
    """Every word is there: the commands say in it what they say in English."""
    assert LANGUAGES == ("en", "vi")
    copy = Copy.changed(tmp_path / "copy", "### A language")
    begun_well = copy.run("tests.new_language", "fr")
    assert begun_well.returncode == 0, begun_well.stderr
    for words in (("solve", CASE), ("check", CASE), ("solve", "-h"), ("check", tmp_path / "none")):
        said, english = (copy.run("catopt", *words, "--lang", each) for each in ("fr", "en"))
        assert said.returncode == english.returncode
        assert said.stdout.replace("\N{NO-BREAK SPACE}", ",") == english.stdout
        assert said.stderr == english.stderr
    assert copy.run("catopt", "solve", CASE, "--lang", "de").returncode == 2
    buoy = ("size", "buoy", "pillar 1.8 m", "--depth", "12 m", "--at-rest")
    sizing = (*buoy, "--out", tmp_path / "note")
    for language in ("en", "fr"):
        sized = copy.run("catopt", *sizing, "--lang", language)
        assert sized.returncode == 0, sized.stderr
    shell = "from catopt.page_api import shell; print(shell('fr'))"
    assert 'value="fr" checked' in copy.python(shell)
