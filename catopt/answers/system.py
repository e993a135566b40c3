"""What the equilibrium of a body on several lines consists of; and of points, lines and bodies."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Literal

from catopt.answers import blocks
from catopt.answers.blocks import (
    Rows,
    fact,
    if_known,
    largest,
    measured,
    section,
    stated,
    tabulate,
    texts,
)
from catopt.answers.check import first_blocks, verdict_blocks, verdict_column
from catopt.answers.floats import (
    afloat_on_card,
    buoyancy_tables,
    floating_tables,
    floats_on_card,
    floats_tables,
)
from catopt.answers.places import hung_on_card, if_free, legs_tables, places_tables
from catopt.answers.solution import current_in_words, forces_at_ends
from catopt.checks.result import AtLevels
from catopt.quantities import QUANTITIES
from catopt.words import Measure, Message

if TYPE_CHECKING:
    from catopt.checks.result import CheckReport
    from catopt.mooring.case import AtLevel, SystemReport
    from catopt.mooring.network_out import NetworkOut
    from catopt.mooring.network_rest import (
        HeldBody,
        LinesAtRest,
        NetworkAtRest,
    )
    from catopt.mooring.restoring import Response, RestoringCurve, WatchCircle
    from catopt.mooring.solution import SystemSolution

_EVERY = 10
"""One direction of the watch circle in so many is shown: 30 degrees."""
_CURVE_EVERY = 2


_LOADS = {
    "along_x": "Fx",
    "along_y": "Fy",
    "along_z": "Fz",
    "about_x": "Mx",
    "about_y": "My",
    "about_z": "Mz",
}
"""Components of the lines' load on a body, and their symbols."""


def system_answer(
    report: SystemReport, checks: CheckReport, at_levels: AtLevels | None = None
) -> blocks.Answer:
    """Lay out a moored body; `at_levels`: with the checks of other water levels."""
    everywhere = at_levels or AtLevels(checks, ())
    freedom = "mooring.x_y_and_yaw" if report.solution.system.turns else "mooring.x_and_y"
    count, circle = len(report.solution.lines), report.circle
    solved = Message("mooring.solved", count=count, freedom=Message(freedom))
    table = lines_table(report.solution, checks)
    lines: list[blocks.Block] = [table, *legs_tables(report.solution)]
    if table.columns[-1].quantity is QUANTITIES["utilisation"]:
        lines.append(blocks.Text(lines_used(checks), only="people", is_small=True))
    lost = map(blocks.Text, lines_lost(report))
    judged = blocks.Text(Message("mooring.all_checks"), only="people", is_small=True)
    whole = blocks.answered(
        "system",
        report.case.title or Message("captions.moored_body"),
        section("captions.body", blocks.Text(solved), _body(report)),
        section("captions.lines", *lines),
        section(
            "captions.checks",
            *verdict_blocks(everywhere.whole),
            *([judged] if checks.results else []),
        ),
        *(
            [section("captions.one_line_out", line_out_table(report), *lost)]
            if report.line_out
            else []
        ),
        *([section("captions.watch_circle", circle_table(circle))] if circle else []),
        *(_curve(number, each) for number, each in enumerate(report.curves, start=1)),
        *_levels(report.levels, everywhere.others),
        *(fixed_section(*each) for each in enumerate(report.at_displacement, start=1)),
        section("captions.residuals", *_closing(report, everywhere.whole)),
    )
    return replace(whole, card=tuple(_card(report, checks, everywhere, solved)))


def _card(
    report: SystemReport, checks: CheckReport, everywhere: AtLevels, solved: Message
) -> Iterator[blocks.CardBlock]:
    """Say what the checks come to, where the body is, what its lines carry, and what was asked."""
    # With symbols, which tell apart facts of one name: a stiffness along x, and along y.
    known = tuple(
        replace(each, name=blocks.labelled(each.name, each.quantity.symbol))
        for each in body_facts(report.solution)
        if each.only != "files" and each.value and each.quantity is not None
    )
    yield from verdict_blocks(everywhere.whole)
    body = blocks.Facts("body", known, Message("captions.body"))
    asked, lines = list(_asked(report, everywhere)), lines_table(report.solution, checks)
    yield from asked
    yield from (lines, body) if asked else (body, lines)
    *_, shapes = legs_tables(report.solution)
    yield from hung_on_card(each.placed_loads for each in report.solution.lines)
    yield from if_free(shapes, [each.solution for each in report.solution.lines])
    for block in _closing(report, everywhere.whole):
        if isinstance(block, blocks.Warnings):
            yield from blocks.briefly(block.said, blocks.TO_BE_KNOWN, 3)
    yield blocks.Brief((solved,))


def _asked(report: SystemReport, everywhere: AtLevels) -> Iterator[blocks.Table]:
    """Yield the tables of what was asked beside the equilibrium."""
    if report.line_out:
        yield line_out_table(report)
    if report.circle is not None:
        yield circle_table(report.circle)
    yield from (curve_table(number, each) for number, each in enumerate(report.curves, start=1))
    held = (fixed_section(*each) for each in enumerate(report.at_displacement, start=1))
    for of in (*_levels(report.levels, everywhere.others), *held):
        yield from (each for each in of.blocks if isinstance(each, blocks.Table))


def solved_system(solution: SystemSolution) -> blocks.Answer:
    """Lay out the equilibrium of a body alone, without what is asked of its case."""
    return blocks.answered(
        "system",
        solution.title or Message("captions.moored_body"),
        section("captions.lines", lines_table(solution), *legs_tables(solution)),
        section("captions.body", blocks.Facts("body", tuple(body_facts(solution)))),
        section("captions.residuals", blocks.Warnings(tuple(solution.warnings))),
    )


def body_facts(solution: SystemSolution) -> list[blocks.Fact]:
    """List where the body is and how it is held."""
    system, stiffness = solution.system, solution.stiffness
    return [
        stated("title", solution.title, only="files"),
        fact("horizontal_force", system.force[0], "force_on_the_body_along_x", symbol=""),
        fact("horizontal_force", system.force[1], "force_on_the_body_along_y", symbol=""),
        *([fact("moment", system.moment)] if system.turns else []),
        fact("offset", solution.neutral.x, "zero_load_position_x"),
        fact("offset", solution.neutral.y, "zero_load_position_y"),
        fact("offset", solution.offset[0], "offset_along_x"),
        fact("offset", solution.offset[1], "offset_along_y"),
        fact("stiffness", stiffness[0][0], symbol="kxx"),
        fact("stiffness", stiffness[0][1], symbol="kxy"),
        fact("stiffness", stiffness[1][1], symbol="kyy"),
        *([fact("angle", solution.position.yaw, "yaw", symbol="")] if system.turns else []),
    ]


def _body(report: SystemReport) -> blocks.Facts:
    """List where the body is, how it is held, and what the rule of practice says."""
    solution, rule, facts = report.solution, report.rule, body_facts(report.solution)
    if rule.horizontal_force is not None:
        assert rule.line is not None
        own = solution.lines[rule.line].horizontal_force
        for key, force in (("force_of_line", own), ("force_by_rule", rule.horizontal_force)):
            said = Message(f"columns.{key}", number=rule.line + 1)
            facts.append(fact("horizontal_force", force, said, symbol=""))
    return blocks.Facts("body", tuple(facts), Message("captions.body"))


def lines_table(solution: SystemSolution, checks: CheckReport | None = None) -> blocks.Table:
    """Tabulate what each line carries, and how far it is used by the strictest check."""
    lines = solution.lines
    of = Rows(lines)
    numbers = range(1, len(lines) + 1)
    return tabulate(
        "lines",
        texts("line", numbers),
        of.measured("angle", "leg.azimuth", "azimuth", symbol=""),
        of.measured("span", "solution.span"),
        *forces_at_ends(
            Rows(of.read("solution")), "anchor_horizontal_force", "fairlead_horizontal_force"
        ),
        of.measured("tension", "tension", "fairlead_tension"),
        of.measured("tension", "solution.anchor.tension", "anchor_tension", symbol="TA"),
        of.measured("grounded_length", "solution.grounded_length"),
        *_utilisation(checks, [line.utilisation() for line in lines]),
        caption=Message("captions.lines"),
    )


def _utilisation(
    checks: CheckReport | None, of_MBL: Sequence[float | None]
) -> Iterator[blocks.Column]:
    """Say how far each line is used: by its checks, or else of its MBL; nothing if unknown."""
    used = [checks.used(line=k) if checks else None for k in range(1, len(of_MBL) + 1)]
    return if_known(measured("utilisation", of_MBL if set(used) == {None} else used))


def lines_used(checks: CheckReport) -> Message:
    """Say what the utilisation of a line is of."""
    judged = checks.used() is not None
    return Message("mooring.used_by_checks" if judged else "mooring.used_of_MBL")


def line_out_table(report: SystemReport) -> blocks.Table:
    """Tabulate what happens when each line is gone."""
    of = Rows(report.line_out)
    return tabulate(
        "line_out",
        of.texts("line_out", lambda each: each.missing + 1),
        *_responses(of.read("response")),
        of.texts("refusal", only="all" if any(of.read("refusal")) else "files"),
        caption=Message("captions.one_line_out"),
    )


def lines_lost(report: SystemReport) -> Iterator[Message]:
    """Say of each line without which there is no equilibrium why that is."""
    for each in report.line_out:
        if each.response is None:
            yield Message("mooring.lost", number=each.missing + 1, refusal=each.refusal)


def circle_table(circle: WatchCircle) -> blocks.Table:
    """Tabulate where the force takes the body as it goes round."""
    return tabulate(
        "watch_circle",
        measured("angle", circle.directions, "direction", symbol=""),
        *_responses(circle.responses),
        caption=Message("captions.circle", force=Measure("horizontal_force", circle.force)),
        shown=tuple(range(0, len(circle.directions), _EVERY)),
    )


def curve_table(number: int, curve: RestoringCurve) -> blocks.Table:
    """Tabulate force and offset along one direction."""
    rows = len(curve.offset)
    of = Rows(curve.responses)
    return tabulate(
        f"restoring_{number}",
        measured("angle", [curve.direction] * rows, "direction", symbol="", only="files"),
        measured("offset", curve.offset),
        measured("horizontal_force", curve.force, "force_along_the_direction", symbol=""),
        measured("horizontal_force", curve.force_across, "force_across_it", symbol=""),
        of.measured("tension", "largest_tension", "largest_tension", symbol=""),
        of.texts("in_line", lambda each: each.most_loaded + 1),
        caption=Message("captions.held", angle=Measure("angle", curve.direction)),
        shown=tuple(range(0, rows, _CURVE_EVERY)),
    )


def _curve(number: int, curve: RestoringCurve) -> blocks.Section:
    table, title = curve_table(number, curve), Message("captions.restoring", number=number)
    return section(title, table, blocks.Graph(title, table.name, x=1, y=(2,)))


def _levels(levels: Sequence[AtLevel], checks: Sequence[CheckReport]) -> Iterator[blocks.Section]:
    """Tabulate the mooring at other water levels, with what its checks come to there."""
    judged = [each for each in checks if each.results]
    if levels:
        of, title = Rows(levels), Message("captions.water_levels")
        columns = (
            of.measured("height", "level", "water_level", symbol=""),
            *_responses(of.read("response")),
            *if_known(
                of.measured(
                    "stiffness", lambda each: each.stiffness[0][0], symbol="kxx", priority=1
                )
            ),
            *if_known(
                of.measured("height", "floating.draught", "draught", symbol="", only="files"),
                of.measured("height", "floating.freeboard", "freeboard", symbol=""),
                measured("utilisation", [each.used() for each in judged]),
            ),
            *([verdict_column(each.passes for each in judged)] if judged else []),
        )
        under = [
            f"{Measure('height', each.level)}"
            for each in levels
            if each.floating and each.floating.under
        ]
        said = (
            [blocks.Text(Message("mooring.under_at_levels", levels=", ".join(under)))]
            if under
            else []
        )
        yield section(title, *said, blocks.Table("water_levels", columns, title))


def fixed_section(number: int, body: HeldBody) -> blocks.Section:
    """Lay out what the lines do to a body that is held: load and stiffness in six freedoms."""
    at = {
        name: Measure("offset" if k < 3 else "angle", value)
        for k, (name, value) in enumerate(body.by_freedom.items())
    }
    height = Measure("height", body.origin_height)
    load = (
        fact("horizontal_force" if k < 3 else "moment", body.load[k], name, symbol=symbol)
        for k, (name, symbol) in enumerate(_LOADS.items())
    )
    return section(
        Message("captions.held_body", number=number),
        blocks.Text(Message("mooring.held_at", **at)),
        blocks.Text(Message("mooring.held_about", height=height)),
        blocks.Facts(f"held_{number}_load", tuple(load), Message("captions.held_load")),
        _stiffness(f"held_{number}_forces", body, 0),
        _stiffness(f"held_{number}_moments", body, 3),
    )


def _stiffness(name: str, body: HeldBody, first: Literal[0, 3]) -> blocks.Table:
    """Tabulate the rows of the forces (from 0) or of the moments (from 3): they differ in unit."""
    caption, shift, turn = {
        0: ("held_forces", "stiffness", "force_by_turning"),
        3: ("held_moments", "moment_by_shift", "moment_by_turning"),
    }[first]
    rows = slice(first, first + 3)
    columns = [texts("load_component", [*_LOADS.values()][rows])]
    columns += [
        measured(shift if k < 3 else turn, [row[k] for row in body.stiffness[rows]], way, symbol="")
        for k, way in enumerate(body.by_freedom)
    ]
    return blocks.Table(name, tuple(columns), Message(f"captions.{caption}"))


def _responses(responses: Iterable[Response | None]) -> tuple[blocks.Column, ...]:
    of = Rows(responses)
    return (
        of.measured("offset", "x", "position", symbol="x"),
        of.measured("offset", "y", "position", symbol="y"),
        *of.own("offset"),
        of.measured("tension", "largest_tension", "largest_tension", symbol=""),
        of.texts("in_line", lambda each: each.most_loaded + 1),
        of.measured("grounded_length", "least_grounded", "shortest_grounded_length"),
    )


def _closing(report: SystemReport, checks: CheckReport) -> Iterator[blocks.Block]:
    """Say what is left of the balance, and what is to be known."""
    solution = report.solution
    if report.rule.horizontal_force is None:
        yield blocks.Text(Message("mooring.no_rule", why=report.rule.why_not))
    yield blocks.Text(Message("mooring.residual_of_forces", value=solution.residual.force))
    if solution.system.turns:
        yield blocks.Text(Message("mooring.residual_of_moments", value=solution.residual.moment))
    yield blocks.Warnings(tuple(dict.fromkeys((*solution.warnings, *checks.warnings))))


# ------------------------------------------------------------------ points, lines and bodies


def network_answer(
    rest: LinesAtRest,
    held: Sequence[NetworkAtRest],
    checks: CheckReport,
    bodies: Sequence[HeldBody],
    *,
    line_out: Sequence[NetworkOut] = (),
    circle: WatchCircle | None = None,
    curves: Sequence[RestoringCurve] = (),
    levels: Sequence[AtLevel] = (),
    at_levels: AtLevels | None = None,
) -> blocks.Answer:
    """Lay out bodies, joints and lines at rest and where the body is held, with the stiffnesses."""
    everywhere = at_levels or AtLevels(checks, ())
    network = rest.network
    joints = sum(point.kind == "joint" for point in network.points)
    counts = {"lines": len(network.lines), "joints": joints, "bodies": len(rest.bodies)}
    kind = "joints" if network.has_fairlead else "joints_alone"
    kind = "network" if rest.bodies else kind
    solved = Message(f"mooring.{kind}_solved", **counts)
    if network.current_at_rest is not None:
        said = current_in_words(network.current_at_rest, network.site.water_depth)
        way = "floats" if network.has_lone_floats else "current"
        solved = Message(f"mooring.{way}_solved", current=said, **counts)
    tables = (
        (
            number,
            joints_table(each, f"held_joints_{number}"),
            meeting_table(each, f"held_lines_{number}"),
        )
        for number, each in enumerate(held, start=1 + len(bodies) - len(held))
    )
    bodies_tables = [bodies_table(rest), *floating_tables(rest)] if rest.bodies else []
    first = tuple(first_blocks(checks))
    moved = [section("captions.bodies", *first, *bodies_tables)] if rest.bodies else []
    residual = max(each.joints.residual for each in (rest, *held))
    out = network_out_table(line_out, checks)
    lost = (blocks.Text(each.why_lost) for each in line_out if each.rest is None)
    whole = blocks.answered(
        "network",
        network.title or Message("captions.moored_body"),
        *moved,
        section(
            "captions.joints",
            *(() if moved else first),
            blocks.Text(solved),
            *floats_tables(rest),
            *buoyancy_tables(rest),
            joints_table(rest, "joints"),
        ),
        section("captions.lines", meeting_table(rest, "lines", checks), *places_tables(rest)),
        section("captions.checks", *verdict_blocks(everywhere.whole)),
        *([section("captions.one_line_out", out, *lost)] if line_out else []),
        *([section("captions.watch_circle", circle_table(circle))] if circle else []),
        *(_curve(number, each) for number, each in enumerate(curves, start=1)),
        *_levels(levels, everywhere.others),
        *(fixed_section(number, body) for number, body in enumerate(bodies, start=1)),
        *(section(Message("captions.held_lines", number=k), *each) for k, *each in tables),
        section(
            "captions.residuals",
            blocks.Text(Message("mooring.residual_of_joints", value=residual)),
            blocks.Warnings(everywhere.whole.others),
        ),
    )
    *_, shapes = places_tables(rest)
    in_current = network.current_at_rest is not None  # then its joints are said by how they move
    card: tuple[blocks.CardBlock, ...] = (
        *first_blocks(everywhere.whole),
        *afloat_on_card(rest),
        *verdict_blocks(everywhere.whole),
        *([out] if line_out else []),
        *([circle_table(circle)] if circle else []),
        *(curve_table(number, each) for number, each in enumerate(curves, start=1)),
        *(
            each
            for of in _levels(levels, everywhere.others)
            for each in of.blocks
            if isinstance(each, blocks.Table | blocks.Text)
        ),
        *floats_on_card(rest),
        meeting_table(rest, "lines", checks),
        *([bodies_table(rest)] if rest.bodies else []),
        *hung_on_card(each.point_loads for each in rest.named_lines),
        *([] if in_current else [joints_table(rest, "joints")]),
        *if_free(shapes, rest.lines),
        *blocks.briefly(everywhere.whole.others, blocks.TO_BE_KNOWN, 3),
        blocks.Brief((solved,)),
    )
    return replace(whole, card=card)


def network_out_table(gone: Sequence[NetworkOut], checks: CheckReport) -> blocks.Table:
    """Tabulate what each line gone leaves to the others, by the strictest check where there is."""
    of = Rows(gone)
    return tabulate(
        "line_out",
        of.texts("line_out", lambda each: each.missing + 1),
        of.measured("tension", "largest_tension", "largest_tension", symbol=""),
        of.texts("in_line", "most_loaded_line"),
        *if_known(
            measured("utilisation", [checks.used(missing=each.missing + 1) for each in gone])
        ),
        of.texts("loose", lambda each: ", ".join(map(str, each.loose_lines))),
        of.texts("refusal", only="all" if any(of.read("refusal")) else "files"),
        caption=Message("captions.one_line_out"),
    )


def bodies_table(rest: LinesAtRest) -> blocks.Table:
    """Tabulate where free bodies lie, from where they lie without load, and how they are held."""
    of = Rows(rest.bodies)
    return tabulate(
        "bodies",
        of.texts("body", "body.name"),
        of.measured("offset", lambda each: each.offset[0], "offset_along_x"),
        of.measured("offset", lambda each: each.offset[1], "offset_along_y"),
        of.measured("angle", "position.yaw", "yaw", symbol=""),
        of.measured("stiffness", lambda each: each.stiffness[0][0], symbol="kxx"),
        of.measured("stiffness", lambda each: each.stiffness[1][1], symbol="kyy"),
        of.measured("offset", "position.x", "position", symbol="x"),
        of.measured("offset", "position.y", "position", symbol="y"),
        caption=Message("captions.bodies"),
    )


def joints_table(rest: LinesAtRest, name: str) -> blocks.Table:
    """Tabulate where joints lie, and what the bed carries of them."""
    found = zip(rest.network.points, rest.joints.places, rest.joints.reactions, strict=True)
    of = Rows(each for each in found if each[0].kind == "joint")
    return tabulate(
        name,
        of.texts("point", lambda each: each[0].name),
        of.measured("offset", lambda each: each[1][0], "position", symbol="x"),
        of.measured("offset", lambda each: each[1][1], "position", symbol="y"),
        of.measured("height", lambda each: each[1][2], symbol="z"),
        of.measured(
            "vertical_force", lambda each: each[0].submerged_weight, "weight_in_water", symbol=""
        ),
        of.measured("vertical_force", lambda each: each[2], "reaction_of_the_bed", symbol=""),
        caption=Message("captions.joints"),
    )


def meeting_table(
    rest: LinesAtRest, name: str, checks: CheckReport | None = None, marked: int | None = None
) -> blocks.Table:
    """Tabulate what each line carries, and how far it is used: by its checks, or else of MBL."""
    points, runs, of = rest.network.points, Rows(rest.runs), Rows(rest.lines)
    of_MBL = [largest(each.utilisation() for each in line.segments) for line in rest.lines]
    return tabulate(
        name,
        runs.texts("line", "name"),
        runs.texts("from_point", lambda run: points[run.first].name),
        runs.texts("to_point", lambda run: points[run.second].name),
        *of.own("span"),
        *forces_at_ends(of, "force_there", "force_here"),
        *(
            of.measured("tension", what, f"{name}{short}", symbol=symbol, only=only)
            for what, name, number in (
                ("anchor.tension", "tension_there", "T1"),
                ("fairlead.tension", "tension_here", "T2"),
            )
            for short, symbol, only in (("", number, "files"), ("_short", "", "people"))
        ),
        of.measured("grounded_length", "grounded_length", priority=1),
        *_utilisation(checks, of_MBL),
        caption=Message("captions.lines"),
        marked=marked,
    )
