"""Many loads on one system in one call: arrays in, arrays out."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from catopt.arrays import Array, Codes, Flags
from catopt.catenary.state import CONVERGED, REASONS
from catopt.errors import InputError, Problem
from catopt.model.array_inputs import array_in_si
from catopt.model.kinds import Findings
from catopt.model.system import System
from catopt.mooring.rest import TURNS_OVER
from catopt.mooring.under_loads import PER_LINE, rested
from catopt.mooring.zero_load import within_half_a_turn, zero_load_position
from catopt.words import Message

__all__ = ["Batch", "SystemSolutions", "solve_system_many"]


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

    def under(self, force: npt.ArrayLike, moment: npt.ArrayLike = 0.0) -> SystemSolutions:
        """Bring the body to rest under many loads; as `solve_system_many`."""
        forces, moments = _loads(self.system, force, moment)
        n, count = len(forces), len(self.system.legs)
        (net, known), neutral = self._zero_load.as_numbers(), self._zero_load.neutral
        scale = np.array(net.scale)
        loads = np.column_stack([forces, moments]) / scale
        _, under = rested(net, known, loads.ravel().tolist(), n)
        status, number, steps = np.array(under.codes, np.int64).reshape(n, 3).T
        solved = status == CONVERGED

        def found(column: Any, *shape: int) -> Array:
            values = np.reshape(np.asarray(column, float), (n, *shape))
            return np.where(solved.reshape(n, *(1 for _ in shape)), values, np.nan)

        position, left = found(under.q, 3) / scale, abs(found(under.unbalanced, 3)) * scale
        position[:, 2] = [within_half_a_turn(yaw) for yaw in position[:, 2].tolist()]
        lines = np.moveaxis(found(under.lines, count, PER_LINE), 2, 0)
        return SystemSolutions(
            status,
            np.where(status == TURNS_OVER, -1, number),
            steps,
            position=position,
            offset=position[:, :2] - [neutral.x, neutral.y],
            horizontal_force=np.hypot(lines[3], lines[4]),
            vertical_force=-lines[5],
            span=lines[7],
            grounded_length=lines[6],
            anchor_horizontal_force=np.hypot(lines[0], lines[1]),
            anchor_vertical_force=lines[2],
            stiffness=found(under.stiffness, 3, 3) * scale * scale[:, np.newaxis],
            residual=np.column_stack([np.hypot(left[:, 0], left[:, 1]), left[:, 2]]),
        )


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
