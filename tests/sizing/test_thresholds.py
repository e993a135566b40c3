"""What an engineer is told to mind, and from where on."""

from __future__ import annotations

import dataclasses
import math
from typing import Any

import pytest

from catopt.errors import InputError
from catopt.loads import SeaState, WaterLevels, buoy, estimated_tanker
from catopt.model import Service
from catopt.sizing import (
    BuoyRequest,
    Environment,
    GivenBuoy,
    LineChoice,
    MooredShip,
    SinkerGround,
    Sizing,
    TankerRequest,
    size_buoy,
    size_tanker,
)
from catopt.sizing.alternatives import Limit, trade
from catopt.sizing.kinds import usual
from catopt.words import is_said
from tests.sizing.test_consistency import LOADED, deep

G = 9.80665
ONE_SIZE = LineChoice(
    usual("chain", "tanker"), "break/5", diameters=(0.07,), length_step=27.5, life=0.0
)
"""Few designs, so that the search is quick."""


def of_a_ship(low: float, *ships: MooredShip) -> Sizing:
    place = dataclasses.replace(deep(), levels=WaterLevels(low, 22.0))
    return size_tanker(TankerRequest(ships or (LOADED,), place, line=ONE_SIZE))


def of_a_buoy(
    body: GivenBuoy, place: Environment, ground: SinkerGround | None = None, **more: float
) -> Sizing:
    line = LineChoice(usual("chain"), "break/5", diameters=(0.038,), **more)  # type: ignore[arg-type]
    return size_buoy(BuoyRequest(body, place, line, ground or SinkerGround()))


@pytest.mark.parametrize(
    ("low", "room"), [(13.42, "1"), (13.62, "1.2"), (13.66, None), (20.0, None)]
)
def test_less_water_under_the_keel_than_a_tenth_of_the_draught_is_told(
    low: float, room: str | None
) -> None:
    """She draws 12.4 m: from 13.64 m of water on there is enough."""
    said = [each for each in of_a_ship(low).assumptions if "under-keel clearance" in each]
    assert said == (
        []
        if room is None
        else [
            f"Loaded, the under-keel clearance at low water is {room} m, less than a tenth "
            "of the draught: squat, waves and the accuracy of the survey matter."
        ]
    )


def test_each_condition_is_held_against_its_own_draught() -> None:
    """At 13.1 m there are 0.7 m below the loaded ship, and 6.9 m below her in ballast."""
    light = estimated_tanker("tanker", 234.0, 31.3, 6.2, moulded_depth=16.0, condition="ballast")
    ballast = MooredShip("ballast", light, "tanker ballast", 9.8)
    words = of_a_ship(13.1, LOADED, ballast).assumptions
    assert [each.split(",")[0] for each in words if "under-keel clearance" in each] == ["Loaded"]
    assert not any(is_said(each, "sizing.loaded_alone") for each in words)
    alone = of_a_ship(20.0).assumptions
    assert any(is_said(each, "sizing.loaded_alone") for each in alone)


@pytest.mark.parametrize(
    ("keel", "hs", "depth"),
    [
        (3.0, 2.0, "0.56"),  # 4 - 1.56 - 3: no wave is above 0.78 x 4 = 3.12 m
        (2.46, 2.0, "0.02"),
        (2.42, 2.0, None),  # 0.02 m are left
        (3.0, 1.0, None),  # 4 - 0.5 x 1.85 - 3 = 0.075
        (3.2, 1.0, "0.12"),  # -0.125
    ],
)
def test_a_buoy_that_reaches_the_bed_in_the_trough_is_told(
    keel: float, hs: float, depth: str | None
) -> None:
    place = Environment(WaterLevels(4.0, 12.0), sea=SeaState(8.0, hs))
    sized = of_a_buoy(GivenBuoy(3e3, 60e3, keel), place)
    said = [each for each in sized.assumptions if "trough" in each]
    assert len(said) == (depth is not None)
    for each in said:
        assert f"the buoy reaches {depth} m into the bed" in each


def test_a_buoy_that_just_clears_the_bed_in_the_trough_is_not_told_to_be_in_it() -> None:
    place = Environment(WaterLevels(4.0, 12.0), sea=SeaState(8.0, maximum_height=2.0))
    sized = of_a_buoy(GivenBuoy(3e3, 60e3, 3.0), place)
    assert not [each for each in sized.assumptions if "trough" in each]


def test_what_is_worn_off_is_told_in_mm() -> None:
    """Ten years of 0.3 mm are 3 mm; what does not wear stays as new."""
    place = Environment(WaterLevels(10.0, 12.0))
    year = 365.25 * 86400.0
    worn = of_a_buoy(GivenBuoy(3e3, 60e3), place, life=10.0 * year, wear_rate=0.3e-3 / year)
    assert any("lost 3 mm of diameter" in each for each in worn.assumptions)
    assert worn.case.service == Service(10.0 * year, 0.3e-3 / year)
    new = of_a_buoy(GivenBuoy(3e3, 60e3), place, life=0.0)
    assert "The line remains as new: no wear." in new.assumptions
    assert new.case.service is None


def test_a_buoy_below_the_weight_of_the_lightest_chain_is_refused() -> None:
    """14 mm have 3.8 kg/m, of steel of 7850 kg/m3: 32.4 N/m hang through 12 + 1.11 - 1 m.

    The mass is of IALA CALMAR, 7.2 (catopt/catalogue/data/buoy_chain.toml); Hmax/2 is
    1.85 x 1.2/2 = 1.11 m.
    """
    place = Environment(WaterLevels(10.0, 12.0), sea=SeaState(6.0, 1.2))
    line = LineChoice(usual("chain"), "break/5", life=0.0)
    weight = 3.8 * G * (1.0 - 1025.0 / 7850.0) * (12.0 + 1.11 - 1.0)

    def sized(reserve: float) -> Sizing:
        return size_buoy(BuoyRequest(GivenBuoy(1.0, reserve, 1.0), place, line))

    with pytest.raises(InputError) as caught:
        sized(0.999 * weight)
    (problem,) = caught.value.problems
    assert problem.key == "reserve_buoyancy"
    assert problem.found == f"{0.999e-3 * weight:.3g} kN"
    assert f"{weight / 1e3:.3g} kN: 12.1 m of chain open-link 4D Q2 14 mm" in problem.allowed
    # With no force to speak of the line hangs nearly straight down, and a little more holds it.
    above = sized(1.2 * weight)
    pulls = [each.fairlead.vertical_force for _, each in above.point.checks.solutions]
    assert 0.99 * weight < max(pulls) <= 1.2 * weight


def test_every_warning_begins_with_a_capital() -> None:
    """Those of the sinker are notes, which begin with a small letter where they stand alone."""
    ground = SinkerGround("IALA default")
    sized = of_a_buoy(GivenBuoy(3e3, 60e3), Environment(WaterLevels(10.0, 12.0)), ground)
    assert sized.sinker is not None
    assert len(sized.sinker.notes) == 2
    for note in sized.sinker.notes:
        assert note[0].islower()
        assert sum(each.lower().startswith(note.lower()) for each in sized.warnings) == 1
        assert not any(each.startswith(note) for each in sized.warnings)
    assert any(each.startswith("Density of concrete") for each in sized.warnings)


def test_a_step_that_fails_says_what_it_runs_into() -> None:
    """A check in its load case; where the line has no equilibrium, why it has none."""
    sized = size_tanker(TankerRequest((LOADED,), deep(), line=ONE_SIZE))
    (shorter,) = sized.limits
    assert shorter.check is not None
    assert shorter.reason == ""
    assert shorter.words == shorter.check.in_case
    assert shorter.check.load_case in shorter.words
    assert shorter.check.name in shorter.words
    assert Limit("chain: 20 m for 30 m", None, "too short to reach").words == "too short to reach"


def test_only_steps_to_less_that_fail_govern() -> None:
    """Of one size the length alone is stepped; a step more passes, and is not told."""
    sized = size_tanker(TankerRequest((LOADED,), deep(), line=ONE_SIZE))
    length = sized.point.line.length
    assert [each.change for each in sized.limits] == [
        f"chain: {length - 27.5:g} m instead of {length:g} m"
    ]
    for each in sized.limits:
        assert each.check is not None
        assert not each.check.passes


@pytest.mark.parametrize(
    ("other", "own", "said"),
    [
        ((110.0, 1e3), (100.0, 2e3), "10 m more swing, 10 %, for 1.0 t less chain, 50 %"),
        ((109.0, 3e3), (100.0, 2e3), "9.0 m more swing, 9.0 %, for 1.0 t more chain, 50 %"),
        ((99.0, 12e3), (100.0, 2e3), "1.0 m less swing, 1.0 %, for 10 t more chain, 500 %"),
        # 13/382 = 3.40 % and 8.4/11.05 = 76.0 %; 13/369 = 3.52 % and 8.4/19.45 = 43.2 %
        ((369.0, 19.45e3), (382.0, 11.05e3), "13 m less swing, 3.4 %, for 8.4 t more chain, 76 %"),
        ((382.0, 11.05e3), (369.0, 19.45e3), "13 m more swing, 3.5 %, for 8.4 t less chain, 43 %"),
        ((60.0, 2e3), (60.0, 2e3), "the recommended line"),
    ],
)
def test_a_trade_has_two_digits(
    other: tuple[float, float], own: tuple[float, float], said: str
) -> None:
    assert trade(*other, *own) == said


def test_a_buoy_s_crest_and_chain_are_told() -> None:
    """Hmax 3.5 m: a crest of 1.75 m. The loads are on the chain that is recommended, 70 mm."""
    body = buoy("mooring buoy 5.0 m")
    sized = size_tanker(TankerRequest((LOADED,), deep(), line=ONE_SIZE, buoy=body, hawser=40.0))
    (said,) = [each for each in sized.assumptions if "follows the waves" in each]
    assert "a crest of 1.75 m" in said
    assert "one chain of 70 mm" in said
    # The buoy's bottom is at its draught, of 16 t on 5 m: m/(rho pi D^2/4).
    keel = 16e3 / (1025.0 * math.pi * 5.0**2 / 4.0)
    heights = {name: each.fairlead_height for name, each in sized.point.checks.solutions}
    assert heights == pytest.approx(
        {
            "loaded, high water": 22.0 + 1.75 - keel,
            "loaded, low water": 20.0 - keel,
            "everyday": 22.0 - keel,
        },
        rel=1e-12,
    )
    assert [length for _, length in sized.swing.parts][1:] == [40.0, 234.0]


def test_water_without_a_tide_is_one_load_case_unless_there_is_a_crest() -> None:
    steady = dataclasses.replace(deep(), levels=WaterLevels.steady(22.0))
    at_the_bow = size_tanker(TankerRequest((LOADED,), steady, line=ONE_SIZE))
    assert [each.name for each in at_the_bow.case.load_cases] == ["loaded, high water", "everyday"]
    assert at_the_bow.swing.load_case == "loaded, high water"
    assert "hawser" not in {name for name, _ in at_the_bow.swing.parts}
    body = buoy("mooring buoy 5.0 m")
    at_a_buoy = size_tanker(TankerRequest((LOADED,), steady, line=ONE_SIZE, buoy=body))
    levels = {each.name: each.water_level for each in at_a_buoy.case.load_cases}
    assert levels == {"loaded, high water": 1.75, "loaded, low water": 0.0, "everyday": 0.0}
    assert "hawser" not in {name for name, _ in at_a_buoy.swing.parts}


def test_the_smallest_size_that_was_looked_at_is_told_where_a_smaller_one_is_sold() -> None:
    """With the bound at 70 mm a smaller size is sold; with it at the smallest of all none is."""
    bound = dataclasses.replace(
        ONE_SIZE, diameters=(), diameter_min=0.07, diameter_max=0.073, prefer="lightest"
    )
    said = size_tanker(TankerRequest((LOADED,), deep(), line=bound)).why
    assert said.startswith("It is the lightest line that passes. Its size is the smallest")
    assert "considered, 70 mm:" in said
    free = dataclasses.replace(ONE_SIZE, prefer="lightest")
    why = size_tanker(TankerRequest((LOADED,), deep(), line=free)).why
    assert why == "It is the lightest line that passes."


def test_a_line_says_by_what_it_is_recommended() -> None:
    """The ship is 234 m long, six depths are 132 m: a line spans no more than her length."""

    def why(prefer: str | None, **changes: object) -> str:
        wider: Any = {"diameters": (0.06, 0.07, 0.08), "prefer": prefer, **changes}
        line = dataclasses.replace(ONE_SIZE, **wider)
        return str(size_tanker(TankerRequest((LOADED,), deep(), line=line)).why)

    assert "a span of at most 234 m" in why("balanced")
    assert why("shortest").startswith("It is the shortest line that passes")
    assert "of at most 234 m, the usual practice" in why("practice")
    assert why(None) == why("practice")  # that of its code, "break/5"
    assert "the smallest swing" in why("least-swing")
    # With chains too thin for a span of 234 m none is short enough.
    thin = {"diameters": (0.036, 0.04), "code": "UFC-4-159-03", "life": usual("life", "tanker")}
    assert why("balanced", **thin).startswith("It has the least product of mass and area")
    assert why("practice", **thin).startswith("It is the shortest line that passes")
