"""The line followed from either end with an answer's own forces; nothing of the kernel.

What is checked on the way is the definition of an equilibrium: both ends are met, nothing hangs
below the bed, the line touches down at height 0 without vertical force or at a clump weight that
the bed carries in part, nothing buoyant lies there, the bed pushes and never pulls, and friction
takes its coefficient times the bed's reaction off the tension, down to 0.

Tolerances
----------
Lengths: LENGTH of the line's length; forces: FORCE of the largest tension. Beside these stands
what double precision leaves open, followed along: forces carry an error of ULPS half-ulps of the
largest force met since the walk began (the numbers of the answer and of the line are themselves
only that exact), and an element ds whose forces are off by d moves its end by at most
min(2, d/T) ds + d ds/EA. A touchdown is placed to a few ulps of the line's length (SNAP at a
joint), and so V there is exact to that times w.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from tests.campaign.quadrature import Reach, fast, hanging, upright

LENGTH = 1e-9
FORCE = 1e-9
ULPS = 16.0 * 2.0**-52
SNAP = 1e-14
"""Of the length: a touchdown that close to a joint or a point load is there."""

CONDITIONS = (
    "asked",
    "span",
    "height",
    "touchdown height",
    "touchdown force",
    "below the bed",
    "floats on the bed",
    "bed reaction",
    "anchor H",
    "anchor V",
    "V by height",
    "H by span",
    "span from below",
    "height from below",
    "H from below",
    "V from below",
    "place of a stretch",
    "force of a stretch",
    "place of a point load",
    "layout",
    "grounded length",
    "slack",
)
(
    ASKED,
    SPAN,
    HEIGHT,
    TOUCH_Z,
    TOUCH_V,
    BELOW,
    FLOATS,
    REACTION,
    ANCHOR_H,
    ANCHOR_V,
    V_BY_HEIGHT,
    H_BY_SPAN,
    UP_X,
    UP_Z,
    UP_H,
    UP_V,
    PLACE,
    STRETCH_FORCE,
    LOAD_PLACE,
    LAYOUT,
    GROUNDED,
    SLACK,
) = range(len(CONDITIONS))


class Parts(NamedTuple):
    """Uniform parts from the anchor up; every array has an entry a part.

    Attributes
    ----------
    length, weight, compliance
        m, N/m, 1/N.
    blur
        How inexact V is made by the place of a touchdown that cuts the part, N.
    on_bed, loose : bool
        Whether it lies on the bed, and there without tension.
    load, reaction
        Weight on the joint at its upper end and what the bed carries of it, N.
    x, z, H, V
        What the answer says of its lower end; nan where it says nothing.
    """

    length: Any
    weight: Any
    compliance: Any
    blur: Any
    on_bed: Any
    loose: Any
    load: Any
    reaction: Any
    x: Any
    z: Any
    H: Any
    V: Any


class Ends(NamedTuple):
    """What the answer says of both ends; SI."""

    H: float
    V: float
    span: float
    height: float
    H_anchor: float
    V_anchor: float
    anchor_height: float
    friction: float
    size: float


class Walked(NamedTuple):
    """What double precision leaves open after a walk.

    Attributes
    ----------
    x, z : float
        Of the last place, m.
    H, V : float
        Of the forces at the fairlead, N; H where the span is known and not the force.
    """

    x: float
    z: float
    H: float
    V: float


# The walker: one array, so that the steps of both walks share it.
(
    X,
    Z,
    H,
    V,
    OPEN_X,
    OPEN_Z,
    OPEN_H,
    OPEN_V,
    MET,
    X_H,
    X_V,
    Z_V,
    YIELDS,
    SKEW,
    OPEN_SKEW,
    TOP_V,
    FORCE_LIMIT,
    FAR,
    FRICTION,
    SIZE,
    LIES,
) = range(21)


@fast
def note(ratio: Any, condition: int, miss: float, allowed: float) -> None:
    """Keep the worst miss of a condition as a part of what is allowed."""
    size = abs(miss)
    if size == 0.0:
        return
    part = size / allowed if allowed > 0.0 else np.inf
    if not part <= ratio[condition]:
        ratio[condition] = part if part == part else np.inf


@fast
def _started(ends: Ends, x: float, z: float, force: float, uplift: float, open_V: float) -> Any:
    """Return a walker at one end of the line."""
    at = np.zeros(21)
    at[X], at[Z], at[H], at[V] = x, z, force, uplift
    at[OPEN_X], at[OPEN_Z] = ULPS * ends.size, ULPS * ends.size
    at[OPEN_H], at[OPEN_V] = ULPS * force, open_V
    at[MET] = np.hypot(force, uplift)
    at[TOP_V] = -1.0
    at[FORCE_LIMIT] = FORCE * max(np.hypot(ends.H, ends.V), np.hypot(ends.H_anchor, ends.V_anchor))
    at[FAR] = LENGTH * ends.size
    at[FRICTION], at[SIZE] = ends.friction, ends.size
    return at


@fast
def down(parts: Parts, ends: Ends, by_span: bool, most: Any, ratio: Any) -> Walked:
    """Walk from the fairlead to the anchor.

    Parameters
    ----------
    most : array
        Written to: the largest force met so far in the hanging part that each part belongs to, N.
    ratio : array
        Written to by `note`.
    """
    n = len(parts.length)
    at = _started(ends, ends.span, ends.height, ends.H, ends.V, ULPS * abs(ends.V))
    for k in range(n - 1, -1, -1):
        if k < n - 1:
            _past_a_joint_down(parts, k, at, ratio)
        if parts.on_bed[k]:
            _land(parts, k, at, ratio)
            _along_the_bed_down(parts, k, at)
        else:
            _hang(parts, k, -1.0, at, ratio)
        most[k] = at[MET]
    note(ratio, SPAN, at[X], at[FAR] + at[OPEN_X])
    note(ratio, ANCHOR_H, at[H] - ends.H_anchor, at[FORCE_LIMIT] + at[OPEN_H])
    if at[LIES] == 1.0:
        note(ratio, HEIGHT, ends.anchor_height, at[FAR])
        note(ratio, ANCHOR_V, ends.V_anchor, at[FORCE_LIMIT])
    else:
        miss = at[Z] - ends.anchor_height
        note(ratio, HEIGHT, miss, at[FAR] + at[OPEN_Z])
        note(ratio, ANCHOR_V, at[V] - ends.V_anchor, at[FORCE_LIMIT] + at[OPEN_V])
        _close(miss, 0.0, at, ratio)
    # At a height that is held, what is open of it opens the span, too.
    yields = at[YIELDS]
    open_H = (at[OPEN_X] + at[OPEN_SKEW]) / yields if yields > 0.0 else 0.0
    if by_span and yields > 0.0:
        note(ratio, H_BY_SPAN, (at[X] - at[SKEW]) / yields, at[FORCE_LIMIT] + open_H)
    return Walked(at[OPEN_X], at[OPEN_Z], open_H, at[TOP_V])


@fast
def _past_a_joint_down(parts: Parts, k: int, at: Any, ratio: Any) -> None:
    """Pass the point loads on the upper end of part k, and what the bed carries of them."""
    W, R = parts.load[k], parts.reaction[k]
    if W == 0.0 and R == 0.0:
        return
    at[V] += R - W
    at[OPEN_V] = max(at[OPEN_V], ULPS * max(abs(at[V]), abs(W), abs(R)))
    open_force = at[FORCE_LIMIT] + at[OPEN_V]
    note(ratio, REACTION, max(-R, R - max(W, 0.0), 0.0), open_force)
    if abs(R) > open_force:
        note(ratio, REACTION, at[Z], at[FAR] + at[OPEN_Z])
    at[H] = max(at[H] - at[FRICTION] * R, 0.0)
    at[OPEN_H] = max(at[OPEN_H], at[FRICTION] * (at[OPEN_V] + ULPS * abs(R)))
    at[MET] = max(at[MET], np.hypot(at[H], at[V]))


@fast
def _land(parts: Parts, k: int, at: Any, ratio: Any) -> None:
    """Arrive at part k, which lies: at height 0, without vertical force, and it does not float."""
    note(ratio, TOUCH_V, at[V], at[OPEN_V] + FORCE * at[MET] + parts.blur[k])
    if at[LIES] == 0.0:
        note(ratio, TOUCH_Z, at[Z], at[FAR] + at[OPEN_Z])
        _close(at[Z], parts.blur[k], at, ratio)
    note(ratio, FLOATS, min(parts.weight[k] * parts.length[k], 0.0), at[FORCE_LIMIT])
    at[V] = at[Z] = at[OPEN_V] = 0.0
    at[OPEN_Z] = ULPS * at[SIZE]
    at[LIES] = 1.0


@fast
def _close(miss: float, blur: float, at: Any, ratio: Any) -> None:
    """End a hanging part: by what force would it not miss the height of its lower end."""
    if at[Z_V] > 0.0:
        short = max(abs(miss) - at[OPEN_Z], 0.0)
        note(ratio, V_BY_HEIGHT, short / at[Z_V], FORCE * at[MET] + blur)
        at[YIELDS] += max(at[X_H] - at[X_V] * at[X_V] / at[Z_V], 1e-12 * at[X_H])
        at[SKEW] += miss * at[X_V] / at[Z_V]
        at[OPEN_SKEW] += at[OPEN_Z] * abs(at[X_V] / at[Z_V])
    if at[TOP_V] < 0.0:
        at[TOP_V] = at[OPEN_Z] / at[Z_V] if at[Z_V] > 0.0 else at[OPEN_V]
    at[X_H] = at[X_V] = at[Z_V] = 0.0


@fast
def _along_the_bed_down(parts: Parts, k: int, at: Any) -> None:
    """Follow part k on the bed: friction takes the tension off, down to 0."""
    length, c = parts.length[k], parts.compliance[k]
    loss = at[FRICTION] * parts.weight[k]
    held = length if loss * length <= at[H] else at[H] / loss
    at[X] -= length + c * held * (at[H] - 0.5 * loss * held)
    at[YIELDS] += c * held
    at[H] = max(at[H] - loss * length, 0.0)
    at[OPEN_H] = max(at[OPEN_H], ULPS * loss * at[SIZE])
    at[OPEN_X] += c * held * at[OPEN_H] + ULPS * length
    at[MET] = at[H]


@fast
def _hang(parts: Parts, k: int, way: float, at: Any, ratio: Any) -> None:
    """Follow part k, which hangs, upwards (`way` 1) or downwards (-1) along the line."""
    length, w, c = parts.length[k], parts.weight[k], parts.compliance[k]
    at[LIES] = 0.0
    change = w * length
    at[OPEN_V] = max(at[OPEN_V], parts.blur[k], ULPS * max(abs(at[V]), abs(at[V] + way * change)))
    lower = at[V] if way > 0.0 else at[V] - change
    at[V] += way * change
    at[MET] = max(at[MET], np.hypot(at[H], at[V]))
    r = _reach(at[H], lower, w, c, length, at[OPEN_H] + at[OPEN_V])
    z_lower = at[Z] if way > 0.0 else at[Z] - r.z
    at[X] += way * r.x
    at[Z] += way * r.z
    at[OPEN_X] += r.doubt + ULPS * abs(r.x)
    at[OPEN_Z] += r.doubt + ULPS * abs(r.z)
    at[X_H] += r.x_H
    at[X_V] += r.x_V
    at[Z_V] += r.z_V
    note(ratio, BELOW, min(z_lower + r.low, 0.0), at[FAR] + at[OPEN_Z])


@fast
def up(parts: Parts, ends: Ends, most: Any, ratio: Any, place: Any) -> Walked:
    """Walk from the anchor to the fairlead; `place` (n + 1, 2) takes the way, m."""
    n = len(parts.length)
    open_V = ULPS * _most_of(parts, most, 0)
    at = _started(ends, 0.0, ends.anchor_height, ends.H_anchor, ends.V_anchor, open_V)
    for k in range(n):
        place[k, 0], place[k, 1] = at[X], at[Z]
        if not np.isnan(parts.x[k]):
            # The answer counts V from anywhere in the hanging part.
            open_said = parts.blur[k] + ULPS * _most_of(parts, most, k)
            open_force = at[FORCE_LIMIT] + at[OPEN_V] + open_said
            note(ratio, PLACE, parts.x[k] - at[X], at[FAR] + at[OPEN_X])
            note(ratio, PLACE, parts.z[k] - at[Z], at[FAR] + at[OPEN_Z])
            note(ratio, STRETCH_FORCE, parts.H[k] - at[H], at[FORCE_LIMIT] + at[OPEN_H])
            note(ratio, STRETCH_FORCE, parts.V[k] - at[V], open_force)
        if parts.on_bed[k]:
            if at[LIES] == 0.0:
                open_force = at[FORCE_LIMIT] + at[OPEN_V] + parts.blur[k]
                note(ratio, TOUCH_Z, at[Z], at[FAR] + at[OPEN_Z])
                note(ratio, TOUCH_V, at[V], open_force)
            _along_the_bed_up(parts, k, at)
        else:
            _hang(parts, k, 1.0, at, ratio)
        if k < n - 1:
            _past_a_joint_up(parts, k, at, ratio)
    place[n, 0], place[n, 1] = at[X], at[Z]
    note(ratio, UP_X, at[X] - ends.span, at[FAR] + at[OPEN_X])
    note(ratio, UP_Z, at[Z] - ends.height, at[FAR] + at[OPEN_Z])
    note(ratio, UP_H, at[H] - ends.H, at[FORCE_LIMIT] + at[OPEN_H])
    note(ratio, UP_V, at[V] - ends.V, at[FORCE_LIMIT] + at[OPEN_V])
    return Walked(at[OPEN_X], at[OPEN_Z], at[OPEN_H], at[OPEN_V])


@fast
def _along_the_bed_up(parts: Parts, k: int, at: Any) -> None:
    """Follow part k on the bed: friction adds to the tension, unless the part lies loose."""
    length, c = parts.length[k], parts.compliance[k]
    gain = 0.0 if parts.loose[k] else at[FRICTION] * parts.weight[k]
    at[V] = at[Z] = at[OPEN_V] = 0.0
    at[OPEN_Z] = ULPS * at[SIZE]
    at[X] += length + c * length * (at[H] + 0.5 * gain * length)
    # Where the tension begins is exact to SNAP of the length.
    open_H = (ULPS + SNAP) * at[FRICTION] * parts.weight[k] * at[SIZE]
    at[OPEN_H] = max(at[OPEN_H], open_H)
    at[OPEN_X] += c * length * at[OPEN_H] + ULPS * length
    at[H] += gain * length
    at[LIES] = 1.0


@fast
def _past_a_joint_up(parts: Parts, k: int, at: Any, ratio: Any) -> None:
    """Pass the point loads on the upper end of part k.

    Where nothing is left below it, friction under a clump weight takes off no more than there is:
    how much that is, is for the answer to say.
    """
    W, R = parts.load[k], parts.reaction[k]
    if W == 0.0 and R == 0.0:
        return
    at[V] += W - R
    at[OPEN_V] = max(at[OPEN_V], ULPS * max(abs(at[V]), abs(W), abs(R)))
    at[OPEN_H] = max(at[OPEN_H], at[FRICTION] * (at[OPEN_V] + ULPS * abs(R)))
    gain = at[FRICTION] * R
    if at[H] == 0.0 and R > 0.0 and not np.isnan(parts.H[k + 1]):
        said = parts.H[k + 1]
        note(ratio, UP_H, max(-said, said - gain, 0.0), at[FORCE_LIMIT] + at[OPEN_H])
        gain = said
    at[H] += gain


@fast
def _reach(force: float, V: float, w: float, c: float, length: float, error: float) -> Reach:
    if force > 0.0:
        return hanging(force, V, w, c, length, error)
    return upright(V, w, c, length, error)


@fast
def _most_of(parts: Parts, most: Any, first: int) -> float:
    """Largest force in what hangs from the lower end of part `first` on, N."""
    found = 0.0
    for k in range(first, len(most)):
        if parts.on_bed[k]:
            break
        found = max(found, most[k])
    return found
