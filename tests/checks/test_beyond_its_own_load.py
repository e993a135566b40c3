"""What was asked beside the load that a mooring has is in its verdict: levels, sides, floats."""

from __future__ import annotations

from dataclasses import replace

import pytest

from catopt.casefile.reading import parse_mooring
from catopt.checks.result import AtLevels
from catopt.checks.system import check_at_levels, check_network, check_system, with_circle
from catopt.model import Case
from catopt.model.network import Network
from catopt.mooring.restoring import watch_circle

LEGS = [(x, y) for x in (45, -45) for y in (30, -30)]


def pontoon(*, force: str = '["8 kN", "3 kN"]') -> Network:
    """Moor a pontoon of 72 m2 by four lines of 60 m in 30 m of water."""
    text = ['title = "pontoon"', '[site]\nwater_depth = "30 m"\nwater_density = 1000']
    for k, (x, y) in enumerate(LEGS):
        side_x, side_y = 6 if x > 0 else -6, 3 if y > 0 else -3
        text.append(
            f'[[points]]\nname = "a{k}"\nkind = "anchor"\nx = "{x} m"\ny = "{y} m"\n'
            f'[[points]]\nname = "f{k}"\nkind = "fairlead"\nx = "{side_x} m"\ny = "{side_y} m"\n'
            'height = "29.6 m"\nbody = "pontoon"\n'
            f'[[lines]]\nstart = "a{k}"\nend = "f{k}"\n[[lines.segments]]\nlength = "60 m"\n'
            'submerged_weight = "180 N/m"\nEA = "90 MN"\nMBL = "350 kN"'
        )
    text.append(
        f'[[bodies]]\nname = "pontoon"\nforce = {force}\nwaterplane_area = "72 m^2"\n'
        'draught = "0.5 m"\nfreeboard = "0.6 m"\n[checks]\nsafety_factor = 3'
    )
    found = parse_mooring("\n".join(text))
    assert isinstance(found, Network)
    return found


def at_levels(*levels: float) -> AtLevels:
    network = pontoon()
    return check_at_levels(check_network(network), check_network, network, levels)


def test_a_level_that_fails_is_no_green() -> None:
    """Four lines of 60 m cannot reach 43 m of water with 39 m across: 171.7 kN of 116.7 kN.

    They hold the pontoon under with its whole reserve, 72 m2 x 0.6 m x 9.80665 kN/m3 = 423.6 kN.
    """
    assert at_levels().whole.judgement.passes
    found = at_levels(13.0)
    assert found.whole.judgement.colour == "red"
    assert "water level 13.000 m" in found.whole.judgement.governing
    (other,) = found.others
    pulled = next(each for each in other.results if each.kind == "buoyancy")
    assert pulled.demand == pytest.approx(72.0 * 0.6 * 9806.65, rel=1e-6)
    assert not pulled.passes
    assert other.used() == pytest.approx(171.739e3 / (350e3 / 3.0), rel=1e-5)


def test_every_check_of_a_level_is_there_with_its_level() -> None:
    found = at_levels(-2.0, 1.0)
    own = check_network(pontoon())
    assert len(found.whole.results) == 3 * len(own.results)
    assert [str(each.load_case) for each in found.whole.results[: len(own.results)]] == [
        str(each.load_case) for each in own.results
    ]
    assert all("water level -2.000 m" in str(each.load_case) for each in found.whole.results[
        len(own.results) : 2 * len(own.results)
    ])  # fmt: skip


def test_a_body_of_a_system_is_checked_at_its_levels() -> None:
    """Its fairleads rise with the water, and so does the load on its lines."""
    case = parse_mooring(SYSTEM)
    assert isinstance(case, Case)
    own = check_system(case)
    found = check_at_levels(own, check_system, case, [4.0])
    assert len(found.whole.results) == 2 * len(own.results)
    (other,) = found.others
    assert (other.used() or 0.0) > (own.used() or 0.0)


SYSTEM = """
[site]
water_depth = "20 m"
[line]
fairlead_height = "20 m"
[[line.segments]]
length = "60 m"
submerged_weight = "1 kN/m"
EA = "500 MN"
MBL = "3 MN"
[system]
anchor_radius = "52 m"
azimuths = ["0 deg", "120 deg", "240 deg"]
force = ["50 kN", "0 kN"]
[checks]
safety_factor = 2
"""


def test_a_load_that_is_harder_from_another_side_is_not_judged() -> None:
    """Along x two lines share the load; towards one line it carries it alone."""
    network = pontoon(force='["75 kN", "0 kN"]')
    checks = check_network(network)
    circle = watch_circle(network, force=75e3, directions=12)
    found = with_circle(checks, circle).judgement
    assert checks.judgement.passes
    assert [each.subject for each in found.not_judged if each.subject == "directions"]
    assert found.colour == "amber"


def test_a_circle_that_is_nowhere_harder_changes_nothing() -> None:
    network = pontoon(force='["75 kN", "0 kN"]')
    checks = check_network(network)
    circle = watch_circle(network, force=75e3, directions=12)
    softer = replace(circle, responses=(circle.responses[0],) * 12)
    own = max(s.max_tension for _, each in checks.solutions[:4] for s in each.segments)
    assert softer.responses[0].largest_tension == pytest.approx(own, rel=1e-9)
    assert with_circle(checks, softer) is checks
    assert with_circle(checks, None) is checks


HUB = """
title = "tripod"
[site]
water_depth = "20 m"
[[points]]
name = "hub"
kind = "joint"
submerged_weight = "-6 kN"
mass = "150 kg"
FLOAT
force = ["9 kN", "0 kN", "0 kN"]
"""


def hub(height: str) -> Network:
    """Hold a float of 6 kN by three lines of 46 m of which two carry 9 kN, and take it under."""
    text = [HUB.replace("FLOAT", height)]
    for k, (x, y) in enumerate([(40, 0), (-20, 34.6), (-20, -34.6)]):
        text.append(
            f'[[points]]\nname = "a{k}"\nkind = "anchor"\nx = "{x} m"\ny = "{y} m"\n'
            f'[[lines]]\nstart = "a{k}"\nend = "hub"\n[[lines.segments]]\nlength = "46 m"\n'
            'submerged_weight = "100 N/m"\nEA = "50 MN"\nMBL = "250 kN"'
        )
    found = parse_mooring("\n".join([*text, "[checks]\nsafety_factor = 3"]))
    assert isinstance(found, Network)
    return found


def test_a_float_that_is_dragged_under_fails() -> None:
    """One with a height is meant to float; without one it may be meant to lie below."""
    found = check_network(hub('float_height = "1 m"'))
    assert found.judgement.colour == "red"
    worst = found.failed[0]
    assert worst.kind == "buoyancy"
    assert "hub" in str(worst.name)
    assert worst.demand == pytest.approx(6e3, rel=1e-9)
    assert "under water" in str(worst.note)
    assert not [each for each in check_network(hub("")).results if each.kind == "buoyancy"]
