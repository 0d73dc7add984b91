import { signal } from "@preact/signals";
import { HoldButton } from "../controls/hold-button";
import { minutes, sentence } from "../format";
import { createHold } from "../hold";
import { clock } from "../live/words";
import { changeClip, clipTrouble, closeClip, opened, openedInfo } from "./clip-store";
import { subjectOf } from "./clips";
import { happened } from "./words";
import { clipAddress } from "./tasks-client";
import type { ClipInfo } from "../wire/task-messages";

const HOLD = 1;
const remove = createHold(HOLD, signal(""), () => void changeClip("delete"));

/** The clip that could not be shown, by id. */
const broken = signal("");

/** One clip, played, with what is known of it. Not modal: STOP stays within reach. */
export function ClipSheet() {
  const id = opened.value;
  if (!id) return null;
  const info = openedInfo.value;
  const title = info ? subjectOf(info) : "Clip";
  const isPicture = info?.kind === "snapshot";
  const fails = (): void => void (broken.value = id);
  return (
    <section class="sheet clip" role="dialog" aria-label={`Clip: ${title}`}>
      <div class="row">
        <h2>{title}</h2>
        <span class="row">
          <a class="button" href={clipAddress(id, true)} download>
            Save
          </a>
          <button type="button" onClick={closeClip}>
            Close
          </button>
        </span>
      </div>
      {info === undefined ? (
        <p class="quiet">…</p>
      ) : isPicture ? (
        <img src={clipAddress(id)} alt={`Picture of ${title}`} onError={fails} />
      ) : (
        <video
          key={id}
          src={clipAddress(id)}
          controls
          autoplay
          muted
          loop={false}
          playsInline
          aria-label={`Clip of ${title}`}
          onError={fails}
        />
      )}
      {broken.value === id && (
        <p role="alert">△ This clip is gone, or this browser cannot show it.</p>
      )}
      {clipTrouble.value && <p role="alert">△ {sentence(clipTrouble.value)}</p>}
      {info && (
        <>
          <div class="row">
            <button
              type="button"
              onClick={() => void changeClip(info.keep_until === null ? "let go" : "keep")}
            >
              {info.keep_until === null ? "Keep no longer than others" : "Keep"}
            </button>
            <HoldButton hold={remove} class="danger" label="Delete this clip">
              <span>Delete</span>
              <small aria-hidden="true">hold</small>
            </HoldButton>
          </div>
          <Facts info={info} />
        </>
      )}
    </section>
  );
}

const MEGABYTE = 1e6;

function Facts({ info }: { info: ClipInfo }) {
  const facts: [string, string][] = [
    ["When", clock(info.began_at) + (info.duration ? `, for ${minutes(info.duration)}` : "")],
    ["Place", info.place],
    ["Thing", info.thing],
    ["People", info.people.join(", ")],
    ["For", `${info.service}, task ${info.task}`],
    ["Because of", happened(info.cause)],
    ["End", info.cut_off ? "missing: a crash or a full disk cut it off" : ""],
    ["Privacy", info.blanked ? "a part of the picture is blank, as the site says" : ""],
    [
      "Kept",
      info.keep_until === null ? "until somebody deletes it" : `until ${clock(info.keep_until)}`,
    ],
    ["Size", `${(info.size / MEGABYTE).toFixed(1)} MB`],
  ];
  return (
    <dl class="chain">
      {facts
        .filter(([, words]) => words)
        .map(([name, words]) => [<dt key={name}>{name}</dt>, <dd key={`${name} is`}>{words}</dd>])}
    </dl>
  );
}
