import { effect } from "@preact/signals";
import { render } from "preact";
import "../theme.css";
import "../layout.css";
import "../map/map.css";
import "../live/editing.css";
import "./new.css";
import "./new-plan.css";
import { App, redo, undo } from "./app";
import { leave, load, trouble } from "./draft";
import { t } from "./messages/texts";
import { openKey } from "./tools";

render(<App />, document.getElementById("app")!);
void load();

effect(() => {
  document.title = `${t("New site")} · Housefly`;
});

// What was refused is opened, so that it stands beside the words.
effect(() => {
  const key = trouble.value?.key;
  if (key) openKey(key);
});

window.addEventListener("beforeunload", leave);

function typing(target: EventTarget | null): boolean {
  return target instanceof HTMLInputElement && target.type !== "checkbox";
}

window.addEventListener("keydown", (event) => {
  if (!(event.ctrlKey || event.metaKey) || typing(event.target)) return;
  const key = event.key.toLowerCase();
  if (key !== "z" && key !== "y") return;
  event.preventDefault();
  void (key === "y" || event.shiftKey ? redo() : undo());
});
