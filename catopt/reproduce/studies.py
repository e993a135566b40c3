"""Which published calculations can be recomputed, by name."""

from __future__ import annotations

from collections.abc import Callable

from catopt.errors import InputError, Problem
from catopt.reproduce import (
    bridle,
    buoy_9p5m,
    fso_rang_dong,
    fso_rang_dong_dynamic,
    fso_rang_dong_loads,
    lines_in_motion,
    load_sharing,
    reference_moorings,
    ship_200m,
    tanker_20m,
    tanker_20m_loads,
    tanker_20m_sinker,
)
from catopt.reproduce.items import Reproduction, Study

Progress = Callable[[int, int], None]

_STUDIES: dict[str, Callable[[Progress | None], Study]] = {
    buoy_9p5m.NAME: buoy_9p5m.study,
    ship_200m.NAME: lambda _progress: ship_200m.study(),
    tanker_20m.NAME: lambda _progress: tanker_20m.study(),
    tanker_20m_loads.NAME: lambda _progress: tanker_20m_loads.study(),
    tanker_20m_sinker.NAME: lambda _progress: tanker_20m_sinker.study(),
    load_sharing.NAME: lambda _progress: load_sharing.study(),
    fso_rang_dong.NAME: lambda _progress: fso_rang_dong.study(),
    fso_rang_dong_loads.NAME: lambda _progress: fso_rang_dong_loads.study(),
    fso_rang_dong_dynamic.NAME: lambda _progress: fso_rang_dong_dynamic.study(),
    **{
        name: lambda _progress, name=name: reference_moorings.study(name)  # type: ignore[misc]
        for name in reference_moorings.NAMES
    },
    bridle.NAME: lambda _progress: bridle.study(),
    lines_in_motion.CHAIN: lambda _progress: lines_in_motion.chain_study(),
    lines_in_motion.CABLE: lambda _progress: lines_in_motion.cable_study(),
}


def names() -> tuple[str, ...]:
    """Names that `reproduce` knows."""
    return tuple(_STUDIES)


def reproduce(name: str | None = None, *, progress: Progress | None = None) -> Reproduction:
    """Recompute what was published.

    Parameters
    ----------
    name : str, optional
        One study; all of them when left out.
    progress : callable, optional
        Told of the swarm runs done and wanted, as they are done.

    Raises
    ------
    InputError
        No study has that name.
    """
    if name is not None and name not in _STUDIES:
        raise InputError([Problem("name", repr(name), _allowed(name))], "reproduce")
    wanted = names() if name is None else (name,)
    return Reproduction(tuple(_STUDIES[each](progress) for each in wanted))


def _allowed(name: str) -> str:
    from catopt.catalogue.names import nearest

    near = nearest(name, names())
    hint = f"; did you mean {near}?" if near else ""
    return f"one of {', '.join(names())} is wanted{hint}"
