"""The lines of a case where they hang: what is written for another program."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from catopt.catenary.case import solve_case, under_a_load
from catopt.catenary.layout import end_of
from catopt.catenary.solution import Solution
from catopt.catenary.solve import solve
from catopt.constants import STANDARD_GRAVITY
from catopt.errors import InputError, Problem
from catopt.model import Case, Line, PointLoad, Segment
from catopt.mooring.case import report_system
from catopt.mooring.solution import SystemSolution
from catopt.words import Message

STEEL_DENSITY = 7850.0
"""kg/m3: stands in for a segment whose mass is not known."""

LEAST_VOLUME = 1e-9
"""Of the mass over the water's density: less is rounding of a body that displaces nothing."""


@dataclass(frozen=True)
class BodyInWater:
    """Mass (kg, or kg/m) and volume (m3, or m2) that together have a submerged weight.

    Both are of the whole body, or per unstretched length. `is_known`: whether the mass is that of
    the case; otherwise it stands in, which changes nothing at rest; `drag_area`: of a point load,
    times its drag coefficient, m2; `added_mass`: its coefficient, on the displaced water.
    """

    mass: float
    volume: float
    is_known: bool = True
    drag_area: float = 0.0
    added_mass: float = 0.0

    @property
    def diameter(self) -> float:
        """Volume-equivalent diameter, m, where both are per length."""
        return math.sqrt(4.0 * self.volume / math.pi)


def of_segment(segment: Segment, water_density: float, key: str) -> BodyInWater:
    """Mass and volume of a segment, per length.

    `water_density`: kg/m3; `key`: where the segment stands in the case, for messages. Raises
    InputError when it does not sink and its mass is not known, or its mass is less than its weight
    in water.
    """
    weight = segment.submerged_weight / STANDARD_GRAVITY
    if segment.mass == 0.0:
        allowed = Message("refused_command.must_be_above_0_kg")
        raise InputError([Problem(f"{key}.mass", "0 kg/m", allowed)], "export")
    if segment.mass is not None:
        return _displacing(segment.mass, weight, water_density, f"{key}.mass", "kg/m")
    if weight <= 0.0:
        allowed = Message("refused_command.missing_segment_does_not_sink")
        raise InputError([Problem(f"{key}.mass", "", allowed)], "export")
    mass = weight / (1.0 - water_density / STEEL_DENSITY)
    return BodyInWater(mass, mass / STEEL_DENSITY, is_known=False)


def of_point_load(load: PointLoad, water_density: float, key: str) -> BodyInWater:
    """Mass and volume of a clump weight or a buoy, with its drag and added mass.

    `water_density`: kg/m3; `key`: where the load stands in the case, for messages. Raises
    InputError when its mass in air is less than its weight in water.
    """
    weight = load.submerged_weight / STANDARD_GRAVITY
    if load.mass is None:
        body = BodyInWater(max(weight, 0.0), max(-weight, 0.0) / water_density, is_known=False)
    elif abs(load.mass - weight) <= LEAST_VOLUME * load.mass:
        body = BodyInWater(load.mass, 0.0)
    else:
        body = _displacing(load.mass, weight, water_density, f"{key}.mass", "kg")
    return replace(body, drag_area=load.drag_product, added_mass=load.added_mass_coefficient)


def _displacing(
    mass: float, weight: float, water_density: float, key: str, unit: str
) -> BodyInWater:
    volume = (mass - weight) / water_density
    if volume < LEAST_VOLUME * mass / water_density:
        allowed = Message("refused_command.must_be_above_what_weight", weight=weight, unit=unit)
        raise InputError([Problem(key, f"{mass:.6g} {unit}", allowed)], "export")
    return BodyInWater(mass, volume)


@dataclass(frozen=True)
class ExportedLine:
    """One line between its two ends.

    `name`: ``line 1``, or that of its leg; `solution`: its equilibrium in its own vertical plane;
    `at_rest`: the same between the same ends on a bed without friction, None where that is no
    other; `own_tension`: at the fairlead, N, of the line as the case has it, where `solution` has
    another EA; `anchor`: its x and y, m; `heading`: from there to the fairlead, counter-clockwise
    from x, rad.
    """

    name: str
    solution: Solution
    at_rest: Solution | None
    own_tension: float
    anchor: tuple[float, float] = (0.0, 0.0)
    heading: float = 0.0

    @property
    def expected(self) -> Solution:
        """What a program that knows no friction at rest should find."""
        return self.solution if self.at_rest is None else self.at_rest

    def in_space(self, distance: float, height: float) -> tuple[float, float, float]:
        """Place a point of the line's plane: x, y and height above the bed, m.

        `distance`, `height`: horizontally from the anchor, and above the bed, m.
        """
        x, y = self.anchor
        cosine, sine = math.cos(self.heading), math.sin(self.heading)
        return x + distance * cosine, y + distance * sine, height

    def in_plane(self, arc: float) -> tuple[float, float]:
        """Distance and height of the point `arc` (m, unstretched) from the anchor, m."""
        stretch = [each for each in self.solution.stretches if each.start <= arc][-1]
        return end_of(stretch, min(arc - stretch.start, stretch.length))

    def at(self, arc: float) -> tuple[float, float, float]:
        """Place of the point `arc` (m, unstretched) from the anchor: x, y, height above the bed."""
        return self.in_space(*self.in_plane(arc))


@dataclass(frozen=True)
class ExportedLines:
    """A case with its lines where they hang.

    `case`: under the load that was taken; `lines`: one, or those of the system; `system`: of a
    moored body; `EA`: of the segments that do not stretch in the case, N; None: they were left as
    they are; `warnings`: what an engineer should know before using the answer.
    """

    case: Case
    lines: tuple[ExportedLine, ...]
    system: SystemSolution | None
    EA: float | None
    warnings: tuple[str, ...]

    @property
    def highest(self) -> float:
        """Largest height of any line above the bed, m."""
        return max(max(line.solution.profile().z) for line in self.lines)


def exported_lines(case: Case, EA: float | None = None) -> ExportedLines:
    """Solve a case, and once more with an EA for the segments that do not stretch.

    `EA`: for segments without, N; the load stays what it is. Raises NoEquilibriumError,
    NotConvergedError as for `solve_case` and `solve_system`.
    """
    return _line(case, EA) if case.system is None else _body(case, EA)


def rigid_segments(case: Case) -> tuple[str, ...]:
    """List the segments of a case that do not stretch, by their keys, each once."""
    lines = [case.line] if case.system is None else [leg.line for leg in case.system.legs]
    found = (
        f"line.segments[{number}]"
        for line in lines
        for number, segment in enumerate(line.segments)
        if segment.is_inextensible
    )
    return tuple(dict.fromkeys(found))


def _line(case: Case, EA: float | None) -> ExportedLines:
    case.check_still_water()
    own = solve_case(case)
    case, _ = under_a_load(case)
    solution = own if EA is None else _stretching(own, case, EA)
    line = ExportedLine("line 1", solution, _at_rest(solution), own.fairlead.tension)
    return ExportedLines(case, (line,), None, EA, own.warnings)


def _stretching(own: Solution, case: Case, EA: float) -> Solution:
    """Solve the line with another EA under what is known of its load, or was found."""
    known = {"horizontal_force": own.horizontal_force}
    if case.find is None and case.load is not None:
        (key,) = case.load.given
        known = {key: getattr(case.load, key)}
    return solve(
        _with_EA(own.line, EA),
        height=own.fairlead_height,
        anchor_height=own.anchor_height,
        seabed_friction=own.seabed_friction,
        **known,
    )


def _body(case: Case, EA: float | None) -> ExportedLines:
    own = report_system(case).solution
    assert case.system is not None
    solved = own
    if EA is not None:
        legs = tuple(replace(leg, line=_with_EA(leg.line, EA)) for leg in case.system.legs)
        case = replace(case, system=replace(case.system, legs=legs))
        solved = report_system(case).solution
    lines = tuple(
        ExportedLine(
            state.leg.name or f"line {number}",
            state.solution,
            _at_rest(state.solution),
            before.tension,
            anchor=state.leg.anchor,
            heading=state.direction + math.pi,
        )
        for number, (state, before) in enumerate(zip(solved.lines, own.lines, strict=True), start=1)
    )
    return ExportedLines(case, lines, solved, EA, own.warnings)


def _with_EA(line: Line, EA: float) -> Line:
    segments = [replace(s, EA=EA) if s.is_inextensible else s for s in line.segments]
    return Line(segments, line.point_loads)


def _at_rest(solution: Solution) -> Solution | None:
    """Solve the line anew between its ends, without friction; None where it feels none."""
    line = solution.line
    rough = solution.seabed_friction > 0.0 or any(load.friction for load in line.point_loads)
    if not rough or solution.grounded_length == 0.0:
        return None
    loads = [replace(load, friction=None) for load in line.point_loads]
    return solve(
        Line(line.segments, loads),
        height=solution.fairlead_height,
        anchor_height=solution.anchor_height,
        span=solution.span,
    )
