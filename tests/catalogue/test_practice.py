"""What makers lay and ships carry is as printed; what was only recalled decides nothing."""

from __future__ import annotations

import itertools

import pytest

from catopt.catalogue.practice import (
    condition,
    equipment,
    equipment_number,
    equipment_rows,
    laid_for_buoy,
    practice_of_buoy,
    practice_of_ship,
)
from catopt.errors import InputError
from catopt.words import say

KNOT = 1852.0 / 3600.0


@pytest.mark.parametrize(
    ("depth", "knots", "chain", "least", "most"),
    [
        # Nautilus-2200, page 11: size by depth; 2, 2.5 or 3 depths by current, 3 to 50 m deep only.
        (10.0, 1.0, 44.0, 20.0, 30.0),
        (10.0, 2.0, 44.0, 25.0, 30.0),
        (18.0, 3.0, 38.0, 45.0, 54.0),
        (28.0, 5.0, 32.0, 84.0, 84.0),
        (28.0, 6.0, 32.0, 84.0, 84.0),
        (60.0, 1.0, 22.0, 120.0, 150.0),
        # Where two rows meet.
        (14.0, 1.0, 44.0, 28.0, 42.0),
        (50.0, 1.0, 25.0, 100.0, 150.0),
    ],
)
def test_the_maker_s_table_of_chain(
    depth: float, knots: float, chain: float, least: float, most: float
) -> None:
    laid = laid_for_buoy(2.2, depth, knots * KNOT)
    assert laid is not None
    assert laid.is_of_size
    assert laid.chain == chain * 1e-3
    assert laid.lengths == (least, most)
    assert (laid.shackle, laid.swivel, laid.bridle_shackle) == (0.038, 0.038, 0.032)
    assert laid.origin.confidence == "A"


@pytest.mark.parametrize(("depth", "knots"), [(5.9, 1.0), (76.0, 1.0), (10.0, 6.1), (60.0, 4.1)])
def test_beyond_the_table_nothing_is_said(depth: float, knots: float) -> None:
    assert laid_for_buoy(2.2, depth, knots * KNOT) is None
    said = practice_of_buoy(0.03, 30.0, buoy_diameter=2.2, depth=depth, current=knots * KNOT)
    assert said.laid is None
    assert said.message.startswith("no maker's table was read for ")


def test_another_size_of_buoy_is_said_to_be_outside() -> None:
    said = practice_of_buoy(
        0.02, 68.0, buoy_diameter=2.4, depth=10.0, current=1.0, chain_limits=(0.02, 0.05)
    )
    assert said.laid is not None
    assert not said.laid.is_of_size
    assert said.message == (
        "the buoy's own entry has chain of 20 to 50 mm; compared with the 20 to 30 m laid for a "
        "buoy of 2.2 m here this is longer; no table for its own size was read"
    )
    thin = practice_of_buoy(
        0.018, 25.0, buoy_diameter=2.4, depth=10.0, current=1.0, chain_limits=(0.02, 0.05)
    )
    assert thin.message.count("this is thinner;")  # than its own entry has


@pytest.mark.parametrize(
    ("diameter", "length", "verdict", "vi"),
    [
        (0.044, 25.0, "as laid", "như thực tế"),
        (0.038, 30.0, "thinner", "mảnh hơn"),
        (0.050, 19.0, "heavier and shorter", "nặng hơn và ngắn hơn"),
        (0.044, 31.0, "longer", "dài hơn"),
    ],
)
def test_a_buoy_s_chain_beside_practice(
    diameter: float, length: float, verdict: str, vi: str
) -> None:
    said = practice_of_buoy(diameter, length, buoy_diameter=2.2, depth=10.0, current=1.0).message
    assert said == f"makers of a 2.2 m buoy lay 44 mm and 20 to 30 m here: this is {verdict}"
    assert say(said, "vi").endswith(f"phương án này {vi}")


def test_the_equipment_number_of_a_tanker_of_50_000_dwt() -> None:
    """By hand: 210 x 32.2 m, 12.6 m of draught, 3.8 m of freeboard, a house 15 m high, 25 m long.

    Displacement 0.8 x 0.97 x 210 x 32.2 x 12.6 x 1.025 = 67,769 t, to 2/3: 1662.2; 2 x 32.2 x 18.8
    = 1210.7; (210 x 3.8 + 375)/10 = 117.3.
    """
    front, side = 32.2 * 18.8, 210.0 * 3.8 + 375.0
    displacement = 0.8 * 0.97 * 210.0 * 32.2 * 12.6 * 1025.0
    number = 1662.2 + 1210.7 + 117.3
    assert equipment_number(displacement, front, side) == pytest.approx(number, abs=0.2)
    own = equipment(displacement, front, side)
    assert own.row is not None
    assert own.decides
    assert own.row.stockless == 8700.0
    assert own.row.grades == (0.095, 0.084, 0.073)
    assert own.row.high_holding == 6525.0  # as printed
    assert own.row.origin.confidence == "C"
    said = practice_of_ship(0.036, 302.5, displacement=displacement, front=front, side=side)
    assert said.message == (
        "her own cable: 73 mm Grade 3, 316.2 m, anchor 8.7 t stockless (EN 2,990): "
        "this is thinner and shorter"
    )


@pytest.mark.parametrize(
    ("above", "up_to", "mass", "high_holding", "length", "grades"),
    [
        # As printed.
        (205, 240, 660, 495, 302.5, (26, 22, 20.5)),
        (980, 1060, 3060, 2295, 495, (56, 50, 44)),
        (1480, 1570, 4590, 3445, 550, (68, 60, 52)),
        (2530, 2700, 7800, 5850, 632.5, (90, 78, 68)),
        (3210, 3400, 9900, 7425, 660, (100, 87, 78)),
    ],
)
def test_rows_as_printed(
    above: float,
    up_to: float,
    mass: float,
    high_holding: float,
    length: float,
    grades: tuple[float, float, float],
) -> None:
    (row,) = (each for each in equipment_rows() if each.above == above)
    assert (row.up_to, row.stockless, row.length) == (up_to, mass, length)
    assert row.high_holding == pytest.approx(high_holding, abs=5.0)  # printed to 5 kg
    assert row.grades == pytest.approx([each * 1e-3 for each in grades], rel=1e-15)


def test_the_rows_that_were_read_have_no_gap_and_rise() -> None:
    read = [each for each in equipment_rows() if not each.origin.is_recalled]
    for low, high in itertools.pairwise(read):
        assert low.up_to == high.above
        assert low.stockless < high.stockless
        assert low.length <= high.length
        assert all(a <= b for a, b in zip(low.grades, high.grades, strict=True))
        assert low.grades[0] > low.grades[1] > low.grades[2]
    assert (read[0].above, read[-1].up_to) == (50.0, 3400.0)


def number_of(number: float) -> dict[str, float]:
    """Figures of a ship of an equipment number, 600 and 100 of it of what the wind sees."""
    return {"displacement": (number - 700.0) ** 1.5 * 1e3, "front": 300.0, "side": 1000.0}


def test_a_recalled_row_says_so_and_decides_nothing() -> None:
    own = equipment(**number_of(3700.0))
    assert own.number == pytest.approx(3700.0)
    assert own.row is not None
    assert own.row.origin.is_recalled
    assert not own.decides
    said = practice_of_ship(0.08, 300.0, **number_of(3700.0)).message
    assert said.startswith("her own cable, as recalled (R): 81 mm Grade 3")
    assert "theo trí nhớ (R)" in say(said, "vi")


def test_between_the_rows_nothing_is_said() -> None:
    said = practice_of_ship(0.08, 300.0, **number_of(4000.0))
    assert said.equipment is not None
    assert said.equipment.row is None
    assert not said.equipment.decides
    assert said.message == "no row of the table of equipment was read for this ship (EN 4,000)"


def test_used_chain_is_discarded_below_four_fifths() -> None:
    assert (condition().good, condition().discard) == (0.9, 0.8)


def test_what_cannot_be_is_refused_at_once() -> None:
    with pytest.raises(InputError) as refused:
        laid_for_buoy(0.0, -1.0, -0.1)
    assert [each.key for each in refused.value.problems] == ["buoy_diameter", "depth", "current"]
    with pytest.raises(InputError) as refused:
        equipment(0.0, 0.0, 0.0)
    assert [each.key for each in refused.value.problems] == ["displacement", "front", "side"]
