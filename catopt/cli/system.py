"""``catopt system``: a body moored by several lines."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from catopt.cli.options import DesignOption, JsonOption, LangOption, OutOption, ReportLanguage

if TYPE_CHECKING:
    from catopt.cli.result_files import Asked
    from catopt.model.network import Network
    from catopt.units import Dimension


def system(
    context: typer.Context,
    case: Annotated[
        Path,
        typer.Argument(
            metavar="CASE",
            help="Case file (TOML) with [system]; with --design a directory that catopt design "
            "--out wrote.",
        ),
    ],
    design: DesignOption = None,
    line_out: Annotated[
        bool,
        typer.Option("--line-out", help="Also take each line away in turn, under the same load."),
    ] = False,
    watch_circle: Annotated[
        bool,
        typer.Option(
            "--watch-circle", help="Also let a force of the same size act from all sides."
        ),
    ] = False,
    curve: Annotated[
        list[str] | None,
        typer.Option(
            metavar="ANGLE",
            help='Also the restoring curve in this direction, such as "180 deg", '
            "counter-clockwise from x; several may be given.",
        ),
    ] = None,
    level: Annotated[
        list[str] | None,
        typer.Option(
            metavar="HEIGHT",
            help='Also at this water level, such as "-1.5 m" below that of the case; the body '
            "floats up and down with it. Several may be given.",
        ),
    ] = None,
    stiffness: Annotated[
        bool,
        typer.Option(
            "--stiffness",
            help="Also load and stiffness of the lines in six freedoms, about the waterline, where "
            "the body rests.",
        ),
    ] = False,
    held: Annotated[
        list[str] | None,
        typer.Option(
            metavar="SIX",
            help="The same where the body is held: surge, sway, heave, roll, pitch and yaw, such "
            'as "5 m, 0, 0, 0, 2 deg, 0". Several may be given.',
        ),
    ] = None,
    lang: LangOption = ReportLanguage.ENGLISH,
    as_json: JsonOption = False,
    out: OutOption = None,
) -> None:
    """Find where a moored body comes to rest, and what each of its lines carries.

    Prints the zero-load position, the offset under the load, the stiffness, a table of the lines,
    whether all checks pass, and what else is asked for, with the residual of the balance.

    Of a file with [[points]] and [[lines]], whose lines meet in free joints, where the joints come
    to rest and what every line carries, with the body in place and where --held puts it.
    """
    from catopt.answers.system import system_answer
    from catopt.casefile import read_mooring
    from catopt.casefile.design_directory import read_case_or_design
    from catopt.checks.system import check_system
    from catopt.cli.result_files import Asked
    from catopt.model.network import Network
    from catopt.mooring.case import report_system
    from catopt.report.bundle import system_pictures
    from catopt.units import Dimension
    from catopt.words import Message, say

    asked = Asked(context.obj, lang, as_json, out)
    directions = _in_si("--curve", curve or [], Dimension.ANGLE)
    levels = _in_si("--level", level or [], Dimension.LENGTH)
    displacements = [_displacement(text) for text in held or []]
    is_design = design is not None or case.is_dir()
    read = read_case_or_design(case, design) if is_design else read_mooring(case)
    if isinstance(read, Network):
        given = {
            "--line-out": line_out,
            "--watch-circle": watch_circle,
            "--curve": directions,
            "--level": levels,
        }
        _refuse_with_joints([option for option, value in given.items() if value])
        _network(asked, read, displacements, with_stiffness=stiffness)
        return
    report = report_system(
        read,
        with_line_out=line_out,
        with_circle=watch_circle,
        directions=directions,
        levels=levels,
        with_stiffness=stiffness,
        displacements=displacements,
    )
    checks = check_system(read, report)
    if watch_circle and report.circle is None:
        asked.output.note(say(Message("mooring.no_circle"), lang.value))

    def document() -> dict[str, Any]:
        return report.to_dict() | {"checks": checks.verdict_document()}

    asked.give(system_answer(report, checks), document, read, partial(system_pictures, report))


def _refuse_with_joints(options: list[str]) -> None:
    """Refuse options that are not evaluated where lines meet in joints."""
    from catopt.errors import InputError, Problem

    allowed = "does not go with lines that meet in joints: their body is held; leave it out"
    if options:
        raise InputError([Problem(option, "", allowed) for option in options], "options")


def _network(
    asked: Asked,
    network: Network,
    displacements: list[tuple[float, ...]],
    *,
    with_stiffness: bool,
) -> None:
    """Answer for lines that meet in joints, the body in place and where it is to be held."""
    from catopt.answers.network import network_answer
    from catopt.mooring.held import hold, network_document

    rest, *held = [hold(network, each) for each in ((0.0,) * 6, *displacements)]
    answer = network_answer(rest, held, with_stiffness=with_stiffness)
    asked.give(answer, lambda: network_document([rest, *held]))


def _in_si(option: str, texts: list[str], dimension: Dimension) -> list[float]:
    from catopt.cli.values import in_si

    return [in_si({option: (text, dimension)})[option] for text in texts]


def _displacement(text: str) -> tuple[float, ...]:
    """Read six values of a displacement: three lengths, three angles."""
    from catopt.cli.values import in_si
    from catopt.errors import InputError, Problem
    from catopt.mooring.held import FREEDOMS
    from catopt.units import Dimension

    parts = [each.strip() for each in text.split(",")]
    if len(parts) != len(FREEDOMS):
        wanted = f"must be six values with commas between them: {', '.join(FREEDOMS)}"
        raise InputError([Problem("--held", repr(text), wanted)], "options")
    dimensions = (Dimension.LENGTH,) * 3 + (Dimension.ANGLE,) * 3
    given = {
        f"--held, {name}": (part, dimension)
        for name, part, dimension in zip(FREEDOMS, parts, dimensions, strict=True)
    }
    return tuple(in_si(given).values())
