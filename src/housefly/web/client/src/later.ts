// What the first paint does not need, in one file: fetched soon after it, or when it is opened.
import "./later-style";

export { Invite } from "./device/invite";
export { CoverageLayer, CoverageLegend } from "./live/coverage";
export { Feed } from "./feed/feed";
export { AfterCard } from "./scene/after-card";
export { OnPhone } from "./scene/on-phone";
export { Bubble } from "./hints/bubbles";
export { CurveLayer, SpeedLegend } from "./map/curve";
export { HeightProfile } from "./map/height-profile";
export { Turning } from "./map/turning";
export { Nudge } from "./controls/nudge";
export { RecordedLayer } from "./replay/recorded-layer";
export { RecordedBanner, RecordedLog, RecordedPicture } from "./replay/recorded-parts";
export { TasksScreen } from "./tasks/tasks-screen";
export { Recording } from "./timebar/recording";
