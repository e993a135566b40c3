"""S3, Table 2: the tanker's line with sinkers of 100 to 300 kN, which is not one equilibrium."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from catopt.model import Line, PointLoad, Segment
from catopt.reproduce.comparison import compare, study_of
from catopt.reproduce.equivalent_length import SinkerLine, sinker_line
from catopt.reproduce.interval import interval
from catopt.reproduce.items import Drawn, Input, Study
from catopt.reproduce.printed import Printed
from catopt.reproduce.published import Published, published
from catopt.units import UNITS, Dimension
from catopt.words import Message

if TYPE_CHECKING:
    from catopt.catenary.find import Found

NAME = "tanker_20m_sinker"

_KN = UNITS[Dimension.FORCE]["kN"]
_LENGTH = "line_length_m"
_TENSION = "fairlead_tension_kN"
_FORCES = (100.0, 1000.0)  # kN, where the force that a printed length needs is looked for


@dataclass(frozen=True)
class _Row:
    """One row of Table 2: the sinker's weight, kN, and what was printed for it."""

    method: str
    weight: float
    printed: dict[str, Printed]


def study() -> Study:
    """Find the true equilibria beside Table 2, and what its columns can be made from."""
    source = published(NAME)
    rows = _rows(source)
    found = [_equilibrium(source, row.weight) for row in rows]
    return study_of(
        source,
        inputs=_inputs(source),
        items=tuple(
            item
            for row, line in zip(rows, found, strict=True)
            for item in compare(source, row.method, _numbers(line))
        ),
        findings=(
            _about_the_load(source, rows),
            _about_other_forces(source, rows),
            _about_the_lengths(source, rows),
            _about_the_tensions(source, rows),
        ),
        drawn=[Drawn(row.method, line.solution) for row, line in zip(rows, found, strict=True)],
    )


def _rows(source: Published) -> list[_Row]:
    weights = source.series["sinker_weight_kN"]
    methods = [Message("reproduce.sinker_kn", weight=weight) for weight in weights]
    return [
        _Row(method, weight, source.printed[method])
        for method, weight in zip(methods, weights, strict=True)
    ]


def _inputs(source: Published) -> tuple[Input, ...]:
    given = source.inputs
    weights = ", ".join(f"{weight:g}" for weight in source.series["sinker_weight_kN"])
    return (
        Input("water depth = fairlead height", f"{given['water_depth_m']:g}", "m"),
        Input("submerged weight, inextensible", f"{given['submerged_weight_N_per_m']:g}", "N/m"),
        Input("horizontal force", f"{given['horizontal_force_kN']:g}", "kN"),
        Input("sinkers", weights, "kN", "printed; taken as submerged weights"),
        Input("sinker, along the line from the anchor", f"{given['sinker_position_m']:g}", "m"),
        Input("inclination at the anchor", "0", "rad", "the condition for the line length"),
    )


def _equilibrium(source: Published, weight: float) -> Found:
    """Find the line length that brings the anchor inclination to 0; the sinker's weight in kN."""
    from catopt.catenary.find import find_length

    given = source.inputs
    position = given["sinker_position_m"]
    start = 3.0 * given["water_depth_m"]  # m, where the search for the length begins
    return find_length(
        Line(
            [Segment(start, given["submerged_weight_N_per_m"])],
            [PointLoad(position, weight * _KN)],
        ),
        height=given["water_depth_m"],
        horizontal_force=given["horizontal_force_kN"] * _KN,
        anchor_angle=0.0,
    )


def _numbers(found: Found) -> dict[str, float]:
    """Put the numbers of a row of Table 2 together."""
    return {_LENGTH: found.value, _TENSION: found.solution.fairlead.tension / _KN}


# ------------------------------------------------------------------ findings


def _laid_out(source: Published, force: float, equivalent_length: float) -> SinkerLine:
    """Lay the line out by the formulas of S2 and S3; force in kN, length in m."""
    given = source.inputs
    a = force * _KN / given["submerged_weight_N_per_m"]
    return sinker_line(a, given["water_depth_m"], given["sinker_position_m"], equivalent_length)


def _about_the_load(source: Published, rows: list[_Row]) -> str:
    force = source.inputs["horizontal_force_kN"]
    largest = max((row.printed[_TENSION] for row in rows), key=lambda printed: printed.value)
    return Message("reproduce.by_text_line_carries_h", force=force, tension=largest.text)


def _about_other_forces(source: Published, rows: list[_Row]) -> str:
    weight_per_length = source.inputs["submerged_weight_N_per_m"]

    def length_with(weight: float) -> Callable[[float], float]:
        equivalent = weight * _KN / weight_per_length
        return lambda force: _laid_out(source, force, equivalent).length

    needed = [interval(length_with(row.weight), row.printed[_LENGTH], _FORCES) for row in rows]
    forces = ", ".join(f"{0.5 * (each.least + each.largest):.0f}" for each in needed)
    return Message("reproduce.nor_one_line_under_another", forces=forces)


_LENGTHS_FORCE = 100.0  # kN: the horizontal force at first of Table 1
_LENGTHS_RATIO = 0.0126  # m/kN: equivalent length over the printed weight


def _about_the_lengths(source: Published, rows: list[_Row]) -> str:
    made = [_laid_out(source, _LENGTHS_FORCE, _LENGTHS_RATIO * row.weight).length for row in rows]
    agreeing = sum(
        row.printed[_LENGTH].rounding(length) == row.printed[_LENGTH].text
        for row, length in zip(rows, made, strict=True)
    )
    share = _LENGTHS_RATIO * source.inputs["submerged_weight_N_per_m"] / _KN
    return Message(
        "reproduce.s3_own_formulas_give_printed",
        agreeing=agreeing,
        count=len(rows),
        force=_LENGTHS_FORCE,
        ratio=_LENGTHS_RATIO,
        share=share,
    )


_TENSIONS_ADD = 137.81  # kN: the force at uplift of Table 1
_TENSIONS_FORCE = 650.0  # kN, in a = H / q only
_BLOCK_DENSITY, _WATER_DENSITY = 2.5, 1.025  # t/m3


def _about_the_tensions(source: Published, rows: list[_Row]) -> str:
    weight_per_length = source.inputs["submerged_weight_N_per_m"] / _KN
    share = 1.0 - _WATER_DENSITY / _BLOCK_DENSITY
    made = [
        weight_per_length
        * _laid_out(source, _TENSIONS_FORCE, share * row.weight / weight_per_length).z_oc
        + _TENSIONS_ADD
        for row in rows
    ]
    worst = max(
        abs(tension - row.printed[_TENSION].value) for row, tension in zip(rows, made, strict=True)
    )
    return Message(
        "reproduce.same_formulas_give_printed_tensions",
        worst=worst,
        added=_TENSIONS_ADD,
        force=_TENSIONS_FORCE,
        share=share,
        water=_WATER_DENSITY,
        block=_BLOCK_DENSITY,
    )
