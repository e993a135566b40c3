"""``catopt app`` answers its own page, and nothing else."""

from __future__ import annotations

import http.client
import json
import random
import socket
import struct
from contextlib import closing
from threading import Thread
from typing import Any

import pytest

from catopt.page_api import ask
from catopt.page_api.fields import START
from catopt.web.build import PageServer

QUESTION: dict[str, Any] = {"door": "line", "values": START["line"]}


def reply(
    server: PageServer, method: str, path: str, body: str = "", **headers: str
) -> tuple[int, bytes]:
    told = {"Host": server.host, "Content-Length": str(len(body)), **headers}
    connection = http.client.HTTPConnection("127.0.0.1", server.server_port, timeout=30)
    with closing(connection):
        connection.request(method, path, body.encode() or None, told)
        answer = connection.getresponse()
        return answer.status, answer.read()


def answered(server: PageServer, call: str = "solve", question: dict[str, Any] = QUESTION) -> Any:
    """Ask a question of the page and read the answer."""
    path = f"/{server.token}/ask/{call}"
    status, answer = reply(server, "POST", path, json.dumps(question))
    assert status == 200
    return json.loads(answer)


def test_it_gives_the_page_and_answers_its_questions(server: PageServer) -> None:
    status, page = reply(server, "GET", f"/{server.token}/")
    assert status == 200
    assert b'data-transport="app"' in page
    assert answered(server) == json.loads(json.dumps(ask("solve", QUESTION)))
    compared = QUESTION | {"kept": ask("file", QUESTION)["text"]}
    assert answered(server, "compare", compared) == ask("compare", compared)


def test_it_listens_on_this_machine_alone_and_two_have_two_tokens(server: PageServer) -> None:
    assert server.server_address[0] == "127.0.0.1"
    with PageServer() as other:
        assert other.token != server.token
        assert len(other.token) >= 32


ELSEWHERE: list[dict[str, str]] = [
    {"Host": "example.org"},
    {"Host": "127.0.0.1"},
    {"Origin": "http://example.org"},
    {"Origin": "null"},
]
REFUSED: list[tuple[str, str, dict[str, str], int]] = [
    *(
        (line, json.dumps(QUESTION), headers, 403)
        for line in ("GET /TOKEN/", "POST /TOKEN/ask/solve")
        for headers in ELSEWHERE
    ),
    *(
        (f"{method} {path}", "{}", {}, 403)
        for method in ("GET", "POST")
        for path in ("/", "/wrong/", "/wrong/ask/solve", "//", "/%00/")
    ),
    ("POST /TOKEN/ask/eval", "{}", {}, 404),
    ("POST /TOKEN/other", "{}", {}, 404),
    ("POST /TOKEN/ask/solve", "{", {}, 400),
    ("POST /TOKEN/ask/solve", "[]", {}, 400),
    ("POST /TOKEN/ask/solve", "", {"Content-Length": "99999999999"}, 413),
    ("POST /TOKEN/ask/solve", "", {"Content-Length": "-1"}, 413),
]
"""What another host, origin or token asks, and what is no question."""


@pytest.mark.parametrize(("line", "body", "headers", "status"), REFUSED)
def test_what_is_not_its_own_page_s_question_is_refused(
    server: PageServer, line: str, body: str, headers: dict[str, str], status: int
) -> None:
    method, path = line.replace("TOKEN", server.token).split()
    assert reply(server, method, path, body, **headers)[0] == status
    assert reply(server, "GET", f"/{server.token}/")[0] == 200


def test_two_pages_at_once_get_each_their_own_answer(server: PageServer) -> None:
    forces = [f"{force} kN" for force in range(100, 120)]
    found: dict[str, float] = {}

    def one(force: str) -> None:
        values = START["line"] | {"load.horizontal_force": force}
        solved = answered(server, question={"door": "line", "values": values})
        found[force] = solved["horizontal_force_N"]

    pages = [Thread(target=one, args=(force,)) for force in forces]
    for page in pages:
        page.start()
    for page in pages:
        page.join()
    assert found == {force: 1e3 * float(force.split()[0]) for force in forces}


def test_a_page_that_is_closed_in_the_middle_of_a_search_ends_nothing(
    server: PageServer, capfd: pytest.CaptureFixture[str]
) -> None:
    question = json.dumps({"door": "tanker", "values": START["tanker"]}).encode()
    head = f"POST /{server.token}/ask/size HTTP/1.1\r\nHost: {server.host}\r\n"
    with socket.create_connection(("127.0.0.1", server.server_port)) as closed:
        closed.sendall(f"{head}Content-Length: {len(question)}\r\n\r\n".encode() + question)
        closed.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
    assert answered(server)
    assert "Traceback" not in capfd.readouterr().err


@pytest.mark.slow
def test_it_survives_a_thousand_requests_at_random(
    server: PageServer, capfd: pytest.CaptureFixture[str]
) -> None:
    """Words of a request in any order, cut anywhere, with bytes that belong nowhere."""
    draw = random.Random(29)
    words = (
        b"GET |POST |PUT |HEAD |/|/ask/solve|/ask/eval| HTTP/1.1| HTTP/9.9|\r\n|\r\n\r\n|Host: |"
        b'Content-Length: 5|Content-Length: -5|Origin: null|{}|{"text": 3}|\x00\xff|\xe1\xba\xbf|: '
    ).split(b"|")
    words += [server.token.encode(), server.host.encode(), b"[" * 3000]
    for _ in range(1000):
        sent = b"".join(draw.choices(words, k=draw.randint(1, 16)))
        with socket.create_connection(("127.0.0.1", server.server_port)) as connection:
            connection.sendall(sent[: draw.randint(1, len(sent))])
    assert answered(server)
    assert "Traceback" not in capfd.readouterr().err
