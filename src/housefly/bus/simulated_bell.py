"""How the console presses the doorbell of a simulated room: one query, one answer, as JSON."""

from __future__ import annotations

from dataclasses import dataclass

from pydantic import TypeAdapter, ValidationError

from housefly.errors import WireError

BELL_QUERY = "twin/bell"
"""Query: "" -> JSON of a BellPress; only a simulated room answers."""
BELL_WEBHOOK = "bell"
"""The webhook that speaks for a bell without a wire."""


@dataclass(frozen=True, slots=True)
class BellPress:
    """What the simulated room does when its bell is to be pressed.

    Attributes:
        pressed: whether somebody presses it.
        words: what happens, or why nothing does, in words.
        at: when it is pressed [Unix time, s].
        has_wire: whether the bell tells the house itself, as a device on MQTT.
    """

    pressed: bool
    words: str
    at: float
    has_wire: bool = True


_PRESS: TypeAdapter[BellPress] = TypeAdapter(BellPress)


def press_to_json(press: BellPress) -> str:
    """Return the JSON text of an answer."""
    return _PRESS.dump_json(press).decode()


def press_from_json(text: str) -> BellPress:
    """Return an answer; raises WireError when it is none."""
    try:
        return _PRESS.validate_json(text)
    except ValidationError as error:
        raise WireError("the simulated room answers what is no bell") from error
