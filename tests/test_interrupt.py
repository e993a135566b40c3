"""Ctrl-C that comes where Python swallows it, and what follows from one."""

from __future__ import annotations

import subprocess
import sys

import pytest

SWALLOWED = """
import os, signal, sys, time, weakref
from catopt.interrupt import heed_signals, was_interrupted

signal.signal(signal.SIGINT, signal.default_int_handler)
heed_signals()

class Thing:
    pass

def lost(_):
    os.kill(os.getpid(), signal.SIGINT)
    time.sleep(1.0)

thing = Thing()
reference = weakref.ref(thing, lost)
try:
    assert not was_interrupted()
    del thing
    time.sleep(60.0)
    print("never")
except KeyboardInterrupt:
    print("stopped", was_interrupted())
"""

FOLLOWS = """
import os, signal, sys
import catopt.cli.app
from catopt.__main__ import main

def command(**_):
    try:
        os.kill(os.getpid(), {signal})
        while True:
            pass
    except KeyboardInterrupt as stop:
        raise ValueError("min() arg is an empty sequence") from stop

signal.signal(signal.SIGINT, signal.default_int_handler)
catopt.cli.app.command = command
sys.argv = ["catopt"]
sys.exit(main())
"""

posix = pytest.mark.skipif(sys.platform == "win32", reason="no process sends itself Ctrl-C there")


def ran(script: str) -> subprocess.CompletedProcess[str]:
    """Run a script as a process of its own."""
    return subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, timeout=50, check=False
    )


@posix
def test_one_that_is_swallowed_comes_again() -> None:
    ended = ran(SWALLOWED)
    assert (ended.stdout, ended.stderr) == ("stopped True\n", "")


@posix
@pytest.mark.parametrize("name", ["SIGINT", "SIGTERM"])
def test_an_error_that_follows_from_one_is_no_fault(name: str) -> None:
    ended = ran(FOLLOWS.format(signal=f"signal.{name}"))
    assert (ended.returncode, ended.stderr) == (130, "catopt: interrupted\n")
