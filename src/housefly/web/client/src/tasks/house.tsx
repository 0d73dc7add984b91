import { board, records, running, silent } from "./board";

/** The mode of the house, and whether the camera records: on every screen. */
export function House() {
  if (silent.value) return <span class="house worry">services not running</span>;
  if (!running.value || !board.value) return null;
  return (
    <span class="house" title="Mode of the house">
      <strong class="recording" role="status">
        {records.value ? "● recording " : ""}
      </strong>
      <span class="spoken">Mode of the house: </span>
      {board.value.mode}
    </span>
  );
}
