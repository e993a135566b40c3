/* A stand-in for Worker on pages opened from disk, where browsers start none: the worker's script
 * runs in a hidden frame and the two talk by messages. Only the search needs it. */
"use strict";
if (location.protocol === "file:") {
  window.Worker = class extends EventTarget {
    constructor(url) {
      super();
      const place = new URL(url, document.baseURI);
      this.frame = document.createElement("iframe");
      this.frame.hidden = true;
      document.body.append(this.frame);
      const inside = this.frame.contentWindow;
      inside.postMessage = (data) =>
        this.dispatchEvent(new MessageEvent("message", { data }));
      inside.importScripts = (...urls) =>
        urls.reduce(
          (before, each) =>
            before.then(
              () =>
                new Promise((done) => {
                  const script = inside.document.createElement("script");
                  script.src = new URL(each, place);
                  script.onload = done;
                  inside.document.body.append(script);
                }),
            ),
          Promise.resolve(),
        );
      this.ready = inside.importScripts(place);
    }
    postMessage(data) {
      this.ready.then(() =>
        this.frame.contentWindow.dispatchEvent(new MessageEvent("message", { data })),
      );
    }
    terminate() {
      this.frame.remove();
    }
  };
}
