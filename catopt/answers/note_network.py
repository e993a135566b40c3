"""What the note of lines between points consists of; its headings are those of a moored body."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import partial
from typing import TYPE_CHECKING

from catopt.answers import blocks
from catopt.answers.blocks import Block, Figure, Section, Text, Verdict, about
from catopt.answers.check import checked_body
from catopt.answers.note import inputs_table, note_answer, opening, section, small
from catopt.answers.note import damaged_section, network_basis_section
from catopt.answers.solution import given_tables, method_name
from catopt.answers.system import (
    bodies_table,
    floats_tables,
    joints_table,
    meeting_table,
    network_out_table,
)
from catopt.figures.mooring import network_plan, network_side
from catopt.words import Message

if TYPE_CHECKING:
    from catopt.notes.system import NetworkNote

_section = partial(section, group="note_system")


def network_note_answer(note: NetworkNote) -> blocks.Answer:
    """Lay out the note of lines between points."""
    sections = (
        *_opening(note),
        network_basis_section(note.sheet),
        _section("checks", _checks(note)),
        _section("line_out", _line_out(note)),
        _section("side", _side(note)),
        _section("joints", _joints(note)),
        _section("lines", _lines(note)),
        damaged_section(note.sheet),
        section("components", _components(note)),
        section("inputs", [Text(Message("note.inputs_about")), inputs_table(note.origin)]),
    )
    return note_answer(
        note, "note_system.kind_network", sections, untitled="note_system.untitled_network"
    )


def _opening(note: NetworkNote) -> Iterator[Section]:
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


def _side(note: NetworkNote) -> Iterator[Block]:
    yield Text(Message("note_system.side_about"))
    yield Figure(network_side(note.rest, note.most_loaded))


def _joints(note: NetworkNote) -> Iterator[Block]:
    if note.rest.bodies:
        yield bodies_table(note.rest)
    yield from floats_tables(note.rest)
    if any(point.kind == "joint" for point in note.case.points):
        yield joints_table(note.rest, "joints")
    if note.rest.bodies or any(point.kind == "joint" for point in note.case.points):
        found = note.rest.joints
        yield small("note_system.joints_about", left=found.residual, steps=found.steps)


def _lines(note: NetworkNote) -> Iterator[Block]:
    yield meeting_table(note.rest, "network_lines", note.checks, marked=note.most_loaded)
    yield small("note_system.network_lines_about")


def _checks(note: NetworkNote) -> Iterator[Block]:
    if note.checks.results:
        yield Text(Message("note_system.network_checks_about"))
        yield from checked_body(note.checks)
        yield small("note.checks_legend")


def _line_out(note: NetworkNote) -> Iterator[Block]:
    """Tabulate what each line gone does, and say why the joints find no rest."""
    gone = note.line_out
    if not gone:
        return
    yield Text(Message("note_system.network_line_out_about"))
    yield network_out_table(gone, note.checks)
    for each in gone:
        if each.rest is None:
            yield Verdict(each.why_lost, passes=False)


def _components(note: NetworkNote) -> Iterator[Block]:
    """Tabulate what each line is made of; those made alike once."""
    alike: dict[object, list[str]] = {}
    for number, run in enumerate(note.rest.runs, start=1):
        alike.setdefault(run.line, []).append(f"{number}")
    for line, numbers in alike.items():
        yield Text(Message("note_system.network_components", lines=", ".join(numbers)))
        yield from given_tables(line)  # type: ignore[arg-type]
