"""The paths of the tasks' HTTP API: one question or order each, and how often it may be asked."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

from housefly.evidence.clip_values import ClipsQuestion, DeleteClip, KeepClip
from housefly.tasks.api.questions import (
    BoardQuestion,
    CancelTask,
    ChangeRule,
    ContinueTask,
    DryRunQuestion,
    PauseTask,
    RehearseTask,
    ReplyToTask,
    RequestTask,
    RulesQuestion,
    Sentence,
    ServicesQuestion,
    SetMode,
    TakePhoto,
    TaskHistoryQuestion,
    TaskQuestion,
    Webhook,
)

FILLED_IN = ("by", "surface", "cause", "may_fly", "owner", "only_of")
"""What a browser never says itself: the server knows who asks."""
SAID_BY_PROGRAMS = ("by", "surface", "cause")
"""What a program with the key of the run says of itself."""
SILENT_SERVICES = "the services do not answer"
"""So begins the refusal where no tasks run."""


class Pace(Enum):
    """How often somebody may ask.

    FREE is not counted: reading, and what makes the drone safer. COSTLY is computed for seconds.
    """

    FREE = "free"
    COUNTED = "counted"
    COSTLY = "costly"


@dataclass(frozen=True, slots=True)
class TaskEndpoint:
    """One path of the API.

    Attributes:
        method: GET reads, with parameters in the query; POST changes, with a JSON body.
        path: below the prefix, with its parameter in braces.
        question: its fields are the parameters; the server fills in who asks.
        summary: one line.
        pace: how often somebody may ask.
    """

    method: str
    path: str
    question: type[TaskQuestion]
    summary: str
    pace: Pace = Pace.FREE


TASK_ENDPOINTS = (
    TaskEndpoint("GET", "/tasks", BoardQuestion, "What flies, what waits, what ended lately"),
    TaskEndpoint("POST", "/tasks", RequestTask, "Ask for a service", Pace.COUNTED),
    TaskEndpoint("GET", "/tasks/history", TaskHistoryQuestion, "Tasks of a time, newest first"),
    TaskEndpoint(
        "POST", "/tasks/rehearse", RehearseTask, "Rehearse a service; nothing flies", Pace.COSTLY
    ),
    TaskEndpoint(
        "POST", "/tasks/{task}/reply", ReplyToTask, "Answer a question of a task", Pace.COUNTED
    ),
    TaskEndpoint("POST", "/tasks/{task}/cancel", CancelTask, "End a task; 0 ends every open one"),
    TaskEndpoint("POST", "/tasks/{task}/pause", PauseTask, "Hover until it is continued"),
    TaskEndpoint(
        "POST", "/tasks/{task}/continue", ContinueTask, "Go on with a paused task", Pace.COUNTED
    ),
    TaskEndpoint("GET", "/services", ServicesQuestion, "What can be asked for"),
    TaskEndpoint("POST", "/sentence", Sentence, "Something that a person says", Pace.COUNTED),
    TaskEndpoint("POST", "/mode", SetMode, "Set the mode of the house", Pace.COUNTED),
    TaskEndpoint("GET", "/rules", RulesQuestion, "Which rules there are, what each did last"),
    TaskEndpoint(
        "GET", "/rules/dry-run", DryRunQuestion, "What the rules would have done", Pace.COSTLY
    ),
    TaskEndpoint(
        "POST", "/rules/{rule}/change", ChangeRule, "Change a rule beside its file", Pace.COUNTED
    ),
    TaskEndpoint("GET", "/clips", ClipsQuestion, "Which clips and snapshots there are"),
    TaskEndpoint("POST", "/clips/{clip}/keep", KeepClip, "Keep a clip, or no longer", Pace.COUNTED),
    TaskEndpoint("POST", "/clips/{clip}/delete", DeleteClip, "Delete a clip", Pace.COUNTED),
    TaskEndpoint("POST", "/photo", TakePhoto, "Keep the picture that is shown", Pace.COUNTED),
    TaskEndpoint("POST", "/webhook/{name}", Webhook, "A trigger from outside", Pace.COUNTED),
)
