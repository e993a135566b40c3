"""What came of an export, as a value, and what the closed form says of its lines."""

from __future__ import annotations

import math
import re
import unicodedata
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from hashlib import sha256
from textwrap import wrap
from typing import Annotated, Any, Literal
from warnings import warn

from catopt._version import identity
from catopt.catenary.case import solve_case, under_a_load
from catopt.catenary.solution import Solution
from catopt.catenary.solve import solve
from catopt.decks.deck import End
from catopt.errors import refused
from catopt.export.exported_line import ExportedBody, ExportedLine, ExportedLines, ExportedPoint
from catopt.model import Case, Line
from catopt.model.network import Network, Point
from catopt.mooring.case import report_system
from catopt.mooring.fixed_body import at_rest
from catopt.mooring.network_rest import LinesAtRest
from catopt.mooring.solution import of_line
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


_SAID = (
    *("span", "H", "V at {last}", "T at {last}", "T at {first}", "V at {first}"),
    "on the bed",
)
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
        ends = [plain(solved.points[end].name) for end in line.ends]
        yield f"  {plain(line.name)}: {_sentence(line.solution, *ends)}"
        if line.at_rest is not None:
            yield f"    on a bed without friction: {_sentence(line.at_rest, *ends)}"
    for body in solved.bodies:
        count = len(body.fairleads)
        yield (
            f"  {plain(body.name)} at x {significant(body.x)} m, y {significant(body.y)} m, yaw "
            f"{significant(body.yaw)} rad, where the {count} lines balance a force of "
            f"{significant(body.force[0])} N along x and {significant(body.force[1])} N along y"
        )


def _sentence(solution: Solution, first: str, last: str) -> str:
    found, rounding = FoundForces(solution).to_dict(), ROUNDING * solution.fairlead.tension
    return ", ".join(
        f"{said.format(first=first, last=last)} "
        f"{significant(value if abs(value) > rounding else 0.0)} {key.rpartition('_')[2]}"
        for said, (key, value) in zip(_SAID, found.items(), strict=True)
    )


def exported_lines(case: Case | Network, EA: float | None = None) -> ExportedLines:
    """Solve a case, and once more with an EA for the segments that do not stretch.

    `EA`: for segments without, N; the load stays what it is. Raises NoEquilibriumError,
    NotConvergedError as for `solve_case` and `solve_system`; InputError for lines in a current.
    """
    if isinstance(case, Network):
        return _between_points(case, EA)
    return _body(case, EA) if case.several_lines else _line(case, EA)


def rigid_segments(case: Case | Network) -> tuple[str, ...]:
    """List the segments of a case that do not stretch, by their keys, each once."""
    found = (
        f"{key}.segments[{number}]"
        for key, line in case.keyed_lines
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
    line = ExportedLine("line 1", solution, _at_rest(solution), own.fairlead.tension, (0, 1))
    points = _ends(line, (solution.span, 0.0))
    return ExportedLines(case, (line,), points, EA=EA, warnings=own.warnings)


def _ends(line: ExportedLine, fairlead: tuple[float, float]) -> tuple[ExportedPoint, ExportedPoint]:
    """Make points of the two ends of a line; x and y of the second in m."""
    solution, of = line.solution, f"of {line.name}"
    first, second = (*line.anchor, solution.anchor_height), (*fairlead, solution.fairlead_height)
    return (
        ExportedPoint("anchor", f"anchor {of}", "fixed", first),
        ExportedPoint("fairlead", f"fairlead {of}", "coupled", second),
    )


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
    solved = own
    if EA is not None:
        legs = tuple(replace(leg, line=_with_EA(leg.line, EA)) for leg in own.system.legs)
        case = replace(case, system=replace(own.system, legs=legs))
        solved = report_system(case).solution
    lines = tuple(
        ExportedLine(
            state.leg.name or f"line {number}",
            state.solution,
            _at_rest(state.solution),
            before.tension,
            (number - 1, len(own.lines) + number - 1),
            anchor=state.leg.anchor,
            heading=state.direction + math.pi,
        )
        for number, (state, before) in enumerate(zip(solved.lines, own.lines, strict=True), start=1)
    )
    pairs = (_ends(line, each.fairlead) for line, each in zip(lines, solved.lines, strict=True))
    anchors, fairleads = zip(*pairs, strict=True)
    at, neutral, system = solved.position, solved.neutral, solved.system
    body = ExportedBody(
        "body",
        at.x,
        at.y,
        at.yaw,
        fairleads[0].place[2],
        system.force,
        system.moment,
        (neutral.x, neutral.y),
        tuple(each.place for each in fairleads),
    )
    return ExportedLines(case, lines, anchors + fairleads, (body,), EA, own.warnings, system)


_ENDS: Mapping[str, End] = {"anchor": "fixed", "fairlead": "coupled", "joint": "free"}


def _between_points(network: Network, EA: float | None) -> ExportedLines:
    """Bring points, lines and bodies to rest; bodies are held there on a bed without friction."""
    network = network.without_motion()
    network.site.check_water()
    if network.current_at_rest is not None:
        raise refused("current", "", Message("refused_command.exported_in_still_water"), "export")
    own = at_rest(network)
    rest = own if EA is None else at_rest(_stretched(network, EA))
    smooth = _on_smooth_bed(rest)
    used = {each.name: each.used for each in rest.floats}
    points = tuple(
        ExportedPoint(
            of.name,
            f"{of.kind} {of.name}",
            _ENDS[of.kind],
            place,
            of.name,
            _hung(of, used.get(of.name)) if of.kind == "joint" else None,
            f"points[{number}]",
            reaction,
        )
        for number, (of, place, reaction) in enumerate(rest.points)
    )
    laid = zip(rest.runs, network.lines, rest.lines, smooth, own.lines, strict=True)
    lines = []
    for number, (run, given, solution, bare, before) in enumerate(laid):
        (x, y, _), (to_x, to_y, _) = points[run.first].place, points[run.second].place
        lines.append(
            ExportedLine(
                given.name or f"line {run.name}",
                solution,
                bare,
                before.fairlead.tension,
                (run.first, run.second),
                anchor=(x, y),
                heading=math.atan2(to_y - y, to_x - x),
                key=f"lines[{number}]",
                is_turned=network.numbers[given.start] != run.first,
            )
        )
    warnings = (
        of_line(number, warning)
        for number, line in enumerate(own.lines, start=1)
        for warning in line.warnings
    )
    said = (*warnings, *_stand_ins(rest))
    bodies = tuple(_bodies(rest))
    return ExportedLines(network, tuple(lines), points, bodies, EA, said, network)


def _stand_ins(rest: LinesAtRest) -> Iterator[Message]:
    """Say which joints have another weight in the file."""
    afloat = ", ".join(each.name for each in rest.floats if each.left > 0.0)
    if afloat:
        yield Message("export.floats", names=afloat)
    pulled = ", ".join(each.name for each in rest.network.points if each.force[2] != 0.0)
    if pulled:
        yield Message("export.pulled", names=pulled)


def _hung(joint: Point, used: float | None) -> Point:
    """Put the lift of a float that its lines use, N, and a force up or down, in a joint's weight.

    So it keeps its height under water; the mass of what is pulled up or down no longer fits.
    """
    along, across, up = joint.force
    return replace(
        joint,
        submerged_weight=(joint.submerged_weight if used is None else -used) - up,
        force=(along, across, 0.0),
        mass=joint.mass if up == 0.0 else None,
        float_height=None,
    )


def _bodies(rest: LinesAtRest) -> Iterator[ExportedBody]:
    for each in rest.bodies:
        own, places = rest.network.arms_of(each.body), rest.joints.places
        ends = [end for run in rest.runs for end in (run.first, run.second) if end in own]
        at, neutral = each.position, each.zero_load_position
        along, across = each.body.force
        yield ExportedBody(
            each.body.name,
            at.x,
            at.y,
            at.yaw,
            places[next(iter(own))][2],
            (along, across),
            each.body.moment,
            None if neutral is None else (neutral.x, neutral.y),
            tuple(places[end] for end in ends),
        )


def _stretched(network: Network, EA: float) -> Network:
    lines = (replace(each, line=_with_EA(each.line, EA)) for each in network.lines)
    return replace(network, lines=tuple(lines))


def _on_smooth_bed(rest: LinesAtRest) -> tuple[Solution | None, ...]:
    """Solve the lines of a network anew without friction, bodies held; None where they feel none.

    Joints come to rest elsewhere then.
    """
    network = rest.network
    if not any(map(_feels_friction, rest.lines)):
        return (None,) * len(rest.lines)
    points = tuple(
        replace(of, x=x, y=y, height=z, body="") if of.kind == "fairlead" else of
        for of, (x, y, z), _ in rest.points
    )
    lines = tuple(replace(each, line=_smooth(each.line)) for each in network.lines)
    site = replace(network.site, seabed_friction=0.0)
    return at_rest(replace(network, site=site, points=points, lines=lines, bodies=())).lines


def _with_EA(line: Line, EA: float) -> Line:
    segments = [replace(s, EA=EA) if s.is_inextensible else s for s in line.segments]
    return Line(segments, line.point_loads)


def _smooth(line: Line) -> Line:
    return Line(line.segments, [replace(load, friction=None) for load in line.point_loads])


def _feels_friction(solution: Solution) -> bool:
    loads = solution.line.point_loads
    rough = solution.seabed_friction > 0.0 or any(load.friction for load in loads)
    return rough and solution.grounded_length != 0.0


def _at_rest(solution: Solution) -> Solution | None:
    """Solve the line anew between its ends, without friction; None where it feels none."""
    if not _feels_friction(solution):
        return None
    return solve(
        _smooth(solution.line),
        height=solution.fairlead_height,
        anchor_height=solution.anchor_height,
        span=solution.span,
    )
