"""Fatigue: cycles of a tension by rainflow counting, T-N and S-N curves, and Miner's sum."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Final, Literal

import numpy as np
import numpy.typing as npt

from catopt.catalogue.figure import Confidence
from catopt.checks.criterion import CheckSource, LineKind, line_kind
from catopt.checks.spectral_fatigue import Band, bands, range_moment
from catopt.checks.strength import strength_of
from catopt.constants import YEAR
from catopt.errors import InputError, Problem, need_package
from catopt.model import Case, CatalogueChoice, Segment, SegmentCurve, Service
from catopt.words import Message

Array = npt.NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Cycles:
    """Cycles of one series.

    Attributes
    ----------
    ranges, counts : ndarray
        Each range, and 1 for a whole cycle or 0.5 for half of one.
    mean : float
        Of the series.
    time : float
        That it lasts, s.
    bands : tuple of Band or None
        The series' slow and fast parts; None where it was not parted.
    """

    ranges: Array
    counts: Array
    mean: float
    time: float
    bands: tuple[Band, Band] | None = None


def count_cycles(values: Array, time: float, split: float | None = None) -> Cycles:
    """Count the cycles of a series by rainflow, ASTM E1049; what is left over counts half.

    The time is that which the series lasts, s; by `split` (rad/s) its spectrum is parted, too.
    Refused when the package rainflow is missing.

    Examples
    --------
    >>> import numpy as np
    >>> found = count_cycles(np.array([-2.0, 1, -3, 5, -1, 3, -4, 4, -2]), 1.0)
    >>> {size: found.counts[found.ranges == size].sum() for size in (3.0, 4.0, 6.0, 8.0, 9.0)}
    {3.0: 0.5, 4.0: 1.5, 6.0: 0.5, 8.0: 1.0, 9.0: 0.5}
    """
    need_rainflow()
    from rainflow import extract_cycles

    found = np.array([cycle[:3:2] for cycle in extract_cycles(values.tolist())]).reshape(-1, 2)
    parted = None if split is None else bands(values, time, split)
    return Cycles(found[:, 0], found[:, 1], float(values.mean()), time, parted)


def need_rainflow() -> None:
    """Refuse to count where the package rainflow is missing.

    Raises
    ------
    InputError
        With how to install it.
    """
    need_package("rainflow", "fatigue", "fatigue")


@dataclass(frozen=True)
class FatigueCurve:
    """Cycles to failure N over a range.

    Attributes
    ----------
    kind : {"S-N", "T-N"}
        N = factor s^-slope with the stress range s in MPa, or N = factor R^-slope with R the
        tension range over the reference strength.
    factor, slope : float
        a_D and m, or K and M.
    per_mean : float
        log10 of the factor falls by so much times the mean tension over the reference strength.
    source : CheckSource
        Where it comes from.
    line : {"chain", "wire", "rope"} or None
        For which kind of line; None: any.
    ORQ : bool
        Whether the reference is the strength of ORQ chain of the same size, whatever its grade.
    """

    kind: Literal["S-N", "T-N"]
    factor: float
    slope: float
    source: CheckSource
    line: LineKind | None = None
    per_mean: float = 0.0
    ORQ: bool = False

    def damage(self, cycles: Cycles, reference: float) -> float:
        """Miner's sum of n/N.

        Parameters
        ----------
        cycles : Cycles
            Of a tension, N.
        reference : float
            Area in m2 of an S-N curve, strength in N of a T-N curve.
        """
        over, log = self._scales(cycles, reference)
        return float(np.sum(cycles.counts * (cycles.ranges / over) ** self.slope) / 10.0**log)

    def damage_by_spectrum(self, cycles: Cycles, reference: float) -> float | None:
        """Miner's sum by dual narrow band, parameters as of `damage`; None without bands."""
        if cycles.bands is None:
            return None
        over, log = self._scales(cycles, reference)
        slow, fast = (Band(each.variance / over**2, each.rate) for each in cycles.bands)
        return cycles.time * range_moment(slow, fast, self.slope) / float(10.0**log)

    def _scales(self, cycles: Cycles, reference: float) -> tuple[float, float]:
        """Give what ranges are over, and the logarithm of the factor at the mean."""
        if self.kind == "T-N":
            fall = self.per_mean * cycles.mean / reference
            return reference, math.log10(self.factor) - fall
        return 1e6 * reference, math.log10(self.factor)


def _source(name: str, document: str, clause: str, confidence: Confidence) -> CheckSource:
    return CheckSource(name, document, clause, confidence)


_E301 = ("DNV-OS-E301 (2008)", "Table F1")
_API = ("API RP 2SK 3rd ed. (2005)", "Table 3")


def _E(name: str, factor: float, slope: float, line: LineKind) -> FatigueCurve:
    return FatigueCurve("S-N", factor, slope, _source(name, *_E301, "B"), line)


def _A(
    name: str, log: float, slope: float, line: LineKind, confidence: Confidence, fall: float = 0.0
) -> FatigueCurve:
    source = _source(name, *_API, confidence)
    return FatigueCurve("T-N", 10.0**log, slope, source, line, fall, ORQ=line == "chain")


CURVES: Mapping[str, FatigueCurve] = MappingProxyType(
    {
        "E301 stud": _E("E301 stud", 1.2e11, 3.0, "chain"),
        "E301 studless": _E("E301 studless", 6.0e10, 3.0, "chain"),
        "E301 six-strand": _E("E301 six-strand", 3.4e14, 4.0, "wire"),
        "E301 spiral": _E("E301 spiral", 1.7e17, 4.8, "wire"),
        "E301 polyester": FatigueCurve(
            "T-N", 0.259, 13.46, _source("E301 polyester", *_E301, "B"), "rope"
        ),
        "API stud": _A("API stud", 3.0, 3.0, "chain", "C"),
        "API studless": _A("API studless", math.log10(316.0), 3.0, "chain", "B"),
        "API six-strand": _A("API six-strand", 3.20, 4.09, "wire", "C", 2.79),
        "API spiral": _A("API spiral", 3.25, 5.05, "wire", "C", 3.43),
    }
)
"""Curves by name; docs/dynamics.md has the table with its sources."""

_OF_COMPONENT: Final = (
    ("chain stud-link", "stud"),
    ("chain studless", "studless"),
    ("wire 6-strand", "six-strand"),
    ("wire spiral-strand", "spiral"),
    ("polyester 8-strand", ""),
    ("polyester", "polyester"),
)
"""What curves are called by how the names of components begin."""

_OF_CODE: Final = {"DNV-OS-E301-2008": "E301", "API-RP-2SK": "API"}


@dataclass(frozen=True)
class FatigueStrength:
    """What a segment withstands, at half its loss of diameter.

    Attributes
    ----------
    curve : FatigueCurve
        Its curve.
    reference : float
        Area in m2, or strength in N.
    diameter : float or None
        Nominal, less half the loss, m.
    """

    curve: FatigueCurve
    reference: float
    diameter: float | None

    def damage(self, runs: Iterable[Cycles]) -> float:
        """Damage in a year of nothing but what the runs are of.

        Parameters
        ----------
        runs : iterable of Cycles
            Of a tension, each of its own seed.
        """
        every = list(runs)
        time = sum(each.time for each in every)
        return sum(self.curve.damage(each, self.reference) for each in every) * YEAR / time

    def damage_by_spectrum(self, runs: Iterable[Cycles]) -> float | None:
        """Give the same by dual narrow band; None where a run's spectrum was not parted."""
        every = list(runs)
        found = [self.curve.damage_by_spectrum(each, self.reference) for each in every]
        known = [each for each in found if each is not None]
        if len(known) < len(every):
            return None
        return sum(known) * YEAR / sum(each.time for each in every)


def fatigue_strengths(case: Case) -> tuple[FatigueStrength, ...]:
    """Find the curve of every segment and its reference at half the loss of diameter.

    Raises
    ------
    InputError
        For every segment without a curve, a diameter or a strength.
    """
    found: list[FatigueStrength] = []
    problems: list[Problem] = []
    for index, segment in enumerate(case.line.segments):
        try:
            curve = _curve(case, segment, index)
            found.append(_strength(curve, segment, case.service, case.catalogue, index))
        except InputError as error:
            problems += error.problems
    if problems:
        raise InputError(problems, "fatigue")
    return tuple(found)


def _curve(case: Case, segment: Segment, index: int) -> FatigueCurve:
    fatigue = case.fatigue
    assert fatigue is not None
    given = {each.segment: each for each in fatigue.curves}
    own = given.get(index + 1, given.get(None))
    kind = line_kind(segment.component)
    if own is not None:
        curve = CURVES[own.name] if own.name else _given(own)
        if curve.line is not None and kind is not None and curve.line != kind:
            allowed = f"is for {curve.line}, and the segment is {segment.component}"
            key = f"fatigue.curves[{fatigue.curves.index(own)}].name"
            raise InputError([Problem(key, own.name, allowed)])
        return replace(curve, line=kind or curve.line)
    of = next((name for start, name in _OF_COMPONENT if segment.component.startswith(start)), "")
    name = f"{_OF_CODE[fatigue.code]} {of}" if fatigue.code else ""
    if name not in CURVES:
        what = f"{fatigue.code or 'no code'} has no curve for it: give one by [[fatigue.curves]]"
        found = segment.component or "no component"
        raise InputError([Problem(f"line.segments[{index}]", found, what)])
    return CURVES[name]


def _given(own: SegmentCurve) -> FatigueCurve:
    if own.log_a_D is not None and own.m is not None:
        return FatigueCurve("S-N", 10.0**own.log_a_D, own.m, CheckSource("user"))
    assert own.K is not None
    assert own.M is not None
    return FatigueCurve("T-N", own.K, own.M, CheckSource("user"))


def _strength(
    curve: FatigueCurve,
    segment: Segment,
    service: Service | None,
    catalogue: CatalogueChoice,
    index: int,
) -> FatigueStrength:
    """Put the diameter less half the loss into the area, or into the strength."""
    key = f"line.segments[{index}]"
    half = None if service is None else replace(service, life=0.5 * service.life)
    strength = strength_of(segment, half, catalogue, key=key)
    diameter = strength.end_diameter
    if curve.kind == "T-N" and not curve.ORQ:
        return FatigueStrength(curve, strength.need("MBL", key, curve.kind), diameter)
    if diameter is None:
        raise InputError([Problem(f"{key}.diameter", "", "missing; the curve needs it")])
    if curve.ORQ:
        from catopt.catalogue import component

        MBL = component("chain stud-link ORQ", diameter).MBL
        assert MBL is not None
        return FatigueStrength(curve, MBL, diameter)
    if curve.line is None:
        allowed = "missing; the area of a stress is that of a chain's two legs or of a rope"
        raise InputError([Problem(f"{key}.component", "", allowed)])
    legs = 2.0 if curve.line == "chain" else 1.0
    return FatigueStrength(curve, legs * math.pi / 4.0 * diameter**2, diameter)


_FACTORS: Mapping[str, tuple[float, float, Confidence, str]] = MappingProxyType(
    {
        "DNV-OS-E301-2008": (8.0, 60.0, "C", _E301[0]),
        "API-RP-2SK": (3.0, 3.0, "R", _API[0]),
    }
)
"""Factor on the damage of chain and wire, of polyester, its grade and its document. E301's is that
of adjacent lines of equal damage, the largest: 5 where theirs is at most 0.8 of it, 3 where
inspected ashore."""


def design_factor(case: Case, curve: FatigueCurve) -> tuple[float, CheckSource]:
    """Return the factor on the damage of a segment, and where it comes from.

    Raises
    ------
    InputError
        It was read in no document and not allowed.
    """
    fatigue = case.fatigue
    assert fatigue is not None
    if fatigue.design_factor is not None:
        return fatigue.design_factor, CheckSource("user")
    steel, polyester, confidence, document = _FACTORS[fatigue.code]
    factor = polyester if curve.line == "rope" else steel
    if confidence == "R" and not case.checks.allow_recalled:
        allowed = Message("fatigue.recalled_factor", factor=factor, code=fatigue.code)
        raise InputError([Problem("fatigue.design_factor", "", allowed)], "fatigue")
    return factor, CheckSource(fatigue.code, document, "", confidence)
