"""Lines in the time domain: a fairlead that is led, or a body under a force, in waves and current.

Static equilibrium comes first, in the current; then motion, force and waves grow smoothly.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import fields, replace
from typing import Any

import numpy as np

from catopt.arrays import Array
from catopt.errors import InputError, Problem, refused
from catopt.fem.dynamic_model import LineProperties, lay_out_moving
from catopt.fem.extremes import FOLLOWED, course_of
from catopt.fem.history import STOPPED, History
from catopt.fem.march import StepCounts
from catopt.fem.mesh import SAME_PLACE, LineMesh, end_nodes, mesh_line
from catopt.fem.moving import BodyNode, MovingLines
from catopt.fem.network import LineEnd, MeetingPoint, solve_network
from catopt.fem.run_settings import BodyInertia, TimeStepping, record_warnings, step_warnings
from catopt.fem.sampling import Record
from catopt.fem.seabed import Bed, RestrainedBed, Seabed
from catopt.fem.series import Harmonic, Sampled, Series, Together, fill_series, series_rows
from catopt.fem.simulation import Break, Simulation
from catopt.fem.sloped_rest import bring_to_rest_on_slope
from catopt.fem.solve import Leg, solve_line, solve_system
from catopt.model import Line
from catopt.model.kinds import Findings
from catopt.model.network import Point
from catopt.waves import Sea
from catopt.words import Measure, Message

_SERIES = (Harmonic, Sampled, Together)
_UNCERTAIN = 1e-3
"""Part of the tension at rest that rounding may take or give without a word."""
_SHALLOW = 0.001
"""Least depth to which a line's weight presses the bed on which it first comes to rest, m."""


def run_dynamics(
    line: Line,
    stepping: TimeStepping,
    *,
    height: float,
    span: float | None = None,
    horizontal_force: float | None = None,
    anchor_height: float = 0.0,
    motion: Series | None = None,
    anchor_motion: Series | None = None,
    anchor_lost: float | None = None,
    broken: Break | None = None,
    properties: LineProperties | None = None,
    sea: Sea | None = None,
    elements: int | Sequence[int] = 100,
    mesh: LineMesh | None = None,
    progress: Callable[[float], None] | None = None,
) -> History:
    """Run one line whose fairlead is led.

    Parameters
    ----------
    line : Line
        From its anchor at x = y = 0; every segment with mass and EA.
    height, span, horizontal_force, anchor_height
        Rest, as for `solve_line`; the motion goes on about the fairlead's place there.
    motion, anchor_motion : Harmonic or Sampled, optional
        Of the fairlead and of the lower end, m, from their places at rest; they stay by default.
    anchor_lost : float, optional
        When the lower end becomes free, s, to the nearest sample but not at the start.
    broken : Break, optional
        How else the line, 0, parts: at its fairlead, or where it reaches its strength.
    sea : Sea, optional
        Waves and current; its depth is that of the bed at z = 0. Without, all is submerged in
        still water. A sea whose waves have no ramp of their own takes that of `stepping`.
    elements, mesh
        Bars, as for `solve_line`.
    progress : callable, optional
        Called with the time reached, s.

    Raises
    ------
    InputError, NoEquilibriumError
        As `solve_line`, and for what dynamics lacks.
    NotConvergedError
        With time, node and force left over; or when what is computed is the scheme's own ringing.
    """
    warnings = check_run(stepping, motion, anchor_motion, sea=sea)
    cut = mesh or mesh_line(line, elements)
    simulation = line_at_rest(
        cut,
        height=height,
        span=span,
        horizontal_force=horizontal_force,
        anchor_height=anchor_height,
        properties=properties,
        sea=ramped(sea, stepping),
    )
    ends, prescribed_motion = simulation.state.x[-1:], [motion]
    if anchor_motion is not None:
        ends, prescribed_motion = simulation.state.x[[-1, 0]], [motion, anchor_motion]
    simulation.prescribed_motion = series_rows(ends, prescribed_motion, stepping.ramp_time)
    if anchor_lost is not None:
        broken = Break(0, anchor_lost, at_anchor=True)
    return run_from_rest(simulation, stepping, [cut], warnings, progress, broken)


def line_at_rest(
    mesh: LineMesh,
    *,
    height: float,
    span: float | None = None,
    horizontal_force: float | None = None,
    anchor_height: float = 0.0,
    properties: LineProperties | None = None,
    sea: Sea | None = None,
) -> Simulation:
    """Bring one line to rest in the current, ready to be set in motion."""
    of = properties or LineProperties()
    lines, seabed = lay_out_moving([mesh], of), of.seabed
    bed, friction = _static_bed(seabed, lines)
    rest = solve_line(
        mesh.line,
        height=height,
        span=span,
        horizontal_force=horizontal_force,
        anchor_height=anchor_height,
        mesh=mesh,
        bed=bed,
        seabed_friction=friction,
    )
    if isinstance(seabed, Seabed) and seabed.slope != 0.0:
        return _on_slope(lines, rest.nodes, seabed, horizontal_force, sea)
    simulation = Simulation(lines, rest.nodes, sea=sea)
    simulation.settle(rubbed=_begins_rubbed(seabed))
    return simulation


def _on_slope(
    lines: MovingLines, level: Array, seabed: Seabed, pull: float | None, sea: Sea | None
) -> Simulation:
    """Bring a line to rest on a sloped bed, from its nodes on a level one.

    Under a horizontal pull, N, its fairlead goes along x to where it balances that.
    """
    _check_above_bed(level[-1], seabed.slope)
    if pull is None:
        simulation = Simulation(lines, level, sea=sea)
        bring_to_rest_on_slope(simulation, seabed.initial_friction)
    else:
        free = BodyNode(np.array([1.0, 0.0, 0.0]), np.zeros(3), np.zeros(3))
        load = series_rows(np.array([[pull, 0.0, 0.0]]), [None], 0.0)
        simulation = Simulation(lines, level, body=free, load=load, sea=sea)
        bring_to_rest_on_slope(simulation, seabed.initial_friction)
        simulation.hold_ends()
    _check_above_bed(simulation.state.x[-1], seabed.slope)
    return simulation


def _check_above_bed(fairlead: Array, slope: float) -> None:
    """Refuse a fairlead that is not above the bed."""
    bed = float(fairlead[0]) * math.tan(slope)
    if not fairlead[2] > bed:
        allowed = Message("refused_motion.bed_rises_m_under_fairlead", bed=bed)
        raise refused("height", f"{fairlead[2]:g} m", allowed, "run_dynamics")


def run_system_dynamics(
    legs: Sequence[Leg],
    stepping: TimeStepping,
    *,
    height: float,
    mean_force: tuple[float, float] = (0.0, 0.0),
    force: Series | None = None,
    body: BodyInertia | None = None,
    position: tuple[float, float] | None = None,
    motion: Series | Sequence[Series] | None = None,
    properties: LineProperties | None = None,
    sea: Sea | None = None,
    elements: int | Sequence[int] = 100,
    meshes: Sequence[LineMesh] | None = None,
    broken: tuple[int, float] | Break | None = None,
    at_anchor: bool = False,
    progress: Callable[[float], None] | None = None,
) -> History:
    """Run several lines that meet in a body, which moves under a force or is led.

    Parameters
    ----------
    height : float
        Of the body's origin above the bed, m; held unless `motion` moves it.
    mean_force : tuple of float
        On the body along x and y, N: under it the lines are at rest.
    force : Harmonic or Sampled, optional
        What comes on top of it, N; its part along z is not used.
    body : BodyInertia, optional
        Of the body that moves freely; no mass by default.
    position, motion : tuple of float and Harmonic, Sampled or a sequence of them, optional
        Instead of forces: where the body's origin rests, m, and its motion about that; that of
        each leg's fairlead where the body turns.
    properties, sea, elements, meshes, progress
        As for `run_dynamics`; sections are shared by all lines.
    broken : tuple of int and float, or Break, optional
        A line, from 0, that breaks at its fairlead, and when, s, to the nearest sample: its last
        bar is then gone. Or where and when else it parts. Largest values count from then on.
    at_anchor : bool
        It breaks at its anchor instead: its lower end is then free.

    Raises
    ------
    InputError, NotConvergedError
        As for `run_dynamics`.
    """
    is_led = position is not None
    _check_system(is_led, motion, force, mean_force)
    cuts = [mesh_line(leg.line, elements) for leg in legs] if meshes is None else list(meshes)
    prescribed_motion = (
        [motion] * len(cuts) if motion is None or isinstance(motion, _SERIES) else list(motion)
    )
    warnings = check_run(stepping, *(prescribed_motion if is_led else [force]), sea=sea)
    simulation = body_at_rest(
        legs,
        cuts,
        height=height,
        mean_force=mean_force,
        body=body,
        position=position,
        properties=properties,
        sea=ramped(sea, stepping),
    )
    ramp_time = stepping.ramp_time
    simulation.prescribed_motion = series_rows(
        simulation.prescribed_motion.base, prescribed_motion or [None] * len(cuts), ramp_time
    )
    simulation.load = series_rows(simulation.load.base, [force], ramp_time)
    if broken is not None and not isinstance(broken, Break):
        broken = Break(*broken, at_anchor)
    return run_from_rest(simulation, stepping, cuts, warnings, progress, broken)


def body_at_rest(
    legs: Sequence[Leg],
    cuts: Sequence[LineMesh],
    *,
    height: float,
    mean_force: tuple[float, float] = (0.0, 0.0),
    body: BodyInertia | None = None,
    position: tuple[float, float] | None = None,
    properties: LineProperties | None = None,
    sea: Sea | None = None,
) -> Simulation:
    """Bring the lines of a body to rest in the current, ready to be set in motion."""
    is_led = position is not None
    of = properties or LineProperties()
    _check_level(of.seabed)
    lines, seabed = lay_out_moving(cuts, of), of.seabed
    bed, friction = _static_bed(seabed, lines)
    rest = solve_system(
        legs,
        height=height,
        force=None if is_led else mean_force,
        position=position,
        meshes=cuts,
        bed=bed,
        seabed_friction=friction,
    )
    ends = np.array([each.nodes[-1] for each in rest.lines])
    inertia = body or BodyInertia()
    free = np.array([0.0, 0.0, 0.0] if is_led else [1.0, 1.0, 0.0])
    simulation = Simulation(
        lines,
        rest.rest.state.x,
        body=BodyNode(free, np.full(3, inertia.mass), np.full(3, inertia.damping)),
        prescribed_motion=series_rows(ends, [None] * len(cuts), 0.0),
        load=series_rows(np.array([[*mean_force, 0.0]]), [None], 0.0),
        sea=sea,
    )
    simulation.settle(rubbed=_begins_rubbed(seabed))
    return simulation


def run_network_dynamics(
    meshes: Sequence[LineMesh],
    ends: Sequence[tuple[LineEnd, LineEnd]],
    joints: Sequence[Point],
    stepping: TimeStepping,
    *,
    motions: Sequence[tuple[Series | None, Series | None]] | None = None,
    properties: LineProperties | None = None,
    sea: Sea | None = None,
    broken: Break | None = None,
    progress: Callable[[float], None] | None = None,
) -> History:
    """Run lines that meet in joints, with what is fixed to these.

    Parameters
    ----------
    meshes, ends
        Lines, and where the first and the last end of each is held, m, or its joint, from 0.
    joints
        Weight, force, mass, drag and added mass are read of them.
    motions
        Of the first and of the last end of each line about where it is held, m; None: it stays.
    broken
        A line that parts at its last end; at its first, if that is held; or by its strength.
    properties, sea, progress
        As for `run_dynamics`; places of the joints are the `nodes` of what is returned.

    Raises
    ------
    InputError, NotConvergedError
        As for `run_dynamics`.
    """
    prescribed_motion = motions or [(None, None)] * len(meshes)
    warnings = check_run(stepping, *(each for pair in prescribed_motion for each in pair), sea=sea)
    simulation = network_at_rest(
        meshes, ends, joints, properties=properties, sea=ramped(sea, stepping)
    )
    x, (first, last) = simulation.state.x, end_nodes(simulation.lines.start)
    of_ends = [pair[1] for pair in prescribed_motion] + [pair[0] for pair in prescribed_motion]
    base = x[np.concatenate([last, first])]
    simulation.prescribed_motion = series_rows(base, of_ends, stepping.ramp_time)
    kept = replace(stepping, nodes=tuple(range(len(x) - len(joints), len(x))))
    return run_from_rest(simulation, kept, meshes, warnings, progress, broken)


def network_at_rest(
    meshes: Sequence[LineMesh],
    ends: Sequence[tuple[LineEnd, LineEnd]],
    joints: Sequence[Point],
    *,
    properties: LineProperties | None = None,
    sea: Sea | None = None,
) -> Simulation:
    """Bring lines that meet in joints to rest in the current, ready to be set in motion."""
    of = properties or LineProperties()
    _check_level(of.seabed)
    of_end = np.array([[-1 if e.point is None else e.point for e in pair] for pair in ends])
    lines, seabed = lay_out_moving(meshes, of, joints, of_end), of.seabed
    bed, friction = _static_bed(seabed, lines)
    points = [MeetingPoint(joint.hung) for joint in joints]
    rest = solve_network(meshes, ends, points, bed=bed, seabed_friction=friction)
    places = np.array(rest.places).reshape(-1, 3)
    simulation = Simulation(lines, np.concatenate([rest.rest.state.x, places]), sea=sea)
    simulation.settle(rubbed=_begins_rubbed(seabed))
    return simulation


def _check_beginning(simulation: Simulation) -> None:
    """Refuse a motion that begins away from rest; one at speed takes its line along."""
    motion, out = simulation.prescribed_motion, np.zeros((3, 3))
    for end, base in enumerate(motion.base):
        fill_series(0.0, motion, end, out)
        away = float(np.linalg.norm(out[0] - base))
        if away > SAME_PLACE * max(1.0, float(np.abs(base).max())):
            wanted = Message("refused_motion.motion_begins_m_away_from", away=away)
            problem = Problem("ramp_time", f"{motion.ramp_time:g} s", wanted)
            raise InputError([problem], "TimeStepping")


def run_from_rest(
    simulation: Simulation,
    stepping: TimeStepping,
    cuts: Sequence[LineMesh],
    warnings: list[str],
    progress: Callable[[float], None] | None,
    broken: Break | None = None,
) -> History:
    """Set off from rest; `broken`: a line that parts."""
    _check_beginning(simulation)
    part = simulation.uncertain(stepping.controls.tolerance)
    if part > _UNCERTAIN:
        stiff = Measure("EA", float(simulation.lines.EA.max()))
        warnings = [*warnings, Message("motion.too_stiff", part=part, EA=stiff)]
    if simulation.afloat is None:
        simulation.start()
    record, complete = simulation.run(stepping, breaks=broken, progress=progress)
    counts, seen = simulation.counts, np.isfinite(record.max_tension)
    parted = simulation.parted
    warnings += _warnings_of(counts, stepping, None if complete else float(record.time[-1]))
    # Slides summed up, with the one that goes on at the end.
    _, way, ways, squares, slides = np.moveaxis(record.slides, -1, 0)
    found: dict[str, Any] = record._asdict() | counts._asdict()
    found |= {
        "fairlead_force": record.end_force[:, :, 1],
        "anchor_force": record.end_force[:, :, 0],
        "first_bar": simulation.lines.start,
        "arc": np.concatenate([0.5 * (cut.arc[1:] + cut.arc[:-1]) for cut in cuts]),
        **_courses(record, simulation.lines),
        "slides": np.stack([ways + way, squares + way**2, slides + (way > 0.0)], axis=-1),
        "max_tension": np.where(seen, record.max_tension, np.nan),
        "min_tension": np.where(seen, record.min_tension, np.nan),
        "balance": simulation.balance(record),
        "since": max(stepping.counted_since, parted.time if parted else 0.0),
        "parted": parted,
        "step": stepping.step,
        "shortest_step": min(counts.shortest, stepping.step),
        "is_complete": complete,
        "warnings": tuple(warnings),
    }
    return History(**{each.name: found[each.name] for each in fields(History)})


def _courses(record: Record, lines: MovingLines) -> dict[str, Any]:
    rows = list(map(course_of, record.course, record.turns, record.turn_count))
    size, count = len(FOLLOWED), lines.start.size - 1
    return {
        "courses": tuple(tuple(rows[k * size : (k + 1) * size]) for k in range(count)),
        "bar_courses": tuple(rows[count * size :]),
    }


def _warnings_of(
    counts: StepCounts, stepping: TimeStepping, stopped: float | None
) -> Iterator[str]:
    """Yield what about a run is to be doubted; `stopped`: when it was, s."""
    shortest, step = counts.shortest, stepping.step
    if counts.halvings > 0:
        yield Message("motion.halvings", count=counts.halvings, shortest=shortest, step=step)
    if counts.unresolved > 0:
        count, steps = counts.unresolved, counts.steps
        yield Message("motion.unresolved", count=count, steps=steps, shortest=shortest)
    if stopped is not None:
        yield Message(STOPPED, reached=stopped, duration=stepping.duration)


def check_run(stepping: TimeStepping, *series: Series | None, sea: Sea | None) -> list[str]:
    """Refuse a step that cannot follow; return what is to be warned of."""
    given = [each for each in series if each is not None]
    periods: dict[str, float] = {}
    if given:
        periods[Message("motion.motion_or_force")] = min(each.shortest_period for each in given)
    warnings = step_warnings(stepping.step, stepping.duration, periods, sea)
    for each in given:
        if isinstance(each, Sampled):
            warnings += record_warnings(each.shortest_period, each.usual_step)
    return warnings


def _static_bed(
    seabed: Seabed | RestrainedBed | None, lines: MovingLines
) -> tuple[Bed | RestrainedBed, float]:
    """Bed for the equilibrium from which `Simulation.settle` goes on, and its friction."""
    if seabed is None:
        return RestrainedBed(0.0), 0.0
    if isinstance(seabed, RestrainedBed):
        return seabed, 0.0
    length = float(lines.length.sum())
    softest = float((np.abs(lines.weight) * lines.length).sum()) / length / _SHALLOW
    stiffness = min(float(lines.bed_stiffness.sum()) / length, softest)
    if seabed.initial_friction == "none" or seabed.slope != 0.0:
        return Bed(stiffness), 0.0
    return Bed(stiffness, friction_law=seabed.initial_friction), seabed.friction


def _begins_rubbed(seabed: Seabed | RestrainedBed | None) -> bool:
    """Whether friction that the equilibrium has is taken over into the motion."""
    return not isinstance(seabed, Seabed) or seabed.initial_friction != "none"


def ramped(sea: Sea | None, stepping: TimeStepping) -> Sea | None:
    """Let waves without a ramp of their own grow over that of a run."""
    if sea is None or sea.waves is None or sea.ramp_time > 0.0:
        return sea
    return replace(sea, ramp_time=stepping.ramp_time)


def _check_level(seabed: Seabed | RestrainedBed | None) -> None:
    """Refuse a slope, which rises along the line: those of a body have no direction in common."""
    if isinstance(seabed, Seabed) and seabed.slope != 0.0:
        wanted = Message("refused_motion.one_line_slopes")
        problem = Problem("seabed.slope", f"{seabed.slope:g} rad", wanted)
        raise InputError([problem], "run_system_dynamics")


def _check_system(
    is_led: bool,
    motion: Series | Sequence[Series] | None,
    force: Series | None,
    mean_force: tuple[float, float],
) -> None:
    found = Findings("run_system_dynamics")
    if is_led and (force is not None or mean_force != (0.0, 0.0)):
        given = Message("refused_motion.with_a_position")
        found.add("force", given, Message("refused_motion.body_led_or_under_force"))
    if not is_led and motion is not None:
        given = Message("refused_motion.without_a_position")
        found.add("motion", given, Message("refused_motion.place_of_body"))
    found.raise_if_any()
