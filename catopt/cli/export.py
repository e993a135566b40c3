"""``catopt export``: the lines of a case as the input of another program."""

from __future__ import annotations

from typing import Annotated, Literal, get_args

import typer

from catopt.casefile.reading import DESIGN_CASE, DESIGN_DOCUMENT, read_mooring_or_design
from catopt.cli.answering import Asked, answering
from catopt.cli.options import CaseArgument, CountOption, DesignOption, LoadCaseOption, PlaceOption
from catopt.cli.values import in_state, positive, refused, with_known_codes
from catopt.errors import InputError, Problem
from catopt.export.export_result import Source, exported_lines, rigid_segments
from catopt.model.kinds import Findings
from catopt.notes.origin import file_name, read_source
from catopt.units import Dimension
from catopt.words import Message

Target = Literal["moordyn", "map", "moorpy", "ontology", "orcaflex", "dxf"]
"""What reads the file."""

_ENDINGS = dict(
    zip(get_args(Target), (".txt", ".map", ".py", ".yaml", ".yml", ".dxf"), strict=True)
)
"""Of the file's name, where a directory is given."""

_FEWEST, _MOST = 2, 10000


@answering(PlaceOption, without=["lang", "units", "full"])
def export(
    asked: Asked,
    case: CaseArgument,
    to: Annotated[Target, typer.Option("--to", metavar="FORMAT")],
    design: DesignOption = None,
    load_case: LoadCaseOption = None,
    stiffness: Annotated[str | None, typer.Option("--EA", metavar="FORCE")] = None,
    elements: CountOption = None,
    true_depth: Annotated[bool, typer.Option("--true-depth")] = False,
) -> None:
    """Write the line of a case, or the lines of its body, for another program."""
    from catopt.export.drawing import dxf_drawing
    from catopt.export.moordyn import moordyn_input
    from catopt.export.moordyn_model import ELEMENTS
    from catopt.export.programs import program_input

    EA = _settings(to, stiffness, elements, true_depth=true_depth)
    whole = with_known_codes(read_mooring_or_design(case, design))
    read = in_state(whole, load_case)
    paths = [case] if design is None else [case / DESIGN_CASE, case / DESIGN_DOCUMENT]
    files = [read_source(path) for path in paths]
    sources = tuple(Source(file.name, file.sha256) for file in files)
    # Refuse a line without EA where it needs one, and an EA that no segment needs.
    rigid = rigid_segments(read)
    if EA is not None and not rigid:
        raise refused("--EA", str(stiffness), Message("refused_command.every_segment_has_own_ea"))
    if EA is None and rigid and to != "dxf":
        allowed = Message("refused_command.missing_wants_give_segment_ea", to=to)
        raise InputError([Problem(f"{key}.EA", "", allowed) for key in rigid], f"--to {to}")
    lines = exported_lines(read, EA)
    if to == "dxf":
        found = dxf_drawing(lines, whole=whole, sources=sources)
    elif to == "moordyn":
        found = moordyn_input(
            lines, elements=elements or ELEMENTS, true_depth=true_depth, sources=sources
        )
    else:
        found = program_input(to, lines, sources=sources)
    name = file_name(case, design).removesuffix(".html") + _ENDINGS[to]
    asked.give_file(name, found.text, found.to_dict, found.remarks, keep=case)


def _settings(
    to: Target, stiffness: str | None, elements: int | None, *, true_depth: bool
) -> float | None:
    """Check the options and return EA; everything that is wrong with them is reported at once."""
    found = Findings("options")
    EA = positive(found, "--EA", stiffness, Dimension.FORCE)
    if elements is not None:
        found.number("--elements", elements, "", at_least=_FEWEST, at_most=_MOST)
    if to != "moordyn":
        only = Message("refused_command.goes_with_moordyn_leave_out")
        if elements is not None:
            found.add("--elements", str(elements), only)
        if true_depth:
            found.add("--true-depth", "", only)
    found.raise_if_any()
    return EA
