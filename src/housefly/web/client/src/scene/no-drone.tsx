import { verdict } from "../store";
import { t, tongue, translated } from "../messages/language";

/** Instead of the orders, in a room without a drone: that nothing flies, and how to add one. */
export function NoDrone() {
  const known = (verdict.value?.known ?? []).map(translated);
  return (
    <section class="card no-drone" aria-label={t("No drone")}>
      <p>
        <strong>{t("No drone")}</strong>{" "}
        {t("The room sees, remembers and answers; nothing flies.")}{" "}
        <span class="quiet">
          {t("To add one, set enabled = true under [drone] in the site file and start again.")}
        </span>
      </p>
      {known.map((note) => (
        <p key={note} class="known" lang={tongue(note)}>
          △ {note}
        </p>
      ))}
    </section>
  );
}
