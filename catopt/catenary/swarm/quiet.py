"""pyswarms without its logging.

pyswarms makes a Reporter when it is imported and with every object that it builds. A Reporter
opens ./report.log for writing and gives the root logger new handlers and a new level, unless the
environment variable LOG_CFG names another configuration. So it is given one that does nothing, as
long as it needs one: no file, no change of the user's logging, and no failure in a folder that
cannot be written to.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from threading import RLock

_VARIABLE = "LOG_CFG"
_NOTHING = Path(__file__).with_name("no-logging.yaml")
_LOCK = RLock()  # the environment belongs to the process: one thread at a time


@contextmanager
def without_logging() -> Iterator[None]:
    """Let pyswarms be imported and its objects be built without touching logging."""
    with _LOCK:
        before = os.environ.get(_VARIABLE)
        os.environ[_VARIABLE] = str(_NOTHING)
        try:
            yield
        finally:
            if before is None:
                del os.environ[_VARIABLE]
            else:
                os.environ[_VARIABLE] = before
