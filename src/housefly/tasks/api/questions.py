"""Questions and orders to the tasks, one frozen value each; ``tasks.api.answers`` has the answers.

The same values cross the bus as JSON (``TASKS_QUERY``) and are the bodies of the HTTP API. Who asks
stands in ``by``, a name to show, and in ``owner``, an id: the edge that knows the person fills both
in, never the person.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Annotated, Literal

from pydantic import Field

from housefly.config.house_mode import HouseMode
from housefly.evidence.clip_values import ClipsQuestion, DeleteClip, KeepClip
from housefly.tasks.api.values import Confirm, Priority, RequestSurface

_Word = Annotated[str, Field(max_length=200, pattern=r"^[^\x00-\x1f\x7f]*$")]
_Name = Annotated[str, Field(min_length=1, max_length=80, pattern=r"^[^\x00-\x1f\x7f]*$")]
_Sentence = Annotated[str, Field(min_length=1, max_length=500, pattern=r"^[^\x00-\x1f\x7f]*$")]
_Time = Annotated[float, Field(ge=0.0, le=4102444800.0, allow_inf_nan=False)]
"""Unix time up to the year 2100 [s]."""
_Id = Annotated[int, Field(ge=1, le=2**53)]
_Limit = Annotated[int, Field(ge=1, le=1000)]
_Value = Annotated[float, Field(allow_inf_nan=False)] | bool | str
_Parameters = Annotated[dict[_Name, _Value], Field(max_length=20)]


@dataclass(frozen=True, slots=True)
class RequestTask:
    """Ask for a service; with ``confirm`` ASK it waits until a person says yes."""

    service: _Name
    parameters: _Parameters = field(default_factory=dict)
    by: _Word = ""
    surface: RequestSurface = RequestSurface.CONSOLE
    cause: _Word = ""
    confirm: Confirm = Confirm.AUTO
    priority: Priority = Priority.PERSON
    deadline: _Time | None = None
    ask: Literal["request"] = "request"
    owner: _Word = ""
    drone: _Word = ""


@dataclass(frozen=True, slots=True)
class RehearseTask:
    """Rehearse a service in lock step; nothing flies."""

    service: _Name
    parameters: _Parameters = field(default_factory=dict)
    ask: Literal["rehearse"] = "rehearse"
    surface: RequestSurface = RequestSurface.CONSOLE
    drone: _Word = ""


@dataclass(frozen=True, slots=True)
class ReplyToTask:
    """Answer a question of a task: its confirmation (id "confirm") or one that it asks."""

    task: _Id
    question: _Name
    choice: _Name
    by: _Word = ""
    ask: Literal["reply"] = "reply"


@dataclass(frozen=True, slots=True)
class CancelTask:
    """End a task: one that flies comes home or lands, as it says; 0 ends every open one.

    With ``only_of``, the id of who asks, only what they asked for themselves.
    """

    task: Annotated[int, Field(ge=0, le=2**53)] = 0
    by: _Word = ""
    ask: Literal["cancel"] = "cancel"
    only_of: _Word = ""


@dataclass(frozen=True, slots=True)
class PauseTask:
    """Hover where the drone is until the task is continued."""

    task: _Id
    by: _Word = ""
    ask: Literal["pause"] = "pause"


@dataclass(frozen=True, slots=True)
class ContinueTask:
    """Go on with a paused task."""

    task: _Id
    by: _Word = ""
    ask: Literal["continue"] = "continue"


@dataclass(frozen=True, slots=True)
class BoardQuestion:
    """What flies, what waits, what ended lately, and in which mode the house is."""

    ask: Literal["board"] = "board"


@dataclass(frozen=True, slots=True)
class ServicesQuestion:
    """What can be asked for."""

    ask: Literal["services"] = "services"


@dataclass(frozen=True, slots=True)
class TaskHistoryQuestion:
    """Tasks that were asked for between two times, the newest first.

    ``before`` is the last task of the page before; 0 begins with the newest.
    """

    since: _Time = 0.0
    until: _Time | None = None
    service: _Word = ""
    limit: _Limit = 50
    ask: Literal["history"] = "history"
    before: Annotated[int, Field(ge=0, le=2**53)] = 0


@dataclass(frozen=True, slots=True)
class Sentence:
    """Something a person said or typed; ``fly`` False never starts a task.

    ``may_fly`` False is for whoever may only ask; the edge that knows the person fills it in.
    ``drone`` is for whom it is meant where the words name none; "" for all, or any.
    """

    text: _Sentence
    language: Literal["en", "de", "ja"] = "en"
    by: _Word = ""
    surface: RequestSurface = RequestSurface.CONSOLE
    confirm: Confirm = Confirm.AUTO
    fly: bool = True
    may_fly: bool = True
    ask: Literal["sentence"] = "sentence"
    owner: _Word = ""
    drone: _Word = ""


@dataclass(frozen=True, slots=True)
class SetMode:
    """Set the mode of the house."""

    mode: HouseMode
    by: _Word = ""
    ask: Literal["mode"] = "mode"


@dataclass(frozen=True, slots=True)
class RulesQuestion:
    """Which rules there are and what each did last."""

    ask: Literal["rules"] = "rules"


@dataclass(frozen=True, slots=True)
class ChangeRule:
    """Change a rule, beside its file; None, and what is not named, stays as it is.

    With ``as_written`` it is again as its file says, and nothing else counts.
    """

    rule: _Name
    enabled: bool | None = None
    confirm: Confirm | None = None
    mode: Annotated[tuple[HouseMode, ...], Field(max_length=5)] | None = None
    parameters: _Parameters = field(default_factory=dict)
    as_written: bool = False
    by: _Word = ""
    ask: Literal["change_rule"] = "change_rule"


@dataclass(frozen=True, slots=True)
class DryRunQuestion:
    """What the rules would have done between two times of the past.

    With ``off`` also those that are off, as if they had been on.
    """

    since: _Time
    until: _Time | None = None
    off: bool = False
    ask: Literal["dry_run"] = "dry_run"


@dataclass(frozen=True, slots=True)
class Webhook:
    """A trigger from outside: its name, for rules that wait for it."""

    name: _Name
    by: _Word = ""
    ask: Literal["webhook"] = "webhook"


@dataclass(frozen=True, slots=True)
class TakePhoto:
    """Keep the picture that a person sees, in flight; ``at`` is when it came [s], 0 the newest."""

    at: Annotated[float, Field(ge=0.0, le=1e12, allow_inf_nan=False)] = 0.0
    by: _Word = ""
    ask: Literal["photo"] = "photo"
    drone: _Word = ""


TaskQuestion = (
    RequestTask
    | RehearseTask
    | ReplyToTask
    | CancelTask
    | PauseTask
    | ContinueTask
    | BoardQuestion
    | ServicesQuestion
    | TaskHistoryQuestion
    | Sentence
    | SetMode
    | RulesQuestion
    | ChangeRule
    | DryRunQuestion
    | ClipsQuestion
    | Webhook
    | KeepClip
    | DeleteClip
    | TakePhoto
)
