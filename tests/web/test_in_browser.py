"""The page in Chromium, from disk and from a server: displayed digits are the command's."""

from __future__ import annotations

import io
import json
import os
import re
import tarfile
import time
from collections.abc import Iterator
from functools import partial
from html import unescape
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from threading import Thread
from typing import Any, Literal

import pytest

from catopt.errors import InputError
from catopt.page_api import ask
from catopt.page_api.fields import DOORS, START, Door
from catopt.web.build import PinnedPart, document, fetched, parts, pieces
from catopt.words import LANGUAGES, Language
from tests.report.browser import CHROMIUM, Tab, chromium
from tests.report.page_reader import read_page

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(not CHROMIUM, reason="no chromium on this machine"),
]

MOST = 14_000_000
"""Bytes that the single file may have, to be mailed."""


@pytest.fixture(scope="module")
def made() -> dict[str, bytes]:
    """Parts from a folder of one's own (CATOPT_PAGE_PARTS), or from their registries."""
    own = os.environ.get("CATOPT_PAGE_PARTS")
    folder = Path(own) if own else None
    try:
        read = {each: fetched(each, folder) for each in parts()}
    except InputError as error:
        pytest.skip(f"the parts of the page cannot be had: {error}")
    return pieces(read.__getitem__)


@pytest.fixture
def tab(tmp_path: Path) -> Iterator[Tab]:
    with chromium(tmp_path) as opened:
        yield opened


@pytest.fixture
def page(made: dict[str, bytes], tmp_path: Path) -> Path:
    """Write the page as a single file."""
    path = tmp_path / "catopt.html"
    path.write_text(document(made), encoding="utf-8")
    return path


def wait(tab: Tab, wanted: str = "ready") -> None:
    """Wait until the page says how a calculation went."""
    until = time.monotonic() + 120.0
    said = ""
    while time.monotonic() < until:
        said = tab.value("document.querySelector('.status').dataset.now")
        if said not in ("", "starting", "working"):
            break
        time.sleep(0.1)
    assert said == wanted, (said, tab.value("document.querySelector('.status').textContent"))


def displayed(tab: Tab) -> str:
    """Read the card and the table of results, with a space between words."""
    parts: list[str] = tab.value(
        "[...document.querySelectorAll('.card > p, .card dt, .card dd,"
        " [data-key=results] :is(caption, th, td)')].map((each) => each.textContent)"
    )
    return " ".join(" ".join(parts).split())


def expected(door: Door = DOORS[0], **question: str) -> str:
    """Make the same by Python outside of the browser."""
    reply = ask("whole", {"door": door, "values": START[door], **question})
    card = re.sub(r"<[^>]*>", " ", reply["card"])
    words = [unescape(card)]
    if door == "line":
        table = read_page(reply["html"]).table("results")
        words += [table.caption, *table.headings, *(text for row in table.texts() for text in row)]
    return " ".join(" ".join(words).split())


def choose(tab: Tab, name: str, value: str) -> None:
    """Choose among language, units or doors as a hand does, and wait for the answer."""
    tab.value(f"document.querySelector('input[name={name}][value=\"{value}\"]').click()")
    time.sleep(1.0)
    wait(tab)


def test_from_disk_both_languages_show_the_digits_of_the_command(tab: Tab, page: Path) -> None:
    assert page.stat().st_size <= MOST
    tab.open(page, 1280)
    wait(tab)
    assert displayed(tab) == expected() != ""
    choose(tab, "door", "line")
    assert displayed(tab) == expected("line")
    choose(tab, "lang", "vi")
    assert displayed(tab) == expected("line", lang="vi")
    choose(tab, "units", "tf")
    assert displayed(tab) == expected("line", lang="vi", units="tf")
    choose(tab, "door", "body")
    asked = [each for each in tab.requests if not each.startswith(("file:", "data:", "blob:"))]
    assert asked == []
    assert tab.messages == []


def test_from_disk_an_error_stands_at_its_field(tab: Tab, page: Path) -> None:
    tab.open(page, 390)
    wait(tab)
    choose(tab, "door", "line")
    tab.value("""(() => { const field = document.getElementById("line-site.water_depth");
      field.value = "-3 m"; field.dispatchEvent(new Event("change", { bubbles: true })); })()""")
    time.sleep(1.0)
    wait(tab, "failed")
    values = START["line"] | {"site.water_depth": "-3 m"}
    (problem,) = ask("live", {"door": "line", "values": values})["problems"]
    said = tab.value("document.getElementById('line-site.water_depth-wrong').textContent")
    assert said == f"{problem['found']}: {problem['allowed']}"
    assert tab.value("document.documentElement.scrollWidth") <= 390


DOWNLOADED = """(async () => {
  const made = new Promise((resolve) => {
    URL.createObjectURL = (blob) => { resolve(blob); return "#"; };
  });
  HTMLAnchorElement.prototype.click = () => {};
  document.querySelector("[data-do=note]").click();
  return await (await made).text();
})()"""


def words_in(html: str) -> list[str]:
    """List the words of a page's text; what rounding leaves of a sum of forces is left out.

    A browser's sine and logarithm may differ from another library's in the last bit.
    """
    body = re.sub(r"(?s)<(style|script).*?</\1>", " ", html)
    words = re.sub(r"(?s)<[^>]*>", " ", body).split()
    nothing = r"[-\u2212]?(\d(\.\d+)?e[-\u2212](0[6-9]|1\d)|(?<![\d.,])0(?![\d.,]))"
    return [re.sub(f"[()]|{nothing}", "", each) for each in words]


AXE = PinnedPart(
    "axe-core-4.14.1.tgz",
    "https://registry.npmjs.org/axe-core/-/axe-core-4.14.1.tgz",
    "e6b0ce02b84d892e2e33e403485e7f3d6c29e2be6df65daf44d89ba564139745",
)
"""Looks through a page for what keeps people from using it (WCAG)."""

VIOLATIONS = """axe.run().then((found) => JSON.stringify(
  found.violations.map(({ id, nodes }) => [id, nodes[0].html, nodes[0].failureSummary])))"""


@pytest.fixture(scope="module")
def axe() -> str:
    """Its script; empty where it cannot be had."""
    try:
        packed = fetched(AXE)
    except InputError:
        return ""
    with tarfile.open(fileobj=io.BytesIO(packed)) as archive:
        file = archive.extractfile("package/axe.min.js")
        assert file is not None
        return file.read().decode()


@pytest.mark.parametrize(
    ("width", "scheme", "languages"),
    [(1280, "light", LANGUAGES), (390, "dark", ("vi",))],
)
def test_every_door_leads_to_its_note_and_nothing_keeps_people_from_it(
    tab: Tab,
    page: Path,
    axe: str,
    width: int,
    scheme: Literal["light", "dark"],
    languages: tuple[Language, ...],
) -> None:
    tab.open(page, width, scheme=scheme)
    wait(tab)
    tab.call("Runtime.evaluate", expression=axe)
    for door in DOORS:
        choose(tab, "door", door)
        tab.value("document.querySelector('[data-do=compare]').click()")
        wait(tab)
        for language in languages:
            choose(tab, "lang", language)
            assert tab.value("document.querySelector('.compared').textContent.trim()") != ""
            if axe:
                assert json.loads(tab.value(VIOLATIONS)) == [], (door, language)
            question = {"door": door, "values": START[door], "lang": language}
            assert words_in(tab.value(DOWNLOADED)) == words_in(ask("note", question)["html"])
    assert tab.messages == []


class _Quiet(SimpleHTTPRequestHandler):
    def log_message(self, *_: Any) -> None:
        pass


def test_from_a_server_it_asks_for_its_own_files_alone(
    tab: Tab, made: dict[str, bytes], tmp_path: Path
) -> None:
    folder = tmp_path / "site"
    (folder / "pack").mkdir(parents=True)
    (folder / "index.html").write_text(document(list(made)), encoding="utf-8")
    for name, data in made.items():
        (folder / "pack" / f"{name}.gz").write_bytes(data)
    with ThreadingHTTPServer(("127.0.0.1", 0), partial(_Quiet, directory=str(folder))) as server:
        thread = Thread(target=server.serve_forever)
        thread.start()
        try:
            here = f"http://127.0.0.1:{server.server_port}/"
            tab.call("Page.navigate", url=here)
            time.sleep(2.0)
            wait(tab)
            assert displayed(tab) == expected()
            asked = [each for each in tab.requests if each.startswith("http")]
            assert asked
            assert all(each.startswith(here) for each in asked)
        finally:
            server.shutdown()
            thread.join()


def typed(tab: Tab, field: str, value: str) -> None:
    """Write into a field and leave it."""
    tab.value(
        f"(() => {{ const field = document.getElementById({field!r}); field.value = {value!r};"
        ' field.dispatchEvent(new Event("change", { bubbles: true })); })()'
    )


SEEN = """[...document.querySelectorAll(":is(.card, .brief-card) > :is(.headline, .verdict)")]
  .filter((each) => {
    const box = each.getBoundingClientRect();
    return box.height > 0 && box.top >= 0 && box.bottom <= innerHeight;
  }).map((each) => each.textContent)"""


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize(("width", "height"), [(1366, 768), (390, 844)])
def test_the_first_screen_has_chain_length_sinker_and_verdict_in_the_reader_s_language(
    tab: Tab, page: Path, width: int, height: int, language: Language
) -> None:
    """At once: what the page opens with was answered when it was made."""
    tab.call("Emulation.setUserAgentOverride", userAgent="x", acceptLanguage=f"{language}-XX")
    tab.open(page, width, height=height)
    reply = ask("whole", {"door": "buoy", "values": START["buoy"], "lang": language})
    said = re.findall(r'<p class="(?:headline|verdict[^"]*)">(.*?)</p>', reply["card"])
    assert len(said) == 2
    assert tab.value("document.documentElement.lang") == language
    assert set(map(unescape, said)) <= set(tab.value(SEEN))


UNITS = {
    "environment.wind": ("50 knots", "50 hải lý/giờ"),
    "site.water_depth": ("40 ft", "12 bananas"),
}


_EVERY = """
m metre mét cm mm km ft in yd fathom shot nmi hải_lý kg g t tấn lb s min h giờ d year
knots nút mph kph fps m/s km/h ft/s deg độ rad N kN MN kgf tf tấn_lực lbf kip Pa kPa
MPa bar psi t/m^3 kg/m kN/m kip/ft
"""
EVERY_UNIT = _EVERY.split()
"""What people write behind a number, in both languages."""
ASKED = """(async () => {
  const { ask } = await import("catopt/ask");
  const found = [];
  for (const unit of UNITS) for (const lang of ["en", "vi"]) {
    const values = { ...START };
    for (const key of BOTH) values[key] = `20 ${unit}`;
    try {
      const reply = await ask("live", { door: "line", values, lang, units: "", base: "" });
      found.push([unit, (reply.problems ?? []).map((each) => each.key)]);
    } catch (error) { found.push([unit, String(error)]); }
  }
  return JSON.stringify(found);
})()"""


def test_no_unit_ends_in_a_traceback(tab: Tab, page: Path) -> None:
    tab.open(page, 1366)
    wait(tab)
    for key, values in UNITS.items():
        for value in values:
            typed(tab, f"buoy-{key}", value)
            time.sleep(1.0)
            wait(tab, "failed" if "bananas" in value else "ready")
    assert "Traceback" not in tab.value("document.body.textContent")
    assert len(EVERY_UNIT) >= 40
    both = ["site.water_depth", "load.horizontal_force"]
    script = ASKED.replace("BOTH", json.dumps(both)).replace("UNITS", json.dumps(EVERY_UNIT))
    for unit, keys in json.loads(tab.value(script.replace("START", json.dumps(START["line"])))):
        assert isinstance(keys, list), (unit, keys)  # what is broken says why
        assert set(keys) <= set(both), (unit, keys)


def test_a_line_of_the_drawing_is_taken_by_a_click(tab: Tab, page: Path) -> None:
    tab.open(page, 1366)
    wait(tab)
    before = displayed(tab)
    places = json.loads(
        tab.value("document.querySelectorAll('[data-figure=choices] script')[1].textContent")
    )
    said = json.loads(
        tab.value("document.querySelectorAll('[data-figure=choices] script')[0].textContent")
    )
    lightest = next(k for k, words in enumerate(said) if words.startswith("lightest"))
    x, y = tab.value(
        "(() => { const svg = document.querySelector('[data-figure=choices] svg');"
        " svg.scrollIntoView({ block: 'center' });"
        f" const at = new DOMPoint(...{places[lightest]}).matrixTransform(svg.getScreenCTM());"
        " return [at.x, at.y]; })()"
    )
    tab.click(x, y)
    time.sleep(1.0)
    wait(tab)
    values = START["buoy"] | {"line.prefer": "lightest"}
    card = re.sub(r"<[^>]*>", " ", ask("whole", {"door": "buoy", "values": values})["card"])
    assert displayed(tab) == " ".join(unescape(card).split()) != before


def test_the_link_of_a_file_has_no_path(tab: Tab, page: Path) -> None:
    tab.open(page, 1366)
    wait(tab)
    tab.value("navigator.clipboard.writeText = async (text) => { window.copied = text; }")
    tab.value("document.querySelector('[data-do=link]').click()")
    assert tab.value("window.copied").startswith("#%7B")
    assert not tab.value("document.querySelector('.toast').hidden")
