"""S2: 600 m of line in 200 m of water under 300 and 800 kN, without and with a sinker."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from catopt.model import Line, PointLoad, Segment
from catopt.reproduce.comparison import compare, study_of
from catopt.reproduce.equivalent_length import SinkerLine, sinker_line
from catopt.reproduce.items import Drawn, Input, Item, Study
from catopt.reproduce.published import Published, published
from catopt.units import UNITS, Dimension
from catopt.words import Message

if TYPE_CHECKING:
    from catopt.catenary.find import Found
    from catopt.catenary.solution import Solution

NAME = "ship_200m"

_KN = UNITS[Dimension.FORCE]["kN"]


def study() -> Study:
    """Recompute S2's worked example in closed form and judge every printed number."""
    source = published(NAME)
    first = _hang(source, "initial_horizontal_force_kN")
    loaded = _hang(source, "loaded_horizontal_force_kN")
    held = _level_with_sinker(source)
    return study_of(
        source,
        inputs=_inputs(source),
        items=(*_plain_items(source, first, loaded), *_sinker_items(source, held)),
        findings=(
            _about_the_plain_spans(source, first.span, loaded.span),
            _about_the_span_with_the_sinker(source),
        ),
        drawn=(
            Drawn("under 300 kN", first),
            Drawn("under 800 kN", loaded),
            Drawn("under 800 kN, with the sinker", held.solution),
        ),
    )


def _inputs(source: Published) -> tuple[Input, ...]:
    given = source.inputs
    return (
        Input("water depth = fairlead height", f"{given['water_depth_m']:g}", "m"),
        Input("line length, inextensible", f"{given['line_length_m']:g}", "m"),
        Input("submerged weight", f"{given['submerged_weight_N_per_m']:g}", "N/m"),
        Input("horizontal force at first", f"{given['initial_horizontal_force_kN']:g}", "kN"),
        Input(
            "horizontal force, loaded",
            f"{given['loaded_horizontal_force_kN']:g}",
            "kN",
            "printed, as 500 kN more",
        ),
        Input("sinker, submerged weight", f"{given['sinker_submerged_weight_kN']:g}", "kN"),
        Input("sinker, along the line from the anchor", f"{given['sinker_position_m']:g}", "m"),
    )


# ------------------------------------------------------------------ plain line


def _hang(source: Published, force: str) -> Solution:
    """Solve the line without sinker under one of the two horizontal forces."""
    from catopt.catenary.solve import solve

    given = source.inputs
    line = Line([Segment(given["line_length_m"], given["submerged_weight_N_per_m"])])
    return solve(line, height=given["water_depth_m"], horizontal_force=given[force] * _KN)


def _plain_items(source: Published, first: Solution, loaded: Solution) -> tuple[Item, ...]:
    method = "plain line"
    printed = source.printed[method]
    spans = [printed[f"span_{state}_m"].text for state in ("loaded", "initial")]
    return compare(
        source,
        method,
        {
            "grounded_length_m": first.grounded_length,
            "suspended_length_m": first.suspended_length,
            "span_initial_m": first.span,
            "span_loaded_m": loaded.span,
            "offset_m": loaded.span - first.span,
            "fairlead_tension_kN": loaded.fairlead.tension / _KN,
        },
        {
            "span_initial_m": "printed as if cut off after one decimal, see below",
            "offset_m": Message(
                "reproduce.printed_spans_whole_metres",
                first=spans[0],
                second=spans[1],
                rounded=loaded.span - first.span,
            ),
        },
    )


# ------------------------------------------------------------------ line with the sinker


def _level_with_sinker(source: Published) -> Found:
    """Shorten the line until its inclination at the anchor is 0."""
    from catopt.catenary.find import find_length

    given = source.inputs
    position = given["sinker_position_m"]
    line = Line(
        [Segment(given["line_length_m"], given["submerged_weight_N_per_m"])],
        [PointLoad(position, given["sinker_submerged_weight_kN"] * _KN)],
    )
    return find_length(
        line,
        height=given["water_depth_m"],
        horizontal_force=given["loaded_horizontal_force_kN"] * _KN,
        anchor_angle=0.0,
    )


def _sinker_items(source: Published, found: Found) -> tuple[Item, ...]:
    """Judge what S2 prints of the line with the sinker."""
    given = source.inputs
    return compare(
        source,
        "line with the sinker",
        {
            "span_m": found.solution.span,
            "suspended_length_m": found.value - given["sinker_position_m"],
            "fairlead_tension_kN": found.solution.fairlead.tension / _KN,
            "length_saved_m": given["line_length_m"] - found.value,
        },
        {"span_m": "rounding on the way, see below"},
    )


# ------------------------------------------------------------------ findings


def _cut_off(value: float) -> float:
    """Drop what follows the first decimal, as is done by hand."""
    return math.floor(10.0 * value) / 10.0


def _about_the_plain_spans(source: Published, first: float, loaded: float) -> str:
    table = source.printed["plain line"]
    return Message(
        "reproduce.span_under_300_kn_200",
        span=first,
        rounded=first,
        cut=_cut_off(first),
        loaded=loaded,
        either=loaded,
        offset=table["offset_m"].text,
        unrounded=loaded - first,
    )


def _by_equivalent_length(source: Published) -> SinkerLine:
    """Lay the line out by S2's own formulas."""
    given = source.inputs
    weight = given["submerged_weight_N_per_m"]
    return sinker_line(
        given["loaded_horizontal_force_kN"] * _KN / weight,
        given["water_depth_m"],
        given["sinker_position_m"],
        given["sinker_submerged_weight_kN"] * _KN / weight,
    )


def _about_the_span_with_the_sinker(source: Published) -> str:
    laid = _by_equivalent_length(source)
    parts = (laid.x_b1, laid.x_oc, laid.x_b2)
    cut = [_cut_off(part) for part in parts]
    rounded = [round(part, 1) for part in parts]
    whole = [float(round(part)) for part in parts]
    printed = source.printed["line with the sinker"]
    beyond = laid.length - source.inputs["sinker_position_m"]
    return Message(
        "reproduce.span_with_sinker_x_b1",
        exact=f"{laid.x_b1:.3f} + {laid.x_oc:.3f} - {laid.x_b2:.3f} = {laid.span:.3f}",
        rounded=_sum(rounded),
        cut=_sum(cut),
        length=printed["suspended_length_m"].text,
        shorter=_cut_off(beyond),
        whole=_sum(whole, 0),
    )


def _sum(parts: list[float], decimals: int = 1) -> str:
    """Write x_b1 + x_OC - x_b2 out."""
    first, second, less, span = (
        f"{value:.{decimals}f}" for value in (*parts, parts[0] + parts[1] - parts[2])
    )
    return f"{first} + {second} - {less} = {span}"
