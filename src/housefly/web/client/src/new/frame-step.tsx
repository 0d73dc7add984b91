import { Metres } from "../controls/metres";
import { translated } from "../messages/speech";
import { Told } from "../messages/told";
import type { FramePoint } from "../wire/draft-messages";
import { change, known, view } from "./draft";
import { Button, Text } from "./fields";
import { Words } from "./heard-words";
import { ItemList } from "./item-list";
import { with_ } from "./items";
import { t } from "./messages/texts";
import { addInTheMiddle } from "./tools";
import { heard, listen } from "./tracking-step";

/** Three points that are known on the map, and where tracking sees them. */
export function FrameStep() {
  const { hardware } = known.value;
  const fit = view.value!.fit;
  if (!hardware)
    return <p class="quiet">{t("The simulated tracking system uses the map's frame.")}</p>;
  return (
    <>
      <p class="quiet">
        {t("Lay the drone on three points of the floor that are far from each other.")}{" "}
        {t("For each, say where it is on the map, and take where tracking sees the drone.")}
      </p>
      <Button press={() => addInTheMiddle("frame_points")}>{t("Add a point")}</Button>
      <ItemList
        kind="frame_points"
        label={t("Points")}
        form={(index) => <PointForm index={index} />}
      />
      {fit && (
        <ul class="notes" data-well={fit.trusted} aria-label={t("What the points say")}>
          {fit.words.map((words, k) => (
            <li key={k}>
              <Told words={translated(words)} />
            </li>
          ))}
        </ul>
      )}
    </>
  );
}

const AXES = ["x", "y", "z"];

function PointForm({ index }: { index: number }) {
  const point = known.value.frame_points[index]!;
  const set = (next: Partial<FramePoint>, field: string): void =>
    change(with_(known.value, "frame_points", index, next), `frame_points.${index}.${field}`);
  const take = async (): Promise<void> => {
    await listen();
    const body = heard.value?.bodies.find(({ name }) => name === known.value.tracking!.body);
    if (!body) return;
    const [x, y, z] = body.position.map((value) => Math.round(value * 1e4) / 1e4);
    set({ seen: [x!, y!, z!] }, "");
  };
  return (
    <>
      <Text name={t("Name")} value={point.name} set={(name) => set({ name }, "name")} />
      {(["on_map", "seen"] as const).map((key) => (
        <fieldset key={key}>
          <legend>{key === "on_map" ? t("On the map [m]") : t("As tracking sees it [m]")}</legend>
          {AXES.map((axis, k) => (
            <Metres
              key={axis}
              name={axis}
              value={point[key][k]!}
              set={(value) => {
                const next: [number, number, number] = [...point[key]];
                next[k] = value;
                set({ [key]: next }, `${key}.${k}`);
              }}
            />
          ))}
        </fieldset>
      ))}
      <Button ready={known.value.tracking !== null} press={take}>
        {t("Take what tracking sees now")}
      </Button>
      <Words said={heard.value} />
    </>
  );
}
