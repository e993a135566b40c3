"""Bodies of a network at rest under their loads: as `solve_system`, by hand, by differences."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import pytest

from catopt import InputError, Line, NoEquilibriumError, Segment, System, read_case
from catopt import solve as solve_line
from catopt.casefile.reading import parse_network
from catopt.casefile.writing import write_case
from catopt.checks.system import check_network
from catopt.model import Checks, Site
from catopt.model.network import LineBetween, MooredBody, Network, Point
from catopt.mooring.case import at_levels
from catopt.mooring.fixed_body import at_rest, hold
from catopt.mooring.network_out import each_line_out
from catopt.mooring.network_rest import LinesAtRest
from catopt.mooring.restoring import offset_curve, restoring_curve, watch_circle
from catopt.mooring.solution import solve_system

from .layouts import CHAIN, fso, spread, unequal_legs

Plan = tuple[float, float]
CASES = Path(__file__).parents[2] / "cases"
OWN = Path(__file__).parents[1] / "cli" / "cases"


def as_points(system: System, depth: float, origin: tuple[float, float] = (0.0, 0.0)) -> Network:
    """Write a system as points, lines and one body."""
    points, lines = [], []
    for k, leg in enumerate(system.legs):
        for kind, (x, y), height, body in (
            ("anchor", leg.anchor, leg.anchor_height, ""),
            ("fairlead", leg.fairlead, leg.fairlead_height, "body"),
        ):
            at = (origin[0] + x, origin[1] + y, height)
            points.append(Point(f"{kind} {k}", kind, *at, body=body))  # type: ignore[arg-type]
        lines.append(LineBetween(leg.line, f"anchor {k}", f"fairlead {k}"))
    moored = MooredBody("body", *origin, system.force, system.moment, system.turns)
    site = Site(depth, system.seabed_friction)
    return Network(site, tuple(points), tuple(lines), bodies=(moored,))


def unequal(force: tuple[float, float] = (90e3, -40e3), moment: float = 3e5) -> System:
    """Moor a body by four lines that differ, on fairleads of different heights."""
    weighted = Line([Segment(430.0, 700.0, EA=6e8)])
    plain = Line([Segment(420.0, 900.0, EA=4e8)])
    return System(unequal_legs(plain, weighted), force, moment, 0.4)


SYSTEMS = {
    "shipped turret": fso((-4281e3, 0.0)),
    "turns": fso((1.2e6, 4e5), fairlead_radius=7.0, moment=2e6, turned=0.3),
    "with friction": spread(3, (4e5, 1e5), friction=0.6),
    "pulled until lines are slack": spread(4, (2.5e6, 3e5)),
    "not loaded": spread(6),
    "unequal": unequal(),
}


def assert_same(found: LinesAtRest, system: System, origin: tuple[float, float]) -> None:
    """Compare a network at rest with the system that it says again, to nine digits."""
    known = solve_system(system)
    (body,) = found.bodies
    reach = max(leg.line.length for leg in system.legs)
    for own, other in ((body.position, known.position), (body.neutral, known.neutral)):
        at = (own.x - origin[0], own.y - origin[1])
        assert at == pytest.approx((other.x, other.y), rel=1e-9, abs=1e-9 * reach)
        assert own.yaw == pytest.approx(other.yaw, rel=1e-9, abs=1e-9)
    scale = max(abs(each) for row in known.full_stiffness for each in row)
    for row, other_row in zip(body.stiffness, known.full_stiffness, strict=True):
        assert row == pytest.approx(other_row, rel=1e-7, abs=1e-9 * scale)
    strongest = max(line.tension for line in known.lines)
    for line, state in zip(found.lines, known.lines, strict=True):
        assert line.fairlead.tension == pytest.approx(state.tension, rel=1e-9, abs=1e-9 * strongest)
        anchor = state.solution.anchor.tension
        assert line.anchor.tension == pytest.approx(anchor, rel=1e-9, abs=1e-9 * strongest)


@pytest.mark.parametrize("name", SYSTEMS)
def test_a_system_written_as_points_rests_where_it_does(name: str) -> None:
    system = SYSTEMS[name]
    for origin in ((0.0, 0.0), (120.0, -35.0)):
        assert_same(at_rest(as_points(system, 90.0, origin)), system, origin)


def shipped() -> list[Path]:
    """Find every case with a body on several lines, of the project and of its tests."""
    files = [*CASES.glob("*/case.toml"), *OWN.glob("*.toml")]
    return sorted(path for path in files if "\n[system]" in path.read_text("utf-8"))


@pytest.mark.parametrize("path", shipped(), ids=lambda path: f"{path.parent.name}/{path.stem}")
def test_shipped_systems_rest_where_they_do(path: Path) -> None:
    try:
        case = read_case(path)
        assert case.system is not None
        solve_system(case.system)
    except (InputError, NoEquilibriumError):
        pytest.skip("a case that is refused")
    found = at_rest(as_points(case.system, case.site.water_depth))
    assert_same(found, case.system, (0.0, 0.0))


def barge(
    force: tuple[float, float] = (150e3, 60e3), moment: float = 4e5, **own: object
) -> Network:
    """Moor a barge by two lines astern and a crowfoot ahead, a clump weight where it splits."""
    bow, quarter = (Line([Segment(m, 1100.0, EA=6e8, MBL=5e6)]) for m in (230.0, 258.0))
    rope = Line([Segment(45.0, 150.0, EA=9e7, MBL=2e6)])
    points = [
        Point("ahead", "anchor", 290.0, 10.0, 0.0),
        Point("port quarter", "anchor", -220.0, 160.0, 0.0),
        Point("starboard quarter", "anchor", -230.0, -150.0, 4.0),
        Point("clump", "joint", submerged_weight=25e3),
        Point("bow port", "fairlead", 30.0, 6.0, 52.0, body="barge"),
        Point("bow starboard", "fairlead", 30.0, -6.0, 52.0, body="barge"),
        Point("stern port", "fairlead", -30.0, 6.0, 51.0, body="barge"),
        Point("stern starboard", "fairlead", -30.0, -6.0, 51.0, body="barge"),
    ]
    lines = [
        LineBetween(bow, "ahead", "clump"),
        LineBetween(rope, "clump", "bow port"),
        LineBetween(rope, "bow starboard", "clump"),
        LineBetween(quarter, "port quarter", "stern port"),
        LineBetween(quarter, "stern starboard", "starboard quarter"),
    ]
    return Network(
        Site(50.0),
        tuple(points),
        tuple(lines),
        bodies=(MooredBody("barge", force=force, moment=moment),),
        **own,  # type: ignore[arg-type]
    )


def pulls_on(
    found: LinesAtRest, names: set[str]
) -> list[tuple[tuple[float, float], tuple[float, float]]]:
    """Solve each line again between the places found: where it pulls, with which x and y."""
    network, pulls = found.network, []
    for run in found.runs:
        a, b = (network.points[k].name for k in (run.first, run.second))
        (xa, ya, za), (xb, yb, zb) = found.place_of(a), found.place_of(b)
        span = math.hypot(xa - xb, ya - yb)
        line = solve_line(run.line, height=zb, anchor_height=za, span=span)
        for name, sign in ((a, 1.0), (b, -1.0)):
            if name in names:
                H = sign * line.horizontal_force / span
                pulls.append((found.place_of(name)[:2], ((xb - xa) * H, (yb - ya) * H)))
    return pulls


def test_forces_and_moments_on_a_barge_balance() -> None:
    network = barge()
    found = at_rest(network)
    (body,) = found.bodies
    own = {point.name for point in network.points if point.body}
    left = [*body.body.force, body.body.moment]
    for (x, y), (fx, fy) in pulls_on(found, own):
        left[0] += fx
        left[1] += fy
        left[2] += (x - body.position.x) * fy - (y - body.position.y) * fx
    assert left == pytest.approx([0.0, 0.0, 0.0], abs=1e-7 * 150e3 * 30.0)
    clump = [pull for _, pull in pulls_on(found, {"clump"})]
    assert [sum(each) for each in zip(*clump, strict=True)] == pytest.approx([0.0, 0.0], abs=1e-2)
    # Held where it came to rest, the lines pull on it with minus its load.
    load = hold(network, body.moved).body.load
    assert (load[0], load[1], load[5]) == pytest.approx((-150e3, -60e3, -4e5), rel=1e-6)


def test_stiffness_is_that_of_a_small_more_of_the_load() -> None:
    (body,) = at_rest(barge()).bodies
    columns = []
    for j, step in enumerate((10.0, 10.0, 100.0)):
        moved = []
        for sign in (1.0, -1.0):
            load = [150e3, 60e3, 4e5]
            load[j] += sign * step
            (other,) = at_rest(barge((load[0], load[1]), load[2])).bodies
            moved.append((other.position.x, other.position.y, other.position.yaw))
        columns.append([(a - b) / (2.0 * step) for a, b in zip(*moved, strict=True)])
    # The stiffness times the flexibility is one.
    for i in range(3):
        for j in range(3):
            product = sum(body.stiffness[i][k] * columns[j][k] for k in range(3))
            scale = math.sqrt(body.stiffness[i][i] / body.stiffness[j][j])
            assert product == pytest.approx(float(i == j), abs=1e-4 * max(scale, 1.0)), (i, j)


def test_a_body_astern_of_another_pulls_on_it() -> None:
    # One line ahead of each: the force on the second goes through the hawser into the first, whose
    # line, and the hawser between fairleads of one height, are then known for themselves.
    hawser = Line([Segment(80.0, 120.0, EA=5e7)])
    points = [
        Point("anchor", "anchor", 0.0, 0.0, 0.0),
        Point("bow", "fairlead", 560.0, 0.0, 50.0, body="first"),
        Point("stern", "fairlead", 600.0, 0.0, 50.0, body="first"),
        Point("second bow", "fairlead", 680.0, 0.0, 50.0, body="second"),
    ]
    lines = [LineBetween(CHAIN, "anchor", "bow"), LineBetween(hawser, "stern", "second bow")]
    bodies = (
        MooredBody("first", 580.0, 0.0, (2e5, 0.0)),
        MooredBody("second", 700.0, 0.0, (3e5, 0.0)),
    )
    found = at_rest(Network(Site(50.0), tuple(points), tuple(lines), bodies=bodies))
    mooring = solve_line(CHAIN, height=50.0, horizontal_force=5e5)
    tow = solve_line(hawser, height=50.0, anchor_height=50.0, horizontal_force=3e5)
    first, second = found.bodies
    assert first.position.x == pytest.approx(mooring.span + 20.0, rel=1e-9)
    assert second.position.x == pytest.approx(mooring.span + 40.0 + tow.span + 20.0, rel=1e-9)
    assert found.lines[0].horizontal_force == pytest.approx(5e5, rel=1e-8)
    assert found.lines[1].horizontal_force == pytest.approx(3e5, rel=1e-8)
    with pytest.raises(InputError, match="only one"):
        hold(found.network)


def test_a_body_on_a_line_that_does_not_stretch() -> None:
    """A force of 30 kN on a chain of 1 kN/m: a = 30 m, what hangs is sqrt(h (h + 2 a)) long."""
    points = (
        Point("anchor", "anchor", 0.0, 0.0),
        Point("eye", "fairlead", 10.0, 0.0, 50.0, body="buoy"),
    )
    lines = (LineBetween(Line([Segment(120.0, 1e3)]), "anchor", "eye"),)
    buoy = MooredBody("buoy", 10.0, force=(0.0, 30e3))
    (body,) = at_rest(Network(Site(50.0), points, lines, bodies=(buoy,))).bodies
    hangs = math.sqrt(50.0 * (50.0 + 60.0))
    span = 120.0 - hangs + 30.0 * math.asinh(hangs / 30.0)
    assert (body.position.x, body.position.y) == pytest.approx((0.0, span), abs=1e-6)


def test_a_body_turns_into_the_line_that_holds_it() -> None:
    # Pushed away from its anchor, a body on one line lies behind its fairlead; it is in balance the
    # other way round, too, but does not stay so: the search starts there.
    points = [
        Point("anchor", "anchor", -560.0, 0.0, 0.0),
        Point("bow", "fairlead", 20.0, 0.0, 50.0, body="buoy"),
    ]
    network = Network(
        Site(50.0),
        tuple(points),
        (LineBetween(CHAIN, "anchor", "bow"),),
        bodies=(MooredBody("buoy", force=(3e5, 0.0)),),
    )
    (body,) = at_rest(network).bodies
    span = solve_line(CHAIN, height=50.0, horizontal_force=3e5).span
    assert abs(body.position.yaw) == pytest.approx(math.pi, abs=1e-6)
    assert body.position.x == pytest.approx(span - 560.0 + 20.0, rel=1e-9)


def test_a_body_that_drifts_is_told() -> None:
    # The lines of this body hang slack without a load.
    network = as_points(spread(3, line=Line([Segment(900.0, 1000.0, EA=8e8)])), 50.0)
    report = check_network(network)
    assert "do not hold the body body here" in "\n".join(report.warnings)
    assert "do not hold" not in "\n".join(check_network(barge()).warnings)


def test_the_watch_circle_is_that_of_the_system() -> None:
    system = SYSTEMS["unequal"]
    own = watch_circle(as_points(system, 90.0, (120.0, -35.0)), force=1.5e5, directions=5)
    known = watch_circle(system, force=1.5e5, directions=5)
    assert own.directions == known.directions
    assert own.neutral == pytest.approx((known.neutral[0] + 120.0, known.neutral[1] - 35.0))
    for each, other in zip(own.responses, known.responses, strict=True):
        assert each.offset == pytest.approx(other.offset, rel=1e-8)
        assert each.yaw == pytest.approx(other.yaw, abs=1e-8)
        assert each.largest_tension == pytest.approx(other.largest_tension, rel=1e-8)
        assert each.most_loaded == other.most_loaded
        assert each.largest_anchor_tension == pytest.approx(other.largest_anchor_tension, rel=1e-8)
        assert each.least_grounded == pytest.approx(other.least_grounded, abs=1e-5)
    with pytest.raises(InputError, match="needs one free body"):
        watch_circle(replace(barge(), bodies=(), points=tuple(
            replace(point, body="") for point in barge().points)), force=1e5)  # fmt: skip


@pytest.mark.parametrize("name", ["shipped turret", "turns", "with friction", "unequal"])
def test_the_restoring_curve_is_that_of_the_system(name: str) -> None:
    system = SYSTEMS[name]
    offsets = (-25.0, -3.0, 0.0, 8.0, 30.0)
    network = as_points(system, 90.0, (120.0, -35.0))
    own = restoring_curve(network, direction=0.7, offsets=offsets)
    known = restoring_curve(system, direction=0.7, offsets=offsets)
    assert own.offset == known.offset
    strong = max(map(abs, known.force))
    assert own.force == pytest.approx(known.force, rel=1e-8, abs=1e-8 * strong)
    assert own.force_across == pytest.approx(known.force_across, rel=1e-8, abs=1e-8 * strong)
    for each, other in zip(own.responses, known.responses, strict=True):
        assert each.yaw == pytest.approx(other.yaw, abs=1e-7)
        assert each.offset == pytest.approx(other.offset, rel=1e-9, abs=1e-9)
        # Of a system at a fairlead, here at either end; the fairlead is the higher one.
        assert each.largest_tension == pytest.approx(other.largest_tension, rel=1e-8)
        assert each.most_loaded == other.most_loaded


def test_the_restoring_curve_of_what_is_held_is_the_load_on_it() -> None:
    barged = barge()
    points = tuple(replace(point, body="") for point in barged.points)
    held = replace(barged, bodies=(), points=points)
    curve = restoring_curve(held, direction=math.pi / 2.0, offsets=(-2.0, 0.0, 2.0))
    for offset, along, across in zip(curve.offset, curve.force, curve.force_across, strict=True):
        x, y, *_ = hold(held, (0.0, offset, 0.0, 0.0, 0.0, 0.0)).body.load
        assert (along, across) == pytest.approx((-y, x), rel=1e-9)
    # The body that is free is held by no force where it rests without load.
    free = restoring_curve(barged, direction=0.3, offsets=(0.0,))
    pull = max(line.fairlead.tension for line in at_rest(barged).lines)
    assert (*free.force, *free.force_across) == pytest.approx((0.0, 0.0), abs=1e-8 * pull)
    anchors = tuple(replace(p, kind="anchor") if p.kind == "fairlead" else p for p in points)
    bodies = (*barged.bodies, replace(barged.bodies[0], name="other"))
    apart = tuple(replace(p, body="other" if p.name == "stern port" else p.body)
                  for p in barged.points)  # fmt: skip
    for network in (replace(held, points=anchors), replace(barged, bodies=bodies, points=apart)):
        with pytest.raises(InputError, match="curve needs one free body"):
            restoring_curve(network, direction=0.0, offsets=(1.0,))


def test_a_moment_that_lines_cannot_carry_is_refused() -> None:
    with pytest.raises(NoEquilibriumError, match="on the body barge: it turns over"):
        at_rest(barge(moment=1e11))


def test_each_line_out_moves_the_body_anew() -> None:
    network = barge(checks=Checks(safety_factor=2.0))
    out = each_line_out(network)
    # With a line to an anchor out, the barge rests where a barge moored by the others does.
    gone = out[4]
    assert gone.rest is not None
    left = replace(network, points=tuple(p for p in network.points if p.name not in
                   ("starboard quarter", "stern starboard")), lines=network.lines[:4])  # fmt: skip
    (body,), (again,) = gone.rest.bodies, at_rest(left).bodies
    assert body.position.x == pytest.approx(again.position.x, abs=1e-6)
    assert body.position.yaw == pytest.approx(again.position.yaw, abs=1e-8)
    assert body.position.y != pytest.approx(at_rest(network).bodies[0].position.y, abs=1.0)
    # With the line ahead gone, the crowfoot hangs loose from the bow.
    assert set(out[0].loose) <= {1, 2}
    alone = replace(network, lines=network.lines[3:4], points=(network.points[1],
                    network.points[6]))  # fmt: skip
    (lost,) = each_line_out(alone)
    assert lost.rest is None
    assert "barge" in lost.refusal


def test_a_file_says_bodies() -> None:
    network = replace(barge(), bodies=(replace(barge().bodies[0], moment=0.0, yaw_free=False),))
    text = write_case(network)
    assert "[[bodies]]" in text
    assert parse_network(text) == network


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ('body = "barge"', 'body = "ship"', "no such body"),
        ('name = "barge"', 'name = "ship"', "no fairlead belongs to it"),
        ('kind = "joint"', 'kind = "joint"\nbody = "barge"', "only a fairlead belongs"),
        ("[[bodies]]", '[[bodies]]\nname = "barge"\n\n[[bodies]]', "another has this name"),
        ("[[bodies]]", "[[bodies]]\nyaw_free = false", "must be 0 where the body does not yaw"),
        ('EA = "600000000.0 N"\n', "", "be elastic"),
    ],
)
def test_what_cannot_be_is_refused(old: str, new: str, said: str) -> None:
    text = write_case(barge())
    assert old in text
    with pytest.raises(InputError, match=said):
        parse_network(text.replace(old, new))


def test_a_body_that_no_line_leads_to_an_anchor_is_refused() -> None:
    network = barge()
    tie = LineBetween(CHAIN, "bow port", "stern port")
    points = tuple(p for p in network.points if p.name in ("bow port", "stern port"))
    with pytest.raises(InputError, match="no line leads from here to an anchor"):
        replace(network, points=points, lines=(tie,))


LIES_WITHOUT_LOAD = """
[site]
water_depth = 20.0
seabed_friction = 0.5
[[points]]
name = "a"
kind = "anchor"
x = -100.0
y = 0.0
[[points]]
name = "j"
kind = "joint"
submerged_weight = 20000.0
[[points]]
name = "port"
kind = "fairlead"
x = -10.0
y = 5.0
height = 20.0
body = "barge"
[[points]]
name = "starboard"
kind = "fairlead"
x = -10.0
y = -5.0
height = 20.0
body = "barge"
[[lines]]
start = "a"
end = "j"
[[lines.segments]]
length = 70.0
submerged_weight = 500.0
EA = 1e9
[[lines]]
start = "j"
end = "port"
[[lines.segments]]
length = 40.0
submerged_weight = 300.0
EA = 1e9
[[lines]]
start = "j"
end = "starboard"
[[lines.segments]]
length = 40.0
submerged_weight = 300.0
EA = 1e9
[[bodies]]
name = "barge"
force = [{force}, 0.0]
"""


def test_a_body_is_at_rest_under_its_load_where_it_is_not_without() -> None:
    """Without load the bridle's joint lies on the bed, whose friction leaves its place open."""
    found = at_rest(parse_network(LIES_WITHOUT_LOAD.format(force="300e3")))
    (body,) = found.bodies
    assert all(map(math.isnan, body.offset))
    assert body.zero_load_position is None
    # By hand: all of the pull goes through the one line to the anchor, each rope of the bridle
    # carries half of it along x, and the joint is in balance upwards.
    leg, *bridle = found.joints.ends
    assert leg.state.H == pytest.approx(300e3, rel=1e-9)
    spread = [math.hypot(*each.first[:2]) for each in bridle]
    assert spread == pytest.approx([spread[0]] * 2, rel=1e-9)
    up = leg.second[2] + sum(each.first[2] for each in bridle)
    assert up == pytest.approx(20_000.0, abs=1e-3)
    # On a bed without friction both are found, and the loaded state is the same.
    smooth = LIES_WITHOUT_LOAD.replace("seabed_friction = 0.5", "seabed_friction = 0.0")
    (same,) = at_rest(parse_network(smooth.format(force="300e3"))).bodies
    assert body.position.x == pytest.approx(same.position.x, abs=1e-6)
    assert not math.isnan(same.offset[0])


def test_without_a_load_the_reason_is_told_as_before() -> None:
    with pytest.raises(NoEquilibriumError, match="friction its position is not determined"):
        at_rest(parse_network(LIES_WITHOUT_LOAD.format(force="0.0")))


def test_the_offset_curve_is_that_of_the_system() -> None:
    system, forces = SYSTEMS["unequal"], (-1e5, 0.0, 2e5)
    points = tuple(replace(point, body="") for point in barge().points)
    own = offset_curve(as_points(system, 90.0, (120.0, -35.0)), direction=0.7, forces=forces)
    known = offset_curve(system, direction=0.7, forces=forces)
    assert own.force == known.force == forces
    assert own.offset == pytest.approx(known.offset, rel=1e-7, abs=1e-7)
    assert own.across == pytest.approx(known.across, rel=1e-7, abs=1e-7)
    with pytest.raises(InputError, match="curve needs one free body"):
        offset_curve(replace(barge(), bodies=(), points=points), direction=0.0, forces=forces)


def test_water_levels_are_those_of_the_system() -> None:
    """A body rises with the water, joints do not: those of the system's lines are its loads."""
    system = SYSTEMS["unequal"]
    network = as_points(system, 90.0, (120.0, -35.0))
    for own, known in zip(
        at_levels(network, (-2.0, 3.0)), at_levels(system, (-2.0, 3.0)), strict=True
    ):
        assert own.level == known.level
        assert own.response.offset == pytest.approx(known.response.offset, rel=1e-7)
        assert own.response.largest_tension == pytest.approx(
            known.response.largest_tension, rel=1e-8
        )
        for row, other in zip(own.stiffness, known.stiffness, strict=True):
            assert row == pytest.approx(other, rel=1e-6, abs=1e-6 * own.stiffness[0][0])
    with pytest.raises(InputError, match=r"levels\[0\]"):
        at_levels(network, (-80.0,))
    one = barge()
    two = (*one.bodies, MooredBody("two", -400.0, 160.0))
    points = (*one.points, Point("of two", "fairlead", -400.0, 160.0, 50.0, body="two"))
    lines = (*one.lines, replace(one.lines[3], end="of two"))
    with pytest.raises(InputError, match="level is for one body"):
        at_levels(replace(barge(), bodies=two, points=points, lines=lines), (1.0,))


def test_what_is_held_goes_up_with_the_water() -> None:
    """A metre more of water is a metre of heave; no stiffness is that of a body."""
    points = tuple(replace(point, body="") for point in barge().points)
    network = replace(barge(), bodies=(), points=points)
    (found,) = at_levels(network, (1.0,))
    due = hold(network, (0.0, 0.0, 1.0, 0.0, 0.0, 0.0))
    tensions = [max(line.anchor.tension, line.fairlead.tension) for line in due.lines]
    assert found.response.largest_tension == pytest.approx(max(tensions), rel=1e-9)
    assert found.response.offset == 0.0
    assert found.to_dict()["stiffness_N_per_m"] == [[None, None], [None, None]]


def test_a_float_in_a_current_at_another_level() -> None:
    """By the same file with a metre more of water."""
    case = read_case("cases/instrument-mooring/case.toml")
    (found,) = at_levels(case, (1.0,))
    deeper = replace(case, site=replace(case.site, water_depth=181.0))
    (line,) = at_rest(deeper).lines
    due = max(line.anchor.tension, line.fairlead.tension)
    assert found.response.largest_tension == pytest.approx(due, rel=1e-9)
