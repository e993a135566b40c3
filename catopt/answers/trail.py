"""The equation trail: each result of a line with its equation and its numbers put in.

Everything is worked out here once more with the formulas of docs/theory.md as they are printed
there, from the forces of the solution, so that a checker with a pocket calculator can follow.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from catopt.answers.blocks import Block, Column, Step, Table, Text, Trail, exact
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
class Piece:
    """One stretch of the line, from the anchor up.

    Attributes
    ----------
    number : int
        Which uniform piece it is of, counted from 1 at the anchor.
    on_bed : bool
        Whether it lies on the bed.
    length, weight, EA : float
        m, N/m, N.
    V1, V2, T1, T2 : float
        Vertical force and tension at its lower and its upper end, N.
    dx, dz : float
        How far and how high it reaches, m.
    equation : str
        What dx was worked out by.
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


def is_uniform(solution: Solution) -> bool:
    """Whether the equations of S1 and S2 for one line that does not stretch hold."""
    segments = solution.line.segments
    return (
        len(segments) == 1
        and not solution.line.point_loads
        and math.isinf(segments[0].EA)
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


def pieces_of(solution: Solution) -> tuple[Piece, ...]:
    """Work out what each stretch of a line of several pieces contributes; none of one alone."""
    if is_uniform(solution):
        return ()
    return tuple(_piece(stretch) for stretch in solution.stretches if stretch.length > 0.0)


def _step(
    name: str, value: float, quantity: Quantity, formula: str, *, symbol: str = "", **more: object
) -> Step:
    said = Message(f"trail.{name}")
    return Step(said, value, quantity, symbol, formula, **more)  # type: ignore[arg-type]


# ------------------------------------------------------------------ one uniform line


def _hanging(solution: Solution) -> Iterator[Step]:
    """Follow a line that hangs free, by S1."""
    segment = solution.line.segments[0]
    H, w, L = solution.horizontal_force, segment.submerged_weight, segment.length
    h = solution.fairlead_height - solution.anchor_height
    a, t = H / w, math.tan(solution.anchor.angle)
    q = L / a + t
    slopes = {"a": a, "q": q, "t": t}
    yield _height(solution)
    yield _step("parameter", a, _M, "{H} / {w}", symbol="a", numbers={"H": H, "w": w})
    yield _step(
        "slope", t, _NUMBER, "tan {θ₀:°}", symbol="t",
        numbers={"θ₀": math.degrees(solution.anchor.angle)},
        stated=solution.anchor.vertical_force / H,
    )  # fmt: skip
    yield _step(
        "upper_slope", q, _NUMBER, "{L} / {a} + {t:()}", symbol="q",
        numbers={"L": L, "a": a, "t": t},
    )  # fmt: skip
    yield _step(
        "height_met", a * math.hypot(1.0, q) - a * math.hypot(1.0, t), _M,
        "{a} √(1 + {q:()}²) − {a} √(1 + {t:()}²)",
        symbol="h", numbers=slopes, stated=h, equation="S1 (4)",
    )  # fmt: skip
    yield _step(
        "span", a * math.asinh(q) - a * math.asinh(t), _M,
        "{a} asinh {q:()} − {a} asinh {t:()}",
        symbol="S", numbers=slopes, stated=solution.span, equation="S1 (5)",
    )  # fmt: skip
    T1, T2 = H * math.hypot(1.0, t), H * math.hypot(1.0, q)
    yield _step(
        "anchor_tension", T1, _N, "{H} √(1 + {t:()}²)", symbol="T(0)",
        numbers={"H": H, "t": t}, stated=solution.anchor.tension, equation="S1 (7)",
    )  # fmt: skip
    yield _step(
        "fairlead_tension", T2, _N, "{H} √(1 + {q:()}²)", symbol="T(L)",
        numbers={"H": H, "q": q}, stated=solution.fairlead.tension, equation="S1 (7)",
    )  # fmt: skip
    yield _step(
        "tension_rise", T1 + w * h, _N, "{T(0)} + {w} · {h}", symbol="T(L)",
        numbers={"T(0)": T1, "w": w, "h": h}, stated=solution.fairlead.tension, equation="C1",
    )  # fmt: skip


def _grounded(solution: Solution) -> Iterator[Step]:
    """Follow a line of which a part lies on the bed, by S2."""
    segment = solution.line.segments[0]
    H, w, L = solution.horizontal_force, segment.submerged_weight, segment.length
    h, mu = solution.fairlead_height, solution.seabed_friction
    a = H / w
    least = math.sqrt(h * (h + 2.0 * a))
    yield _step("parameter", a, _M, "{H} / {w}", symbol="a", numbers={"H": H, "w": w})
    yield _step(
        "suspended", least, _M, "√({h} ({h} + 2 · {a}))", symbol="L_min",
        numbers={"h": h, "a": a}, stated=solution.suspended_length, equation="S2 (1)",
    )  # fmt: skip
    d = L - least
    yield _step(
        "grounded", d, _M, "{L} − {L_min}", symbol="d",
        numbers={"L": L, "L_min": least}, stated=solution.grounded_length,
    )  # fmt: skip
    yield _step(
        "span", d + a * math.asinh(least / a), _M, "{d} + {a} asinh({L_min} / {a})", symbol="S",
        numbers={"d": d, "a": a, "L_min": least}, stated=solution.span, equation="C2",
    )  # fmt: skip
    yield _step(
        "fairlead_tension", H + w * h, _N, "{H} + {w} · {h}", symbol="T",
        numbers={"H": H, "w": w, "h": h}, stated=solution.fairlead.tension, equation="S2 (4)",
    )  # fmt: skip
    yield _step(
        "anchor_tension", max(0.0, H - mu * w * d), _N, "max(0, {H} − {μ} · {w} · {d})",
        symbol="T(d)", numbers={"H": H, "μ": mu, "w": w, "d": d},
        stated=solution.anchor.tension, equation="C7",
    )  # fmt: skip
    yield _step(
        "lift_force", 0.5 * w * (L * L / h - h), _N, "({w} / 2) ({L}² / {h} − {h})", symbol="H₁",
        numbers={"w": w, "L": L, "h": h}, equation="S2, below (4)",
    )  # fmt: skip


def _height(solution: Solution) -> Step:
    top, foot = solution.fairlead_height, solution.anchor_height
    numbers = {"z_F": top, "z_A": foot}
    return _step("height", top - foot, _M, "{z_F} − {z_A}", symbol="h", numbers=numbers)


# ------------------------------------------------------------------ a line of several pieces


def _piece(stretch: Stretch) -> Piece:
    """Work out what one stretch contributes."""
    H, V1 = stretch.horizontal_force, stretch.vertical_force
    length, weight, compliance = stretch.length, stretch.submerged_weight, stretch.compliance
    EA = math.inf if compliance == 0.0 else 1.0 / compliance
    number = stretch.piece + 1
    if stretch.on_bed:
        T2 = H + stretch.friction * length
        dx = length * (1.0 + 0.5 * (H + T2) * compliance) * stretch.gathered
        return Piece(number, True, length, weight, EA, 0.0, 0.0, H, T2, dx, 0.0, "C8")
    V2 = V1 + weight * length
    T1, T2 = math.hypot(H, V1), math.hypot(H, V2)
    m = T1 + T2
    sine = (V1 + V2) / m if m > 0.0 else stretch.slope
    dz = length * sine + 0.5 * length * (V1 + V2) * compliance
    reach, equation = _reach(stretch, V2, m)
    dx = (reach + H * length * compliance) * stretch.gathered
    return Piece(number, False, length, weight, EA, V1, V2, T1, T2, dx, dz, f"{equation}, C5")


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


def _pieces_table(pieces: tuple[Piece, ...]) -> Table:
    per_length = exact("N/m")
    numbers = {
        "l": (_M, "length"), "w": (per_length, "weight"), "EA": (_N, "EA"), "V1": (_N, "V1"),
        "V2": (_N, "V2"), "T1": (_N, "T1"), "T2": (_N, "T2"), "Δx": (_M, "dx"), "Δz": (_M, "dz"),
    }  # fmt: skip
    where = ("note.equations_on_bed" if each.on_bed else "note.equations_hangs" for each in pieces)
    return Table(
        "pieces",
        (
            Column(Message("note.equations_piece"), tuple(each.number for each in pieces)),
            Column(Message("note.equations_lies"), tuple(map(Message, where))),
            *(
                Column(term(symbol), tuple(getattr(each, name) for each in pieces), quantity)
                for symbol, (quantity, name) in numbers.items()
            ),
            Column(Message("note.equations_by"), tuple(each.equation for each in pieces)),
        ),
        Message("note.equations_pieces"),
        only="not csv",
    )


def _sums(solution: Solution, pieces: tuple[Piece, ...]) -> Iterator[Step]:
    """Add up what the stretches contribute."""
    span, rise = math.fsum(each.dx for each in pieces), math.fsum(each.dz for each in pieces)
    yield _height(solution)
    yield _step(
        "span", span, _M, "Σ Δx", symbol="S",
        terms=tuple((each.dx,) for each in pieces), stated=solution.span,
    )  # fmt: skip
    yield _step(
        "height_met", rise, _M, "Σ Δz", symbol="h",
        terms=tuple((each.dz,) for each in pieces),
        stated=solution.fairlead_height - solution.anchor_height,
    )  # fmt: skip
    for name, end in (
        ("fairlead_tension", solution.fairlead),
        ("anchor_tension", solution.anchor),
    ):
        forces = {"H": end.horizontal_force, "V": end.vertical_force}
        yield _step(
            name, math.hypot(*forces.values()), _N, "√({H:()}² + {V:()}²)", symbol="T",
            numbers=forces, stated=end.tension,
        )  # fmt: skip
    H, V = solution.anchor.horizontal_force, solution.anchor.vertical_force
    if H > 0.0:
        yield _step(
            "anchor_angle", math.atan(V / H), DEGREES, "atan({V} / {H})", symbol="θ₀",
            numbers={"V": V, "H": H}, stated=solution.anchor.angle,
        )  # fmt: skip


def _mass(solution: Solution) -> Iterator[Step]:
    """Add up the mass in air, where all of it is known."""
    line = solution.line
    if line.mass is None:
        return
    terms = [(each.length, each.mass) for each in line.segments if each.mass is not None]
    loads = [(each.mass,) for each in line.point_loads if each.mass is not None]
    total = math.fsum(math.prod(each) for each in (*terms, *loads))
    formula = "Σ m l + Σ m_W" if line.point_loads else "Σ m l"
    yield _step(
        "mass", total, _KG, formula, symbol="m", terms=(*terms, *loads), stated=line.mass
    )  # fmt: skip
