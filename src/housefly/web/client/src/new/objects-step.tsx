import { Metres } from "../controls/metres";
import type { DraftBox, DraftWall } from "../wire/draft-messages";
import { change, known, view } from "./draft";
import { Button, Choice, Text, Tick } from "./fields";
import { ItemList } from "./item-list";
import { degrees, radians } from "./geometry";
import { with_ } from "./items";
import { addInTheMiddle, preset, PRESETS, tool, type Tool } from "./tools";

const TOOLS: [Tool, string][] = [
  ["move", "Move"],
  ["wall", "Draw walls"],
  ["box", "Draw furniture"],
];

export function ObjectsStep() {
  const scanned = view.value!.scanned;
  const tools: [Tool, string][] = scanned ? [...TOOLS, ["erase", "Erase scan"]] : TOOLS;
  return (
    <>
      <div class="chips" role="group" aria-label="A drag on the plan">
        {tools.map(([name, words]) => (
          <Button key={name} pressed={tool.value === name} press={() => (tool.value = name)}>
            {words}
          </Button>
        ))}
      </div>
      <Choice
        name="Kind of furniture"
        value={preset.value.name}
        options={PRESETS.map(({ name, top }) => [name, `${name}, ${top.toFixed(2)} m high`])}
        set={(name) => {
          preset.value = PRESETS.find((one) => one.name === name)!;
          tool.value = "box";
        }}
      />
      <div class="chips">
        <Button press={() => addInTheMiddle("walls")}>Add a wall</Button>
        <Button press={() => addInTheMiddle("furniture")}>Add a {preset.value.name}</Button>
      </div>
      {scanned > 0 && (
        <p class="quiet">
          {scanned} boxes come from the file; “Erase scan” takes out what moved since.
        </p>
      )}
      <ItemList kind="furniture" label="Furniture" form={(index) => <BoxForm index={index} />} />
      <ItemList kind="walls" label="Walls" form={(index) => <WallForm index={index} />} />
    </>
  );
}

function WallForm({ index }: { index: number }) {
  const wall = known.value.walls[index]!;
  const set = (next: Partial<DraftWall>, field: string): void =>
    change(with_(known.value, "walls", index, next), `walls.${index}.${field}`);
  const [[x0, y0], [x1, y1]] = [wall.start, wall.end];
  return (
    <>
      <fieldset class="two">
        <legend>From, to [m]</legend>
        <Metres name="x from" value={x0} set={(x) => set({ start: [x, y0] }, "x0")} />
        <Metres name="y from" value={y0} set={(y) => set({ start: [x0, y] }, "y0")} />
        <Metres name="x to" value={x1} set={(x) => set({ end: [x, y1] }, "x1")} />
        <Metres name="y to" value={y1} set={(y) => set({ end: [x1, y] }, "y1")} />
      </fieldset>
      <fieldset>
        <legend>Thickness and heights [m]</legend>
        <Metres
          name="thickness"
          value={wall.thickness}
          set={(thickness) => set({ thickness }, "thickness")}
        />
        <Metres name="bottom" value={wall.bottom} set={(bottom) => set({ bottom }, "bottom")} />
        {wall.top !== null && (
          <Metres name="top" value={wall.top} set={(top) => set({ top }, "top")} />
        )}
      </fieldset>
      <Tick
        name="up to the ceiling"
        value={wall.top === null}
        set={(all) => set({ top: all ? null : 1 }, "ceiling")}
      />
    </>
  );
}

function BoxForm({ index }: { index: number }) {
  const box = known.value.furniture[index]!;
  const set = (next: Partial<DraftBox>): void =>
    change(
      with_(known.value, "furniture", index, next),
      `furniture.${index}.${Object.keys(next)[0]}`,
    );
  return (
    <>
      <Text name="Name" value={box.name} set={(name) => set({ name })} />
      <fieldset class="two">
        <legend>Middle and size [m]</legend>
        <Metres name="x" value={box.x} set={(x) => set({ x })} />
        <Metres name="y" value={box.y} set={(y) => set({ y })} />
        <Metres name="length" value={box.length} set={(length) => set({ length })} />
        <Metres name="width" value={box.width} set={(width) => set({ width })} />
      </fieldset>
      <fieldset>
        <legend>Heights [m], turn [°]</legend>
        <Metres name="bottom" value={box.bottom} set={(bottom) => set({ bottom })} />
        <Metres name="top" value={box.top} set={(top) => set({ top })} />
        <Metres
          name="turned"
          step={5}
          value={degrees(box.yaw)}
          set={(value) => set({ yaw: radians(value) })}
        />
      </fieldset>
    </>
  );
}
