import type { ComponentChildren } from "preact";
import { busy } from "./draft";

interface TextProps {
  name: string;
  value: string;
  set: (value: string) => void;
  max?: number;
  placeholder?: string;
}

/** A line of text. */
export function Text({ name, value, set, max = 60, placeholder = "" }: TextProps) {
  return (
    <label>
      {name}
      <input
        value={value}
        maxLength={max}
        autocomplete="off"
        placeholder={placeholder}
        onInput={(event) => set(event.currentTarget.value)}
      />
    </label>
  );
}

interface ChoiceProps<Value extends string> {
  name: string;
  value: Value;
  options: readonly (readonly [Value, string])[];
  set: (value: Value) => void;
}

/** One of a few. */
export function Choice<Value extends string>({ name, value, options, set }: ChoiceProps<Value>) {
  return (
    <label>
      {name}
      <select value={value} onChange={(event) => set(event.currentTarget.value as Value)}>
        {options.map(([key, words]) => (
          <option key={key} value={key}>
            {words}
          </option>
        ))}
      </select>
    </label>
  );
}

/** Yes or no. */
export function Tick({
  name,
  value,
  set,
}: {
  name: string;
  value: boolean;
  set: (value: boolean) => void;
}) {
  return (
    <label class="tick">
      <input
        type="checkbox"
        checked={value}
        onChange={(event) => set(event.currentTarget.checked)}
      />
      {name}
    </label>
  );
}

interface ButtonProps {
  press: () => unknown;
  ready?: boolean;
  strong?: boolean;
  pressed?: boolean;
  children: ComponentChildren;
}

/** A button that waits while something else is under way. */
export function Button({ press, ready = true, strong = false, pressed, children }: ButtonProps) {
  const possible = ready && busy.value === "";
  return (
    <button
      type="button"
      class={strong && possible ? "strong" : ""}
      aria-disabled={!possible}
      {...(pressed === undefined ? {} : { "aria-pressed": pressed })}
      onClick={() => possible && press()}
    >
      {children}
    </button>
  );
}
