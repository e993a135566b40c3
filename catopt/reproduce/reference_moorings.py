"""Moorings that everybody computes: three floating turbines, and lines of other programs."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING, Final

from catopt.model import Line, Segment, System
from catopt.reproduce.comparison import compare, study_of
from catopt.reproduce.items import Drawn, Input, Item, Study
from catopt.reproduce.published import Published, published
from catopt.words import Message

if TYPE_CHECKING:
    from catopt.catenary.solution import Solution
    from catopt.mooring.held import HeldBody

_TURN: Final = 0.03
"""rad: the step of the differences that explain OC3's matrix."""

NAMES: Final = ("oc3", "oc4", "volturnus", "steep_chain", "hanging_cable", "moordyn_line")

_UNIT = {"kN": 1e3, "N": 1.0, "m": 1.0, "deg": math.radians(1.0)}
_ONE_LINE: dict[str, Callable[[Solution], float]] = {
    "horizontal_force": lambda line: line.fairlead.horizontal_force,
    "vertical_force": lambda line: line.fairlead.vertical_force,
    "fairlead_tension": lambda line: line.fairlead.tension,
    "fairlead_angle": lambda line: line.fairlead.angle,
    "anchor_horizontal_force": lambda line: line.anchor.horizontal_force,
    "anchor_vertical_force": lambda line: line.anchor.vertical_force,
    "grounded_length": lambda line: line.grounded_length,
}
"""What is printed of one line, in SI."""


_INPUTS = {
    "gravity_m_per_s2": ("gravity", "m/s2"),
    "water_density_kg_per_m3": ("water density", "kg/m3"),
    "water_depth_m": ("water depth", "m"),
    "span_m": ("span", "m"),
    "fairlead_height_m": ("fairlead height", "m"),
    "anchor_height_m": ("anchor height", "m"),
    "line_length_m": ("line length", "m"),
    "mass_kg_per_m": ("mass in air", "kg/m"),
    "volume_diameter_m": ("volume-equivalent diameter", "m"),
    "EA_N": ("axial stiffness", "N"),
    "anchor_radius_m": ("anchor radius", "m"),
    "fairlead_radius_m": ("fairlead radius", "m"),
    "fairlead_depth_m": ("fairlead depth", "m"),
    "first_azimuth_deg": ("azimuth of the first of three lines", "deg"),
    "seabed_friction": ("seabed friction, of the one line", ""),
    "span_east_m": ("span of the one line, along x", "m"),
    "span_north_m": ("span of the one line, along y", "m"),
    "contact_diameter_m": ("contact diameter", "m"),
    "damping_ratio": ("axial damping of a bar, of critical", ""),
    "drag_coefficient": ("drag coefficient CD", ""),
    "axial_drag_on_pi_D": ("axial drag coefficient, on pi D", ""),
    "added_mass_coefficient": ("added mass coefficient", ""),
    "bed_stiffness_kN_per_m3": ("stiffness of the bed", "kN/m3"),
    "friction_in_motion": ("seabed friction", ""),
    "heave_period_s": ("period of the motion", "s"),
    "motion_period_s": ("period of the motion", "s"),
    "motion_amplitude_m": ("amplitude of the motion", "m"),
    "wave_amplitude_m": ("wave amplitude", "m"),
    "wave_period_s": ("wave period", "s"),
}
"""How inputs are called, and their units."""


def study(name: str) -> Study:
    """Recompute one of them in closed form and judge every printed number."""
    source = published(name)
    line = solve_one_line(source)
    items: list[Item] = []
    for method, printed in source.printed.items():
        if method.endswith("linearised"):
            items += _linearised(source, method)
        else:
            computed = {quantity: _of_line(line, quantity) for quantity in printed}
            items += compare(source, method, computed, _remarks(source, method))
    return study_of(
        source,
        inputs=inputs_of(source),
        items=items,
        findings=_findings(source),
        drawn=(Drawn(source.title, line, source.inputs.get("water_depth_m", 0.0)),),
    )


def inputs_of(source: Published) -> tuple[Input, ...]:
    """Say what went in, of the numbers that do not vary."""
    return tuple(input_of(key, f"{value:.9g}") for key, value in source.inputs.items())


def input_of(key: str, value: str) -> Input:
    """Say what one key of a source's inputs is, with its unit."""
    name, unit = _INPUTS[key]
    return Input(name, value, unit)


def segment_of(source: Published) -> Segment:
    """Return the line, its weight in water from mass and volume."""
    given = source.inputs
    displaced = math.pi / 4.0 * given["volume_diameter_m"] ** 2 * given["water_density_kg_per_m3"]
    mass = given["mass_kg_per_m"]
    weight = (mass - displaced) * given["gravity_m_per_s2"]
    return Segment(given["line_length_m"], weight, EA=given["EA_N"], mass=mass)


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


def _of_line(line: Solution, quantity: str) -> float:
    name, _, unit = quantity.rpartition("_")
    return _ONE_LINE[name](line) / _UNIT[unit]


def _system(source: Published) -> System:
    """Put three such lines round a body; on a bed without friction, as linearised matrices are."""
    given = source.inputs
    first = math.radians(given["first_azimuth_deg"])
    return System.around(
        Line([segment_of(source)]),
        azimuths=[first + 2.0 * math.pi / 3.0 * k for k in range(3)],
        anchor_radius=given["anchor_radius_m"],
        fairlead_radius=given["fairlead_radius_m"],
        fairlead_height=given["water_depth_m"] - given["fairlead_depth_m"],
    )


def _held(source: Published, displacement: tuple[float, ...] = (0.0,) * 6) -> HeldBody:
    from catopt.mooring.held import held_body

    depth = source.inputs["water_depth_m"]
    return held_body(_system(source), origin_height=depth, displacement=displacement)


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


def _linearised(source: Published, method: str) -> tuple[Item, ...]:
    """Judge load and stiffness of all lines about the waterline."""
    body = _held(source)
    remarks: dict[str, str] = {}
    if source.name == "oc4":
        single = -body.load[2] / 3e3
        remarks["vertical_load_kN"] = Message("reproduce.digits_swapped", single=single)
    return compare(source, method, linearised(body), remarks)


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
        tensions = [
            solve_one_line(source, radius).fairlead.tension / 1e3
            for radius in source.series["anchor_radius_m"]
        ]
        return (
            Message(
                "reproduce.three_radii", tensions=", ".join(f"{each:.1f}" for each in tensions)
            ),
        )
    return ()


def _by_half_a_millimetre(source: Published) -> float:
    """By how much H differs over half a millimetre of either part of the span, N."""
    given = source.inputs
    wider = {key: given[key] + 5e-4 for key in ("span_east_m", "span_north_m")}
    more = solve_one_line(replace(source, inputs={**given, **wider}))
    return more.horizontal_force - solve_one_line(source).horizontal_force
