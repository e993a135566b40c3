"""What stands in a file for MoorDyn otherwise than in the case, and what does not stand there."""

from __future__ import annotations

from collections.abc import Iterator

from catopt.export.exported import significant
from catopt.export.exported_line import STEEL_DENSITY, ExportedLines
from catopt.export.moordyn_model import Model, is_above, resting
from catopt.model import Segment
from catopt.words import Message

MOORPY_REACH = 2.0
"""Height above the bed below which MoorPy 1.3 takes weight off a point, m."""

DRAG, ADDED_MASS = 1.2, 1.0
"""Of a smooth cylinder; stand in where a segment has no coefficients."""


def remarks_of(model: Model) -> Iterator[str]:
    """Say what stands in the file otherwise than in the case, and what does not."""
    yield from common_remarks(model)
    if any(line.at_rest is not None for line in model.solved.lines):
        yield (
            f"bed friction {model.solved.lines[0].solution.seabed_friction:g}: MoorDyn's friction "
            "acts on what moves and is none at rest, and MoorPy drops it. "
            "Compare with the closed form on a bed without friction; the fairleads stand where "
            "they do with friction."
        )
    if any(resting(model.parts)):
        yield (
            "a point load rests on the bed: a point of MoorDyn does not feel the bed, the line at "
            "its two sides carries it, for which kBot is made stiff enough to let it sink by 1 mm."
        )
    heights = (
        part.line.at(joint.arc)[2]
        for part in model.parts
        for joint in part.joints
        if joint.body.mass > 0.0 or joint.body.volume > 0.0
    )
    if any(height < MOORPY_REACH for height in heights):
        yield (
            "MoorPy lets the bed carry some of a point load that hangs less than 2 m above it: set "
            "zTol of its points to 0.001 before it solves."
        )
    depth, highest = model.solved.case.site.water_depth, model.solved.highest
    if not is_above(model.solved):
        return
    if model.surface > depth:
        yield (
            f"a line reaches {significant(highest - depth)} m above the water of the case, "
            f"{significant(depth)} m deep. The closed form lets all of it weigh what it weighs in "
            f"water; for MoorDyn to do so too the depth is put at {significant(model.surface)} m. "
            "With --true-depth it weighs there what it weighs in air."
        )
    else:
        yield (
            f"a line reaches {significant(highest - depth)} m above the water. MoorDyn lets that "
            "part weigh what it weighs in air, the closed form what it weighs in water, and so "
            "does MoorPy: the tensions differ by that."
        )


def common_remarks(model: Model) -> Iterator[str]:
    """Say what holds for any program that lets its lines stretch and takes mass and diameter."""
    yield from model.solved.warnings
    yield from _on_stiffness(model.solved)
    unknown = [each.name for each in model.types if not each.body.is_known]
    if unknown:
        yield (
            f"mass in air not known of {', '.join(unknown)}: that of steel ({STEEL_DENSITY:g} "
            "kg/m3) with the submerged weight of the case stands in. At rest it changes nothing."
        )
    if any(not joint.body.is_known for part in model.parts for joint in part.joints):
        yield (
            "mass in air not known of a point load: a weight without volume, or a volume without "
            "mass, with its submerged weight stands in. At rest it changes nothing."
        )
    bare = [each.name for each in model.types if not has_drag(each.segment)]
    if bare:
        yield (
            f"drag and added mass not known of {', '.join(bare)}: Cd {DRAG:g} across, 0 along, Ca "
            f"{ADDED_MASS:g} across, 0 along stand in. At rest they change nothing; give your own "
            "before a run in waves."
        )
    yield from _on_the_rest(model.solved)
    own = {
        f"{load.friction:g}"
        for line in model.solved.lines
        for load in line.solution.line.point_loads
        if load.friction is not None
    }
    if own:
        yield Message("export.load_friction", values=", ".join(sorted(own)))


def _on_stiffness(solved: ExportedLines) -> Iterator[str]:
    if solved.EA is None:
        return
    changes = [line.solution.fairlead.tension / line.own_tension - 1.0 for line in solved.lines]
    largest = max(changes, key=abs)
    yield (
        f"EA {significant(solved.EA)} N is not of the case, in which the line does not stretch: it "
        "was given for this file, and the closed form here is that of the line that has it. It "
        f"changes the fairlead tension by {100.0 * largest:.2g} %."
    )


def has_drag(segment: Segment) -> bool:
    """Whether the coefficients of a segment are known, with the diameter that they refer to."""
    return segment.drag_normal is not None and segment.drag_diameter is not None


def _on_the_rest(solved: ExportedLines) -> Iterator[str]:
    if solved.system is not None:
        yield (
            "the body is not in the file: each fairlead is held where it is under the load, and "
            "the forces of all lines together balance that load."
        )
    left = [key for key in ("waves", "current", "motion") if getattr(solved.case, key) is not None]
    if left:
        yield f"not in the file: {', '.join(left)} of the case. It is the line at rest."
