"""Every command in both languages: every text is there and fits, and the numbers are the same."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from io import BytesIO
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
import openpyxl
import pytest

from catopt import catalogue, read_case, verify_case
from catopt.catenary.pieces import LineProblem, cut
from catopt.catenary.solution import check_buoys, named_line
from catopt.catenary.solve import refusal
from catopt.catenary.state import NOT_CONVERGED, TOO_HEAVY, TOO_SHORT
from catopt.errors import FloatsUpError, NoEquilibriumError
from catopt.fem.run_settings import record_warnings, step_warnings
from catopt.loads.drag_anchor import SOILS
from catopt.loads.ship import PROPELLER_AREA_RATIOS
from catopt.loads.ship_coefficients import TYPES
from catopt.loads.sinker import SOIL_FRICTION
from catopt.model import Line, Load, PointLoad, Segment
from catopt.mooring.case import report_system
from catopt.verify.comparison import Compared, Unit
from catopt.verify.motion_words import part_sentence, rough_sentence
from catopt.waves import Sea, jonswap, random_waves
from catopt.words import Message, is_term, say, term

from .cases import write_files
from .conftest import BUOY, OWN, Run, fits, names, typed

_, *MANY = Path(__file__).with_name("many.txt").read_text("utf-8").splitlines()
FAMILIES = [family.name for family in catalogue.families()]
OF_FAMILIES = [f"catalog show '{name}'" for name in FAMILIES if name != "chain stud-link"]


@pytest.mark.slow
@pytest.mark.parametrize("line", [*MANY, *OF_FAMILIES])
def test_languages_differ_in_words_alone(
    run: Run, line: str, inside: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # Figures are drawn from the English in every language and take most of the time.
    monkeypatch.setattr("catopt.render.picture.pictures", lambda *_, **__: {})
    write_files(inside)
    command = typed(line)
    english, said = (run(*command, "--lang", each, "--out", each) for each in ("en", "vi"))
    # Two of the lines that go slack in motion do not converge, which is an answer.
    assert english.status == said.status == (4 if "NOT CONVERGED" in english.out else 0), said.err
    assert fits(said.out)
    if command[0] in {"curve", "verify"}:
        assert said_alike(english.out, said.out) <= {english.out.splitlines()[0]}
    files = {path.name: path.read_bytes() for path in (inside / "en").iterdir()}
    assert files.keys() == names(inside / "vi")
    for name, content in files.items():
        other = (inside / "vi" / name).read_bytes()
        if name.endswith(".xlsx"):
            assert content != other
            assert numbers(content) == numbers(other) != []
        elif name != "note.html":
            assert content == other


def numbers(workbook: bytes) -> list[tuple[int, str, object, str]]:
    """List the numbers of a workbook: sheet, cell, value and format."""
    book = openpyxl.load_workbook(BytesIO(workbook))
    return [
        (index, cell.coordinate, cell.value, cell.number_format)
        for index, sheet in enumerate(book)
        for row in sheet.iter_rows()
        for cell in row
        if cell.data_type == "n" and cell.value is not None
    ]


def said_alike(english: str, vietnamese: str) -> set[str]:
    """Lines with words that are the same in both languages."""
    in_words = re.compile(r"[^\W\d_]{3,}")
    lines = (set(text.splitlines()) for text in (english, vietnamese))
    return {line for line in set.intersection(*lines) if in_words.search(line)}


# ------------------------------------------------------------------ what data files say


@pytest.mark.parametrize("name", FAMILIES)
def test_all_that_the_data_say_of_a_family_is_said(name: str) -> None:
    """Its title and notes, and formula, reason and note of every figure, recalled ones included."""
    family = catalogue.standard().family(name)
    told = [family.title, family.note]
    told += [text for figure in family.figures for text in (figure.reason, figure.note)]
    assert [text for text in told if text and say(text, "vi") == text] == []
    formulas = [say(figure.text, "vi") for figure in family.figures]
    english = re.compile(r"d in mm?|both legs|table of|times|volume-equivalent|tension")
    assert [text for text in formulas if english.search(text)] == []


def test_what_is_cited_is_in_no_table() -> None:
    """Titles of documents and places in them; what is reckoned or recalled is in no document."""
    standard = catalogue.standard()
    figures = [figure for family in standard.families for figure in family.figures]
    cited = {figure.place for figure in figures if figure.confidence != "R"}
    cited |= {s.title for figure in figures for s in figure.sources if s.key != "RECALLED"}
    assert cited
    assert not [text for text in cited if is_term(text) or isinstance(text, Message)]


@pytest.mark.parametrize(
    "name", sorted({*TYPES, *PROPELLER_AREA_RATIOS, *SOIL_FRICTION, *SOILS, "sea state"})
)
def test_kinds_of_ship_and_soil_have_their_vietnamese(name: str) -> None:
    assert is_term(name)
    assert say(term(name), "vi") != name


# ------------------------------------------------------------------ sentences of no answer above


def refusals() -> Iterator[str]:
    """Make every message for a line that cannot hang as asked."""
    line = Line([Segment(100.0, 1000.0)])
    for status, height, load in (
        (TOO_SHORT, 120.0, Load(span=80.0)),
        (TOO_SHORT, 120.0, Load(fairlead_tension=100.0)),
        (TOO_SHORT, 60.0, Load(span=80.0)),  # 60, 80, 100: as long
        (TOO_SHORT, 100.0, Load(fairlead_tension=1.0)),
        (TOO_HEAVY, 60.0, Load(fairlead_tension=100.0)),
        (NOT_CONVERGED, 60.0, Load(span=80.0)),
    ):
        setting = LineProblem(cut(line)[0], 0.0, height, 0.5)
        yield refusal(status, line, load, setting).message
    for name in ("", "float"):
        high = Line([Segment(100.0, 1000.0)], [PointLoad(50.0, -9e4, name=name)])
        with pytest.raises(FloatsUpError) as afloat, named_line(2):
            check_buoys(high, [25.0], 20.0)
        yield afloat.value.message


def of_bodies() -> Iterator[str]:
    """Make the refusals of a body, and what a line that is gone leaves."""
    for name in ("do-not-meet", "large-moment"):
        with pytest.raises(NoEquilibriumError) as refused:
            report_system(read_case(OWN / f"{name}.toml"))
        yield refused.value.message
    report = report_system(read_case(OWN / "one-line.toml"), with_line_out=True)
    yield from (each.refusal for each in report.line_out)


UNITS: list[tuple[Unit, str]] = [
    ("N", "fairlead_tension"), ("m", "span"), ("m", "position_x"), ("rad", "anchor_angle"),
    ("Nm", "moment_of_lines"),
]  # fmt: skip


def of_models() -> Iterator[str]:
    """Say every verdict: near and far, settled and not, of a slack line and not."""
    plain = verify_case(read_case(BUOY), elements=40).static
    for (unit, quantity), closed_form in product(UNITS, (1.0, 1.0001, 2.0)):
        for theory, finest in product((1.0, 2.0), (1.0, 1.1)):
            fem = (1.0, 1.0, finest)
            each = Compared(quantity, unit, closed_form, fem, 1.0, 1e-3, line=1, theory=theory)
            part = replace(plain, quantities=(each,))
            yield from filter(None, (part_sentence(part), rough_sentence(part)))
    for count in range(1, 7):
        others = plain.quantities[count:]
        rough = [replace(q, fem=(1.0, 2.0, 1.0), scale=1.0) for q in plain.quantities[:count]]
        yield rough_sentence(replace(plain, quantities=(*rough, *others)))
        off = [replace(q, closed_form=9.0 * (q.scale + 1.0)) for q in plain.quantities[:count]]
        yield part_sentence(replace(plain, quantities=(*off, *others)))


def of_runs() -> Iterator[str]:
    """Warn of waves that break and nearly repeat themselves, and of a step that is rather long."""
    sea = Sea(8.0, random_waves(jonswap(7.0, 9.0), 12, np.random.default_rng(1)))
    yield from step_warnings(0.5, 600.0, {Message("motion.motion_or_force"): 8.0}, sea)
    yield from record_warnings(0.2, 0.1)


@pytest.mark.parametrize(
    ("sentences", "least"), [(refusals, 8), (of_bodies, 3), (of_models, 9), (of_runs, 4)]
)
def test_sentences_hold_nothing_english(sentences: Any, least: int) -> None:
    """What a message holds is said with it: joined to a plain text it would stay English."""
    told = set(sentences())
    assert len(told) >= least
    english = re.compile(r" (the|is|of|by|Give|change|allowed|tension|span|inclination|more) ")
    for each in told:
        assert isinstance(each, Message)
        assert not english.search(say(each, "vi"))
