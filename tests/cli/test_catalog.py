"""``catopt catalog``: what it shows, its document, its files and its exit status."""

from __future__ import annotations

import csv
import json
import re
from pathlib import Path
from typing import Any

import openpyxl
import pytest

from catopt import catalogue
from tests.catalogue.test_user_families import GOOD

from .conftest import Run
from .test_json import document_of

TEXT = {
    "Component", "Family", "Grade", "Grades", "Quantity", "Variant", "Default", "Formula",
    "Confidence", "Sources", "Place", "Reason", "Note", "Title", "Also", "Source",
    "Confidence of MBL", "Recalled, read in no document", "Confidence of the sizes",
    "Sources of the sizes",
}  # fmt: skip
COUNTS = {"Sizes"}

QUESTIONS = [
    ("list",),
    ("show", "chain studless", "R4", "--diameter", "76 mm"),
    ("show", "chain studless R4"),
    ("show", "chain stud-link"),
    ("show", "nylon", "--diameter", "64 mm"),
    ("show", "wire 6-strand wire-core", "--diameter", "0.09", "--recalled"),
    ("search", "--mbl", "500 kN"),
    ("search", "--mbl", "50 tf", "--family", "chain studless", "--all-sizes"),
]


def rows(path: Path) -> list[dict[str, str]]:
    with path.open(encoding="utf-8", newline="") as stream:
        return list(csv.DictReader(stream))


@pytest.fixture
def own(tmp_path: Path) -> Path:
    path = tmp_path / "own.toml"
    path.write_text(GOOD, encoding="utf-8")
    return path


# ------------------------------------------------------------------ what a reader sees


def test_list_names_every_family_grade_and_range(run: Run) -> None:
    shown = " ".join(run("catalog", "list").out.split())
    for family in catalogue.families():
        assert family.name in shown
        low, high = (f"{round(end * 1e3, 6):g}" for end in family.range)
        assert f"{low} to {high}" in shown
    for grade in ("U1", "ORQ", "R4S", "Q3"):
        assert grade in shown
    assert "R recalled, read in no document" in shown


def test_show_has_value_source_confidence_and_diameter_of_each_figure(run: Run) -> None:
    """R4 of 76 mm: MBL 6001 kN in Vryhof's table; drag on d and d/pi, added mass on 136.9 mm."""
    out = run("catalog", "show", "chain studless", "r4", "--diameter", "76 mm").out
    cells = [re.split(r"\s{2,}", line.strip()) for line in out.splitlines()]
    table = {row[0]: row[1:] for row in cells}
    assert table["Minimum breaking load MBL"] == ["6001.3 kN", "B", "DDJ, BEM, VRY, PIL, MP"]
    assert table["drag diameter d"] == ["76.0 mm"]
    assert table["drag diameter d/pi"] == ["24.2 mm"]
    assert table["volume-equivalent diameter"] == ["136.9 mm"]
    assert table["Drag coefficient across"][:2] == ["2.4", "B"]
    text = " ".join(out.split())
    assert "Nominal diameter d = 76 mm" in text
    assert "0.0274 d^2 (44 - 0.08 d) kN, d in mm; 19 mm to 185 mm" in text
    assert "EA=orcaflex" in text
    assert "VRY: Vryhof manual" in text


def test_show_without_grade_has_a_column_for_each(run: Run) -> None:
    out = run("catalog", "show", "chain studless").out
    (heading,) = [line for line in out.splitlines() if "ORQ" in line and "R4S" in line][:1]
    assert heading.split()[1:] == ["ORQ", "R3", "R3S", "R4", "R4S", "R5"]
    (row,) = [line for line in out.splitlines() if line.split()[:2] == ["76", "4621"]]
    assert row.split() == ["76", "4621", "4884", "5454", "6001", "6658", "7009"]


def test_what_is_recalled_is_said(run: Run) -> None:
    strict = run("catalog", "show", "wire 6-strand wire-core", "--diameter", "90 mm").out
    assert "Drag coefficient across" not in strict
    assert "only recalled, read in no document: ask for it with --recalled" in " ".join(
        strict.split()
    )
    asked = run("catalog", "show", "wire 6-strand wire-core", "--diameter", "90 mm", "--recalled")
    assert "Drag coefficient across" in asked.out
    assert "R, only recalled and read in no document: Drag across the line." in " ".join(
        asked.out.split()
    )
    found = run("catalog", "search", "--family", "wire 6-strand wire-core", "--recalled").out
    assert "R, only recalled and read in no document: Drag across the line." in " ".join(
        found.split()
    )


def test_a_recalled_list_of_sizes_is_said(run: Run) -> None:
    out = run("catalog", "search", "--mbl", "500 kN").out
    text = " ".join(out.split())
    assert "Sizes from lists that are only recalled (R): wire 6-strand wire-core, wire" in text
    chains = run("catalog", "search", "--mbl", "500 kN", "--family", "chain studless").out
    assert "recalled" not in chains
    assert "RECALLED" in run("catalog", "show", "HMPE").out


def test_search_is_from_the_lightest(run: Run) -> None:
    out = run("catalog", "search", "--mbl", "500 kN", "--family", "chain studless").out
    names = [line[:30].strip() for line in out.splitlines() if line.startswith("chain")]
    assert names == [
        "chain studless R4S 20.5 mm",
        "chain studless R5 20.5 mm",
        "chain studless R3S 22 mm",
        "chain studless R4 22 mm",
        "chain studless ORQ 24 mm",
        "chain studless R3 24 mm",
    ]


# ------------------------------------------------------------------ the document and the files


@pytest.mark.slow
@pytest.mark.parametrize("question", QUESTIONS, ids=" ".join)
def test_the_document_is_valid(run: Run, question: tuple[str, ...]) -> None:
    document = document_of(run, "catalog", *question)
    assert document["schema"] == "catopt.catalog/1"
    assert document["question"] == question[0]
    assert bool(document["components"]) == (question[0] != "list")
    keys = {source["key"] for source in document["sources"]}
    for component in document["components"]:
        for origin in component["provenance"]:
            assert set(origin["sources"]) <= keys


def test_the_document_has_what_python_gives(run: Run) -> None:
    document = document_of(
        run, "catalog", "show", "chain studless R4", "--diameter", "0.1", "--variant",
        "EA=orcaflex", "--variant", "price=tud", "--water-density", "1000 kg/m^3",
    )  # fmt: skip
    chain = catalogue.component(
        "chain studless R4",
        0.1,
        variants={"EA": "orcaflex", "price": "tud"},
        water_density=1000.0,
    )
    (shown,) = document["components"]
    assert shown["EA_N"] == chain.EA == pytest.approx(8.54e8, rel=1e-12)
    assert shown["price_USD_per_m"] == chain.price
    assert shown["submerged_weight_N_per_m"] == chain.submerged_weight
    assert shown["drag_normal"] == {"coefficient": 2.4, "diameter_m": 0.1, "diameter_name": "d"}


def test_out_writes_tables_with_units(run: Run, tmp_path: Path) -> None:
    ran = run("catalog", "search", "--mbl", "500 kN", "--json", "--out", tmp_path / "out")
    assert ran.status == 0
    names = {path.name for path in (tmp_path / "out").iterdir()}
    csvs = {"components.csv", "figures.csv", "families.csv", "sources.csv"}
    assert names == csvs | {"catalog.json", "catalog.xlsx"}
    assert ran.err == f"{len(names)} files written to {tmp_path / 'out'}\n"
    document: dict[str, Any] = json.loads(ran.out)
    assert document == json.loads((tmp_path / "out" / "catalog.json").read_text("utf-8"))
    for name in csvs:
        for heading in rows(tmp_path / "out" / name)[0]:
            assert heading in TEXT | COUNTS or heading.endswith(")"), heading
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
    book = openpyxl.load_workbook(tmp_path / "out" / "catalog.xlsx")
    assert book.sheetnames == ["Components", "Figures", "Families", "Sources"]
    assert book["Components"].max_row == 1 + len(components)


def test_list_writes_no_components(run: Run, tmp_path: Path) -> None:
    assert run("catalog", "list", "--out", tmp_path).status == 0
    assert not (tmp_path / "components.csv").exists()
    assert len(rows(tmp_path / "families.csv")) == len(catalogue.families())


# ------------------------------------------------------------------ one's own families


def test_one_s_own_families_stand_beside_catopt_s(run: Run, own: Path) -> None:
    assert "aramid rope" in run("catalog", "list", "--families", own).out
    shown = document_of(
        run, "catalog", "show", "aramid rope T1", "--diameter", "40 mm", "--families", own
    )
    assert shown["components"][0]["mass_kg_per_m"] == 1.4
    found = document_of(
        run, "catalog", "search", "--mbl", "3 MN", "--family", "aramid rope", "--families", own
    )
    assert [component["grade"] for component in found["components"]] == ["T1", "T2"]


def test_a_broken_file_of_families_is_2_with_every_error(run: Run, own: Path) -> None:
    own.write_text(GOOD.replace("1440", "0").replace('confidence = "C"', ""), encoding="utf-8")
    ran = run("catalog", "list", "--families", own, "--json")
    assert (ran.status, ran.out) == (2, "")
    assert "3 errors" in ran.err
    assert "figure[1].formula.density: found 0; must be above 0" in ran.err
    assert "figure[3].confidence: missing" in ran.err


# ------------------------------------------------------------------ what goes wrong


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["show", "chain studles"], 'FAMILY: found "chain studles"; did you mean'),
        (["show", "chain studless", "R6"], 'GRADE: found "R6"; one of ORQ, R3'),
        (["show", "chain studless", "--diameter", "76 mm"], "GRADE: missing; one of ORQ, R3"),
        (
            ["show", "chain studless R3", "--diameter", "200 mm"],
            "--diameter: found 200 mm; chain studless is known from 19 mm to 185 mm",
        ),
        (["show", "chain studless R3", "--diameter", "76"], "did you mean 0.076?"),
        (
            ["show", "chain studless R3", "--diameter", "76 kN"],
            '--diameter: found "76 kN", a force',
        ),
        (["show", "polyester", "--variant", "EA"], '--variant: found "EA"; QUANTITY=NAME'),
        (["show", "polyester", "--variant", "EA=x"], '--variant EA: found "x"; one of moorpy'),
        (
            ["show", "wire spiral-strand", "--variant", "EA=dnv-os-e301"],
            '--variant EA: found "dnv-os-e301"; only recalled',
        ),
        (["show", "polyester", "--water-density", "0"], "--water-density: found 0"),
        (["search", "--mbl", "-5 kN"], "--mbl: found -5000"),
        (["search", "--mbl", "5 t"], '--mbl: found "5 t", a mass; a force is wanted: write'),
        (["search", "--family", "chainn"], '--family: found "chainn"'),
        (["search", "--grade", "R9"], '--grade: found "R9"; one of U1'),
        (["list", "--families", "gone.toml"], "gone.toml: 1 error"),
    ],
)
def test_a_user_s_mistake_is_2_and_told_by_the_option(
    run: Run, arguments: list[str], message: str
) -> None:
    ran = run("catalog", *arguments, "--json")
    assert (ran.status, ran.out) == (2, "")
    assert message in " ".join(ran.err.split())
    assert "Traceback" not in ran.err


def test_nothing_found_is_3_and_names_the_strongest(run: Run) -> None:
    """Chain studless of grade R3 ends with 185 mm and 22286 kN."""
    ran = run("catalog", "search", "--mbl", "30 MN", "--family", "chain studless R3", "--json")
    assert (ran.status, ran.out) == (3, "")
    assert "no component fits; the strongest that was searched is chain studless R3 185 mm" in (
        " ".join(ran.err.split())
    )
    assert "22286.0 kN" in ran.err
