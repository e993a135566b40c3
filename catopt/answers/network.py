"""What lines that meet in joints consist of at rest."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from catopt.answers.blocks import Answer, Section, Table, Text, measured, texts
from catopt.answers.system import held_section
from catopt.words import Message

if TYPE_CHECKING:
    from catopt.mooring.held import NetworkAtRest

__all__ = ["network_answer"]


def network_answer(
    rest: NetworkAtRest, held: Sequence[NetworkAtRest], *, with_stiffness: bool
) -> Answer:
    """Lay out the joints and the lines with the body in place, and where it is held."""
    network = rest.network
    joints = sum(point.kind == "joint" for point in network.points)
    title = network.title or Message("captions.moored_body")
    solved = Message("mooring.joints_solved", lines=len(network.lines), joints=joints)
    sections = [
        Section(Message("captions.joints"), (Text(solved), _joints(rest, "joints"))),
        Section(Message("captions.lines"), (_lines(rest, "lines"),)),
    ]
    bodies = [rest.body] if with_stiffness else []
    bodies += [each.body for each in held]
    sections += (held_section(number, body) for number, body in enumerate(bodies, start=1))
    for number, each in enumerate(held, start=1 + with_stiffness):
        tables = (_joints(each, f"held_joints_{number}"), _lines(each, f"held_lines_{number}"))
        sections.append(Section(Message("captions.held_lines", number=number), tables))
    residual = max(each.joints.residual for each in (rest, *held))
    closing = Text(Message("mooring.residual_of_joints", value=residual))
    sections.append(Section(Message("captions.residuals"), (closing,)))
    return Answer("network", title, tuple(sections))


def _joints(rest: NetworkAtRest, name: str) -> Table:
    places = [
        (point, place, reaction)
        for point, place, reaction in zip(
            rest.network.points, rest.joints.places, rest.joints.reactions, strict=True
        )
        if point.kind == "joint"
    ]
    columns = (
        texts("point", [point.name for point, _, _ in places]),
        measured("offset", [place[0] for _, place, _ in places], "position", symbol="x"),
        measured("offset", [place[1] for _, place, _ in places], "position", symbol="y"),
        measured("height", [place[2] for _, place, _ in places], symbol="z"),
        measured("vertical_force", [point.submerged_weight for point, _, _ in places],
                 "weight_in_water", symbol=""),
        measured("vertical_force", [reaction for _, _, reaction in places],
                 "reaction_of_the_bed", symbol=""),
    )  # fmt: skip
    return Table(name, columns, Message("captions.joints"))


def _lines(rest: NetworkAtRest, name: str) -> Table:
    points, lines = rest.network.points, rest.lines
    columns = [
        texts("line", [run.name for run in rest.runs]),
        texts("from_point", [points[run.first].name for run in rest.runs]),
        texts("to_point", [points[run.second].name for run in rest.runs]),
        measured("span", [line.span for line in lines]),
        measured("horizontal_force", [line.horizontal_force for line in lines]),
        measured("tension", [line.anchor.tension for line in lines], "tension_there", symbol="T1"),
        measured("tension", [line.fairlead.tension for line in lines], "tension_here", symbol="T2"),
        measured("grounded_length", [line.grounded_length for line in lines]),
    ]
    used = [
        max((u for each in line.segments if (u := each.utilisation()) is not None), default=None)
        for line in lines
    ]
    if any(each is not None for each in used):
        columns.append(measured("utilisation", used))
    return Table(name, tuple(columns), Message("captions.lines"))
