"""A page as PDF, printed by the browser at hand."""

from __future__ import annotations

import os
import shutil
import subprocess
from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Final

from catopt.errors import CatoptError, refused
from catopt.words import Message

_NAMES: Final = (
    *("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome"),
    *("microsoft-edge", "microsoft-edge-stable", "msedge", "brave-browser"),
)
_PLACES: Final = (
    "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
    "/Applications/Microsoft Edge.app/Contents/MacOS/Microsoft Edge",
    "/Applications/Chromium.app/Contents/MacOS/Chromium",
)
_ON_WINDOWS: Final = (
    r"Google\Chrome\Application\chrome.exe",
    r"Microsoft\Edge\Application\msedge.exe",
)
BROWSER: Final = "CATOPT_BROWSER"
"""Variable of the environment that names the browser."""
_PATIENCE: Final = 300.0
"""Seconds that printing may take."""


def browser() -> str:
    """Find a browser that prints; InputError with the way out where there is none."""
    own = os.environ.get(BROWSER)
    if own is not None:
        found = shutil.which(own)
        if found is None:
            raise refused(BROWSER, own, Message("refused_command.no_such_browser"), "environment")
        return found
    for program in _browsers():
        if found := shutil.which(program):
            return found
    raise refused("--pdf", "", Message("refused_command.no_browser", variable=BROWSER), "options")


def _browsers() -> Iterator[str]:
    yield from (*_NAMES, *_PLACES)
    for folder in ("PROGRAMFILES", "PROGRAMFILES(X86)", "LOCALAPPDATA"):
        yield from (str(Path(os.environ.get(folder, "")) / place) for place in _ON_WINDOWS)


def printed(page: bytes, by: str) -> bytes:
    """Print a page on A4 by a browser; CatoptError with what it said where it does not."""
    with TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        source, target = Path(folder) / "page.html", Path(folder) / "page.pdf"
        source.write_bytes(page)
        command = [
            by,
            "--headless",
            "--disable-gpu",
            "--no-first-run",
            f"--user-data-dir={folder}/profile",
            "--no-pdf-header-footer",
            "--generate-pdf-document-outline",
            f"--print-to-pdf={target}",
            source.as_uri(),
        ]
        if hasattr(os, "geteuid") and os.geteuid() == 0:
            command.insert(1, "--no-sandbox")  # without which none runs as root
        try:
            run = subprocess.run(command, capture_output=True, timeout=_PATIENCE, check=False)
            said = run.stderr.decode(errors="replace").strip()
        except (OSError, subprocess.TimeoutExpired) as error:
            said = str(error)
        if not target.is_file():
            last = said.splitlines()[-1:] or ["-"]
            raise CatoptError(Message("refused_command.not_printed", browser=by, said=last[0]))
        return target.read_bytes()
