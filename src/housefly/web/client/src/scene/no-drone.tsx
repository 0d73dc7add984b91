import { t } from "../messages/language";

/** Instead of the orders, in a room without a drone: that nothing flies, and how to add one. */
export const NoDrone = () => (
  <section class="card no-drone" aria-label={t("No drone")}>
    <p>
      <strong>{t("No drone")}</strong>{" "}
      {t("To add one: enabled = true under [drone] in the site file.")}
    </p>
  </section>
);
