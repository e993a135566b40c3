"""What holds the line: a sinker or a drag anchor, sized step by step with the numbers put in."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from catopt.constants import STANDARD_GRAVITY
from catopt.loads.drag_anchor import DragAnchorSize
from catopt.loads.sinker import DENSITIES, FACTOR_SOURCE, SAFETY_FACTOR, SinkerSize
from catopt.loads.source import CALMAR, OWN, LoadSource
from catopt.model.anchor import sinker_needed
from catopt.notes.size import SizeNote
from catopt.quantities import QUANTITIES, Quantity
from catopt.render.texts import Words
from catopt.report.page.sizing.put_in import typeset_unit
from catopt.report.page.table import Cell, Heading, Table, measured

__all__ = ["Step", "hold", "steps"]

FORCE, MASS = QUANTITIES["horizontal_force"], QUANTITIES["mass"]
LIFT = QUANTITIES["vertical_force"]
NUMBER, DENSITY = QUANTITIES["coefficient"], QUANTITIES["density"]

GIVEN = "this note"
"""Source of what the user gave: it stands among the inputs."""

MATERIALS = {"concrete": "size_hold.concrete", "steel": "size_hold.steel"}
"""Keys of sinkers by their material."""


@dataclass(frozen=True)
class Step:
    """One step of the calculation.

    Attributes
    ----------
    key : str
        Of the text that says what it is.
    symbol : str
        Of it.
    quantity : Quantity
        What it is printed as.
    value : float or None
        SI.
    equation, put_in : str
        In symbols and with the numbers; empty for what is given.
    source : str
        Where a figure is from, as it is cited.
    """

    key: str
    symbol: str
    quantity: Quantity
    value: float | None
    equation: str = ""
    put_in: str = ""
    source: str = ""


def hold(note: SizeNote, words: Words) -> dict[str, Any] | None:
    """Build the table of steps; None where nothing was sized."""
    listed = steps(note)
    if not listed:
        return None
    headings = (
        Heading(words("table.what")),
        Heading(words("size_loads.formula")),
        Heading(words("table.value"), is_number=True),
        Heading(words("checks.source")),
    )
    of = note.sizing
    size = of.drag_anchor or of.sinker
    assert size is not None
    return {
        "table": Table("size_hold", headings, tuple(_row(each, words) for each in listed)),
        "held": held(note, words),
        "is_sinker": of.drag_anchor is None,
        "smaller": "–" if size.smaller is None else MASS.format(size.smaller, unit=True),
        "larger": "–" if size.larger is None else MASS.format(size.larger, unit=True),
        "note": _others(of.drag_anchor),
    }


def _others(of: DragAnchorSize | None) -> str:
    """Cite what other data sets say of a drag anchor; empty where there are none."""
    return of.capacity.note if of is not None and of.capacity.others else ""


def held(note: SizeNote, words: Words) -> str:
    """Say in a few words what holds the line; empty where nothing was sized."""
    of = note.sizing
    if of.drag_anchor is not None:
        size = of.drag_anchor
        soil = words.sentence(size.soil).text
        return words("size_hold.drag", name=size.anchor, mass=f"{size.mass / 1e3:g}", soil=soil)
    if of.sinker is None:
        return ""
    mass = of.sinker.mass if of.point.anchor is None else of.point.anchor.mass or of.sinker.mass
    return words(MATERIALS[of.sinker.material], mass=f"{mass / 1e3:g}")


def steps(note: SizeNote) -> list[Step]:
    """List the steps of the calculation; none where nothing was sized."""
    of = note.sizing
    if of.drag_anchor is not None:
        return list(_drag_anchor(of.drag_anchor))
    if of.sinker is None:
        return []
    own = None if of.point.anchor is None else of.point.anchor.mass
    return list(_sinker(of.sinker, of.case.site.water_density, own))


def _row(of: Step, words: Words) -> tuple[Cell, ...]:
    formula = of.symbol
    cited = of.source not in ("", GIVEN)
    if of.equation:
        formula += f" = {of.equation}"
    if of.put_in:
        formula += f"\n= {of.put_in}"
    return (
        Cell(words(of.key), style="words"),
        Cell(formula, style="formula"),
        Cell(typeset_unit(measured(of.quantity, of.value, unit=True).text), of.value),
        Cell(
            of.source if cited else words.name(of.source), lang="en" if cited else "", style="words"
        ),
    )


def _sinker(of: SinkerSize, water_density: float, own_mass: float | None) -> Iterator[Step]:
    H, V, mu, SF = of.horizontal_force, of.vertical_force, of.friction, of.safety_factor
    source = GIVEN if of.friction_source is None else of.friction_source.text
    yield Step("size_hold.pull", "H", FORCE, H)
    yield Step("size_hold.lift", "V", LIFT, V)
    yield Step("size_hold.friction", "μ", NUMBER, mu, source=source)
    yield Step(
        "size_hold.factor", "SF", NUMBER, SF,
        source=FACTOR_SOURCE.text if math.isclose(SF, SAFETY_FACTOR) else GIVEN,
    )  # fmt: skip
    yield Step("size_hold.density", "ρ", DENSITY, of.density, source=_density_source(of))
    yield Step("size_hold.water", "ρw", DENSITY, water_density)
    weight = sinker_needed(H, V, mu, SF)
    put_in = f"{V:.9g} + {SF:g} · {H:.9g}/{mu:g}"
    yield Step("size_hold.needed_weight", "W₁", LIFT, weight, "V + SF H/μ", put_in)
    floating = f"{STANDARD_GRAVITY:g} · (1 − {water_density:g}/{of.density:g})"
    yield Step(
        "size_hold.needed_mass", "m₁", MASS, of.needed_mass,
        "W₁/(g (1 − ρw/ρ))", f"{weight:.9g}/({floating})",
    )  # fmt: skip
    yield Step("size_hold.next", "m", MASS, of.mass)
    yield Step(
        "size_hold.weight", "W", LIFT, of.submerged_weight,
        "g m (1 − ρw/ρ)",
        f"{STANDARD_GRAVITY:g} · {of.mass:g} · (1 − {water_density:g}/{of.density:g})",
    )  # fmt: skip
    if of.factor is not None:
        yield Step(
            "size_hold.reached", "μ (W − V)/H", NUMBER, of.factor,
            put_in=f"{mu:g} · ({of.submerged_weight:.9g} − {V:.9g})/{H:.9g}",
        )  # fmt: skip
    if own_mass is not None and not math.isclose(own_mass, of.mass):
        yield Step("size_hold.own", "m", MASS, own_mass)


def _density_source(of: SinkerSize) -> str:
    """Cite where the density is from."""
    if not math.isclose(of.density, DENSITIES[of.material]):
        return GIVEN
    if of.material == "steel":
        return LoadSource(CALMAR, "7.2", "A").text
    return LoadSource(OWN, "recalled", "R").text


def _drag_anchor(of: DragAnchorSize) -> Iterator[Step]:
    H, SF, curve = of.horizontal_force, of.safety_factor, of.capacity.curve
    HR, mR, b = curve.reference_capacity, curve.reference_mass, curve.exponent
    yield Step("size_hold.pull", "H", FORCE, H)
    yield Step(
        "size_hold.factor", "SF", NUMBER, SF,
        source=GIVEN if of.factor_source is None else of.factor_source.text,
    )  # fmt: skip
    yield Step("size_hold.wanted", "Q₁", FORCE, SF * H, "SF H", f"{SF:g} · {H:.9g}")
    yield Step("size_hold.reference", "HR", FORCE, HR, source=curve.source.text)
    yield Step("size_hold.reference_mass", "mR", MASS, mR, source=curve.source.text)
    yield Step("size_hold.exponent", "b", NUMBER, b, source=curve.source.text)
    is_of_curve = H > 0.0 and math.isclose(curve.mass(SF * H), of.needed_mass)
    yield Step(
        "size_hold.needed_mass", "m₁", MASS, of.needed_mass,
        "mR (Q₁/HR)^(1/b)" if is_of_curve else "",
        f"{mR:g} · ({SF * H:.9g}/{HR:.9g})^(1/{b:g})" if is_of_curve else "",
    )  # fmt: skip
    yield Step("size_hold.next", "m", MASS, of.mass)
    yield Step(
        "size_hold.capacity", "Q", FORCE, of.capacity.capacity,
        "HR (m/mR)^b", f"{HR:.9g} · ({of.mass:g}/{mR:g})^{b:g}",
    )  # fmt: skip
    if of.factor is not None:
        put_in = f"{of.capacity.capacity:.9g}/{H:.9g}"
        yield Step("size_hold.reached", "Q/H", NUMBER, of.factor, put_in=put_in)
