"""The mooring line: segments from the anchor to the fairlead, and what hangs on them."""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, fields
from itertools import pairwise
from typing import TYPE_CHECKING, Annotated, Any, Final, Literal, NoReturn, TypeVar, get_args

from catopt.constants import STANDARD_GRAVITY
from catopt.errors import Problem, refused
from catopt.model.kinds import (
    Area,
    Coefficient,
    Findings,
    Force,
    Given,
    Height,
    Length,
    MassPerLength,
    Measured,
    NotNegative,
    OneOf,
    Positive,
    Price,
    SomeMass,
    Strength,
    Text,
    WearRate,
    Weight,
)
from catopt.model.plausible_ranges import Plausible
from catopt.model.service import WEAR_ZONES
from catopt.units import Dimension
from catopt.words import Message


def table_misfits(
    strain: Sequence[float], tension: Sequence[float], key: str = "strain_tension"
) -> list[Problem]:
    """List what of a table of strains and tensions, N, is wrong; `key` names the tensions."""
    if len(strain) != len(tension):
        found = Message("refused.numbers", count=len(tension))
        return [Problem(key, found, Message("refused.so_many", count=len(strain)))]
    problems = []
    for name, values in (("strain", strain), (key, tension)):
        if len(values) < 2:
            found = Message("refused.numbers", count=len(values))
            problems.append(Problem(name, found, Message("refused_case.table_of_two")))
        elif values[0] != 0.0:
            problems.append(
                Problem(f"{name}[0]", f"{values[0]:g}", Message("refused_case.table_from_zero"))
            )
        for k, (lower, upper) in enumerate(pairwise(values), start=1):
            if not upper > lower:
                allowed = Message("refused.above", bound=f"{lower:g}")
                problems.append(Problem(f"{name}[{k}]", f"{upper:g}", allowed))
    if problems:
        return problems
    pairs = zip(pairwise(strain), pairwise(tension), strict=True)
    for k, ((e, more), (T, larger)) in enumerate(pairs, start=1):
        # Beyond this the straight line of the row would begin below a strain of -1.
        most = e + (1.0 + e) * (larger - T) / T if T > 0.0 else math.inf
        if not more < most:
            allowed = Message("refused_case.table_softens", most=most)
            problems.append(Problem(f"strain[{k}]", f"{more:g}", allowed))
    return problems


@dataclass(frozen=True)
class StrainTable:
    """Strain of a rope at some tensions, N, both from 0 and rising; straight lines between them.

    It stands in the place of `Segment.EA`. One line is solved by it at rest (`solve`, ``catopt
    solve``) and verified by the truss model. Everything that needs one axial stiffness refuses it.

    Parameters
    ----------
    strain : sequence of float
        Elongation over unstretched length.
    tension : sequence of float or str
        N, or text with a unit.

    Raises
    ------
    InputError
        Fewer than two rows, not from 0, not rising.

    Examples
    --------
    >>> from catopt import StrainTable
    >>> rope = StrainTable([0.0, 0.05, 0.1], ["0 kN", "20 kN", "60 kN"])
    >>> round(rope.strain_at(40e3), 9)
    0.075
    """

    strain: tuple[float, ...]
    tension: tuple[float, ...]

    def __init__(self, strain: Iterable[float], tension: Iterable[float | str]) -> None:
        object.__setattr__(self, "strain", tuple(strain))
        object.__setattr__(self, "tension", tuple(tension))
        found = Findings(of=self)
        found.each("strain", "", at_least=0.0)
        found.each("tension", "N", at_least=0.0)
        found.raise_if_any()
        found.problems += table_misfits(self.strain, self.tension, "tension")
        found.raise_if_any()

    def strain_at(self, tension: float) -> float:
        """Strain at a tension, N; beyond the last row its slope goes on, which answers refuse."""
        k = self._row(tension)
        return self.strain[k] + (tension - self.tension[k]) * self.slope(k)

    def law(self, least: float, most: float) -> tuple[float, float]:
        """Return e and c, 1/N, of the strain e + c T that stands for tensions between two, N.

        It has the table's chord between them and its mean.
        """
        k = self._row(0.5 * (least + most))
        if self._row(least) == self._row(most):
            return self.strain[k] - self.slope(k) * self.tension[k], self.slope(k)
        inside = [T for T in self.tension if least < T < most]
        places = [least, *inside, most]
        strains = [self.strain_at(T) for T in places]
        pairs = zip(pairwise(places), pairwise(strains), strict=True)
        mean = math.fsum(0.5 * (b - a) * (u + v) for (a, b), (u, v) in pairs) / (most - least)
        c = (strains[-1] - strains[0]) / (most - least)
        return mean - 0.5 * c * (least + most), c

    def slope(self, k: int) -> float:
        """Strain gained per tension from a row, from 0, to the next, 1/N."""
        return (self.strain[k + 1] - self.strain[k]) / (self.tension[k + 1] - self.tension[k])

    def _row(self, tension: float) -> int:
        return min(max(bisect_right(self.tension, tension) - 1, 0), len(self.tension) - 2)

    def _refuse(self, *_: object) -> NoReturn:
        allowed = Message("refused_case.table_is_no_stiffness")
        raise refused("EA", Message("refused_case.table_of_strain"), allowed)

    # What reckons with one axial stiffness does not know this rope.
    __float__ = __rtruediv__ = __truediv__ = __mul__ = __rmul__ = _refuse
    __lt__ = __gt__ = __le__ = __ge__ = __abs__ = __neg__ = _refuse


def weight_in_water(mass: float, density: float, water_density: float) -> float:
    """Submerged weight of a solid body, N, from kg and kg/m3; negative when it floats.

    S2, equation (24), with W = m g0.
    """
    return mass * STANDARD_GRAVITY * (1.0 - water_density / density)


LineKind = Literal["chain", "wire", "rope"]
"""Chain, steel wire rope of any make, fibre rope: codes have factors of their own for each."""
LINE_KINDS: tuple[LineKind, ...] = get_args(LineKind)

_ROPES = "rope polyester nylon polyamide polypropylene polyethylene hmpe aramid"
_WORDS: dict[LineKind, str] = {"chain": "chain", "wire": "wire spiral", "rope": _ROPES}
"""Words in a component's name by the kind of line; wire comes before rope, for "wire rope"."""


def line_kind(component: str) -> LineKind | None:
    """Return the kind of line by the name of a component; None when it does not say."""
    name = component.casefold()
    for kind, words in _WORDS.items():
        if any(word in name for word in words.split()):
            return kind
    return None


INEXTENSIBLE: Final = 1e12
"""Axial stiffness beyond which a line hardly stretches, N; no real one comes near it."""

HIGHEST_COV: Final = 0.25
"""Coefficient of variation from which c (3 - 6 c) falls: more scatter would make more strength."""

Cov = Annotated[float, Measured(Dimension.NUMBER, at_least=0.0, at_most=HIGHEST_COV)]

DragMethod = Literal["given", "roughness"]

STEADY_FROM: Final = 12.0
"""KC from which S4 has the wake amplification in a graph (figure 2.10), which is not at hand."""

_GIVEN = ("drag_normal", "drag_axial", "added_mass_normal")
_ROUGH = ("roughness", "keulegan_carpenter", "wake_amplification")


TESTS: Final = ("MBL_mean", "MBL_cov")
"""Statistics of break tests."""


def break_test_misfits(given: Collection[str]) -> list[Problem]:
    """List which of the statistics of break tests is missing beside the other."""
    missing = [key for key in TESTS if key not in given]
    if len(missing) != 1:
        return []
    return [Problem(missing[0], "", Message("refused_case.missing_mbl_mean_mbl_cov"))]


def drag_misfits(given: Mapping[str, Any]) -> list[Problem]:
    """List what does not go with the way in which a segment's drag is found.

    By its name in `Segment`, what the segment is given; a value that cannot be read is None.
    """
    if given.get("drag_method") != "roughness":
        return [
            Problem(key, repr(given[key]), Message("refused_case.goes_with_drag_method_roughness"))
            for key in _ROUGH
            if key in given
        ]
    problems = [
        Problem(key, repr(given[key]), Message("refused_case.follows_from_roughness_leave_out"))
        for key in _GIVEN
        if key in given
    ]
    if str(given.get("component") or "").startswith("chain"):
        allowed = Message("refused_case.round_wires_ropes_chain_none")
        problems.append(Problem("drag_method", "'roughness'", allowed))
    problems += [
        Problem(key, "", Message("refused_case.missing_drag_method_roughness_needs"))
        for key in _ROUGH[:2]
        if key not in given
    ]
    KC = given.get("keulegan_carpenter")
    if KC is not None and KC >= STEADY_FROM and "wake_amplification" not in given:
        graph = Message("refused_case.missing_kc_or_more_s4", steady_from=STEADY_FROM)
        problems.append(Problem("wake_amplification", "", graph))
    return problems


@dataclass(frozen=True)
class Segment(Plausible):
    """A uniform stretch of chain, wire or rope."""

    length: Length
    """Unstretched, m."""
    submerged_weight: Weight
    """Weight in water per unstretched length, N/m; negative when it floats."""
    EA: Annotated[float, Measured(Dimension.FORCE, above=0.0, infinite=True)] = math.inf
    """Axial stiffness, N; infinite for an inextensible segment. A rope that does not stretch in
    proportion to its tension has a `StrainTable` here."""
    mass: MassPerLength | None = None
    """In air per unstretched length, kg/m; None when not known, as of what follows."""
    MBL: Strength | None = None
    """Minimum breaking load, N."""
    name: str = ""
    """Free text, for tables."""
    component: Annotated[str, Text(filled=True, example='"chain studless R3"')] = ""
    """Family and grade in the catalogue; empty when the figures are the user's own."""
    nominal_diameter: Length | None = None
    """Of the bar of a chain's links, or of the rope as sold, m."""
    proof_load: Strength | None = None
    """Proof load, N."""
    price: Price | None = None
    """Material only, USD/m."""
    wear_rate: WearRate | None = None
    """Loss of nominal diameter, m/s; None: that of the case's service."""
    wear_zone: Annotated[str, OneOf(WEAR_ZONES, quoted=True)] | None = None
    """For the table of wear that the case's service names."""
    drag_diameter: Length | None = None
    """That both drag coefficients refer to, m."""
    drag_normal: Coefficient | None = None
    """Drag coefficient across the line; `drag_axial` along it."""
    drag_axial: Coefficient | None = None
    added_mass_normal: Coefficient | None = None
    """Added-mass coefficient across the line, on displaced water; `added_mass_axial` along it."""
    added_mass_axial: Coefficient | None = None
    drag_method: DragMethod = "given"
    """Whether the coefficients are given, or follow from the three that come next: recalled
    formulas of S4, docs/dynamics.md, for wires and ropes."""
    roughness: Height | None = None
    """Height of what is rough on the surface, m."""
    keulegan_carpenter: Coefficient | None = None
    """KC = v T/D of the flow to and fro, v the amplitude of its velocity, D the drag diameter."""
    wake_amplification: Positive | None = None
    """Factor psi on the drag of a steady flow; None: by the KC, below 12."""
    MBL_mean: Strength | None = None
    """Mean of the breaking loads of a series of tests, N."""
    MBL_cov: Cov | None = None
    """Their coefficient of variation."""

    if TYPE_CHECKING:  # numbers in SI or text with a unit; what is kept are numbers

        def __init__(
            self,
            length: Given,
            submerged_weight: Given,
            EA: Given | StrainTable = math.inf,
            mass: Given | None = None,
            MBL: Given | None = None,
            name: str = "",
            component: str = "",
            nominal_diameter: Given | None = None,
            proof_load: Given | None = None,
            price: Given | None = None,
            wear_rate: Given | None = None,
            wear_zone: str | None = None,
            drag_diameter: Given | None = None,
            drag_normal: Given | None = None,
            drag_axial: Given | None = None,
            added_mass_normal: Given | None = None,
            added_mass_axial: Given | None = None,
            drag_method: DragMethod = "given",
            roughness: Given | None = None,
            keulegan_carpenter: Given | None = None,
            wake_amplification: Given | None = None,
            MBL_mean: Given | None = None,
            MBL_cov: Given | None = None,
            *,
            accept: Sequence[str] = (),
        ) -> None: ...

    def _check(self, found: Findings) -> None:
        if isinstance(self.EA, StrainTable):
            found.check(*(each.name for each in fields(self) if each.name != "EA"))
        else:
            found.check()
        found.problems += break_test_misfits({k for k in TESTS if getattr(self, k) is not None})
        is_rough = self.drag_method != "given" or any(getattr(self, k) is not None for k in _ROUGH)
        if is_rough and not found.problems:
            given = {key: value for key, value in vars(self).items() if value not in (None, "")}
            found.problems += drag_misfits(given)

    @property
    def catalogued(self) -> str | None:
        """Family and grade in the catalogue; None for figures of the case's own."""
        return self.component or None

    @property
    def is_inextensible(self) -> bool:
        """Whether it does not stretch at all."""
        return not isinstance(self.EA, StrainTable) and math.isinf(self.EA)

    @property
    def tested_strength(self) -> float | None:
        """Characteristic strength by tests, mu (1 - c (3 - 6 c)) (DNV-OS-E301, 2008, C), N.

        None without tests.
        """
        if self.MBL_mean is None or self.MBL_cov is None:
            return None
        return self.MBL_mean * (1.0 - self.MBL_cov * (3.0 - 6.0 * self.MBL_cov))


_DRAG = ("drag_area", "drag_coefficient")


def point_drag_misfits(given: Collection[str]) -> list[Problem]:
    """List which of the area and the coefficient of a point load's drag lacks the other."""
    return [
        Problem(other, "", Message("refused.missing_goes_with", key_=key))
        for key, other in (_DRAG, _DRAG[::-1])
        if key in given and other not in given
    ]


@dataclass(frozen=True)
class PointLoad(Plausible):
    """A clump weight (sinker) or a buoy fixed to the line."""

    position: Length
    """Unstretched arc length from the anchor, m; strictly between the ends of the line."""
    submerged_weight: Force
    """Weight in water, N; negative for a buoy."""
    mass: SomeMass | None = None
    """In air, kg; None when not known."""
    name: str = ""
    """Free text, for tables."""
    friction: NotNegative | None = None
    """Coulomb coefficient of the body on the bed where it rests there; None: that of the bed."""
    drag_area: Area | None = None
    """A, m2, in all directions: for a line in motion, given together with Cd. None: no drag."""
    drag_coefficient: Coefficient | None = None
    """Cd that goes with the area."""
    added_mass_coefficient: Coefficient = 0.0
    """Ca on the displaced water, in all directions."""

    if TYPE_CHECKING:  # numbers in SI or text with a unit; what is kept are numbers

        def __init__(
            self,
            position: Given,
            submerged_weight: Given,
            mass: Given | None = None,
            name: str = "",
            friction: Given | None = None,
            drag_area: Given | None = None,
            drag_coefficient: Given | None = None,
            added_mass_coefficient: Given = 0.0,
            *,
            accept: Sequence[str] = (),
        ) -> None: ...

    def _check(self, found: Findings) -> None:
        found.check()
        given = [key for key in _DRAG if getattr(self, key) is not None]
        found.problems += point_drag_misfits(given)

    @property
    def drag_product(self) -> float:
        """Cd A, m2."""
        return (self.drag_coefficient or 0.0) * (self.drag_area or 0.0)


def weightless(line: Literal["system", "network"]) -> tuple[Message, Message]:
    """Say what was found of the segments of a line without weight, and why that is not allowed."""
    return Message("refused_motion.weightless"), Message(f"refused_case.{line}_needs_weight")


def drag_missing(line: Line, path: str = "line") -> list[Problem]:
    """List what the segments of a line lack of what their drag in a current is found from."""
    found = Findings()
    for k, segment in enumerate(line.segments):
        key = f"{path}.segments[{k}]"
        if segment.drag_method != "given":
            allowed = Message("refused_case.current_wants_given_drag")
            found.add(f"{key}.drag_method", f'"{segment.drag_method}"', allowed)
        elif segment.drag_normal is None:
            found.add(f"{key}.drag_normal", "", Message("refused_case.current_wants_drag"))
        elif segment.drag_diameter is None and (segment.drag_normal or segment.drag_axial):
            found.add(f"{key}.drag_diameter", "", Message("refused_motion.missing_drag_refers"))
    return found.problems


END_ROUNDING = 1e-14
"""Of a line's length, which is a sum of lengths: nearer to its ends no place is told from them."""


T = TypeVar("T")


def _all(kind: type[T], key: str, items: Iterable[T]) -> tuple[T, ...]:
    """Return items of one kind; InputError for what is none."""
    if isinstance(items, kind):
        items = (items,)
    found, read = Findings("Line"), tuple(items)
    for k, each in enumerate(read):
        if not isinstance(each, kind):
            allowed = Message("refused_case.kind_wanted", kind=kind.__name__)
            found.add(f"{key}[{k}]", repr(each)[:40], allowed)
    found.raise_if_any()
    return read


@dataclass(frozen=True)
class Line:
    """A mooring line."""

    segments: tuple[Segment, ...]
    """From the anchor to the fairlead; at least one. Any iterable is taken."""
    point_loads: tuple[PointLoad, ...] = ()
    """In any order; they are kept sorted by position."""

    def __init__(self, segments: Iterable[Segment], point_loads: Iterable[PointLoad] = ()) -> None:
        loads = sorted(_all(PointLoad, "point_loads", point_loads), key=lambda load: load.position)
        object.__setattr__(self, "segments", _all(Segment, "segments", segments))
        object.__setattr__(self, "point_loads", tuple(loads))
        found = Findings(of=self)
        found.some("segments", Message("refused_case.line_has_at_least_one"))
        for index, load in enumerate(self.point_loads):
            nearest = min(load.position, self.length - load.position)
            if self.segments and not nearest > END_ROUNDING * self.length:
                allowed = Message("refused_case.must_lie_between_ends_line", length=self.length)
                found.add(f"point_loads[{index}].position", f"{load.position:g} m", allowed)
        for lower, upper in pairwise(self.point_loads):
            if lower.position == upper.position and lower.friction != upper.friction:
                values = {"one": f"{lower.friction}", "other": f"{upper.friction}"}
                shown = Message("refused_case.two_at", **values, place=lower.position)
                lie = Message("refused_case.point_loads_one_place_lie")
                allowed = Message("refused_case.give_both_same", allowed=lie)
                found.add("point_loads.friction", shown, allowed)
        found.raise_if_any()

    @property
    def length(self) -> Length:
        """Unstretched, m."""
        return math.fsum(segment.length for segment in self.segments)

    @property
    def submerged_weight(self) -> float:
        """Weight in water of the whole line with its point loads, N."""
        weights = [segment.length * segment.submerged_weight for segment in self.segments]
        return math.fsum([*weights, *(load.submerged_weight for load in self.point_loads)])

    @property
    def mass(self) -> SomeMass | None:
        """In air, of all segments and point loads; None when one of them is not known."""
        masses = [
            *(None if s.mass is None else s.length * s.mass for s in self.segments),
            *(load.mass for load in self.point_loads),
        ]
        known = [mass for mass in masses if mass is not None]
        return math.fsum(known) if len(known) == len(masses) else None
