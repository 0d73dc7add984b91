import { render } from "preact";
import { App } from "./app";
import { listenToKeys } from "./keys";
import "./theme.css";
import "./layout.css";
import "./map/map.css";
import "./live/live.css";
import { keepAwake } from "./wake";
import { connect } from "./wire/socket";

render(<App />, document.getElementById("app")!);
listenToKeys();
keepAwake();
connect();
