"""Write the synthetic forces of cases/fso-rang-dong-dynamic: python -m tests.fso_force.

The force is c times the elevation of a random sea of source S4's spectrum, so that it meets the one
sample that S4 prints (`catopt.reproduce.fso_rang_dong_dynamic`). It is not S4's, which is lost.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from catopt.fem.series import series_rows, series_values
from catopt.reproduce.fso_rang_dong_dynamic import SeaSpectrum, synthetic_force

FOLDER = Path(__file__).parents[1] / "cases" / "fso-rang-dong-dynamic"
SPECTRA: dict[str, SeaSpectrum] = {
    "pierson-moskowitz": "Pierson-Moskowitz",
    "jonswap": "JONSWAP",
}
INTERVAL = 0.5
"""s: of the force, joined by a cubic spline."""
DURATION = 1200.0


def series_of(spectrum: SeaSpectrum) -> str:
    """Tabulate the force beside its mean, as the CSV file has it."""
    times = INTERVAL * np.arange(round(DURATION / INTERVAL) + 1, dtype=np.float64)
    rows = series_rows(np.zeros((1, 3)), [synthetic_force(spectrum)], 0.0)
    force = series_values(rows, times)[:, 0] / 1e3
    head = "# SYNTHETIC: c times the elevation of a random sea, not the force of S4, which is lost"
    lines = (f"{t:.1f},{fx:.1f},0,0" for t, fx in zip(times, force, strict=True))
    return "\n".join([head, "t (s),Fx (kN),Fy (kN),Fz (kN)", *lines]) + "\n"


if __name__ == "__main__":
    for name, spectrum in SPECTRA.items():
        (FOLDER / f"{name}.csv").write_text(series_of(spectrum), encoding="utf-8")
