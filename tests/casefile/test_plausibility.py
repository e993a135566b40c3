"""Values beyond the range of their quantity are refused, and taken where their name is accepted."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from catopt import InputError, solve_case
from catopt.casefile import parse_case, write_case
from catopt.casefile.reading import parse_network
from catopt.model import (
    Anchor,
    Case,
    Checks,
    CurrentProfile,
    Dynamics,
    Floater,
    Line,
    Load,
    PointLoad,
    Segment,
    SinkerChoice,
    Site,
    WaveState,
    WaveTrain,
)
from catopt.model.kinds import OneOf, annotated
from catopt.model.plausible_ranges import RANGES
from catopt.sizing.file import parse_file

CASE = """
[site]
water_depth = "20 m"
[line]
[[line.segments]]
length = "100 m"
submerged_weight = "1000 N/m"
mass = "110 kg/m"
[load]
horizontal_force = "200 kN"
[anchor]
kind = "sinker"
mass = "20 t"
density = "2400 kg/m^3"
friction = 0.5
safety_factor = 1.5
[current]
profile = "power"
speed = "1 m/s"
"""
POINT = '[[line.point_loads]]\nposition = "50 m"\nsubmerged_weight = "100 kN"\nmass = "1 t"\n'
SLIPS = [
    ("friction = 0.5", "friction = 50", "anchor.friction: found 50", "friction"),
    ("[line]", "seabed_friction = 3.0\n[line]", "site.seabed_friction: found 3.0", "friction"),
    ("[line]", "water_density = 10\n[line]", "site.water_density: found 10", "water_density"),
    ("[line]", 'water_density = "1.2 t/m^3"\n[line]', "site.water_density", "water_density"),
    ("2400 kg/m^3", "24000 kg/m^3", "anchor.density: found", "body_density"),
    ("= 1.5", "= 150", "anchor.safety_factor: found 150", "safety_factor"),
    ("20 m", "20 km", "site.water_depth: found", "water_depth"),
    ("1 m/s", "100 kn", "current.speed: found", "current_speed"),
    ("110 kg/m", "1 kg/m", "segments[0].submerged_weight: found", "weight_in_water"),
    ("[load]", POINT + "[load]", "point_loads[0].submerged_weight", "weight_in_water"),
    ("[load]", "drag_normal = 24\n[load]", "segments[0].drag_normal: found 24", "drag"),
]


def test_the_case_is_right_before_it_is_changed() -> None:
    assert parse_case(CASE).accept == ()


@pytest.mark.parametrize(("old", "new", "said", "name"), SLIPS)
def test_a_slip_is_refused_and_its_range_overridden_by_name(
    old: str, new: str, said: str, name: str
) -> None:
    text = CASE.replace(old, new, 1)
    assert text != CASE
    with pytest.raises(InputError) as caught:
        parse_case(text)
    assert said in str(caught.value)
    assert f'write accept = ["{name}"]' in str(caught.value)
    case = parse_case(f'accept = ["{name}"]\n{text}')
    assert case.accept == (name,)
    assert parse_case(write_case(case)) == case
    other = next(each.name for each in RANGES if each.name != name)
    with pytest.raises(InputError, match="not plausible"):
        parse_case(f'accept = ["{other}"]\n{text}')


def test_an_unknown_name_is_refused() -> None:
    with pytest.raises(InputError, match=r"accept\[0\]: found \"frictions\".*friction"):
        parse_case(f'accept = ["frictions"]\n{CASE}')


def test_points_and_sizings_have_the_same_ranges() -> None:
    network = (Path(__file__).parents[2] / "catopt/casefile/templates/points.toml").read_text()
    slipped = network.replace("seabed_friction = 0.0", "seabed_friction = 5", 1)
    assert slipped != network
    with pytest.raises(InputError, match=r"site\.seabed_friction: found 5"):
        parse_network(slipped)
    file = parse_file('[buoy]\nname = "pillar 1.8 m"\n[site]\nwater_density = 10\n', "buoy")
    assert [each.path for each in file.findings] == [("site", "water_density")]


CHAIN: dict[str, Any] = {"length": 100.0, "submerged_weight": 1000.0, "mass": 110.0}
IN_PYTHON: list[tuple[Any, dict[str, Any], str, str]] = [
    (Site, {"water_depth": 20.0, "seabed_friction": 3.0}, "seabed_friction: found 3", "friction"),
    (Site, {"water_depth": 20.0, "water_density": 10.0}, "water_density: found", "water_density"),
    (Site, {"water_depth": "20 km"}, "water_depth: found 20000", "water_depth"),
    (Segment, CHAIN | {"mass": 1.0}, "submerged_weight: found 1000", "weight_in_water"),
    (Segment, CHAIN | {"drag_normal": 24.0}, "drag_normal: found 24", "drag"),
    (PointLoad, {"position": 50.0, "submerged_weight": "100 kN", "mass": "1 t"},
     "submerged_weight: found 100000", "weight_in_water"),
    (PointLoad, {"position": 50.0, "submerged_weight": 9.0, "friction": 50.0}, "50", "friction"),
    (Anchor, {"kind": "sinker", "submerged_weight": 1e5, "friction": 50.0}, "found 50", "friction"),
    (Checks, {"safety_factor": 50.0}, "safety_factor: found 50", "safety_factor"),
    (WaveState, {"spectrum": "jonswap", "height": 80.0, "period": 10.0}, "80", "wave_height"),
    (WaveTrain, {"spectrum": "jonswap", "height": 8.0, "period": 90.0}, "90", "wave_period"),
    (CurrentProfile, {"profile": "power", "speed": "100 kn"}, "speed: found 51", "current_speed"),
    (CurrentProfile, {"profile": "table", "depths": (0.0, 5.0), "speeds": (1.0, 50.0)},
     "speeds: found 1, 50", "current_speed"),
    (SinkerChoice, {"masses": (1e3,), "density": 2400.0, "friction": 50.0}, "50", "friction"),
    (Dynamics, {"duration": 600.0, "line_damping": 5.0}, "line_damping: found 5", "damping"),
    (Floater, {"buoy": "pillar 1.8 m", "wind_speed": 200.0}, "found 200", "wind_speed"),
    (Floater, {"buoy": "pillar 1.8 m", "pitch_damping": 3.0}, "found 3", "damping"),
]  # fmt: skip


@pytest.mark.parametrize(("part", "given", "said", "name"), IN_PYTHON)
def test_python_has_the_ranges_of_files_and_their_override(
    part: Any, given: dict[str, Any], said: str, name: str
) -> None:
    with pytest.raises(InputError, match="not plausible") as caught:
        part(**given)
    assert said in str(caught.value)
    assert f'give accept=["{name}"]' in str(caught.value)
    other = next(each.name for each in RANGES if each.name != name)
    with pytest.raises(InputError, match="not plausible"):
        part(**given, accept=[other])
    taken = part(**given, accept=[name])
    assert replace(taken).accept == (name,)  # a part that is changed accepts what it did
    with pytest.raises(InputError, match="accept: found"):
        part(**given, accept=[name, "frictions"])


def test_what_is_accepted_is_told_with_the_answer_and_written() -> None:
    site = Site(20.0, seabed_friction=3.0, accept=["friction"])
    case = Case(site, Line([Segment(**CHAIN)]), Load(horizontal_force=2e5), 20.0)
    assert case.accept == ("friction",)
    text = write_case(case)
    assert text.count("accept") == 1
    again = parse_case(text)
    assert (again, again.site.accept) == (case, ("friction",))
    (told,) = [each for each in solve_case(case).warnings if "accepted" in each]
    assert told.endswith("friction")
    plain = replace(case, site=Site(20.0), accept=())
    assert not [each for each in solve_case(plain).warnings if "accepted" in each]


def test_the_names_are_those_of_the_ranges() -> None:
    kind = annotated(Case)["accept"].kind
    assert isinstance(kind, OneOf)
    assert kind.words == (*(each.name for each in RANGES), "weight_in_water")
