"""Headless Chromium, driven over a pair of pipes: no driver and no network come into it."""

from __future__ import annotations

import base64
import itertools
import json
import os
import shlex
import shutil
import signal
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any, Literal

FONTS = ("DejaVu Sans", "Liberation Sans", "Noto Sans")
"""What a page may be read in: a wide font, a narrow one, a tall one (packages in .ci/run)."""

Scheme = Literal["light", "dark"]
CHROMIUM = next(
    (found for name in ("chromium", "google-chrome") if (found := shutil.which(name))), ""
)
"""Where it is; empty when it is not installed."""

_FLAGS = shlex.split("""
--headless --no-sandbox --disable-gpu --disable-quic --no-first-run --hide-scrollbars
--disable-background-networking --disable-component-update --disable-sync --disable-dev-shm-usage
--remote-debugging-pipe
""")


class Tab:
    """A page in the browser, what was put on its console, and the addresses it has asked for."""

    def __init__(self, write: int, read: int) -> None:
        self._write, self._read = write, read
        self._numbers = itertools.count(1)
        self._rest = b""
        self._session = ""
        self.messages: list[str] = []
        self.requests: list[str] = []
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        attached = self.call("Target.attachToTarget", targetId=target, flatten=True)
        self._session = attached["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(f"{domain}.enable")

    def call(self, method: str, **parameters: Any) -> dict[str, Any]:
        """Ask the browser for something and wait for its answer."""
        number = next(self._numbers)
        message: dict[str, Any] = {"id": number, "method": method, "params": parameters}
        if self._session:
            message["sessionId"] = self._session
        os.write(self._write, json.dumps(message).encode() + b"\0")
        while True:
            answer = self._next()
            if answer.get("id") == number:
                assert "error" not in answer, answer
                return dict(answer["result"])

    def open(
        self,
        page: Path,
        width: int,
        *,
        height: int = 900,
        scheme: Scheme = "light",
        scripts: bool = True,
    ) -> None:
        """Open a file at a width, in a colour scheme, with or without scripts."""
        self.call("Emulation.setScriptExecutionDisabled", value=not scripts)
        screen = {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": width < 600}
        self.call("Emulation.setDeviceMetricsOverride", **screen)
        features = [{"name": "prefers-color-scheme", "value": scheme}]
        self.call("Emulation.setEmulatedMedia", features=features)
        self._loaded = False
        self.call("Page.navigate", url=page.resolve().as_uri())
        while not self._loaded:
            self._next()

    def value(self, expression: str) -> Any:
        """Evaluate an expression in the page; a promise is waited for."""
        how = {"awaitPromise": True, "returnByValue": True}
        found = self.call("Runtime.evaluate", expression=expression, **how)
        assert "exceptionDetails" not in found, found
        return found["result"].get("value")

    def fonts(self) -> set[str]:
        """Families in which the page's headings and drawings are shown."""
        self.call("DOM.enable")
        self.call("CSS.enable")
        root = self.call("DOM.getDocument")["root"]["nodeId"]
        found = self.call("DOM.querySelectorAll", nodeId=root, selector="h1, figure text")
        return {
            each["familyName"]
            for node in found["nodeIds"]
            for each in self.call("CSS.getPlatformFontsForNode", nodeId=node)["fonts"]
        }

    def point_at(self, x: float, y: float) -> None:
        """Move the pointer to a place of the window."""
        self.call("Input.dispatchMouseEvent", type="mouseMoved", x=x, y=y)

    def click(self, x: float, y: float) -> None:
        """Click on a place of the window."""
        self.point_at(x, y)
        for kind in ("mousePressed", "mouseReleased"):
            self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=1)

    def press(self, key: str) -> None:
        """Press and let go of a key."""
        for kind in ("keyDown", "keyUp"):
            self.call("Input.dispatchKeyEvent", type=kind, key=key, code=key)

    def pdf(self) -> bytes:
        """Print to PDF, with the paper that the page asks for."""
        printed = self.call("Page.printToPDF", preferCSSPageSize=True, printBackground=True)
        return base64.b64decode(printed["data"])

    def _next(self) -> dict[str, Any]:
        while b"\0" not in self._rest:
            data = os.read(self._read, 1 << 16)
            assert data, "the browser has gone"
            self._rest += data
        line, _, self._rest = self._rest.partition(b"\0")
        answer: dict[str, Any] = json.loads(line)
        self._note(answer.get("method", ""), answer.get("params", {}))
        return answer

    def _note(self, method: str, told: dict[str, Any]) -> None:
        match method:
            case "Page.loadEventFired":
                self._loaded = True
            case "Runtime.consoleAPICalled" | "Runtime.exceptionThrown" | "Log.entryAdded":
                self.messages.append(json.dumps(told))
            case "Network.requestWillBeSent":
                self.requests.append(told["request"]["url"])


@contextmanager
def chromium(folder: Path, font: str = "") -> Iterator[Tab]:
    """Start the browser, which writes to a folder, and end it in any case.

    All text is in the family `font`; when that is empty, in whatever the machine has.
    """
    surroundings = dict(os.environ)
    if font:
        chosen = folder / "fonts.conf"
        template = Path(__file__).with_name("fonts.conf").read_text("utf-8")
        chosen.write_text(template.format(font=font, cache=folder / "fonts"))
        surroundings["FONTCONFIG_FILE"] = str(chosen)
    to_browser, write = os.pipe()
    read, from_browser = os.pipe()

    def third_and_fourth() -> None:
        # Both are moved out of the way first: one of them may be 3 or 4 itself.
        source, sink = os.dup(to_browser), os.dup(from_browser)
        while min(source, sink) <= 4:
            source, sink = os.dup(source), os.dup(sink)
        os.dup2(source, 3)
        os.dup2(sink, 4)

    profile = folder / "profile"
    started = subprocess.Popen(
        [CHROMIUM, *_FLAGS, f"--user-data-dir={profile}", "about:blank"],
        env=surroundings,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        close_fds=False,
        preexec_fn=third_and_fourth,
        start_new_session=True,
    )
    os.close(to_browser)
    os.close(from_browser)
    try:
        yield Tab(write, read)
    finally:
        os.close(write)
        os.close(read)
        with suppress(ProcessLookupError):
            os.killpg(started.pid, signal.SIGKILL)
        started.wait()
