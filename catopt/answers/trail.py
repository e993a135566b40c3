"""The equation trail: each result of a line with its equation and its numbers put in.

Everything is worked out here once more with the formulas of docs/theory.md as they are printed
there, from the forces of the solution, so that a checker with a pocket calculator can follow.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

from catopt.answers.blocks import Block, Rows, Step, Table, Text, Trail, exact, tabulate
from catopt.quantities import Quantity
from catopt.words import Message, term

if TYPE_CHECKING:
    from catopt.catenary.layout import Stretch
    from catopt.catenary.solution import Solution

_FLAT = 0.1
"""Below this |y| a piece is so nearly straight that the printed logarithm loses its digits."""
_M, _N, _KG, _NUMBER = (exact(unit) for unit in ("m", "N", "kg", ""))
DEGREES = Quantity("exact", "", "", "rad", "deg", math.pi / 180.0, 9, "significant")


@dataclass(frozen=True)
class TrailPiece:
    """One stretch of the line, from the anchor up: in m, N/m and N.

    `number` is that of its uniform piece, from 1 at the anchor; V and T are vertical force and
    tension at its lower and its upper end, `dx` and `dz` how far and how high it reaches, and
    `equation` is what `dx` was worked out by.
    """

    number: int
    on_bed: bool
    length: float
    weight: float
    EA: float
    V1: float
    V2: float
    T1: float
    T2: float
    dx: float
    dz: float
    equation: str


def equation_trail(solution: Solution) -> Iterator[Block]:
    """Follow a line through the equations: the steps, and its pieces where it has several."""
    yield Text(Message("note.equations_about"))
    if solution.regime == "slack":
        yield Text(Message("note.equations_slack"))
    pieces = pieces_of(solution)
    if pieces:
        H = _NUMBER.format(solution.horizontal_force)
        yield Text(Message("note.equations_general", H=H))
        yield _pieces_table(pieces)
    yield Trail("trail", steps_of(solution), Message("note.equations_stated"))


def step_of(
    numbers: Mapping[str, float],
    key: str,
    symbol: str,
    quantity: Quantity,
    value: float | None,
    formula: str = "",
    stated: float | None = None,
    equation: str = "",
    *,
    terms: Iterable[tuple[float, ...]] = (),
    source: str = "",
) -> Step:
    """Make a step by the key of its name; `numbers` has those of all steps of its trail."""
    used, name, sums = numbers if "{" in formula else {}, Message(key), tuple(terms)
    return Step(name, value, quantity, symbol, formula, used, sums, stated, equation, source)


def is_uniform(solution: Solution) -> bool:
    """Whether the equations of S1 and S2 for one line that does not stretch hold."""
    segments = solution.line.segments
    return (
        len(segments) == 1
        and not solution.line.point_loads
        and segments[0].is_inextensible
        and segments[0].submerged_weight > 0.0
        and (
            solution.regime == "suspended"
            or (solution.regime == "grounded" and solution.anchor_height == 0.0)
        )
    )


def steps_of(solution: Solution) -> tuple[Step, ...]:
    """Follow a solution, in closed form or by the swarm, through the equations."""
    if not is_uniform(solution):
        steps = _sums(solution, pieces_of(solution))
    else:
        steps = _hanging(solution) if solution.regime == "suspended" else _grounded(solution)
    return (*steps, *_mass(solution))


def pieces_of(solution: Solution) -> tuple[TrailPiece, ...]:
    """Work out what each stretch of a line of several pieces contributes; none of one alone."""
    if is_uniform(solution):
        return ()
    return tuple(_piece(stretch) for stretch in solution.stretches if stretch.length > 0.0)


# ------------------------------------------------------------------ one uniform line


def _hanging(solution: Solution) -> Iterator[Step]:
    """Follow a line that hangs free, by S1."""
    segment, anchor, fairlead = solution.line.segments[0], solution.anchor, solution.fairlead
    H, w, L = solution.horizontal_force, segment.submerged_weight, segment.length
    h = solution.fairlead_height - solution.anchor_height
    a, t = H / w, math.tan(anchor.angle)
    q = L / a + t
    height = a * math.hypot(1.0, q) - a * math.hypot(1.0, t)
    span = a * math.asinh(q) - a * math.asinh(t)
    T1, T2 = H * math.hypot(1.0, t), H * math.hypot(1.0, q)
    numbers = {"H": H, "w": w, "L": L, "h": h, "a": a, "t": t, "q": q, "T(0)": T1}
    step = partial(step_of, numbers | {"θ₀": math.degrees(anchor.angle)})
    low, high = "{a} √(1 + {t:()}²)", "{a} √(1 + {q:()}²)"
    yield _height(solution)
    yield step("trail.parameter", "a", _M, a, "{H} / {w}")
    yield step("trail.slope", "t", _NUMBER, t, "tan {θ₀:°}", anchor.vertical_force / H)
    yield step("trail.upper_slope", "q", _NUMBER, q, "{L} / {a} + {t:()}")
    yield step("trail.height_met", "h", _M, height, f"{high} − {low}", h, "S1 (4)")
    reach = "{a} asinh {q:()} − {a} asinh {t:()}"
    yield step("quantities.span", "S", _M, span, reach, solution.span, "S1 (5)")
    root = "{H} √(1 + {t:()}²)"
    yield step("trail.anchor_tension", "T(0)", _N, T1, root, anchor.tension, "S1 (7)")
    root = "{H} √(1 + {q:()}²)"
    yield step("trail.fairlead_tension", "T(L)", _N, T2, root, fairlead.tension, "S1 (7)")
    rise = "{T(0)} + {w} · {h}"
    yield step("trail.tension_rise", "T(L)", _N, T1 + w * h, rise, fairlead.tension, "C1")


def _grounded(solution: Solution) -> Iterator[Step]:
    """Follow a line of which a part lies on the bed, by S2."""
    segment, anchor, fairlead = solution.line.segments[0], solution.anchor, solution.fairlead
    H, w, L = solution.horizontal_force, segment.submerged_weight, segment.length
    h, mu = solution.fairlead_height, solution.seabed_friction
    a = H / w
    least = math.sqrt(h * (h + 2.0 * a))
    d = L - least
    span = d + a * math.asinh(least / a)
    tension = max(0.0, H - mu * w * d)
    lift = 0.5 * w * (L * L / h - h)
    numbers = {"H": H, "w": w, "L": L, "h": h, "μ": mu, "a": a, "L_min": least, "d": d}
    step = partial(step_of, numbers)
    yield step("trail.parameter", "a", _M, a, "{H} / {w}")
    root, hung = "√({h} ({h} + 2 · {a}))", solution.suspended_length
    yield step("trail.suspended", "L_min", _M, least, root, hung, "S2 (1)")
    yield step("trail.grounded", "d", _M, d, "{L} − {L_min}", solution.grounded_length)
    reach = "{d} + {a} asinh({L_min} / {a})"
    yield step("quantities.span", "S", _M, span, reach, solution.span, "C2")
    rise = "{H} + {w} · {h}"
    yield step("trail.fairlead_tension", "T", _N, H + w * h, rise, fairlead.tension, "S2 (4)")
    held = "max(0, {H} − {μ} · {w} · {d})"
    yield step("trail.anchor_tension", "T(d)", _N, tension, held, anchor.tension, "C7")
    force = "({w} / 2) ({L}² / {h} − {h})"
    yield step("trail.lift_force", "H₁", _N, lift, force, equation="S2, below (4)")


def _height(solution: Solution) -> Step:
    top, foot = solution.fairlead_height, solution.anchor_height
    numbers = {"z_F": top, "z_A": foot}
    return step_of(numbers, "trail.height", "h", _M, top - foot, "{z_F} − {z_A}")


# ------------------------------------------------------------------ a line of several pieces


def _piece(stretch: Stretch) -> TrailPiece:
    H, V1 = stretch.horizontal_force, stretch.vertical_force
    length, weight, compliance = stretch.length, stretch.submerged_weight, stretch.compliance
    EA = math.inf if compliance == 0.0 else 1.0 / compliance
    number = stretch.piece + 1
    if stretch.on_bed:
        T2 = H + stretch.friction * length
        dx = length * (1.0 + 0.5 * (H + T2) * compliance) * stretch.gathered
        return TrailPiece(number, True, length, weight, EA, 0.0, 0.0, H, T2, dx, 0.0, "C8")
    V2 = V1 + weight * length
    T1, T2 = math.hypot(H, V1), math.hypot(H, V2)
    m = T1 + T2
    sine = (V1 + V2) / m if m > 0.0 else stretch.slope
    dz = length * sine + 0.5 * length * (V1 + V2) * compliance
    reach, equation = _reach(stretch, V2, m)
    dx = (reach + H * length * compliance) * stretch.gathered
    return TrailPiece(number, False, length, weight, EA, V1, V2, T1, T2, dx, dz, f"{equation}, C5")


def _reach(stretch: Stretch, V2: float, m: float) -> tuple[float, str]:
    """How far a hanging stretch reaches before it stretches, m, and by which equation."""
    H, V1 = stretch.horizontal_force, stretch.vertical_force
    length, weight = stretch.length, stretch.submerged_weight
    if m == 0.0:  # neither weight nor force: straight, and as steep as its ends ask
        return length * math.sqrt(1.0 - stretch.slope**2), "C6"
    if H == 0.0:
        return 0.0, "C3"
    y = weight * length / m
    if abs(y) < _FLAT:
        return 2.0 * H * length / m * (math.atanh(y) / y if y else 1.0), "C6"
    return H / weight * (math.asinh(V2 / H) - math.asinh(V1 / H)), "C3"


def _pieces_table(pieces: tuple[TrailPiece, ...]) -> Table:
    of, lies = Rows(pieces), ("note.equations_hangs", "note.equations_on_bed")
    return tabulate(
        "pieces",
        of.texts("note.equations_piece", "number"),
        of.texts("note.equations_lies", lambda each: Message(lies[each.on_bed])),
        of.measured(_M, "length", term("l")),
        of.measured(exact("N/m"), "weight", term("w")),
        *(of.measured(_N, symbol, term(symbol)) for symbol in ("EA", "V1", "V2", "T1", "T2")),
        of.measured(_M, "dx", term("Δx")),
        of.measured(_M, "dz", term("Δz")),
        of.texts("note.equations_by", "equation"),
        caption=Message("note.equations_pieces"),
    )


def _sums(solution: Solution, pieces: tuple[TrailPiece, ...]) -> Iterator[Step]:
    reaches, rises = [(each.dx,) for each in pieces], [(each.dz,) for each in pieces]
    span, rise = (math.fsum(value for (value,) in terms) for terms in (reaches, rises))
    height = solution.fairlead_height - solution.anchor_height
    step = partial(step_of, {})
    yield _height(solution)
    yield step("quantities.span", "S", _M, span, "Σ Δx", solution.span, terms=reaches)
    yield step("trail.height_met", "h", _M, rise, "Σ Δz", height, terms=rises)
    anchor, fairlead = solution.anchor, solution.fairlead
    for key, end in (("trail.fairlead_tension", fairlead), ("trail.anchor_tension", anchor)):
        forces = {"H": end.horizontal_force, "V": end.vertical_force}
        tension = math.hypot(*forces.values())
        yield step_of(forces, key, "T", _N, tension, "√({H:()}² + {V:()}²)", end.tension)
    H, V = forces.values()
    if H > 0.0:
        angle = math.atan(V / H)
        step = partial(step_of, forces)
        yield step("trail.anchor_angle", "θ₀", DEGREES, angle, "atan({V} / {H})", anchor.angle)


def _mass(solution: Solution) -> Iterator[Step]:
    """Add up the mass in air, where all of it is known."""
    line = solution.line
    if line.mass is None:
        return
    terms: list[tuple[float, ...]] = []
    terms += [(each.length, each.mass) for each in line.segments if each.mass is not None]
    terms += [(each.mass,) for each in line.point_loads if each.mass is not None]
    total = math.fsum(map(math.prod, terms))
    formula = "Σ m l + Σ m_W" if line.point_loads else "Σ m l"
    yield step_of({}, "trail.mass", "m", _KG, total, formula, line.mass, terms=terms)
