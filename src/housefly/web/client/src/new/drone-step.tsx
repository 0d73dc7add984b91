import { signal } from "@preact/signals";
import type { HeardView } from "../wire/draft-messages";
import { ask, change, known } from "./draft";
import { Button, Text } from "./fields";
import { Words } from "./heard-words";
import { t } from "./messages/texts";

const answered = signal<HeardView | null>(null);

export function DroneStep() {
  const { hardware, drone } = known.value;
  if (!hardware || !drone)
    return <p class="quiet">{t("The drone is simulated; “Tracking” says what flies.")}</p>;
  return (
    <>
      <Text
        name={t("Address")}
        value={drone.address}
        set={(address) => change({ drone: { ...drone, address } }, "drone.address")}
      />
      <Text
        name={t("Profile of housefly identify (may be empty)")}
        value={drone.profile}
        max={400}
        set={(profile) => change({ drone: { ...drone, profile } }, "drone.profile")}
      />
      <Button
        press={async () => {
          answered.value = null;
          answered.value = await ask<HeardView>("/drone/heard", t("Asking the drone …"));
        }}
      >
        {t("Ask the drone")}
      </Button>
      <Words said={answered.value} />
      <p class="quiet">{t("Nothing turns: it is only asked how it is.")}</p>
    </>
  );
}
