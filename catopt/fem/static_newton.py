"""From straight lines to their equilibrium: springs are stiffened into the bars as they are.

Where the lines start is straight, and a straight line without tension has no stiffness across
itself. So the bars are first springs of stiffness K without a length of their own (`resting.Law`,
e = 1) over a soft bed: the energy of such a net is quadratic on either side of the bed, and its
equilibrium is found in a few linear steps from anywhere. Then e is lowered to 0, and the bed
hardens with it. For every e the energy of bars that do not push, over a bed that only pushes, is
convex, so that there is one equilibrium to follow; on the way a bar that is too long keeps a little
tension, for a bight to keep its shape. Where lines hang slack the end of that way may not be
found: along a smooth bed nothing holds their bars, and how a bar that touches down shares its
weight (`hanging_part`) depends on a tension that is none. Then e is lowered further, and they keep
that little tension, with half of each bar's weight at either end. A step of e that Newton's method
does not close in a few iterations is taken again, half as far. Friction comes in with the last one.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from catopt.arrays import Array, Flags
from catopt.compiled import compiled
from catopt.errors import NotConvergedError
from catopt.fem.banded import WIDTH
from catopt.fem.friction import limit
from catopt.fem.mesh import Problem, place_of
from catopt.fem.seabed import HALVING, NO_FRICTION, SHARING, SLACK, SPRING, Ground, friction_sense
from catopt.fem.static_model import BarLoads, Body, Law, Net, State
from catopt.fem.step import StepReport, Water, take_steps
from catopt.words import Message

_DRAG_IN = 1e-9
"""Stiffness that holds a loose node during one step, over what line and loads weigh per length."""
_SOLVING = 2e-4
"""Time that a bar takes in each iteration as plain Python, s."""
_USUAL = 25
"""Iterations on the way to rest."""


class Newton:
    """Iterations on one state, which they move; counts them, and keeps the last report."""

    def __init__(self, problem: Problem, state: State, most: int) -> None:
        self.problem = problem
        self.state = state
        self.iterations = 0
        self.last: StepReport | None = None
        self._most = most
        count = problem.bars.length.size
        self._visits = _USUAL * count
        varies = problem.current is not None or math.isfinite(problem.surface)
        blocks = (count if varies else 0, 3, 3)
        self.loads = BarLoads(np.zeros((count, 3)), np.zeros(blocks), np.zeros(blocks))
        rows = 4 * count + 3 * (problem.bars.start.size - 1)
        aside = rows if (problem.body.of_end[:, 0] >= 0).any() else 0
        self._room = np.zeros((rows, WIDTH)), np.zeros(rows), np.zeros((aside, 3))
        self._drag_in = _DRAG_IN * problem.soft / float(problem.bars.length.sum())

    @property
    def is_spent(self) -> bool:
        """Whether all iterations are used up."""
        return self.iterations >= self._most

    def run(
        self, ease: float, ground: Ground, limit: int, tolerance: float, *, keep: float
    ) -> bool:
        """Iterate until the forces balance; say whether they do.

        `ease`, `keep`: e of `Law`, and what a bar may keep there; `limit`: iterations, at
        most; `tolerance`: largest force left over at a node over the largest tension.
        """
        problem = self.problem
        keep = 0.0 if problem.carries_compression else keep
        law = Law(ease, problem.soft, keep, problem.carries_compression, self._drag_in)
        net = Net(problem.bars, self.state, self.loads, problem.nodal, ground, law, *self._room)
        # A current is another one wherever the line goes.
        most = limit if problem.current is None else 1
        for _ in range(0, limit, most):
            water = Water(problem.first_node, problem.surface, self._velocity())
            left = self._most - self.iterations
            iterate = compiled(take_steps, _SOLVING * self._visits)
            report = iterate(net, problem.body, water, most, left, tolerance)
            self.iterations += report.used
            self.last = report.last
            if report.is_settled or report.is_over:
                return bool(report.is_settled)
        return False

    def _velocity(self) -> Array:
        """Of the current at the bars' middles, m/s."""
        problem, x, a = self.problem, self.state.x, self.problem.first_node
        if problem.current is None:
            return np.zeros((0, 3))
        middles = 0.5 * (x[a] + x[a + 1])
        return np.ascontiguousarray(problem.current.velocity(middles), dtype=np.float64)


@dataclass(frozen=True)
class Controls:
    """When to stop, and when to give up."""

    tolerance: float = 1e-10  # largest force left over at a node, over the largest tension, and
    # largest misfit of a bar's length, over the length
    max_iterations: int = 2000  # of Newton's method in all


@dataclass(frozen=True)
class Rest:
    """Lines at rest."""

    state: State
    half_loads: Array  # (bars, 3): what each bar hands to each of its ends, N
    ground: Ground  # with the feet of its friction springs
    residual: float  # largest force left over at a node, over the largest tension
    node: int  # where; -1 for the body
    iterations: int  # of Newton's method, in all
    body: Body  # under what


_SOFTNESS = 0.05
"""Depth, over the line's length, to which the whole weight presses the soft bed at e = 1."""
_KEPT_BY_EASE, _KEPT_FIRST, _KEPT = 1e-4, 1e-12, 1e-14
"""Part of e K on the way that a bar too long by all its length keeps as tension; of K that it has
when its line is first told to hang slack, and that it keeps at the end."""
_NO_PULL, _LEAST_PULL = 1e-3, 1e-8
"""Tension, over what a bar weighs and over K, below which its line is taken to hang slack."""
_STAGE_TOLERANCE = 1e-4
_PART_TOLERANCE = 1e-7
"""Of steps on the way, of e and of friction."""
_STAGE_LIMIT = 25
_LAST_LIMIT = 40
_LEAST_PART = 1e-5
_VAIN_PART = 0.2
_LAST_EASE = 1e-6
"""Below this e the next one is 0."""


def bring_to_rest(problem: Problem, start: State, controls: Controls) -> Rest:
    """Bring lines to rest from any shape, such as `problem.straight`; that is not changed.

    Raises NotConvergedError with the node and the force left over there.
    """
    newton = Newton(problem, _copied(start), controls.max_iterations)
    newton.state.laid[:] = SHARING
    soft_bed, most = _soft_bed(problem, 1.0), controls.max_iterations
    if not newton.run(1.0, soft_bed, most, _STAGE_TOLERANCE, keep=0.0):
        raise _stuck(newton, 1.0)
    smooth = problem.ground._replace(law=NO_FRICTION)
    ease, ratio = 1.0, 0.1
    kept = _copied(newton.state)
    while ease > 0.0:
        target = ease * ratio if ease * ratio >= _LAST_EASE else 0.0
        if _stage(newton, target, smooth, controls):
            ease = target
            ratio = max(ratio * ratio, 0.1)
            kept = _copied(newton.state)
            continue
        _restore(newton.state, kept)
        if target == 0.0 and not problem.carries_compression:
            _let_hang_slack(newton, ease, smooth, controls)
            break
        ratio = math.sqrt(ratio)
        if newton.is_spent or ratio > 0.97:
            raise _stuck(newton, target)
    if friction_sense(problem.ground.law) != 0.0:
        if not problem.carries_compression:
            _tell_slack(newton, smooth, controls)
        _rub_in(newton, problem.ground, controls)
        _let_rub(newton, controls)
    return _rest(newton, problem, problem.ground)


def follow(problem: Problem, start: Rest, controls: Controls) -> Rest:
    """Bring lines to rest again after the force on the body or its place has changed a little.

    The change is cut in two where it is too large for Newton's method. Friction springs keep their
    feet, and drag them along where they slip. Without such a history there is no need to go
    through every change between: after a few vain cuts the way is that of `bring_to_rest`.

    `start`: of the same lines; not changed. Raises NotConvergedError with the node and the force
    left over there.
    """
    ground = problem.ground._replace(spring_foot=start.ground.spring_foot)
    newton = Newton(problem, _copied(start.state), controls.max_iterations)

    def go_to(part: float) -> bool:
        nonlocal ground
        newton.problem = replace(problem, body=_between(start.body, problem.body, part))
        closed = _stage(newton, 0.0, ground, controls)
        if closed:
            ground = _dragged_feet(newton.state, ground)
        return closed

    if not _in_steps(newton, go_to, vain=0.0 if ground.law == SPRING else _VAIN_PART):
        return bring_to_rest(problem, start.state, controls)
    return _rest(newton, problem, ground)


def _let_hang_slack(newton: Newton, ease: float, smooth: Ground, controls: Controls) -> None:
    """Go from a small e to the end where lines hang slack: as if all did, then as those that do."""
    while ease > _KEPT / _KEPT_BY_EASE:
        ease *= 0.1
        if not _stage(newton, ease, smooth, controls):
            raise _stuck(newton, ease)
    newton.state.laid[:] = SLACK
    if not _stage(newton, 0.0, smooth, controls):
        raise _stuck(newton, 0.0)
    _tell_slack(newton, smooth, controls)


def _tell_slack(newton: Newton, smooth: Ground, controls: Controls) -> None:
    """Tell lines that hang slack from the others, and bring them to rest as such.

    The others share their weight where they touch down, or where that leads nowhere halve it.
    """
    bars, state = newton.problem.bars, newton.state
    is_slack = _hangs_slack(newton)
    if not is_slack.any() and not state.laid.any():
        return
    some = np.repeat(is_slack, np.diff(bars.start)) * _KEPT_FIRST * newton.problem.soft
    state.tension[:] = np.maximum(state.tension, some)
    kept = _copied(state)
    for others in (SHARING, HALVING):
        newton.state.laid[:] = np.where(is_slack, SLACK, others)
        if _stage(newton, 0.0, smooth, controls):
            return
        _restore(newton.state, kept)
    raise _stuck(newton, 0.0)


def _hangs_slack(newton: Newton) -> Flags:
    """Say of each line whether a bar of it has next to no tension."""
    bars = newton.problem.bars
    least = np.maximum(_NO_PULL * np.abs(bars.submerged), _LEAST_PULL * newton.problem.soft)
    return np.logical_or.reduceat(newton.state.tension <= least, bars.start[:-1])


def _rub_in(newton: Newton, ground: Ground, controls: Controls) -> None:
    """Let friction grow to its full coefficient: at once, or in steps where that is too much."""

    def go_to(part: float) -> bool:
        rough = ground._replace(friction=part * ground.friction, beside=part * ground.beside)
        tolerance = controls.tolerance if part == 1.0 else _PART_TOLERANCE
        return newton.run(0.0, rough, _LAST_LIMIT, tolerance, keep=_KEPT)

    _in_steps(newton, go_to)


def _let_rub(newton: Newton, controls: Controls) -> None:
    """Let lines rub, too, that hung slack without friction, where with it they pull."""
    pulls = (newton.state.laid == SLACK) & ~_hangs_slack(newton)
    if pulls.any():
        newton.state.laid[pulls] = SHARING
        if not _stage(newton, 0.0, newton.problem.ground, controls):
            raise _stuck(newton, 0.0)


def _in_steps(newton: Newton, go_to: Callable[[float], bool], vain: float = 0.0) -> bool:
    """Go to a part of the way and on to all of it, in shorter steps where one does not close.

    Returns False as soon as a step is shorter than `vain`.
    """
    done, part = 0.0, 1.0
    while done < 1.0:
        to = min(1.0, done + part)
        kept = _copied(newton.state)
        if go_to(to):
            done, part = to, 2.0 * part
            continue
        _restore(newton.state, kept)
        part *= 0.5
        if part < vain:
            return False
        if newton.is_spent or part < _LEAST_PART:
            raise _stuck(newton, 0.0)
    return True


def _stage(newton: Newton, ease: float, at_rest: Ground, controls: Controls) -> bool:
    if ease == 0.0:
        return newton.run(0.0, at_rest, _LAST_LIMIT, controls.tolerance, keep=_KEPT)
    bed, keep = _soft_bed(newton.problem, ease), ease * _KEPT_BY_EASE
    return newton.run(ease, bed, _STAGE_LIMIT, _STAGE_TOLERANCE, keep=keep)


def _soft_bed(problem: Problem, ease: float) -> Ground:
    """Bed that hardens as e falls, without friction."""
    carried = problem.carried
    length = float(np.diff(problem.bars.start).max() * problem.bars.length.mean())
    stiffness = problem.soft / (length * _SOFTNESS * ease * length) * carried
    softer = np.minimum(stiffness, problem.ground.stiffness)
    return problem.ground._replace(law=NO_FRICTION, stiffness=softer)


def _between(first: Body, last: Body, part: float) -> Body:
    """Force on the body and its place, part of the way from one to the other."""
    if part == 1.0 or not np.array_equal(first.free, last.free):
        return last
    force, place = (
        (1.0 - part) * old + part * new
        for old, new in ((first.force, last.force), (first.place, last.place))
    )
    return last._replace(force=force, place=place)


def _dragged_feet(state: State, ground: Ground) -> Ground:
    """Bed whose friction springs have slipped as far as they must; those of hanging nodes are gone.

    A node that has come down sets its foot where it lies.
    """
    if ground.law != SPRING:
        return ground
    foot = np.full_like(ground.spring_foot, np.nan)
    for node in np.flatnonzero(state.reaction > 0.0):
        x, y = state.x[node, :2]
        foot[node] = ground.spring_foot[node]
        most = limit(int(node), state.reaction[node], ground, state.contact)
        dx, dy = state.x[node, :2] - foot[node]
        reach, distance = most / ground.tangential[node], math.hypot(dx, dy)
        if math.isnan(distance):
            foot[node] = x, y
        elif distance > reach:
            keep = reach / distance
            foot[node] = x - keep * dx, y - keep * dy
    return ground._replace(spring_foot=foot)


def _rest(newton: Newton, problem: Problem, ground: Ground) -> Rest:
    report = newton.last
    assert report is not None
    return Rest(
        state=newton.state,
        half_loads=newton.loads.force,
        ground=_dragged_feet(newton.state, ground),
        residual=report.imbalance / max(report.tension, 1e-300),
        node=report.node,
        iterations=newton.iterations,
        body=problem.body,
    )


def _copied(state: State) -> State:
    copied: Any = map(np.copy, state)
    return State(*copied)


def _restore(state: State, kept: State) -> None:
    for array, old in zip(state, kept, strict=True):
        array[...] = old


def _stuck(newton: Newton, ease: float) -> NotConvergedError:
    """Say where the forces do not balance."""
    report, problem = newton.last, newton.problem
    assert report is not None
    values = {
        "count": newton.iterations,
        "left": report.imbalance,
        "where": place_of(report.node, problem.bars.start, newton.state.x, len(problem.body.free)),
        "part": report.imbalance / max(report.tension, 1e-300),
    }
    if ease == 0.0:
        return NotConvergedError(Message("truss.not_at_rest", **values))
    return NotConvergedError(Message("truss.not_at_rest_softened", ease=ease, **values))
