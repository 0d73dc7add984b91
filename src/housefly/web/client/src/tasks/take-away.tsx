import { signal } from "@preact/signals";
import { sentence } from "../format";
import { fetchAsSession } from "../wire/session";
import { clipsAddress } from "./tasks-client";
import type { ClipInfo } from "../wire/task-messages";
import { translated } from "../messages/language";

const MOST = 200;
const NOT_YOURS = "with your role clips can be watched, not taken away together";

/** Why nothing was taken away, by the clips that were asked for. */
const trouble = signal<{ of: string; words: string }>({ of: "", words: "" });

async function takeAway(address: string): Promise<void> {
  const answer = await fetchAsSession(address, { method: "HEAD" }).catch(() => null);
  const words = !answer
    ? "no contact with the server"
    : answer.status === 403
      ? NOT_YOURS
      : answer.statusText;
  trouble.value = answer?.ok ? { of: "", words: "" } : { of: address, words };
  if (answer?.ok) location.assign(address);
}

/** Saves several clips at once, with all that is known of them. */
export function TakeAway({ clips, label }: { clips: readonly ClipInfo[]; label: string }) {
  if (clips.length === 0) return null;
  const address = clipsAddress(clips.slice(0, MOST).map((clip) => clip.id));
  return (
    <>
      <button type="button" onClick={() => void takeAway(address)}>
        {label}
      </button>
      {trouble.value.of === address && (
        <span role="alert">△ {sentence(translated(trouble.value.words))}</span>
      )}
    </>
  );
}
