"""Verify a case by both models in each of its load cases, or every design of a front."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import nullcontext
from dataclasses import dataclass
from typing import Any, Literal

from catopt.catenary.case import as_found, solve_case
from catopt.catenary.solution import check_buoys, named_line
from catopt.errors import InputError, NoAnswerError, NotConvergedError, refused
from catopt.model import Case
from catopt.model.network import Network
from catopt.patience import paced
from catopt.records import Counted, Record
from catopt.units import as_written
from catopt.verify.convergence_check import ELEMENTS, TOLERANCE, check_settings
from catopt.verify.line import verify_line, verify_system
from catopt.verify.network import verify_network
from catopt.verify.result import (
    SCHEMA,
    VERDICTS,
    StaticComparison,
    Verdict,
    Verification,
    least_agreeing,
)
from catopt.words import Message

LOAD = "load"
"""Name of the load case of a case that has only its ``[load]``."""

Progress = Callable[[int, int], None]


def verify_case(
    case: Case | Network,
    *,
    load_case: str | None = None,
    elements: int = ELEMENTS,
    tolerance: float = TOLERANCE,
    progress: Progress | None = None,
) -> Verification:
    """Solve a case by the closed form and by the truss model, and compare them.

    The truss model shares nothing with the closed form but the line it is given. It is solved on
    three meshes, of which each has twice the bars of the one before; their values are extrapolated
    where they close up with the square of the bar length.

    Parameters
    ----------
    case : Case or Network
        As read by `catopt.read_case`; with a system, the body and all its lines; of points, lines
        and bodies all of them.
    load_case : str, optional
        Name of one load case; all of them when left out, or the load where there are none.
    elements : int
        Bars of a line on the coarsest mesh.
    tolerance : float
        Largest difference that counts as agreement: of the fairlead tension for forces, of the
        line's length for lengths, in rad for angles (docs/verify.md).
    progress : callable, optional
        Told how many load cases are done and how many there are.

    Returns
    -------
    Verification
        With a verdict for each load case.

    Raises
    ------
    InputError
        When a setting is out of range, or no load case has that name.
    NoEquilibriumError, FloatsUpError
        When there is no equilibrium, or a buoy would float above the water surface.
    NotConvergedError
        When one of the models stopped short of its tolerance.

    Examples
    --------
    >>> from catopt import read_case, verify_case
    >>> found = verify_case(read_case("cases/buoy-9.5m/case.toml"))
    >>> found.verdict
    'agrees'
    >>> round(found.static.of("span").order, 2)
    2.0
    """
    check_settings(elements, tolerance, source="verify_case")
    if isinstance(case, Network):
        if load_case is not None:
            raise _no_load_cases(load_case)
        part = verify_network(case, elements=elements, tolerance=tolerance, name=LOAD)
        return Verification(case, (part,))
    case.site.check_level()
    case.check_still_water()
    states = load_states(case, load_case)
    parts = []
    steps = paced(Message("words.load_cases", total=len(states)), states)
    for done, (name, state) in enumerate(steps):
        if progress is not None:
            progress(done, len(states))
        assert isinstance(state, Case)
        parts.append(_verified(name, state, elements, tolerance))
    return Verification(case, tuple(parts))


def load_states(case: Case | Network, wanted: str | None) -> list[tuple[str, Case | Network]]:
    """Name every state of a case that is to be verified, with the case under its load.

    `wanted`: name of one load case; None: all of them, or the load where there are none. Raises
    InputError when no load case has that name.
    """
    states: dict[str, Case | Network] = {LOAD: case}
    if isinstance(case, Case):
        found = as_found(case)
        states = {each.name: found.under(each) for each in case.load_cases} or {LOAD: found}
    if wanted is None:
        return list(states.items())
    if wanted not in {state.name for state in case.load_cases}:
        names = ", ".join(state.name for state in case.load_cases)
        raise _no_load_cases(wanted, names)
    return [(wanted, states[wanted])]


def _no_load_cases(wanted: str, names: str = "") -> InputError:
    none = Message("refused_command.case_has_no_load_cases")
    allowed = Message("refused.one_of", words=names) if names else none
    return refused("--load-case", as_written(wanted), allowed, "options")


def _verified(name: str, case: Case, elements: int, tolerance: float) -> StaticComparison:
    if case.system is not None:
        part = verify_system(case.system, elements=elements, tolerance=tolerance, name=name)
    else:
        case = as_found(case)
        closed = solve_case(case)
        part = verify_line(case, closed, elements=elements, tolerance=tolerance, name=name)
    # Refuse buoys above the water surface by the truss model, which has every line.
    for number, pair in enumerate(part.lines, start=1):
        mesh = pair.finest.mesh
        heights = pair.finest.nodes[mesh.load_node, 2].tolist()
        with nullcontext() if part.kind == "line" else named_line(number):
            check_buoys(mesh.line, heights, case.site.water_depth)
    return part


# ------------------------------------------------------------------ a front


@dataclass(frozen=True)
class Design:
    """One design of a front.

    `case`: of this design; `load_case`: name of the load case that governs it; None: all of them.
    """

    number: Counted
    """Its number on the front, as in its tables."""
    case: Case
    load_case: str | None = None


@dataclass(frozen=True)
class DesignVerification(Record):
    """What came of one design."""

    DOCUMENT = "design.number=design verdict failure load_cases"

    design: Design
    verification: Verification | None
    """None where a model gave no answer."""
    failure: str = ""
    """Why there is no answer; empty where there is one."""
    did_not_converge: bool = False
    """Whether that was a solver that stopped short."""

    @property
    def verdict(self) -> Verdict | Literal["no answer"]:
        """Of all that was verified."""
        return "no answer" if self.verification is None else self.verification.verdict

    @property
    def load_cases(self) -> tuple[StaticComparison, ...]:
        """As of a case; empty without an answer."""
        return () if self.verification is None else self.verification.parts


@dataclass(frozen=True)
class FrontVerification(Record):
    """A front by both models."""

    SCHEMA = SCHEMA
    DOCUMENT = "title verdict static designs"

    title: str
    """Title of the search."""
    designs: tuple[DesignVerification, ...]
    """Of a front: every design, in its governing load case."""

    @property
    def verified(self) -> tuple[Verification, ...]:
        """Of the designs that both models answered for."""
        found = [design.verification for design in self.designs]
        return tuple(each for each in found if each is not None)

    @property
    def static(self) -> StaticComparison | None:
        """Of the design on which the models agree least; None where there is no answer."""
        parts = [each.static for each in self.verified]
        return least_agreeing(parts) if parts else None

    @property
    def verdict(self) -> Verdict | Literal["no answer"]:
        """The one of a design that outweighs the others; ``"no answer"`` where one has none."""
        verdicts = [each.verdict for each in self.verified]
        if len(verdicts) < len(self.designs):
            return "no answer"
        return next(each for each in VERDICTS if each in verdicts)

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
        return super().to_dict() | {"dynamic": None}


def verify_front(
    title: str,
    designs: Sequence[Design],
    *,
    elements: int = ELEMENTS,
    tolerance: float = TOLERANCE,
    progress: Progress | None = None,
) -> FrontVerification:
    """Verify designs one after the other; one that fails does not stop the others."""
    found = []
    steps = paced(Message("words.designs", total=len(designs)), designs)
    for done, design in enumerate(steps):
        if progress is not None:
            progress(done, len(designs))
        try:
            verification = verify_case(
                design.case, load_case=design.load_case, elements=elements, tolerance=tolerance
            )
            found.append(DesignVerification(design, verification))
        except (NoAnswerError, NotConvergedError) as error:
            stopped = isinstance(error, NotConvergedError)
            found.append(DesignVerification(design, None, error.message, stopped))
    return FrontVerification(title, tuple(found))
