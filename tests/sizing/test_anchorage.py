"""What holds a line: the sinkers that are cast, the factor that counts, and whose it is."""

from __future__ import annotations

import pytest

from catopt.constants import STANDARD_GRAVITY
from catopt.errors import NoAnswerError
from catopt.sizing import DragGround, SinkerGround

WATER = 1025.0
CONCRETE, STEEL = 2400.0, 7850.0


def pull_of(tonnes: float, friction: float, factor: float = 1.5) -> float:
    """Horizontal pull that a sinker just holds: mu m g (1 - rho_w/rho)/SF, N."""
    weight = 1e3 * tonnes * STANDARD_GRAVITY * (1.0 - WATER / CONCRETE)
    return friction * weight / factor


@pytest.mark.parametrize(
    ("needed", "cast"),
    [
        *((59.0, 60.0), (61.0, 80.0), (81.0, 100.0), (101.0, 125.0), (126.0, 150.0)),
        *((151.0, 200.0), (201.0, 250.0), (251.0, 300.0), (301.0, 400.0), (401.0, 500.0)),
        *((499.9, 500.0), (501.0, 600.0), (601.0, 800.0), (801.0, 1000.0), (999.9, 1000.0)),
    ],
)
def test_a_sinker_for_a_ship_is_of_the_next_round_size(needed: float, cast: float) -> None:
    """Steps of a third at the most, in round figures, tonnes."""
    found = SinkerGround("IALA default").sized(pull_of(needed, 1.0), 0.0, WATER)
    assert found.needed_mass == pytest.approx(1e3 * needed, rel=1e-12)
    assert found.mass == 1e3 * cast


@pytest.mark.parametrize("tonnes", [80, 100, 125, 150, 200, 250, 300, 400, 500, 600, 800, 1000])
def test_a_size_that_just_holds_is_enough(tonnes: float) -> None:
    found = SinkerGround("IALA default").sized(pull_of(tonnes, 1.0), 0.0, WATER)
    assert found.mass == 1e3 * tonnes
    assert found.factor == pytest.approx(1.5, rel=1e-12)


def test_nothing_is_cast_beyond_a_thousand_tonnes() -> None:
    ground = SinkerGround("IALA default")
    with pytest.raises(NoAnswerError):
        ground.sized(pull_of(1001.0, 1.0), 0.0, WATER)
    # By a friction of 0.35 the same pull wants 1/0.35 = 2.86 times as much.
    held = ground.sized(pull_of(400.0, 1.0), 0.0, WATER)
    assert ground.by_other_rule(held, WATER) is None


def test_a_search_for_a_buoy_looks_at_no_sinker_for_ships() -> None:
    ground = SinkerGround()
    assert max(ground.choice(coded=False).masses) == 60e3
    assert max(ground.choice(coded=False, heavy=True).masses) == 1000e3


def test_the_factor_is_the_code_s_or_one_s_own_or_iala_s() -> None:
    """On sliding IALA recommends 1.5 (CALMAR 6.2.6)."""
    usual, own = SinkerGround(), SinkerGround(safety_factor=2.0)
    assert (usual.choice(coded=True).safety_factor, usual.choice(coded=True).factor_source) == (
        None,
        "",
    )
    assert usual.choice(coded=False).safety_factor == 1.5
    assert "CALMAR" in usual.choice(coded=False).factor_source
    assert own.choice(coded=True).safety_factor is None
    assert (own.choice(coded=False).safety_factor, own.choice(coded=False).factor_source) == (
        2.0,
        "",
    )
    assert usual.is_usual_factor
    assert not own.is_usual_factor


def test_a_sinker_of_one_s_own_figures() -> None:
    ground = SinkerGround(None, 0.4, density=2300.0)
    choice = ground.choice(coded=False)
    assert (choice.friction, choice.density) == (0.4, 2300.0)
    assert SinkerGround().choice(coded=False).density == CONCRETE
    assert SinkerGround(None, 0.4, "steel").rho == STEEL


@pytest.mark.parametrize(
    ("ground", "friction", "density"),
    [
        (SinkerGround("hard clay"), 1.0, CONCRETE),
        (SinkerGround("IALA default"), 0.30, CONCRETE),  # fine or silty sand, formed concrete
        (SinkerGround(None, 0.4, "steel"), 1.0, STEEL),
    ],
)
def test_the_rule_that_was_not_chosen(
    ground: SinkerGround, friction: float, density: float
) -> None:
    """The mass is (SF H/mu + V)/(g (1 - rho_w/rho))."""
    own = ground.sized(20e3, 3e3, WATER)
    other = ground.by_other_rule(own, WATER)
    assert other is not None
    weight = 1.5 * 20e3 / friction + 3e3
    needed = weight / (STANDARD_GRAVITY * (1.0 - WATER / density))
    assert other.needed_mass == pytest.approx(needed, rel=1e-12)


def test_a_drag_anchor_is_held_to_its_own_factor_or_the_table_s() -> None:
    """UFC's table 3-7 has 2.0 for a drag anchor of high efficiency."""
    pull = 300e3
    usual, own = DragGround(), DragGround(safety_factor=1.7)
    by_table, by_own = usual.held(usual.sized(pull)), own.held(own.sized(pull))
    assert (by_table.safety_factor, by_own.safety_factor) == (2.0, 1.7)
    assert "table 3-7" in by_table.factor_source
    assert by_own.factor_source == ""
    assert by_table.holding_capacity is not None
    assert by_table.holding_capacity >= 2.0 * pull
    assert by_own.holding_capacity is not None
    assert by_own.holding_capacity >= 1.7 * pull
