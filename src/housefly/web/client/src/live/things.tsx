import { at, found, shown, type Seen } from "./store";
import { turn, type Projection } from "../map/projection";
import { keepInView } from "../map/view";
import { find } from "./room-client";
import { LINE } from "../map/label-spots";
import { ObstacleLayer } from "./obstacles";
import { MOVES, personRadius, takenByNames, wordsOf, type Words } from "./thing-labels";
import { kindOf } from "./words";

const FADES: [number, number][] = [
  [2, 1],
  [30, 0.8],
  [300, 0.6],
];
const FAINTEST = 0.45;
/** Head and shoulders, in a circle of 12. */
const PERSON = "M0-7a3.2 3.2 0 1 1 0 6.4a3.2 3.2 0 1 1 0-6.4zM-6 6.5a6 5.2 0 0 1 12 0z";

/** What moves, at its place; what is inside something, beside it; faded by age. */
export function ThingsLayer({ to }: { to: Projection }) {
  const all = shown.value;
  const byId = new Map(all.map((one) => [one.thing, one]));
  const inside = new Map<string, Seen[]>();
  for (const one of all)
    if (byId.has(one.inside)) inside.set(one.inside, [...(inside.get(one.inside) ?? []), one]);
  const drawn = all.filter(
    (one) =>
      one.position &&
      // Where the drone is now, the pilot knows better.
      (kindOf(one) !== "robot" || at.value !== null) &&
      (inside.has(one.thing) || (MOVES.includes(kindOf(one)) && !byId.get(one.inside)?.position)),
  );
  const taken = takenByNames(to);
  const words = wordsOf(drawn, inside, to, taken);
  return (
    <>
      <ObstacleLayer to={to} taken={taken} />
      <g class="things">
        <Rings to={to} byId={byId} />
        {drawn.map((one) => (
          <Mark key={one.thing} to={to} thing={one} words={words.get(one.thing)!} />
        ))}
      </g>
    </>
  );
}

/** Rings around what was searched for, or around what it is in; dashed where it may be instead. */
function Rings({ to, byId }: { to: Projection; byId: Map<string, Seen> }) {
  const answer = found.value.answer;
  if (!answer) return null;
  const known = [
    answer.position,
    ...[answer.thing, ...answer.inside].map((id) => byId.get(id)?.position),
  ].find((position) => position != null);
  const rings = [
    { place: known, kind: "found" },
    ...answer.alternatives.map((one) => ({ place: one.position, kind: "found perhaps" })),
  ];
  return (
    <>
      {rings.map(({ place, kind }, index) => {
        if (!place) return null;
        const [u, v] = to.at([place[0], place[1]]);
        return (
          <g class={kind} key={index} transform={`translate(${u.toFixed(1)} ${v.toFixed(1)})`}>
            <circle r="22" />
            <circle class="outer" r="28" />
          </g>
        );
      })}
    </>
  );
}

interface MarkProps {
  to: Projection;
  thing: Seen;
  words: Words;
}

function Mark({ to, thing, words }: MarkProps) {
  const kind = kindOf(thing);
  const [x, y] = thing.position!;
  const [u, v] = to.at([x, y]);
  const { lines, age } = words;
  const press = (event: Event): void => {
    event.stopPropagation();
    void find(thing.name);
  };
  return (
    <g
      class="thing-mark"
      data-kind={kind}
      data-thing={thing.thing}
      role="button"
      tabindex={0}
      aria-label={words.said}
      style={{
        transform: `translate(${u.toFixed(1)}px, ${v.toFixed(1)}px)`,
        opacity: MOVES.includes(kind) ? fade(age) : 1,
      }}
      onClick={press}
      onFocus={(event) => event.currentTarget.matches(":focus-visible") && keepInView([x, y])}
      onKeyDown={(event) => event.key === "Enter" && press(event)}
    >
      <circle class="reach" r="16" />
      <Shape to={to} kind={kind} yaw={thing.yaw} />
      {lines.map((line, k) => (
        <text key={k} class={line.kind} x={words.x} y={words.y + k * LINE}>
          {line.text}{" "}
        </text>
      ))}
    </g>
  );
}

function Shape({ to, kind, yaw }: { to: Projection; kind: string; yaw: number | null }) {
  if (kind === "person") {
    return (
      <g class="person">
        <circle class="body" r={personRadius(to.scale)} />
        <path d={PERSON} transform={`scale(${(personRadius(to.scale) / 12).toFixed(2)})`} />
      </g>
    );
  }
  if (kind === "robot") {
    return (
      <g class="drone" transform={yaw === null ? "" : `rotate(${turn(yaw, to)})`}>
        <circle class="hull" r="12" />
        {yaw !== null && <path class="arrow" d="M9 0L-6 6L-3 0L-6 -6z" />}
      </g>
    );
  }
  return kind === "object" ? (
    <path class="object" d="M0 -7L7 0L0 7L-7 0z" />
  ) : (
    <rect class="holder" x="-6" y="-6" width="12" height="12" rx="2" />
  );
}

/** How pale a thing is that was seen so long ago [s]. */
export function fade(age: number | null): number {
  return FADES.find(([limit]) => age !== null && age < limit)?.[1] ?? FAINTEST;
}

/** Things that move and have no place: nobody may think that they are gone. */
export function placeless(): Seen[] {
  const all = shown.value;
  const placed = new Set(all.filter((one) => one.position).map((one) => one.thing));
  return all.filter(
    (one) => MOVES.includes(kindOf(one)) && !one.position && one.inside && !placed.has(one.inside),
  );
}
