"""What the pages need on the way to the site: mkdocs calls these functions, see mkdocs.yml.

The pages are written for the repository: they link to files beside docs/ and mark what a test runs.
Here the files that they link to become pages of the site, links follow them there, the tables of
docs/api.md give way to the docstrings themselves, and a notebook is run and shown with its answers.
"""

from __future__ import annotations

import ast
import base64
import io
import json
import os
import posixpath
import re
import sys
import unicodedata
from collections.abc import Iterator
from contextlib import redirect_stdout
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from mkdocs.config.defaults import MkDocsConfig
    from mkdocs.structure.files import Files
    from mkdocs.structure.pages import Page

__all__ = [
    "described",
    "notebook_page",
    "on_files",
    "on_page_markdown",
    "on_post_build",
    "plain_words",
    "relinked",
    "searching",
    "title",
    "unmarked",
]

ROOT = Path(__file__).parents[2]
BESIDE_DOCS = (
    "CHANGELOG.md",
    "benchmarks/results/*.md",
    "cases/**/*.toml",
    "reports/**/*.html",
    "reports/**/*.md",
    "reports/**/*.svg",
)

FOUND_LAST = ("api", "CHANGELOG", "benchmarks", "cases", "reports", "catalogue-verdicts")
"""Pages that have every word, and are seldom what one looks for."""

TERMS = "conventions.md"
"""The page that says what a word of the field means here: it is found first."""

NOTEBOOK = ".ipynb"

FENCE = re.compile(r"^(?P<fence>`{3,}).*?^(?P=fence)$", re.MULTILINE | re.DOTALL)
MARK = re.compile(r"^(```\w+) run$", re.MULTILINE)
PATCH = re.compile(r"^```diff (\S+)$", re.MULTILINE)
LINK = re.compile(r"(?P<image>!?)\[(?P<text>(?:[^\]\[]|\[[^\]]*\])*)\]\((?P<target>[^)\s]+)\)")
NAMES = re.compile(
    r"^<!-- (?P<module>catopt[a-z_.]*)[\w ]*: python -m tests\.api_page -->\n"
    r"(?P<table>.*?)^<!-- end -->$",
    re.MULTILINE | re.DOTALL,
)
WAITS = """(() => {
  let waiting = [];
  addEventListener("message", (event) => {
    if (event.data.type === 0) {
      const asked = waiting ?? [];
      waiting = null;
      const ask = (data) => dispatchEvent(new MessageEvent("message", { data }));
      setTimeout(() => asked.forEach(ask));
    } else if (waiting) {
      waiting.push(event.data);
      event.stopImmediatePropagation();
    }
  });
})();
"""
"""Stands before the script that searches: 0 brings it the words of the pages."""
ROW = re.compile(r"^\| \[`(?P<name>\w+)`\]", re.MULTILINE)


def on_files(files: Files, config: MkDocsConfig) -> Files:
    """Take in what the pages link to beside docs/: books, notes, benchmark results and cases."""
    from mkdocs.structure.files import File

    for notebook in [each for each in files if each.src_uri.endswith(NOTEBOOK)]:
        files.remove(notebook)
        page = notebook.src_uri.removesuffix(NOTEBOOK) + ".md"
        text = notebook_page(Path(notebook.abs_src_path).read_text("utf-8"))
        files.append(File.generated(config, page, content=text))
    for pattern in BESIDE_DOCS:
        for path in sorted(ROOT.glob(pattern)):
            place = path.relative_to(ROOT).as_posix()
            files.append(File.generated(config, place, abs_src_path=str(path)))
    return files


def on_page_markdown(markdown: str, page: Page, files: Files, **_: object) -> str:
    """Make a page of the repository one of the site."""
    known = {file.src_uri for file in files}
    if page.file.src_uri.startswith(FOUND_LAST):
        page.meta["search"] = {"boost": 0.2}
    if page.file.src_uri == TERMS:
        page.meta["search"] = {"boost": 4}
    return relinked(unmarked(described(markdown)), page.file.src_uri, known)


def notebook_page(notebook: str) -> str:
    """Run a notebook from the root of the repository, and write it as a page with its answers."""
    names: dict[str, Any] = {}
    parts: list[str] = []
    before = Path.cwd()
    sys.path.insert(0, str(ROOT))
    os.chdir(ROOT)
    try:
        for cell in json.loads(notebook)["cells"]:
            source = "".join(cell["source"])
            if cell["cell_type"] == "markdown":
                parts.append(source)
            else:
                parts += [f"```python\n{source}\n```", *_shown(source, names)]
    finally:
        os.chdir(before)
        sys.path.remove(str(ROOT))
    return "\n\n".join(parts) + "\n"


def _shown(source: str, names: dict[str, Any]) -> Iterator[str]:
    """Run a cell; yield what it prints, and the value of its last line as a notebook shows it."""
    *before, last = ast.parse(source).body
    is_shown = isinstance(last, ast.Expr)
    body = ast.Module(before if is_shown else [*before, last], [])
    value, printed = None, io.StringIO()
    with redirect_stdout(printed):
        exec(compile(body, "cell", "exec"), names)
        if isinstance(last, ast.Expr):
            value = eval(compile(ast.Expression(last.value), "cell", "eval"), names)
    if printed.getvalue():
        yield f"```text\n{printed.getvalue().rstrip()}\n```"
    for name, show in _SHOWS.items():
        if value is not None and hasattr(value, name):
            yield show(getattr(value, name)())
            return
    if value is not None:
        yield f"```text\n{value!r}\n```"


def _picture(data: bytes) -> str:
    return f'<img alt="" src="data:image/png;base64,{base64.b64encode(data).decode()}">'


def _table(html: str) -> str:
    """Put it on one line: what is set in, or follows an empty line, Markdown takes for its own."""
    return '<div style="overflow-x: auto">' + re.sub(r"\s*\n\s*", " ", html) + "</div>"


_SHOWS = {"_repr_png_": _picture, "_repr_html_": _table}
"""How a notebook shows a value that can be shown so, the first one that it has."""


def on_post_build(config: MkDocsConfig) -> None:
    """Let the search find Vietnamese words by their plain letters, xích by xich, and every word."""
    for worker in Path(config.site_dir).glob("assets/javascripts/workers/search.*.js"):
        worker.write_text(searching(worker.read_text("utf-8")), "utf-8")
    place = Path(config.site_dir) / "search" / "search_index.json"
    index = json.loads(place.read_text("utf-8"))
    for entry in index["docs"]:
        entry["text"] = " ".join([entry["text"], *plain_words(f"{entry['title']} {entry['text']}")])
    place.write_text(json.dumps(index, ensure_ascii=False), "utf-8")


def searching(worker: str) -> str:
    """Mend lunr, by which the pages are searched, in the script that has it.

    It merges the ends of words that lead to the same place, known by letters and numbers of places
    written one behind the other: "a", 1, "2", 34 reads as "a", 12, "3", 4 does. So pages with many
    numbers get words that are in no page, and what finds one of them, as "friction" did, fails.
    What is typed before the words of the pages are there waits for them.
    """
    merged, apart = "{0}={0}+{1}+{2}.id}}", "{0}={0}+{1}+{2}.id+','}}"
    place = re.search(r"(\w)=\1\+(\w)\+(\w)\.id\}", worker)
    if place is None:
        raise ValueError("lunr's TokenSet.toString is written otherwise now: mend `searching`")
    return WAITS + worker.replace(merged.format(*place.groups()), apart.format(*place.groups()))


def plain_words(text: str) -> list[str]:
    """Return the words that have marks of Vietnamese, without them, each once."""
    words = re.findall(r"\w+", unicodedata.normalize("NFC", text))
    plain = ((word, plain_letters(word)) for word in words)
    return list(dict.fromkeys(letters for word, letters in plain if letters != word))


def plain_letters(word: str) -> str:
    """Take the marks off the letters of a word; what is no Latin letter stays."""
    apart = unicodedata.normalize("NFD", word.translate({ord("đ"): "d", ord("Đ"): "D"}))
    return "".join(each for each in apart if not unicodedata.combining(each))


def unmarked(markdown: str) -> str:
    """Take the marks of blocks that a test runs off; the file of a patch becomes its title."""
    return PATCH.sub(r'```diff title="\1"', MARK.sub(r"\1", markdown))


def described(markdown: str) -> str:
    """Put mkdocstrings' directives in the place of the tables of names of docs/api.md."""

    def directives(found: re.Match[str]) -> str:
        names = ROW.findall(found["table"])
        return "\n\n".join(f"::: {found['module']}.{name}" for name in names)

    return NAMES.sub(directives, markdown)


def relinked(markdown: str, page: str, known: set[str]) -> str:
    """Point links to where their targets are on the site.

    Parameters
    ----------
    markdown : str
        The text of a page.
    page : str
        Its place on the site.
    known : set of str
        Places of everything on the site. A link to anything else in the repository, source code
        say, loses its target and keeps its words.
    """
    parts, end = [], 0
    for fence in FENCE.finditer(markdown):
        parts += [_relinked(markdown[end : fence.start()], page, known), fence[0]]
        end = fence.end()
    return "".join([*parts, _relinked(markdown[end:], page, known)])


def _relinked(text: str, page: str, known: set[str]) -> str:
    def moved(found: re.Match[str]) -> str:
        path, hash_, anchor = found["target"].partition("#")
        if not path or re.match(r"[a-z]+:", path):
            return found[0]
        if path.endswith(NOTEBOOK):  # a page of the site, too
            path = path.removesuffix(NOTEBOOK) + ".md"
        goal = _on_site(posixpath.join(posixpath.dirname(_in_repository(page)), path))
        if goal not in known:
            return found["text"] if (ROOT / goal).exists() else found[0]
        place = posixpath.relpath(goal, posixpath.dirname(page) or ".")
        words = title(goal) if found["text"].endswith(".md") else found["text"]
        return f"{found['image']}[{words}]({place}{hash_}{anchor})"

    return LINK.sub(moved, text)


def title(page: str) -> str:
    """Title of a page of the site: readers of the site know no file names."""
    first = (ROOT / _in_repository(page)).read_text("utf-8").partition("\n")[0]
    return first.removeprefix("# ")


def _in_repository(page: str) -> str:
    """Path in the repository of what has a place on the site."""
    return f"docs/{page}" if (ROOT / "docs" / page).exists() else page


def _on_site(path: str) -> str:
    """Place on the site of a path in the repository."""
    return posixpath.normpath(path).removeprefix("docs/")
