"""The tension of a ship's mooring over what is known of her to no better than a range."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

from catopt.errors import NoAnswerError, NotConvergedError
from catopt.loads.ship_ranges import RANGES, at_the_end, in_the_middle
from catopt.model import Case, ShipAfloat
from catopt.sizing.in_motion import Band, Reach
from catopt.verify.ship_result import remarks_of
from catopt.verify.two_scales import moored_ship, verify_ship
from catopt.words import Message


def band_of(case: Case, **on_lines: Any) -> Band:
    """Run a case of a ship with each input at the ends of its range, and all in the middle.

    Seas and gusts are those of the case throughout; lines as of `verify_ship`.
    """
    floater = case.floater
    assert floater is not None
    assert floater.ship is not None
    middle = in_the_middle(floater.ship)

    def tension(of: ShipAfloat) -> float | None:
        try:
            own = replace(case, floater=replace(floater, ship=of))
            found = verify_ship(own, proven=False, **on_lines)
        except (NoAnswerError, NotConvergedError):
            return None
        return max(each.judged("most-probable") for each in found.lines)

    def reaches() -> Iterator[Reach]:
        for cause in RANGES:
            low = tension(at_the_end(middle, cause, favourable=True))
            yield Reach(cause, low, tension(at_the_end(middle, cause)))

    return Band(tension(middle), tuple(reaches()))


def basis_of(case: Case) -> tuple[str, ...]:
    """Say what a run of a ship's case stands on, with the numbers to follow it by."""
    moored, drive = moored_ship(case)
    sea, ship = drive.sea(0), moored.ship
    assert sea.waves is not None
    rest = moored.at_rest(sea.waves)
    surge, sway, yaw = ship.inertia.diagonal().tolist()
    added = ship.added
    damping = (ship.of.surge_damping, ship.of.sway_damping, ship.of.yaw_damping)
    masses = {"mass": ship.mass / 1e3, "surge": added[0] / 1e3, "sway": added[1] / 1e3}
    stiff = dict(zip(("surge", "sway", "yaw"), rest.stiffness, strict=True))
    critical = (
        2.0 * part * math.sqrt(max(k, 0.0) * m)
        for part, k, m in zip(damping, rest.stiffness, (surge, sway, yaw), strict=True)
    )
    slow = zip(("surge", "sway", "yaw"), critical, strict=True)
    means = {
        name: math.hypot(*part[:2]) / 1e3
        for name, part in zip(("wind", "current", "drift"), rest.parts, strict=True)
    }
    period = 2.0 * math.pi * math.sqrt(surge / stiff["surge"]) if stiff["surge"] > 0.0 else math.inf
    return (
        Message("floater.basis_mass", **masses, yaw=yaw / 1e3),
        Message("floater.basis_mean", speed=math.hypot(*ship.wind), **means),
        Message("floater.basis_stiffness", **{key: each / 1e3 for key, each in stiff.items()}),
        Message("floater.basis_damping", **{key: each / 1e3 for key, each in slow}, period=period),
        Message("floater.basis_gusts"),
        Message("floater.basis_newman"),
        *remarks_of(case, moored, sea, rest),
    )
