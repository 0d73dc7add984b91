import { render } from "preact";
import { App } from "./app";
import { listenToKeys } from "./keys";
import "./replay/back-to-live";
import "./scene/stage";
import { keepShell } from "./device/install";
import { notify } from "./device/notify";
import { keepAwake } from "./wake-lock";
import { connect } from "./wire/socket";

render(<App />, document.getElementById("app")!);
listenToKeys();
keepAwake();
keepShell();
notify();
connect();
