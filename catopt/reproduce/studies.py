"""Which published calculations can be recomputed, by name."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from catopt.errors import InputError, Problem
from catopt.mooring.sharing_rule import load_sharing_factor
from catopt.reproduce import (
    buoy_9p5m,
    calmar,
    fso_rang_dong,
    fso_rang_dong_dynamic,
    lines_in_motion,
    reference_moorings,
    ship_lines,
    ship_loads,
)
from catopt.reproduce.items import Reproduction, Study, compare, published, study_of
from catopt.words import Message

Progress = Callable[[int, int], None]


def load_sharing() -> Study:
    """Add up the lines of the loaded half of S4's ring of lines, and judge the printed factors."""
    source = published("load_sharing")
    numbers = [int(lines) for lines in source.series["lines"]]
    factors = {f"FT_over_F_{lines}_lines": load_sharing_factor(lines) for lines in numbers}
    return study_of(
        source,
        compare(source, "N/4 rule", factors, computed_by="the rule's sum"),
        (
            Message("reproduce.line_force_ft_points_along"),
            Message("reproduce.rule_holds_for_equal_lines"),
        ),
    )


_STUDIES: dict[str, Callable[[], Study]] = {
    buoy_9p5m.NAME: buoy_9p5m.study,
    "ship_200m": ship_lines.ship_200m,
    "tanker_20m": ship_lines.tanker_20m,
    "tanker_20m_loads": ship_loads.tanker_20m_loads,
    "tanker_20m_sinker": ship_lines.tanker_20m_sinker,
    "load_sharing": load_sharing,
    fso_rang_dong.NAME: fso_rang_dong.study,
    "fso_rang_dong_loads": ship_loads.fso_rang_dong_loads,
    fso_rang_dong_dynamic.NAME: fso_rang_dong_dynamic.study,
    **{name: partial(reference_moorings.study, name) for name in reference_moorings.NAMES},
    "bridle": reference_moorings.bridle,
    lines_in_motion.CHAIN: lines_in_motion.chain_study,
    lines_in_motion.CABLE: lines_in_motion.cable_study,
    calmar.NAME: calmar.study,
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
    by_swarm = {buoy_9p5m.NAME: partial(buoy_9p5m.study, progress)}
    return Reproduction(tuple((_STUDIES | by_swarm)[each]() for each in wanted))


def _allowed(name: str) -> Message:
    from catopt.catalogue.family import meant

    return meant(Message("refused.one_of", words=", ".join(names())), name, names())
