"""What is sold of the components that a line may be made of."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache

from catopt.catalogue.choice import chosen
from catopt.catalogue.figure import within
from catopt.errors import InputError, Problem
from catopt.model import CatalogueChoice, Line, Segment
from catopt.sizing.line_choice import LineChoice

__all__ = ["catalogue_of", "first_line", "sold"]


def catalogue_of(choice: LineChoice) -> CatalogueChoice:
    """Say where the components come from."""
    return CatalogueChoice(allow_recalled=choice.allow_recalled)


@cache
def sold(choice: LineChoice, water_density: float) -> tuple[Segment, ...]:
    """List a metre of everything that is sold within the bounds, component by component.

    Parameters
    ----------
    choice : LineChoice
        Components and bounds.
    water_density : float
        kg/m3.

    Raises
    ------
    InputError
        There is no such component, or no size of any of them is sold within the bounds.
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


def first_line(choice: LineChoice, water_density: float, length: float) -> Line:
    """Make a line to begin with: a case has to have one before the search has found any.

    Parameters
    ----------
    choice : LineChoice
        Of which components.
    water_density : float
        kg/m3.
    length : float
        m.
    """
    return Line([replace(sold(choice, water_density)[0], length=length)])
