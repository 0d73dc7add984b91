import { signal } from "@preact/signals";
import { useState } from "preact/hooks";
import { Metres } from "../controls/metres";
import { act, change, known, trouble, upload, view } from "./draft";
import { Button, Choice, Text } from "./fields";
import { millimetres } from "./geometry";

/** The files that are read as rooms; what comes with them has other endings. */
const ROOMS = /\.(ya?ml|ply|obj|glb|gltf|stl|svg|dxf)$/i;
const ACCEPTED =
  ".yaml,.yml,.pgm,.png,.ply,.obj,.mtl,.glb,.gltf,.bin,.stl,.svg,.dxf,.jpg,.jpeg";
const UNITS = [
  ["", "found out"],
  ["1", "metres"],
  ["0.01", "centimetres"],
  ["0.001", "millimetres"],
  ["0.0254", "inches"],
  ["0.3048", "feet"],
] as const;
const UPS = [
  ["auto", "found out"],
  ["z", "z"],
  ["y", "y"],
] as const;

const files = signal<File[]>([]);

export function RoomStep() {
  const all = known.value;
  return (
    <>
      <Text
        name="Name of the site"
        value={all.name}
        set={(name) => change({ name }, "name")}
        placeholder="my lab"
      />
      <SizeForm key={JSON.stringify([all.bounds, all.height])} />
      <FileForm />
      <fieldset class="two">
        <legend>The drone flies at [m]</legend>
        <Metres
          name="height above the floor"
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
        <legend>An empty rectangle [m]</legend>
        <Metres
          name="length (x)"
          value={size.length}
          set={(length) => setSize((old) => ({ ...old, length }))}
        />
        <Metres
          name="width (y)"
          value={size.width}
          set={(width) => setSize((old) => ({ ...old, width }))}
        />
        <Metres
          name="ceiling"
          value={size.height}
          set={(value) => setSize((old) => ({ ...old, height: value }))}
        />
      </fieldset>
      <button type="submit" class={bounds ? "" : "strong"}>
        {bounds ? "Change the size" : "Make this room"}
      </button>
      {bounds && walls.length > 4 && (
        <small class="quiet">Four new walls take the place of those that are drawn.</small>
      )}
    </form>
  );
}

function FileForm() {
  const [unit, setUnit] = useState<(typeof UNITS)[number][0]>("");
  const [up, setUp] = useState<(typeof UPS)[number][0]>("auto");
  const [layers, setLayers] = useState("");
  const main = files.value.find((file) => ROOMS.test(file.name));
  const read = async (): Promise<void> => {
    for (const file of files.value) if (!(await upload(file))) return;
    const words = layers.split(",").map((word) => word.trim()).filter(Boolean);
    const asked = { file: main!.name, unit: unit ? Number(unit) : null, up, layers: words };
    await act("/draft/import", asked, `Reading ${main!.name} …`);
  };
  return (
    <fieldset class="file">
      <legend>Or a file of it</legend>
      <label>
        ROS map (yaml and its picture), scan (ply, obj, gltf, glb, stl), floor plan (svg, dxf)
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
        <Choice name="Unit of the file" value={unit} options={UNITS} set={setUnit} />
        <Choice name="Up in a scan" value={up} options={UPS} set={setUp} />
      </div>
      {main && /\.(svg|dxf)$/i.test(main.name) && (
        <Text
          name="Layers of the plan that hold the walls (may be empty)"
          value={layers}
          set={setLayers}
          placeholder="walls, windows"
        />
      )}
      {files.value.length > 0 && !main && (
        <p class="wrong" role="alert">
          △ None of these is a room: choose the yaml, the scan or the plan too.
        </p>
      )}
      <Button ready={main !== undefined} press={read}>
        {main ? `Read ${main.name}` : "Read it"}
      </Button>
      {known.value.source && <p>Read from {known.value.source}.</p>}
      {view.value!.notes.length > 0 && (
        <ul class="notes">
          {view.value!.notes.map((note) => (
            <li key={note}>{note}</li>
          ))}
        </ul>
      )}
    </fieldset>
  );
}
