import { signal } from "@preact/signals";
import type { ComponentChild } from "preact";
import type { WrittenView } from "../wire/draft-messages";
import { ask, view } from "./draft";
import { Button } from "./fields";
import { t } from "./messages/texts";

export type Files = WrittenView["files"];

const written = signal<{ version: string; files: Files } | null>(null);
/** What is shown of it, fetched when there is something. */
const Written = signal<((props: { files: Files }) => ComponentChild) | null>(null);

export function SaveStep() {
  const { missing, version } = view.value!;
  const hindered = missing.some((one) => one.hinders);
  const write = async (): Promise<void> => {
    written.value = null;
    const answer = await ask<WrittenView>("/site", t("Writing …"));
    if (!answer) return;
    Written.value = (await import("./written")).Written;
    written.value = { version: view.value!.version, files: answer.files };
  };
  const done = written.value?.version === version ? written.value.files : null;
  return (
    <>
      {hindered ? (
        <p>{t("What the steps above still lack has to be said first.")}</p>
      ) : (
        <p class="quiet">
          {t("Room and site are written as files that you can read and change.")}
        </p>
      )}
      <Button strong ready={!hindered} press={write}>
        {t("Write the site")}
      </Button>
      {done && Written.value && <Written.value files={done} />}
    </>
  );
}
