"""Solutions to lay out."""

from tests.report.conftest import buoy, case, leg, swarm

__all__ = ["buoy", "case", "leg", "swarm"]
