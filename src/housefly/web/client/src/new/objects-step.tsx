import { Metres } from "../controls/metres";
import { decimal } from "../messages/numbers";
import type { DraftBox, DraftWall } from "../wire/draft-messages";
import { change, known, view } from "./draft";
import { Button, Choice, Text, Tick } from "./fields";
import { ItemList } from "./item-list";
import { degrees, radians } from "./geometry";
import { with_ } from "./items";
import type { Key } from "./messages/en";
import { t } from "./messages/texts";
import { addInTheMiddle, preset, PRESETS, tool, type Tool } from "./tools";

const TOOLS: [Tool, Key][] = [
  ["move", "Move"],
  ["wall", "Draw walls"],
  ["box", "Draw furniture"],
];

export function ObjectsStep() {
  const scanned = view.value!.scanned;
  const tools: [Tool, Key][] = scanned ? [...TOOLS, ["erase", "Erase scan"]] : TOOLS;
  return (
    <>
      <div class="chips" role="group" aria-label={t("A drag on the plan")}>
        {tools.map(([name, words]) => (
          <Button key={name} pressed={tool.value === name} press={() => (tool.value = name)}>
            {t(words)}
          </Button>
        ))}
      </div>
      <Choice
        name={t("Kind of furniture")}
        value={preset.value.name}
        options={PRESETS.map(({ name, top }) => [
          name,
          t("{name}, {d} m high", { name: t(name), d: decimal(top, 2) }),
        ])}
        set={(name) => {
          preset.value = PRESETS.find((one) => one.name === name)!;
          tool.value = "box";
        }}
      />
      <div class="chips">
        <Button press={() => addInTheMiddle("walls")}>{t("Add a wall")}</Button>
        <Button press={() => addInTheMiddle("furniture")}>
          {t("Add a {name}", { name: t(preset.value.name) })}
        </Button>
      </div>
      {scanned > 0 && (
        <p class="quiet">
          {t("{n} boxes come from the file; “Erase scan” takes out what moved since.", {
            n: scanned,
          })}
        </p>
      )}
      <ItemList
        kind="furniture"
        label={t("Furniture")}
        form={(index) => <BoxForm index={index} />}
      />
      <ItemList kind="walls" label={t("Walls")} form={(index) => <WallForm index={index} />} />
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
        <legend>{t("From, to [m]")}</legend>
        <Metres name={t("x from")} value={x0} set={(x) => set({ start: [x, y0] }, "x0")} />
        <Metres name={t("y from")} value={y0} set={(y) => set({ start: [x0, y] }, "y0")} />
        <Metres name={t("x to")} value={x1} set={(x) => set({ end: [x, y1] }, "x1")} />
        <Metres name={t("y to")} value={y1} set={(y) => set({ end: [x1, y] }, "y1")} />
      </fieldset>
      <fieldset>
        <legend>{t("Thickness and heights [m]")}</legend>
        <Metres
          name={t("thickness")}
          value={wall.thickness}
          set={(thickness) => set({ thickness }, "thickness")}
        />
        <Metres
          name={t("bottom")}
          value={wall.bottom}
          set={(bottom) => set({ bottom }, "bottom")}
        />
        {wall.top !== null && (
          <Metres name={t("top")} value={wall.top} set={(top) => set({ top }, "top")} />
        )}
      </fieldset>
      <Tick
        name={t("up to the ceiling")}
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
      <Text name={t("Name")} value={box.name} set={(name) => set({ name })} />
      <fieldset class="two">
        <legend>{t("Middle and size [m]")}</legend>
        <Metres name="x" value={box.x} set={(x) => set({ x })} />
        <Metres name="y" value={box.y} set={(y) => set({ y })} />
        <Metres name={t("length")} value={box.length} set={(length) => set({ length })} />
        <Metres name={t("width")} value={box.width} set={(width) => set({ width })} />
      </fieldset>
      <fieldset>
        <legend>{t("Heights [m], turn [°]")}</legend>
        <Metres name={t("bottom")} value={box.bottom} set={(bottom) => set({ bottom })} />
        <Metres name={t("top")} value={box.top} set={(top) => set({ top })} />
        <Metres
          name={t("turned")}
          step={5}
          value={degrees(box.yaw)}
          set={(value) => set({ yaw: radians(value) })}
        />
      </fieldset>
    </>
  );
}
