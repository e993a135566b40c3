"""Whether an answer is an equilibrium: its public figures against the walks from both ends."""

from __future__ import annotations

import math
from bisect import bisect_left
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import numpy.typing as npt

from catopt.catenary.solution import Solution
from tests.campaign import walks
from tests.campaign.quadrature import upright
from tests.campaign.walks import CONDITIONS, FORCE, LENGTH, SNAP, ULPS, Ends, Parts, Walked

Array = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Finding:
    """What an answer's check found.

    Attributes
    ----------
    condition : str
        The condition that is missed the most, of walks.CONDITIONS.
    ratio : float
        Its miss as a part of what is allowed: up to 1 is right.
    open_place, open_H, open_V : float
        What double precision leaves open: of the far end (m) and of the forces at the fairlead (N).
    """

    condition: str
    ratio: float
    open_place: float
    open_H: float
    open_V: float

    @property
    def is_right(self) -> bool:
        return self.ratio <= 1.0


def check(solution: Solution, known: str, value: float) -> Finding:
    """Check an answer.

    Parameters
    ----------
    solution : Solution
        Of `catopt.solve`.
    known, value : str, float
        What was asked for: a key of Load, and N or m.
    """
    ratio, walked = _walked(solution, known)
    asked = {
        "horizontal_force": solution.horizontal_force,
        "span": solution.span,
        "fairlead_tension": solution.fairlead.tension,
    }
    exact = FORCE if known == "fairlead_tension" else 1e-12
    walks.note(ratio, walks.ASKED, asked[known] - value, exact * value)
    worst = int(np.argmax(ratio))
    open_H = walked.H if known == "span" else 0.0
    return Finding(CONDITIONS[worst], float(ratio[worst]), walked.x + walked.z, open_H, walked.V)


def misses(solution: Solution) -> dict[str, float]:
    """Miss of every condition, whatever was asked: of lengths over L, of forces over the largest.

    The force that would close a part's height is left out: it says the same again.
    """
    ratio, _ = _walked(solution, "")
    ratio[walks.V_BY_HEIGHT] = 0.0
    return dict(zip(CONDITIONS, (FORCE * ratio).tolist(), strict=True))


def misfit(solution: Solution) -> float:
    """Return the largest of all misses."""
    return max(misses(solution).values())


def _walked(solution: Solution, known: str) -> tuple[Array, Walked]:
    """Misses of all conditions, as parts of what is allowed."""
    ratio = np.zeros(len(CONDITIONS))
    ends = _ends(solution)
    T = solution.fairlead.tension
    walks.note(ratio, walks.ASKED, T - math.hypot(ends.H, ends.V), FORCE * T)
    _layout(solution, ratio)
    if known == "span" and ends.H == 0.0:
        return ratio, _slack(solution, ratio)
    parts = _parts(solution)
    most = np.zeros(len(parts.length))
    place = np.zeros((len(most) + 1, 2))
    walked = walks.down(parts, ends, known == "span", most, ratio)
    raised = walks.up(parts, ends, most, ratio, place)
    _point_loads(solution, parts, place, raised, ratio)
    return ratio, walked


def _ends(solution: Solution) -> Ends:
    return Ends(
        solution.fairlead.horizontal_force,
        solution.fairlead.vertical_force,
        solution.span,
        solution.fairlead_height,
        solution.anchor.horizontal_force,
        solution.anchor.vertical_force,
        solution.anchor_height,
        solution.seabed_friction,
        max(solution.line.length, solution.span),
    )


def _layout(solution: Solution, ratio: Array) -> None:
    """Check that the stretches make up the line, and how much of it lies."""
    length = solution.line.length
    start = grounded = 0.0
    for stretch in solution.stretches:
        walks.note(ratio, walks.LAYOUT, stretch.start - start, LENGTH * length)
        walks.note(ratio, walks.LAYOUT, min(stretch.length, 0.0), LENGTH * length)
        start += stretch.length
        grounded += stretch.length if stretch.on_bed else 0.0
    walks.note(ratio, walks.LAYOUT, start - length, LENGTH * length)
    walks.note(ratio, walks.GROUNDED, grounded - solution.grounded_length, LENGTH * length)


def _parts(solution: Solution) -> Parts:
    """Cut the line at its joints and point loads, and where the answer changes between them."""
    line, length = solution.line, solution.line.length
    joints = [0.0]
    for segment in line.segments:
        joints.append(joints[-1] + segment.length)
    loads: dict[float, list[float]] = {}
    for load, state in zip(line.point_loads, solution.point_loads, strict=True):
        place = _nearest(sorted({*joints[1:-1], *loads}), load.position, SNAP * length)
        found = loads.setdefault(load.position if place is None else place, [0.0, 0.0])
        found[0] += load.submerged_weight
        found[1] += state.seabed_reaction
    exact = sorted({*joints, *loads})
    stretches = [s for s in solution.stretches if s.length > SNAP * length]
    cuts = []
    for below, above in pairwise(stretches):
        changes = below.on_bed != above.on_bed or _is_loose(below) != _is_loose(above)
        if changes and _nearest(exact, above.start, SNAP * length) is None:
            cuts.append(above.start)
    places = sorted({*exact, *cuts})
    n = len(places) - 1
    parts = Parts(
        *(np.zeros(n) for _ in range(4)),
        *(np.zeros(n, dtype=np.bool_) for _ in range(2)),
        *(np.zeros(n) for _ in range(2)),
        *(np.full(n, math.nan) for _ in range(4)),
    )
    owner, at = 0, 0
    for k, (a, b) in enumerate(pairwise(places)):
        while joints[owner + 1] <= a:
            owner += 1
        segment = line.segments[owner]
        is_whole = a == joints[owner] and b == joints[owner + 1]
        parts.length[k] = segment.length if is_whole else b - a
        parts.weight[k] = segment.submerged_weight
        parts.compliance[k] = 1.0 / segment.EA
        if not is_whole:
            parts.blur[k] = ULPS * length * abs(segment.submerged_weight)
        middle = 0.5 * (a + b)
        while at < len(stretches) - 1 and stretches[at + 1].start <= middle:
            at += 1
        stretch = stretches[at]
        parts.on_bed[k] = stretch.on_bed
        parts.loose[k] = _is_loose(stretch)
        if abs(stretch.start - a) <= SNAP * length < b - a:
            parts.x[k], parts.z[k] = stretch.x, stretch.z
            parts.H[k], parts.V[k] = stretch.horizontal_force, stretch.vertical_force
        parts.load[k], parts.reaction[k] = loads.get(b, (0.0, 0.0))
    _blur_touchdowns(parts, length)
    return parts


def _blur_touchdowns(parts: Parts, length: float) -> None:
    """Where the line touches down at a joint, it may do so within SNAP of it."""
    for k in np.flatnonzero(parts.on_bed[1:] != parts.on_bed[:-1]):
        blur = SNAP * length * np.abs(parts.weight[k : k + 2]).max()
        parts.blur[k : k + 2] = np.maximum(parts.blur[k : k + 2], blur)


def _is_loose(stretch: object) -> bool:
    return bool(
        stretch.on_bed and stretch.horizontal_force == 0.0 and stretch.friction == 0.0  # type: ignore[attr-defined]
    )


def _nearest(places: list[float], place: float, within: float) -> float | None:
    index = bisect_left(places, place - within)
    return places[index] if index < len(places) and places[index] <= place + within else None


def _point_loads(
    solution: Solution, parts: Parts, place: Array, walked: Walked, ratio: Array
) -> None:
    """Check the places that the answer gives of its point loads."""
    allowed = LENGTH * max(solution.line.length, solution.span) + walked.x + walked.z
    starts = np.concatenate(([0.0], np.cumsum(parts.length)))
    for state in solution.point_loads:
        k = int(np.argmin(np.abs(starts - state.position)))
        walks.note(ratio, walks.LOAD_PLACE, state.x - place[k, 0], allowed)
        walks.note(ratio, walks.LOAD_PLACE, state.z - place[k, 1], allowed)


def _slack(solution: Solution, ratio: Array) -> Walked:
    """Check a line without horizontal force: what hangs is upright, what lies may lie in bights.

    Without a direction of its own, a piece on the bed, or a weightless one without force, need only
    be long enough for the way between the places that the answer gives to its ends.
    """
    size = max(solution.line.length, solution.span)
    far = LENGTH * size
    V = solution.fairlead.vertical_force
    force = FORCE * max(abs(V), abs(solution.anchor.vertical_force))
    x, z = solution.span, solution.fairlead_height
    open_V, open_z = ULPS * abs(V), ULPS * size
    parts = _parts(solution)
    for k in range(len(parts.length) - 1, -1, -1):
        w, c, length = parts.weight[k], parts.compliance[k], parts.length[k]
        if k < len(parts.length) - 1:
            W, R = parts.load[k], parts.reaction[k]
            V += R - W
            open_V = max(open_V, ULPS * max(abs(W), abs(R)))
            walks.note(ratio, walks.REACTION, max(-R, R - max(W, 0.0), 0.0), force + open_V)
            if abs(R) > force + open_V:
                walks.note(ratio, walks.REACTION, z, far + open_z)
        x_low, z_low = parts.x[k], parts.z[k]
        if math.isnan(x_low):
            walks.note(ratio, walks.LAYOUT, 1.0, 0.0)
            break
        walks.note(ratio, walks.STRETCH_FORCE, parts.H[k], force)
        way = math.hypot(x - x_low, z - z_low)
        if parts.on_bed[k]:
            walks.note(ratio, walks.TOUCH_V, V, open_V + force + parts.blur[k])
            walks.note(ratio, walks.TOUCH_Z, max(abs(z), abs(z_low)), far + open_z)
            walks.note(ratio, walks.FLOATS, min(w * length, 0.0), force)
            walks.note(ratio, walks.SLACK, max(way - length, 0.0), far)
            V, open_V, open_z = 0.0, 0.0, ULPS * size
        else:
            V -= w * length
            open_V = max(open_V, parts.blur[k], ULPS * max(abs(V), abs(w * length)))
            walks.note(ratio, walks.STRETCH_FORCE, parts.V[k] - V, force + open_V)
            if w == 0.0 and abs(V) <= open_V:
                walks.note(ratio, walks.SLACK, max(way - length, 0.0), far)
                walks.note(ratio, walks.BELOW, min(z_low, 0.0), far)
            else:
                r = upright(V, w, c, length, open_V)
                open_z += r.doubt + ULPS * abs(r.z)
                walks.note(ratio, walks.PLACE, x - x_low, far)
                walks.note(ratio, walks.HEIGHT, z - z_low - r.z, far + open_z)
                walks.note(ratio, walks.BELOW, min(z_low + r.low, 0.0), far + open_z)
        x, z = float(x_low), float(z_low)
    walks.note(ratio, walks.SPAN, x, far)
    walks.note(ratio, walks.HEIGHT, z - solution.anchor_height, far)
    walks.note(ratio, walks.ANCHOR_V, V - solution.anchor.vertical_force, force + open_V)
    walks.note(ratio, walks.ANCHOR_H, solution.anchor.horizontal_force, force)
    return Walked(ULPS * size, open_z, 0.0, open_V)
