"""What the page costs: its size, the wait for an answer, and what a slider's step takes.

    python -m benchmarks.page [--from DIR] [--out benchmarks/results/page.md]

One HTML file is opened from disk in headless Chromium, which computes with its own Python. Limits
are those that the page is to keep on two cores.
"""

from __future__ import annotations

import argparse
import json
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

from benchmarks.common import page
from catopt.web.build import document, fetched, pieces, site
from tests.report.browser import Tab, chromium

STEPS = 120
SLIDER = """(async () => {
  const slider = document.querySelector("form:not([hidden]) input[type=range]");
  const found = document.querySelector(".found");
  const taken = [];
  for (let k = 0; k < STEPS; k += 1) {
    const began = performance.now();
    slider.value = 60 + k % 80;
    slider.dispatchEvent(new Event("input", { bubbles: true }));
    await new Promise((resolve) => {
      const seen = new MutationObserver(() => { seen.disconnect(); resolve(); });
      seen.observe(found, { childList: true });
    });
    await new Promise((resolve) => requestAnimationFrame(resolve));
    taken.push(performance.now() - began);
  }
  return JSON.stringify(taken);
})()""".replace("STEPS", str(STEPS))
FRAMES = """window.gaps = []; (() => {
  let last = performance.now();
  const frame = () => {
    const now = performance.now();
    gaps.push(now - last); last = now; requestAnimationFrame(frame);
  };
  requestAnimationFrame(frame);
})()"""
NOTE = """(async () => {
  const made = new Promise((resolve) => {
    URL.createObjectURL = (blob) => { resolve(blob); return "#"; };
  });
  HTMLAnchorElement.prototype.click = () => {};
  const began = performance.now();
  document.querySelector("[data-do=note]").click();
  await made;
  return String(performance.now() - began);
})()"""


def waited(tab: Tab, since: float) -> float:
    """Wait until the page has answered; return the time from a moment on, s."""
    while tab.value("document.querySelector('.status').dataset.now") != "ready":
        time.sleep(0.01)
    return time.monotonic() - since


def chosen(tab: Tab, door: str) -> float:
    """Open a door, and return how long its answer takes, s."""
    began = time.monotonic()
    tab.value(f"document.querySelector('input[name=door][value={door}]').click()")
    time.sleep(0.4)  # the page waits 0.35 s for further typing
    return waited(tab, began)


def rows(made: dict[str, bytes], folder: Path) -> Iterator[tuple[str, str, str]]:
    """Yield what was measured, the figure and its limit."""
    page = folder / "catopt.html"
    page.write_text(document(made), encoding="utf-8")
    yield "single file, MB", f"{page.stat().st_size / 1e6:.1f}", "14"
    yield "folder, MB", f"{sum(map(len, made.values())) / 1e6:.1f}", "20"
    with chromium(folder) as tab:
        began = time.monotonic()
        tab.open(page, 1366, height=768)
        yield "what it opens with, s", f"{waited(tab, began):.1f}", "5"
        chosen(tab, "line")
        yield "first answer to a question, s after opening", f"{time.monotonic() - began:.1f}", "8"
        steps = sorted(json.loads(tab.value(SLIDER)))
        yield "step of the slider, median, ms", f"{steps[STEPS // 2]:.0f}", "40"
        yield "step of the slider, 95th percentile, ms", f"{steps[STEPS * 95 // 100]:.0f}", "100"
        tab.value(FRAMES)
        yield "a buoy's mooring, s", f"{chosen(tab, 'buoy'):.1f}", "5"
        longest = tab.value("Math.max(...gaps)")
        yield "longest frame meanwhile, ms", f"{longest:.0f}", "50"
        both = chosen(tab, "tanker") + float(tab.value(NOTE)) / 1e3
        yield "a tanker's mooring and its note, s", f"{both:.1f}", "3"


def main() -> None:
    """Print the table; write it when asked to."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--from", dest="parts", type=Path, help="folder with the page's parts")
    page(parser, _report)


def _report(of: argparse.Namespace) -> Iterator[str]:
    yield "# The page"
    yield ""
    yield "Headless Chromium."
    yield ""
    yield "| | measured | limit |"
    yield "|---|---|---|"
    if of.smoke:
        yield f"| catopt in the page, MB | {len(site([])) / 1e6:.1f} | 2 |"
        return
    made = pieces(lambda part: fetched(part, of.parts))
    with tempfile.TemporaryDirectory() as folder:
        for row in rows(made, Path(folder)):
            yield "| {} | {} | {} |".format(*row)


if __name__ == "__main__":
    main()
