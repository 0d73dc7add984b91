// Generated from housefly/hub/api/answers.py by `python -m housefly.web.typescript`. Do not edit.

export interface SourceAnswer {
  source: string;
  age: number;
  position: [number, number, number] | null;
  inside: string;
  valid: boolean;
  facts: Record<string, string | number | boolean>;
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

export interface EventAnswer {
  kind: string;
  thing: string;
  at: number;
  source: string;
  cause: string;
  confidence: number;
  facts: Record<string, string | number | boolean>;
}

export interface EventsAnswer {
  events: EventAnswer[];
}

export interface SensorAnswer {
  sensor: string;
  kind: string;
  title: string;
  connected: boolean;
  rate_hz: number;
  age: number | null;
  problem: string;
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

export interface CoverageView {
  height: number;
  cameras: number;
  enough: number;
  origin: [number, number];
  resolution: number;
  rows: string[];
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
  | SensorsAnswer
  | PictureAnswer
  | CoverageView
  | EditsView;

export type RoomNews = News;
