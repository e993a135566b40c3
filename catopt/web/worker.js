// Python in the browser. Everything it is made of is handed over; nothing is fetched from elsewhere.
const HOME = "https://pack.invalid/";
const ASM = "`${e.indexURL}pyodide.asm.mjs`";
const files = {};
let answer = null;

const bytesOf = async ({ base64, url }) => {
  if (url) {
    const found = await realFetch(url);
    if (!found.ok) throw new Error(`${url}: ${found.status}`);
    return found.body;
  }
  if (Uint8Array.fromBase64) return new Response(Uint8Array.fromBase64(base64)).body;
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let k = 0; k < text.length; k += 1) bytes[k] = text.charCodeAt(k);
  return new Response(bytes).body;
};
const realFetch = self.fetch.bind(self);
self.fetch = async (address) => {
  const bytes = files[String(address).replace(HOME, "")];
  if (!bytes) throw new Error(`not in the page: ${address}`);
  const type = String(address).endsWith(".wasm") ? "application/wasm" : "application/octet-stream";
  return new Response(bytes, { headers: { "Content-Type": type } });
};

// A page from disk may start no module worker from a Blob (Chromium). This one imports by import()
// alone, as a module worker does; Pyodide asks for that by calling importScripts.
self.importScripts = () => { throw new TypeError("import() is used here"); };

const script = (text) => URL.createObjectURL(new Blob([text], { type: "text/javascript" }));

const boot = async (pieces) => {
  self.postMessage({ stage: "unpack" });
  await Promise.all(pieces.map(async (piece) => {
    const plain = (await bytesOf(piece)).pipeThrough(new DecompressionStream("gzip"));
    files[piece.name] = await new Response(plain).arrayBuffer();
  }));
  self.postMessage({ stage: "python" });
  const loader = new TextDecoder().decode(files["pyodide.mjs"]);
  if (!loader.includes(ASM)) throw new Error("this is another Pyodide than catopt was made for");
  const { loadPyodide } = await import(script(loader.replace(ASM, JSON.stringify(script(files["pyodide.asm.mjs"])))));
  const pyodide = await loadPyodide({ indexURL: HOME });
  self.postMessage({ stage: "catopt" });
  pyodide.unpackArchive(files["site.zip"], "zip", { extractDir: "/site" });
  return pyodide.runPython(`
import json, sys
sys.path.insert(0, "/site")
from catopt.page_api import ask
lambda call, question: json.dumps(ask(call, json.loads(question)))
`);
};

self.onmessage = async ({ data }) => {
  if (data.pieces) {
    answer = boot(data.pieces);
    answer.catch((error) => self.postMessage({ failed: String(error) }));
    return;
  }
  try {
    const reply = (await answer)(data.call, data.question);
    self.postMessage({ number: data.number, reply });
  } catch (error) {
    self.postMessage({ number: data.number, error: String(error) });
  }
};
