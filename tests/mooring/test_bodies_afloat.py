"""Bodies that float deeper as their lines pull: draught, freeboard, under water, on the bed."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from catopt import InputError, Line, NoEquilibriumError, Segment, solve
from catopt.answers.blocks import Table, Text
from catopt.answers.check import check_answer, kind_name
from catopt.answers.floats import afloat_on_card
from catopt.answers.note_system import network_note_answer
from catopt.answers.system import network_answer
from catopt.casefile.reading import parse_network
from catopt.casefile.writing import write_case
from catopt.checks.system import check_network
from catopt.constants import STANDARD_GRAVITY as G
from catopt.model import CurrentProfile, Site
from catopt.model.load import Checks
from catopt.model.network import LineBetween, MooredBody, Network, Point, PointKind
from catopt.mooring.case import at_levels
from catopt.mooring.fixed_body import at_rest
from catopt.mooring.many import solve_network_many
from catopt.mooring.network_rest import LinesAtRest
from catopt.notes.origin import Asked
from catopt.notes.system import NetworkNote, read_network_note
from catopt.verify.case import verify_network
from catopt.words import say

RHO = 1000.0
ROPE = Segment(70.0, 100.0, EA=2e6, MBL=5e5, drag_diameter=0.04, drag_normal=1.2)
WATERPLANE: dict[str, Any] = {"waterplane_area": 30.0, "draught": 0.5, "freeboard": 0.7}


def raft(
    depth: float = 40.0, friction: float = 0.0, force: tuple[float, float] = (4e3, 1e3), **own: Any
) -> Network:
    """Moor a raft by a rope to each of four anchors, two of them up on a bank."""
    corners = [(5.0, 3.0, 50.0, 30.0, 0.0), (-5.0, 3.0, -45.0, 30.0, 0.0)]
    corners += [(-5.0, -3.0, -40.0, -28.0, 30.0), (5.0, -3.0, 42.0, -28.0, 35.0)]
    points, lines = [], []
    for k, (x, y, u, v, z) in enumerate(corners):
        points.append(Point(f"anchor {k}", "anchor", u, v, z))
        points.append(Point(f"corner {k}", "fairlead", x, y, depth - 0.2, body="raft"))
        lines.append(LineBetween(Line([ROPE]), f"anchor {k}", f"corner {k}"))
    site = Site(depth, friction, water_density=RHO)
    body = MooredBody("raft", force=force, **own)
    return Network(
        site, tuple(points), tuple(lines), bodies=(body,), checks=Checks(safety_factor=3.0)
    )


def pull_down(found: LinesAtRest) -> float:
    """Sum the vertical pull at the corners, each line solved alone between its ends."""
    total = 0.0
    for run in found.runs:
        low, high = (found.joints.places[k] for k in (run.first, run.second))
        total += solve(
            run.line, height=high[2], anchor_height=low[2], span=math.dist(low[:2], high[:2])
        ).fairlead.vertical_force
    return total


def test_a_raft_floats_deeper_by_what_its_lines_pull() -> None:
    found = at_rest(raft(**WATERPLANE))
    (body,) = found.bodies
    floating = body.floating
    assert floating.draught is not None
    assert floating.freeboard is not None
    deeper = pull_down(found) / (RHO * G * 30.0)
    assert deeper > 0.02
    assert floating.draught == pytest.approx(0.5 + deeper, abs=1e-9)
    assert floating.freeboard == pytest.approx(0.7 - deeper, abs=1e-9)
    assert found.place_of("corner 2")[2] == pytest.approx(39.8 - deeper, abs=1e-9)
    assert floating.reserve == pytest.approx(RHO * G * 30.0 * 0.7)
    assert floating.pull == pytest.approx(pull_down(found), rel=1e-9)
    assert body.moved[2] == pytest.approx(-deeper)
    assert floating.under is False
    assert found.residual < 1e-3


def test_a_taut_leg_shares_the_rise_of_the_water_with_the_float() -> None:
    # A bar of EA / L straight down, 0.1 m short: EA / L (0.1 - s) = rho g A s.
    tether = Line([Segment(9.9, 1e-6, EA=1e6)])
    points = (
        Point("anchor", "anchor", 0.0, 0.0),
        Point("eye", "fairlead", 0.0, 0.0, 10.0, body="b"),
    )
    body = MooredBody("b", waterplane_area=5.0, draught=0.4, freeboard=0.6)
    network = Network(
        Site(10.0, water_density=RHO),
        points,
        (LineBetween(tether, "anchor", "eye"),),
        bodies=(body,),
    )
    (found,) = at_rest(network).bodies
    water, bar = RHO * G * 5.0, 1e6 / 9.9
    sunk = 0.1 * bar / (bar + water)
    assert found.floating.draught == pytest.approx(0.4 + sunk, abs=1e-7)
    assert found.floating.left == pytest.approx(water * (0.6 - sunk), rel=1e-6)


def test_what_its_lines_take_under_carries_all_its_reserve_and_fails() -> None:
    small = replace(raft(**WATERPLANE | {"waterplane_area": 0.4}), title="Small raft")
    found = at_rest(small)
    (body,) = found.bodies
    floating = body.floating
    assert floating.freeboard is not None
    assert floating.under is True
    assert floating.pull == pytest.approx(RHO * G * 0.4 * 0.7, rel=1e-6)
    assert found.place_of("corner 0")[2] == pytest.approx(39.8 - 0.7 + floating.freeboard)
    report = check_network(small, found)
    (failed,) = (each for each in report.failed if each.place.state == "intact")
    assert (failed.kind, failed.name) == ("buoyancy", "vertical pull on raft")
    assert failed.note == f"under water by {-floating.freeboard:.3f} m"
    answer = network_answer(found, [], report, [])
    first, *_ = answer.card
    assert isinstance(first, Text)
    assert f"{first.said}".startswith("Pulled under water by their lines: raft by")
    (table,) = (each for each in answer.blocks if getattr(each, "name", "") == "floating")
    assert isinstance(table, Table)
    assert table.to_dataframe()["Freeboard (m)"].tolist() == [floating.freeboard]


def test_a_reserve_alone_is_held_against_the_pull_at_the_given_height() -> None:
    found = at_rest(raft(reserve_buoyancy=20e3))
    kept = at_rest(raft())
    assert found.joints == kept.joints
    (body,) = found.bodies
    pull = pull_down(found)
    assert (body.floating.pull, body.floating.left) == pytest.approx((pull, 20e3 - pull))
    assert body.floating.freeboard is None
    for reserve, passes in ((1.001 * pull, True), (0.999 * pull, False)):
        network = raft(reserve_buoyancy=reserve)
        ours = at_rest(network)
        assert ours.bodies[0].floating.under is not passes
        report = check_network(network, ours, ())
        (check,) = (each for each in report.results if each.kind == "buoyancy")
        assert check.passes is passes
        assert (check.demand, check.capacity) == pytest.approx((pull, reserve))


def test_a_verdict_names_what_is_not_known_of_a_body() -> None:
    subjects = {
        name: [each.subject for each in check_network(raft(**own)).judgement.not_judged]
        for name, own in (("none", {}), ("reserve", {"reserve_buoyancy": 1e5}), ("all", WATERPLANE))
    }
    assert subjects == {"none": ["reserve"], "reserve": [], "all": []}


def test_stiffness_has_the_body_follow_in_height() -> None:
    step, network = 0.5, raft(**WATERPLANE)
    (body,) = at_rest(network).bodies
    moved = []
    for x, y, m in ((step, 0.0, 0.0), (0.0, step, 0.0), (0.0, 0.0, 5.0 * step)):
        places = []
        for sign in (1.0, -1.0):
            loaded = MooredBody("raft", force=(4e3 + sign * x, 1e3 + sign * y), moment=sign * m)
            other = replace(loaded, **WATERPLANE)
            (there,) = at_rest(replace(network, bodies=(other,))).bodies
            places.append([there.position.x, there.position.y, there.position.yaw])
        moved.append(np.subtract(places[0], places[1]) / (2.0 * max(x, y, m)))
    assert np.linalg.inv(body.stiffness) == pytest.approx(np.array(moved).T, rel=2e-4, abs=1e-10)


def test_many_loads_and_levels_have_it_float_as_one_load_does() -> None:
    network = raft(**WATERPLANE)
    loads = [(4e3, 1e3, 0.0), (-8e3, 2e3, 1e3), (0.0, 0.0, 0.0)]
    many = solve_network_many(network, force=np.array([[each] for each in loads]))
    assert not many.reasons
    for k, (x, y, m) in enumerate(loads):
        own = replace(network.bodies[0], force=(x, y), moment=m)
        (single,) = at_rest(replace(network, bodies=(own,))).bodies
        place = (single.position.x, single.position.y, single.position.yaw)
        assert many.position[k, 0] == pytest.approx(place, abs=1e-7)
    for level in (-5.0, 1.5):
        (found,) = at_levels(network, [level])
        there = at_rest(raft(40.0 + level, **WATERPLANE)).bodies[0].position
        assert (found.response.x, found.response.y) == pytest.approx((there.x, there.y), abs=1e-7)


def test_the_truss_model_has_it_at_the_same_height() -> None:
    assert verify_network(raft(**WATERPLANE), elements=30, tolerance=1e-3).verdict == "agrees"


def test_in_a_current_it_floats_by_the_pull_of_its_lines_there() -> None:
    current = CurrentProfile("table", depths=(0.0, 40.0), speeds=(0.8, 0.8))
    found = at_rest(replace(raft(**WATERPLANE), current=current))
    (body,) = found.bodies
    pull = math.fsum(line.fairlead.vertical_force for line in found.lines)
    assert body.floating.draught == pytest.approx(0.5 + pull / (RHO * G * 30.0), abs=1e-7)
    assert body.floating.pull == pytest.approx(pull, rel=1e-9)


def test_a_raft_that_the_water_leaves_lies_on_the_bed() -> None:
    ends: list[tuple[str, PointKind, float, float]] = [
        ("a", "anchor", 20.0, 0.0),
        ("c", "fairlead", 2.0, 0.3),
    ]
    points = tuple(
        Point(f"{name} {k}", kind, x * sign, 0.0, z, body="b" if kind == "fairlead" else "")
        for k, sign in enumerate((1.0, -1.0))
        for name, kind, x, z in ends
    )
    line = Line([Segment(18.2, 50.0, EA=1e6)])
    lines = tuple(LineBetween(line, f"a {k}", f"c {k}") for k in (0, 1))
    body = MooredBody("b", waterplane_area=8.0, draught=0.5, freeboard=0.5)
    network = Network(Site(0.3, water_density=RHO), points, lines, bodies=(body,))
    found = at_rest(network)
    floating = found.bodies[0].floating
    # 0.2 m of its draught are missing: the bed carries that much of its weight, and the lines.
    assert floating.draught == pytest.approx(0.3, abs=1e-12)
    assert floating.freeboard == pytest.approx(0.7)
    assert floating.bed_reaction == pytest.approx(RHO * G * 8.0 * 0.2 + floating.pull, rel=1e-9)
    with pytest.raises(NoEquilibriumError, match="the body b lies on the bed"):
        at_rest(replace(network, site=replace(network.site, seabed_friction=0.3)))


def test_lines_from_banks_above_lift_a_raft() -> None:
    low = at_rest(raft(20.0, **WATERPLANE))
    floating = low.bodies[0].floating
    assert floating.pull == pytest.approx(pull_down(low), abs=1e-3)
    assert floating.draught == pytest.approx(0.5 + floating.pull / (RHO * G * 30.0), abs=1e-9)


@pytest.mark.parametrize("own", [WATERPLANE, {"reserve_buoyancy": 20e3}])
def test_a_pull_upwards_is_said_to_lift(own: dict[str, Any]) -> None:
    network = raft(8.0, **own)
    points = [replace(p, height=30.0) if p.kind == "anchor" else p for p in network.points]
    lines = []
    for line, bank, corner in zip(network.lines, points[::2], points[1::2], strict=True):
        rope = replace(ROPE, length=1.001 * math.dist(bank.place, corner.place))
        lines.append(replace(line, line=Line([rope])))
    found = at_rest(replace(network, points=tuple(points), lines=tuple(lines)))
    pull = found.bodies[0].floating.pull
    assert pull < 0.0
    (text,) = afloat_on_card(found)
    assert f"lifted with {-pull / 1e3:.3f} kN" in f"{text.said}"
    assert "in reserve" not in f"{text.said}"
    assert f"bị nhấc lên {-pull / 1e3:.3f} kN" in say(text.said, "vi")


@pytest.mark.parametrize(
    ("own", "key", "said"),
    [
        ({"draught": 0.5}, "freeboard", "say together how a body floats"),
        ({**WATERPLANE, "reserve_buoyancy": 1e3}, "reserve_buoyancy", "leave it out"),
        ({"waterplane_area": 0.0}, "waterplane_area", "above 0"),
    ],
)
def test_what_does_not_go_together_is_refused_by_name(
    own: dict[str, Any], key: str, said: str
) -> None:
    with pytest.raises(InputError) as error:
        MooredBody("raft", **own)
    assert any(each.key == key and said in each.allowed for each in error.value.problems)


def test_a_file_keeps_it() -> None:
    for own in (WATERPLANE, {"reserve_buoyancy": 2e4}):
        network = raft(**own)
        assert parse_network(write_case(network)) == network


HUB = """
title = "Float on three legs"
[site]
water_depth = "20 m"
[[points]]
name = "hub"
kind = "joint"
submerged_weight = "-6 kN"
mass = "150 kg"
float_height = "1 m"
[checks]
safety_factor = 3
""" + "".join(
    f"""
[[points]]
name = "a{k}"
kind = "anchor"
x = "{x} m"
y = "{y} m"
[[lines]]
start = "a{k}"
end = "hub"
segments = [{{length = "25 m", submerged_weight = "400 N/m", EA = "50 MN", MBL = "250 kN"}}]
"""
    for k, (x, y) in enumerate([(20, 0), (-10, 17), (-10, -17)])
)
"""Its lines weigh more than it floats: it hangs on them below the surface."""


def note_of(tmp_path: Path, text: str) -> tuple[NetworkNote, str, list[str]]:
    """Compute a note; what it begins with, and all that it says in its sections."""
    place = tmp_path / "case.toml"
    place.write_text(text, encoding="utf-8")
    note = read_network_note(place, Asked(verify=False))
    answer = network_note_answer(note)
    every = [f"{each.said}" for each in answer.blocks if isinstance(each, Text)]
    return note, every[0], every


@pytest.mark.parametrize("of", ["raft", "sunken raft", "hub"])
def test_a_note_says_what_is_free_and_first_what_is_under_water(tmp_path: Path, of: str) -> None:
    area = {"raft": 40.0, "sunken raft": 0.4}.get(of)
    text = HUB
    if area is not None:
        own = raft(**WATERPLANE | {"waterplane_area": area})
        text = write_case(replace(own, title=of, checks=Checks(safety_factor=3.0)))
    note, head, every = note_of(tmp_path, text)
    said = " ".join(every)
    assert "held" not in said  # no case here holds anything
    assert ("bodies (raft)" in said) is (of != "hub")
    assert ("equilibrium: joints" in said) is (of == "hub")
    under = {
        "raft": "",
        "sunken raft": "Pulled under water by their lines: raft by ",
        "hub": "Under water, with all their buoyancy in use: hub by ",
    }[of]
    if under:
        assert head.startswith(under)
        assert f"{note.warnings[0]}" == head
        (card, *_) = check_answer(note.checks, of_points=True).card
        assert isinstance(card, Text)
        assert f"{card.said}" == head
        assert note.checks.to_dict()["warnings"][0] == head
    else:
        assert "nder water" not in said
    (limits,) = (
        each
        for each in network_note_answer(note).blocks
        if isinstance(each, Table) and each.name == "limit_states"
    )
    assert isinstance(limits, Table)
    named = {f"{each}" for each in limits.columns[1].values}
    counted = {f"{kind_name(each.kind)}" for each in note.checks.results}
    assert named == counted
    assert "Reserve buoyancy" in named


@pytest.mark.parametrize(
    ("depth", "said"),
    [
        (40.0, ""),
        (40.3, ""),  # 0.5 m below the water: at the keel
        (45.4, "fairleads corner 0, corner 1, corner 2, corner 3 are below the keel of raft, by "),
        (39.0, "fairleads corner 0, corner 1, corner 2, corner 3 are above the deck of raft, by "),
    ],
)
def test_fairleads_beyond_keel_and_deck_are_remarked_on(depth: float, said: str) -> None:
    """They are 39.8 m above the bed; the raft reaches from 0.5 m below the water to 0.7 m above."""
    own = raft(**WATERPLANE)
    own = replace(own, site=replace(own.site, water_depth=depth))
    warned = [f"{each}" for each in check_network(own).warnings if "fairleads corner" in f"{each}"]
    by = {45.4: 45.4 - 39.8 - 0.5, 39.0: 39.8 - 39.0 - 0.7}.get(depth)
    assert len(warned) == (by is not None)
    if by is not None:
        assert warned[0].startswith(f"{said}up to {by:.4g} m")
