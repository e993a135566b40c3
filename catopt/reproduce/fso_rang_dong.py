"""S4: the turret of FSO Rang Dong at rest, as the source ran it and on a bed that only pushes."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import astuple, dataclass, replace
from functools import cache
from typing import TYPE_CHECKING, Final

from catopt.constants import STANDARD_GRAVITY
from catopt.model import Line, Segment, System
from catopt.reproduce.items import (
    KN,
    Item,
    MooredLine,
    Mooring,
    Published,
    SideBySide,
    Study,
    compare,
    in_unit,
    published,
    study_of,
)
from catopt.words import Message

if TYPE_CHECKING:
    from catopt.fem import RestrainedBed, TrussSolution
    from catopt.fem import SystemSolution as TrussSystem
    from catopt.verify.comparison import Compared
    from catopt.verify.result import StaticComparison

NAME = "fso_rang_dong"

BARS = 200
"""Of each line on the coarsest mesh of the truss model on the bed that only pushes."""

TOLERANCE = 1e-4
"""Difference of the two models on that bed that counts as agreement."""

_LOADED = 1
"""Line 2, which lies straight against the force; from 0."""

_PRINTED_BARS = 11
"""Rows of a line's printed tensions: elements 1 to 10, and 11 to 20 alike."""

_LEEWARD: Final = range(3, 9)
_LINES: Final = (0, 1, *_LEEWARD)
"""Whose tensions are printed, from 0."""

_OWN_GRAVITY: Final = 9.81
"""S4's own, Table 4.7, m/s2."""

_HANGING: Final = 155.374
"""Submerged mass per length, kg/m, by which most of the leeward lines come out with that."""


@dataclass(frozen=True)
class _Answer:
    """Turret offset along the force, m, and largest tensions, kN."""

    offset: float
    fairlead: float
    anchor: float

    @property
    def rounded(self) -> tuple[str, str, str]:
        """What S4 prints, as tables have it."""
        return f"{self.offset:.3f}", f"{self.fairlead:.0f}", f"{self.anchor:.0f}"


_PRINTED = ("turret_offset_m", "fairlead_tension_kN", "anchor_tension_kN")
"""Keys of the prints, in the order of an answer."""


def study() -> Study:
    """Solve the nine lines with the source's restraints and without them; judge every number."""
    source = published(NAME)
    return study_of(
        source,
        items=_items(source),
        findings=(
            Message(
                "reproduce.every_printed_static_figure_mooring",
                factor=source.inputs["EA_multiplier"],
                tension=as_run().lines[_LOADED].fairlead.tension / KN,
            ),
            _about_the_leeward_lines(source),
            _about_the_bed(),
            _about_orcaflex(source),
            _about_the_azimuths(source),
        ),
        side_by_side=(_restraints(source), _both_models()),
        moorings=(
            Mooring(
                "As run: held to the bed, 100 EA",
                tuple(_laid(line, held=True) for line in as_run().lines),
            ),
            Mooring(
                "Bed only pushes, printed EA",
                tuple(_laid(pair.finest, held=False) for pair in free_bed().lines),
            ),
        ),
        loaded_line=_LOADED,
    )


# ------------------------------------------------------------------ the mooring


def turret(
    source: Published,
    azimuths: str = "azimuth_deg",
    *,
    gravity: float = STANDARD_GRAVITY,
    hanging: float | None = None,
) -> System:
    """Lay the nine lines out as printed.

    `gravity`: another than the standard one, m/s2; `hanging`: submerged mass of the two segments
    that do not lie, kg/m, in place of the printed one.
    """
    series, given = source.series, source.inputs
    masses = list(series["submerged_mass_kg_per_m"])
    if hanging is not None:
        masses[-2:] = [hanging, hanging]
    columns = zip(series["length_m"], masses, series["EA_kN"], strict=True)
    line = Line([Segment(L, m * gravity, EA=EA * KN) for L, m, EA in columns])
    return System.around(
        line,
        azimuths=[math.radians(azimuth) for azimuth in series[azimuths]],
        anchor_radius=given["anchor_radius_m"],
        fairlead_height=given["water_depth_m"] + given["turret_height_above_water_m"],
        force=(given["static_force_x_kN"] * KN, 0.0),
    )


def with_segments(system: System, segments: Sequence[Segment]) -> System:
    """Return the system with other segments in every line."""
    line = Line(list(segments))
    return replace(system, legs=tuple(replace(leg, line=line) for leg in system.legs))


@cache
def as_run(
    *,
    stiffened: bool = True,
    azimuths: str = "azimuth_deg",
    force: float | None = None,
    gravity: float = STANDARD_GRAVITY,
    hanging: float | None = None,
) -> TrussSystem:
    """Solve with the source's restraint: nodes up to the second joint held in height both ways.

    `force`: on the turret along x, N; the printed one when left out. The rest as of `turret`.
    """
    from catopt.fem import solve_system
    from catopt.verify.line import truss_legs

    source = published(NAME)
    system = turret(source, azimuths, gravity=gravity, hanging=hanging)
    legs, height = truss_legs(system, 0.0)
    bars = int(source.inputs["elements_per_segment"])
    return solve_system(
        legs,
        height=height,
        force=system.force if force is None else (force, 0.0),
        elements=[bars] * len(system.legs[0].line.segments),
        bed=restrained_bed(source, stiffened=stiffened),
    )


def restrained_bed(source: Published, *, stiffened: bool = True) -> RestrainedBed:
    """Restraint of the source's run: nodes up to the second joint held, EA a hundredfold or not."""
    from catopt.fem import RestrainedBed

    return RestrainedBed(
        grounded_length=source.inputs["grounded_length_m"],
        EA_multiplier=source.inputs["EA_multiplier"] if stiffened else 1.0,
    )


@cache
def free_bed() -> StaticComparison:
    """Solve with a bed that only pushes and the printed EA, by closed form and truss model."""
    from catopt.verify.line import verify_system

    return verify_system(turret(published(NAME)), elements=BARS, tolerance=TOLERANCE)


def _of_truss(truss: TrussSystem) -> _Answer:
    """Read what S4 prints: the tensions are those of the first and the last bar."""
    return _Answer(
        offset=-truss.position[0],
        fairlead=max(float(line.tension[-1]) for line in truss.lines) / KN,
        anchor=max(float(line.tension[0]) for line in truss.lines) / KN,
    )


def _on_free_bed() -> _Answer:
    """Offset and largest tensions on the bed that only pushes, by closed form."""
    found = free_bed()
    lines = range(len(found.lines))
    return _Answer(
        offset=-found.of("position_x").closed_form,
        fairlead=max(found.of("fairlead_tension", k).closed_form for k in lines) / KN,
        anchor=max(found.of("anchor_tension", k).closed_form for k in lines) / KN,
    )


# ------------------------------------------------------------------ printed numbers


def _items(source: Published) -> tuple[Item, ...]:
    run = as_run()
    computed = dict(zip(_PRINTED, astuple(_of_truss(run)), strict=True))
    free = _on_free_bed().rounded
    remarks = {
        key: Message("reproduce.on_free_bed", value=f"{value} {key.rpartition('_')[2]}")
        for key, value in zip(_PRINTED, free, strict=True)
    }
    return (
        *compare(source, "MOORING_2017", computed, remarks, "truss"),
        *(item for k in _LINES for item in _line_items(source, k, run.lines[k])),
        *(_few_digits(check) for check in compare(source, "OrcaFlex", computed, remarks, "truss")),
    )


def _few_digits(item: Item) -> Item:
    """Show a number that differs to as many digits as are of use, not to all that were printed."""
    decimals = 4 if item.unit == "m" else 2
    text = f"{item.computed:.{decimals}f}"
    return replace(item, judgement=replace(item.judgement, computed_text=text))


def _line_items(source: Published, index: int, line: TrussSolution) -> tuple[Item, ...]:
    """Judge the printed tensions of a line, from the turret."""
    method = Message("reproduce.mooring_2017_line", number=index + 1)
    tensions = [float(T) / KN for T in line.tension[::-1][:_PRINTED_BARS]]
    computed = dict(zip(source.printed[method], tensions, strict=True))
    return compare(source, method, computed, computed_by="truss")


def _leeward(source: Published, run: TrussSystem) -> tuple[Item, ...]:
    """Judge those of lines 4 to 9."""
    return tuple(item for k in _LEEWARD for item in _line_items(source, k, run.lines[k]))


# ------------------------------------------------------------------ findings


def _about_the_leeward_lines(source: Published) -> str:
    """Say how the six digits of lines 4 to 9 come out, and by which weight."""
    runs = (
        as_run(),
        as_run(gravity=_OWN_GRAVITY),
        as_run(gravity=_OWN_GRAVITY, hanging=_HANGING),
    )
    ours, own, found = (_leeward(source, run) for run in runs)
    off = [
        sum(100.0 * ((item.computed or 0.0) / item.published - 1.0) for item in reach) / len(reach)
        for reach in (ours, own)
    ]
    return Message(
        "reproduce.leeward_lines",
        count=len(ours),
        off=-off[0],
        gravity=_OWN_GRAVITY,
        own=off[1],
        weight=_HANGING,
        printed=source.series["submerged_mass_kg_per_m"][-1],
        met=sum(item.verdict == "reproduces" for item in found),
    )


def _about_the_bed() -> str:
    free = _on_free_bed()
    return Message(
        "reproduce.held_down_both_directions_bed",
        pull=-min(float(reaction) for reaction in as_run().lines[_LOADED].bed_reaction) / KN,
        offset=free.offset,
        grounded=free_bed().of("grounded_length", _LOADED).closed_form,
        tension=free.fairlead,
    )


def _about_orcaflex(source: Published) -> str:
    printed = source.printed["OrcaFlex"]
    ours = astuple(_of_truss(as_run()))
    offset, fairlead, anchor = (
        100.0 * (printed[key].value / value - 1.0)
        for key, value in zip(_PRINTED, ours, strict=True)
    )
    return Message(
        "reproduce.offset_printed_for_orcaflex_m",
        offset=printed["turret_offset_m"].text,
        share=offset,
        fairlead=fairlead,
        anchor=anchor,
    )


def _about_the_azimuths(source: Published) -> str:
    printed = ", ".join(f"{value:g}" for value in source.series["azimuth_printed_deg"][:3])
    lines = as_run(azimuths="azimuth_printed_deg").lines[:2]
    first, second = (float(line.tension[-1]) / KN for line in lines)
    return Message(
        "reproduce.text_puts_lines_group_5", azimuths=printed, first=first, second=second
    )


# ------------------------------------------------------------------ side by side


def _restraints(source: Published) -> SideBySide:
    """Set print, run and the two choices, one at a time, side by side."""
    answers: dict[str, _Answer] = {
        Message("reproduce.printed_by", program=name): _Answer(
            *(source.printed[name][key].value for key in _PRINTED)
        )
        for name in ("MOORING_2017", "OrcaFlex")
    }
    # Solve with a bed that only pushes and the stiffened lines, in closed form.
    from catopt.mooring.solution import solve_system

    system = turret(source)
    factor, segments = source.inputs["EA_multiplier"], system.legs[0].line.segments
    stiff = [replace(segment, EA=factor * segment.EA) for segment in segments]
    closed = solve_system(with_segments(system, stiff))
    answers |= {
        "as run: held both ways, 100 EA": _of_truss(as_run()),
        "held both ways, printed EA": _of_truss(as_run(stiffened=False)),
        "pushes only, 100 EA": _Answer(
            offset=-closed.offset[0],
            fairlead=max(line.tension for line in closed.lines) / KN,
            anchor=max(line.solution.anchor.tension for line in closed.lines) / KN,
        ),
        "pushes only, printed EA": _on_free_bed(),
    }
    return SideBySide(
        "What the two choices make",
        (
            "bed and EA",
            in_unit("turret offset", "m"),
            in_unit("at the turret", "kN"),
            in_unit("at the anchor", "kN"),
        ),
        tuple((name, *answer.rounded) for name, answer in answers.items()),
    )


def _both_models() -> SideBySide:
    """Set closed form and truss model on the bed that only pushes side by side."""
    found = free_bed()
    rows: list[tuple[str, ...]] = [
        (in_unit("offset", "m"), *_pair(found.of("position_x"), -1.0, 4))
    ]
    for k in range(len(found.lines)):
        for quantity, key in (
            ("fairlead_tension", "reproduce.at_the_turret"),
            ("anchor_tension", "reproduce.line_anchor"),
        ):
            said = Message(key, number=k + 1)
            rows.append((said, *_pair(found.of(quantity, k), 1.0 / KN, 2)))
    return SideBySide(
        "A bed that only pushes and the printed EA, by both models",
        ("quantity", "closed form", "truss", "within 0.01 %"),
        tuple(rows),
    )


def _pair(each: Compared, factor: float, digits: int) -> tuple[str, str, str]:
    exact, truss = factor * each.closed_form, factor * each.extrapolated
    return f"{exact:.{digits}f}", f"{truss:.{digits}f}", "yes" if each.agrees else "no"


def _laid(line: TrussSolution, *, held: bool) -> MooredLine:
    arc = published(NAME).inputs["grounded_length_m"] if held else line.grounded_length
    x, y, z = (tuple(float(value) for value in line.nodes[:, axis]) for axis in range(3))
    return MooredLine(x, y, z, tuple(bool(s <= arc) for s in line.arc))
