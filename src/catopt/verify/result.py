"""What the comparison of the two models says, as values."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Literal

from catopt.catenary.solution import Solution
from catopt.fem import TrussSolution
from catopt.model import Case
from catopt.verify.compared import Compared

__all__ = ["LinePair", "Mesh", "StaticComparison", "Verdict", "Verification"]

Verdict = Literal["agrees", "differs", "no closed form"]


@dataclass(frozen=True)
class Mesh:
    """One solution of the truss model.

    Attributes
    ----------
    elements : int
        Bars of all lines.
    iterations : int
        Of Newton's method, from a straight start.
    residual : float
        Largest force left over at a node, over the largest tension.
    penetration : float
        Largest depth of a node below the bed, m.
    """

    elements: int
    iterations: int
    residual: float
    penetration: float


@dataclass(frozen=True)
class LinePair:
    """One line by both models: the closed form, if it has one, and the truss on its meshes."""

    closed: Solution | None
    trusses: tuple[TrussSolution, ...] = field(repr=False)

    @property
    def finest(self) -> TrussSolution:
        """The truss model on its finest mesh."""
        return self.trusses[-1]


@dataclass(frozen=True)
class StaticComparison:
    """Closed form and truss model at rest under one load.

    Attributes
    ----------
    name : str
        Of the load case.
    kind : {"line", "system"}
        One line, or a body moored by several.
    quantities : tuple of Compared
        Every one that both models know.
    meshes : tuple of Mesh
        From the coarsest.
    lines : tuple of LinePair
        Shapes and tensions.
    tolerance : float
        Allowed difference over each quantity's scale.
    refusal : str
        Why the closed form refuses; empty where it does not.
    remarks : tuple of str
        What to know before the verdict is used.
    """

    name: str
    kind: Literal["line", "system"]
    quantities: tuple[Compared, ...]
    meshes: tuple[Mesh, ...]
    lines: tuple[LinePair, ...]
    tolerance: float
    refusal: str = ""
    remarks: tuple[str, ...] = ()

    @property
    def worst(self) -> Compared:
        """The quantity with the largest gap over its tolerance."""
        return max(self.quantities, key=lambda each: each.gap / each.tolerance)

    @property
    def rough(self) -> tuple[Compared, ...]:
        """The quantities whose error does not fall smoothly: they are not extrapolated."""
        return tuple(each for each in self.quantities if not each.is_smooth)

    @property
    def is_settled(self) -> bool:
        """Whether every gap is within its tolerance."""
        return all(each.agrees for each in self.quantities)

    @property
    def verdict(self) -> Verdict:
        """Whether the two models agree."""
        if self.refusal:
            return "no closed form"
        return "agrees" if self.is_settled else "differs"

    @property
    def residual(self) -> float:
        """Largest force left over at a node of the finest mesh, over the largest tension."""
        return self.meshes[-1].residual

    def mesh_gap(self, mesh: int) -> float | None:
        """Largest difference over its scale on one mesh, from 0; None without a closed form."""
        gaps = [
            abs(each.fem[mesh] - each.closed_form) / each.scale
            for each in self.quantities
            if each.closed_form is not None
        ]
        return max(gaps, default=None)

    def of(self, quantity: str, line: int | None = None) -> Compared:
        """Look a quantity up.

        Parameters
        ----------
        quantity : str
            Such as ``"fairlead_tension"``.
        line : int, optional
            Of a system: which line, from 0.
        """
        return next(q for q in self.quantities if (q.quantity, q.line) == (quantity, line))


@dataclass(frozen=True)
class Verification:
    """A case by both models.

    Attributes
    ----------
    case : Case
        What was verified.
    parts : tuple of StaticComparison
        One a load case.
    """

    case: Case
    parts: tuple[StaticComparison, ...]

    @property
    def static(self) -> StaticComparison:
        """The load case in which the models agree least."""
        return max(self.parts, key=lambda part: part.worst.gap / part.worst.tolerance)

    @property
    def verdict(self) -> Verdict:
        """``"differs"`` where any load case does, ``"agrees"`` where all do."""
        verdicts = [part.verdict for part in self.parts]
        return next((v for v in ("differs", "no closed form") if v in verdicts), "agrees")

    @property
    def is_settled(self) -> bool:
        """Whether the models agree, or, without a closed form, the meshes do."""
        return all(part.is_settled for part in self.parts)

    def to_dict(self) -> dict[str, Any]:
        """Build the document that ``catopt verify --json`` prints (schema catopt.verify/1)."""
        from catopt.verify.document import verification_document

        return verification_document(self)
