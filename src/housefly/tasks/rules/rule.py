"""A rule: when something happens, and if something holds, ask for a service."""

from __future__ import annotations

import re
from datetime import time
from typing import Annotated, Literal, Self

from pydantic import BeforeValidator, Field, field_validator, model_validator

from housefly.config.json_path import JsonPath
from housefly.config.section import Section
from housefly.config.tasks import ModeName
from housefly.tasks.api.values import ParameterValue

_DURATION = re.compile(r"(\d+(?:\.\d+)?)\s*(s|min|h|d)?")
_UNITS = {"s": 1.0, "min": 60.0, "h": 3600.0, "d": 86400.0, None: 1.0}
_CLOCK = re.compile(r"([01]?\d|2[0-3]):([0-5]\d)")
REFERENCE = re.compile(r"\$(event|mqtt|webhook)\.([A-Za-z0-9_]{1,60})")
"""A parameter that takes its value from the trigger, wholly: no text is ever put together."""
MQTT_FIELDS = ("topic", "value")
_SERVICE = r"^[a-z0-9][a-z0-9_-]{0,79}$"


def _seconds(value: object) -> object:
    """Return "10 min" as 600 [s]; what is no such text is left for the type to judge."""
    match = _DURATION.fullmatch(value.strip()) if isinstance(value, str) else None
    return float(match[1]) * _UNITS[match[2]] if match else value


def _clock(value: object) -> object:
    match = _CLOCK.fullmatch(value.strip()) if isinstance(value, str) else None
    if match is None:
        raise ValueError(f"is {value!r}; allowed: a time of day such as 07:30")
    return time(int(match[1]), int(match[2]))


def _one_or_more(value: object) -> object:
    return value if isinstance(value, list | tuple) else (value,)


Duration = Annotated[
    float, BeforeValidator(_seconds), Field(ge=0.0, le=31 * 86400.0, allow_inf_nan=False)
]
ClockTime = Annotated[time, BeforeValidator(_clock)]
Weekday = Literal["mon", "tue", "wed", "thu", "fri", "sat", "sun"]
WEEKDAYS: tuple[Weekday, ...] = ("mon", "tue", "wed", "thu", "fri", "sat", "sun")
Name = Annotated[str, Field(min_length=1, max_length=200)]
_Words = Annotated[str, Field(max_length=200)]
_Share = Annotated[float, Field(ge=0.0, le=1.0, allow_inf_nan=False)]
_Number = Annotated[float, Field(allow_inf_nan=False)]


class Hours(Section):
    """From a local time of day to another one, over midnight when it is the earlier one."""

    begin: ClockTime = Field(alias="from")
    end: ClockTime = Field(alias="to")

    def hold(self, at: time) -> bool:
        """Return whether a local time of day is within them."""
        if self.begin <= self.end:
            return self.begin <= at < self.end
        return at >= self.begin or at < self.end

    def __str__(self) -> str:
        return f"{self.begin:%H:%M} to {self.end:%H:%M}"


class EventPattern(Section):
    """An event of the room: its kind, and the thing and facts that it must have."""

    kind: Literal["event"] = "event"
    event: Name
    thing: _Words = ""
    facts: dict[Name, ParameterValue] = Field(default_factory=dict, max_length=20)
    of_tasks: bool = False


class SituationPattern(Section):
    """A situation of the room that begins or ends."""

    kind: Literal["situation"] = "situation"
    situation: Name
    thing: _Words = ""
    edge: Literal["begins", "ends"] = "begins"


class MqttPattern(Section):
    """A message on a topic: any, or one whose value, or field of a JSON object, fits."""

    kind: Literal["mqtt"] = "mqtt"
    mqtt: Annotated[str, Field(min_length=1, max_length=200, pattern=r"^[^\x00-\x1f\x7f]*$")]
    field: _Words = ""
    value: ParameterValue | None = None
    above: _Number | None = None
    below: _Number | None = None

    @field_validator("field")
    @classmethod
    def _is_a_path(cls, field: str) -> str:
        return str(JsonPath(field)) if field else ""

    @field_validator("mqtt")
    @classmethod
    def _is_a_filter(cls, topic: str) -> str:
        levels = topic.split("/")
        if any("#" in level or ("+" in level and level != "+") for level in levels[:-1]) or (
            levels[-1] not in ("#", "+") and ("#" in levels[-1] or "+" in levels[-1])
        ):
            raise ValueError(f"is {topic!r}; allowed: + for one level, # for the rest at the end")
        return topic


class WebhookPattern(Section):
    """A call of ``/api/v1/webhook/NAME``."""

    kind: Literal["webhook"] = "webhook"
    webhook: Annotated[str, Field(pattern=r"^[A-Za-z0-9][A-Za-z0-9_-]{0,59}$")]


class TimePattern(Section):
    """A time: each day (or on some weekdays) at a local time of day, or every so often [s]."""

    kind: Literal["time"] = "time"
    at: Annotated[tuple[ClockTime, ...], BeforeValidator(_one_or_more)] = ()
    every: Duration = 0.0
    days: tuple[Weekday, ...] = WEEKDAYS

    @model_validator(mode="after")
    def _is_one_of_two(self) -> Self:
        if bool(self.at) == bool(self.every):
            raise ValueError("needs either at (a time of day) or every (a duration), not both")
        if self.every and self.every < 60.0:
            raise ValueError(f"every is {self.every:g} s; allowed: 60 s or more")
        if not self.days:
            raise ValueError("days names no day")
        return self


Pattern = EventPattern | SituationPattern | MqttPattern | WebhookPattern | TimePattern
_KEYS = {"event": "event", "situation": "situation", "mqtt": "mqtt", "webhook": "webhook"}


def _with_kind(tree: object) -> object:
    """Return what a rule waits for with the kind that its keys say."""
    if not isinstance(tree, dict) or "kind" in tree:
        return tree
    named = [kind for key, kind in _KEYS.items() if key in tree] or (
        ["time"] if "at" in tree or "every" in tree else []
    )
    if len(named) != 1:
        raise ValueError("allowed: exactly one of event, situation, mqtt, webhook, at, every")
    return {"kind": named[0], **tree}


class StateCondition(Section):
    """A state of a thing, as ``housefly is`` knows it; what nobody knows does not hold."""

    thing: Name
    state: Name
    answer: Literal["yes", "no"] = "yes"


class Conditions(Section):
    """What must hold, all of it."""

    mode: Annotated[tuple[ModeName, ...], BeforeValidator(_one_or_more)] = ()
    states: tuple[StateCondition, ...] = Field(default=(), max_length=20, alias="is")
    present: _Words = ""
    absent: _Words = ""
    between: Hours | None = None
    confidence: _Share = 0.0


class ServiceCall(Section):
    """The service that is asked for."""

    service: Annotated[str, Field(pattern=_SERVICE)]
    parameters: dict[Name, ParameterValue] = Field(default_factory=dict, max_length=20)


class Rule(Section):
    """One rule of the house."""

    name: Annotated[str, Field(pattern=_SERVICE)]
    about: _Words = ""
    enabled: bool = True
    when: Annotated[Pattern, BeforeValidator(_with_kind), Field(discriminator="kind")]
    conditions: Conditions = Field(default_factory=lambda: Conditions(), alias="if")
    then: ServiceCall
    confirm: Literal["auto", "ask", "never"] = "ask"
    priority: Literal["alarm", "person", "rule", "background"] = "rule"
    cooldown: Duration = 60.0
    per_hour: int = Field(default=12, ge=1, le=1000)
    per_day: int = Field(default=50, ge=1, le=1000)
    quiet: Hours | None = None
    deadline: Duration = 300.0

    @model_validator(mode="after")
    def _takes_only_what_its_trigger_has(self) -> Self:
        for name, value in self.then.parameters.items():
            if not isinstance(value, str) or not value.startswith("$"):
                continue
            match = REFERENCE.fullmatch(value)
            if match is None or not _has(self.when, match[1], match[2]):
                raise ValueError(
                    f"then.parameters.{name} is {value!r}; allowed: {_allowed(self.when)}"
                )
        if self.conditions.confidence and self.when.kind not in ("event", "situation"):
            raise ValueError("if.confidence needs an event or a situation in when")
        return self

    def words(self) -> str:
        """Return the rule as a sentence."""
        only = self.if_words()
        return f"{self.when_words()}{f', if {only}' if only else ''}: {self._then_words()}"

    def when_words(self) -> str:
        """Return what it waits for."""
        return _when_words(self.when)

    def if_words(self) -> str:
        """Return what must hold, "" for nothing."""
        return _if_words(self.conditions)

    def _then_words(self) -> str:
        given = ", ".join(f"{key} {value}" for key, value in self.then.parameters.items())
        asks = {"auto": "", "ask": " after a yes", "never": ", never by itself"}[self.confirm]
        return f"{self.then.service}{f' ({given})' if given else ''}{asks}"


def _has(pattern: Pattern, source: str, field: str) -> bool:
    match pattern:
        case EventPattern() | SituationPattern():
            return source == "event"
        case MqttPattern():
            return source == "mqtt" and field in MQTT_FIELDS
        case WebhookPattern():
            return source == "webhook" and field == "name"
        case TimePattern():
            return False


def _allowed(pattern: Pattern) -> str:
    return {
        "event": "$event. with kind, thing, source, cause, confidence, at or a fact",
        "situation": "$event. with kind, thing, source, cause, confidence, at or a fact",
        "mqtt": "$mqtt.topic or $mqtt.value",
        "webhook": "$webhook.name",
        "time": "no text that begins with $: a time has nothing to tell",
    }[pattern.kind]


def awaited_words(pattern: EventPattern | SituationPattern | MqttPattern) -> str:
    """Return what must happen: "person fallen (person-1) begins"."""
    match pattern:
        case EventPattern():
            facts = " and ".join(f"{key} {_shown(value)}" for key, value in pattern.facts.items())
            about = ", ".join(part for part in (pattern.thing, facts) if part)
            return f"{pattern.event}{f' ({about})' if about else ''}"
        case SituationPattern():
            what = f"{pattern.situation}{f' ({pattern.thing})' if pattern.thing else ''}"
            return f"{what} {pattern.edge}"
        case MqttPattern():
            return _message_words(pattern)


def _when_words(pattern: Pattern) -> str:
    match pattern:
        case EventPattern() | SituationPattern() | MqttPattern():
            return f"when {awaited_words(pattern)}"
        case WebhookPattern():
            return f"when the webhook {pattern.webhook} is called"
        case TimePattern():
            days = "day" if len(pattern.days) == len(WEEKDAYS) else ", ".join(pattern.days)
            times = ", ".join(f"{at:%H:%M}" for at in pattern.at)
            return f"every {days} at {times}" if times else f"every {pattern.every:g} s"


def _message_words(pattern: MqttPattern) -> str:
    """Return what must come: "ENERGY.Power is above 1000 on the MQTT topic tele/stove/SENSOR"."""
    limits = [
        *([_shown(pattern.value)] if pattern.value is not None else []),
        *([f"above {pattern.above:g}"] if pattern.above is not None else []),
        *([f"below {pattern.below:g}"] if pattern.below is not None else []),
    ]
    if limits:
        what = f"{pattern.field or 'the value'} is {' and '.join(limits)}"
    else:
        what = f"a message with {pattern.field} comes" if pattern.field else "any message comes"
    return f"{what} on the MQTT topic {pattern.mqtt}"


def _shown(value: ParameterValue) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    return f"{value:g}" if isinstance(value, float) else f'"{value}"'


def _if_words(conditions: Conditions) -> str:
    parts = [
        *([f"the house is in mode {' or '.join(conditions.mode)}"] if conditions.mode else []),
        *(f"{item.thing} {item.state}: {item.answer}" for item in conditions.states),
        *([f"{conditions.present} is there"] if conditions.present else []),
        *([f"{conditions.absent} is not there"] if conditions.absent else []),
        *([f"it is {conditions.between}"] if conditions.between else []),
        *([f"{100 * conditions.confidence:.0f} % sure"] if conditions.confidence else []),
    ]
    return " and ".join(parts)
