"""Verify every design of a front, each in the load case that governs it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from catopt.errors import NoAnswerError, NotConvergedError
from catopt.model import Case
from catopt.verify.case import verify_case
from catopt.verify.result import Verification
from catopt.verify.settings import ELEMENTS, TOLERANCE


@dataclass(frozen=True)
class Design:
    """One design of a front.

    `number`: counted from 1, as in the tables of the front; `case`: of this design; `load_case`:
    name of the load case that governs it; None: all of them.
    """

    number: int
    case: Case
    load_case: str | None = None


@dataclass(frozen=True)
class DesignVerification:
    """What came of one design.

    `design`: which; `verification`: None where a model gave no answer; `failure`: why there is
    none; empty where there is one; `did_not_converge`: whether that was a solver that stopped
    short.
    """

    design: Design
    verification: Verification | None
    failure: str = ""
    did_not_converge: bool = False


@dataclass(frozen=True)
class FrontVerification:
    """A front by both models.

    `title`: of the search; `designs`: in the order of the front.
    """

    title: str
    designs: tuple[DesignVerification, ...]

    @property
    def verified(self) -> tuple[Verification, ...]:
        """Of the designs that both models answered for."""
        found = [design.verification for design in self.designs]
        return tuple(each for each in found if each is not None)

    @property
    def is_settled(self) -> bool:
        """Whether every design has an answer and the models agree on it."""
        count = len(self.verified)
        return count == len(self.designs) and all(each.is_settled for each in self.verified)

    @property
    def has_converged(self) -> bool:
        """Whether no solver stopped short."""
        return not any(design.did_not_converge for design in self.designs)

    def to_dict(self) -> dict[str, Any]:
        """Build the document that ``catopt verify DIR --all --json`` prints."""
        from catopt.verify.document import front_document

        return front_document(self)


def verify_front(
    title: str,
    designs: Sequence[Design],
    *,
    elements: int = ELEMENTS,
    tolerance: float = TOLERANCE,
    progress: Callable[[int, int], None] | None = None,
) -> FrontVerification:
    """Verify designs one after the other; one that fails does not stop the others."""
    found = []
    for done, design in enumerate(designs):
        if progress is not None:
            progress(done, len(designs))
        found.append(_verified(design, elements, tolerance))
    return FrontVerification(title, tuple(found))


def _verified(design: Design, elements: int, tolerance: float) -> DesignVerification:
    try:
        verification = verify_case(
            design.case, load_case=design.load_case, elements=elements, tolerance=tolerance
        )
    except (NoAnswerError, NotConvergedError) as error:
        stopped = isinstance(error, NotConvergedError)
        return DesignVerification(design, None, error.message, stopped)
    return DesignVerification(design, verification)
