"""Members at rest, many at a time: only their loads differ within a group of them."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import Any, Final, NamedTuple

import numpy as np

from catopt.arrays import Array, Codes
from catopt.catenary.batch import Solutions, solve_many
from catopt.catenary.case import solve_case
from catopt.catenary.solution import Solution
from catopt.errors import InputError, NoAnswerError, NotConvergedError, refused
from catopt.model import Case, Load, System
from catopt.model.kinds import Measured
from catopt.model.load import LOADS as OF_A_LINE
from catopt.model.network import Network
from catopt.model.system import Leg
from catopt.mooring.batch import SystemSolutions, solve_system_many
from catopt.mooring.case import report_system
from catopt.mooring.fixed_body import at_rest as network_at_rest
from catopt.mooring.joints import reversed_line
from catopt.mooring.many import solve_network_many
from catopt.mooring.network_rest import LinesAtRest
from catopt.study.member import Base, kind_of_key, read_member, reason_of
from catopt.study.study import StudyPiece
from catopt.words import Message

_LOADS: Final = re.compile(
    rf"load\.({'|'.join(OF_A_LINE)})|(system|bodies\[\d+\])\.(force\[[01]\]|moment)"
)
"""Keys that differ within a group."""


class AtRest(NamedTuple):
    """Members at rest: `values`, by name, nan where there is no answer; `reasons` for those."""

    values: dict[str, Array]
    reasons: dict[int, str]


def at_rest(base: Base, piece: StudyPiece) -> AtRest:
    """Solve the members of a piece."""
    names = [each.name for each in base.kept]
    found = AtRest({name: np.full(len(piece), np.nan) for name in names}, {})
    for group in _groups(piece):
        try:
            _solve(base, piece, group, found)
        except (InputError, NoAnswerError, NotConvergedError) as error:
            found.reasons.update(dict.fromkeys(group.tolist(), reason_of(error)))
    return found


def _groups(piece: StudyPiece) -> Iterator[Codes]:
    """Part the members of a piece by all but their loads."""
    slow = {key: column for key, column in piece.columns.items() if not _LOADS.fullmatch(key)}
    if not slow:
        yield np.arange(len(piece))
        return
    codes = np.zeros(len(piece), dtype=np.int64)
    for column in slow.values():
        values, code = np.unique(np.asarray(column), return_inverse=True)
        codes = np.unique(codes * len(values) + code, return_inverse=True)[1]
    order = np.argsort(codes, kind="stable")
    yield from np.split(order, np.flatnonzero(np.diff(codes[order])) + 1)


def _solve(base: Base, piece: StudyPiece, group: Codes, found: AtRest) -> None:
    """Solve members that differ in their loads alone."""
    loads = {
        key: np.asarray(column)[group]
        for key, column in piece.columns.items()
        if _LOADS.fullmatch(key)
    }
    within = np.ones(len(group), dtype=bool)
    for key, values in loads.items():
        kind = kind_of_key(base, key)
        assert isinstance(kind, Measured)
        wrong = np.zeros(values.shape, dtype=bool) if kind.above is None else values <= kind.above
        within &= ~wrong
        for member in np.flatnonzero(wrong).tolist():
            found.reasons[int(group[member])] = _refusal(base, key, values[member])
    if not within.any():
        return
    at = group[within]
    loads = {key: values[within] for key, values in loads.items()}
    first = {key: values[0].item() for key, values in loads.items()}
    case = read_member(base, {**piece.changes(int(group[0])), **first})
    if isinstance(case, Network):
        solved = _points(case, loads, len(at))
    else:
        assert isinstance(case, Case)
        case.site.check_level()
        case.check_still_water()
        if any(each.submerged_weight < 0.0 for each in case.line.point_loads):
            # Of its buoys it is to be told, load by load, that none rises above the water.
            solved = _each(partial(_under, case), loads, len(at))
        elif case.several_lines:
            solved = _bodies(case.own_system, loads, len(at))
        else:
            solved = _lines(case, loads, len(at))
    for name, column in solved.values.items():
        found.values[name][at] = column
    found.reasons.update({int(at[member]): reason for member, reason in solved.reasons.items()})


def _refusal(base: Base, key: str, value: float) -> str:
    try:
        kind_of_key(base, key).read(float(value))
    except InputError as error:
        return f"{key}: {error.problems[0].allowed}"
    raise AssertionError(key)


Loads = Mapping[str, Array]
"""Values in SI by key path."""


def _lines(case: Case, loads: Loads, count: int) -> AtRest:
    """Solve one line under many loads."""
    if case.load is None:
        raise refused("case", "", Message("refused_study.case_with_load_or_system"))
    given: dict[str, Any] = {name: getattr(case.load, name) for name in OF_A_LINE}
    given |= {key.removeprefix("load."): values for key, values in loads.items()}
    wanted: dict[str, Any] = {
        name: np.broadcast_to(value, (count,)) for name, value in given.items() if value is not None
    }
    wanted |= case.place
    solved = solve_many(case.line, **wanted)
    values = {
        "fairlead_tension": solved.tension,
        "anchor_tension": solved.anchor_tension,
        "anchor_uplift": solved.anchor_vertical_force,
        "grounded_length": solved.grounded_length,
        "span": solved.span,
    }
    return AtRest(values, _reasons(solved))


def _bodies(system: System, loads: Loads, count: int) -> AtRest:
    """Bring one body to rest under many loads."""

    def given(key: str, own: float) -> Array:
        return loads.get(f"system.{key}", np.full(count, own))

    solved = solve_system_many(
        system,
        force=np.column_stack([given(f"force[{k}]", own) for k, own in enumerate(system.force)]),
        moment=given("moment", system.moment),
    )
    values = {
        "fairlead_tension": solved.tension.max(axis=1),
        "anchor_tension": solved.anchor_tension.max(axis=1),
        "anchor_uplift": solved.anchor_vertical_force.max(axis=1),
        "grounded_length": solved.grounded_length.min(axis=1),
        "offset": np.hypot(solved.offset[:, 0], solved.offset[:, 1]),
    }
    return AtRest(values, _reasons(solved))


def _points(network: Network, loads: Loads, count: int) -> AtRest:
    """Bring points and lines to rest under many loads on bodies: in bulk what is as a system."""
    system = system_of(network)
    if system is not None:
        own = {key.replace("bodies[0]", "system"): values for key, values in loads.items()}
        return _bodies(system, own, count)
    if not network.bodies:
        return _each(lambda _: points_at_rest(network_at_rest(network)), loads, count)
    keys = ("force[0]", "force[1]", "moment")
    given = [
        [
            loads.get(f"bodies[{k}].{key}", np.full(count, own))
            for key, own in zip(keys, (*body.force, body.moment), strict=True)
        ]
        for k, body in enumerate(network.bodies)
    ]
    solved = solve_network_many(network, force=np.moveaxis(np.array(given), 2, 0))
    first, second = (
        np.linalg.norm(each, axis=2) for each in (solved.first_force, solved.second_force)
    )
    kinds = {point.name: point.kind for point in network.points}
    is_anchored = np.array(
        [{kinds[e.start], kinds[e.end]} & {"anchor"} != set() for e in network.lines]
    )
    others = np.where(is_anchored, 0.0, first)
    values = {
        "fairlead_tension": np.maximum(others, second).max(axis=1),
        "grounded_length": solved.grounded_length.min(axis=1),
        "offset": np.hypot(solved.offset[..., 0], solved.offset[..., 1]).max(axis=1),
    }
    if is_anchored.any():
        values["anchor_tension"] = first[:, is_anchored].max(axis=1)
        values["anchor_uplift"] = solved.first_force[:, is_anchored, 2].max(axis=1)
    return AtRest(values, solved.reasons)


def system_of(network: Network) -> System | None:
    """Say points and lines as a system again: lines from anchors to one free body; None of others.

    Of buoys on lines it is not told how high they come to be.
    """
    points = {point.name: point for point in network.points}
    legs = []
    for each in network.lines:
        ends, line = [points[each.start], points[each.end]], each.line
        if ends[1].kind == "anchor":
            ends, line = ends[::-1], reversed_line(line)
        anchor, fairlead = ends
        has_buoys = any(load.submerged_weight < 0.0 for load in line.point_loads)
        if anchor.kind != "anchor" or not fairlead.body or len(network.bodies) > 1 or has_buoys:
            return None
        (body,) = network.bodies
        (ax, ay, anchor_height), (x, y, height) = anchor.place, fairlead.place
        if math.hypot(ax - body.x, ay - body.y) == 0.0:
            return None
        legs.append(
            Leg.between(
                line,
                anchor=(ax - body.x, ay - body.y),
                fairlead=(x - body.x, y - body.y),
                fairlead_height=height,
                anchor_height=anchor_height,
            )
        )
    x, y = body.force
    friction, turns = network.site.seabed_friction, network.turns(body)
    return System(tuple(legs), (x, y), body.moment, friction, yaw_free=turns)


def points_at_rest(rest: LinesAtRest) -> dict[str, float]:
    """Sum up points and lines at rest over all lines: at anchors, and at all other ends."""
    lines = rest.lines
    anchors = [line.anchor for k, line in enumerate(lines) if rest.is_anchored(k)]
    others = [line.anchor for k, line in enumerate(lines) if not rest.is_anchored(k)]
    values = {
        "fairlead_tension": max(e.tension for e in (*others, *(line.fairlead for line in lines))),
        "grounded_length": min(line.grounded_length for line in lines),
    }
    if anchors:
        values["anchor_tension"] = max(each.tension for each in anchors)
        values["anchor_uplift"] = max(each.vertical_force for each in anchors)
    if rest.bodies:
        values["offset"] = max(math.hypot(*body.offset) for body in rest.bodies)
    return values


def _reasons(solved: Solutions | SystemSolutions) -> dict[int, str]:
    failed = np.flatnonzero(~solved.converged).tolist()
    return {member: solved.reason(member) or "" for member in failed}


def _each(
    under: Callable[[Mapping[str, float]], dict[str, float]], loads: Loads, count: int
) -> AtRest:
    """Solve members one by one, each under its own loads."""
    values: dict[str, Array] = {}
    reasons = {}
    for member in range(count):
        own = {key: float(column[member]) for key, column in loads.items()}
        try:
            found = under(own)
        except (NoAnswerError, NotConvergedError) as error:
            reasons[member] = error.message
            continue
        for name, value in found.items():
            values.setdefault(name, np.full(count, np.nan))[member] = value
    return AtRest(values, reasons)


def _under(case: Case, loads: Mapping[str, float]) -> dict[str, float]:
    """Solve a case under loads of a member's own."""
    if case.several_lines:
        system = case.own_system
        x, y = system.force
        force = (loads.get("system.force[0]", x), loads.get("system.force[1]", y))
        moment = loads.get("system.moment", system.moment)
        case = replace(case, system=replace(system, force=force, moment=moment))
    elif loads:
        (name, value), *_ = loads.items()
        case = replace(case, load=Load(**{name.removeprefix("load."): value}))
    return one_at_rest(case)


def one_at_rest(case: Case) -> dict[str, float]:
    """Solve one case at rest, as ``catopt solve`` and ``catopt system`` do.

    Raises what they raise.
    """
    if not case.several_lines:
        solution = solve_case(case)
        return {**_of_ends([solution]), "span": solution.span}
    body = report_system(case).solution
    return {
        **_of_ends([each.solution for each in body.lines]),
        "offset": math.hypot(*body.offset),
    }


def _of_ends(lines: Sequence[Solution]) -> dict[str, float]:
    return {
        "fairlead_tension": max(each.fairlead.tension for each in lines),
        "anchor_tension": max(each.anchor.tension for each in lines),
        "anchor_uplift": max(each.anchor.vertical_force for each in lines),
        "grounded_length": min(each.grounded_length for each in lines),
    }
