"""What a design may be made of, as a case file says it."""

from __future__ import annotations

import pytest

from catopt.casefile import parse_case
from catopt.casefile.building import MOST_VALUES, values_of
from catopt.casefile.schema import LENGTHS
from catopt.errors import InputError
from catopt.model import Case, ClumpWeightChoice, Design, SegmentChoice, SinkerChoice

TWO_SEGMENTS = """
[site]
water_depth = 20
[[line.segments]]
length = "60 m"
component = "chain studless R3"
diameter = "76 mm"
[[line.segments]]
length = "40 m"
submerged_weight = "300 N/m"
[load]
horizontal_force = 1e5
[design]
"""


def design(text: str) -> Design:
    read = parse_case(TWO_SEGMENTS + text)
    assert isinstance(read, Case)
    assert read.design is not None
    return read.design


def segments(text: str) -> tuple[SegmentChoice, ...]:
    return design(text).segments


def test_every_key_arrives_in_si() -> None:
    found = design("""
objectives = ["cost", "mass", "offset"]
method = "swarm"
evaluations = 500
population = 20
seed = 7
max_enumerated = 1000
[[design.segments]]
name = "chain"
components = ["chain studless R4", "r3 studless chain"]
diameters = ["81 mm", "0.076 m"]
lengths = ["2 shots", "27.5 m"]
optional = true
[[design.segments]]
component = "polyester"
diameter_min = "120 mm"
diameter_max = "160 mm"
length = 40
[[design.clump_weights]]
name = "clump"
mass_min = "1 t"
mass_max = "3 t"
mass_step = "1 t"
density = "7850 kg/m^3"
joint = 1
optional = true
[[design.clump_weights]]
mass = "2 t"
density = 2400
positions = [9, 7]
friction = 0.6
[design.sinker]
masses = ["5 t", "2 t"]
density = "2400 kg/m^3"
friction = 0.5
safety_factor = 1.5
""")
    assert found == Design(
        segments=(
            SegmentChoice(
                lengths=(27.5, 55.0),
                components=("chain studless R4", "chain studless R3"),
                diameters=(0.076, 0.081),
                optional=True,
                name="chain",
            ),
            SegmentChoice(
                lengths=(40.0,), components=("polyester",), diameter_min=0.12, diameter_max=0.16
            ),
        ),
        clump_weights=(
            ClumpWeightChoice((1e3, 2e3, 3e3), 7850.0, joint=1, optional=True, name="clump"),
            ClumpWeightChoice((2e3,), 2400.0, positions=(7.0, 9.0), friction=0.6),
        ),
        sinker=SinkerChoice((2e3, 5e3), 2400.0, 0.5, 1.5),
        objectives=("cost", "mass", "offset"),
        method="swarm",
        evaluations=500,
        population=20,
        seed=7,
        max_enumerated=1000,
    )


def test_what_is_left_out_is_as_in_the_line() -> None:
    """Its own figures included: a segment without component and diameter is the line's own."""
    assert segments("[[design.segments]]\n[[design.segments]]\nlengths = [30, 50]") == (
        SegmentChoice(lengths=(60.0,)),
        SegmentChoice(lengths=(30.0, 50.0)),
    )


def test_diameters_alone_are_of_the_component_of_the_line() -> None:
    (found,) = segments('[[design.segments]]\ndiameters = ["70 mm", "76 mm"]')
    assert found == SegmentChoice((60.0,), ("chain studless R3",), (0.07, 0.076))


def test_a_component_alone_comes_in_every_size_that_is_sold() -> None:
    (found,) = segments('[[design.segments]]\ncomponent = "chain studless R3"')
    assert (found.diameters, found.diameter_min, found.diameter_max) == ((), None, None)


def test_a_design_may_have_more_segments_than_the_line() -> None:
    third = '[[design.segments]]\ncomponent = "polyester"\nlength = 10\n'
    assert len(segments("[[design.segments]]\n" * 2 + third)) == 3


@pytest.mark.parametrize(
    ("low", "high", "step", "expected"),
    [
        ("0.1 m", "0.7 m", "0.2 m", (0.1, 0.3, 0.5, 0.7)),
        # In double precision 0.1 + 2 x 0.1 is 0.30000000000000004 and 3 x 0.1 beyond 0.3.
        ("0.1 m", "0.3 m", "0.1 m", (0.1, 0.2, 0.3)),
        ("1 m", "2 m", "0.3 m", (1.0, 1.3, 1.6, 1.9)),
        ("4 shots", "6 shots", "1 shot", (110.0, 137.5, 165.0)),
        ("50 mm", "60 mm", "5 mm", (0.05, 0.055, 0.06)),
        ("7 m", "7 m", "1 m", (7.0,)),
        ("7 m", "8 m", "5 m", (7.0,)),
    ],
)
def test_a_range_has_both_ends_where_its_step_meets_them(
    low: str, high: str, step: str, expected: tuple[float, ...]
) -> None:
    text = (
        f'[[design.segments]]\nlength_min = "{low}"\nlength_max = "{high}"\nlength_step = "{step}"'
    )
    assert segments(text)[0].lengths == expected


def test_the_largest_range_is_allowed_and_no_larger() -> None:
    text = "[[design.segments]]\nlength_min = 1\nlength_step = 1\nlength_max = "
    (found,) = segments(f"{text}{MOST_VALUES}")
    assert found.lengths == tuple(float(k) for k in range(1, MOST_VALUES + 1))
    with pytest.raises(InputError, match="makes 10001 values; at most 10000 are allowed"):
        design(f"{text}{MOST_VALUES + 1}")


def test_a_step_too_small_for_any_count_is_refused() -> None:
    with pytest.raises(InputError, match="at most 10000 are allowed"):
        design("[[design.segments]]\nlength_min = 1\nlength_step = 1e-9\nlength_max = 1e6")


def test_the_ends_are_exactly_as_written() -> None:
    third = 1.0 / 3.0
    values = values_of(
        LENGTHS,
        {"length_min": third, "length_max": 2 * third, "length_step": third},
    )
    assert values == (third, 2 * third)


def test_a_clump_weight_beyond_the_shorter_lines_is_allowed() -> None:
    """Line of 60 m or 30 m with 40 m: at 80 m it is on the longer one."""
    found = design("""
[[design.segments]]
lengths = [30, 60]
[[design.segments]]
[[design.clump_weights]]
mass = 500
density = 2400
position = 80
""")
    assert found.clump_weights[0].positions == (80.0,)
