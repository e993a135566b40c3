"""What the comparison of the two models says, as values."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Annotated, Any, Literal, NamedTuple, NotRequired, TypedDict

import numpy as np

from catopt.arrays import Array
from catopt.catenary.layout import end_of, tension_at
from catopt.catenary.solution import Solution
from catopt.display import Displayable
from catopt.fem import SystemSolution, TrussSolution
from catopt.fem.network import NetworkSolution
from catopt.largest import largest
from catopt.model import Case
from catopt.model.kinds import Angle, Force, Height, Moment, NotNegative, Place, Positive
from catopt.model.network import Network
from catopt.records import Counted, From, FromZero, Record
from catopt.verify.comparison import ORDER, ROUNDING, Compared, worst_of

__all__ = [
    "VERDICTS",
    "Gap",
    "LinePair",
    "Mesh",
    "StaticComparison",
    "Verdict",
    "Verification",
    "least_agreeing",
]

SCHEMA = "catopt.verify/1"
Verdict = Literal["agrees", "differs", "not resolved", "not compared"]
VERDICTS: tuple[Verdict, ...] = ("differs", "not resolved", "agrees")
"""From the one that outweighs all others."""

_AT_JOINT = 1e-12
"""How far below a joint, over the line's length, a place counts as above it."""


def closed_form_at(closed: Solution, arc: Sequence[float] | Array) -> Array:
    """Place x and z, m, and tension, N, of points of the closed form's line, shape (points, 3).

    `arc` (points,): unstretched arc lengths from the anchor, m. At a joint those of its upper side.
    """
    stretches = [stretch for stretch in closed.stretches if stretch.length > 0.0]
    starts = [stretch.start for stretch in stretches]
    found = np.empty((len(arc), 3))
    for index, s in enumerate(arc):
        above = bisect_right(starts, float(s) + _AT_JOINT * closed.line.length)
        stretch = stretches[max(above - 1, 0)]
        local = min(max(float(s) - stretch.start, 0.0), stretch.length)
        found[index, :2] = end_of(stretch, local)
        found[index, 2] = tension_at(stretch, local)
    return found


def flat(truss: TrussSolution) -> Array:
    """Nodes in the line's own plane: horizontal distance from the anchor and height, m."""
    away = truss.nodes[:, :2] - truss.nodes[0, :2]
    return np.column_stack([np.hypot(away[:, 0], away[:, 1]), truss.nodes[:, 2]])


def largest_distances(
    closed: Solution, trusses: Sequence[TrussSolution]
) -> tuple[tuple[float, ...], float]:
    """Largest distance between a node and the closed form's point of the same arc length, m.

    On each mesh, and with the nodes themselves extrapolated. It is not less than the distance of
    the node from the curve, and taken at the nodes of the coarsest mesh, which all meshes share.
    """
    exact = closed_form_at(closed, trusses[0].arc)[:, :2]
    shapes = [flat(truss)[:: 2**k] for k, truss in enumerate(trusses)]
    if len(shapes) > 1:
        shapes.append(shapes[-1] + (shapes[-1] - shapes[-2]) / (2.0**ORDER - 1.0))
    *found, limit = [float(np.linalg.norm(s - exact, axis=1).max()) for s in shapes]
    return (tuple(found), limit) if len(trusses) > 1 else ((limit,), limit)


@dataclass(frozen=True)
class Mesh(Record):
    """One solution of the truss model."""

    DOCUMENT = "elements iterations residual penetration"

    elements: Counted
    """Bars of all lines."""
    iterations: FromZero
    """Of Newton's method, from a straight start."""
    residual: NotNegative
    """Largest force left over at a node, over the largest tension."""
    penetration: Height
    """Largest depth of a node below the bed, m."""

    @classmethod
    def of(
        cls, truss: TrussSolution | SystemSolution | NetworkSolution, lines: Sequence[TrussSolution]
    ) -> Mesh:
        """Tell of a solution of one line, or of a body with several."""
        elements = sum(line.mesh.elements for line in lines)
        penetration = max(line.penetration for line in lines) + 0.0
        return cls(elements, truss.iterations, truss.residual, penetration)


class Gap(NamedTuple):
    """By how much a truss is off the closed form along the line."""

    arc: Array
    distance: Array
    """Unstretched arc lengths, and how far each node is from its place in the closed form, m."""
    middles: Array
    tension: Array
    """Arc lengths of the bars' middles, m, and the difference of their tensions, N."""


@dataclass(frozen=True)
class LinePair:
    """One line by both models: the closed form, and the truss on its meshes."""

    closed: Solution
    trusses: tuple[TrussSolution, ...] = field(repr=False)

    @property
    def finest(self) -> TrussSolution:
        """The truss model on its finest mesh."""
        return self.trusses[-1]

    def finest_shape(self) -> Array:
        """Return the nodes of the finest mesh in the line's own plane: x and z, m."""
        return flat(self.finest)

    def closed_form_there(self) -> Array:
        """Return x, z (m) and tension (N) of the closed form at the nodes of the finest mesh."""
        return closed_form_at(self.closed, self.finest.arc)

    def gaps(self) -> list[Gap]:
        """Compare place and tension with the closed form along the line, for each mesh."""
        found = []
        for truss in self.trusses:
            exact = closed_form_at(self.closed, truss.arc)
            middles = 0.5 * (truss.arc[1:] + truss.arc[:-1])
            tension = closed_form_at(self.closed, middles)[:, 2]
            distance = np.linalg.norm(flat(truss) - exact[:, :2], axis=1)
            found.append(Gap(truss.arc, distance, middles, np.abs(truss.tension - tension)))
        return found


class PointValues(TypedDict):
    """Values of a joint or a free body."""

    place_x_m: NotRequired[Place]
    """m: of a joint."""
    place_y_m: NotRequired[Place]
    """m."""
    place_z_m: NotRequired[Place]
    """m, above the seabed."""
    position_x_m: NotRequired[Place]
    """m: of a body, under its load."""
    position_y_m: NotRequired[Place]
    """m."""
    moment_of_lines_Nm: NotRequired[Moment]
    """N m: of a body that yaws; of its lines about the vertical, counter-clockwise."""


class LineValues(TypedDict):
    """Values of one of several lines."""

    horizontal_force_N: Force
    """N: at the fairlead."""
    span_m: Place
    """m: horizontal distance between the ends."""
    grounded_length_m: Place
    """m, unstretched: on the seabed."""
    from_tension_N: NotRequired[Force]
    """N: effective tension, of a line between points, at the anchor or the first point of the
    case."""
    to_tension_N: NotRequired[Force]
    """N: the same at its other end."""
    fairlead_tension_N: NotRequired[Force]
    """N: effective tension."""
    anchor_tension_N: NotRequired[Force]
    """N: effective tension, after seabed friction."""


class ComparedValues(TypedDict):
    """The quantities of one line; or position, moment and lines of a body."""

    span_m: NotRequired[Place]
    """m: horizontal distance between the ends; where the force is given."""
    horizontal_force_N: NotRequired[Force]
    """N: at the fairlead; where the span is given, and of a system's lines."""
    fairlead_tension_N: NotRequired[Force]
    """N: effective tension."""
    fairlead_vertical_force_N: NotRequired[Force]
    """N: positive where the line rises towards the fairlead."""
    fairlead_angle_rad: NotRequired[Angle]
    """rad: inclination above the horizontal."""
    anchor_tension_N: NotRequired[Force]
    """N: effective tension, after seabed friction."""
    anchor_vertical_force_N: NotRequired[Force]
    """N: positive where the line pulls the anchor up."""
    anchor_angle_rad: NotRequired[Angle]
    """rad: inclination above the horizontal."""
    grounded_length_m: NotRequired[Place]
    """m, unstretched: on the seabed."""
    shape_m: NotRequired[Place]
    """m: largest distance between a node and the closed form's point of the same arc length; 0 in
    closed_form."""
    position_x_m: NotRequired[Place]
    """m: of a body, under its load."""
    position_y_m: NotRequired[Place]
    """m."""
    moment_of_lines_Nm: NotRequired[Moment]
    """N m: of a body that yaws; of its lines about the vertical, counter-clockwise."""
    points: NotRequired[Mapping[str, Annotated[Mapping[str, float], PointValues]]]
    """Of points joined by lines: joints and free bodies, by name."""
    lines: NotRequired[tuple[Annotated[Mapping[str, float], LineValues], ...]]
    """Of a body, or of points: the lines, in the order of the case."""


@dataclass(frozen=True)
class StaticComparison(Record):
    """Closed form and truss model at rest under one load."""

    DOCUMENT = (
        "name=load_case kind verdict tolerance closed_form fem difference "
        "worst(quantity line+1 named_point=point? unit gap) meshes quantities remarks"
    )

    name: str
    """Its name; load where the case has only that."""
    kind: Literal["line", "system", "network"]
    """One line, a body moored by several, or points joined by lines."""
    quantities: Annotated[tuple[Compared, ...], From(1)]
    """Every one that both models know."""
    meshes: Annotated[tuple[Mesh, ...], From(2)]
    """From the coarsest; each has twice the bars of the one before."""
    lines: tuple[LinePair, ...]
    tolerance: Positive
    """Allowed difference over the scale of each quantity, a pure number."""
    remarks: tuple[str, ...] = ()
    """What to know before the verdict is used."""
    line_names: tuple[str, ...] = ()
    """Of a network."""

    @property
    def closed_form(self) -> Annotated[Mapping[str, Any], ComparedValues]:
        """By the closed form."""
        return self._by_key(lambda each: each.closed_form)

    @property
    def fem(self) -> Annotated[Mapping[str, Any], ComparedValues]:
        """By the truss model: extrapolated, or of the finest mesh where it is not smooth."""
        return self._by_key(lambda each: each.extrapolated)

    @property
    def difference(self) -> Annotated[Mapping[str, Any], ComparedValues]:
        """By the truss model minus by the closed form."""
        return self._by_key(lambda each: each.difference)

    def _by_key(self, value: Callable[[Compared], float]) -> dict[str, Any]:
        """Lay values out by quantity, of lines in a list, of joints and bodies by name."""
        alone = [each for each in self.quantities if each.line is None]
        found: dict[str, Any] = {each.key: value(each) for each in alone if not each.point}
        if self.kind == "network":
            named: dict[str, dict[str, float]] = {}
            for each in alone:
                named.setdefault(each.point, {})[each.key] = value(each)
            found["points"] = named
        if self.kind != "line":
            found["lines"] = [
                {each.key: value(each) for each in self.quantities if each.line == k}
                for k in range(len(self.lines))
            ]
        return found

    @property
    def worst(self) -> Compared:
        """The quantity with the largest gap over its tolerance; of those alike the first."""
        return worst_of(self.quantities)

    def worst_of(self, line: int) -> Compared:
        """Return the same of one line of a system, from 0."""
        return worst_of(each for each in self.quantities if each.line == line)

    @property
    def rough(self) -> tuple[Compared, ...]:
        """The quantities whose error does not fall smoothly: they are not extrapolated."""
        return tuple(each for each in self.quantities if not each.is_smooth)

    @property
    def is_settled(self) -> bool:
        """Whether every gap is within its tolerance."""
        return all(each.agrees for each in self.quantities)

    @cached_property
    def verdict(self) -> Verdict:
        """Whether they agree; not resolved: the truss model itself may be off by the difference."""
        if self.is_settled:
            return "agrees"
        off = [each for each in self.quantities if not each.agrees]
        return "differs" if any(each.is_resolved for each in off) else "not resolved"

    @property
    def residual(self) -> float:
        """Largest force left over at a node of the finest mesh, over the largest tension."""
        return self.meshes[-1].residual

    def mesh_gap(self, mesh: int) -> float:
        """Largest difference over its scale on one mesh, from 0."""
        return max(abs(each.fem[mesh] - each.closed_form) / each.scale for each in self.quantities)

    def of(self, quantity: str, line: int | None = None, point: str = "") -> Compared:
        """Look a quantity up, such as ``"fairlead_tension"``; of a system by the line, from 0."""
        wanted = (quantity, line, point)
        return next(q for q in self.quantities if (q.quantity, q.line, q.point) == wanted)

    @property
    def fairlead_tension(self) -> Compared:
        """Tension at the fairlead, of several lines that of the most loaded one."""
        every = [each for each in self.quantities if each.quantity == "fairlead_tension"]
        return largest(every, lambda each: each.closed_form)

    def name_of_line(self, line: int) -> str:
        """Name of a line, from 0: of a network its own, else its number."""
        return self.line_names[line] if self.line_names else f"{line + 1}"


def least_agreeing(parts: Sequence[StaticComparison]) -> StaticComparison:
    """Return the load case in which the models agree least; of those alike the first."""
    resolved = ROUNDING / min(part.tolerance for part in parts)
    return largest(parts, lambda part: part.worst.severity, resolved)


@dataclass(frozen=True, repr=False)
class Verification(Displayable, Record):
    """Closed form beside truss model: a case in all its load cases, or the designs of a front."""

    SCHEMA = SCHEMA
    DOCUMENT = "case.title verdict worst_case=static parts=load_cases"

    case: Case | Network
    parts: tuple[StaticComparison, ...]
    """Of a case: every load case that was verified; empty where there is no closed form to compare
    with."""

    @property
    def is_named(self) -> bool:
        """Whether the load cases have names."""
        return isinstance(self.case, Case) and bool(self.case.load_cases)

    @property
    def static(self) -> StaticComparison:
        """The load case in which the models agree least."""
        return least_agreeing(self.parts)

    @property
    def worst_case(self) -> StaticComparison | None:
        """The load case, or design, in which the models agree least; None without any."""
        return self.static if self.parts else None

    @cached_property
    def verdict(self) -> Verdict:
        """Of all that was verified; not compared where the bed slopes: there is no closed form."""
        verdicts = [part.verdict for part in self.parts]
        return next((v for v in VERDICTS if v in verdicts), "not compared")

    @property
    def is_settled(self) -> bool:
        """Whether the models agree."""
        return all(part.is_settled for part in self.parts)

    def to_dict(self) -> dict[str, Any]:
        """Build the document that ``catopt verify --json`` prints (schema catopt.verify/1)."""
        return super().to_dict() | {"dynamic": None}
