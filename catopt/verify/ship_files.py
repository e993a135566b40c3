"""From a ship on two time scales to its lines in the truss model, led by both motions of a run."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Final

import numpy as np

from catopt.floater.two_scales import SLOW_STEP
from catopt.hydro.coefficients import FREEDOMS
from catopt.model import Case, Motion
from catopt.verify.ship_result import ShipVerification

RAOS: Final = "ship_raos.csv"
DRIFT: Final = "ship_drift.csv"
LONGEST: Final = 1200.0
"""s of the run that the truss model is given: it takes minutes of processor a minute."""
_AROUND: Final = math.radians(5.0)
"""Between headings, and beyond those of the waves."""


def led_case(found: ShipVerification) -> Case:
    """Make the case of its lines in motion, led by RAOs and drift of the first run.

    Its files are those of `raos_csv` and `drift_csv`, by the names `RAOS` and `DRIFT`; its mean
    load is that of the weather, its waves are the same. The slow yaw is not in it.
    """
    case, rest = found.case, found.rest
    assert case.system is not None
    assert case.dynamics is not None
    moment = float(np.sum(rest.parts, axis=0)[2]) if case.system.turns else 0.0
    _, reference, crest = found.moored.raos
    motion = Motion(
        rao_file=RAOS,
        rao_phase="lag",
        rao_reference=(*_turned(found, reference[0], reference[1]), reference[2]),
        rao_rotation="rad/m",
        rao_per="amplitude",
        rao_crest=_turned(found, crest[0], crest[1]),
        drift_file=DRIFT,
    )
    duration = min(case.dynamics.duration, LONGEST)
    ramp = case.dynamics.ramp if case.dynamics.ramp and case.dynamics.ramp < duration else None
    return replace(
        case,
        system=replace(case.system, force=rest.force, moment=moment),
        floater=None,
        motion=motion,
        dynamics=replace(case.dynamics, duration=duration, ramp=ramp, runs=1),
    )


def _axis(found: ShipVerification) -> float:
    """Angle from the axes of the lines' body at rest to the ship's: of one that turns freely."""
    return 0.0 if found.moored.system.turns else found.rest.place[2]


def _turned(found: ShipVerification, x: float, y: float) -> tuple[float, float]:
    turned = complex(x, y) * np.exp(1j * _axis(found))
    return float(turned.real), float(turned.imag)


def raos_csv(found: ShipVerification) -> str:
    """Tabulate the ship's response around the headings of the waves, in the axes of the lines."""
    answer, _, _ = found.moored.raos
    yaw, axis = found.rest.place[2], _axis(found)
    seen = found.directions - yaw
    low, high = float(seen.min()) - _AROUND, float(seen.max()) + _AROUND
    count = max(3, math.ceil((high - low) / _AROUND) + 1)
    omega = answer.omega
    names = [f"{name} ({'m/m' if k < 3 else 'rad/m'})" for k, name in enumerate(FREEDOMS)]
    names += [f"{name}_phase (deg)" for name in FREEDOMS]
    lines = [",".join(["heading (deg)", "frequency (rad/s)", *names])]
    for heading in np.linspace(low, high, count).tolist():
        six = answer.at("response", omega, np.full(omega.size, heading))
        cosine, sine = math.cos(axis), math.sin(axis)
        for first in (0, 3):  # ways, and turns, along x and y
            a, b = six[:, first].copy(), six[:, first + 1].copy()
            six[:, first], six[:, first + 1] = a * cosine - b * sine, a * sine + b * cosine
        for w, row in zip(omega.tolist(), six, strict=True):
            cells = [math.degrees(heading + axis), w]
            cells += [*np.abs(row).tolist(), *np.degrees(np.angle(row)).tolist()]
            lines.append(",".join(f"{each:.8g}" for each in cells))
    return "\n".join(lines) + "\n"


def drift_csv(found: ShipVerification) -> str:
    """Tabulate the slow motion of the first run from where it rests."""
    course, rest = found.runs[0].course, found.rest.place
    lines = ["t (s),x (m),y (m)"]
    for n, (x, y, _) in enumerate(course.tolist()):
        lines.append(f"{n * SLOW_STEP:g},{x - rest[0]:.9g},{y - rest[1]:.9g}")
    return "\n".join(lines) + "\n"
