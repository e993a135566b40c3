"""A campaign over networks: each answer and each refusal of `at_rest` is checked.

    python -m tests.campaign --lines 0 --networks 10000 --afloat 2000

An answer is checked at its own places: those of fairleads by own geometry, the ends of each line by
`solve(span=)`, and their sums at every joint and every body. A refusal for friction is right where
what is refused, which is checked as an answer is, has a joint or a line without an anchor there;
one of a float is right where it comes to rest above the surface in deeper water. All else that is
refused is wrong.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Any

import pytest

from catopt import Line, solve
from catopt.catenary.layout import highest_afloat
from catopt.constants import STANDARD_GRAVITY
from catopt.errors import CatoptError, FloatsUpError, NoEquilibriumError, NotConvergedError
from catopt.model import Site
from catopt.model.network import Network, Point
from catopt.mooring.chains import rows_of
from catopt.mooring.fixed_body import at_rest
from catopt.mooring.joints import Vector, reversed_line
from catopt.mooring.network_rest import BodyAtRest, LinesAtRest
from tests.campaign.networks import counted, drawn, drawn_afloat

BALANCE = 1e-8
"""Part of the largest tension that may be left: ten times what the solver itself lets stand."""

LAST_DIGITS = 1e-14
"""Part of the longest line that the last digits of a place are worth."""

NEAREST = 1e-9
"""Part of a line's length by which its ends are apart in plan at least."""


def faults_of_answer(found: LinesAtRest) -> list[str]:
    """Say what is wrong with an answer; empty when nothing is."""
    network, kept = found.network, found.joints
    places = dict(zip((p.name for p in network.points), kept.places, strict=True))
    left, strongest = _left(found, places)
    lines = network.lines
    longest = max(line.line.length for line in lines)
    stiffest = max(_stiffness(line.line) for line in lines)
    limit = BALANCE * strongest + LAST_DIGITS * longest * stiffest
    limit += max(_given_way(line.line, network.site, strongest) for line in lines) * longest**0.5
    faults = [*_faults_of_places(found, places)]
    for point, reaction, lost in zip(network.points, kept.reactions, kept.lost, strict=True):
        if point.kind == "joint":
            x, y, z, _ = left[point.name]
            z -= lost
            faults += _faults_afloat(point, network.site.water_depth, places[point.name][2], lost)
            rubbed = network.site.seabed_friction * max(reaction, 0.0)
            over = math.hypot(max(math.hypot(x, y) - rubbed, 0.0), z + reaction)
            if over > limit:
                faults.append(f"{over:.3g} N left at {point.name} of {strongest:.3g} N")
            height = places[point.name][2]
            if reaction < 0.0 or (reaction > 0.0 and height > 1e-9 * longest):
                faults.append(f"{point.name} is carried with {reaction:.3g} N at {height:.3g} m")
    for body in found.bodies:
        x, y, up, moment = left[body.body.name]
        faults += _faults_of_height(body, network.site, up, limit)
        arm = max(math.hypot(*each) for each in _arms(found, places)[body.body.name].values())
        if math.hypot(x, y) > limit:
            faults.append(f"{math.hypot(x, y):.3g} N left on {body.body.name}")
        if body.turns and abs(moment) > limit * arm:
            faults.append(f"{moment:.3g} N m left on {body.body.name}")
    return faults


def _faults_afloat(point: Point, depth: float, height: float, lost: float) -> Iterator[str]:
    """Check what a float loses of its lift by how far it is out of the water."""
    weight = STANDARD_GRAVITY * (point.mass or 0.0)
    most = max(weight - point.submerged_weight, 0.0) if point.submerged_weight < 0.0 else 0.0
    out = height - depth + (point.float_height or 0.0)
    if point.float_height:
        least = most = most * min(max(out / point.float_height, 0.0), 1.0)
    else:
        least, most = (most if out > 0.0 else 0.0), (most if out >= 0.0 else 0.0)
    rounding = 1e-12 * (weight - point.submerged_weight) * depth / (point.float_height or depth)
    if not least - abs(rounding) <= lost <= most + abs(rounding):
        yield f"{point.name} has lost {lost:.3g} N {out:.3g} m out of the water"


def _faults_of_height(body: BodyAtRest, site: Site, up: float, limit: float) -> Iterator[str]:
    """Check what carries a body that floats, pulled up by its lines with so much (N)."""
    if not body.body.floats:
        return
    area, draught, freeboard = body.body.afloat
    height = draught + freeboard
    per_metre = site.water_density * STANDARD_GRAVITY * area
    wet = min(max(draught - body.rise, 0.0), height)
    bed = body.floating.bed_reaction
    over = per_metre * (wet - draught) + up + bed
    if abs(over) > limit + 1e-12 * per_metre * max(height, site.water_depth):
        yield f"{over:.3g} N left of the height of {body.body.name}"
    if bed < 0.0:
        yield f"{body.body.name} is carried with {bed:.3g} N"


def _arms(
    found: LinesAtRest, places: dict[str, Vector]
) -> dict[str, dict[str, tuple[float, float]]]:
    """How far the fairleads of each body are off its origin, m."""
    return {
        body.body.name: {
            point.name: (
                places[point.name][0] - body.position.x,
                places[point.name][1] - body.position.y,
            )
            for point in found.network.points
            if point.body == body.body.name
        }
        for body in found.bodies
    }


def _stiffness(line: Line) -> float:
    return 1.0 / sum(segment.length / segment.EA for segment in line.segments)


def _given_way(line: Line, site: Site, tension: float) -> float:
    """Force that the last digits of a place are worth at the end of a line on the bed, N/m^0.5.

    On a rough bed it gives way along it by H^2 / (2 EA mu w), and is lifted by V^2 / (2 w T).
    """
    of = (
        max(segment.submerged_weight, 0.0) * max(site.seabed_friction * segment.EA, tension)
        for segment in line.segments
    )
    return math.sqrt(2.0 * max(of) * LAST_DIGITS)


def _left(found: LinesAtRest, places: dict[str, Vector]) -> tuple[dict[str, list[float]], float]:
    """Sum forces (N) and moment (N m) on joints and bodies, line by line, and the largest tension.

    Without a bed under joints.
    """
    network, strongest = found.network, 0.0
    left = {point.name: [*point.hung, 0.0] for point in network.points if point.kind == "joint"}
    left |= {body.body.name: [*body.body.force, 0.0, body.body.moment] for body in found.bodies}
    arms = _arms(found, places)
    owners = {point.name: point.body or point.name for point in network.points}
    for run, given in zip(found.runs, network.lines, strict=True):
        ends = [network.points[k].name for k in (run.first, run.second)]
        line = given.line if ends[0] == given.start else reversed_line(given.line)
        a, b = (places[name] for name in ends)
        away = (b[0] - a[0], b[1] - a[1])
        size = math.hypot(*away)
        alone = solve(
            line,
            height=b[2],
            anchor_height=a[2],
            span=max(size, NEAREST * line.length),
            seabed_friction=_friction(network, run.name),
        )
        along = (away[0] / size, away[1] / size) if size > 0.0 else (0.0, 0.0)
        strongest = max(strongest, alone.fairlead.tension, alone.anchor.tension)
        for name, end, sense in ((ends[0], alone.anchor, 1.0), (ends[1], alone.fairlead, -1.0)):
            total = left.get(owners[name])
            if total is not None:
                pull = [sense * end.horizontal_force * each for each in along]
                x, y = arms.get(owners[name], {}).get(name, (0.0, 0.0))
                total[0] += pull[0]
                total[1] += pull[1]
                total[2] += sense * end.vertical_force
                total[3] += x * pull[1] - y * pull[0]
    return left, strongest


def _friction(network: Network, name: str) -> float:
    """Return the friction on a line: none where no anchor is at the end of its row."""
    for row in rows_of(network):
        if name in {network.lines[k].name or f"{k + 1}" for k, _ in row.lines}:
            kinds = {p.kind for p in network.points if p.name in (row.start, row.end)}
            return network.site.seabed_friction if "anchor" in kinds else 0.0
    raise KeyError(name)


def _faults_of_places(found: LinesAtRest, places: dict[str, Vector]) -> Iterator[str]:
    """Check places of what is held, of what moves with bodies, and of joints."""
    network, depth = found.network, found.network.site.water_depth
    bodies = {each.body.name: each for each in found.bodies}
    for point in network.points:
        x, y, z = places[point.name]
        if point.kind == "joint":
            if z < 0.0:
                yield f"{point.name} is {-z:.3g} m below the bed"
            if point.is_float and point.mass is None and z > depth:
                yield f"{point.name} is lifted {z - depth:.3g} m above the surface"
            continue
        a, b, c = point.place
        if point.body:
            rest = bodies[point.body]
            turned = math.cos(rest.position.yaw), math.sin(rest.position.yaw)
            a, b = a - rest.body.x, b - rest.body.y
            a, b = turned[0] * a - turned[1] * b, turned[1] * a + turned[0] * b
            a, b, c = rest.position.x + a, rest.position.y + b, c + rest.rise
        if math.dist((a, b, c), (x, y, z)) > 1e-12 * (abs(a) + abs(b) + depth):
            yield f"{point.name} is off its place"


def faults_of_refusal(network: Network, error: CatoptError) -> list[str]:
    """Say what is wrong with a refusal; empty when nothing is."""
    if isinstance(error, FloatsUpError):
        deeper = replace(
            network, site=replace(network.site, water_depth=1e5, accept=("water_depth",))
        )
        return _unless(deeper, error, _floats_above(network.site.water_depth))
    if isinstance(error, NoEquilibriumError) and network.site.seabed_friction > 0.0:
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr("catopt.mooring.joints.check_rest", lambda *_: None)
            patch.setattr("catopt.mooring.chains._check_rows", lambda *_: None)
            unloaded = error.message.startswith("without load")
            return _unless(network.unloaded() if unloaded else network, error, _lies_open)
    return [f"{type(error).__name__}: {error}"]


def _unless(network: Network, error: CatoptError, is_so: Any) -> list[str]:
    """Say what is wrong with a refusal, unless an answer, which is checked, shows its cause."""
    try:
        found = at_rest(network)
    except FloatsUpError as other:  # a second cause
        return faults_of_refusal(network, other)
    except CatoptError as other:
        return [f"{error}; and without its cause: {type(other).__name__}: {other}"]
    rubs = "lies on the bed between hanging parts" in error.message
    faults = [
        each
        for each in faults_of_answer(found)
        if not (rubs and "N left at" in each) and "is lifted" not in each  # a second cause
    ]
    return faults if faults or is_so(found) else [f"nothing of the kind: {error}"]


def _floats_above(depth: float) -> Any:
    def is_above(found: LinesAtRest) -> bool:
        lines = found.lines
        loads = [
            at for line in lines for at in zip(line.line.point_loads, line.point_loads, strict=True)
        ]
        heights = [
            *(highest_afloat(line.stretches) for line in lines),
            *(at.z for load, at in loads if load.submerged_weight < 0.0),
            *(point.place[2] for point in found.points if point.of.is_float),
        ]
        return max(heights) > depth

    return is_above


def _lies_open(found: LinesAtRest) -> bool:
    """Whether a joint, a body or a line without an anchor lies on the bed, held by friction."""
    bodies = (body.floating.bed_reaction for body in found.bodies)
    return any(reaction > 0.0 for reaction in (*found.joints.reactions, *bodies)) or any(
        line.grounded_length > 0.0 and not found.is_anchored(k)
        for k, line in enumerate(found.lines)
    )


def judge(seed: int, draw: Callable[[int], Network] = drawn) -> tuple[str, list[str]]:
    """Solve one network; what became of it, and what is wrong."""
    network = draw(seed)
    try:
        found = at_rest(network)
    except NotConvergedError as error:
        return "not converged", [str(error)]
    except CatoptError as error:
        return "refused", faults_of_refusal(network, error)
    return "answered", faults_of_answer(found)


def run_afloat(count: int, first: int, tell: Callable[[str], object]) -> int:
    """Do the same where floats and bodies come to the surface."""
    return run(count, first, tell, lambda seed: judge(seed, drawn_afloat))


def run(
    count: int,
    first: int,
    tell: Callable[[str], object],
    judge: Callable[[int], tuple[str, list[str]]] = judge,
) -> int:
    """Judge networks; tell of each that failed, and how many came to what. How many failed."""

    def judged(seed: int) -> tuple[str, str]:
        came, faults = judge(seed)
        return ("FAILED", f"{came}: {'; '.join(faults)}") if faults else (came, "")

    return counted(count, first, tell, judged)
