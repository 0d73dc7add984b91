// Generated from housefly/tasks/api by `python scripts/console_types.py`. Do not edit.

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

/** Words of the server: of ours the template and its values, of another version a text. */
export type Said = string | SaidWords;

export interface SaidWords extends Array<Said | { n: string }> {
  0: string;
}

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

export interface TasksAnswer {
  tasks: TaskStatus[];
}

export type HouseMode = "home" | "away" | "night" | "privacy" | "maintenance";

export interface TaskBoard {
  at: number;
  mode: HouseMode;
  drone: Said;
  records: boolean;
  tasks: TaskStatus[];
  ended: TaskStatus[];
  notices: string[];
}

export interface ParameterInfo {
  name: string;
  type: string;
  about: string;
  unit: string;
  default: string | number | boolean | null;
  required: boolean;
}

export interface ServiceInfo {
  name: string;
  title: string;
  about: string;
  parameters: ParameterInfo[];
  flies: boolean;
  problem: string;
}

export interface ServicesAnswer {
  services: ServiceInfo[];
}

export interface RehearsalAnswer {
  rehearsal: RehearsalReport;
}

export type Confirm = "auto" | "ask" | "never";

export interface TaskRequest {
  service: string;
  parameters: Record<string, string | number | boolean>;
  asked_by: string;
  surface: RequestSurface;
  cause: string;
  confirm: Confirm;
  priority: Priority;
  deadline: number | null;
  owner: string;
  drone: string;
  sentence: string;
}

export interface SentenceAnswer {
  understood: boolean;
  intent: string;
  words: Said;
  slots: Record<string, string | number | boolean>;
  task: TaskStatus | null;
  suggestions: string[];
  offer: TaskRequest | null;
  code: ReasonCode;
}

export interface ModeAnswer {
  mode: HouseMode;
  words: string;
}

export interface RuleStatus {
  name: string;
  words: string;
  enabled: boolean;
  last_at: number | null;
  last_words: string;
  last_cause: string;
  when: Said;
  title: string;
  confirm: Confirm;
  modes: HouseMode[];
  parameters: ParameterInfo[];
  is_remembered: boolean;
  changed_by: string;
}

export interface RulesAnswer {
  rules: RuleStatus[];
}

export interface RuleFiring {
  rule: string;
  at: number;
  cause: string;
  service: string;
  code: ReasonCode;
  words: string;
}

export interface FiringsAnswer {
  firings: RuleFiring[];
}

export interface ClipInfo {
  id: string;
  kind: string;
  task: number;
  service: string;
  place: string;
  thing: string;
  people: string[];
  cause: string;
  began_at: number;
  duration: number;
  size: number;
  keep_until: number | null;
  blanked: boolean;
  cut_off: boolean;
  drone: string;
}

export interface ClipsAnswer {
  clips: ClipInfo[];
}

export type TaskAnswer =
  | TasksAnswer
  | TaskBoard
  | ServicesAnswer
  | RehearsalAnswer
  | SentenceAnswer
  | ModeAnswer
  | RulesAnswer
  | FiringsAnswer
  | ClipsAnswer;
