import { computed } from "@preact/signals";
import { AskIcon, ListIcon, ShapeIcon } from "../controls/icons";
import { House } from "../tasks/house";
import { asked } from "../tasks/board";
import { hasDrone, iFly, open, panel, room, screen, state, toggle, verdict } from "../store";
import { lag } from "../wire/clock";
import { milliseconds, percent } from "../format";
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
        <div class="facts">
          <House />
          <span class="charge">{charge.value}</span>
          <span class="lag" title={t("Round trip between this browser and the server")}>
            {t("lag {time}", { time: lag.value === null ? "–" : milliseconds(lag.value) })}
          </span>
        </div>
        {screen.value === "live" && (
          <>
            <button
              type="button"
              class="quiet-button to-ask"
              aria-label={t("Ask")}
              aria-expanded={panel.value === "ask"}
              onClick={() => toggle("ask")}
            >
              <AskIcon />
            </button>
            <button
              type="button"
              class="quiet-button to-side"
              aria-label={t("Details")}
              aria-expanded={panel.value === "side"}
              onClick={() => toggle("side")}
            >
              <ListIcon />
            </button>
          </>
        )}
        {hasDrone.value && (
          <button
            type="button"
            class="quiet-button control"
            aria-expanded={panel.value === "control"}
            onClick={() => toggle("control")}
          >
            {who()}
          </button>
        )}
        <button
          type="button"
          class="quiet-button key"
          aria-label={t("Keys")}
          aria-expanded={panel.value === "help"}
          onClick={() => toggle("help")}
        >
          ?
        </button>
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

const charge = computed(() => {
  const share = state.value?.battery;
  return share == null ? "" : t("battery {p}", { p: percent(share) });
});

/** The site's name, and its mode when it is not the usual one. */
function site(): string {
  if (!room.value) return " ";
  return room.value.mode === "default"
    ? room.value.site
    : t("{site} · mode {mode}", { site: room.value.site, mode: room.value.mode });
}

function who(): string {
  if (iFly.value) return t("You have control");
  return verdict.value?.control ? t("{who} has control", { who: verdict.value.control })
    : t("Nobody has control");
}
