"""What Home Assistant may ask for: messages as checked values."""

from __future__ import annotations

import json
from dataclasses import dataclass
from enum import Enum

from housefly.errors import WireError

MAX_COMMAND = 1024
"""Longest command [bytes]."""
_TASK_MAX = 2**53
_TEXT_MAX = 80


class DroneVerb(Enum):
    """What a drone may be told."""

    STOP = "stop"
    LAND = "land"
    HOVER = "hover"
    HOME = "home"
    START = "start"
    GO = "go"


class YesOrNo(Enum):
    """What a person may say to whatever is asked."""

    YES = "yes"
    NO = "no"


@dataclass(frozen=True, slots=True)
class DroneCommand:
    """One thing that a drone shall do; ``place`` is for GO."""

    verb: DroneVerb
    place: str = ""


@dataclass(frozen=True, slots=True)
class AnswerCommand:
    """What somebody says to the question of a task.

    Attributes:
        choice: yes or no, or one of the choices in its own words.
        task, question: which is meant; 0 and "" mean the only one that waits.
    """

    choice: YesOrNo | str
    task: int = 0
    question: str = ""


def drone_command(payload: bytes) -> DroneCommand:
    """Return what a message tells a drone: ``stop``, ``go entrance``; raises WireError."""
    word, _, place = _text(payload).partition(" ")
    verbs = {verb.value: verb for verb in DroneVerb}
    if word not in verbs or bool(place) != (verbs.get(word) is DroneVerb.GO):
        raise WireError(f"{payload[:40]!a} tells a drone nothing; known: {', '.join(verbs)}")
    if len(place) > _TEXT_MAX:
        raise WireError(f"the name of a place has at most {_TEXT_MAX} letters")
    return DroneCommand(verbs[word], place)


def answer_command(payload: bytes) -> AnswerCommand:
    """Return what a message answers: ``yes``, ``no``, or JSON; raises WireError.

    ``{"task": 12, "question": "confirm", "choice": "yes"}`` means that question and no later one.
    """
    text = _text(payload)
    if text in {one.value for one in YesOrNo}:
        return AnswerCommand(YesOrNo(text))
    try:
        tree = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise WireError(f"{payload[:40]!a} is no answer; known: yes, no, JSON") from error
    match tree:
        case {"task": int(task), "question": str(question), "choice": str(choice)} if (
            tree.keys() == {"task", "question", "choice"}
            and not isinstance(task, bool)
            and 1 <= task <= _TASK_MAX
            and all(
                0 < len(word) <= _TEXT_MAX and word.isprintable() for word in (question, choice)
            )
        ):
            known = {one.value: one for one in YesOrNo}
            return AnswerCommand(known.get(choice, choice), task, question)
    raise WireError('an answer is {"task": number, "question": text, "choice": text}')


def _text(payload: bytes) -> str:
    if len(payload) > MAX_COMMAND:
        raise WireError(f"{len(payload)} bytes; allowed: {MAX_COMMAND}")
    try:
        text = payload.decode().strip()
    except UnicodeDecodeError as error:
        raise WireError("this is no text") from error
    if not text.isprintable():
        raise WireError("this is no text")
    return text
