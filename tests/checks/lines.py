"""Lines whose forces come out in whole numbers, so that every check can be done by hand.

Both weigh 1000 N/m in water and carry H = 30 kN, so that a = H/w = 30 m.

GROUNDED, 60 m in 20 m of water. Suspended: sqrt(h (h + 2 a)) = sqrt(20 * 80) = 40 m, so that 20 m
lie on the bed. At the fairlead V = 40 kN and T = H + w h = 50 kN (3 : 4 : 5). Span: 20 m on the bed
and a arcosh(1 + h/a) = 30 arcosh(5/3) = 30 ln 3 = 32.9584 m, together 52.9584 m.

LIFTED, 49.5 m in 40.5 m of water. Cut from a catenary between sinh u = 0.75 (cosh 1.25) and
sinh u = 2.4 (cosh 2.6): height 30 * (2.6 - 1.25) = 40.5 m, length 30 * (2.4 - 0.75) = 49.5 m. At
the anchor V = 30 * 0.75 = 22.5 kN and the angle is arctan 0.75; at the fairlead T = 30 * 2.6 =
78 kN.
"""

from __future__ import annotations

import math
from dataclasses import replace

from catopt.checks.case import check_case
from catopt.checks.result import CheckResult
from catopt.model import Case, Checks, Line, Load, Segment, Site

H = 30e3
CLOSE = 1e-12
"""Relative: a few roundings of the solver and of the arithmetic by hand."""
SPAN = 20.0 + 30.0 * math.log(3.0)

PLAIN = Segment(60.0, 1000.0, MBL=200e3, proof_load=100e3, nominal_diameter=0.1)
GROUNDED = Case(Site(20.0), Line([PLAIN]), Load(H), 20.0)
LIFTED = Case(Site(40.5), Line([replace(PLAIN, length=49.5)]), Load(H), 40.5)


def asking(case: Case = GROUNDED, checks: Checks | None = None, **parts: object) -> Case:
    """Return a case with other parts."""
    return replace(case, checks=checks or case.checks, **parts)  # type: ignore[arg-type]


def only(case: Case) -> CheckResult:
    """Return the one check that a case asks for."""
    (result,) = check_case(case).results
    return result
