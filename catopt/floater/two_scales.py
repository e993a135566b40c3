"""A ship on its lines on two time scales: slow motion stepped in time, waves by its RAOs.

Slow surge, sway and yaw answer to wind with gusts, current and slow drift, which is Newman's
(1974): of each pair of waves the mean of their own mean drifts. Lines restore by closed form. On
that come the motions of each wave by the ship's response, and the tension of each line by closed
form at every place of its fairlead: without the line's own inertia and drag.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Annotated, Any, Final, TypedDict

import numpy as np

from catopt.arrays import Array
from catopt.compiled import compiled
from catopt.errors import NoEquilibriumError, NotConvergedError
from catopt.floater.line_tables import no_tables
from catopt.floater.ship_in_weather import ShipInWeather
from catopt.floater.slow_drift import (
    ALL_ROUND,
    SLOW_STEP,
    Sector,
    drift_all_round,
    drift_series,
    grown_share,
    mean_drift,
    sector_around,
    stable_headings,
    summed_waves,
    wave_numbers_of,
)
from catopt.floater.slow_ship import (
    BEYOND,
    HEADINGS,
    SlowShip,
    hang_lines,
    step_slowly,
)
from catopt.floater.stability import SwingMode, linearised, swing_mode
from catopt.hydro.coefficients import Coefficients
from catopt.hydro.hull import monohull_response
from catopt.loads.environment import gust_series
from catopt.model import System
from catopt.model.kinds import Angle, Force, Place
from catopt.mooring.net import room_for
from catopt.mooring.under_loads import as_arrays
from catopt.mooring.zero_load import BodyRest, ZeroLoadPosition, zero_load_position
from catopt.waves import Waves
from catopt.words import Message

_FAST_STEPS: Final = 20
"""Samples of a mean period of the waves."""
_ROUNDS: Final = 60
_OFF: Final = math.radians(1.0)
"""By which a ship that turns freely starts off its heading, so that fishtailing can begin."""
_SAME: Final = 1e-9
_PULL: Final = 2e-4
"""Time that a line takes as plain Python, s."""
_TURN: Final = 2.0 * math.pi


@dataclass(frozen=True, eq=False)
class ShipHistory:
    """What one run gave, after its ramp: of samples (n,) a time apart that the waves ask for.

    `slow` (n, 3): x and y, m, and yaw, rad, of the origin; `whole` likewise with the waves;
    `slow_tension`, `tension` (n, lines, 2): at fairlead and anchor, N. `course`: all of the slow
    motion from the start, a sample every `SLOW_STEP`.
    """

    time: Array
    slow: Array
    whole: Array
    slow_tension: Array
    tension: Array
    course: Array


class MeanLoads(TypedDict):
    """Mean loads of a ship by what they come from."""

    wind: tuple[float, float, float]
    """Mean wind."""
    current: tuple[float, float, float]
    """Mean current."""
    drift: tuple[float, float, float]
    """Mean drift of the waves."""


class PlaceAtRest(TypedDict):
    """Place and yaw."""

    x_m: Place
    """m, along x of the system."""
    y_m: Place
    """m, along y."""
    yaw_rad: Angle
    """rad, of the ship's x axis from that of the system."""


@dataclass(frozen=True, eq=False)
class ShipAtRest:
    """A ship where its mean weather and its lines balance.

    `place`: x and y, m, and yaw, rad; `zero`: the zero-load position, x and y; `parts`: mean wind,
    current and drift in the ship's axes about the origin, N and N m; `others`: further headings at
    which it would lie, rad; `stiffness`: in surge, sway and yaw with the weather's, N/m and N m.
    """

    place: tuple[float, float, float]
    zero: tuple[float, float]
    parts: tuple[Array, Array, Array]
    others: tuple[float, ...]
    stiffness: tuple[float, float, float]

    @property
    def of_document(self) -> Annotated[Mapping[str, float], PlaceAtRest]:
        """Where the ship rests in the mean weather."""
        return dict(zip(("x_m", "y_m", "yaw_rad"), self.place, strict=True))

    @property
    def mean_loads(self) -> Annotated[Mapping[str, tuple[float, ...]], MeanLoads]:
        """In surge, sway (N) and yaw (N m), in the ship's axes about the origin of the system."""
        names = ("wind", "current", "drift")
        return {name: tuple(part.tolist()) for name, part in zip(names, self.parts, strict=True)}

    @property
    def force(self) -> tuple[Force, Force]:
        """Of the mean weather, N, along x and y of the system."""
        along, across, _ = np.sum(self.parts, axis=0).tolist()
        cosine, sine = math.cos(self.place[2]), math.sin(self.place[2])
        return along * cosine - across * sine, along * sine + across * cosine


@dataclass(frozen=True, eq=False)
class MooredShip:
    """A ship on its lines, with its response to waves.

    `response` is about `reference`: along its x and y from the origin of the system, and above the
    bed, m; its phases count from the crest over `crest`, likewise. None: closed forms, midships.
    """

    system: System
    ship: ShipInWeather
    response: Coefficients | None = None
    reference: tuple[float, ...] = ()
    crest: tuple[float, ...] = ()

    @property
    def raos(self) -> tuple[Coefficients, tuple[float, ...], tuple[float, ...]]:
        """Give its response to waves, its reference and its crest: closed forms for none."""
        if self.response is not None:
            return self.response, self.reference, self.crest
        of, ship = self.ship.of, self.ship.ship
        omega = np.geomspace(0.1, 4.0, 160)
        heading = np.linspace(0.0, _TURN, HEADINGS + 1)
        answer = monohull_response(
            omega,
            heading,
            self.ship.depth,
            length=ship.length_waterline,
            breadth=ship.breadth,
            draught=ship.draught,
            block=self.ship.block,
            roll_period=of.roll_period,
            roll_damping=of.roll_damping,
        )
        midships = (-of.mooring_point, 0.0)
        return Coefficients(omega, heading, response=answer), (*midships, self.ship.depth), midships

    @cached_property
    def zero_load(self) -> ZeroLoadPosition:
        """The lines alone."""
        return zero_load_position(self.system)

    # ------------------------------------------------------------------ at rest

    def at_rest(self, waves: Waves) -> ShipAtRest:
        """Find where it rests under the means of wind, current and drift.

        NoEquilibriumError where it finds no heading, or the lines do not hold it;
        NotConvergedError.
        """
        drift = mean_drift(self.ship, waves)

        def load(heading: float) -> Array:
            return self.ship.steady(heading, drift(heading))

        turns = self.system.turns
        rest, yaw, others = self._turned(load) if turns else self._vaned(load, waves)
        turn = 1e-4
        by_weather = -(load(yaw + turn)[2] - load(yaw - turn)[2]) / (2.0 * turn)
        (xx, xy, _), (_, yy, _), (_, _, turning) = rest.stiffness
        cosine, sine = math.cos(yaw), math.sin(yaw)
        both = 2.0 * cosine * sine * xy
        surge = cosine * cosine * xx + sine * sine * yy + both
        sway = sine * sine * xx + cosine * cosine * yy - both
        about = by_weather + (turning if self.system.turns else 0.0)
        neutral = self.zero_load.neutral
        parts = (*self.ship.blown(yaw), drift(yaw))
        place = (rest.x, rest.y, yaw)
        return ShipAtRest(place, (neutral.x, neutral.y), parts, others, (surge, sway, about))

    def _vaned(
        self, load: Callable[[float], Array], waves: Waves
    ) -> tuple[BodyRest, float, tuple[float, ...]]:
        """Let it turn freely about the origin: a heading at which a turn is turned back."""
        stable = stable_headings(self.ship, waves)
        if stable is None:
            return self._held(load(0.0), 0.0), 0.0, ()
        if not stable:
            raise NoEquilibriumError(Message("loads.no_heading"), "heading", math.nan)
        yaw, *others = stable
        return self._held(load(yaw), yaw), yaw, tuple(others)

    def _turned(self, load: Callable[[float], Array]) -> tuple[BodyRest, float, tuple[float, ...]]:
        """Find its yaw on lines that turn with it: the load of a yaw, the yaw of a load."""
        yaw = self.zero_load.neutral.yaw
        for _ in range(_ROUNDS):
            rest = self._held(load(yaw), yaw)
            off = rest.yaw - yaw
            if abs(off) <= _SAME:
                return rest, rest.yaw, ()
            yaw += 0.7 * off
        raise NotConvergedError(Message("floater.ship_not_at_rest", rounds=_ROUNDS))

    def _held(self, load: Array, yaw: float) -> BodyRest:
        cosine, sine = math.cos(yaw), math.sin(yaw)
        along, across, moment = load.tolist()
        force = (along * cosine - across * sine, along * sine + across * cosine)
        return self.zero_load.under(force, moment if self.system.turns else 0.0)[0]

    # ------------------------------------------------------------------ in time

    def run(
        self,
        waves: Waves,
        duration: float,
        ramp: float,
        generator: np.random.Generator,
        rest: ShipAtRest | None = None,
        *,
        step: float | None = None,
        start: Array | None = None,
        finer: bool = False,
        parts: tuple[int, float] | None = None,
    ) -> ShipHistory:
        """Run it from rest for a time, s, of which the ramp is left out of the answer.

        The generator draws the gusts; `step`, s, is that of the samples, `sample_step` when left
        out; `start` (6,): a state of `swing` in the place of rest; `finer`: at half the step, in
        the same gusts and drift; `parts`: a line, from 0, that parts at a time, s, from which on
        the answer has the others. NoEquilibriumError where a line does not reach, with the time.
        """
        rest = rest or self.at_rest(waves)
        slow = self._slow(waves, duration, ramp, generator, rest, start, finer, parts)
        if parts is not None:
            left, ramp = self.without(parts[0]), max(ramp, parts[1])
        else:
            left = self
        step = (step or sample_step(waves)) * (0.5 if finer else 1.0)
        time = ramp + step * np.arange(int((duration - ramp) / step) + 1, dtype=np.float64)
        way = slow_at(time, slow)
        fast = left._fast(waves, time, way, rest)
        none = np.zeros((time.size, len(left.system.legs), 3))
        whole = way.copy()
        whole[:, :2] += fast[0]
        whole[:, 2] += fast[2]
        still, tension = left._hung(time, way, none), left._hung(time, way, fast[1])
        return ShipHistory(time, way, whole, still, tension, slow)

    def without(self, line: int) -> MooredShip:
        """Return it without one of its lines, from 0."""
        return replace(self, system=self.system.without([line]))

    def _slow(
        self,
        waves: Waves,
        duration: float,
        ramp: float,
        generator: np.random.Generator,
        rest: ShipAtRest,
        start: Array | None,
        finer: bool,
        parts: tuple[int, float] | None = None,
    ) -> Array:
        """Step the slow motion: x, y and yaw, a sample every `SLOW_STEP`, (n, 3)."""
        ship, of = self.ship, self.ship.of
        samples = math.ceil(duration / SLOW_STEP) + 1
        grown = grown_share(samples, ramp)
        speed = math.hypot(*ship.wind)
        gust = np.zeros(samples)
        if of.gusts != "none" and speed > 0.0:
            gust = gust_series(speed, samples, SLOW_STEP, generator)
        blown = np.outer(1.0 + grown * gust / (speed or 1.0), ship.wind)

        def stepped(sector: Sector) -> Array:
            drift = drift_series(ship, waves, samples, ramp, sector)
            if not finer:
                slow = self._driven(rest, blown, drift, sector)
                return self._parted(slow, rest, samples, start, SLOW_STEP, parts)[:, :3]
            slow = self._driven(rest, _with_means(blown), _with_means(drift), sector)
            count, half = 2 * samples - 1, 0.5 * SLOW_STEP
            return self._parted(slow, rest, count, start, half, parts)[::2, :3]

        try:
            return stepped(sector_around(rest.place[2]))
        except _LeavesSectorError:
            return stepped(ALL_ROUND)

    def _driven(
        self, rest: ShipAtRest, wind: Array, drift: Array, sector: Sector = ALL_ROUND
    ) -> SlowShip:
        """Put together what steps it, under wind and drift over time."""
        ship, of, inertia = self.ship, self.ship.of, self.ship.inertia
        critical = (of.surge_damping, of.sway_damping, of.yaw_damping)
        stiff = zip(critical, rest.stiffness, np.diag(inertia).tolist(), strict=True)
        damping = np.array([2.0 * part * math.sqrt(max(k, 0.0) * m) for part, k, m in stiff])
        turn_sway, turn_yaw = map(float, ship.turning)
        surge, sway = map(float, ship.added)
        return SlowShip(
            inverse=np.linalg.inv(inertia),
            mass=float(ship.mass),
            added=(surge, sway),
            lever=-float(of.mooring_point),
            damping=damping,
            turn_sway=turn_sway,
            turn_yaw=turn_yaw,
            crossflow=float(ship.crossflow),
            half=0.5 * float(ship.ship.length_waterline),
            wind_table=ship.wind_table,
            current_table=ship.current_table,
            current_x=float(ship.current[0]),
            current_y=float(ship.current[1]),
            turns=bool(self.system.turns),
            wind=np.ascontiguousarray(wind),
            drift=drift,
            first=sector.first,
        )

    def _steady(self, waves: Waves, rest: ShipAtRest) -> SlowShip:
        """Put it together under the mean weather: two samples, alike, stand for all."""
        drift = np.repeat(drift_all_round(self.ship, waves)[np.newaxis], 2, axis=0)
        return self._driven(rest, np.repeat([self.ship.wind], 2, axis=0), drift)

    def mode(self, waves: Waves, rest: ShipAtRest) -> SwingMode:
        """Find the motion in the mean weather, linearised, that dies away the slowest, or grows."""
        return swing_mode(linearised(self._steady(waves, rest), self.zero_load.net, rest.place))

    def still_tension(self, path: Array) -> Array:
        """Give the tensions of every line along slow motion (n, 3): (n, lines, 2), N."""
        time = SLOW_STEP * np.arange(path.shape[0], dtype=np.float64)
        return self._hung(time, path, np.zeros((path.shape[0], len(self.system.legs), 3)))

    def swing(self, waves: Waves, rest: ShipAtRest, duration: float) -> Array:
        """Step it in the mean weather alone from a degree off where it rests: the state, (n, 6)."""
        samples = math.ceil(duration / SLOW_STEP) + 1
        return self._stepped(self._steady(waves, rest), rest, samples)

    def _parted(
        self,
        slow: SlowShip,
        rest: ShipAtRest,
        samples: int,
        start: Array | None,
        step: float,
        parts: tuple[int, float] | None,
    ) -> Array:
        """Step what drives it, as `_stepped`; from where a line parts, to a step, without that."""
        if parts is None:
            return self._stepped(slow, rest, samples, start, step)
        line, time = parts
        at = min(max(1, round(time / step)), samples - 2)
        whole = self._stepped(slow, rest, at + 1, start, step)
        left = self.without(line)
        further = slow._replace(
            turns=bool(left.system.turns), wind=slow.wind[at:], drift=slow.drift[at:]
        )
        return np.concatenate(
            [whole[:-1], left._stepped(further, rest, samples - at, whole[-1], step)]
        )

    def _stepped(
        self,
        slow: SlowShip,
        rest: ShipAtRest,
        samples: int,
        start: Array | None = None,
        step: float | None = None,
    ) -> Array:
        """Step what drives it from a state, or from rest: a sample every step, s, (n, 6).

        `SLOW_STEP` where no step is given.
        """
        step = step or SLOW_STEP
        path = np.zeros((samples, 6))
        path[0, :3] = rest.place
        if not self.system.turns:
            path[0, 2] += _OFF
        if start is not None:
            path[0] = start
        known = as_arrays(room_for(self.zero_load.net))
        work = 4.0 * _PULL * samples * len(self.system.legs)
        done, wrong = compiled(step_slowly, work)(
            step, slow, self._net, self._tables, known, np.zeros((5, 6)), path
        )
        if wrong == BEYOND:
            raise _LeavesSectorError
        if wrong >= 0:
            raise _out_of_reach(wrong, done * step)
        return path

    @property
    def _net(self) -> Any:
        return as_arrays(self.zero_load.net)

    @property
    def _tables(self) -> Any:
        """Tables that stand for closed form: none."""
        return as_arrays(no_tables())

    def _fast(
        self, waves: Waves, time: Array, slow: Array, rest: ShipAtRest
    ) -> tuple[Array, Array, Array]:
        """Motions by the waves: of the origin along x and y, of each fairlead, and in yaw."""
        raos, reference, crest = self.raos
        k = wave_numbers_of(waves, self.ship.depth)
        yaws = slow[:, 2]
        count = max(2, math.ceil((yaws.max() - yaws.min()) / (_TURN / HEADINGS)) + 1)
        grid = np.linspace(yaws.min(), yaws.max() + _SAME, count)
        answers = raos.at("response", waves.omega, waves.direction - grid[:, np.newaxis])
        turned = np.exp(1j * grid) * complex(*crest)
        x, y = rest.place[0] + turned.real, rest.place[1] + turned.imag
        ahead = np.outer(x, k * np.cos(waves.direction)) + np.outer(y, k * np.sin(waves.direction))
        there = waves.amplitude * np.exp(1j * (ahead + waves.phase))
        sized = (answers * there[..., np.newaxis]).transpose(1, 0, 2).reshape(waves.omega.size, -1)
        six = np.empty((time.size, 6))
        place = (yaws - grid[0]) / (grid[1] - grid[0])
        left = np.minimum(place.astype(int), count - 2)
        part = (place - left)[:, np.newaxis]

        def columns(at: slice) -> slice:
            return slice(6 * int(left[at].min()), 6 * (int(left[at].max()) + 2))

        for at, summed in summed_waves(waves, time, sized, columns):
            found = summed.reshape(summed.shape[0], -1, 6)
            rows, own = np.arange(found.shape[0]), left[at] - left[at].min()
            below, above = found[rows, own], found[rows, own + 1]
            six[at] = (1.0 - part[at]) * below + part[at] * above
        cosine, sine = np.cos(yaws), np.sin(yaws)

        def moved(arm_x: Array | float, arm_y: Array | float, height: float) -> Array:
            """Way of a point at an arm from the origin, in the ship's axes, along x, y and up."""
            dx, dy, dz = arm_x - reference[0], arm_y - reference[1], height - reference[2]
            roll, pitch, yaw = six[:, 3], six[:, 4], six[:, 5]
            along = six[:, 0] + pitch * dz - yaw * dy
            across = six[:, 1] + yaw * dx - roll * dz
            up = six[:, 2] + roll * dy - pitch * dx
            way = (along * cosine - across * sine, along * sine + across * cosine, up)
            return np.stack(way, axis=1)

        ways = []
        for leg in self.system.legs:
            x_0, y_0 = leg.fairlead
            arm: tuple[Array | float, Array | float] = (x_0, y_0)
            if not self.system.turns:  # the ship turns about them
                arm = x_0 * cosine + y_0 * sine, y_0 * cosine - x_0 * sine
            ways.append(moved(*arm, leg.fairlead_height))
        height = self.system.legs[0].fairlead_height
        return moved(0.0, 0.0, height)[:, :2], np.stack(ways, axis=1), six[:, 5]

    def _hung(self, time: Array, path: Array, ways: Array) -> Array:
        """Tensions of every line at both ends, (n, lines, 2), by closed form."""
        out = np.empty((time.size, len(self.system.legs), 2))
        work = _PULL * out.size
        done, wrong = compiled(hang_lines, work)(
            np.ascontiguousarray(path),
            np.ascontiguousarray(ways),
            bool(self.system.turns),
            self._net,
            self._tables,
            out,
        )
        if wrong >= 0:
            raise _out_of_reach(wrong, float(time[done]))
        return out


class _LeavesSectorError(Exception):
    """The ship turns beyond the headings of which her drift was summed."""


def _with_means(samples: Array) -> Array:
    """Put the mean of two samples between them: of what is taken as straight from one to the next.

    `samples` (n, ...) gives (2 n - 1, ...).
    """
    out = np.empty((2 * samples.shape[0] - 1, *samples.shape[1:]))
    out[::2] = samples
    out[1::2] = 0.5 * (samples[:-1] + samples[1:])
    return out


def sample_step(waves: Waves) -> float:
    """Give the time between samples by which motions in waves are followed, s."""
    energy = waves.amplitude**2
    return min(float(_TURN * energy.sum() / (energy @ waves.omega)) / _FAST_STEPS, SLOW_STEP)


def slow_at(time: Array, path: Array) -> Array:
    """Interpolate slow motion between its samples."""
    known = SLOW_STEP * np.arange(path.shape[0], dtype=np.float64)
    return np.stack([np.interp(time, known, each) for each in path.T], axis=1)


def _out_of_reach(line: int, time: float) -> NoEquilibriumError:
    said = Message("floater.line_out_of_reach", number=line + 1, time=time)
    return NoEquilibriumError(said, "length", math.nan)
