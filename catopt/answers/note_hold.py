"""What holds a line, in a note: a sinker or a drag anchor, sized step by step."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import partial
from typing import TYPE_CHECKING

from catopt.answers.blocks import Block, Step, Text, Trail
from catopt.answers.note import small
from catopt.answers.trail import step_of
from catopt.constants import STANDARD_GRAVITY
from catopt.model.anchor import sinker_needed
from catopt.quantities import QUANTITIES
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
    sinker, drag = note.sizing.sinker, note.sizing.drag_anchor
    size: SinkerSize | DragAnchorSize
    if drag is not None:
        size, key, steps = drag, "note_size.hold_about_drag", _drag_anchor(drag, note)
    elif sinker is not None:
        size, key, steps = sinker, "note_size.hold_about_sinker", _sinker(sinker, note)
    else:
        return
    yield Text(Message(key, held=what_holds(note)))
    yield Trail("size_hold", tuple(steps))
    smaller, larger = (
        "-" if mass is None else Message("sizing.measure", value=Measure("mass", mass))
        for mass in (size.smaller, size.larger)
    )
    yield small("note_size.hold_series", smaller=smaller, larger=larger)
    if drag is not None and drag.capacity.others:
        yield Text(Cited(drag.capacity.note), is_small=True)


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


def _sinker(of: SinkerSize, note: SizeNote) -> Iterator[Step]:
    H, V, mu, SF = of.horizontal_force, of.vertical_force, of.friction, of.safety_factor
    water, rho, g = note.sizing.case.site.water_density, of.density, STANDARD_GRAVITY
    sources, needed = note.sources, sinker_needed(H, V, mu, SF)
    numbers = {"H": H, "V": V, "μ": mu, "SF": SF, "ρ": rho, "ρw": water, "g": g, "W₁": needed}
    step = partial(step_of, numbers | {"m": of.mass, "W": of.submerged_weight})
    yield step("note_size.hold_pull", "H", _FORCE, H)
    yield step("note_size.hold_lift", "V", _LIFT, V)
    yield step("note_size.hold_friction", "μ", _NUMBER, mu, source=sources["friction"])
    yield step("note_size.hold_factor", "SF", _NUMBER, SF, source=sources["factor"])
    yield step("note_size.hold_density", "ρ", _DENSITY, rho, source=sources["density"])
    yield step("note_size.hold_water", "ρw", _DENSITY, water)
    yield step("note_size.hold_needed_weight", "W₁", _LIFT, needed, "{V} + {SF} · {H}/{μ}")
    formula = "{W₁}/({g} · (1 − {ρw}/{ρ}))"
    yield step("note_size.hold_needed_mass", "m₁", _MASS, of.needed_mass, formula)
    yield step("note_size.hold_next", "m", _MASS, of.mass)
    formula = "{g} · {m} · (1 − {ρw}/{ρ})"
    yield step("note_size.hold_weight", "W", _LIFT, of.submerged_weight, formula)
    if of.factor is not None:
        yield step("note_size.hold_reached", "", _NUMBER, of.factor, "{μ} · ({W} − {V})/{H}")
    own = None if note.sizing.point.anchor is None else note.sizing.point.anchor.mass
    if own is not None and not math.isclose(own, of.mass):
        yield step("note_size.hold_own", "m", _MASS, own)


def _drag_anchor(of: DragAnchorSize, note: SizeNote) -> Iterator[Step]:
    H, SF, curve = of.horizontal_force, of.safety_factor, of.capacity.curve
    HR, mR, b = curve.reference_capacity, curve.reference_mass, curve.exponent
    Q, wanted, cited = of.capacity.capacity, SF * H, Cited(curve.source.text)
    numbers = {"H": H, "SF": SF, "HR": HR, "mR": mR, "b": b, "Q₁": wanted, "m": of.mass, "Q": Q}
    step = partial(step_of, numbers)
    yield step("note_size.hold_pull", "H", _FORCE, H)
    yield step("note_size.hold_factor", "SF", _NUMBER, SF, source=note.sources["factor"])
    yield step("note_size.hold_wanted", "Q₁", _FORCE, wanted, "{SF} · {H}")
    yield step("note_size.hold_reference", "HR", _FORCE, HR, source=cited)
    yield step("note_size.hold_reference_mass", "mR", _MASS, mR, source=cited)
    yield step("note_size.hold_exponent", "b", _NUMBER, b, source=cited)
    is_by_curve = H > 0.0 and math.isclose(curve.mass(wanted), of.needed_mass)
    formula = "{mR} · ({Q₁}/{HR})^(1/{b})" if is_by_curve else ""
    yield step("note_size.hold_needed_mass", "m₁", _MASS, of.needed_mass, formula)
    yield step("note_size.hold_next", "m", _MASS, of.mass)
    yield step("note_size.hold_capacity", "Q", _FORCE, Q, "{HR} · ({m}/{mR})^{b}")
    if of.factor is not None:
        yield step("note_size.hold_reached", "", _NUMBER, of.factor, "{Q}/{H}")
