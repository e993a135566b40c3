"""Everything measured or printed that catopt was put beside, by how far it is off.

Its table stands in docs/validation.md (``python -m tests.validation_page``). A row is a group of
numbers of one kind, told by the one that is furthest off. What counts as unsafe: a tension, a
force, an offset, a motion or a drift that is smaller here.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import groupby
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple

import numpy as np
import pandas as pd

from catopt.fem.newmark import Scheme
from catopt.hydro.cylinder import HEAVE, SURGE, FloatingCylinder
from catopt.reproduce import Reproduction
from tests.catenary import test_measured
from tests.fem import test_dyn_published as chains
from tests.floater import test_linear_body as bodies
from tests.hydro import test_cylinder as cylinders
from tests.hydro import test_drift as drifts

_UNSAFE = ("tension", "force", "offset", "drift", "response", "drop")
"""Words of what is unsafe where it is smaller, but for those of what is not."""
_NEITHER = ("error", "min_", "smallest", "mean tension", "stiffness")
_SMALL = 0.05
"""Part of the largest of its kind below which a number is not told in per cent of itself."""


class Beside(NamedTuple):
    """One number beside another."""

    source: str
    kind: str
    """measured, printed, or by which program."""
    what: str
    ours: float
    theirs: float
    is_whole: bool = False
    """Whether every printed digit comes out."""

    @property
    def off(self) -> float:
        """Difference, per cent."""
        if self.is_whole:
            return 0.0
        return 100.0 * (self.ours / self.theirs - 1.0)

    @property
    def side(self) -> str:
        """Say on which side it is."""
        what = self.what.lower()
        is_load = any(word in what for word in _UNSAFE)
        if self.is_whole or not is_load or any(word in what for word in _NEITHER):
            return "-"
        return "unsafe" if self.off < 0.0 else "safe"


def lines(reproduction: Reproduction) -> list[tuple[str, ...]]:
    """Rows of the table: the furthest off first; the last are those with every printed digit."""
    every = [*_printed(reproduction), *_chain(), *_moordyn(), *_section(), *_ships()]
    every += [*_sphere(), *_oc4(), *_oc5(), *_cylinders()]
    groups = []
    key = _group
    for _, of in groupby(sorted(every, key=key), key=key):
        each = list(of)
        groups.append((max(each, key=lambda one: abs(one.off)), len(each)))
    groups.sort(key=lambda group: (-abs(group[0].off), group[0].source, group[0].what))
    return [_line(worst, count) for worst, count in groups]


def _group(one: Beside) -> tuple[str, ...]:
    return one.source, one.kind, one.what.partition(":")[0], one.side, f"{one.is_whole}"


def _line(worst: Beside, count: int) -> tuple[str, ...]:
    what = worst.what.replace("|", "\\|")
    off = "0, every digit" if worst.is_whole else _per_cent(worst.off)
    numbers = (f"{worst.ours:.4g}", f"{worst.theirs:.4g}")
    return (worst.source, worst.kind, what, str(count), *numbers, off, worst.side)


def _per_cent(off: float) -> str:
    """Write a difference with as many digits as another machine gives it, too."""
    size = abs(off)
    if size < 0.01:
        return f"{off:+.0e}"
    return f"{off:+.{0 if size >= 10.0 else 1 if size >= 1.0 else 2}f}"


def set_aside(reproduction: Reproduction) -> dict[str, int]:
    """Count what is printed and has nothing beside it here, by study."""
    none = [item.name for item in reproduction.items if item.computed is None]
    return {name: none.count(name) for name in dict.fromkeys(none)}


def _printed(reproduction: Reproduction) -> Iterator[Beside]:
    for item in reproduction.items:
        if item.computed is None or item.published == 0.0:
            continue
        what = f"{item.name}, {item.method}: {item.quantity}"
        whole = item.verdict == "reproduces"
        yield Beside(item.source, "printed", what, item.computed, item.published, whole)


def _chain() -> Iterator[Beside]:
    """Lindahl's chain on a circle, measured."""
    for column, period, cycles, step, first in ((0, 1.25, 10, 0.005, 0), (1, 3.5, 8, 0.01, 1)):
        measured = chains._measured(column, period, first)
        mean = measured.mean(axis=0)
        ours = chains._beside(chains._lindahl(period, cycles, step), period, cycles, mean)
        name = f"chain on a circle of {period:g} s"
        peak = float(measured.max(axis=1).mean())
        yield Beside("Lindahl 1984", "measured", f"{name}, peak tension", float(ours.max()), peak)
        average = float(ours.mean()), float(mean.mean())
        yield Beside("Lindahl 1984", "measured", f"{name}, mean tension", *average)
        slack = [100.0 * float(np.mean(each < 2.0)) for each in (ours, measured)]
        yield Beside(
            "Lindahl 1984", "measured", f"{name}, below 2 N, % of the cycle", slack[0], slack[1]
        )


def _oc5() -> Iterator[Beside]:
    """Put the pretensions of OC5's lines beside the least and the largest measured."""
    for ours in test_measured.pretensions():
        for word, theirs in zip(("least", "largest"), test_measured.MEASURED, strict=True):
            what = f"OC5 DeepCwind, pretension (MN): beside the {word} of three lines"
            yield Beside("OC5, MARIN 2013", "measured", what, ours / 1e6, theirs / 1e6)


def _moordyn() -> Iterator[Beside]:
    figures = chains._figures("moordyn_chain_600m.toml")["statistics"]
    history = chains._moordyn_chain(80, 0.05, Scheme.generalised_alpha(0.5))
    statistics = history.tension_statistics()
    for word, value in (("largest", statistics.maximum), ("smallest", statistics.minimum)):
        theirs = figures[f"end_force_{'max' if word == 'largest' else 'min'}_kN"]
        what = f"chain of 600 m in surge, {word} tension (kN)"
        yield Beside("MoorDyn-C 2.7.2", "program", what, value / 1e3, theirs)


def _section() -> Iterator[Beside]:
    """Put the drift of a ship's section in beam waves beside what was measured."""
    for row in drifts.rows("section_drift.csv"):
        omega = 2.0 * math.pi / float(row["period"])
        how = {} if row["held"] == "fixed" else drifts.afloat(0.05, 0.015)
        ours = drifts.FLUME.drift(omega, **how) / (0.5 * drifts.RHO * drifts.G)
        what = f"section in beam waves, {row['held']}, drift at kB/2 {row['half_breadth']}"
        yield Beside("Sundsdal 2025", "measured", what, ours, float(row["drift"]))


def _ships() -> Iterator[Beside]:
    """Mean drift over a Bretschneider sea, by panels."""
    for ship in drifts.SHIPS:
        for heading in (180, 150, 120, 90):
            for peak in (7.0, 9.0):
                ours, theirs = drifts.in_a_sea(ship, heading, peak)
                for k, name in enumerate(("surge", "sway")):
                    if abs(theirs[k]) > _SMALL * float(np.abs(theirs).max()):
                        what = (
                            f"{ship}, waves to {heading} deg, mean drift in {name}: Tp {peak:g} s"
                        )
                        values = float(ours[k]), float(theirs[k])
                        yield Beside("MSS, WAMIT 6.3", "program", what, *values)


def _sphere() -> Iterator[Beside]:
    """IEA OES Task 10: a drop by CFD, responses as the mean of five codes."""
    step = 0.01
    place = bodies.sphere().run(np.zeros((1600, 6)), step, longest=30.0, start=(0, 0, 1, 0, 0, 0))
    z = place[:, bodies.HEAVE]
    turns = 1 + np.flatnonzero((z[1:-1] - z[:-2]) * (z[2:] - z[1:-1]) < 0.0)
    for at, theirs in zip(turns.tolist(), (-0.869, 0.637, -0.469, 0.349), strict=False):
        yield Beside("IEA OES 10", "CFD", "sphere, drop of 1 m: extreme", float(z[at]), theirs)
    codes = pd.read_csv(bodies.DATA / "sphere_heave_rao.csv").set_index("period_s")
    omega = 2.0 * math.pi / codes.index.to_numpy()
    found = np.abs(bodies.sphere().response(omega[::-1].copy(), np.zeros(1))[::-1, 0, HEAVE + 1])
    for period, ours, row in zip(codes.index, found, codes.to_numpy(), strict=True):
        what = f"sphere, response in heave: {period:g} s"
        yield Beside("IEA OES 10", "program", what, float(ours), float(row.mean()))


def _oc4() -> Iterator[Beside]:
    with TemporaryDirectory() as folder:
        found = bodies.oc4_frequencies(Path(folder))
        bare = bodies.oc4_frequencies(Path(folder), moored=False)
    for key in ("roll", "pitch"):
        what = f"the same of {key} without the lines' stiffness in roll, pitch and heave (Hz)"
        yield Beside("NREL's forum 1730", "printed", what, bare[key], bodies.OC4_PRINTED[key])
    for key, theirs in bodies.OC4_PRINTED.items():
        what = f"OC4 DeepCwind, natural frequency of {key} (Hz)"
        yield Beside("NREL's forum 1730", "printed", what, found[key], theirs)


def _cylinders() -> Iterator[Beside]:
    """Floating cylinders by capytaine; what is small beside the largest of its kind is left out."""
    for _, of in cylinders.TABLE.groupby(["radius_m", "draught_m", "depth_m"]):
        first = of.iloc[0]
        size = first.radius_m, first.draught_m, first.depth_m
        found = FloatingCylinder(*size, density=1000.0, gravity=9.81).at(of.omega_rad_s.to_numpy())
        for mode, names in ((SURGE, ("A11", "B11")), (HEAVE, ("A33_kg", "B33_kg_s"))):
            for part, name in zip((found.added_mass, found.damping), names, strict=True):
                theirs = of[name].to_numpy()
                what = f"cylinder, {'added mass' if name[0] == 'A' else 'damping'} in "
                what += "the horizontal" if mode == SURGE else "heave"
                for ours, value in zip(part[:, mode, mode], theirs, strict=True):
                    if value > cylinders.SMALL * theirs.max():
                        yield Beside("capytaine 3.0", "program", what, float(ours), float(value))
