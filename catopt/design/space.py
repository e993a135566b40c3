"""The design space: everything that a line may be made of, numbered by whole numbers.

A design is a row of genes, two for each segment (what it is made of, its length) and two for each
clump weight (its mass, its place), from the anchor up; of a whole mooring two more (its number of
lines, the radius of its anchors). Neighbouring values of a gene are alike:
sizes of a family, lengths, masses and places rise. Where a part may be absent, 0 of its first gene
says so, and its second gene does not matter: in the canonical form it is 0.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import accumulate

import numpy as np
from numpy.typing import NDArray

from catopt.design.problem import Genes
from catopt.model import Line, PointLoad, Segment
from catopt.words import Message

GENES_EACH = 2
"""Genes of a segment, and of a clump weight."""

AT_END = 1e-9
"""Part of the line's length next to its ends in which no clump weight can hang."""


class Variable:
    """What two genes stand for: what a part is made of, and its length or place."""

    is_optional: bool
    """Whether the part may be absent."""
    name: str
    """For tables."""

    @property
    def values(self) -> tuple[Sequence[object], Sequence[object]]:
        """What the part may be made of, and its lengths or places."""
        raise NotImplementedError

    @property
    def sizes(self) -> tuple[int, int]:
        """How many values its two genes have."""
        kinds, places = self.values
        return len(kinds) + self.is_optional, max(len(places), 1)

    @property
    def count(self) -> int:
        """How many different parts it may be, absent included."""
        kinds, places = self.sizes
        return (kinds - self.is_optional) * places + self.is_optional


@dataclass(frozen=True)
class SegmentVariable(Variable):
    """What one segment may be."""

    options: tuple[Segment, ...]  # what it may be made of, each with the first of the lengths
    lengths: tuple[float, ...]  # unstretched, m, rising
    is_optional: bool = False
    name: str = ""

    @property
    def values(self) -> tuple[Sequence[Segment], Sequence[float]]:
        """Options and lengths."""
        return self.options, self.lengths

    def segment(self, kind: int, length: int) -> Segment | None:
        """Return the segment of two genes; None where it is absent."""
        option = kind - self.is_optional
        return None if option < 0 else replace(self.options[option], length=self.lengths[length])


@dataclass(frozen=True)
class ClumpWeightVariable(Variable):
    """What one clump weight may be; it has positions, or hangs at a joint.

    The joint is the upper end of that segment, counted from 1 at the anchor, or where that would be
    when it is absent.
    """

    masses: tuple[float, ...]  # in air, kg, rising
    submerged_weights: tuple[float, ...]  # of those masses, N
    positions: tuple[float, ...] = ()  # unstretched arc length from the anchor, m, rising
    joint: int = 0  # 0 when it has positions
    is_optional: bool = False
    name: str = ""
    friction: float | None = None  # Coulomb coefficient on the bed; None: that of the bed

    @property
    def values(self) -> tuple[Sequence[float], Sequence[float]]:
        """Masses and positions."""
        return self.masses, self.positions


@dataclass(frozen=True)
class LayoutVariable(Variable):
    """How many lines a body may have, and how far away their anchors may be.

    By radii, or by the horizontal force in each line with the body at its origin, from which the
    distance of the anchors follows.
    """

    azimuths: tuple[tuple[float, ...], ...]  # of each number of lines, rad; more lines come later
    radii: tuple[float, ...]  # from the body's origin to the anchors, m, rising
    pretensions: tuple[float, ...] = ()  # N, rising
    is_optional: bool = False
    name: str = ""

    @property
    def values(self) -> tuple[Sequence[object], Sequence[float]]:
        """Azimuths, and radii or pretensions."""
        return self.azimuths, self.pretensions or self.radii


@dataclass(frozen=True)
class DesignSpace:
    """All designs: of one line by itself, or of several such lines about a body."""

    segments: tuple[SegmentVariable, ...]  # from the anchor up; one at least is always there
    clump_weights: tuple[ClumpWeightVariable, ...] = ()
    layout: LayoutVariable | None = None  # None for one line by itself

    @property
    def variables(self) -> tuple[SegmentVariable | ClumpWeightVariable | LayoutVariable, ...]:
        """Segments, clump weights and layout, in the order of their genes."""
        layout = () if self.layout is None else (self.layout,)
        return (*self.segments, *self.clump_weights, *layout)

    @property
    def sizes(self) -> tuple[int, ...]:
        """How many values each gene has."""
        return tuple(size for variable in self.variables for size in variable.sizes)

    @property
    def count(self) -> int:
        """How many designs there are in canonical form.

        Those with a clump weight beyond the end of the line count too; they are never feasible.
        """
        return math.prod(variable.count for variable in self.variables)

    def canonical(self, genes: Genes) -> Genes:
        """Set the second gene of each absent part to 0, in a copy."""
        result = np.array(genes, dtype=np.int64)
        for index, variable in enumerate(self.variables):
            if variable.is_optional:
                first = GENES_EACH * index
                result[result[:, first] == 0, first + 1] = 0
        return result

    def genes_between(self, first: int, end: int) -> Genes:
        """Genes of the designs number `first` to `end` (not included); see `genes_of`."""
        return self.genes_of(np.arange(first, end, dtype=np.int64))

    def genes_of(self, numbers: NDArray[np.int64]) -> Genes:
        """Genes of designs by their number, in canonical form.

        Every design of the space has one number from 0 to below `count`; the last variable changes
        fastest.
        """
        left = numbers
        genes = np.zeros((left.size, len(self.sizes)), dtype=np.int64)
        for index in reversed(range(len(self.variables))):
            variable = self.variables[index]
            left, own = np.divmod(left, variable.count)
            if variable.is_optional:
                # 0 is absent; the rest counts through what it is made of, with each of its places.
                own = own - 1
            kind, place = np.divmod(own, variable.sizes[1])
            is_absent = own < 0
            genes[:, GENES_EACH * index] = np.where(is_absent, 0, kind + variable.is_optional)
            genes[:, GENES_EACH * index + 1] = np.where(is_absent, 0, place)
        return genes

    def flaw(self, genes: tuple[int, ...]) -> str:
        """Say why a design is none: a clump weight hangs at or beyond an end; else empty."""
        lengths = self._lengths(genes)
        total = sum(lengths)
        for number, (variable, position, _) in enumerate(self._hung(genes, lengths), start=1):
            if not AT_END * total < position <= (1.0 - AT_END) * total:
                name = variable.name or Message("design.clump_weight", number=number)
                values = {"part": name, "position": position, "total": total}
                return Message("design.beyond_the_line", **values)
        return ""

    def line(self, genes: tuple[int, ...]) -> Line:
        """Build the line of a design; InputError when it has a flaw."""
        loads = [
            PointLoad(
                position,
                variable.submerged_weights[mass],
                variable.masses[mass],
                variable.name,
                variable.friction,
            )
            for variable, position, mass in self._hung(genes, self._lengths(genes))
        ]
        return Line([segment for segment in self._segments(genes) if segment is not None], loads)

    def _segments(self, genes: tuple[int, ...]) -> list[Segment | None]:
        """Return each segment, None where it is absent."""
        pairs = zip(genes[::GENES_EACH], genes[1::GENES_EACH], strict=True)
        return [each.segment(*pair) for each, pair in zip(self.segments, pairs, strict=False)]

    def _lengths(self, genes: tuple[int, ...]) -> list[float]:
        """Length of each segment, 0 where it is absent, m."""
        return [0.0 if each is None else each.length for each in self._segments(genes)]

    def _hung(
        self, genes: tuple[int, ...], lengths: list[float]
    ) -> list[tuple[ClumpWeightVariable, float, int]]:
        """List the clump weights that are there: which, its arc length (m), the index of its mass.

        A joint is where segments have been summed to, one after the other, as the kernel does.
        """
        joints = list(accumulate(lengths))
        hung = []
        for index, variable in enumerate(self.clump_weights, start=len(self.segments)):
            kind, place = genes[GENES_EACH * index : GENES_EACH * (index + 1)]
            mass = kind - variable.is_optional
            if mass >= 0:
                at_joint = variable.joint > 0
                position = joints[variable.joint - 1] if at_joint else variable.positions[place]
                hung.append((variable, position, mass))
        return hung
