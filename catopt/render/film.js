"use strict";
// Draws the moments of a scene; everything is in metres, kN and seconds until it is drawn.
const scene = JSON.parse(document.getElementById("scene").textContent);
const at = (id) => document.getElementById(id);
const [x0, z1, unit] = scene.frame;
const place = ([x, z]) => `${((x - x0) / unit).toFixed(1)},${((z1 - z) / unit).toFixed(1)}`;
const through = (drawing, places) => drawing.setAttribute("points", places.map(place).join(" "));
const drawn = (id, places) => through(at(id), places);
const most = Math.max(...scene.tension);
const [first, last] = [scene.time[0], scene.time[scene.time.length - 1]];
const width = at("water").viewBox.baseVal.width;
const across = (t) => (width * (t - first)) / (last - first);
at("tension").setAttribute(
  "points",
  scene.tension.map((T, k) => `${across(scene.time[k])},${135 - (130 * T) / most}`).join(" "),
);
const moorings = scene.lines.map(() => {
  const drawing = document.createElementNS("http://www.w3.org/2000/svg", "polyline");
  drawing.setAttribute("class", "mooring");
  return at("lines").appendChild(drawing);
});

function show(k) {
  const surface = scene.surface[k].map((z, i) => [scene.x[i], z]);
  const [x, z, pitch] = scene.place[k];
  const [sine, cosine] = [Math.sin(pitch), Math.cos(pitch)];
  drawn("surface", surface);
  drawn("body-of-water", [...surface, [surface[surface.length - 1][0], 0], [surface[0][0], 0]]);
  scene.lines.forEach((line, i) => through(moorings[i], line[k]));
  drawn("hull", scene.outline.map(([u, v]) => [x + u * cosine + v * sine, z + v * cosine - u * sine]));
  at("now").setAttribute("x1", across(scene.time[k]));
  at("now").setAttribute("x2", across(scene.time[k]));
  at("told").textContent = `${scene.time[k].toFixed(2)} s, ${scene.tension[k].toFixed(1)} kN`;
}

let started = null;
function step(now) {
  if (started === null) return;
  const t = first + ((now - started) / 1000) % (last - first);
  let k = 0;
  while (k < scene.time.length - 1 && scene.time[k + 1] <= t) k += 1;
  at("moment").value = k;
  show(k);
  requestAnimationFrame(step);
}
at("play").addEventListener("click", () => {
  const button = at("play");
  started = started === null ? performance.now() - 1000 * (scene.time[at("moment").value] - first) : null;
  button.textContent = started === null ? button.dataset.play : button.dataset.pause;
  requestAnimationFrame(step);
});
at("moment").addEventListener("input", (event) => {
  started = null;
  at("play").textContent = at("play").dataset.play;
  show(Number(event.target.value));
});
show(Number(at("moment").value));
