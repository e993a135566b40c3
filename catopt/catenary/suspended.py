"""The suspended part of a line below its fairlead, and the part on the bed below that.

The suspended part is followed down from the forces H and V at the fairlead, one piece after the
other. Where it ends is said by its place of touchdown, a whole number that rises up the line:

    NO_TOUCHDOWN      at the anchor, whatever the line passes through
    FIRST_TOUCHDOWN   where V first falls to 0: inside a piece, or at a clump weight
    inside(k)         inside piece k, where V falls to 0
    at_clump(k)       at the clump weight on the joint below piece k, which the bed carries in part

A hanging part of the line: what lies between two places where it is held or rests on the bed.

The forces along it are counted from the piece in which they are known best: at a touchdown V is 0
exactly, and what hangs above it adds up from there. Counted down from the fairlead, V near the
touchdown would be the small difference of large weights.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from catopt.catenary.pieces import Pieces, piece_reach, piece_rise, rise_by_V, tension_past_clump
from catopt.compiled import inlined

NO_TOUCHDOWN = -1


@inlined
def at_clump(piece: int) -> int:
    """Return the place at the clump weight on the joint below a piece."""
    return 2 * piece + 1


@inlined
def inside(piece: int) -> int:
    """Return the place inside a piece."""
    return 2 * piece


@inlined
def is_inside(place: int) -> bool:
    """Whether it is inside a piece."""
    return place % 2 == 0


@inlined
def piece_of(place: int) -> int:
    """Return the piece that it is inside, or on whose lower joint."""
    return place // 2


class Part(NamedTuple):
    """A hanging part; the line's pieces are counted from the anchor.

    H is its horizontal force (N; 0 when it hangs straight), `slope` the sine of the inclination of
    pieces that have neither weight nor force. It ends above in piece `top`, top_length (m) of which
    lies below the end, and below in piece `bottom`, bottom_length (m) of which lies above the end.
    V (N) is the vertical force at the lower end of its share in `piece`. `touchdown` says how it
    ends below: NO_TOUCHDOWN at the anchor, `inside` a piece, or `at_clump` below one.
    """

    H: float
    slope: float
    top: int
    top_length: float
    bottom: int
    bottom_length: float
    piece: int
    V: float
    touchdown: int


NO_PART = Part(math.nan, 0.0, -1, 0.0, -1, 0.0, 0, math.nan, NO_TOUCHDOWN)
"""Where there is none, or none was found."""

TO_THE_ANCHOR = Part(0.0, 0.0, 0, 0.0, -1, 0.0, 0, 0.0, NO_TOUCHDOWN)
"""What follows a touchdown below which the line lies all the way to its anchor."""


def with_force(part: Part, piece: int, V: float) -> Part:
    """Return the same part with the vertical force known in another place."""
    return Part(*part[:6], piece, V, part.touchdown)


def with_slope(part: Part, slope: float) -> Part:
    """Return the same part with its loose pieces inclined."""
    return Part(part.H, slope, *part[2:])


class PartReach(NamedTuple):
    """How far a part reaches from its lower to its upper end: x and z, m.

    x_H, z_H and z_V are derivatives by H and by a shift of V along the whole part (m/N; dx/dV =
    dz/dH), all 0 without horizontal force. V_top and V_bottom act at its ends (N). `low` is its
    lowest point above its lower end (m; 0 or below), `smallest` the piece with the smallest
    vertical force at its lower end; not the one in which it touches down, where that is 0 exactly.
    """

    x: float
    z: float
    x_H: float
    z_H: float
    z_V: float
    V_top: float
    V_bottom: float
    low: float
    smallest: int


def share(part: Part, pieces: Pieces, k: int) -> float:
    """Unstretched length of piece k that belongs to a part, m."""
    length: float = pieces.length[k]
    if k == part.bottom and part.bottom_length < length:
        return part.bottom_length - (length - part.top_length if k == part.top else 0.0)
    return part.top_length if k == part.top else length


def part_reach(part: Part, pieces: Pieces) -> PartReach:
    """Add up a part from the piece whose forces are known, upwards and downwards."""
    H = part.H
    x = x_H = z_H = z_V = 0.0
    # Upwards; heights are above the lower end of the share in `part.piece`.
    z = low = 0.0
    V = part.V
    smallest, least = part.piece, math.inf if is_inside(part.touchdown) else abs(V)
    for k in range(part.piece, part.top + 1):
        if k > part.piece:
            V += pieces.load[k]
            if abs(V) < least:
                smallest, least = k, abs(V)
        length = share(part, pieces, k)
        V2 = V + pieces.weight[k] * length
        low = min(low, z + _sag(H, V, V2, pieces.weight[k], pieces.compliance[k]))
        dx, dz, by_H, dz_H, dz_V = _reach(part, V, V2, length, pieces.compliance[k])
        x, z, x_H, z_H, z_V = x + dx, z + dz, x_H + by_H, z_H + dz_H, z_V + dz_V
        low = min(low, z)
        V = V2
    V_top = V
    top = z
    z = 0.0
    V = part.V
    for k in range(part.piece - 1, part.bottom - 1, -1):
        V -= pieces.load[k + 1]
        length = share(part, pieces, k)
        V1 = V - pieces.weight[k] * length
        dx, dz, by_H, dz_H, dz_V = _reach(part, V1, V, length, pieces.compliance[k])
        x, z, x_H, z_H, z_V = x + dx, z - dz, x_H + by_H, z_H + dz_H, z_V + dz_V
        low = min(low, z + _sag(H, V1, V, pieces.weight[k], pieces.compliance[k]), z)
        V = V1
        if abs(V) < least:
            smallest, least = k, abs(V)
    return PartReach(x, top - z, x_H, z_H, z_V, V_top, V, low - z, smallest)


def _reach(
    part: Part, V1: float, V2: float, length: float, compliance: float
) -> tuple[float, float, float, float, float]:
    """Reach of one piece and its derivatives by H, and by V of the height."""
    H = part.H
    if H > 0.0:
        T1, T2 = math.sqrt(H * H + V1 * V1), math.sqrt(H * H + V2 * V2)
        reach = piece_reach(H, V1, V2, T1, T2, length, compliance)
        return reach.dx, reach.dz, reach.x_H, reach.z_H, reach.z_V
    loose = V1 == 0.0 and V2 == 0.0
    dx = length * math.sqrt(1.0 - part.slope * part.slope) if loose else 0.0
    return dx, piece_rise(H, V1, V2, length, compliance, part.slope), 0.0, 0.0, 0.0


def _sag(H: float, V1: float, V2: float, weight: float, compliance: float) -> float:
    """Height of a heavy piece's lowest point above its lower end, m; 0 when that is the lowest."""
    if not V1 < 0.0 < V2:
        return 0.0
    return piece_rise(H, V1, 0.0, -V1 / weight, compliance, 0.0)


FIRST_TOUCHDOWN = -2


class SuspendedPart(NamedTuple):
    """The suspended part: reach (m), derivatives by H and V at the fairlead (m/N; dx/dV = dz/dH).

    It ends in piece `bottom`, of which bottom_length (unstretched, m) hangs, with the vertical
    force V (N) at the anchor or just above the clump weight; touchdown is NO_TOUCHDOWN, `inside` or
    `at_clump`.
    """

    x: float
    z: float
    x_H: float
    z_H: float
    z_V: float
    touchdown: int
    bottom: int
    bottom_length: float
    V: float


class GroundedPart(NamedTuple):
    """The part on the bed: length along x (m), its derivative by H (m/N), H beyond it (N)."""

    x: float
    x_H: float
    H: float


@inlined
def suspended_height(H: float, V: float, pieces: Pieces) -> tuple[float, float]:
    """Height of the fairlead above the anchor or the first touchdown (m), and its derivative by V.

    H above 0 and V not below, N, on a line without buoyant parts.
    """
    z = 0.0
    z_V = 0.0
    T = math.sqrt(H * H + V * V)
    for k in range(len(pieces.length) - 1, -1, -1):
        length = pieces.length[k]
        V1 = V - pieces.weight[k] * length
        is_last = V1 < 0.0
        if is_last:
            length = V / pieces.weight[k]
            V1 = 0.0
        T1 = math.sqrt(H * H + V1 * V1)
        m = T1 + T
        cl = pieces.compliance[k] * length
        z += (V1 + V) * (length / m + 0.5 * cl)
        z_V += rise_by_V(H, V1, V, m, T1 * T, length) + cl
        below = V1 - pieces.load[k]
        if is_last or below < 0.0:
            break
        V = below
        T = T1 if pieces.load[k] == 0.0 else math.sqrt(H * H + V * V)
    return z, z_V


@inlined
def suspended_part(H: float, V: float, pieces: Pieces, touchdown: int) -> SuspendedPart:
    """Follow the suspended part down to a touchdown; all derivatives of its reach. H above 0."""
    x = 0.0
    z = 0.0
    x_H = 0.0
    z_H = 0.0
    z_V = 0.0
    T = math.sqrt(H * H + V * V)
    for k in range(len(pieces.length) - 1, -1, -1):
        length = pieces.length[k]
        V1 = V - pieces.weight[k] * length
        falls_here = touchdown == inside(k) or (touchdown == FIRST_TOUCHDOWN and V1 < 0.0)
        if falls_here:
            length = max(V, 0.0) / pieces.weight[k] if pieces.weight[k] > 0.0 else 0.0
            V1 = 0.0
        T1 = math.sqrt(H * H + V1 * V1)
        part = piece_reach(H, V1, V, T1, T, length, pieces.compliance[k])
        x += part.dx
        z += part.dz
        x_H += part.x_H
        z_H += part.z_H
        z_V += part.z_V
        if falls_here:
            return SuspendedPart(
                x, z, x_H, z_H, z_V, inside(k), k, min(length, pieces.length[k]), 0.0
            )
        below = V1 - pieces.load[k]
        if touchdown == at_clump(k) or (touchdown == FIRST_TOUCHDOWN and below < 0.0):
            return SuspendedPart(x, z, x_H, z_H, z_V, at_clump(k), k, length, V1)
        V = below
        T = T1 if pieces.load[k] == 0.0 else math.sqrt(H * H + V * V)
    return SuspendedPart(x, z, x_H, z_H, z_V, NO_TOUCHDOWN, 0, pieces.length[0], V)


@inlined
def grounded_part(
    H: float,
    pieces: Pieces,
    friction: float,
    piece: int,
    rest: float,
    end_piece: int,
    end_rest: float,
) -> GroundedPart:
    """Follow the line on the bed from a touchdown, where its force is H (N), towards the anchor.

    Friction takes its Coulomb coefficient times the bed's reaction off the tension, on the weight
    of the line and on clump weights, down to 0 and not further. `rest` is the length of the first
    piece that lies on the bed, `end_rest` that of the last piece that does not, m.
    """
    T = H
    x = 0.0
    x_H = 0.0
    for k in range(piece, end_piece - 1, -1):
        length = rest if k == piece else pieces.length[k]
        if k == end_piece:
            length -= end_rest
        loss = friction * pieces.weight[k]
        tensioned = length if loss * length <= T else T / loss
        T1 = max(T - loss * length, 0.0)
        x += length + pieces.compliance[k] * tensioned * 0.5 * (T + T1)
        x_H += pieces.compliance[k] * tensioned
        T = T1
        if k > end_piece and pieces.load[k] != 0.0:
            T = tension_past_clump(T, pieces, k, friction, pieces.load[k])
    return GroundedPart(x, x_H, T)


LAST_STEP = 1e-8
"""A Newton step this small, relatively, leaves its square: less than the last digit."""


def vertical_force(
    H: float,
    height: float,
    pieces: Pieces,
    length: float,
    weight: float,
    guess: float,
    last_step: float,
) -> float:
    """Vertical force at the fairlead that lifts it to `height` above anchor or first touchdown, N.

    Newton's method from `guess` on a rising function, kept inside a bracket that every evaluation
    narrows; nan when it does not converge. The line, of whole `length` (m) and `weight` (N), has no
    buoyant parts. After a Newton step of the relative size `last_step` no other is taken: 0 to go
    on to the last digit, or LAST_STEP where the caller looks at what is left of the height.
    """
    scale = max(length, height)
    low, high = 0.0, math.inf
    stride = H + abs(guess)
    last_error = math.inf
    V = guess
    for _ in range(200):
        z, z_V = suspended_height(H, V, pieces)
        error = z - height
        is_slow = abs(error) > 0.5 * last_error
        if abs(error) <= 2e-16 * scale or (
            is_slow and abs(error) <= 1e-12 * scale and last_step > 0.0
        ):
            return V
        last_error = abs(error)
        if error > 0.0:
            high = min(high, V)
        else:
            low = max(low, V)
        new = _step(H, V, error, z_V, V < weight)
        step = abs(new - V)
        if step <= last_step * abs(V) and low < new < high:
            return new
        if step <= 2.3e-16 * max(abs(V), H) or not low < high:
            # The last digit of V is reached: what its rounding leaves of the height decides.
            return V if abs(error) <= 1e-10 * scale else math.nan
        if is_slow or not low < new < high:
            if math.isinf(high):
                new = max(V - math.copysign(stride, error), low)
                stride *= 4.0
            else:
                new = 0.5 * (low + high)
                if new in (low, high):
                    return V if abs(error) <= 1e-10 * scale else math.nan
        V = new
    return math.nan


@inlined
def _step(H: float, V: float, error: float, z_V: float, is_grounded: bool) -> float:
    """Newton's next V; inf where the height does not answer.

    From a touchdown the height of a uniform line is (T - H)/w: linear in T, not in V. Taken in T,
    the step of such a line needs no second one, and that of others few.
    """
    if z_V <= 0.0:
        return math.inf
    if not is_grounded or V <= 0.0:
        return V - error / z_V
    T = math.sqrt(H * H + V * V)
    rise = -error * V / (z_V * T)
    square = V * V + rise * (2.0 * T + rise)
    # A tension below 0 would come back as its mirror image, and then the step as no step at all.
    return math.sqrt(square) if square > 0.0 and T + rise > 0.0 else 0.5 * V


@inlined
def grounded_guess(H: float, pieces: Pieces, rise: float, length: float, weight: float) -> float:
    """V at the fairlead of a uniform line of the same mean weight, touchdown or not.

    Its tension at the fairlead is H + p with p + c p (p + 2 H) / 2 = w rise; a line of several
    pieces is taken not to stretch, for its mean weight is the greater error.
    """
    p = max(weight / length * rise, 0.0)
    if len(pieces.length) == 1:
        stiff = 1.0 + pieces.compliance[0] * H
        p *= 2.0 / (stiff + math.sqrt(stiff * stiff + 2.0 * pieces.compliance[0] * p))
    V = math.sqrt(p * (p + 2.0 * H))
    return V if V < weight else _suspended_guess(H, rise, length, weight)


@inlined
def _suspended_guess(H: float, rise: float, length: float, weight: float) -> float:
    """V at the fairlead of a hanging line whose mean direction is that of its chord."""
    slope = max(-0.999, min(0.999, rise / length))
    return H * slope / math.sqrt(1.0 - slope * slope) + 0.5 * weight


def top_weight(pieces: Pieces, length: float) -> float:
    """Submerged weight of the uppermost `length` (m, unstretched) of the line, N."""
    weight = 0.0
    for k in range(len(pieces.length) - 1, -1, -1):
        if pieces.length[k] >= length:
            weight += pieces.weight[k] * length
            break
        weight += pieces.weight[k] * pieces.length[k] + pieces.load[k]
        length -= pieces.length[k]
    return weight
