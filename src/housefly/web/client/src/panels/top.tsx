import { computed } from "@preact/signals";
import { AskIcon, BatteryIcon, ListIcon, ShapeIcon } from "../controls/icons";
import { Opens } from "../controls/opens";
import { House } from "../tasks/house";
import { asked } from "../tasks/board";
import {
  hasDrone,
  iFly,
  open,
  room,
  screen,
  simulated,
  state,
  verdict,
} from "../store";
import { ordering } from "../scene/dock";
import { percent } from "../format";
import { banner, headline } from "../headline";
import { t, tongue } from "../messages/language";

const SCREENS = [
  ["live", "Live"],
  ["tasks", "Tasks"],
] as const;

/** The state in words, who flies, and the way to the other screen. */
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
        <span class="words">
          <strong lang={tongue(text)}>{text}</strong>
          <span class="detail" lang={tongue(detail)}>
            {detail}
          </span>
        </span>
      </div>
      <div class="who">
        <nav class="screens" aria-label={t("Screens")}>
          {SCREENS.map(([name, title]) => (
            <button
              type="button"
              key={name}
              aria-current={screen.value === name ? "page" : undefined}
              onClick={() => open(name)}
            >
              {t(title)}
              {name === "tasks" && asked.value.length > 0 && (
                <span class="count"> {asked.value.length}</span>
              )}
            </button>
          ))}
        </nav>
        {screen.value === "live" && (
          <>
            {ordering.value && (
              <Opens name="ask" label={t("Ask")} class="quiet-button to-ask">
                <AskIcon />
              </Opens>
            )}
            <Opens name="side" label={t("What happened")} class="quiet-button to-side">
              <ListIcon />
            </Opens>
          </>
        )}
        <div class="pill">
          <House />
          {charge.value && (
            <span class="charge" title={t("Battery")}>
              <BatteryIcon /> {charge.value}
            </span>
          )}
          {hasDrone.value && (
            <Opens name="control" class="control">
              {who()}
            </Opens>
          )}
        </div>
        <Opens name="help" label={t("Keys")} class="quiet-button key">
          ?
        </Opens>
      </div>
      <Banner />
    </header>
  );
}

const Banner = () => (
  <p class="banner" role="alert" lang={tongue(banner.value)} hidden={!banner.value}>
    {banner.value}
  </p>
);

/** How long it may still fly, or what its battery holds. */
const charge = computed(() => {
  const { battery, flight_s } = state.value ?? {};
  if (flight_s != null) return t("{n} min", { n: Math.floor(flight_s / 60) });
  return battery == null ? "" : percent(battery);
});

/** The site's name, and its mode when it is not the usual one. */
function site(): string {
  if (!room.value) return " ";
  const { site, mode } = room.value;
  return mode === "default"
    ? `${site}${simulated.value ? ` · ${t("Simulated room")}` : ""}`
    : t("{site} · mode {mode}", { site, mode });
}

function who(): string {
  if (iFly.value) return t("You have control");
  return verdict.value?.control ? t("{who} has control", { who: verdict.value.control })
    : t("Nobody has control");
}
