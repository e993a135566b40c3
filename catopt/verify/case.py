"""Points, lines and bodies, a case in each of its load cases, or a front, by both models."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence, Set
from contextlib import nullcontext
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, Literal

from catopt.catenary.case import as_found, solve_case
from catopt.catenary.solution import check_buoys, named_line
from catopt.errors import InputError, NoAnswerError, NotConvergedError, refused
from catopt.fem import mesh_line
from catopt.fem.network import LineEnd, MeetingPoint, NetworkSolution, solve_network
from catopt.fem.solve import TrussSolution, part_of
from catopt.model import Case
from catopt.model.joined import joined
from catopt.model.network import Network
from catopt.mooring.chains import Row, in_rows, rows_of
from catopt.mooring.fixed_body import at_rest
from catopt.mooring.joints import Moored, Run, moored, runs_of
from catopt.mooring.network_rest import BodyAtRest, LinesAtRest
from catopt.progress import Progress, paced
from catopt.records import Counted, Record
from catopt.units import as_written
from catopt.verify.comparison import ORDER, Compared
from catopt.verify.convergence_check import ELEMENTS, TOLERANCE, check_settings
from catopt.verify.line import (
    SLACK,
    SLACK_ORDER,
    Comparing,
    bends,
    compared_places,
    on_meshes,
    verify_line,
    verify_system,
)
from catopt.verify.result import (
    SCHEMA,
    VERDICTS,
    LinePair,
    Mesh,
    StaticComparison,
    Verdict,
    Verification,
    least_agreeing,
)
from catopt.words import Message


@dataclass(frozen=True)
class _Within:
    """Where a line of a network is in its row: arc length at which it begins, m, and which way."""

    row: int
    start: float
    turned: bool


def verify_network(
    network: Network, *, elements: int, tolerance: float, name: str = ""
) -> StaticComparison:
    """Solve lines that meet in joints and bodies by the truss model beside their closed form.

    Joints are nodes that lines share. Bodies of the truss model do not turn: they are held in the
    closed form's yaw, and the moment of their lines is compared with the one on them. Joints of
    two lines are nodes of one line, whose friction goes on through them.

    Raises InputError for floats in a current, or what the closed form and the truss model raise.
    """
    if network.current_at_rest is not None:
        allowed = Message("refused_motion.truss_of_points_has_no_current")
        raise refused("current", "", allowed, "verify")
    closed = at_rest(network)
    network = closed.carrying_floats(network)
    rows = rows_of(network)
    within = _places_in_rows(network, rows, closed.runs)
    whole = in_rows(network, rows)
    runs = runs_of(whole)
    points, ends = _points(whole, closed, runs)
    trusses = on_meshes(
        elements,
        lambda bars: [
            mesh_line(run.line, bars, bends=_bends(k, closed, within)) for k, run in enumerate(runs)
        ],
        lambda meshes: solve_network(
            meshes, ends, points, seabed_friction=network.site.seabed_friction
        ),
    )
    lines = tuple(
        tuple(
            part_of(truss.lines[at.row], run.line, at.start, turned=at.turned) for truss in trusses
        )
        for run, at in zip(closed.runs, within, strict=True)
    )
    compared = _beside_slack(
        closed,
        [
            Comparing(solution, of_line, tolerance, k)
            for k, (solution, of_line) in enumerate(zip(closed.lines, lines, strict=True))
        ],
    )
    loose = _open_places(closed, compared)
    return StaticComparison(
        name=name,
        kind="network",
        quantities=(
            *_joints(whole, closed, trusses, compared, loose, tolerance),
            *_bodies(whole, closed, trusses, lines, loose, tolerance),
            *(
                each
                for run, both in zip(closed.runs, compared, strict=True)
                for each in _line(both, is_loose=bool({run.first, run.second} & loose))
            ),
        ),
        meshes=tuple(Mesh.of(truss, truss.lines) for truss in trusses),
        lines=tuple(map(LinePair, closed.lines, lines)),
        tolerance=tolerance,
        remarks=tuple(_remarks(closed, compared, loose)),
        line_names=tuple(run.name for run in closed.runs),
    )


def _places_in_rows(
    network: Network, rows: Sequence[Row], runs: Sequence[Run]
) -> tuple[_Within, ...]:
    """Say where each line is in which row; `runs` as they are laid out alone."""
    found: dict[int, _Within] = {}
    for k, row in enumerate(rows):
        start, names = 0.0, (row.start, *row.joints)
        for (number, _), name in zip(row.lines, names, strict=True):
            turned = runs[number].first != network.numbers[name]
            found[number] = _Within(k, start, turned)
            start += runs[number].line.length
    return tuple(found[k] for k in range(len(runs)))


def _bends(row: int, closed: LinesAtRest, within: Sequence[_Within]) -> list[tuple[float, float]]:
    """Gather where lines of a row are level, by arc length along the row, with their radii; m."""
    found = []
    for solution, at in zip(closed.lines, within, strict=True):
        if at.row == row:
            for arc, radius in bends(solution):
                along = solution.line.length - arc if at.turned else arc
                found.append((at.start + along, radius))
    return found


def _points(
    whole: Network, closed: LinesAtRest, runs: Sequence[Run]
) -> tuple[list[MeetingPoint], list[tuple[LineEnd, LineEnd]]]:
    """Lay out joints and bodies for the truss model, and the ends of its lines."""
    points: list[MeetingPoint] = []
    at: dict[int, LineEnd] = {}
    for k, point in enumerate(whole.points):
        if point.kind == "joint":
            at[k] = LineEnd((0.0, 0.0, 0.0), len(points))
            points.append(MeetingPoint(point.hung))
        elif not point.body:
            at[k] = LineEnd(closed.place_of(point.name))
    for body, rest in zip(moored(whole, 0), closed.bodies, strict=True):
        for k, (x, y, z) in body.turned(rest.position.yaw).items():
            at[k] = LineEnd((x, y, z + rest.rise), len(points))
        given, (along, across) = body.body, body.body.force
        points.append(MeetingPoint((along, across, 0.0), (given.x, given.y, 0.0)))
    return points, [(at[run.first], at[run.second]) for run in runs]


def _beside_slack(closed: LinesAtRest, compared: Sequence[Comparing]) -> list[Comparing]:
    """Measure what moves with a slack line by its bars, to which it is known."""
    points = closed.network.points
    ties = [
        {
            points[k].body or points[k].name
            for k in (run.first, run.second)
            if points[k].kind == "joint" or points[k].body
        }
        for run in closed.runs
    ]
    found = list(compared)
    for k, both in enumerate(compared):
        if both.is_slack:
            reached = joined(ties[k], ties)
            for other, ends in enumerate(ties):
                if ends & reached:
                    least = map(max, found[other].beside, both.bar)
                    found[other] = replace(found[other], beside=(next(least), next(least)))
    return found


def _open_places(closed: LinesAtRest, compared: Sequence[Comparing]) -> set[int]:
    """Gather joints, and fairleads of free bodies, that slack lines alone hold.

    Nothing says where in plan they are.
    """
    pulled = {
        point
        for run, both in zip(closed.runs, compared, strict=True)
        if not both.is_slack
        for point in (run.first, run.second)
    }
    points = closed.network.points
    afloat = {points[k].body for k in pulled}
    return {
        k
        for k, point in enumerate(points)
        if (point.kind == "joint" and k not in pulled) or (point.body and point.body not in afloat)
    }


def _remarks(closed: LinesAtRest, compared: Sequence[Comparing], loose: Set[int]) -> Iterator[str]:
    points = closed.network.points
    for name in dict.fromkeys(points[k].body or points[k].name for k in sorted(loose)):
        yield Message("truss.place_is_open", name=name)
    for run, both in zip(closed.runs, compared, strict=True):
        if both.is_slack:
            yield Message("mooring.of_line", number=run.name, warning=Message(SLACK))
    for body in closed.bodies:
        if body.turns:
            yaw = math.degrees(body.position.yaw)
            yield Message("truss.body_in_yaw", name=body.body.name, yaw=yaw)
        if body.body.floats:
            yield Message("truss.body_in_height", name=body.body.name, rise=body.rise)


def _joints(
    whole: Network,
    closed: LinesAtRest,
    trusses: Sequence[NetworkSolution],
    compared: Sequence[Comparing],
    loose: Set[int],
    tolerance: float,
) -> Iterator[Compared]:
    """Compare where joints lie: those that lines share, and those within rows."""
    shared = [point.name for point in whole.points if point.kind == "joint"]
    for number, point in enumerate(closed.network.points):
        if point.kind != "joint":
            continue
        meeting = [
            (run, both)
            for run, both in zip(closed.runs, compared, strict=True)
            if number in (run.first, run.second)
        ]
        run, both = meeting[0]
        end = 0 if run.first == number else -1
        scale = max(each.scales[1] for _, each in meeting)
        theory = SLACK_ORDER if any(each.is_slack for _, each in meeting) else ORDER
        for axis in (2,) if number in loose else range(3):
            if point.name in shared:
                p = shared.index(point.name)
                values = tuple(truss.places[p][axis] for truss in trusses)
            else:
                values = tuple(float(truss.nodes[end, axis]) for truss in both.trusses)
            key, exact = f"place_{'xyz'[axis]}", closed.joints.places[number][axis]
            own = point.name
            yield Compared(key, "m", exact, values, scale, tolerance, theory=theory, point=own)


def _bodies(
    whole: Network,
    closed: LinesAtRest,
    trusses: Sequence[NetworkSolution],
    lines: Sequence[Sequence[TrussSolution]],
    loose: Set[int],
    tolerance: float,
) -> Iterator[Compared]:
    longest = max(run.line.length for run in closed.runs)
    first = len(trusses[0].places) - len(closed.bodies)
    for number, (rest, body) in enumerate(zip(closed.bodies, moored(whole, 0), strict=True)):
        if loose & body.arms.keys():
            continue
        places = [truss.places[first + number] for truss in trusses]
        yield from compared_places(rest, longest, places, tolerance, rest.body.name)
        if rest.turns:
            yield _moment(rest, body, closed, places, lines, tolerance)


def _moment(
    rest: BodyAtRest,
    body: Moored,
    closed: LinesAtRest,
    places: Sequence[tuple[float, float, float]],
    lines: Sequence[Sequence[TrussSolution]],
    tolerance: float,
) -> Compared:
    """Compare the moment of lines on a body about the vertical through its origin."""
    fairleads = {k for k, point in enumerate(closed.network.points) if point.body == body.body.name}
    values, strongest = [], 0.0
    for mesh, place in enumerate(places):
        total = 0.0
        for run, of_line in zip(closed.runs, lines, strict=True):
            truss = of_line[mesh]
            for at, end, other, force in (
                (run.first, 0, -1, truss.anchor),
                (run.second, -1, 0, truss.fairlead),
            ):
                if at in fairleads:
                    arm = truss.nodes[end, :2] - place[:2]
                    way = truss.nodes[other, :2] - truss.nodes[end, :2]
                    size = max(math.hypot(*way), 1e-300)
                    turning = float(arm[0] * way[1] - arm[1] * way[0])
                    total += force.horizontal_force * turning / size
                    strongest = max(strongest, force.tension)
        values.append(total)
    exact, scale, own = -rest.body.moment, body.arm * strongest, rest.body.name
    return Compared("moment_of_lines", "Nm", exact, tuple(values), scale, tolerance, point=own)


def _line(both: Comparing, *, is_loose: bool) -> Iterator[Compared]:
    """Compare a line; `is_loose`: one of its ends is anywhere, so that its span is open."""
    force, length = both.scales
    yield both.of("from_tension", "N", force, "anchor.tension")
    yield both.of("to_tension", "N", force, "fairlead.tension")
    for each in both.of_several(force, length):
        if not is_loose or each.quantity != "span":
            yield each


LOAD = "load"
"""Name of the load case of a case that has only its ``[load]``."""


def verify_case(
    case: Case | Network,
    *,
    load_case: str | None = None,
    elements: int = ELEMENTS,
    tolerance: float = TOLERANCE,
    progress: Progress | None = None,
) -> Verification:
    """Solve a case by the closed form and by the truss model, and compare them.

    The truss model shares nothing with the closed form but the line it is given. It is solved on
    three meshes, of which each has twice the bars of the one before; their values are extrapolated
    where they close up with the square of the bar length.

    Parameters
    ----------
    case : Case or Network
        As read by `catopt.read_case`; with a system, the body and all its lines; of points, lines
        and bodies all of them.
    load_case : str, optional
        Name of one load case; all of them when left out, or the load where there are none.
    elements : int
        Bars of a line on the coarsest mesh.
    tolerance : float
        Largest difference that counts as agreement: of the fairlead tension for forces, of the
        line's length for lengths, in rad for angles (docs/verify.md).
    progress : callable, optional
        Told how many load cases are done and how many there are.

    Returns
    -------
    Verification
        With a verdict for each load case.

    Raises
    ------
    InputError
        When a setting is out of range, or no load case has that name.
    NoEquilibriumError, FloatsUpError
        When there is no equilibrium, or a buoy would float above the water surface.
    NotConvergedError
        When one of the models stopped short of its tolerance.

    Examples
    --------
    >>> from catopt import read_case, verify_case
    >>> found = verify_case(read_case("cases/buoy-9.5m/case.toml"))
    >>> found.verdict
    'agrees'
    >>> round(found.static.of("span").order, 2)
    2.0
    """
    check_settings(elements, tolerance, source="verify_case")
    if isinstance(case, Network):
        if load_case is not None:
            raise _no_load_cases(load_case)
        part = verify_network(case, elements=elements, tolerance=tolerance, name=LOAD)
        return Verification(case, (part,))
    if case.site.is_in_air:
        lifted, _ = case.clear_of_the_ground
        found = verify_case(
            lifted, load_case=load_case, elements=elements, tolerance=tolerance, progress=progress
        )
        return replace(found, case=case)
    case.site.check_level()
    case.check_still_water()
    states = load_states(case, load_case)
    parts = []
    steps = paced(Message("words.load_cases", total=len(states)), states)
    for done, (name, state) in enumerate(steps):
        if progress is not None:
            progress(done, len(states))
        assert isinstance(state, Case)
        parts.append(_verified(name, state, elements, tolerance))
    return Verification(case, tuple(parts))


def load_states(case: Case | Network, wanted: str | None) -> list[tuple[str, Case | Network]]:
    """Name every state of a case that is to be verified, with the case under its load.

    `wanted`: name of one load case; None: all of them, or the load where there are none. Raises
    InputError when no load case has that name.
    """
    states: dict[str, Case | Network] = {LOAD: case}
    if isinstance(case, Case):
        found = as_found(case)
        states = {each.name: found.under(each) for each in case.load_cases} or {LOAD: found}
    if wanted is None:
        return list(states.items())
    if wanted not in {state.name for state in case.load_cases}:
        names = ", ".join(state.name for state in case.load_cases)
        raise _no_load_cases(wanted, names)
    return [(wanted, states[wanted])]


def _no_load_cases(wanted: str, names: str = "") -> InputError:
    none = Message("refused_command.case_has_no_load_cases")
    allowed = Message("refused.one_of", words=names) if names else none
    return refused("--load-case", as_written(wanted), allowed, "options")


def _verified(name: str, case: Case, elements: int, tolerance: float) -> StaticComparison:
    if case.several_lines:
        part = verify_system(case.own_system, elements=elements, tolerance=tolerance, name=name)
    else:
        case = as_found(case)
        closed = solve_case(case)
        part = verify_line(case, closed, elements=elements, tolerance=tolerance, name=name)
    # Refuse buoys above the water surface by the truss model, which has every line.
    for number, pair in enumerate(part.lines, start=1):
        mesh = pair.finest.mesh
        heights = pair.finest.nodes[mesh.load_node, 2].tolist()
        with nullcontext() if part.kind == "line" else named_line(number):
            check_buoys(mesh.line, heights, case.site.water_depth)
    return part


# ------------------------------------------------------------------ a front


@dataclass(frozen=True)
class Design:
    """One design of a front.

    `case`: of this design; `load_case`: name of the load case that governs it; None: all of them.
    """

    number: Counted
    """Its number on the front, as in its tables."""
    case: Case
    load_case: str | None = None


@dataclass(frozen=True)
class DesignVerification(Record):
    """What came of one design."""

    DOCUMENT = "design.number=design verdict failure load_cases"

    design: Design
    verification: Verification | None
    """None where a model gave no answer."""
    failure: str = ""
    """Why there is no answer; empty where there is one."""
    did_not_converge: bool = False
    """Whether that was a solver that stopped short."""

    @cached_property
    def verdict(self) -> Verdict | Literal["no answer"]:
        """Of all that was verified."""
        return "no answer" if self.verification is None else self.verification.verdict

    @property
    def load_cases(self) -> tuple[StaticComparison, ...]:
        """As of a case; empty without an answer."""
        return () if self.verification is None else self.verification.parts


@dataclass(frozen=True)
class FrontVerification(Record):
    """A front by both models."""

    SCHEMA = SCHEMA
    DOCUMENT = "title verdict static designs"

    title: str
    """Title of the search."""
    designs: tuple[DesignVerification, ...]
    """Of a front: every design, in its governing load case."""

    @property
    def verified(self) -> tuple[Verification, ...]:
        """Of the designs that both models answered for."""
        found = [design.verification for design in self.designs]
        return tuple(each for each in found if each is not None)

    @property
    def static(self) -> StaticComparison | None:
        """Of the design on which the models agree least; None where there is no answer."""
        parts = [each.static for each in self.verified]
        return least_agreeing(parts) if parts else None

    @cached_property
    def verdict(self) -> Verdict | Literal["no answer"]:
        """The one of a design that outweighs the others; ``"no answer"`` where one has none."""
        verdicts = [each.verdict for each in self.verified]
        if len(verdicts) < len(self.designs):
            return "no answer"
        return next(each for each in VERDICTS if each in verdicts)

    @property
    def is_settled(self) -> bool:
        """Whether every design has an answer and the models agree on it."""
        count = len(self.verified)
        return count == len(self.designs) and all(each.is_settled for each in self.verified)

    @property
    def has_converged(self) -> bool:
        """Whether no solver stopped short."""
        return not any(design.did_not_converge for design in self.designs)

    def to_dict(self) -> dict[str, Any]:
        """Build the document that ``catopt verify DIR --all --json`` prints."""
        return super().to_dict() | {"dynamic": None}


def verify_front(
    title: str,
    designs: Sequence[Design],
    *,
    elements: int = ELEMENTS,
    tolerance: float = TOLERANCE,
    progress: Progress | None = None,
) -> FrontVerification:
    """Verify designs one after the other; one that fails does not stop the others."""
    found = []
    steps = paced(Message("words.designs", total=len(designs)), designs)
    for done, design in enumerate(steps):
        if progress is not None:
            progress(done, len(designs))
        try:
            verification = verify_case(
                design.case, load_case=design.load_case, elements=elements, tolerance=tolerance
            )
            found.append(DesignVerification(design, verification))
        except (NoAnswerError, NotConvergedError) as error:
            stopped = isinstance(error, NotConvergedError)
            found.append(DesignVerification(design, None, error.message, stopped))
    return FrontVerification(title, tuple(found))
