"""S2 and S3: lines of a ship in 200 m and of a tanker in 20 m of water, without and with a sinker.

Both take a sinker's weight for a piece of line of equivalent length.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from catopt.model import Line, PointLoad, Segment
from catopt.reproduce.items import (
    KN,
    TF,
    Drawn,
    Item,
    Printed,
    Published,
    Study,
    compare,
    interval,
    published,
    study_of,
)
from catopt.words import Message

if TYPE_CHECKING:
    from catopt.catenary.find import Found
    from catopt.catenary.solution import Solution


def _line(source: Published) -> Line:
    given = source.inputs
    return Line([Segment(given["line_length_m"], given["submerged_weight_N_per_m"])])


def _hang(source: Published, force: str) -> Solution:
    """Solve the line without sinker under a horizontal force, a key of the inputs."""
    from catopt.catenary.solve import solve

    given = source.inputs
    return solve(_line(source), height=given["water_depth_m"], horizontal_force=given[force] * KN)


def _level_with_sinker(source: Published, start: float, weight: float, force: str) -> Found:
    """Find the line length that brings the inclination at the anchor to 0.

    `start`: m, where the search for the length begins; `weight`: of the sinker, kN; `force`:
    horizontal, a key of the inputs.
    """
    from catopt.catenary.find import find_length

    given = source.inputs
    return find_length(
        Line(
            [Segment(start, given["submerged_weight_N_per_m"])],
            [PointLoad(given["sinker_position_m"], weight * KN)],
        ),
        height=given["water_depth_m"],
        horizontal_force=given[force] * KN,
        anchor_angle=0.0,
    )


@dataclass(frozen=True)
class _SinkerLine:
    """A line with a sinker whose anchor inclination is 0, as two pieces of one catenary.

    The catenary is that of a line without sinker; O is where it is level. The lower piece, of the
    length of line below the sinker, ends at b1. The upper piece starts at b2, further up by the
    equivalent length, and ends at the fairlead C.

    `x_b1`, `x_b2`, `x_oc`: from O to b1, b2 and C, horizontally, m; `z_oc`: from O up to C, m; S2
    (35); `length`: of line, below and above the sinker, m; S2 (36).
    """

    x_b1: float
    x_b2: float
    x_oc: float
    z_oc: float
    length: float


def _laid_out(source: Published, force: float, equivalent_length: float) -> _SinkerLine:
    """Lay a line with a sinker out by S2 (30) to (40).

    `force`: horizontal, kN; `equivalent_length`: L_eq = W_s / q, m; S2 (30).
    """
    given = source.inputs
    a = force * KN / given["submerged_weight_N_per_m"]
    position = given["sinker_position_m"]
    upper = position + equivalent_length
    z_b1, z_b2 = (math.hypot(a, s) - a for s in (position, upper))
    z_oc = given["water_depth_m"] + z_b2 - z_b1
    l_oc = math.sqrt(z_oc * z_oc + 2.0 * a * z_oc)
    x_b1, x_b2, x_oc = (a * math.asinh(s / a) for s in (position, upper, l_oc))
    return _SinkerLine(x_b1, x_b2, x_oc, z_oc, l_oc - equivalent_length)


# ------------------------------------------------------------------ S2: a ship in 200 m of water

_PLAIN, _WITH_SINKER = "plain line", "line with the sinker"


def ship_200m() -> Study:
    """Recompute S2's worked example in closed form and judge every printed number."""
    source = published("ship_200m")
    given = source.inputs
    first = _hang(source, "initial_horizontal_force_kN")
    loaded = _hang(source, "loaded_horizontal_force_kN")
    held = _level_with_sinker(
        source,
        given["line_length_m"],
        given["sinker_submerged_weight_kN"],
        "loaded_horizontal_force_kN",
    )
    offset = loaded.span - first.span
    printed = source.printed[_PLAIN]
    plain = {
        "grounded_length_m": first.grounded_length,
        "suspended_length_m": first.suspended_length,
        "span_initial_m": first.span,
        "span_loaded_m": loaded.span,
        "offset_m": offset,
        "fairlead_tension_kN": loaded.fairlead.tension / KN,
    }
    plain_remarks = {
        "span_initial_m": "printed as if cut off after one decimal, see below",
        "offset_m": Message(
            "reproduce.printed_spans_whole_metres",
            first=printed["span_loaded_m"].text,
            second=printed["span_initial_m"].text,
            rounded=offset,
        ),
    }
    with_sinker = {
        "span_m": held.solution.span,
        "suspended_length_m": held.value - given["sinker_position_m"],
        "fairlead_tension_kN": held.solution.fairlead.tension / KN,
        "length_saved_m": given["line_length_m"] - held.value,
    }
    about_the_spans = Message(
        "reproduce.span_under_300_kn_200",
        span=first.span,
        rounded=first.span,
        cut=_cut_off(first.span),
        loaded=loaded.span,
        either=loaded.span,
        offset=printed["offset_m"].text,
        unrounded=offset,
    )
    return study_of(
        source,
        items=(
            *compare(source, _PLAIN, plain, plain_remarks),
            *compare(
                source, _WITH_SINKER, with_sinker, {"span_m": "rounding on the way, see below"}
            ),
        ),
        findings=(about_the_spans, _about_the_span_with_the_sinker(source)),
        drawn=(
            Drawn("under 300 kN", first),
            Drawn("under 800 kN", loaded),
            Drawn("under 800 kN, with the sinker", held.solution),
        ),
    )


def _cut_off(value: float) -> float:
    """Drop what follows the first decimal, as is done by hand."""
    return math.floor(10.0 * value) / 10.0


def _about_the_span_with_the_sinker(source: Published) -> str:
    given = source.inputs
    equivalent = given["sinker_submerged_weight_kN"] * KN / given["submerged_weight_N_per_m"]
    laid = _laid_out(source, given["loaded_horizontal_force_kN"], equivalent)
    parts = (laid.x_b1, laid.x_oc, laid.x_b2)
    return Message(
        "reproduce.span_with_sinker_x_b1",
        exact=_sum(parts, 3),
        rounded=_sum([round(part, 1) for part in parts], 1),
        cut=_sum([_cut_off(part) for part in parts], 1),
        length=source.printed[_WITH_SINKER]["suspended_length_m"].text,
        shorter=_cut_off(laid.length - given["sinker_position_m"]),
        whole=_sum([float(round(part)) for part in parts], 0),
    )


def _sum(parts: Sequence[float], decimals: int) -> str:
    """Write the span x_AC of S2 (40) out: x_b1 + x_OC - x_b2."""
    first, second, less, span = (
        f"{value:.{decimals}f}" for value in (*parts, parts[0] + parts[1] - parts[2])
    )
    return f"{first} + {second} - {less} = {span}"


# ------------------------------------------------------------------ S3, Table 1: a tanker

_TABLE = "Table 1"


def tanker_20m() -> Study:
    """Recompute Table 1, up to where the touchdown is gone, and judge every printed number."""
    from catopt.catenary.find import find_touchdown_force

    source = published("tanker_20m")
    first = _hang(source, "initial_horizontal_force_kN")
    lifting = find_touchdown_force(_line(source), height=source.inputs["water_depth_m"])
    table = _table_1(source, first, lifting)
    printed = source.printed[_TABLE]
    agreeing = sum(
        number.rounding(table[quantity]) == number.text for quantity, number in printed.items()
    )
    permissible = source.inputs["breaking_load_tf"] / source.inputs["safety_factor"]
    largest = table["uplift_fairlead_tension_kN"] * KN / TF
    key = "reproduce.largest_within" if largest <= permissible else "reproduce.largest_above"
    return study_of(
        source,
        items=(
            *compare(source, _TABLE, table, _remarks(source, table)),
            *compare(
                source,
                "safe working",
                {"permissible_tension_tf": permissible},
                {"permissible_tension_tf": Message(key, tension=largest)},
                computed_by="T_break / SF",
            ),
        ),
        findings=(
            Message("reproduce.numbers_table_1_have_every", count=len(printed), agreeing=agreeing),
        ),
        drawn=(
            Drawn(f"under {first.horizontal_force / KN:g} kN", first),
            Drawn(f"under {lifting.value / KN:.0f} kN: touchdown at the anchor", lifting.solution),
        ),
    )


def _table_1(source: Published, first: Solution, lifting: Found) -> dict[str, float]:
    """Put the numbers of Table 1 together."""
    force = source.inputs["initial_horizontal_force_kN"] * KN
    lifted = lifting.solution
    return {
        "minimum_suspended_length_m": first.suspended_length,
        "spare_length_m": first.grounded_length,
        "span_suspended_m": first.span - first.grounded_length,
        "span_total_m": first.span,
        "fairlead_tension_kN": first.fairlead.tension / KN,
        "uplift_horizontal_force_kN": lifting.value / KN,
        "uplift_added_force_kN": (lifting.value - force) / KN,
        "uplift_span_m": lifted.span,
        "uplift_offset_m": lifted.span - first.span,
        "uplift_fairlead_tension_kN": lifted.fairlead.tension / KN,
    }


def _remarks(source: Published, table: dict[str, float]) -> dict[str, str]:
    """Say where S3 went on with more digits than it printed."""
    printed = source.printed[_TABLE]
    length, shortest = source.inputs["line_length_m"], printed["minimum_suspended_length_m"]
    suspended, spare = printed["span_suspended_m"], printed["spare_length_m"]
    uplift, total = printed["uplift_span_m"], printed["span_total_m"]
    return {
        "spare_length_m": Message(
            "reproduce.from_unrounded_lengths_would_be",
            difference=f"{length:g} - {shortest.text}",
            value=length - shortest.value,
        ),
        "span_total_m": Message(
            "reproduce.from_unrounded_parts_would_be",
            sum=f"{suspended.text} + {spare.text}",
            value=suspended.value + spare.value,
        ),
        "uplift_offset_m": Message(
            "reproduce.from_unrounded_spans_would_be",
            difference=f"{uplift.text} - {total.text}",
            value=uplift.value - total.value,
        ),
        "uplift_span_m": Message("reproduce.two_decimals", value=table["uplift_span_m"]),
    }


# ------------------------------------------------------------------ S3, Table 2: with a sinker

_LENGTH = "line_length_m"
_TENSION = "fairlead_tension_kN"
_FORCES = (100.0, 1000.0)  # kN, where the force that a printed length needs is looked for
_LENGTHS_FORCE = 100.0  # kN: the horizontal force at first of Table 1
_LENGTHS_RATIO = 0.0126  # m/kN: equivalent length over the printed weight
_TENSIONS_ADD = 137.81  # kN: the force at uplift of Table 1
_TENSIONS_FORCE = 650.0  # kN, in a = H / q only
_BLOCK_DENSITY, _WATER_DENSITY = 2.5, 1.025  # t/m3


@dataclass(frozen=True)
class _Row:
    """One row of Table 2: the sinker's weight, kN, and what was printed for it."""

    method: str
    weight: float
    printed: dict[str, Printed]


def tanker_20m_sinker() -> Study:
    """Find the true equilibria beside Table 2, and what its columns can be made from.

    The table, for sinkers of 100 to 300 kN, is not one equilibrium.
    """
    source = published("tanker_20m_sinker")
    start = 3.0 * source.inputs["water_depth_m"]
    rows: list[_Row] = []
    items: list[Item] = []
    drawn: list[Drawn] = []
    for weight in source.series["sinker_weight_kN"]:
        method = Message("reproduce.sinker_kn", weight=weight)
        rows.append(_Row(method, weight, source.printed[method]))
        found = _level_with_sinker(source, start, weight, "horizontal_force_kN")
        tension = found.solution.fairlead.tension / KN
        items += compare(source, method, {_LENGTH: found.value, _TENSION: tension})
        drawn.append(Drawn(method, found.solution))
    force = source.inputs["horizontal_force_kN"]
    largest = max((row.printed[_TENSION] for row in rows), key=lambda printed: printed.value)
    return study_of(
        source,
        items,
        findings=(
            Message("reproduce.by_text_line_carries_h", force=force, tension=largest.text),
            _about_other_forces(source, rows),
            _about_the_lengths(source, rows),
            _about_the_tensions(source, rows),
        ),
        drawn=tuple(drawn),
    )


def _about_other_forces(source: Published, rows: list[_Row]) -> str:
    weight_per_length = source.inputs["submerged_weight_N_per_m"]

    def length_with(weight: float) -> Callable[[float], float]:
        equivalent = weight * KN / weight_per_length
        return lambda force: _laid_out(source, force, equivalent).length

    needed = [interval(length_with(row.weight), row.printed[_LENGTH], _FORCES) for row in rows]
    forces = ", ".join(f"{0.5 * (ends.least + ends.largest):.0f}" for ends in needed)
    return Message("reproduce.nor_one_line_under_another", forces=forces)


def _about_the_lengths(source: Published, rows: list[_Row]) -> str:
    agreeing = 0
    for row in rows:
        made = _laid_out(source, _LENGTHS_FORCE, _LENGTHS_RATIO * row.weight).length
        agreeing += row.printed[_LENGTH].rounding(made) == row.printed[_LENGTH].text
    return Message(
        "reproduce.s3_own_formulas_give_printed",
        agreeing=agreeing,
        count=len(rows),
        force=_LENGTHS_FORCE,
        ratio=_LENGTHS_RATIO,
        share=_LENGTHS_RATIO * source.inputs["submerged_weight_N_per_m"] / KN,
    )


def _about_the_tensions(source: Published, rows: list[_Row]) -> str:
    weight_per_length = source.inputs["submerged_weight_N_per_m"] / KN
    share = 1.0 - _WATER_DENSITY / _BLOCK_DENSITY
    missed = []
    for row in rows:
        laid = _laid_out(source, _TENSIONS_FORCE, share * row.weight / weight_per_length)
        made = weight_per_length * laid.z_oc + _TENSIONS_ADD
        missed.append(abs(made - row.printed[_TENSION].value))
    return Message(
        "reproduce.same_formulas_give_printed_tensions",
        worst=max(missed),
        added=_TENSIONS_ADD,
        force=_TENSIONS_FORCE,
        share=share,
        water=_WATER_DENSITY,
        block=_BLOCK_DENSITY,
    )
