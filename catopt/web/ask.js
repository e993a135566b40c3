// One question, one answer: from Python in a worker, or from catopt app behind this page.
const transport = document.body.dataset.transport;
const waiting = new Map();
let worker = null;
let number = 0;
let failed = null;

// What the worker is made of: base64 within a single file, else an address beside the page.
const pieces = () => JSON.parse(document.getElementById("pieces").textContent).map((name) => {
  const inside = document.getElementById(`piece-${name}`);
  return inside
    ? { name, base64: inside.textContent }
    : { name, url: new URL(`pack/${name}.gz`, document.baseURI).href };
});

export const start = (told) => {
  if (transport !== "worker" || worker) return;
  const text = document.getElementById("worker").textContent;
  worker = new Worker(URL.createObjectURL(new Blob([text], { type: "text/javascript" })));
  worker.onmessage = ({ data }) => {
    if (data.stage) {
      told(data.stage);
      return;
    }
    if (data.failed) {
      failed = new Error(data.failed);
      for (const each of waiting.values()) each.reject(failed);
      waiting.clear();
      return;
    }
    const each = waiting.get(data.number);
    waiting.delete(data.number);
    if (!each) return;
    if (data.error) each.reject(new Error(data.error));
    else each.resolve(JSON.parse(data.reply));
  };
  worker.onerror = (event) => worker.onmessage({ data: { failed: event.message || "worker" } });
  worker.postMessage({ pieces: pieces() });
};

const byWorker = (call, question) => new Promise((resolve, reject) => {
  if (failed) {
    reject(failed);
    return;
  }
  number += 1;
  waiting.set(number, { resolve, reject });
  worker.postMessage({ number, call, question: JSON.stringify(question) });
});

const byServer = async (call, question) => {
  const answer = await fetch(`ask/${call}`, { method: "POST", body: JSON.stringify(question) });
  if (!answer.ok) throw new Error(`${answer.status} ${answer.statusText}`);
  return answer.json();
};

export const ask = transport === "worker" ? byWorker : byServer;
