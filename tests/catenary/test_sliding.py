"""Spans that a line with much friction jumps over as its force grows: each has its equilibrium.

Lines of the campaign (seed, index) that were refused as not converged. The answers are checked by
its oracle, which follows the line from both ends with the answer's own forces.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from catopt import solve_many
from tests.campaign.evaluation import ANSWERED, evaluate, solved
from tests.campaign.lines import draw
from tests.campaign.oracle import check
from tests.campaign.refusals import RIGHT

LOOSE_BELOW_A_BUOY = [(2, 141862), (2, 182098), (7, 32038), (7, 70210)]
"""Nothing is left of the force somewhere on the bed, from where on the line lies loose."""
TOUCHING_OR_CLEAR = [(2, 87154), (7, 32341), (7, 139282)]
"""It jumps from touching the bed to passing over it; the spans between touch it with less force."""
TWO_LOADS_IN_ONE_PLACE = (7, 114949)
"""Two point loads in one place of a buoyant segment, on the bed."""


@pytest.mark.parametrize("case", [*LOOSE_BELOW_A_BUOY, *TOUCHING_OR_CLEAR, TWO_LOADS_IN_ONE_PLACE])
def test_at_a_jump_the_line_is_held(case: tuple[int, int]) -> None:
    (outcome,) = evaluate([draw(*case)])
    assert (outcome.verdict, outcome.reason) == (ANSWERED, "")


@pytest.mark.slow
@pytest.mark.parametrize("case", [(2, 87154), (7, 32341), (2, 182098)])
def test_every_span_across_a_jump_has_its_line(case: tuple[int, int]) -> None:
    """What lies on the bed changes as steadily as the span, across both ends of the jump, too."""
    trial = draw(*case)
    assert any("slides there" in each for each in solved(trial).warnings)
    length = trial.line.length
    spans = np.linspace(trial.value - 0.1 * length, trial.value + 0.1 * length, 101)
    many = solve_many(
        trial.line,
        height=trial.height,
        anchor_height=trial.anchor_height,
        seabed_friction=trial.friction,
        span=spans,
    )
    assert (many.status == 0).all()
    assert np.abs(np.diff(many.grounded_length)).max() < 20 * np.diff(spans)[0]
    for span in spans[30:70:10].tolist():
        assert check(solved(replace(trial, value=span)), "span", span).is_right


@pytest.mark.slow
def test_rounding_of_a_light_piece_takes_no_equilibrium_away() -> None:
    """Fairlead on the bed, H of 1e-7 N beside weights of 1e-2 N: some forces had no answer."""
    (outcome,) = evaluate([draw(7, 1847)])
    assert (outcome.verdict, outcome.reason) == (RIGHT, "tension too small")
