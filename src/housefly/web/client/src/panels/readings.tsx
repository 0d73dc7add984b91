import type { ComponentChildren } from "preact";
import { freshness, link, poseAge, state, stateAge } from "../store";
import { lag, now } from "../wire/clock";
import { picture } from "../wire/video";
import { milliseconds, percent } from "../format";
import { decimal, t } from "../messages/language";

const LINK_PERIOD = 0.5;

interface Props {
  name: string;
  age: number;
  problem?: boolean;
  children: ComponentChildren;
}

/** One value with its name; grey when older than 0.5 s, struck out when older than 2 s. */
function Reading({ name, age, problem = false, children }: Props) {
  return (
    <div class="reading" data-age={freshness(age)} data-problem={problem}>
      <dt>{name}</dt>
      <dd>{children}</dd>
    </div>
  );
}

const POSE_OLD = 0.25;
const TELEMETRY_OLD = 0.5;

export function Readings() {
  // Five times a second: nobody reads faster.
  const ticked = now.value;
  const age = stateAge.peek();
  const s = state.peek();
  const heard = link.peek();
  const wires = heard?.link;
  // The link is told twice a second: its age counts from when the next one was due.
  const linkAge = heard ? Math.max(0, ticked - heard.heard_at - LINK_PERIOD) : Infinity;
  const seen = poseAge.peek();
  const telemetryAge = (s?.telemetry_age ?? Infinity) + age;
  const shown = picture.peek();
  // While pictures flow their latency tells more than the age of the last one.
  const pictureAge = shown ? Math.max(shown.latency, ticked - shown.receivedAt) : Infinity;
  const speed = s?.velocity ? Math.hypot(s.velocity[0], s.velocity[1]) : null;
  return (
    <dl class="card readings">
      <Reading name={t("Lag")} age={0}>
        <span title={t("Round trip between this browser and the server")}>
          {lag.value === null ? "–" : milliseconds(lag.value)}
        </span>
      </Reading>
      <Reading
        name={t("Tracking")}
        age={Math.max(linkAge, age)}
        problem={seen > POSE_OLD || wires?.tracking_connected === false}
      >
        {rate(wires?.tracking_rate_hz)} · {ageWords(seen)}
      </Reading>
      <Reading
        name={t("Drone")}
        age={Math.max(linkAge, age)}
        problem={telemetryAge > TELEMETRY_OLD || wires?.drone_connected === false}
      >
        {rate(wires?.telemetry_rate_hz)} · {ageWords(telemetryAge)}
      </Reading>
      <Reading name={t("Picture")} age={linkAge} problem={wires?.video_connected === false}>
        {rate(wires?.video_rate_hz)} · {ageWords(pictureAge)}
      </Reading>
      <Reading name={t("Pilot loop")} age={linkAge}>
        {wires
          ? t("p99 {d} ms late · {n} missed", {
              d: decimal(1000 * wires.loop_p99_s, 1),
              n: wires.missed_ticks,
            })
          : "–"}
      </Reading>
      <Reading name={t("Delays")} age={linkAge}>
        {t("tracking {one} · command {other}", {
          one: known(wires?.tracking_latency_s),
          other: known(wires?.command_delay_s),
        })}
        <small> ± {known(wires?.command_delay_std_s)}</small>
      </Reading>
      <Reading name={t("Filter")} age={linkAge}>
        NIS {wires?.nis ? t("{one} · height {other}", {
              one: decimal(wires.nis, 1),
              other: decimal(wires.height_nis, 1),
            }) : "–"}
      </Reading>
      <Reading name={t("Push")} age={linkAge}>
        {wires?.push
          ? t("{d} m/s² · load {p}", { d: decimal(wires.push, 2), p: percent(wires.load) })
          : "–"}
      </Reading>
      <Reading name={t("Position")} age={seen}>
        {s?.position ? `${s.position.map((value) => decimal(value, 2)).join("  ")} m` : "–"}
        {s?.position_std != null && <small> ± {milli(s.position_std)}</small>}
      </Reading>
      <Reading name={t("Motion")} age={seen}>
        {speed === null ? "–" : `${decimal(speed, 2)} m/s`} ·{" "}
        {s?.yaw == null ? "–" : `${degrees(s.yaw)}°`}
      </Reading>
      <Reading name={t("State")} age={age} problem={s !== null && s.safety !== "nominal"}>
        {s ? t("{state} · safety {mode}", { state: s.behavior, mode: s.safety }) : "–"}
        {s && s.safety !== "nominal" && <small> → {t(s.clears)}</small>}
      </Reading>
    </dl>
  );
}

function known(seconds: number | undefined): string {
  return seconds ? milliseconds(seconds) : "–";
}

function rate(hertz: number | undefined): string {
  return hertz === undefined ? "– Hz" : `${Math.round(hertz)} Hz`;
}

function ageWords(age: number): string {
  return Number.isFinite(age) ? milliseconds(age) : t("nothing yet");
}

function milli(metres: number): string {
  return metres < 1 ? `${Math.round(1000 * metres)} mm` : `${decimal(metres, 1)} m`;
}

function degrees(radians: number): number {
  return (Math.round((radians * 180) / Math.PI) + 360) % 360;
}
