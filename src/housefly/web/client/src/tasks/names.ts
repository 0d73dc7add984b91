// What somebody may mean by a name; the ROOM screen asks for it, too.
import { catalogue } from "../live/store";
import { things } from "./tasks-client";

export function learnNames(): void {
  if (catalogue.value.length === 0)
    things()
      .then((answer) => (catalogue.value = answer.things))
      .catch(() => undefined);
}
