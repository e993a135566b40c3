"""The wind of a sizing: given, or of a place, and the mean that loads are computed for."""

from __future__ import annotations

from functools import partial

from catopt.loads.design_wind import USUAL_PERIOD, PlaceWind, wind_of_place
from catopt.sizing.environment import WIND_MEAN, mean_over
from catopt.sizing.input_values import ResolvedInputs
from catopt.units import lasting
from catopt.words import Message


def wind_of_30_s(of: ResolvedInputs) -> float | None:
    """Convert the wind to the mean that loads on a ship are computed for, m/s.

    A wind whose averaging time is not known is taken for a mean of 30 s.
    """
    mean = of["wind_mean"] or WIND_MEAN
    return of.errors.make(partial(mean_over, wanted=WIND_MEAN), of["wind"], mean)


def blowing(of: ResolvedInputs) -> float | None:
    """Take the wind that was given, or that of the place, m/s; None where it is not known."""
    found = of_place(of)
    return of["wind"] if found is None else found.speed


def of_place(of: ResolvedInputs) -> PlaceWind | None:
    """Look the wind of the place up; None without one."""
    if of["place"] is None:
        return None
    look_up = partial(wind_of_place, recalled=bool(of["recalled"]))
    return of.errors.make(look_up, of["place"], of["return_period"] or USUAL_PERIOD)


def of_the_wind(of: ResolvedInputs) -> tuple[Message, ...]:
    """Say to which speed the wind was converted."""
    speed = wind_of_30_s(of)
    if speed is None or of["wind_mean"] in (None, WIND_MEAN):
        return ()
    given = {"given": of["wind"], "mean": lasting(of["wind_mean"])}
    return (Message("sizing.wind_converted", speed=speed, **given),)
