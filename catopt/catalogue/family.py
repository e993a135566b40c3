"""A family of components: one kind of chain or rope in its grades and sizes."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from catopt.catalogue.figure import RECALLED, Confidence, Figure, Source
from catopt.words import Message


def in_mm(diameter: float) -> str:
    """Write a diameter in m as makers do: ``76 mm``."""
    return f"{round(diameter * 1e3, 6):g} mm"


@dataclass(frozen=True)
class Sizes:
    """Nominal diameters that are sold.

    A list of sizes is no figure of strength, so that a recalled one is used, and says so.
    """

    diameters: tuple[float, ...] = ()
    """m, rising; none when the list is not known."""
    sources: tuple[Source, ...] = ()
    """Documents that list them, at `place`."""
    place: str = ""
    confidence: Confidence = RECALLED

    @property
    def is_recalled(self) -> bool:
        """Whether the list was read in no document."""
        return self.confidence == RECALLED


@dataclass(frozen=True)
class Family:
    """One kind of chain or rope: the name by which it is looked up, and its title in words."""

    name: str
    title: str
    also: tuple[str, ...]
    """Other names for it."""
    grades: tuple[str, ...]
    """From the weakest to the strongest; empty when there are none."""
    range: tuple[float, float]
    """Smallest and largest nominal diameter, m."""
    sizes: Sizes
    figures: tuple[Figure, ...]
    """All figures, in the order of the file."""
    note: str = ""
    """What else to know."""
    _by_quantity: dict[str, list[Figure]] = field(
        default_factory=dict, init=False, repr=False, compare=False
    )

    def __post_init__(self) -> None:
        for figure in sorted(self.figures, key=lambda figure: not figure.default):
            self._by_quantity.setdefault(figure.quantity, []).append(figure)

    def alternatives(self, quantity: str, grade: str | None) -> tuple[Figure, ...]:
        """List the figures of a quantity that hold for a grade, the default first."""
        return tuple(f for f in self._by_quantity.get(quantity, ()) if f.holds_for(grade))

    def default(self, quantity: str, grade: str | None) -> Figure | None:
        """Find the figure that is used when no variant is named; None when there is none."""
        return next((f for f in self.alternatives(quantity, grade) if f.default), None)

    @property
    def names(self) -> Iterator[str]:
        """Its name and its other names."""
        yield self.name
        yield from self.also

    @property
    def known_range(self) -> Message:
        """The range in words: ``from 19 mm to 185 mm``."""
        return Message("catalogue.from_to", low=in_mm(self.range[0]), high=in_mm(self.range[1]))
