"""What can set off a rule, as values; ``tasks.rules.rule`` has the patterns that they fit."""

from __future__ import annotations

import json
from dataclasses import dataclass
from math import isfinite

import aiomqtt

from housefly.config.json_path import JsonPath
from housefly.hub.api.told_events import TOLD_EVENT_SOURCE
from housefly.hub.situations.situation import SOURCE_PREFIX
from housefly.messages import RoomEvent
from housefly.tasks.api.values import ParameterValue
from housefly.tasks.rules.rule import (
    EventPattern,
    MqttPattern,
    Pattern,
    SituationPattern,
    TimePattern,
    WebhookPattern,
)
from housefly.wires.devices.fields import plain_number

_TRUTHS = {"true": True, "on": True, "yes": True, "false": False, "off": False, "no": False}
_OWN_SOURCES = frozenset({TOLD_EVENT_SOURCE, "pilot"})
"""Whoever flies because of a rule tells events; they set off no rule, unless it asks for them."""
MAX_MQTT_PAYLOAD = 4096
"""A longer message sets off nothing [bytes]."""
_LONGEST = 200
"""Longest text that a parameter takes from a trigger [characters]."""


@dataclass(frozen=True, slots=True)
class EventTrigger:
    """An event of the room."""

    event: RoomEvent

    @property
    def at(self) -> float:
        """When [Unix time, s]."""
        return self.event.at

    @property
    def id(self) -> str:
        """Tell it from all others."""
        event = self.event
        return f"{event.kind}/{event.thing}/{event.source}/{event.at:.3f}"


@dataclass(frozen=True, slots=True)
class MqttTrigger:
    """A message on a topic; a retained one is older than the subscription: nobody knows how old."""

    topic: str
    payload: bytes
    at: float
    retained: bool = False

    @property
    def id(self) -> str:
        """Tell it from all others."""
        return f"{self.topic}/{self.at:.3f}"


@dataclass(frozen=True, slots=True)
class WebhookTrigger:
    """A call of a webhook, by somebody who has its key."""

    name: str
    at: float
    by: str = ""

    @property
    def id(self) -> str:
        """Tell it from all others."""
        return f"webhook {self.name}/{self.at:.3f}"


@dataclass(frozen=True, slots=True)
class TimeTrigger:
    """A time that one rule waits for."""

    rule: str
    at: float

    @property
    def id(self) -> str:
        """Tell it from all others."""
        return f"time/{self.at:.0f}"


Trigger = EventTrigger | MqttTrigger | WebhookTrigger | TimeTrigger


def is_own(trigger: Trigger) -> bool:
    """Return whether a flight or a task of ours has brought it about."""
    return isinstance(trigger, EventTrigger) and trigger.event.source in _OWN_SOURCES


def fits(pattern: Pattern, trigger: Trigger, rule: str) -> bool:
    """Return whether a trigger is what a rule waits for."""
    match pattern, trigger:
        case EventPattern(), EventTrigger(event):
            facts = dict(event.facts)
            return (
                event.kind == pattern.event
                and pattern.thing in ("", event.thing)
                and (pattern.of_tasks or not is_own(trigger))
                and all(_same(facts.get(key), value) for key, value in pattern.facts.items())
            )
        case SituationPattern(), EventTrigger(event):
            ending = " ended" if pattern.edge == "ends" else ""
            return (
                event.kind == f"{pattern.situation}{ending}"
                and event.source.startswith(SOURCE_PREFIX)
                and pattern.thing in ("", event.thing)
            )
        case MqttPattern(), MqttTrigger():
            return not trigger.retained and _message_fits(pattern, trigger)
        case WebhookPattern(), WebhookTrigger():
            return pattern.webhook == trigger.name
        case TimePattern(), TimeTrigger():
            return trigger.rule == rule
    return False


def value_of(trigger: Trigger, field: str, pattern: Pattern) -> ParameterValue | None:
    """Return what a parameter takes from a trigger, None if it has no such thing."""
    match trigger:
        case EventTrigger(event):
            found = (
                getattr(event, field)
                if field in ("kind", "thing", "source", "cause", "confidence", "at")
                else dict(event.facts).get(field)
            )
            return _checked(found)
        case MqttTrigger():
            is_topic = field == "topic" or not isinstance(pattern, MqttPattern)
            return _checked(trigger.topic if is_topic else _mqtt_value(pattern, trigger))  # type: ignore[arg-type]
        case WebhookTrigger():
            return _checked(trigger.name)
        case TimeTrigger():
            return None


def _mqtt_value(pattern: MqttPattern, trigger: MqttTrigger) -> ParameterValue | None:
    """Return the value of a message: of its field, or of all of it; None if it has none."""
    if len(trigger.payload) > MAX_MQTT_PAYLOAD:
        return None
    try:
        text = trigger.payload.decode()
        tree = json.loads(text)
    except UnicodeDecodeError:
        return None
    except (ValueError, RecursionError):
        tree = text
    if pattern.field:
        try:
            tree = JsonPath(pattern.field).value_in(tree)
        except LookupError:
            return None
    return _checked(tree)


def _message_fits(pattern: MqttPattern, trigger: MqttTrigger) -> bool:
    if not aiomqtt.Topic(trigger.topic).matches(pattern.mqtt):
        return False
    if pattern.value is None and pattern.above is None and pattern.below is None:
        return not pattern.field or _mqtt_value(pattern, trigger) is not None
    value = _mqtt_value(pattern, trigger)
    if pattern.value is not None and not _same(value, pattern.value):
        return False
    if pattern.above is None and pattern.below is None:
        return True
    number = _number_of(value)
    return (
        number is not None
        and (pattern.above is None or number > pattern.above)
        and (pattern.below is None or number < pattern.below)
    )


def _same(found: ParameterValue | None, wanted: ParameterValue) -> bool:
    """Return whether two values mean the same: true is "true" and "ON", 1 is "1"; true is not 1.

    Upper and lower case are the same.
    """
    if found is None:
        return False
    if isinstance(found, bool) or isinstance(wanted, bool):
        return _truth_of(found) is not None and _truth_of(found) is _truth_of(wanted)
    one, other = _number_of(found), _number_of(wanted)
    if one is not None or other is not None:
        return one == other
    return str(found).strip().lower() == str(wanted).strip().lower()


def _truth_of(value: ParameterValue) -> bool | None:
    """Return a truth value, or what a word says; None for a number."""
    if isinstance(value, bool):
        return value
    return _TRUTHS.get(value.strip().lower()) if isinstance(value, str) else None


def _number_of(value: ParameterValue | None) -> float | None:
    """Return a number, or the one that a text is; None for a truth value."""
    if isinstance(value, bool) or value is None:
        return None
    return plain_number(value) if isinstance(value, str) else value


def _checked(value: object) -> ParameterValue | None:
    """Return a value that a parameter may have: a short printable text, a number, a truth."""
    if isinstance(value, bool):
        return value
    if isinstance(value, int | float):
        try:
            number = float(value)
        except OverflowError:
            return None
        return number if isfinite(number) else None
    if isinstance(value, str) and 0 < len(value) <= _LONGEST and value.isprintable():
        return value
    return None
