import type { ComponentChild } from "preact";
import { StopBar } from "./controls/stop";
import { Announcer } from "./panels/announcer";
import { Control } from "./panels/control";
import { Checks } from "./panels/preflight";
import { Help } from "./panels/help";
import { Said } from "./panels/said";
import { Top } from "./panels/top";
import { lazyScreen } from "./lazy-screen";
import { banner } from "./headline";
import { LiveScene } from "./scene/scene";
import { flying, hasDrone, panel, screen, swapped, type Screen } from "./store";
import { Hints } from "./hints/hints";
import { Questions } from "./tasks/questions";

const SCREENS: Record<Screen, () => ComponentChild> = {
  live: LiveScene,
  edit: lazyScreen(async () => (await import("./live/edit-screen")).EditScreen, true),
  tasks: lazyScreen(async () => (await import("./later")).TasksScreen),
};

const Invite = lazyScreen(async () => (await import("./later")).Invite);

/** The live scene, and beside it editing and the tasks; STOP is on each, in the same place. */
export function App() {
  const Shown = SCREENS[screen.value];
  return (
    <div
      class="app"
      data-flying={flying.value}
      data-drone={hasDrone.value}
      data-banner={banner.value !== ""}
      data-screen={screen.value}
      data-panel={panel.value}
      data-swapped={swapped.value && screen.value === "live" && hasDrone.value}
    >
      <Top />
      <Shown key={screen.value} />
      {screen.value !== "tasks" && <Questions over={true} />}
      {hasDrone.value && <StopBar />}
      <Checks />
      <Help />
      <Control />
      {panel.value === "invite" && <Invite />}
      <Hints />
      <Said />
      <Announcer />
    </div>
  );
}
