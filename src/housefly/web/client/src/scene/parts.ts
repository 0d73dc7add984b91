// Parts of the scene that the first paint does not need, in one file: fetched soon after it.
export { CurveLayer, SpeedLegend } from "../map/curve";
export { HeightProfile } from "../map/height-profile";
export { RecordedLayer } from "../replay/recorded-layer";
export { RecordedBanner, RecordedLog, RecordedPicture } from "../replay/recorded-parts";
export { Recording } from "../timebar/recording";
