"""What a client of rosbridge v2 is told, as JSON texts."""

from __future__ import annotations

import json
from enum import IntEnum
from typing import Any


class StatusLevel(IntEnum):
    """How bad it is; a client hears what is at least as bad as its level."""

    INFO = 0
    WARNING = 1
    ERROR = 2
    NONE = 3


def level_named(name: str) -> StatusLevel:
    """Return a level by the name that the protocol has for it."""
    return StatusLevel[name.upper()]


def message_text(topic: str, tree: dict[str, Any]) -> str:
    """Return a message of a topic."""
    return _text({"op": "publish", "topic": topic, "msg": tree})


def status_text(level: StatusLevel, words: str, ident: str | int | None) -> str:
    """Return a line about what became of a message, with its id where it had one."""
    told = {"op": "status", "level": level.name.lower(), "msg": words}
    return _text(told if ident is None else {**told, "id": ident})


def response_text(
    service: str, ident: str | int | None, values: dict[str, Any] | str, *, result: bool
) -> str:
    """Return the answer to a call; ``values`` are words where it failed."""
    told = {"op": "service_response", "service": service, "values": values, "result": result}
    return _text(told if ident is None else {**told, "id": ident})


def _text(tree: dict[str, Any]) -> str:
    return json.dumps(tree, ensure_ascii=False, allow_nan=False, separators=(",", ":"))
