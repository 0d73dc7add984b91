import { board, records, running, silent } from "./board";
import { t } from "../messages/language";

/** The mode of the house, and whether the camera records: on every screen. */
export function House() {
  if (silent.value) return <span class="house worry">{t("services not running")}</span>;
  if (!running.value || !board.value) return null;
  return (
    <span class="house" title={t("Mode of the house")}>
      <strong class="recording" role="status">
        {records.value ? `● ${t("recording")} ` : ""}
      </strong>
      <span class="spoken">{t("Mode of the house")}: </span>
      {t(`${board.value.mode}^mode`)}
    </span>
  );
}
