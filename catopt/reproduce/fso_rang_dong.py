"""S4: the turret of FSO Rang Dong at rest, as the source ran it and on a bed that only pushes."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cache
from typing import TYPE_CHECKING

from catopt.constants import STANDARD_GRAVITY
from catopt.model import Line, Segment, System
from catopt.reproduce.comparison import compare, study_of
from catopt.reproduce.items import Input, Item, MooredLine, Mooring, SideBySide, Study, in_unit
from catopt.reproduce.published import Published, published
from catopt.units import UNITS, Dimension
from catopt.words import Message

if TYPE_CHECKING:
    from catopt.fem import HeldBed, TrussSolution
    from catopt.fem import SystemSolution as TrussSystem
    from catopt.mooring.solution import SystemSolution
    from catopt.verify.result import StaticComparison

NAME = "fso_rang_dong"

BARS = 200
"""Of each line on the coarsest mesh of the truss model on the bed that only pushes."""

TOLERANCE = 1e-4
"""Difference of the two models on that bed that counts as agreement."""

_KN = UNITS[Dimension.FORCE]["kN"]
_LOADED = 1
"""Line 2, which lies straight against the force; from 0."""

_PRINTED_BARS = 11
"""Rows of a line's printed tensions: elements 1 to 10, and 11 to 20 alike."""


@dataclass(frozen=True)
class _Answer:
    """Turret offset along the force, m, and largest tensions, N."""

    offset: float
    fairlead: float
    anchor: float


def study() -> Study:
    """Solve the nine lines with the source's restraints and without them; judge every number."""
    source = published(NAME)
    made = study_of(
        source,
        inputs=_inputs(source),
        items=_items(source),
        findings=(
            _about_the_run(source),
            _about_the_bed(),
            _about_orcaflex(source),
            _about_the_azimuths(source),
        ),
    )
    return replace(
        made,
        side_by_side=(_restraints(source), _both_models()),
        moorings=_moorings(),
        loaded_line=_LOADED,
    )


# ------------------------------------------------------------------ the mooring


def turret(source: Published, azimuths: str = "azimuth_deg") -> System:
    """Lay the nine lines out as printed."""
    series, given = source.series, source.inputs
    columns = zip(
        series["length_m"], series["submerged_mass_kg_per_m"], series["EA_kN"], strict=True
    )
    line = Line([Segment(L, m * STANDARD_GRAVITY, EA=EA * _KN) for L, m, EA in columns])
    return System.around(
        line,
        azimuths=[math.radians(azimuth) for azimuth in series[azimuths]],
        anchor_radius=given["anchor_radius_m"],
        fairlead_height=given["water_depth_m"] + given["turret_height_above_water_m"],
        force=(given["static_force_x_kN"] * _KN, 0.0),
    )


def _stiffened(system: System, factor: float) -> System:
    """Return the system with every EA multiplied."""
    (line,) = {leg.line for leg in system.legs}
    stiff = Line([replace(each, EA=factor * each.EA) for each in line.segments])
    return replace(system, legs=tuple(replace(leg, line=stiff) for leg in system.legs))


@cache
def as_run(
    *, stiffened: bool = True, azimuths: str = "azimuth_deg", force: float | None = None
) -> TrussSystem:
    """Solve with the source's restraint: nodes up to the second joint held in height both ways.

    `force`: on the turret along x, N; the printed one when left out.
    """
    from catopt.fem import solve_system
    from catopt.verify.system import truss_legs

    source = published(NAME)
    system = turret(source, azimuths)
    legs, height = truss_legs(system, 0.0)
    bars = int(source.inputs["elements_per_segment"])
    return solve_system(
        legs,
        height=height,
        force=system.force if force is None else (force, 0.0),
        elements=[bars] * len(system.legs[0].line.segments),
        bed=held_bed(source, stiffened=stiffened),
    )


def held_bed(source: Published, *, stiffened: bool = True) -> HeldBed:
    """Restraint of the source's run: nodes up to the second joint held, EA a hundredfold or not."""
    from catopt.fem import HeldBed

    return HeldBed(
        grounded_length=source.inputs["grounded_length_m"],
        EA_multiplier=source.inputs["EA_multiplier"] if stiffened else 1.0,
    )


@cache
def free_bed() -> StaticComparison:
    """Solve with a bed that only pushes and the printed EA, by closed form and truss model."""
    from catopt.verify.system import verify_system

    return verify_system(turret(published(NAME)), elements=BARS, tolerance=TOLERANCE)


def _stiff_on_free_bed(source: Published) -> SystemSolution:
    from catopt.mooring.solve import solve_system

    return solve_system(_stiffened(turret(source), source.inputs["EA_multiplier"]))


def _of_truss(truss: TrussSystem) -> _Answer:
    """Read what S4 prints: the tensions are those of the first and the last bar."""
    return _Answer(
        offset=-truss.position[0],
        fairlead=max(float(line.tension[-1]) for line in truss.lines),
        anchor=max(float(line.tension[0]) for line in truss.lines),
    )


def _of_closed_form(closed: SystemSolution) -> _Answer:
    return _Answer(
        offset=-closed.offset[0],
        fairlead=max(line.tension for line in closed.lines),
        anchor=max(line.solution.anchor.tension for line in closed.lines),
    )


def _on_free_bed() -> _Answer:
    """Offset and largest tensions on the bed that only pushes, by closed form."""
    found = free_bed()
    lines = range(len(found.lines))
    return _Answer(
        offset=-_exact(found, "position_x"),
        fairlead=max(_exact(found, "fairlead_tension", k) for k in lines),
        anchor=max(_exact(found, "anchor_tension", k) for k in lines),
    )


def _exact(found: StaticComparison, quantity: str, line: int | None = None) -> float:
    value = found.of(quantity, line).closed_form
    assert value is not None
    return value


# ------------------------------------------------------------------ printed numbers


def _inputs(source: Published) -> tuple[Input, ...]:
    given, series = source.inputs, source.series

    def listed(key: str) -> str:
        return ", ".join(f"{value:g}" for value in series[key])

    not_printed = "not printed; identified, see below"
    return (
        Input("water depth", f"{given['water_depth_m']:g}", "m"),
        Input("turret above the water", f"{given['turret_height_above_water_m']:g}", "m"),
        Input("anchor radius", f"{given['anchor_radius_m']:g}", "m"),
        Input("azimuths", listed("azimuth_deg"), "deg", "printed node coordinates; see below"),
        Input("segment lengths, from the anchor", listed("length_m"), "m"),
        Input("submerged mass", listed("submerged_mass_kg_per_m"), "kg/m"),
        Input("axial stiffness EA", listed("EA_kN"), "kN"),
        Input("force on the turret along x", f"{given['static_force_x_kN']:g}", "kN"),
        Input("bars of each segment", f"{given['elements_per_segment']:g}", ""),
        Input("as run: EA times", f"{given['EA_multiplier']:g}", "", not_printed),
        Input(
            "as run: length from the anchor held at the bed both ways",
            f"{given['grounded_length_m']:g}",
            "m",
            "printed restraints",
        ),
    )


def _items(source: Published) -> tuple[Item, ...]:
    run = as_run()
    answer = _of_truss(run)
    computed = {
        "turret_offset_m": answer.offset,
        "fairlead_tension_kN": answer.fairlead / _KN,
        "anchor_tension_kN": answer.anchor / _KN,
    }
    free = _on_free_bed()
    values = {
        "turret_offset_m": f"{free.offset:.3f} m",
        "fairlead_tension_kN": f"{free.fairlead / _KN:.0f} kN",
        "anchor_tension_kN": f"{free.anchor / _KN:.0f} kN",
    }
    remarks = {key: Message("reproduce.on_free_bed", value=said) for key, said in values.items()}
    by = "truss"
    return (
        *compare(source, "MOORING_2017", computed, remarks, by),
        *_line_items(source, 0, run.lines[0]),
        *_line_items(source, 1, run.lines[1]),
        *(_few_digits(item) for item in compare(source, "OrcaFlex", computed, remarks, by)),
    )


def _few_digits(item: Item) -> Item:
    """Show a number that differs to as many digits as are of use, not to all that were printed."""
    decimals = 4 if item.unit == "m" else 2
    text = f"{item.computed:.{decimals}f}"
    return replace(item, judgement=replace(item.judgement, computed_text=text))


def _line_items(source: Published, index: int, line: TrussSolution) -> tuple[Item, ...]:
    """Judge the printed tensions of a line, from the turret."""
    method = Message("reproduce.mooring_2017_line", number=index + 1)
    tensions = [float(T) / _KN for T in line.tension[::-1][:_PRINTED_BARS]]
    computed = dict(zip(source.printed[method], tensions, strict=True))
    return compare(source, method, computed, computed_by="truss")


# ------------------------------------------------------------------ findings


def _about_the_run(source: Published) -> str:
    multiplier = source.inputs["EA_multiplier"]
    return Message(
        "reproduce.every_printed_static_figure_mooring",
        factor=multiplier,
        tension=as_run().lines[_LOADED].fairlead.tension / _KN,
    )


def _about_the_bed() -> str:
    run = as_run()
    line = run.lines[_LOADED]
    pull = -min(float(reaction) for reaction in line.bed_reaction) / _KN
    free = _on_free_bed()
    grounded = _exact(free_bed(), "grounded_length", _LOADED)
    return Message(
        "reproduce.held_down_both_directions_bed",
        pull=pull,
        offset=free.offset,
        grounded=grounded,
        tension=free.fairlead / _KN,
    )


def _about_orcaflex(source: Published) -> str:
    printed = source.printed["OrcaFlex"]
    answer = _of_truss(as_run())
    off = 100.0 * (printed["turret_offset_m"].value / answer.offset - 1.0)
    tension = 100.0 * (printed["fairlead_tension_kN"].value * _KN / answer.fairlead - 1.0)
    anchor = 100.0 * (printed["anchor_tension_kN"].value * _KN / answer.anchor - 1.0)
    return Message(
        "reproduce.offset_printed_for_orcaflex_m",
        offset=printed["turret_offset_m"].text,
        share=off,
        fairlead=tension,
        anchor=anchor,
    )


def _about_the_azimuths(source: Published) -> str:
    printed = ", ".join(f"{value:g}" for value in source.series["azimuth_printed_deg"][:3])
    lines = as_run(azimuths="azimuth_printed_deg").lines[:2]
    first, second = (float(line.tension[-1]) / _KN for line in lines)
    return Message(
        "reproduce.text_puts_lines_group_5", azimuths=printed, first=first, second=second
    )


# ------------------------------------------------------------------ side by side


def _restraints(source: Published) -> SideBySide:
    """Set print, run and the two choices, one at a time, side by side."""
    answers = (
        ("as run: held both ways, 100 EA", _of_truss(as_run())),
        ("held both ways, printed EA", _of_truss(as_run(stiffened=False))),
        ("pushes only, 100 EA", _of_closed_form(_stiff_on_free_bed(source))),
        ("pushes only, printed EA", _on_free_bed()),
    )
    rows: list[tuple[str, ...]] = [
        (Message("reproduce.printed_by", program=name), *_rounded(source, name))
        for name in ("MOORING_2017", "OrcaFlex")
    ]
    rows += [
        (
            name,
            f"{answer.offset:.3f}",
            f"{answer.fairlead / _KN:.0f}",
            f"{answer.anchor / _KN:.0f}",
        )
        for name, answer in answers
    ]
    return SideBySide(
        "What the two choices make",
        (
            "bed and EA",
            in_unit("turret offset", "m"),
            in_unit("at the turret", "kN"),
            in_unit("at the anchor", "kN"),
        ),
        tuple(rows),
    )


def _rounded(source: Published, method: str) -> tuple[str, str, str]:
    """Round the printed numbers of a method like ours."""
    offset, fairlead, anchor = (printed.value for printed in source.printed[method].values())
    return f"{offset:.3f}", f"{fairlead:.0f}", f"{anchor:.0f}"


def _both_models() -> SideBySide:
    """Set closed form and truss model on the bed that only pushes side by side."""
    found = free_bed()
    rows: list[tuple[str, ...]] = [
        (in_unit("offset", "m"), *_pair(found, "position_x", None, -1.0, 4))
    ]
    for k in range(len(found.lines)):
        for quantity, key in (
            ("fairlead_tension", "reproduce.at_the_turret"),
            ("anchor_tension", "reproduce.line_anchor"),
        ):
            said = Message(key, number=k + 1)
            rows.append((said, *_pair(found, quantity, k, 1.0 / _KN, 2)))
    return SideBySide(
        "A bed that only pushes and the printed EA, by both models",
        ("quantity", "closed form", "truss", "within 0.01 %"),
        tuple(rows),
    )


def _pair(
    found: StaticComparison, quantity: str, line: int | None, factor: float, digits: int
) -> tuple[str, str, str]:
    each = found.of(quantity, line)
    assert each.closed_form is not None
    exact, truss = factor * each.closed_form, factor * each.extrapolated
    return f"{exact:.{digits}f}", f"{truss:.{digits}f}", "yes" if each.agrees else "no"


# ------------------------------------------------------------------ where the lines lie


def _moorings() -> tuple[Mooring, ...]:
    run = tuple(_laid(line, held=True) for line in as_run().lines)
    free = tuple(_laid(pair.finest, held=False) for pair in free_bed().lines)
    return (
        Mooring("As run: held to the bed, 100 EA", run),
        Mooring("Bed only pushes, printed EA", free),
    )


def _laid(line: TrussSolution, *, held: bool) -> MooredLine:
    arc = published(NAME).inputs["grounded_length_m"] if held else line.grounded_length
    x, y, z = (tuple(float(value) for value in line.nodes[:, axis]) for axis in range(3))
    return MooredLine(x, y, z, tuple(bool(s <= arc) for s in line.arc))
