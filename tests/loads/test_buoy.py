"""Buoys: hydrostatics and CALMAR's forces, against hand calculations and limits."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from catopt.errors import InputError
from catopt.loads import (
    BuoyShape,
    BuoySlice,
    Loads,
    SeaState,
    SurfaceCurrent,
    WaterLevels,
    Wind,
    buoy,
    buoy_loads,
    buoys,
    laying_check,
    read_buoys,
)
from catopt.loads.buoy import BreakingSeaError, parse_buoys

from . import ROUNDING

G = 9.80665
PLAIN = BuoyShape("drum", hull_diameter=2.0, hull_depth=2.0, mass=1025.0 * math.pi)
"""Of 2 m: it displaces pi m3, which is a draught of 1 m."""

CALM = SeaState(6.0, 0.0)
LEVELS = WaterLevels.steady(20.0)


def loads(
    shape: BuoyShape = PLAIN,
    wind: float = 0.0,
    current: float = 0.0,
    sea: SeaState = CALM,
    levels: WaterLevels = LEVELS,
    **more: Any,
) -> Loads:
    more = {"chain_diameter": 0.0, **more}
    return buoy_loads(shape, Wind(wind), SurfaceCurrent(current), sea, levels, **more)


def force(of: Loads, name: str) -> float:
    (component,) = [each for each in of.components if each.name == name]
    return component.force


# ------------------------------------------------------------------ hydrostatics


def test_draught_and_reserve_by_hand() -> None:
    """The drum floats at 1 m; the other metre carries rho g pi m3 = 31.58 kN."""
    afloat = PLAIN.afloat()
    assert afloat.draught == pytest.approx(1.0, rel=ROUNDING)
    assert afloat.freeboard == pytest.approx(1.0, rel=ROUNDING)
    assert PLAIN.reserve_buoyancy() == pytest.approx(1025.0 * G * math.pi, rel=ROUNDING)


def test_half_the_reserve_is_half_a_metre() -> None:
    afloat = PLAIN.afloat(0.5 * PLAIN.reserve_buoyancy())
    assert afloat.draught == pytest.approx(1.5, rel=ROUNDING)


def test_least_freeboard_takes_its_share() -> None:
    kept = replace(PLAIN, least_freeboard=0.25)
    assert kept.reserve_buoyancy() == pytest.approx(0.75 * PLAIN.reserve_buoyancy(), rel=ROUNDING)


def test_a_tail_tube_carries_and_is_seen() -> None:
    """A tube of 0.5 m, 1.6 m long, displaces 0.1 pi m3: the hull rises by 0.1 m."""
    tube = replace(PLAIN, tube_diameter=0.5, tube_length=1.6).afloat()
    assert tube.draught == pytest.approx(0.9, rel=ROUNDING)
    assert tube.keel_depth == pytest.approx(2.5, rel=ROUNDING)
    assert tube.hull_area_in_water() == pytest.approx(2.0 * 0.9 + 0.5 * 1.6, rel=ROUNDING)


def test_growth_widens_hull_and_tube_on_both_sides_however_short_the_tube() -> None:
    """5 cm all round: (2.0 + 0.1) m by the draught and (0.5 + 0.1) m by the tube."""
    for length in (1.6, 0.05):
        # the tube displaces pi/16 m3 for each metre, a sixteenth of a metre of the hull's draught
        tube = replace(PLAIN, tube_diameter=0.5, tube_length=length).afloat()
        by_hand = 2.1 * (1.0 - length / 16.0) + 0.6 * length
        assert tube.hull_area_in_water(0.05) == pytest.approx(by_hand, rel=ROUNDING)


def test_windage_by_hand() -> None:
    """Hull 2 m x 1 m in air, half of a tower of 3 m x 0.8 m, a topmark of 0.25 m2: 3.45 m2."""
    shape = replace(PLAIN, tower_height=3.0, tower_width=0.8, tower_solidity=0.5, topmark_area=0.25)
    assert shape.afloat().windage == pytest.approx(2.0 + 1.2 + 0.25, rel=ROUNDING)


def test_what_a_buoy_is_not_said_to_have_is_not_there() -> None:
    assert PLAIN.afloat().windage == pytest.approx(2.0, rel=ROUNDING)
    assert replace(PLAIN, tower_width=1.0).tower_area == 0.0
    assert replace(PLAIN, tower_height=1.0).tower_area == 0.0
    assert replace(PLAIN, tower_height=1.0, tower_width=1.0).tower_area == 1.0
    assert replace(PLAIN, tube_length=1.0).tube_volume == 0.0
    assert replace(PLAIN, tube_diameter=1.0).afloat().keel_depth == pytest.approx(1.0, rel=ROUNDING)


def test_a_shallow_draught_still_floats() -> None:
    """A tenth of a tonne on pi m2 of water: 0.031 m."""
    afloat = replace(PLAIN, mass=100.0).afloat()
    assert afloat.draught == pytest.approx(100.0 / 1025.0 / math.pi, rel=ROUNDING)


def test_heavier_water_lifts_a_hull_off_its_tube_and_that_is_refused() -> None:
    """The tube of 3.99 m displaces pi 0.9975 m3: the mass of pi m3 of 1025 kg/m3 in 1030.

    1025/1030 = 0.99515 is less than 0.9975; in 1025 kg/m3 it is more, and the hull reaches the
    water.
    """
    tall = replace(PLAIN, tube_diameter=1.0, tube_length=3.99)
    assert tall.afloat().draught == pytest.approx(0.0025, rel=1e-9)  # a difference of near numbers
    with pytest.raises(InputError, match="its hull floats clear of the water"):
        tall.afloat(0.0, 1030.0)


def test_a_pull_at_the_reserve_floats_and_one_above_is_refused() -> None:
    reserve = PLAIN.reserve_buoyancy()
    assert PLAIN.afloat(reserve).freeboard == pytest.approx(0.0, abs=1e-12)
    with pytest.raises(InputError, match=r"above the buoy's reserve buoyancy of 31\.6 kN"):
        PLAIN.afloat(1.01 * reserve)
    with pytest.raises(InputError, match=r"found 40 kN; above .* leaves a freeboard of 0\.5 m"):
        replace(PLAIN, least_freeboard=0.5).afloat(40e3)


@pytest.mark.parametrize("shape", buoys(), ids=lambda shape: shape.name)
def test_every_buoy_of_the_library_balances(shape: BuoyShape) -> None:
    """Weight and pull equal the water displaced, at rest and at the reserve."""
    assert shape.generic == ("generic" in shape.origin)
    reserve = shape.reserve_buoyancy()
    for pull in (0.0, 0.4 * reserve, reserve):
        afloat = shape.afloat(pull)
        assert afloat.displacement * G == pytest.approx(shape.total_mass * G + pull, rel=ROUNDING)
        assert afloat.freeboard >= shape.least_freeboard - 1e-12
    assert shape.afloat().windage > 0.0


def test_the_library_knows_its_names() -> None:
    assert buoy("pillar 1.8 m").hull_diameter == 1.8
    with pytest.raises(InputError, match=r"did you mean pillar 1\.8 m"):
        buoy("piller 1.8 m")


def test_buoys_of_one_s_own(tmp_path: Path) -> None:
    path = tmp_path / "own.toml"
    path.write_text(
        'schema = "catopt.buoys/1"\n[[buoy]]\nname = "mine"\nhull_diameter = 2\n'
        "hull_depth = 2\nmass = 2000\n"
    )
    (mine,) = read_buoys(path)
    assert (mine.name, mine.hull_diameter, mine.origin) == ("mine", 2, "the user's own")


def test_every_problem_of_a_file_is_told() -> None:
    with pytest.raises(InputError) as caught:
        parse_buoys(
            'schema = "catopt.buoys/2"\nextra = 1\n'
            '[[buoy]]\nname = "a"\nhull_diametre = 2\nhull_depth = 2\nmass = 10\n'
            '[[buoy]]\nname = "b"\nhull_diameter = -2\nhull_depth = 2\nmass = "heavy"\n',
            "own.toml",
        )
    text = str(caught.value)
    for words in (
        "schema",
        "extra: found an unknown key",
        "buoy[0].hull_diametre: found an unknown key; did you mean hull_diameter",
        "buoy[0].hull_diameter: missing",
        "buoy[1].hull_diameter: found -2",
        "buoy[1].mass",
    ):
        assert words in text


def test_a_file_that_is_not_there_or_no_toml() -> None:
    with pytest.raises(InputError, match="file of buoys: there is no such file"):
        read_buoys("nowhere.toml")
    with pytest.raises(InputError, match="line 1, column 7"):
        parse_buoys("[[buoy]\n")


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"mass": 1025.0 * 2.0 * math.pi}, "freeboard of 0.00 m"),
        ({"mass": 7000.0}, "below 6440 kg"),
        ({"tube_diameter": 3.0}, "wider than the hull"),
        ({"tube_diameter": 1.0, "tube_length": 5.0}, "less than what is below its hull displaces"),
        ({"tower_solidity": 1.5}, "must be 1 or less"),
    ],
)
def test_what_cannot_float_is_refused(change: dict[str, float], words: str) -> None:
    with pytest.raises(InputError, match=re.escape(words)):
        replace(PLAIN, **change)  # type: ignore[arg-type]


# ------------------------------------------------------------------ stacks of slices

CONE = BuoySlice(1.5, 0.0, 2.0)
"""Point down: pi/12 x 1.5 x 4 = pi/2 m3 in all, a share of (h/1.5)^3 below h."""

STACK = BuoyShape(
    "cone and drum",
    hull=(CONE, BuoySlice(1.0, 2.0, 2.0)),
    structure=(BuoySlice(3.0, 0.2, 0.2, volume=0.03),),
    structure_depth=1.0,
    eye_offset=0.75,
    mass=1025.0 * (0.0625 * math.pi + 0.0175),
)
"""It floats with half of the cone under water, 1/8 of pi/2 m3, and 1.75 m of a flooded pole."""


def test_a_cone_and_a_pole_by_hand() -> None:
    afloat = STACK.afloat()
    assert afloat.draught == pytest.approx(0.75, rel=ROUNDING)
    assert afloat.keel_depth == pytest.approx(1.75, rel=ROUNDING)
    assert afloat.eye_depth == pytest.approx(1.5, rel=ROUNDING)
    assert afloat.freeboard == pytest.approx(1.75, rel=ROUNDING)
    # The cone is 1 m wide there; the flooded pole is a hundredth of a square metre.
    assert afloat.waterplane_area == pytest.approx(0.25 * math.pi + 0.01, rel=ROUNDING)


def test_what_of_a_pole_is_hidden_in_the_hull_counts_from_the_side() -> None:
    """Under water: cone 0.75 x 1/2 and pole 1.75 x 0.2; above, 1.125 + 2 and 1.25 x 0.2 m2."""
    afloat = STACK.afloat()
    assert afloat.hull_area_in_water() == pytest.approx(0.375 + 0.35, rel=ROUNDING)
    assert afloat.hull_area_in_air == pytest.approx(1.125 + 2.0 + 0.25, rel=ROUNDING)
    assert afloat.hull_area_in_water(0.1) == pytest.approx(0.725 + 0.2 * 1.75, rel=ROUNDING)


def test_a_stated_volume_scales_that_of_the_geometry() -> None:
    """Twice the volume of the cone: half of its height displaces a quarter of pi/2 m3."""
    twice = replace(CONE, volume=math.pi)
    assert twice.displaced(0.75) == pytest.approx(math.pi / 8.0, rel=ROUNDING)
    assert twice.displaced(9.0) == pytest.approx(math.pi, rel=ROUNDING)
    assert twice.waterplane(0.75) == pytest.approx(0.5 * math.pi, rel=ROUNDING)


def test_a_hole_displaces_nothing_and_its_width_is_seen() -> None:
    ring = BuoySlice(1.0, 2.0, 2.0, inner=1.0)
    assert ring.displaced(1.0) == pytest.approx(0.75 * math.pi, rel=ROUNDING)
    assert ring.outline() == 2.0
    # A guard as thin as a line, and plates whose volume is stated: nothing, and that volume.
    assert BuoySlice(1.0, 0.8, 0.6, inner=0.8).displaced(1.0) == 0.0
    assert BuoySlice(1.0, 2.0, 3.0, inner=3.0, volume=2.5).displaced(1.0) == 2.5


def test_ballast_of_cast_iron_loses_its_buoyancy() -> None:
    """Two pieces of 366 kg displace a tenth of a cubic metre: 732 kg weigh 732 - 102.5 kg."""
    ballast = replace(PLAIN, ballast_mass=366.0, ballast_pieces=2)
    by_hand = 1.0 + (732.0 - 102.5) / 1025.0 / math.pi
    assert ballast.afloat().draught == pytest.approx(by_hand, rel=ROUNDING)
    lost = PLAIN.reserve_buoyancy() - ballast.reserve_buoyancy()
    assert lost == pytest.approx(G * 629.5, rel=1e-11)  # a difference of near numbers


def test_a_stack_and_the_cylinder_in_short_are_the_same_buoy() -> None:
    short = replace(PLAIN, tube_diameter=0.5, tube_length=1.6)
    stack = BuoyShape(
        "drum",
        mass=short.mass,
        hull=(BuoySlice(2.0, 2.0, 2.0),),
        structure=(BuoySlice(1.6, 0.5, 0.5),),
        structure_depth=1.6,
        eye_offset=1.6,
    )
    for pull in (0.0, 10e3):
        one, other = short.afloat(pull), stack.afloat(pull)
        for key in ("draught", "keel_depth", "eye_depth", "freeboard", "windage", "reserve_share"):
            assert getattr(one, key) == getattr(other, key)
        assert one.hull_area_in_water(0.03) == other.hull_area_in_water(0.03)


@pytest.mark.parametrize(
    ("name", "mass", "volume"), [("2S5PL", 3405.0, 12.7555), ("2S5PL +2", 4417.0, 14.1815)]
)
def test_trinity_house_prints_mass_and_volume(name: str, mass: float, volume: float) -> None:
    """Its guide's totals of each body, less a dummy of 1 kg and 494.5 kg of superstructure."""
    body = buoy(name)
    assert body.mass - 494.5 - 1.0 == pytest.approx(mass, abs=1e-9)
    # The printed digits, and the dummy's hundredth of a litre.
    assert body.volume == pytest.approx(volume, abs=0.5e-4)
    assert (body.chain_min, body.chain_max) == (0.032, 0.038)


def test_real_buoys_displace_what_they_are_named_by() -> None:
    """Litres of the float, to the 10 % that a name leaves open."""
    named = {each.name: float(found[1]) for each in buoys() if (found := LITRES.search(each.name))}
    assert len(named) == 7
    for name, litres in named.items():
        assert 1e3 * buoy(name).volume == pytest.approx(litres, rel=0.10)


HEAVIEST = {
    "pillar 1.2 m": ("T-1000l-1.24m", 358.0),
    "pillar 1.8 m": ("T-2500l-1.85m", 918.29),
    "pillar 2.4 m": ("T-5000l-2.4m", 2053.7),
    "pillar 3.0 m": ("2S5PL", 4900.5),
    "spar 0.8 m": ("SP-3200l-1.2m", 1300.0),
}
"""The real buoy nearest in size, and its mass with all the ballast that its file allows, kg."""


@pytest.mark.parametrize("name", HEAVIEST)
def test_no_generic_buoy_is_heavier_than_the_real_one_of_its_size(name: str) -> None:
    nearest, heaviest = HEAVIEST[name]
    generic, real = buoy(name), buoy(nearest)
    assert generic.total_mass <= heaviest
    assert (generic.chain_min, generic.chain_max) == (real.chain_min, real.chain_max)
    assert generic.chain_source.startswith(nearest)


LITRES = re.compile(r"-(\d+)l-")


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"hull_diameter": 2.0}, "hull_diameter: found 2.0; leave it out"),
        ({"mass": 10.0}, "less than what is below its hull displaces"),
        ({"ballast_pieces": 1.5}, "a whole number is required"),
        ({"drag_in_water": 0.0}, "drag_in_water"),
        ({"chain_min": 0.03, "chain_max": 0.02}, "not below chain_min, 0.03 m"),
    ],
)
def test_what_a_stack_cannot_be_is_refused(change: dict[str, Any], words: str) -> None:
    with pytest.raises(InputError, match=re.escape(words)):
        replace(STACK, **change)


def test_a_hole_between_both_ends_wants_its_volume() -> None:
    with pytest.raises(InputError, match="state the volume"):
        BuoySlice(1.0, 1.0, 2.0, inner=1.5)
    with pytest.raises(InputError, match="no width to displace water with"):
        BuoySlice(1.0, 0.0, 0.0, volume=1.0)


def test_a_structure_belongs_to_a_hull_of_slices() -> None:
    with pytest.raises(InputError, match=r"eye_offset: found 0\.5; it belongs to a hull of slices"):
        replace(PLAIN, eye_offset=0.5)


def test_a_stack_of_one_s_own_and_every_problem_of_its_slices() -> None:
    head = 'schema = "catopt.buoys/1"\n[[buoy]]\nname = "mine"\nmass = 900\n'
    (mine,) = parse_buoys(
        head + "hull = [{ height = 0.5, lower = 1, upper = 2 }, { height = 1, lower = 2, upper = 2"
        ", inner = 0.3, volume = 3 }]\nchain_min = 0.02\n"
    )
    assert [each.height for each in mine.hull] == [0.5, 1]
    assert mine.hull[1].displaced(1.0) == 3.0
    with pytest.raises(InputError) as caught:
        parse_buoys(
            head + "hull = [{ height = -1, lower = 1, upper = 2 }, { hight = 1, lower = 2 }]\n"
        )
    text = str(caught.value)
    for words in (
        "buoy[0].hull[0].height: found -1",
        "buoy[0].hull[1].hight: found an unknown key; did you mean height",
        "buoy[0].hull[1].height: missing",
        "buoy[0].hull[1].upper: missing",
    ):
        assert words in text


# ------------------------------------------------------------------ forces


def test_current_alone_by_hand() -> None:
    """1/2 x 1025 x 1.5^2 x (2 m x 1 m) x 1.2 = 2767.5 N."""
    of = loads(current=1.5)
    assert force(of, "current on the hull") == pytest.approx(2767.5, rel=ROUNDING)
    assert of.horizontal_force == pytest.approx(2767.5, rel=ROUNDING)


def test_wind_alone_drives_the_surface_too() -> None:
    """20 m/s: air 1/2 x 1.29 x 400 x 2 x 1.2 = 619.2 N; water 0.3 m/s, 110.7 N."""
    of = loads(wind=20.0)
    assert force(of, "wind on the hull") == pytest.approx(619.2, rel=ROUNDING)
    assert force(of, "current on the hull") == pytest.approx(110.7, rel=ROUNDING)
    assert of.of("wind") == pytest.approx(619.2, rel=ROUNDING)


def test_chain_by_hand() -> None:
    """40 mm over 20 m - 1 m: A = 2.65 x 0.04 x 19 = 2.014 m2, times 615 Pa is 1238.61 N."""
    of = loads(current=1.0, chain_diameter=0.04)
    assert force(of, "current on the chain") == pytest.approx(1238.61, rel=ROUNDING)


def test_chain_hangs_under_the_crest_at_high_water() -> None:
    """Hmax 2 m at high water of 24 m: the chain reaches over 24 + 1 - 1 = 24 m."""
    of = loads(
        current=1.0,
        chain_diameter=0.04,
        sea=SeaState(6.0, maximum_height=2.0),
        levels=WaterLevels(18.0, 24.0),
    )
    by_hand = 0.5 * 1025.0 * 1.2 * 2.65 * 0.04 * 24.0
    assert force(of, "current on the chain") == pytest.approx(by_hand, rel=ROUNDING)


def test_the_depth_of_the_waves_is_told() -> None:
    """A load case at low water has steady levels: it must not be told to be at high water."""
    sea = SeaState(6.0, maximum_height=2.0)
    of = loads(current=1.0, sea=sea, levels=WaterLevels.steady(10.0), wave_height="hmax")
    told = next(text for text in of.assumptions if text.startswith("Surface speed"))
    assert told.endswith(" in 10 m of water.")


def test_calmar_takes_the_significant_height_in_deep_water() -> None:
    """Its manuals' buoy: Hs 1.08 m and 12 s are pi x 1.08/12 = 0.282743 m/s in 6 m of water."""
    sea = SeaState(12.0, significant_height=1.08, maximum_height=2.0)
    of = loads(current=1.0, sea=sea, levels=WaterLevels.steady(6.0))
    by_hand = 1230.0 * (1.0 + 0.09 * math.pi) ** 2
    assert force(of, "current on the hull") == pytest.approx(by_hand, rel=ROUNDING)
    assert of.method == "IALA-CALMAR"
    told = next(text for text in of.assumptions if text.startswith("Surface speed"))
    assert told.endswith("+ wave 0.283, pi Hs/T of Hs 1.08 m and 12 s.")


def test_the_largest_wave_adds_to_the_surface_speed() -> None:
    """Deep water: 1 m/s and pi x 2/6 m/s; (1 + 1.047198)^2 = 4.191018 times 1230 N."""
    sea = SeaState(6.0, maximum_height=2.0)
    of = loads(current=1.0, sea=sea, levels=WaterLevels.steady(190.0), wave_height="hmax")
    # 190 m are deep for a wave of 56 m: tanh is 1 in double precision.
    by_hand = 1230.0 * (1.0 + math.pi / 3.0) ** 2
    assert force(of, "current on the hull") == pytest.approx(by_hand, rel=ROUNDING)


def test_growth_widens_hull_and_chain_and_is_marked_as_ours() -> None:
    clean, grown = (loads(current=1.0, chain_diameter=0.04, marine_growth=t) for t in (0.0, 0.05))
    assert force(grown, "current on the hull") == pytest.approx(
        1.05 * force(clean, "current on the hull"), rel=ROUNDING
    )
    assert force(grown, "current on the chain") / force(clean, "current on the chain") == (
        pytest.approx((2.65 * 0.04 + 0.1) / (2.65 * 0.04), rel=ROUNDING)
    )
    assert not any("catopt's own" in each.note for each in clean.components)
    assert sum("catopt's own" in each.note for each in grown.components) == 2


def test_only_what_is_there_is_listed() -> None:
    """A drum has no tower, no topmark and here no chain; 0.05 m2 of a topmark count."""
    hull = ["current on the hull", "wind on the hull"]
    assert [str(each.name) for each in loads(wind=20.0).components] == hull
    marked = loads(replace(PLAIN, topmark_area=0.05), wind=20.0, chain_diameter=0.01)
    names = [str(each.name) for each in marked.components]
    assert names == [*hull, "wind on the topmark", "current on the chain"]
    # 1/2 x 1.29 x 20^2 x 0.05 x 1.2
    assert force(marked, "wind on the topmark") == pytest.approx(15.48, rel=ROUNDING)


def test_what_went_into_the_speed_and_the_chain_is_told() -> None:
    """Tide 1 m/s, 0.015 x 20 = 0.3, pi x 2/6 = 1.047 m/s in deep water; 190 + 1 - 1 m of chain."""
    of = loads(
        wind=20.0,
        current=1.0,
        chain_diameter=0.04,
        sea=SeaState(6.0, maximum_height=2.0),
        levels=WaterLevels.steady(190.0),
        wave_height="hmax",
    )
    told = next(text for text in of.assumptions if text.startswith("Surface speed"))
    assert told == (
        "Surface speed 2.347 m/s = tide 1 + 0.015 x wind 20 (0.300) + wave 1.047 in 190 m of water."
    )
    (chain,) = [each for each in of.components if each.name == "current on the chain"]
    assert str(chain.note) == "d = 40 mm nominal, over 190 m"
    media = {str(each.kind): str(each.numbers[0].meaning) for each in of.components}
    assert media == {"current": "of the water", "wind": "density of the air"}


def test_nothing_moves_nothing_pulls() -> None:
    assert loads(chain_diameter=0.04).horizontal_force == 0.0


def test_a_pull_shifts_area_from_the_air_to_the_water() -> None:
    light, heavy = (loads(wind=20.0, pull=pull) for pull in (0.0, 15e3))
    assert force(heavy, "current on the hull") > force(light, "current on the hull")
    assert force(heavy, "wind on the hull") < force(light, "wind on the hull")


def test_every_force_carries_formula_numbers_and_source() -> None:
    of = loads(buoy("pillar 1.8 m"), wind=20.0, current=1.0, chain_diameter=0.03)
    assert len(of.components) == 5
    for each in of.components:
        values = {number.symbol: number.value for number in each.numbers}
        again = 0.5 * values["rho"] * values["V"] ** 2 * values["A"] * values["Cd"]
        assert each.force == pytest.approx(again, rel=ROUNDING)
        assert each.formula == "1/2 rho V^2 A Cd"
        assert "CALMAR" in each.source.text
        assert "Cd = 1.2" in each.numbers_text
    assert of.recalled == ()


def test_a_breaking_wave_is_told() -> None:
    """0.14 x 1.56 x 16 = 3.494 m by steepness; CALMAR stops there, catopt's own wave is cut."""
    steep = SeaState(4.0, maximum_height=6.0)
    with pytest.raises(BreakingSeaError, match=r"at 3\.49 m \(6\.3\.1\)") as refused:
        loads(sea=steep)
    assert refused.value.exit_status == 3
    assert "load_method catopt-buoy" in str(refused.value)
    stopped, cut = loads(sea=steep, wave_height="hmax", method="catopt-buoy").warnings
    assert "at 3.49 m (CALMAR 6.3.1): CALMAR does not apply here" in stopped
    assert "3.49 m is used" in cut
    assert loads(sea=steep, method="catopt-buoy").warnings == (stopped,)
    assert loads(sea=steep, method="catopt-buoy").method == "catopt-buoy"
    assert loads(sea=SeaState(8.0, maximum_height=2.0)).warnings == ()


def test_the_depth_in_which_a_wave_breaks_has_its_crest() -> None:
    """H = 0.78 (10 + H/2) is 12.787 m (CALMAR); catopt's own wave is cut at 0.78 of 10 m."""
    shallow = WaterLevels.steady(10.0)
    reached = 7.8 / 0.61
    stands, breaks = (SeaState(12.0, maximum_height=share * reached) for share in (0.9999, 1.0001))
    whole = loads(sea=stands, levels=shallow)
    assert (whole.method, whole.warnings) == ("IALA-CALMAR", ())
    with pytest.raises(BreakingSeaError):
        loads(sea=breaks, levels=shallow)
    own = loads(sea=breaks, levels=shallow, method="catopt-buoy")
    assert (own.method, len(own.warnings)) == ("catopt-buoy", 1)
    for height, cut in ((7.8, 0), (7.81, 1)):
        sea = SeaState(8.0, maximum_height=height)
        assert len(loads(sea=sea, levels=shallow, wave_height="hmax").warnings) == cut


def test_the_chain_is_in_the_tide_alone_unless_waves_are_put_on_it() -> None:
    """40 mm over 20 + 1 - 1 m; tide 1, drift 0.3, wave pi x (2/1.85)/6 = 0.566 m/s."""
    sea = SeaState(6.0, maximum_height=2.0)
    tide, all_of_it = (
        loads(wind=20.0, current=1.0, sea=sea, chain_diameter=0.04, chain_waves=waves)
        for waves in (False, True)
    )
    by_hand = 0.5 * 1025.0 * 1.2 * 2.65 * 0.04 * 20.0
    assert force(tide, "current on the chain") == pytest.approx(by_hand, rel=ROUNDING)
    speed = 1.3 + math.pi * (2.0 / 1.85) / 6.0
    assert force(all_of_it, "current on the chain") == pytest.approx(
        by_hand * speed**2, rel=ROUNDING
    )


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"wave_height": "hmax"}, "the wave is the largest"),
        ({"chain_waves": True}, "act on the chain too"),
        ({"marine_growth": 0.05}, "marine growth"),
    ],
)
def test_what_departs_from_calmar_has_our_name_and_is_said(
    change: dict[str, Any], said: str
) -> None:
    whole = loads(current=1.0, chain_diameter=0.04)
    assert whole.method == "IALA-CALMAR"
    assert not any(text.startswith("Departs from CALMAR") for text in whole.assumptions)
    ours = loads(current=1.0, chain_diameter=0.04, **change)
    assert ours.method == "catopt-buoy"
    (told,) = [text for text in ours.assumptions if text.startswith("Departs from CALMAR")]
    assert said in told
    assert {each.source.confidence for each in whole.components} == {"A"}
    own = [each for each in ours.components if each.source.document == "catopt-buoy"]
    assert own
    assert {each.source.confidence for each in own} == {"C"}


def test_a_hull_has_its_own_coefficients() -> None:
    """2767.5 N and 619.2 N with 1.2: times 0.55/1.2 in water, 0.40/1.2 in air; the chain keeps."""
    own = replace(PLAIN, drag_in_water=0.55, drag_in_air=0.40)
    of = loads(own, current=1.5, chain_diameter=0.04)
    assert force(of, "current on the hull") == pytest.approx(2767.5 * 0.55 / 1.2, rel=ROUNDING)
    assert force(of, "current on the chain") == force(
        loads(current=1.5, chain_diameter=0.04), "current on the chain"
    )
    assert force(loads(own, wind=20.0), "wind on the hull") == pytest.approx(206.4, rel=ROUNDING)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"levels": WaterLevels.steady(201.0)}, "CALMAR applies down to 200 m"),
        ({"current": 7.5}, "CALMAR applies up to 7 m/s"),
        ({"levels": WaterLevels(0.9, 3.0)}, "it would touch the bed"),
        ({"pull": 40e3}, "reserve buoyancy"),
        ({"chain_diameter": 25.0}, "chain_diameter"),
        ({"marine_growth": -0.1}, "marine_growth"),
        ({"wave_height": "h10"}, "one of hs, hmax"),
    ],
)
def test_what_calmar_does_not_hold_for_is_refused(change: dict[str, Any], words: str) -> None:
    with pytest.raises(InputError, match=words):
        loads(**change)


# ------------------------------------------------------------------ others' worked examples


def test_a_navigation_buoy_with_coefficients_of_its_own() -> None:
    """Indonesia, 14 m: 98.09 N at 11.3 m/s with 0.40, 909.30 N at 0.85 m/s with 0.55.

    The areas are not printed: 2.977 and 4.469 m2 follow from these figures and 1.29 and 1024 kg/m3,
    here those of a drum 3 m wide. The example has no drift current: wind and tide act in turn.
    """
    wet, dry = 4.469 / 3.0, 2.977 / 3.0
    drum = BuoyShape(
        "drum",
        hull_diameter=3.0,
        hull_depth=wet + dry,
        mass=1024.0 * math.pi / 4.0 * 9.0 * wet,
        drag_in_water=0.55,
        drag_in_air=0.40,
    )
    by_tide = loads(drum, current=0.85, water_density=1024.0)
    by_wind = loads(drum, wind=11.3, water_density=1024.0)
    # The areas have four digits, so have the forces.
    assert force(by_tide, "current on the hull") == pytest.approx(909.30, rel=2e-4)
    assert force(by_wind, "wind on the hull") == pytest.approx(98.09, rel=2e-4)


EXAMPLE = BuoyShape(
    "buoy on 110 m of 32 mm chain",
    mass=1384.0,
    hull=(BuoySlice(1.129, 2.4, 2.4, volume=5.105), BuoySlice(0.271, 2.4, 2.4)),
)
"""2.4 m x 1.4 m; it displaces 5.105 m3 at 1.129 m, as printed."""


def test_a_buoy_carries_its_chain_and_sinker_while_it_is_laid() -> None:
    """1384 + 1238 + 2602.6 kg beside 5.105 m3 of 1024 kg/m3 (51.28 kN): printed are 99.95 %.

    The volume has four digits: half a unit of the last is 1e-4 of it, beside half a digit of the
    share.
    """
    of = laying_check(
        EXAMPLE, 2602.6 * G, 1238.0 * G, chain_in="air", freeboard=0.271, water_density=1024.0
    )
    assert of.utilisation == pytest.approx(0.9995, abs=0.5e-4 + 1e-4)
    assert of.demand == pytest.approx((1384.0 + 1238.0 + 2602.6) * G, rel=ROUNDING)
    assert of.name.endswith("the chain weighed in air")
    assert of.source.confidence == "C"
    awash = laying_check(EXAMPLE, 2602.6 * G, 1238.0 * G, chain_in="air", water_density=1024.0)
    more = 1024.0 * G * (5.105 + 0.271 * math.pi * 1.44)
    assert awash.capacity == pytest.approx(more, rel=ROUNDING)


def test_a_laying_check_counts_ballast_and_refuses_what_cannot_be() -> None:
    """Ballast of 732 kg, a tenth of a cubic metre, weighs and displaces."""
    ballast = replace(PLAIN, ballast_mass=366.0, ballast_pieces=2)
    of, bare = (laying_check(each, 1e3, 2e3) for each in (ballast, PLAIN))
    assert of.demand - bare.demand == pytest.approx(732.0 * G, rel=1e-11)
    assert of.capacity - bare.capacity == pytest.approx(102.5 * G, rel=1e-10)
    with pytest.raises(InputError) as caught:
        laying_check(PLAIN, -1.0, -1.0, chain_in="oil", freeboard=3.0)  # type: ignore[arg-type]
    keys = {each.key for each in caught.value.problems}
    assert keys == {"chain_weight", "sinker_weight", "chain_in", "freeboard"}
