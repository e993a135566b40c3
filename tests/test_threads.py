"""The command solves its equations in one thread, unless the user has set another number."""

from __future__ import annotations

import os
import subprocess
import sys

import pytest

VARIABLES = ("OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "OMP_NUM_THREADS")
SEEN = """
import os, sys
from catopt.__main__ import main
sys.argv = ["catopt", "--version"]
try:
    main()
finally:
    print([os.environ.get(name) for name in {names!r}])
"""


@pytest.mark.parametrize(("given", "used"), [(None, "1"), ("3", "3")])
def test_the_command_uses_one_thread(given: str | None, used: str) -> None:
    environment = {name: value for name, value in os.environ.items() if name not in VARIABLES}
    if given is not None:
        environment |= dict.fromkeys(VARIABLES, given)
    ran = subprocess.run(
        [sys.executable, "-c", SEEN.format(names=VARIABLES)],
        env=environment, capture_output=True, text=True, check=True,
    )  # fmt: skip
    assert str([used] * 3) in ran.stdout
