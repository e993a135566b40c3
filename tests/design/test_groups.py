"""Designs of lines between points by groups: the front against every mooring written out."""

from __future__ import annotations

import itertools
import json
import math
from dataclasses import replace
from pathlib import Path

import pytest

from catopt import InputError, read_case
from catopt.casefile.reading import parse_network, read_design
from catopt.casefile.writing import write_case
from catopt.checks.system import check_network
from catopt.design.search import design_case
from catopt.model.network import Network
from catopt.mooring.fixed_body import at_rest

RAFT = (Path(__file__).parents[2] / "cases/raft-four-lines/case.toml").read_text("utf-8")
ROPE = 'submerged_weight = "0.33 kgf/m"'
WEIGHED = RAFT.replace(ROPE, f'{ROPE}\nmass = "1.1 kg/m"')
SIZES, LENGTHS, ROPES = ("28 mm", "32 mm", "36 mm"), (50, 55, 60), (36, 40)
DESIGN = """
[design]
objectives = ["mass", "offset"]

[[design.groups]]
name = "chain"
lines = ["line 1", "line 2", "line 3", "line 4"]
component = "chain studless R3"
diameters = ["28 mm", "32 mm", "36 mm"]
length_min = "50 m"
length_max = "60 m"
length_step = "5 m"

[[design.groups]]
name = "ropes of lines 3 and 4"
lines = ["line 3", "line 4"]
segment = 2
lengths = ["36 m", "40 m"]
"""
TEXT = WEIGHED + DESIGN


def written_out(size: str, length: int, rope: int) -> str:
    """Write the file of one design: chains of all lines, ropes of the last two."""
    text = WEIGHED.replace('diameter = "32 mm"', f'diameter = "{size}"')
    text = text.replace('length = "55 m"', f'length = "{length} m"')
    head, third = text.split('[[lines]]\nname = "line 3"')
    return f'{head}[[lines]]\nname = "line 3"' + third.replace(
        'length = "36 m"', f'length = "{rope} m"'
    )


def test_the_front_is_that_of_every_mooring_written_out() -> None:
    """All 18 files, each read, brought to rest and checked by itself."""
    feasible = []
    for size, length, rope in itertools.product(SIZES, LENGTHS, ROPES):
        network = parse_network(written_out(size, length, rope))
        rest = at_rest(network)
        if check_network(network, rest).passes:
            mass = sum(each.line.mass or math.nan for each in network.lines)
            feasible.append((mass, math.hypot(*rest.bodies[0].offset)))
    best = sorted(
        one
        for one in feasible
        if not any(other != one and other[0] <= one[0] and other[1] <= one[1] for other in feasible)
    )
    result = design_case(parse_network(TEXT))
    assert (result.designs, result.is_exact, result.feasible) == (18, True, len(feasible))
    found = [(each.objectives["mass_kg"], each.objectives["offset_m"]) for each in result.front]
    assert 1 < len(best) < len(feasible) < 18
    assert found == [pytest.approx(each, rel=1e-9) for each in best]


def test_a_design_is_read_back_as_its_mooring(tmp_path: Path) -> None:
    network = parse_network(TEXT)
    result = design_case(network)
    (tmp_path / "design.json").write_text(json.dumps(result.to_dict()), "utf-8")
    (tmp_path / "case.toml").write_text(write_case(network), "utf-8")
    assert read_case(tmp_path / "case.toml") == network
    for number, point in enumerate(result.front, start=1):
        read = read_design(tmp_path, number)
        assert isinstance(read, Network)
        assert read.design is None
        due = [each.exceedance for each in point.checks.results]
        found = [each.exceedance for each in check_network(read).results]
        assert found == pytest.approx(due, rel=1e-9, abs=1e-12)
        assert [each.length for each in read.lines[3].line.segments] == [
            segment.length for segment in point.line.segments
        ]


@pytest.mark.parametrize(
    ("old", "new", "refusal"),
    [
        ('"line 4"]\nsegment', '"line 9"]\nsegment', r"groups\[1\].lines\[1\].*line 9"),
        ("segment = 2", "segment = 3", r"groups\[1\].segment.*2 segments"),
        ('lengths = ["36 m", "40 m"]', "", r"groups\[1\].lengths: missing"),
        ('lengths = ["36 m", "40 m"]', 'length = "36 m"\ndiameter = "40 mm"', "component"),
        ('"offset"]', '"excursion"]', "excursion"),
        ('"offset"]', '"cost"]', r"lines\[0\].segments\[1\].price"),
    ],
)
def test_what_does_not_fit_is_refused_by_its_key(old: str, new: str, refusal: str) -> None:
    assert TEXT.count(old) == 1
    with pytest.raises(InputError, match=refusal):
        design_case(parse_network(TEXT.replace(old, new)))


def test_without_a_body_nothing_is_offset() -> None:
    raft = parse_network(TEXT)
    points = tuple(replace(point, body="") for point in raft.points)
    held = replace(raft, points=points, bodies=())
    with pytest.raises(InputError, match="without a free body nothing is offset"):
        design_case(held)
    assert held.design is not None
    pulled = replace(held.design, objectives=("mass", "anchor_load"))
    result = design_case(replace(held, design=pulled))
    assert result.objectives == ("mass_kg", "anchor_load_N")
