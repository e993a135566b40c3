"""A whole case: site, line, load and the settings of its solvers and checks."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Annotated, Literal

from catopt.errors import refused
from catopt.model.anchor import Anchor
from catopt.model.design import Design, DesignLoad, Find, body_misfits, inconsistencies
from catopt.model.dynamics import (
    FOR_MOTION,
    Dynamics,
    Fatigue,
    broken_line_misfits,
    dynamics_misfits,
    fatigue_needs,
    of_motion_misfits,
    strength_misfits,
)
from catopt.model.kinds import (
    Accepted,
    Checked,
    File,
    Findings,
    Height,
    Measured,
    Seed,
    Share,
    Whole,
)
from catopt.model.line import Line, Segment
from catopt.model.load import Checks, Load, LoadCase, Site
from catopt.model.plausible_ranges import accepted_in
from catopt.model.sea import CurrentProfile, Motion, WaveState
from catopt.model.service import Service, wear_misfits
from catopt.model.system import Body, Buoy, Floater, Leg, System, system_misfits
from catopt.model.title_block import TitleBlock
from catopt.model.wear import worn_line
from catopt.units import Dimension
from catopt.words import Message


@dataclass(frozen=True)
class CatalogueChoice:
    """Where components come from, and which of disagreeing figures to follow."""

    file: Annotated[str, File()] = ""
    """Full path of a file with families of one's own; empty when there is none."""
    allow_recalled: bool = False
    """Whether figures that were read in no document (confidence R) may be used."""
    variants: tuple[tuple[str, str], ...] = ()
    """Quantity, or "all", and the variant of it to follow."""

    @property
    def by_quantity(self) -> Mapping[str, str]:
        """The variants as a mapping."""
        return dict(self.variants)


Boundary = Literal["nearest", "reflective", "shrink", "random", "intermediate", "periodic"]

MOST_EVALUATIONS = 10**10
"""Of a swarm: hours on one core."""


@dataclass(frozen=True)
class SwarmSettings(Checked):
    """Settings of the particle swarm.

    The defaults are the article's numbers (S1) with the coefficients and the boundary handling
    under which its problem does not stall (docs/theory.md).
    """

    particles: Annotated[int, Whole("particles", example=200)] = 200
    """Size of the swarm."""
    iterations: Annotated[int, Whole("iterations", example=200)] = 200
    """Of a run."""
    runs: Annotated[int, Whole("runs", example=200)] = 1
    """Independent ones."""
    seed: Seed = 1
    """Run k draws from the generator seeded with (seed, k)."""
    cognitive: Annotated[float, Measured(Dimension.NUMBER, at_least=0.0, at_most=4.0)] = 1.5
    """c1 of the velocity rule."""
    social: Annotated[float, Measured(Dimension.NUMBER, at_least=0.0, at_most=4.0)] = 1.5
    """c2 of the velocity rule."""
    inertia: Share = 0.4
    """w of the velocity rule."""
    boundary: Boundary = "reflective"
    """What happens to a particle beyond a bound; the names are those of pyswarms."""

    def _check(self, found: Findings) -> None:
        found.check("particles", "iterations", "runs")
        evaluations = 0 if found.problems else self.particles * self.iterations * self.runs
        if evaluations > MOST_EVALUATIONS:
            allowed = Message(
                "refused_case.with_particles_iterations_evaluations_are",
                evaluations=evaluations,
                most_evaluations=MOST_EVALUATIONS,
            )
            found.add("runs", f"{self.runs}", allowed)
        found.check("seed", "cognitive", "social", "inertia", "boundary")


WET = ("system", "buoy", "anchor", "design", *FOR_MOTION, "fatigue")
"""What of a case wants water, or a bed."""


@dataclass(frozen=True)
class Case(Checked):
    """Everything a case file says."""

    site: Site
    line: Line
    load: Load | None
    """At the fairlead; None where `find` seeks the force itself, or where there are load cases."""
    fairlead_height: Height
    """Above the seabed, m, as `anchor_height`."""
    anchor_height: Height = 0.0
    checks: Checks = field(default_factory=Checks)
    swarm: SwarmSettings = field(default_factory=SwarmSettings)
    """Of ``--method pso``."""
    title: str = ""
    """Title of the case; empty when it has none."""
    source: str = ""
    find: Find | None = None
    """What is sought instead, if anything."""
    load_cases: tuple[LoadCase, ...] = ()
    """The states that checks and designs are made for; empty: the load alone."""
    service: Service | None = None
    """Life and wear; None: the line stays as new."""
    buoy: Buoy | None = None
    """What the line pulls down on, when its buoyancy is to be checked."""
    anchor: Anchor | None = None
    """What holds the line, when that is to be checked."""
    catalogue: CatalogueChoice = field(default_factory=CatalogueChoice)
    """Where components come from."""
    design: Design | None = None
    """What may vary."""
    system: System | None = None
    """A body moored by several lines like `line`, in the place of a load."""
    waves: WaveState | None = None
    """Of the sea, for a line in motion, as `current`."""
    current: CurrentProfile | None = None
    motion: Motion | None = None
    """Of the fairlead; of a body with several lines, of its origin."""
    anchor_motion: Motion | None = None
    """Of the lower end of a line, harmonic or recorded; it stays without."""
    body: Body | None = None
    """That the lines moor, where it moves under forces instead of being led."""
    floater: Floater | None = None
    """A buoy that the line moors, which floats and moves with it, or a ship on several lines."""
    dynamics: Dynamics | None = None
    """How the line is run in time; needed by the six before it."""
    fatigue: Fatigue | None = None
    """What its damage in a year is found from."""
    document: TitleBlock | None = None
    """For the title block of its note."""
    accept: tuple[Accepted, ...] = ()
    """Names of the plausible ranges that its values may go beyond."""

    def _check(self, found: Findings) -> None:
        object.__setattr__(self, "accept", accepted_in(self.accept, self))
        found.check("fairlead_height", "anchor_height")
        has_system = self.several_lines
        if self.site.is_in_air and (wet := [k for k in WET if getattr(self, k) is not None]):
            named = ", ".join(f"[{key}]" for key in wet)
            found.add("site", "", Message("refused_case.site_for", keys=named))
        found.problems += inconsistencies(
            self.find,
            load=None if self.load is None else self.load.given,
            MBL_known=[segment.MBL is not None for segment in self.line.segments],
            point_loads=len(self.line.point_loads),
            anchor_height=self.anchor_height,
            has_load_cases=bool(self.load_cases) or has_system,
        )
        if has_system:
            others = {key: getattr(self, key) for key in ("load", "load_cases", "find")}
            found.problems += system_misfits(
                {**others, "site.seabed_slope": self.site.seabed_slope}
            )
        if self.design is not None:
            found.problems += body_misfits(
                vars(self.design), has_system=has_system, has_force=any(self.own_force)
            )
        for part, of in (("checks", self.checks), ("anchor", self.anchor)):
            factor = None if of is None else of.safety_factor_line_out
            if factor is not None and not has_system:
                found.add(
                    f"{part}.safety_factor_line_out",
                    f"{factor:g}",
                    Message("refused.needs_several_lines"),
                )
        self._check_motion(found)
        self._check_current(found)
        service = {} if self.service is None else vars(self.service)
        found.problems += wear_misfits(service, [vars(each) for each in self.line.segments])
        found.problems += fatigue_needs(self, len(self.line.segments))
        self._check_levels("load_cases", self.load_cases, found)
        for index, state in enumerate(self.load_cases):
            if state.condition is not None and self.service is None:
                allowed = Message("refused_case.goes_with_service_which_missing")
                found.add(f"load_cases[{index}].condition", f'"{state.condition}"', allowed)
        if self.design is not None:
            self._check_levels("design.loads", self.design.loads, found)

    def _check_motion(self, found: Findings) -> None:
        """Find what does not go together of the parts for a line in motion."""
        present = [key for key in FOR_MOTION if getattr(self, key) is not None]
        found.problems += dynamics_misfits(
            present,
            {
                f"{part}.{key}": value
                for part in ("motion", "body", "floater", "dynamics")
                if part in present
                for key, value in vars(getattr(self, part)).items()
                if value
            },
        )
        if self.dynamics is None:
            found.problems += of_motion_misfits(self, Message("refused.with_dynamics"))
        else:
            count = len(self.every_line)
            found.problems += broken_line_misfits(self.dynamics.broken_line, count)
            for line in self.every_line if self.dynamics.broken_line is not None else ():
                strengths = [each.MBL for each in line.segments]
                found.problems += strength_misfits(self.dynamics, strengths)
        lower = self.anchor_motion
        if lower is not None and (lower.rao_file or lower.of_a_body):
            given = Message("refused_case.raos_or_drift")
            found.add("anchor_motion", given, Message("refused_case.give_period_or_file"))

    def _check_current(self, found: Findings) -> None:
        """Find what does not go with a current on a line at rest."""
        if self.current_at_rest is None:
            return
        said = ", ".join(f"[{k}]" for k in ("find", "design") if getattr(self, k) is not None)
        if said:
            found.add("current", "", Message("refused_case.current_at_rest_alone", keys=said))
        if self.current is not None and self.current.series_file:
            allowed = Message("refused_case.current_series_is_for_motion")
            found.add("current.series_file", self.current.series_file, allowed)
        if self.site.seabed_slope != 0.0:
            slope = Message("refused_case.current_at_rest_alone", keys="site.seabed_slope")
            found.add("current", "", slope)

    @property
    def every_line(self) -> tuple[Line, ...]:
        """The line, or those of the body that is moored."""
        return tuple(leg.line for leg in self.legs) or (self.line,)

    @property
    def _systems(self) -> tuple[System, ...]:
        """Its body on several lines, or none."""
        return () if self.system is None else (self.system,)

    @property
    def legs(self) -> tuple[Leg, ...]:
        """Lines of its body on several; none where it has one line."""
        return tuple(leg for system in self._systems for leg in system.legs)

    @property
    def own_system(self) -> System:
        """Its body on several lines; InputError where it has one line."""
        for system in self._systems:
            return system
        wanted = Message("refused_motion.missing_table_system_with_anchor")
        raise refused("system", "", wanted)

    def raised(self, by: float) -> Case:
        """Return the case of a body on several lines at another water level, m above its own."""
        site = replace(self.site, water_depth=self.site.water_depth + by)
        return replace(self, site=site, system=self.own_system.raised(by))

    @property
    def keyed_lines(self) -> Iterator[tuple[str, Line]]:
        """Its lines by their keys in the file."""
        return (("line", line) for line in self.every_line)

    def without_load_cases(self) -> Case:
        """Return the case with its load alone."""
        return replace(self, load_cases=())

    @property
    def own_force(self) -> tuple[float, float]:
        """On its body along x and y, N; 0 where it has one line."""
        return next((system.force for system in self._systems), (0.0, 0.0))

    def segment_for(self, choice: int) -> Segment | None:
        """Segment of the line in the place of what its design chooses; None where there is none."""
        segments = self.line.segments
        return segments[choice] if choice < len(segments) else None

    @property
    def keyed_joints(self) -> tuple[()]:
        """None: its lines end at anchors and fairleads."""
        return ()

    @property
    def several_lines(self) -> bool:
        """Whether it is of a body with several lines, which move together."""
        return bool(self._systems)

    @property
    def current_at_rest(self) -> CurrentProfile | None:
        """The current on a line at rest; None where there is none, or it is for one in motion."""
        return self.current if self.dynamics is None else None

    def check_still_water(self) -> None:
        """Raise InputError where a current acts at rest, for what takes still water."""
        if self.current_at_rest is not None:
            allowed = Message("refused_case.current_for_solve_and_check")
            raise refused("current", "", allowed)

    def _check_levels(
        self, place: str, states: Sequence[LoadCase | DesignLoad], found: Findings
    ) -> None:
        names = [state.name for state in states]
        for index, state in enumerate(states):
            if state.name in names[:index]:
                allowed = Message("refused_case.another_has_this_name")
                found.add(f"{place}[{index}].name", state.name, allowed)
            lowest = min(self.site.water_depth, self.fairlead_height + state.fairlead_rise)
            if not state.water_level > -lowest:
                allowed = Message("refused.fairlead_above_bed", least=-lowest)
                found.add(f"{place}[{index}].water_level", f"{state.water_level:g} m", allowed)

    @property
    def place(self) -> dict[str, float]:
        """Where the line is moored, by the arguments of `catopt.solve`: m, m and friction."""
        return {
            "height": self.fairlead_height,
            "anchor_height": self.anchor_height,
            "seabed_friction": self.site.seabed_friction,
        }

    @property
    def clear_of_the_ground(self) -> tuple[Case, float]:
        """The case of a line in air so high above a bed that none of it is met, and how high, m."""
        lift = 2.0 * self.line.length
        upper, lower = self.fairlead_height + lift, self.anchor_height + lift
        site = Site(10.0 * (upper + lower), accept=("water_depth",))
        return replace(self, site=site, fairlead_height=upper, anchor_height=lower), lift

    def under(self, state: LoadCase) -> Case:
        """Return the case in one of its states, with water and fairlead at its levels.

        The line is the worn one where the state is one at the end of its service life.
        """
        depth = self.site.water_depth + state.water_level
        return replace(
            self,
            site=replace(self.site, water_depth=depth),
            line=worn_line(self.line, self.service) if state.condition == "worn" else self.line,
            fairlead_height=self.fairlead_height + state.lift,
            load=Load(horizontal_force=state.horizontal_force),
            load_cases=(),
            find=None,
        )
