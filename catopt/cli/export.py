"""``catopt export``: the lines of a case as the input of another program."""

from __future__ import annotations

from enum import StrEnum
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Annotated

import typer

from catopt.cli.options import CaseArgument, DesignOption, JsonOption

if TYPE_CHECKING:
    from catopt.cli.output import Output
    from catopt.export.exported import Exported, Source
    from catopt.model import Case


class Target(StrEnum):
    """What reads the file."""

    MOORDYN = "moordyn"
    MAP = "map"
    MOORPY = "moorpy"
    ONTOLOGY = "ontology"
    ORCAFLEX = "orcaflex"
    DXF = "dxf"


ENDINGS = MappingProxyType(
    {
        Target.MOORDYN: ".txt",
        Target.MAP: ".map",
        Target.MOORPY: ".py",
        Target.ONTOLOGY: ".yaml",
        Target.ORCAFLEX: ".yml",
        Target.DXF: ".dxf",
    }
)
"""Of the file's name, where a directory is given."""

_FEWEST, _MOST = 2, 10000
_ONLY_MOORDYN = "goes with --to moordyn; leave it out"


def export(
    context: typer.Context,
    case: CaseArgument,
    to: Annotated[
        Target,
        typer.Option(
            "--to",
            metavar="FORMAT",
            help="moordyn: input file of MoorDyn version 2, which MoorPy reads too. map: of MAP++. "
            "moorpy: Python script that builds the lines in MoorPy. ontology: floating array "
            "ontology (YAML). orcaflex: text data of OrcaFlex (YAML). dxf: drawing (R12, metres) "
            "for CAD programs.",
        ),
    ],
    design: DesignOption = None,
    load_case: Annotated[
        str | None,
        typer.Option(
            "--load-case",
            metavar="NAME",
            help="The line under this load case; when left out under [load], or the first one.",
        ),
    ] = None,
    stiffness: Annotated[
        str | None,
        typer.Option(
            "--EA",
            metavar="FORCE",
            help='Axial stiffness, such as "500 MN", of segments for which the case has none. '
            "All formats but dxf need it; the file says that it was given so.",
        ),
    ] = None,
    elements: Annotated[
        int | None,
        typer.Option(
            metavar="N",
            help="moordyn: about how many elements a line is cut into, from 2 to 10000; 50 when "
            "left out.",
        ),
    ] = None,
    true_depth: Annotated[
        bool,
        typer.Option(
            "--true-depth",
            help="moordyn: keep the water depth where a line reaches above the water. MoorDyn then "
            "lets that part weigh what it weighs in air; the closed form does not.",
        ),
    ] = False,
    as_json: JsonOption = False,
    out: Annotated[
        Path | None,
        typer.Option(
            "--out",
            metavar="PLACE",
            help="File to write, or a directory; on standard output when left out. A file of the "
            "same name is replaced.",
        ),
    ] = None,
) -> None:
    """Write the line of a case, or the lines of its body, for another program.

    The line is solved first, so that it stands in the file where it hangs. The file says what the
    closed form finds there and what the other program takes otherwise; that is also told on
    standard error.
    """
    from catopt.casefile.design_directory import read_case_or_design
    from catopt.cli.state import in_state, with_known_codes

    output: Output = context.obj
    EA = _settings(to, stiffness, elements, true_depth=true_depth)
    read = in_state(with_known_codes(read_case_or_design(case, design)), load_case)
    found = _exported(
        read, to, EA, elements, _sources(case, design), true_depth=true_depth, given=stiffness
    )
    path = None if out is None else _write(found, out, case, design, to)
    for remark in found.remarks:
        output.note(f"note: {remark}")
    if as_json:
        output.json(found.to_dict(path))
    elif path is None:
        output.file(found.text)
    else:
        output.file(f"{path}\n")  # as a whole: a path is not folded


def _settings(
    to: Target, stiffness: str | None, elements: int | None, *, true_depth: bool
) -> float | None:
    """Check the options and return EA; everything that is wrong with them is reported at once."""
    from catopt.cli.values import in_si
    from catopt.errors import InputError, Problem
    from catopt.model.validity import Findings
    from catopt.units import Dimension

    found = Findings("options")
    EA = None
    try:
        EA = in_si({"--EA": (stiffness, Dimension.FORCE)}).get("--EA")
    except InputError as error:
        found.problems += error.problems
    if EA is not None:
        found.number("--EA", EA, "N", above=0.0)
    if elements is not None:
        found.number("--elements", elements, "", at_least=_FEWEST, at_most=_MOST)
    if to is not Target.MOORDYN:
        if elements is not None:
            found.problems.append(Problem("--elements", str(elements), _ONLY_MOORDYN))
        if true_depth:
            found.problems.append(Problem("--true-depth", "", _ONLY_MOORDYN))
    found.raise_if_any()
    return EA


def _exported(
    case: Case,
    to: Target,
    EA: float | None,
    elements: int | None,
    sources: tuple[Source, ...],
    *,
    true_depth: bool,
    given: str | None,
) -> Exported:
    from catopt.export.exported_line import exported_lines, rigid_segments

    rigid = rigid_segments(case)
    _check_stiffness(rigid, EA, given, to)
    solved = exported_lines(case, EA)
    if to is Target.DXF:
        from catopt.export.dxf import dxf_drawing

        return dxf_drawing(solved, sources=sources)
    if to is not Target.MOORDYN:
        from catopt.export.programs import program_input

        return program_input(to.value, solved, sources=sources)  # type: ignore[arg-type]
    from catopt.export.moordyn import moordyn_input
    from catopt.export.moordyn_model import ELEMENTS

    return moordyn_input(
        solved, elements=elements or ELEMENTS, true_depth=true_depth, sources=sources
    )


def _check_stiffness(
    rigid: tuple[str, ...], EA: float | None, given: str | None, to: Target
) -> None:
    """Refuse a line without EA where it needs one, and an EA that no segment needs."""
    from catopt.errors import InputError, Problem

    if EA is not None and not rigid:
        allowed = "every segment has its own EA; leave it out"
        raise InputError([Problem("--EA", str(given), allowed)], "options")
    if EA is None and rigid and to is not Target.DXF:
        allowed = (
            f"missing; --to {to.value} wants it. Give the segment its EA in the case file, "
            'or one for this file with --EA "500 MN"; with 10,000 times the tension or more the '
            "line hardly stretches"
        )
        raise InputError([Problem(f"{key}.EA", "", allowed) for key in rigid], f"--to {to.value}")


def _sources(path: Path, design: int | None) -> tuple[Source, ...]:
    from catopt.casefile.design_directory import DESIGN_CASE, DESIGN_DOCUMENT
    from catopt.export.exported import Source
    from catopt.notes.origin import read_source

    names = [path] if design is None else [path / DESIGN_CASE, path / DESIGN_DOCUMENT]
    files = [read_source(name) for name in names]
    return tuple(Source(file.name, file.sha256) for file in files)


def _write(found: Exported, out: Path, case: Path, design: int | None, to: Target) -> str:
    """Write the file, whole or not at all, and return where."""
    from catopt.notes.origin import file_name
    from catopt.report.files import write_files

    folder, name = out.parent, out.name
    if out.is_dir() or not out.suffix:
        folder = out
        name = file_name(case, design).removesuffix(".html") + ENDINGS[to]
    (written,) = write_files(folder, {name: found.content}, keep=[case])
    return str(written)
