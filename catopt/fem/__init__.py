"""The spatial truss model: lines cut into bars, at rest on a bed that only pushes and in motion."""

from catopt.fem.dynamic_model import Fluid, LineProperties
from catopt.fem.dynamics import run_dynamics, run_system_dynamics
from catopt.fem.extremes import (
    Course,
    Extreme,
    GumbelFit,
    SeriesStatistics,
    TailFit,
    gumbel,
    power_spectrum,
    series_statistics,
    weibull_tail,
)
from catopt.fem.history import History
from catopt.fem.linear_model import line_frequencies, natural_frequencies
from catopt.fem.loads import Current, DragSection
from catopt.fem.mesh import LineMesh, Water, mesh_line
from catopt.fem.morison import MorisonSection
from catopt.fem.newmark import LineDamping, Scheme, rayleigh_factors
from catopt.fem.run_settings import BodyInertia, StepControls, TimeStepping
from catopt.fem.seabed import Bed, RestrainedBed, Seabed
from catopt.fem.series import Harmonic, Sampled, Together
from catopt.fem.simulation import Simulation
from catopt.fem.solve import EndForce, Leg, SystemSolution, TrussSolution, solve_line, solve_system
from catopt.fem.static_newton import Controls
from catopt.old_names import old_function

HeldBed = old_function("HeldBed", RestrainedBed)

__all__ = [
    "Bed",
    "BodyInertia",
    "Controls",
    "Course",
    "Current",
    "DragSection",
    "EndForce",
    "Extreme",
    "Fluid",
    "GumbelFit",
    "Harmonic",
    "History",
    "Leg",
    "LineDamping",
    "LineMesh",
    "LineProperties",
    "MorisonSection",
    "RestrainedBed",
    "Sampled",
    "Scheme",
    "Seabed",
    "SeriesStatistics",
    "Simulation",
    "StepControls",
    "SystemSolution",
    "TailFit",
    "TimeStepping",
    "Together",
    "TrussSolution",
    "Water",
    "gumbel",
    "line_frequencies",
    "mesh_line",
    "natural_frequencies",
    "power_spectrum",
    "rayleigh_factors",
    "run_dynamics",
    "run_system_dynamics",
    "series_statistics",
    "solve_line",
    "solve_system",
    "weibull_tail",
]
