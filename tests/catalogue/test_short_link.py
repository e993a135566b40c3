"""Short-link chain of yachts and thin nylon rope against what was printed of them."""

from __future__ import annotations

import math

import pytest

from catopt import InputError, catalogue, solve_case
from catopt.casefile import parse_case

DEALER = """
6 0.80 10.0
7 1.15 16.0
8 1.40 20.0
10 2.25 32.0
12 3.25 35.0
13 3.90 50.0
"""
"""chains.ie: mm, kg/m, proof force in kN; breaking force of grade 30: 18, 25, 32, 50, 71, 80 kN."""

BREAKS: dict[str, dict[int, float]] = {
    "30": {6: 18, 7: 25, 8: 32, 10: 50, 12: 71, 13: 80},
    "40": {7: 30, 8: 40, 10: 63},
}
COX: dict[str, dict[int, float]] = {
    "30": {6: 16, 7: 24.4, 8: 30, 10: 50, 12: 70},
    "40": {7: 31, 8: 40, 10: 62, 12: 90},
}
"""Breaking force of both tables, kN."""

ROPE = """
7.94 0.036 10.2
9.53 0.053 14.4
12.70 0.094 25.2
15.88 0.147 39.6
"""
"""The Engineering ToolBox, nylon of 5/16, 3/8, 1/2 and 5/8 in: mm, kg/m, kN."""


def rows(text: str) -> list[list[float]]:
    return [[float(each) for each in line.split()] for line in text.split("\n") if line]


@pytest.mark.parametrize("grade", ["30", "40"])
def test_every_printed_row(grade: str) -> None:
    for d, mass, proof in rows(DEALER):
        if grade == "40" and d == 6.0:
            continue  # two tables of its MBL contradict
        chain = catalogue.component(f"chain short-link {grade}", d / 1e3)
        assert chain.mass == pytest.approx(mass)
        assert chain.proof_load == pytest.approx(proof * 1e3)


@pytest.mark.parametrize("grade", ["30", "40"])
def test_the_breaking_load_is_the_lower_of_two_tables(grade: str) -> None:
    """And no more than 4 % above the stress of the grade on both legs, between rows, too."""
    for d in sorted(BREAKS[grade].keys() | COX[grade].keys()):
        printed = [table[grade][d] for table in (BREAKS, COX) if d in table[grade]]
        MBL = catalogue.component(f"chain short-link {grade}", d / 1e3).MBL
        assert MBL is not None
        assert MBL <= 1e3 * min(printed) * (1.0 + 1e-12)
        assert MBL >= 0.9 * 1e3 * min(printed)
        assert MBL <= 1.04 * float(grade) * 10.0 * math.pi / 2.0 * d**2


def test_thin_nylon_is_near_what_is_printed() -> None:
    for d, mass, MBL in rows(ROPE):
        own = catalogue.component("nylon", max(d, 8.0) / 1e3)
        printed = catalogue.component("nylon", max(d, 8.0) / 1e3, variants={"all": "toolbox"})
        assert own.MBL == pytest.approx(1e3 * MBL, rel=0.07)
        assert own.mass == pytest.approx(mass, rel=0.16)
        assert printed.MBL == pytest.approx(1e3 * MBL, rel=0.02)


def yacht(chain: str, d: str = "8 mm") -> str:
    return f"""
    site.water_depth = "8 m"
    load.horizontal_force = "2 kN"
    [line]
    fairlead_height = "9.2 m"
    [[line.segments]]
    component = "{chain}"
    diameter = "{d}"
    length = "30 m"
    [[line.segments]]
    component = "nylon"
    diameter = "14 mm"
    length = "25 m"
    """


def test_a_yacht_lies_to_8_mm_chain_and_14_mm_nylon() -> None:
    """V at the fairlead is what hangs: nothing lies on the bed, but for the chain's lowest part."""
    case = parse_case(yacht("chain short-link 30"))
    rest = solve_case(case)
    hangs = sum(each.submerged_weight * each.length for each in case.line.segments)
    up, foot = rest.fairlead.vertical_force, rest.anchor.vertical_force
    assert up - foot == pytest.approx(hangs, rel=1e-9)
    # 1.40 kg/m of steel, 7850 kg/m3, in sea water.
    w = 1.40 * 9.80665 * (1.0 - 1025.0 / 7850.0)
    assert case.line.segments[0].submerged_weight == pytest.approx(w, rel=1e-9)


def test_a_size_that_is_not_known_is_refused_with_a_way_out() -> None:
    with pytest.raises(InputError) as caught:
        parse_case(yacht("chain open-link 3D Q1"))
    (problem,) = caught.value.problems
    assert "of this size there are chain short-link" in problem.allowed
    assert "or leave component out and give figures of your own" in problem.allowed
    with pytest.raises(InputError, match="from 14 mm to 60 mm; or leave component out"):
        parse_case(yacht("chain open-link 3D Q1", "2 mm"))
