// Generated from housefly/hub/api/answers.py by `python scripts/console_types.py`. Do not edit.

export interface SourceAnswer {
  source: string;
  age: number;
  position: [number, number, number] | null;
  inside: string;
  valid: boolean;
  facts: Record<string, string | number | boolean>;
}

export interface AlternativePlace {
  words: string;
  thing: string;
  position: [number, number, number] | null;
  confidence: number;
}

export interface WhereAnswer {
  thing: string;
  name: string;
  kind: string;
  words: string;
  position: [number, number, number] | null;
  yaw: number | null;
  std: number | null;
  inside: string[];
  by_container: string;
  seen_at: number | null;
  age: number | null;
  sources: string[];
  said: SourceAnswer[];
  confidence: number;
  alternatives: AlternativePlace[];
}

export interface ViewpointAnswer {
  name: string;
  position: [number, number, number];
  yaw: number;
  robot: string;
}

export interface ThingAnswer {
  thing: string;
  name: string;
  kind: string;
  aliases: string[];
  position: [number, number, number] | null;
  inside: string;
  viewpoints: ViewpointAnswer[];
}

export interface ThingsAnswer {
  things: ThingAnswer[];
}

export interface PlacedThing {
  thing: string;
  name: string;
  kind: string;
  position: [number, number, number] | null;
  yaw: number | null;
  inside: string;
  age: number | null;
  distance: number | null;
}

export interface PlacedAnswer {
  things: PlacedThing[];
}

export interface TrajectoryAnswer {
  thing: string;
  rows: [number, number, number, number][];
}

/** Words of the server: of ours the template and its values, of another version a text. */
export type Said = string | SaidWords;

export interface SaidWords extends Array<Said | { n: string }> {
  0: string;
}

export interface EventAnswer {
  kind: string;
  thing: string;
  at: number;
  source: string;
  cause: string;
  confidence: number;
  facts: Record<string, string | number | boolean>;
  words: Said;
}

export interface EventsAnswer {
  events: EventAnswer[];
}

export interface FeedEntry {
  of: "people" | "things" | "drone" | "tasks";
  thing: string;
  name: Said;
  words: Said;
  began_at: number;
  at: number;
  pictures: string[];
  alarms: boolean;
}

export interface FeedAnswer {
  entries: FeedEntry[];
}

export interface SensorAnswer {
  sensor: string;
  kind: string;
  title: string;
  connected: boolean;
  rate_hz: number;
  age: number | null;
  problem: Said;
  counts: Record<string, number>;
}

export interface SensorsAnswer {
  sensors: SensorAnswer[];
  memory: string;
}

export interface SituationAnswer {
  kind: string;
  thing: string;
  since: number;
  confidence: number;
  evidence: string;
  facts: Record<string, string | number | boolean>;
  sources: string[];
  words: Said;
}

export interface ObstacleAnswer {
  obstacle: string;
  x: number;
  y: number;
  radius: number;
  vx: number;
  vy: number;
  confidence: number;
  age: number;
  source: string;
  length: number;
  width: number;
  yaw: number;
}

export interface PictureAnswer {
  at: number;
  things: PlacedThing[];
  situations: SituationAnswer[];
  obstacles: ObstacleAnswer[];
}

export interface StateAnswer {
  thing: string;
  name: string;
  state: string;
  answer: "yes" | "no" | "unknown";
  words: string;
  confidence: number;
  age: number | null;
  since: number | null;
  sources: string[];
}

export interface PersonAnswer {
  person: string;
  name: string;
  words: string;
  present: "yes" | "no" | "unknown";
  posture: string;
  activity: string;
  fallen: number;
  carries: string[];
  since: number | null;
  confidence: number;
  position: [number, number, number] | null;
  age: number | null;
  evidence: string;
  sources: string[];
}

export interface PeopleAnswer {
  at: number;
  people: PersonAnswer[];
}

export interface TimeUp {
  left: number;
  back: number | null;
}

export interface NightAnswer {
  thing: string;
  begin: number;
  end: number;
  times_up: TimeUp[];
  rose: number | null;
  in_bed: number;
  unknown: number;
  words: string;
}

export interface NightsAnswer {
  nights: NightAnswer[];
}

export interface CameraCone {
  name: string;
  position: [number, number, number];
  corners: [number, number, number][];
  reach: number;
}

export interface CoverageView {
  height: number;
  cameras: number;
  enough: number;
  origin: [number, number];
  resolution: number;
  rows: string[];
  lenses: CameraCone[];
}

export interface PlaceView {
  name: string;
  title: string;
  viewpoint: [number, number];
  look_at: [number, number, number];
}

export interface ZoneView {
  rectangle: [number, number, number, number];
  reason: string;
}

export interface EditsView {
  version: number;
  own: PlaceView[];
  places: PlaceView[];
  zones: ZoneView[];
  undoable: boolean;
  saved_at: number;
  by: string;
  words: string;
  in_use: boolean;
  use_time: number;
}

export interface BellView {
  simulated: boolean;
  rung: boolean;
  words: string;
}

export interface SimulatedFault {
  row: string;
  words: Said;
}

export interface SimulationView {
  simulated: boolean;
  done: boolean;
  words: Said;
  faults: SimulatedFault[];
  failing: number;
}

export type Severity = "info" | "warning" | "fault";

export interface FlightView {
  id: string;
  started_at: number;
  duration: number;
  goal: string;
  worst: Severity;
  complete: boolean;
}

export interface FlightsView {
  now: number;
  flights: FlightView[];
}

export type Phase =
  | "idle"
  | "taking off"
  | "flying to goal"
  | "looking"
  | "holding"
  | "returning"
  | "landing";

export type SafetyMode =
  | "nominal"
  | "warn"
  | "slow"
  | "hold"
  | "return"
  | "stopped"
  | "land"
  | "descend"
  | "cut";

export interface LoggedStage {
  t: number;
  phase: Phase;
  safety: SafetyMode;
  goal: string;
}

export interface FlightPath {
  t: number;
  waypoints: [number, number][];
  heights: number[];
  times: number[];
  speeds: number[];
}

export interface FlightNote {
  t: number;
  severity: Severity;
  code: string;
  text: Said;
}

export interface FlightReplay {
  flight: FlightView;
  t: number[];
  x: (number | null)[];
  y: (number | null)[];
  z: (number | null)[];
  yaw: number[];
  speed: number[];
  battery: number[];
  stages: LoggedStage[];
  paths: FlightPath[];
  notes: FlightNote[];
}

export interface DroneView {
  name: string;
  headline: Said;
  may_be_airborne: boolean;
  stopped: boolean;
  battery: number | null;
  control: string;
}

export interface DronesView {
  drones: DroneView[];
}

export interface News {
  at: number;
  things: PlacedThing[];
  events: EventAnswer[];
  situations: SituationAnswer[];
  obstacles: ObstacleAnswer[];
}

export type RoomAnswer =
  | WhereAnswer
  | ThingsAnswer
  | PlacedAnswer
  | TrajectoryAnswer
  | EventsAnswer
  | FeedAnswer
  | SensorsAnswer
  | PictureAnswer
  | StateAnswer
  | PeopleAnswer
  | NightsAnswer
  | CoverageView
  | EditsView
  | BellView
  | SimulationView
  | FlightsView
  | FlightReplay
  | DronesView;

export type RoomNews = News;
