import { signal } from "@preact/signals";
import type { DraftDrone, HeardView } from "../wire/draft-messages";
import { ask, change, known, view } from "./draft";
import { Button, Choice, Text } from "./fields";
import { Words } from "./heard-words";
import { t } from "./messages/texts";

const answered = signal<HeardView | null>(null);

export function DroneStep() {
  const { hardware } = known.value;
  const drone: DraftDrone = known.value.drone ?? { address: "", profile: "", model: "ardrone" };
  const models = view.value?.models ?? [];
  const set = (next: Partial<DraftDrone>): void =>
    change({ drone: { ...drone, ...next } }, `drone.${Object.keys(next)[0]}`);
  return (
    <>
      <Choice
        name={t("Drone")}
        value={drone.model}
        options={models.map(({ model, name }) => [model, name] as const)}
        set={(model) => {
          const { address } = models.find((one) => one.model === model)!;
          set({ model, address, profile: "" });
        }}
      />
      {hardware ? (
        <Real drone={drone} set={set} />
      ) : (
        <p class="quiet">{t("The drone is simulated; “Tracking” says what flies.")}</p>
      )}
    </>
  );
}

interface RealProps {
  drone: DraftDrone;
  set: (next: Partial<DraftDrone>) => void;
}

/** Where a real one answers, and whether it does. */
function Real({ drone, set }: RealProps) {
  return (
    <>
      <Text name={t("Address")} value={drone.address} set={(address) => set({ address })} />
      <Text
        name={t("Profile of housefly identify (may be empty)")}
        value={drone.profile}
        max={400}
        set={(profile) => set({ profile })}
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
