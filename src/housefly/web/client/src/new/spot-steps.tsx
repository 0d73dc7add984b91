import { Metres } from "../controls/metres";
import type { DraftPlace, SiteDraft } from "../wire/draft-messages";
import { act, change, known } from "./draft";
import { Button, Text, Tick } from "./fields";
import { ItemList } from "./item-list";
import { degrees, radians, rounded } from "./geometry";
import { lookOf, with_ } from "./items";
import { t } from "./messages/texts";
import { slug } from "./unique-names";
import { addInTheMiddle } from "./tools";

export function PadStep() {
  const { pad, pad_yaw } = known.value;
  return (
    <>
      <div class="chips">
        <Button press={() => act("/draft/pad", {}, t("Looking for a roomy spot …"))}>
          {t("Choose a roomy spot")}
        </Button>
        {!pad && (
          <Button press={() => addInTheMiddle("pad")}>{t("Put it in the middle")}</Button>
        )}
      </div>
      {pad && (
        <fieldset>
          <legend>{t("Pad [m], nose [°]")}</legend>
          <Metres name="x" value={pad[0]} set={(x) => change({ pad: [x, pad[1]] }, "pad.0")} />
          <Metres name="y" value={pad[1]} set={(y) => change({ pad: [pad[0], y] }, "pad.1")} />
          <Metres
            name={t("nose looks to")}
            step={5}
            value={degrees(pad_yaw)}
            set={(value) => change({ pad_yaw: radians(value) }, "pad_yaw")}
          />
        </fieldset>
      )}
      <p class="quiet">
        {t("The drone starts and lands there. 0° is along x, 90° along y.")}
      </p>
    </>
  );
}

export function PlacesStep() {
  return (
    <>
      <div class="chips">
        <Button press={() => addInTheMiddle("places")}>{t("Add a place")}</Button>
        <Button press={() => act("/draft/places", {}, t("Looking for roomy spots …"))}>
          {t("Choose roomy spots")}
        </Button>
      </div>
      <ItemList kind="places" label={t("Places")} form={(index) => <PlaceForm index={index} />} />
    </>
  );
}

/** Titled anew, a place is called by that in commands too. */
function retitled(all: SiteDraft, index: number, title: string): Partial<DraftPlace> {
  const others = all.places.filter((_, k) => k !== index).map((one) => one.name);
  return title.trim() ? { title, name: slug(title, others) } : { title };
}

function PlaceForm({ index }: { index: number }) {
  const all = known.value;
  const place = all.places[index]!;
  const set = (next: Partial<DraftPlace>, field: string): void =>
    change(with_(known.value, "places", index, next), `places.${index}.${field}`);
  const [u, v] = lookOf(all, index).map(rounded) as [number, number];
  const height = place.look_at?.[2] ?? all.flight_height;
  return (
    <>
      <Text
        name={t("Name")}
        value={place.title}
        max={40}
        placeholder={t("Reading corner")}
        set={(title) => set(retitled(known.value, index, title), "title")}
      />
      <small class="quiet">{t("In commands: {name}", { name: place.name })}</small>
      <fieldset class="two">
        <legend>{t("Hovers at [m]")}</legend>
        <Metres name="x" value={place.x} set={(x) => set({ x }, "x")} />
        <Metres name="y" value={place.y} set={(y) => set({ y }, "y")} />
      </fieldset>
      {place.look_at && (
        <fieldset>
          <legend>{t("Looks at [m]")}</legend>
          <Metres name="x" value={u} set={(x) => set({ look_at: [x, v, height] }, "u")} />
          <Metres name="y" value={v} set={(y) => set({ look_at: [u, y, height] }, "v")} />
          <Metres
            name={t("height")}
            value={height}
            set={(z) => set({ look_at: [u, v, z] }, "z")}
          />
        </fieldset>
      )}
      <Tick
        name={t("looks away from the pad")}
        value={place.look_at === null}
        set={(away) => set({ look_at: away ? null : [u, v, height] }, "away")}
      />
    </>
  );
}

export function ZonesStep() {
  return (
    <>
      <Button press={() => addInTheMiddle("zones")}>{t("Add a zone")}</Button>
      <ItemList
        kind="zones"
        label={t("No-fly zones")}
        form={(index) => <ZoneForm index={index} />}
      />
      <p class="quiet">
        {t("None are needed: walls and furniture are kept away from anyway.")}
      </p>
    </>
  );
}

const CORNERS = ["x from", "y from", "x to", "y to"] as const;

function ZoneForm({ index }: { index: number }) {
  const zone = known.value.zones[index]!;
  return (
    <>
      <Text
        name={t("Reason")}
        value={zone.reason}
        placeholder={t("Wet floor")}
        set={(reason) =>
          change(with_(known.value, "zones", index, { reason }), `zones.${index}.reason`)
        }
      />
      <fieldset class="two">
        <legend>{t("Kept free [m]")}</legend>
        {CORNERS.map((name, k) => (
          <Metres
            key={name}
            name={t(name)}
            value={zone.rectangle[k]!}
            set={(value) => {
              const next: typeof zone.rectangle = [...zone.rectangle];
              next[k] = value;
              change(
                with_(known.value, "zones", index, { rectangle: next }),
                `zones.${index}.${k}`,
              );
            }}
          />
        ))}
      </fieldset>
    </>
  );
}
