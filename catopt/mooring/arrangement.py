"""All lines of a body as plain sequences of numbers: the form in which the kernel takes them."""

from __future__ import annotations

from typing import Any, NamedTuple

from catopt.catenary.equilibrium import hang_slack
from catopt.catenary.pieces import LineProblem, Pieces, cut
from catopt.catenary.state import CONVERGED, TOO_SHORT, failed
from catopt.model.line import Line
from catopt.model.system import Leg, System


class Arrangement(NamedTuple):
    """Where the ends of the lines are and what the lines are made of.

    Lists in plain code, arrays in compiled code. Anchors and heights (above the seabed) in m, arms
    are the fairleads in the body's axes (m), friction the Coulomb coefficient of the bed. The
    pieces of line k (as in catenary.pieces.Pieces, line after line) are those from `first[k]` to
    `first[k + 1]`; `load` begins at twice `first[k] + k`. slack_span is the longest span at which a
    line pulls to no side (m; below 0 when there is none), with its vertical forces (N) and length
    on the bed (m) there.
    """

    anchor_x: Any
    anchor_y: Any
    anchor_height: Any
    arm_x: Any
    arm_y: Any
    fairlead_height: Any
    friction: float
    first: Any
    length: Any
    weight: Any
    compliance: Any
    load: Any
    slack_span: Any
    slack_V: Any
    slack_V_anchor: Any
    slack_grounded: Any


class Lines(NamedTuple):
    """What is known of each line at a position of the body; written to by the kernel.

    H and V at the fairlead (N; nan before the first position), span and grounded length (m), forces
    on the anchor (N); H_S and V_S are derivatives of H and V by the span, the height held (N/m).
    """

    H: Any
    V: Any
    span: Any
    grounded: Any
    H_anchor: Any
    V_anchor: Any
    H_S: Any
    V_S: Any


def arrange(system: System) -> Arrangement:
    """Lay out a system as lists of plain numbers."""
    first, length, weight, compliance, load = [0], [], [], [], []
    slack = []
    known: dict[tuple[Line, float, float], tuple[float, float, float, float]] = {}
    for leg in system.legs:
        pieces, _ = cut(leg.line)
        key = (leg.line, leg.anchor_height, leg.fairlead_height)
        if key not in known:
            known[key] = _slack(pieces, leg, system.seabed_friction)
        slack.append(known[key])
        length += pieces.length
        weight += pieces.weight
        compliance += pieces.compliance
        load += pieces.load
        first.append(len(length))
    legs = system.legs
    return Arrangement(
        anchor_x=[leg.anchor[0] for leg in legs],
        anchor_y=[leg.anchor[1] for leg in legs],
        anchor_height=[float(leg.anchor_height) for leg in legs],
        arm_x=[leg.fairlead[0] for leg in legs],
        arm_y=[leg.fairlead[1] for leg in legs],
        fairlead_height=[float(leg.fairlead_height) for leg in legs],
        friction=float(system.seabed_friction),
        first=first,
        length=length,
        weight=weight,
        compliance=compliance,
        load=load,
        slack_span=[each[0] for each in slack],
        slack_V=[each[1] for each in slack],
        slack_V_anchor=[each[2] for each in slack],
        slack_grounded=[each[3] for each in slack],
    )


def _slack(pieces: Pieces, leg: Leg, friction: float) -> tuple[float, float, float, float]:
    """Span, V, V at the anchor and grounded length of a line that just hangs slack."""
    problem = LineProblem(pieces, float(leg.anchor_height), float(leg.fairlead_height), friction)
    drop = leg.fairlead_height + leg.anchor_height
    state = hang_slack(problem) if drop < leg.line.length else failed(TOO_SHORT)
    if state.status != CONVERGED:
        return -1.0, 0.0, 0.0, 0.0
    return state.span, state.V, state.V_anchor, state.grounded


def room_for(lines: int) -> Lines:
    """Make lists for what the kernel says of each line."""
    return Lines(*([float("nan")] * lines for _ in Lines._fields))
