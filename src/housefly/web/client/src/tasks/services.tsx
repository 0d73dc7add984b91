import { computed, effect, signal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { HoldButton } from "../controls/hold-button";
import { sentence } from "../format";
import { createHold } from "../hold";
import { hasDrone } from "../store";
import { Told } from "../messages/told";
import { running } from "./board";
import { Field } from "./field";
import {
  rehearse,
  request,
  services as askServices,
  type Parameters,
  type Value,
} from "./tasks-client";
import { rehearsed } from "./words";
import type { RehearsalReport, ServiceInfo } from "../wire/task-messages";
import { t, translated } from "../messages/language";

const HOLD = 0.6;

const offered = signal<ServiceInfo[]>([]);
const chosen = signal<ServiceInfo | null>(null);
const given = signal<Parameters>({});
const rehearsal = signal<RehearsalReport | "…" | null>(null);
const outcome = signal("");

// Documents may have changed while the services were away.
effect(() => {
  if (running.value)
    askServices()
      .then((answer) => (offered.value = answer.services))
      .catch(() => undefined);
});

const missing = computed(() => {
  if (chosen.value?.problem) return translated(chosen.value.problem);
  const one = chosen.value?.parameters.find(
    (parameter) => parameter.required && (given.value[parameter.name] ?? "") === "",
  );
  return one ? t("Say first: {what}.", { what: translated(one.about || one.name) }) : "";
});
const objection = computed(() =>
  running.value ? missing.value : t("The services are not running."),
);

function choose(service: ServiceInfo | null): void {
  chosen.value = chosen.value === service ? null : service;
  given.value = {};
  rehearsal.value = null;
  outcome.value = "";
  if (chosen.value?.flies && !missing.value) void look();
}

/** Rehearse what is chosen; an answer that comes after a change of it is not shown. */
async function look(): Promise<void> {
  const [service, parameters] = [chosen.value, given.value];
  if (!service || objection.value) return;
  rehearsal.value = "…";
  let found: RehearsalReport | null = null;
  try {
    found = (await rehearse(service.name, parameters)).rehearsal;
  } catch (error) {
    outcome.value = translated((error as Error).message);
  }
  if (chosen.value === service && given.value === parameters) rehearsal.value = found;
}

async function start(): Promise<void> {
  const service = chosen.value;
  if (!service || objection.value) return;
  outcome.value = "";
  try {
    const { tasks } = await request(service.name, given.value);
    outcome.value = tasks.map((task) => translated(task.words || task.state)).join(", ");
  } catch (error) {
    outcome.value = translated((error as Error).message);
  }
}

const fly = createHold(HOLD, objection, () => void start());

/** One tap a service; what it needs is asked in place, and rehearsed before the yes. */
export function Services() {
  return (
    <section class="card services" aria-label={t("Services")}>
      <h2>{t("What can be done")}</h2>
      <ul>
        {offered.value.map((one) => (
          <li key={one.name}>
            <button
              type="button"
              aria-expanded={chosen.value?.name === one.name}
              onClick={() => choose(one)}
            >
              <strong>
                <Told words={translated(one.title)} />
              </strong>
              <span class="quiet">
                <Told words={translated(one.about)} />
              </span>
            </button>
            {chosen.value?.name === one.name && <Form service={one} />}
          </li>
        ))}
      </ul>
      {offered.value.length === 0 && (
        <p class="quiet">{hasDrone.value ? t("Not known yet.") : t("No drone")}</p>
      )}
    </section>
  );
}

function Form({ service }: { service: ServiceInfo }) {
  const form = useRef<HTMLFormElement>(null);
  useEffect(() => form.current!.scrollIntoView({ block: "nearest" }), []);
  return (
    <form
      ref={form}
      aria-label={translated(service.title)}
      onSubmit={(event) => {
        event.preventDefault();
        void (service.flies ? look() : start());
      }}
    >
      {service.parameters.map((one) => (
        <Field
          key={one.name}
          parameter={one}
          value={given.value[one.name] ?? one.default}
          put={(value) => put(one.name, value)}
          done={() => void look()}
        />
      ))}
      <p role="status" class="rehearsal">
        <Rehearsed />
      </p>
      <div class="row orders">
        {service.flies ? (
          <>
            <HoldButton
              hold={fly}
              class="primary"
              label={t("Start: {title}", { title: translated(service.title) })}
            >
              <span>{t("Start")}</span>
              <small aria-hidden="true">{t("hold")}</small>
            </HoldButton>
            <button type="submit" class="secondary" aria-disabled={objection.value !== ""}>
              {t("Rehearse")}
            </button>
          </>
        ) : (
          <button type="submit" class="primary" aria-disabled={objection.value !== ""}>
            {t("Ask")}
          </button>
        )}
      </div>
    </form>
  );
}

function Rehearsed() {
  const found = rehearsal.value;
  if (outcome.value) return <>{sentence(outcome.value)}</>;
  if (found === "…") return <span class="quiet">{t("Rehearsing …")}</span>;
  if (found) return <span data-may={found.may_fly}>{rehearsed(found)}</span>;
  return <span class="quiet">{missing.value}</span>;
}

function put(name: string, value: Value): void {
  const { [name]: _, ...rest } = given.value;
  given.value = value === "" ? rest : { ...rest, [name]: value };
  rehearsal.value = null;
  outcome.value = "";
}
