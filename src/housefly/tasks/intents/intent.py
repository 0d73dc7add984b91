"""The intent document: what a sentence, a button or an assistant means, in one form for all.

An intent is a name and slots. What it may hold stands in ``INTENT_SLOTS``; the JSON schema
(``intent_schema.json``) is generated from here.
"""

from __future__ import annotations

import json
from dataclasses import dataclass, field, fields
from enum import StrEnum
from functools import cache
from pathlib import Path
from typing import Annotated, Any, ClassVar, Literal

from pydantic import ConfigDict, Field, TypeAdapter, ValidationError

from housefly.errors import WireError
from housefly.hub.api.json import first_problem
from housefly.tasks.api.values import ParameterValue

Language = Literal["en", "de", "ja"]
LANGUAGES: tuple[Language, ...] = ("en", "de", "ja")

_Text = Annotated[str, Field(max_length=500, pattern=r"^[^\x00-\x1f\x7f]*$")]
_Name = Annotated[str, Field(min_length=1, max_length=200, pattern=r"^[^\x00-\x1f\x7f]*$")]
_Clock = Annotated[str, Field(pattern=r"^([01]\d|2[0-3]):[0-5]\d$")]
_Minutes = Annotated[float, Field(gt=0.0, le=525600.0, allow_inf_nan=False)]


class IntentName(StrEnum):
    """What can be meant."""

    LOOK = "look"
    LOOK_AROUND = "look_around"
    WHERE = "where"
    IS = "is"
    WHO = "who"
    WHAT_HAPPENED = "what_happened"
    CAME_AT = "came_at"
    CONTENTS = "contents"
    GOT_UP = "got_up"
    NIGHTS = "nights"
    PATROL = "patrol"
    COME = "come"
    FOLLOW = "follow"
    VISITOR = "visitor"
    INVENTORY = "inventory"
    NIGHT_ROUND = "night_round"
    ALL_RIGHT = "all_right"
    SERVICE = "service"
    CALL_ME = "call_me"
    CLIPS = "clips"
    CANCEL = "cancel"
    PAUSE = "pause"
    CONTINUE = "continue"
    STOP = "stop"
    LAND = "land"
    HOME = "home"
    MODE = "mode"
    HELP = "help"


class NameKind(StrEnum):
    """What a name is the name of."""

    PLACE = "place"
    THING = "thing"
    PERSON = "person"


@dataclass(frozen=True, slots=True)
class IntentSlots:
    """The values of an intent; None is not said.

    Attributes:
        subject: name of a place, or id of a thing or person.
        subject_kind: which of them.
        owner: id of the person whose thing it is said to be.
        state: a word of the hub for a state ("on", "in bed"); docs/asking.md.
        empty: it is asked whether something is empty.
        go: the drone shall go and look, whatever the memory says.
        at: local time of day, "HH:MM".
        either_half: ``at`` may as well be twelve hours later or earlier.
        since: from ``at`` on, not at it.
        day: "today", "yesterday", "tomorrow" (only of a reminder) or a day of the week.
        period: a part of a day.
        last_minutes: the time that is meant ends now and is this long [min].
        in_minutes: from now [min].
        event: what is waited for.
        mode: of the house.
        service: name of a task document.
    """

    __pydantic_config__: ClassVar[ConfigDict] = ConfigDict(extra="forbid")
    subject: _Name | None = None
    subject_kind: NameKind | None = None
    owner: _Name | None = None
    state: _Name | None = None
    empty: bool | None = None
    go: bool | None = None
    at: _Clock | None = None
    either_half: bool | None = None
    since: bool | None = None
    day: (
        Literal[
            "today",
            "yesterday",
            "tomorrow",
            "monday",
            "tuesday",
            "wednesday",
            "thursday",
            "friday",
            "saturday",
            "sunday",
        ]
        | None
    ) = None
    period: Literal["morning", "afternoon", "evening", "night"] | None = None
    last_minutes: _Minutes | None = None
    in_minutes: _Minutes | None = None
    event: Literal["bell", "at_door", "gets_up", "falls", "state", "time"] | None = None
    mode: Literal["home", "away", "night", "privacy", "maintenance"] | None = None
    service: _Name | None = None


@dataclass(frozen=True, slots=True)
class Intent:
    """One intent: its name, slots, and the sentence and language that it came from."""

    __pydantic_config__: ClassVar[ConfigDict] = ConfigDict(extra="forbid")
    intent: IntentName
    slots: IntentSlots = field(default_factory=IntentSlots)
    sentence: _Text = ""
    language: Language = "en"

    def given(self) -> dict[str, ParameterValue]:
        """Return the slots that were said."""
        return _given_slots(self.slots)


_SUBJECT = frozenset({"subject", "subject_kind", "owner"})
_WHEN = frozenset({"at", "either_half", "since", "day", "period", "last_minutes"})
_NONE: frozenset[str] = frozenset()


@dataclass(frozen=True, slots=True)
class AllowedSlots:
    """Which slots an intent must have, and which it may have besides."""

    required: frozenset[str] = _NONE
    optional: frozenset[str] = _NONE


_ABOUT = AllowedSlots(frozenset({"subject", "subject_kind"}), frozenset({"owner"}))
INTENT_SLOTS: dict[IntentName, AllowedSlots] = {
    IntentName.LOOK: _ABOUT,
    IntentName.LOOK_AROUND: AllowedSlots(),
    IntentName.WHERE: AllowedSlots(_ABOUT.required, frozenset({"owner", "go"})),
    IntentName.IS: AllowedSlots(_ABOUT.required | {"state"}, frozenset({"owner"})),
    IntentName.WHO: AllowedSlots(_NONE, _SUBJECT | {"event"}),
    IntentName.WHAT_HAPPENED: AllowedSlots(_NONE, _SUBJECT | _WHEN),
    IntentName.CAME_AT: AllowedSlots(_NONE, _WHEN),
    IntentName.CONTENTS: AllowedSlots(_ABOUT.required, frozenset({"owner", "empty"})),
    IntentName.GOT_UP: AllowedSlots(_NONE, _SUBJECT),
    IntentName.NIGHTS: AllowedSlots(_NONE, _SUBJECT | _WHEN),
    IntentName.PATROL: AllowedSlots(),
    IntentName.COME: AllowedSlots(_NONE, _SUBJECT),
    IntentName.FOLLOW: AllowedSlots(_NONE, _SUBJECT),
    IntentName.VISITOR: AllowedSlots(),
    IntentName.INVENTORY: AllowedSlots(_NONE, _SUBJECT),
    IntentName.NIGHT_ROUND: AllowedSlots(),
    IntentName.ALL_RIGHT: AllowedSlots(_NONE, _SUBJECT),
    IntentName.SERVICE: AllowedSlots(frozenset({"service"}), _SUBJECT),
    IntentName.CALL_ME: AllowedSlots(
        frozenset({"event"}), _SUBJECT | _WHEN | {"state", "in_minutes"}
    ),
    IntentName.CLIPS: AllowedSlots(_NONE, _SUBJECT | _WHEN),
    IntentName.CANCEL: AllowedSlots(),
    IntentName.PAUSE: AllowedSlots(),
    IntentName.CONTINUE: AllowedSlots(),
    IntentName.STOP: AllowedSlots(),
    IntentName.LAND: AllowedSlots(),
    IntentName.HOME: AllowedSlots(),
    IntentName.MODE: AllowedSlots(_NONE, frozenset({"mode"})),
    IntentName.HELP: AllowedSlots(),
}
"""What each intent holds."""

FLYING_INTENTS = frozenset(
    {
        IntentName.LOOK,
        IntentName.LOOK_AROUND,
        IntentName.PATROL,
        IntentName.COME,
        IntentName.FOLLOW,
        IntentName.VISITOR,
        IntentName.INVENTORY,
        IntentName.NIGHT_ROUND,
        IntentName.ALL_RIGHT,
        IntentName.SERVICE,
    }
)
"""Intents that ask for a flight; ``where`` does with ``go``."""


def may_fly(intent: Intent) -> bool:
    """Return whether an intent asks for a flight."""
    return intent.intent in FLYING_INTENTS or bool(intent.slots.go)


def _given_slots(slots: IntentSlots) -> dict[str, ParameterValue]:
    """Return the slots that are not None, by name, as plain values."""
    said = ((one.name, getattr(slots, one.name)) for one in fields(slots))
    return {
        name: str(value) if isinstance(value, NameKind) else value
        for name, value in said
        if value is not None
    }


@cache
def _adapter() -> TypeAdapter[Intent]:
    return TypeAdapter(Intent)


def intent_to_json(intent: Intent) -> str:
    """Return an intent as JSON; what was not said is left out."""
    return _adapter().dump_json(intent, exclude_none=True).decode()


def intent_from_json(text: str | bytes) -> Intent:
    """Return the intent; raises WireError that names the first bad key."""
    try:
        return checked_intent(_adapter().validate_json(text))
    except ValidationError as error:
        raise WireError(first_problem(error)) from error


def checked_intent(intent: Intent) -> Intent:
    """Return the intent; raises WireError when it lacks a slot or has one that it never has."""
    allowed, said = INTENT_SLOTS[intent.intent], set(_given_slots(intent.slots))
    if missing := allowed.required - said:
        raise WireError(f"slots.{min(missing)}: is missing; {intent.intent.value} needs it")
    if extra := said - allowed.required - allowed.optional:
        known = ", ".join(sorted(allowed.required | allowed.optional)) or "none"
        raise WireError(f"slots.{min(extra)}: {intent.intent.value} has no such slot; has: {known}")
    return intent


def intent_schema() -> dict[str, Any]:
    """Return the JSON schema of an intent: types, and which slots belong to which intent."""
    schema = _adapter().json_schema()
    rules = [
        {
            "if": {"properties": {"intent": {"const": name.value}}, "required": ["intent"]},
            "then": {"properties": {"slots": _slots_rule(allowed)}}
            | ({"required": ["slots"]} if allowed.required else {}),
        }
        for name, allowed in INTENT_SLOTS.items()
    ]
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", **schema, "allOf": rules}


def _slots_rule(allowed: AllowedSlots) -> dict[str, Any]:
    names = sorted(allowed.required | allowed.optional)
    return {
        "required": sorted(allowed.required),
        "propertyNames": {"enum": names},
    }


SCHEMA_FILE = Path(__file__).with_name("intent_schema.json")


def schema_text() -> str:
    """Return the text of ``intent_schema.json``."""
    return json.dumps(intent_schema(), indent=1, ensure_ascii=False, sort_keys=True) + "\n"


if __name__ == "__main__":
    SCHEMA_FILE.write_text(schema_text(), encoding="utf-8")
