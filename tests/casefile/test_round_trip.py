"""A case written and read again is the same case, to the last digit."""

from __future__ import annotations

import math
from dataclasses import replace

from hypothesis import given, settings
from hypothesis import strategies as st

from catopt.casefile import parse_case, write_case
from catopt.model import Case, Checks, Find, Line, Load, PointLoad, Segment, Site, SwarmSettings
from catopt.model.case import BOUNDARY_HANDLINGS
from catopt.model.find import FIND_QUANTITIES

POSITIVE = st.floats(min_value=0.0, exclude_min=True, allow_infinity=False)
NOT_NEGATIVE = st.floats(min_value=0.0, allow_infinity=False)
ANY = st.floats(allow_nan=False, allow_infinity=False)
TEXT = st.text(st.characters(exclude_categories=["Cs"]), max_size=20)
LENGTHS = st.floats(min_value=1e-3, max_value=1e5)

SEGMENTS = st.builds(
    Segment,
    length=LENGTHS,
    submerged_weight=ANY,
    EA=POSITIVE | st.just(math.inf),
    mass=st.none() | NOT_NEGATIVE,
    MBL=st.none() | POSITIVE,
    name=TEXT,
)
LOADS = st.one_of(
    *(
        st.builds(Load, **{key: POSITIVE})
        for key in ("horizontal_force", "span", "fairlead_tension")
    )
)
CHECKS = st.builds(
    Checks,
    safety_factor=st.floats(min_value=1.0, allow_infinity=False),
    max_anchor_uplift_angle=st.none() | st.floats(0.0, math.pi / 2.0),
)
SWARMS = st.builds(
    SwarmSettings,
    particles=st.integers(2, 10**9),
    iterations=st.integers(1, 10**9),
    runs=st.integers(1, 10**9),
    seed=st.integers(0, 2**63 - 1),
    cognitive=st.floats(0.0, 4.0),
    social=st.floats(0.0, 4.0),
    inertia=st.floats(0.0, 1.0),
    boundary=st.sampled_from(BOUNDARY_HANDLINGS),
)


@st.composite
def lines(draw: st.DrawFn) -> Line:
    segments = draw(st.lists(SEGMENTS, min_size=1, max_size=3))
    total = math.fsum(segment.length for segment in segments)
    loads = st.builds(
        PointLoad,
        position=st.floats(0.0, total, exclude_min=True, exclude_max=True),
        submerged_weight=ANY,
        mass=st.none() | NOT_NEGATIVE,
        name=TEXT,
    )
    return Line(segments, draw(st.lists(loads, max_size=3)))


@st.composite
def questions(draw: st.DrawFn, line: Line) -> tuple[Line, Load | None, Find | None]:
    """Draw a line with a load, or with something sought and the load that goes with it."""
    quantity = draw(st.sampled_from([None, *FIND_QUANTITIES]))
    segment = draw(st.none() | st.integers(1, len(line.segments)))
    angle = draw(st.floats(0.0, math.pi / 2.0))
    if quantity == "length":
        load = draw(LOADS.filter(lambda load: load.span is None))
        on_bed = draw(st.none() | POSITIVE)
        condition = (angle, None) if on_bed is None else (None, on_bed)
        return line, load, Find("length", segment, None, *condition)
    if quantity == "clump_weight" and line.point_loads:
        number = draw(st.none() | st.integers(1, len(line.point_loads)))
        return line, draw(LOADS), Find("clump_weight", point_load=number, anchor_angle=angle)
    if quantity == "touchdown_force":
        return line, None, Find("touchdown_force")
    if quantity == "limit_force":
        strong = Line([replace(part, MBL=draw(POSITIVE)) for part in line.segments])
        return strong, None, Find("limit_force", segment=segment)
    return line, draw(LOADS), None


@st.composite
def cases(draw: st.DrawFn) -> Case:
    anchor, fairlead = sorted([draw(NOT_NEGATIVE), draw(NOT_NEGATIVE)])
    line, load, find = draw(questions(draw(lines())))
    if find is not None and find.quantity == "touchdown_force":
        anchor = 0.0
    return Case(
        site=Site(draw(POSITIVE), draw(NOT_NEGATIVE), draw(POSITIVE)),
        line=line,
        load=load,
        fairlead_height=fairlead,
        anchor_height=anchor,
        checks=draw(CHECKS),
        swarm=draw(SWARMS),
        title=draw(TEXT),
        source=draw(TEXT),
        find=find,
    )


@given(cases())
@settings(deadline=None)  # the first example builds the schema
def test_a_written_case_is_read_back_exactly(case: Case) -> None:
    assert parse_case(write_case(case)) == case


def test_the_written_file_reads_like_one_by_hand() -> None:
    case = Case(
        site=Site(9.5),
        line=Line(
            [Segment(20, 93.163175, EA=4.1e7, mass=10.9)], [PointLoad(7.0, 490.3325, name="sinker")]
        ),
        load=Load(horizontal_force=3363.68095),
        fairlead_height=9.5,
        swarm=SwarmSettings(200, 200, 1, 1, 1.5, 1.5, 0.5, "nearest"),
        title='The "9.5 m" buoy',
    )
    assert write_case(case) == (
        'title = "The \\"9.5 m\\" buoy"\n'
        "\n"
        "[site]\n"
        'water_depth = "9.5 m"\n'
        "seabed_friction = 0.0\n"
        'water_density = "1025.0 kg/m^3"\n'
        "\n"
        "[line]\n"
        'fairlead_height = "9.5 m"\n'
        'anchor_height = "0.0 m"\n'
        "\n"
        "[[line.segments]]\n"
        'length = "20.0 m"\n'
        'submerged_weight = "93.163175 N/m"\n'
        'mass = "10.9 kg/m"\n'
        'EA = "41000000.0 N"\n'
        "\n"
        "[[line.point_loads]]\n"
        'name = "sinker"\n'
        'position = "7.0 m"\n'
        'submerged_weight = "490.3325 N"\n'
        "\n"
        "[load]\n"
        'horizontal_force = "3363.68095 N"\n'
        "\n"
        "[checks]\n"
        "safety_factor = 1.0\n"
        "\n"
        "[pso]\n"
        "particles = 200\n"
        "iterations = 200\n"
        "runs = 1\n"
        "seed = 1\n"
        "cognitive = 1.5\n"
        "social = 1.5\n"
        "inertia = 0.5\n"
        'boundary = "nearest"\n'
    )


def test_what_is_sought_is_written_where_the_load_would_be() -> None:
    case = Case(
        site=Site(20.0),
        line=Line([Segment(55.0, 2100.0, MBL=7.5e6)]),
        load=None,
        fairlead_height=20.0,
        find=Find("limit_force", segment=1),
    )
    text = write_case(case)
    assert "[load]" not in text
    assert '\n[find]\nquantity = "limit_force"\nsegment = 1\n\n[checks]\n' in text
