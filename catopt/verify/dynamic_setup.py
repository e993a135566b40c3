"""From a case to what the truss model is run with in time."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache

import numpy as np

from catopt.errors import InputError, Problem, refused
from catopt.fem.dynamic_model import Fluid, LineProperties
from catopt.fem.morison import OBLIQUE, MorisonSection, added_mass, steady_drag, wake_amplification
from catopt.fem.newmark import LineDamping, Scheme
from catopt.fem.run_settings import StepControls, TimeStepping
from catopt.fem.seabed import Seabed
from catopt.fem.series import Harmonic, Sampled, Series
from catopt.model import Anchor, Case, Dynamics, Line, Motion, Segment, WaveState, WaveTrain
from catopt.model.network import Network
from catopt.model.sea import CurrentProfile
from catopt.verify.motion_file import (
    Raos,
    VesselRaos,
    read_current,
    read_elevation,
    read_force,
    read_motion,
    read_raos,
    read_vessel_raos,
)
from catopt.waves import (
    CosineSpreading,
    CurrentSeries,
    ElevationRecord,
    PowerLawCurrent,
    Sea,
    TableCurrent,
    Waves,
    WindCurrent,
    jonswap,
    peak_enhancement,
    pierson_moskowitz,
    random_waves,
    regular_wave,
)
from catopt.words import Message

_STEPS = 60.0
"""Steps in the shortest period, unless the step is given."""

_SAMPLES = 20000
"""Most samples of a run, unless their interval is given."""

_RAMP = 0.1
"""Part of the duration, unless the ramp is given."""

_FAST = 0.99
"""Part of the waves, by their energy, that is slower than the shortest period."""


@dataclass(frozen=True)
class Excitation:
    """What drives a case, with its files read.

    `case`: with dynamics; `elevation`: of the surface; `current`: over time; `record`: of the
    motion of the fairlead, or of a body's origin; `raos`: of the fairlead; `vessel`: of a body;
    `drift`: slow, of a body; `force`: on a body, beside its mean; `anchor_record`: of the motion of
    a line's lower end; `counts_cycles`: whether the cycles of every bar's tension are counted;
    `compares_at_rest`: whether what the lines would do without moving is found, too; `sinkers`:
    with their masses, of which it is found how far they would slide.
    """

    case: Case | Network
    elevation: ElevationRecord | None = None
    current: CurrentSeries | None = None
    record: Sampled | None = None
    raos: Raos | None = None
    vessel: VesselRaos | None = None
    drift: Sampled | None = None
    force: Sampled | None = None
    anchor_record: Sampled | None = None
    counts_cycles: bool = False
    compares_at_rest: bool = True
    sinkers: tuple[Anchor, ...] = ()

    @property
    def one(self) -> Case:
        """The case of one line, or of a body's equal ones."""
        assert isinstance(self.case, Case)
        return self.case

    @property
    def dynamics(self) -> Dynamics:
        """How the case is run."""
        assert self.case.dynamics is not None
        return self.case.dynamics

    @property
    def is_random(self) -> bool:
        """Whether runs differ in their seed."""
        return self.case.waves is not None and self.case.waves.is_random

    @property
    def is_led_at_random(self) -> bool:
        """Whether the fairlead goes where a random sea sends it."""
        by_waves = (self.raos, self.vessel, self.case.body, self.case.floater)
        return self.is_random and any(each is not None for each in by_waves)

    def sea(self, run: int) -> Sea:
        """Waves and current of one run, from 0."""
        given, depth = self.case.waves, self.case.site.water_depth
        flow = () if self.case.current is None else (_current(self.case.current),)
        sea = Sea(depth, None, flow, current_series=self.current)
        if given is None:
            return sea
        sea = replace(sea, stretching=given.stretching)
        if self.elevation is None:
            return replace(sea, waves=_waves(given, run))
        waves = self.recorded_waves
        sea = replace(sea, waves=waves)
        # The record's phases are those at its place; the model's, at x = 0.
        ahead = given.elevation_x * math.cos(given.direction)
        return replace(sea, waves=replace(waves, phase=waves.phase - sea.wave_numbers * ahead))

    @cached_property
    def recorded_waves(self) -> Waves:
        """Waves of the recorded surface, with their phases where it was recorded."""
        given = self.case.waves
        assert given is not None
        assert self.elevation is not None
        shortest = given.shortest_period
        return self.elevation.waves(direction=given.direction, shortest_period=shortest)

    @property
    def remarks(self) -> list[str]:
        """What is to be known of the files and of recalled coefficients."""
        remarks: list[str] = []
        record = self.elevation
        if record is not None:
            waves = self.recorded_waves
            known = {
                "count": waves.count,
                "period": 2.0 * math.pi / float(waves.omega[-1]),
                "part": record.left_out(waves),
                "mean": record.mean,
            }
            remarks.append(Message("motion.recorded_waves", **known))
            if record.is_resampled:
                remarks.append(Message("motion.resampled", step=record.step))
        for line in self.case.every_line:
            for at, segment in enumerate(line.segments, start=1):
                if segment.drag_method == "roughness":  # it is not verified
                    section = section_of(segment)
                    drag, mass = section.drag_normal, section.added_mass_normal
                    m, n = section.oblique
                    said = Message("motion.roughness", number=at, drag=drag, mass=mass, m=m, n=n)
                    remarks.append(said)
        return list(dict.fromkeys(remarks))

    def motion(self, sea: Sea, span: float) -> Series | None:
        """Motion of the fairlead in a sea; `span` at rest, m."""
        if self.case.motion is None:
            return None
        if self.record is not None:
            return self.record
        if self.raos is not None and sea.waves is not None:
            return self.raos.motion(sea.waves, sea.wave_numbers, span)
        return self.harmonic

    @property
    def harmonic(self) -> Harmonic:
        """The motion by a period, amplitudes and phases."""
        assert self.case.motion is not None
        return _harmonic(self.case.motion)

    @property
    def anchor_motion(self) -> Series | None:
        """Motion of the lower end of a line."""
        given = self.case.anchor_motion
        return None if given is None else self.anchor_record or _harmonic(given)

    @property
    def period(self) -> float | None:
        """Of all that drives the line, s; None where that is not periodic."""
        case = self.case
        files = (self.elevation, self.current, self.record, self.drift, self.force)
        if self.is_random or any(each is not None for each in (*files, self.anchor_record)):
            return None
        if self.dynamics.broken_line is not None:
            return None
        periods = {each.period for each in (case.motion, case.anchor_motion) if each is not None}
        if case.waves is not None:
            periods |= {each.period for each in case.waves.all_trains}
        known = [each for each in periods if each is not None]
        return known[0] if len(known) == 1 else None

    @property
    def has_rest(self) -> bool:
        """Whether the closed form gives a tension for every place of a fairlead, and is asked."""
        is_level = self.anchor_motion is None and self.case.site.seabed_slope == 0.0
        return self.compares_at_rest and is_level and not isinstance(self.case, Network)

    def stepping(self, sea: Sea, driven_by: Sequence[Series], finer: int = 1) -> TimeStepping:
        """Lay out steps and samples of a run."""
        dynamics = self.dynamics
        step = dynamics.time_step or self._shortest_period(sea, driven_by) / _STEPS
        if dynamics.output_interval is None:
            every = max(1, math.ceil(dynamics.duration / step / _SAMPLES))
        else:
            every = max(1, round(dynamics.output_interval / step))
        controls = StepControls()
        return TimeStepping(
            dynamics.duration,
            step / finer,
            ramp_time=self.ramp,
            output_interval=every * step,
            scheme=self.scheme,
            controls=replace(controls, surprise=controls.surprise / finer**2),
            tensions=self.counts_cycles,
            blocks=tuple(map(_block, self.sinkers)),
        )

    @property
    def gammas(self) -> tuple[float | None, ...]:
        """Peak enhancement of each train, given or by the rule; None of any but JONSWAP."""
        trains = () if self.case.waves is None else self.case.waves.all_trains
        return tuple(
            None
            if train.spectrum != "jonswap"
            else train.peak_enhancement or peak_enhancement(train.height, train.period)
            for train in trains
        )

    @property
    def ramp(self) -> float:
        """Of motion and waves, s."""
        dynamics = self.dynamics
        return _RAMP * dynamics.duration if dynamics.ramp is None else dynamics.ramp

    @property
    def scheme(self) -> Scheme:
        """How time is stepped."""
        if self.dynamics.scheme == "newmark":
            return Scheme.average_acceleration()
        return Scheme.generalised_alpha(self.dynamics.spectral_radius)

    @property
    def seabed(self) -> Seabed:
        """The bed under the line."""
        dynamics = self.dynamics
        return Seabed(
            normal_stiffness=dynamics.seabed_stiffness,
            normal_damping=dynamics.seabed_damping,
            friction=self.case.site.seabed_friction,
            initial_friction=dynamics.initial_friction,
            slope=self.case.site.seabed_slope,
        )

    @property
    def properties(self) -> LineProperties:
        """What the line needs beside its segments' weight and stiffness; of lines the first one."""
        site, dynamics = self.case.site, self.dynamics
        first, *_ = self.case.every_line
        return LineProperties(
            sections=[section_of(segment) for segment in first.segments],
            damping=LineDamping(
                critical_ratio=dynamics.critical_ratio, stiffness_time=dynamics.damping_time
            ),
            fluid=Fluid(density=site.water_density),
            seabed=self.seabed,
        )

    def _shortest_period(self, sea: Sea, driven_by: Sequence[Series]) -> float:
        """Return the shortest that drives the line, s; of random waves the one most are above.

        What is in proportion to the waves has their periods.
        """
        from_waves = self.raos is not None or self.vessel is not None
        if self.case.body is not None and self.case.body.wave_force:
            driven_by = [] if self.force is None else [self.force]
        periods = [] if from_waves else [each.shortest_period for each in driven_by]
        if sea.waves is not None:
            periods.append(2.0 * math.pi / _fast_frequency(sea.waves))
        return min(periods)


def read_drive(case: Case | Network) -> Excitation:
    """Read the files of a case's sea and motion; InputError for what is wrong in them."""
    assert case.dynamics is not None
    duration = case.dynamics.duration
    drive = _with_motion(case, duration)
    waves, current, lower = case.waves, case.current, case.anchor_motion
    if waves is not None and waves.elevation_file:
        drive = replace(drive, elevation=read_elevation(waves.elevation_file, duration))
        drive.recorded_waves  # noqa: B018 - refuses a shortest period that no wave has
    if current is not None and current.series_file:
        series = read_current(current.series_file, duration)
        if series.directions is not None and current.direction != 0.0:
            allowed = Message("refused_motion.stands_series_file_too_leave")
            found = f"{math.degrees(current.direction):g} deg"
            raise refused("current.direction", found, allowed, "--dynamic")
        drive = replace(drive, current=series)
    if lower is not None and lower.file:
        drive = replace(drive, anchor_record=read_motion(lower.file, duration))
    if case.anchor is not None and case.anchor.max_slide is not None:
        drive = replace(drive, sinkers=(case.anchor,))
    return drive


def _block(of: Anchor) -> tuple[float, float, float, float]:
    """Take a sinker as a block on the bed."""
    assert of.mass is not None
    assert of.submerged_weight is not None
    assert of.friction is not None
    base = math.inf if of.base_holding is None else of.base_holding
    return of.mass, of.submerged_weight, of.friction, base


def _with_motion(case: Case | Network, duration: float) -> Excitation:
    if case.body is not None and case.body.force_file:
        return Excitation(case, force=read_force(case.body.force_file, duration))
    given = case.motion
    if given is None:
        return Excitation(case)
    drift = read_motion(given.drift_file, duration) if given.drift_file else None
    if given.file:
        return Excitation(case, record=read_motion(given.file, duration))
    if not given.rao_file:
        return Excitation(case, drift=drift)
    if case.several_lines:
        return Excitation(case, vessel=read_vessel_raos(given), drift=drift)
    return Excitation(case, raos=read_raos(given.rao_file))


def _harmonic(given: Motion) -> Harmonic:
    assert given.period is not None
    return Harmonic(
        given.period,
        (given.surge, given.sway, given.heave),
        (given.surge_phase, given.sway_phase, given.heave_phase),
    )


def check_for_motion(case: Case | Network) -> None:
    """Refuse a case that lacks what a line in motion needs, with everything that it lacks.

    Raises InputError with the path of every key.
    """
    problems = []
    if case.floater is not None and case.floater.on_two_scales:
        allowed = Message("refused_case.ship_on_two_scales")
        raise refused(f"floater.{case.floater.kind}", "", allowed, "--dynamic")
    if case.dynamics is None:
        allowed = Message("refused_motion.missing_write_dynamics_with_duration")
        problems.append(Problem("dynamics", "", allowed))
    elif case.dynamics.runs > 1 and not Excitation(case).is_random:
        allowed = Message("refused_motion.without_random_sea_all_runs")
        problems.append(Problem("dynamics.runs", f"{case.dynamics.runs}", allowed))
    elif case.dynamics.judged_by != "largest" and not Excitation(case).is_random:
        allowed = Message("refused_motion.judged_by_wants_a_random_sea")
        problems.append(Problem("dynamics.judged_by", f'"{case.dynamics.judged_by}"', allowed))
    for key, line in dict.fromkeys(case.keyed_lines):
        problems += _of_line(key, line)
    for key, joint in case.keyed_joints:
        if joint.submerged_weight and joint.mass is None:
            allowed = Message("refused_motion.missing_line_motion_needs")
            problems.append(Problem(f"{key}.mass", "", allowed))
    if problems:
        raise InputError(problems, "--dynamic")


def _of_line(path: str, line: Line) -> Iterator[Problem]:
    for index, segment in enumerate(line.segments):
        yield from _of_segment(f"{path}.segments[{index}]", segment)
    for index, load in enumerate(line.point_loads):
        if load.mass is None:
            allowed = Message("refused_motion.missing_line_motion_needs")
            yield Problem(f"{path}.point_loads[{index}].mass", "", allowed)


def _of_segment(path: str, segment: Segment) -> list[Problem]:
    lacks = []
    if not segment.mass:
        lacks.append(("mass", "missing_line_motion_needs"))
    if segment.is_inextensible:
        lacks.append(("EA", "missing_motion_EA"))
    if segment.drag_method == "roughness":
        if segment.drag_diameter is None:
            lacks.append(("drag_diameter", "missing_roughness_refers"))
    elif segment.drag_normal is None:
        lacks.append(("drag_normal", "missing_motion_drag"))
    elif segment.drag_diameter is None and (segment.drag_normal or segment.drag_axial):
        lacks.append(("drag_diameter", "missing_drag_refers"))
    return [Problem(f"{path}.{key}", "", Message(f"refused_motion.{why}")) for key, why in lacks]


def section_of(segment: Segment) -> MorisonSection:
    """Take of a segment what the water does to it."""
    if segment.drag_method == "roughness":
        D, k, KC = segment.drag_diameter, segment.roughness, segment.keulegan_carpenter
        assert D is not None
        assert k is not None
        assert KC is not None
        steady, psi = steady_drag(k, D), segment.wake_amplification
        return MorisonSection(
            diameter=D,
            drag_normal=steady * (wake_amplification(steady, KC) if psi is None else psi),
            added_mass_normal=added_mass(steady, KC),
            added_mass_tangential=_or_else(segment.added_mass_axial, 0.0),
            oblique=OBLIQUE,
        )
    return MorisonSection(
        diameter=segment.drag_diameter or 1.0,  # without drag any will do
        drag_normal=segment.drag_normal or 0.0,
        drag_tangential=segment.drag_axial or 0.0,
        added_mass_normal=_or_else(segment.added_mass_normal, 1.0),
        added_mass_tangential=_or_else(segment.added_mass_axial, 0.0),
    )


def _or_else(value: float | None, default: float) -> float:
    return default if value is None else value


def _fast_frequency(waves: Waves) -> float:
    """Return the angular frequency that all but the fastest of the energy is below, rad/s."""
    order = np.argsort(waves.omega)
    energy = np.cumsum(waves.amplitude[order] ** 2)
    if energy[-1] == energy[0]:
        return float(waves.omega[order[0]])
    place = (energy - energy[0]) / (energy[-1] - energy[0])
    return float(np.interp(_FAST, place, waves.omega[order]))


@lru_cache(maxsize=16)
def _waves(given: WaveState, run: int) -> Waves:
    generator = np.random.default_rng([given.seed, run])
    first, *others = (_train(train, generator) for train in given.all_trains)
    return first.with_others(*others) if others else first


def _train(train: WaveTrain, generator: np.random.Generator) -> Waves:
    if train.spectrum == "regular":
        return regular_wave(train.height, train.period, direction=train.direction)
    if train.spectrum == "jonswap":
        spectrum = jonswap(train.height, train.period, train.peak_enhancement)
    else:
        spectrum = pierson_moskowitz(train.height, train.period)
    spreading = None
    if train.spreading_exponent is not None:
        spreading = CosineSpreading(train.spreading_exponent, train.directions)
    return random_waves(
        spectrum, train.components, generator, direction=train.direction, spreading=spreading
    )


def _current(given: CurrentProfile) -> PowerLawCurrent | WindCurrent | TableCurrent:
    if given.profile == "table":
        return TableCurrent(given.depths, given.speeds, given.direction, given.directions)
    # The speed of a series takes the place of the profile's own.
    speed = 1.0 if given.speed is None else given.speed
    if given.profile == "wind":
        assert given.depth is not None
        return WindCurrent(speed, given.depth, given.direction)
    if given.exponent is None:
        return PowerLawCurrent(speed, given.direction)
    return PowerLawCurrent(speed, given.direction, given.exponent)
