"""The sinkers that a design may be held by; the lightest that holds is taken."""

from __future__ import annotations

from dataclasses import replace

from catopt.model import Anchor, Case, SinkerChoice
from catopt.model.immersion import weight_in_water


def sinker(choice: SinkerChoice, index: int, water_density: float) -> Anchor:
    """Make one of the sinkers."""
    mass = choice.masses[index]
    return Anchor(
        kind="sinker",
        submerged_weight=weight_in_water(mass, choice.density, water_density),
        friction=choice.friction,
        safety_factor=choice.safety_factor,
        factor_source=choice.factor_source,
        mass=mass,
    )


def with_a_sinker(case: Case) -> Case:
    """Put the lightest sinker of a case's design in place of its anchor, if there are any.

    All of them have the same factors, which is all that the criteria want of an anchor.
    """
    if case.design is None or case.design.sinker is None:
        return case
    return replace(case, anchor=sinker(case.design.sinker, 0, case.site.water_density))
