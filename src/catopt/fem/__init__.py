"""The spatial truss model: lines cut into bars, at rest on a bed that only pushes."""

from catopt.fem.bed import Bed, HeldBed
from catopt.fem.loads import Current, DragSection
from catopt.fem.mesh import LineMesh, mesh_line
from catopt.fem.problem import Water
from catopt.fem.result import EndForce, SystemSolution, TrussSolution
from catopt.fem.settle import Controls
from catopt.fem.solve import Leg, solve_line, solve_system

__all__ = [
    "Bed",
    "Controls",
    "Current",
    "DragSection",
    "EndForce",
    "HeldBed",
    "Leg",
    "LineMesh",
    "SystemSolution",
    "TrussSolution",
    "Water",
    "mesh_line",
    "solve_line",
    "solve_system",
]
