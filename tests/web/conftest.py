"""The page as `catopt app` serves it."""

from __future__ import annotations

from collections.abc import Iterator
from threading import Thread

import pytest

from catopt.web.build import PageServer


@pytest.fixture(scope="module")
def server() -> Iterator[PageServer]:
    with PageServer() as made:
        thread = Thread(target=made.serve_forever)
        thread.start()
        yield made
        made.shutdown()
        thread.join()
