"""The design space: which designs there are, and which line each of them is."""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest

from catopt import InputError
from catopt.catalogue import component
from catopt.design.evaluation import DesignProblem
from catopt.design.space import DesignSpace
from catopt.model import (
    CatalogueChoice,
    Checks,
    ClumpWeightChoice,
    Line,
    Load,
    Segment,
    SegmentChoice,
    Service,
    SinkerChoice,
)
from tests.design.small_cases import DESIGN, all_genes, small_case


def space_of(**changes: object) -> DesignSpace:
    return DesignProblem.of(small_case(**changes)).space


def test_sizes_and_count() -> None:
    """4 chains of 3 lengths; 2 wires of 2 lengths or none; 2 masses at 2 places or none."""
    space = space_of()
    assert space.sizes == (4, 3, 3, 2, 3, 2)
    assert space.count == 12 * 5 * 5


def test_canonical_designs_are_all_there_and_each_once() -> None:
    problem = DesignProblem.of(small_case())
    every = {tuple(row) for row in problem.canonical(np.array(all_genes(problem))).tolist()}
    listed = [tuple(row) for row in problem.space.genes_between(0, problem.space.count).tolist()]
    assert len(listed) == len(set(listed)) == problem.space.count
    assert set(listed) == every


def test_designs_may_be_listed_in_parts() -> None:
    space = space_of()
    parts = [space.genes_between(k, min(k + 7, space.count)) for k in range(0, space.count, 7)]
    assert np.array_equal(np.concatenate(parts), space.genes_between(0, space.count))


def test_canonical_genes_of_absent_parts_are_0_and_the_others_stay() -> None:
    space = space_of()
    given = np.array([[3, 2, 0, 1, 0, 1], [3, 2, 1, 1, 2, 1]])
    assert space.canonical(given).tolist() == [[3, 2, 0, 0, 0, 0], [3, 2, 1, 1, 2, 1]]
    assert given[0].tolist() == [3, 2, 0, 1, 0, 1]


def test_a_line_has_the_figures_of_the_catalogue() -> None:
    line = space_of().line((3, 1, 1, 0, 1, 1))
    chain, wire = line.segments
    sold = component("chain studless R4", 0.06)
    assert chain.component == "chain studless R4"
    assert chain.name == sold.name
    assert (chain.length, chain.nominal_diameter) == (220.0, 0.06)
    assert (chain.mass, chain.EA, chain.MBL) == (sold.mass, sold.EA, sold.MBL_in_water)
    assert (chain.proof_load, chain.price) == (sold.proof_load, sold.price)
    assert chain.submerged_weight == sold.submerged_weight
    assert (wire.component, wire.length) == ("wire spiral-strand", 50.0)
    (weight,) = line.point_loads
    # 5 t of steel in sea water: 5000 * 9.80665 * (1 - 1025/7850) = 42 630.8 N
    assert (weight.position, weight.mass) == (90.0, 5000.0)
    assert weight.submerged_weight == pytest.approx(42630.8, abs=0.05)


def test_nylon_is_as_strong_as_it_is_in_water() -> None:
    rope = SegmentChoice((110.0,), ("nylon",), diameters=(0.08,))
    case = replace(small_case(segments=(rope,)), catalogue=CatalogueChoice(allow_recalled=True))
    (segment,) = DesignProblem.of(case).space.line((0, 0, 0, 0)).segments
    sold = component("nylon", 0.08, allow_recalled=True)
    assert segment.MBL == sold.MBL_in_water
    assert sold.MBL is not None
    assert segment.MBL is not None
    assert segment.MBL < sold.MBL


def test_sizes_that_are_sold_rise_within_their_bounds() -> None:
    choice = SegmentChoice((100.0,), ("chain studless R4",), diameter_min=0.07, diameter_max=0.1)
    space = space_of(segments=(choice,))
    sizes = [option.nominal_diameter or 0.0 for option in space.segments[0].options]
    assert sizes == sorted(sizes)
    assert sizes[0] == 0.07
    assert sizes[-1] <= 0.1
    assert len(sizes) > 5


def test_a_segment_without_component_is_that_of_the_line() -> None:
    space = space_of(segments=(SegmentChoice((250.0, 300.0)),))
    (segment,) = space.line((0, 0, 0, 0)).segments
    assert (segment.length, segment.submerged_weight, segment.MBL) == (250.0, 700.0, 4e6)


def test_a_weight_at_a_joint_moves_with_it() -> None:
    weight = ClumpWeightChoice((5e3,), 7850.0, joint=1)
    space = space_of(clump_weights=(weight,))
    positions = [space.line((0, k, 1, 0, 0, 0)).point_loads[0].position for k in range(3)]
    assert positions == [110.0, 220.0, 330.0]


def test_no_weight_hangs_at_or_beyond_an_end() -> None:
    at_joint = space_of(clump_weights=(ClumpWeightChoice((5e3,), 7850.0, joint=1),))
    assert "at 110 m of a line of 110 m" in at_joint.flaw((0, 0, 0, 0, 0, 0))
    assert at_joint.flaw((0, 0, 1, 0, 0, 0)) == ""
    beyond = space_of(clump_weights=(ClumpWeightChoice((5e3,), 7850.0, positions=(120.0,)),))
    assert "at 120 m of a line of 110 m" in beyond.flaw((0, 0, 0, 0, 0, 0))
    assert beyond.flaw((0, 1, 0, 0, 0, 0)) == ""


def test_everything_that_is_missing_is_told_at_once() -> None:
    case = small_case(
        objectives=("mass", "cost"),
        segments=(
            SegmentChoice((100.0,), ("chain stud-link U2",), diameters=(0.07, 0.08)),
            SegmentChoice((100.0,), ("chain studles R3",)),
            SegmentChoice((100.0,), ("wire spiral-strand",), diameter_max=0.01),
            SegmentChoice((100.0,)),
        ),
        clump_weights=(ClumpWeightChoice((1e3,), 900.0, positions=(10.0,)),),
    )
    with pytest.raises(InputError) as raised:
        DesignProblem.of(case)
    told = [str(problem) for problem in raised.value.problems]
    wanted = (
        r"design\.segments\[0\]: found .*70 mm and .*80 mm; no price is known.*choose a variant",
        r'design\.segments\[1\]\.components\[0\]: .*did you mean "chain studless R3"',
        r"design\.segments\[2\]\.components\[0\]: .*no size is sold up to 10 mm",
        r"design\.segments\[3\]\.components: .*line\.segments has only 1",
        r"design\.clump_weights\[0\]\.density: found 900 kg/m3",
    )
    assert len(told) == len(wanted)
    for problem, pattern in zip(told, wanted, strict=True):
        assert re.search(pattern, problem), problem


def test_a_strength_that_a_check_needs_has_to_be_known() -> None:
    case = replace(
        small_case(segments=(SegmentChoice((300.0,)),)),
        line=Line([Segment(300.0, 700.0, mass=80.0)]),
    )
    with pytest.raises(InputError, match=r"design\.segments\[0\]\.MBL"):
        DesignProblem.of(case)
    without = replace(case, checks=Checks(max_anchor_uplift_angle=0.0))
    assert DesignProblem.of(without).space.count > 0


def test_wear_lowers_the_allowed_tension() -> None:
    worn = replace(small_case(), service=Service(life=20 * 31557600.0, wear_rate=0.4e-3 / 31557600))
    new, end = (DesignProblem.of(case).tables.allowed for case in (small_case(), worn))
    assert (end[:, 0, :4] < new[:, 0, :4]).all()
    # R3 50 mm less 8 mm: c d2 (44 - 0.08 d) of 42 mm over that of 50 mm
    ratio = (42**2 * (44 - 0.08 * 42)) / (50**2 * (44 - 0.08 * 50))
    assert end[0, 0, 0] / new[0, 0, 0] == pytest.approx(ratio, rel=1e-6)


def test_a_segment_of_the_line_that_wears_faster_wears_faster_in_every_size() -> None:
    """0.4 mm a year for 20 years there, no wear elsewhere; a rope does not take it over."""
    rate = 0.4e-3 / 31557600
    case = small_case()
    choice = SegmentChoice((300.0,), ("chain studless R3", "polyester"), diameters=(0.14,))
    line = Line([replace(case.line.segments[0], wear_rate=rate, nominal_diameter=0.06)])
    case = replace(
        case,
        line=line,
        service=Service(life=20 * 31557600.0),
        design=replace(DESIGN, segments=(choice,), clump_weights=()),
    )
    chain, rope = DesignProblem.of(case).space.segments[0].options
    assert (chain.wear_rate, rope.wear_rate) == (rate, None)
    allowed = DesignProblem.of(case).tables.allowed[0, 0, :2]
    # R3 140 mm less 8 mm, over the factor of 3: 0.0223 132^2 (44 - 0.08 132) / 3 = 4331.1 kN
    assert allowed[0] == pytest.approx(4331.1e3, rel=2e-5)
    assert rope.MBL is not None
    assert allowed[1] == rope.MBL / 3.0


def test_sizes_read_in_no_document_are_told() -> None:
    warnings = DesignProblem.of(
        small_case(segments=(SegmentChoice((100.0,), ("wire spiral-strand",)),))
    ).warnings
    assert any("wire spiral-strand is sold" in warning for warning in warnings)


@pytest.mark.parametrize(
    ("changes", "match"),
    [
        ({"load_cases": (), "load": Load(span=100.0)}, "load_cases: missing"),
        ({"design": None}, "design: missing"),
        (
            {
                "design": replace(DESIGN, objectives=("mass", "excursion")),
                "load_cases": small_case().load_cases[:1],
            },
            "excursion; a load case of kind",
        ),
        (
            {"design": replace(DESIGN, sinker=SinkerChoice((50e3,), 2400.0, 0.6))},
            "design.sinker.safety_factor: missing; give the factor on sliding",
        ),
    ],
)
def test_what_a_search_cannot_do_without(changes: dict[str, object], match: str) -> None:
    with pytest.raises(InputError, match=match):
        DesignProblem.of(replace(small_case(), **changes))  # type: ignore[arg-type]
