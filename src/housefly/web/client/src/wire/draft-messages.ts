// Generated from housefly/web/new_site by `python scripts/console_types.py`. Do not edit.

export interface DraftWall {
  start: [number, number];
  end: [number, number];
  thickness: number;
  bottom: number;
  top: number | null;
}

export interface DraftBox {
  name: string;
  x: number;
  y: number;
  length: number;
  width: number;
  top: number;
  bottom: number;
  yaw: number;
  thing: string;
}

export interface DraftPlace {
  name: string;
  x: number;
  y: number;
  title: string;
  look_at: [number, number, number] | null;
}

export interface DraftZone {
  rectangle: [number, number, number, number];
  reason: string;
}

export interface DraftTracking {
  kind: "vicon" | "natnet" | "vrpn" | "bridge";
  address: string;
  port: number | null;
  body: string;
  bridge_system: string;
  vrpn_transport: "tcp" | "udp";
  up_axis: "auto" | "y" | "z";
}

export interface FramePoint {
  name: string;
  on_map: [number, number, number];
  seen: [number, number, number];
}

export interface DraftDrone {
  address: string;
  profile: string;
  model: string;
}

export interface SiteDraft {
  name: string;
  bounds: [number, number, number, number] | null;
  height: number;
  walls: DraftWall[];
  furniture: DraftBox[];
  scanned: DraftBox[];
  pad: [number, number] | null;
  pad_yaw: number;
  places: DraftPlace[];
  zones: DraftZone[];
  tracking: DraftTracking | null;
  frame_points: FramePoint[];
  drone: DraftDrone | null;
  hardware: boolean;
  flight_height: number;
  source: string;
  answered: string;
}

export interface GridView {
  origin: [number, number];
  resolution: number;
  width: number;
  height: number;
  rows: string[];
}

/** Words of the server: of ours the template and its values, of another version a text. */
export type Said = string | SaidWords;

export interface SaidWords extends Array<Said | { n: string }> {
  0: string;
}

export interface MissingView {
  step: string;
  words: Said;
  mend: Said;
  hinders: boolean;
}

export interface FitView {
  words: Said[];
  trusted: boolean;
}

export interface ModelView {
  model: string;
  name: string;
  address: string;
}

export interface DraftView {
  version: string;
  folder: string;
  draft: SiteDraft;
  scanned: number;
  scan: GridView | null;
  grid: GridView | null;
  missing: MissingView[];
  fit: FitView | null;
  models: ModelView[];
  settled: boolean;
  undoable: boolean;
  redoable: boolean;
  words: Said;
  notes: Said[];
}

export interface BodyView {
  name: string;
  position: [number, number, number];
}

export interface HeardView {
  words: Said[];
  bodies: BodyView[];
}

export interface WrittenFile {
  path: string;
  text: string;
}

export interface WrittenView {
  files: WrittenFile[];
}

export type OpenedState = "closed" | "starting" | "ready" | "ended";

export interface OpenedView {
  state: OpenedState;
  line: string;
  address: string;
}

export type DraftAnswer = DraftView | HeardView | WrittenView | OpenedView;
