"""What drives a line in motion, and the model that it is run with, as tables."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, NamedTuple

from catopt.quantities import QUANTITIES
from catopt.render.texts import Words
from catopt.report.page.table import Cell, Heading, Table, measured, units

if TYPE_CHECKING:
    from catopt.model import CurrentProfile, Motion, Segment, WaveState, WaveTrain
    from catopt.notes.motion import InMotion
    from catopt.verify.dynamic_result import DynamicRun
    from catopt.verify.motion_file import Raos

__all__ = ["Row", "drive_rows", "model_rows", "rao_table", "segment_rows", "segments_table"]

Row = tuple[str, Cell]
"""Key of what it is called, and its value."""

_MOST_RAOS = 40


class _Axis(NamedTuple):
    """Keys of what is said of a motion along an axis."""

    name: str
    amplitude: str
    recorded: str


_AXES = {
    "surge": _Axis("in_motion.surge_of", "in_motion.surge", "in_motion.record_surge"),
    "sway": _Axis("in_motion.sway_of", "in_motion.sway", "in_motion.record_sway"),
    "heave": _Axis("in_motion.heave_of", "in_motion.heave", "in_motion.record_heave"),
}
_SPECTRA = {
    "jonswap": "in_motion.jonswap",
    "pierson-moskowitz": "in_motion.pierson_moskowitz",
    "regular": "in_motion.regular",
}
_STRETCHINGS = {
    "none": "in_motion.stretching_none",
    "wheeler": "in_motion.stretching_wheeler",
}
_FRICTION = {
    "pulled": "in_motion.friction_pulled",
    "none": "in_motion.friction_none",
    "laid": "in_motion.friction_laid",
}
_PROFILES = {
    "power": "in_motion.current_power",
    "wind": "in_motion.current_wind",
    "table": "in_motion.current_table",
}
_SEVENTH = 1.0 / 7.0


def drive_rows(moved: InMotion, words: Words) -> list[Row]:
    """List what drives the line: waves, current, motion of the fairlead, each with its figures."""
    case = moved.found.case
    rows: list[Row] = []
    if case.waves is not None:
        rows += _waves(case.waves, moved, words)
    if case.current is not None:
        rows += _current(case.current, moved, words)
    if case.motion is not None:
        rows += _motion(case.motion, moved, words)
    return rows


def _waves(waves: WaveState, moved: InMotion, words: Words) -> Iterator[Row]:
    if waves.elevation_file:
        yield from _recorded(waves, moved, words)
    for train, gamma in zip(waves.all_trains, moved.drive.gammas, strict=True):
        yield from _train(train, gamma, words)
    if waves.is_random:
        runs = moved.drive.dynamics.runs
        seeds = ", ".join(f"({waves.seed}, {k})" for k in range(min(runs, 4)))
        yield (
            "in_motion.seeds",
            Cell(seeds + (f", … ({waves.seed}, {runs - 1})" if runs > 4 else "")),
        )
    yield "in_motion.stretching", Cell(words(_STRETCHINGS[waves.stretching]))


def _recorded(waves: WaveState, moved: InMotion, words: Words) -> Iterator[Row]:
    from pathlib import Path

    record, kept = moved.drive.elevation, moved.drive.recorded_waves
    assert record is not None
    name = Path(waves.elevation_file).name
    yield "in_motion.waves", Cell(words("in_motion.recorded_surface", file=name))
    yield "in_motion.surface_length", _in(record.duration, "s")
    yield "in_motion.recorded_at", _in(waves.elevation_x, "m")
    height = kept.significant_height
    yield "in_motion.significant_height", Cell(f"{height:.4g} m", height)
    yield "in_motion.wave_direction", _in_degrees(waves.direction)
    yield "in_motion.components", Cell(str(kept.count), kept.count)
    shortest = 2.0 * math.pi / float(kept.omega[-1])
    yield "in_motion.shortest_kept", Cell(f"{shortest:.4g} s", shortest)
    left_out = record.left_out(kept)
    yield "in_motion.variance_left_out", Cell(f"{left_out:.2%}", left_out)
    yield "in_motion.mean_taken_off", Cell(f"{record.mean:.4g} m", record.mean)


def _train(train: WaveTrain, gamma: float | None, words: Words) -> Iterator[Row]:
    is_regular = train.spectrum == "regular"
    yield "in_motion.waves", Cell(words(_SPECTRA[train.spectrum]))
    yield (
        "in_motion.wave_height" if is_regular else "in_motion.significant_height",
        _in(train.height, "m"),
    )
    yield "in_motion.wave_period" if is_regular else "in_motion.peak_period", _in(train.period, "s")
    if gamma is not None:
        by_rule = f" ({words('in_motion.by_rule')})" if train.peak_enhancement is None else ""
        yield "in_motion.gamma", Cell(f"{gamma:.4g}{by_rule}", gamma)
    yield "in_motion.wave_direction", _in_degrees(train.direction)
    if train.spreading_exponent is not None:
        n, count = f"{train.spreading_exponent:g}", train.directions
        yield "in_motion.spreading", Cell(words("in_motion.cosine_power", n=n, count=count))
    if not is_regular:
        yield "in_motion.components", Cell(str(train.components), train.components)


def _current(current: CurrentProfile, moved: InMotion, words: Words) -> Iterator[Row]:
    yield "in_motion.current", Cell(words(_PROFILES[current.profile]))
    if current.series_file:
        yield from _current_series(current, moved, words)
    if current.speed is not None:
        yield "in_motion.surface_speed", _in(current.speed, "m/s")
    if current.profile == "power":
        given = current.exponent
        yield (
            "in_motion.exponent",
            Cell("1/7", _SEVENTH) if given is None else Cell(f"{given:g}", given),
        )
    if current.depth is not None:
        yield "in_motion.current_depth", _in(current.depth, "m")
    if current.depths:
        pairs = zip(current.speeds, current.depths, strict=True)
        told = "; ".join(words("in_motion.speed_at", v=f"{v:g}", d=f"{d:g}") for v, d in pairs)
        yield "in_motion.speeds", Cell(told)
    if current.directions:
        turned = zip(current.directions, current.depths, strict=True)
        at = "in_motion.direction_at"
        told = "; ".join(words(at, b=f"{math.degrees(b):.4g}", d=f"{d:g}") for b, d in turned)
        yield "in_motion.directions", Cell(told)
    elif moved.drive.current is None or moved.drive.current.directions is None:
        yield "in_motion.current_direction", _in_degrees(current.direction)


def _current_series(current: CurrentProfile, moved: InMotion, words: Words) -> Iterator[Row]:
    from pathlib import Path

    import numpy as np

    series = moved.drive.current
    assert series is not None
    name = Path(current.series_file).name
    yield "in_motion.current_series", Cell(words("in_motion.series_in", file=name))
    ends = [f"{each:.4g}" for each in (np.min(series.speeds), np.max(series.speeds))]
    yield "in_motion.series_speed", Cell(f"{ends[0]} … {ends[1]} m/s")
    if series.directions is not None:
        b = np.degrees(series.directions)
        yield "in_motion.series_direction", Cell(f"{b.min():.4g}° … {b.max():.4g}°")


def _motion(motion: Motion, moved: InMotion, words: Words) -> Iterator[Row]:
    from pathlib import Path

    if motion.period is not None:
        yield "in_motion.motion", Cell(words("in_motion.harmonic"))
        yield "in_motion.motion_period", _in(motion.period, "s")
        for axis in _AXES:
            size, phase = getattr(motion, axis), getattr(motion, f"{axis}_phase")
            if size:
                yield _AXES[axis].amplitude, Cell(f"{size:g} m, {math.degrees(phase):.4g}°", size)
        return
    name = Path(motion.file or motion.rao_file).name
    yield (
        "in_motion.motion",
        Cell(words("in_motion.record" if motion.file else "in_motion.raos", file=name)),
    )
    record = moved.drive.record
    if record is not None:
        times, values = record.times, record.values
        yield "in_motion.record_length", _in(float(times[-1] - times[0]), "s")
        for axis, column in zip(_AXES, values.T, strict=True):
            if column.any():
                ends = {"a": f"{column.min():.4g}", "b": f"{column.max():.4g}"}
                yield _AXES[axis].recorded, Cell(words("in_motion.from_to", **ends))


def rao_table(raos: Raos | None, words: Words) -> Table | None:
    """Tabulate a ship's response at the fairlead; None where there is none."""
    if raos is None:
        return None
    sizes, phases = abs(raos.response), _phases(raos)
    used = [k for k in range(3) if sizes[:, k].any()]
    axes = list(_AXES.values())
    order = range(len(raos.omega) - 1, -1, -1)  # by rising period
    step = max(1, math.ceil(len(raos.omega) / _MOST_RAOS))
    rows = []
    for row in list(order)[::step]:
        cells = [Cell(f"{2.0 * math.pi / raos.omega[row]:.4g}", 2.0 * math.pi / raos.omega[row])]
        for k in used:
            size, phase = float(sizes[row, k]), phases[row][k]
            # Where nothing moves there is no lag, whatever the file has.
            lag = Cell(f"{math.degrees(phase):.4g}", phase) if size > 0.0 else Cell("–")
            cells += [Cell(f"{size:.4g}", size), lag]
        rows.append(tuple(cells))
    headings = [Heading(words("in_motion.rao_period"), is_number=True)]
    for k in used:
        axis = words(axes[k].name)
        headings += [
            Heading(f"{axis} (m/m)", is_number=True),
            Heading(words("in_motion.phase_of", axis=axis), is_number=True),
        ]
    return Table("motion_raos", tuple(headings), tuple(rows), words("in_motion.rao_table"))


def _phases(raos: Raos) -> list[list[float]]:
    """Lag of each response behind the crest, from 0 to a full turn."""
    turn = 2.0 * math.pi
    return [
        [math.atan2(each.imag, each.real) % turn for each in (complex(v) for v in row)]
        for row in raos.response
    ]


def model_rows(moved: InMotion, run: DynamicRun, words: Words) -> list[Row]:
    """List what the line is run with.

    Parameters
    ----------
    moved : InMotion
        With its settings.
    run : DynamicRun
        Any of them.
    words : Words
        Language.
    """
    case, dynamics = moved.found.case, moved.drive.dynamics
    bars = moved.found.parts[moved.governing].elements
    average = dynamics.scheme == "newmark"
    scheme = "in_motion.average" if average else "in_motion.generalised"
    stiffness, damping = dynamics.seabed_stiffness, dynamics.seabed_damping
    return [
        ("in_motion.bars", Cell(str(bars), bars)),
        ("in_motion.runs", Cell(str(dynamics.runs), dynamics.runs)),
        ("in_motion.duration", _in(dynamics.duration, "s")),
        ("in_motion.of_interest", _in(dynamics.duration_of_interest, "s")),
        ("in_motion.ramp", _in(moved.drive.ramp, "s")),
        ("in_motion.since", _in(run.history.since, "s")),
        ("in_motion.step", Cell(f"{run.history.step:.4g} s", run.history.step)),
        ("in_motion.scheme", Cell(words(scheme, radius=f"{dynamics.spectral_radius:g}"))),
        (
            "in_motion.line_damping",
            Cell(f"{dynamics.critical_ratio:g}", dynamics.critical_ratio),
        ),
        ("in_motion.damping_time", _in(dynamics.damping_time, "s")),
        (
            "in_motion.bed_stiffness",
            Cell(words("in_motion.one_centimetre"))
            if stiffness is None
            else _in(stiffness, "N/m²"),
        ),
        (
            "in_motion.bed_damping",
            Cell(words("in_motion.critical")) if damping is None else _in(damping, "N s/m²"),
        ),
        (
            "in_motion.bed_friction",
            Cell(f"{case.site.seabed_friction:g}", case.site.seabed_friction),
        ),
        (
            "in_motion.initial_friction",
            Cell(words(_FRICTION[dynamics.initial_friction])),
        ),
        ("in_motion.density", _in(case.site.water_density, "kg/m³")),
    ]


def segment_rows(moved: InMotion) -> list[tuple[Segment, Sequence[float | None]]]:
    """List for each segment what inertia and drag are made of.

    Returns
    -------
    list of (Segment, sequence)
        Mass per length, EA, drag diameter, its coefficients across and along, volume-equivalent
        diameter, coefficients of added mass across and along; SI, as the run has them.
    """
    properties = moved.drive.properties
    gravity, density = properties.fluid.gravity, properties.fluid.density
    rows: list[tuple[Segment, Sequence[float | None]]] = []
    sections = properties.sections or ()
    for segment, section in zip(moved.found.case.line.segments, sections, strict=True):
        assert segment.mass is not None
        displaced = (segment.mass - segment.submerged_weight / gravity) / density
        numbers = (
            segment.mass, segment.EA, segment.drag_diameter, section.drag_normal,
            # That of an oblique flow is no single number: a remark has it.
            None if any(section.oblique) else section.drag_tangential,
            math.sqrt(4.0 * max(displaced, 0.0) / math.pi),
            section.added_mass_normal, section.added_mass_tangential,
        )  # fmt: skip
        rows.append((segment, numbers))
    return rows


def segments_table(moved: InMotion, words: Words) -> Table:
    """Tabulate inertia and drag of the segments, each coefficient beside its diameter."""
    coefficient = QUANTITIES["coefficient"]
    quantities = (
        QUANTITIES["mass_per_length"], QUANTITIES["EA"],
        QUANTITIES["drag_diameter"], coefficient, coefficient,
        QUANTITIES["volume_diameter"], coefficient, coefficient,
    )  # fmt: skip
    rows = tuple(
        (
            Cell(str(number), number),
            Cell(segment.name or segment.component, style="words"),
            *(measured(q, value) for q, value in zip(quantities, numbers, strict=True)),
        )
        for number, (segment, numbers) in enumerate(segment_rows(moved), start=1)
    )
    across, along = words("in_motion.across"), words("in_motion.along")
    told = (
        units(words, quantities[0]), units(words, quantities[1]), units(words, quantities[2]),
        Heading(f"C_D, {across}", is_number=True), Heading(f"C_D, {along}", is_number=True),
        units(words, quantities[5]),
        Heading(f"C_A, {across}", is_number=True), Heading(f"C_A, {along}", is_number=True),
    )  # fmt: skip
    number, name = words("components.segment"), words("components.name")
    headings = (Heading(number, is_number=True), Heading(name), *told)
    return Table("motion_segments", headings, rows, words("in_motion.segments"))


def _in(si: float, unit: str) -> Cell:
    return Cell(f"{si:g} {unit}", si)


def _in_degrees(si: float) -> Cell:
    return Cell(f"{math.degrees(si):.4g}°", si)
