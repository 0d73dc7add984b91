import { useRef } from "preact/hooks";
import { find } from "./room-client";
import { at, catalogue, found, nameOf } from "./store";
import { clock } from "./words";

const QUIET_KINDS = ["sensor", "structure"];

/** Where is it? The answer in words, and around what it is on the map. */
export function Find() {
  const field = useRef<HTMLInputElement>(null);
  const names = catalogue.value
    .filter((one) => !QUIET_KINDS.includes(one.kind))
    .flatMap((one) => [one.name, ...one.aliases]);
  const go = (words: string): void => {
    if (field.current) field.current.value = words;
    void find(words);
  };
  return (
    <section class="card find" aria-label="Find a thing">
      <form
        role="search"
        onSubmit={(event) => {
          event.preventDefault();
          go(field.current!.value);
        }}
      >
        <input
          ref={field}
          type="search"
          aria-label="Where is"
          placeholder="Where is …"
          list="names"
          maxLength={200}
          autocomplete="off"
          onInput={(event) => event.currentTarget.value === "" && go("")}
        />
        <button type="submit">Find</button>
        <datalist id="names">
          {[...new Set(names)].map((name) => (
            <option key={name} value={name} />
          ))}
        </datalist>
      </form>
      <div class="answer" role="status">
        <Answer go={go} />
      </div>
    </section>
  );
}

function Answer({ go }: { go: (words: string) => void }) {
  const { answer, problem, meant } = found.value;
  if (problem) {
    return (
      <>
        <p>△ {problem}</p>
        {meant.length > 0 && (
          <p class="chips">
            {meant.map((name) => (
              <button type="button" key={name} onClick={() => go(name)}>
                {name}
              </button>
            ))}
          </p>
        )}
      </>
    );
  }
  if (!answer) return <p class="quiet">By name or nickname, or touch something on the map.</p>;
  const perhaps = answer.alternatives.map((one) => one.thing).filter((id) => id);
  const around = [...new Set([...answer.inside, ...perhaps])];
  return (
    <>
      {at.value !== null && <strong class="then">At {clock(at.value)}: </strong>}
      <p class="words">{answer.words}</p>
      {around.length > 0 && (
        <p class="chips">
          {around.map((id) => (
            <button type="button" key={id} onClick={() => go(id)}>
              {nameOf(id)}
            </button>
          ))}
        </p>
      )}
    </>
  );
}
