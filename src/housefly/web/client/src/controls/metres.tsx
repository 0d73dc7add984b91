import { useLayoutEffect, useRef } from "preact/hooks";

interface MetresProps {
  name: string;
  value: number;
  set: (value: number) => void;
  step?: number;
}

/** A number field that leaves half-typed input such as "4." alone. */
export function Metres({ name, value, set, step = 0.05 }: MetresProps) {
  const field = useRef<HTMLInputElement>(null);
  const show = (): void => {
    // Blur comes also when the form goes away.
    const input = field.current;
    if (input && input.valueAsNumber !== value) input.value = String(value);
  };
  useLayoutEffect(() => {
    if (document.activeElement !== field.current) show();
  }, [value]);
  return (
    <label>
      {name}
      <input
        ref={field}
        type="number"
        step={step}
        onBlur={show}
        onBeforeInput={decimalPoint}
        onInput={(event) =>
          Number.isFinite(event.currentTarget.valueAsNumber) &&
          set(event.currentTarget.valueAsNumber)
        }
      />
    </label>
  );
}

/** A comma typed for a decimal point is one: a browser may drop it, and read 6,5 as 65. */
function decimalPoint(event: InputEvent): void {
  if (event.data?.split(",").length !== 2) return;
  event.preventDefault();
  document.execCommand("insertText", false, event.data.replace(",", "."));
}
