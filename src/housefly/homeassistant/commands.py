"""What Home Assistant may ask for: messages as checked values."""

from __future__ import annotations

import re
from dataclasses import dataclass
from enum import Enum

from housefly.errors import WireError

MAX_COMMAND = 1024
"""Longest command [bytes]."""
_TASK = re.compile(r"[1-9][0-9]{0,14}", re.ASCII)
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
    """Return what a message answers: ``yes``, ``no``, ``12|confirm|yes``; raises WireError.

    The last means one question of one task, and no later one.
    """
    said = _text(payload)
    known = {one.value: one for one in YesOrNo}
    if said in known:
        return AnswerCommand(known[said])
    match said.split("|", 2):
        case [task, question, choice] if (
            _TASK.fullmatch(task)
            and 0 < len(question) <= _TEXT_MAX
            and 0 < len(choice) <= _TEXT_MAX
        ):
            return AnswerCommand(known.get(choice, choice), int(task), question)
    raise WireError(f"{payload[:40]!a} is no answer; known: yes, no, TASK|QUESTION|CHOICE")


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
