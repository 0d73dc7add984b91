import { simulated } from "../store";
import { lazyPart } from "../lazy-part";

const Strip = lazyPart(async () => (await import("./strip")).Strip, undefined, true);

/** What may be done to the room, where it is simulated. */
export const Sim = () => (simulated.value ? <Strip /> : null);
