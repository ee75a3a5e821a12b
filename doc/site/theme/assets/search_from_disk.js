// Search in pages that are opened from disk, where browsers start no workers and read no JSON: the worker runs in a
// frame instead, and the index is a script.
if (location.protocol === "file:") {
  const assets = document.currentScript.src.replace(/[^/]*$/, "");

  window.IFrameWorker = class extends EventTarget {
    constructor(url) {
      super();
      const frame = document.createElement("iframe");
      frame.hidden = true;
      frame.srcdoc = `<script>postMessage = data => parent.dispatchEvent(new CustomEvent("from-search", {detail: data}))` +
        `<\/script><script src="${url}"><\/script>`;
      this.loaded = new Promise(resolve => frame.addEventListener("load", () => resolve(frame.contentWindow)));
      addEventListener("from-search", event => this.dispatchEvent(new MessageEvent("message", {data: event.detail})));
      document.body.append(frame);
    }

    postMessage(data) {
      this.loaded.then(worker => worker.dispatchEvent(new worker.MessageEvent("message", {data})));
    }
  };
  window.Worker = window.IFrameWorker;

  // The theme looks here for an index before it asks for one. It is read when somebody searches, since the frame's
  // work holds up the page.
  window.__search = {
    index: new Promise(resolve => {
      addEventListener("focusin", ({target}) => {
        if (!target.matches(".md-search__input") || window.searchIndex) return;
        const script = document.createElement("script");
        script.src = assets + "../search/search_index.js";
        script.onload = () => resolve(window.searchIndex);
        document.head.append(script);
      });
    })
  };
}
