"""What the truss model found, as values."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

from catopt.fem.mesh import LineMesh
from catopt.fem.settle import Rest

Array = npt.NDArray[np.float64]


@dataclass(frozen=True)
class EndForce:
    """Force between the line and what holds its end: the balance of the end node, not a bar's.

    Attributes
    ----------
    tension : float
        N.
    horizontal_force, vertical_force : float
        Its parts, N; the vertical one is positive where the line rises towards the fairlead (at
        the anchor: where the line pulls the anchor up).
    angle : float
        Inclination above the horizontal, rad.
    """

    tension: float
    horizontal_force: float
    vertical_force: float
    angle: float


@dataclass(frozen=True)
class TrussSolution:
    """One line at rest.

    Attributes
    ----------
    mesh : LineMesh
        How the line was cut.
    nodes : ndarray, shape (elements + 1, 3)
        Coordinates from the anchor to the fairlead, m.
    tension : ndarray, shape (elements,)
        Of each bar, N: that of the line at the bar's middle.
    fairlead, anchor : EndForce
        Nodal reactions; the anchor's after seabed friction.
    span : float
        Horizontal distance between the ends, m.
    grounded_length : float
        Unstretched, m; between nodes, the touchdown follows from the reaction of the last node.
    bed_reaction : ndarray, shape (elements + 1,)
        Upward force of the bed on each node, N; below 0 only where a `HeldBed` holds a node down.
    penetration : float
        Largest depth of a node below the bed, m.
    residual : float
        Largest force left over at an inner node of all lines, over the largest tension.
    residual_node : int
        Where, counted over all lines; -1 for the body.
    iterations : int
        Of Newton's method, from the start.
    end_tension : ndarray, shape (elements, 2)
        Tension of the line at both ends of each bar, N, by the balance of half a bar.
    rest : Rest
        The whole state, for `start=` of a later solution.
    """

    mesh: LineMesh
    nodes: Array
    tension: Array
    fairlead: EndForce
    anchor: EndForce
    span: float
    grounded_length: float
    bed_reaction: Array
    penetration: float
    residual: float
    residual_node: int
    iterations: int
    end_tension: Array
    rest: Rest = field(repr=False, compare=False)

    @property
    def horizontal_force(self) -> float:
        """Horizontal force at the fairlead, N."""
        return self.fairlead.horizontal_force

    @property
    def arc(self) -> Array:
        """Unstretched arc length of the nodes, m, shape (elements + 1,)."""
        return self.mesh.arc

    @property
    def touchdowns(self) -> int:
        """Number of separate stretches of nodes on the bed, ends not counted."""
        lies = self.bed_reaction[1:-1] > 0.0
        return int(np.count_nonzero(lies[1:] & ~lies[:-1]) + (lies.size > 0 and lies[0]))

    def segment_max_tension(self) -> Array:
        """Largest tension in each segment, N: at the ends of its bars, by the nodes' balance."""
        largest = np.zeros(len(self.mesh.line.segments))
        np.maximum.at(largest, self.mesh.segment, self.end_tension.max(axis=1))
        return largest

    def point_load_reaction(self) -> Array:
        """Return what the bed carries at each point load beyond the line's own weight there, N."""
        node = self.mesh.load_node
        weight = np.array([s.submerged_weight for s in self.mesh.line.segments])
        half = 0.5 * weight[self.mesh.segment] * self.mesh.length
        own = np.maximum(half[node - 1] + half[node], 0.0)
        carried: Array = np.maximum(self.bed_reaction[node] - own, 0.0)
        return carried


@dataclass(frozen=True)
class SystemSolution:
    """Several lines and the body in which they meet, at rest.

    Attributes
    ----------
    position : tuple of float
        Of the body's origin, x, y and z, m.
    lines : tuple of TrussSolution
        In the order given.
    force : tuple of float
        Force of all lines on the body, N.
    residual, residual_node, iterations
        As for `TrussSolution`.
    rest : Rest
        The whole state, for `start=` of a later solution.
    """

    position: tuple[float, float, float]
    lines: tuple[TrussSolution, ...]
    force: tuple[float, float, float]
    residual: float
    residual_node: int
    iterations: int
    rest: Rest = field(repr=False, compare=False)
