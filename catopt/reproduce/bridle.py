"""The bridle of MAP++'s documentation: three legs of steel that split into two of nylon each."""

from __future__ import annotations

import math
from typing import Final

from catopt.model import Line, Segment, Site
from catopt.model.network import LineBetween, Network, Point
from catopt.mooring.held import NetworkAtRest, hold
from catopt.reproduce.comparison import compare, study_of
from catopt.reproduce.items import Input, Study
from catopt.reproduce.published import Published, published
from catopt.reproduce.reference_moorings import linearised

NAME: Final = "bridle"

SURGE: Final = (5.0, 0.0, 0.0, 0.0, 0.0, 0.0)


def study() -> Study:
    """Bring the joints to rest with the body in place and 5 m ahead, and judge every number."""
    source = published(NAME)
    network = network_of(source)
    rest, ahead = hold(network), hold(network, SURGE)
    items = (
        *compare(source, "MAP++, in place", _in_place(rest)),
        *compare(source, "MAP++, 5 m ahead", _ahead(ahead)),
        *compare(source, "MAP++, linearised", linearised(rest.body)),
    )
    inputs = []
    for key, value in source.inputs.items():
        quantity, _, unit = key.rpartition("_in_")
        inputs.append(Input(quantity.replace("_", " "), f"{value:.9g}", unit))
    return study_of(source, inputs, items, ())


def _in_place(rest: NetworkAtRest) -> dict[str, float]:
    steel, nylon, _ = rest.lines[:3]
    return {"steel_span_m": steel.span, "nylon_fairlead_tension_N": nylon.fairlead.tension}


def _ahead(rest: NetworkAtRest) -> dict[str, float]:
    top = rest.lines[0].fairlead
    return {
        "steel_horizontal_force_N": top.horizontal_force,
        "steel_vertical_force_N": top.vertical_force,
    }


def network_of(source: Published) -> Network:
    """Put the three legs round the body, turned by 120 degrees."""
    given = source.inputs
    height = given["water_depth_in_m"] - given["fairlead_depth_in_m"]
    points: list[Point] = []
    lines: list[LineBetween] = []
    for leg in range(3):
        c, s = math.cos(leg * math.tau / 3.0), math.sin(leg * math.tau / 3.0)
        out, aside = given["fairlead_ahead_in_m"], given["fairlead_aside_in_m"]
        radius = given["anchor_radius_in_m"]
        anchor, joint = f"anchor {leg + 1}", f"joint {leg + 1}"
        points += [Point(anchor, "anchor", c * radius, s * radius, 0.0), Point(joint, "joint")]
        lines.append(LineBetween(_line(source, "steel"), anchor, joint, f"steel {leg + 1}"))
        for side, to in (("port", aside), ("starboard", -aside)):
            end = f"{side} {leg + 1}"
            points.append(Point(end, "fairlead", c * out - s * to, s * out + c * to, height))
            lines.append(LineBetween(_line(source, "nylon"), joint, end, f"nylon {end}"))
    site = Site(given["water_depth_in_m"], given["seabed_friction_in_"])
    return Network(site, tuple(points), tuple(lines))


def _line(source: Published, kind: str) -> Line:
    length, diameter, mass, EA = (
        source.inputs[f"{kind}_{key}"]
        for key in ("length_in_m", "volume_diameter_in_m", "mass_in_kg/m", "EA_in_N")
    )
    displaced = math.pi / 4.0 * diameter**2 * source.inputs["water_density_in_kg/m3"]
    return Line([Segment(length, (mass - displaced) * source.inputs["gravity_in_m/s2"], EA=EA)])
