"""The equation trail, followed with a pocket calculator: what is printed gives what is printed."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

import pytest

from catopt.answers.blocks import Step
from catopt.answers.trail import TrailPiece, is_uniform, pieces_of, steps_of
from catopt.catenary.solve import solve
from catopt.model import Line, PointLoad, Segment
from catopt.words import Message

from .notes import LINES, note_named, page_named
from .page_reader import calculate

THEORY = (Path(__file__).parents[2] / "docs" / "theory.md").read_text("utf-8")


@pytest.fixture(params=LINES)
def name(request: pytest.FixtureRequest) -> str:
    return str(request.param)


@pytest.fixture
def steps(name: str) -> tuple[Step, ...]:
    return steps_of(note_named(name).solution)


@pytest.fixture
def pieces(name: str) -> tuple[TrailPiece, ...]:
    return pieces_of(note_named(name).solution)


def key_of(step: Step) -> str:
    assert isinstance(step.name, Message)
    return step.name.key.rpartition(".")[2]


def numbered() -> set[str]:
    """List the numbers that equations of the theory have; ``S1 (2), (5)`` are two."""
    found = set()
    for match in re.finditer(r"^.*=.*  (C\d|S\d.*)$", THEORY, re.MULTILINE):
        source, *others = match[1].split("), (")
        found |= {source + (")" if others else "")}
        found |= {f"{source.split()[0]} ({each.rstrip(')')})" for each in others}
    assert {"S1 (2)", "S1 (5)", "S1 (7)", "S2 (4)", "C1", "S2, below (4)"} <= found
    return found


@pytest.mark.parametrize(
    ("printed", "value"),
    [
        ("2 · 3 − 4", 2.0),
        ("3 √(1 + 0.75²) − 3 √(1 + (−0.75)²)", 0.0),
        ("2 asinh 0 − 5", -5.0),
        ("(4 / 2) (3² / 9 − 2)", -2.0),
        ("√(2 (2 + 2 · 3))", 4.0),
        ("max(0, 1 − 2)", 0.0),
        ("tan 45°", 1.0),
    ],
)
def test_the_calculator_reads_what_is_printed(printed: str, value: float) -> None:
    assert calculate(printed) == pytest.approx(value, abs=1e-15)


def test_the_printed_numbers_give_the_printed_value(name: str) -> None:
    """Nine digits are printed of each number, and differences lose some three of them."""
    table = page_named(name).table("trail")
    assert len(table.rows) >= 5
    place = table.headings.index("With numbers")
    for row in table.rows:
        printed = row[place].text.split("\n= ")[1]
        cell, value = row[place + 1], calculate(printed)
        if printed.startswith("atan"):
            assert value == pytest.approx(cell.value, rel=1e-7, abs=1e-12)
            continue
        largest = max(abs(float(n)) for n in re.findall(r"[\d.]+(?:e[+-]?\d+)?", printed))
        assert value == pytest.approx(cell.value, rel=1e-6, abs=1e-8 * largest), row[0].text


def test_every_value_is_that_of_the_solver(steps: tuple[Step, ...]) -> None:
    """Both in double precision; a height out of two long sides loses three digits or so."""
    compared = [step for step in steps if step.stated is not None]
    assert {"span", "fairlead_tension"} <= {key_of(step) for step in compared}
    assert_agree(compared)


def assert_agree(steps: Iterable[Step]) -> None:
    for step in steps:
        if step.stated is not None:
            assert step.value == pytest.approx(step.stated, rel=1e-9, abs=1e-9), step.name


@pytest.mark.parametrize("friction", [0.0, 0.3, 1.0])
def test_a_line_that_touches_twice_is_followed(friction: float) -> None:
    """With a friction of 1 nothing is left of the force where the buoy lifts the line."""
    line = Line([Segment(300.0, 1000.0, EA=5e8)], [PointLoad(120.0, -5e4)])
    solution = solve(line, height=50.0, horizontal_force=4e4, seabed_friction=friction)
    assert solution.regime == "grounded-in-parts"
    hanging = [each.T1 for each in pieces_of(solution) if not each.on_bed]
    assert (min(hanging) == 0.0) == (friction == 1.0)
    assert_agree(steps_of(solution))


def test_a_wrong_solution_does_not_pass() -> None:
    """The trail works the span out by itself: it does not repeat what the solver has."""
    for name in ("buoy-9.5m", "buoy-9.5m-slack", "leg"):
        solution = note_named(name).solution
        wrong = steps_of(replace(solution, span=1.01 * solution.span))
        (step,) = (each for each in wrong if key_of(each) == "span")
        assert step.value == pytest.approx(solution.span, rel=1e-9)
        assert step.stated == 1.01 * solution.span


def test_every_equation_is_in_the_theory(
    steps: tuple[Step, ...], pieces: tuple[TrailPiece, ...]
) -> None:
    cited = {step.equation for step in steps}
    cited |= {each for piece in pieces for each in piece.equation.split(", ")}
    assert cited - {""} <= numbered()


def test_the_words_about_pieces_cite_equations_of_the_theory() -> None:
    page = page_named("leg")
    cited = set(re.findall(r"\bC\d\b", page.sections["equations"]))
    assert cited == {"C3", "C5", "C6", "C7", "C8"}
    assert cited <= numbered()
    assert "S2 (28)" in THEORY


def test_one_plain_line_is_followed_by_the_sources_own_equations(
    name: str, steps: tuple[Step, ...], pieces: tuple[TrailPiece, ...]
) -> None:
    """A line of one segment without point loads, with or without friction on a flat bed."""
    uniform = name in ("buoy-9.5m", "buoy-9.5m-slack", "tanker-20m", "friction")
    assert is_uniform(note_named(name).solution) == uniform
    assert bool(pieces) != uniform
    sources = {step.equation.split()[0] for step in steps if step.equation}
    assert bool(sources & {"S1", "S2"}) == uniform


def test_s1s_own_numbers_stand_in_the_trail_of_its_example() -> None:
    """S1 prints an offset of 17.430 m and a tension of 0.446 tf for its buoy."""
    steps = steps_of(note_named("buoy-9.5m").solution)
    values = {key_of(step): step.value or 0.0 for step in steps}
    assert round(values["span"], 3) == 17.430
    assert round(values["fairlead_tension"] / 9806.65, 3) == 0.446


def test_pieces_follow_each_other(pieces: tuple[TrailPiece, ...], name: str) -> None:
    """V goes on from piece to piece, but for the point loads; T and lengths add up."""
    if not pieces:
        return
    solution = note_named(name).solution
    assert math.fsum(row.length for row in pieces) == pytest.approx(solution.line.length)
    for row in pieces:
        if not row.on_bed:
            assert row.V2 == pytest.approx(row.V1 + row.weight * row.length, rel=1e-12)
    last = pieces[-1]
    assert last.T2 == pytest.approx(solution.fairlead.tension, rel=1e-9)
    # The fairlead carries all that hangs, and what the anchor is pulled up by.
    hung = math.fsum(row.weight * row.length for row in pieces if not row.on_bed)
    loads = zip(solution.line.point_loads, solution.point_loads, strict=True)
    hung += math.fsum(load.submerged_weight - state.seabed_reaction for load, state in loads)
    carried = solution.fairlead.vertical_force - solution.anchor.vertical_force
    assert hung == pytest.approx(carried, rel=1e-9)


def test_the_table_of_pieces_has_their_numbers(name: str, pieces: tuple[TrailPiece, ...]) -> None:
    tables = page_named(name).all("pieces")
    assert bool(tables) == bool(pieces)
    for table in tables:
        shown = [[cell.value for cell in row[5:11]] for row in table.rows]
        assert shown == [[r.V1, r.V2, r.T1, r.T2, r.dx, r.dz] for r in pieces]
        assert [row[4].text == "∞" for row in table.rows] == [math.isinf(r.EA) for r in pieces]
