"""Coefficients of drag and added mass for a line in motion, from the catalogue."""

from __future__ import annotations

from dataclasses import fields, replace
from typing import TYPE_CHECKING, Any

from catopt.model import Case, Segment

if TYPE_CHECKING:
    from catopt.catalogue import Component

__all__ = ["hydrodynamic", "segment_in_motion"]

_KEYS = ("drag_diameter", "drag_normal", "drag_axial", "added_mass_normal", "added_mass_axial")


def hydrodynamic(component: Component) -> dict[str, Any]:
    """List what a segment has for its motion, each coefficient on the one diameter of the model.

    Both of drag on the diameter of the normal one; both of added mass on the displaced water.

    Parameters
    ----------
    component : Component
        Of the catalogue; its coefficients have diameters of their own.
    """
    drag, along = component.drag_normal, component.drag_axial
    across, axial = component.added_mass_normal, component.added_mass_axial
    displacing = component.volume_diameter
    on_drag = None
    if drag is not None and along is not None:
        on_drag = along.coefficient * (along.diameter / drag.diameter)
    return {
        "drag_diameter": None if drag is None else drag.diameter,
        "drag_normal": None if drag is None else drag.coefficient,
        "drag_axial": on_drag,
        **{
            key: None if each is None else each.coefficient * (each.diameter / displacing) ** 2
            for key, each in (("added_mass_normal", across), ("added_mass_axial", axial))
        },
    }


def segment_in_motion(segment: Segment, case: Case) -> Segment:
    """Give a segment of a design its drag and added mass, if the case is for a line in motion.

    Parameters
    ----------
    segment : Segment
        Of a component, or one that the line of the case has too.
    case : Case
        Of the search.
    """
    if case.dynamics is None:
        return segment
    if segment.component and segment.nominal_diameter is not None:
        from catopt.catalogue.choice import chosen

        families = chosen(case.catalogue, case.site.water_density)
        component = families.component(segment.component, segment.nominal_diameter)
        return replace(segment, **hydrodynamic(component))
    kept = {field.name for field in fields(Segment)} - {"length", *_KEYS}
    for own in case.line.segments:
        if all(getattr(own, key) == getattr(segment, key) for key in kept):
            return replace(segment, **{key: getattr(own, key) for key in _KEYS})
    return segment
