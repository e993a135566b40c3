"""Sinkers: NAVFAC's friction, uplift, buoyancy, and IALA's rule."""

from __future__ import annotations

import pytest

from catopt.errors import InputError, NoAnswerError
from catopt.loads import size_sinker
from catopt.loads.component import LoadSource
from catopt.loads.holding_table import sinker_holdings
from catopt.loads.sinker import (
    ADHESION,
    SOIL_FRICTION,
    adhesion_holding,
    base_of,
    friction_of,
    holding_force,
    soil_named,
)
from catopt.model.anchor import sinker_needed
from catopt.model.line import weight_in_water

from . import ROUNDING

G = 9.80665
LAND = "a figure for foundations on land: soft mud is not covered"
CAST = {
    "clean sound rock": (0.70, 0.70),
    "gravel or coarse sand": (0.55, 0.60),
    "clean fine to medium sand": (0.45, 0.55),
    "fine or silty sand": (0.35, 0.45),
    "sandy silt": (0.30, 0.35),
    "hard clay": (0.40, 0.50),
    "stiff clay": (0.30, 0.35),
}
"""NAVFAC DM 7.02 (1986), table 1: mass concrete on ..., tan(delta): cast in place."""

PRECAST = {
    "clean sound rock": (0.55, 0.55),
    "gravel or coarse sand": (0.40, 0.50),
    "clean fine to medium sand": (0.30, 0.40),
    "fine or silty sand": (0.30, 0.30),
    "sandy silt": (0.25, 0.25),
    "hard clay": (0.40, 0.50),
    "stiff clay": (0.30, 0.35),
}
"""The same: formed concrete; of rock dressed hard rock on its like, of clay mass concrete."""

STEEL = {
    "gravel or coarse sand": 0.40,
    "clean fine to medium sand": 0.30,
    "fine or silty sand": 0.25,
    "sandy silt": 0.20,
}
"""The same: steel."""


def test_the_soils_are_navfac_s() -> None:
    of_navfac = {
        name: row for name, row in SOIL_FRICTION.items() if "NAVFAC" in row.source.document
    }
    assert {name: (row.low, row.high) for name, row in of_navfac.items()} == PRECAST
    assert {name: row.cast for name, row in of_navfac.items()} == CAST
    (other,) = [row for name, row in SOIL_FRICTION.items() if name not in PRECAST]
    # CALMAR 7.2: phi = 45 deg
    assert (other.soil, other.low, other.high) == ("IALA default", 1.0, 1.0)
    for name, (low, _) in PRECAST.items():
        friction, source = friction_of(name)
        sure = "A" if name in ("hard clay", "stiff clay") else "B"
        assert (friction, source.confidence) == (low, sure)
        assert "foundations on land" in source.text
        assert friction_of(name, "concrete cast in place") == (
            CAST[name][0],
            LoadSource(source.document, f"mass concrete; {LAND}", "A"),
        )


def test_a_precast_block_is_formed_concrete() -> None:
    """On sand 0.30, not the 0.45 of concrete cast in place: 1.5 times the weight."""
    precast = size_sinker(50e3, soil="clean fine to medium sand")
    cast = size_sinker(50e3, soil="clean fine to medium sand", material="concrete cast in place")
    assert precast.needed_mass == pytest.approx(1.5 * cast.needed_mass, rel=ROUNDING)
    assert all(PRECAST[name][0] <= CAST[name][0] for name in CAST)


def test_iala_s_rule_by_hand() -> None:
    """M = 1.5 H/[g tan(45 deg) (1 - 1025/2400)]: 10 kN need 2669.8 kg."""
    size = size_sinker(10e3, soil="IALA default")
    by_hand = 1.5 * 10e3 / (G * (1.0 - 1025.0 / 2400.0))
    assert by_hand == pytest.approx(2669.8, abs=0.05)  # printed digits
    assert size.needed_mass == pytest.approx(by_hand, rel=ROUNDING)
    assert size.mass == 3000.0
    assert (size.smaller, size.larger) == (2500.0, 4000.0)
    assert "unconservative" in size.notes[0]


def test_uplift_friction_and_factor_by_hand() -> None:
    """From mu (W - V) = SF H, W = 5 + 1.5 x 20/0.4 = 80 kN; steel 80e3/g/(1 - 1025/7850) kg."""
    assert sinker_needed(20e3, 5e3, 0.4, 1.5) == pytest.approx(80e3, rel=ROUNDING)
    size = size_sinker(20e3, 5e3, friction=0.4, material="steel")
    assert size.needed_mass == pytest.approx(80e3 / (G * (1.0 - 1025.0 / 7850.0)), rel=ROUNDING)
    assert size.factor is not None
    assert size.factor >= 1.5
    held = 0.4 * (size.submerged_weight - 5e3)
    assert size.factor == pytest.approx(held / 20e3, rel=ROUNDING)


def test_buoyancy_counts() -> None:
    """1 t of concrete weighs g (1 - 1025/2400) kN = 5.618 kN in water."""
    assert weight_in_water(1000.0, 2400.0, 1025.0) == pytest.approx(5618.4, abs=0.05)  # digits


def test_a_pull_straight_up_needs_its_own_weight() -> None:
    size = size_sinker(0.0, 30e3, friction=0.5)
    assert size.factor is None
    assert size.submerged_weight >= 30e3


def test_steel_and_cast_iron() -> None:
    """Read now, in the row of steel; cast iron has none of its own, and weighs 7320 kg/m3."""
    for name, value in STEEL.items():
        friction, source = friction_of(name, "steel")
        assert (friction, source.confidence) == (value, "B")
        iron, of_iron = friction_of(name, "cast iron")
        assert (iron, of_iron.confidence) == (value, "C")
        assert value <= PRECAST[name][0]
    with pytest.raises(InputError, match="no figure for steel"):
        size_sinker(10e3, soil="hard clay", material="steel")
    # 10 kN by 0.5 and 1.5 are 30 kN in water: 30e3/g/(1 - 1025/7320) kg.
    size = size_sinker(10e3, friction=0.5, material="cast iron")
    assert size.density == 7320.0
    assert size.needed_mass == pytest.approx(30e3 / G / (1.0 - 1025.0 / 7320.0), rel=ROUNDING)


def test_mud_holds_by_adhesion() -> None:
    """Soft clay 10 to 35 kPa on concrete, 5 to 30 on steel; stiff clay 35 to 60 and 30 to 60.

    4 m2 of concrete on mud hold 40 kN at the least, whatever the block weighs.
    """
    assert (ADHESION["soft clay"].concrete, ADHESION["soft clay"].steel) == (
        (10e3, 35e3),
        (5e3, 30e3),
    )
    assert (ADHESION["stiff clay"].concrete, ADHESION["stiff clay"].steel) == (
        (35e3, 60e3),
        (30e3, 60e3),
    )
    for soil in ("mud", "soft mud", "soft clay"):
        assert adhesion_holding(soil, 4.0)[0] == pytest.approx(40e3, rel=ROUNDING)
        assert friction_of(soil)[0] == 0.25  # of sandy silt, the lowest of the table
        assert "for want of one of soft clay" in friction_of(soil)[1].text
        assert friction_of(soil, "steel")[0] == 0.20
    assert adhesion_holding("stiff clay", 2.0, "cast iron")[0] == pytest.approx(60e3, rel=ROUNDING)
    with pytest.raises(InputError, match="base_area"):
        adhesion_holding("sand", 0.0)


def test_the_table_of_what_a_sinker_holds() -> None:
    """5 t of concrete weigh 28.09 kN in water: on sand 0.30 of it, 8.43 kN, over 1.5 5.62 kN.

    On soft clay 0.25 of it, 7.02 kN, on 4 m2; on 0.5 m2 10 kPa hold 5 kN.
    """
    rows = {each.soil: each for each in sinker_holdings(5e3, base_area=4.0)}
    sand = rows["clean fine to medium sand"]
    weight = 5e3 * G * (1.0 - 1025.0 / 2400.0)
    assert sand.submerged_weight == pytest.approx(weight, rel=ROUNDING)
    assert sand.holding == pytest.approx(0.30 * weight, rel=ROUNDING)
    assert sand.pull == pytest.approx(0.30 * weight / 1.5, rel=ROUNDING)
    assert rows["soft clay"].holding == pytest.approx(0.25 * weight, rel=ROUNDING)
    assert rows["stiff clay"].holding == pytest.approx(0.30 * weight, rel=ROUNDING)
    (small,) = (e for e in sinker_holdings(5e3, base_area=0.5) if e.soil == "soft clay")
    assert small.holding == pytest.approx(5e3, rel=ROUNDING)
    assert small.adhesion == 10e3
    with pytest.raises(InputError, match="one of concrete"):
        sinker_holdings(5e3, "lead")


ORDER = (
    *("clean sound rock", "gravel or coarse sand", "clean fine to medium sand"),
    *("fine or silty sand", "sandy silt", "soft clay"),
)
"""Soils from the one that holds best to the softest; of clays hard, stiff, soft."""


@pytest.mark.parametrize("order", [ORDER, ("hard clay", "stiff clay", "soft clay")])
@pytest.mark.parametrize("pull", [1e3, 12e3, 50e3])
def test_the_softer_the_ground_the_larger_the_sinker(order: tuple[str, ...], pull: float) -> None:
    needed = [size_sinker(pull, soil=soil).needed_mass for soil in order]
    assert needed == sorted(needed)
    by_word = [size_sinker(pull, soil=word).needed_mass for word in ("sand", "clay", "mud")]
    assert by_word == sorted(by_word)


def test_a_word_of_practice_is_the_weakest_of_its_kind() -> None:
    for word, soils in {
        "sand": ("gravel or coarse sand", "clean fine to medium sand", "fine or silty sand"),
        "clay": ("hard clay", "stiff clay", "soft clay"),
        "mud": ("soft clay",),
    }.items():
        least = min(friction_of(soil)[0] for soil in soils)
        assert friction_of(word) == friction_of(soil_named(word))
        assert friction_of(word)[0] == least


def test_a_base_decides_on_clay() -> None:
    """A pull of 10 kN by 1.5 and 10 kPa wants 1.5 m2, whatever the block weighs.

    Of 1.4 m2 (1.1832 m wide) 0.1 m2 more at two sides: sunk in by 0.1/2/1.1832 = 0.0423 m it holds.
    A block of 4 t in a mould half as high as wide: 2 x 4/2.4 = 3.333 m3, 1.4938 m wide, 2.2314 m2.
    """
    with pytest.raises(NoAnswerError, match=r"1\.4 m2 on clay of 10 kPa .* 1\.5 m2 are required"):
        size_sinker(10e3, soil="mud", base_area=1.4)
    with pytest.raises(NoAnswerError, match=r"are required"):
        size_sinker(10e3, soil="mud", base_area=1.4, embedment=0.042)
    size = size_sinker(10e3, soil="mud", base_area=1.4, embedment=0.0423)
    assert size.mass == 12e3  # by friction: 15/0.25 kN are 10.7 t
    assert size.base_holding == pytest.approx(15e3, rel=1e-3)
    assert size.held == pytest.approx(min(15e3, 0.25 * size.submerged_weight), rel=1e-3)
    assert base_of(4e3, 2400.0) == pytest.approx(2.2314, abs=5e-5)
    block = size_sinker(3e3, soil="mud")
    assert block.side == pytest.approx(2.0 * block.height, rel=ROUNDING)
    assert block.side**2 * block.height * 2400.0 == pytest.approx(block.mass, rel=ROUNDING)
    with pytest.raises(InputError, match="embedment"):
        size_sinker(10e3, soil="sand", embedment=0.1)


def test_a_light_steel_block_is_held_by_its_base() -> None:
    """10 kN by 1.5 and 5 kPa want 3 m2: 0.5 x 3^1.5 x 7850 kg, above 75 kN by 0.2 in water."""
    size = size_sinker(10e3, soil="mud", material="steel")
    assert size.needed_mass == pytest.approx(0.5 * 3.0**1.5 * 7850.0, rel=ROUNDING)
    assert 75e3 / G / (1.0 - 1025.0 / 7850.0) < size.needed_mass


def test_a_sinker_that_is_lifted_holds_nothing() -> None:
    """Of 5 kN lifted by 4 kN a friction of 0.5 holds half of 1 kN."""
    assert holding_force(5e3, 4e3, 0.5) == pytest.approx(500.0, rel=ROUNDING)
    assert holding_force(5e3, 5e3, 0.5) == 0.0
    assert holding_force(5e3, 6e3, 0.5) == 0.0


def test_water_and_density_of_one_s_own_count() -> None:
    """10 kN by 0.5 and 1.5 are 30 kN in water, of 2400 in 1000 kg/m3 30e3/g/(1 - 1/2.4) kg."""
    size = size_sinker(10e3, friction=0.5, water_density=1000.0)
    assert size.needed_mass == pytest.approx(30e3 / G / (1.0 - 1.0 / 2.4), rel=ROUNDING)
    own = size_sinker(10e3, friction=0.5, density=4800.0, water_density=1000.0)
    assert own.needed_mass == pytest.approx(30e3 / G / (1.0 - 1.0 / 4.8), rel=ROUNDING)
    assert own.density == 4800.0


def test_a_factor_of_one_s_own_on_sliding() -> None:
    """2.0 in the place of 1.5 takes a third more weight."""
    usual, own = size_sinker(30e3, friction=0.5), size_sinker(30e3, friction=0.5, safety_factor=2.0)
    assert (usual.safety_factor, own.safety_factor) == (1.5, 2.0)
    assert own.needed_mass == pytest.approx(usual.needed_mass * 2.0 / 1.5, rel=ROUNDING)


def test_what_is_assumed_is_said() -> None:
    notes = size_sinker(10e3, soil="hard clay").notes
    assert any("foundations on land" in note for note in notes)
    assert any("2400 kg/m3" in note for note in notes)
    own = size_sinker(10e3, friction=0.5, density=2500.0)
    assert (own.notes, own.friction_source) == ((), None)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ({"soil": "peat"}, "for others, give friction"),
        ({}, "one of soil and friction is required"),
        ({"soil": "hard clay", "friction": 0.4}, "found both"),
        ({"friction": 0.4, "density": 900.0}, "it floats"),
        (
            {"friction": 0.4, "material": "lead"},
            "one of concrete, concrete cast in place, steel, cast iron",
        ),
        ({"friction": 0.0}, "friction"),
        ({"friction": 0.4, "safety_factor": 0.5}, "safety_factor"),
    ],
)
def test_what_is_wrong_is_told(arguments: dict[str, object], words: str) -> None:
    with pytest.raises(InputError, match=words):
        size_sinker(10e3, **arguments)  # type: ignore[arg-type]


def test_a_pull_that_no_sinker_holds() -> None:
    with pytest.raises(NoAnswerError, match=r"the largest is 60 t, .* too light"):
        size_sinker(1e6, friction=0.4)
