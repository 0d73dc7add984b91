import type { ComponentChildren } from "preact";
import { useLayoutEffect, useRef } from "preact/hooks";
import { Metres } from "../controls/metres";
import type { Key } from "../messages/en";
import { open } from "../store";
import { UseNow } from "./edit-use";
import {
  addInTheMiddle,
  aims,
  busy,
  changed,
  choose,
  editObjection,
  chosen,
  load,
  places,
  remove,
  save,
  saved,
  setPlace,
  setZone,
  said,
  trouble,
  undo,
  zones,
  type Chosen,
} from "./edits";
import { t } from "../messages/language";

const HINTS: Record<"none" | Chosen["kind"], Key> = {
  none: "Tap the map for a new place, drag on it for a new zone, or:",
  places: "Tap or drag on the map to move what is open; Done when it is right.",
  zones: "Drag on the map to draw the open zone again; Done when it is right.",
};

const COUNTS_LATER: Key = "What is saved here counts from the next start of Housefly on.";
const COUNTS_AFTER_SAVE: Key =
  "What is saved here counts from the next start on, or as soon as you use it after Save.";

/** What can be edited, in a list; what is open has a form, and beside it what is wrong with it. */
export function EditPanel() {
  const view = saved.value;
  const wrong = trouble.value;
  const shownBeside = wrong?.item != null;
  return (
    <section class="card edit" aria-label={t("Edit places and zones")}>
      <h2>
        {t("Places and no-fly zones")}{" "}
        <small class="quiet">
          {view &&
            (view.version
              ? view.by
                ? t("version {n}, by {who}", { n: view.version, who: view.by })
                : t("version {n}", { n: view.version })
              : t("never edited"))}
        </small>
      </h2>
      {editObjection.value ? (
        <p class="wrong" role="status">
          △ {editObjection.value}
        </p>
      ) : (
        <p class="quiet advice">{t(HINTS[chosen.value?.kind ?? "none"])}</p>
      )}
      <p class="chips">
        <button
          type="button"
          aria-disabled={!view || editObjection.value !== ""}
          onClick={() => view && addInTheMiddle("places")}
        >
          {t("Add a place")}
        </button>
        <button
          type="button"
          aria-disabled={!view || editObjection.value !== ""}
          onClick={() => view && addInTheMiddle("zones")}
        >
          {t("Add a zone")}
        </button>
      </p>
      <ul class="items" data-scrolls aria-label={t("Places and zones")}>
        {places.value.map((place, index) => (
          <Item
            key={`p${index}`}
            item={{ kind: "places", index }}
            name={place.title || t("new place")}
            fixed={place.name === "home" ? t("where it starts and lands") : ""}
          >
            <PlaceForm index={index} />
          </Item>
        ))}
        {zones.value.map((zone, index) => (
          <Item
            key={`z${index}`}
            item={{ kind: "zones", index }}
            name={zone.reason || t("new zone")}
            fixed=""
          >
            <ZoneForm index={index} />
          </Item>
        ))}
      </ul>
      {wrong && !shownBeside && (
        <p class="wrong" role="alert">
          △ {wrong.words}
        </p>
      )}
      <p role="status">{said.value || (changed.value ? t("Not saved yet.") : "")}</p>
      {changed.value && (
        <p class="quiet">
          {t("The drone keeps the map that it started with.")}{" "}
          {view?.use_time ? t(COUNTS_AFTER_SAVE) : t(COUNTS_LATER)}
        </p>
      )}
      <UseNow />
      <div class="chips">
        <Button
          words={t("Save")}
          strong
          ready={changed.value && !editObjection.value}
          press={save}
        />
        <Button words={t("Discard")} ready={changed.value || wrong !== null} press={load} />
        <Button
          words={t("Undo")}
          title={t("Go back to the version before")}
          ready={!changed.value && !editObjection.value && (view?.undoable ?? false)}
          press={undo}
        />
        <button type="button" onClick={() => open("live")}>
          {t("Close")}
        </button>
      </div>
    </section>
  );
}

interface ButtonProps {
  words: string;
  title?: string;
  strong?: boolean;
  ready: boolean;
  press: () => Promise<void>;
}

function Button({ words, title, strong = false, ready, press }: ButtonProps) {
  const possible = ready && !busy.value;
  return (
    <button
      type="button"
      title={title}
      class={strong && possible ? "strong" : ""}
      aria-disabled={!possible}
      onClick={() => possible && void press()}
    >
      {words}
    </button>
  );
}

interface ItemProps {
  item: Chosen;
  name: string;
  /** Why it cannot be changed, or "". */
  fixed: string;
  children: ComponentChildren;
}

function Item({ item, name, fixed, children }: ItemProps) {
  const open = chosen.value?.kind === item.kind && chosen.value.index === item.index;
  const wrong = trouble.value;
  const beside = open && wrong?.item?.kind === item.kind && wrong.item.index === item.index;
  const row = useRef<HTMLLIElement>(null);
  useLayoutEffect(() => {
    if (!open) return;
    row.current!.querySelector<HTMLInputElement>("input")!.focus({ preventScroll: true });
    row.current!.scrollIntoView({ block: "nearest" });
  }, [open, beside]);
  if (fixed) {
    return (
      <li class="fixed">
        {name} <small class="quiet">{fixed}</small>
      </li>
    );
  }
  return (
    <li ref={row} data-kind={item.kind}>
      <div class="head">
        <button
          type="button"
          class="name"
          aria-expanded={open}
          onClick={() => choose(open ? null : item)}
        >
          {name}
        </button>
        <button
          type="button"
          aria-label={t("Remove {name}", { name })}
          aria-disabled={editObjection.value !== ""}
          onClick={() => remove(item)}
        >
          {t("Remove")}
        </button>
      </div>
      {open && (
        <form
          onSubmit={(event) => {
            event.preventDefault();
            choose(null);
          }}
        >
          {beside && (
            <p class="wrong" role="alert">
              △ {wrong!.words}
            </p>
          )}
          {children}
          <button type="submit">{t("Done")}</button>
        </form>
      )}
    </li>
  );
}

function PlaceForm({ index }: { index: number }) {
  const place = places.value[index]!;
  const own = saved.value?.places.some((one) => one.name === place.name) ?? false;
  const [[x, y], [u, v, height]] = [place.viewpoint, place.look_at];
  return (
    <>
      <label>
        {t("Name")}
        <input
          value={place.title}
          maxLength={40}
          required
          autocomplete="off"
          placeholder={t("Reading corner")}
          onInput={(event) => setPlace(index, { title: event.currentTarget.value })}
        />
      </label>
      {own && <small class="quiet">{t("In commands: {name}", { name: place.name })}</small>}
      <fieldset>
        <legend>{t("Hovers at [m]")}</legend>
        <Metres name="x" value={x} set={(value) => setPlace(index, { viewpoint: [value, y] })} />
        <Metres name="y" value={y} set={(value) => setPlace(index, { viewpoint: [x, value] })} />
        <span />
        <Aim at="viewpoint" />
      </fieldset>
      <fieldset>
        <legend>{t("Looks at [m]")}</legend>
        <Metres
          name="x"
          value={u}
          set={(value) => setPlace(index, { look_at: [value, v, height] })}
        />
        <Metres
          name="y"
          value={v}
          set={(value) => setPlace(index, { look_at: [u, value, height] })}
        />
        <Metres
          name={t("height")}
          value={height}
          set={(value) => setPlace(index, { look_at: [u, v, value] })}
        />
        <Aim at="look_at" />
      </fieldset>
    </>
  );
}

/** Which of the two points the map sets. */
function Aim({ at }: { at: "viewpoint" | "look_at" }) {
  return (
    <button type="button" aria-pressed={aims.value === at} onClick={() => (aims.value = at)}>
      {t("on map")}
    </button>
  );
}

const CORNERS: Key[] = ["x from", "y from", "x to", "y to"];

function ZoneForm({ index }: { index: number }) {
  const zone = zones.value[index]!;
  return (
    <>
      <label>
        {t("Reason")}
        <input
          value={zone.reason}
          maxLength={60}
          required
          autocomplete="off"
          placeholder={t("Wet floor")}
          onInput={(event) => setZone(index, { reason: event.currentTarget.value })}
        />
      </label>
      <fieldset class="two">
        <legend>{t("Kept free [m]")}</legend>
        {[0, 2, 1, 3].map((k) => (
          <Metres
            key={k}
            name={t(CORNERS[k]!)}
            value={zone.rectangle[k]!}
            set={(value) => {
              const next: typeof zone.rectangle = [...zone.rectangle];
              next[k] = value;
              setZone(index, { rectangle: next });
            }}
          />
        ))}
      </fieldset>
    </>
  );
}
