"""What is sold of the components that a line may be made of."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache
from typing import Final

from catopt.catalogue.choice import chosen
from catopt.catalogue.figure import within
from catopt.errors import InputError, Problem
from catopt.model import CatalogueChoice, Line, Segment
from catopt.sizing.line_choice import LineChoice

_ON_THE_BED: Final = 30.0
"""m."""


def catalogue_of(choice: LineChoice) -> CatalogueChoice:
    """Say where the components come from."""
    return CatalogueChoice(allow_recalled=choice.allow_recalled)


@cache
def sold(choice: LineChoice, water_density: float) -> tuple[Segment, ...]:
    """List a metre of everything that is sold within the bounds, component by component.

    Refused when there is no such component, or no size of any of them is sold within the bounds.
    """
    limits = (choice.diameter_min or 0.0, choice.diameter_max or math.inf)
    catalogue = chosen(catalogue_of(choice), water_density)
    there = [each for name in choice.components for each in catalogue.sold(name)]
    within_bounds = [each for each in there if within(each.nominal_diameter, limits)]
    if not within_bounds:
        names = ", ".join(choice.components)
        least, most = limits[0] * 1e3, limits[1] * 1e3
        allowed = f"no size of it is sold from {least:g} to {most:g} mm"
        raise InputError([Problem("components", names, allowed)], "LineChoice")
    return tuple(each.segment(1.0) for each in within_bounds)


def unpriced_components(choice: LineChoice, water_density: float) -> tuple[str, ...]:
    """List the components of which the price of a size that may be taken is not known."""
    every = sold(choice, water_density)
    return tuple(dict.fromkeys(each.component for each in every if each.price is None))


def longest_useful(choice: LineChoice, water_density: float, height: float) -> float:
    """Return the length beyond which more line only lies on the bed, m.

    At its breaking load a line of weight w hangs over s = sqrt(2 h MBL/w - h^2) of its length, as a
    catenary that leaves the bed horizontally, h the height that it spans, m. Of what is sold the
    longest counts; some 30 m may have to lie on the bed (UFC asks for a shot).
    """
    ratios = (
        each.MBL / each.submerged_weight
        for each in sold(choice, water_density)
        if each.MBL is not None and each.submerged_weight > 0.0
    )
    square = 2.0 * height * max(ratios, default=0.0) - height * height
    return math.sqrt(max(square, 0.0)) + _ON_THE_BED


def first_line(choice: LineChoice, water_density: float, length: float) -> Line:
    """Make a line to begin with: a case has to have one before the search has found any."""
    return Line([replace(sold(choice, water_density)[0], length=length)])
