"""Fatigue of lines between points: that of the same line by itself."""

from __future__ import annotations

import pytest

from catopt import InputError
from catopt.casefile.reading import parse_case, parse_network
from catopt.verify.fatigue import verify_fatigue

SITE = '[site]\nwater_depth = "20 m"\nseabed_friction = 0.5\n'
SEGMENT = """segments]]
component = "chain studless R3"
diameter = "76 mm"
length = "120 m"
"""
SEA = """
[service]
life = "20 years"
wear_rate = "0.4 mm/year"

[waves]
spectrum = "regular"
height = "2 m"
period = "8 s"

[motion]
period = "8 s"
surge = "0.5 m"
heave = "0.5 m"

[dynamics]
duration = "32 s"
ramp = "16 s"
elements = 10

[fatigue]
code = "DNV-OS-E301-2008"

[[fatigue.sea_states]]
height = "2 m"
period = "8 s"
time_per_year = "2000 h"
"""
POINTS = f"""{SITE}
[[points]]
name = "anchor"
kind = "anchor"
x = "0 m"
y = "0 m"

[[points]]
name = "buoy"
kind = "fairlead"
x = "117.20 m"
y = "0 m"
height = "20 m"

[[lines]]
start = "buoy"
end = "anchor"

[[lines.{SEGMENT}{SEA}"""
LINE = f'{SITE}[line]\n[[line.{SEGMENT}[load]\nspan = "117.20 m"\n{SEA}'


@pytest.mark.slow  # two runs in time, each as plain Python
def test_a_line_between_points_is_damaged_as_it_is_by_itself() -> None:
    (own,) = verify_fatigue(parse_network(POINTS), convergence_check="none").segments
    (due,) = verify_fatigue(parse_case(LINE), convergence_check="none").segments
    assert own.line == 1
    assert due.damage > 0.0
    assert own.damage == pytest.approx(due.damage, rel=1e-6)
    assert own.along == pytest.approx(due.along, abs=1e-9)
    assert own.utilisation == pytest.approx(due.utilisation, rel=1e-6)


def test_what_fatigue_needs_of_other_sections_is_named() -> None:
    without = POINTS.split("[service]")[0] + "[dynamics]" + POINTS.split("[dynamics]")[1]
    with pytest.raises(InputError, match=r"needs \[waves\](.|\n)*needs \[service\]"):
        parse_network(without)
    curve = '\n[[fatigue.curves]]\nsegment = 2\nname = "E301 stud"\n'
    with pytest.raises(InputError, match=r"fatigue.curves\[0\].segment"):
        parse_network(POINTS + curve)
