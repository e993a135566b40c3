"""A file of points and lines is refused with all its errors at once."""

from __future__ import annotations

import pytest

from catopt import InputError
from catopt.casefile.reading import parse_network

FILE = """
[site]
water_depth = "10 m"
[[points]]
name = "A"
kind = "anchor"
x = "0 m"
y = "0 m"
[[points]]
name = "B"
kind = "fairlead"
x = "5 m"
y = "0 m"
height = "3 m"
[[lines]]
start = "A"
end = "B"
[[lines.segments]]
length = "8 m"
submerged_weight = "100 N/m"
EA = "1e8 N"
[[lines]]
start = "B"
end = "A"
[[lines.segments]]
length = "8 m"
submerged_weight = "100 N/m"
[[lines.point_loads]]
position = "4 m"
submerged_weight = "5 N"
"""

UNIT = ('EA = "1e8 N"', 'EA = "1e8"')
NAMED_TWICE = ('name = "B"', 'name = "A"')
NO_SUCH_END = ('start = "A"\nend = "B"', 'start = "A"\nend = "Z"')
NO_HEIGHT = ('height = "3 m"\n', "")
BEYOND = ('position = "4 m"', 'position = "9 m"')


def keys_of(*changes: tuple[str, str]) -> list[str]:
    text = FILE
    for old, new in changes:
        assert old in text
        text = text.replace(old, new, 1)
    with pytest.raises(InputError) as refused:
        parse_network(text)
    return [problem.key for problem in refused.value.problems]


def test_a_unit_hides_neither_a_name_nor_an_end() -> None:
    assert keys_of(UNIT, NAMED_TWICE, NO_SUCH_END) == [
        "points[1].name",
        "lines[0].end",
        "lines[0].segments[0].EA",
        "lines[1].start",
    ]


def test_what_the_model_refuses_of_other_parts_is_told_beside() -> None:
    """The second line has the number that it has in the file, the first being unread."""
    assert keys_of(UNIT, NO_HEIGHT, BEYOND) == [
        "points[1].height",
        "lines[0].segments[0].EA",
        "lines[1].point_loads[0].position",
    ]
    assert keys_of(NO_HEIGHT, BEYOND, NO_SUCH_END) == [
        "points[1].height",
        "lines[0].end",
        "lines[1].point_loads[0].position",
    ]


def test_an_end_is_not_missed_where_a_name_is_unread() -> None:
    """The point that it names may be the one whose name is not read."""
    assert keys_of(UNIT, ('name = "B"', "name = 7")) == [
        "points[1].name",
        "lines[0].segments[0].EA",
    ]
