"""The programs that take lines at rest, and what each of them takes otherwise than the case."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Literal

from catopt.constants import STANDARD_GRAVITY
from catopt.decks.deck import Deck, Point
from catopt.export.deck import deck_of
from catopt.export.exported import Exported, Source, exported, heading
from catopt.export.exported_line import ExportedLines
from catopt.export.mappp import mappp_lines
from catopt.export.moordyn_model import Model, is_above, model_of
from catopt.export.moordyn_remarks import common_remarks
from catopt.export.moorpy_script import moorpy_lines
from catopt.export.ontology import ontology_lines
from catopt.export.orcaflex import orcaflex_lines
from catopt.words.message import Message

ProgramFormat = Literal["map", "moorpy", "ontology", "orcaflex"]


@dataclass(frozen=True)
class Program:
    """A program that takes lines at rest.

    `first`: what the file is; `lines`: from the deck, and what the file says of itself, to its
    lines; `remarks`: what the program takes otherwise; `true_depth`: whether all of a line weighs
    what it weighs in water, above the water too; for another program the depth is raised to the
    highest point of the lines.
    """

    name: str
    first: str
    lines: Callable[[Deck, Iterable[str]], Iterator[str]]
    remarks: Callable[[Model], Iterator[str]]
    true_depth: bool = False


def program_input(
    to: ProgramFormat, solved: ExportedLines, *, sources: Sequence[Source] = ()
) -> Exported:
    """Write lines for a program.

    `solved`: the lines where they hang; every segment has an EA; `sources`: what the case was read
    from. InputError: a segment does not stretch, or its mass is missing or too small, with every
    one; for the ontology, the anchor stands above the bed.

    Examples
    --------
    >>> import catopt
    >>> from catopt.export.exported_line import exported_lines
    >>> from catopt.export.programs import program_input
    >>> chain = catopt.Segment(60.0, 2100.0, EA=2e8, mass=246.0, name="chain")
    >>> load = catopt.Load(horizontal_force=1e5)
    >>> case = catopt.Case(catopt.Site(20.0), catopt.Line([chain]), load, 20.0)
    >>> program_input("map", exported_lines(case)).text.splitlines()[3][:15]
    'chain 0.1802653'
    """
    program = PROGRAMS[to]
    model = model_of(solved, true_depth=program.true_depth, program=program.name)
    remarks = (*common_remarks(model), *program.remarks(model), *_of_the_water(model))
    said = heading(program.first, solved, (), remarks, sources)
    text = "\n".join(program.lines(deck_of(model), said)) + "\n"
    return exported(to, solved, text, remarks, sources)


def _of_the_water(model: Model) -> Iterator[str]:
    """Say where the depth is not that of the case."""
    depth = model.solved.case.site.water_depth
    if is_above(model.solved) and model.surface > depth:
        height = model.solved.highest - depth
        yield Message("export.raised", height=height, depth=depth, raised=model.surface)


def _of_mappp(model: Model) -> Iterator[str]:
    site = model.solved.case.site
    yield Message(
        "export.map_place",
        gravity=STANDARD_GRAVITY,
        density=site.water_density,
        depth=site.water_depth,
    )
    bed = [point.name for point in deck_of(model).points.values() if _lies(point, model.surface)]
    if bed:
        yield Message("export.map_bed", nodes=", ".join(bed))


def _lies(point: Point, depth: float) -> bool:
    return point.end == "free" and point.z + depth <= 1e-9 * depth


def _of_moorpy(model: Model) -> Iterator[str]:
    if any(line.at_rest is not None for line in model.solved.lines):
        friction = model.solved.lines[0].solution.seabed_friction
        yield Message("export.no_friction", friction=friction)


def _of_ontology(model: Model) -> Iterator[str]:
    yield Message("export.ontology_keys")
    if is_above(model.solved):
        height = model.solved.highest - model.solved.case.site.water_depth
        yield Message("export.above", height=height)


def _of_orcaflex(model: Model) -> Iterator[str]:
    yield Message("export.orcaflex", contact=max(each.body.diameter for each in model.types))
    if any(joint.body.drag_area for part in model.parts for joint in part.joints):
        yield Message("export.orcaflex_clumps")


PROGRAMS: Mapping[ProgramFormat, Program] = MappingProxyType(
    {
        "map": Program("MAP++", "MAP++ input file", mappp_lines, _of_mappp, true_depth=True),
        "ontology": Program(
            "the ontology", "Floating array ontology", ontology_lines, _of_ontology, true_depth=True
        ),
        "orcaflex": Program("OrcaFlex", "OrcaFlex text data", orcaflex_lines, _of_orcaflex),
        "moorpy": Program("MoorPy", "MoorPy script", moorpy_lines, _of_moorpy),
    }
)
"""What `program_input` writes, by the name of its format."""
