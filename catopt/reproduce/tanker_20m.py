"""S3, Table 1: a tanker on 55 m of chain in 20 m of water, and when its touchdown is gone."""

from __future__ import annotations

from typing import TYPE_CHECKING

from catopt.model import Line, Segment
from catopt.reproduce.comparison import compare, study_of
from catopt.reproduce.items import Drawn, Input, Item, Study
from catopt.reproduce.published import Published, published
from catopt.units import UNITS, Dimension
from catopt.words import Message

if TYPE_CHECKING:
    from catopt.catenary.find import Found
    from catopt.catenary.solution import Solution

NAME = "tanker_20m"

_KN = UNITS[Dimension.FORCE]["kN"]
_TONNE_FORCE = UNITS[Dimension.FORCE]["tf"]
_TABLE = "Table 1"


def study() -> Study:
    """Recompute Table 1 in closed form and judge every printed number."""
    source = published(NAME)
    first, lifting = _hang(source)
    table = _table_1(source, first, lifting)
    return study_of(
        source,
        inputs=_inputs(source),
        items=(
            *compare(source, _TABLE, table, _remarks(source, table)),
            *_safe_working(source, table),
        ),
        findings=(_about_the_digits(source, table),),
        drawn=(
            Drawn(f"under {first.horizontal_force / _KN:g} kN", first),
            Drawn(f"under {lifting.value / _KN:.0f} kN: touchdown at the anchor", lifting.solution),
        ),
    )


def _inputs(source: Published) -> tuple[Input, ...]:
    given = source.inputs
    return (
        Input("water depth = fairlead height", f"{given['water_depth_m']:g}", "m"),
        Input("line length, inextensible", f"{given['line_length_m']:g}", "m"),
        Input("submerged weight", f"{given['submerged_weight_N_per_m']:g}", "N/m"),
        Input("horizontal force at first", f"{given['initial_horizontal_force_kN']:g}", "kN"),
        Input("breaking load", f"{given['breaking_load_tf']:g}", "tf"),
        Input("safety factor", f"{given['safety_factor']:g}", ""),
    )


def _hang(source: Published) -> tuple[Solution, Found]:
    """Solve the line at first, and under the force that brings the touchdown to the anchor."""
    from catopt.catenary.find import find_touchdown_force
    from catopt.catenary.solve import solve

    given = source.inputs
    line = Line([Segment(given["line_length_m"], given["submerged_weight_N_per_m"])])
    height, force = given["water_depth_m"], given["initial_horizontal_force_kN"] * _KN
    first = solve(line, height=height, horizontal_force=force)
    return first, find_touchdown_force(line, height=height)


def _table_1(source: Published, first: Solution, lifting: Found) -> dict[str, float]:
    """Put the numbers of Table 1 together."""
    force = source.inputs["initial_horizontal_force_kN"] * _KN
    lifted = lifting.solution
    return {
        "minimum_suspended_length_m": first.suspended_length,
        "spare_length_m": first.grounded_length,
        "span_suspended_m": first.span - first.grounded_length,
        "span_total_m": first.span,
        "fairlead_tension_kN": first.fairlead.tension / _KN,
        "uplift_horizontal_force_kN": lifting.value / _KN,
        "uplift_added_force_kN": (lifting.value - force) / _KN,
        "uplift_span_m": lifted.span,
        "uplift_offset_m": lifted.span - first.span,
        "uplift_fairlead_tension_kN": lifted.fairlead.tension / _KN,
    }


def _remarks(source: Published, table: dict[str, float]) -> dict[str, str]:
    """Say where S3 went on with more digits than it printed."""
    printed = source.printed[_TABLE]
    length = source.inputs["line_length_m"]
    spare = length - printed["minimum_suspended_length_m"].value
    total = printed["span_suspended_m"].value + printed["spare_length_m"].value
    offset = printed["uplift_span_m"].value - printed["span_total_m"].value
    return {
        "spare_length_m": Message(
            "reproduce.from_unrounded_lengths_would_be",
            difference=f"{length:g} - {printed['minimum_suspended_length_m'].text}",
            value=spare,
        ),
        "span_total_m": Message(
            "reproduce.from_unrounded_parts_would_be",
            sum=f"{printed['span_suspended_m'].text} + {printed['spare_length_m'].text}",
            value=total,
        ),
        "uplift_offset_m": Message(
            "reproduce.from_unrounded_spans_would_be",
            difference=f"{printed['uplift_span_m'].text} - {printed['span_total_m'].text}",
            value=offset,
        ),
        "uplift_span_m": Message("reproduce.two_decimals", value=table["uplift_span_m"]),
    }


def _safe_working(source: Published, table: dict[str, float]) -> tuple[Item, ...]:
    """Divide the breaking load; hold the largest tension of Table 1 against the outcome."""
    permissible = source.inputs["breaking_load_tf"] / source.inputs["safety_factor"]
    largest = table["uplift_fairlead_tension_kN"] * _KN / _TONNE_FORCE
    key = "reproduce.largest_within" if largest <= permissible else "reproduce.largest_above"
    remark = Message(key, tension=largest)
    return compare(
        source,
        "safe working",
        {"permissible_tension_tf": permissible},
        {"permissible_tension_tf": remark},
        computed_by="T_break / SF",
    )


def _about_the_digits(source: Published, table: dict[str, float]) -> str:
    printed = source.printed[_TABLE]
    agreeing = sum(
        each.rounding(table[quantity]) == each.text for quantity, each in printed.items()
    )
    return Message("reproduce.numbers_table_1_have_every", count=len(printed), agreeing=agreeing)
