"""A catalogue of one's own from a table: its figures come back, and what is wrong is told."""

from __future__ import annotations

import math
from pathlib import Path

import openpyxl
import pytest

from catopt import InputError, catalogue, read_case

HEADINGS = (
    "family,grade,diameter (mm),mass (kg/m),density (kg/m^3),MBL (kN),Proof load (tf),"
    "price (USD/m),source"
)
ROWS = (
    "works chain,G3,28,17.2,7850,660,33,,Certificate 4712",
    "works chain,G3,20,8.76,7850,342,17.1,30,Certificate 4711",
    "works chain,G2,20,8.76,7850,244,,28,Certificate 4711",
    "rope,,40,1.1,1380,380,,,Works table",
)


def written(folder: Path, *rows: str, headings: str = HEADINGS, name: str = "stock.csv") -> Path:
    path = folder / name
    path.write_text("\n".join([headings, *rows]) + "\n", encoding="utf-8")
    return path


def check(path: Path) -> None:
    """Compare with the rows, and with d^2 between them."""
    found = catalogue.read_families(path)
    chain = found.component("works chain G3", "20 mm")
    assert chain.MBL == pytest.approx(342e3)
    assert chain.proof_load == pytest.approx(17.1e3 * 9.80665)
    assert chain.volume_diameter == pytest.approx(math.sqrt(4.0 * 8.76 / (math.pi * 7850.0)))
    # Halfway in diameter, value/d^2 is halfway.
    between = found.component("works chain G3", "24 mm")
    assert between.mass == pytest.approx(0.5 * (8.76 / 20.0**2 + 17.2 / 28.0**2) * 24.0**2)
    weaker = found.component("works chain G2", "20 mm")
    assert weaker.MBL == pytest.approx(244e3)
    assert weaker.proof_load is None
    rope = found.component("rope", "40 mm")
    assert (rope.mass, rope.MBL) == pytest.approx((1.1, 380e3))


def test_a_table_of_text_is_read(tmp_path: Path) -> None:
    check(written(tmp_path, *ROWS))


def test_a_workbook_is_read_alike(tmp_path: Path) -> None:
    book = openpyxl.Workbook()
    sheet = book.active
    assert sheet is not None
    for line in (HEADINGS, *ROWS):
        cells = line.split(",")
        sheet.append(
            [
                float(e) if e[:1].isdigit() and e.replace(".", "").isdigit() else e or None
                for e in cells
            ]
        )
    book.save(tmp_path / "stock.xlsx")
    check(tmp_path / "stock.xlsx")


def test_commas_are_decimal_where_semicolons_part_the_cells(tmp_path: Path) -> None:
    rows = (each.replace(",", ";").replace(".", ",") for each in ROWS)
    check(written(tmp_path, *rows, headings=HEADINGS.replace(",", ";")))


def test_a_case_takes_its_chain_from_it(tmp_path: Path) -> None:
    written(tmp_path, *ROWS)
    (tmp_path / "case.toml").write_text(
        '[site]\nwater_depth = "10 m"\n[catalogue]\nfile = "stock.csv"\n[line]\n[[line.segments]]\n'
        'component = "works chain G3"\ndiameter = "20 mm"\nlength = "30 m"\n'
        '[load]\nhorizontal_force = "5 kN"\n'
    )
    (segment,) = read_case(tmp_path / "case.toml").line.segments
    assert segment.MBL == pytest.approx(342e3)
    # Steel of 7850 in water of 1025 kg/m3.
    assert segment.submerged_weight == pytest.approx(8.76 * 9.80665 * (1.0 - 1025.0 / 7850.0))


WRONG = [
    (
        ("works chain,G3,28,-17.2,7850,x,33,,C",),
        ["line 2, mass: found -17.2", "line 2, MBL: found x"],
    ),
    ((",G3,28,17.2,,660,33,,",), ["line 2, family", "line 2, density", "line 2, source"]),
    ((ROWS[0], ROWS[0]), ["line 3, diameter: found 28 mm; each size of a grade stands once"]),
    ((ROWS[0], ROWS[1].replace("7850", "7.85")), ["line 3, density: found 7.85", "has 7850 kg/m3"]),
]


@pytest.mark.parametrize(("rows", "said"), WRONG)
def test_what_is_wrong_is_told_by_its_cell(
    rows: tuple[str, ...], said: list[str], tmp_path: Path
) -> None:
    with pytest.raises(InputError) as caught:
        catalogue.read_families(written(tmp_path, *rows))
    for each in said:
        assert each in str(caught.value)


def test_wrong_headings_are_told_at_once(tmp_path: Path) -> None:
    path = written(tmp_path, "a,1,2,3,4", headings="familly,diameter,mass (lb),MBL (kN),MBL (kN)")
    with pytest.raises(InputError) as caught:
        catalogue.read_families(path)
    text = str(caught.value)
    for each in ("familly", "found diameter;", "mass (lb)", "twice", "density is missing"):
        assert each in text


def test_a_cell_beside_the_table_is_told(tmp_path: Path) -> None:
    book = openpyxl.Workbook()
    sheet = book.active
    assert sheet is not None
    sheet.append(["family", "diameter (mm)", "mass (kg/m)", "density (kg/m^3)", "source"])
    sheet.append(["x", 20, 8.0, 7850, "C", "stray"])
    book.save(tmp_path / "stock.xlsx")
    with pytest.raises(InputError, match=r"F2: found stray; a heading is required above it"):
        catalogue.read_families(tmp_path / "stock.xlsx")
