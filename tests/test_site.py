"""The documentation site: built without a warning, whole without a network, and fit to be read.

The longer checks want the extra ``docs``, and Chromium (Debian's package ``chromium``).
"""

from __future__ import annotations

import importlib.util
import json
import os
import re
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Iterator
from functools import cache, partial
from html.parser import HTMLParser
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from threading import Thread
from typing import Any, Literal
from urllib.parse import unquote, urlsplit

import pytest
from markdown_it import MarkdownIt

from tests.report.browser import CHROMIUM, Tab, chromium
from tests.snippets import ROOT

DOCS = ROOT / "docs"
PAGES = sorted(path.relative_to(DOCS).as_posix() for path in DOCS.rglob("*.md"))
GENERATED = {"api.md", "api-parts.md"}
"""Pages whose tables give way to docstrings on the site."""


def _hooks() -> Any:
    spec = importlib.util.spec_from_file_location("hooks", DOCS / "site" / "hooks.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


HOOKS = _hooks()


# ------------------------------------------------------------------ what the hooks do


@pytest.mark.parametrize("page", PAGES)
def test_every_page_is_in_the_navigation(page: str) -> None:
    listed = re.findall(r"^ +- (?:[^:\n]+: )?(\S+\.md)$", (ROOT / "mkdocs.yml").read_text(), re.M)
    assert page in listed, "add it to nav in mkdocs.yml"


@pytest.mark.parametrize(
    ("page", "link", "moved"),
    [
        ("theory.md", "[b](../benchmarks/results/swarm.md)", "[b](benchmarks/results/swarm.md)"),
        ("how-to/a.md", "[t](../theory.md#on-the-bed)", "[t](../theory.md#on-the-bed)"),
        ("theory.md", "![m](regime-map.svg)", "![m](regime-map.svg)"),
        ("theory.md", "[theory.md](theory.md)", "[Theory](theory.md)"),
        ("theory.md", "[`f`](../catopt/errors.py)", "`f`"),
        ("reports/reproduction.md", "[t](../docs/theory.md)", "[t](../theory.md)"),
        ("theory.md", "[s](#notation) [w](https://toml.io)", "[s](#notation) [w](https://toml.io)"),
        ("theory.md", "[g](gone.md)", "[g](gone.md)"),
        ("theory.md", "```text\n[a](../README.md)\n```", "```text\n[a](../README.md)\n```"),
    ],
)
def test_links_follow_their_targets(page: str, link: str, moved: str) -> None:
    known = {"theory.md", "regime-map.svg", "benchmarks/results/swarm.md"}
    assert HOOKS.relinked(link, page, known) == moved


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("Xích neo phao", ["Xich"]),
        ("đường kính, Đáy", ["duong", "kinh", "Day"]),
        ("touchdown at 12 m", []),
        ("xi\u0301ch", ["xich"]),  # written apart
        ("neo, néo, neo", ["neo"]),
    ],
)
def test_words_are_found_by_their_plain_letters(text: str, plain: list[str]) -> None:
    assert HOOKS.plain_words(text) == plain


def test_marks_of_what_is_run_are_taken_off() -> None:
    assert HOOKS.unmarked("```sh run\na run\n```\n") == "```sh\na run\n```\n"
    assert HOOKS.unmarked("```diff a/b.py\n+c\n```\n") == '```diff title="a/b.py"\n+c\n```\n'


def test_tables_of_names_give_way_to_docstrings() -> None:
    table = (
        "<!-- catopt.waves: python -m tests.api_page -->\n\n| name | what it is |\n|---|---|\n"
        "| [`Sea`](../src/x.py) | A sea. |\n\n<!-- end -->\n"
    )
    assert HOOKS.described(f"a\n{table}b") == "a\n::: catopt.waves.Sea\nb"


def test_a_notebook_is_a_page_with_what_it_prints_and_shows() -> None:
    def cell(kind: str, source: str) -> dict[str, object]:
        return {"cell_type": kind, "source": [source]}

    code = (
        "class Shown:\n    def _repr_png_(self):\n        return b'picture'\nprint(6 * 7)\nShown()"
    )
    cells = [cell("markdown", "# Title"), cell("code", code), cell("code", "'a' * 3")]
    page = HOOKS.notebook_page(json.dumps({"cells": cells}))
    assert page.startswith("# Title\n\n```python\n")
    assert "```text\n42\n```" in page
    assert '<img alt="" src="data:image/png;base64,cGljdHVyZQ==">' in page
    assert page.endswith("```text\n'aaa'\n```\n")
    assert HOOKS.relinked("[n](n.ipynb)", "api.md", {"n.md"}) == "[n](n.md)"


# ------------------------------------------------------------------ the site


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Build the site where no network answers."""
    pytest.importorskip("mkdocs", reason="optional extra: docs")
    pytest.importorskip("material", reason="optional extra: docs")
    pytest.importorskip("mkdocstrings", reason="optional extra: docs")
    folder = tmp_path_factory.mktemp("site")
    nowhere = dict.fromkeys(("http_proxy", "https_proxy", "all_proxy"), "http://127.0.0.1:9")
    built = subprocess.run(
        [sys.executable, "-m", "mkdocs", "build", "--strict", "--site-dir", str(folder)],
        cwd=ROOT,
        env={**os.environ, **nowhere, "NO_MKDOCS_2_WARNING": "1", "PYTHONWARNINGS": "error"},
        capture_output=True,
        encoding="utf-8",
        check=False,
        timeout=180,
    )
    assert built.returncode == 0, built.stderr
    assert "WARNING" not in built.stderr
    return folder


class Parts(HTMLParser):
    """What a page is made of: tags of its text, names to link to, and what it refers to."""

    def __init__(self) -> None:
        super().__init__()
        self.tags: Counter[str] = Counter()
        self.names: set[str] = set()
        self.links: list[str] = []
        self.loads: list[str] = []
        self._inside = 0

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        given = {name: value or "" for name, value in attributes}
        self.names |= {given[name] for name in ("id", "name") if name in given}
        if tag == "a" and "href" in given:
            self.links.append(given["href"])
        elif tag == "link" and given.get("rel") not in {"prev", "next", "canonical"}:
            self.loads.append(given["href"])
        elif "src" in given:
            self.loads.append(given["src"])
        if tag == "article":
            self._inside += 1
        elif self._inside:
            self.tags[tag] += 1

    def handle_endtag(self, tag: str) -> None:
        self._inside -= tag == "article"


@cache
def parts(page: Path) -> Parts:
    read = Parts()
    read.feed(page.read_text("utf-8"))
    return read


def pages(site: Path) -> Iterator[Path]:
    return (path for path in sorted(site.rglob("*.html")) if path.name != "404.html")


@pytest.mark.slow
def test_nothing_is_loaded_from_elsewhere(site: Path) -> None:
    loaded = {load for page in pages(site) for load in parts(page).loads}
    assert loaded
    assert [load for load in loaded if urlsplit(load).netloc] == []
    for style in site.rglob("*.css"):
        assert re.findall(r"url\(['\"]?(?:https?:)?//", style.read_text("utf-8")) == [], style


@pytest.mark.slow
def test_every_link_of_the_site_leads_somewhere(site: Path) -> None:
    broken = []
    for page in pages(site):
        for link in parts(page).links:
            place = urlsplit(link)
            if place.scheme or place.netloc:
                continue
            goal = (page.parent / unquote(place.path)).resolve() if place.path else page
            anchor = unquote(place.fragment)
            if not goal.is_file() or (
                anchor and goal.suffix == ".html" and anchor not in parts(goal).names
            ):
                broken.append(f"{page.relative_to(site)}: {link}")
    assert broken == []


@pytest.mark.slow
@pytest.mark.parametrize("page", [page for page in PAGES if page not in GENERATED])
def test_a_page_is_made_of_the_same_parts_on_the_site_as_in_the_repository(
    site: Path, page: str
) -> None:
    """Lists, tables, headings and blocks, as CommonMark with tables reads them."""
    text = (DOCS / page).read_text("utf-8")
    tokens = MarkdownIt("commonmark").enable("table").parse(text)
    wanted = Counter(token.tag for token in tokens if token.nesting == 1)
    wanted["pre"] = sum(token.type in {"fence", "code_block"} for token in tokens)
    found = parts((site / page).with_suffix(".html")).tags
    kinds = ("h1", "h2", "h3", "ol", "ul", "li", "table", "tr", "td", "pre")
    assert {kind: found[kind] for kind in kinds} == {kind: wanted[kind] for kind in kinds}


# ------------------------------------------------------------------ in a browser


@pytest.fixture(scope="module")
def tab(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Tab]:
    if not CHROMIUM:
        pytest.skip("Chromium is not installed")
    with chromium(tmp_path_factory.mktemp("browser")) as opened:
        yield opened


SIZES: list[tuple[int, Literal["light", "dark"]]] = [(1280, "light"), (390, "dark")]


@pytest.mark.slow
@pytest.mark.parametrize(("width", "scheme"), SIZES)
def test_no_page_is_wider_than_the_screen_or_complains(
    site: Path, tab: Tab, width: int, scheme: Literal["light", "dark"]
) -> None:
    for page in pages(site):
        if "cases" in page.relative_to(site).parts or "reports" in page.relative_to(site).parts:
            continue
        tab.messages.clear()
        tab.open(page, width, scheme=scheme)
        room = "document.documentElement.scrollWidth - document.documentElement.clientWidth"
        assert (page.name, tab.value(room)) == (page.name, 0)
        assert (page.name, tab.messages) == (page.name, [])


def typed(tab: Tab, words: str) -> None:
    """Type into the search as hands do, letter by letter."""
    tab.value("document.querySelector('.md-search__input').focus()")
    for letter in words:
        tab.call("Input.insertText", text=letter)
        tab.press(letter)


def found_pages(tab: Tab) -> list[str]:
    """Wait for pages that the search finds, and list them."""
    links = "[...document.querySelectorAll('.md-search-result__item a')].map((a) => a.href)"
    until = time.monotonic() + 20.0
    while not tab.value(links) and time.monotonic() < until:
        time.sleep(0.1)
    return [unquote(urlsplit(link).path).rpartition("/")[2] for link in tab.value(links)]


SEARCHED = {
    "touchdown": "theory.html",
    "friction": "dynamics.html",
    "wind": "loads.html",
    "sinker friction": "loads.html",
    "anchor": "loads.html",
    "swing": "sizing.html",
    "buoy": "size-a-buoy.html",
    "safety factor": "checks.html",
    "wear": "sizing.html",
    "fairlead": "conventions.html",
    "spectrum": "waves.html",
    "workbook": "report.html",
    "xich": "bat-dau-nhanh.html",
    "neo phao": "bat-dau-nhanh.html",
    "xích": "day-xich-va-cap.html",
    "phao": "neo-phao.html",
    "tàu": "neo-tau.html",
    "lực căng": "bat-dau-nhanh.html",
    "kiểm chứng": "kiem-chung.html",
    "đáy": "neo-phao.html",
}
"""Words that are looked for, and a page that is about them."""


@pytest.mark.slow
def test_the_search_answers_from_disk(site: Path, tab: Tab) -> None:
    """A query finds what is asked for, and nothing is said on the console."""
    tab.messages.clear()
    missed = {}
    for words, page in SEARCHED.items():
        tab.open(site / "index.html", 1280)
        typed(tab, words)
        pages_found = found_pages(tab)
        if page not in pages_found:
            missed[words] = pages_found
    assert missed == {}
    assert tab.messages == []


class _Slow(SimpleHTTPRequestHandler):
    """Serves the site, but the words of its pages late."""

    def do_GET(self) -> None:
        if "search_index" in self.path:
            time.sleep(2.0)
        super().do_GET()

    def log_message(self, *_: Any) -> None:
        pass


@pytest.mark.slow
def test_what_is_typed_before_the_search_is_ready_is_answered(site: Path, tab: Tab) -> None:
    tab.messages.clear()
    with ThreadingHTTPServer(("127.0.0.1", 0), partial(_Slow, directory=str(site))) as server:
        Thread(target=server.serve_forever, daemon=True).start()
        tab.call("Page.navigate", url=f"http://127.0.0.1:{server.server_port}/index.html")
        time.sleep(1.5)
        typed(tab, "wind")
        assert "loads.html" in found_pages(tab)
        server.shutdown()
    assert tab.messages == []


def test_ends_of_words_are_merged_by_numbers_with_a_mark_between() -> None:
    """As they are written, one place "a" to 1 and "2" to 34 is "a" to 12 and "3" to 4."""
    script = "for(i=0;i<n;i++){var s=r[i],o=this.edges[s];e=e+s+o.id}return e"
    assert HOOKS.searching(script).endswith("o=this.edges[s];e=e+s+o.id+','}return e")
    with pytest.raises(ValueError, match="lunr"):
        HOOKS.searching("another script")
