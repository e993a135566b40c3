"""Files for MAP++, MoorPy, OrcaFlex and the ontology: by hand, what is said, and read back."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest
import yaml

from catopt import Case, InputError, Line, Load, PointLoad, Segment, Site, read_case, solve_case
from catopt.decks.deck import Deck, Notes
from catopt.decks.mappp import parse_mappp
from catopt.decks.reading import read_deck
from catopt.export.export_result import Source, exported_lines
from catopt.export.moordyn import moordyn_input
from catopt.export.moordyn_model import model_of
from catopt.export.programs import PROGRAMS, ProgramFormat, deck_of, program_input
from catopt.mooring.case import report_system
from catopt.words import say

from .cases import CASES, FSO, chain_and_wire, suspended, tanker, tanker_with_sinker

G = 9.80665
ALL = [
    (suspended(), None),
    (tanker(), None),
    (chain_and_wire(0.4), None),
    (tanker_with_sinker(), 5e8),
    (read_case(CASES / "ship-200m" / "case.toml"), 5e8),
    (read_case(FSO), None),
]
NAMES = ["suspended", "tanker", "clump", "sinker", "ship", "FSO"]


def bare(deck: Deck) -> Deck:
    """Return a deck without what a MAP++ file does not hold: rows, drag, breaking loads."""
    types = {
        name: replace(kind, row=0, drag=None, MBL=None, nominal_diameter=None)
        for name, kind in deck.types.items()
    }
    points = {
        name: replace(point, row=0, drag_area=0.0, added_mass=0.0)
        for name, point in deck.points.items()
    }
    pieces = [replace(piece, row=0) for piece in deck.pieces]
    return replace(deck, types=types, points=points, pieces=pieces, friction=None)


@pytest.mark.parametrize(("case", "EA"), ALL, ids=NAMES)
def test_a_map_file_reads_back_as_the_same_deck(case: Case, EA: float | None) -> None:
    """To the last bit: numbers are written so that they read back as the same doubles."""
    solved = exported_lines(case, EA)
    written = deck_of(model_of(solved, true_depth=True))
    notes = Notes()
    given = {"gravity": G, "density": written.density, "depth": written.depth}
    back = parse_mappp(program_input("map", solved).text, notes, given)
    assert not notes.problems
    assert bare(back) == bare(written)


def exportable() -> list[tuple[Case, float | None]]:
    """Shipped cases, of whose segments those that do not stretch are given an EA."""
    names = ("dynamic-chain-56m", "fso-rang-dong", "ship-200m", "ship-200m-sinker", "tanker-20m",
             "tanker-20m-sinker", "buoy-9.5m")  # fmt: skip
    shipped = [read_case(CASES / name / "case.toml") for name in names]
    cases = [*shipped, suspended(), tanker(), chain_and_wire(), chain_and_wire(0.4)]
    return [(c, 5e8 if any(math.isinf(s.EA) for s in c.line.segments) else None) for c in cases]


@pytest.mark.parametrize(
    ("to", "case", "EA"),
    [("moordyn", *each) for each in exportable()]
    + [(to, *each) for to in ("ontology", "orcaflex") for each in ALL],
)
def test_what_is_written_reads_back(to: str, case: Case, EA: float | None) -> None:
    """In YAML numbers read back as the same doubles, places go over span and heading, or the bed.

    For MoorDyn ten digits are written. The lines agree to 1e-9, the forces they have between their
    ends to 1e-6: a nearly straight line makes 1e3 of the rounding of its ends.
    """
    solved = exported_lines(case, EA)
    length, weight, force = 1e-14, 1e-12, 1e-8
    if to == "moordyn":
        length, weight, force = 1e-9, 1e-8, 1e-6
        text = moordyn_input(solved).text
    else:
        text = program_input(to, solved).text  # type: ignore[arg-type]
        yaml.safe_load(text)
    back = read_deck(text, "back.yaml").case
    first = solved.lines[0].solution.line
    for ours, theirs in zip(first.segments, back.line.segments, strict=True):
        assert theirs.submerged_weight == pytest.approx(ours.submerged_weight, rel=weight)
        assert theirs.length == pytest.approx(ours.length, rel=length)
        assert theirs.EA == pytest.approx(ours.EA, rel=1e-9 if to == "moordyn" else 1e-15)
        assert to != "ontology" or theirs.MBL == ours.MBL
    for hung, again in zip(first.point_loads, back.line.point_loads, strict=True):
        assert again.position == pytest.approx(hung.position, rel=length)
        assert again.submerged_weight == pytest.approx(hung.submerged_weight, rel=weight)
    assert to == "moordyn" or back.site.seabed_friction == case.site.seabed_friction
    found = [leg.solution for leg in report_system(back).solution.lines] if back.system else None
    for one, line in zip(found or [solve_case(back)], solved.lines, strict=True):
        due = line.solution
        assert one.horizontal_force == pytest.approx(due.horizontal_force, rel=force)
        assert one.fairlead.tension == pytest.approx(due.fairlead.tension, rel=force)


def test_the_numbers_of_a_map_file() -> None:
    """6000 kg that weigh 50 kN displace (6000 - 50000/g)/1025 m3; d from (178.7 - 1470/g)/1025."""
    solved = exported_lines(chain_and_wire(0.4))
    lines = program_input("map", solved, sources=[Source("case.toml", 64 * "a")]).text.splitlines()
    heads = [number for number, line in enumerate(lines) if line.startswith("-")]
    assert heads == [0, 5, 11, 16]  # no line before the first; three heading lines each
    chain = lines[3].split()
    assert float(chain[1]) == pytest.approx(
        math.sqrt(4.0 / math.pi * (178.7 - 1470.0 / G) / 1025.0), rel=1e-14
    )
    assert [float(each) for each in chain[2:5]] == [178.7, 800e6, 0.4]
    anchor, clump, fairlead = (line.split() for line in lines[8:11])
    assert anchor[1:] == ["fix", "0.0", "0.0", "depth", "0.0", "0.0", "#", "#", "#"]
    (state,) = solved.lines[0].solution.point_loads
    assert clump[1] == "connect"
    assert [float(each.removeprefix("#")) for each in clump[2:5]] == pytest.approx(
        [state.x, 0.0, state.z - 56.0], rel=1e-14
    )
    assert float(clump[5]) == 6000.0
    assert float(clump[6]) == pytest.approx((6000.0 - 50e3 / G) / 1025.0, rel=1e-14)
    assert fairlead[1] == "vessel"
    assert [line.split()[:5] for line in lines[14:16]] == [
        ["1", "chain", "200.0", "1", "2"],
        ["2", "wire", "200.0", "2", "3"],
    ]
    assert all(line.startswith(" !") for line in lines[23:])
    assert f" ! From case.toml, SHA-256 {64 * 'a'}" in lines


def test_what_another_program_takes_otherwise_is_said() -> None:
    high = replace(tanker(), fairlead_height=25.0)
    rough = exported_lines(chain_and_wire(0.4))
    said = program_input("map", exported_lines(tanker())).remarks
    place = "give it 9.80665 m/s^2, 1025 kg/m^3 and 20 m"
    assert any(place in remark for remark in said)
    assert any(place.split()[2] in say(each, "vi") and "độ sâu" in say(each, "vi") for each in said)
    assert "the depth is set to 25 m" in " ".join(
        program_input("moorpy", exported_lines(high)).remarks
    )
    assert "raised" not in " ".join(program_input("map", exported_lines(high)).remarks)
    assert "MoorPy applies no friction to lines" in " ".join(program_input("moorpy", rough).remarks)
    slack = replace(tanker_with_sinker(), load=Load(horizontal_force=100e3))
    resting = program_input("map", exported_lines(slack, EA=1e9)).remarks
    assert any("nodes on the bed: 2" in remark for remark in resting)
    own = Line(tanker().line.segments, [PointLoad(20.0, 5e3, friction=0.7)])
    rubs = program_input("moorpy", exported_lines(replace(tanker(), line=own))).remarks
    assert any("friction 0.7 of a point load" in remark for remark in rubs)


@pytest.mark.parametrize("to", PROGRAMS)
def test_a_line_that_does_not_stretch_is_refused_for_its_program(to: ProgramFormat) -> None:
    case = Case(Site(20.0), Line([Segment(60.0, 2100.0)]), Load(horizontal_force=1e5), 20.0)
    with pytest.raises(InputError, match="every line is elastic") as caught:
        program_input(to, exported_lines(case))
    assert PROGRAMS[to].name in str(caught.value)
