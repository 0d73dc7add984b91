// Generated from web/*_messages.py by `python scripts/console_types.py`. Do not edit.

export interface Hello {
  type: "hello";
  tab: string;
  name?: string;
}

export interface PingRequest {
  type: "ping";
  sent: number;
}

export interface StopRequest {
  type: "stop";
  id?: number;
}

export type OrderKind =
  | "take_off"
  | "land"
  | "hover"
  | "go"
  | "service"
  | "home"
  | "stop"
  | "resume"
  | "cut"
  | "reset"
  | "nudge";

export interface OrderRequest {
  type: "order";
  id: number;
  order: OrderKind;
  place?: string;
  goal?: [number, number] | null;
  look_s?: number;
}

export interface NudgeRequest {
  type: "nudge";
  id: number;
  velocity: [number, number, number];
  sent: number;
}

export interface PlanQuestion {
  type: "plan";
  id: number;
  place?: string;
  goal?: [number, number] | null;
}

export interface LeaseRequest {
  type: "lease";
  id: number;
  action: "take" | "release" | "give";
  to?: number;
  held?: boolean;
}

export interface InviteRequest {
  type: "invite";
  id: number;
  role?: "watch" | "ask" | "fly";
}

export type Role = "watch" | "ask" | "fly" | "admin";

export type Severity = "info" | "warning" | "fault";

/** Words of the server: of ours the template and its values, of another version a text. */
export type Said = string | SaidWords;

export interface SaidWords extends Array<Said | { n: string }> {
  0: string;
}

export interface EventView {
  number: number;
  at: number;
  severity: Severity;
  code: string;
  text: Said;
}

export interface Welcome {
  you: number;
  role: Role;
  now: number;
  events: EventView[];
  trail: [number, number][];
  simulated: boolean;
  type: "welcome";
}

export interface GridView {
  origin: [number, number];
  resolution: number;
  width: number;
  height: number;
  rows: string[];
}

export interface OutlineView {
  thing: string;
  corners: [number, number][];
  top: number;
  colour: string;
  tracked: boolean;
}

export interface PlaceView {
  name: string;
  title: string;
  viewpoint: [number, number];
  look_at: [number, number, number];
}

export interface RoomView {
  site: string;
  mode: string;
  bounds: [number, number, number, number];
  grid: GridView;
  outlines: OutlineView[];
  places: PlaceView[];
  home: [number, number];
  flight_height: number;
  visitor: [number, number] | null;
  limits: Record<string, number>;
}

export interface RoomMessage {
  room: RoomView;
  type: "room";
}

export interface PreflightCheck {
  code: string;
  title: Said;
  fault: Said;
  passed: boolean;
  required: boolean;
  value: Said;
  limit: Said;
  why: Said;
  mend: Said;
}

export interface PreflightView {
  ready: boolean;
  checks: PreflightCheck[];
}

export interface PreflightMessage {
  preflight: PreflightView;
  type: "preflight";
}

export type DroneStatus = "unknown" | "landed" | "taking off" | "flying" | "landing" | "emergency";

export type Behavior = "hover" | "altitudeControl" | "yawControl" | "pathTracking";

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

export type Clearing =
  | "by itself"
  | "once it stands"
  | "a fresh order on the ground"
  | "Resume"
  | "a reset";

export type Action =
  | "idle"
  | "take off"
  | "fly"
  | "hover"
  | "land"
  | "cut motors"
  | "reset emergency";

export interface OtherBody {
  name: string;
  position: [number, number];
  size: [number, number];
  yaw: number;
}

export interface StateMessage {
  sequence: number;
  heard_at: number;
  status: DroneStatus | null;
  battery: number | null;
  battery_return: number;
  flight_s: number | null;
  telemetry_age: number | null;
  faults: string[];
  notes: string[];
  height: number | null;
  position: [number, number, number] | null;
  velocity: [number, number, number] | null;
  yaw: number | null;
  pose_age: number | null;
  position_std: number | null;
  wanted: [number, number, number] | null;
  behavior: Behavior;
  phase: Phase;
  safety: SafetyMode;
  clears: Clearing;
  action: Action;
  goal_name: string;
  reason: Said;
  path: number;
  waypoint: number;
  others: OtherBody[];
  stopping_distance: number | null;
  height_std: number | null;
  type: "state";
}

export interface PathMessage {
  number: number;
  waypoints: [number, number][];
  length: number;
  heights: number[];
  times: number[];
  speeds: number[];
  type: "path";
}

export interface LinkStatus {
  at: number;
  tracking_connected: boolean;
  drone_connected: boolean;
  video_connected: boolean;
  tracking_rate_hz: number;
  telemetry_rate_hz: number;
  video_rate_hz: number;
  loop_p50_s: number;
  loop_p99_s: number;
  loop_max_s: number;
  missed_ticks: number;
  notes: Said[];
  tracking_latency_s: number;
  command_delay_s: number;
  command_delay_std_s: number;
  nis: number;
  height_nis: number;
  push: number;
  load: number;
  height_std: number;
}

export interface LinkMessage {
  heard_at: number;
  link: LinkStatus;
  type: "link";
}

export type HeadlineShape = "ready" | "moving" | "holding" | "stopped" | "warning" | "lost";

export type Standing =
  | "on the pad"
  | "off the pad"
  | "on the ground, nobody sees where"
  | "in the air"
  | "unknown";

export interface FlightObjection {
  code: string;
  words: Said;
  mend: Said;
}

export interface OrderObjection {
  order: OrderKind;
  words: Said;
}

export type StopProgress = "none" | "sent" | "confirmed" | "failed";

export interface StopView {
  progress: StopProgress;
  by: string;
  words: Said;
}

export interface ConsoleVerdict {
  at: number;
  shape: HeadlineShape;
  headline: Said;
  detail: Said;
  banner: Said;
  standing: Standing;
  place: Said;
  pad_distance: number | null;
  airborne: boolean | null;
  may_be_airborne: boolean;
  is_cut: boolean;
  pose_is_old: boolean;
  may_take_off: boolean;
  reasons: FlightObjection[];
  known: Said[];
  orders: OrderObjection[];
  next_order: OrderKind | null;
  if_contact_lost: Said;
  stop: StopView;
  pilot: number | null;
  control: string;
  has_drone: boolean;
  is_showing: boolean;
  type: "verdict";
}

export interface EventsMessage {
  events: EventView[];
  type: "events";
}

export interface ViewerView {
  id: number;
  name: string;
}

export interface ViewersMessage {
  pilot: number | null;
  viewers: ViewerView[];
  type: "viewers";
}

export type HouseMode = "home" | "away" | "night" | "privacy" | "maintenance";

export type TaskStage =
  | "waiting for a yes"
  | "queued"
  | "running"
  | "paused"
  | "suspended"
  | "done"
  | "failed"
  | "cancelled"
  | "refused"
  | "expired";

export type ReasonCode =
  | "ok"
  | "unknown_service"
  | "bad_parameter"
  | "unknown_place"
  | "unknown_thing"
  | "unknown_task"
  | "not_understood"
  | "no_way"
  | "no_view"
  | "battery"
  | "too_long"
  | "preflight"
  | "mode"
  | "quiet_hours"
  | "cooldown"
  | "rate_limit"
  | "queue_full"
  | "not_allowed"
  | "declined"
  | "no_answer"
  | "deadline"
  | "cancelled"
  | "person_took_over"
  | "step_failed"
  | "timeout"
  | "safety"
  | "restarted"
  | "not_ready"
  | "no_drone"
  | "no_camera"
  | "condition"
  | "preempted";

export type RequestSurface =
  | "console"
  | "command line"
  | "http"
  | "mqtt"
  | "ros 2"
  | "webhook"
  | "assistant"
  | "rule";

export type Priority = "alarm" | "person" | "rule" | "background";

export type TaskStepState = "waiting" | "running" | "done" | "failed" | "skipped";

export interface TaskStepStatus {
  name: string;
  words: string;
  state: TaskStepState;
}

export interface PersonQuestion {
  id: string;
  words: Said;
  choices: string[];
  until: number | null;
  otherwise: string;
}

export interface RehearsalReport {
  may_fly: boolean;
  code: ReasonCode;
  words: Said;
  way: [number, number][];
  duration: number | null;
  charge: number | null;
  clearance: number | null;
  first_look: number | null;
  took: number;
  shortest: number | null;
}

export interface TaskLook {
  words: Said;
  until: number | null;
}

export interface TaskStatus {
  id: number;
  service: string;
  title: string;
  parameters: Record<string, string | number | boolean>;
  state: TaskStage;
  code: ReasonCode;
  words: Said;
  asked_by: string;
  surface: RequestSurface;
  cause: string;
  priority: Priority;
  asked_at: number;
  started_at: number | null;
  ended_at: number | null;
  deadline: number | null;
  steps: TaskStepStatus[];
  question: PersonQuestion | null;
  rehearsal: RehearsalReport | null;
  clips: string[];
  report: string[];
  took_off_at: number | null;
  flown: number | null;
  recording: string;
  drone: string;
  look: TaskLook | null;
}

export interface TaskBoard {
  at: number;
  mode: HouseMode;
  drone: Said;
  records: boolean;
  tasks: TaskStatus[];
  ended: TaskStatus[];
  notices: string[];
}

export interface TasksMessage {
  running: boolean;
  heard_at: number;
  board: TaskBoard | null;
  type: "tasks";
}

export interface Path {
  waypoints: [number, number][];
  length: number;
  clearance: number;
}

export interface PlanAnswer {
  start: [number, number];
  goal: [number, number];
  path: Path | null;
  reason: Said;
  suggestion: [number, number] | null;
  duration: number;
}

export interface PlanReply {
  id: number;
  answer: PlanAnswer;
  type: "plan";
}

export interface AcceptedReply {
  id: number;
  type: "accepted";
}

export interface RefusedReply {
  id: number;
  reason: Said;
  type: "refused";
}

export interface OrderRefused {
  order: OrderKind;
  reason: Said;
  type: "order_refused";
}

export interface PongReply {
  sent: number;
  now: number;
  type: "pong";
}

export interface QrView {
  size: number;
  path: string;
}

export interface InviteReply {
  id: number;
  name: string;
  origin: string;
  path: string;
  until: number;
  qr: QrView | null;
  type: "invite";
}

export interface InvitationUsed {
  name: string;
  type: "invitation_used";
}

export type ClientMessage =
  | Hello
  | PingRequest
  | StopRequest
  | OrderRequest
  | NudgeRequest
  | PlanQuestion
  | LeaseRequest
  | InviteRequest;

export type ServerMessage =
  | Welcome
  | RoomMessage
  | PreflightMessage
  | StateMessage
  | PathMessage
  | LinkMessage
  | ConsoleVerdict
  | EventsMessage
  | ViewersMessage
  | TasksMessage
  | PlanReply
  | AcceptedReply
  | RefusedReply
  | OrderRefused
  | PongReply
  | InviteReply
  | InvitationUsed;
