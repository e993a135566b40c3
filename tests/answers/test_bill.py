"""The fittings of a bill of materials, counted by hand."""

from __future__ import annotations

from pathlib import Path

import pytest

from catopt import check_case
from catopt.answers.bill import Prices, bill
from catopt.answers.blocks import Table, Text
from catopt.casefile import parse_case
from catopt.catalogue.fittings import fittings
from catopt.notes.origin import Asked
from catopt.notes.sheet import sheet_of
from catopt.notes.system import read_network_note

CHAIN = '[[line.segments]]\ncomponent = "chain studless R3"\ndiameter = "{} mm"\nlength = "40 m"\n'
WIRE = (
    '[[line.segments]]\nname = "wire"\nlength = "40 m"\nsubmerged_weight = 30\nMBL = "900 kN"\n'
    "EA = 4e7\nmass = 3.5\n"
)
SINKER = (
    '[anchor]\nkind = "sinker"\nmass = "60 t"\ndensity = "2400 kg/m^3"\nfriction = 0.6\n'
    "safety_factor = 1.5\n"
)


def billed(line: str, more: str = "") -> tuple[dict[str, int], list[str]]:
    """Return how many of each part there are, by its code, and what is said below."""
    text = f'[site]\nwater_depth = "20 m"\n[line]\n{line}[load]\nhorizontal_force = "60 kN"\n'
    case = parse_case(text + more)
    table, *said = bill(sheet_of(case, case.line, check_case(case)), "")
    assert isinstance(table, Table)
    names, numbers = (
        next(each.values for each in table.columns if str(each.name).endswith(name))
        for name in ("ode or name", "umber")
    )
    assert all(isinstance(each, int) for each in numbers)
    by_name = {str(name): number for name, number in zip(names, numbers, strict=True)}
    return by_name, [str(each.said) for each in said if isinstance(each, Text)]  # type: ignore[return-value]


def test_two_chains_on_a_sinker_have_five_shackles() -> None:
    """Sinker, ring and shackle of the thin chain; at the joint its own; two of the thick above."""
    found, said = billed(CHAIN.format(30) + CHAIN.format(34), SINKER)
    shackles = {name: count for name, count in found.items() if name.startswith("shackle")}
    assert list(shackles.values()) == [2, 2]
    assert [count for name, count in found.items() if name.startswith(("swivel", "sinker r"))] == [
        1,
        1,
    ]
    assert not any("NOT chosen" in each for each in said)


def test_none_is_weaker_than_the_chain_that_it_joins() -> None:
    found, _ = billed(CHAIN.format(30), SINKER)
    # DNV-OS-E302: R3 is 0.0223 d^2 (44 - 0.08 d) kN, 835 kN of 30 mm.
    MBL = 0.0223 * 30.0**2 * (44.0 - 0.08 * 30.0) * 1e3
    own = {f"{use} {1e3 * e.size:.4g} mm": e for e in fittings() for use in (e.kind, "sinker ring")}
    chosen = [own[name] for name in found if name in own]
    assert len(chosen) == 3
    assert all(each.MBL >= MBL for each in chosen)


def test_between_wires_nothing_is_chosen_and_that_is_said() -> None:
    """Wire below chain: at the anchor none, at the joint by the chain, two above."""
    found, said = billed(WIRE + CHAIN.format(30))
    assert [count for name, count in found.items() if name.startswith("shackle")] == [3]
    (open_ends,) = [each for each in said if "NOT chosen" in each]
    assert open_ends.startswith("Fittings of 1 connections of a line, 1 in all")
    found, said = billed(WIRE)
    assert len(found) == 1
    assert any("of 2 connections" in each for each in said)


def test_given_prices_are_added_up_and_what_has_none_is_named() -> None:
    """Chain of 1500 USD a tonne, a sinker of 60 t at 100 USD a tonne, a set of 900 USD."""
    text = f'[site]\nwater_depth = "20 m"\n[line]\n{CHAIN.format(30)}'
    case = parse_case(text + '[load]\nhorizontal_force = "60 kN"\n' + SINKER)
    sheet = sheet_of(case, case.line, check_case(case))

    def priced(prices: Prices) -> tuple[list[object], str]:
        table, *said = bill(sheet, "", prices)
        assert isinstance(table, Table)
        (column,) = (each for each in table.columns if str(each.name) == "Total price")
        first = next(each for each in said if isinstance(each, Text))
        return list(column.values), str(first.said)

    # OrcaFlex takes 19.9 d^2 t/m of studless links: 17.9 kg/m of 30 mm.
    found, said = priced(Prices(1500.0, 100.0, 900.0))
    assert found[0] == pytest.approx(1.5 * 19.9e3 * 0.03**2 * 40.0, rel=0.02)
    assert found[1] == pytest.approx(6000.0)
    assert found[2:] == [None] * (len(found) - 3) + [900.0]
    assert "without" not in said
    assert f"{found[0] + 6900.0:,.0f} USD" in said  # type: ignore[operator]
    _, said = priced(Prices(sinker=100.0))  # of the chain as the catalogue has it
    assert "without fittings, whose" in said


def test_lines_between_points_are_counted_together() -> None:
    """Four chains of 55 m of 20.48 kg/m are 4.506 t; a shackle at each anchor and each joint."""
    note = read_network_note(Path("cases/raft-four-lines/case.toml"), Asked(verify=False))
    table, *said = bill(note.sheet, "")
    assert isinstance(table, Table)
    columns = {str(each.name): each.values for each in table.columns}
    assert columns["Number"][:2] == (4, 4)
    assert columns["Total mass"][0] == pytest.approx(4 * 55.0 * 20.48, rel=1e-3)
    assert columns["Number"][2] == 8
    texts = [str(each.said) for each in said if isinstance(each, Text)]
    assert any("Fittings of 1 connections of a line, 4 in all" in each for each in texts)
