"""What a check says: demand, capacity, utilisation and where the criterion comes from."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from catopt.catenary.solution import Solution
from catopt.checks.criterion import CheckSource, Place
from catopt.checks.excess import ROUNDING
from catopt.documents import figures
from catopt.model import LoadCase
from catopt.shown import Shown
from catopt.ties import largest
from catopt.words import Message

__all__ = ["CheckReport", "CheckResult", "CheckSource", "line_in_state"]


def line_in_state(number: int, state: str) -> Message:
    """Say of which line of a body something is, and in which state: ``"line 2, intact"``."""
    line = Message("checks.line_number", number=number)
    return Message("checks.of_line", line=line, name=state)


@dataclass(frozen=True)
class CheckResult:
    """One criterion in one load case."""

    name: str
    """What is checked, with the place: ``"tension, segment 2 (chain studless R3 76 mm)"``."""
    kind: str
    """Key of the criterion: ``tension``, ``uplift_angle``, ``uplift_force``, ``grounded_length``,
    ``span``, ``buoyancy``, ``sliding``, ``holding`` or ``equilibrium``."""
    load_case: str
    """Name of the load case; of a body with several lines, that of its state."""
    demand: float
    capacity: float
    """SI; of a least grounded length the demand is what is wanted, the capacity what lies there."""
    unit: str
    """SI unit of both."""
    excess: float
    """By how much the limit is overrun (`catopt.checks.excess`); the check is passed when it is at
    most ROUNDING."""
    source: CheckSource
    note: str = ""
    """What went into the capacity: factor, strength, diameter at the end of life."""
    place: Place = field(default_factory=Place)

    @property
    def utilisation(self) -> float | None:
        """Demand over capacity; None where the capacity is 0 or less."""
        return self.demand / self.capacity if self.capacity > 0.0 else None

    def to_dict(self) -> dict[str, Any]:
        """Lay it out, in SI, as the documents of ``catopt check`` and ``catopt design`` have it."""
        keys = "name kind load_case demand capacity unit utilisation excess passes"
        return figures(self, keys) | {
            "source": self.source.text,
            "code": self.source.code,
            "confidence": self.source.confidence,
            "note": self.note,
        }

    def to_dict_of_body(self) -> dict[str, Any]:
        """Lay it out with state and line, as documents of moored bodies have it."""
        return self.to_dict() | _place(self.place)

    @property
    def in_case(self) -> Message:
        """Its name with that of the load case: ``"tension, segment 1 (storm)"``."""
        return Message("checks.in_case", check=self.name, load_case=self.where)

    @property
    def where(self) -> str:
        """Its load case; of a line of a body its number and the state: ``"line 2, intact"``."""
        number = self.place.line
        return self.load_case if number is None else line_in_state(number, self.load_case)

    @property
    def passes(self) -> bool:
        """Whether the limit is kept."""
        return self.excess <= ROUNDING


@dataclass(frozen=True, repr=False)
class CheckReport(Shown):
    """All checks of a line under all its load cases, or of a body with lines in all its states."""

    title: str
    results: tuple[CheckResult, ...]
    """By load case, then by line and by check."""
    solutions: tuple[tuple[str, Solution], ...]
    """The equilibrium in each load case, by its name; of a body, of each line in each state."""
    warnings: tuple[str, ...] = ()
    """What an engineer should know: notes of the codes, recalled criteria, no check at all."""
    load_cases: tuple[LoadCase, ...] = ()
    """Those of the case, in the order of `solutions`; empty when its load alone was checked."""
    places: tuple[Place, ...] = ()
    """Of a body: line and state of each of the `solutions`."""
    is_doubted: bool = False
    """Whether the demands are in doubt: of a run in time that was stopped or did not converge."""

    @property
    def passes(self) -> bool:
        """Whether every check is passed."""
        return all(result.passes for result in self.results)

    @property
    def verdict(self) -> bool | None:
        """Whether every check is passed; None where there is none, or all are but in doubt."""
        if not self.results or (self.passes and self.is_doubted):
            return None
        return self.passes

    @property
    def governing(self) -> CheckResult | None:
        """The failed check that is furthest beyond its limit, else the one nearest to it.

        Nearness is the utilisation: of a limit of 0 that is just kept, such as no uplift, nothing
        can be said, so that it governs only where there is no other check. None without checks.
        """
        if self.failed:
            return self.failed[0]
        if not self.results:
            return None
        return largest(self.results, lambda result: result.utilisation or 0.0, ROUNDING)

    @property
    def failed(self) -> tuple[CheckResult, ...]:
        """The checks that are failed, the worst first; those alike as they come."""
        failed = [result for result in self.results if not result.passes]
        return tuple(sorted(failed, key=lambda result: -round(result.excess, 9)))

    def tightest(self, kind: str) -> CheckResult | None:
        """Return the check of a kind nearest to its limit, over segments and load cases."""
        made = [result for result in self.results if result.kind == kind]
        return largest(made, lambda result: result.excess, ROUNDING) if made else None

    @property
    def tightest_by_state(self) -> tuple[int, ...]:
        """Which results are nearest to their limit, by state, kind and criterion, from 0."""
        found: dict[tuple[object, ...], int] = {}
        for index, each in enumerate(self.results):
            key = (each.place.state, each.kind, each.source)
            best = found.setdefault(key, index)
            if each.excess > self.results[best].excess + ROUNDING:
                found[key] = index
        return tuple(sorted(found.values()))

    def used(self, *, line: int | None = None, missing: int | None = None) -> float | None:
        """Return the largest utilisation of a tension; None where none is limited.

        `line`: of one line of a body, from 1; of any when left out; `missing`: the line that is
        gone, from 1; with all there when left out.
        """
        known = [
            each.demand / each.capacity
            for each in self.results
            if each.kind == "tension"
            and each.place.missing == missing
            and line in (None, each.place.line)
        ]
        return max(known, default=None)

    @property
    def _governing_index(self) -> int | None:
        return None if self.governing is None else self.results.index(self.governing)

    def to_dict(self) -> dict[str, Any]:
        """Build the document that ``catopt check --json`` prints (schema catopt.check/1)."""
        places = self.places or (None,) * len(self.solutions)
        load_cases = self.load_cases or (None,) * len(self.solutions)
        return {
            "schema": "catopt.check/1",
            "title": self.title,
            "passes": self.passes,
            "governing": self._governing_index,
            "load_cases": [
                _load_case(name, solution, of) | ({} if place is None else _place(place))
                for (name, solution), of, place in zip(
                    self.solutions, load_cases, places, strict=True
                )
            ],
            "checks": [
                each.to_dict_of_body() if self.places else each.to_dict() for each in self.results
            ],
            "warnings": list(self.warnings),
        }

    def motion_document(self) -> dict[str, Any]:
        """Build the checks of lines in motion as ``catopt verify --dynamic --json`` has them."""
        return {
            "passes": self.verdict,
            "governing": self._governing_index,
            "checks": [each.to_dict_of_body() for each in self.results],
            "warnings": list(self.warnings),
        }

    def verdict_document(self) -> dict[str, Any]:
        """Build the verdict of a body as ``catopt system --json`` has it."""
        found = self.governing
        return {
            "checks": len(self.results),
            "failed": len(self.failed),
            "passes": self.passes,
            "governing": None if found is None else found.to_dict_of_body(),
            "warnings": list(self.warnings),
        }


def _place(place: Place) -> dict[str, Any]:
    return {"state": place.state, "line": place.line, "missing_line": place.missing}


def _load_case(name: str, solution: Solution, state: LoadCase | None) -> dict[str, Any]:
    return {
        "name": name,
        "kind": "extreme" if state is None else state.kind,
        "water_level_m": 0.0 if state is None else state.water_level,
        **figures(solution, "horizontal_force_N fairlead_height_m span_m"),
        "fairlead_tension_N": solution.fairlead.tension,
        "anchor_horizontal_force_N": solution.anchor.horizontal_force,
        "anchor_vertical_force_N": solution.anchor.vertical_force,
        "anchor_angle_rad": solution.anchor.angle,
        "grounded_length_m": solution.grounded_length,
    }
