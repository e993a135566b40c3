"""S2's and S3's way through a sinker: its weight read as a piece of line of equivalent length."""

from __future__ import annotations

import math
from dataclasses import dataclass


@dataclass(frozen=True)
class SinkerLine:
    """A line with a sinker whose anchor inclination is 0, as two pieces of one catenary.

    The catenary is that of a line without sinker; O is where it is level. The lower piece, of the
    length of line below the sinker, ends at b1. The upper piece starts at b2, further up by the
    equivalent length, and ends at the fairlead C.

    `x_b1`, `x_b2`, `x_oc`: from O to b1, b2 and C, horizontally, m; `z_oc`: from O up to C, m; S2
    (35); `length`: of line, below and above the sinker, m; S2 (36).
    """

    x_b1: float
    x_b2: float
    x_oc: float
    z_oc: float
    length: float

    @property
    def span(self) -> float:
        """x_AC of S2 (40), m."""
        return self.x_b1 + self.x_oc - self.x_b2


def sinker_line(a: float, height: float, position: float, equivalent_length: float) -> SinkerLine:
    """Lay out a line with a sinker by S2 (30) to (40).

    `a`: H / q, m; `height`: of the fairlead above the anchor, m; `position`: length of line from
    the anchor to the sinker, m; `equivalent_length`: L_eq = W_s / q, m; S2 (30).
    """
    upper = position + equivalent_length
    z_b1, z_b2 = (math.hypot(a, s) - a for s in (position, upper))
    z_oc = height + z_b2 - z_b1
    l_oc = math.sqrt(z_oc * z_oc + 2.0 * a * z_oc)
    x_b1, x_b2, x_oc = (a * math.asinh(s / a) for s in (position, upper, l_oc))
    return SinkerLine(x_b1, x_b2, x_oc, z_oc, l_oc - equivalent_length)
