import { signal } from "@preact/signals";
import type { WrittenView } from "../wire/draft-messages";
import { ask, view } from "./draft";
import { Button } from "./fields";
import type { Key } from "./messages/en";
import { t } from "./messages/texts";

const written = signal<{ version: string; files: WrittenView["files"] } | null>(null);

function commands(folder: string, hardware: boolean): [Key, string][] {
  const site = /^[\w./-]+$/.test(folder) ? folder : `'${folder.replaceAll("'", "'\\''")}'`;
  const simulated = hardware ? site.replace(/'?$/, "/simulated.toml$&") : site;
  const first: [Key, string][] = [
    ["Is this machine fit for it?", `housefly doctor --site ${site}`],
    ["The whole thing, simulated", `housefly demo --site ${simulated}`],
  ];
  if (!hardware) return first;
  return [
    ...first,
    [
      "Before the first flight, the drone in your hands",
      `housefly preflight --frames --site ${site}`,
    ],
    ["The real room", `housefly run --site ${site}`],
  ];
}

export function SaveStep() {
  const { missing, folder, version, draft } = view.value!;
  const hindered = missing.some((one) => one.hinders);
  const write = async (): Promise<void> => {
    written.value = null;
    const answer = await ask<WrittenView>("/site", t("Writing …"));
    if (answer) written.value = { version: view.value!.version, files: answer.files };
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
      <div role="status">
        {done && (
          <>
            <p>{t("Written to {folder}. In a terminal:", { folder })}</p>
            {commands(folder, draft.hardware).map(([words, line]) => (
              <div key={line} class="next-line">
                <small class="quiet">{t(words)}</small>
                <pre>{line}</pre>
              </div>
            ))}
          </>
        )}
      </div>
      {done?.map(({ path, text }) => (
        <details key={path}>
          <summary>{path.split("/").at(-1)}</summary>
          <pre>{text}</pre>
        </details>
      ))}
    </>
  );
}
