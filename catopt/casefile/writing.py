"""From a Case to a case file."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from hashlib import sha256

from catopt.casefile.design_writing import design_sections
from catopt.casefile.toml_text import flag, measured, measures, text, texts, wear, whole
from catopt.errors import InputError, Problem
from catopt.model import (
    Anchor,
    Body,
    Buoy,
    Case,
    CatalogueChoice,
    CurrentProfile,
    Dynamics,
    Find,
    Load,
    LoadCase,
    Motion,
    PointLoad,
    Segment,
    Service,
    System,
    WaveState,
    WaveTrain,
)

__all__ = ["case_digest", "write_case"]


def case_digest(case: Case) -> str:
    """Return the SHA-256 of a case: of the very text that `write_case` gives it."""
    return sha256(write_case(case).encode()).hexdigest()


def write_case(case: Case) -> str:
    """Write a case as TOML, in SI with its units.

    Parameters
    ----------
    case : Case
        What to write.

    Returns
    -------
    str
        Text that `parse_case` reads back as an equal case, to the last digit. What has no value
        (an EA of an inextensible segment, an unknown mass) is left out; a segment of a component
        takes it from the catalogue again. Paths are absolute.
    """
    sections: list[tuple[str, Iterable[str]]] = [
        ("[site]", _site(case)),
        ("[line]", _ends(case)),
        *(("[[line.segments]]", _segment(segment)) for segment in case.line.segments),
        *(("[[line.point_loads]]", _point_load(load)) for load in case.line.point_loads),
        *((("[load]", _load(case.load)),) if case.load else ()),
        *(("[[load_cases]]", _load_case(state)) for state in case.load_cases),
        *((("[system]", _system(case, case.system)),) if case.system else ()),
        *((("[find]", _find(case.find)),) if case.find else ()),
        ("[checks]", _checks(case)),
        *((("[service]", _service(case.service)),) if case.service else ()),
        *((("[buoy]", _buoy(case.buoy)),) if case.buoy else ()),
        *((("[anchor]", _anchor(case.anchor)),) if case.anchor else ()),
        *_catalogue(case.catalogue),
        *(design_sections(case.design) if case.design else ()),
        *(_waves(case.waves) if case.waves else ()),
        *((("[current]", _current(case.current)),) if case.current else ()),
        *((("[motion]", _motion(case.motion)),) if case.motion else ()),
        *((("[anchor_motion]", _motion(case.anchor_motion)),) if case.anchor_motion else ()),
        *((("[body]", _body(case.body)),) if case.body else ()),
        *((("[dynamics]", _dynamics(case.dynamics)),) if case.dynamics else ()),
        ("[pso]", _swarm(case)),
    ]
    head = [*text("title", case.title), *text("source", case.source)]
    blocks = [head] if head else []
    blocks += [[opening, *lines] for opening, lines in sections]
    return "\n\n".join("\n".join(block) for block in blocks) + "\n"


def _site(case: Case) -> Iterator[str]:
    yield from measured("water_depth", case.site.water_depth, "m")
    yield from measured("seabed_friction", case.site.seabed_friction)
    yield from measured("water_density", case.site.water_density, "kg/m^3")
    if case.site.seabed_slope:
        yield from measured("seabed_slope", case.site.seabed_slope, "rad")


def _ends(case: Case) -> Iterator[str]:
    yield from measured("fairlead_height", case.fairlead_height, "m")
    yield from measured("anchor_height", case.anchor_height, "m")


def _segment(segment: Segment) -> Iterator[str]:
    # A component would give its own name to a segment without one.
    yield from text("name", segment.name, empty=bool(segment.component))
    yield from measured("length", segment.length, "m")
    yield from text("component", segment.component)
    yield from measured("diameter", segment.nominal_diameter, "m")
    yield from measured("submerged_weight", segment.submerged_weight, "N/m")
    yield from measured("mass", segment.mass, "kg/m")
    if math.isfinite(segment.EA):
        yield from measured("EA", segment.EA, "N")
    yield from measured("MBL", segment.MBL, "N")
    yield from measured("MBL_mean", segment.MBL_mean, "N")
    yield from measured("MBL_cov", segment.MBL_cov)
    yield from measured("proof_load", segment.proof_load, "N")
    yield from measured("price", segment.price, "USD/m")
    yield from wear("wear_rate", segment.wear_rate)
    yield from text("wear_zone", segment.wear_zone or "")
    yield from measured("drag_diameter", segment.drag_diameter, "m")
    for key in ("drag_normal", "drag_axial", "added_mass_normal", "added_mass_axial"):
        yield from measured(key, getattr(segment, key))
    if segment.drag_method != "given":
        yield from text("drag_method", segment.drag_method)
        yield from measured("roughness", segment.roughness, "m")
        yield from measured("keulegan_carpenter", segment.keulegan_carpenter)
        yield from measured("wake_amplification", segment.wake_amplification)


def _point_load(load: PointLoad) -> Iterator[str]:
    yield from text("name", load.name)
    yield from measured("position", load.position, "m")
    yield from measured("submerged_weight", load.submerged_weight, "N")
    yield from measured("mass", load.mass, "kg")
    yield from measured("friction", load.friction)
    yield from measured("drag_area", load.drag_area, "m^2")
    yield from measured("drag_coefficient", load.drag_coefficient)
    if load.added_mass_coefficient > 0.0:
        yield from measured("added_mass_coefficient", load.added_mass_coefficient)


def _load(load: Load) -> Iterator[str]:
    yield from measured("horizontal_force", load.horizontal_force, "N")
    yield from measured("span", load.span, "m")
    yield from measured("fairlead_tension", load.fairlead_tension, "N")


def _load_case(state: LoadCase) -> Iterator[str]:
    yield from text("name", state.name)
    yield from measured("horizontal_force", state.horizontal_force, "N")
    yield from measured("water_level", state.water_level, "m")
    yield from text("kind", state.kind)


def _system(case: Case, system: System) -> Iterator[str]:
    """Write a system of equal lines, each like the case's; InputError for any other."""
    first, *_ = system.legs
    around = System.around(
        case.line,
        azimuths=[leg.azimuth for leg in system.legs],
        anchor_radius=first.anchor_radius,
        fairlead_radius=first.fairlead_radius,
        fairlead_height=case.fairlead_height,
        anchor_height=case.anchor_height,
        seabed_friction=case.site.seabed_friction,
        force=system.force,
        moment=system.moment,
        yaw_free=system.yaw_free,
    )
    if around != system:
        allowed = "a case file holds equal lines, each like the case's own, around the body"
        raise InputError([Problem("system", "lines of their own", allowed)], "write_case")
    yield from measured("anchor_radius", first.anchor_radius, "m")
    yield from measured("fairlead_radius", first.fairlead_radius, "m")
    yield from measures("azimuths", [leg.azimuth for leg in system.legs], "rad")
    yield from measures("force", system.force, "N")
    yield from measured("moment", system.moment, "N*m")
    if system.yaw_free is not None:
        yield f"yaw_free = {'true' if system.yaw_free else 'false'}"


def _find(find: Find) -> Iterator[str]:
    yield from text("quantity", find.quantity)
    yield from whole("segment", find.segment)
    yield from whole("point_load", find.point_load)
    yield from measured("anchor_angle", find.anchor_angle, "rad")
    yield from measured("grounded_length", find.grounded_length, "m")


def _checks(case: Case) -> Iterator[str]:
    checks = case.checks
    yield from measured("safety_factor", checks.safety_factor)
    yield from measured("safety_factor_line_out", checks.safety_factor_line_out)
    yield from texts("codes", checks.codes)
    yield from measured("proof_load_factor", checks.proof_load_factor)
    yield from measured("max_anchor_uplift_angle", checks.max_anchor_uplift_angle, "rad")
    yield from measured("max_anchor_uplift_force", checks.max_anchor_uplift_force, "N")
    yield from measured("min_grounded_length", checks.min_grounded_length, "m")
    yield from measured("max_span", checks.max_span, "m")
    yield from measured("max_offset", checks.max_offset, "m")
    yield from flag("allow_recalled", checks.allow_recalled)


def _service(service: Service) -> Iterator[str]:
    yield from measured("life", service.life, "s")
    yield from wear("wear_rate", service.wear_rate or None)
    yield from text("wear_table", service.wear_table or "")


def _buoy(buoy: Buoy) -> Iterator[str]:
    yield from measured("reserve_buoyancy", buoy.reserve_buoyancy, "N")


def _anchor(anchor: Anchor) -> Iterator[str]:
    yield from text("kind", anchor.kind)
    yield from measured("submerged_weight", anchor.submerged_weight, "N")
    yield from measured("mass", anchor.mass, "kg")
    yield from measured("friction", anchor.friction)
    yield from measured("holding_capacity", anchor.holding_capacity, "N")
    yield from measured("safety_factor", anchor.safety_factor)
    yield from measured("safety_factor_line_out", anchor.safety_factor_line_out)
    yield from text("factor_source", anchor.factor_source)


def _catalogue(choice: CatalogueChoice) -> Iterator[tuple[str, Iterable[str]]]:
    own = [*text("file", choice.file), *flag("allow_recalled", choice.allow_recalled)]
    if own:
        yield "[catalogue]", own
    if choice.variants:
        lines = (line for quantity, name in choice.variants for line in text(quantity, name))
        yield "[catalogue.variants]", lines


def _waves(waves: WaveState) -> Iterator[tuple[str, Iterable[str]]]:
    train = () if waves.spectrum is None else _train(waves)
    yield "[waves]", [*train, *_sea(waves)]
    yield from (("[[waves.trains]]", _train(each)) for each in waves.trains)


def _train(train: WaveTrain | WaveState) -> Iterator[str]:
    yield from text("spectrum", train.spectrum or "")
    yield from measured("height", train.height, "m")
    yield from measured("period", train.period, "s")
    yield from measured("peak_enhancement", train.peak_enhancement)
    yield from measured("direction", train.direction, "rad")
    yield from whole("components", train.components)
    yield from measured("spreading_exponent", train.spreading_exponent)
    yield from whole("spreading_directions", train.spreading_directions)


def _sea(waves: WaveState) -> Iterator[str]:
    yield from text("stretching", waves.stretching)
    if not waves.elevation_file:
        yield from whole("seed", waves.seed)
        return
    yield from text("elevation_file", waves.elevation_file)
    yield from measured("elevation_x", waves.elevation_x, "m")
    yield from measured("shortest_period", waves.shortest_period, "s")
    yield from measured("direction", waves.direction, "rad")


def _current(current: CurrentProfile) -> Iterator[str]:
    yield from text("profile", current.profile)
    yield from measured("speed", current.speed, "m/s")
    yield from measured("exponent", current.exponent)
    yield from measured("depth", current.depth, "m")
    yield from measures("depths", current.depths, "m")
    yield from measures("speeds", current.speeds, "m/s")
    if current.directions:
        yield from measures("directions", current.directions, "rad")
    else:
        yield from measured("direction", current.direction, "rad")
    yield from text("series_file", current.series_file)


def _motion(motion: Motion) -> Iterator[str]:
    if motion.period is not None:
        yield from measured("period", motion.period, "s")
        for key in ("surge", "sway", "heave"):
            yield from measured(key, getattr(motion, key), "m")
        for key in ("surge_phase", "sway_phase", "heave_phase"):
            yield from measured(key, getattr(motion, key), "rad")
    yield from text("file", motion.file)
    yield from text("rao_file", motion.rao_file)
    yield from text("rao_phase", motion.rao_phase)
    yield from measures("rao_reference", motion.rao_reference, "m")
    yield from text("rao_rotation", motion.rao_rotation)
    yield from text("rao_per", motion.rao_per)
    yield from measures("drift", motion.drift, "m")
    yield from text("drift_file", motion.drift_file)


def _body(body: Body) -> Iterator[str]:
    yield from measured("mass", body.mass, "kg")
    yield from measured("added_mass", body.added_mass, "kg")
    yield from measured("damping", body.damping, "N*s/m")
    yield from text("force_file", body.force_file)
    yield from measures("wave_force", body.wave_force, "N/m")


def _dynamics(dynamics: Dynamics) -> Iterator[str]:
    for key in ("duration", "ramp", "time_step", "output_interval"):
        yield from measured(key, getattr(dynamics, key), "s")
    yield from whole("elements", dynamics.elements)
    yield from text("scheme", dynamics.scheme)
    yield from measured("spectral_radius", dynamics.spectral_radius)
    yield from whole("runs", dynamics.runs)
    yield from measured("seabed_stiffness", dynamics.seabed_stiffness, "N/m^2")
    yield from measured("seabed_damping", dynamics.seabed_damping, "N*s/m^2")
    yield from measured("line_damping", dynamics.line_damping)
    yield from measured("damping_time", dynamics.damping_time, "s")
    yield from whole("broken_line", dynamics.broken_line)
    yield from measured("broken_at", dynamics.broken_at, "s")
    if dynamics.broken_line is not None:
        yield from text("broken_end", dynamics.broken_end)
    yield from text("initial_friction", dynamics.initial_friction)
    yield from measured("duration_of_interest", dynamics.duration_of_interest, "s")


def _swarm(case: Case) -> Iterator[str]:
    swarm = case.swarm
    for key in ("particles", "iterations", "runs", "seed"):
        yield from whole(key, getattr(swarm, key))
    yield from measured("cognitive", swarm.cognitive)
    yield from measured("social", swarm.social)
    yield from measured("inertia", swarm.inertia)
    yield from text("boundary", swarm.boundary)
