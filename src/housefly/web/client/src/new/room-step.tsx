import { signal } from "@preact/signals";
import { useState } from "preact/hooks";
import { Metres } from "../controls/metres";
import { translated } from "../messages/speech";
import { Told } from "../messages/told";
import { act, change, known, trouble, upload, view } from "./draft";
import { Button, Choice, Text } from "./fields";
import { millimetres } from "./geometry";
import type { Key } from "./messages/en";
import { t } from "./messages/texts";

/** The files that are read as rooms; what comes with them has other endings. */
const ROOMS = /\.(ya?ml|ply|obj|glb|gltf|stl|pcd|la[sz]|e57|svg|dxf)$/i;
const PLANS = /\.(svg|dxf)$/i;
const ACCEPTED =
  ".yaml,.yml,.pgm,.png,.ply,.obj,.mtl,.glb,.gltf,.bin,.stl,.pcd,.las,.laz,.e57,.svg,.dxf," +
  ".jpg,.jpeg";
const UNITS = [
  ["", "found out"],
  ["1", "metres"],
  ["0.01", "centimetres"],
  ["0.001", "millimetres"],
  ["0.0254", "inches"],
  ["0.3048", "feet"],
] as const satisfies [string, Key][];
const UPS = [
  ["auto", "found out"],
  ["z", "z"],
  ["y", "y"],
] as const;

const UNSEEN = [
  ["wall", "a wall"],
  ["free", "free floor"],
] as const satisfies [string, Key][];

const named = <Value extends string>(all: readonly (readonly [Value, Key | "z" | "y"])[]) =>
  all.map(([value, words]): [Value, string] => [
    value,
    words === "z" || words === "y" ? words : t(words),
  ]);

const files = signal<File[]>([]);

export function RoomStep() {
  const all = known.value;
  return (
    <>
      <Text
        name={t("Name of the site")}
        value={all.name}
        set={(name) => change({ name }, "name")}
        placeholder={t("my lab")}
      />
      <SizeForm key={JSON.stringify([all.bounds, all.height])} />
      <FileForm />
      <fieldset class="two">
        <legend>{t("The drone flies at [m]")}</legend>
        <Metres
          name={t("height above the floor")}
          value={all.flight_height}
          set={(value) => change({ flight_height: value }, "flight_height")}
        />
      </fieldset>
    </>
  );
}

function SizeForm() {
  const { bounds, height, walls } = known.value;
  const [x0, y0, x1, y1] = bounds ?? [0, 0, 6, 4];
  const [size, setSize] = useState({
    length: millimetres(x1 - x0),
    width: millimetres(y1 - y0),
    height,
  });
  return (
    <form
      class="plain"
      noValidate
      onSubmit={(event) => {
        event.preventDefault();
        void act("/draft/size", size);
      }}
    >
      <fieldset>
        <legend>{t("An empty rectangle [m]")}</legend>
        <Metres
          name={t("length (x)")}
          value={size.length}
          set={(length) => setSize((old) => ({ ...old, length }))}
        />
        <Metres
          name={t("width (y)")}
          value={size.width}
          set={(width) => setSize((old) => ({ ...old, width }))}
        />
        <Metres
          name={t("ceiling")}
          value={size.height}
          set={(value) => setSize((old) => ({ ...old, height: value }))}
        />
      </fieldset>
      <button type="submit" class={bounds ? "" : "strong"}>
        {bounds ? t("Change the size") : t("Make this room")}
      </button>
      {bounds && walls.length > 4 && (
        <small class="quiet">
          {t("Four new walls take the place of those that are drawn.")}
        </small>
      )}
    </form>
  );
}

function FileForm() {
  const [unit, setUnit] = useState<(typeof UNITS)[number][0]>("");
  const [up, setUp] = useState<(typeof UPS)[number][0]>("auto");
  const [layers, setLayers] = useState("");
  const [unexplored, setUnexplored] = useState<(typeof UNSEEN)[number][0]>("wall");
  const main = files.value.find((file) => ROOMS.test(file.name));
  const read = async (): Promise<void> => {
    for (const file of files.value) if (!(await upload(file))) return;
    const words = layers.split(",").map((word) => word.trim()).filter(Boolean);
    const file = main!.name;
    const asked = { file, unit: unit ? Number(unit) : null, up, layers: words, unexplored };
    await act("/draft/import", asked, t("Reading {file} …", { file }));
  };
  return (
    <fieldset class="file">
      <legend>{t("Or a file of it")}</legend>
      <label>
        {t("ROS map (yaml and its picture), scan (ply, gltf, las, e57 …), plan (svg, dxf)")}
        <input
          type="file"
          multiple
          accept={ACCEPTED}
          onChange={(event) => {
            files.value = [...(event.currentTarget.files ?? [])];
            trouble.value = null;
          }}
        />
      </label>
      <div class="pair">
        <Choice name={t("Unit of the file")} value={unit} options={named(UNITS)} set={setUnit} />
        <Choice name={t("Up in a scan")} value={up} options={named(UPS)} set={setUp} />
      </div>
      {main && !PLANS.test(main.name) && (
        <Choice
          name={t("Floor that was never seen is")}
          value={unexplored}
          options={named(UNSEEN)}
          set={setUnexplored}
        />
      )}
      {main && PLANS.test(main.name) && (
        <Text
          name={t("Layers of the plan that hold the walls (may be empty)")}
          value={layers}
          set={setLayers}
          placeholder={t("walls, windows")}
        />
      )}
      {files.value.length > 0 && !main && (
        <p class="wrong" role="alert">
          △ {t("None of these is a room: choose the yaml, the scan or the plan too.")}
        </p>
      )}
      <Button ready={main !== undefined} press={read}>
        {main ? t("Read {file}", { file: main.name }) : t("Read it")}
      </Button>
      {known.value.source && <p>{t("Read from {file}.", { file: known.value.source })}</p>}
      {view.value!.notes.length > 0 && (
        <ul class="notes">
          {view.value!.notes.map((note, k) => (
            <li key={k}>
              <Told words={translated(note)} />
            </li>
          ))}
        </ul>
      )}
    </fieldset>
  );
}
