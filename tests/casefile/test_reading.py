"""What a case file says is what the case holds."""

from __future__ import annotations

import json
import math
import subprocess
import sys
from contextlib import suppress
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from catopt.casefile import parse_case, read_case
from catopt.errors import InputError
from catopt.model import Case, Checks, Find, Line, Load, PointLoad, Segment, Site, SwarmSettings

CASES = Path(__file__).parents[2] / "cases"

SHORTEST = """
[site]
water_depth = 9.5
[[line.segments]]
length = 20
submerged_weight = 93.163175
[load]
span = 17.4
"""

FULL = """
title = "A case with every key"
source = "made up"

[site]
water_depth = "200 m"
seabed_friction = 0.3
water_density = "1.02 t/m^3"

[line]
fairlead_height = "190 m"
anchor_height = "5 m"

[[line.segments]]
name = "chain"
length = "100 m"
submerged_weight = "1 kN/m"
mass = "120 kg/m"
EA = "600 MN"
MBL = "7100 kN"

[[line.segments]]
name = "rope"
length = "500 m"
submerged_weight = "-2 kgf/m"

[[line.point_loads]]
name = "buoy"
position = "300 m"
submerged_weight = "-10 kN"

[[line.point_loads]]
name = "sinker"
position = "150 m"
mass = "2 t"
density = "4080 kg/m^3"

[[line.point_loads]]
name = "clump"
position = "200 m"
submerged_weight = "5 kN"
mass = "0.6 t"

[load]
fairlead_tension = "1.2 MN"

[checks]
safety_factor = 1.67
max_anchor_uplift_angle = "90 deg"

[pso]
particles = 50
iterations = 60
runs = 7
seed = 0
cognitive = 2
social = 1.0
inertia = 0.7
boundary = "reflective"
"""

FIND = """
[find]
quantity = "clump_weight"
point_load = 3
anchor_angle = "3 deg"
"""


def problems_of(text: str) -> list[str]:
    with pytest.raises(InputError) as caught:
        parse_case(text)
    return [str(problem) for problem in caught.value.problems]


def test_what_is_left_out_takes_its_default() -> None:
    expected = Case(
        site=Site(water_depth=9.5, seabed_friction=0.0, water_density=1025.0),
        line=Line([Segment(length=20.0, submerged_weight=93.163175, EA=math.inf)]),
        load=Load(span=17.4),
        fairlead_height=9.5,
        anchor_height=0.0,
        checks=Checks(),
        swarm=SwarmSettings(),
    )
    assert parse_case(SHORTEST) == expected


def test_every_key_arrives_in_si() -> None:
    sinker_weight = 2000 * 9.80665 * 0.75  # the density is four times that of the water
    expected = Case(
        site=Site(water_depth=200.0, seabed_friction=0.3, water_density=1020.0),
        line=Line(
            [
                Segment(100.0, 1000.0, EA=6e8, mass=120.0, MBL=7.1e6, name="chain"),
                Segment(500.0, -2 * 9.80665, name="rope"),
            ],
            [
                PointLoad(150.0, sinker_weight, mass=2000.0, name="sinker"),
                PointLoad(200.0, 5000.0, mass=600.0, name="clump"),
                PointLoad(300.0, -10000.0, name="buoy"),
            ],
        ),
        load=Load(fairlead_tension=1.2e6),
        fairlead_height=190.0,
        anchor_height=5.0,
        checks=Checks(safety_factor=1.67, max_anchor_uplift_angle=math.pi / 2.0),
        swarm=SwarmSettings(50, 60, 7, 0, 2.0, 1.0, 0.7, "reflective"),
        title="A case with every key",
        source="made up",
    )
    assert parse_case(FULL) == expected


def test_what_is_sought_arrives_in_si() -> None:
    case = parse_case(FULL + FIND)
    assert case.find == Find("clump_weight", point_load=3, anchor_angle=3 * (math.pi / 180))
    assert case.load == Load(fairlead_tension=1.2e6)
    (_, load) = SHORTEST.split("[load]")
    assert load.strip() == "span = 17.4"
    bare = SHORTEST.replace("[load]\nspan = 17.4", '[find]\nquantity = "touchdown_force"')
    case = parse_case(bare)
    assert (case.load, case.find) == (None, Find("touchdown_force"))


def test_a_point_load_has_a_friction_of_its_own() -> None:
    load = "\n[[line.point_loads]]\nsubmerged_weight = 5\nposition = 7\n"
    assert parse_case(SHORTEST + load).line.point_loads[0].friction is None
    assert parse_case(SHORTEST + load + "friction = 0.9").line.point_loads[0].friction == 0.9
    with pytest.raises(InputError, match=r"line.point_loads\[0\].friction: found -0.1; "):
        parse_case(SHORTEST + load + "friction = -0.1")


def test_the_tanker_of_s3_seeks_its_length() -> None:
    """S3: h = 20 m, w = 2100 N/m, H = 450 kN, a clump weight 7 m from the anchor."""
    case = read_case(CASES / "tanker-20m-find-length" / "case.toml")
    assert case.find == Find("length", segment=1, anchor_angle=0.0)
    assert case.load == Load(horizontal_force=450e3)
    assert case.line.point_loads[0] == PointLoad(7.0, 200e3, name="sinker")
    assert case.line.segments[0].MBL == pytest.approx(770e3 * 9.80665, rel=1e-15)


@pytest.mark.parametrize(
    "written",
    [
        '[find]\nquantity = "spam"',
        "[find]",
        "find = 3",
        '[fnd]\nquantity = "touchdown_force"',
    ],
)
def test_a_load_is_not_missed_where_it_is_unclear_what_is_sought(written: str) -> None:
    """One mistake, one message: with a sound [find] there might be no load."""
    bare = SHORTEST.replace("[load]\nspan = 17.4\n", "")
    text = written + bare if "=" in written.splitlines()[0] else bare + written
    assert len(problems_of(text)) == 1


def test_a_load_under_another_name_is_not_missed_too() -> None:
    (problem,) = problems_of(SHORTEST.replace("[load]", "[laod]"))
    assert problem.startswith("laod: ")


def test_the_line_is_not_judged_where_it_is_unclear() -> None:
    """A number beyond segments that cannot be read, or that may be there, is not reported."""
    find = '[find]\nquantity = "{}"\n{} = 2\nanchor_angle = 0\n'
    force = SHORTEST.replace("span = 17.4", "horizontal_force = 5")
    first = "[[line.segments]]\nlength = 20\nsubmerged_weight = 93.163175"
    segment = find.format("length", "segment")
    assert len(problems_of(force.replace(first, "[line]\nsegments = 5") + segment)) == 1
    assert len(problems_of(force.replace("line.segments", "line.segmnts") + segment)) == 1
    buoys = "[[line.point_lods]]\nposition = 7\nsubmerged_weight = 5\n"
    assert len(problems_of(force + buoys + find.format("clump_weight", "point_load"))) == 1
    limit = SHORTEST.replace("[load]\nspan = 17.4", '[find]\nquantity = "limit_force"')
    assert len(problems_of(limit.replace("length = 20", "length = 20\nmbl = 5"))) == 1


def test_the_buoy_of_the_article() -> None:
    """S1's figures; w = 9.5 kgf/m is not printed there."""
    case = read_case(CASES / "buoy-9.5m" / "case.toml")
    (segment,) = case.line.segments
    assert (case.site.water_depth, case.fairlead_height, case.anchor_height) == (9.5, 9.5, 0.0)
    assert (segment.length, segment.EA) == (20.0, math.inf)
    # One product of two rounded factors each.
    assert segment.submerged_weight == pytest.approx(93.163175, rel=sys.float_info.epsilon)
    assert case.load is not None
    assert case.load.horizontal_force == pytest.approx(3363.68095, rel=sys.float_info.epsilon)
    assert (case.swarm.particles, case.swarm.iterations) == (200, 200)


def test_the_slack_sister_differs_in_its_weight_alone() -> None:
    case = read_case(CASES / "buoy-9.5m" / "case.toml")
    slack = read_case(CASES / "buoy-9.5m-slack" / "case.toml")
    (segment,) = slack.line.segments
    assert segment.submerged_weight == pytest.approx(294.1995, rel=sys.float_info.epsilon)
    same = ("site", "load", "fairlead_height", "anchor_height", "checks", "swarm")
    assert all(getattr(slack, key) == getattr(case, key) for key in same)
    assert slack.line.length == case.line.length
    # Slack, from S1 (4) with theta0 = 0: longer than sqrt(h (h + 2 a)).
    a = 3363.68095 / 294.1995
    assert slack.line.length > math.sqrt(9.5 * (9.5 + 2.0 * a))


@pytest.mark.parametrize(
    "path", sorted(CASES.rglob("case.toml")), ids=lambda path: path.parent.name
)
def test_every_case_of_the_project_is_read(path: Path) -> None:
    assert read_case(path).title


def test_a_line_too_short_for_the_depth_is_no_error_of_the_file() -> None:
    assert parse_case(SHORTEST.replace("length = 20", "length = 5")).line.length == 5.0


def test_a_point_load_lies_strictly_below_the_top_of_the_line() -> None:
    load = "\n[[line.point_loads]]\nsubmerged_weight = 5\nposition = "
    assert parse_case(SHORTEST + load + "19.999").line.point_loads[0].position == 19.999
    (problem,) = problems_of(SHORTEST + load + "20")
    assert problem.startswith("line.point_loads[0].position: found 20; must be below 20 m")


def test_positions_are_not_judged_by_a_length_that_is_wrong() -> None:
    text = SHORTEST.replace("length = 20", 'length = "20 kg"')
    load = "\n[[line.point_loads]]\nsubmerged_weight = 5\nposition = 30"
    assert len(problems_of(text + load)) == 1


def test_an_anchor_above_its_fairlead_is_allowed() -> None:
    raised = SHORTEST + "[line]\nanchor_height = 12\n"
    assert parse_case(raised).anchor_height == 12.0


def test_problems_come_in_the_order_of_the_file() -> None:
    text = """
[pso]
runs = 0
[load]
horizontal_force = 1
span = -1
[[line.segments]]
submerged_weight = 5
EA = 0
[site]
depth = 9.5
"""
    keys = [problem.split(":")[0] for problem in problems_of(text)]
    assert keys == [
        "pso.runs",
        "load",
        "load.span",
        "line.segments[0].EA",
        "line.segments[0].length",
        "site.depth",
    ]


def test_a_key_with_odd_characters_is_quoted_in_its_path() -> None:
    (problem,) = problems_of('"a b" = 1\n' + SHORTEST)
    assert problem.startswith("'a b': found an unknown key; ")


@pytest.mark.parametrize(
    ("section", "key", "hint"),
    [
        ("[site]", "Water_Depth", "did you mean water_depth?"),
        ("[site]", "water-density", "did you mean water_density?"),
        ("[site]", "depth", "did you mean water_depth?"),
        ("[site]", "mu", "did you mean seabed_friction?"),
        ("[site]", "title", "move it to the top of the file, before the first section"),
        ("[site]", "EA", "move it to [[line.segments]]"),
        ("[site]", "friction", "did you mean seabed_friction?"),
        ("[site]", "masses", "move it to [[design.clump_weights]] or [design.sinker]"),
        (
            "[site]",
            "mass",
            "move it to [[line.segments]], [[line.point_loads]], [anchor], "
            "[[design.clump_weights]], [design.sinker], [body] or [floater.hull]",
        ),
        ("[load]", "segments", "move it to [[line.segments]] or [[design.segments]]"),
        ("[load]", "water_level", "move it to [[load_cases]] or [[design.loads]]"),
        ("[[line.segments]]", "nominal_diameter", "did you mean diameter?"),
        ("[[line.segments]]", "load", "did you mean proof_load?"),
        ("[load]", "segment", "move it to [find] or [[fatigue.curves]]"),
        (
            "[site]",
            "wind",
            "allowed here: water_depth, seabed_friction, water_density, seabed_slope, "
            "contact_offset",
        ),
        ("[load]", "xyz", "allowed here: horizontal_force, span, fairlead_tension"),
    ],
)
def test_an_unknown_key_gets_a_hint(section: str, key: str, hint: str) -> None:
    text = SHORTEST.replace(section, f"{section}\n{key} = 1")
    assert problems_of(text)[-1].endswith(f"{key}: found an unknown key; {hint}")


JUNK = [
    "1",
    "-1",
    "nan",
    "inf",
    "true",
    '"text"',
    '"9.5 m"',
    '"5 kN"',
    "[]",
    "[1]",
    "[{}]",
    "{}",
    "2025-04-01",
    "1" * 500,
    '{a = "9.5 m"}',
]


@given(st.data())
@settings(deadline=None)  # the first example builds the schema
def test_any_value_anywhere_is_read_or_refused(data: st.DataObject) -> None:
    lines = (FULL + FIND).splitlines()
    assignments = [index for index, line in enumerate(lines) if " = " in line]
    changed = data.draw(st.lists(st.sampled_from(assignments), min_size=1, max_size=4))
    for index in changed:
        key = lines[index].split(" = ")[0]
        lines[index] = f"{key} = {data.draw(st.sampled_from(JUNK))}"
    _read_or_refused("\n".join(lines))


@given(st.text(max_size=80))
@settings(deadline=None)
def test_any_text_is_read_or_refused(text: str) -> None:
    _read_or_refused(text)


def _read_or_refused(text: str) -> None:
    with suppress(InputError):
        assert isinstance(parse_case(text), Case)


def test_a_cold_start_loads_no_numpy() -> None:
    code = (
        "import json, sys; from catopt.casefile import read_case;"
        f"read_case({str(CASES / 'buoy-9.5m' / 'case.toml')!r});"
        "print(json.dumps(sorted(sys.modules)))"
    )
    run = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=60
    )
    assert {"numpy", "numba", "pandas"} & set(json.loads(run.stdout)) == set()
