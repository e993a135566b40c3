"""The tension of a ship's mooring over what is known of her to no better than a range."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from catopt.errors import NoAnswerError, NotConvergedError
from catopt.loads.ship_ranges import RANGES, at_the_end, in_the_middle
from catopt.model import Case, ShipAfloat
from catopt.sizing.in_motion import Band, Reach
from catopt.verify.two_scales import verify_ship


def band_of(case: Case) -> Band:
    """Run a case of a ship with each input at the ends of its range, and all in the middle.

    Seas and gusts are those of the case throughout.
    """
    floater = case.floater
    assert floater is not None
    assert floater.ship is not None
    middle = in_the_middle(floater.ship)

    def tension(of: ShipAfloat) -> float | None:
        try:
            found = verify_ship(replace(case, floater=replace(floater, ship=of)))
        except (NoAnswerError, NotConvergedError):
            return None
        return max(each.judged("most-probable") for each in found.lines)

    def reaches() -> Iterator[Reach]:
        for cause in RANGES:
            low = tension(at_the_end(middle, cause, favourable=True))
            yield Reach(cause, low, tension(at_the_end(middle, cause)))

    return Band(tension(middle), tuple(reaches()))
