"""The sea of a sizing: given by its height, or raised by the wind over a fetch."""

from __future__ import annotations

from typing import Any

from catopt.loads.environment import HMAX_OVER_HS, SeaState
from catopt.loads.wave_growth import GROWING_MEAN, grown_sea
from catopt.sizing.environment import WIND_MEAN, mean_over, usual_period
from catopt.sizing.input_values import ResolvedInputs
from catopt.sizing.wind import blowing
from catopt.words import Message


def sea_of(of: ResolvedInputs) -> SeaState | None:
    """Make the waves; the period follows from the height, or from the fetch, if not given.

    None where wind or depth is missing, without which a fetch raises no sea; that is told there.
    """
    if "fetch" in of.given:
        wind, depth = _wind(of), _depth(of)
        if None in {of["fetch"], wind, depth}:
            return None
        grown = grown_sea(wind, of["fetch"], depth)
        return SeaState(of["period"] or grown.peak_period, grown.hs)
    height, largest = of["hs"], of["hmax"]
    significant = height if height is not None else (largest or 0.0) / HMAX_OVER_HS
    return SeaState(of["period"] or usual_period(significant), height, largest)


def has_waves(of: ResolvedInputs) -> bool:
    """Whether a height or a fetch is known."""
    return "fetch" in of.given or of["hs"] is not None or of["hmax"] is not None


def of_the_period(of: ResolvedInputs, key: str) -> tuple[Message, ...]:
    """Say by a key what period was taken, where none is given and the sea is of no fetch."""
    if not has_waves(of) or not of.given.isdisjoint({"period", "fetch"}):
        return ()
    sea = sea_of(of)
    return () if sea is None else (Message(key, period=sea.period),)


def of_the_fetch(of: ResolvedInputs) -> tuple[Message, ...]:
    """Say what sea was taken, and of which wind, fetch and depth it is."""
    sea = sea_of(of) if "fetch" in of.given else None
    if sea is None:
        return ()
    values = {"hs": sea.hs, "period": sea.period, "speed": _wind(of), "depth": _depth(of)}
    return (Message("sizing.of_fetch", fetch=of["fetch"] / 1000.0, **values),)


def _depth(of: ResolvedInputs) -> Any:
    """Depth over the fetch, m: that of the place at high water where no other is given."""
    return of["fetch_depth"] or of["depth"]


def _wind(of: ResolvedInputs) -> Any:
    """Return the wind as a mean of 10 min, m/s; that on a buoy is taken for one."""
    speed = blowing(of)
    if of.moored == "buoy" or speed is None:
        return speed
    return mean_over(speed, of["wind_mean"] or WIND_MEAN, GROWING_MEAN)
