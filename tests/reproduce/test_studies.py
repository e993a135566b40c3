"""What all studies have in common."""

from __future__ import annotations

import math
import re
from pathlib import Path

import jsonschema
import pytest

from catopt.figures.studies import lines_to_scale
from catopt.report.bundle import reproduction_pictures
from catopt.reproduce import book, names, reproduce
from catopt.reproduce.items import compare, published
from catopt.reproduce.reference_moorings import contact_offset
from catopt.schemas import schema

NAMES = (
    "buoy_9p5m",
    "ship_200m",
    "tanker_20m",
    "tanker_20m_loads",
    "tanker_20m_sinker",
    "load_sharing",
    "fso_rang_dong",
    "fso_rang_dong_loads",
    "fso_rang_dong_dynamic",
    "oc3",
    "oc4",
    "volturnus",
    "steep_chain",
    "hanging_cable",
    "moordyn_line",
    "bridle",
    "chain_in_waves",
    "cable_in_waves",
    "calmar",
)
WITHOUT_SWARM = NAMES[1:]
STUDIES = [
    pytest.param(name, marks=[pytest.mark.slow] if name.endswith("dynamic") else [])
    for name in WITHOUT_SWARM
]
"""The nine lines in a storm run for half a minute."""


def test_the_names() -> None:
    assert names() == NAMES


@pytest.mark.parametrize("name", STUDIES)
def test_the_document_keeps_to_its_schema(name: str) -> None:
    document = reproduce(name).to_dict()
    jsonschema.validate(document, schema("catopt.reproduction/1"))
    assert {item["name"] for item in document["items"]} == {name}


@pytest.mark.parametrize("name", ["ship_200m", "tanker_20m", "tanker_20m_sinker"])
def test_every_figure_of_the_page_is_among_the_files(name: str) -> None:
    reproduction = reproduce(name)
    shown = re.findall(r"!\[.*?\]\((.*?)\)", book(reproduction))
    files = reproduction_pictures(reproduction)
    assert shown == [f"{name}_lines.svg"]
    assert set(shown) <= set(files)


def test_a_figure_of_a_study_is_to_scale_and_shows_every_line_from_anchor_to_fairlead() -> None:
    """Spans by the logarithms of S2 for its first two lines, whose anchors are level."""
    (study,) = reproduce("ship_200m").studies
    drawn_lines = [(each.name, each.solution) for each in study.drawn]
    chart = lines_to_scale(drawn_lines, 200.0)
    drawn = {each.label: list(zip(each.x, each.y, strict=True)) for each in chart.series}
    spans = {"under 300 kN": 200 + 300 * math.log(3), "under 800 kN": 800 * math.log(2)}
    for name, span in spans.items():
        assert drawn[name][0] == pytest.approx((0.0, 0.0), abs=1e-9)
        assert drawn[name][-1] == pytest.approx((span, 200.0), rel=1e-9)
    assert "under 800 kN, with the sinker" in drawn
    assert chart.to_scale == 1.0


@pytest.mark.parametrize("name", STUDIES)
def test_every_number_of_the_source_is_judged_once(name: str) -> None:
    printed = [
        (method, quantity)
        for method, table in published(name).printed.items()
        for quantity in table
    ]
    items = reproduce(name).items
    assert [(item.method, item.quantity) for item in items] == printed
    assert all(item.note for item in items if item.verdict != "reproduces")


@pytest.mark.parametrize(
    ("name", "tally"),
    [
        ("ship_200m", "Of 10 printed numbers 7 reproduce, 3 differ and 0 cannot be reproduced."),
        ("tanker_20m", "Of 11 printed numbers 11 reproduce, 0 differ and 0 cannot be reproduced."),
        (
            "tanker_20m_sinker",
            "Of 10 printed numbers 0 reproduce, 10 differ and 0 cannot be reproduced.",
        ),
        ("load_sharing", "Of 3 printed numbers 3 reproduce, 0 differ and 0 cannot be reproduced."),
        (
            "fso_rang_dong",
            "Of 94 printed numbers 25 reproduce, 69 differ and 0 cannot be reproduced.",
        ),
        ("oc3", "Of 12 printed numbers 7 reproduce, 5 differ and 0 cannot be reproduced."),
        ("oc4", "Of 11 printed numbers 4 reproduce, 7 differ and 0 cannot be reproduced."),
        ("volturnus", "Of 2 printed numbers 1 reproduce, 1 differ and 0 cannot be reproduced."),
        ("steep_chain", "Of 5 printed numbers 5 reproduce, 0 differ and 0 cannot be reproduced."),
        ("hanging_cable", "Of 8 printed numbers 4 reproduce, 4 differ and 0 cannot be reproduced."),
        ("bridle", "Of 9 printed numbers 9 reproduce, 0 differ and 0 cannot be reproduced."),
        ("moordyn_line", "Of 2 printed numbers 0 reproduce, 2 differ and 0 cannot be reproduced."),
        (
            "chain_in_waves",
            "Of 12 printed numbers 0 reproduce, 12 differ and 0 cannot be reproduced.",
        ),
        (
            "cable_in_waves",
            "Of 8 printed numbers 7 reproduce, 1 differ and 0 cannot be reproduced.",
        ),
        ("calmar", "Of 28 printed numbers 28 reproduce, 0 differ and 0 cannot be reproduced."),
        pytest.param(
            "fso_rang_dong_dynamic",
            "Of 30 printed numbers 0 reproduce, 0 differ and 30 cannot be reproduced.",
            marks=pytest.mark.slow,
        ),
    ],
)
def test_the_tally(name: str, tally: str) -> None:
    assert reproduce(name).tally == tally


@pytest.mark.parametrize("name", STUDIES)
def test_the_page_has_a_heading_for_each_method(name: str) -> None:
    reproduction = reproduce(name)
    page = book(reproduction)
    headings = re.findall(r"^### (.+)$", page, re.MULTILINE)
    methods = [method[:1].upper() + method[1:] for method in published(name).printed]
    found = ["What was found"] if reproduction.studies[0].findings else []
    assert headings == [*methods, *found]


def test_a_printed_number_that_nothing_was_computed_for_is_a_fault() -> None:
    with pytest.raises(KeyError, match="FT_over_F_8_lines"):
        compare(published("load_sharing"), "N/4 rule", {"FT_over_F_6_lines": 1.5})


@pytest.mark.slow
def test_the_documentation_counts_right() -> None:
    page = Path(__file__).parents[2] / "docs" / "reproduction.md"
    row = re.compile(r"^\| `(\w+)` \|.*\| (\d+) \| (\d+) \|$", re.MULTILINE)
    counted = [
        (study.name, len(study.items), sum(i.verdict == "reproduces" for i in study.items))
        for study in reproduce().studies
    ]
    rows = row.findall(page.read_text(encoding="utf-8"))
    assert [(name, int(all_), int(good)) for name, all_, good in rows] == counted


def test_what_explains_the_reports_of_turbines_is_computed() -> None:
    """Derivatives and differences part in the third order of the step; 613 has 631's digits."""
    (oc3,) = reproduce("oc3").studies
    said = " ".join(oc3.findings)
    assert "over 0.03 rad give -2.820 and 311.1 MN m/rad in roll, over 1 m of surge -2.816" in said
    left = next(item for item in oc3.items if item.quantity == "anchor_horizontal_force_N")
    # 736939.290 - 0.001 x 698.0945 x 134.785
    assert "736845.197 N" in left.note
    (oc4,) = reproduce("oc4").studies
    assert any("3 x 631 kN by equilibrium" in item.note for item in oc4.items)
    (volturnus,) = reproduce("volturnus").studies
    # 2435.5597 kN at 9.80665 m/s2, by MoorPy; at 9.81 the whole line is 0.034 % heavier
    assert "2409.0, 2436.4, 2445.7 kN" in " ".join(volturnus.findings)


def test_chains_beside_orcaflex_and_moordyn() -> None:
    """Closed form with its offset: 0.2345 m - 3323 N/m / (100 kN/m3 x 0.469 m).

    Largest tensions: within 6 % of the print and nearer to it than MoorDyn's, whose are 2.7, 3.8,
    1.3 and 6.7 % above it.
    """
    assert contact_offset() == pytest.approx(0.2345 - 3323.2 / (1e5 * 0.469), abs=1e-4)
    (study,) = reproduce("chain_in_waves").studies
    found = {item.quantity: item for item in study.items}
    for quantity, without in (
        ("fairlead_tension_50m_kN", 1001.7),
        ("anchor_tension_50m_kN", 835.6),
        ("fairlead_tension_600m_kN", 5236.2),
        ("anchor_tension_600m_kN", 3247.3),
    ):
        item = found[quantity]
        assert item.computed == pytest.approx(item.published, rel=2e-3)
        assert f"it would be {without} kN" in item.note
    theirs = {
        "50m_heave_2m": 2.67,
        "50m_heave_5m": 3.79,
        "600m_heave_2m": 1.28,
        "600m_heave_5m": 6.71,
    }
    for run, percent in theirs.items():
        item = found[f"max_{run}_kN"]
        assert item.computed is not None
        off = 100.0 * abs(item.computed / item.published - 1.0)
        assert off < min(6.0, percent)
        assert f"(+{percent} %), further from the print" in item.note
    assert "nearer to it than MoorDyn's in 4 of 4 runs" in study.findings[1]
    assert "friction" in study.findings[2]
