"""The lines of a case at rest, ready to be run in time: one by itself, or all of a body's."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import get_args

import numpy as np

from catopt.arrays import Array
from catopt.catenary.batch import solve_many
from catopt.catenary.case import solve_case
from catopt.errors import FloatsUpError, refused
from catopt.fem.dynamics import (
    body_at_rest,
    line_at_rest,
    ramped,
    run_dynamics,
    run_network_dynamics,
    run_system_dynamics,
)
from catopt.fem.history import History
from catopt.fem.mesh import LineMesh, mesh_line
from catopt.fem.network import LineEnd
from catopt.fem.run_settings import BodyInertia, TimeStepping
from catopt.fem.seabed import Seabed
from catopt.fem.series import Harmonic, Series, Together, series_rows, series_values
from catopt.fem.simulation import Break, Simulation
from catopt.fem.solve import Leg
from catopt.floater.alone import HullHistory
from catopt.floater.moored import AtRest, moored_at_rest, run_moored
from catopt.floater.scene import kept_nodes, scene_of
from catopt.hydro.build import SteppedHull
from catopt.model import Load
from catopt.model.dynamics import Dynamics, InitialFriction
from catopt.model.network import Network
from catopt.mooring import fixed_body, network_rest
from catopt.mooring.solution import solve_system
from catopt.verify.dynamic_result import Between
from catopt.verify.dynamic_run import DynamicRun
from catopt.verify.dynamic_setup import Excitation, section_of
from catopt.verify.hulls import HULLS, hull_of
from catopt.verify.line import rotated, truss_legs
from catopt.waves import Sea, Waves
from catopt.words import Message

PartDone = Callable[[float], None]


def parting(dynamics: Dynamics, meshes: Sequence[LineMesh]) -> Break | None:
    """Say which of the lines parts, when and where; None where none does."""
    if dynamics.broken_line is None:
        return None
    number = dynamics.broken_line - 1
    if dynamics.broken_by == "time":
        assert dynamics.broken_at is not None
        return Break(number, dynamics.broken_at, dynamics.broken_end == "anchor")
    mesh = meshes[number]
    known = [segment.MBL for segment in mesh.line.segments]
    strength = (known[int(k)] for k in mesh.segment)
    return Break(number, strength=tuple(math.inf if MBL is None else MBL for MBL in strength))


def parting_words(dynamics: Dynamics, *, alone: bool = False) -> Iterator[Message]:
    """Yield which line parts at which time, and where; `alone`: it is the only one."""
    number, time = dynamics.broken_line, dynamics.broken_at
    if number is None or time is None:
        return
    lost = dynamics.broken_end == "anchor"
    key = "motion.lost_at_anchor" if lost else "motion.breaks"
    if alone:
        key = "motion.the_line_lost" if lost else "motion.the_line_breaks"
    yield Message(key, number=number, time=time)


def parted_words(dynamics: Dynamics, runs: Sequence[DynamicRun]) -> Iterator[Message]:
    """Yield in which runs a line has parted by its strength, and when."""
    number = dynamics.broken_line
    if number is None or dynamics.broken_by != "MBL":
        return
    for run in runs:
        parted, at = run.history.parted, {"number": number, "run": run.number + 1}
        if parted is None:
            yield Message("motion.did_not_part", **at)
        else:
            yield Message("motion.parts_by_MBL", **at, time=parted.time, bar=parted.bar + 1)


@dataclass(frozen=True)
class OneLine:
    """A line whose fairlead is led.

    `drive`: what drives it; `load`: by which the truss model is brought to rest; `span`: that it
    gives, m.
    """

    drive: Excitation
    load: Load
    span: float

    @classmethod
    def at_rest(cls, drive: Excitation) -> OneLine:
        """Solve the line in closed form; on a bed that slopes, by the truss model."""
        load = drive.one.load
        assert load is not None
        if drive.one.site.seabed_slope == 0.0:
            closed = solve_case(drive.one)
            if load.fairlead_tension is not None:
                load = Load(horizontal_force=closed.horizontal_force)
            return cls(drive, load, closed.span)
        if load.fairlead_tension is not None:
            allowed = Message("refused_motion.give_horizontal_force_or_span")
            found = f"{load.fairlead_tension:g} N"
            raise refused("load.fairlead_tension", found, allowed, "--dynamic")
        rest = cls(drive, load, 0.0).simulation()
        return cls(drive, load, float(rest.state.x[-1, 0]))

    def simulation(self, seabed: Seabed | None = None) -> Simulation:
        """Bring the truss model to rest, in the current, of the same bars as in the run."""
        case = self.drive.one
        return line_at_rest(
            mesh_line(case.line, self.drive.dynamics.bars),
            height=case.fairlead_height,
            span=self.load.span,
            horizontal_force=self.load.horizontal_force,
            anchor_height=case.anchor_height,
            properties=replace(self.drive.properties, seabed=seabed or self.drive.seabed),
            sea=replace(self.drive.sea(0), waves=None),
        )

    @property
    def legs(self) -> Sequence[Leg]:
        """The line, from its anchor at x = y = 0."""
        case = self.drive.one
        return (Leg(case.line, (0.0, 0.0, case.anchor_height)),)

    def driven_by(self, sea: Sea) -> list[Series]:
        """Motion of the line's ends."""
        ends = (self.drive.motion(sea, self.span), self.drive.anchor_motion)
        return [each for each in ends if each is not None]

    def run(
        self, sea: Sea, stepping: TimeStepping, elements: int, progress: PartDone
    ) -> tuple[History, Array | None]:
        """Run it; there is no body."""
        case = self.drive.one
        mesh = mesh_line(case.line, elements)
        history = run_dynamics(
            case.line,
            stepping,
            height=case.fairlead_height,
            span=self.load.span,
            horizontal_force=self.load.horizontal_force,
            anchor_height=case.anchor_height,
            motion=self.drive.motion(sea, self.span),
            anchor_motion=self.drive.anchor_motion,
            broken=parting(self.drive.dynamics, [mesh]),
            properties=self.drive.properties,
            sea=sea,
            mesh=mesh,
            progress=progress,
        )
        return history, None

    def anchor_at_rest(self) -> Mapping[InitialFriction, float]:
        """Bring the line to rest by every past; nothing where nothing rubs.

        In the current, of the same bars and under the same load as in the run.
        """
        found: dict[InitialFriction, float] = {}
        for state in get_args(InitialFriction):
            simulation = self.simulation(replace(self.drive.seabed, initial_friction=state))
            if not simulation.lines.friction.any() or not (simulation.state.reaction > 0.0).any():
                return {}
            found[state] = float(np.linalg.norm(simulation.state.force[0]))
        return found

    def remarks(self) -> Iterator[str]:
        """Yield what becomes of the lower end."""
        if self.drive.anchor_motion is not None:
            yield Message("motion.lower_end_led")
        yield from parting_words(self.drive.dynamics, alone=True)
        slope = self.drive.one.site.seabed_slope
        if slope != 0.0:
            yield Message("motion.sloped_bed", angle=math.degrees(slope))


@dataclass(frozen=True)
class LinesOfABody:
    """Lines that meet in a body, which is led or moves under forces.

    `drive`: what drives the body; `legs`: its lines, in the yaw that it has at rest; `place`: of
    its origin at rest, m: x, y, and the height of the first fairlead; `yaw`: at rest, rad.
    """

    drive: Excitation
    legs: tuple[Leg, ...]
    place: tuple[float, float, float]
    yaw: float

    @classmethod
    def at_rest(cls, drive: Excitation) -> LinesOfABody:
        """Solve the body under its mean force in closed form; a constant drift comes on top."""
        system = drive.one.own_system
        at = solve_system(system).position
        legs, height = truss_legs(system, at.yaw)
        motion = drive.case.motion
        x, y = (motion.drift or (0.0, 0.0)) if motion is not None else (0.0, 0.0)
        return cls(drive, tuple(legs), (at.x + x, at.y + y, height), at.yaw)

    def driven_by(self, sea: Sea) -> list[Series]:
        """Motion of each fairlead, or the force on the body."""
        if self.drive.case.body is None:
            return [self._motion(sea, leg.fairlead) for leg in self.legs]
        force = self._force(sea)
        return [] if force is None else [force]

    def run(
        self, sea: Sea, stepping: TimeStepping, elements: int, progress: PartDone
    ) -> tuple[History, Array | None]:
        """Run all lines; one-way where the body is led: they do not act on it."""
        system, body = self.drive.one.own_system, self.drive.case.body
        is_led = body is None
        meshes = [mesh_line(leg.line, elements) for leg in self.legs]
        history = run_system_dynamics(
            self.legs,
            stepping,
            height=self.place[2],
            mean_force=(0.0, 0.0) if is_led else system.force,
            force=None if is_led else self._force(sea),
            body=None if body is None else BodyInertia(body.mass + body.added_mass, body.damping),
            position=self.place[:2] if is_led else None,
            motion=self.driven_by(sea) if is_led else None,
            properties=self.drive.properties,
            sea=sea,
            meshes=meshes,
            broken=parting(self.drive.dynamics, meshes),
            progress=progress,
        )
        if not is_led:
            return history, history.fairlead[:, 0] - np.array(self.legs[0].fairlead)
        origin = self._motion(sea, (0.0, 0.0, 0.0))
        rows = series_rows(np.array([self.place]), [origin], stepping.ramp_time)
        return history, series_values(rows, history.time)

    def simulation(self) -> Simulation:
        """Bring the truss model to rest, with the body where it is."""
        drive, bars = self.drive, self.drive.dynamics.bars
        return body_at_rest(
            self.legs,
            [mesh_line(leg.line, bars) for leg in self.legs],
            height=self.place[2],
            position=self.place[:2],
            properties=drive.properties,
            sea=replace(drive.sea(0), waves=None),
        )

    def remarks(self) -> Iterator[str]:
        """Yield how the body moves, and what of it is held."""
        body, system = self.drive.case.body, self.drive.one.own_system
        if body is None:
            yield Message("motion.led")
            if self.drive.case.current is not None:
                yield Message("motion.place_without_current")
        else:
            yield Message("motion.body_moves")
            force = self.drive.force
            if force is not None and force.values[:, 2].any():
                yield Message("motion.Fz_unused")
        yield from parting_words(self.drive.dynamics)
        if system.turns:
            yield Message("motion.kept_yaw", yaw=math.degrees(self.yaw))

    def _motion(self, sea: Sea, arm: tuple[float, float, float]) -> Series:
        """Motion of a point that is an arm away from the origin, in the yaw at rest."""
        drive, given = self.drive, self.drive.case.motion
        assert given is not None
        if drive.record is not None:
            return drive.record
        if drive.vessel is None or sea.waves is None:
            assert given.period is not None
            motion = drive.harmonic
        else:
            motion = self._response(sea, arm)
        return motion if drive.drift is None else Together(motion, drive.drift)

    def _response(self, sea: Sea, arm: tuple[float, float, float]) -> Harmonic:
        """Answer of a point to the waves, those of each direction by their own heading."""
        waves = sea.waves
        assert waves is not None
        amplitude, phase = np.zeros((2, waves.omega.size, 3))
        for which in (waves.direction == each for each in np.unique(waves.direction)):
            answer = self._response_to(waves.only(which), sea.wave_numbers[which], arm)
            amplitude[which], phase[which] = answer.amplitude, answer.phase
        return Harmonic(tuple(2.0 * math.pi / waves.omega), amplitude, phase)

    def _response_to(
        self, waves: Waves, wave_numbers: Array, arm: tuple[float, float, float]
    ) -> Harmonic:
        """Answer to waves of one direction; rotations are small.

        The ship's axes are turned by its yaw at rest.
        """
        vessel = self.drive.vessel
        assert vessel is not None
        x, y, height = self.place
        from_origin = rotated(arm[0], arm[1], -self.yaw)
        heading = float(waves.direction[0]) - self.yaw
        raos = vessel.of_point(heading, (*from_origin, height + arm[2]))
        along, across = rotated(1.0, 0.0, self.yaw), rotated(0.0, 1.0, self.yaw)
        response = raos.response @ np.array([(*along, 0.0), (*across, 0.0), (0.0, 0.0, 1.0)])
        ahead, aside = rotated(vessel.crest[0], vessel.crest[1], self.yaw)
        of_earth = type(raos)(raos.omega, response)
        return of_earth.motion(waves, wave_numbers, x + ahead, y + aside)

    def _force(self, sea: Sea) -> Series | None:
        """Return what pushes the body beside its mean force."""
        body, record = self.drive.case.body, self.drive.force
        if body is None or not body.wave_force or sea.waves is None:
            return record
        waves, (x, y, _) = sea.waves, self.place
        ahead = x * np.cos(waves.direction) + y * np.sin(waves.direction)
        phase = -(sea.wave_numbers * ahead + waves.phase)
        harmonic = Harmonic(
            tuple(2.0 * math.pi / waves.omega),
            np.outer(waves.amplitude, (*body.wave_force, 0.0)),
            np.repeat(phase[:, np.newaxis], 3, axis=1),
        )
        return harmonic if record is None else Together(harmonic, record)


@dataclass(frozen=True)
class LinesOfPoints:
    """Lines between points, whose fairleads are led.

    `drive`: what drives them; `rest`: where everything is before it moves, bodies under their
    loads.
    """

    drive: Excitation
    rest: network_rest.LinesAtRest

    @classmethod
    def at_rest(cls, drive: Excitation) -> LinesOfPoints:
        """Bring joints and bodies to rest in closed form; FloatsUpError: a float at the surface."""
        assert isinstance(drive.case, Network)
        rest = fixed_body.at_rest(drive.case)
        for each in rest.floats:
            if each.lost > 0.0:
                raise FloatsUpError(Message("motion.float_at_the_surface", name=each.name))
        return cls(drive, rest)

    @property
    def legs(self) -> Sequence[Leg]:
        """Its lines, each from where its first end rests."""
        places = self.rest.joints.places
        return [Leg(run.line, places[run.first]) for run in self.rest.runs]

    def between(self, number: int) -> Between:
        """Say which line one is, from 1."""
        run, points = self.rest.runs[number - 1], self.rest.network.points
        ends = points[run.first].name, points[run.second].name
        return Between(run.name, *ends, self.rest.is_anchored(number - 1))

    def driven_by(self, sea: Sea) -> list[Series]:
        """Motion of the fairleads."""
        motion = self.drive.motion(sea, 0.0)
        return [] if motion is None else [motion]

    def run(
        self, sea: Sea, stepping: TimeStepping, elements: int, progress: PartDone
    ) -> tuple[History, Array | None]:
        """Run all lines; bodies are led with their fairleads."""
        network, runs = self.rest.network, self.rest.runs
        points, motion = network.points, self.drive.motion(sea, 0.0)
        joints = [k for k, point in enumerate(points) if point.kind == "joint"]
        ends = {
            k: LineEnd((0.0, 0.0, 0.0), joints.index(k)) if k in joints else LineEnd(place)
            for k, place in enumerate(self.rest.joints.places)
        }
        prescribed_motion = [motion if point.kind == "fairlead" else None for point in points]
        sections = [[section_of(segment) for segment in run.line.segments] for run in runs]
        meshes = [mesh_line(run.line, elements) for run in runs]
        history = run_network_dynamics(
            meshes,
            [(ends[run.first], ends[run.second]) for run in runs],
            [points[k] for k in joints],
            stepping,
            motions=[(prescribed_motion[run.first], prescribed_motion[run.second]) for run in runs],
            properties=replace(self.drive.properties, of_lines=sections),
            sea=sea,
            broken=parting(self.drive.dynamics, meshes),
            progress=progress,
        )
        return history, None

    def remarks(self) -> Iterator[str]:
        """Yield what is led."""
        network = self.rest.network
        if network.motion is not None:
            yield Message("motion.fairleads_led")
        if network.motion is not None and network.bodies:
            yield Message("motion.led")
        yield from parting_words(self.drive.dynamics)
        yield Message("motion.no_still_of_points")


@dataclass(frozen=True)
class LinesOfAFloater:
    """The line, or lines, of a buoy that floats at their upper ends; all are one system.

    `drive`: what drives them; `hull`: the buoy.
    """

    drive: Excitation
    hull: SteppedHull

    @classmethod
    def at_rest(cls, drive: Excitation) -> LinesOfAFloater:
        """Make the buoy; hull and lines find their rest in the current of each run."""
        return cls(drive, hull_of(drive.one))

    @property
    def legs(self) -> Sequence[Leg]:
        """The line, from its anchor at x = y = 0; or those of the system."""
        case = self.drive.one
        if case.several_lines:
            return truss_legs(case.own_system, 0.0)[0]
        return (Leg(case.line, (0.0, 0.0, case.anchor_height)),)

    def driven_by(self, sea: Sea) -> list[Series]:  # noqa: ARG002 - as of the others
        """Nothing leads it."""
        return []

    def moored_at_rest(self) -> AtRest:
        """Bring all to rest in the steady current."""
        drive, legs = self.drive, self.legs
        meshes = [mesh_line(leg.line, drive.dynamics.bars) for leg in legs]
        sea, properties = drive.sea(0), drive.properties
        return moored_at_rest(self.hull, legs, meshes, sea=sea, properties=properties)

    def run(
        self, sea: Sea, stepping: TimeStepping, elements: int, progress: PartDone
    ) -> tuple[History, HullHistory]:
        """Run all; of the nodes' places what the scene takes is kept."""
        legs = self.legs
        meshes = [mesh_line(leg.line, elements) for leg in legs]
        outline = self.hull.outline
        kept = () if outline is None else kept_nodes(meshes)
        history, hull = run_moored(
            self.hull,
            legs,
            meshes,
            replace(stepping, nodes=tuple(itertools.chain.from_iterable(kept))),
            sea=sea,
            properties=self.drive.properties,
            broken=parting(self.drive.dynamics, meshes),
            progress=progress,
        )
        if outline is None:
            return history, hull
        in_sea = ramped(sea, stepping)
        assert in_sea is not None
        scene = scene_of(history, kept, hull, outline, in_sea)
        return replace(history, nodes=history.nodes[:, :0]), replace(hull, scene=scene)

    def remarks(self) -> Iterator[str]:
        """Yield what is assumed of what floats, and where the method ends."""
        of = self.drive.one.floater
        assert of is not None
        yield from HULLS[of.kind].remarks(self.drive, self.hull, self.legs)
        yield from parting_words(self.drive.dynamics, alone=len(self.legs) == 1)


LinesAtRest = OneLine | LinesOfABody | LinesOfPoints | LinesOfAFloater
"""Lines that are run together, and what drives them."""


def lines_at_rest(drive: Excitation) -> LinesAtRest:
    """Find how the lines of a case hang before they move.

    Raises NoEquilibriumError, NotConvergedError as for `solve_case` and `solve_system`.
    """
    if isinstance(drive.case, Network):
        return LinesOfPoints.at_rest(drive)
    if drive.case.floater is not None:
        return LinesOfAFloater.at_rest(drive)
    return (LinesOfABody if drive.case.several_lines else OneLine).at_rest(drive)


def quasi_static(leg: Leg, history: History, seabed_friction: float) -> Array:
    """Tension at a line's fairlead in closed form at each of its places; nan where it has none."""
    at = history.fairlead[:, 0]
    solved = solve_many(
        leg.line,
        height=np.ascontiguousarray(at[:, 2]),
        span=np.hypot(at[:, 0] - leg.anchor[0], at[:, 1] - leg.anchor[1]),
        seabed_friction=seabed_friction,
        anchor_height=leg.anchor[2],
    )
    return np.where(solved.converged, solved.tension, np.nan)
