"""The particle swarm method of S1: the equilibrium as the minimum of one function."""

from catopt.catenary.swarm.solve import solve_swarm

__all__ = ["solve_swarm"]
