"""Tables on a terminal of 80 columns: what heads them, and what folds."""

from __future__ import annotations

import pytest

from catopt.answers.blocks import Answer, Column, Section, Table, measured, texts
from catopt.cli.output import Printer
from catopt.render.terminal import show
from catopt.words import Message


def printed(capsys: pytest.CaptureFixture[str], *columns: Column) -> list[str]:
    """Lines of a table, those of its heading first."""
    title = Message("captions.results")
    show(Printer(), Answer("any", title, (Section(title, (Table("any", columns),)),)))
    return capsys.readouterr().out.splitlines()[2:]


def headed(lines: list[str]) -> list[str]:
    rule = next(k for k, line in enumerate(lines) if set(line) == {"─"})
    return lines[:rule]


def test_a_name_that_says_more_comes_before_the_symbol(capsys: pytest.CaptureFixture[str]) -> None:
    lines = printed(
        capsys,
        measured("span", [1077.709]),
        measured("span", [1077.709], "largest_span"),
        measured("tension", [1581298.0], "anchor_tension", symbol="TA"),
        measured("stiffness", [439521.0], symbol="kxx"),
    )
    assert headed(lines) == [
        "                        Anchor",
        "            Largest    tension",
        "       S     span S         TA       kxx",
        "     (m)        (m)       (kN)    (kN/m)",
    ]


def test_words_of_headings_are_broken_where_80_columns_have_no_room(
    capsys: pytest.CaptureFixture[str],
) -> None:
    many = [measured("horizontal_force", [1484734.0]) for _ in range(6)]
    lines = printed(capsys, *many, measured("utilisation", [0.258]))
    assert headed(lines)[-1].endswith("   Utilisation")
    lines = printed(capsys, *many, measured("MBL", [1e3]), measured("utilisation", [0.258]))
    assert [each.split()[-1] for each in headed(lines)[-2:]] == ["Utilis-", "ation"]
    assert max(map(len, lines)) <= 80


def test_a_number_keeps_its_unit_where_words_fold(capsys: pytest.CaptureFixture[str]) -> None:
    line = "chain stud-link U3 14 mm, 8 m; chain stud-link U3 16 mm, 5 m; sinker 2 t"
    lines = printed(capsys, texts("design", [1]), texts("line_from_the_anchor", [line]))
    assert [each.split("   ")[-1] for each in lines[-3:-1]] == [
        "chain stud-link U3 14 mm, 8 m; chain stud-link U3 16 mm, 5 m; sinker",
        "2 t",
    ]
