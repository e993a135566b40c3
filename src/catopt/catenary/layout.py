"""The line laid out from the anchor up, as stretches that hang or lie on the bed throughout.

The kernel walks down from the fairlead; here its answer is followed up from the anchor, so that
where this ends, against where the fairlead is, is a check and not a repetition.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from catopt.catenary.piece import piece_reach
from catopt.catenary.pieces import Pieces, flip, total_weight
from catopt.catenary.state import SLACK, State
from catopt.catenary.stretch import Stretch
from catopt.catenary.walk import NO_TOUCHDOWN

__all__ = ["end_of", "lay_out"]


@dataclass(frozen=True)
class _Run:
    """A uniform run of the line before it has a place: forces on its lower-s end."""

    piece: int
    length: float
    H: float
    V: float
    friction: float
    on_bed: bool


def lay_out(
    state: State, pieces: Pieces, anchor_height: float, friction: float
) -> tuple[Stretch, ...]:
    """Place every run of the line, from the anchor up.

    Parameters
    ----------
    state : State
        A converged answer of the kernel.
    pieces : Pieces
        The line.
    anchor_height : float
        Above the bed, m.
    friction : float
        Coulomb coefficient of the bed.
    """
    runs = [
        *_hanging(state, pieces),
        *_grounded(state, pieces, friction),
        *_anchor_side(state, pieces),
    ]
    gathered = _gathered(state, runs)
    stretches: list[Stretch] = []
    start, x, z = 0.0, 0.0, anchor_height
    for run in reversed(runs):
        stretch = Stretch(
            start,
            run.length,
            pieces.weight[run.piece],
            pieces.compliance[run.piece],
            x,
            z,
            run.H,
            run.V,
            run.friction,
            run.on_bed,
            run.piece,
            gathered if run.on_bed else 1.0,
        )
        stretches.append(stretch)
        x, z = end_of(stretch, run.length)
        start += run.length
    return tuple(stretches)


def end_of(stretch: Stretch, length: float) -> tuple[float, float]:
    """Place of the point `length` (m, unstretched) above the lower end of a stretch."""
    if length == 0.0:
        return stretch.x, stretch.z
    H, V1 = stretch.horizontal_force, stretch.vertical_force
    if stretch.on_bed:
        mean = H + 0.5 * stretch.friction * length
        run = length * (1.0 + stretch.compliance * mean) * stretch.gathered
        return stretch.x + run, stretch.z
    V2 = V1 + stretch.submerged_weight * length
    T1, T2 = (H * H + V1 * V1) ** 0.5, (H * H + V2 * V2) ** 0.5
    reach = piece_reach(H, V1, V2, T1, T2, length, stretch.compliance)
    return stretch.x + reach.dx, stretch.z + reach.dz


def _laid_force(state: State, pieces: Pieces) -> float:
    """H with which hanging runs are laid out; a slack line is given next to nothing."""
    weight = sum(abs(w) * part for w, part in zip(pieces.weight, pieces.length, strict=True))
    return state.H if state.H > 0.0 else 1e-13 * max(weight, abs(total_weight(pieces)))


def _hanging(state: State, pieces: Pieces) -> Iterator[_Run]:
    """Yield the runs from the fairlead down to the touchdown or the anchor."""
    yield from _descend(_laid_force(state, pieces), state.V, pieces, state.touchdown)


def _descend(H: float, V: float, pieces: Pieces, touchdown: int) -> Iterator[_Run]:
    for k in range(len(pieces.length) - 1, -1, -1):
        if touchdown == 2 * k:
            weight = pieces.weight[k]
            hanging = max(V, 0.0) / weight if weight > 0.0 else 0.0
            yield _Run(k, min(hanging, pieces.length[k]), H, 0.0, 0.0, False)
            return
        V -= pieces.weight[k] * pieces.length[k]
        yield _Run(k, pieces.length[k], H, V, 0.0, False)
        if touchdown == 2 * k + 1:
            return
        V -= pieces.load[k]


def _grounded(state: State, pieces: Pieces, friction: float) -> Iterator[_Run]:
    """Yield the runs on the bed, from the touchdown down, with what friction leaves of H."""
    if state.touchdown == NO_TOUCHDOWN:
        return
    left = state.grounded
    hung = list(_hanging(state, pieces))
    lowest = hung[-1]
    k = lowest.piece
    room = pieces.length[k] - lowest.length
    T = state.H
    if state.touchdown % 2 == 1:
        T = max(T - friction * (pieces.load[k] - lowest.V), 0.0)
        k, room = k - 1, pieces.length[k - 1]
    while left > 1e-15 * sum(pieces.length) and k >= 0:
        length = min(room, left)
        loss = friction * pieces.weight[k]
        held = length if loss * length <= T else T / loss
        T = max(T - loss * held, 0.0)
        yield _Run(k, held, T, 0.0, loss, True)
        if length > held:
            yield _Run(k, length - held, 0.0, 0.0, 0.0, True)
        left -= length
        T = max(T - friction * pieces.load[k], 0.0)
        k, room = k - 1, pieces.length[k - 1]


def _anchor_side(state: State, pieces: Pieces) -> Iterator[_Run]:
    """Yield the runs between the bed and a raised anchor, from the bed up."""
    if state.anchor_touchdown == NO_TOUCHDOWN:
        return
    last = len(pieces.length) - 1
    H = max(state.H_anchor, 1e-12 * abs(state.V_anchor))
    for run in reversed(list(_descend(H, -state.V_anchor, flip(pieces), state.anchor_touchdown))):
        k = last - run.piece
        # Seen from the fairlead, the run's far end is its lower-s end, and forces change sign.
        V = -(run.V + pieces.weight[k] * run.length)
        yield _Run(k, run.length, run.H, V, 0.0, False)


def _gathered(state: State, runs: list[_Run]) -> float:
    """Distance over length on the bed: below 1 where a slack line lies in bights."""
    if state.regime != SLACK:
        return 1.0
    length = sum(run.length for run in runs if run.on_bed)
    return state.span / length if length > 0.0 else 1.0
