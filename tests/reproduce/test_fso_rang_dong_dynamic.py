"""S4's turret in motion: the synthetic force is what it says, and nothing is said to reproduce."""

from __future__ import annotations

from typing import get_args

import numpy as np
import pytest

from catopt.fem.series import fill_series, series_rows
from catopt.reproduce import Study, book, reproduce
from catopt.reproduce.fso_rang_dong import as_run
from catopt.reproduce.fso_rang_dong_dynamic import SeaSpectrum, run, synthetic_force

SPECTRA: tuple[SeaSpectrum, ...] = get_args(SeaSpectrum)
MEAN, SAMPLE = -4281e3, -9824e3

in_full = pytest.mark.slow
"""Needs the runs of the study: four times 20 minutes of nine lines."""


@pytest.fixture(scope="module")
def study() -> Study:
    return reproduce("fso_rang_dong_dynamic").studies[0]


def force_over_time(of: SeaSpectrum, times: list[float]) -> np.ndarray:
    """As the run applies it after its ramp."""
    rows = series_rows(np.array([[MEAN, 0.0, 0.0]]), [synthetic_force(of)], 0.0)
    out, values = np.zeros((3, 3)), []
    for t in times:
        fill_series(t, rows, 0, out)
        values.append(out[0].copy())
    return np.array(values)


@pytest.mark.parametrize("of", SPECTRA)
def test_the_force_meets_the_printed_sample(of: SeaSpectrum) -> None:
    """To double precision; the printed part along z is not in it."""
    (at_sample,) = force_over_time(of, [100.0])
    assert at_sample[0] == pytest.approx(SAMPLE, rel=1e-12)
    assert at_sample[1:].tolist() == [0.0, 0.0]


@pytest.mark.parametrize("of", SPECTRA)
def test_the_sample_is_the_largest_force_of_the_run(of: SeaSpectrum) -> None:
    """The crest was looked for in steps of 0.05 s: between them it rises by less than 0.1 %."""
    force = force_over_time(of, np.arange(0.0, 1200.0, 0.1).tolist())[:, 0]
    assert force.min() == pytest.approx(SAMPLE, rel=1e-3)


@pytest.mark.parametrize(
    ("of", "lowest", "highest"), [("Pierson-Moskowitz", 0.396, 3.487), ("JONSWAP", 0.282, 2.186)]
)
def test_the_force_has_twenty_waves_from_the_printed_range(
    of: SeaSpectrum, lowest: float, highest: float
) -> None:
    """Table 4.4, to its printed digits; one frequency in each of 20 equal bands."""
    omega = 2.0 * np.pi / np.array(synthetic_force(of).period)
    assert omega.size == 20
    assert omega.min() > lowest - 0.0005
    assert omega.max() < highest + 0.0005
    band = (omega - lowest) / (highest - lowest) * 20.0
    # The printed ends of the range are off by 0.003 at most, a fiftieth of a band.
    assert np.abs(band - np.arange(20) - 0.5).max() < 0.55


def test_the_force_is_the_same_every_time() -> None:
    first, second = synthetic_force("JONSWAP"), synthetic_force("JONSWAP")
    assert np.array_equal(first.rows, second.rows)


@in_full
def test_no_printed_number_is_judged(study: Study) -> None:
    assert len(study.items) == 30
    for item in study.items:
        assert item.verdict == "not reproducible"
        assert item.computed is None
        assert item.judgement.computed_text == ""
        assert item.note == "inputs missing: the load series FT(t) is a lost figure"


@in_full
def test_the_light_turret_follows_the_force_nearly_as_at_rest() -> None:
    """S4's model at rest under the largest force, within 10 %: what the body's inertia adds."""
    at_rest = as_run(force=SAMPLE)
    for of in SPECTRA:
        found = run(of)
        for k in range(3):
            assert found.tension[k] == pytest.approx(at_rest.lines[k].tension.max(), rel=0.1)
        # The stiff line stretches by 0.1 m between the mean force and the largest.
        assert found.offset == pytest.approx(-at_rest.position[0], abs=0.02)


@in_full
@pytest.mark.parametrize("of", SPECTRA)
def test_the_mooring_is_symmetric_and_so_is_the_answer(of: SeaSpectrum) -> None:
    """Lines 1 and 3, 4 and 9, 5 and 8, 6 and 7 mirror each other in the direction of the force.

    Rounding grows where lines snap; 0.1 % is far below the digits that are shown.
    """
    tension = run(of).tension
    for k, other in ((0, 2), (3, 8), (4, 7), (5, 6)):
        assert tension[k] == pytest.approx(tension[other], rel=1e-3)


@in_full
def test_a_bed_that_only_pushes_lets_the_turret_out() -> None:
    """At rest under the mean force alone it is 21.738 m out there."""
    for of in SPECTRA:
        assert 21.738 < run(of, "pushes only").offset < 40.0
        assert run(of).offset < 7.0


@in_full
def test_the_tables_show_prints_in_full_and_ours_with_two_digits(study: Study) -> None:
    beside, beds = study.side_by_side
    assert "orders of magnitude, not a reproduction" in beside.title
    assert len(beside.rows) == 9 + 1
    assert beside.rows[1][:4] == ("line 2 (kN)", "5125", "5134", "5250")
    assert beside.rows[9][:4] == ("turret offset (m)", "6.624", "6.689", "6.9755")
    assert all(len(row) == len(beside.header) for row in beside.rows)
    assert len(beds.rows) == 4
    for row in (*(row[4:] for row in beside.rows), *(row[1:] for row in beds.rows)):
        for cell in row:
            assert len(cell.replace(",", "").replace(".", "").rstrip("0")) <= 2


@in_full
def test_it_is_said_that_the_force_is_synthetic_and_what_follows(study: Study) -> None:
    told = " ".join(study.findings)
    for words in (
        "The force is SYNTHETIC",
        "-4,281 kN, and one sample, -9,824 kN along x at 100 s",
        "No printed maximum is reproduced, and none is contradicted",
        "orders of magnitude",
        "The mass matters as much as the force",
    ):
        assert words in told
    page = book(reproduce("fso_rang_dong_dynamic"))
    assert "under a synthetic force" in page.splitlines()[6]


@in_full
def test_the_printed_maxima_against_the_static_model(study: Study) -> None:
    """What the finding says of 12,085 kN, from the model at rest: the printed 5,125 kN."""
    at_rest = as_run(force=-12085e3)
    assert at_rest.lines[1].tension.max() / 1e3 == pytest.approx(5125.0, abs=0.5)
    assert f"{-at_rest.position[0]:.2f}" == "6.19"
    finding = next(text for text in study.findings if "12,085 kN" in text)
    assert "6.19 m, not 6.624 m" in finding
