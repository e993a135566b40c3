"""Answers the page on this machine alone: the server of ``catopt app``."""

from __future__ import annotations

import hmac
import json
import secrets
import sys
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from threading import Lock
from typing import Any, Final

from catopt.desk import CALLS, ask
from catopt.documents import MOST_BYTES
from catopt.web.build import document

__all__ = ["PageServer"]

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
            with self.server.one_at_a_time:
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
