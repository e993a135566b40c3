"""Components of the catalogue in a case file."""

from __future__ import annotations

import json
import math
import subprocess
import sys
from pathlib import Path

import pytest

from catopt import catalogue
from catopt.casefile import parse_case, read_case
from catopt.errors import InputError

SITE = """
[site]
water_depth = 20
{site}
[[line.segments]]
length = 100
{segment}
[load]
horizontal_force = 1e5
"""

CHAIN = 'component = "studless chain r3"\ndiameter = "76 mm"\n'


def case(segment: str, site: str = "", rest: str = "") -> str:
    return SITE.format(segment=segment, site=site) + rest


def test_length_component_and_diameter_are_enough() -> None:
    """Vryhof's manual: studless R3 of 76 mm breaks at 4884 kN; 20.0 d^2 t/m make 115.5 kg/m."""
    (segment,) = parse_case(case(CHAIN)).line.segments
    assert (segment.component, segment.nominal_diameter) == ("chain studless R3", 0.076)
    assert segment.name == "chain studless R3 76 mm"
    assert segment.MBL == pytest.approx(4884e3, rel=2e-3)  # 22.3 d^2 (44 - 80 d) is rounded
    assert segment.mass == pytest.approx(20e3 * 0.076**2, rel=1e-12)  # one product
    assert segment.proof_load is not None
    assert segment.price is not None
    assert math.isfinite(segment.EA)


def test_figures_that_are_given_go_before_those_of_the_catalogue() -> None:
    own = CHAIN + (
        'name = "bed chain"\nsubmerged_weight = "1 kN/m"\nmass = 120\nEA = "500 MN"\n'
        'MBL = "5 MN"\nproof_load = "3 MN"\nprice = "400 USD/m"\nwear_rate = "0.2 mm/year"\n'
    )
    (segment,) = parse_case(case(own)).line.segments
    assert (segment.submerged_weight, segment.mass, segment.EA) == (1000.0, 120.0, 5e8)
    assert (segment.MBL, segment.proof_load, segment.price) == (5e6, 3e6, 400.0)
    assert segment.name == "bed chain"
    assert segment.component == "chain studless R3"
    assert segment.wear_rate == pytest.approx(0.2e-3 / (365.25 * 86400), rel=1e-15)


def test_the_weight_is_in_the_water_of_the_site() -> None:
    """Of 1000 instead of 1025 kg/m3 the chain displaces 25 kg/m3 less: steel of about 7850."""
    salt = parse_case(case(CHAIN)).line.segments[0]
    fresh = parse_case(case(CHAIN, site="water_density = 1000")).line.segments[0]
    assert salt.mass is not None
    more = (fresh.submerged_weight - salt.submerged_weight) / 9.80665
    # The volume is the mass over the density of steel, which sources give within 2 %.
    assert more == pytest.approx(25.0 * salt.mass / 7850.0, rel=0.02)


def test_the_strength_of_nylon_is_that_in_water() -> None:
    text = case('component = "nylon"\ndiameter = "80 mm"\n')
    (segment,) = parse_case(text).line.segments
    dry = catalogue.component("nylon", 0.08).MBL
    assert dry is not None
    assert segment.MBL == pytest.approx(0.85 * dry, rel=1e-15)


def test_a_variant_holds_for_the_components_that_have_it() -> None:
    """Polyester has no EA of DNV's edition of 2000 and keeps its own."""
    two = CHAIN + '[[line.segments]]\nlength = 50\ncomponent = "polyester"\ndiameter = "160 mm"\n'
    variants = '[catalogue.variants]\nEA = "dnv-os-e301-2000"\n'
    plain, chosen = (parse_case(case(two, rest=rest)).line for rest in ("", variants))
    older = {"EA": "dnv-os-e301-2000"}
    chain = catalogue.component("chain studless R3", 0.076, variants=older)
    assert chosen.segments[0].EA == chain.EA != plain.segments[0].EA
    assert chosen.segments[1] == plain.segments[1]


def test_families_of_ones_own_count_from_the_folder_of_the_case(tmp_path: Path) -> None:
    (tmp_path / "own.toml").write_text(OWN, encoding="utf-8")
    text = case('component = "test rope"\ndiameter = "50 mm"', rest='[catalogue]\nfile="own.toml"')
    (tmp_path / "case.toml").write_text(text, encoding="utf-8")
    read = read_case(tmp_path / "case.toml")
    assert read.line.segments[0].mass == pytest.approx(2.0, rel=1e-12)  # 800 x 0.05^2
    assert read.catalogue.file == str(tmp_path / "own.toml")
    with pytest.raises(InputError, match=r'component: found "test rope"; .*catopt catalog list'):
        parse_case(case('component = "test rope"\ndiameter = "50 mm"'))


OWN = """
schema = "catopt.families/1"
[sources.OWN]
title = "Made up"
place = "nowhere"
[[family]]
name = "test rope"
title = "Rope of a test"
range_mm = [10, 100]
[[figure]]
family = "test rope"
quantity = "mass"
formula = { d2 = 800.0 }
source = "OWN"
place = "page 1"
confidence = "C"
[[figure]]
family = "test rope"
quantity = "volume_diameter"
formula = { density = 1380 }
source = "OWN"
place = "page 1"
confidence = "C"
"""


def test_a_file_of_families_is_read_even_when_no_component_is_named() -> None:
    with pytest.raises(
        InputError, match=r'catalogue.file: found "gone.toml"; there is no such file'
    ):
        parse_case(case("submerged_weight = 5", rest='[catalogue]\nfile = "gone.toml"\n'))


def test_a_segment_without_MBL_in_the_catalogue_has_no_limit_force(tmp_path: Path) -> None:
    (tmp_path / "own.toml").write_text(OWN, encoding="utf-8")
    sought = '[catalogue]\nfile = "own.toml"\n[find]\nquantity = "limit_force"\n'
    text = case('component = "test rope"\ndiameter = "50 mm"', rest=sought)
    text = text.replace("[load]\nhorizontal_force = 1e5\n", "")
    with pytest.raises(InputError, match="at least one segment needs its MBL"):
        parse_case(text, folder=str(tmp_path))
    strong = text.replace("test rope", "polyester").replace("50 mm", "160 mm")
    assert parse_case(strong, folder=str(tmp_path)).find is not None


@pytest.mark.parametrize(("segment", "is_read"), [("submerged_weight = 5", False), (CHAIN, True)])
def test_the_catalogue_is_read_only_where_a_component_is_named(segment: str, is_read: bool) -> None:
    code = (
        "import json, sys; from catopt.casefile import parse_case;"
        f"parse_case({case(segment)!r});"
        "print(json.dumps(['catopt.catalogue' in sys.modules, 'numpy' in sys.modules]))"
    )
    run = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=60
    )
    assert json.loads(run.stdout) == [is_read, False]
