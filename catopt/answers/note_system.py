"""What the notes of a moored body, and of lines between points, consist of."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from functools import partial
from operator import itemgetter
from typing import TYPE_CHECKING, Any

from catopt.answers import blocks, places
from catopt.answers import system as body
from catopt.answers.bill import bill
from catopt.answers.blocks import (
    Block,
    Figure,
    Rows,
    Section,
    Text,
    Verdict,
    about,
    exact,
    named,
    texts,
)
from catopt.answers.check import checked_body
from catopt.answers.floats import buoyancy_tables, floating_tables, floats_tables
from catopt.answers.note import (
    basis_section,
    by_both,
    case_sections,
    damaged_section,
    inputs_table,
    note_answer,
    opening,
    section,
    sheet_sections,
    small,
    stated_section,
)
from catopt.answers.note_motion import body_motion_blocks
from catopt.answers.solution import given_tables, method_name, profile_table
from catopt.answers.system import (
    bodies_table,
    joints_table,
    meeting_table,
    network_out_table,
)
from catopt.answers.trail import DEGREES, equation_trail, step_of
from catopt.figures import mooring
from catopt.figures.line import line_in_water, magnified
from catopt.figures.mooring import network_plan, network_side
from catopt.quantities import QUANTITIES, Quantity
from catopt.words import Measure, Message, Sentence, Several

if TYPE_CHECKING:
    from catopt.checks.result import CheckReport
    from catopt.mooring.network_rest import LinesAtRest
    from catopt.mooring.restoring import Response
    from catopt.mooring.solution import LegState, SystemSolution
    from catopt.notes.system import NetworkNote, SystemNote

_CURVE_EVERY = 4
"""One point of a restoring curve in so many is shown; both ends and the middle are among them."""
_MOST_FORCE = 4.0
"""Restoring curves are drawn up to this multiple of the body's force."""
_TURNING = Quantity("turning", "", "", "N/rad", "kN/rad", 1e3, 3)
_YAWING = Quantity("yawing", "", "", "N*m/rad", "kN*m/rad", 1e3, 1)
_RESIDUAL = Quantity("force_left", "", "", "N", "N", 1.0, 2, "scientific")
_RESIDUAL_MOMENT = Quantity("moment_left", "", "", "N*m", "N*m", 1.0, 2, "scientific")
_section = partial(section, group="note_system")
_M, _N, _NM = (exact(unit) for unit in ("m", "N", "N m"))


def system_note_answer(note: SystemNote) -> blocks.Answer:
    """Lay out the note of a moored body."""
    followed = Message("note_system.line_trail_of_line", line=note.solution.most_loaded + 1)
    sections = (
        *_opening(note),
        basis_section(note.sheet),
        _section("identity", _identity(note)),
        _section("checks", _checks(note.checks, "note_system.checks_about")),
        _section("line_out", _line_out(note)),
        _section("elevation", _elevation(note)),
        _section("results", _results(note)),
        _section("lines", _lines(note)),
        *sheet_sections(note.sheet),
        _section("watch_circle", _watch_circle(note)),
        _section("restoring", _restoring(note)),
        *case_sections(note, note.case, note.case.line),
        _section("balance", _balance(note)),
        _section("line_trail", [Text(followed), *equation_trail(note.loaded.solution)]),
        _section("verification", by_both(note, "note_system", note.solution.most_loaded)),
        _section("motion", body_motion_blocks(note)),
    )
    return note_answer(
        note, "note_system.kind_system", sections, untitled="note_system.untitled_system"
    )


# ------------------------------------------------------------------ what decides


def _opening(note: SystemNote) -> Iterator[Section]:
    solution, system = note.solution, note.solution.system
    force, offset = math.hypot(*system.force), math.hypot(*solution.offset)
    said = Message(
        "note_first.body",
        lines=len(solution.lines),
        force=about("horizontal_force", force),
        offset=about("offset", offset),
        line=solution.most_loaded + 1,
        tension=about("tension", note.loaded.tension),
    )
    size = Measure("horizontal_force", force)
    pull = Message("sizing.measure", value=size)
    if any(system.force):
        towards = Measure("angle", note.force_towards)
        pull = Message("note_system.identity_towards", force=size, angle=towards)
    moment = Message("sizing.measure", value=Measure("moment", system.moment))
    freedom = "note_system.identity_turns" if system.turns else "mooring.x_and_y"
    facts = (
        ("note_system.identity_lines", f"{len(system.legs)}"),
        ("note_system.identity_freedom", Message(freedom)),
        ("note_system.identity_force", pull),
        ("note_system.identity_moment", moment if system.turns else ""),
        ("note.identity_method", method_name("closed-form")),
    )
    return opening(
        note,
        facts,
        said,
        drawing=plan_blocks(solution),
        force=(Message("note_system.identity_force"), "horizontal_force", force),
        reach=(Message("quantities.offset"), "offset", offset),
        tension=max(part.max_tension for each in note.sheet.intact for part in each.segments),
        in_motion=note.motion is not None,
        moved=note.motion_checks,
    )


def _identity(note: SystemNote) -> Iterator[Block]:
    tension = Measure("tension", note.loaded.tension)
    line = note.solution.most_loaded + 1
    loaded = Message("note_system.identity_loaded", line=line, tension=tension)
    yield _use(note, loaded, note.used)
    length = Measure("offset", math.hypot(*note.solution.offset))
    gone = Message("note_system.identity_stays", offset=length)
    if any(note.solution.offset) and any(note.solution.system.force):
        angle = Measure("angle", note.offset_towards)
        gone = Message("note_system.identity_goes", offset=length, angle=angle)
    yield Verdict(gone, None)
    yield from _one_out(note)
    yield from near_blocks(note.solution)


def _use(note: SystemNote, said: Message, used: float | None) -> Verdict:
    """Add how far lines are used to what is said of them."""
    if used is None:
        return Verdict(said, None)
    key = "note_system.identity_used" if note.is_judged else "note_system.identity_used_of_mbl"
    whole = Several((said, Message(key, used=QUANTITIES["utilisation"].format(used))), " ")
    return Verdict(whole, False if used > 1.0 else None)


def _one_out(note: SystemNote) -> Iterator[Verdict]:
    """Say what the worst missing line does, and which lines the body cannot do without."""
    for each in note.report.line_out:
        if each.response is None:
            refused = Message("note_system.line_out_refused", line=each.missing + 1)
            yield Verdict(Sentence(refused), passes=False)
    most_tension, most_offset = note.worst_out("largest_tension"), note.worst_out("offset")
    if most_tension is None or most_offset is None:
        return
    hardest, farthest = note.report.line_out[most_tension], note.report.line_out[most_offset]
    assert hardest.response is not None
    assert farthest.response is not None
    said = Message(
        "note_system.identity_one_out",
        tension=Measure("tension", hardest.response.largest_tension),
        line=hardest.response.most_loaded + 1,
        missing=hardest.missing + 1,
        offset=Measure("offset", farthest.response.offset),
        farthest=farthest.missing + 1,
    )
    yield _use(note, said, max((each for each in note.left if each is not None), default=None))


# ------------------------------------------------------------------ the body at rest


def plan_blocks(solution: SystemSolution) -> Iterator[Block]:
    """Draw the plan."""
    yield Text(Message("note_system.plan_about"))
    yield Figure(mooring.plan(solution))


def near_blocks(solution: SystemSolution) -> Iterator[Block]:
    """Draw the surroundings of the body larger, where the offset is small on the plan."""
    around = mooring.near(solution)
    if around is not None:
        yield Text(Message("figures.near"))
        yield Figure(around)


def _elevation(note: SystemNote) -> Iterator[Block]:
    """Draw the most loaded line to scale, and with heights magnified where it is flat."""
    solution, depth = note.loaded.solution, note.case.site.water_depth
    yield Text(Message("note_system.elevation_about", line=note.solution.most_loaded + 1))
    yield Figure(replace(line_in_water(solution, depth), name="system_elevation"))
    larger = magnified(solution, depth)
    if larger is not None:
        yield Text(larger.title)
        yield Figure(larger)
    yield profile_table(solution, only="workbook")


def _results(note: SystemNote) -> Iterator[Block]:
    yield blocks.Facts("system_results", tuple(_facts(note)))
    yield small("note_system.results_about", steps=note.solution.steps)
    rule = note.report.rule
    if rule.horizontal_force is not None and rule.line is not None:
        balance = note.solution.lines[rule.line].horizontal_force
        values = {
            "rule": Measure("horizontal_force", rule.horizontal_force),
            "balance": Measure("horizontal_force", balance),
        }
        yield Text(Message("note_system.results_rule", line=rule.line + 1, **values))
    if rule.why_not:
        yield Text(Several((Message("note_system.results_no_rule"), Sentence(rule.why_not)), " "))


def _facts(note: SystemNote) -> Iterator[blocks.Fact]:
    """List what the command says of the body, and more of its place and stiffness."""
    yield from body.body_facts(note.report.solution)
    solution = note.solution
    stiffness, turns = solution.full_stiffness, solution.system.turns
    length, angle = named("offset", ""), named("angle", "")
    zero, place = solution.neutral, solution.position
    for key, quantity, value, is_there in (
        ("place_x", length, place.x, True),
        ("place_y", length, place.y, True),
        ("offset", length, math.hypot(*solution.offset), True),
        ("zero_yaw", angle, zero.yaw, turns),
        ("kxm", _TURNING, stiffness[0][2], turns),
        ("kym", _TURNING, stiffness[1][2], turns),
        ("kmm", _YAWING, stiffness[2][2], turns),
        ("residual", _RESIDUAL, solution.residual.force, True),
        ("residual_moment", _RESIDUAL_MOMENT, solution.residual.moment, turns),
    ):
        if is_there:
            yield blocks.Fact(Message(f"note_system.results_{key}"), value, quantity)


def _lines(note: SystemNote) -> Iterator[Block]:
    """Tabulate what each line carries; the most loaded is marked."""
    solution = note.solution
    number, *others = body.lines_table(note.report.solution, note.checks).columns
    of = Rows(solution.lines)
    names = of.texts("name", "leg.name")
    directions = of.measured(
        "angle", "direction", "note_system.workbook_direction", symbol="", only="workbook"
    )
    columns = (number, *([names] if any(names.values) else []), *others, directions)
    yield blocks.Table("system_lines", columns, marked=solution.most_loaded)
    yield from places.legs_tables(solution)
    known = body.lines_used(note.checks)
    if note.used is None:
        known = Message("note_system.lines_unknown")
    yield Text(Several((known, Message("note_system.lines_marked")), " "), is_small=True)


def _checks(checks: CheckReport, about: str) -> Iterator[Block]:
    if checks.results:
        yield Text(Message(about))
        yield from checked_body(checks)
        yield small("note.checks_legend")


# ------------------------------------------------------------------ other states


def _line_out(note: SystemNote) -> Iterator[Block]:
    """Tabulate what each line gone does, and say why the body does not come to rest."""
    gone = note.report.line_out
    if not gone:
        return
    table = body.line_out_table(note.report)
    yield Text(Message("note_system.line_out_about"))
    hardest = note.worst_out("largest_tension")
    columns = (*table.columns[:-1], blocks.measured("utilisation", note.left), table.columns[-1])
    further = _further(each.response for each in gone)
    yield replace(table, columns=(*columns, *further), caption="", marked=hardest)
    yield from (Verdict(lost, passes=False) for lost in body.lines_lost(note.report))


def _further(responses: Iterable[Response | None]) -> Iterator[blocks.Column]:
    """Yield what only workbooks have of places of rest."""
    of = Rows(responses)
    for name, key, attribute in (
        ("yaw", "angle", "yaw"),
        ("anchor_tension", "tension", "largest_anchor_tension"),
        ("anchor_vertical", "vertical_force", "largest_uplift"),
    ):
        heading = f"note_system.workbook_{name}"
        yield of.measured(key, attribute, heading, symbol="", only="workbook")


def _watch_circle(note: SystemNote) -> Iterator[Block]:
    circle = note.report.circle
    if circle is None:
        return
    said = Message("note_system.watch_circle_about", force=Measure("tension", circle.force))
    yield Text(_turning(note, said))
    yield Figure(mooring.watch_track(note.solution, circle))
    yield Figure(mooring.watch_round(note.solution, circle, note.allowed_at_fairlead))
    table = body.circle_table(circle)
    shown = sorted({*(table.shown or ()), circle.farthest, circle.hardest})
    yield replace(
        table,
        columns=(*table.columns, *_further(circle.responses)),
        caption=Message("note_system.watch_circle_some"),
        shown=tuple(shown),
    )


def _turning(note: SystemNote, about: Message) -> Message:
    if not note.solution.system.turns:
        return about
    return Several((about, Message("note_system.restoring_turns")), " ")


def _restoring(note: SystemNote) -> Iterator[Block]:
    curves = note.report.curves
    if not curves:
        return
    yield Text(_turning(note, Message("note_system.restoring_about")))
    yield Figure(mooring.restoring(curves, note.solution, _MOST_FORCE))
    for number, curve in enumerate(curves, start=1):
        shown = tuple(range(0, len(curve.offset), _CURVE_EVERY))
        yield replace(body.curve_table(number, curve), shown=shown)


# ------------------------------------------------------------------ the balance by hand


def _balance(note: SystemNote) -> Iterator[Block]:
    system, position = note.solution.system, note.solution.position
    key = "note_system.balance_body" if system.has_arms else "note_system.balance_point"
    place = {"x": _M.format(position.x), "y": _M.format(position.y)}
    said = [Message("note_system.balance_about"), Message(key, **place)]
    if system.turns:
        said.insert(1, Message("note_system.balance_yaw"))
    yield Text(Several(said, " "))
    yield _pulls(note)
    yield blocks.Trail("balance", tuple(steps_of(note)), Message("note_system.balance_wanted"))


def _pulls(note: SystemNote) -> blocks.Table:
    """Tabulate H, its direction and its parts along x and y; with arms the moment, too."""
    system, lines = note.solution.system, Rows(note.solution.lines)
    anchors, fairleads = Rows(lines.read("leg.anchor")), Rows(lines.read("fairlead"))
    pulls, x, y = Rows(lines.read(pull_of)), itemgetter(0), itemgetter(1)
    listed: list[tuple[str, Rows, Quantity, str | Callable[[Any], Any]]] = [
        ("xA", anchors, _M, x),
        ("yA", anchors, _M, y),
        *([("xF", fairleads, _M, x), ("yF", fairleads, _M, y)] if system.has_arms else []),
        ("S", lines, _M, "solution.span"),
        ("H", lines, _N, "horizontal_force"),
        ("φ", lines, DEGREES, "direction"),
        ("H cos φ", pulls, _N, x),
        ("H sin φ", pulls, _N, y),
        *([("M", lines, _NM, partial(_moment, note))] if system.turns else []),
    ]
    columns = (
        of.measured(quantity, what, Message("note_system.balance_symbol", symbol=symbol))
        for symbol, of, quantity, what in listed
    )
    return blocks.tabulate(
        "pulls",
        texts("line", range(1, len(lines.rows) + 1)),
        *columns,
        caption=Message("note_system.balance_pulls"),
        marked=note.solution.most_loaded,
    )


def pull_of(line: LegState) -> tuple[float, float]:
    """Force of a line on the body along x and y, N."""
    H = line.horizontal_force
    return H * math.cos(line.direction), H * math.sin(line.direction)


def _moment(note: SystemNote, line: LegState) -> float:
    """Moment of a line on the body about its origin, N m."""
    position, (fx, fy) = note.solution.position, pull_of(line)
    rx, ry = line.fairlead[0] - position.x, line.fairlead[1] - position.y
    return rx * fy - ry * fx


def steps_of(note: SystemNote) -> Iterator[blocks.Step]:
    """Follow the balance: the sums over the lines against the load, and the most loaded span."""
    solution, system = note.solution, note.solution.system
    pulls = [pull_of(line) for line in solution.lines]
    for axis, letter, function in ((0, "x", "cos"), (1, "y", "sin")):
        terms, force = [(pull[axis],) for pull in pulls], system.force[axis]
        total, sum_of = math.fsum(pull[axis] for pull in pulls), f"Σ H {function} φ"
        step = partial(step_of, {f"F{letter}": force, sum_of: total})
        wanted = 0.0 - force
        key = f"note_system.balance_sum_{letter}"
        yield step(key, "", _N, total, sum_of, wanted, terms=terms)
        both = f"{{F{letter}}} + {{{sum_of}:()}}"
        yield step(f"note_system.balance_left_{letter}", "", _N, force + total, both)
    if system.turns:
        moments = [(_moment(note, line),) for line in solution.lines]
        total, wanted = math.fsum(moment for (moment,) in moments), 0.0 - system.moment
        sum_of, key = "Σ (x_r H sin φ − y_r H cos φ)", "note_system.balance_sum_m"
        yield step_of({}, key, "Σ M", _NM, total, sum_of, wanted, terms=moments)
    line = note.loaded
    (ax, ay), (px, py), (x, y) = line.leg.anchor, line.fairlead, solution.offset
    places = {"x_A": ax, "y_A": ay, "x_F": px, "y_F": py}
    step = partial(step_of, places | {"Δx": x, "Δy": y})
    span, root = math.hypot(ax - px, ay - py), "√(({x_A} − {x_F:()})² + ({y_A} − {y_F:()})²)"
    yield step("note_system.balance_span", "S", _M, span, root, line.solution.span)
    root = "√({Δx:()}² + {Δy:()}²)"
    yield step("note_system.balance_offset", "d", _M, math.hypot(x, y), root)


def network_note_answer(note: NetworkNote) -> blocks.Answer:
    """Lay out the note of lines between points."""
    side = Figure(network_side(note.rest, note.most_loaded))
    lines = meeting_table(note.rest, "network_lines", note.checks, marked=note.most_loaded)
    sections = (
        *_network_opening(note),
        stated_section(note.sheet, {}),
        _section("checks", _checks(note.checks, "note_system.network_checks_about")),
        _section("line_out", _network_line_out(note)),
        _section("side", [Text(Message("note_system.side_about")), side]),
        _section("joints", _joints(note)),
        _section(
            "lines",
            [lines, small("note_system.network_lines_about"), *places.places_tables(note.rest)],
        ),
        section("bill", bill(note.sheet, ""), "note_sheet"),
        damaged_section(note.sheet),
        section("components", _components(note)),
        _section("verification", by_both(note, "note_system", note.most_loaded)),
        _section("motion", body_motion_blocks(note)),
        section("inputs", [Text(Message("note.inputs_about")), inputs_table(note.origin)]),
    )
    return note_answer(
        note, "note_system.kind_network", sections, untitled="note_system.untitled_network"
    )


def _network_opening(note: NetworkNote) -> Iterator[Section]:
    rest, network = note.rest, note.case
    joints = sum(point.kind == "joint" for point in network.points)
    tension = note.tensions[note.most_loaded]
    said = Message(
        "note_first.network",
        lines=len(network.lines),
        points=len(network.points),
        joints=joints,
        line=note.most_loaded + 1,
        tension=about("tension", tension),
    )
    facts = (
        ("note_system.identity_lines", f"{len(network.lines)}"),
        ("note_system.identity_joints", f"{joints}"),
        ("note.identity_method", method_name(rest.lines[0].method)),
    )
    lies = max(line.grounded_length for line in rest.lines)
    return opening(
        note,
        facts,
        said,
        drawing=(
            Text(Message("note_system.network_plan_about")),
            Figure(network_plan(rest, note.most_loaded)),
        ),
        force=(Message("note_system.pull_on_body"), "horizontal_force", _pull(note)),
        reach=(Message("note_system.longest_on_bed"), "grounded_length", lies),
        tension=tension,
        in_motion=note.motion is not None,
        moved=note.motion_checks,
    )


def _pull(note: NetworkNote) -> float:
    """Sum the horizontal pull of the lines on the points of the body, N."""
    rest = note.rest
    pulls = [
        pull
        for run, ends in zip(rest.runs, rest.joints.ends, strict=True)
        for at, pull in ((run.first, ends.first), (run.second, ends.second))
        if note.case.points[at].kind == "fairlead"
    ]
    return math.hypot(*(math.fsum(pull[k] for pull in pulls) for k in (0, 1)))


def _joints(note: NetworkNote) -> Iterator[Block]:
    if note.rest.bodies:
        yield bodies_table(note.rest)
        yield from floating_tables(note.rest)
    yield from floats_tables(note.rest)
    yield from buoyancy_tables(note.rest)
    if any(point.kind == "joint" for point in note.case.points):
        yield joints_table(note.rest, "joints")
    if note.rest.bodies or any(point.kind == "joint" for point in note.case.points):
        found = note.rest.joints
        yield small("note_system.joints_about", left=found.residual, steps=found.steps)


def _network_line_out(note: NetworkNote) -> Iterator[Block]:
    """Tabulate what each line gone does, and say why the joints find no rest."""
    gone = note.line_out
    if not gone:
        return
    yield Text(Several(_about_line_out(note.rest), " "))
    yield network_out_table(gone, note.checks)
    yield from (Verdict(each.why_lost, passes=False) for each in gone if each.rest is None)


def _about_line_out(rest: LinesAtRest) -> Iterator[Message]:
    """Say what a line that is gone leaves free to move, and what is held."""
    yield Message("note_system.network_line_out_about")
    network, frees = rest.network, []
    if any(point.kind == "joint" for point in network.points):
        frees.append(Message("note_system.network_joints"))
    if network.bodies:
        names = ", ".join(body.name for body in network.bodies)
        frees.append(Message("note_system.network_bodies", names=names))
    if frees:
        yield Message("note_system.network_frees", frees=Several(frees, ", "))
    if rest.has_held_body:
        yield Message("note_system.network_held")
    yield Message("note_system.network_loose")


def _components(note: NetworkNote) -> Iterator[Block]:
    """Tabulate what each line is made of; those made alike once."""
    alike: dict[object, list[str]] = {}
    for number, run in enumerate(note.rest.runs, start=1):
        alike.setdefault(run.line, []).append(f"{number}")
    for line, numbers in alike.items():
        yield Text(Message("note_system.network_components", lines=", ".join(numbers)))
        yield from given_tables(line)  # type: ignore[arg-type]
