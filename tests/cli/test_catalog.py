"""``catopt catalog``: what it shows, its document and its exit status."""

from __future__ import annotations

from pathlib import Path

import pytest

from catopt import catalogue

from .commands import QUESTIONS
from .conftest import Run, document_of, rows, typed, words


def test_list_names_every_family_and_range(run: Run, tmp_path: Path) -> None:
    shown = words(run("catalog", "list", "--out", tmp_path).out)
    for family in catalogue.families():
        assert family.name in shown
        low, high = (f"{round(end * 1e3, 6):g}" for end in family.range)
        assert f"{low} to {high}" in shown
    assert len(rows(tmp_path / "families.csv")) == len(catalogue.families())


def test_show_without_grade_has_a_column_for_each(run: Run) -> None:
    out = run("catalog", "show", "chain studless").out
    (heading,) = [line for line in out.splitlines() if "ORQ" in line and "R4S" in line][:1]
    assert heading.split()[1:] == ["ORQ", "R3", "R3S", "R4", "R4S", "R5"]


def test_search_is_from_the_lightest(run: Run) -> None:
    out = run("catalog", "search", "--mbl", "500 kN", "--family", "chain studless").out
    found = [line[:30].strip() for line in out.splitlines() if line.startswith("chain")]
    sizes = ["R4S 20.5 mm", "R5 20.5 mm", "R3S 22 mm", "R4 22 mm", "ORQ 24 mm", "R3 24 mm"]
    assert found == [f"chain studless {size}" for size in sizes]


@pytest.mark.slow
@pytest.mark.parametrize("question", QUESTIONS)
def test_the_document_is_valid(run: Run, question: str) -> None:
    document = document_of(run, *typed(question))
    assert question.split()[1] == document["question"]
    assert bool(document["components"]) == (document["question"] != "list")
    keys = {source["key"] for source in document["sources"]}
    for component in document["components"]:
        for origin in component["provenance"]:
            assert set(origin["sources"]) <= keys


def test_the_document_has_what_python_gives(run: Run) -> None:
    document = document_of(
        run, "catalog", "show", "chain studless R4", "--diameter", "0.1", "--variant",
        "EA=orcaflex", "--variant", "price=tud", "--water-density", "1000 kg/m^3",
    )  # fmt: skip
    variants = {"EA": "orcaflex", "price": "tud"}
    chain = catalogue.component("chain studless R4", 0.1, variants=variants, water_density=1000.0)
    (shown,) = document["components"]
    assert shown["EA_N"] == chain.EA == pytest.approx(8.54e8, rel=1e-12)
    assert shown["price_USD_per_m"] == chain.price
    assert shown["submerged_weight_N_per_m"] == chain.submerged_weight
    assert shown["drag_normal"] == {"coefficient": 2.4, "diameter_m": 0.1, "diameter_name": "d"}


def test_every_figure_in_the_files_has_its_source(run: Run, tmp_path: Path) -> None:
    search = ("catalog", "search", "--mbl", "500 kN", "--out", tmp_path / "out")
    document = document_of(run, *search)
    components = rows(tmp_path / "out" / "components.csv")
    assert [row["Component"] for row in components] == [c["name"] for c in document["components"]]
    for row, component in zip(components, document["components"], strict=True):
        # Relative: one division by 1000.
        assert float(row["Minimum breaking load in water (kN)"]) == pytest.approx(
            component["MBL_in_water_N"] / 1e3, rel=1e-15
        )
    for row in rows(tmp_path / "out" / "figures.csv"):
        assert row["Confidence"] in "ABCR"
        assert row["Sources"]
        assert row["Place"]
