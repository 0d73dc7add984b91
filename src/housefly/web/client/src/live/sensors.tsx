import { useEffect } from "preact/hooks";
import { milliseconds } from "../format";
import type { Said, SensorAnswer } from "../wire/room-messages";
import { sensors, trouble, wantsSensors } from "./store";
import { ago } from "./words";
import { t, translated } from "../messages/language";
import { Told } from "../messages/told";

type Health = "well" | "warning" | "fault";

const MARK: Record<Health, string> = { well: "✓", warning: "△", fault: "✕" };

/** Every sensor: how often it speaks, when it last did, and what is wrong, in words. */
export function Sensors() {
  useEffect(() => {
    wantsSensors.value = true;
    return () => void (wantsSensors.value = false);
  }, []);
  const all = sensors.value?.sensors ?? [];
  const memory = sensors.value?.memory;
  const wrong = all.filter((one) => health(one) !== "well").length;
  return (
    <section class="card sensors" aria-label={t("Sensors")}>
      <h2>
        {t("Sensors")}{" "}
        <small class="quiet">
          {all.length === 0
            ? t("none heard yet")
            : wrong
              ? t("{n} of {all} needs a look|{n} of {all} need a look", {
                  n: wrong,
                  all: all.length,
                })
              : t("all {n} are well", { n: all.length })}
        </small>
      </h2>
      <ul tabIndex={0} data-scrolls data-old={trouble.value !== ""}>
        {[...all]
          .sort((a, b) => Number(health(a) === "well") - Number(health(b) === "well"))
          .map((one) => (
            <Row key={one.sensor} one={one} />
          ))}
        {memory !== undefined && (
          <li data-health={memory ? "warning" : "well"}>
            <span class="mark">{memory ? MARK.warning : MARK.well}</span>
            <span>{t("memory")}</span>
            <span class="quiet">{memory ? "" : t("all is kept")}</span>
            {memory && saying(memory)}
          </li>
        )}
      </ul>
    </section>
  );
}

const saying = (said: Said) => (
  <em>
    <Told words={translated(said)} />
  </em>
);

function Row({ one }: { one: SensorAnswer }) {
  const state = health(one);
  return (
    <li data-health={state}>
      <span class="mark" aria-label={t(state)}>
        {MARK[state]}
      </span>
      <span>{one.title}</span>
      <span class="quiet">
        {one.rate_hz >= 0.5 ? `${Math.round(one.rate_hz)} Hz · ` : ""}
        {heard(one.age)}
      </span>
      {one.problem && saying(one.problem)}
    </li>
  );
}

function health(one: SensorAnswer): Health {
  return one.connected ? (one.problem ? "warning" : "well") : "fault";
}

function heard(age: number | null): string {
  if (age === null) return t("never heard");
  return age < 1 ? milliseconds(age) : ago(age);
}
