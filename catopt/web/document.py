"""The page as one HTML document, for a browser that has Python itself or for ``catopt app``."""

from __future__ import annotations

import base64
import json
from collections.abc import Mapping, Sequence
from importlib.resources import files
from typing import Any, Final

from catopt.desk import ask, shell
from catopt.desk.fields import DOORS, START
from catopt.render.looks import stylesheet
from catopt.words import LANGUAGES

__all__ = ["document"]

_STYLE: Final = "style-src 'unsafe-inline'; img-src data:; base-uri 'none'; form-action 'none'"
_SCRIPT: Final = "script-src 'unsafe-inline' data: blob: 'wasm-unsafe-eval'"


def document(pieces: Mapping[str, bytes] | Sequence[str] | None = None) -> str:
    """Write the page as HTML, in which no address of another host stands.

    `pieces` are what Python in the browser is made of: compressed, to be put into the page; the
    names of files beside it; or None where catopt app answers.
    """
    inside = pieces if isinstance(pieces, Mapping) else {}
    connects = "'self'" if not inside else "'none'"
    text = _file("web", "index.html")
    policy = ("default-src 'none'", _SCRIPT, "worker-src blob:", f"connect-src {connects}", _STYLE)
    filled = {
        "policy": "; ".join(policy),
        "style": stylesheet() + _file("render", "style.css") + _file("web", "desk.css"),
        "imports": json.dumps({"imports": _modules()}),
        "transport": "app" if pieces is None else "worker",
        "shells": _inert(json.dumps({each: shell(each) for each in LANGUAGES})),
        "first": _inert(json.dumps({} if pieces is None else _first())),
        "pieces": "" if pieces is None else _pieces(list(pieces), inside),
    }
    for name, value in filled.items():
        text = text.replace(f"{{{{ {name} }}}}", value)
    return text


def _first() -> dict[str, dict[str, Any]]:
    """Answer what the page opens with, so that it need not wait for Python."""
    door = DOORS[0]
    question = {"door": door, "values": START[door]}
    return {each: {door: ask("whole", {**question, "lang": each})} for each in LANGUAGES}


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
