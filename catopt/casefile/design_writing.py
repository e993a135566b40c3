"""Writes ``[design]`` and the tables below it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from catopt.casefile.toml_text import flag, measured, measures, text, texts, whole
from catopt.model import ClumpWeightChoice, Design, SegmentChoice, SinkerChoice


def design_sections(design: Design) -> list[tuple[str, Iterable[str]]]:
    """List the sections of a design, each with its lines; ranges as their values."""
    return [
        ("[design]", _design(design)),
        *(("[[design.segments]]", _segment(each)) for each in design.segments),
        *(("[[design.clump_weights]]", _clump_weight(each)) for each in design.clump_weights),
        *((("[design.sinker]", _sinker(design.sinker)),) if design.sinker else ()),
    ]


def _design(design: Design) -> Iterator[str]:
    yield from texts("objectives", design.objectives)
    yield from text("method", design.method)
    for key in ("evaluations", "population", "seed", "max_enumerated"):
        yield from whole(key, getattr(design, key))


def _segment(choice: SegmentChoice) -> Iterator[str]:
    yield from text("name", choice.name)
    yield from texts("components", choice.components)
    yield from measures("diameters", choice.diameters, "m")
    yield from measured("diameter_min", choice.diameter_min, "m")
    yield from measured("diameter_max", choice.diameter_max, "m")
    yield from measures("lengths", choice.lengths, "m")
    yield from flag("optional", choice.optional)


def _clump_weight(choice: ClumpWeightChoice) -> Iterator[str]:
    yield from text("name", choice.name)
    yield from measures("masses", choice.masses, "kg")
    yield from measured("density", choice.density, "kg/m^3")
    yield from measures("positions", choice.positions, "m")
    yield from whole("joint", choice.joint)
    yield from measured("friction", choice.friction)
    yield from flag("optional", choice.optional)


def _sinker(choice: SinkerChoice) -> Iterator[str]:
    yield from measures("masses", choice.masses, "kg")
    yield from measured("density", choice.density, "kg/m^3")
    yield from measured("friction", choice.friction)
    yield from measured("safety_factor", choice.safety_factor)
