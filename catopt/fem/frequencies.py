"""Natural frequencies of lines about where they are at rest."""

from __future__ import annotations

import numpy as np

from catopt.arrays import Array
from catopt.fem.dynamic_model import LineProperties
from catopt.fem.dynamics import line_at_rest
from catopt.fem.mesh import LineMesh, end_nodes
from catopt.fem.moving import Blend
from catopt.fem.simulation import Simulation
from catopt.waves import Sea


def line_frequencies(
    mesh: LineMesh,
    count: int = 10,
    *,
    height: float,
    span: float | None = None,
    horizontal_force: float | None = None,
    anchor_height: float = 0.0,
    properties: LineProperties | None = None,
    sea: Sea | None = None,
) -> Array:
    """Lowest natural frequencies of a line with both ends held, rad/s, rising.

    Two of them with one damping ratio give Rayleigh's factors (`rayleigh_factors`), as in S4.

    Parameters
    ----------
    count : int
        How many.
    height, span, horizontal_force, anchor_height, properties, sea
        As for `run_dynamics`.
    """
    simulation = line_at_rest(
        mesh,
        height=height,
        span=span,
        horizontal_force=horizontal_force,
        anchor_height=anchor_height,
        properties=properties,
        sea=sea,
    )
    return natural_frequencies(simulation, count)


def natural_frequencies(simulation: Simulation, count: int = 10) -> Array:
    """Lowest natural frequencies, rad/s, rising: of K - omega^2 M at the present state at rest.

    K is the tangent of bars, bed and friction springs, M the mass with the water's added mass.
    Drag and damping do not count, nor does friction that slips.

    Parameters
    ----------
    simulation : Simulation
        Lines at rest (`Simulation.settle`).
    count : int
        How many, at most; frequencies of 0 (a line that can swing freely without weight) are 0.
    """
    from scipy.linalg import eigh

    K = _matrix(simulation, Blend(0.0, 0.0, 1.0, 0.0, 0.0))
    M = _matrix(simulation, Blend(0.0, 0.0, 0.0, 0.0, 1.0))
    lowest = [0, min(count, K.shape[0]) - 1]
    squares = eigh(0.5 * (K + K.T), 0.5 * (M + M.T), eigvals_only=True, subset_by_index=lowest)
    frequencies: Array = np.sqrt(np.maximum(squares, 0.0))
    return frequencies


def _matrix(simulation: Simulation, blend: Blend) -> Array:
    """Whole matrix of the unknowns: inner nodes of all lines, then the body's free directions."""
    simulation.assemble(blend)
    blocks, lines, body = simulation.equations, simulation.lines, simulation.body
    firsts, lasts = end_nodes(lines.start)
    unknowns = 3 * int((lasts - firsts - 1).sum())
    full = np.zeros((unknowns + 3, unknowns + 3))
    body_rows = slice(unknowns, unknowns + 3)
    full[body_rows, body_rows] = np.diag(blend.by_a * body.mass)
    row = 0
    for first, last in zip(firsts, lasts, strict=True):
        for n in range(first + 1, last):
            here = slice(row, row + 3)
            after = slice(row + 3, row + 6) if n + 1 < last else body_rows
            full[here, here] += blocks.diagonal[n]
            full[here, after] += blocks.upper[n]
            full[after, here] += blocks.lower[n + 1]
            row += 3
        full[body_rows, body_rows] += blocks.diagonal[last]
    kept = np.concatenate([np.ones(unknowns, bool), body.free == 1.0])
    matrix: Array = full[np.ix_(kept, kept)]
    return matrix
