"""A moored body: lines around it, and what pushes it."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace

from catopt.errors import Problem
from catopt.model.kinds import Angle, Checked, Findings, Force, Height, Length, Moment, NotNegative
from catopt.model.line import Line, weightless
from catopt.words import Message


@dataclass(frozen=True)
class Leg(Checked):
    """One mooring line of a body: what it is made of, and where its two ends are.

    Directions are counter-clockwise from x. The body's own axes lie along x and y when its yaw
    is 0.
    """

    line: Line
    """From the anchor to the fairlead."""
    azimuth: Angle
    """Direction from the origin to the anchor, rad."""
    anchor_radius: Length
    """Horizontal distance from the origin to the anchor, m."""
    fairlead_height: Height
    """Above the seabed, m."""
    anchor_height: Height = 0.0
    """Above the seabed, m."""
    fairlead_radius: Height = 0.0
    """Horizontal distance from the body's origin to the fairlead, m."""
    fairlead_azimuth: Angle = math.nan
    """Direction from the body's origin to the fairlead, rad; that of the line when left out."""
    name: str = ""
    """Free text, for tables."""

    def _check(self, found: Findings) -> None:
        if isinstance(self.fairlead_azimuth, float) and math.isnan(self.fairlead_azimuth):
            object.__setattr__(self, "fairlead_azimuth", self.azimuth)
        found.check("azimuth", "anchor_radius", "fairlead_height", "anchor_height")
        found.check("fairlead_radius")
        if self.azimuth == self.azimuth:
            found.check("fairlead_azimuth")
        if not self.line.point_loads and not any(s.submerged_weight for s in self.line.segments):
            found.add("line.segments", *weightless("a line of a system"))

    @classmethod
    def between(
        cls,
        line: Line,
        *,
        anchor: tuple[float, float],
        fairlead: tuple[float, float] = (0.0, 0.0),
        fairlead_height: float,
        anchor_height: float = 0.0,
        name: str = "",
    ) -> Leg:
        """Place a line by the positions of its ends: x and y, m.

        The fairlead's are in the body's axes; heights count from the seabed, m.
        """
        radius = math.hypot(*fairlead)
        return cls(
            line,
            azimuth=math.atan2(anchor[1], anchor[0]),
            anchor_radius=math.hypot(*anchor),
            fairlead_height=fairlead_height,
            anchor_height=anchor_height,
            fairlead_radius=radius,
            fairlead_azimuth=math.atan2(fairlead[1], fairlead[0]) if radius > 0.0 else math.nan,
            name=name,
        )

    @property
    def anchor(self) -> tuple[float, float]:
        """X and y of the anchor, m."""
        return (
            self.anchor_radius * math.cos(self.azimuth),
            self.anchor_radius * math.sin(self.azimuth),
        )

    @property
    def fairlead(self) -> tuple[float, float]:
        """X and y of the fairlead in the body's axes, m."""
        return (
            self.fairlead_radius * math.cos(self.fairlead_azimuth),
            self.fairlead_radius * math.sin(self.fairlead_azimuth),
        )


@dataclass(frozen=True)
class System(Checked):
    """A body moored by several lines, free to move in x and y and, where it can, to yaw."""

    legs: tuple[Leg, ...]
    """At least one; any iterable is taken."""
    force: tuple[Force, Force] = (0.0, 0.0)
    """On the body's origin, along x and y, N."""
    moment: Moment = 0.0
    """On the body about the vertical, counter-clockwise, N m."""
    seabed_friction: NotNegative = 0.0
    """Coulomb coefficient of what lies on the bed, along the line."""
    yaw_free: bool | None = None
    """Whether the body turns. None: it does where a fairlead lies off the body's origin."""
    judged_line_out: bool = field(default=True, compare=False)
    """Whether checks look at it with each line gone; not where a load of a search asks for none."""

    def _check(self, found: Findings) -> None:
        object.__setattr__(self, "legs", tuple(self.legs))
        object.__setattr__(self, "force", tuple(self.force))
        if not self.legs:
            found.add(
                "legs", Message("refused.none"), Message("refused_motion.system_has_at_least_one")
            )
        if len(self.force) != 2:
            found.add(
                "force",
                f"{len(self.force)} numbers",
                Message("refused_case.two_are_wanted_along_x"),
            )
        found.check("force", "moment", "seabed_friction")
        if self.yaw_free and not self.has_arms:
            allowed = Message("refused_case.no_fairlead_lies_off_body")
            found.add("yaw_free", "True", allowed)
        if not found.problems and self.moment != 0.0 and not self.turns:
            allowed = Message("refused_case.must_be_0_where_body")
            found.add("moment", f"{self.moment:g} N m", allowed)

    @classmethod
    def around(
        cls,
        line: Line,
        *,
        azimuths: Sequence[float],
        anchor_radius: float,
        fairlead_height: float,
        fairlead_radius: float = 0.0,
        anchor_height: float = 0.0,
        seabed_friction: float = 0.0,
        force: tuple[float, float] = (0.0, 0.0),
        moment: float = 0.0,
        yaw_free: bool | None = None,
        judged_line_out: bool = True,
    ) -> System:
        """Put equal lines around a body.

        Parameters
        ----------
        line : Line
            Of which each mooring line is made.
        azimuths : sequence of float
            Direction from the body to each anchor, counter-clockwise from x, rad.
        anchor_radius : float
            From the body's origin to the anchors, horizontally, m.
        fairlead_height, anchor_height : float
            Above the seabed, m.
        fairlead_radius : float
            From the body's origin to the fairleads, each in the direction of its line, m.
        seabed_friction, force, moment, yaw_free, judged_line_out
            As in System.

        Examples
        --------
        >>> from math import radians
        >>> from catopt import Line, Segment, System
        >>> chain = Line([Segment(1082.0, 900.0, EA=6e8)])
        >>> azimuths = [radians(angle) for angle in (0.0, 120.0, 240.0)]
        >>> len(System.around(chain, azimuths=azimuths, anchor_radius=1056.0,
        ...                   fairlead_height=71.4).legs)
        3
        """
        legs = [
            Leg(
                line,
                azimuth=azimuth,
                anchor_radius=anchor_radius,
                fairlead_height=fairlead_height,
                anchor_height=anchor_height,
                fairlead_radius=fairlead_radius,
            )
            for azimuth in azimuths
        ]
        return cls(tuple(legs), force, moment, seabed_friction, yaw_free, judged_line_out)

    @property
    def has_arms(self) -> bool:
        """Whether any fairlead lies off the body's origin."""
        return any(leg.fairlead_radius > 0.0 for leg in self.legs)

    @property
    def turns(self) -> bool:
        """Whether the body is free in yaw."""
        return self.has_arms if self.yaw_free is None else self.yaw_free

    def under(self, force: tuple[float, float], moment: float = 0.0) -> System:
        """Return the same system under another load: N along x and y, N m."""
        return replace(self, force=force, moment=moment)

    def without(self, legs: Iterable[int]) -> System:
        """Return the system with some lines gone, counted from 0; InputError when none is left.

        The body's freedom in yaw stays as it was, unless no fairlead is left off its origin.
        """
        gone = set(legs)
        left = tuple(leg for index, leg in enumerate(self.legs) if index not in gone)
        has_arms = any(leg.fairlead_radius > 0.0 for leg in left)
        return replace(self, legs=left, yaw_free=self.turns and has_arms)

    def raised(self, by: float) -> System:
        """Return the system at another water level, the body floating `by` metres higher."""
        return replace(
            self,
            legs=tuple(replace(leg, fairlead_height=leg.fairlead_height + by) for leg in self.legs),
        )


def system_misfits(others: Mapping[str, object]) -> list[Problem]:
    """List the parts of a case that do not go with a system; one it lacks is empty or None."""
    reasons = {"site.seabed_slope": Message("refused_case.slopes_along_one")}
    own_load = Message("refused_case.load_of_its_own")
    return [
        Problem(
            key,
            Message("refused_case.beside_a_system"),
            Message("refused_case.leave_out_or_system", key_=key, value=reasons.get(key, own_load)),
        )
        for key, value in others.items()
        if value
    ]
