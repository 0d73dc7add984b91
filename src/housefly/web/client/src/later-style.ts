// The styles of what comes later: its script waits for them, so that nothing is shown bare.
const link = document.createElement("link");
link.rel = "stylesheet";
link.href = "/static/later.css";
await new Promise((done) => {
  link.onload = link.onerror = done;
  document.head.append(link);
});

export {};
