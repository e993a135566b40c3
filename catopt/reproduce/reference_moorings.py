"""Moorings that everybody computes, at rest, and series of OrcaFlex: extremes beside ours.

At rest: floating turbines, other programs' lines, and a bridle. In motion: chains whose fairlead
heaves, of MoorDyn's tests, whose reference program is OrcaFlex; Low and Langley's cable, with the
series as read from the figures of FRyDoM's documentation.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cache
from operator import attrgetter
from typing import TYPE_CHECKING, Final, Literal, get_args

from catopt.model import Line, Segment, Site, System
from catopt.model.network import LineBetween, Network, Point
from catopt.reproduce.items import (
    KN,
    Drawn,
    Input,
    Item,
    Printed,
    Published,
    SideBySide,
    Study,
    compare,
    published,
    study_of,
)
from catopt.words import Message

if TYPE_CHECKING:
    from catopt.catenary.solution import Solution
    from catopt.fem import Fluid, History, LineProperties, Seabed
    from catopt.mooring.network_rest import HeldBody
    from catopt.waves import Sea


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
    from catopt.mooring.fixed_body import at_displacement

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
    plus, minus = (_held(source, moved).load[load] for moved in way)
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
        tensions = ", ".join(f"{solution.fairlead.tension / 1e3:.1f}" for solution in lines)
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
    from catopt.mooring.fixed_body import hold

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


CHAIN: Final = "chain_in_waves"
CABLE: Final = "cable_in_waves"

Depth = Literal[50, 600]
Heave = Literal[2, 5]
CableCase = Literal["surge", "heave", "waves_along", "waves_at_45_deg"]

BARS: Final = {CHAIN: 80, CABLE: 68}
STEP: Final = 0.05
"""s."""
RAMP_TIME: Final = 15.0
DURATION: Final = 50.0
"""s: of a chain's heave as it begins, and of its run; two periods of it are settled."""
SETTLED: Final = {CHAIN: 30.0, CABLE: 40.0}
"""s from the start of a run, after which extremes are taken."""
_SINE: Final = -0.5 * math.pi
_HEAVES: Final[tuple[tuple[Depth, Heave], ...]] = ((50, 2), (50, 5), (600, 2), (600, 5))


def _ours(name: str) -> tuple[Input, ...]:
    bars = Input("bars", f"{BARS[name]}", "", "ours")
    return bars, Input("time step", f"{STEP:g}", "s", "ours")


# ------------------------------------------------------------------ chains


def chain_study() -> Study:
    """Recompute the chains at rest and in heave."""
    source = published(CHAIN)
    at_rest, in_heave = source.printed
    lifted, on_bed = _end_tensions(contact_offset()), _end_tensions(0.0)
    said = {key: Message("reproduce.without_offset", tension=on_bed[key]) for key in on_bed}
    rows = _in_heave(source, in_heave)
    computed, remarks = {r.key: r.catopt for r in rows}, {r.key: r.remark for r in rows}
    items = [
        *compare(source, at_rest, lifted, said),
        *compare(source, in_heave, computed, remarks, "truss"),
    ]
    findings, beside = _about_the_chains(rows), _beside_moordyn(rows)
    return study_of(source, items, findings, _ours(CHAIN), side_by_side=(beside,))


def contact_offset() -> float:
    """By how much a chain's centre line lies above the bed, m: its contact radius less the sinking.

    It sinks in by w / (k D), where the bed of k over the contact diameter D carries its weight w.
    """
    given = published(CHAIN).inputs
    D, k = given["contact_diameter_m"], given["bed_stiffness_kN_per_m3"] * KN
    return 0.5 * D - segment_of(chain_of(50)).submerged_weight / (k * D)


def chain_of(depth: Depth, offset: float = 0.0) -> Published:
    """Take the chain in one depth as one line between its ends, on a bed higher by an offset, m.

    At rest there is no friction yet, as there.
    """
    source = published(CHAIN)
    at = source.series["water_depth_m"].index(depth)
    of_depth = {key: source.series[key][at] for key in ("span_m", "line_length_m")}
    ends = {"fairlead_height_m": depth - offset, "anchor_height_m": 0.0, "seabed_friction": 0.0}
    return replace(source, inputs=source.inputs | of_depth | ends)


def _end_tensions(offset: float) -> dict[str, float]:
    """Tensions of the chains at rest in closed form, kN, by the quantities of the print."""
    depths: tuple[Depth, ...] = get_args(Depth)
    return {
        f"{end}_tension_{depth}m_kN": getattr(line, end).tension / KN
        for depth, line in (
            (water_depth, solve_one_line(chain_of(water_depth, offset))) for water_depth in depths
        )
        for end in ("fairlead", "anchor")
    }


@cache
def run_chain(depth: Depth, heave: Heave, step: float = STEP) -> History:
    """Run a chain with its fairlead in heave (amplitude, m) for 50 s; friction begins from none.

    The bed is a spring, under a contact radius above the bed: so the chain sinks in as it does
    in OrcaFlex. MoorDyn's axial coefficient goes with pi D, its damping is critical for each bar.
    """
    from catopt.fem import Fluid, Harmonic, Seabed, TimeStepping, run_dynamics
    from catopt.model import Line

    given = published(CHAIN).inputs
    D = given["contact_diameter_m"]
    source = chain_of(depth, 0.5 * D)
    bed = Seabed(
        given["bed_stiffness_kN_per_m3"] * KN * D,
        friction=given["friction_in_motion"],
        initial_friction="none",
    )
    return run_dynamics(
        Line([segment_of(source)]),
        TimeStepping(DURATION, step, ramp_time=RAMP_TIME, since=SETTLED[CHAIN]),
        height=source.inputs["fairlead_height_m"],
        span=source.inputs["span_m"],
        motion=Harmonic(given["heave_period_s"], (0.0, 0.0, heave), (0.0, 0.0, _SINE)),
        properties=_properties(source, given, Fluid(given["water_density_kg_per_m3"]), bed),
        elements=BARS[CHAIN],
    )


def _properties(
    line: Published, given: dict[str, float], water: Fluid, bed: Seabed
) -> LineProperties:
    from catopt.fem import LineDamping, LineProperties, MorisonSection

    section = MorisonSection(
        line.inputs["volume_diameter_m"],
        given["drag_coefficient"],
        math.pi * given["axial_drag_on_pi_D"],
        given["added_mass_coefficient"],
        0.0,
    )
    damping = LineDamping(critical_ratio=given["damping_ratio"], critical_length="bar")
    return LineProperties([section], damping, water, bed)


def extremes(history: History) -> tuple[float, float]:
    """Largest and smallest tension at the upper end once the motion has settled, kN."""
    found = history.tension_statistics()
    return found.maximum / KN, found.minimum / KN


@dataclass(frozen=True)
class _InHeave:
    """One extreme of a chain in heave by three programs, kN; `key`: of the print."""

    key: str
    which: str
    depth: Depth
    heave: Heave
    orcaflex: Printed
    moordyn: float
    catopt: float

    def off(self, tension: float) -> float:
        """By how much a tension is off the print, %."""
        return 100.0 * (tension / self.orcaflex.value - 1.0)

    @property
    def is_nearer(self) -> bool:
        """Whether catopt's is nearer to the print than MoorDyn's."""
        return abs(self.off(self.catopt)) < abs(self.off(self.moordyn))

    @property
    def remark(self) -> Message:
        key = "moordyn_further" if self.is_nearer else "moordyn_nearer"
        return Message(f"reproduce.{key}", tension=self.moordyn, share=self.off(self.moordyn))


def _in_heave(source: Published, method: str) -> tuple[_InHeave, ...]:
    found: list[_InHeave] = []
    for at, (depth, heave) in enumerate(_HEAVES):
        for which, ours in zip(("max", "min"), extremes(run_chain(depth, heave)), strict=True):
            key, peer = f"{which}_{depth}m_heave_{heave}m_kN", source.series[f"moordyn_{which}_kN"]
            print_ = source.printed[method][key]
            found.append(_InHeave(key, which, depth, heave, print_, peer[at], ours))
    return tuple(found)


def _about_the_chains(rows: Sequence[_InHeave]) -> tuple[str, ...]:
    largest = [row for row in rows if row.which == "max"]
    return (
        Message("reproduce.chain_offset", offset=contact_offset()),
        Message(
            "reproduce.chain_largest",
            worst=max(abs(row.off(row.catopt)) for row in largest),
            nearer=sum(row.is_nearer for row in largest),
            count=len(largest),
        ),
        Message("reproduce.chain_smallest"),
    )


def _beside_moordyn(rows: Sequence[_InHeave]) -> SideBySide:
    return SideBySide(
        Message("reproduce.heave_by_three"),
        ("largest and smallest", "OrcaFlex", "MoorDyn-C", "catopt"),
        tuple(
            (
                Message(f"reproduce.heave_{row.which}", depth=row.depth, heave=row.heave),
                row.orcaflex.text,
                f"{row.moordyn:.1f}",
                f"{row.catopt:.1f}",
            )
            for row in rows
        ),
    )


# ------------------------------------------------------------------ a cable


def cable_study() -> Study:
    """Recompute the cable whose upper end is led, and the one in waves."""
    source = published(CABLE)
    (method,) = source.printed
    computed = {
        f"{which}_{case}_kN": value
        for case in get_args(CableCase)
        for which, value in zip(("max", "min"), extremes(run_cable(case)), strict=True)
    }
    items = compare(source, method, computed, computed_by="truss")
    return study_of(source, items, (Message("reproduce.cable_read"),), _ours(CABLE))


def cable_sea(case: CableCase) -> Sea:
    """Water of the cable's depth, with waves over it or without."""
    from catopt.waves import Sea, regular_wave

    given, depth = published(CABLE).inputs, published("hanging_cable").inputs["water_depth_m"]
    if case in ("surge", "heave"):
        return Sea(depth)
    direction = math.radians(0.0 if case == "waves_along" else 45.0)
    height, period = 2.0 * given["wave_amplitude_m"], given["wave_period_s"]
    return Sea(depth, regular_wave(height, period, direction=direction), ramp_time=20.0)


@cache
def run_cable(case: CableCase) -> History:
    """Run the cable between its two ends, without bending.

    In heave the upper end comes out of the water, where it loses its lift: the surface counts. In
    waves water ends at the still surface, and the crest is over the lower end at t = 0.
    """
    from catopt.fem import Fluid, Harmonic, Seabed, TimeStepping, run_dynamics
    from catopt.model import Line

    given, source = published(CABLE).inputs, published("hanging_cable")
    line = source.inputs
    amplitude = given["motion_amplitude_m"]
    along = {"surge": (amplitude, 0.0, 0.0), "heave": (0.0, 0.0, amplitude)}
    motion = None
    if case in along:
        motion = Harmonic(given["motion_period_s"], along[case], (_SINE, 0.0, _SINE))
    water = Fluid(line["water_density_kg_per_m3"], line["gravity_m_per_s2"])
    duration, ramp = (90.0, 20.0) if motion is None else (80.0, given["motion_period_s"])
    return run_dynamics(
        Line([segment_of(source)]),
        TimeStepping(duration, STEP, ramp_time=ramp, since=SETTLED[CABLE]),
        height=line["fairlead_height_m"],
        anchor_height=line["anchor_height_m"],
        span=line["span_m"],
        motion=motion,
        properties=_properties(source, given, water, Seabed()),
        sea=cable_sea(case),
        elements=BARS[CABLE],
    )
