"""What drives a line in motion, and the model that it is run with, in a note."""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from catopt.answers.blocks import Block, Fact, Facts, Rows, Table, Value, measured, tabulate, texts
from catopt.answers.note import small
from catopt.quantities import Quantity
from catopt.words import Cited, Message, Several

if TYPE_CHECKING:
    from catopt.fem.morison import MorisonSection as Section
    from catopt.model import CurrentProfile, Motion, Segment, WaveState
    from catopt.notes.motion import InMotion

_JUDGED_BY = {
    "largest": "by_largest",
    "most-probable": "by_most_probable",
    "upper": "by_upper",
}


def significant(unit: str, digits: int = 6) -> Quantity:
    """Take what is written with some significant digits, in an SI unit."""
    return Quantity("", "", "", unit, unit, 1.0, digits, "significant")


def fixed(unit: str, digits: int) -> Quantity:
    """Take what is written with some digits after the point, in an SI unit."""
    return Quantity("", "", "", unit, unit, 1.0, digits)


_DEGREES = Quantity("", "", "", "rad", "deg", math.pi / 180.0, 4, "significant")
_S, _M, _NUMBER, _SPEED = (significant(unit) for unit in ("s", "m", "-", "m/s"))
_S4, _M4 = significant("s", 4), significant("m", 4)
PERCENT = Quantity("", "", "", "-", "%", 0.01, 2)
_MOST_RAOS, _MOST_SEEDS = 40, 4
_SEVENTH = 1.0 / 7.0
_AXES = ("surge", "sway", "heave")


def drive_blocks(moved: InMotion) -> Iterator[Block]:
    """Lay out what drives the line, the model, and inertia and drag of its segments."""
    yield Facts("motion_drive", tuple(drive_facts(moved)), _said("drive"))
    if moved.drive.raos is not None:
        # Tabulate a ship's response at the fairlead, by rising period.
        raos = moved.drive.raos
        count = len(raos.omega)
        rows = range(count - 1, -1, -1)[:: max(1, math.ceil(count / _MOST_RAOS))]
        sizes = abs(raos.response)
        periods = [2.0 * math.pi / float(raos.omega[row]) for row in rows]
        columns = [measured(_S4, periods, "note_motion.rao_period")]
        for k, axis in enumerate(_AXES):
            if not sizes[:, k].any():
                continue
            size = [float(sizes[row, k]) for row in rows]
            # Where nothing moves there is no lag, whatever the file has.
            lags = [
                _lag(complex(raos.response[row, k])) if of > 0.0 else None
                for row, of in zip(rows, size, strict=True)
            ]
            along = _said(f"{axis}_motion")
            columns.append(measured(significant("m/m", 4), size, along))
            columns.append(measured(_DEGREES, lags, _said("phase", axis=along)))
        yield Table("motion_raos", tuple(columns), _said("rao_table"))
    yield Facts("motion_model", tuple(_model(moved)), _said("model"))
    yield segments_table(moved)
    yield small("note_motion.coefficients")


def _fact(key: str, value: Value, quantity: Quantity | None = None) -> Fact:
    return Fact(_said(key), value, quantity)


def _said(key: str, **values: object) -> Message:
    return Message(f"note_motion.{key}", **values)


def drive_facts(moved: InMotion) -> Iterator[Fact]:
    """List what drives the line: waves, current, motion of the fairlead, each with its figures."""
    case = moved.found.case
    if case.waves is not None:
        yield from _waves(case.waves, moved)
    if case.current is not None:
        yield from _current(case.current, moved)
    if case.motion is not None:
        yield from _motion(case.motion, moved)


def _waves(waves: WaveState, moved: InMotion) -> Iterator[Fact]:
    if waves.elevation_file:
        record, kept = moved.drive.elevation, moved.drive.recorded_waves
        assert record is not None
        name = Cited(Path(waves.elevation_file).name)
        yield _fact("waves", _said("recorded_surface", file=name))
        yield _fact("surface_length", record.duration, _S)
        yield _fact("recorded_at", waves.elevation_x, _M)
        yield _fact("significant_height", kept.significant_height, _M4)
        yield _fact("wave_direction", waves.direction, _DEGREES)
        yield _fact("components", kept.count)
        yield _fact("shortest_kept", 2.0 * math.pi / float(kept.omega[-1]), _S4)
        yield _fact("variance_left_out", record.left_out(kept), PERCENT)
        yield _fact("mean_taken_off", record.mean, _M4)
    for train, gamma in zip(waves.all_trains, moved.drive.gammas, strict=True):
        is_regular = train.spectrum == "regular"
        yield _fact("waves", _said(train.spectrum.replace("-", "_")))
        yield _fact("wave_height" if is_regular else "significant_height", train.height, _M)
        yield _fact("wave_period" if is_regular else "peak_period", train.period, _S)
        if gamma is not None:
            by_rule = "gamma_by_rule" if train.peak_enhancement is None else "gamma"
            yield _fact(by_rule, gamma, significant("-", 4))
        yield _fact("wave_direction", train.direction, _DEGREES)
        if train.spreading_exponent is not None:
            n, count = f"{train.spreading_exponent:g}", train.directions
            yield _fact("spreading", _said("cosine_power", n=n, count=count))
        if not is_regular:
            yield _fact("components", train.components)
    if waves.is_random:
        runs = moved.drive.dynamics.runs
        seeds = [f"({waves.seed}, {k})" for k in range(min(runs, _MOST_SEEDS))]
        if runs > _MOST_SEEDS:
            seeds.append(f"… ({waves.seed}, {runs - 1})")
        yield _fact("seeds", ", ".join(seeds))
    yield _fact("stretching", _said(f"stretching_{waves.stretching}"))


def _current(current: CurrentProfile, moved: InMotion) -> Iterator[Fact]:
    yield _fact("current", _said(f"current_{current.profile}"))
    if current.series_file:
        yield from _current_series(current, moved)
    if current.speed is not None:
        yield _fact("surface_speed", current.speed, _SPEED)
    if current.profile == "power":
        given = current.exponent
        yield _fact("exponent", _SEVENTH if given is None else given, _NUMBER)
    if current.depth is not None:
        yield _fact("current_depth", current.depth, _M)
    if current.depths:
        pairs = zip(current.speeds, current.depths, strict=True)
        at = (_said("speed_at", v=f"{v:g}", d=f"{d:g}") for v, d in pairs)
        yield _fact("speeds", Several(at))
    if current.directions:
        turned = zip(current.directions, current.depths, strict=True)
        at = (_said("direction_at", b=f"{math.degrees(b):.4g}", d=f"{d:g}") for b, d in turned)
        yield _fact("directions", Several(at))
    elif moved.drive.current is None or moved.drive.current.directions is None:
        yield _fact("current_direction", current.direction, _DEGREES)


def _current_series(current: CurrentProfile, moved: InMotion) -> Iterator[Fact]:
    import numpy as np

    series = moved.drive.current
    assert series is not None
    name = Cited(Path(current.series_file).name)
    yield _fact("current_series", _said("series_in", file=name))
    low, high = np.min(series.speeds), np.max(series.speeds)
    yield _fact("series_speed", f"{low:.4g} … {high:.4g} m/s")
    if series.directions is not None:
        b = np.degrees(series.directions)
        yield _fact("series_direction", f"{b.min():.4g}° … {b.max():.4g}°")


def _motion(motion: Motion, moved: InMotion) -> Iterator[Fact]:
    if motion.period is not None:
        yield _fact("motion", _said("harmonic"))
        yield _fact("motion_period", motion.period, _S)
        for axis in _AXES:
            size, phase = getattr(motion, axis), getattr(motion, f"{axis}_phase")
            if size:
                along = _said(f"{axis}_motion")
                yield Fact(_said("amplitude_of", axis=along), size, _M)
                yield Fact(_said("phase", axis=along), phase, _DEGREES)
        return
    name = Cited(Path(motion.file or motion.rao_file).name)
    yield _fact("motion", _said("record" if motion.file else "raos", file=name))
    record = moved.drive.record
    if record is not None:
        times, values = record.times, record.values
        yield _fact("record_length", float(times[-1] - times[0]), _S)
        for axis, moves in zip(_AXES, values.T, strict=True):
            if moves.any():
                ends = {"a": f"{moves.min():.4g}", "b": f"{moves.max():.4g}"}
                yield _fact(f"record_{axis}", _said("from_to", **ends))


def _lag(response: complex) -> float:
    """Lag of a response behind the crest, from 0 to a full turn."""
    return math.atan2(response.imag, response.real) % (2.0 * math.pi)


def _model(moved: InMotion) -> Iterator[Fact]:
    case, dynamics = moved.found.case, moved.drive.dynamics
    part = moved.found.parts[moved.governing]
    run = part.runs[0].history
    average = dynamics.scheme == "newmark"
    radius = f"{dynamics.spectral_radius:g}"
    scheme = _said("average") if average else _said("generalised", radius=radius)
    yield _fact("bars", part.elements)
    yield _fact("runs", dynamics.runs)
    yield _fact("duration", dynamics.duration, _S)
    yield _fact("of_interest", dynamics.duration_of_interest, _S)
    yield _fact("judged_by", _said(_JUDGED_BY[dynamics.judged_by]))
    yield _fact("ramp", moved.drive.ramp, _S)
    yield _fact("since", run.since, _S)
    yield _fact("step", run.step, _S4)
    yield _fact("scheme", scheme)
    yield _fact("line_damping", dynamics.critical_ratio, _NUMBER)
    yield _fact("damping_time", dynamics.damping_time, _S)
    for key, value, unless_given, unit in (
        ("bed_stiffness", dynamics.seabed_stiffness, "one_centimetre", "N/m²"),
        ("bed_damping", dynamics.seabed_damping, "critical", "N s/m²"),
    ):
        given = value is not None
        yield _fact(key, value, significant(unit)) if given else _fact(key, _said(unless_given))
    yield _fact("bed_friction", case.site.seabed_friction, _NUMBER)
    yield _fact("initial_friction", _said(f"friction_{dynamics.initial_friction}"))
    yield _fact("density", case.site.water_density, significant("kg/m³"))


def segments_table(moved: InMotion) -> Table:
    """Tabulate inertia and drag of the segments, each coefficient beside its diameter."""
    fluid, segments = moved.drive.properties.fluid, Rows(moved.found.case.line.segments)
    sections = Rows(moved.drive.properties.sections or ())
    across, along = "note_motion.across", "note_motion.along"

    def displaced(segment: Segment) -> float:
        """Diameter of a cylinder of the same volume, m."""
        assert segment.mass is not None
        area = (segment.mass - segment.submerged_weight / fluid.gravity) / fluid.density
        return math.sqrt(4.0 * max(area, 0.0) / math.pi)

    def drag_along(section: Section) -> float | None:
        """Return the coefficient; of an oblique flow it is no single number: a remark has it."""
        return None if any(section.oblique) else section.drag_tangential

    return tabulate(
        "motion_segments",
        texts("segment", range(1, len(segments.rows) + 1)),
        segments.texts("name", lambda segment: segment.name or segment.component),
        segments.measured("mass_per_length", "mass"),
        *segments.own("EA", "drag_diameter"),
        sections.measured("coefficient", "drag_normal", across, symbol="C_D"),
        sections.measured("coefficient", drag_along, along, symbol="C_D"),
        segments.measured("volume_diameter", displaced),
        sections.measured("coefficient", "added_mass_normal", across, symbol="C_A"),
        sections.measured("coefficient", "added_mass_tangential", along, symbol="C_A"),
        caption=_said("segments"),
    )
