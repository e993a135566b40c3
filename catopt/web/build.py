"""The page that runs catopt in a browser: built of pinned parts, or answered on this machine."""

from __future__ import annotations

import base64
import gzip
import hashlib
import hmac
import io
import json
import secrets
import sys
import tarfile
import tomllib
import zipfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import nullcontext
from dataclasses import dataclass
from functools import cache
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from importlib.resources import files
from pathlib import Path
from threading import Lock
from typing import Any, Final

from catopt._version import version_and_commit
from catopt.documents import MOST_BYTES
from catopt.errors import refused
from catopt.page_api import ABOUT_A_RUN, CALLS, ask, shell
from catopt.page_api.fields import DOORS, START
from catopt.render.svg import stylesheet
from catopt.words import LANGUAGES, Message

_STYLE: Final = "style-src 'unsafe-inline'; img-src data:; base-uri 'none'; form-action 'none'"
_SCRIPT: Final = "script-src 'unsafe-inline' data: blob: 'wasm-unsafe-eval'"


def document(pieces: Mapping[str, bytes] | Sequence[str] | None = None) -> str:
    """Write the page as HTML, in which no address of another host stands.

    `pieces` are what Python in the browser is made of: compressed, to be put into the page; the
    names of files beside it; or None where catopt app answers.
    """
    inside = pieces if isinstance(pieces, Mapping) else {}
    connects = "'self'" if not inside else "'none'"
    first = {}
    if pieces is not None:  # what the page opens with, so that it need not wait for Python
        door = DOORS[0]
        question = {"door": door, "values": START[door]}
        first = {
            language: {door: ask("whole", {**question, "lang": language})} for language in LANGUAGES
        }
    text = _file("web", "index.html")
    policy = ("default-src 'none'", _SCRIPT, "worker-src blob:", f"connect-src {connects}", _STYLE)
    filled = {
        "policy": "; ".join(policy),
        "style": stylesheet() + _file("render", "style.css") + _file("web", "desk.css"),
        "imports": json.dumps({"imports": _modules()}),
        "transport": "app" if pieces is None else "worker",
        "shells": _inert(
            json.dumps({language: shell(language, runs=pieces is None) for language in LANGUAGES})
        ),
        "first": _inert(json.dumps(first)),
        "pieces": "" if pieces is None else _pieces(list(pieces), inside),
    }
    for name, value in filled.items():
        text = text.replace(f"{{{{ {name} }}}}", value)
    return text


def _modules() -> dict[str, str]:
    """Write the scripts as addresses that hold them: modules from disk may not import files."""
    figures = f"export const listen = () => {{\n{_file('render', 'script.js')}\n}};\n"
    scripts = {"page": _file("web", "page.js"), "ask": _file("web", "ask.js"), "figures": figures}
    return {
        f"catopt/{name}": f"data:text/javascript;base64,{base64.b64encode(text.encode()).decode()}"
        for name, text in scripts.items()
    }


def _pieces(names: list[str], inside: Mapping[str, bytes]) -> str:
    made = [
        f'<script type="text/plain" id="worker">{_file("web", "worker.js")}</script>',
        f'<script type="application/json" id="pieces">{json.dumps(names)}</script>',
    ]
    made += [
        f'<script type="text/plain" id="piece-{name}">{base64.b64encode(data).decode()}</script>'
        for name, data in inside.items()
    ]
    return "\n".join(made)


def _file(part: str, name: str) -> str:
    return files(f"catopt.{part}").joinpath(name).read_text("utf-8")


def _inert(text: str) -> str:
    """Keep a text from ending the script element that it stands in."""
    return text.replace("<", "\\u003c")


_LOADER: Final = ("pyodide.mjs", "pyodide.asm.mjs", "pyodide.asm.wasm", "python_stdlib.zip")
_WITHOUT: Final = ("cli", "fem", "reproduce", "decks", "export")
"""Parts of catopt that nothing asks for in a browser."""
_WHEN: Final = (1980, 1, 1, 0, 0, 0)
_WAIT: Final = 120.0
"""Seconds that a server may take to answer."""


@dataclass(frozen=True)
class PinnedPart:
    """A file from a package registry, with the SHA-256 of its bytes."""

    name: str
    url: str
    sha256: str


@cache
def parts() -> tuple[PinnedPart, ...]:
    """List what a browser needs beside catopt; Pyodide comes first."""
    table = tomllib.loads(files("catopt.web").joinpath("parts.toml").read_text("utf-8"))
    return tuple(PinnedPart(**part) for part in table["parts"])


def fetched(part: PinnedPart, folder: Path | None = None) -> bytes:
    """Read a part from a folder, by its name, or where none is given from its registry.

    InputError when it is not there, cannot be fetched, or is another file than the pinned one.
    """
    from urllib.request import urlopen

    way = Message("refused_command.put_into_folder_from_at", url=part.url)
    try:
        if folder is not None:
            data = (folder / part.name).read_bytes()
        else:
            with urlopen(part.url, timeout=_WAIT) as answer:
                data = answer.read()
    except OSError as error:
        raise refused(part.name, str(error), way, "web") from error
    found = hashlib.sha256(data).hexdigest()
    if found != part.sha256:
        wanted = Message("refused_command.must_be", sha256=part.sha256, way=way)
        raise refused(part.name, f"SHA-256 {found}", wanted, "web")
    return data


def pieces(read: Callable[[PinnedPart], bytes]) -> dict[str, bytes]:
    """Make what the worker of the page takes, by name, each compressed by gzip.

    `read` gives the bytes of a part. The same parts and the same catopt give the same bytes.
    """
    pyodide, *others = parts()
    loader = _unpacked(read(pyodide))
    made = {name: loader[f"package/{name}"] for name in _LOADER}
    lock = json.loads(loader["package/pyodide-lock.json"]) | {"packages": {}}
    made["pyodide-lock.json"] = json.dumps(lock).encode()
    made["site.zip"] = site([read(part) for part in others])
    return {name: gzip.compress(data, 9, mtime=0) for name, data in made.items()}


def site(archives: Sequence[bytes]) -> bytes:
    """Pack catopt and Python packages, wheels or source archives with ``src``, into one archive."""
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w", zipfile.ZIP_STORED) as packed:
        for name, data in (*_packages(archives), *_own()):
            packed.writestr(zipfile.ZipInfo(name, _WHEN), data)
    return made.getvalue()


def _packages(archives: Sequence[bytes]) -> Iterator[tuple[str, bytes]]:
    for archive in archives:
        for name, data in sorted(_unpacked(archive).items()):
            place = name.partition("/src/")[2] if "/src/" in name else name
            is_source = place != name or not archive.startswith(b"\x1f\x8b")
            if is_source and place.endswith((".py", ".so", "METADATA")):
                yield place, data


def _own() -> Iterator[tuple[str, bytes]]:
    """Yield catopt's own files, but for what no browser asks for."""
    root = Path(str(files("catopt")))
    for path in sorted(root.rglob("*")):
        inside = path.relative_to(root)
        is_asked_for = inside.parts[0] not in (*_WITHOUT, "web")
        if path.is_file() and is_asked_for and not {"__pycache__", "_build.py"} & {*inside.parts}:
            yield f"catopt/{inside.as_posix()}", path.read_bytes()
    version, commit = version_and_commit()
    yield "catopt/_build.py", f"VERSION = {version!r}\nCOMMIT = {commit!r}\n".encode()
    yield "numpy/__init__.py", root.joinpath("web", "plain_numpy.py").read_bytes()
    yield "numpy/typing.py", b"from numpy import ArrayLike, NDArray\n"


def _unpacked(archive: bytes) -> dict[str, bytes]:
    """Read the files of a wheel or of a compressed tar archive."""
    if not archive.startswith(b"\x1f\x8b"):
        with zipfile.ZipFile(io.BytesIO(archive)) as packed:
            return {name: packed.read(name) for name in packed.namelist() if name[-1] != "/"}
    with tarfile.open(fileobj=io.BytesIO(archive)) as packed_tar:
        found = (
            (member.name, packed_tar.extractfile(member)) for member in packed_tar.getmembers()
        )
        return {name: data.read() for name, data in found if data is not None}


_HOST: Final = "127.0.0.1"


class PageServer(ThreadingHTTPServer):
    """Serves the page, and answers its questions one after the other.

    `port` is of 127.0.0.1, 0 any that is free; the random `token` stands in the page's address, and
    nothing is answered without it.
    """

    daemon_threads = True
    request_queue_size = 64

    def __init__(self, port: int = 0) -> None:
        self.token = secrets.token_urlsafe(24)
        self.page = document().encode()
        self.one_at_a_time = Lock()
        super().__init__((_HOST, port), _Handler)

    def handle_error(self, request: Any, client_address: Any) -> None:
        """Say what went wrong, but for a page that was closed meanwhile."""
        if not isinstance(sys.exc_info()[1], ConnectionError):
            super().handle_error(request, client_address)

    @property
    def host(self) -> str:
        """Host and port, as a browser says them."""
        return f"{_HOST}:{self.server_port}"

    @property
    def address(self) -> str:
        """Of the page."""
        return f"http://{self.host}/{self.token}/"


class _Handler(BaseHTTPRequestHandler):
    server: PageServer
    protocol_version = "HTTP/1.1"
    server_version = "catopt"
    sys_version = ""
    timeout = 60

    def do_GET(self) -> None:
        """Give the page."""
        place = self._place()
        if place == "":
            self._give(HTTPStatus.OK, self.server.page, "text/html; charset=utf-8")
        elif place is not None:
            self._refuse(HTTPStatus.NOT_FOUND)

    def do_POST(self) -> None:
        """Answer a question."""
        place = self._place()
        if place is None:
            return
        part, _, call = place.partition("/")
        if part != "ask" or call not in CALLS:
            self._refuse(HTTPStatus.NOT_FOUND)
            return
        length = self.headers.get("Content-Length", "")
        if not length.isdecimal() or int(length) > MOST_BYTES:
            self._refuse(HTTPStatus.REQUEST_ENTITY_TOO_LARGE)
            return
        try:
            question = json.loads(self.rfile.read(int(length)))
            if not isinstance(question, dict):
                raise TypeError
        except (ValueError, TypeError, RecursionError):
            self._refuse(HTTPStatus.BAD_REQUEST)
            return
        try:
            with nullcontext() if call in ABOUT_A_RUN else self.server.one_at_a_time:
                reply = json.dumps(ask(call, question)).encode()
        except Exception:
            self._refuse(HTTPStatus.INTERNAL_SERVER_ERROR)
            raise
        self._give(HTTPStatus.OK, reply, "application/json")

    def _place(self) -> str | None:
        """Return the path behind the token; refuse and return None for what is not the page's."""
        server = self.server
        is_ours = self.headers.get("Host") == server.host
        is_ours &= self.headers.get("Origin", f"http://{server.host}") == f"http://{server.host}"
        token, _, place = self.path.removeprefix("/").partition("/")
        if is_ours and hmac.compare_digest(token.encode(), server.token.encode()):
            return place
        self._refuse(HTTPStatus.FORBIDDEN)
        return None

    def _refuse(self, status: HTTPStatus) -> None:
        self.close_connection = True
        self._give(status, status.phrase.encode(), "text/plain; charset=utf-8")

    def _give(self, status: HTTPStatus, data: bytes, kind: str) -> None:
        self.send_response(status)
        for name, value in (
            ("Content-Type", kind),
            ("Content-Length", str(len(data))),
            ("Cache-Control", "no-store"),
            ("Referrer-Policy", "no-referrer"),
            ("X-Content-Type-Options", "nosniff"),
            ("X-Frame-Options", "DENY"),
            ("Connection", "close" if self.close_connection else "keep-alive"),
        ):
            self.send_header(name, value)
        self.end_headers()
        self.wfile.write(data)

    def log_message(self, format: str, *args: object) -> None:  # noqa: A002 - of the base
        """Keep quiet: the address has the token in it."""
