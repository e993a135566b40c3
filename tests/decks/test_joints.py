"""Decks whose lines meet in free points: read, written, read again, and what MAP++ prints."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

import catopt
from catopt import InputError
from catopt.casefile import read_mooring, write_case
from catopt.casefile.reading import read_case_or_design
from catopt.decks.reading import Asked, read_any_deck, read_deck
from catopt.model.network import Network
from catopt.mooring.fixed_body import hold
from tests.decks.own import BRIDLE, MAP_BRIDLE, MOORDYN

SITE = Asked(9.81, 1025.0, 350.0)


def of_map() -> tuple[Network, tuple[str, ...]]:
    found, remarks = read_any_deck(MAP_BRIDLE, "bridle.map", SITE)
    assert isinstance(found, Network)
    return found, remarks


def test_the_bridle_of_mappp() -> None:
    """MAP++'s documentation, python_example.rst: to the printed digits."""
    network, remarks = of_map()
    assert [point.kind for point in network.points[:4]] == [
        "anchor", "joint", "fairlead", "fairlead",
    ]  # fmt: skip
    rest = hold(network)
    assert rest.lines[0].span == pytest.approx(338.18, abs=5e-3)
    assert rest.lines[1].fairlead.tension == pytest.approx(711942.60, abs=5e-3)
    ahead = hold(network, (5.0, 0.0, 0.0, 0.0, 0.0, 0.0)).lines[0].fairlead
    assert ahead.horizontal_force == pytest.approx(597513.33, abs=5e-3)
    assert ahead.vertical_force == pytest.approx(1143438.75, abs=5e-3)
    said = "\n".join(remarks)
    assert "mass, drag and added mass of lines and points are not kept" in said
    assert "w = 2645.614 N/m" in said
    # Clockwise: the second anchor lies at -120 deg.
    second = next(point for point in network.points if point.name == "1@120")
    assert second.place[:2] == pytest.approx((-200.0, -200.0 * math.sqrt(3.0)), abs=1e-9)


def test_a_free_point_of_two_lines_is_a_joint_too() -> None:
    """W = (20000 - 2.5 x 1025) x 9.81 = 171061.875 N of the joints with mass."""
    found, _ = read_any_deck(BRIDLE, "bridle.txt")
    assert isinstance(found, Network)
    joints = {p.name: p.submerged_weight for p in found.points if p.kind == "joint"}
    assert joints == pytest.approx({"2": 171061.875, "6": 0.0, "7": 171061.875}, rel=1e-12)
    assert len(found.lines) == 7


def test_a_force_turns_with_the_node_it_pulls() -> None:
    pulled = MAP_BRIDLE.replace("#-80 0 0 0 0 0", "#-80 0 0 3000 400 -50").replace(
        "repeat 120 240", "repeat 90"
    )
    found, _ = read_any_deck(pulled, "bridle.map", SITE)
    assert isinstance(found, Network)
    forces = {point.name: point.force for point in found.points if point.kind == "joint"}
    assert forces["2"] == (3000.0, 400.0, -50.0)
    assert forces["2@90"] == pytest.approx((400.0, -3000.0, -50.0), abs=1e-9)  # clockwise
    unread = MAP_BRIDLE.replace("#-80 0 0 0 0 0", "#-80 0 0 #300 # x")
    with pytest.raises(InputError, match="FZ x"):
        read_any_deck(unread, "bridle.map", SITE)


def test_a_float_of_a_deck_ends_its_line() -> None:
    """400 kg and 40 m3 lift (40 x 1025 - 400) x 9.81 N: the tension there."""
    deck = MOORDYN.replace("4 Coupled 5.2 0 -70 0 0", "4 Free 840 0 -70 400 40").replace(
        "902.2 20 -", "100 20 -", 1
    )
    found, _ = read_any_deck(deck.replace("9.80665 g", "9.81 g"), "float.txt")
    assert isinstance(found, Network)
    first = hold(found).lines[0].fairlead
    assert first.tension == pytest.approx((40.0 * 1025.0 - 400.0) * 9.81, rel=1e-9)
    with pytest.raises(InputError, match="point 4 of 1 line; lines of a free point"):
        read_any_deck(deck, asked=Asked(line=2))


def test_the_force_of_a_moordyn_point_is_refused_with_a_way_out() -> None:
    deck = (
        MOORDYN.replace("Volume CdA Ca", "Volume FX FY FZ CdA Ca")
        .replace(" 0 0 0 0\n", " 0 0 0 0 0 0 0\n")
        .replace("4 Coupled 5.2 0 -70 0 0 0 0 0", "4 Free 5.2 0 -70 0 0 5 0 0")
    )
    with pytest.raises(InputError, match="force of the joint in the case file"):
        read_any_deck(deck)


@pytest.mark.parametrize("text", [MAP_BRIDLE, BRIDLE], ids=["map", "moordyn"])
def test_what_is_written_reads_back(text: str, tmp_path: Path) -> None:
    found, _ = read_any_deck(text, "deck.txt", SITE if text is MAP_BRIDLE else None)
    place = tmp_path / "case.toml"
    place.write_text(write_case(found), encoding="utf-8")
    assert read_mooring(place) == found


def test_read_in_python_it_is_what_the_commands_read(tmp_path: Path) -> None:
    """Where a program takes a case of one line or body alone, it says which take these."""
    found = read_deck(BRIDLE).case
    assert isinstance(found, catopt.Network)
    place = tmp_path / "bridle.txt"
    place.write_text(BRIDLE)
    read = catopt.read_case(place)
    assert (read.points, read.lines, read.title) == (found.points, found.lines, "bridle")
    rest = catopt.solve_system(found)
    assert rest.residual < 1e-6 * max(line.fairlead.tension for line in rest.lines)
    for refusing in (catopt.solve_case, catopt.curve_case):
        with pytest.raises(InputError, match="catopt solve, system, check, curve, design, verify"):
            refusing(found)
    with pytest.raises(InputError, match="leave out --line"):
        read_any_deck(BRIDLE, asked=Asked(line=1))
    with pytest.raises(InputError, match="import FILE --line N"):
        read_case_or_design(place, None)


UNEQUAL = (Path(__file__).parent / "brought" / "model_scale_body.txt").read_text("utf-8")


def test_a_deck_of_unequal_lines_at_model_scale(tmp_path: Path) -> None:
    """MoorPy's H with water of 998 kg/m3: 3.914 N of the first line, 3.973 N of the others."""
    place = tmp_path / "body.txt"
    place.write_text(UNEQUAL, encoding="utf-8")
    rest = catopt.solve_system(catopt.read_case(place))
    pulls = [line.horizontal_force for line in rest.lines]
    assert pulls == pytest.approx([3.914, 3.973, 3.973], abs=5e-4)
    barge = catopt.MooredBody("body", force=(1.0, 0.0))
    assert barge.force == (1.0, 0.0)


def test_a_line_with_a_free_end_hangs_from_its_other() -> None:
    loose = BRIDLE.replace("7 nylon 9 7 90", "7 nylon 9 10 90").replace(
        "--- LINES", "10 Free 0 0 -20 0 0 0 0\n--- LINES"
    )
    network, _ = read_any_deck(loose.replace("5 nylon 6 7", "5 nylon 6 2"))
    assert isinstance(network, Network)
    assert {"9", "10"} == {network.lines[6].start, network.lines[6].end}


FILE = """
[site]
water_depth = "30 m"

[[points]]
name = "a"
kind = "anchor"
x = "40 m"
y = "0 m"
height = "0 m"

[[points]]
name = "j"
kind = "joint"
submerged_weight = "-2 kN"

[[points]]
name = "f"
kind = "fairlead"
x = "0 m"
y = "1 m"
height = "29 m"

[[points]]
name = "g"
kind = "fairlead"
x = "0 m"
y = "-1 m"
height = "29 m"

[[lines]]
start = "a"
end = "j"
[[lines.segments]]
length = "35 m"
submerged_weight = "90 N/m"
EA = "40 MN"

[[lines]]
start = "j"
end = "f"
[[lines.segments]]
length = "15 m"
submerged_weight = "30 N/m"
EA = "20 MN"

[[lines]]
start = "j"
end = "g"
[[lines.segments]]
length = "15 m"
submerged_weight = "30 N/m"
EA = "20 MN"
"""


def faults(text: str, tmp_path: Path) -> list[str]:
    place = tmp_path / "case.toml"
    place.write_text(text)
    with pytest.raises(InputError) as caught:
        read_mooring(place)
    return [f"{problem.key}: {problem.allowed}" for problem in caught.value.problems]


def test_a_file_is_read_and_every_fault_told(tmp_path: Path) -> None:
    place = tmp_path / "case.toml"
    place.write_text(FILE)
    network = read_mooring(place)
    assert isinstance(network, Network)
    assert network.points[1].submerged_weight == -2000.0
    assert network.lines[1].start == "j"
    place.write_text(FILE.replace('height = "0 m"', ""))  # an anchor lies on the bed
    assert read_mooring(place) == network
    wrong = FILE.replace('kind = "joint"', 'kind = "joint"\nx = "5 m"').replace('y = "0 m"', "", 1)
    assert faults(wrong, tmp_path) == [
        "points[0].y: missing; anchors have x, y and height",
        "points[1].x: leave it out: the position of a joint is an output",
    ]
    found = faults(
        FILE.replace('start = "j"', 'start = "k"', 1).replace('EA = "40 MN"', ""), tmp_path
    )
    assert found == [
        "lines[1].start: no such point; there are a, j, f, g",
        "lines[0].segments[0].EA: missing; lines to joints must be elastic",
    ]
    assert faults(FILE.replace('submerged_weight = "90', 'sumberged_weight = "90'), tmp_path) == [
        "lines[0].segments[0].sumberged_weight: did you mean submerged_weight?"
    ]
    assert faults(FILE + '\n[load]\nspan = "3 m"\n', tmp_path)[0].startswith("load: ")
