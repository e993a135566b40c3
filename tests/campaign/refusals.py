"""Whether a refusal is right: the equilibrium that it denies is looked for.

Too short
    Exact: lengths and distances are compared as fractions. Only a line that does not stretch is
    ever too short.
Tension too small
    The fairlead tension is at least the horizontal force, so that forces from next to nothing up to
    the tension asked for are scanned and the valleys between them closed in on. The answers of the
    scan are lines with a known force, which the campaign checks by themselves; the lowest of them
    is checked here. Without buoyant parts the line that hangs without horizontal force is computed
    independently, too.
"""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

import numpy as np
import numpy.typing as npt

from catopt import solve, solve_many
from catopt.catenary.batch import Solutions
from catopt.errors import (
    CatoptError,
    InputError,
    NoEquilibriumError,
)
from tests.campaign.lines import Trial, gross_weight
from tests.campaign.oracle import check

Array = npt.NDArray[np.float64]

RIGHT = "refused rightly"
WRONG = "refused wrongly"
UNEXPLAINED = "unexplained"

STATUS = {"length": 1, "force": 2}
"""What solve_many calls a refusal for want of a quantity."""


def status_of(error: CatoptError) -> int:
    """Status that solve_many gives to a line that solve refuses so."""
    if isinstance(error, NoEquilibriumError):
        return STATUS.get(error.quantity, -1)
    if isinstance(error, InputError):
        return 4
    return 3


def judge(trial: Trial, error: CatoptError) -> tuple[str, str]:
    """Verdict on a refusal, and the reason in a few words."""
    if isinstance(error, NoEquilibriumError) and error.quantity == "length":
        return (RIGHT if is_too_short(trial) else WRONG), "too short"
    if isinstance(error, NoEquilibriumError) and error.quantity == "force":
        return _tension_too_small(trial)
    if isinstance(error, InputError):
        return (RIGHT if _is_undetermined(trial) else WRONG), "input"
    words = str(error).split()
    return UNEXPLAINED, "misses its fairlead" if "misses" in words else "did not converge"


def is_too_short(trial: Trial) -> bool:
    """Whether the straight way is as long as the line, which does not stretch; exactly.

    Within two roundings of the length either answer is right.
    """
    if not trial.is_inextensible:
        return False
    length = sum((Fraction(s.length) for s in trial.line.segments), Fraction(0))
    span = Fraction(trial.value) if trial.known == "span" else Fraction(0)
    rise = Fraction(trial.height) - Fraction(trial.anchor_height)
    return span**2 + rise**2 >= (length * (1 - Fraction(2) ** -51)) ** 2


def larger_force(trial: Trial, force: float) -> float | None:
    """Return a larger horizontal force at which the tension is below the one asked for, if any."""
    if force >= trial.value:
        return None
    forces = np.geomspace(force, trial.value, 60)[1:]
    tension = _at(trial, forces).tension
    low = np.flatnonzero(tension < trial.value * (1.0 - 1e-9))
    return float(forces[low[-1]]) if low.size else None


def _is_undetermined(trial: Trial) -> bool:
    weighs = any(part.submerged_weight for part in trial.line.segments) or trial.line.point_loads
    return not weighs and trial.known != "horizontal_force"


def _at(trial: Trial, forces: Array) -> Solutions:
    return solve_many(
        trial.line,
        height=trial.height,
        horizontal_force=forces,
        seabed_friction=trial.friction,
        anchor_height=trial.anchor_height,
    )


def _tension_too_small(trial: Trial) -> tuple[str, str]:
    asked = trial.value
    if trial.known != "fairlead_tension":
        return WRONG, "tension too small"
    floor = max(1e-15 * min(asked, gross_weight(trial.line)), 1e-29)
    low, high = floor, asked
    least, at = math.inf, math.nan
    has_gaps = False
    for count in (60, 30, 30, 30):
        forces = np.geomspace(low, high, count)
        tension = _at(trial, forces).tension
        if not np.isfinite(tension).any():
            return UNEXPLAINED, "tension too small: no force has an answer"
        has_gaps = has_gaps or not np.isfinite(tension).all()
        index = int(np.nanargmin(tension))
        if tension[index] < least:
            least, at = float(tension[index]), float(forces[index])
        low, high = forces[max(index - 1, 0)], forces[min(index + 1, count - 1)]
        if least < asked or index == 0 or not low < high:
            break
    if least <= asked * (1.0 - 1e-9):
        return WRONG, "tension too small"
    if has_gaps:
        return UNEXPLAINED, "tension too small: some forces have no answer"
    if not _is_checked(trial, at):
        return UNEXPLAINED, "tension too small: no right answer nearby"
    hung = hung_without_force(trial)
    if hung is not None and abs(hung) <= asked * (1.0 - 1e-9):
        return WRONG, "tension too small"
    return RIGHT, "tension too small"


def _is_checked(trial: Trial, force: float) -> bool:
    """Whether a line with a known force has an answer, and a right one."""
    try:
        answer: Any = solve(
            trial.line,
            height=trial.height,
            horizontal_force=force,
            seabed_friction=trial.friction,
            anchor_height=trial.anchor_height,
        )
    except (CatoptError, ArithmeticError):
        return False
    return check(answer, "horizontal_force", force).is_right


def hung_without_force(trial: Trial) -> float | None:
    """Vertical force at the fairlead of a line without horizontal force, N.

    From statics alone, for lines without buoyant parts: what hangs is upright. None with buoyant
    parts, and where a weightless part leaves the force open.
    """
    parts = [(s.length, s.submerged_weight, 1.0 / s.EA) for s in trial.line.segments]
    if trial.is_buoyant or any(weight == 0.0 for _, weight, _ in parts):
        return None
    steps = _from_top(trial)
    lifted = _root(lambda V: _height(steps, V, stop=True) - trial.height, steps)
    if trial.anchor_height == 0.0:
        return lifted
    free = _root(lambda V: _height(steps, V, stop=False) - trial.rise, steps)
    hangs_clear = trial.height - _height(steps, free, stop=True) >= 0.0
    return free if hangs_clear else lifted


def _from_top(trial: Trial) -> list[tuple[float, float, float]]:
    """Uniform parts (length, weight, compliance) from the fairlead down; a load has no length."""
    found: list[tuple[float, float, float]] = []
    top = trial.line.length
    loads = sorted(trial.line.point_loads, key=lambda load: -load.position)
    for segment in reversed(trial.line.segments):
        end = top - segment.length
        for load in [each for each in loads if end < each.position]:
            loads.remove(load)
            if load.position < top:
                found.append((top - load.position, segment.submerged_weight, 1.0 / segment.EA))
                top = load.position
            found.append((0.0, load.submerged_weight, 0.0))
        if end < top:
            found.append((top - end, segment.submerged_weight, 1.0 / segment.EA))
            top = end
    return found


def _height(steps: list[tuple[float, float, float]], V: float, *, stop: bool) -> float:
    """Height of the fairlead above the anchor, or above the place where V falls to 0 (`stop`)."""
    z = 0.0
    for length, weight, compliance in steps:
        if length == 0.0:
            V -= weight
        else:
            up = min(max(V / weight, 0.0), length)
            z += up * (1.0 + compliance * (V - 0.5 * weight * up))
            V -= weight * up
            if up < length and not stop:
                down = length - up
                z -= down * (1.0 + compliance * (0.5 * weight * down - V))
                V -= weight * down
        if stop and V <= 0.0:
            break
    return z


def _root(function: Any, steps: list[tuple[float, float, float]]) -> float:
    """Where a rising function of the vertical force passes 0, by bisection; N."""
    low = -1.0
    high = 1.0 + sum(weight * (length or 1.0) for length, weight, _ in steps)
    while function(low) > 0.0:
        low *= 2.0
    while function(high) < 0.0:
        high *= 2.0
        if high > 1e30:
            break
    for _ in range(200):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if function(middle) < 0.0 else (low, middle)
    return 0.5 * (low + high)
