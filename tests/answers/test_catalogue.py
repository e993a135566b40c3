"""An answer out of the catalogue: diameters as makers write them, formulas in both languages."""

from __future__ import annotations

from catopt import catalogue
from catopt.answers.blocks import Table, Text
from catopt.answers.catalogue import catalogue_answer
from catopt.catalogue.document import Answer as Found
from catopt.quantities import QUANTITIES
from catopt.render.values import cell
from catopt.words import say


def test_diameters_are_written_in_as_few_digits_as_they_have() -> None:
    family = catalogue.standard().family("chain studless")
    found = Found("show", (family,), catalogue.standard().sold("chain studless", grade="R4"))
    sizes = next(
        each
        for each in catalogue_answer(found).blocks
        if isinstance(each, Table) and each.name == "sizes"
    )
    written = [cell(sizes.columns[0], row) for row in range(3)]
    assert written == ["19", "20.5", "22"]
    assert QUANTITIES["nominal_diameter"].format(0.019) == "19.0"


def test_how_a_figure_follows_is_said_in_both_languages() -> None:
    family = catalogue.standard().family("chain studless")
    chain = catalogue.component("chain studless R4", 0.076)
    answer = catalogue_answer(Found("show", (family,), (chain,)), in_full=True)
    how = next(each for each in answer.blocks if isinstance(each, Text) and each.caption)
    formula = "0.0274 d^2 (44 - 0.08 d) kN"
    assert f"{formula}, d in mm;" in say(how.said, "en")
    assert f"{formula}, d tính bằng mm;" in say(how.said, "vi")
