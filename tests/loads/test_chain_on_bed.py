"""Chain on the bed: Djokic's table and DTOcean's clay, of which the lower counts."""

from __future__ import annotations

import pytest

from catopt.errors import InputError
from catopt.loads.drag_anchor import CHAIN_ON_BED, chain_holding

PRINTED = {
    "sand": (0.98, 0.74),
    "mud with sand": (0.92, 0.69),
    "firm mud": (1.01, 0.62),
    "soft mud": (0.90, 0.56),
    "clay": (1.25, 0.81),
}
"""Djokic, friction.md: starting and sliding friction of anchor chain."""

DTOCEAN = {"sand": 0.74, "clay": 0.50}
"""soilprops.txt, seaflrfriccoef."""


def test_the_lower_of_both_counts() -> None:
    for bed, (starting, sliding) in PRINTED.items():
        row = CHAIN_ON_BED[bed]
        assert row.starting == starting
        assert row.sliding == min(sliding, DTOCEAN.get(bed, sliding))
        assert row.source.confidence == "C"
    assert set(CHAIN_ON_BED) == set(PRINTED)


def test_a_hundred_metres_of_chain_on_sand() -> None:
    """1 kN/m on 100 m: 74 kN."""
    held, source = chain_holding("sand", 100e3)
    assert held == pytest.approx(74e3, rel=1e-12)
    assert "Djokic" in source.text


def test_a_bed_without_figures_is_refused() -> None:
    with pytest.raises(InputError) as error:
        chain_holding("coral", -1.0)
    assert [problem.key for problem in error.value.problems] == ["bed", "submerged_weight"]
