"""The table [system] of a case file: read, written back, refused."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

from catopt import InputError, Line, Segment, System
from catopt.casefile import parse_case
from catopt.casefile.writing import write_case
from catopt.model import Case, Leg, Load, Site

HEAD = """
[site]
water_depth = "50 m"
seabed_friction = 0.3
[line]
fairlead_height = "48 m"
anchor_height = "1 m"
[[line.segments]]
length = "600 m"
submerged_weight = "1000 N/m"
"""
SYSTEM = """
[system]
anchor_radius = "0.57 km"
azimuths = ["0 deg", "120 deg", 4.0]
fairlead_radius = "10 m"
force = ["200 kN", -5]
moment = "3 kN*m"
"""
LINE = Line([Segment(600.0, 1000.0)])


def test_it_is_read_with_the_line_and_the_site() -> None:
    case = parse_case(HEAD + SYSTEM)
    assert case.load is None
    assert case.system == System.around(
        LINE,
        azimuths=[0.0, math.radians(120.0), 4.0],
        anchor_radius=570.0,
        fairlead_height=48.0,
        anchor_height=1.0,
        fairlead_radius=10.0,
        seabed_friction=0.3,
        force=(200e3, -5.0),
        moment=3e3,
    )


@pytest.mark.parametrize(
    "further", ["", "yaw_free = true", "yaw_free = false"], ids=["left out", "true", "false"]
)
def test_it_is_written_back(further: str) -> None:
    text = SYSTEM.replace('moment = "3 kN*m"', "") if further.endswith("false") else SYSTEM
    case = parse_case(HEAD + text + further)
    assert parse_case(write_case(case)) == case


@pytest.mark.parametrize("judged", [True, False])
def test_a_mooring_that_is_not_judged_without_a_line_stays_so_in_a_file(judged: bool) -> None:
    case = parse_case(HEAD + SYSTEM + f"judged_line_out = {str(judged).lower()}")
    written = write_case(case)
    assert ("judged_line_out = false" in written) is not judged
    again = parse_case(written).system
    assert again is not None
    assert again.judged_line_out is judged


def test_lines_of_their_own_have_no_place_in_a_file() -> None:
    case = parse_case(HEAD + SYSTEM)
    assert case.system is not None
    own = Leg(Line([Segment(700.0, 900.0)]), 1.0, 570.0, 48.0)
    with pytest.raises(InputError, match="equal lines"):
        write_case(replace(case, system=System((*case.system.legs, own))))


@pytest.mark.parametrize(
    ("text", "key"),
    [
        (SYSTEM + '[load]\nspan = "500 m"', "load"),
        (SYSTEM + '[[load_cases]]\nname = "a"\nhorizontal_force = "5 kN"', "load_cases"),
        (SYSTEM.replace('anchor_radius = "0.57 km"', ""), "anchor_radius"),
        (SYSTEM.replace('["200 kN", -5]', '["200 kN"]'), "system.force"),
        (SYSTEM.replace('"3 kN*m"', '"3 kN"'), "system.moment"),
        (SYSTEM.replace("fairlead_radius", "fairled_radius"), "fairled_radius"),
        (SYSTEM.replace('fairlead_radius = "10 m"', "yaw_free = true"), "system.yaw_free"),
        (SYSTEM.replace('fairlead_radius = "10 m"', "yaw_free = false"), "system.moment"),
        (SYSTEM + "yaw_free = false", "system.moment"),
        (SYSTEM.replace('"10 m"', '"0 m"'), "system.moment"),
        (SYSTEM.replace('["0 deg", "120 deg", 4.0]', "[]"), "system.azimuths"),
    ],
)
def test_what_is_wrong_is_named(text: str, key: str) -> None:
    with pytest.raises(InputError) as caught:
        parse_case(HEAD + text)
    assert any(key in problem.key for problem in caught.value.problems)


def test_the_model_refuses_a_load_beside_a_system() -> None:
    case = parse_case(HEAD + SYSTEM)
    with pytest.raises(InputError, match="load: found together with a system"):
        Case(Site(50.0), LINE, Load(span=500.0), 48.0, system=case.system)


def test_a_system_has_a_level_bed() -> None:
    sloped = HEAD.replace("[site]\n", '[site]\nseabed_slope = "3 deg"\n')
    with pytest.raises(InputError, match="a sloping bed is for one line") as caught:
        parse_case(sloped + SYSTEM)
    assert [each.key for each in caught.value.problems] == ["site.seabed_slope"]
    case = parse_case(HEAD + SYSTEM)
    with pytest.raises(InputError, match=r"site\.seabed_slope"):
        replace(case, site=replace(case.site, seabed_slope=0.05))


# ------------------------------------------------------------------ in motion

LED = """
[site]
water_depth = "20 m"
[line]
[[line.segments]]
length = "120 m"
submerged_weight = "1110 N/m"
mass = "130 kg/m"
EA = "400 MN"
drag_normal = 0
[system]
anchor_radius = "117 m"
azimuths = ["180 deg", "60 deg", "-60 deg"]
[waves]
spectrum = "regular"
height = "2 m"
period = "7 s"
[motion]
rao_file = "rao.csv"
rao_phase = "lead"
rao_reference = ["1 m", "-2 m", "22 m"]
rao_rotation = "rad/m"
rao_per = "height"
rao_crest = ["3 m", "-4 m"]
drift = ["1 m", "0 m"]
drift_file = "drift.csv"
[dynamics]
duration = "24 s"
"""

FREE = (
    LED[: LED.index("[motion]")]
    + """
[body]
mass = "200 t"
added_mass = "20 t"
damping = "3 kN*s/m"
force_file = "force.csv"
wave_force = ["100 kN/m", "0 N/m"]
[dynamics]
duration = "24 s"
broken_line = 2
broken_at = "12 s"
"""
)


@pytest.mark.parametrize("text", [LED, FREE], ids=["led", "free"])
def test_a_body_in_motion_is_written_and_read_again(text: str) -> None:
    case = parse_case(text)
    assert parse_case(write_case(case)) == case


def test_a_free_body_is_read_in_si() -> None:
    body = parse_case(FREE).body
    assert body is not None
    assert (body.mass, body.added_mass, body.damping) == (2e5, 2e4, 3e3)
    assert body.wave_force == (1e5, 0.0)
    assert body.force_file.endswith("/force.csv")


@pytest.mark.parametrize(
    ("left_out", "message"),
    [
        ('rao_phase = "lead"\n', "motion.rao_phase: missing; the RAOs of a body need it"),
        ('rao_reference = ["1 m", "-2 m", "22 m"]\n', "motion.rao_reference: missing"),
        ('rao_rotation = "rad/m"\n', "motion.rao_rotation: missing"),
        ('rao_per = "height"\n', "motion.rao_per: missing"),
    ],
)
def test_what_raos_do_not_say_themselves_has_to_be_there(left_out: str, message: str) -> None:
    with pytest.raises(InputError) as caught:
        parse_case(LED.replace(left_out, ""))
    assert message in str(caught.value)
    assert len(caught.value.problems) == 1


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (LED.replace("rao_phase", "rao_phaze"), "did you mean rao_phase?"),
        (FREE.replace("broken_at", "# broken_at"), "dynamics.broken_at: missing"),
        (FREE.replace("broken_line = 2", "broken_line = 4"), "there are 3 lines"),
        (FREE.replace('"12 s"', '"24 s"'), "must be below 24 s, the duration"),
        (
            LED.replace("[dynamics]\n", '[body]\nmass = "1 t"\n[dynamics]\n'),
            "a body either has prescribed motion or",
        ),
    ],
)
def test_mistakes_of_a_body_in_motion_are_told_once(text: str, message: str) -> None:
    with pytest.raises(InputError) as caught:
        parse_case(text, "case.toml")
    assert str(caught.value).startswith("case.toml: ")
    assert message in str(caught.value)
    assert len(caught.value.problems) == 1
