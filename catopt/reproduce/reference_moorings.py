"""Moorings that everybody computes: floating turbines, other programs' lines, and a bridle."""

from __future__ import annotations

import math
from dataclasses import replace
from operator import attrgetter
from typing import TYPE_CHECKING, Final

from catopt.model import Line, Segment, Site, System
from catopt.model.network import LineBetween, Network, Point
from catopt.reproduce.items import Drawn, Item, Published, Study, compare, published, study_of
from catopt.words import Message

if TYPE_CHECKING:
    from catopt.catenary.solution import Solution
    from catopt.mooring.network_rest import HeldBody

SURGE: Final = (5.0, 0.0, 0.0, 0.0, 0.0, 0.0)
"""m: by how much the body of the bridle goes ahead."""

_TURN: Final = 0.03
"""rad: the step of the differences that explain OC3's matrix."""

NAMES: Final = ("oc3", "oc4", "volturnus", "steep_chain", "hanging_cable", "moordyn_line")

_UNIT = {"kN": 1e3, "N": 1.0, "m": 1.0, "deg": math.radians(1.0)}
_ONE_LINE: Final = {
    "horizontal_force": attrgetter("fairlead.horizontal_force"),
    "vertical_force": attrgetter("fairlead.vertical_force"),
    "fairlead_tension": attrgetter("fairlead.tension"),
    "fairlead_angle": attrgetter("fairlead.angle"),
    "anchor_horizontal_force": attrgetter("anchor.horizontal_force"),
    "anchor_vertical_force": attrgetter("anchor.vertical_force"),
    "grounded_length": attrgetter("grounded_length"),
}
"""What is printed of one line, in SI."""


def study(name: str) -> Study:
    """Recompute one of them in closed form and judge every printed number."""
    source = published(name)
    line = solve_one_line(source)
    items: list[Item] = []
    for method, printed in source.printed.items():
        if method.endswith("linearised"):
            body = _held(source)
            computed = linearised(body)
            swapped = Message("reproduce.digits_swapped", single=-body.load[2] / 3e3)
            remarks: dict[str, str] = {"vertical_load_kN": swapped} if name == "oc4" else {}
        else:
            computed = {}
            for quantity in printed:
                figure, _, unit = quantity.rpartition("_")
                computed[quantity] = _ONE_LINE[figure](line) / _UNIT[unit]
            remarks = _remarks(source, method)
        items += compare(source, method, computed, remarks)
    return study_of(
        source,
        items,
        _findings(source),
        drawn=(Drawn(source.title, line, source.inputs.get("water_depth_m", 0.0)),),
    )


def segment_of(source: Published) -> Segment:
    """Return the line, its weight in water from mass and volume."""
    given = source.inputs
    mass = given["mass_kg_per_m"]
    displaced = _displaced(given["volume_diameter_m"], given["water_density_kg_per_m3"])
    weight = (mass - displaced) * given["gravity_m_per_s2"]
    return Segment(given["line_length_m"], weight, EA=given["EA_N"], mass=mass)


def _displaced(diameter: float, water_density: float) -> float:
    """Mass of the water that a line displaces, kg/m."""
    return math.pi / 4.0 * diameter**2 * water_density


def solve_one_line(source: Published, anchor_radius: float | None = None) -> Solution:
    """Solve one line between its ends, as the inputs of a source have them."""
    from catopt.catenary.solve import solve

    given = source.inputs
    if "span_m" in given:
        height, anchor, span = given["fairlead_height_m"], given["anchor_height_m"], given["span_m"]
    else:
        height, anchor = given["water_depth_m"] - given["fairlead_depth_m"], 0.0
        radius = given["anchor_radius_m"] if anchor_radius is None else anchor_radius
        span = radius - given["fairlead_radius_m"]
        if "span_east_m" in given:
            span = math.hypot(given["span_east_m"], given["span_north_m"])
    return solve(
        Line([segment_of(source)]),
        height=height,
        anchor_height=anchor,
        span=span,
        seabed_friction=given["seabed_friction"],
    )


def _held(source: Published, displacement: tuple[float, ...] = (0.0,) * 6) -> HeldBody:
    """Hold a body on three such lines; on a bed without friction, as linearised matrices are."""
    from catopt.mooring.held import at_displacement

    given = source.inputs
    depth, first = given["water_depth_m"], math.radians(given["first_azimuth_deg"])
    system = System.around(
        Line([segment_of(source)]),
        azimuths=[first + 2.0 * math.pi / 3.0 * k for k in range(3)],
        anchor_radius=given["anchor_radius_m"],
        fairlead_radius=given["fairlead_radius_m"],
        fairlead_height=depth - given["fairlead_depth_m"],
    )
    return at_displacement(system, origin_height=depth, displacement=displacement)


def _slope(source: Published, load: int, freedom: int, step: float) -> float:
    """Take minus the central difference of a load over a step of a freedom."""
    way = [(0.0,) * freedom + (sign * step,) + (0.0,) * (5 - freedom) for sign in (1.0, -1.0)]
    plus, minus = (_held(source, each).load[load] for each in way)
    return (minus - plus) / (2.0 * step)


def linearised(body: HeldBody) -> dict[str, float]:
    """Name load and stiffness of all lines about the waterline as they are printed."""
    K = body.stiffness
    return {
        "vertical_load_kN": body.load[2] / 1e3,
        "surge_stiffness_kN/m": K[0][0] / 1e3,
        "heave_stiffness_kN/m": K[2][2] / 1e3,
        "roll_stiffness_MN*m/rad": K[3][3] / 1e6,
        "yaw_stiffness_MN*m/rad": K[5][5] / 1e6,
        "surge_by_pitch_MN/rad": K[0][4] / 1e6,
        "pitch_by_surge_MN": K[4][0] / 1e6,
    }


def _remarks(source: Published, method: str) -> dict[str, str]:
    if source.name == "oc3":
        printed, weight = source.printed[method], segment_of(source).submerged_weight
        friction = source.inputs["seabed_friction"] * weight * printed["grounded_length_m"].value
        left = printed["horizontal_force_N"].value - friction
        return {"anchor_horizontal_force_N": Message("reproduce.less_friction", left=left)}
    if method.startswith("OrcaFlex"):
        said: str = Message("reproduce.has_bending_stiffness")
        return dict.fromkeys(source.printed[method], said)
    if source.name == "moordyn_line":
        return dict.fromkeys(source.printed[method], Message("reproduce.settled_in_time"))
    return {}


def _findings(source: Published) -> tuple[str, ...]:
    """Say what explains the numbers that differ."""
    if source.name == "oc3":
        matrix = Message(
            "reproduce.oc3_matrix",
            surge_by_pitch=_slope(source, 0, 4, _TURN) / 1e6,
            roll=_slope(source, 3, 3, _TURN) / 1e6,
            pitch_by_surge=_slope(source, 4, 0, 1.0) / 1e6,
        )
        return (matrix, Message("reproduce.oc3_yaw_spring"))
    if source.name == "oc4":
        return (Message("reproduce.oc4_span", more=_by_half_a_millimetre(source)),)
    if source.name == "volturnus":
        lines = [solve_one_line(source, radius) for radius in source.series["anchor_radius_m"]]
        tensions = ", ".join(f"{each.fairlead.tension / 1e3:.1f}" for each in lines)
        return (Message("reproduce.three_radii", tensions=tensions),)
    return ()


def _by_half_a_millimetre(source: Published) -> float:
    """By how much H differs over half a millimetre of either part of the span, N."""
    given = source.inputs
    wider = {key: given[key] + 5e-4 for key in ("span_east_m", "span_north_m")}
    more = solve_one_line(replace(source, inputs={**given, **wider}))
    return more.horizontal_force - solve_one_line(source).horizontal_force


# ------------------------------------------------------------------ a bridle


def bridle() -> Study:
    """Bring the joints to rest with the body in place and 5 m ahead, and judge every number.

    MAP++'s documentation has three legs of steel that split into two of nylon each.
    """
    from catopt.mooring.held import hold

    source = published("bridle")
    network = network_of(source)
    rest, ahead = hold(network), hold(network, SURGE)
    steel, nylon, _ = rest.lines[:3]
    top = ahead.lines[0].fairlead
    by_method = {
        "MAP++, in place": {
            "steel_span_m": steel.span,
            "nylon_fairlead_tension_N": nylon.fairlead.tension,
        },
        "MAP++, 5 m ahead": {
            "steel_horizontal_force_N": top.horizontal_force,
            "steel_vertical_force_N": top.vertical_force,
        },
        "MAP++, linearised": linearised(rest.body),
    }
    return study_of(
        source,
        [
            item
            for method, computed in by_method.items()
            for item in compare(source, method, computed)
        ],
    )


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
    """Return a line of the bridle.

    `kind`: ``"steel"`` or ``"nylon"``.
    """
    given = source.inputs
    length, diameter, mass, EA = (
        given[f"{kind}_{key}"]
        for key in ("length_in_m", "volume_diameter_in_m", "mass_in_kg/m", "EA_in_N")
    )
    displaced = _displaced(diameter, given["water_density_in_kg/m3"])
    return Line([Segment(length, (mass - displaced) * given["gravity_in_m/s2"], EA=EA)])
