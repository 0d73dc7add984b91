import { cutMotors } from "../commands";
import { HoldButton } from "../controls/hold-button";
import { CutIcon, ShapeIcon } from "../controls/icons";
import { House } from "../tasks/house";
import { asked } from "../tasks/board";
import { iFly, nameOf, open, panel, room, screen, state, viewers } from "../store";
import { lag } from "../wire/clock";
import { milliseconds } from "../format";
import { headline } from "../headline";

const SCREENS = [
  ["fly", "Fly"],
  ["room", "Room"],
  ["tasks", "Tasks"],
] as const;

/** The state in words, who flies, and far from STOP the button that cuts the motors. */
export function Top() {
  const { shape, text, detail } = headline.value;
  return (
    <header class="top">
      <div class="brand">
        <img src="/static/favicon.svg" alt="" width="28" height="28" />
        <div>
          <h1>Housefly</h1>
          <span class="site">{site()}</span>
        </div>
      </div>
      <div class="headline" data-shape={shape}>
        <ShapeIcon shape={shape} />
        <strong>{text}</strong>
        <span class="detail">{detail}</span>
      </div>
      <div class="who">
        <nav class="screens" aria-label="Screens">
          {SCREENS.map(([name, title]) => (
            <button
              type="button"
              key={name}
              aria-current={screen.value === name ? "page" : undefined}
              onClick={() => open(name)}
            >
              {title}
              {name === "tasks" && asked.value.length > 0 && (
                <span class="count"> {asked.value.length}</span>
              )}
            </button>
          ))}
        </nav>
        <div class="facts">
          <House />
          <span class="charge">
            {state.value?.battery == null
              ? ""
              : `battery ${Math.round(100 * state.value.battery)} %`}
          </span>
          <span class="lag" title="Round trip between this browser and the server">
            lag {lag.value === null ? "–" : milliseconds(lag.value)}
          </span>
        </div>
        <button
          type="button"
          class="quiet-button"
          aria-expanded={panel.value === "control"}
          onClick={() => toggle("control")}
        >
          {who()}
        </button>
        <button
          type="button"
          class="quiet-button key"
          aria-label="Keys"
          aria-expanded={panel.value === "help"}
          onClick={() => toggle("help")}
        >
          ?
        </button>
      </div>
      <HoldButton hold={cutMotors} class="cut" label="Cut motors: motors stop, drone falls">
        <CutIcon />
        <span>Cut motors</span>
        <small>hold 1 s, drone falls</small>
      </HoldButton>
    </header>
  );
}

/** The site's name, and its mode when it is not the usual one. */
function site(): string {
  if (!room.value) return " ";
  return room.value.mode === "default"
    ? room.value.site
    : `${room.value.site} · mode ${room.value.mode}`;
}

function who(): string {
  if (iFly.value) return "You have control";
  return viewers.value.pilot === null
    ? "Take control"
    : `${nameOf(viewers.value.pilot)} has control`;
}

function toggle(name: "help" | "control"): void {
  panel.value = panel.value === name ? "" : name;
}
