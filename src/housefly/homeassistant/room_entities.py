"""The room itself as entities: situations, the mode of the house, what a task asks."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from typing import Any

from housefly.homeassistant.entities import ROOM_DEVICE, HomeDevice, HomeEntity
from housefly.homeassistant.topics import HomeTopics
from housefly.hub.api.answers import SituationAnswer
from housefly.hub.situations.kinds import SituationKind
from housefly.tasks.api.answers import TaskBoard
from housefly.tasks.api.values import TaskStatus

QUESTION, REPLY, MODE, YES, NO = "room-question", "room-reply", "room-mode", "room-yes", "room-no"
NO_QUESTION = "none"
"""State of the sensor while no task asks anything."""
_CLASSES: Mapping[SituationKind, str] = {
    SituationKind.PERSON_PRESENT: "occupancy",
    SituationKind.PERSON_FALLEN: "safety",
    SituationKind.BED_OCCUPIED: "occupancy",
    SituationKind.DOOR_OPEN_LONG: "problem",
    SituationKind.APPLIANCE_ON: "power",
    SituationKind.CONTACT_OPEN: "opening",
    SituationKind.AT_ENTRANCE: "occupancy",
    SituationKind.OBJECT_MISSING: "problem",
}
_TEXT_MAX = 255
"""Longest state that Home Assistant takes."""


def room_device(name: str) -> HomeDevice:
    """Return the device of the room; everything else stands under it."""
    return HomeDevice(ROOM_DEVICE, name, "Room")


def room_entities(room: HomeDevice, topics: HomeTopics, *, may_ask: bool) -> tuple[HomeEntity, ...]:
    """Return the entities of the room; yes and no are among them where they may be said."""
    told = [
        HomeEntity(
            "binary_sensor",
            _key(kind),
            room,
            kind.value.capitalize(),
            {
                "state_topic": topics.state(_key(kind)),
                "json_attributes_topic": topics.attributes(_key(kind)),
                **({"device_class": _CLASSES[kind]} if kind in _CLASSES else {}),
            },
        )
        for kind in SituationKind
    ]
    texts = {QUESTION: "Question", REPLY: "Reply", MODE: "Mode"}
    for key, name in texts.items():
        more = {} if key == REPLY else {"json_attributes_topic": topics.attributes(key)}
        told.append(
            HomeEntity("sensor", key, room, name, {"state_topic": topics.state(key), **more})
        )
    if may_ask:
        told += [
            HomeEntity(
                "button",
                key,
                room,
                name,
                {"command_topic": topics.answer_command, "payload_press": payload},
            )
            for key, name, payload in ((YES, "Yes", "yes"), (NO, "No", "no"))
        ]
    return tuple(told)


def situation_states(situations: Iterable[SituationAnswer], topics: HomeTopics) -> dict[str, bytes]:
    """Return what the topics of all situations are to hold."""
    held = tuple(situations)
    found = {}
    for kind in SituationKind:
        mine = [one for one in held if one.kind == kind.value]
        found[topics.state(_key(kind))] = b"ON" if mine else b"OFF"
        found[topics.attributes(_key(kind))] = _json(
            {
                "things": [one.thing for one in mine],
                "since": min((one.since for one in mine), default=None),
                "confidence": round(max((one.confidence for one in mine), default=0.0), 1),
            }
        )
    return found


def asking_task(board: TaskBoard | None) -> TaskStatus | None:
    """Return the task whose question is shown: the one that has waited longest, or None."""
    asking = (task for task in board.tasks if task.question is not None) if board else iter(())
    return min(asking, key=lambda task: task.id, default=None)


def board_states(board: TaskBoard | None, topics: HomeTopics) -> dict[str, bytes]:
    """Return what question and mode are to show; nothing is known without a board."""
    task = asking_task(board)
    question = task.question if task is not None else None
    asked: dict[str, Any] = {}
    if task is not None and question is not None:
        asked = {
            "asks": f"{task.id}|{question.id}",
            "words": question.words,
            "choices": list(question.choices),
            "until": question.until,
            "service": task.service,
            "asked_by": task.asked_by,
            "waiting": sum(one.question is not None for one in board.tasks) if board else 0,
        }
    return {
        topics.state(QUESTION): text_state(question.words if question else NO_QUESTION),
        topics.attributes(QUESTION): _json(asked),
        topics.state(MODE): board.mode.value.encode() if board else b"None",
        topics.attributes(MODE): _json({"records": board.records} if board else {}),
    }


def text_state(words: str) -> bytes:
    """Return a text as a state, cut to what Home Assistant takes."""
    return (words if len(words) <= _TEXT_MAX else f"{words[: _TEXT_MAX - 1]}…").encode()


def _key(kind: SituationKind) -> str:
    return f"situation-{kind.name.lower().replace('_', '-')}"


def _json(tree: Mapping[str, Any]) -> bytes:
    return json.dumps(tree, ensure_ascii=False).encode()
