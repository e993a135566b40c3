"""Sizings that the page has run in motion: how far one is, how it stops, what it came to."""

from __future__ import annotations

from collections import OrderedDict
from dataclasses import dataclass, field
from threading import Event
from typing import TYPE_CHECKING, Final

from catopt.page_api.fields import Door
from catopt.progress import watched
from catopt.sizing.file import parse_file, sized

if TYPE_CHECKING:
    from catopt.sizing import Sizing

_KEPT: Final = 8
"""Sizings that are kept by their files."""


@dataclass
class _Run:
    done: float = 0.0
    total: float = 1.0
    stops: Event = field(default_factory=Event)

    def tell(self, done: float, total: float) -> None:
        """Note how much is done; KeyboardInterrupt where it is to stop."""
        self.done, self.total = max(self.done, done), total
        if self.stops.is_set():
            raise KeyboardInterrupt


_now: list[_Run] = []
_found: OrderedDict[str, Sizing] = OrderedDict()


def run(text: str, door: Door) -> Sizing | None:
    """Size what a file describes, in motion as it asks or fast; None where it was stopped."""
    own = _Run()
    _now[:] = [own]
    try:
        with watched(own.tell):
            found = sized(parse_file(text, door if door == "tanker" else "buoy"))
    except KeyboardInterrupt:
        return None
    finally:
        _now.clear()
    _found[text] = found
    while len(_found) > _KEPT:
        _found.popitem(last=False)
    return found


def found_in_motion(text: str) -> Sizing | None:
    """Give what a run of a file came to, if it was run."""
    return _found.get(text)


def progress() -> dict[str, object]:
    """Say how much of the run is done; nothing of none."""
    return {"done": _now[0].done, "total": _now[0].total} if _now else {}


def stop() -> dict[str, object]:
    """Stop the run at its next step."""
    for started in _now:
        started.stops.set()
    return {}
