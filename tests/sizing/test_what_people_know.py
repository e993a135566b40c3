"""A sizing from what people know: a deadweight, a wind with its mean, mud, two rules of sinkers."""

from __future__ import annotations

import pytest

from catopt.answers.size import size_answer
from catopt.constants import STANDARD_GRAVITY
from catopt.errors import InputError
from catopt.render.files import csv_files
from catopt.sizing.environment import mean_over
from catopt.sizing.input_values import input_values
from catopt.sizing.requests import request_of
from catopt.sizing.result import Sizing
from catopt.sizing.tanker_request import TankerRequest
from tests.sizing.at_rest import size_buoy, size_tanker

SHIP = {"length": 234.0, "breadth": 31.3, "draught": 12.4, "depth": 20.0}


def requested(**inputs: object) -> TankerRequest:
    request = request_of(input_values("tanker", inputs))
    assert isinstance(request, TankerRequest)
    return request


def test_a_deadweight_gives_the_dimensions_and_each_is_marked() -> None:
    request = requested(dwt="50000 t", depth="20 m")
    ship = request.ships[0].ship
    assert (ship.length_overall, ship.breadth, ship.draught) == (210.0, 32.2, 12.6)
    origins = {each.of.name: each.origin for each in request.inputs}
    estimated = {name for name, origin in origins.items() if origin == "estimated"}
    assert estimated == {"length", "breadth", "draught", "moulded_depth"}
    assert origins["dwt"] == origins["depth"] == "given"
    assert origins["wind"] == "taken"
    assert not {"hawser", "pretension"} & origins.keys()  # neither buoy nor several lines


def test_what_is_given_is_not_estimated() -> None:
    request = requested(dwt="50000 t", depth="20 m", draught="12.4 m", length="234 m")
    ship = request.ships[0].ship
    assert (ship.length_overall, ship.breadth, ship.draught) == (234.0, 32.2, 12.4)
    assert {e.of.name for e in request.inputs if e.origin == "estimated"} == {"breadth"}


def test_a_bare_deadweight_is_in_tonnes() -> None:
    assert requested(dwt=50000, depth=20.0).ships[0].deadweight == 50e6
    assert requested(dwt="50000000 kg", depth=20.0).ships[0].deadweight == 50e6


def test_the_kind_of_ship_has_its_own_table_wind_and_propeller() -> None:
    cargo = requested(ship="general cargo", dwt="20000 t", depth="20 m").ships[0]
    assert (cargo.ship.length_overall, cargo.ship.draught) == (166.0, 10.0)
    assert (cargo.wind_on, cargo.ship.propeller) == ("cargo loaded", "cargo")


@pytest.mark.parametrize(
    ("tonnes", "allowed"),
    [
        (50.0, r"below 0\.4 of what .* displaces, 72238\.3 t"),
        (28_800.0, r"below 0\.4 of what .* displaces, 72238\.3 t"),
        (72_300.0, r"not below what .* displaces, 72238\.3 t"),
    ],
)
def test_a_deadweight_is_held_against_the_displacement_from_both_sides(
    tonnes: float, allowed: str
) -> None:
    """0.80 x 0.97 x 234 x 31.3 x 12.4 x 1.025 = 72,238 t, of which 0.4 is 28,895 t."""
    with pytest.raises(InputError, match=allowed):
        requested(**SHIP, dwt=tonnes)
    assert requested(**SHIP, dwt=28_900).ships[0].deadweight == 28.9e6
    assert requested(**SHIP, dwt=72_200).ships[0].deadweight == 72.2e6


@pytest.mark.parametrize(
    ("hourly", "ratios"),
    [
        (20.0, {600.0: 1.082, 60.0: 1.187, 30.0: 1.219, 3.0: 1.324}),
        (30.0, {600.0: 1.101, 60.0: 1.231, 30.0: 1.270, 3.0: 1.399}),
    ],
)
def test_the_mean_of_a_wind_is_converted_by_the_printed_ratios(
    hourly: float, ratios: dict[float, float]
) -> None:
    """NPD/ISO over the mean of an hour (engineering facts, second sheet, 6), to three digits."""
    for time, ratio in ratios.items():
        assert mean_over(hourly, 3600.0, time) / hourly == pytest.approx(ratio, abs=5.1e-4)
        back = mean_over(mean_over(hourly, 3600.0, time), time, 3600.0)
        assert back == pytest.approx(hourly, rel=1e-12)


def test_a_wind_of_ten_minutes_is_raised_and_the_answer_says_so() -> None:
    """U0 = 20: 1.082 x 20 = 21.64 m/s over 10 min is 1.219 x 20 = 24.38 m/s over 30 s."""
    request = requested(dwt="50000 t", depth="20 m", wind="21.64 m/s", wind_mean="10 min")
    assert request.environment.wind.speed == pytest.approx(24.38, abs=0.02)
    (said,) = [each for each in request.estimates if "averaged over 10 min" in each]
    assert said.startswith("Wind of 21.64 m/s averaged over 10 min is 24.38 m/s averaged over 30 s")
    assert requested(dwt="50000 t", depth="20 m", wind=25.0).environment.wind.speed == 25.0


def test_mud_is_soft_clay_to_a_drag_anchor() -> None:
    request = requested(dwt="50000 t", depth="20 m", soil="mud")
    assert request.ground.soil == "soft clay"
    assert any("mud taken as soft clay" in each for each in request.defaults)
    on_sinker = requested(dwt="50000 t", depth="20 m", anchor="sinker", soil="mud")
    assert on_sinker.ground.soil == "soft clay"
    assert "sinker's base as for a cast block, half as high as wide" in on_sinker.defaults


def test_soft_ground_never_gets_the_smaller_sinker() -> None:
    """Each found by the whole way: mud used to get 4 t by CALMAR's friction of 1.0, sand 12 t."""
    masses, said = [], []
    for soil in ("rock", "sand", "mud"):
        sizing = size_buoy(buoy="pillar 2.4 m", depth="15 m", soil=soil)
        assert sizing.sinker is not None
        assert sizing.point.anchor is not None
        assert sizing.point.anchor.mass == sizing.sinker.mass
        masses.append(sizing.sinker.mass)
        said.append((*sizing.defaults, *sizing.departures))
        # What a tender lifts: 9.80665 (1 - 1025/2400) N of each kg of concrete, and the chain.
        line = sizing.point.line
        assert line.mass is not None
        hung = masses[-1] * 9.80665 * (1.0 - 1025.0 / 2400.0)
        hung += line.length * line.segments[0].submerged_weight
        answer = csv_files(size_answer(sizing))
        (lifted,) = (
            row
            for text in answer.values()
            for row in text.decode("utf-8-sig").splitlines()
            if row.startswith("Lifting weight")
        )
        assert (
            f"{(masses[-1] + line.mass) / 1e3:.3g} t in air, {hung / 1e3:.3f} kN suspended"
            in lifted
        )
    assert masses == sorted(masses)
    assert masses[2] > masses[1]
    assert "sand taken as fine or silty sand, the weakest of its kind" in said[1]
    assert "sinker on clay by friction 0.25 and no more than 10 kPa on its base" in said[2]


def test_a_sinker_by_both_rules() -> None:
    """IALA's is mu = 1; of silty sand NAVFAC has 0.30 under formed concrete."""
    sizing = size_buoy(buoy="pillar 1.8 m", depth="12 m")
    own, other = sizing.sinker, sizing.other_sinker
    assert own is not None
    assert other is not None
    assert (own.friction, other.friction) == (1.0, 0.30)
    H, V = own.horizontal_force, own.vertical_force
    unit = STANDARD_GRAVITY * (1.0 - 1025.0 / 2400.0)
    assert own.needed_mass == pytest.approx((1.5 * H + V) / unit, rel=1e-12)
    assert other.needed_mass == pytest.approx((1.5 * H / 0.30 + V) / unit, rel=1e-12)
    assert other.mass > 2.0 * own.mass >= 2.0 * own.needed_mass


@pytest.fixture(scope="module")
def lightest() -> Sizing:
    return size_tanker(dwt="50000 t", depth="20 m", prefer="lightest")


def test_the_lightest_line_that_passes_is_recommended(lightest: Sizing) -> None:
    masses = [point.objectives["mass_kg"] for point in lightest.settled.result.front]
    assert lightest.point.objectives["mass_kg"] == min(masses)
    assert lightest.point.checks.passes


def test_the_bound_that_the_lightest_line_stands_at_is_told(lightest: Sizing) -> None:
    bound = size_tanker(dwt="50000 t", depth="20 m", diameter_min="60 mm", prefer="lightest")
    assert bound.point.line.segments[0].nominal_diameter == pytest.approx(0.06, abs=1e-12)
    said = "the smallest considered, 60 mm: a smaller one may be lighter"
    assert said in bound.why
    assert "smallest" not in lightest.why
    assert lightest.point.objectives["mass_kg"] < bound.point.objectives["mass_kg"]


def test_the_other_lines_stand_beside_it_each_under_its_own_loads(lightest: Sizing) -> None:
    balanced, least = lightest.alternatives  # of one component the cheapest is the lightest
    assert (balanced.prefer, least.prefer) == ("balanced", "least-swing")
    assert least.swing
    assert balanced.swing
    assert least.swing < balanced.swing < lightest.swing.total
    for each in (balanced, least):
        assert each.settled is not None
        assert each.settled.point.checks.passes
        same = size_tanker(dwt="50000 t", depth="20 m", prefer=each.prefer)
        assert same.swing.total == pytest.approx(each.swing, rel=1e-12)
        assert same.point.line.mass == pytest.approx(each.mass, rel=1e-12)
