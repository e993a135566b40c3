"""What the line of a sizing may be made of, and which of the best lines is recommended."""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace
from functools import cache, cached_property
from typing import Final, Literal, cast, get_args

from catopt.catalogue.choice import chosen
from catopt.catalogue.components import Component, within
from catopt.checks.profiles import Method, profiles_of
from catopt.constants import SEA_WATER_DENSITY, YEAR
from catopt.errors import InputError, refused
from catopt.model import CatalogueChoice, Checks, Line, Segment, SegmentChoice, Service
from catopt.model.kinds import Findings, exceeds
from catopt.sizing.kinds import usual
from catopt.words import Message

Prefer = Literal["practice", "shortest", "cheapest", "lightest", "balanced", "least-swing"]
PREFERENCES: tuple[Prefer, ...] = get_args(Prefer)

_GENERAL_CODE: Final = "API-RP-2SK"
"""Whose method stands in for that of a code that has none."""
_STEPS: Final = (0.25, 0.5, 1.0, 2.5, 5.0, 10.0)
_STEPS_A_HEIGHT: Final = 25.0
"""A step of length is at least this part of the height that the line spans."""
_LONGEST: Final = 12.0
"""Times the height: longer lines are not looked at, but where they are asked for."""
_LONGEST_LIFE: Final = 100.0
"""Years."""
_FASTEST_WEAR: Final = 10e-3
"""m a year."""
_ON_THE_BED: Final = 30.0
"""m."""
MOST_DEPTHS: Final = 20.0
"""Of a scope: longer than any line of practice."""
_ROUNDING: Final = 1e-9
"""Of a number of steps."""


@dataclass(frozen=True)
class LineChoice:
    """What the line may be made of."""

    components: tuple[str, ...]  # families with their grades, as the catalogue names them
    code: str  # profile of criteria that the line is checked by
    diameter_min: float | None = None  # bounds on the sizes that are sold, m
    diameter_max: float | None = None  # m
    # only these, m; empty: every size that is sold within the bounds
    diameters: tuple[float, ...] = ()
    # step of the length, m; None: a round one near a 25th of the height that the line spans
    length_step: float | None = None
    length: float | None = None  # only this one, m; None: every step
    # least and largest length, in depths at high water: of a buoy's chain
    scope: tuple[float, float] = (0.0, math.inf)
    # which design of the front is recommended. Practice: the lightest that is no longer than the
    # aim, or else the shortest; balanced: the lightest whose span is within the aim, or else the
    # least product of mass and area of the swing circle; cheapest: by price and swing. None: that
    # of the code's method
    prefer: Prefer | None = None
    aim: float = math.inf  # length or span that a line keeps to where it can, m
    rest: float = 0.0  # of the swing radius, what is hawser and ship, m
    # largest swing radius that the place allows, m: designs beyond it do not pass
    max_swing: float | None = None
    # what a metre of swing radius costs, USD/m, beside the price of the line: of the cheapest
    swing_price: float = 0.0
    life: float = field(default_factory=lambda: usual("life"))  # service life, s
    # loss of nominal diameter, m/s
    wear_rate: float = field(default_factory=lambda: usual("wear"))
    # allowance for motion on the steady forces, which every check sees. None: that of the code's
    # method
    dynamic_factor: float | None = None
    # that which runs in motion ask for, in its place
    run_factor: float | None = None
    # whether figures and criteria that were read in no document may be used
    allow_recalled: bool = False

    def __post_init__(self) -> None:
        found = Findings("LineChoice")
        if not self.components:
            allowed = Message("refused_sizing.one_family_with_grade_wanted")
            found.add("components", Message("refused.none"), allowed)
        found.numbers(self, "m", "diameter_min", "diameter_max", "length_step", "length", above=0.0)
        found.numbers(self, "m", "max_swing", above=0.0)
        found.number("swing_price", self.swing_price, "USD/m", at_least=0.0)
        least, most = self.diameter_min, self.diameter_max
        if not found.problems and least is not None and most is not None and exceeds(least, most):
            allowed = Message("refused_sizing.below_diameter_min", least=least * 1000.0)
            found.add("diameter_max", f"{most * 1e3:g} mm", allowed)
        self._check_preference(found)
        found.number("life", self.life, "s", at_least=0.0)
        if exceeds(self.life, _LONGEST_LIFE * YEAR):
            allowed = Message("refused_sizing.must_be_years_or_less", longest_life=_LONGEST_LIFE)
            found.add("life", Message("refused_file.years", count=self.life / YEAR), allowed)
        found.number("wear_rate", self.wear_rate, "m/s", at_least=0.0)
        if exceeds(self.wear_rate, _FASTEST_WEAR / YEAR):
            most = _FASTEST_WEAR * 1000.0
            allowed = Message("refused_sizing.must_be_mm_year_or", fastest_wear=most)
            found.add("wear_rate", f"{self.wear_rate * YEAR * 1e3:g} mm/year", allowed)
        found.numbers(self, "", "run_factor", at_least=1.0)
        if self.dynamic_factor is not None:
            found.number("dynamic_factor", self.dynamic_factor, "", at_least=1.0, at_most=10.0)
        try:
            profiles_of(self.checks)
        except InputError as error:
            for problem in error.problems:
                found.add("code", problem.found, problem.allowed)
        found.raise_if_any()

    def _check_preference(self, found: Findings) -> None:
        if self.prefer not in (None, *PREFERENCES):
            allowed = Message("refused.of_these", words=", ".join(PREFERENCES))
            found.add("prefer", repr(self.prefer), allowed)
        lowest, highest = self.scope
        found.number("scope_min", lowest, "", at_least=0.0, at_most=MOST_DEPTHS)
        if highest != math.inf:
            found.number("scope_max", highest, "", above=0.0, at_most=MOST_DEPTHS)
        if 0.0 < highest < lowest <= MOST_DEPTHS:
            allowed = Message("refused_sizing.below_scope_min", lowest=lowest)
            found.add("scope_max", f"{highest:g}", allowed)
        if self.swing_price and self.prefer != "cheapest":
            allowed = Message("refused_sizing.leave_out_prefer_cheapest_alone")
            found.add("swing_price", f"{self.swing_price:g} USD/m", allowed)

    @property
    def checks(self) -> Checks:
        """The checks of the case."""
        return Checks(codes=(self.code,), allow_recalled=self.allow_recalled)

    @property
    def catalogue(self) -> CatalogueChoice:
        """Where the components come from."""
        return CatalogueChoice(allow_recalled=self.allow_recalled)

    def checks_beyond(self, rest: float) -> Checks:
        """Return the checks with the bound on the swing radius as one on the span.

        `rest` is what of the swing radius is not of the line, m.
        """
        longest = None if self.max_swing is None else self.max_swing - rest
        return replace(self.checks, max_span=longest)

    @property
    def method(self) -> Method:
        """What the code has beside its criteria; of one that has nothing, API RP 2SK's."""
        own = profiles_of(self.checks)[0].method
        if own is None:
            own = profiles_of(Checks(codes=(_GENERAL_CODE,)))[0].method
        assert own is not None
        return own

    @property
    def allowance(self) -> float:
        """For motion, on the steady forces."""
        own = self.dynamic_factor if self.run_factor is None else self.run_factor
        return self.method.dynamic_factor if own is None else own

    @property
    def motion(self) -> str:
        """What stands for motion: the user's factor, or what the code's method says of its own."""
        if self.dynamic_factor is not None:
            return Message("sizing.factor_given")
        code = self.code if profiles_of(self.checks)[0].method else _GENERAL_CODE
        return Message("sizing.factor_of_code", code=code, motion=self.method.motion)

    @cached_property
    def looks_for(self) -> Prefer:
        """Which design of the front is recommended."""
        return self.prefer or cast("Prefer", self.method.prefer)

    @property
    def is_bounded(self) -> bool:
        """Whether a larger size is sold than may be taken."""
        if self.diameter_max is None:
            return False
        catalogue = chosen(self.catalogue, SEA_WATER_DENSITY)
        there = (each for name in self.components for each in catalogue.sold(name))
        return any(each.nominal_diameter > self.diameter_max for each in there)

    @property
    def objectives(self) -> tuple[str, str]:
        """What the front is of."""
        if self.looks_for in ("practice", "shortest"):
            return "mass", "length"
        return ("cost" if self.looks_for == "cheapest" else "mass", "offset")

    @property
    def service(self) -> Service | None:
        """Life and wear of the case; None for a line that stays as new."""
        if self.life == 0.0 or self.wear_rate == 0.0:
            return None
        return Service(self.life, self.wear_rate)

    @property
    def least_size(self) -> float | None:
        """The thinnest that is looked at, m: no thinner than what wear leaves anything of."""
        loss = self.life * self.wear_rate
        return max(self.diameter_min or 0.0, loss * (1.0 + 1e-9)) or None

    def has_factor(self, check: Literal["sliding", "holding"]) -> bool:
        """Say whether the code has a factor of its own on a sinker or a drag anchor."""
        criteria = (each for profile in profiles_of(self.checks) for each in profile.criteria)
        return any(each.check == check for each in criteria)

    def by(self, prefer: Prefer) -> LineChoice:
        """Recommend by another preference, which weighs no price of the swing."""
        return replace(self, prefer=prefer, swing_price=0.0)

    def only(self, component: str, diameter: float) -> LineChoice:
        """Leave one size of one component (m) to choose from, and of its lines the lightest."""
        return replace(
            self.by("lightest"),
            components=(component,),
            diameters=(diameter,),
            diameter_min=None,
            diameter_max=None,
        )

    def segment(self, height: float, *, depth: float = 0.0, longest: float = 0.0) -> SegmentChoice:
        """Make the design's segment for the largest height that the line spans, m.

        The scope is in depths, m; `longest` is the length to look at, m, where that is more than
        12 heights.
        """
        step = self.length_step or round_step(height)
        least, most = (each * depth if each else 0.0 for each in self.scope)
        first = max(math.floor(height / step) + 1, math.ceil(least / step - _ROUNDING))
        last = math.ceil(max(_LONGEST * height, longest) / step)
        if most < math.inf:
            last = min(last, math.floor(most / step + _ROUNDING))
        last = max(last, first)
        every = tuple(round(step * k, 9) for k in range(first, last + 1))
        return SegmentChoice(
            name=Message("sizing.chain_part"),
            lengths=every if self.length is None else (self.length,),
            components=self.components,
            diameters=self.diameters,
            diameter_min=None if self.diameters else self.least_size,
            diameter_max=self.diameter_max,
        )


def round_step(height: float) -> float:
    """Pick a round step of length near a 25th of the height that a line spans, m."""
    return next((step for step in _STEPS if step >= height / _STEPS_A_HEIGHT), _STEPS[-1])


# ------------------------------------------------------------------ what is sold


@cache
def _sizes_of(name: str, catalogue: CatalogueChoice, water_density: float) -> tuple[Component, ...]:
    """List a component in all sizes: a search asks within other bounds a hundred times."""
    return chosen(catalogue, water_density).sold(name)


@cache
def sold(choice: LineChoice, water_density: float) -> tuple[Segment, ...]:
    """List a metre of everything that is sold within the bounds, component by component.

    Refused when there is no such component, or no size of any of them is sold within the bounds.
    """
    limits = (choice.least_size or 0.0, choice.diameter_max or math.inf)
    within_bounds = [
        each
        for name in choice.components
        for each in _sizes_of(name, choice.catalogue, water_density)
        if within(each.nominal_diameter, limits)
    ]
    if not within_bounds:
        names = ", ".join(choice.components)
        least, most = (1e3 * each for each in limits)
        allowed = Message("refused_sizing.no_size_sold_from_mm", least=least, most=most)
        raise refused("components", names, allowed, "LineChoice")
    return tuple(each.segment(1.0) for each in within_bounds)


def unpriced_components(choice: LineChoice, water_density: float) -> tuple[str, ...]:
    """List the components of which the price of a size that may be taken is not known."""
    every = sold(choice, water_density)
    return tuple(dict.fromkeys(each.component for each in every if each.price is None))


def longest_useful(choice: LineChoice, water_density: float, height: float) -> float:
    """Return the length beyond which more line only lies on the bed, m.

    At its breaking load a line of weight w hangs over s = sqrt(2 h MBL/w - h^2) of its length, as a
    catenary that leaves the bed horizontally, h the height that it spans, m. Of what is sold the
    longest counts; some 30 m may have to lie on the bed (UFC asks for a shot).
    """
    ratios = (
        each.MBL / each.submerged_weight
        for each in sold(choice, water_density)
        if each.MBL is not None and each.submerged_weight > 0.0
    )
    square = 2.0 * height * max(ratios, default=0.0) - height * height
    return math.sqrt(max(square, 0.0)) + _ON_THE_BED


def first_line(choice: LineChoice, water_density: float, length: float) -> Line:
    """Make a line to begin with: a case has to have one before the search has found any."""
    return Line([replace(sold(choice, water_density)[0], length=length)])
