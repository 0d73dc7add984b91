// Banner, log and picture of a recording; their code is fetched after the first paint.
import { lazyPart } from "../lazy-part";

const parts = (): Promise<typeof import("../later")> => import("../later");

export const RecordedBanner = lazyPart(async () => (await parts()).RecordedBanner);
export const RecordedLog = lazyPart(async () => (await parts()).RecordedLog);
export const RecordedPicture = lazyPart(async () => (await parts()).RecordedPicture);
