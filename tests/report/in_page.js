// What tests ask of a page that is open.

// Elements that stick out, but for what scrolls within its own box.
function beyond() {
  const wide = document.documentElement.clientWidth;
  return [...document.querySelectorAll("body *")].filter((each) => {
    if (each.closest(".scroll, svg, script")) return false;
    const box = each.getBoundingClientRect();
    return box.right > wide + 0.5 || box.left < -0.5;
  }).map((each) => each.outerHTML.slice(0, 120));
}

// Words of a drawing that are cut off at its edge; boxes are taller than their letters.
function offPaper() {
  return [...document.querySelectorAll("figure > svg")].flatMap((svg) => {
    const paper = svg.getBoundingClientRect();
    return [...svg.querySelectorAll("text")].filter((each) => {
      const box = each.getBoundingClientRect();
      return box.left < paper.left - 2 || box.right > paper.right + 2
        || box.top < paper.top - 2 || box.bottom > paper.bottom + 2;
    }).map((each) => each.textContent);
  });
}

// Words of a drawing that stand on each other.
function clashes() {
  return [...document.querySelectorAll("figure > svg")].flatMap((svg) => {
    const texts = [...svg.querySelectorAll("text")];
    const boxes = texts.map((each) => each.getBoundingClientRect());
    const shared = (a, b, from, to) => Math.min(a[to], b[to]) - Math.max(a[from], b[from]);
    return boxes.flatMap((a, i) => boxes.slice(0, i).flatMap((b, j) => {
      const clash = shared(a, b, "left", "right") > 2 && shared(a, b, "top", "bottom") > 4;
      return clash ? [[texts[i].textContent, texts[j].textContent]] : [];
    }));
  });
}

// Elements whose words are too near in brightness to what is behind them.
function faint() {
  const parts = (colour) => colour.match(/[\d.]+/g).map(Number);
  const light = ([r, g, b]) => [r, g, b].map((each) => {
    const part = each / 255;
    return part <= 0.03928 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4;
  }).reduce((sum, part, index) => sum + part * [0.2126, 0.7152, 0.0722][index], 0);
  const ground = (element) => {
    for (let each = element; each; each = each.parentElement) {
      const colour = parts(getComputedStyle(each).backgroundColor);
      if (colour.length < 4 || colour[3] > 0) return colour;
    }
    return [255, 255, 255];
  };
  return [...document.querySelectorAll("p, li, td, th, h1, h2, h3, span, caption, dt, dd")]
    .filter((each) => {
      const [a, b] = [light(parts(getComputedStyle(each).color)), light(ground(each))];
      return (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05) < 4.5;
    }).map((each) => each.outerHTML.slice(0, 100));
}

// One of a figure's points in the window, and what may be said there: that is what belongs to
// points within a pixel and a half, for steep curves crowd them.
function place(name, share) {
  const figure = document.querySelector(`figure[data-figure=${name}]`);
  const svg = figure.querySelector("svg");
  svg.scrollIntoView({ block: "center" });
  const [texts, places] = [...figure.querySelectorAll("script")]
    .map((each) => JSON.parse(each.textContent));
  const shown = places.map((each) =>
    new DOMPoint(...each).matrixTransform(svg.getScreenCTM()));
  const at = shown[Math.min(Math.floor(share * texts.length), texts.length - 1)];
  const near = (each) => Math.hypot(each.x - at.x, each.y - at.y) < 1.5;
  return [at.x, at.y, texts.filter((_, index) => near(shown[index]))];
}

// Figures of the page with the heights of their drawings.
function figures() {
  return [...document.querySelectorAll("figure")].map((each) =>
    [each.dataset.figure, each.querySelector("svg").getBoundingClientRect().height]);
}

// What stands below a figure of what is pointed at, and the same once the keys belong to it.
function readout(name) {
  return document.querySelector(`figure[data-figure=${name}] .readout`).textContent;
}

function focused(name) {
  document.querySelector(`figure[data-figure=${name}] svg`).focus();
  return readout(name);
}

function styleOf(selector) {
  return getComputedStyle(document.querySelector(selector));
}

// All that is to be read, whether scripts run or not.
function words() {
  return [...document.querySelectorAll("h1, h2, table, figcaption, pre")]
    .map((each) => each.innerText);
}

// Tables that are wider than their boxes.
function wideTables() {
  const width = (element) => element.getBoundingClientRect().width;
  return [...document.querySelectorAll(".scroll > table")]
    .filter((each) => width(each) > width(each.parentElement) + 1)
    .map((each) => each.dataset.key);
}
