"""Fatigue: cycles of a tension by rainflow counting, T-N and S-N curves, and Miner's sum.

Fatigue from a spectrum: dual narrow band, of slow motion and of the waves' together.

Of two normally distributed narrow bands, a slow one (L) and a fast one (W), with the parts l of the
variance and the rates n of crossing the mean upwards, Jiao and Moan (1990) add the damage of the
fast one to that of the envelope of both:

    n_P = l_L n_L sqrt(1 + (l_W/l_L) (d n_W/n_L)^2)
    rho = (n_P/n) (l_L^(m/2+2) (1 - sqrt(l_W/l_L)) + sqrt(pi l_L l_W) m G(m/2+1/2)/G(m/2+1))
          + (n_W/n) l_W^(m/2)

times the damage of one narrow band with the whole variance and n^2 = l_L n_L^2 + l_W n_W^2. The
width d of the fast band is taken as 0.1, as recalled from DNV-OS-E301. The form of rho is for a
slow band that is not the smaller part; where it is, it is taken as it stands.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Final, Literal, NamedTuple

import numpy as np

from catopt.arrays import Array
from catopt.catalogue.components import Confidence
from catopt.checks.criteria import strength_of
from catopt.checks.kinds import USER, CheckSource
from catopt.constants import YEAR
from catopt.errors import InputError, Problem, need_package, refused
from catopt.model import Case, Line, Segment
from catopt.model.kinds import Area, Force, Height
from catopt.model.line import LineKind, line_kind
from catopt.model.network import Network
from catopt.words import Message

_WIDTH: Final = 0.1
"""Vanmarcke's width of the fast band."""

_NONE: Final = 1e-6
"""Part of the variance below which a band is none."""


class Band(NamedTuple):
    """A band of a spectrum: its variance, and the rate of crossing the mean upwards, 1/s."""

    variance: float
    rate: float


def bands(values: Array, time: float, split: float) -> tuple[Band, Band]:
    """Part a series at equal steps into what is slower than a frequency, rad/s, and what is faster.

    `time`: that it lasts, s.
    """
    power: Array = np.abs(np.fft.rfft(values - values.mean())) ** 2
    power[1:] *= 2.0 / values.size**2
    whole = time * values.size / (values.size - 1)
    omega = np.arange(power.size, dtype=float) * (2.0 * math.pi / whole)
    parts = (omega > 0.0) & (omega < split), omega >= split
    slow, fast = (_band(power[part], omega[part]) for part in parts)
    return slow, fast


def _band(power: Array, omega: Array) -> Band:
    variance = float(power.sum())
    if not variance > 0.0:
        return Band(0.0, 0.0)
    return Band(variance, math.sqrt(float(power @ omega**2) / variance) / (2.0 * math.pi))


def range_moment(slow: Band, fast: Band, slope: float) -> float:
    """Sum of the ranges to the power of a curve's slope m, in a second, by dual narrow band.

    `slow`, `fast`: of a tension, N2 and 1/s.

    Examples
    --------
    >>> one = range_moment(Band(0.0, 0.0), Band(2.0, 0.1), 3.0)
    >>> round(one, 6) == round(0.1 * (2.0 * 2.0) ** 3 * math.gamma(2.5), 6)
    True
    """
    total = slow.variance + fast.variance
    if not total > 0.0:
        return 0.0
    l_L, l_W = slow.variance / total, fast.variance / total
    if min(l_L, l_W) < _NONE:
        return _narrow(max(slow, fast), slope)
    rate = math.sqrt(l_L * slow.rate**2 + l_W * fast.rate**2)
    both = _narrow(Band(total, rate), slope)
    return _rho(slow, fast, l_L, l_W, rate, slope) * both


def _narrow(band: Band, m: float) -> float:
    """Sum for one narrow band: ranges of twice an amplitude after Rayleigh."""
    size = 2.0 * math.sqrt(2.0 * band.variance)
    return float(band.rate * size**m * math.gamma(1.0 + 0.5 * m))


def _rho(slow: Band, fast: Band, l_L: float, l_W: float, rate: float, m: float) -> float:
    envelope = l_L * slow.rate
    envelope *= math.sqrt(1.0 + l_W / l_L * (_WIDTH * fast.rate / slow.rate) ** 2)
    own = l_L ** (0.5 * m + 2.0) * (1.0 - math.sqrt(l_W / l_L))
    crossed = math.sqrt(math.pi * l_L * l_W) * m
    crossed *= math.exp(math.lgamma(0.5 * m + 0.5) - math.lgamma(0.5 * m + 1.0))
    alone = fast.rate / rate * math.pow(l_W, 0.5 * m)
    return float(envelope / rate * (own + crossed) + alone)


@dataclass(frozen=True, eq=False)
class Cycles:
    """Cycles of one series."""

    ranges: Array
    counts: Array
    """Each range, and 1 for a whole cycle or 0.5 for half of one."""
    mean: float
    """Of the series."""
    time: float
    """That it lasts, s."""
    bands: tuple[Band, Band] | None = None
    """The series' slow and fast parts; None where it was not parted."""


def count_cycles(
    values: Array,
    time: float,
    split: float | None = None,
    *,
    samples: Array | None = None,
    mean: float | None = None,
) -> Cycles:
    """Count the cycles of a series by rainflow, ASTM E1049; what is left over counts half.

    Of a series its turning points are enough, with its `mean` over time and evenly spaced `samples`
    for its spectrum; without them both are of the values. The time is that which the series lasts,
    s; by `split` (rad/s) the spectrum is parted, too. Refused when the package rainflow is missing.

    Examples
    --------
    >>> import numpy as np
    >>> found = count_cycles(np.array([-2.0, 1, -3, 5, -1, 3, -4, 4, -2]), 1.0)
    >>> [float(found.counts[found.ranges == size].sum()) for size in (3.0, 4.0, 6.0, 8.0, 9.0)]
    [0.5, 1.5, 0.5, 1.0, 0.5]
    """
    need_rainflow()
    from rainflow import extract_cycles

    found = np.array([cycle[:3:2] for cycle in extract_cycles(values.tolist())]).reshape(-1, 2)
    even = values if samples is None else samples
    parted = None if split is None else bands(even, time, split)
    mean = float(even.mean()) if mean is None else mean
    return Cycles(found[:, 0], found[:, 1], mean, time, parted)


def need_rainflow() -> None:
    """Refuse to count where the package rainflow is missing: InputError with how to install it."""
    need_package("rainflow", "fatigue", "fatigue")


@dataclass(frozen=True)
class FatigueCurve:
    """Cycles to failure N over a range."""

    kind: Literal["S-N", "T-N"]
    """N = factor s^-slope with the stress range s in MPa, or N = factor R^-slope with R the tension
    range over the reference strength."""
    factor: float
    """a_D, or K without mean tension: cycles to failure at a range of 1."""
    slope: float
    """m, or M."""
    source: CheckSource
    line: LineKind | None = None
    """For which kind of line; None: any."""
    per_mean: float = 0.0
    """log10 of K falls by so much times the mean tension over the reference strength."""
    ORQ: bool = False
    """Whether the reference is the strength of ORQ chain of the same size, whatever its grade."""

    def damage(self, cycles: Cycles, reference: float) -> float:
        """Miner's sum of n/N, of a tension in N; `reference`: area, m2, or strength, N."""
        over, log = self._scales(cycles, reference)
        return float(np.sum(cycles.counts * (cycles.ranges / over) ** self.slope) / 10.0**log)

    def damage_by_spectrum(self, cycles: Cycles, reference: float) -> float | None:
        """Miner's sum by dual narrow band; None without bands."""
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


_E301 = ("DNV-OS-E301 (2008)", "Table F1")
_API = ("API RP 2SK 3rd ed. (2005)", "Table 3")

_ROWS: Final[tuple[tuple[str, float, float, LineKind, Confidence, float], ...]] = (
    ("E301 stud", 1.2e11, 3.0, "chain", "B", 0.0),
    ("E301 studless", 6.0e10, 3.0, "chain", "B", 0.0),
    ("E301 six-strand", 3.4e14, 4.0, "wire", "B", 0.0),
    ("E301 spiral", 1.7e17, 4.8, "wire", "B", 0.0),
    ("E301 polyester", 0.259, 13.46, "rope", "B", 0.0),
    ("API stud", 10.0**3.0, 3.0, "chain", "C", 0.0),
    ("API studless", 10.0 ** math.log10(316.0), 3.0, "chain", "B", 0.0),
    ("API six-strand", 10.0**3.20, 4.09, "wire", "C", 2.79),
    ("API spiral", 10.0**3.25, 5.05, "wire", "C", 3.43),
)
"""Name, factor, slope, kind of line, confidence, and fall of the factor per mean."""


def _curve_of(
    name: str, factor: float, slope: float, line: LineKind, confidence: Confidence, fall: float
) -> FatigueCurve:
    by_API = name.startswith("API")
    source = CheckSource(name, *(_API if by_API else _E301), confidence)
    kind: Literal["S-N", "T-N"] = "T-N" if by_API or line == "rope" else "S-N"
    return FatigueCurve(kind, factor, slope, source, line, fall, ORQ=by_API and line == "chain")


CURVES: Mapping[str, FatigueCurve] = MappingProxyType({row[0]: _curve_of(*row) for row in _ROWS})
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
    """What a segment withstands, at half its loss of diameter."""

    curve: FatigueCurve
    reference: float
    """Area in m2, or strength in N."""
    diameter: Height | None
    """Nominal, less half the loss in the service life."""

    @property
    def area(self) -> Area | None:
        """Cross section at that diameter, of a chain both legs; None for T-N."""
        return self.reference if self.curve.kind == "S-N" else None

    @property
    def breaking_strength(self) -> Force | None:
        """Reference breaking strength at that diameter; None for S-N."""
        return None if self.curve.kind == "S-N" else self.reference

    def damage(self, runs: Sequence[Cycles]) -> float:
        """Damage in a year of nothing but what the runs are of, each of its own seed."""
        time = sum(each.time for each in runs)
        return sum(self.curve.damage(each, self.reference) for each in runs) * YEAR / time

    def damage_by_spectrum(self, runs: Sequence[Cycles]) -> float | None:
        """Give the same by dual narrow band; None where a run's spectrum was not parted."""
        found = [self.curve.damage_by_spectrum(each, self.reference) for each in runs]
        known = [each for each in found if each is not None]
        if len(known) < len(runs):
            return None
        return sum(known) * YEAR / sum(each.time for each in runs)


def fatigue_strengths(
    case: Case | Network, line: Line | None = None, path: str = "line"
) -> tuple[FatigueStrength, ...]:
    """Find the curve of every segment of a line and its reference at half the loss of diameter.

    `line`: the first of the case when left out, `path`: where it stands there. InputError for every
    segment without a curve, a diameter or a strength.
    """
    found: list[FatigueStrength] = []
    problems: list[Problem] = []
    for index, segment in enumerate((line or case.every_line[0]).segments):
        key = f"{path}.segments[{index}]"
        try:
            found.append(_strength(_curve(case, segment, index), segment, case, key))
        except InputError as error:
            problems += error.problems
    if problems:
        raise InputError(problems, "fatigue")
    return tuple(found)


def _curve(case: Case | Network, segment: Segment, index: int) -> FatigueCurve:
    fatigue = case.fatigue
    assert fatigue is not None
    given = {each.segment: each for each in fatigue.curves}
    own = given.get(index + 1, given.get(None))
    kind = line_kind(segment.component)
    if own is not None:
        if own.name:
            curve = CURVES[own.name]
        elif own.log_a_D is not None and own.m is not None:
            curve = FatigueCurve("S-N", 10.0**own.log_a_D, own.m, USER)
        else:
            assert own.K is not None
            assert own.M is not None
            curve = FatigueCurve("T-N", own.K, own.M, USER)
        if curve.line is not None and kind is not None and curve.line != kind:
            allowed = Message("refused_case.segment", line=curve.line, component=segment.component)
            key = f"fatigue.curves[{fatigue.curves.index(own)}].name"
            raise refused(key, own.name, allowed)
        return replace(curve, line=kind or curve.line)
    of = next((name for start, name in _OF_COMPONENT if segment.component.startswith(start)), "")
    name = f"{_OF_CODE[fatigue.code]} {of}" if fatigue.code else ""
    if name not in CURVES:
        code = fatigue.code or Message("refused_case.no_code")
        what = Message("refused_case.has_no_curve_give_one", value=code)
        found = segment.component or Message("refused_case.without_component")
        raise refused(f"line.segments[{index}]", found, what)
    return CURVES[name]


def _strength(
    curve: FatigueCurve, segment: Segment, case: Case | Network, key: str
) -> FatigueStrength:
    """Put the diameter less half the loss into the area, or into the strength."""
    service = case.service
    half = None if service is None else replace(service, life=0.5 * service.life)
    strength = strength_of(segment, half, case.catalogue, key=key)
    diameter = strength.end_diameter
    if curve.kind == "T-N" and not curve.ORQ:
        return FatigueStrength(curve, strength.need("MBL", key, curve.kind), diameter)
    if diameter is None:
        allowed = Message("refused_case.missing_curve_needs")
        raise refused(f"{key}.diameter", "", allowed)
    if curve.ORQ:
        from catopt.catalogue import component

        MBL = component("chain stud-link ORQ", diameter).MBL
        assert MBL is not None
        return FatigueStrength(curve, MBL, diameter)
    if curve.line is None:
        allowed = Message("refused_case.missing_area_stress_chain_s")
        raise refused(f"{key}.component", "", allowed)
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


def design_factor(case: Case | Network, curve: FatigueCurve) -> tuple[float, CheckSource]:
    """Return the factor on the damage of a segment, and where it comes from.

    InputError when it was read in no document and is not allowed.
    """
    fatigue = case.fatigue
    assert fatigue is not None
    if fatigue.design_factor is not None:
        return fatigue.design_factor, USER
    steel, polyester, confidence, document = _FACTORS[fatigue.code]
    factor = polyester if curve.line == "rope" else steel
    if confidence == "R" and not case.checks.allow_recalled:
        allowed = Message("fatigue.recalled_factor", factor=factor, code=fatigue.code)
        raise refused("fatigue.design_factor", "", allowed, "fatigue")
    return factor, CheckSource(fatigue.code, document, "", confidence)
