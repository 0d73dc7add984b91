import { go } from "../timebar/past";
import { at, hubNow, picture } from "./store";
import { ago, clock } from "./words";
import { t } from "../messages/language";

/** Across the map, so that nobody takes the past for the present. */
export function PastBanner() {
  if (at.value === null) return null;
  return (
    <p class="past-banner" role="status">
      <strong>{picture.value ? t("The past") : t("Fetching the past")}</strong>
      <span>
        {clock(at.value)}, {ago(hubNow.value - at.value)}
      </span>
      <button type="button" onClick={() => go(null)}>
        {t("Back to now")}
      </button>
    </p>
  );
}
