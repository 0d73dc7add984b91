import { catalogue } from "../live/store";
import { room } from "../store";
import type { ParameterInfo } from "../wire/task-messages";
import { translated } from "../messages/language";
import type { Value } from "./tasks-client";

const NAMES = ["place", "thing", "place_or_thing", "person", "places"];

interface FieldProps {
  parameter: ParameterInfo;
  value: Value | null;
  put: (value: Value) => void;
  /** After the last letter. */
  done: () => void;
}

/** One value of a service, by its type. */
export function Field({ parameter, value, put, done }: FieldProps) {
  const { name, type, unit } = parameter;
  const label = translated(parameter.about || name) + (unit ? ` [${unit}]` : "");
  if (type === "flag")
    return (
      <label class="field flag">
        <input
          type="checkbox"
          checked={value === true}
          onChange={(event) => {
            put(event.currentTarget.checked);
            done();
          }}
        />
        {label}
      </label>
    );
  const isNumber = type === "number";
  return (
    <label class="field">
      {label}
      <input
        type={isNumber ? "number" : "text"}
        step="any"
        list={NAMES.includes(type) ? "subjects" : undefined}
        required={parameter.required}
        maxLength={200}
        autocomplete="off"
        defaultValue={value === null ? "" : String(value)}
        placeholder={parameter.default === null ? "" : String(parameter.default)}
        onInput={(event) => {
          const text = event.currentTarget.value;
          put(isNumber && text !== "" ? Number(text) : text);
        }}
        onChange={done}
      />
    </label>
  );
}

/** What somebody may mean: places of the map, things of the room. */
export function Subjects() {
  const places = (room.value?.places ?? []).map((one) => one.title);
  const things = catalogue.value.map((one) => one.name);
  return (
    <datalist id="subjects">
      {[...new Set([...places, ...things])].map((name) => (
        <option key={name} value={name} />
      ))}
    </datalist>
  );
}
