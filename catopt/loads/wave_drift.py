"""Mean wave drift force, in two simplifications: a side that reflects, and a slender cylinder."""

from __future__ import annotations

import math
from typing import Literal, get_args

from catopt.constants import STANDARD_GRAVITY
from catopt.loads.component import DTOCEAN, LoadComponent, LoadSource, Number
from catopt.loads.environment import SeaState
from catopt.model.kinds import Findings
from catopt.words import Message, term

DriftWave = Literal["sea state", "largest wave"]
"""The mean over an irregular sea of height Hs, or that under regular waves of the height Hmax."""

_SOURCE = LoadSource(DTOCEAN, "flat side, after Hermans and Remery 1970; depth, McIver 1987", "C")


def depth_factor(wave_number: float, depth: float) -> float:
    """1 + 2 k h/sinh(2 k h): what shallow water adds; 1 in deep water, 2 in shallow (C).

    DTOcean has it for a fixed cylinder. It is the ratio of twice the group to the phase velocity,
    which the momentum in any wave is multiplied with. k in rad/m, h in m.
    """
    double = 2.0 * wave_number * depth
    return 1.0 + (double / math.sinh(double) if double < 700.0 else 0.0)


def share_above(wave_number: float, draught: float, depth: float) -> float:
    """Part of a wave's energy that flows past above the keel: 1 - exp(-2 k T) in deep water.

    What flows is pressure times velocity, in a wave over depth h proportional to cosh^2 k z; below
    the keel that comes to (2 k c + sinh 2 k c)/(2 k h + sinh 2 k h) of all, c the water below it.
    k in rad/m, lengths in m; 1 for a hull that sits on the bed.
    """
    below, whole = (2.0 * wave_number * each for each in (max(depth - draught, 0.0), depth))
    if whole > 700.0:
        return 1.0 - math.exp(below - whole)
    return 1.0 - (below + math.sinh(below)) / (whole + math.sinh(whole))


def flat_side_drift(
    sea: SeaState,
    depth: float,
    *,
    reflection: float = 1.0,
    of: DriftWave = "sea state",
    water_density: float,
) -> float:
    """Mean force per metre on a side that reflects the waves, N/m.

    1/2 rho g (R a)^2 times `depth_factor`, a the amplitude. Over an irregular sea the mean of
    a^2/2 is m0 = Hs^2/16; for one regular wave a = Hmax/2 (not above breaking). The reflection R is
    from 0 to 1; 1, all of the wave, is the upper bound. Depth in m, density in kg/m3.
    """
    found = Findings("wave drift")
    found.number("depth", depth, "m", above=0.0)
    found.number("reflection", reflection, "", at_least=0.0, at_most=1.0)
    found.word("of", of, get_args(DriftWave))
    found.raise_if_any()
    factor = depth_factor(sea.wave_number(depth), depth)
    square = _half_mean_square(sea, depth, of)
    return water_density * STANDARD_GRAVITY * reflection**2 * square * factor


def _half_mean_square(sea: SeaState, depth: float, of: DriftWave) -> float:
    """Mean of a^2/2, m2."""
    if of == "sea state":
        return sea.hs**2 / 16.0
    return (0.5 * sea.height_in(depth)) ** 2 / 2.0


def width_across(length: float, breadth: float, angle: float) -> float:
    """Width of a box across the waves, L |sin| + B |cos|, m; the angle is from the bow, rad."""
    return length * abs(math.sin(angle)) + breadth * abs(math.cos(angle))


def ship_drift(
    sea: SeaState,
    length: float,
    breadth: float,
    depth: float,
    *,
    angle: float,
    reflection: float = 1.0,
    of: DriftWave = "sea state",
    water_density: float,
) -> tuple[LoadComponent, LoadComponent]:
    """Mean drift on a ship, taken for a box that reflects the waves.

    The width across the waves, L |sin| + B |cos|, m, times `flat_side_drift`, along the waves; the
    angle is from the bow to where they come from, rad. The rest is as of `flat_side_drift`.
    """
    per_metre = flat_side_drift(
        sea, depth, reflection=reflection, of=of, water_density=water_density
    )
    sine, cosine = math.sin(angle), math.cos(angle)
    width = width_across(length, breadth, angle)
    mean = "loads.mean_square_sea" if of == "sea state" else "loads.mean_square_wave"
    numbers = (
        Number("rho", water_density, "kg/m3", Message("loads.water_density")),
        Number("m", _half_mean_square(sea, depth, of), "m2", Message(mean)),
        Number("R", reflection, "", Message("loads.reflection")),
        Number("D", depth_factor(sea.wave_number(depth), depth), "", Message("loads.depth_factor")),
        Number("W", width, "m", Message("loads.width")),
    )
    factors = ("{rho}", "{g}", "{R:2}", "{m}", "{D}", "{W}")
    note = Message("loads.waves_note", kind=term(of), angle=math.degrees(angle))

    def component(name: str, axis: Literal["surge", "sway"], share: float) -> LoadComponent:
        force = per_metre * width * share
        return LoadComponent(name, "wave drift", axis, factors, numbers, force, _SOURCE, note)

    return (
        component(Message("loads.drift_along"), "surge", -cosine),
        component(Message("loads.drift_across"), "sway", sine),
    )
