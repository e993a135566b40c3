"""What came of an export, as a value, and what the closed form says of its lines."""

from __future__ import annotations

import math
import re
import unicodedata
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from hashlib import sha256
from textwrap import wrap
from typing import Annotated, Any, Literal
from warnings import warn

from catopt._version import identity
from catopt.catenary.case import solve_case, under_a_load
from catopt.catenary.layout import end_of
from catopt.catenary.solution import Solution
from catopt.catenary.solve import solve
from catopt.constants import STANDARD_GRAVITY
from catopt.errors import refused
from catopt.model import Case, Line, PointLoad, Segment
from catopt.model.network import Network
from catopt.mooring.case import report_system
from catopt.mooring.network_rest import LinesAtRest
from catopt.mooring.solution import SystemSolution, solve_system
from catopt.records import Counted, Digest, From, Record, laid_out
from catopt.words import Message

_WITHOUT_MARKS = str.maketrans({"đ": "d", "Đ": "D"})


def plain(text: str) -> str:
    """Return a text in one line of ASCII: letters lose their marks, the rest becomes ``?``."""
    apart = unicodedata.normalize("NFKD", text.translate(_WITHOUT_MARKS))
    kept = "".join(letter for letter in apart if not unicodedata.combining(letter))
    return " ".join(kept.encode("ascii", "replace").decode("ascii").split())


def word(text: str, instead: str) -> str:
    """Return a text as one word of letters, digits and underscores that begins with a letter.

    `instead`: taken where nothing is left, and put before what does not begin with a letter.
    """
    kept = re.sub(r"[^A-Za-z0-9.]+", "_", plain(text).replace("?", " ")).strip("_.")
    kept = kept.replace(".", "p")
    if not kept:
        return instead
    return kept if kept[0].isalpha() else f"{instead}_{kept}"


def exact(value: float) -> str:
    """Return a number that reads back as the same double, for YAML 1.1 too: ``1.0e-07``."""
    digits = repr(float(value) + 0.0)
    return digits if "." in digits else digits.replace("e", ".0e")


def folded(text: str) -> list[str]:
    """Fold to 100 columns; nothing in it looks like the head of a section."""
    indent = " " * (len(text) - len(text.lstrip()))
    safe = plain(text)
    while "---" in safe:
        safe = safe.replace("---", "--")
    return wrap(
        safe, 100, initial_indent=indent, subsequent_indent=indent + "  ", break_on_hyphens=False
    )


def significant(value: float) -> str:
    """Return a number with ten significant digits; what is below 1e-9 is rounding and 0."""
    return f"{value:.10g}" if abs(value) > 1e-9 else "0"


Format = Literal["moordyn", "map", "moorpy", "ontology", "orcaflex", "dxf"]


@dataclass(frozen=True)
class Source(Record):
    """A file that the case was read from."""

    DOCUMENT = "name sha256"

    name: str
    """Without its folder."""
    sha256: Digest
    """SHA-256 of its bytes."""


@dataclass(frozen=True)
class FoundForces(Record):
    """What the closed form finds of a line."""

    DOCUMENT = (
        "solution.span solution.horizontal_force "
        "solution.fairlead.vertical_force=fairlead_vertical_force_N "
        "solution.fairlead.tension=fairlead_tension_N solution.anchor.tension=anchor_tension_N "
        "solution.anchor.vertical_force=anchor_vertical_force_N solution.grounded_length"
    )

    solution: Solution

    def __getitem__(self, key: str) -> Any:
        """Read it as the document has it: what was a dictionary up to 1.0.0."""
        warn("what is expected is read as solution.fairlead.tension", DeprecationWarning, 2)
        return self.to_dict()[key]


@dataclass(frozen=True)
class Expected(FoundForces):
    """What is to be found of a line of an exported file."""

    DOCUMENT = f"name {FoundForces.DOCUMENT} without_friction"

    name: str
    """Of the leg, or its number."""
    without_friction: FoundForces | None
    """The same line between the same ends on a bed without friction, which other programs find at
    rest; None where the bed has none or nothing lies on it."""


@dataclass(frozen=True)
class Exported(Record):
    """What catopt export has written: the lines of a case as the input of another program."""

    SCHEMA = "catopt.export/1"
    DOCUMENT = (
        "title format path size=bytes sha256 version sources expected=lines remarks _kept_text=text"
    )

    format: Format
    """What reads the file: MoorDyn and MoorPy, MAP++, Python with MoorPy, programs of the floating
    array ontology, OrcaFlex, or CAD programs."""
    title: str
    """Title of the case; empty when it has none."""
    text: str
    """Of the file, ASCII."""
    remarks: tuple[str, ...]
    """What the other program takes otherwise than the case says, and what an engineer should know;
    they stand in the file too."""
    expected: Annotated[tuple[Expected, ...], From(1)]
    """Each line as the closed form finds it, with the EA that stands in the file."""
    sources: Annotated[tuple[Source, ...], From(1)] = ()
    """Files that the case was read from; the case file first."""
    version: str = field(default_factory=identity)
    """Of catopt."""
    path: str | None = None
    """Where the file was written; None where no place was given, and text holds it."""

    @property
    def content(self) -> bytes:
        """The file's bytes."""
        return self.text.encode("ascii")

    @property
    def size(self) -> Counted:
        """Size of the file."""
        return len(self.content)

    @property
    def sha256(self) -> Digest:
        """SHA-256 of the file."""
        return sha256(self.content).hexdigest()

    @property
    def _kept_text(self) -> str | None:
        """The file itself; None where it was written to a path."""
        return self.text if self.path is None else None

    def to_dict(self, path: str | None = None) -> dict[str, Any]:
        """Build the document that ``catopt export --json`` prints, of a file written to a path."""
        return laid_out(replace(self, path=path))


ROUNDING = 1e-12
"""Of a number over the fairlead tension: what is below it is shown as 0."""


_SAID = ("span", "H", "V at fairlead", "T at fairlead", "T at anchor", "V at anchor", "on the bed")
"""What stands in a file for the keys of `FoundForces`."""


def exported(
    to: Format, solved: ExportedLines, text: str, remarks: Iterable[str], sources: Iterable[Source]
) -> Exported:
    """Put the text of a file together with what should be found by whoever runs it."""
    answers = tuple(
        Expected(
            each.solution, each.name, None if each.at_rest is None else FoundForces(each.at_rest)
        )
        for each in solved.lines
    )
    return Exported(to, solved.case.title, text, tuple(remarks), answers, tuple(sources))


def heading(
    first: str,
    solved: ExportedLines,
    own: Sequence[str],
    remarks: Sequence[str],
    sources: Sequence[Source],
) -> Iterator[str]:
    """Yield what a file says of itself.

    `first`: what it is; `own`: how it has to be read; `remarks`: what stands in it otherwise than
    in the case; `sources`: what the case was read from.
    """
    yield f"{first}; written by catopt {identity()}"
    if solved.case.title:
        yield from folded(f"Case: {solved.case.title}")
    for source in sources:
        yield from folded(f"From {source.name}, SHA-256 {source.sha256}")
    yield ""
    for line in in_words(solved):
        yield from folded(line)
    yield ""
    for line in own:
        yield from folded(line)
    for number, remark in enumerate(remarks, start=1):
        yield from folded(f"Remark {number}: {remark}")


def in_words(solved: ExportedLines) -> Iterator[str]:
    """Yield lines of text that say what should be found, in SI."""
    yield "Closed form of catopt, SI units, tensions without the water's pressure (effective):"
    for line in solved.lines:
        yield f"  {plain(line.name)}: {_sentence(line.solution)}"
        if line.at_rest is not None:
            yield f"    on a bed without friction: {_sentence(line.at_rest)}"
    if solved.system is not None:
        where, force = solved.system.position, solved.system.system.force
        yield (
            f"  body at x {significant(where.x)} m, y {significant(where.y)} m, yaw "
            f"{significant(where.yaw)} rad, where the {len(solved.lines)} lines balance a force of "
            f"{significant(force[0])} N along x and {significant(force[1])} N along y"
        )


def _sentence(solution: Solution) -> str:
    found, rounding = FoundForces(solution).to_dict(), ROUNDING * solution.fairlead.tension
    return ", ".join(
        f"{said} {significant(value if abs(value) > rounding else 0.0)} {key.rpartition('_')[2]}"
        for said, (key, value) in zip(_SAID, found.items(), strict=True)
    )


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
        raise refused(f"{key}.mass", "0 kg/m", allowed, "export")
    if segment.mass is not None:
        return _displacing(segment.mass, weight, water_density, f"{key}.mass", "kg/m")
    if weight <= 0.0:
        allowed = Message("refused_command.missing_segment_does_not_sink")
        raise refused(f"{key}.mass", "", allowed, "export")
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
        raise refused(key, f"{mass:.6g} {unit}", allowed, "export")
    return BodyInWater(mass, volume)


@dataclass(frozen=True)
class ExportedLine:
    """One line between its two ends.

    `name`: ``line 1``, or that of its leg; `solution`: its equilibrium in its own vertical plane;
    `at_rest`: the same between the same ends on a bed without friction, None where that is no
    other; `own_tension`: at the fairlead, N, of the line as the case has it, where `solution` has
    another EA; `anchor`: its x and y, m; `heading`: from there to the fairlead, counter-clockwise
    from x, rad; `is_anchored`: whether its first end is one.
    """

    name: str
    solution: Solution
    at_rest: Solution | None
    own_tension: float
    anchor: tuple[float, float] = (0.0, 0.0)
    heading: float = 0.0
    is_anchored: bool = True

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
    moored body; `rest`: of lines between points; `EA`: of the segments that do not stretch in the
    case, N; None: they were left as they are; `warnings`: what an engineer should know before using
    the answer.
    """

    case: Case | Network
    lines: tuple[ExportedLine, ...]
    system: SystemSolution | None
    EA: float | None
    warnings: tuple[str, ...]
    rest: LinesAtRest | None = None

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


def network_lines(network: Network) -> ExportedLines:
    """Solve lines between points; raises what `solve_system` raises."""
    network.site.check_water()
    if network.current_at_rest is not None:
        raise refused("current", "", Message("refused_case.current_for_solve_and_check"))
    rest = solve_system(network)
    lines = []
    for number, (run, solution) in enumerate(zip(rest.runs, rest.lines, strict=True)):
        first, second = (rest.joints.places[end] for end in (run.first, run.second))
        way = math.atan2(second[1] - first[1], second[0] - first[0])
        tension, is_anchored = solution.fairlead.tension, rest.is_anchored(number)
        name = run.name or f"line {number + 1}"
        lines.append(ExportedLine(name, solution, None, tension, first[:2], way, is_anchored))
    return ExportedLines(network, tuple(lines), None, None, (), rest)


def rigid_segments(case: Case) -> tuple[str, ...]:
    """List the segments of a case that do not stretch, by their keys, each once."""
    found = (
        f"line.segments[{number}]"
        for line in case.every_line
        for number, segment in enumerate(line.segments)
        if segment.is_inextensible
    )
    return tuple(dict.fromkeys(found))


def _line(case: Case, EA: float | None) -> ExportedLines:
    case.site.check_water()
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
