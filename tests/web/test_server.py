"""``catopt app`` answers its own page, and nothing else."""

from __future__ import annotations

import http.client
import json
import random
import socket
import struct
from collections.abc import Iterator
from threading import Thread
from typing import Any

import pytest

from catopt.desk import ask
from catopt.desk.fields import START
from catopt.web.server import PageServer

QUESTION: dict[str, Any] = {"door": "line", "values": START["line"]}


@pytest.fixture
def server() -> Iterator[PageServer]:
    with PageServer() as made:
        thread = Thread(target=made.serve_forever)
        thread.start()
        yield made
        made.shutdown()
        thread.join()


def reply(
    server: PageServer, method: str, path: str, body: str = "", **headers: str
) -> tuple[int, bytes]:
    connection = http.client.HTTPConnection("127.0.0.1", server.server_port, timeout=30)
    connection.putrequest(method, path, skip_host=True)
    told = {"Host": server.host, "Content-Length": str(len(body)), **headers}
    for name, value in told.items():
        connection.putheader(name, value)
    connection.endheaders(body.encode() or None)
    answer = connection.getresponse()
    found = answer.status, answer.read()
    connection.close()
    return found


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


def test_it_listens_on_this_machine_alone(server: PageServer) -> None:
    assert server.server_address[0] == "127.0.0.1"


@pytest.mark.parametrize("method", ["GET", "POST"])
@pytest.mark.parametrize(
    "headers",
    [
        {"Host": "example.org"},
        {"Host": "127.0.0.1"},
        {"Origin": "http://example.org"},
        {"Origin": "null"},
    ],
)
def test_another_host_or_origin_is_refused(
    server: PageServer, method: str, headers: dict[str, str]
) -> None:
    path = f"/{server.token}/" + ("ask/solve" if method == "POST" else "")
    assert reply(server, method, path, json.dumps(QUESTION), **headers)[0] == 403


@pytest.mark.parametrize("path", ["/", "/wrong/", "/wrong/ask/solve", "//", "/%00/"])
@pytest.mark.parametrize("method", ["GET", "POST"])
def test_another_token_is_refused(server: PageServer, method: str, path: str) -> None:
    assert reply(server, method, path, "{}")[0] == 403


def test_two_servers_have_two_tokens(server: PageServer) -> None:
    with PageServer() as other:
        assert other.token != server.token
        assert len(other.token) >= 32


@pytest.mark.parametrize(
    ("path", "body", "headers", "status"),
    [
        ("ask/eval", "{}", {}, 404),
        ("other", "{}", {}, 404),
        ("ask/solve", "{", {}, 400),
        ("ask/solve", "[]", {}, 400),
        ("ask/solve", "", {"Content-Length": "99999999999"}, 413),
        ("ask/solve", "", {"Content-Length": "-1"}, 413),
    ],
)
def test_what_is_no_question_is_refused(
    server: PageServer, path: str, body: str, headers: dict[str, str], status: int
) -> None:
    assert reply(server, "POST", f"/{server.token}/{path}", body, **headers)[0] == status
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
    words = [
        b"GET ", b"POST ", b"PUT ", b"HEAD ", b"/", server.token.encode(), b"/ask/solve",
        b"/ask/eval", b" HTTP/1.1", b" HTTP/9.9", b"\r\n", b"\r\n\r\n", b"Host: ",
        server.host.encode(), b"Content-Length: 5", b"Content-Length: -5", b"Origin: null", b"{}",
        b'{"text": 3}', b"\x00\xff", b"\xe1\xba\xbf", b": ", b"[" * 3000,
    ]  # fmt: skip
    for _ in range(1000):
        sent = b"".join(draw.choices(words, k=draw.randint(1, 16)))
        with socket.create_connection(("127.0.0.1", server.server_port)) as connection:
            connection.sendall(sent[: draw.randint(1, len(sent))])
    assert answered(server)
    assert "Traceback" not in capfd.readouterr().err
