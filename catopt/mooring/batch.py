"""Many loads on one system in one call: arrays in, arrays out."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from catopt.arrays import Array, Codes, Flags
from catopt.catenary.state import CONVERGED, REASONS
from catopt.compiled import compiled
from catopt.errors import InputError, Problem
from catopt.model.array_inputs import array_in_si
from catopt.model.kinds import Findings
from catopt.model.system import System
from catopt.mooring.balance import Arrangement, Lines, pull_at, room_for
from catopt.mooring.descent import TURNS_OVER, BodyLoad, BodyProblem, Freedom
from catopt.mooring.static_equilibrium import static_equilibrium, zero_load_position
from catopt.words import Message

__all__ = ["Batch", "SystemSolutions", "solve_system_many"]

BODY, PER_LINE = 14, 6
"""Columns that are written of the body: x, y, yaw, force_error, moment_error as in Rest and x, y,
moment, xx, xy, yy, xm, ym, mm as in RestoringForce; of each line: H, V, span, grounded, H_anchor,
V_anchor as in Lines."""


def static_equilibria(
    x: float,
    y: float,
    yaw: float,
    force_x: Any,
    force_y: Any,
    moment: Any,
    freedom: Freedom,
    arrangement: Arrangement,
    start: Lines,
    lines: Lines,
    status: Any,
    line: Any,
    steps: Any,
    body: Any,
    per_line: Any,
) -> None:
    """Bring the body to rest under each load, every time from the same start.

    x, y, yaw are where the body starts. `start`, what is known of the lines near there, is written
    to; `lines` is work space. Also written: status, line, steps as in Rest; `body` load after load
    by BODY; `per_line` for each load, for each column of PER_LINE, line after line.
    """
    count = len(arrangement.anchor_x)
    pull = pull_at(x, y, yaw, arrangement, start, True)
    for i in range(len(force_x)):
        for k in range(count):
            lines.H[k], lines.V[k], lines.span[k] = start.H[k], start.V[k], start.span[k]
            lines.H_S[k], lines.V_S[k] = start.H_S[k], start.V_S[k]
            lines.grounded[k] = start.grounded[k]
            lines.H_anchor[k], lines.V_anchor[k] = start.H_anchor[k], start.V_anchor[k]
        load = BodyLoad(force_x[i], force_y[i], moment[i])
        problem = BodyProblem(load, freedom, arrangement, lines)
        rest = static_equilibrium(x, y, yaw, pull, problem)
        status[i], line[i], steps[i] = rest.status, rest.line, rest.steps
        end = rest.pull
        at = i * 14
        body[at], body[at + 1], body[at + 2] = rest.x, rest.y, rest.yaw
        body[at + 3], body[at + 4] = rest.force_error, rest.moment_error
        body[at + 5], body[at + 6], body[at + 7] = end.x, end.y, end.moment
        body[at + 8], body[at + 9], body[at + 10] = end.xx, end.xy, end.yy
        body[at + 11], body[at + 12], body[at + 13] = end.xm, end.ym, end.mm
        for k in range(count):
            at = i * 6 * count + k
            per_line[at] = lines.H[k]
            per_line[at + count] = lines.V[k]
            per_line[at + 2 * count] = lines.span[k]
            per_line[at + 3 * count] = lines.grounded[k]
            per_line[at + 4 * count] = lines.H_anchor[k]
            per_line[at + 5 * count] = lines.V_anchor[k]


_A_LINE = 4e-4
"""Time that a line of the system takes under one load as plain Python, s."""


@dataclass(frozen=True)
class SystemSolutions:
    """Answers for many loads; nan where there is none.

    Attributes
    ----------
    status, line, steps : ndarray of int, shape (n,)
        0 where solved, see `reason`; the line that stopped it; Newton steps.
    position : ndarray, shape (n, 3)
        x, y, yaw of the body: m, m, rad.
    offset : ndarray, shape (n, 2)
        From the zero-load position, m.
    horizontal_force, vertical_force, span, grounded_length : ndarray, shape (n, lines)
        At each fairlead, N; m.
    anchor_horizontal_force, anchor_vertical_force : ndarray, shape (n, lines)
        N.
    stiffness : ndarray, shape (n, 3, 3)
        -d(Fx, Fy, M)/d(x, y, yaw): N/m, N/rad, N m/rad.
    residual : ndarray, shape (n, 2)
        Unbalanced force (N) and moment (N m).
    """

    status: Codes
    line: Codes
    steps: Codes
    position: Array
    offset: Array
    horizontal_force: Array
    vertical_force: Array
    span: Array
    grounded_length: Array
    anchor_horizontal_force: Array
    anchor_vertical_force: Array
    stiffness: Array
    residual: Array

    @property
    def converged(self) -> Flags:
        """Which loads have an answer."""
        return np.equal(self.status, CONVERGED)

    @property
    def tension(self) -> Array:
        """Effective tension at each fairlead, N, shape (n, lines)."""
        return np.hypot(self.horizontal_force, self.vertical_force)

    @property
    def anchor_tension(self) -> Array:
        """Effective tension at each anchor, N, shape (n, lines)."""
        return np.hypot(self.anchor_horizontal_force, self.anchor_vertical_force)

    def reason(self, index: int) -> str | None:
        """Why a load has no answer; None when it has one."""
        status = int(self.status[index])
        if status == TURNS_OVER:
            return "turns over: the lines cannot carry the moment"
        cause = REASONS[status]
        number = int(self.line[index])
        return cause if cause is None or number < 0 else f"line {number + 1}: {cause}"


def solve_system_many(
    system: System, *, force: npt.ArrayLike, moment: npt.ArrayLike = 0.0
) -> SystemSolutions:
    """Bring one system to rest under many loads by one loop, each from the zero-load position.

    A load without an answer is marked with its reason and leaves the others alone.

    Parameters
    ----------
    system : System
        Its own load plays no part.
    force : array, shape (n, 2)
        Along x and y, N.
    moment : float or array, shape (n,)
        N m.

    Raises
    ------
    InputError
        When shapes do not fit, a number is not finite, or there is a moment on a body that does
        not turn.
    NoEquilibriumError, NotConvergedError
        When there is no zero-load position.
    """
    return Batch(system).under(force, moment)


class Batch:
    """A system at its zero-load position, ready for loads in compiled code.

    Worth keeping where loads come a few at a time: the zero-load position, some milliseconds, is
    found once. The system's own load plays no part.

    Raises
    ------
    NoEquilibriumError, NotConvergedError
        When there is no zero-load position.
    """

    def __init__(self, system: System) -> None:
        self.system = system
        self._zero_load = zero_load_position(system)
        self._arrangement = as_arrays(self._zero_load.arrangement)

    def under(self, force: npt.ArrayLike, moment: npt.ArrayLike = 0.0) -> SystemSolutions:
        """Bring the body to rest under many loads; as `solve_system_many`."""
        forces, moments = _loads(self.system, force, moment)
        n, count = len(forces), len(self.system.legs)
        zero_load = self._zero_load
        neutral = zero_load.neutral
        status, line, steps = (np.empty(n, dtype=np.int64) for _ in range(3))
        body = np.empty(n * BODY)
        per_line = np.empty(n * PER_LINE * count)
        if n > 0:
            compiled(static_equilibria, _A_LINE * n * count)(
                neutral.x,
                neutral.y,
                neutral.yaw,
                np.ascontiguousarray(forces[:, 0]),
                np.ascontiguousarray(forces[:, 1]),
                moments,
                zero_load.freedom,
                self._arrangement,
                as_arrays(zero_load.lines),
                as_arrays(room_for(count)),
                status,
                line,
                steps,
                body,
                per_line,
            )
        solved = status == CONVERGED
        body = np.where(solved[:, None], body.reshape(n, BODY), np.nan)
        lines = np.where(solved[:, None, None], per_line.reshape(n, PER_LINE, count), np.nan)
        return SystemSolutions(
            status,
            line,
            steps,
            position=body[:, :3],
            offset=body[:, :2] - [neutral.x, neutral.y],
            horizontal_force=lines[:, 0],
            vertical_force=lines[:, 1],
            span=lines[:, 2],
            grounded_length=lines[:, 3],
            anchor_horizontal_force=lines[:, 4],
            anchor_vertical_force=lines[:, 5],
            stiffness=body[:, [8, 9, 11, 9, 10, 12, 11, 12, 13]].reshape(n, 3, 3),
            residual=body[:, 3:5],
        )


def as_arrays(columns: Any) -> Any:
    """Copy a named tuple of lists and numbers, its lists as arrays; for compiled code."""
    return type(columns)(*(np.array(each) if isinstance(each, list) else each for each in columns))


def _loads(system: System, force: npt.ArrayLike, moment: npt.ArrayLike) -> tuple[Array, Array]:
    found = Findings("solve_system_many")
    forces = array_in_si(found, "force", force, "N")
    moments = array_in_si(found, "moment", moment, "N m")
    found.raise_if_any()
    problems = []
    if forces.ndim != 2 or forces.shape[1] != 2:
        shape = Message("refused_motion.shape", shape=forces.shape)
        problems.append(Problem("force", shape, Message("refused_motion.shape_of_pairs")))
    elif moments.ndim > 1 or moments.size not in (1, len(forces)):
        shape = Message("refused_motion.shape", shape=moments.shape)
        wanted = Message("refused_motion.a_number_or_shape", count=len(forces))
        problems.append(Problem("moment", shape, wanted))
    if not np.isfinite(forces).all() or not np.isfinite(moments).all():
        given = Message("refused_motion.finite_pair")
        problems.append(Problem("force, moment", given, Message("refused_motion.newtons")))
    if moments.any() and not system.turns:
        problems.append(Problem("moment", "!= 0", Message("refused_motion.body_does_not_yaw")))
    if problems:
        raise InputError(problems, "solve_system_many")
    return forces, np.ascontiguousarray(np.broadcast_to(moments.ravel(), (len(forces),)))
