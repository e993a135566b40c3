"""Series of OrcaFlex for chains whose fairlead heaves and for a cable: their extremes beside ours.

Chains: MoorDyn's tests, whose reference program is OrcaFlex. Cable: Low and Langley's, with the
series as read from the figures of FRyDoM's documentation.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cache
from typing import TYPE_CHECKING, Final, Literal, get_args

from catopt.reproduce.items import (
    KN,
    Input,
    Printed,
    Published,
    SideBySide,
    Study,
    compare,
    published,
    study_of,
)
from catopt.reproduce.reference_moorings import segment_of, solve_one_line
from catopt.words import Message

if TYPE_CHECKING:
    from catopt.fem import Fluid, History, LineProperties, Seabed
    from catopt.waves import Sea

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
        for depth, line in ((each, solve_one_line(chain_of(each, offset))) for each in depths)
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
