// Events of the page. Every figure, table and word comes from Python; nothing is computed here but
// the place of a slider.
import { ask, start } from "catopt/ask";
import { listen } from "catopt/figures";

const shells = JSON.parse(document.getElementById("shells").textContent);
const root = document.body.appendChild(document.createElement("div"));
const state = { lang: "en", units: "", door: "", base: {}, values: {}, kept: {} };
let running = false;
let wanted = null;
let answered = null;
let later = 0;

const every = (what, within = root) => [...within.querySelectorAll(what)];
const one = (what) => root.querySelector(what);
const form = () => one(`form[data-door="${state.door}"]`);
const status = (key, more = "") => {
  const place = one(".status");
  place.textContent = key ? place.dataset[key] + more : "";
  place.dataset.now = key;
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

const fill = (values) => {
  for (const each of every("input[data-key]", form())) {
    if (each !== document.activeElement) each.value = values[each.dataset.key] ?? "";
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
  lang: state.lang, units: state.units,
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

const give = (reply) => {
  const said = wrong(reply);
  if (reply.status) {
    answered = null;
    one(".found").classList.add("old");
    status("failed", said ? `\n${said}` : "");
    return;
  }
  answered = reply;
  one(".found").classList.remove("old");
  one(".found").innerHTML = reply.html;
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
  running = false;
};

const soon = () => {
  clearTimeout(later);
  later = setTimeout(() => { keep(); compute("whole"); }, 350);
};

// ---------------------------------------------------------------- files

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
    await compare(question());
  },
  save: async () => {
    const reply = await ask("file", question());
    if (reply.status) give(reply);
    else download(reply.name, reply.text, "application/toml");
  },
  document: async () => {
    const reply = await ask(DOCUMENT[state.door], question());
    if (reply.status) give(reply);
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
  link: async () => {
    keep();
    await navigator.clipboard.writeText(location.href);
    status("copied");
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
  } else if (target.dataset.key) typed(target);
});

root.addEventListener("change", ({ target }) => {
  if (target.type === "file") {
    if (target.files.length) take(target.files[0]);
  } else if (["lang", "units", "door"].includes(target.name)) {
    read();
    state[target.name] = target.value;
    if (target.name === "door") {
      one(".found").textContent = "";
      one(".compared").textContent = "";
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

restore();
show();
status("starting");
start();
compute("whole");
