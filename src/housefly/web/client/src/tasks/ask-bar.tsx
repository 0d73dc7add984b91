import { computed, signal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { sentence } from "../format";
import { HoldButton } from "../controls/hold-button";
import { createHold } from "../hold";
import { running } from "./board";
import { ideas } from "./ideas";
import { learnNames } from "./names";
import { request, say } from "./tasks-client";
import type { SentenceAnswer } from "../wire/task-messages";

const said = signal("");
const answer = signal<SentenceAnswer | null>(null);
const trouble = signal("");

async function ask(words: string): Promise<void> {
  if (!words.trim()) return;
  said.value = words;
  answer.value = null;
  trouble.value = "";
  try {
    const found = await say(words.trim());
    if (said.value === words) answer.value = found;
  } catch (error) {
    if (said.value === words) trouble.value = (error as Error).message;
  }
}

const HOLD = 0.6;
const objection = computed(() => (running.value ? "" : "The services are not running."));
const accept = createHold(HOLD, objection, () => void take());

/** Take what an answer offers: "it was seen long ago, shall I go and look?" */
async function take(): Promise<void> {
  const offer = answer.value?.offer;
  if (!offer) return;
  try {
    const { tasks } = await request(offer.service, offer.parameters);
    answer.value = { ...answer.value!, offer: null, words: tasks[0]?.words ?? "" };
  } catch (error) {
    trouble.value = (error as Error).message;
  }
}

/** Ask in a sentence; what would fly shows its rehearsal and waits for a yes. */
export function AskBar() {
  const field = useRef<HTMLInputElement>(null);
  useEffect(learnNames, []);
  const go = (words: string): void => {
    if (field.current) field.current.value = words;
    void ask(words);
  };
  return (
    <section class="card ask" aria-label="Ask">
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
          enterkeyhint="go"
          aria-label="Ask for something"
          placeholder="Look at the entrance, where is the cup …"
          maxLength={500}
          autocomplete="off"
        />
        <button type="submit" class="primary" aria-disabled={!running.value}>
          Ask
        </button>
      </form>
      <div class="answer" role="status">
        <Answer go={go} />
      </div>
      {!answer.value?.suggestions.length && <Chips words={ideas()} go={go} />}
    </section>
  );
}

function Answer({ go }: { go: (words: string) => void }) {
  const found = answer.value;
  if (trouble.value) return <p>△ {sentence(trouble.value)}</p>;
  if (!found) return said.value ? <p class="quiet">…</p> : null;
  return (
    <>
      <p class="words" data-understood={found.understood}>
        {!found.understood && "△ "}
        {sentence(found.words)}
      </p>
      {found.offer && (
        <HoldButton hold={accept} class="primary" label="Yes, do it">
          <span>Yes, do it</span>
          <small>hold</small>
        </HoldButton>
      )}
      {found.suggestions.length > 0 && <Chips words={found.suggestions} go={go} />}
    </>
  );
}

function Chips({ words, go }: { words: string[]; go: (words: string) => void }) {
  return (
    <p class="chips">
      {words.map((one) => (
        <button
          type="button"
          key={one}
          aria-disabled={!running.value}
          onClick={() => running.value && go(one)}
        >
          {one}
        </button>
      ))}
    </p>
  );
}
