"""S4: the turret of FSO Rang Dong in a storm, under a synthetic force in place of the lost one.

The series of forces FT(t) on the turret is a figure that is lost; one sample of it is printed. What
is run here has the printed mean, a fluctuation in proportion to a random sea of the printed
spectrum, and meets that sample. It is not S4's load, so no printed maximum can be reproduced with
it: the tables show orders of magnitude.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cache
from itertools import product
from typing import TYPE_CHECKING, Literal

from catopt.reproduce import fso_rang_dong
from catopt.reproduce.items import (
    KN,
    Input,
    Published,
    SideBySide,
    Study,
    in_unit,
    published,
    set_aside,
    study_of,
)
from catopt.units import UNITS, Dimension
from catopt.words import Message, term

if TYPE_CHECKING:
    from catopt.arrays import Array
    from catopt.fem import Harmonic, LineProperties
    from catopt.waves import Waves

NAME = "fso_rang_dong_dynamic"

SeaSpectrum = Literal["Pierson-Moskowitz", "JONSWAP"]
BedModel = Literal["as run", "pushes only"]

_SPECTRA: tuple[SeaSpectrum, ...] = ("Pierson-Moskowitz", "JONSWAP")

SEED = 1
STEP = 0.1
"""s."""
RAMP_TIME = 30.0
"""s, after which maxima are taken."""
BODY_MASS = 1e5
"""Of the turret node, kg."""
TENFOLD_MASS = 1e6
CRITICAL_RATIO = 1.0
"""Axial damping of a bar, as a part of what is critical for it alone."""
BARS_ON_FREE_BED = (15, 6, 3, 3)
"""Of the segments from the anchor."""

_MM = UNITS[Dimension.LENGTH]["mm"]
_LOOK = 0.05
"""Step of time in which the highest crest is looked for, s."""
_DIGITS = 2
"""Of what is shown: more would claim that the synthetic force means something."""
_REASON = "inputs missing: the load series FT(t) is a lost figure"
_AWAY = 3e6
"""A force along +x, N, that pulls lines 6 and 7 about as far as S4 prints."""


@dataclass(frozen=True)
class Maxima:
    """Largest tension in a bar of each line, N, and largest distance from the origin, m."""

    tension: tuple[float, ...]
    offset: float


def study() -> Study:
    """Run both spectra on both beds; set the maxima beside the printed ones and judge none."""
    source = published(NAME)
    given, ours = source.inputs, "ours; S4's is not known"
    far = [run(spectrum, "pushes only").offset for spectrum in _SPECTRA]
    return study_of(
        source,
        items=[item for method in source.printed for item in set_aside(source, method, _REASON)],
        findings=(
            Message(
                "reproduce.force_synthetic_series_ft_t",
                mean=given["mean_force_x_kN"],
                sample=given["sample_force_x_kN"],
                time=given["sample_time_s"],
            ),
            _about_the_order(source),
            _about_the_mass(),
            _about_the_prints(source),
            Message("reproduce.on_bed_only_pushes_with", offset=_shown(max(far))),
        ),
        ours=(
            Input("seed", f"{SEED}", "", "ours"),
            Input("mass of the turret node", f"{BODY_MASS / 1e3:g}", "t", ours),
            Input("axial damping of a bar, of critical", f"{CRITICAL_RATIO:g}", "", ours),
            Input("waves, current and wind on the lines", "none: still water", "", "ours"),
            Input("time step", f"{STEP:g}", "s", ours),
            Input("ramp, after which maxima are taken", f"{RAMP_TIME:g}", "s", ours),
        ),
        side_by_side=(_beside_the_prints(source), _both_beds()),
    )


# ------------------------------------------------------------------ the synthetic force


def synthetic_force(of: SeaSpectrum) -> Harmonic:
    """Make up what the force does about its mean: N along x.

    It is c times the elevation of a random sea at one place. The sea's time is counted so that its
    highest crest in the whole run comes when the printed sample was taken, and c makes the force
    the printed one then: had the sample been any other moment of that run, c would be larger.
    """
    import numpy as np

    from catopt.fem import Harmonic

    given = published(NAME).inputs
    waves = _sea(of)
    waves = replace(waves, phase=waves.phase - waves.omega * _origin(waves))
    crest = _elevation(waves, np.array([given["sample_time_s"]]))[0]
    wanted = (given["sample_force_x_kN"] - given["mean_force_x_kN"]) * KN
    amplitude = np.zeros((waves.count, 3))
    amplitude[:, 0] = wanted / crest * waves.amplitude
    return Harmonic(
        period=tuple(2.0 * np.pi / waves.omega),
        amplitude=amplitude,
        phase=np.repeat(-waves.phase[:, np.newaxis], 3, axis=1),
    )


def _sea(of: SeaSpectrum) -> Waves:
    """Draw a sea of the spectrum in S4's Table 4.4, in the frequencies of that table."""
    import numpy as np

    from catopt.waves import (
        jonswap,
        peak_from_mean,
        pierson_moskowitz,
        random_waves,
        s4_range_jonswap,
        s4_range_pierson_moskowitz,
        zero_crossing_from_mean,
    )

    given = published(NAME).inputs
    height, mean = given["significant_wave_height_m"], given["mean_wave_period_s"]
    peak, count = peak_from_mean(mean), int(given["wave_components"])
    if of == "JONSWAP":
        spectrum = jonswap(height, peak, normalisation="S4")
        between = s4_range_jonswap(spectrum)
    else:
        spectrum = pierson_moskowitz(height, peak)
        between = s4_range_pierson_moskowitz(zero_crossing_from_mean(mean))
    return random_waves(spectrum, count, np.random.default_rng(SEED), bands="S4", between=between)


def _origin(waves: Waves) -> float:
    """Time of the sea, s, from which the run's highest crest comes when the sample was taken.

    Moving on to the highest crest in sight ends, because each is higher than the one before.
    """
    import numpy as np

    given = published(NAME).inputs
    before, length = (round(given[key] / _LOOK) for key in ("sample_time_s", "duration_s"))
    first = 0
    while True:
        times = _LOOK * (first + np.arange(length + 1, dtype=np.float64))
        level = _elevation(waves, times)
        moved = first + int(level.argmax()) - before
        if moved == first:
            return _LOOK * first
        first = moved


def _elevation(waves: Waves, times: Array) -> Array:
    """Sum of a cos(phase - omega t), m, at each time."""
    import numpy as np

    angles = waves.phase - np.outer(times, waves.omega)
    level: Array = np.cos(angles) @ waves.amplitude
    return level


# ------------------------------------------------------------------ the runs


def run(of: SeaSpectrum, bed: BedModel = "as run", mass: float = BODY_MASS) -> Maxima:
    """Run the nine lines and the turret under the synthetic force.

    `bed`: S4's restraint with a hundredfold EA, or a bed that only pushes with the printed EA;
    `mass`: of the turret node, kg.
    """
    return _run(of, bed, mass)


@cache
def _run(of: SeaSpectrum, bed: BedModel, mass: float) -> Maxima:
    import numpy as np

    from catopt.fem import BodyInertia, TimeStepping, run_system_dynamics
    from catopt.verify.line import truss_legs

    source, mooring = published(NAME), published(fso_rang_dong.NAME)
    light = fso_rang_dong.turret(mooring)
    masses = zip(light.legs[0].line.segments, source.series["mass_kg_per_m"], strict=True)
    segments = [replace(segment, mass=mass) for segment, mass in masses]
    legs, height = truss_legs(fso_rang_dong.with_segments(light, segments), 0.0)
    as_run = [int(mooring.inputs["elements_per_segment"])] * len(segments)
    history = run_system_dynamics(
        legs,
        TimeStepping(source.inputs["duration_s"], STEP, ramp_time=RAMP_TIME),
        height=height,
        mean_force=(source.inputs["mean_force_x_kN"] * KN, 0.0),
        force=synthetic_force(of),
        body=BodyInertia(mass=mass),
        properties=_properties(source, mooring, bed),
        elements=as_run if bed == "as run" else list(BARS_ON_FREE_BED),
    )
    place = history.fairlead[history.counted, 0, :2]
    return Maxima(
        tension=tuple(history.line_max_tension(k) for k in range(len(legs))),
        offset=float(np.linalg.norm(place, axis=1).max()),
    )


def _properties(source: Published, mooring: Published, bed: BedModel) -> LineProperties:
    """Still water: an added mass below zero, which the wire's CM of 0.7 asks for, is left out."""
    from catopt.fem import LineDamping, LineProperties, MorisonSection, Seabed

    columns = (source.series[key] for key in ("diameter_mm", "CD", "CM"))
    return LineProperties(
        sections=[
            MorisonSection(D * _MM, drag_normal=CD, added_mass_normal=max(CM - 1.0, 0.0))
            for D, CD, CM in zip(*columns, strict=True)
        ],
        damping=LineDamping(critical_ratio=CRITICAL_RATIO, critical_length="bar"),
        seabed=fso_rang_dong.restrained_bed(mooring) if bed == "as run" else Seabed(),
    )


# ------------------------------------------------------------------ findings


def _about_the_order(source: Published) -> str:
    ours = [run(spectrum).tension[1] / KN for spectrum in _SPECTRA]
    printed = [table["line_2_tension_max_kN"].value for table in source.printed.values()]
    return Message(
        "reproduce.no_printed_maximum_reproduced_none",
        low=_shown(min(ours)),
        high=_shown(max(ours)),
        printed_low=min(printed),
        printed_high=max(printed),
    )


def _about_the_mass() -> str:
    light, heavy = (run("JONSWAP", mass=mass) for mass in (BODY_MASS, TENFOLD_MASS))
    return Message(
        "reproduce.what_moves_with_turret_not",
        light=BODY_MASS / 1e3,
        heavy=TENFOLD_MASS / 1e3,
        tension=_shown(heavy.tension[1] / KN),
        instead=_shown(light.tension[1] / KN),
    )


def _about_the_prints(source: Published) -> str:
    printed = source.printed["MOORING_2017, Pierson-Moskowitz"]
    tension, offset = printed["line_2_tension_max_kN"], printed["turret_offset_max_m"]
    force = _force_at_rest(tension.value * KN)
    at_rest = fso_rang_dong.as_run(force=-force)
    back = [float(line.tension.max()) / KN for line in fso_rang_dong.as_run(force=_AWAY).lines]
    leeward = max(float(line.tension.max()) for line in at_rest.lines[3:]) / KN
    return Message(
        "reproduce.this_much_can_be_said",
        tension=tension.value,
        force=force / KN,
        offset=-at_rest.position[0],
        printed=offset.text,
        leeward=leeward,
        away=_AWAY / KN,
        most=back[5],
        least=back[3],
    )


def _force_at_rest(tension: float) -> float:
    """Force along -x, N, under which the largest tension in line 2 is this one in S4's model."""
    from scipy.optimize import brentq

    def missing(force: float) -> float:
        line = fso_rang_dong.as_run(force=-force).lines[1]
        return float(line.tension.max()) - tension

    return float(brentq(missing, tension, 4.0 * tension, rtol=1e-9))


# ------------------------------------------------------------------ side by side


def _beside_the_prints(source: Published) -> SideBySide:
    """Set the printed maxima and those of S4's model under the synthetic force side by side."""
    answers = [run(spectrum) for spectrum in _SPECTRA]
    tables = list(source.printed.values())
    rows: list[tuple[str, ...]] = []
    for index, quantity in enumerate(tables[0]):
        if quantity.endswith("_m"):
            name, ours = in_unit("turret offset", "m"), [answer.offset for answer in answers]
        else:
            name = Message("reproduce.line_force", number=index + 1)
            ours = [answer.tension[index] / KN for answer in answers]
        printed = (f"{table[quantity].value:g}" for table in tables)
        rows.append((name, *printed, *map(_shown, ours)))
    return SideBySide(
        "Largest in 1,200 s: orders of magnitude, not a reproduction",
        ("largest of", "S4, PM", "S4, JONSWAP", "OrcaFlex", "synthetic, PM", "synthetic, JONSWAP"),
        tuple(rows),
    )


def _both_beds() -> SideBySide:
    """Set S4's restraint and a bed that only pushes side by side, under the synthetic force."""
    beds: dict[BedModel, str] = {
        "as run": "held both ways, 100 EA",
        "pushes only": "pushes only, printed EA",
    }
    rows: list[tuple[str, ...]] = []
    for spectrum, (bed, words) in product(_SPECTRA, beds.items()):
        answer = run(spectrum, bed)
        windward, leeward = max(answer.tension[:3]) / KN, max(answer.tension[3:]) / KN
        name = Message("reproduce.spectrum_on", spectrum=spectrum, bed=term(words))
        rows.append((name, *map(_shown, (windward, leeward, answer.offset))))
    return SideBySide(
        "The synthetic force on two beds",
        (
            "spectrum, bed and EA",
            in_unit(Message("reproduce.lines", first=1, last=3), "kN"),
            in_unit(Message("reproduce.lines", first=4, last=9), "kN"),
            in_unit("turret offset", "m"),
        ),
        tuple(rows),
    )


def _shown(value: float) -> str:
    """Write a number with two digits, all others zero."""
    rounded = float(f"{value:.{_DIGITS}g}")
    return f"{rounded:,.0f}" if rounded >= 10.0 else f"{rounded:.{_DIGITS - 1}f}"
