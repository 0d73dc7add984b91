import { signal } from "@preact/signals";
import { Metres } from "../controls/metres";
import type { DraftTracking, HeardView } from "../wire/draft-messages";
import { ask, change, known } from "./draft";
import { Button, Choice, Text } from "./fields";
import { Words } from "./heard-words";
import { t } from "./messages/texts";

const kinds = () =>
  [
    ["vicon", "Vicon (DataStream)"],
    ["natnet", "OptiTrack (NatNet)"],
    ["vrpn", "VRPN"],
    ["bridge", t("another, by motioncapture")],
  ] as const;
const PORTS = { vicon: 801, natnet: 1510, vrpn: 3883, bridge: null };
const ups = () =>
  [
    ["auto", t("as usual")],
    ["z", "z"],
    ["y", "y"],
  ] as const;
const TRANSPORTS = [
  ["tcp", "TCP"],
  ["udp", "UDP"],
] as const;

const typed = signal<DraftTracking>({
  kind: "vicon",
  address: "",
  port: null,
  body: "ardrone",
  bridge_system: "qualisys",
  vrpn_transport: "tcp",
  up_axis: "auto",
});
export const heard = signal<HeardView | null>(null);

export function TrackingStep() {
  const { hardware } = known.value;
  return (
    <>
      <div class="chips" role="group" aria-label={t("What flies")}>
        <Button pressed={!hardware} press={() => change({ hardware: false })}>
          {t("All simulated")}
        </Button>
        <Button pressed={hardware} press={() => change({ hardware: true })}>
          {t("Real hardware")}
        </Button>
      </div>
      {hardware ? (
        <TrackingForm />
      ) : (
        <p class="quiet">
          {t("Drone and tracking are simulated: try the room first.")}{" "}
          {t("What is real can be said later.")}
        </p>
      )}
    </>
  );
}

function TrackingForm() {
  const tracking = known.value.tracking ?? typed.value;
  const set = (next: Partial<DraftTracking>): void => {
    typed.value = { ...tracking, ...next };
    const said = typed.value.address.trim() !== "";
    change({ tracking: said ? typed.value : null }, `tracking.${Object.keys(next)[0]}`);
  };
  const usual = PORTS[tracking.kind];
  return (
    <>
      <Choice
        name={t("System")}
        value={tracking.kind}
        options={kinds()}
        set={(kind) => set({ kind })}
      />
      <div class="pair">
        <Text
          name={t("Address")}
          value={tracking.address}
          placeholder="10.0.0.5"
          set={(address) => set({ address })}
        />
        {usual !== null && (
          <Metres
            name={t("Port")}
            step={1}
            value={tracking.port ?? usual}
            set={(port) => set({ port: port === usual ? null : port })}
          />
        )}
        {tracking.kind === "bridge" && (
          <Text
            name={t("Its type in motioncapture")}
            value={tracking.bridge_system}
            set={(bridge_system) => set({ bridge_system })}
          />
        )}
      </div>
      <div class="pair">
        <Text
          name={t("The drone's name there")}
          value={tracking.body}
          set={(body) => set({ body })}
        />
        {tracking.kind === "natnet" && (
          <Choice
            name={t("Axis up")}
            value={tracking.up_axis}
            options={ups()}
            set={(up_axis) => set({ up_axis })}
          />
        )}
        {tracking.kind === "vrpn" && (
          <Choice
            name={t("Begins by")}
            value={tracking.vrpn_transport}
            options={TRANSPORTS}
            set={(vrpn_transport) => set({ vrpn_transport })}
          />
        )}
      </div>
      <Button ready={known.value.tracking !== null} press={listen}>
        {t("Listen for {n} s", { n: 3 })}
      </Button>
      <Words said={heard.value} />
      {heard.value && heard.value.bodies.length > 0 && (
        <div class="chips" role="group" aria-label={t("Which one is the drone")}>
          {heard.value.bodies.map(({ name }) => (
            <Button
              key={name}
              pressed={name === tracking.body}
              press={() => set({ body: name })}
            >
              {name}
            </Button>
          ))}
        </div>
      )}
    </>
  );
}

/** Listen to what is kept as the tracking system. */
export async function listen(): Promise<void> {
  heard.value = null;
  heard.value = await ask<HeardView>("/tracking/heard", t("Listening …"));
}
