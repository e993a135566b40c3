"""``[site] contact_offset``: a line that lies on its own radius is a line on a higher bed."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

from catopt import solve_case, verify_case
from catopt.answers.solution import given_facts
from catopt.casefile import parse_case, write_case
from catopt.errors import InputError
from catopt.model.network import LineBetween, Network, Point

CHAIN = """\
[site]
water_depth = "50 m"
contact_offset = "0.164 m"

[line]
[[line.segments]]
length = "410 m"
submerged_weight = "3323.24 N/m"
mass = "390 kg/m"
EA = "1674 MN"

[load]
span = "400 m"
"""
"""MoorDyn's WD0050; its weight is (390 - pi/4 0.252^2 1025) 9.80665 N/m."""


def test_the_tension_of_orcaflex() -> None:
    """Printed 991.6 and 826.2 kN: 1 % below the line on the bed itself, 0.16 % below this."""
    on_bed = parse_case(CHAIN.replace('contact_offset = "0.164 m"\n', ""))
    lifted, bare = solve_case(parse_case(CHAIN)), solve_case(on_bed)
    assert lifted.fairlead.tension == pytest.approx(991.6e3, rel=1.6e-3)
    assert lifted.anchor.tension == pytest.approx(826.2e3, rel=1.6e-3)
    assert bare.fairlead.tension / 991.6e3 - 1.0 == pytest.approx(0.0102, abs=1e-4)


def test_it_is_a_bed_as_much_higher() -> None:
    """Of the same line on a bed 0.164 m higher; w h = (T - H) (1 + (T + H) / 2 EA) with stretch."""
    higher = CHAIN.replace('contact_offset = "0.164 m"\n', "").replace("50 m", "49.836 m")
    lifted, plain = solve_case(parse_case(CHAIN)), solve_case(parse_case(higher))
    assert lifted.fairlead.tension == pytest.approx(plain.fairlead.tension, rel=1e-12)
    H, T = lifted.horizontal_force, lifted.fairlead.tension
    lift = (T - H) * (1.0 + (T + H) / 2.0 / 1674e6)
    assert lift == pytest.approx(3323.24 * 49.836, rel=1e-9)


def test_ends_on_the_bed_stay_on_it_and_others_are_less_high() -> None:
    on_bed = parse_case(CHAIN)
    assert (on_bed.fairlead_height, on_bed.anchor_height) == (50.0 - 0.164, 0.0)
    assert on_bed.site.water_depth == 50.0 - 0.164
    above = parse_case(
        CHAIN.replace("[line]\n", '[line]\nfairlead_height = "40 m"\nanchor_height = "5 m"\n')
    )
    assert above.fairlead_height == pytest.approx(39.836, abs=1e-12)
    assert above.anchor_height == pytest.approx(4.836, abs=1e-12)


def test_the_file_and_the_facts_keep_what_was_given() -> None:
    case = parse_case(CHAIN.replace("[line]\n", '[line]\nanchor_height = "5 m"\n'))
    written = write_case(case)
    for line in ("water_depth = 50.0", "contact_offset = 0.164", "anchor_height = 5.0"):
        assert line in written.replace('"', "").replace(" m\n", "\n")
    assert parse_case(written) == case
    facts = {str(each.name): each.value for each in given_facts(case)}
    assert facts["Water depth"] == facts["Fairlead height"] == pytest.approx(50.0, abs=1e-12)
    assert facts["Contact offset"] == 0.164


def test_of_a_body_with_several_lines() -> None:
    """Fairleads at the surface of both: the same height over what the lines lie on."""
    system = '[system]\nanchor_radius = "400 m"\nazimuths = ["0 deg", "120 deg", "240 deg"]\n'
    text = CHAIN.replace('[load]\nspan = "400 m"\n', system)
    case = parse_case(text)
    assert case.system is not None
    assert {leg.fairlead_height for leg in case.system.legs} == {50.0 - 0.164}
    assert parse_case(write_case(case)) == case


def test_the_truss_model_lies_as_high() -> None:
    """Both models find 993 kN where OrcaFlex has 991.6: neither lies on the bed itself."""
    (part,) = verify_case(parse_case(CHAIN)).parts
    assert part.verdict == "agrees"
    (pair,) = part.lines
    assert pair.closed is not None
    assert pair.closed.fairlead.tension == pytest.approx(991.6e3, rel=1.6e-3)


@pytest.mark.parametrize(
    ("site", "line", "found"),
    [
        ("contact_offset = 1.2", "", "site.contact_offset: found 1.2"),
        ("contact_offset = -0.1", "", "site.contact_offset: found -0.1"),
        (
            'contact_offset = "0.1 m"\nseabed_slope = "3 deg"',
            "",
            'found "0.1 m"; must be 0 or left',
        ),
        ("contact_offset = 0.2", 'anchor_height = "0.1 m"', "line.anchor_height: found"),
        ("contact_offset = 0.2", 'fairlead_height = "0.2 m"', "line.fairlead_height: found"),
        ("contact_ofset = 0.2", "", "contact_offset"),
    ],
)
def test_what_is_refused(site: str, line: str, found: str) -> None:
    text = CHAIN.replace('contact_offset = "0.164 m"', site).replace(
        "[line]\n", f"[line]\n{line}\n"
    )
    with pytest.raises(InputError) as caught:
        parse_case(text)
    assert len(caught.value.problems) == 1
    assert found in str(caught.value)


def test_lines_with_joints_refuse_it() -> None:
    ends = (Point("a", "anchor", 0.0, 0.0, 0.0), Point("b", "fairlead", 400.0, 0.0, 50.0))
    line = LineBetween(parse_case(CHAIN).line, "a", "b")
    with pytest.raises(InputError, match=r"site\.contact_offset: found 0\.164 m; leave it out"):
        Network(parse_case(CHAIN).site, ends, (line,))


def test_python_refuses_the_same() -> None:
    site = parse_case(CHAIN).site
    with pytest.raises(InputError, match="contact_offset"):
        replace(site, seabed_slope=math.radians(3.0))
    with pytest.raises(InputError, match="contact_offset"):
        replace(site, contact_offset=1.5)
