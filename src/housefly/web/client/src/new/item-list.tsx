import type { ComponentChildren } from "preact";
import { useLayoutEffect, useRef } from "preact/hooks";
import { known } from "./draft";
import { countOf, type Kind } from "./items";
import { t } from "./messages/texts";
import { nameOfItem } from "./names";
import { choose, chosen, remove } from "./tools";

/** What was drawn, in a list; what is open has a form. */
export function ItemList({
  kind,
  label,
  form,
}: {
  kind: Kind;
  label: string;
  form: (index: number) => ComponentChildren;
}) {
  const count = countOf(known.value, kind);
  if (count === 0) return null;
  return (
    <ul class="rows" aria-label={label}>
      {Array.from({ length: count }, (_, index) => (
        <Row key={index} kind={kind} index={index} form={form} />
      ))}
    </ul>
  );
}

interface RowProps {
  kind: Kind;
  index: number;
  form: (index: number) => ComponentChildren;
}

function Row({ kind, index, form }: RowProps) {
  const item = { kind, index };
  const open = chosen.value?.kind === kind && chosen.value.index === index;
  const name = nameOfItem(known.value, item);
  const row = useRef<HTMLLIElement>(null);
  useLayoutEffect(() => {
    if (open) row.current!.scrollIntoView({ block: "nearest" });
  }, [open]);
  return (
    <li ref={row} data-kind={kind}>
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
          onClick={() => remove(item)}
        >
          {t("Remove")}
        </button>
      </div>
      {open && (
        <form
          noValidate
          onSubmit={(event) => {
            event.preventDefault();
            choose(null);
          }}
        >
          {form(index)}
          <button type="submit">{t("Done")}</button>
        </form>
      )}
    </li>
  );
}
