"""The equation trail: each result with its equation, its numbers put in, and its value.

Everything is worked out here once more with the formulas of docs/theory.md as they are printed
there, from the forces of the solution, so that a checker with a pocket calculator can follow.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

from catopt.catenary.solution import Solution
from catopt.catenary.stretch import Stretch

__all__ = ["Row", "Step", "Trail", "is_uniform", "trail_of"]

_FLAT = 0.1
"""Below this |y| a piece is so nearly straight that the printed logarithm loses its digits."""


@dataclass(frozen=True)
class Step:
    """One line of the trail.

    Attributes
    ----------
    name : str
        What it gives: key of a text, ``"trail.span"``.
    equation : str
        Number in docs/theory.md; empty where it needs none.
    formula, put_in : str
        In symbols, and with its numbers.
    value : float
        What comes out; SI, angles in rad.
    unit : str
        Of the value as it is shown; ``"deg"`` turns rad into degrees.
    stated : float or None
        The same in the solution, where it has it.
    """

    name: str
    equation: str
    formula: str
    put_in: str
    value: float
    unit: str
    stated: float | None = None


@dataclass(frozen=True)
class Row:
    """One stretch of the line, from the anchor up.

    Attributes
    ----------
    piece : int
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

    piece: int
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


@dataclass(frozen=True)
class Trail:
    """Steps, and for a line of several pieces what each contributes."""

    steps: tuple[Step, ...]
    rows: tuple[Row, ...] = ()


def digits(value: float) -> str:
    """Write a number with nine digits, enough to be put in again."""
    return f"{value:.9g}".replace("-", "−")


def within(value: float) -> str:
    """Write a number that stands under a power or behind a sign; in brackets where it must."""
    shown = digits(value)
    return f"({shown})" if value < 0.0 or "e" in shown else shown


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


def trail_of(solution: Solution) -> Trail:
    """Follow a solution through the equations of docs/theory.md.

    Parameters
    ----------
    solution : Solution
        In closed form or by the swarm.
    """
    if not is_uniform(solution):
        rows = tuple(_row(stretch) for stretch in solution.stretches if stretch.length > 0.0)
        return Trail((*_sums(solution, rows), *_mass(solution)), rows)
    steps = _hanging(solution) if solution.regime == "suspended" else _grounded(solution)
    return Trail((*steps, *_mass(solution)))


# ------------------------------------------------------------------ one uniform line


def _hanging(solution: Solution) -> Iterator[Step]:
    """Follow a line that hangs free, by S1."""
    segment = solution.line.segments[0]
    H, w, L = solution.horizontal_force, segment.submerged_weight, segment.length
    h = solution.fairlead_height - solution.anchor_height
    a, t = H / w, math.tan(solution.anchor.angle)
    q = L / a + t
    put_a, put_t, put_q = digits(a), within(t), within(q)
    yield _height(solution)
    yield Step("trail.parameter", "", "a = H / w", f"{digits(H)} / {digits(w)}", a, "m")
    yield Step(
        "trail.slope", "", "t = tan θ₀", f"tan {digits(math.degrees(solution.anchor.angle))}°",
        t, "", solution.anchor.vertical_force / H,
    )  # fmt: skip
    yield Step("trail.upper_slope", "", "q = L/a + t", f"{digits(L)} / {put_a} + {put_t}", q, "")
    yield Step(
        "trail.height_met", "S1 (4)", "h = a √(1 + q²) − a √(1 + t²)",
        f"{put_a} √(1 + {put_q}²) − {put_a} √(1 + {put_t}²)",
        a * math.hypot(1.0, q) - a * math.hypot(1.0, t), "m", h,
    )  # fmt: skip
    yield Step(
        "trail.span", "S1 (5)", "S = a asinh q − a asinh t",
        f"{put_a} asinh {put_q} − {put_a} asinh {put_t}",
        a * math.asinh(q) - a * math.asinh(t), "m", solution.span,
    )  # fmt: skip
    T1, T2 = H * math.hypot(1.0, t), H * math.hypot(1.0, q)
    yield Step(
        "trail.anchor_tension", "S1 (7)", "T(0) = H √(1 + t²)",
        f"{digits(H)} √(1 + {put_t}²)", T1, "N", solution.anchor.tension,
    )  # fmt: skip
    yield Step(
        "trail.fairlead_tension", "S1 (7)", "T(L) = H √(1 + q²)",
        f"{digits(H)} √(1 + {put_q}²)", T2, "N", solution.fairlead.tension,
    )  # fmt: skip
    yield Step(
        "trail.tension_rise", "C1", "T(L) = T(0) + w h",
        f"{digits(T1)} + {digits(w)} · {digits(h)}", T1 + w * h, "N", solution.fairlead.tension,
    )  # fmt: skip


def _grounded(solution: Solution) -> Iterator[Step]:
    """Follow a line of which a part lies on the bed, by S2."""
    segment = solution.line.segments[0]
    H, w, L = solution.horizontal_force, segment.submerged_weight, segment.length
    h, mu = solution.fairlead_height, solution.seabed_friction
    a = H / w
    least = math.sqrt(h * (h + 2.0 * a))
    put_a, put_h = digits(a), digits(h)
    yield Step("trail.parameter", "", "a = H / w", f"{digits(H)} / {digits(w)}", a, "m")
    yield Step(
        "trail.suspended", "S2 (1)", "L_min = √(h (h + 2 a))",
        f"√({put_h} ({put_h} + 2 · {put_a}))", least, "m", solution.suspended_length,
    )  # fmt: skip
    on_bed = L - least
    yield Step(
        "trail.grounded", "", "d = L − L_min", f"{digits(L)} − {digits(least)}",
        on_bed, "m", solution.grounded_length,
    )  # fmt: skip
    yield Step(
        "trail.span", "C2", "S = (L − L_min) + a asinh(L_min / a)",
        f"{digits(on_bed)} + {put_a} asinh({digits(least)} / {put_a})",
        on_bed + a * math.asinh(least / a), "m", solution.span,
    )  # fmt: skip
    yield Step(
        "trail.fairlead_tension", "S2 (4)", "T = H + w h",
        f"{digits(H)} + {digits(w)} · {put_h}", H + w * h, "N", solution.fairlead.tension,
    )  # fmt: skip
    yield Step(
        "trail.anchor_tension", "C7", "T(d) = max(0, H − μ w d)",
        f"max(0, {digits(H)} − {digits(mu)} · {digits(w)} · {digits(on_bed)})",
        max(0.0, H - mu * w * on_bed), "N", solution.anchor.tension,
    )  # fmt: skip
    yield Step(
        "trail.lift_force", "S2, below (4)", "H₁ = (w / 2) (L² / h − h)",
        f"({digits(w)} / 2) ({digits(L)}² / {put_h} − {put_h})",
        0.5 * w * (L * L / h - h), "N",
    )  # fmt: skip


def _height(solution: Solution) -> Step:
    """State the height of the fairlead above the anchor."""
    top, foot = solution.fairlead_height, solution.anchor_height
    put_in = f"{digits(top)} − {digits(foot)}"
    return Step("trail.height", "", "h = z_F − z_A", put_in, top - foot, "m")


# ------------------------------------------------------------------ a line of several pieces


def _row(stretch: Stretch) -> Row:
    """Work out what one stretch contributes."""
    H, V1 = stretch.horizontal_force, stretch.vertical_force
    length, weight, compliance = stretch.length, stretch.submerged_weight, stretch.compliance
    EA = math.inf if compliance == 0.0 else 1.0 / compliance
    if stretch.on_bed:
        T2 = H + stretch.friction * length
        dx = length * (1.0 + 0.5 * (H + T2) * compliance) * stretch.gathered
        return Row(stretch.piece + 1, True, length, weight, EA, 0.0, 0.0, H, T2, dx, 0.0, "C8")
    V2 = V1 + weight * length
    T1, T2 = math.hypot(H, V1), math.hypot(H, V2)
    m = T1 + T2
    sine = (V1 + V2) / m if m > 0.0 else stretch.slope
    dz = length * sine + 0.5 * length * (V1 + V2) * compliance
    reach, equation = _reach(stretch, V2, m)
    dx = (reach + H * length * compliance) * stretch.gathered
    return Row(stretch.piece + 1, False, length, weight, EA, V1, V2, T1, T2, dx, dz, equation)


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


def _sums(solution: Solution, rows: tuple[Row, ...]) -> Iterator[Step]:
    """Add up what the stretches contribute."""
    span, rise = math.fsum(row.dx for row in rows), math.fsum(row.dz for row in rows)
    yield _height(solution)
    yield Step("trail.span", "", "S = Σ Δx", _sum(row.dx for row in rows), span, "m", solution.span)
    yield Step(
        "trail.height_met", "", "h = Σ Δz", _sum(row.dz for row in rows), rise, "m",
        solution.fairlead_height - solution.anchor_height,
    )  # fmt: skip
    H, V = solution.fairlead.horizontal_force, solution.fairlead.vertical_force
    yield Step(
        "trail.fairlead_tension", "", "T = √(H² + V²)", f"√({within(H)}² + {within(V)}²)",
        math.hypot(H, V), "N", solution.fairlead.tension,
    )  # fmt: skip
    H, V = solution.anchor.horizontal_force, solution.anchor.vertical_force
    yield Step(
        "trail.anchor_tension", "", "T = √(H² + V²)", f"√({within(H)}² + {within(V)}²)",
        math.hypot(H, V), "N", solution.anchor.tension,
    )  # fmt: skip
    if H > 0.0:
        yield Step(
            "trail.anchor_angle", "", "θ₀ = atan(V / H)", f"atan({digits(V)} / {digits(H)})",
            math.atan(V / H), "deg", solution.anchor.angle,
        )  # fmt: skip


def _sum(values: Iterator[float]) -> str:
    return " + ".join(digits(value) for value in values).replace("+ −", "− ")


def _mass(solution: Solution) -> Iterator[Step]:
    """Add up the mass in air, where all of it is known."""
    line = solution.line
    if line.mass is None:
        return
    parts = [f"{digits(s.length)} · {digits(s.mass)}" for s in line.segments if s.mass is not None]
    parts += [digits(load.mass) for load in line.point_loads if load.mass is not None]
    total = math.fsum(
        [
            *(s.length * s.mass for s in line.segments if s.mass is not None),
            *(load.mass for load in line.point_loads if load.mass is not None),
        ]
    )
    formula = "m = Σ m l + Σ m_W" if line.point_loads else "m = Σ m l"
    yield Step("trail.mass", "", formula, " + ".join(parts), total, "kg", line.mass)
