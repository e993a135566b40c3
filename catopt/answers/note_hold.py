"""What holds a line, in a note: a sinker or a drag anchor, sized step by step."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from catopt.answers.blocks import Block, Step, Text, Trail
from catopt.constants import STANDARD_GRAVITY
from catopt.model.anchor import sinker_needed
from catopt.quantities import QUANTITIES, Quantity
from catopt.words import Cited, Measure, Message, term

if TYPE_CHECKING:
    from catopt.loads.drag_anchor import DragAnchorSize
    from catopt.loads.sinker import SinkerSize
    from catopt.notes.size import SizeNote

_FORCE, _LIFT, _MASS, _NUMBER, _DENSITY = (
    QUANTITIES[key]
    for key in ("horizontal_force", "vertical_force", "mass", "coefficient", "density")
)


def hold_blocks(note: SizeNote) -> Iterator[Block]:
    """Follow how what holds the line was sized; nothing where that was not."""
    of = note.sizing
    size = of.drag_anchor or of.sinker
    if size is None:
        return
    key = "note_size.hold_about_sinker" if of.drag_anchor is None else "note_size.hold_about_drag"
    yield Text(Message(key, held=what_holds(note)))
    yield Trail("size_hold", tuple(_steps(note)))
    smaller, larger = (
        "-" if mass is None else Message("sizing.measure", value=Measure("mass", mass))
        for mass in (size.smaller, size.larger)
    )
    yield Text(Message("note_size.hold_series", smaller=smaller, larger=larger), is_small=True)
    if of.drag_anchor is not None and of.drag_anchor.capacity.others:
        yield Text(Cited(of.drag_anchor.capacity.note), is_small=True)


def what_holds(note: SizeNote) -> str:
    """Say in a few words what holds the line; empty where nothing was sized."""
    of = note.sizing
    if of.drag_anchor is not None:
        size = of.drag_anchor
        values = {"name": size.anchor, "mass": f"{size.mass / 1e3:g}", "soil": term(size.soil)}
        return Message("note_size.hold_drag", **values)
    if of.sinker is None:
        return ""
    key = "note_size.hold_steel" if of.sinker.material == "steel" else "note_size.hold_concrete"
    mass = of.sinker.mass if of.point.anchor is None else of.point.anchor.mass or of.sinker.mass
    return Message(key, mass=f"{mass / 1e3:g}")


def _steps(note: SizeNote) -> Iterator[Step]:
    of = note.sizing
    if of.drag_anchor is not None:
        yield from _drag_anchor(of.drag_anchor, note)
    elif of.sinker is not None:
        yield from _sinker(of.sinker, note)


def _step(
    key: str,
    symbol: str,
    quantity: Quantity,
    value: float | None,
    formula: str = "",
    numbers: Mapping[str, float] | None = None,
    *,
    source: str = "",
) -> Step:
    name = Message(f"note_size.hold_{key}")
    return Step(name, value, quantity, symbol, formula, numbers or {}, source=source)


def _sinker(of: SinkerSize, note: SizeNote) -> Iterator[Step]:
    H, V, mu, SF = of.horizontal_force, of.vertical_force, of.friction, of.safety_factor
    water, rho, g = note.sizing.case.site.water_density, of.density, STANDARD_GRAVITY
    sources = note.sources
    yield _step("pull", "H", _FORCE, H)
    yield _step("lift", "V", _LIFT, V)
    yield _step("friction", "μ", _NUMBER, mu, source=sources["friction"])
    yield _step("factor", "SF", _NUMBER, SF, source=sources["factor"])
    yield _step("density", "ρ", _DENSITY, rho, source=sources["density"])
    yield _step("water", "ρw", _DENSITY, water)
    weight = sinker_needed(H, V, mu, SF)
    floating = {"g": g, "ρw": water, "ρ": rho}
    yield _step(
        "needed_weight", "W₁", _LIFT, weight, "{V} + {SF} · {H}/{μ}",
        {"V": V, "SF": SF, "H": H, "μ": mu},
    )  # fmt: skip
    yield _step(
        "needed_mass", "m₁", _MASS, of.needed_mass, "{W₁}/({g} · (1 − {ρw}/{ρ}))",
        {"W₁": weight, **floating},
    )  # fmt: skip
    yield _step("next", "m", _MASS, of.mass)
    yield _step(
        "weight", "W", _LIFT, of.submerged_weight, "{g} · {m} · (1 − {ρw}/{ρ})",
        {"m": of.mass, **floating},
    )  # fmt: skip
    if of.factor is not None:
        yield _step(
            "reached", "", _NUMBER, of.factor, "{μ} · ({W} − {V})/{H}",
            {"μ": mu, "W": of.submerged_weight, "V": V, "H": H},
        )  # fmt: skip
    own = None if note.sizing.point.anchor is None else note.sizing.point.anchor.mass
    if own is not None and not math.isclose(own, of.mass):
        yield _step("own", "m", _MASS, own)


def _drag_anchor(of: DragAnchorSize, note: SizeNote) -> Iterator[Step]:
    H, SF, curve = of.horizontal_force, of.safety_factor, of.capacity.curve
    HR, mR, b = curve.reference_capacity, curve.reference_mass, curve.exponent
    cited = Cited(curve.source.text)
    yield _step("pull", "H", _FORCE, H)
    yield _step("factor", "SF", _NUMBER, SF, source=note.sources["factor"])
    yield _step("wanted", "Q₁", _FORCE, SF * H, "{SF} · {H}", {"SF": SF, "H": H})
    yield _step("reference", "HR", _FORCE, HR, source=cited)
    yield _step("reference_mass", "mR", _MASS, mR, source=cited)
    yield _step("exponent", "b", _NUMBER, b, source=cited)
    if H > 0.0 and math.isclose(curve.mass(SF * H), of.needed_mass):
        yield _step(
            "needed_mass", "m₁", _MASS, of.needed_mass, "{mR} · ({Q₁}/{HR})^(1/{b})",
            {"mR": mR, "Q₁": SF * H, "HR": HR, "b": b},
        )  # fmt: skip
    else:
        yield _step("needed_mass", "m₁", _MASS, of.needed_mass)
    yield _step("next", "m", _MASS, of.mass)
    capacity = of.capacity.capacity
    yield _step(
        "capacity", "Q", _FORCE, capacity, "{HR} · ({m}/{mR})^{b}",
        {"HR": HR, "m": of.mass, "mR": mR, "b": b},
    )  # fmt: skip
    if of.factor is not None:
        yield _step("reached", "", _NUMBER, of.factor, "{Q}/{H}", {"Q": capacity, "H": H})
