"""A moored body: what it is, the lines around it, and what pushes it."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, fields, replace
from typing import Annotated, Final, Literal, NamedTuple

from catopt.errors import Problem
from catopt.model.kinds import (
    Angle,
    Area,
    Checked,
    Coefficient,
    File,
    Findings,
    Force,
    Height,
    Length,
    Mass,
    Measured,
    Moment,
    NotNegative,
    Place,
    Positive,
    Share,
    Size,
    SomeMass,
    SomeSpeed,
    Source,
    Strength,
    Time,
    Weight,
)
from catopt.model.line import Line, weightless
from catopt.model.plausible_ranges import Plausible
from catopt.units import Dimension
from catopt.words import Message


@dataclass(frozen=True)
class Buoy(Checked):
    """A buoy, as far as the line minds it."""

    reserve_buoyancy: Strength
    """Vertical pull that takes it to its allowed draught, N."""


@dataclass(frozen=True)
class Body(Checked):
    """A body that moves along x and y, held in height and in the yaw that it has at rest.

    The mean of the forces is that of the system; what is here comes on top of it.
    """

    mass: Mass
    """kg."""
    added_mass: SomeMass = 0.0
    """Of the water that moves with it, along x and y alike, kg."""
    damping: Annotated[float, Measured(Dimension.DAMPING, at_least=0.0)] = 0.0
    """Force per speed, along x and y alike, N s/m."""
    force_file: Annotated[str, File(example='"force.csv"')] = ""
    """Path of a CSV file with the forces over time; empty when not used."""
    wave_force: Annotated[tuple[Weight, ...], Size(2, 2)] = ()
    """Force along x and y per height of the waves' surface over still water at the body, N/m; empty
    for none."""


@dataclass(frozen=True)
class ShipAfloat(Plausible):
    """A ship, an FSO or a barge on its lines, by its main dimensions.

    Its x axis points forwards. It turns about the origin of the system where no fairlead lies off
    it (a turret), else its x axis lies along that of the system at rest without load.
    """

    length: Length
    """Over all, m."""
    breadth: Length
    draught: Length
    moulded_depth: Length
    """From deck to keel, m."""
    condition: Literal["loaded", "ballast"] = "loaded"
    """For the block coefficient and the wind's coefficients."""
    kind: Literal["tanker", "bulk carrier", "general cargo", "barge"] = "tanker"
    """For wind and current: a barge or a pontoon has square ends."""
    propeller: Literal["", "destroyer", "cruiser", "carrier", "cargo", "tanker", "submarine"] = ""
    """Kind of a locked propeller, after UFC 4-159-03; empty: none, or one that is not locked."""
    coefficients: Annotated[str, File(example='"coefficients.toml"')] = ""
    """Path of a file of the ship's own coefficients of wind and current; empty: after Blendermann
    and UFC, of a barge those of square ends."""
    length_waterline: Length | None = None
    """m; None: 0.97 of the length over all, of a barge all of it."""
    mooring_point: Place = 0.0
    """Of the origin of the system, m forward of midships."""
    displacement: Mass | None = None
    """kg; None: by the block coefficient of the condition."""
    frontal_area: Area | None = None
    lateral_area: Area | None = None
    """Above water, m2; None: estimated."""
    midship_area: Area | None = None
    """Of the section amidships under water, m2; None: 0.98 of breadth by draught, of a barge all of
    it."""
    lateral_centre: Place | None = None
    """Of a lateral area that is given, m forward of midships; None: amidships."""
    wind_direction: Angle = 0.0
    """Where the wind blows to, rad from the x axis."""
    gusts: Literal["NPD", "none"] = "NPD"
    """Spectrum of the wind's speed."""
    current_yaw: Literal["", "Clarke-lever", "series-60", "FFG"] = ""
    """What the current turns the ship by: the lever of the derivatives of Clarke, Gedling and Hine
    (1983) or a hull of UFC's table 4-10, whose figures are recalled; empty: her own coefficients
    where they have it, else Clarke's lever."""
    lever_factor: Positive = 1.0
    """On where the current acts before midships."""
    turn_factor: NotNegative = 1.0
    """On the moment by which the water slows a turn."""
    reflection: Share | None = None
    """Part of the height of every wave that the hull reflects, for the drift; None: by her form."""
    entrance: Angle | None = None
    """Half angle between the sides of the waterline at her ends, rad; None: half ellipses 1.75
    half-breadths long, of a barge a right angle."""
    drift_factor: NotNegative = 1.0
    """On the drift by her form."""
    drift_file: Annotated[str, File(example='"ship.8"')] = ""
    """Path of WAMIT's .8 file with the mean drift; empty: by `reflection`."""
    ulen: Length | None = None
    """The length ULEN of that file, m."""
    surge_damping: NotNegative = 0.05
    sway_damping: NotNegative = 0.05
    yaw_damping: NotNegative = 0.05
    """Linear, of slow motions beyond the drag of current and wind, as a part of critical."""
    roll_period: Time | None = None
    """Natural period, s; None: it does not roll."""
    roll_damping: Annotated[float, Measured(Dimension.NUMBER, above=0.0, at_most=1.0)] = 0.05
    """As a part of critical."""

    def _check(self, found: Findings) -> None:
        found.check()
        found.problems += ship_misfits([key for key in _OF_DRIFT if getattr(self, key)])


@dataclass(frozen=True)
class HullAfloat(Plausible):
    """A body on several lines whose coefficients a panel program computed.

    It moves in six freedoms about the point of its files, which lies at the origin of the system,
    in still water, its x axis along that of the system.
    """

    file: Annotated[str, File(example='"hull.1"')]
    """Path of WAMIT's .1 file, with .3 and .hst beside it, or of capytaine's netCDF file."""
    mass: Mass
    centre_of_gravity: Annotated[tuple[Place, ...], Size(3, 3)]
    """x, y and z from the point, m."""
    gyration: Annotated[tuple[Length, ...], Size(3, 3)]
    """Radii of gyration in roll, pitch and yaw about it, m."""
    ulen: Length | None = None
    """The length ULEN of WAMIT's files, m."""
    displacement: Mass | None = None
    """Of the water at the draught of the files, kg; None: the mass, and it floats deeper by what
    its lines pull down."""
    damping: Annotated[
        tuple[Annotated[float, Measured(Dimension.DAMPING, at_least=0.0)], ...], Size(3, 3)
    ] = ()
    """Linear, in surge, sway and heave beyond the waves that it makes, N s/m; empty for none."""
    roll_damping: NotNegative = 0.0
    pitch_damping: NotNegative = 0.0
    """Likewise, as a part of critical."""
    memory: Time = 100.0
    """After which the waves that it made have gone, s."""
    weightless: bool = False
    """Whether the stiffness of the files is that of the water alone, without the weight."""


HEAVE_DRAG: Final = 1.0
_OF_DRIFT: Final = ("drift_file", "ulen")


class FloaterKind(NamedTuple):
    """A kind of what floats: whether it is on the lines of a system only, and has wind.

    `on_two_scales`: whether it is run by `catopt.verify.two_scales`; all others are stepped with
    their lines, by their row in `catopt.verify.hulls.HULLS`.
    """

    needs_system: bool = False
    has_wind: bool = True
    on_two_scales: bool = False


FLOATERS: Final[Mapping[str, FloaterKind]] = {
    "buoy": FloaterKind(),
    "ship": FloaterKind(needs_system=True, on_two_scales=True),
    "hull": FloaterKind(needs_system=True, has_wind=False),
}
"""By the key of a `Floater` that says what floats; the first has the keys of `_OF_A_BUOY`."""


def floater_kind(given: Collection[str]) -> str:
    """Say which of what may float is given; the buoy where none is."""
    return next((key for key in FLOATERS if key in given), "buoy")


_OF_A_BUOY: Final[Mapping[str, object]] = {
    "file": "",
    "wind_direction": 0.0,
    "centre_of_gravity": None,
    "pitch_radius": None,
    "pitch_damping": None,
    "max_heel": None,
    "heave_drag": HEAVE_DRAG,
}
"""What others have none of, with what it is where it is not used."""


def ship_misfits(given: Collection[str]) -> list[Problem]:
    """List what is missing of a ship's drift file and the length that goes with it."""
    lacks = [key for key in _OF_DRIFT if key not in given]
    if len(lacks) != 1:
        return []
    return [Problem(lacks[0], "", Message("refused_case.drift_file_and_ulen"))]


def floater_misfits(given: Mapping[str, object]) -> list[Problem]:
    """List what does not go together in what floats: of its keys, those that are given."""
    first, *others = [key for key in FLOATERS if key in given] or [""]
    if not first or others:
        wanted = Message("refused.exactly_one", ways=", ".join(FLOATERS))
        if not first:
            return [Problem("buoy", Message("refused_file.none_of_them"), wanted)]
        return [Problem(key, Message("refused_case.beside_another"), wanted) for key in others]
    if "buoy" in given:
        return []
    allowed = Message("refused_case.of_a_buoy")
    problems = [
        Problem(key, "", allowed)
        for key, unused in _OF_A_BUOY.items()
        if given.get(key, unused) != unused
    ]
    if not FLOATERS[first].has_wind and "wind_speed" in given:
        problems.append(Problem("wind_speed", "", Message("refused_case.no_wind_on_a_hull")))
    return problems


@dataclass(frozen=True)
class Floater(Plausible):
    """What floats: a buoy on its line, or several; a ship, or a hull of files, on several lines.

    A buoy moves with its lines: in surge, heave and pitch where waves, current and wind go along x
    and the lines are mirrored by it, else in all six freedoms. Of one line x goes from the anchor
    to the fairlead, of several it is that of the system. `load`, the line's `fairlead_height` and
    the force of a system are for the answers at rest. All but `ship`, `hull` and
    `wind_speed` is of a buoy; a hull has no wind.
    """

    buoy: Source = ""
    """Name of the buoy, of the library or of `file`."""
    ship: ShipAfloat | None = None
    """In its place."""
    hull: HullAfloat | None = None
    """Likewise."""
    file: Annotated[str, File(example='"buoys.toml"')] = ""
    """Path of a file of buoys of one's own; empty when not used."""
    wind_speed: SomeSpeed = 0.0
    """m/s. Of a buoy, whose own drag in air it has; of a ship the mean of one hour at 10 m."""
    wind_direction: Angle = 0.0
    """Of a buoy: where it blows to, counter-clockwise from x, rad."""
    centre_of_gravity: Place | None = None
    """Height above the bottom of the hull, m; None: that of its hull and structure, as if their
    mass were spread over what they displace, with the ballast at the lowest point."""
    pitch_radius: Length | None = None
    """Radius of gyration about it, m; None: likewise."""
    pitch_damping: NotNegative | None = None
    """Of what else damps the pitch than waves and the drag of the slices, as a part of critical;
    None: not known, and then nothing."""
    heave_drag: Coefficient = HEAVE_DRAG
    """Drag coefficient along the axis, on the widest section."""
    max_heel: Angle | None = None
    """Largest mean heel of a buoy in motion, rad, above 0 and below 90 deg: such as half of the
    vertical divergence of its light; None: not judged."""

    def _check(self, found: Findings) -> None:
        found.check()
        if self.max_heel is not None and not 0.0 < self.max_heel < 0.5 * math.pi:
            allowed = Message("refused_case.upright_to_lying")
            found.add("max_heel", f"{math.degrees(self.max_heel):g} deg", allowed)
        default = {each.name: each.default for each in fields(self) if each.compare}
        given = {key: vars(self)[key] for key in default if vars(self)[key] != default[key]}
        found.problems += floater_misfits(given)

    @property
    def kind(self) -> str:
        """Key in `FLOATERS` of what floats."""
        return floater_kind([key for key, value in vars(self).items() if value])

    @property
    def on_two_scales(self) -> bool:
        """Whether it is run on two time scales, as a ship."""
        return FLOATERS[self.kind].on_two_scales


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
            found.add("line.segments", *weightless("system"))

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
        found = Findings("Leg.between")
        at: dict[str, tuple[float, ...]] = {}
        for key, place in (("anchor", anchor), ("fairlead", fairlead)):
            if len(place) != 2:
                said = Message("refused_case.x_and_y", count=len(place))
                found.add(key, f"{tuple(place)}", said)
            at[key] = tuple(found.taken(f"{key}[{k}]", each, "m") for k, each in enumerate(place))
        found.raise_if_any()
        anchor, fairlead = at["anchor"][:2], at["fairlead"][:2]  # type: ignore[assignment]
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
class System(Plausible):
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
        found.some("legs", Message("refused_motion.system_has_at_least_one"))
        if len(self.force) != 2:
            allowed = Message("refused_case.two_are_wanted_along_x")
            found.add("force", Message("refused.numbers", count=len(self.force)), allowed)
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
        """Whether the body turns: is free in yaw."""
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

    def turned(self, by: float) -> System:
        """Return the system turned about the body's origin, with its load; rad."""
        x, y = self.force
        cosine, sine = math.cos(by), math.sin(by)
        return replace(
            self,
            force=(x * cosine - y * sine, x * sine + y * cosine),
            legs=tuple(
                replace(leg, azimuth=leg.azimuth + by, fairlead_azimuth=leg.fairlead_azimuth + by)
                for leg in self.legs
            ),
        )

    @property
    def lowest_fairlead(self) -> float:
        """Height above the bed, m."""
        return min(leg.fairlead_height for leg in self.legs)

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
