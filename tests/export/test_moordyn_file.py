"""The MoorDyn file against numbers worked by hand, and what it says of what it cannot hold."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

from catopt import Case, Line, Load, PointLoad, Segment, Site, System, read_case
from catopt._version import identity
from catopt.errors import InputError
from catopt.export.export_result import Exported, Source, exported_lines, rigid_segments
from catopt.export.moordyn import moordyn_input
from catopt.model import CurrentProfile, Dynamics, Motion

from .cases import CASES, FSO, chain_and_wire, suspended, tanker, tanker_with_sinker

G = 9.80665


def rows(text: str, section: str) -> list[list[str]]:
    """Rows of a section without its two rows of headings (options have none)."""
    lines = text.splitlines()
    start = lines.index(f"--- {section} ---") + 1
    end = next(k for k in range(start, len(lines)) if lines[k].startswith("---"))
    return [line.split() for line in lines[start:end]][0 if section == "OPTIONS" else 2 :]


def free(exported: Exported) -> list[list[str]]:
    """Return the points between the ends of lines."""
    return [row for row in rows(exported.text, "POINTS") if row[1] == "Free"]


def options(text: str) -> dict[str, float]:
    return {row[1]: float(row[0]) for row in rows(text, "OPTIONS")}


def remarks(exported: Exported) -> str:
    return " ".join(exported.remarks)


def by_hand() -> Case:
    """100 kg/m that displaces 0.01 m2 of water of 1000 kg/m3: 90 kg/m in water.

    Its lowest point is at the anchor; with H = 60 w the textbook's elastic catenary gives the
    fairlead at the end of 80 m.
    """
    H, V, EA = 60.0 * 90.0 * G, 80.0 * 90.0 * G, 1.1e8
    height = 60.0 * (math.hypot(1.0, V / H) - 1.0) + V * 80.0 / (2.0 * EA)
    line = Line([Segment(80.0, 90.0 * G, EA=EA, mass=100.0, name="chain 50 mm")])
    site = Site(50.0, water_density=1000.0)
    return Case(site, line, Load(horizontal_force=H), height, title="By hand")


def test_the_whole_file() -> None:
    """Every number from the textbook's formulas for a line that is level at its anchor."""
    case = by_hand()
    exported = moordyn_input(
        exported_lines(case), elements=16, sources=[Source("case.toml", 64 * "a")]
    )
    w, EA = 90.0 * G, 1.1e8
    H, V = 60.0 * w, 80.0 * w
    T = 100.0 * w  # 60, 80, 100
    x = 60.0 * math.asinh(80.0 / 60.0) + H * 80.0 / EA
    z = case.fairlead_height - 50.0
    diameter = math.sqrt(0.04 / math.pi)
    # The bed gives way by 1 mm: k = w / (d 1 mm), rounded up; critical 2 sqrt(k m / d), down.
    # A tension wave takes l sqrt(m / EA) = 5 m / 1049 m/s; 0.4 of that; the bed's is slower.
    k = 7900000.0
    assert w / (diameter * 1e-3) == pytest.approx(7.822e6, rel=1e-3)
    c = 160000.0
    assert 2.0 * math.sqrt(k * 100.0 / diameter) == pytest.approx(167.3e3, rel=1e-3)
    numbers = (
        f"span {x:.10g} m, H {H:.10g} N, V at fairlead {V:.10g} N, T at fairlead {T:.10g} N, "
        f"T at anchor {H:.10g} N, V at anchor 0 N, on the bed 0 m"
    )
    flat = " ".join(exported.text.split())
    assert f"tensions without the water's pressure (effective): line 1: {numbers}" in flat
    # 90 g 5^2 / (8 60 90 g)
    assert f"w l^2 / (8 H) = {25.0 / 480.0:.2g} m" in flat
    head = exported.text.splitlines()[:3]
    assert head == [
        f"MoorDyn v2 input file, also read by MoorPy; written by catopt {identity()}",
        "Case: By hand",
        f"From case.toml, SHA-256 {64 * 'a'}",
    ]
    body = exported.text[exported.text.index("--- LINE TYPES") :]
    assert (
        body
        == f"""\
--- LINE TYPES ---
Name Diam MassDen EA BA/-zeta EI Cd Ca CdAx CaAx
(-) (m) (kg/m) (N) (N-s/-) (N-m2) (-) (-) (-) (-)
chain_50_mm {diameter:.10g} 100 110000000 -0.8 0 1.2 1 0 0
--- POINTS ---
ID Attachment X Y Z Mass Volume CdA Ca
(#) (-) (m) (m) (m) (kg) (m^3) (m^2) (-)
1 Fixed 0 0 -50 0 0 0 0
2 Coupled {x:.10g} 0 {z:.10g} 0 0 0 0
--- LINES ---
ID LineType AttachA AttachB UnstrLen NumSegs Outputs
(#) (name) (#) (#) (m) (-) (-)
1 chain_50_mm 1 2 80 16 -
--- OPTIONS ---
0 writeLog no log file
0.0019 dtM time step (s): 0.4 of a tension wave through an element
9.80665 g standard gravity (m/s^2)
1000 rho water density (kg/m^3)
50 WtrDpth water depth (m)
{k:.10g} kBot bed stiffness (Pa/m): what lies on it sinks in by 1 mm
{c:.10g} cBot bed damping (Pa-s/m): critical
0 FrictionCoefficient of line on bed; acts on what moves
1 ICgenDynamic let it come to rest by itself: MoorDyn's other way can stop early
100 CdScaleIC drag while it comes to rest, over that of the line
1 dtIC how long the tensions have to keep still (s)
1e-07 threshIC how still: largest change over the tension
600 TmaxIC longest time to come to rest (s)
--- END ---
"""
    )


def test_what_hangs_on_the_line_has_mass_and_volume() -> None:
    """6000 kg that weigh 50 kN in water displace (6000 - 50000/g)/1025 m3."""
    exported = moordyn_input(exported_lines(chain_and_wire()))
    anchor, clump, fairlead = rows(exported.text, "POINTS")
    assert [row[1] for row in (anchor, clump, fairlead)] == ["Fixed", "Free", "Coupled"]
    assert float(clump[5]) == 6000.0
    assert float(clump[6]) == pytest.approx((6000.0 - 50e3 / G) / 1025.0, rel=1e-9)
    assert "point load" not in remarks(exported).replace("some of a point load", "")
    for row in (anchor, fairlead):
        assert row[5:] == ["0", "0", "0", "0"]


def test_segments_meet_in_points_where_the_closed_form_has_them() -> None:
    solved = exported_lines(chain_and_wire())
    exported = moordyn_input(solved, elements=80)
    (state,) = solved.lines[0].solution.point_loads
    (clump,) = free(exported)
    assert float(clump[2]) == pytest.approx(state.x, rel=1e-9)
    assert float(clump[4]) == pytest.approx(state.z - 56.0, rel=1e-9)
    lines = rows(exported.text, "LINES")
    assert [row[1:6] for row in lines] == [
        ["chain", "1", "2", "200", "40"],
        ["wire", "2", "3", "200", "40"],
    ]
    types = {row[0]: row for row in rows(exported.text, "LINE TYPES")}
    for name, mass, weight in (("chain", 178.7, 1470.0), ("wire", 34.9, 298.0)):
        diameter = math.sqrt(4.0 / math.pi * (mass - weight / G) / 1025.0)
        assert float(types[name][1]) == pytest.approx(diameter, rel=1e-9)
        # What MoorDyn makes of it is the weight of the case again.
        area = 0.25 * math.pi * float(types[name][1]) ** 2
        assert (mass - 1025.0 * area) * G == pytest.approx(weight, rel=1e-8)


def test_a_mass_that_is_not_known_stands_in_and_is_said() -> None:
    """Of steel: m = w/g / (1 - 1025/7850). A weight has no volume, a buoy no mass."""
    segment = Segment(60.0, 2100.0, EA=1e9)
    loads = [PointLoad(20.0, 5e3), PointLoad(40.0, -6e3)]
    case = Case(Site(20.0), Line([segment], loads), Load(horizontal_force=100e3), 20.0)
    exported = moordyn_input(exported_lines(case))
    ((name, diameter, mass, *_),) = rows(exported.text, "LINE TYPES")
    assert float(mass) == pytest.approx(2100.0 / G / (1.0 - 1025.0 / 7850.0), rel=1e-9)
    assert float(diameter) == pytest.approx(math.sqrt(4.0 * float(mass) / 7850.0 / math.pi))
    weight, buoy = free(exported)
    assert [float(each) for each in weight[5:7]] == pytest.approx([5e3 / G, 0.0], rel=1e-9)
    assert [float(each) for each in buoy[5:7]] == pytest.approx([0.0, 6e3 / G / 1025.0], rel=1e-9)
    said = remarks(exported)
    assert name == "segment_1"
    assert "mass in air not known of segment_1: that of steel" in said
    assert "mass in air not known of a point load" in said
    text = " ".join(exported.text.split())
    assert all(" ".join(remark.split()) in text for remark in exported.remarks)


def test_two_loads_at_one_place_are_one_point() -> None:
    case = chain_and_wire()
    twice = Line(case.line.segments, [*case.line.point_loads, PointLoad(200.0, 1e3, mass=150.0)])
    exported = moordyn_input(exported_lines(replace(case, line=twice)))
    (both,) = free(exported)
    assert float(both[5]) == 6150.0
    assert float(both[6]) == pytest.approx((6150.0 - 51e3 / G) / 1025.0, rel=1e-9)


def test_drag_and_added_mass_of_what_hangs_at_one_point_are_put_together() -> None:
    """CdA adds up; Ca is over both volumes: of 2 m3 with 0.5 and 1 m3 with 1.1, 0.7."""
    loads = [
        PointLoad(200.0, (4000.0 - 2050.0) * G, mass=4000.0, drag_area=2.0, drag_coefficient=0.6,
                  added_mass_coefficient=0.5),
        PointLoad(200.0, (500.0 - 1025.0) * G, mass=500.0, drag_area=1.0, drag_coefficient=1.1,
                  added_mass_coefficient=1.1),
    ]  # fmt: skip
    case = chain_and_wire()
    exported = moordyn_input(exported_lines(replace(case, line=Line(case.line.segments, loads))))
    (both,) = free(exported)
    assert [float(cell) for cell in both[5:]] == pytest.approx([4500.0, 3.0, 2.3, 0.7], rel=1e-6)


def test_everything_that_is_missing_is_told_at_once() -> None:
    floats = Segment(10.0, -50.0, name="floats")
    too_light = Segment(50.0, 2100.0, EA=1e9, mass=200.0, accept=["weight_in_water"])
    case = Case(Site(20.0), Line([too_light, floats]), Load(horizontal_force=1e5), 20.0)
    solved = exported_lines(case)
    with pytest.raises(InputError) as caught:
        moordyn_input(solved)
    assert [problem.key for problem in caught.value.problems] == [
        "line.segments[0].mass",  # 2100 / g = 214 kg/m in water alone
        "line.segments[1].EA",
    ]
    assert rigid_segments(case) == ("line.segments[1]",)
    with pytest.raises(InputError, match=r"segments\[1\].mass: missing; a segment that does not"):
        moordyn_input(
            exported_lines(replace(case, line=Line([Segment(60.0, 2100.0), floats])), EA=1e9)
        )


def test_a_mass_that_only_just_bears_its_weight_has_no_volume() -> None:
    case = chain_and_wire()
    clump = PointLoad(200.0, 50e3, mass=50e3 / G * (1.0 + 1e-12))
    exported = moordyn_input(exported_lines(replace(case, line=Line(case.line.segments, [clump]))))
    (point,) = free(exported)
    assert point[6] == "0"
    lighter = Line(case.line.segments, [replace(clump, mass=5000.0, accept=("weight_in_water",))])
    with pytest.raises(InputError, match=r"point_loads\[0\].mass: found 5000 kg; must be above"):
        moordyn_input(exported_lines(replace(case, line=lighter)))
    floating = Line([*case.line.segments, Segment(5.0, -20.0, EA=1e8, mass=0.0)])
    with pytest.raises(InputError, match=r"segments\[2\].mass: found 0 kg/m; must be above 0"):
        moordyn_input(exported_lines(replace(case, line=floating)))


def test_a_given_EA_is_said_and_the_closed_form_is_solved_with_it() -> None:
    case = replace(suspended(), line=Line([Segment(20.0, 93.163175, mass=10.9)]))
    exported = moordyn_input(exported_lines(case, EA=2e6))
    assert rows(exported.text, "LINE TYPES")[0][3] == "2000000"
    of_its_own = moordyn_input(exported_lines(suspended(2e6)))
    given, own = (each.expected[0].to_dict() for each in (exported, of_its_own))
    assert given["fairlead_tension_N"] == own["fairlead_tension_N"]
    rigid = exported_lines(case).lines[0].solution.fairlead.tension
    change = 100.0 * (given["fairlead_tension_N"] / rigid - 1.0)
    assert f"It changes the fairlead tension by {change:.2g} %." in remarks(exported)
    assert "was given" not in remarks(of_its_own)


def test_a_found_line_is_exported_as_found() -> None:
    """The case seeks the length that is level at its anchor under 800 kN (S2)."""
    case = read_case(CASES / "ship-200m-sinker" / "case.toml")
    solved = exported_lines(case, EA=1e9)
    length = solved.lines[0].solution.line.length
    assert length == pytest.approx(572.3, abs=0.05)  # S2's digits
    lines = rows(moordyn_input(solved).text, "LINES")
    assert sum(float(row[4]) for row in lines) == pytest.approx(length, rel=1e-9)
    assert solved.lines[0].solution.horizontal_force == pytest.approx(800e3, rel=1e-12)


# ------------------------------------------------------------------ what it cannot hold


def test_friction_at_rest_is_told_with_what_to_expect_without() -> None:
    solved = exported_lines(chain_and_wire(friction=0.5))
    exported = moordyn_input(solved)
    line = exported.expected[0].to_dict()
    assert options(exported.text)["FrictionCoefficient"] == 0.5
    assert "bed friction 0.5: MoorDyn's friction acts on what moves" in remarks(exported)
    assert "on a bed without friction: span" in exported.text
    free = line["without_friction"]
    assert free["span_m"] == line["span_m"]
    # Without friction the anchor bears what the line pulls with; with it, mu w less for each metre.
    assert free["anchor_tension_N"] == pytest.approx(free["horizontal_force_N"], rel=1e-12)
    held = 0.5 * 1470.0 * line["grounded_length_m"]
    assert line["anchor_tension_N"] == pytest.approx(line["horizontal_force_N"] - held, rel=1e-9)
    assert moordyn_input(exported_lines(chain_and_wire())).expected[0].without_friction is None


def test_a_sinker_near_the_bed_and_one_on_it_are_told() -> None:
    case = tanker_with_sinker()
    above = moordyn_input(exported_lines(case, EA=1e9))
    assert "set zTol of its points" in remarks(above)
    assert "rests on the bed" not in remarks(above)
    slack = replace(case, load=Load(horizontal_force=100e3))
    solved = exported_lines(slack, EA=1e9)
    resting = moordyn_input(solved)
    assert "a point of MoorDyn does not feel the bed" in remarks(resting)
    (state,) = solved.lines[0].solution.point_loads
    assert state.seabed_reaction > 1e5
    # The line's halves of an element at its two sides carry it, pressed in by 1 mm.
    kind = rows(resting.text, "LINE TYPES")[0]
    half = sum(0.5 * float(row[4]) / int(row[5]) for row in rows(resting.text, "LINES"))
    wanted = state.seabed_reaction / (half * float(kind[1]) * 1e-3)
    stiffness = options(resting.text)["kBot"]
    assert wanted <= stiffness <= 1.1 * wanted  # rounded up to two digits


def test_a_fairlead_above_the_water() -> None:
    case = replace(tanker(), fairlead_height=25.0)
    raised, true = (moordyn_input(exported_lines(case), true_depth=true) for true in (False, True))
    assert options(raised.text)["WtrDpth"] == 25.0
    assert rows(raised.text, "POINTS")[0][4] == "-25"
    assert "the depth is put at 25 m" in remarks(raised)
    assert options(true.text)["WtrDpth"] == 20.0
    assert [row[4] for row in rows(true.text, "POINTS")] == ["-20", "5"]
    assert "the tensions differ by that" in remarks(true)
    assert "above the water" not in remarks(moordyn_input(exported_lines(tanker())))


def test_the_sea_of_the_case_is_said_to_be_left_out() -> None:
    current, motion = CurrentProfile("power", speed=0.8), Motion(period=8.0, surge=1.0)
    case = replace(tanker(), current=current, motion=motion, dynamics=Dynamics(10.0))
    assert "not in the file: current, motion of the case" in remarks(
        moordyn_input(exported_lines(case))
    )


def test_drag_refers_to_the_diameter_that_moordyn_takes() -> None:
    """Cd D is the same for any diameter; along the line MoorDyn counts pi times the diameter."""
    segment = replace(
        tanker().line.segments[0],
        drag_diameter=0.105,
        drag_normal=2.4,
        drag_axial=1.15,
        added_mass_normal=1.0,
        added_mass_axial=0.5,
    )
    exported = moordyn_input(exported_lines(replace(tanker(), line=Line([segment]))))
    numbers = [float(each) for each in rows(exported.text, "LINE TYPES")[0][1:]]
    diameter, *_, Cd, Ca, CdAx, CaAx = numbers
    assert Cd * diameter == pytest.approx(2.4 * 0.105, rel=1e-9)
    assert CdAx * math.pi * diameter == pytest.approx(1.15 * 0.105, rel=1e-9)
    assert (Ca, CaAx) == (1.0, 0.5)
    assert "drag" not in remarks(exported)


# ------------------------------------------------------------------ names and systems


def test_names_become_words_and_stay_apart() -> None:
    segments = [
        Segment(50.0, 2100.0, EA=1e9, mass=246.0, name="xích 105 mm"),
        Segment(50.0, 2000.0, EA=1e9, mass=246.0, name="xích 105 mm"),
        Segment(50.0, 1900.0, EA=1e9, mass=246.0, name="76 mm"),
        Segment(50.0, 1900.0, EA=1e9, mass=246.0, name="錨"),
    ]
    title = "Neo tàu --- đệm\nva"
    case = Case(Site(20.0), Line(segments), Load(horizontal_force=1e5), 20.0, title=title)
    exported = moordyn_input(exported_lines(case))
    names = [row[0] for row in rows(exported.text, "LINE TYPES")]
    assert names == ["xich_105_mm", "xich_105_mm_2", "segment_3_76_mm", "segment_4"]
    assert "Case: Neo tau -- dem va\n" in exported.text
    assert exported.text.isascii()


def test_a_system_has_all_its_lines_where_the_body_is() -> None:
    solved = exported_lines(read_case(FSO))
    exported = moordyn_input(solved, elements=40)
    points, lines = rows(exported.text, "POINTS"), rows(exported.text, "LINES")
    assert [row[0] for row in points] == [str(k) for k in range(1, 46)]
    assert (len(lines), len(rows(exported.text, "LINE TYPES"))) == (36, 4)
    anchors = [[float(v) for v in row[2:4]] for row in points if row[1] == "Fixed"]
    azimuths = [-3, 0, 3, 117, 120, 123, 237, 240, 243]
    for (x, y), azimuth in zip(anchors, azimuths, strict=True):
        angle = math.radians(azimuth)
        assert (x, y) == pytest.approx(
            (1056.0 * math.cos(angle), 1056.0 * math.sin(angle)), abs=1e-6
        )
    (body,) = solved.bodies
    for row in points:
        if row[1] == "Coupled":
            place = (body.x, body.y, 0.0)
            assert [float(v) for v in row[2:5]] == pytest.approx(place, abs=1e-6)
    assert "the body is not in the file" in remarks(exported)
    # No piece joins two lines: every line's points follow each other.
    ends = [(int(row[2]), int(row[3])) for row in lines]
    assert all(upper == lower + 1 and lower % 5 != 0 for lower, upper in ends)


def test_legs_of_their_own_keep_their_names() -> None:
    line = tanker().line
    legs = System.around(line, azimuths=[0.0, math.pi], anchor_radius=50.0, fairlead_height=20.0)
    named = replace(
        legs, legs=tuple(replace(leg, name=f"leg {k}") for k, leg in enumerate(legs.legs))
    )
    solved = exported_lines(replace(tanker(), load=None, system=named))
    assert [each.name for each in moordyn_input(solved).expected] == ["leg 0", "leg 1"]


def test_expected_forces_are_read_by_their_old_keys_for_one_version() -> None:
    found = moordyn_input(exported_lines(read_case(CASES / "buoy-9.5m/case.toml"), EA=1e8))
    (expected,) = found.expected
    with pytest.warns(DeprecationWarning, match=r"solution.fairlead.tension"):
        assert expected["fairlead_tension_N"] == expected.solution.fairlead.tension
