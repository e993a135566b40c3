"""From a case to what the truss model is run with in time."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from catopt.errors import InputError, Problem
from catopt.fem.damping import LineDamping
from catopt.fem.dynamic_model import Fluid
from catopt.fem.dynamics import LineProperties, TimeStepping
from catopt.fem.morison import MorisonSection
from catopt.fem.newmark import Scheme
from catopt.fem.seabed import Seabed
from catopt.fem.series import Harmonic, Sampled, Series
from catopt.fem.step_controls import StepControls
from catopt.model import Case, Dynamics, Segment, WaveState
from catopt.model.current_profile import CurrentProfile
from catopt.verify.motion_file import Raos, read_motion, read_raos
from catopt.waves import (
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

__all__ = ["Drive", "check_for_motion", "read_drive"]

_STEPS = 60.0
"""Steps in the shortest period, unless the step is given."""

_SAMPLES = 20000
"""Most samples of a run, unless their interval is given."""

_RAMP = 0.1
"""Part of the duration, unless the ramp is given."""

_FAST = 0.99
"""Part of the waves, which hold the same energy each, that is slower than the shortest period."""


@dataclass(frozen=True)
class Drive:
    """What drives a case, with its files read.

    Attributes
    ----------
    case : Case
        With dynamics.
    record : Sampled or None
        Of the fairlead's motion.
    raos : Raos or None
        Of the fairlead.
    """

    case: Case
    record: Sampled | None = None
    raos: Raos | None = None

    @property
    def dynamics(self) -> Dynamics:
        """How the case is run."""
        assert self.case.dynamics is not None
        return self.case.dynamics

    @property
    def is_random(self) -> bool:
        """Whether runs differ in their seed."""
        return self.case.waves is not None and self.case.waves.spectrum != "regular"

    def sea(self, run: int) -> Sea:
        """Waves and current of one run, from 0."""
        given, depth = self.case.waves, self.case.site.water_depth
        waves = None if given is None else _waves(given, run)
        current = [] if self.case.current is None else [_current(self.case.current)]
        stretching = "none" if given is None else given.stretching
        return Sea(depth, waves, current, stretching)

    def motion(self, sea: Sea, span: float) -> Series | None:
        """Motion of the fairlead in a sea.

        Parameters
        ----------
        sea : Sea
            Of the run.
        span : float
            At rest, m.
        """
        given = self.case.motion
        if given is None:
            return None
        if self.record is not None:
            return self.record
        if self.raos is not None and sea.waves is not None:
            return self.raos.motion(sea.waves, sea.wave_numbers, span)
        assert given.period is not None
        return Harmonic(
            given.period,
            (given.surge, given.sway, given.heave),
            (given.surge_phase, given.sway_phase, given.heave_phase),
        )

    def stepping(self, sea: Sea, motion: Series | None, finer: int = 1) -> TimeStepping:
        """Lay out steps and samples of a run.

        Parameters
        ----------
        sea, motion
            Of the run.
        finer : int
            So many steps in place of one, and the square of that less surprise in each.
        """
        dynamics = self.dynamics
        step = dynamics.time_step or self._shortest_period(sea, motion) / _STEPS
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
        )

    @property
    def peak_enhancement(self) -> float | None:
        """Peak enhancement gamma of the waves, given or by the rule; None of any but JONSWAP."""
        given = self.case.waves
        if given is None or given.spectrum != "jonswap":
            return None
        return given.peak_enhancement or peak_enhancement(given.height, given.period)

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
    def properties(self) -> LineProperties:
        """What the line needs beside its segments' weight and stiffness."""
        site, dynamics = self.case.site, self.dynamics
        return LineProperties(
            sections=[_section(segment) for segment in self.case.line.segments],
            damping=LineDamping(
                critical_ratio=dynamics.critical_ratio, stiffness_time=dynamics.damping_time
            ),
            fluid=Fluid(density=site.water_density),
            seabed=Seabed(
                normal_stiffness=dynamics.seabed_stiffness,
                normal_damping=dynamics.seabed_damping,
                friction=site.seabed_friction,
            ),
        )

    def _shortest_period(self, sea: Sea, motion: Series | None) -> float:
        """Return the shortest that drives the line, s; of random waves the one most are above."""
        periods = [] if motion is None or self.raos is not None else [motion.shortest_period]
        if sea.waves is not None:
            periods.append(2.0 * math.pi / float(np.quantile(sea.waves.omega, _FAST)))
        return min(periods)


def read_drive(case: Case) -> Drive:
    """Read the files of a case's motion.

    Parameters
    ----------
    case : Case
        As `check_for_motion` passes it.

    Raises
    ------
    InputError
        For what is wrong in them.
    """
    assert case.dynamics is not None
    if case.motion is None:
        return Drive(case)
    if case.motion.file:
        return Drive(case, record=read_motion(case.motion.file, case.dynamics.duration))
    if case.motion.rao_file:
        return Drive(case, raos=read_raos(case.motion.rao_file))
    return Drive(case)


def check_for_motion(case: Case) -> None:
    """Refuse a case that lacks what a line in motion needs, with everything that it lacks.

    Parameters
    ----------
    case : Case
        Any.

    Raises
    ------
    InputError
        With the path of every key.
    """
    problems = [
        *_of_settings(case),
        *(p for k, s in enumerate(case.line.segments) for p in _of_segment(k, s)),
        *(
            Problem(f"line.point_loads[{k}].mass", "", "missing; a line in motion needs it")
            for k, load in enumerate(case.line.point_loads)
            if load.mass is None
        ),
    ]
    if problems:
        raise InputError(problems, "--dynamic")


def _of_settings(case: Case) -> list[Problem]:
    if case.dynamics is None:
        allowed = "missing; write [dynamics] with a duration, and [motion] or [waves]"
        return [Problem("dynamics", "", allowed)]
    if case.dynamics.runs > 1 and not Drive(case).is_random:
        allowed = "without a random sea all runs are alike; leave it out"
        return [Problem("dynamics.runs", f"{case.dynamics.runs}", allowed)]
    return []


def _of_segment(index: int, segment: Segment) -> list[Problem]:
    path, lacks = f"line.segments[{index}]", []
    if not segment.mass:
        lacks.append(("mass", "a line in motion needs it"))
    if math.isinf(segment.EA):
        lacks.append(("EA", "a line in motion needs its axial stiffness"))
    if segment.drag_normal is None:
        lacks.append(("drag_normal", "a line in motion needs it; 0 for no drag"))
    elif segment.drag_diameter is None and (segment.drag_normal or segment.drag_axial):
        lacks.append(("drag_diameter", "the drag coefficients refer to it"))
    return [Problem(f"{path}.{key}", "", f"missing; {why}") for key, why in lacks]


def _section(segment: Segment) -> MorisonSection:
    return MorisonSection(
        diameter=segment.drag_diameter or 1.0,  # without drag any will do
        drag_normal=segment.drag_normal or 0.0,
        drag_tangential=segment.drag_axial or 0.0,
        added_mass_normal=_or_else(segment.added_mass_normal, 1.0),
        added_mass_tangential=_or_else(segment.added_mass_axial, 0.0),
    )


def _or_else(value: float | None, default: float) -> float:
    return default if value is None else value


def _waves(given: WaveState, run: int) -> Waves:
    if given.spectrum == "regular":
        return regular_wave(given.height, given.period, direction=given.direction)
    if given.spectrum == "jonswap":
        spectrum = jonswap(given.height, given.period, given.peak_enhancement)
    else:
        spectrum = pierson_moskowitz(given.height, given.period)
    generator = np.random.default_rng([given.seed, run])
    return random_waves(spectrum, given.components, generator, direction=given.direction)


def _current(given: CurrentProfile) -> PowerLawCurrent | WindCurrent | TableCurrent:
    if given.profile == "table":
        return TableCurrent(given.depths, given.speeds, given.direction)
    assert given.speed is not None
    if given.profile == "wind":
        assert given.depth is not None
        return WindCurrent(given.speed, given.depth, given.direction)
    if given.exponent is None:
        return PowerLawCurrent(given.speed, given.direction)
    return PowerLawCurrent(given.speed, given.direction, given.exponent)
