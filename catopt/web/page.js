// Events of the page. Every figure, table and word comes from Python; nothing is computed here but
// the place of a slider.
import { ask, start } from "catopt/ask";
import { listen } from "catopt/figures";

const shells = JSON.parse(document.getElementById("shells").textContent);
const root = document.body.appendChild(document.createElement("div"));
const first = JSON.parse(document.getElementById("first").textContent);
const own = Object.keys(shells).find((each) => navigator.language?.toLowerCase().startsWith(each)) ?? "en";
const state = { lang: own, units: "", door: "", base: {}, values: {}, kept: {} };
let running = false;
let wanted = null;
let answered = null;
let later = 0;
let since = 0;
let ticking = 0;

const every = (what, within = root) => [...within.querySelectorAll(what)];
const one = (what) => root.querySelector(what);
const form = () => one(`form[data-door="${state.door}"]`);
const status = (key, more = "") => {
  const place = one(".status");
  place.textContent = key ? place.dataset[key] + more : "";
  place.dataset.now = key;
  one(".progress").hidden = !["starting", "working", "running"].includes(key);
};

// What takes longer than a second says for how long; while Python is loaded, what is being done.
const wait = (is) => {
  clearInterval(ticking);
  if (!is) return;
  since = performance.now();
  ticking = setInterval(() => {
    const seconds = Math.round((performance.now() - since) / 1000);
    const place = one(".status");
    if (place.dataset.now === "working" && seconds) place.textContent = `${place.dataset.working} ${seconds} s`;
  }, 1000);
};

const toast = (key) => {
  const place = one(".toast");
  place.textContent = place.dataset[key];
  place.hidden = false;
  setTimeout(() => { place.hidden = true; }, 6000);
};

// ---------------------------------------------------------------- what the address keeps

const kept = () => {
  const { lang, units, door, base, values } = state;
  return `#${encodeURIComponent(JSON.stringify({ lang, units, door, base: base[door] ?? "", values: values[door] }))}`;
};

const keep = () => {
  if (kept() !== location.hash) history.pushState(null, "", kept());
};

const restore = () => {
  try {
    const { lang, units, door, base, values } = JSON.parse(decodeURIComponent(location.hash.slice(1)));
    if (shells[lang] && ["", "kN", "tf"].includes(units)) Object.assign(state, { lang, units });
    if (typeof door !== "string" || typeof base !== "string" || typeof values !== "object") return;
    state.door = door;
    state.base[door] = base;
    state.values[door] = values;
  } catch { /* no link of ours: the form begins as it is */ }
};

// ---------------------------------------------------------------- the form

const read = () => {
  state.values[state.door] = Object.fromEntries(
    every("input[data-key]", form()).filter((each) => each.value.trim()).map((each) => [each.dataset.key, each.value]),
  );
};

// The menu beside a field shows its unit, if it is one of those offered.
const unitOf = (field) => {
  const menu = field.parentElement.querySelector("select");
  if (!menu) return;
  const [, unit] = /^[-+\d.,\s]*(.*)$/.exec(field.value.split(";")[0]) ?? [];
  if (unit && ![...menu.options].some((each) => each.value === unit)) menu.add(new Option(unit, unit));
  if (unit) menu.value = unit;
};

const setUnit = (menu) => {
  const field = document.getElementById(menu.dataset.unitOf);
  const inIt = (value) => {
    const [number] = /^\s*[-+\d.,]+/.exec(value) ?? [];
    return number ? `${number.trim()} ${menu.value}` : value.trim();
  };
  field.value = field.value.split(";").map(inIt).join("; ");
};

const fill = (values) => {
  for (const each of every("input[data-key]", form())) {
    if (each !== document.activeElement) each.value = values[each.dataset.key] ?? "";
    unitOf(each);
  }
};

const show = () => {
  root.innerHTML = shells[state.lang];
  document.documentElement.lang = state.lang;
  document.title = one("h1").textContent;
  const doors = every("input[name=door]");
  if (!doors.some((each) => each.value === state.door)) state.door = doors[0].value;
  for (const name of ["lang", "units", "door"]) {
    for (const each of every(`input[name=${name}]`)) each.checked = each.value === state[name];
  }
  open();
};

const open = () => {
  for (const each of every("form")) each.hidden = each.dataset.door !== state.door;
  if (state.values[state.door]) fill(state.values[state.door]);
  else read();
  one(".kept").hidden = !state.base[state.door];
  const run = one("[data-do=run]");
  if (run) run.hidden = ["line", "body"].includes(state.door);
};

// A slider goes from a tenth to twice the value that was last typed; its unit stays.
const slide = (slider) => {
  const field = document.getElementById(slider.dataset.of);
  slider.dataset.from ??= field.value;
  const [, whole, rest] = /^\s*([-+]?[\d.,]+(?:e[-+]?\d+)?)(.*)$/i.exec(slider.dataset.from) ?? [];
  const value = Number((whole ?? "").replace(",", "."));
  if (!Number.isFinite(value)) return;
  field.value = `${Number((value * slider.value / 100).toPrecision(3))}${rest}`;
  slider.setAttribute("aria-valuetext", field.value);
};

const typed = (field) => {
  for (const slider of every(`input[data-of="${field.id}"]`)) {
    slider.value = 100;
    delete slider.dataset.from;
  }
};

// ---------------------------------------------------------------- questions and answers

const question = () => ({
  door: state.door, values: state.values[state.door], base: state.base[state.door] ?? "",
  lang: state.lang, units: state.units, app: Boolean(one("[data-do=run]")),
});

const wrong = (reply) => {
  const left = [];
  for (const each of every(".wrong", form())) each.textContent = "";
  for (const each of every("[aria-invalid]", form())) each.removeAttribute("aria-invalid");
  for (const { key, found, allowed } of reply.problems ?? []) {
    const field = every("input[data-key]", form()).find((each) => key === each.dataset.key || key.startsWith(`${each.dataset.key}[`));
    const said = found ? `${found}: ${allowed}` : allowed;
    if (!field) {
      left.push(`${key}: ${said}`);
      continue;
    }
    field.setAttribute("aria-invalid", "true");
    const place = document.getElementById(`${field.id}-wrong`);
    place.textContent = place.textContent ? `${place.textContent}\n${said}` : said;
    field.closest("details")?.setAttribute("open", "");
  }
  return [reply.message, ...left].filter(Boolean).join("\n");
};

const old = (is) => {
  for (const each of [".card", ".brief-card", ".found", ".more", ".others"]) one(each).classList.toggle("old", is);
};

// Take what another line wants of the inputs.
const takeLine = (wanted) => {
  for (const each of every("input[data-key]", form())) {
    if (each.dataset.key in wanted) {
      each.value = wanted[each.dataset.key];
      each.closest("details")?.setAttribute("open", "");
    }
  }
  soon();
};

const others = (found) => {
  const place = one(".others > div");
  one(".others").hidden = !found.length;
  place.textContent = "";
  for (const each of found) {
    const button = place.appendChild(document.createElement("button"));
    button.type = "button";
    button.appendChild(document.createElement("b")).textContent = each.name;
    button.append(each.words);
    button.addEventListener("click", () => takeLine({ [each.key]: each.value }));
  }
};

// Points of the drawing of lines are there to be clicked on, or chosen with the keys and Enter.
const choose = (sets) => {
  const figure = one("figure[data-figure=choices]");
  if (!figure || !sets) return;
  const said = JSON.parse(figure.querySelector("script").textContent);
  const now = () => sets[said.indexOf(figure.querySelector(".readout").textContent)];
  const taken = () => { const found = now(); if (found) takeLine(found); };
  const drawing = figure.querySelector("svg");
  drawing.addEventListener("click", taken);
  drawing.addEventListener("keydown", (event) => { if (event.key === "Enter") taken(); });
};

const give = (reply) => {
  const said = wrong(reply);
  if (reply.status) {
    answered = null;
    old(true);
    status("failed", said ? `\n${said}` : "");
    return;
  }
  answered = reply;
  old(false);
  one(".card").innerHTML = reply.card;
  one(".brief-card").innerHTML = every(".card > :is(.headline, .verdict)").map((each) => each.outerHTML).join("");
  one(".found").innerHTML = reply.html;
  if (reply.more) one(".more").innerHTML = reply.more;
  for (const each of every("input[data-key]", form())) each.placeholder = reply.assumed?.[each.dataset.key] ?? each.dataset.hint;
  others(reply.others ?? []);
  choose(reply.choices);
  listen();
  if (reply.door === state.door) fill(reply.values);
  status("ready");
};

// What was kept stands above every answer of the same door.
const compare = async (asked) => {
  const kept = state.kept[asked.door];
  const reply = kept && answered ? await ask("compare", { ...asked, kept }) : { html: "" };
  const isOurs = asked.door === state.door && asked.lang === state.lang;
  if (isOurs) one(".compared").innerHTML = reply.html ?? "";
};

// Of questions that come while one is answered, only the last is asked.
const compute = async (call) => {
  read();
  wanted = call;
  if (running) return;
  running = true;
  while (wanted) {
    const [now, asked, door] = [wanted, question(), state.door];
    wanted = null;
    if (one(".status").dataset.now !== "starting") status("working");
    if (now === "whole") old(true);
    wait(true);
    try {
      const reply = await ask(now, asked);
      if (door === state.door && asked.lang === state.lang) {
        give(reply);
        if (now === "whole") await compare(asked);
      }
    } catch (error) {
      status("broken", `: ${error.message}`);
    }
  }
  wait(false);
  running = false;
};

const soon = () => {
  clearTimeout(later);
  later = setTimeout(() => { keep(); compute("whole"); }, 350);
};

// How far a run is stands in the bar; it stops at its next step.
const runs = async () => {
  const [asked, bar, stop] = [question(), one(".progress"), one("[data-do=stop]")];
  status("running");
  [bar.hidden, stop.hidden] = [false, false];
  old(true);
  const look = setInterval(async () => {
    const { done, total } = await ask("progress", {});
    if (total) [bar.max, bar.value] = [total, done];
  }, 500);
  try {
    const reply = await ask("run", asked);
    const isOurs = asked.door === state.door && asked.lang === state.lang;
    if (reply.stopped) {
      old(false);
      status("stopped");
    } else if (isOurs) give(reply);
  } finally {
    clearInterval(look);
    bar.removeAttribute("value");
    [bar.hidden, stop.hidden] = [true, true];
  }
};

// ---------------------------------------------------------------- files

const bytesOf = (base64) => Uint8Array.from(atob(base64), (each) => each.charCodeAt(0));

const download = (name, text, type) => {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
};

const DOCUMENT = { line: "solve", body: "system", buoy: "size", tanker: "size" };

const act = {
  compare: async () => {
    if (answered) state.kept[state.door] = answered.text;
    status("working");
    await compare(question());
    status("ready");
  },
  save: async () => {
    const reply = await ask("file", question());
    if (reply.status) give(reply);
    else download(reply.name, reply.text, "application/toml");
  },
  document: async () => {
    const reply = await ask(DOCUMENT[state.door], question());
    if (reply.problems) give(reply); // a solution's own document has a status, too
    else download(`${state.door}.json`, `${JSON.stringify(reply, null, 2)}\n`, "application/json");
  },
  note: async () => {
    status("working");
    const reply = await ask("note", question());
    if (reply.status) give(reply);
    else {
      download(reply.name, reply.html, "text/html");
      status("ready");
    }
  },
  files: async () => {
    status("working");
    const reply = await ask("files", question());
    if (reply.status) give(reply);
    else {
      download(reply.name, bytesOf(reply.base64), "application/zip");
      status("ready");
    }
  },
  run: runs,
  stop: () => ask("stop", {}),
  link: async () => {
    keep();
    const isFile = location.protocol === "file:";
    await navigator.clipboard.writeText(isFile ? location.hash : location.href);
    toast(isFile ? "copied_part" : "copied");
  },
};

const take = async (file) => {
  const reply = await ask("open", { text: await file.text(), lang: state.lang });
  const door = every("input[name=door]").find((each) => each.value === reply.door);
  if (reply.status || !door) {
    status("failed", reply.status ? `\n${wrong(reply)}` : "");
    return;
  }
  state.door = reply.door;
  state.base[reply.door] = reply.text;
  state.values[reply.door] = reply.values;
  show();
  soon();
};

// ---------------------------------------------------------------- events

root.addEventListener("input", ({ target }) => {
  if (target.type === "range") {
    slide(target);
    if (["line", "body"].includes(state.door)) compute("live");
    soon();
  } else if (target.dataset.key) {
    typed(target);
    unitOf(target);
  }
});

root.addEventListener("change", ({ target }) => {
  if (target.dataset.unitOf) setUnit(target);
  if (target.type === "file") {
    if (target.files.length) take(target.files[0]);
  } else if (["lang", "units", "door"].includes(target.name)) {
    read();
    state[target.name] = target.value;
    if (target.name === "door") {
      for (const each of [".card", ".brief-card", ".found", ".more", ".compared"]) one(each).textContent = "";
      others([]);
      open();
    } else if (target.name === "lang") {
      show();
      one("input[name=lang]:checked").focus();
    }
    soon();
  } else soon();
});

root.addEventListener("submit", (event) => { event.preventDefault(); soon(); });

root.addEventListener("click", async ({ target }) => {
  const what = act[target.dataset.do];
  if (!what) return;
  read();
  try {
    await what();
  } catch (error) {
    status("broken", `: ${error.message}`);
  }
});

addEventListener("popstate", () => { restore(); show(); compute("whole"); });

// What the page opens with was answered when it was made; everything else asks Python.
const opened = () => {
  const reply = location.hash ? null : first[state.lang]?.[state.door];
  if (reply) give(reply);
  return Boolean(reply);
};

const began = location.hash;
restore();
show();
start((stage) => {
  if (one(".status").dataset.now !== "starting") return;
  status("starting", ` ${one(".status").dataset[stage] ?? ""}`);
});
if (began || !opened()) {
  status("starting");
  compute("whole");
}
