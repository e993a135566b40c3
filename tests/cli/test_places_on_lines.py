"""Where what hangs on a line lies, with which force each end pulls, and how far a line sags.

The instrument moorings are those that people brought; figures of the first are of an integration
of the line's equations by shooting (scipy), those of the second by hand below.
"""

from __future__ import annotations

import csv
import json
import math
from pathlib import Path

import pytest

from catopt import Line, PointLoad, Segment, solve, solve_system
from catopt.model.system import System
from tests.decks.test_brought import BROUGHT

from .conftest import CASES, Run, document_of, words

STACK = BROUGHT / "02_instrument_stack_in_current.toml"
DEPTHS = BROUGHT / "03_instrument_depths.toml"
AT_ANCHOR, AT_FLOAT = 241.4, 4.5  # N, horizontal


def test_both_ends_and_every_instrument_are_in_the_document(run: Run) -> None:
    (state,) = document_of(run, "system", STACK)["states"]
    (line,) = state["lines"]
    assert line["from_horizontal_force_N"] == pytest.approx(AT_ANCHOR, abs=0.05)
    assert line["to_horizontal_force_N"] == pytest.approx(AT_FLOAT, abs=0.05)
    assert line["horizontal_force_N"] == line["to_horizontal_force_N"]
    assert line["from_tension_N"] == pytest.approx(6343.35, abs=0.01)
    meter = next(each for each in line["point_loads"] if each["name"] == "RCM 5")
    assert meter["position_m"] == 832.0
    assert meter["place_m"] == pytest.approx([24.906, 0.0, 835.321], abs=1e-3)


def test_both_ends_and_every_instrument_are_on_every_face(run: Run, tmp_path: Path) -> None:
    shown = run("system", STACK).out
    assert "H, to" in shown
    for number in ("0.241", "1314.426"):
        assert number in shown
    for language, said in (("en", "Point loads on the lines"), ("vi", "Vật treo trên dây")):
        whole = run("system", STACK, "--full", "--lang", language).out
        for number in ("0.241", "835.321", "24.906", said):
            assert number in whole
    out = tmp_path / "out"
    assert run("system", STACK, "--out", out).status == 0
    rows = list(csv.reader((out / "hung.csv").read_text("utf-8").splitlines()))
    meter = next(dict(zip(rows[0], row, strict=True)) for row in rows if "RCM 5" in row)
    assert float(meter["Height z (m)"]) == pytest.approx(835.321, abs=1e-3)
    (forces,) = csv.DictReader((out / "lines.csv").read_text("utf-8").splitlines())
    assert float(forces["Horizontal force, from (kN)"]) == pytest.approx(0.2414, abs=1e-4)
    assert float(forces["Horizontal force, to (kN)"]) == pytest.approx(0.0045, abs=1e-4)
    note = tmp_path / "note.html"
    assert run("report", STACK, "--out", note).status == 0
    assert "835.321" in note.read_text("utf-8")


def test_instruments_hang_where_the_stretch_of_a_rope_puts_them(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A plumb line: dz = (1 + T/EA) ds, T from the float's lift down."""
    g = 9.80665
    lift, chain, nylon, release, meter = 200.0 * g, 3.0 * g, 0.02 * g, 30.0 * g, 5.0 * g
    above = lift - 135.0 * nylon  # just above the CTD, at 250 m of 385
    below = above - meter
    foot = below - 245.0 * nylon - release  # at the top of the chain
    rope = 245.0 * (1.0 + (below - 0.5 * 245.0 * nylon) / 60e3)
    bottom = 5.0 * (1.0 + (foot - 0.5 * 5.0 * chain) / 20e6)
    (state,) = document_of(run, "system", DEPTHS)["states"]
    found = {each["name"]: each["place_m"] for each in state["lines"][0]["point_loads"]}
    assert found["release"] == pytest.approx([0.0, 0.0, bottom], abs=1e-6)
    assert found["CTD"] == pytest.approx([0.0, 0.0, bottom + rope], abs=1e-6)
    assert found["CTD"][2] == pytest.approx(257.603, abs=1e-3)
    monkeypatch.setattr("tests.cli.conftest.FULL", "0")
    assert "CTD: z 257.603, x 0.000, y 0.000 m" in words(run("system", DEPTHS).out)


def test_loads_of_a_body_s_lines_lie_in_its_plane() -> None:
    """Two equal lines at right angles: what is 30 m along one is so along the other."""
    line = Line([Segment(100.0, 300.0)], [PointLoad(30.0, 2000.0, name="clump")])
    around = [0.0, math.pi / 2.0, math.pi, -math.pi / 2.0]
    body = solve_system(
        System.around(line, azimuths=around, anchor_radius=95.0, fairlead_height=20.0)
    )
    places = [each["point_loads"][0]["place_m"] for each in body.to_dict()["lines"]]
    (x, y, z), across = places[0], places[1]
    assert 95.0 > x >= 65.0 - 1e-9  # at most 30 m of its line away from its anchor
    assert y == pytest.approx(0.0, abs=1e-9)
    assert across == pytest.approx([0.0, x, z], abs=1e-9)


def test_friction_makes_two_forces_and_both_are_named(run: Run, tmp_path: Path) -> None:
    place = tmp_path / "rough.toml"
    place.write_text(
        "[site]\nwater_depth = 20\nseabed_friction = 0.5\n[line]\n[[line.segments]]\nlength = 100\n"
        "submerged_weight = 500\n[load]\nhorizontal_force = 20000\n",
        encoding="utf-8",
    )
    shown = run("solve", place).out
    assert "Fairlead horizontal force" in shown
    assert "Anchor horizontal force" in shown
    document = document_of(run, "solve", place)
    lying = document["grounded_length_m"]
    assert document["anchor"]["horizontal_force_N"] == pytest.approx(20e3 - 250.0 * lying)


def test_sag_of_a_level_cable_is_that_of_its_catenary() -> None:
    """L = 2 a sinh(S/2a); sag = a (cosh(S/2a) - 1)."""
    a, span = 40.0, 60.0
    length = 2.0 * a * math.sinh(0.5 * span / a)
    cable = solve(Line([Segment(length, 10.0)]), height=50.0, anchor_height=50.0, span=span)
    sag = a * (math.cosh(0.5 * span / a) - 1.0)
    assert cable.sag == pytest.approx(sag, rel=1e-9)
    assert cable.lowest_point.to_dict() == pytest.approx(
        {"s_m": 0.5 * length, "x_m": 0.5 * span, "z_m": 50.0 - sag}, rel=1e-9
    )


@pytest.mark.parametrize(("height", "load"), [(50.0, 0.0), (33.0, 800.0), (51.0, -500.0)])
def test_sag_is_the_deepest_of_many_places_below_the_chord(height: float, load: float) -> None:
    loads = [PointLoad(31.0, load)] if load else []
    line = Line([Segment(40.0, 90.0, EA=2e6), Segment(35.0, 40.0)], loads)
    cable = solve(line, height=height, anchor_height=30.0, span=60.0)
    shape = cable.profile(20001)
    top = cable.fairlead_height
    chord = [30.0 + (top - 30.0) * x / cable.span for x in shape.x]
    deepest = max(straight - z for straight, z in zip(chord, shape.z, strict=True))
    assert cable.sag == pytest.approx(deepest, abs=1e-6)
    assert cable.lowest_point.z == pytest.approx(min(shape.z), abs=1e-6)
    assert json.dumps(cable.to_dict()["lowest_point"])


@pytest.mark.parametrize(
    ("name", "what"),
    [("raft-four-lines", "line 3"), ("ship-at-quay", "chock 1"), ("instrument-mooring", "meter")],
)
def test_networks_are_shipped_whose_first_screen_says_all(
    run: Run, monkeypatch: pytest.MonkeyPatch, name: str, what: str
) -> None:
    monkeypatch.setattr("tests.cli.conftest.FULL", "0")
    done = run("system", CASES / name / "case.toml")
    assert done.status == 0, done.err
    assert what in done.out
    assert "checks pass" in done.out
    assert len(done.out.splitlines()) <= 24
    balance = document_of(run, "system", CASES / name / "case.toml")["states"][0]
    assert balance["residual_N"] < 1e-3
