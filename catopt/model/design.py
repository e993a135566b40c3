"""What a design may be made of, and what it is to be best in."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Literal, get_args

from catopt.errors import Problem
from catopt.model.design_load import DesignLoad
from catopt.model.validity import COUNTS, Findings

Objective = Literal["mass", "offset", "excursion", "cost"]
OBJECTIVES: tuple[str, ...] = get_args(Objective)

SearchMethod = Literal["auto", "enumeration", "nsga2", "swarm"]
SEARCH_METHODS: tuple[str, ...] = get_args(SearchMethod)


_OF_A_BODY = ("lines", "anchor_radii", "pretensions", "headings", "line_out", "loads")
_PLAIN: Mapping[str, object] = {"headings": 1}
"""What a key says that might as well be left out."""


@dataclass(frozen=True)
class SegmentChoice:
    """What one segment may be.

    Attributes
    ----------
    components : tuple of str
        Families with their grades, as the catalogue names them; empty: the segment of the case's
        line at this place as it is, whose length alone may vary.
    diameters : tuple of float
        Nominal diameters, m; empty: every size that is sold, within the bounds below.
    diameter_min, diameter_max : float or None
        Bounds on the sizes that are sold, m; None: no bound.
    lengths : tuple of float
        Unstretched, m; rising.
    optional : bool
        Whether the segment may be left out.
    name : str
        For tables.
    """

    lengths: tuple[float, ...]
    components: tuple[str, ...] = ()
    diameters: tuple[float, ...] = ()
    diameter_min: float | None = None
    diameter_max: float | None = None
    optional: bool = False
    name: str = ""

    def __post_init__(self) -> None:
        found = Findings("SegmentChoice", self)
        if not self.lengths:
            found.add("lengths", "none", "at least one length is wanted")
        found.each("lengths", "m", above=0.0)
        found.each("diameters", "m", above=0.0)
        found.numbers(self, "m", "diameter_min", "diameter_max", above=0.0)
        found.raise_if_any()


@dataclass(frozen=True)
class ClumpWeightChoice:
    """What one clump weight may be, and where it may hang.

    Attributes
    ----------
    masses : tuple of float
        In air, kg; rising.
    density : float
        Of its material, kg/m3, for its weight in water.
    positions : tuple of float
        Unstretched arc length from the anchor, m; rising; empty when it hangs at a joint.
    joint : int or None
        At the upper end of this segment, counted from 1 at the anchor; None when `positions` are
        given.
    optional : bool
        Whether it may be left out.
    name : str
        For tables.
    friction : float or None
        Coulomb coefficient of the body on the bed where it rests there; None: that of the bed.
    """

    masses: tuple[float, ...]
    density: float
    positions: tuple[float, ...] = ()
    joint: int | None = None
    optional: bool = False
    name: str = ""
    friction: float | None = None

    def __post_init__(self) -> None:
        found = Findings("ClumpWeightChoice", self)
        if not self.masses:
            found.add("masses", "none", "at least one mass is wanted")
        found.each("masses", "kg", above=0.0)
        found.number("density", self.density, "kg/m3", above=0.0)
        found.each("positions", "m", above=0.0)
        if self.joint is not None:
            found.count("joint", self.joint)
        found.numbers(self, "", "friction", at_least=0.0)
        if (self.joint is None) == (not self.positions):
            found.add("positions", "", "either positions or a joint is wanted")
        found.raise_if_any()


@dataclass(frozen=True)
class SinkerChoice:
    """Sinkers (deadweight anchors) to choose from; the lightest that holds is taken.

    Attributes
    ----------
    masses : tuple of float
        In air, kg; rising.
    density : float
        Of their material, kg/m3.
    friction : float
        On the soil, tan(delta).
    safety_factor : float or None
        On sliding; None: that of the codes that are checked.
    factor_source : str
        Where the factor is from, for the checks; the user when empty.
    """

    masses: tuple[float, ...]
    density: float
    friction: float
    safety_factor: float | None = None
    factor_source: str = ""

    def __post_init__(self) -> None:
        found = Findings("SinkerChoice", self)
        if self.factor_source and self.safety_factor is None:
            found.add("factor_source", "", "goes with safety_factor, which is missing")
        if not self.masses:
            found.add("masses", "none", "at least one mass is wanted")
        found.each("masses", "kg", above=0.0)
        found.number("density", self.density, "kg/m3", above=0.0)
        found.number("friction", self.friction, "", above=0.0)
        found.numbers(self, "", "safety_factor", at_least=1.0)
        found.raise_if_any()


@dataclass(frozen=True)
class Design:
    """A search for the best lines.

    Attributes
    ----------
    segments : tuple of SegmentChoice
        From the anchor to the fairlead.
    clump_weights : tuple of ClumpWeightChoice
        On the line; none is needed.
    sinker : SinkerChoice or None
        At the anchor; None: that of the case, if it has one.
    objectives : tuple of str
        Two or three of: "mass", in air, of segments and clump weights; "offset", the largest span
        over the load cases; "excursion", the largest span less that of the reference case;
        "cost", of the segments' material.
    method : str
        "enumeration" of every design, "nsga2", "swarm", or "auto".
    evaluations : int
        Designs that a search other than enumeration may evaluate.
    population : int
        Designs of one generation, or of the swarm.
    seed : int
        Of the random numbers.
    max_enumerated : int
        The largest number of designs that "auto" enumerates.
    lines : tuple of int
        Of a body: how many equal lines it may have, evenly about the azimuth of the first; empty:
        the azimuths of the case.
    anchor_radii : tuple of float
        Of a body: horizontal distances from its origin to its anchors, m, rising; empty: that of
        the case.
    pretensions : tuple of float
        Of a body: instead, horizontal forces in each line with the body at its origin, N, rising.
    headings : int
        Of a body: from how many sides its force comes, evenly, its own direction the first.
    line_out : bool
        Of a body: whether each line is gone in turn, beside all being there.
    loads : tuple of DesignLoad
        Of a body: what it has to meet, in the place of its system's force; empty: that force.
    """

    segments: tuple[SegmentChoice, ...]
    clump_weights: tuple[ClumpWeightChoice, ...] = ()
    sinker: SinkerChoice | None = None
    objectives: tuple[str, ...] = ("mass", "offset")
    method: SearchMethod = "auto"
    evaluations: int = 10_000
    population: int = 100
    seed: int = 1
    max_enumerated: int = 5_000_000
    lines: tuple[int, ...] = ()
    anchor_radii: tuple[float, ...] = ()
    pretensions: tuple[float, ...] = ()
    headings: int = 1
    line_out: bool = False
    loads: tuple[DesignLoad, ...] = ()

    def __post_init__(self) -> None:
        found = Findings("Design", self)
        if not self.segments:
            found.add("segments", "none", "at least one segment is wanted")
        if all(segment.optional for segment in self.segments):
            found.add("segments", "all optional", "one segment at least has to be there")
        unknown = [name for name in self.objectives if name not in OBJECTIVES]
        if unknown:
            found.add("objectives", ", ".join(unknown), "two or three of " + ", ".join(OBJECTIVES))
        elif not 2 <= len(set(self.objectives)) == len(self.objectives) <= 3:
            named = ", ".join(self.objectives) or "none"
            found.add("objectives", named, "two or three different ones are wanted")
        found.word("method", self.method, SEARCH_METHODS)
        found.count("evaluations", self.evaluations)
        found.count("population", self.population)
        found.count("seed", self.seed)
        found.count("max_enumerated", self.max_enumerated)
        self._check_joints(found)
        self._check_layout(found)
        found.raise_if_any()

    def _check_layout(self, found: Findings) -> None:
        fewest, most = COUNTS["lines"]
        for index, number in enumerate(self.lines):
            found.number(f"lines[{index}]", number, "", at_least=fewest, at_most=most)
        if list(self.lines) != sorted(set(self.lines)):
            found.add("lines", ", ".join(map(str, self.lines)), "rising numbers, each once")
        found.each("anchor_radii", "m", above=0.0)
        found.each("pretensions", "N", above=0.0)
        if self.anchor_radii and self.pretensions:
            allowed = "one of both places the anchors: give the radius or the pretension"
            found.add("pretensions", "beside anchor_radii", allowed)
        found.count("headings", self.headings)

    def _check_joints(self, found: Findings) -> None:
        for index, weight in enumerate(self.clump_weights):
            if weight.joint is not None and not weight.joint < len(self.segments):
                joints = len(self.segments) - 1
                found.add(
                    f"clump_weights[{index}].joint",
                    str(weight.joint),
                    f"the design has {joints or 'no'} joint{'' if joints == 1 else 's'}",
                )


def body_misfits(
    given: Mapping[str, object], *, has_system: bool, has_force: bool
) -> Iterator[Problem]:
    """Yield what a design says of a body that there is not, or cannot say of one that there is.

    Parameters
    ----------
    given : mapping of str to object
        What a design gives; a key that is left out, or as without it, is missing or empty.
    has_system, has_force : bool
        Whether there is a body with several lines, and a force on it.
    """
    loads = given.get("loads")
    if not has_system:
        for key in _OF_A_BODY:
            if given.get(key) and given[key] != _PLAIN.get(key):
                allowed = "is for a body with several lines: add [system], or leave it out"
                yield Problem(f"design.{key}", "without a system", allowed)
        return
    if not has_force and not loads:
        allowed = (
            "missing; a design is for a force on the body, along x and y, other than 0, or for "
            "[[design.loads]]"
        )
        yield Problem("system.force", "", allowed)
    for key in ("headings", "line_out") if loads else ():
        if given.get(key) and given[key] != _PLAIN.get(key):
            allowed = "say it in each of [[design.loads]] that it is for, and leave it out here"
            yield Problem(f"design.{key}", "beside design.loads", allowed)
    if given.get("sinker"):
        allowed = "leave it out: a mooring is searched with the anchors of [anchor]"
        yield Problem("design.sinker", "beside a system", allowed)
    objectives = given.get("objectives")
    if isinstance(objectives, (tuple, list)) and "excursion" in objectives:
        allowed = "take offset: that of a body is counted from where it rests without a load"
        yield Problem("design.objectives", "excursion", allowed)
