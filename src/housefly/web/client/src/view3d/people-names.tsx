import { type PerspectiveCamera, Vector3 } from "three";
import { TALL } from "./people-model";
import { shownDrone } from "./shown";
import { shownPeople } from "./shown-people";
import { t } from "../messages/language";

const ABOVE = 0.12;

/** Name, age and doubt of each person, the words of the plan; placed by `placeNames`. */
export function PeopleNames() {
  return (
    <ul class="space-names" aria-label={t("People")}>
      {shownDrone.value && (
        <li data-drone>
          <span class="name">{t("Drone")}</span>
        </li>
      )}
      {shownPeople.value.map((one) => (
        <li key={one.id} data-person={one.id} style={{ opacity: one.strength }}>
          {one.lines.map((line, k) => (
            <span key={k} class={line.kind}>
              {line.text}
            </span>
          ))}
        </li>
      ))}
    </ul>
  );
}

/** Put each name over its figure, in the picture that was just drawn. */
export function placeNames(names: HTMLElement, camera: PerspectiveCamera): void {
  const { width, height } = names.getBoundingClientRect();
  const put = (name: HTMLElement | null, [x, y]: readonly number[], z: number): void => {
    if (!name) return;
    const head = new Vector3(x, y, z + ABOVE).project(camera);
    const [left, top] = [(width * (1 + head.x)) / 2, (height * (1 - head.y)) / 2];
    name.hidden = head.z > 1;
    const place = `translate(${left.toFixed(1)}px, ${top.toFixed(1)}px)`;
    name.style.transform = `${place} translate(-50%, -100%)`;
  };
  const drone = shownDrone.peek();
  if (drone) put(names.querySelector("[data-drone]"), drone.place, drone.place[2]);
  for (const one of shownPeople.peek()) {
    const name = names.querySelector<HTMLElement>(`[data-person="${CSS.escape(one.id)}"]`);
    put(name, one.place, TALL[one.posture]);
  }
}
