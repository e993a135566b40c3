"""Decks that people brought: of RAFT and windIO, in several files, of farms, with odd ropes.

Forces are MoorPy 1.3's, to the digits printed; a deck's ends are rounded, which moves the last one.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import catopt
from catopt.decks.reading import Asked, read_any_deck
from catopt.errors import InputError
from catopt.model.network import Network
from tests.cli.conftest import Run, run, words
from tests.decks.own import BRIDLE, MOORDYN

__all__ = ("run",)

INCLUDED = ("01_env.yml", "02_types.yml", "03_buoys.yml", "04_lines.yml")
BROUGHT = Path(__file__).parent / "brought"


def read(name: str, asked: Asked | None = None) -> tuple[Any, str]:
    """Read one of the decks, with what is remarked on it."""
    place = BROUGHT / name
    case, remarks = read_any_deck(place.read_text("utf-8"), str(place), asked)
    return case, "\n".join(map(str, remarks))


def test_the_mooring_of_a_raft_design() -> None:
    case, said = read("07_raft_design.yaml")
    (first, *_) = catopt.solve_system(case.system).lines
    assert first.horizontal_force == pytest.approx(686.540e3, rel=2e-6)
    assert first.tension == pytest.approx(879.105e3, rel=2e-6)
    assert "9.81 m/s^2 is used, as RAFT does" in said
    assert case.line.segments[0].MBL == 8e6


WINDIO = """
name: spar, own numbers
components:
  floating_platform:
    joints:
      - name: keel
        location: [0.0, 0.0, -110.0]
      - name: top
        location: [0.0, 0.0, 10.0]
      - name: arm1
        location: [6.0, 0.0, -60.0]
        cylindrical: true
      - name: arm2
        location: [6.0, 120.0, -60.0]
        cylindrical: true
    members:
      - name: centre
        joint1: keel
        joint2: top
        axial_joints:
          - name: unused
            grid: 0.5
  mooring:
    nodes:
      - {name: a1, node_type: fixed, location: [800.0, 0.0, -300.0], anchor_type: drag}
      - {name: a2, node_type: fixed, location: [-400.0, 692.8203, -300.0], anchor_type: drag}
      - {name: a3, node_type: fixed, location: [-400.0, -692.8203, -300.0], anchor_type: drag}
      - {name: f1, node_type: vessel, joint: arm1}
      - {name: f2, node_type: vessel, joint: arm2}
      - {name: f3, node_type: vessel, location: [-3.0, -5.196152, -60.0]}
    lines:
      - {name: l1, line_type: main, unstretched_length: 850.0, node1: a1, node2: f1}
      - {name: l2, line_type: main, unstretched_length: 850.0, node1: a2, node2: f2}
      - {name: l3, line_type: main, unstretched_length: 850.0, node1: a3, node2: f3}
    line_types:
      - {name: main, type: custom, diameter: 0.1, mass_density: 90.0, stiffness: 400.0e6}
environment:
  gravity: 9.81
  water_density: 1025.0
  water_depth: 300.0
"""


def test_the_mooring_of_windio_is_that_of_the_raft_design() -> None:
    case, _ = read_any_deck(WINDIO, "turbine.yaml")
    assert not isinstance(case, Network)
    assert case.system is not None
    (first, *_) = catopt.solve_system(case.system).lines
    assert first.horizontal_force == pytest.approx(686.540e3, rel=2e-6)
    wrong = WINDIO.replace("joint: arm1", "joint: arm9")
    wrong = wrong.replace("a1, node_type: fixed", "a1, node_type: pile")
    with pytest.raises(InputError) as caught:
        read_any_deck(wrong, "turbine.yaml")
    found = {each.found for each in caught.value.problems}
    assert {"arm9", "pile"} <= found


def test_an_orcaflex_model_in_several_files() -> None:
    case, said = read("07c_orcaflex_includes.yml")
    found = catopt.solve_case(case)
    assert found.horizontal_force == pytest.approx(93.187e3, abs=0.5)
    assert found.fairlead.tension == pytest.approx(147.999e3, abs=0.5)
    assert "inc/01_env.yml" in said
    assert "line 8: the end is 0.0225 m lower" in said  # the line that names inc/04_lines.yml


def test_a_file_may_stand_for_one_line_of_a_list(tmp_path: Path) -> None:
    """Also with Windows' strokes, and in a file that is itself taken in; a circle has an end."""
    parts = {k: (BROUGHT / "inc" / name).read_text("utf-8") for k, name in enumerate(INCLUDED)}
    one_line = "\n".join(row[2:] for row in parts[3].splitlines()[1:])
    (tmp_path / "sub").mkdir()
    (tmp_path / "sub" / "line.yml").write_text(one_line, encoding="utf-8")
    whole = f"{parts[0]}\n{parts[1]}\n{parts[2]}\nLines:\n  - includefile: sub\\line.yml\n"
    (tmp_path / "whole.yml").write_text(whole, encoding="utf-8")
    text = "%YAML 1.1\n---\nincludefile: whole.yml\n"
    case, _ = read_any_deck(text, str(tmp_path / "model.yml"))
    assert not isinstance(case, Network)
    found = catopt.solve_case(case)
    assert found.horizontal_force == pytest.approx(93.187e3, abs=0.5)
    (tmp_path / "loop.yml").write_text("- includefile: loop.yml\n", encoding="utf-8")
    with pytest.raises(InputError, match="100 included files"):
        read_any_deck("- includefile: loop.yml\n", str(tmp_path / "model.yml"))


def test_a_file_that_is_not_there_is_named(tmp_path: Path) -> None:
    text = (BROUGHT / "07c_orcaflex_includes.yml").read_text("utf-8")
    with pytest.raises(InputError, match=r"line 7: found inc/03_buoys\.yml; there is no file"):
        read_any_deck(text, str(tmp_path / "model.yml"))


def test_a_buoy_that_was_saved_tilted_and_free() -> None:
    """Its eye 2.1 m below goes by 2.1 sin 4.07 deg = 0.149 m towards the anchor."""
    case, said = read("08_orcaflex_tilted_buoy.yml")
    found = catopt.solve_case(case)
    assert found.span == pytest.approx(420.0 - 0.14905, abs=5e-6)
    assert found.horizontal_force == pytest.approx(93.090e3, abs=0.5)
    assert found.fairlead.tension == pytest.approx(147.880e3, abs=0.5)
    assert "tilted by 4.07 deg about y" in said
    assert "is free in the deck and held here" in said
    assert [load.name for load in case.line.point_loads] == ["Mid-line buoy"]
    text = (BROUGHT / "08_orcaflex_tilted_buoy.yml").read_text("utf-8")
    with pytest.raises(InputError, match="rotated about"):
        read_any_deck(text.replace("  - 4.07\n  - 0\n", "  - 4.07\n  - 30\n"), "b.yml")


def test_a_syrope_rope_is_refused_for_what_it_is() -> None:
    with pytest.raises(InputError) as caught:
        read("10_syrope.txt")
    (problem,) = caught.value.problems
    assert "Syrope rope is not read" in problem.allowed
    assert "next to the deck" not in problem.allowed


def test_a_farm_by_the_places_of_its_turbines(run: Run, tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"Turbine1; .* --turbine"):
        read("16_farm_turbines.dat")
    asked = Asked(gravity=9.81, density=1025.0, turbines=((0.0, 0.0), (1500.0, 0.0)))
    case, said = read("16_farm_turbines.dat", asked)
    rest = catopt.solve_system(case)
    pulls = [each.horizontal_force for each in rest.lines]
    assert min(pulls) == pytest.approx(1721.85e3, rel=1e-3)  # MoorPy's g is 9.81, too
    assert max(pulls) == pytest.approx(2298.78e3, rel=1e-3)
    assert "turbine 2 is held at x = 1500 m" in said
    deck, place = BROUGHT / "16_farm_turbines.dat", tmp_path / "case.toml"
    typed = ("--turbine", "0,0", "--turbine", "1500 m, 0 m", "--out", place)
    assert run("import", deck, *typed).status == 0
    found = words(run("system", place).out)
    assert "2298.779" in found
    assert "1721.850" in found
    assert run("import", deck, "--turbine", "far away").status == 2
    with pytest.raises(InputError, match=r"--turbine \(1\); lines of this deck go to 0"):
        read("17_buoyant_line_with_free_end.txt", Asked(turbines=((0.0, 0.0),)))


def test_a_buoyant_line_with_a_free_end_floats() -> None:
    """Its lift: (pi/4 0.8^2 x 1025 - 130) 9.81 x 0.6 m = 2267.4 N, on the point from which."""
    case, said = read("17_buoyant_line_with_free_end.txt")
    (buoyed,) = [point for point in case.points if point.name == "1"]
    assert buoyed.submerged_weight == pytest.approx(-2267.4, abs=0.05)
    assert "floats from point 1 with a free end" in said
    assert {point.name for point in case.points}.isdisjoint({"2"})
    assert len(case.lines) == 7


def test_an_anchor_high_above_the_bed_is_remarked_on() -> None:
    text = (BROUGHT / "10_syrope.txt").read_text("utf-8").replace("-100.0", "-20.0", 1)
    rope = text.replace("SYROPE:syrope.dat|1.5e8|23.0", "1.5e8")
    _, remarks = read_any_deck(rope, "high.txt")
    assert any("point 1 is fixed 80 m above the bed" in str(each) for each in remarks)


def test_other_yaml_is_told_what_it_is(run: Run, tmp_path: Path) -> None:
    place = tmp_path / "other.yaml"
    place.write_text("hull: 3\nsails:\n  - main\n", encoding="utf-8")
    for command in ("solve", "system", "import"):
        ran = run(command, place)
        assert ran.status == 2
        assert "YAML with hull, sails" in ran.err
        assert "RAFT" in words(ran.err)


def test_ropes_and_words_of_the_catalogue() -> None:
    from catopt.catalogue.finding import find

    (rope,) = find("HMPE 16 mm").components
    assert rope.mass == pytest.approx(496.0 * 0.016**2, rel=1e-12)  # MoorPy's 496 d^2
    with pytest.raises(InputError) as caught:
        find("aqua4 100 mm")
    assert "did you mean" not in f"{caught.value}"


@pytest.mark.parametrize(
    ("text", "si"),
    [("300 daN", 3000.0), ("300 kp", 2941.995), ("2 kp", 19.6133)],
)
def test_forces_of_the_field(text: str, si: float) -> None:
    from catopt.units import Dimension, to_si

    assert to_si(text, Dimension.FORCE) == pytest.approx(si, rel=1e-12)


@pytest.mark.parametrize(("text", "si"), [("3 shackles", 82.296), ("15 fathoms", 27.432)])
def test_lengths_of_the_field(text: str, si: float) -> None:
    """A shackle is 15 fathoms, 90 ft; a shot of chain stays 27.5 m."""
    from catopt.units import Dimension, to_si

    assert to_si(text, Dimension.LENGTH) == pytest.approx(si, rel=1e-12)
    assert to_si("1 shot", Dimension.LENGTH) == 27.5


RODS = """--- ROD TYPES ---
TypeName Diam Mass/m Cd Ca CdEnd CaEnd
(name) (m) (kg/m) (-) (-) (-) (-)
end 0.1 10 1 1 1 1
--- RODS ---
ID RodType Attachment Xa Ya Za Xb Yb Zb NumSegs RodOutputs
(#) (name) (#/key) (m) (m) (m) (m) (m) (m) (-) (-)
1 end Coupled 5.2 0 -70 5.2 0 -70 0 -
2 end VesPin -2.6 4.503332 -70 -2.6 4.503332 -69 0 -
3 end Vessel -2.6 -4.503332 -70 -2.6 -4.503332 -70 0 -
4 end Pinned -426.935 -739.473112 -320 -426.935 -739.473112 -320 0 -
--- POINTS ---"""


def test_rods_of_no_length_are_points() -> None:
    """OC3's lines end at clamps of no length, which MoorDyn writes as rods of 0 segments."""
    points = [line for line in MOORDYN.splitlines(keepends=True) if "Coupled" in line]
    held = next(line for line in MOORDYN.splitlines(keepends=True) if line.startswith("3 Fixed"))
    text = MOORDYN.replace("--- POINTS ---", RODS).replace("main 1 4", "main 1 R1A")
    text = text.replace("main 5 2", "main r2B 2").replace("main 3 6", "main R4A R3B")
    for line in (*points, held):
        text = text.replace(line, "")
    found, remarks = read_any_deck(text, "rods.txt")
    expected, _ = read_any_deck(MOORDYN, "rods.txt")
    assert found == expected
    assert any("rod 1 has no length: it is read as a point" in str(each) for each in remarks)
    long = text.replace("5.2 0 -70 5.2 0 -70 0 -", "5.2 0 -70 5.2 0 -60 4 -")
    with pytest.raises(InputError, match="no rods with a length"):
        read_any_deck(long, "rods.txt")


def test_lines_meet_in_a_free_rod_of_no_length() -> None:
    """The bridle's joint as a rod: the same network."""
    text = BRIDLE
    (joint,) = [line for line in text.splitlines() if line.split()[1:2] == ["Free"]][:1]
    number, _, x, y, z, *_ = joint.split()
    row = f"7 end Free {x} {y} {z} {x} {y} {z} 0 -"
    own = "\n".join(RODS.splitlines()[:7])
    text = text.replace(joint + "\n", "").replace("--- POINTS ---", f"{own}\n{row}\n--- POINTS ---")
    head, lines = text.split("--- LINES ---")
    rows = [
        " ".join("R7A" if k in (2, 3) and word == number else word for k, word in enumerate(each))
        for each in map(str.split, lines.splitlines())
    ]
    found, _ = read_any_deck(head + "--- LINES ---" + "\n".join(rows), "bridle.txt")
    bare = BRIDLE.replace(joint, f"{number} Free {x} {y} {z} 0 0 0 0")  # a rod weighs nothing
    expected, _ = read_any_deck(bare, "bridle.txt")
    assert isinstance(found, Network)
    assert isinstance(expected, Network)
    ours, theirs = catopt.solve_system(found), catopt.solve_system(expected)
    assert [each.fairlead.tension for each in ours.lines] == pytest.approx(
        [each.fairlead.tension for each in theirs.lines], rel=1e-9
    )
