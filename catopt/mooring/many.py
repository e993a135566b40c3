"""Many loads on the bodies of lines between points in one call: arrays in, arrays out."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt

from catopt.arrays import Array, Codes, Flags
from catopt.catenary.state import CONVERGED
from catopt.errors import NoAnswerError, NotConvergedError
from catopt.model.network import MooredBody, Network
from catopt.mooring.fixed_body import WithoutLoad, without_load
from catopt.mooring.joints import is_anchored, moored, pose_of
from catopt.mooring.under_loads import PER_LINE, rested

__all__ = ["NetworkSolutions", "solve_network_many"]


@dataclass(frozen=True)
class NetworkSolutions:
    """Answers for many loads on the bodies of lines between points; nan where there is none.

    Attributes
    ----------
    reasons : dict of int to str
        Why loads have no answer, by their index.
    position : ndarray, shape (n, bodies, 3)
        x, y, yaw: m, m, rad.
    offset : ndarray, shape (n, bodies, 2)
        From where each is without load, m.
    first_force, second_force : ndarray, shape (n, lines, 3)
        Of each line on the points at its ends, along x, y and up, N; it runs from an anchor where
        it has one.
    grounded_length : ndarray, shape (n, lines)
        m.
    residual : ndarray, shape (n,)
        Largest force left over at a joint or a body, N.
    """

    reasons: dict[int, str]
    position: Array
    offset: Array
    first_force: Array
    second_force: Array
    grounded_length: Array
    residual: Array


def solve_network_many(network: Network, *, force: npt.ArrayLike) -> NetworkSolutions:
    """Bring lines between points to rest under many loads on their bodies.

    `force`: on each body along x and y (N) and in yaw (N m), shape (n, bodies, 3). Where joints lie
    in a row on one line, a joint comes to the bed or a buoy to the surface, loads are looked at one
    by one. Raises what `at_rest` raises without load.
    """
    start = without_load(network)
    forces = np.asarray(force, float)
    count, lines = len(forces), len(network.lines)
    of = start.as_numbers()
    loads = np.tile(of.net.pull, (count, 1))
    for each, own in zip(of.bodies, np.moveaxis(forces, 1, 0), strict=True):
        scaled, count_own = own / [1.0, 1.0, each.arm], 2 + each.turns
        loads[:, each.first : each.first + count_own] = scaled[:, :count_own]
    alone, reasons = np.ones(count, bool), {}
    poses = np.full((count, len(of.bodies), 3), np.nan)
    found, left = np.full((count, lines, PER_LINE), np.nan), np.full(count, np.nan)
    if len(of.net.first) == lines:
        _, under = rested(of.net, of.room, loads.ravel().tolist(), count)
        q = np.reshape(under.q, (count, -1))
        found = np.reshape(under.lines, (count, lines, PER_LINE))
        alone = _to_be_told(start, np.reshape(under.codes, (count, 3))[:, 0], q, found)
        poses = np.array([[pose_of(each, row)[:3] for each in of.bodies] for row in q.tolist()])
        left = np.array(under.left, float)
    for load in np.flatnonzero(alone).tolist():
        poses[load], found[load], left[load] = np.nan, np.nan, np.nan
        try:
            rest = start.under(_loaded(network.bodies, forces[load].tolist()))
        except (NoAnswerError, NotConvergedError) as error:
            reasons[load] = error.message
            continue
        poses[load] = [pose[:3] for pose in rest.joints.poses]
        left[load] = rest.residual
        ends = rest.joints.ends
        found[load] = [
            (*each.first, *each.second, each.state.grounded, each.state.span) for each in ends
        ]
    given = np.array([(body.x, body.y, 0.0) for body in network.bodies])
    poses[..., 2] = math.pi - np.remainder(math.pi - poses[..., 2], math.tau)
    neutral = np.array([pose[:2] for pose in start.found.poses])
    return NetworkSolutions(
        reasons,
        position=given + poses,
        offset=poses[..., :2] - neutral,
        first_force=found[..., :3],
        second_force=found[..., 3:6],
        grounded_length=found[..., 6],
        residual=left,
    )


def _loaded(
    bodies: Sequence[MooredBody], forces: Sequence[Sequence[float]]
) -> tuple[MooredBody, ...]:
    return tuple(
        replace(body, force=(x, y), moment=moment)
        for body, (x, y, moment) in zip(bodies, forces, strict=True)
    )


def _to_be_told(start: WithoutLoad, status: Codes, q: Array, found: Array) -> Flags:
    """Which loads are to be looked at one by one, for what is refused or is not in the numbers."""
    network, joints = start.whole, [p for p in start.whole.points if p.kind == "joint"]
    alone = np.not_equal(status, CONVERGED)
    has_friction = network.site.seabed_friction > 0.0
    for k, point in enumerate(joints):
        height = q[:, 3 * k + 2]
        if point.submerged_weight < 0.0:
            alone |= height > network.site.water_depth
        if has_friction:
            alone |= height <= 0.0
    if has_friction:
        for body in moored(network, 3 * len(joints)):
            alone |= q[:, body.up] <= 0.0 if body.body.floats else False
    for k, run in enumerate(start.runs):
        if has_friction and not is_anchored(network, run):
            alone |= found[:, k, 6] > 0.0
    return alone
