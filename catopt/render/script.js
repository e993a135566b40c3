"use strict";
// The nearest of a figure's points answers to the pointer, the arrow keys and a touch. The words are
// in the page already; nothing is computed here.
for (const figure of document.querySelectorAll("figure[data-figure]")) {
  const [texts, places] = [...figure.querySelectorAll("script")].map((each) => JSON.parse(each.textContent));
  const drawing = figure.querySelector("svg");
  const pointer = figure.querySelector(".pointer");
  const readout = figure.querySelector(".readout");
  if (!texts) continue;
  let current = -1;

  const show = (index) => {
    current = index;
    const [x, y] = places[index];
    pointer.setAttribute("cx", x);
    pointer.setAttribute("cy", y);
    readout.textContent = texts[index];
    figure.classList.add("on");
  };
  const nearest = (event) => {
    const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(drawing.getScreenCTM().inverse());
    let best = 0;
    let least = Infinity;
    places.forEach(([x, y], index) => {
      const distance = (x - at.x) ** 2 + (y - at.y) ** 2;
      if (distance < least) [best, least] = [index, distance];
    });
    return best;
  };

  readout.textContent = readout.dataset.hint;
  drawing.addEventListener("pointermove", (event) => show(nearest(event)));
  drawing.addEventListener("pointerdown", (event) => show(nearest(event)));
  drawing.addEventListener("focus", () => { if (current < 0) show(0); });
  drawing.addEventListener("keydown", (event) => {
    const step = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 10, PageDown: -10 }[event.key];
    const end = { Home: 0, End: places.length - 1 }[event.key];
    if (step === undefined && end === undefined) return;
    event.preventDefault();
    show(end ?? Math.min(Math.max(current + step, 0), places.length - 1));
  });
}
