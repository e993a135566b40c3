"""Drag and added mass of a rough circular cylinder, S4 [2.29]-[2.32]: wires and ropes, not chain.

RECALLED, NOT VERIFIED. Of S4's formulas only fragments can be read; they fit those of DNV-RP-C205,
which S4 cites, as recalled: the parts meet at their limits. m and n alone are S4's as printed, for
a slender cylinder: 0.02 to 0.03 and 0.04 to 0.05, of which the upper ends are taken here.
"""

from __future__ import annotations

import math
from typing import Final

OBLIQUE: Final = (0.03, 0.05)
"""m and n of the drag along, C_n (m + n sin g) cos g, S4 [2.32]."""

_SMOOTH, _ROUGH = 1e-4, 1e-2


def steady_drag(roughness: float, diameter: float) -> float:
    """C_DS in a steady flow, S4 [2.30]: 0.65 when smooth, 1.05 when rough; k and D in m."""
    relative = roughness / diameter
    if relative < _SMOOTH:
        return 0.65
    if relative > _ROUGH:
        return 1.05
    return (29.0 + 4.0 * math.log10(relative)) / 20.0


def wake_amplification(steady: float, keulegan_carpenter: float) -> float:
    """Factor psi on C_DS in a flow to and fro, C_D = psi C_DS, S4 [2.29].

    `keulegan_carpenter`: KC = v T/D, v being the amplitude of the velocity; 0 or more and below 12:
    from there on S4 has a graph.
    """
    C_pi = 1.50 - 0.024 * (12.0 / steady - 10.0)
    KC = keulegan_carpenter
    if KC < 0.75:
        return C_pi - 1.0 - 2.0 * (KC - 0.75)
    return C_pi - 1.0 if KC < 2.0 else C_pi + 0.10 * (KC - 12.0)


def added_mass(steady: float, keulegan_carpenter: float) -> float:
    """C_A across the cylinder, S4 [2.31], at KC of 0 or more; C_M = 1 + C_A."""
    if keulegan_carpenter < 3.0:
        return 1.0
    return max(1.0 - 0.044 * (keulegan_carpenter - 3.0), 0.6 - (steady - 0.65))
