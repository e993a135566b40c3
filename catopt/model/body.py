"""The body that lines moor, where it moves under forces: its inertia, and what pushes it."""

from __future__ import annotations

from dataclasses import dataclass

from catopt.model.validity import Findings


@dataclass(frozen=True)
class Body:
    """A body that moves along x and y, held in height and in the yaw that it has at rest.

    The mean of the forces is that of the system; what is here comes on top of it.

    Attributes
    ----------
    mass : float
        kg.
    added_mass : float
        Of the water that moves with it, along x and y alike, kg.
    damping : float
        Force per speed, along x and y alike, N s/m.
    force_file : str
        Path of a CSV file with the forces over time; empty when not used.
    wave_force : tuple of float
        Force along x and y per height of the waves' surface over still water at the body, N/m;
        empty for none.
    """

    mass: float
    added_mass: float = 0.0
    damping: float = 0.0
    force_file: str = ""
    wave_force: tuple[float, ...] = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "wave_force", tuple(self.wave_force))
        found = Findings("Body", self)
        found.number("mass", self.mass, "kg", above=0.0)
        found.number("added_mass", self.added_mass, "kg", at_least=0.0)
        found.number("damping", self.damping, "N s/m", at_least=0.0)
        if len(self.wave_force) not in {0, 2}:
            found.add("wave_force", f"{len(self.wave_force)} numbers", "2 are wanted")
        for value in self.wave_force:
            found.number("wave_force", value, "N/m")
        found.raise_if_any()
