"""Velocity and acceleration of the water: Airy waves at finite depth upon a current."""

from __future__ import annotations

import math
from typing import Any, Final, NamedTuple

import numpy as np

from catopt.arrays import Array
from catopt.compiled import inlined, packed

_ROUND: Final = 6755399441055744.0
"""1.5 · 2^52: adding and taking it away rounds to a whole number."""

_BY_LN2: Final = 1.4426950408889634
_LN2_HEAD: Final = 6.93147180369123816490e-01
_LN2_TAIL: Final = 1.90821492927058770002e-10

_BY_HALF_PI: Final = 0.6366197723675814
_HALF_PI_HEAD: Final = 1.57079632673412561417
_HALF_PI_TAIL: Final = 6.07710050650619224932e-11

_EXPONENT_BIAS: Final = 1023
_MANTISSA_BITS: Final = 52


@inlined
def exp_both_ways(x: float) -> tuple[float, float]:
    """exp(x) and exp(-x) for -700 < x < 700: 2^n times Taylor's series within ln(2)/2 of 0.

    The even and the odd terms of the series serve both. n is read from the bits of a sum, and put
    among those of 2^n: without a conversion between number types the compiler does several at once.
    """
    shifted = x * _BY_LN2 + _ROUND
    n = shifted - _ROUND
    r = x - n * _LN2_HEAD - n * _LN2_TAIL
    z = r * r
    even = 1.0 / 3628800.0 + z * (1.0 / 479001600.0)
    even = 1.0 / 40320.0 + z * even
    even = 1.0 / 720.0 + z * even
    even = 1.0 / 24.0 + z * even
    even = 0.5 + z * even
    even = 1.0 + z * even
    odd = 1.0 / 362880.0 + z * (1.0 / 39916800.0)
    odd = 1.0 / 5040.0 + z * odd
    odd = 1.0 / 120.0 + z * odd
    odd = 1.0 / 6.0 + z * odd
    odd = r + r * z * odd
    whole = np.float64(shifted).view(np.int64)
    bias, bits = np.int64(_EXPONENT_BIAS), np.int64(_MANTISSA_BITS)
    up = np.int64((whole + bias) << bits).view(np.float64)
    down = np.int64((bias - whole) << bits).view(np.float64)
    return (even + odd) * up, (even - odd) * down


@inlined
def cos_sin(angle: float) -> tuple[float, float]:
    """Cosine and sine of an angle in rad, absolute error below 1e-15 plus that of the angle.

    Minimax polynomials within pi/4 of a multiple of pi/2 (fdlibm's), then the quadrant.
    """
    shifted = angle * _BY_HALF_PI + _ROUND
    n = shifted - _ROUND
    r = angle - n * _HALF_PI_HEAD - n * _HALF_PI_TAIL
    z = r * r
    s = 2.75573137070700676789e-06 + z * (
        -2.50507602534068634195e-08 + z * 1.58969099521155010221e-10
    )
    s = 8.33333333332248946124e-03 + z * (-1.98412698298579493134e-04 + z * s)
    s = r + r * z * (-1.66666666666666324348e-01 + z * s)
    c = -2.75573143513906633035e-07 + z * (
        2.08757232129817482790e-09 + z * -1.13596475577881948265e-11
    )
    c = -1.38888888888741095749e-03 + z * (2.48015872894767294178e-05 + z * c)
    c = 1.0 - 0.5 * z + z * z * (4.16666666666666019037e-02 + z * c)
    quadrant = np.float64(shifted).view(np.int64)
    one, two = np.int64(1), np.int64(2)
    is_odd = (quadrant & one) != 0
    cos = s if is_odd else c
    sin = c if is_odd else s
    cos = -cos if ((quadrant + one) & two) != 0 else cos
    sin = -sin if (quadrant & two) != 0 else sin
    return cos, sin


NEGLIGIBLE: Final = 37.0
"""k (d - z) from which a wave is left out: exp(-37) is below the rounding of its surface motion."""


@packed
class Flow(NamedTuple):
    """A sea as the kernels read it; made by `Sea.flow`."""

    depth: float  # d, m
    is_stretched: bool  # by Wheeler
    reach: float  # k (d - z) from which a wave is left out: `NEGLIGIBLE`, or pi for half a length
    ramp_time: float  # s over which the waves grow from nothing; 0 for waves at once
    waves: Any  # (n, 8), a row a wave: omega, k cos b, k sin b, k, phi, cos b, sin b, a
    factors: Any  # (n, 2): q, and a omega/(1 - q)
    power_currents: Any  # (m, 3): surface speed along x and y, m/s, exponent
    current: Any  # (l, 3), from the bed up: height, m, speed along x and y, m/s
    current_series: Any  # (m, 3): time, s, and the complex factor on all that flows in two parts


@inlined
def smooth_ramp(t: float, ramp_time: float) -> tuple[float, float]:
    """Factor (1 - cos(pi t/T))/2 on the waves, from 0 at t = 0 to 1 at T, and its rate, 1/s."""
    if t >= ramp_time:
        return 1.0, 0.0
    if t <= 0.0:
        return 0.0, 0.0
    angle = math.pi * t / ramp_time
    return 0.5 * (1.0 - math.cos(angle)), 0.5 * math.pi / ramp_time * math.sin(angle)


def fill_elevation(t: Any, x: Any, y: Any, flow: Flow, eta: Any) -> None:
    """Write the surface's height above still water (m) at each time and place into `eta`.

    Parameters
    ----------
    t, x, y, eta : array, shape (n,)
        s, m, m; written to.
    flow : Flow
        The sea.
    """
    count = t.shape[0]
    for n in range(count):
        eta[n] = 0.0
    for i in range(flow.waves.shape[0]):
        omega, k_x, k_y = flow.waves[i, 0], flow.waves[i, 1], flow.waves[i, 2]
        phase, amplitude = flow.waves[i, 4], flow.waves[i, 7]
        for n in range(count):
            cos, _ = cos_sin(k_x * x[n] + k_y * y[n] - omega * t[n] + phase)
            eta[n] += amplitude * cos
    for n in range(count):
        ramp, _ = smooth_ramp(t[n], flow.ramp_time)
        eta[n] *= ramp


def row_at(rising: Any, value: float) -> int:
    """Find the last row that is not above a value, from rows that rise; -1 where all are.

    numpy's own takes a second to compile, most of it for the words of its errors.
    """
    low, high = 0, rising.shape[0]
    while low < high:
        middle = (low + high) // 2
        if rising[middle] <= value:
            low = middle + 1
        else:
            high = middle
    return low - 1


@inlined
def current_factor(t: float, flow: Flow) -> tuple[float, float, float, float]:
    """Complex factor on the current at a time, and its rate of change (1/s); held at either end."""
    rows = flow.current_series
    last = rows.shape[0] - 1
    if t <= rows[0, 0] or last == 0:
        return rows[0, 1], rows[0, 2], 0.0, 0.0
    if t >= rows[last, 0]:
        return rows[last, 1], rows[last, 2], 0.0, 0.0
    row = row_at(rows[:, 0], t)
    over = 1.0 / (rows[row + 1, 0] - rows[row, 0])
    rate_x = over * (rows[row + 1, 1] - rows[row, 1])
    rate_y = over * (rows[row + 1, 2] - rows[row, 2])
    passed = t - rows[row, 0]
    return rows[row, 1] + passed * rate_x, rows[row, 2] + passed * rate_y, rate_x, rate_y


def current_at(z: float, flow: Flow) -> tuple[float, float]:
    """Speed of the profiles along x and y at a height above the bed, m/s."""
    table = flow.current
    last = table.shape[0] - 1
    z = min(max(z, 0.0), flow.depth)
    row = 0
    while row < last - 1 and z > table[row + 1, 0]:
        row += 1
    part = (z - table[row, 0]) / (table[row + 1, 0] - table[row, 0])
    u = table[row, 1] + part * (table[row + 1, 1] - table[row, 1])
    v = table[row, 2] + part * (table[row + 1, 2] - table[row, 2])
    powers = flow.power_currents
    for i in range(powers.shape[0]):
        share = (z / flow.depth) ** powers[i, 2]
        u += powers[i, 0] * share
        v += powers[i, 1] * share
    return u, v


def fill_kinematics(
    t: float, points: Any, flow: Flow, velocity: Any, acceleration: Any, surface: Any
) -> None:
    """Write the water's motion at each point; nothing moves where there is no water.

    Parameters
    ----------
    t : float
        Time, s.
    points : array, shape (n, 3)
        x, y and height z above the bed, m. Below the bed the motion is that at the bed.
    flow : Flow
        The sea.
    velocity, acceleration : array, shape (n, 3)
        Written to: m/s and m/s², of waves and current at the fixed point.
    surface : array, shape (n,)
        Written to: height above the bed up to which there is water over each point, m.
    """
    count = points.shape[0]
    depth = flow.depth
    x, y, below = np.empty(count), np.empty(count), np.empty(count)
    for n in range(count):
        x[n], y[n], surface[n] = points[n, 0], points[n, 1], depth
    if flow.is_stretched:
        times = np.empty(count)
        for n in range(count):
            times[n] = t
        fill_elevation(times, x, y, flow, surface)
        for n in range(count):
            surface[n] += depth
    for n in range(count):
        # Wheeler: the profile up to still water is stretched to reach up to the surface.
        z, top = points[n, 2], surface[n]
        below[n] = depth - max(z, 0.0) * (depth / top) if z < top else 0.0
    sums = np.zeros((6, count))
    _add_waves(t, x, y, below, flow, sums)
    ramp, ramp_rate = smooth_ramp(t, flow.ramp_time)
    same, turned, same_rate, turned_rate = current_factor(t, flow)
    for n in range(count):
        for j in range(3):
            velocity[n, j] = ramp * sums[j, n]
            acceleration[n, j] = ramp * sums[3 + j, n] + ramp_rate * sums[j, n]
        u, v = current_at(points[n, 2], flow)
        velocity[n, 0] += same * u - turned * v
        velocity[n, 1] += same * v + turned * u
        acceleration[n, 0] += same_rate * u - turned_rate * v
        acceleration[n, 1] += same_rate * v + turned_rate * u
        if points[n, 2] > surface[n]:
            for j in range(3):
                velocity[n, j] = acceleration[n, j] = 0.0


def _add_waves(t: float, x: Any, y: Any, below: Any, flow: Flow, sums: Any) -> None:
    """Add velocity and acceleration of each wave at depths `below` still water to six rows.

    Points are the inner loop, and it has no branch: so the compiler does several at a time.
    """
    reach = flow.reach
    for i in range(flow.waves.shape[0]):
        wave = flow.waves[i]
        omega, k_x, k_y, k, cos_b, sin_b = wave[0], wave[1], wave[2], wave[3], wave[5], wave[6]
        phase = wave[4] - (omega * t) % (2.0 * math.pi)
        q, speed = flow.factors[i, 0], flow.factors[i, 1]
        for n in range(x.shape[0]):
            decay = k * below[n]
            here = speed if decay <= reach else 0.0
            E, inverse = exp_both_ways(-min(decay, reach))
            mirrored = q * inverse
            along, up = here * (E + mirrored), here * (E - mirrored)
            cos, sin = cos_sin(k_x * x[n] + k_y * y[n] + phase)
            u, u_t = along * cos, omega * along * sin
            sums[0, n] += u * cos_b
            sums[1, n] += u * sin_b
            sums[2, n] += up * sin
            sums[3, n] += u_t * cos_b
            sums[4, n] += u_t * sin_b
            sums[5, n] -= omega * up * cos


@packed
class WaterEnds(NamedTuple):
    """The water about some points at the start (0) and the end (1) of a whole step."""

    velocity: Array  # (2, points, 3): m/s
    acceleration: Array  # (2, points, 3): m/s2
    surface: Array  # (2, points): height up to which there is water, m
    points: Array  # (points, 3): where they are expected at its end, m
    is_known: Array  # (1,): 1.0 once the water at its end is


def water_ends(points: int) -> WaterEnds:
    """Room for so many points."""
    return WaterEnds(
        velocity=np.zeros((2, points, 3)),
        acceleration=np.zeros((2, points, 3)),
        surface=np.zeros((2, points)),
        points=np.zeros((points, 3)),
        is_known=np.zeros(1),
    )


def keep_start(velocity: Any, acceleration: Any, surface: Any, ends: WaterEnds) -> None:
    """Begin a whole step with the water at hand."""
    for n in range(surface.shape[0]):
        ends.surface[0, n] = surface[n]
        for i in range(3):
            ends.velocity[0, n, i] = velocity[n, i]
            ends.acceleration[0, n, i] = acceleration[n, i]
    ends.is_known[0] = 0.0


def look_ahead(t: float, flow: Flow, ends: WaterEnds) -> None:
    """Find the water at the whole step's end t, s, at `ends.points`."""
    fill_kinematics(t, ends.points, flow, ends.velocity[1], ends.acceleration[1], ends.surface[1])
    ends.is_known[0] = 1.0


def fill_between(
    part: float, ends: WaterEnds, velocity: Any, acceleration: Any, surface: Any
) -> None:
    """Write the water after a part of the whole step, straight between its ends.

    Of a wave's motion it is off by (omega step)^2/8 at most, omega being its angular frequency.
    """
    before = 1.0 - part
    for n in range(surface.shape[0]):
        surface[n] = before * ends.surface[0, n] + part * ends.surface[1, n]
        for i in range(3):
            velocity[n, i] = before * ends.velocity[0, n, i] + part * ends.velocity[1, n, i]
            acceleration[n, i] = (
                before * ends.acceleration[0, n, i] + part * ends.acceleration[1, n, i]
            )
