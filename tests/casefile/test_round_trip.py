"""A case written and read again is the same case, to the last digit."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path
from typing import Any, get_args

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from catopt.casefile import parse_case, write_case
from catopt.documents import unfit
from catopt.model import (
    Anchor,
    Buoy,
    Case,
    CatalogueChoice,
    Checks,
    ClumpWeightChoice,
    CurrentProfile,
    Design,
    Dynamics,
    Find,
    Line,
    Load,
    LoadCase,
    Motion,
    PointLoad,
    Segment,
    SegmentChoice,
    Service,
    SinkerChoice,
    Site,
    SwarmSettings,
    WaveState,
    WaveTrain,
)
from catopt.model.case import Boundary
from catopt.model.design import FIND_QUANTITIES, OBJECTIVES, SearchMethod
from catopt.model.dynamics import INITIAL_FRICTION, JudgedBy, TimeScheme
from catopt.model.kinds import COUNTS
from catopt.model.load import LoadCaseKind
from catopt.model.plausible_ranges import NAMES, accepting
from catopt.model.sea import WAVE_SPECTRA, Stretching

POSITIVE = st.floats(min_value=1e-3, max_value=100.0)
"""Plausible of every quantity."""
NOT_NEGATIVE = st.just(0.0) | POSITIVE
ANY = NOT_NEGATIVE | POSITIVE.map(lambda value: -value)
ANGLES = st.just(0.0) | st.floats(1e-3, 6.5) | st.floats(-6.5, -1e-3)
"""Up to about a turn."""
TEXT = st.text(st.characters(exclude_categories=["Cs", "Cc"]), max_size=20).filter(
    lambda text: not unfit(text)
)
NAME = TEXT.filter(str.strip)
LENGTHS = st.floats(min_value=1e-3, max_value=1e5)


def up_to(most: float) -> st.SearchStrategy[float]:
    return st.just(0.0) | st.floats(1e-6, most)


FACTOR = st.floats(min_value=1.0, max_value=1e3)

SEGMENTS = st.one_of(
    st.builds(
        Segment,
        length=LENGTHS,
        submerged_weight=ANY,
        EA=POSITIVE | st.just(math.inf),
        mass=st.none() | NOT_NEGATIVE,
        MBL=st.none() | POSITIVE,
        name=TEXT,
        nominal_diameter=st.none() | POSITIVE,
        proof_load=st.none() | POSITIVE,
        price=st.none() | NOT_NEGATIVE,
        wear_rate=st.none() | NOT_NEGATIVE,
        drag_diameter=st.none() | POSITIVE,
        drag_normal=st.none() | NOT_NEGATIVE,
        drag_axial=st.none() | NOT_NEGATIVE,
        added_mass_normal=st.none() | NOT_NEGATIVE,
        added_mass_axial=st.none() | NOT_NEGATIVE,
    ),
    st.builds(
        Segment,
        length=LENGTHS,
        submerged_weight=ANY,
        MBL_mean=POSITIVE,
        MBL_cov=st.just(0.0) | st.floats(1e-6, 0.25),
        mass=NOT_NEGATIVE,
        drag_diameter=POSITIVE,
        added_mass_axial=st.none() | NOT_NEGATIVE,
        drag_method=st.just("roughness"),
        roughness=NOT_NEGATIVE,
        keulegan_carpenter=st.floats(12.0, 1e3),
        wake_amplification=POSITIVE,
    ),
    # Of a component, with figures of one's own before those of the catalogue.
    st.builds(
        Segment,
        length=LENGTHS,
        submerged_weight=ANY,
        EA=POSITIVE,
        mass=NOT_NEGATIVE,
        MBL=POSITIVE,
        name=TEXT,
        component=st.sampled_from(["chain studless R3", "chain stud-link U2"]),
        nominal_diameter=st.floats(0.02, 0.12),
        proof_load=POSITIVE,
        price=NOT_NEGATIVE,
        wear_rate=st.none() | NOT_NEGATIVE,
        drag_diameter=POSITIVE,
        drag_normal=NOT_NEGATIVE,
        drag_axial=NOT_NEGATIVE,
        added_mass_normal=NOT_NEGATIVE,
        added_mass_axial=NOT_NEGATIVE,
    ),
)
LOADS = st.one_of(
    *(
        st.builds(Load, **{key: POSITIVE})
        for key in ("horizontal_force", "span", "fairlead_tension")
    )
)
CHECKS = st.builds(
    Checks,
    safety_factor=FACTOR,
    max_anchor_uplift_angle=st.none() | up_to(math.pi / 2.0),
    codes=st.lists(NAME, max_size=3, unique=True).map(tuple),
    proof_load_factor=st.none() | FACTOR,
    max_anchor_uplift_force=st.none() | NOT_NEGATIVE,
    min_grounded_length=st.none() | NOT_NEGATIVE,
    min_tension=st.none() | NOT_NEGATIVE,
    max_span=st.none() | POSITIVE,
    allow_recalled=st.booleans(),
)
SERVICES = st.builds(Service, life=NOT_NEGATIVE, wear_rate=NOT_NEGATIVE)
BUOYS = st.builds(Buoy, reserve_buoyancy=POSITIVE)
ANCHORS = st.one_of(
    st.builds(
        Anchor,
        kind=st.just("sinker"),
        submerged_weight=POSITIVE,
        friction=POSITIVE,
        safety_factor=st.none() | FACTOR,
        mass=st.none() | POSITIVE,
    ),
    st.builds(
        Anchor,
        kind=st.just("drag"),
        holding_capacity=POSITIVE,
        safety_factor=FACTOR,
        factor_source=TEXT.filter(lambda text: not text or bool(text.strip())),
        mass=st.none() | POSITIVE,
    ),
)
CHOICES = st.builds(CatalogueChoice, allow_recalled=st.booleans())


def counts(key: str) -> st.SearchStrategy[int]:
    return st.integers(*COUNTS[key])


def values(
    least: float = 1e-3, most: float = 1e6, *, size: int = 1
) -> st.SearchStrategy[tuple[float, ...]]:
    drawn = st.lists(st.floats(least, most), min_size=size, max_size=20, unique=True)
    return drawn.map(lambda each: tuple(sorted(each)))


@st.composite
def designs(draw: st.DrawFn, line: Line, references: int) -> Design:
    made = st.builds(
        SegmentChoice,
        lengths=values(1e3, 1e5),
        components=st.sampled_from(
            [("chain studless R3",), ("chain studless R4", "chain stud-link U3")]
        ),
        diameters=values(0.02, 0.12),
        optional=st.booleans(),
        name=TEXT,
    )
    sold = st.builds(
        SegmentChoice,
        lengths=values(1e3, 1e5),
        components=st.just(("chain studless R3",)),
        diameter_min=st.none() | st.floats(0.01, 0.06),
        diameter_max=st.none() | st.floats(0.07, 1e3),
        name=TEXT,
    )
    as_it_is = st.builds(SegmentChoice, lengths=values(1e3, 1e5), name=TEXT)
    segments = [
        draw(sold if index else made.filter(lambda each: not each.optional))
        if draw(st.booleans()) or index >= len(line.segments)
        else draw(as_it_is)
        for index in range(draw(st.integers(1, 3)))
    ]
    weight = {"masses": values(), "density": POSITIVE, "optional": st.booleans(), "name": TEXT}
    weights = [st.builds(ClumpWeightChoice, positions=values(1e-3, 900.0), **weight)]
    if len(segments) > 1:
        joints = st.integers(1, len(segments) - 1)
        weights.append(st.builds(ClumpWeightChoice, joint=joints, **weight))
    sinker = st.builds(
        SinkerChoice,
        masses=values(),
        density=st.floats(1e3, 3e4),
        friction=POSITIVE,
        safety_factor=st.none() | FACTOR,
    )
    named = [name for name in OBJECTIVES if name != "excursion" or references == 1]
    return Design(
        tuple(segments),
        tuple(draw(st.lists(st.one_of(weights), max_size=3))),
        draw(st.none() | sinker),
        tuple(draw(st.permutations(named)))[: draw(st.integers(2, 3))],
        draw(st.sampled_from(get_args(SearchMethod))),
        evaluations=draw(counts("evaluations")),
        population=draw(counts("population")),
        seed=draw(counts("seed")),
        max_enumerated=draw(counts("max_enumerated")),
    )


SWARMS = st.builds(
    SwarmSettings,
    particles=st.integers(2, 1_000),
    iterations=counts("iterations"),
    runs=counts("runs"),
    seed=counts("seed"),
    cognitive=up_to(4.0),
    social=up_to(4.0),
    inertia=up_to(1.0),
    boundary=st.sampled_from(get_args(Boundary)),
)


GAMMA = st.none() | st.floats(1.0, 20.0)
SPREADINGS: st.SearchStrategy[dict[str, Any]] = st.sampled_from(
    [{}, {"spreading_exponent": 2.5, "spreading_directions": 7}]
)


@st.composite
def trains(draw: st.DrawFn) -> WaveTrain:
    spectrum: Any = draw(st.sampled_from(WAVE_SPECTRA))
    spread: dict[str, Any] = draw(SPREADINGS) if spectrum != "regular" else {}
    return WaveTrain(
        spectrum,
        draw(POSITIVE),
        draw(POSITIVE),
        draw(GAMMA) if spectrum == "jonswap" else None,
        draw(ANGLES),
        7 * draw(st.integers(1, 1000)),
        **spread,
    )


SEA: dict[str, Any] = {
    "stretching": st.sampled_from(get_args(Stretching)),
    "seed": counts("seed"),
}
WAVES: st.SearchStrategy[WaveState] = st.one_of(
    st.tuples(trains(), st.fixed_dictionaries(SEA)).map(
        lambda drawn: WaveState(**vars(drawn[0]), **drawn[1])
    ),
    st.builds(WaveState, trains=st.lists(trains(), min_size=1, max_size=3).map(tuple), **SEA),
    st.builds(
        WaveState,
        elevation_file=st.just("/data/elevation.csv"),
        elevation_x=ANY,
        shortest_period=st.none() | POSITIVE,
        direction=ANGLES,
        stretching=SEA["stretching"],
    ),
)
TABLES = st.lists(st.tuples(NOT_NEGATIVE, ANY), min_size=1, max_size=4, unique_by=lambda r: r[0])
CURRENTS = st.one_of(
    st.builds(
        CurrentProfile,
        profile=st.just("power"),
        speed=NOT_NEGATIVE,
        exponent=st.none() | POSITIVE,
        direction=ANGLES,
    ),
    st.builds(CurrentProfile, profile=st.just("wind"), speed=NOT_NEGATIVE, depth=POSITIVE),
    st.builds(
        CurrentProfile,
        profile=st.just("power"),
        direction=ANGLES,
        series_file=st.just("/data/c.csv"),
    ),
    st.builds(
        CurrentProfile,
        profile=st.just("table"),
        depths=st.just((1.0, 2.0)),
        speeds=st.tuples(POSITIVE, NOT_NEGATIVE),
        directions=st.tuples(up_to(1.5), up_to(1.5)),
        series_file=st.sampled_from(["", "/data/c.csv"]),
    ),
    TABLES.map(
        lambda rows: CurrentProfile(
            "table", depths=tuple(sorted(d for d, _ in rows)), speeds=tuple(s for _, s in rows)
        )
    ),
)
LOWER_MOTIONS = st.one_of(
    st.builds(
        Motion,
        period=POSITIVE,
        **dict.fromkeys(("surge", "sway", "heave"), NOT_NEGATIVE),
        **dict.fromkeys(("surge_phase", "sway_phase", "heave_phase"), ANGLES),
    ),
    st.builds(Motion, file=st.just("/data/motion.csv")),
)
MOTIONS = LOWER_MOTIONS | st.builds(Motion, rao_file=st.just("/data/rao.csv"))
WITHIN = st.none() | st.floats(1e-3, 0.9)
RUNS = st.builds(
    Dynamics,
    duration=st.floats(1.0, 1e6),
    ramp=WITHIN,
    time_step=WITHIN,
    output_interval=WITHIN,
    elements=counts("elements"),
    scheme=st.sampled_from(get_args(TimeScheme)),
    initial_friction=st.sampled_from(INITIAL_FRICTION),
    spectral_radius=up_to(1.0),
    runs=counts("runs"),
    seabed_stiffness=st.none() | POSITIVE,
    seabed_damping=st.none() | NOT_NEGATIVE,
    line_damping=st.none() | NOT_NEGATIVE,
    damping_time=NOT_NEGATIVE,
    duration_of_interest=POSITIVE,
    judged_by=st.sampled_from(get_args(JudgedBy)),
)


DRAG = st.sampled_from([{}, {"drag_area": st.floats(0.1, 9.0), "drag_coefficient": st.just(1.2)}])
"""The two are given together."""


@st.composite
def lines(draw: st.DrawFn) -> Line:
    segments = draw(st.lists(SEGMENTS, min_size=1, max_size=3))
    total = math.fsum(segment.length for segment in segments)
    loads = st.builds(
        PointLoad,
        position=st.floats(1e-6, 0.999 * total),
        submerged_weight=ANY,
        mass=st.none() | NOT_NEGATIVE,
        name=TEXT,
        friction=st.none() | NOT_NEGATIVE,
        added_mass_coefficient=NOT_NEGATIVE,
        **draw(DRAG),
    )
    # In one place there is one friction.
    apart = st.lists(loads, max_size=3, unique_by=lambda load: load.position)
    return Line(segments, draw(apart))


@st.composite
def questions(draw: st.DrawFn, line: Line) -> tuple[Line, Load | None, Find | None]:
    """Draw a line with a load, or with something sought and the load that goes with it."""
    quantity = draw(st.sampled_from([None, *FIND_QUANTITIES]))
    segment = draw(st.none() | st.integers(1, len(line.segments)))
    angle = draw(up_to(math.pi / 2.0))
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
    """Draw one whose numbers are any."""
    with accepting(NAMES):
        return _case(draw)


def _case(draw: st.DrawFn) -> Case:
    anchor, fairlead = sorted([draw(NOT_NEGATIVE), draw(NOT_NEGATIVE)])
    line, load, find = draw(questions(draw(lines())))
    if find is not None and find.quantity == "touchdown_force":
        anchor = 0.0
    depth = draw(POSITIVE)
    state = st.builds(
        LoadCase,
        name=NAME,
        horizontal_force=POSITIVE,
        water_level=NOT_NEGATIVE,
        fairlead_rise=NOT_NEGATIVE,
        kind=st.sampled_from(get_args(LoadCaseKind)),
    )
    states = draw(st.lists(state, max_size=3, unique_by=lambda each: each.name))
    if min(depth, fairlead) == 0.0:
        states = []  # the fairlead is on the bed
    if states and find is None and draw(st.booleans()):
        load = None
    references = sum(each.kind == "reference" for each in states)
    waves, motion = draw(WAVES), draw(st.none() | MOTIONS)
    moving: dict[str, Any] = {
        "waves": waves,
        "current": draw(st.none() | CURRENTS),
        "motion": motion,
        "anchor_motion": draw(st.none() | LOWER_MOTIONS),
    }
    moving |= {"dynamics": draw(RUNS)} if draw(st.booleans()) else dict.fromkeys(moving)
    return Case(
        site=Site(
            depth,
            draw(NOT_NEGATIVE),
            draw(st.floats(1e-3, 900.0)),
            draw(st.just(0.0) | st.floats(1e-6, 0.7) | st.floats(-0.7, -1e-6)),
        ),
        line=line,
        load=load,
        fairlead_height=fairlead,
        anchor_height=anchor,
        checks=draw(CHECKS),
        swarm=draw(SWARMS),
        title=draw(TEXT),
        source=draw(TEXT),
        find=find,
        load_cases=tuple(states),
        service=draw(st.none() | SERVICES),
        buoy=draw(st.none() | BUOYS),
        anchor=draw(st.none() | ANCHORS),
        catalogue=draw(CHOICES),
        design=draw(st.none() | designs(line, references)),
        accept=NAMES,
        **moving,
    )


@pytest.mark.slow
@given(cases())
@settings(deadline=None)  # the first example builds the schema and reads the catalogue
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


def test_the_catalogue_that_was_chosen_is_written_with_its_full_path(tmp_path: Path) -> None:
    (tmp_path / "own.toml").write_text('schema = "catopt.families/1"\n', encoding="utf-8")
    text = """
[site]
water_depth = 20
[[line.segments]]
length = 100
component = "chain studless R4"
diameter = "76 mm"
[load]
span = 90
[catalogue]
file = "own.toml"
allow_recalled = true
[catalogue.variants]
EA = "orcaflex"
"""
    case = parse_case(text, folder=str(tmp_path))
    full = str(tmp_path / "own.toml")
    assert case.catalogue == CatalogueChoice(full, True, (("EA", "orcaflex"),))
    assert parse_case(write_case(case)) == case
    assert write_case(case).count("orcaflex") == 1


def test_a_long_array_is_written_on_several_lines() -> None:
    lengths = tuple(20.0 + 0.5 * k for k in range(60))
    design = Design((SegmentChoice(lengths),))
    case = Case(
        site=Site(20.0),
        line=Line([Segment(55.0, 2100.0)]),
        load=Load(horizontal_force=1e5),
        fairlead_height=20.0,
        design=design,
    )
    text = write_case(case)
    assert max(map(len, text.splitlines())) <= 100
    assert parse_case(text) == case
