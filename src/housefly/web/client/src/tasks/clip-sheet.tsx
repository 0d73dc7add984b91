import { signal } from "@preact/signals";
import { HoldButton } from "../controls/hold-button";
import { minutes, sentence } from "../format";
import { createHold } from "../hold";
import { clock } from "../live/words";
import type { Key } from "../messages/en";
import { changeClip, clipTrouble, closeClip, opened, openedInfo } from "./clip-store";
import { subjectOf } from "./clips";
import { causeOf } from "./words";
import { clipAddress } from "./tasks-client";
import type { ClipInfo } from "../wire/task-messages";
import { decimal, t, translated } from "../messages/language";

const HOLD = 1;
const remove = createHold(HOLD, signal(""), () => void changeClip("delete"));

/** The clip that could not be shown, by id. */
const broken = signal("");

/** One clip, played, with what is known of it. Not modal: STOP stays within reach. */
export function ClipSheet() {
  const id = opened.value;
  if (!id) return null;
  const info = openedInfo.value;
  const title = info ? subjectOf(info) : t("Clip");
  const isPicture = info?.kind === "snapshot";
  const fails = (): void => void (broken.value = id);
  return (
    <section class="sheet clip" role="dialog" aria-label={`${t("Clip")}: ${title}`}>
      <div class="row">
        <h2>{title}</h2>
        <span class="row">
          <a class="button" href={clipAddress(id, "&download=1")} download>
            {t("Save")}
          </a>
          <button type="button" onClick={closeClip}>
            {t("Close")}
          </button>
        </span>
      </div>
      {info === undefined ? (
        <p class="quiet">…</p>
      ) : isPicture ? (
        <img src={clipAddress(id)} alt={t("Picture of {title}", { title })} onError={fails} />
      ) : (
        <video
          key={id}
          src={clipAddress(id)}
          controls
          autoplay
          muted
          loop={false}
          playsInline
          aria-label={t("Clip of {title}", { title })}
          onError={fails}
        />
      )}
      {broken.value === id && (
        <p role="alert">△ {t("This clip is gone, or this browser cannot show it.")}</p>
      )}
      {clipTrouble.value && <p role="alert">△ {sentence(translated(clipTrouble.value))}</p>}
      {info && (
        <>
          <div class="row">
            <button
              type="button"
              onClick={() => void changeClip(info.keep_until === null ? "let go" : "keep")}
            >
              {info.keep_until === null ? t("Keep no longer than others") : t("Keep")}
            </button>
            <HoldButton hold={remove} class="danger" label={t("Delete this clip")}>
              <span>{t("Delete")}</span>
              <small aria-hidden="true">{t("hold")}</small>
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
  const facts: [Key, string][] = [
    ["When", clock(info.began_at) + (info.duration ? `, ${minutes(info.duration)}` : "")],
    ["Place", info.place],
    ["Thing", info.thing],
    ["People", info.people.join(", ")],
    ["For", info.task ? t("{service}, task {n}", { service: info.service, n: info.task }) : ""],
    [info.task ? "Because of" : "Taken by", causeOf(info.cause)],
    ["End", info.cut_off ? t("missing: a crash or a full disk cut it off") : ""],
    ["Privacy", info.blanked ? t("a part of the picture is blank, as the site says") : ""],
    [
      "Kept",
      info.keep_until === null
        ? t("until somebody deletes it")
        : t("until {time}", { time: clock(info.keep_until) }),
    ],
    ["Size", `${decimal(info.size / MEGABYTE, 1)} MB`],
  ];
  return (
    <dl class="chain">
      {facts
        .filter(([, words]) => words)
        .map(([name, words]) => [
          <dt key={name}>{t(name)}</dt>,
          <dd key={`${name} is`}>{words}</dd>,
        ])}
    </dl>
  );
}
