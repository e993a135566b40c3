"""What the equilibrium of a body on several lines consists of."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Literal

from catopt.answers.blocks import (
    Answer,
    Block,
    Column,
    Fact,
    Facts,
    Graph,
    Section,
    Table,
    Text,
    Verdict,
    Warnings,
    fact,
    measured,
    texts,
)
from catopt.answers.check import governing_sentence, verdict_sentence
from catopt.quantities import QUANTITIES
from catopt.words import Measure, Message

if TYPE_CHECKING:
    from catopt.checks.result import CheckReport
    from catopt.mooring.case import SystemReport
    from catopt.mooring.held import HeldBody
    from catopt.mooring.response import Response
    from catopt.mooring.restoring import RestoringCurve
    from catopt.mooring.watch_circle import WatchCircle

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


def system_answer(report: SystemReport, checks: CheckReport) -> Answer:
    """Lay out a moored body."""
    opening = (Text(_solved(report)), _body(report))
    return Answer(
        "system",
        report.case.title or Message("captions.moored_body"),
        (
            Section(Message("captions.body"), opening),
            Section(Message("captions.lines"), _lines(report, checks)),
            Section(Message("captions.checks"), tuple(_verdict(checks))),
            *_line_out(report),
            *_circle(report),
            *(_curve(number, each) for number, each in enumerate(report.curves, start=1)),
            *_levels(report),
            *(held_section(number, each) for number, each in enumerate(report.held, start=1)),
            Section(Message("captions.residuals"), tuple(_closing(report, checks))),
        ),
    )


def _solved(report: SystemReport) -> Message:
    freedom = "mooring.x_y_and_yaw" if report.solution.system.turns else "mooring.x_and_y"
    count = len(report.solution.lines)
    return Message("mooring.solved", count=count, freedom=Message(freedom))


def body_facts(report: SystemReport) -> list[Fact]:
    """List where the body is and how it is held."""
    solution = report.solution
    system, stiffness = solution.system, solution.stiffness
    facts = [
        Fact(Message("columns.title"), report.case.title, only="files"),
        fact("horizontal_force", system.force[0], "force_on_the_body_along_x", symbol=""),
        fact("horizontal_force", system.force[1], "force_on_the_body_along_y", symbol=""),
        fact("offset", solution.neutral.x, "zero_load_position_x"),
        fact("offset", solution.neutral.y, "zero_load_position_y"),
        fact("offset", solution.offset[0], "offset_along_x"),
        fact("offset", solution.offset[1], "offset_along_y"),
        fact("stiffness", stiffness[0][0], symbol="kxx"),
        fact("stiffness", stiffness[0][1], symbol="kxy"),
        fact("stiffness", stiffness[1][1], symbol="kyy"),
    ]
    if system.turns:
        facts[3:3] = [fact("moment", system.moment)]
        facts += [fact("angle", solution.position.yaw, "yaw", symbol="")]
    return facts


def _body(report: SystemReport) -> Facts:
    """List where the body is, how it is held, and what the rule of practice says."""
    solution, rule, facts = report.solution, report.rule, body_facts(report)
    if rule.horizontal_force is not None:
        assert rule.line is not None
        own = solution.lines[rule.line].horizontal_force
        for key, force in (("force_of_line", own), ("force_by_rule", rule.horizontal_force)):
            said = Message(f"columns.{key}", number=rule.line + 1)
            facts += [fact("horizontal_force", force, symbol="", said=said)]
    return Facts("body", tuple(facts), Message("captions.body"))


def lines_table(report: SystemReport, checks: CheckReport) -> Table:
    """Tabulate what each line carries, and how far it is used by the strictest check."""
    solution = report.solution
    lines = solution.lines
    own = [line.solution for line in lines]
    used = [checks.used(line=number) for number in range(1, len(lines) + 1)]
    if all(value is None for value in used):
        used = [line.utilisation() for line in lines]
    columns = [
        texts("line", range(1, len(lines) + 1)),
        measured("angle", (line.leg.azimuth for line in lines), "azimuth", symbol=""),
        measured("span", (each.span for each in own)),
        measured("horizontal_force", (line.horizontal_force for line in lines)),
        measured("tension", (line.tension for line in lines), "fairlead_tension"),
        measured("tension", (each.anchor.tension for each in own), "anchor_tension", symbol="TA"),
        measured("grounded_length", (each.grounded_length for each in own)),
    ]
    if any(value is not None for value in used):
        columns.append(measured("utilisation", used))
    return Table("lines", tuple(columns), Message("captions.lines"))


def lines_used(checks: CheckReport) -> Message:
    """Say what the utilisation of a line is of."""
    judged = checks.used() is not None
    return Message("mooring.used_by_checks" if judged else "mooring.used_of_MBL")


def _lines(report: SystemReport, checks: CheckReport) -> tuple[Block, ...]:
    table = lines_table(report, checks)
    if table.columns[-1].quantity is not QUANTITIES["utilisation"]:
        return (table,)
    return table, Text(lines_used(checks), only="people", is_small=True)


def _verdict(checks: CheckReport) -> Iterator[Block]:
    yield Verdict(verdict_sentence(checks), checks.passes)
    if checks.results:
        yield Text(governing_sentence(checks))
        yield Text(Message("mooring.all_checks"), only="people", is_small=True)


def line_out_table(report: SystemReport) -> Table:
    """Tabulate what happens when each line is gone."""
    gone = report.line_out
    return Table(
        "line_out",
        (
            texts("line_out", [each.missing + 1 for each in gone]),
            *_responses([each.response for each in gone]),
            texts("refusal", [each.refusal for each in gone], only="files"),
        ),
        Message("captions.one_line_out"),
    )


def _line_out(report: SystemReport) -> Iterator[Section]:
    if not report.line_out:
        return
    lost = tuple(
        Text(Message("mooring.lost", number=each.missing + 1, refusal=each.refusal))
        for each in report.line_out
        if each.response is None
    )
    title = Message("captions.one_line_out")
    yield Section(title, (line_out_table(report), *lost))


def circle_table(circle: WatchCircle) -> Table:
    """Tabulate where the force takes the body as it goes round."""
    return Table(
        "watch_circle",
        (
            measured("angle", circle.directions, "direction", symbol=""),
            *_responses(circle.responses),
        ),
        Message("captions.circle", force=Measure("horizontal_force", circle.force)),
        tuple(range(0, len(circle.directions), _EVERY)),
    )


def _circle(report: SystemReport) -> Iterator[Section]:
    if report.circle is not None:
        yield Section(Message("captions.watch_circle"), (circle_table(report.circle),))


def curve_table(number: int, curve: RestoringCurve) -> Table:
    """Tabulate force and offset along one direction."""
    rows = len(curve.offset)
    return Table(
        f"restoring_{number}",
        (
            measured("angle", [curve.direction] * rows, "direction", symbol="", only="files"),
            measured("offset", curve.offset),
            measured("horizontal_force", curve.force, "force_along_the_direction", symbol=""),
            measured("horizontal_force", curve.force_across, "force_across_it", symbol=""),
            measured(
                "tension",
                [each.largest_tension for each in curve.responses],
                "largest_tension",
                symbol="",
            ),
            texts("in_line", [each.most_loaded + 1 for each in curve.responses]),
        ),
        Message("captions.held", angle=Measure("angle", curve.direction)),
        tuple(range(0, rows, _CURVE_EVERY)),
    )


def _curve(number: int, curve: RestoringCurve) -> Section:
    table, title = curve_table(number, curve), Message("captions.restoring", number=number)
    return Section(title, (table, Graph(title, table.name, x=1, y=(2,))))


def _levels(report: SystemReport) -> Iterator[Section]:
    """Tabulate what the water level changes."""
    levels = report.levels
    if not levels:
        return
    columns = (
        measured("height", [each.level for each in levels], "water_level", symbol=""),
        *_responses([each.response for each in levels]),
        measured("stiffness", [each.stiffness[0][0] for each in levels], symbol="kxx"),
    )
    title = Message("captions.water_levels")
    yield Section(title, (Table("water_levels", columns, title),))


def held_section(number: int, body: HeldBody) -> Section:
    """Lay out what the lines do to a body that is held: load and stiffness in six freedoms."""
    title = Message("captions.held_body", number=number)
    at = {
        name: Measure("offset" if k < 3 else "angle", value)
        for k, (name, value) in enumerate(body.by_freedom.items())
    }
    height = Measure("height", body.origin_height)
    load = Facts(
        f"held_{number}_load",
        tuple(
            fact("horizontal_force" if k < 3 else "moment", body.load[k], name, symbol=symbol)
            for k, (name, symbol) in enumerate(_LOADS.items())
        ),
        Message("captions.held_load"),
    )
    return Section(
        title,
        (
            Text(Message("mooring.held_at", **at)),
            Text(Message("mooring.held_about", height=height)),
            load,
            _stiffness(f"held_{number}_forces", body, 0),
            _stiffness(f"held_{number}_moments", body, 3),
        ),
    )


def _stiffness(name: str, body: HeldBody, first: Literal[0, 3]) -> Table:
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
    return Table(name, tuple(columns), Message(f"captions.{caption}"))


def _responses(responses: Iterable[Response | None]) -> tuple[Column, ...]:
    rows = list(responses)

    def of(name: str) -> list[float | None]:
        return [None if row is None else getattr(row, name) for row in rows]

    return (
        measured("offset", of("x"), "position", symbol="x"),
        measured("offset", of("y"), "position", symbol="y"),
        measured("offset", of("offset")),
        measured("tension", of("largest_tension"), "largest_tension", symbol=""),
        texts("in_line", [None if row is None else row.most_loaded + 1 for row in rows]),
        measured("grounded_length", of("least_grounded"), "shortest_grounded_length"),
    )


def _closing(report: SystemReport, checks: CheckReport) -> Iterator[Block]:
    """Say what is left of the balance, and what is to be known."""
    solution = report.solution
    if report.rule.horizontal_force is None:
        yield Text(Message("mooring.no_rule", why=report.rule.why_not))
    yield Text(Message("mooring.residual_of_forces", value=solution.residual.force))
    if solution.system.turns:
        yield Text(Message("mooring.residual_of_moments", value=solution.residual.moment))
    yield Warnings(tuple(dict.fromkeys((*solution.warnings, *checks.warnings))))
