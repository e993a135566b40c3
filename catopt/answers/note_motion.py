"""Lines in motion, in a note: their tensions, what drives them, and what is to be known."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from dataclasses import replace
from operator import attrgetter, methodcaller
from pathlib import Path
from typing import TYPE_CHECKING

from catopt.answers import blocks
from catopt.answers.blocks import (
    Block,
    Fact,
    Facts,
    Figure,
    Rows,
    Table,
    Text,
    Value,
    measured,
    tabulate,
    texts,
)
from catopt.answers.check import checks_in_motion
from catopt.answers.motion import (
    ENERGIES,
    FORCE,
    lines_of_body,
    lines_of_points,
    over_runs,
    quantities_table,
)
from catopt.answers.note import small
from catopt.answers.verification import quantity_in_note
from catopt.figures.motion import envelope_chart, history, peaks_above, track
from catopt.quantities import Quantity, fixed, significant
from catopt.units import lasting
from catopt.verify.motion_words import (
    DYNAMIC_QUANTITY_OF,
    dynamic_sentences,
    motion_sentences,
    proof_sentences,
    stopped_sentence,
)
from catopt.words import Cited, Listed, Measure, Message, Several, term

if TYPE_CHECKING:
    from catopt.catenary.solution import Solution
    from catopt.fem.morison import MorisonSection as Section
    from catopt.model import CurrentProfile, Motion, Segment, WaveState
    from catopt.notes.line import Note
    from catopt.notes.motion import InMotion
    from catopt.notes.system import NetworkNote, SystemNote
    from catopt.verify.dynamic_result import DynamicPart, DynamicVerification

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
            # Lag behind the crest, from 0 to a full turn; where nothing moves, whatever the file
            # has, there is none.
            lags = [
                cmath.phase(raos.response[row, k]) % (2.0 * math.pi) if of > 0.0 else None
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
    judged_by = dynamics.judged_by.replace("-", "_")
    yield _fact("judged_by", Message(f"note_motion.by_{judged_by}"))
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
    fluid, segments = moved.drive.properties.fluid, Rows(moved.drive.one.line.segments)
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


_FACTOR = fixed("-", 3)
_SLACK = fixed("s", 2)
_ENERGY = replace(significant("kJ", 4), si_unit="J", factor=1e3)
_PART = replace(blocks.named("residual", ""), si_unit="-", field_unit="-", digits=1)
_MOST_RUNS = 30

_EXTREMES = {
    "probable": "tail.extreme.most_probable",
    "interval_from": "tail.extreme.low",
    "interval_to": "tail.extreme.high",
    "expected": "tail.extreme.expected",
    "threshold": "tail.threshold",
    "peaks_above": "tail.clusters",
    "weibull_scale": "tail.scale",
    "weibull_shape": "tail.shape",
}
"""What is listed of an extreme, and where a quantity's statistics have it."""
_OF_TAIL = {"peaks_above": fixed("-", 0), "weibull_shape": _FACTOR}
"""What is no value of the quantity itself."""


def motion_blocks(note: Note) -> Iterator[Block]:
    """Lay out the line in motion; nothing where nobody asked for it."""
    moved = note.motion
    if moved is None:
        return
    index = moved.governing
    part, uses, solution = moved.found.parts[index], moved.uses[index], moved.solutions[index]
    yield from _stopped(moved.found)
    about = [Message("note_motion.about")]
    if moved.found.case.load_cases:
        about.append(Message("note_motion.shown", name=part.name))
    yield Text(Several(about, " "))
    yield _verdict(note, moved.used(index), part)
    yield Text(Several(dynamic_sentences(part), " "))
    if len(moved.found.parts) > 1:
        yield _cases(moved)
    yield _statistics(part, solution)
    yield _uses(moved, index)
    balance = part.governing.history.balance
    facts = (
        _fact("anywhere", part.max_tension, FORCE),
        _fact("still_max", part.quasi_static_max, FORCE),
        _fact("amplification", part.dynamic_amplification, _FACTOR),
        _fact("slack_time", part.slack_time, _SLACK),
        _fact("longest_slack", part.longest_slack, _SLACK),
        *(
            Fact(_said("energy", what=term(name)), getattr(balance, energy), _ENERGY)
            for name, energy in ENERGIES.items()
        ),
        _fact("energy_part", balance.numerical_part, _PART),
    )
    yield Facts("motion_outcome", facts, _said("outcome"))
    yield from _extremes(part)
    peaks = peaks_above(part)
    if peaks is not None:
        yield Figure(peaks, Message("note_motion.exceedance"))
    drawn = history(part, solution.fairlead.tension)
    yield Figure(drawn, Message("note_motion.history"))
    allowed = [use.capacity for use in uses]
    yield Figure(envelope_chart(part, solution, allowed), Message("note_motion.envelope"))
    yield blocks.Points((*_known(note, moved, part), *part.remarks), Message("note_motion.to_know"))
    yield from drive_blocks(moved)
    yield from _runs(moved, part)


def _stopped(found: DynamicVerification) -> Iterator[Block]:
    if not found.is_complete:
        yield blocks.Verdict(stopped_sentence(found), passes=False)


def _verdict(note: Note, used: float | None, part: DynamicPart) -> blocks.Verdict:
    largest = Measure("tension", part.max_tension)
    good = part.slack_time == 0.0 and part.verdict == "converged" and (used is None or used <= 1.0)
    if used is None:
        return blocks.Verdict(Message("note_motion.no_limit", T=largest), good)
    basis = Message("note_motion.by_checks")
    if not _is_checked(note):
        basis = Message("note_motion.by_mbl", factor=f"{note.solution.safety_factor:g}")
    key = "note_motion.within" if used <= 1.0 else "note_motion.beyond"
    return blocks.Verdict(Message(key, T=largest, used=f"{used:.3f}", basis=basis), good)


def _is_checked(note: Note) -> bool:
    return any(check.kind == "tension" for check in note.checks.results)


# ------------------------------------------------------------------ statistics


def _statistics(part: DynamicPart, solution: Solution) -> Table:
    """Tabulate each quantity beside its value at rest, in closed form."""
    rest = {
        "fairlead_tension": solution.fairlead.tension,
        "anchor_tension": solution.anchor.tension,
        "grounded_length": solution.grounded_length,
        "offset": 0.0,
    }
    values = [rest[each.quantity] for each in part.quantities]
    table = quantities_table(part, _said("statistics"), values)
    return replace(table, name="motion_statistics", only="all")


def _cases(moved: InMotion) -> Table:
    """Tabulate the load cases, the one that is shown marked."""
    parts = moved.found.parts
    table = lines_of_body(parts, [solution.fairlead.tension for solution in moved.solutions])
    used = measured("utilisation", map(moved.used, range(len(parts))))
    return replace(
        table,
        name="motion_cases",
        columns=(*table.columns, used),
        caption=_said("cases"),
        marked=moved.governing,
        only="all",
    )


def _uses(moved: InMotion, shown: int) -> Table:
    """Tabulate what each segment carries; people see the load case that governs."""
    every = zip(moved.found.parts, moved.uses, strict=True)
    cases = [(index, part.name) for index, (part, uses) in enumerate(every) for _ in uses]
    of = Rows(use for uses in moved.uses for use in uses)
    largest = of.measured(FORCE, "largest", "largest_tension")
    allowed = of.measured(FORCE, "capacity", "note.workbook_allowed")
    used = of.measured("utilisation", "utilisation", formula=(largest, "/", allowed))
    passes = tuple(None if each is None else each <= 1.0 for each in of.read("utilisation"))
    words = {None: None, True: Message("answers.passes"), False: Message("answers.fails")}
    return tabulate(
        "motion_use",
        texts("load_case", (name for _, name in cases), only="files"),
        of.texts("segment", "number"),
        of.texts("name"),
        largest,
        of.measured(FORCE, "at_rest", "note_motion.rest"),
        allowed,
        used,
        texts("verdict", map(words.get, passes), passes=passes),
        caption=Message("note_motion.uses"),
        shown=tuple(row for row, (index, _) in enumerate(cases) if index == shown),
    )


# ------------------------------------------------------------------ what it comes to


def _extremes(part: DynamicPart) -> Iterator[Table]:
    """List what extremes are and what they rest on, a column each random quantity."""
    every = [each for each in part.quantities if each.tail is not None]
    if not every:
        return
    by_minute = any(each.storm is not each.tail.extreme for each in every if each.tail)
    listed: dict[str, str] = {}
    if by_minute:
        listed = {"judged": "storm.most_probable"}
        listed |= {"judged_from": "storm.low", "judged_to": "storm.high"}
    listed |= _EXTREMES
    if every[0].gumbel is not None:
        listed |= {"by_gumbel": "gumbel.extreme.most_probable"}
        listed |= {"gumbel_from": "gumbel.extreme.low", "gumbel_to": "gumbel.extreme.high"}
    columns = []
    for each in every:
        quantity = DYNAMIC_QUANTITY_OF[each.quantity]
        values = [
            len(value) if isinstance(value, tuple) else value
            for value in attrgetter(*listed.values())(each)
        ]
        units = tuple(_OF_TAIL.get(key, quantity) for key in listed)
        columns.append(texts(quantity_in_note(quantity), values, units=units))
    caption = Message("note_motion.extremes", time=lasting(part.duration_of_interest))
    names = texts("what", (Message(f"note_motion.{key}") for key in listed))
    yield tabulate("motion_extremes", names, *columns, caption=caption)


def _runs(moved: InMotion, part: DynamicPart) -> Iterator[Block]:
    waves, every = moved.found.case.waves, part.runs
    seed = waves.seed if part.drive.is_random and waves is not None else None
    of = Rows(every)
    histories = Rows(of.read("history"))
    largest = Rows(of.read(methodcaller("statistics", "fairlead_tension")))
    yield tabulate(
        "motion_runs",
        of.texts("run", lambda run: run.number + 1),
        of.texts("seed", lambda run: "-" if seed is None else f"({seed}, {run.number})"),
        largest.measured(FORCE, "maximum", "largest_fairlead_tension"),
        largest.measured(_SLACK, "time_of_maximum", "at"),
        of.measured(FORCE, "quasi_static_max", "largest_quasi_static_fairlead_tension"),
        histories.measured(_SLACK, methodcaller("line_slack_time"), "slack_in_all"),
        histories.texts("steps"),
        histories.texts("halvings"),
        caption=Message("note_motion.run_table"),
        shown=tuple(range(min(len(every), _MOST_RUNS))),
        marked=every.index(part.governing),
    )
    if len(every) > _MOST_RUNS:
        yield small("note_motion.left_out", count=len(every) - _MOST_RUNS)


# ------------------------------------------------------------------ what is to be known


def _known(note: Note, moved: InMotion, part: DynamicPart) -> Iterator[Message]:
    """Yield what an engineer must know of the figures: what they are of, what they leave out."""
    yield Message(
        "note_motion.transient",
        ramp=f"{moved.drive.ramp:g}",
        since=f"{part.runs[0].history.since:g}",
        end=f"{moved.drive.dynamics.duration:g}",
    )
    if part.drive.is_random:
        peaks = sum(run.statistics("fairlead_tension").peaks for run in part.runs)
        if len(part.runs) == 1:
            yield Message("note_motion.one_seed", peaks=peaks)
        else:
            yield Message("note_motion.several_seeds", runs=len(part.runs), peaks=peaks)
        yield Message("note_motion.in_duration", duration=lasting(part.duration_of_interest))
    else:
        yield Message("note_motion.not_random")
    if moved.codes:
        yield Message("note_motion.allowed_dynamic", codes=Listed(moved.codes, "and"))
    elif _is_checked(note):
        yield Message("note_motion.allowed_at_rest")
    else:
        factor = f"{note.solution.safety_factor:g}"
        yield Message("note_motion.allowed_by_mbl", factor=factor)
    led = () if note.case.floater is not None else ("led",)
    yield from (Message(f"note_motion.{key}") for key in (*led, "ends", "grounded"))


# ------------------------------------------------------------------ a body's lines


def body_motion_blocks(note: SystemNote | NetworkNote) -> Iterator[Block]:
    """Lay out all lines of a body, or between points, in motion; nothing where not asked for."""
    found = note.motion
    if found is None:
        return
    governing = found.governing
    assert governing.line is not None
    yield from _stopped(found)
    of_points = governing.between is not None
    yield Text(Message("note_system.points_about" if of_points else "note_system.motion_about"))
    said = [
        Message("note_motion.of_line", number=part.shown, said=sentence)
        for part, sentences in (
            (governing, motion_sentences),
            (found.least_proven, proof_sentences),
        )
        for sentence in sentences(part)
    ]
    yield blocks.Verdict(Several(said, " "), found.verdict == "converged")
    if note.motion_checks is not None and note.motion_checks.results:
        yield from checks_in_motion(note.motion_checks)
    at_rest = [line.tension for line in note.at_rest]
    if of_points:
        yield from lines_of_points(found)
    else:
        marked = found.parts.index(governing)
        lines = replace(lines_of_body(found.parts, at_rest), name="system_motion_lines")
        yield replace(lines, marked=marked, only="all")
    if found.body:
        numbers = over_runs(found.body, in_note=True)
        yield tabulate("system_motion_body", *numbers, caption=Message("motion.the_body"))
    if governing.governing.track is not None:
        yield Figure(track(found), Message("note_system.motion_track"))
    caption = Message("note_system.motion_history", line=governing.shown)
    yield Figure(history(governing, at_rest[governing.line - 1]), caption)
    remarks = dict.fromkeys(each for part in found.parts for each in part.remarks)
    ends = () if of_points else (Message("note_motion.ends"),)
    yield blocks.Points((*ends, *remarks), Message("note_motion.to_know"))
