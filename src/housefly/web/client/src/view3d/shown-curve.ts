import { computed } from "@preact/signals";
import { curve, type Curve } from "../map/curve-values";
import { recordedCurve } from "../replay/recorded-state";
import { replay } from "../replay/replay";

/** The planned curve of the present, or of the recording that is looked at. */
export const shownCurve = computed<Curve | null>(() =>
  replay.value ? recordedCurve.value : curve.value,
);
