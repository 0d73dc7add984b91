"""What a kind of device is: tables of its keys and events, and one function that turns a checked
state into observations.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from math import cos, sin

from housefly.geometry import Vec3
from housefly.messages import Fact, Observation
from housefly.wires.devices.fields import ChoiceField, JsonRecord, JsonSpec, NumberField

_UNIX_TIME_MAX = 4.0e9
"""Latest Unix time that is a time at all [s], year 2096."""

_COMMON_KEYS: JsonSpec = {
    "time": NumberField(0.0, _UNIX_TIME_MAX, "s (Unix time)", required=False),
    "battery": NumberField(0.0, 1.0, required=False),
}
"""Keys that every message may have."""


@dataclass(frozen=True, slots=True)
class Placement:
    """What we know of one device beforehand.

    Attributes:
        position: origin of its frame in the world [m].
        yaw: direction of its x axis in the world [rad].
        things: which thing carries which tag; a tag that is not here is the thing's own id.
    """

    position: Vec3 = (0.0, 0.0, 0.0)
    yaw: float = 0.0
    things: Mapping[str, str] = field(default_factory=dict)

    def world(self, x: float, y: float, z: float) -> Vec3:
        """Return a point of the device's frame in the world [m]."""
        px, py, pz = self.position
        return (
            px + x * cos(self.yaw) - y * sin(self.yaw),
            py + x * sin(self.yaw) + y * cos(self.yaw),
            pz + z,
        )

    def thing(self, tag: str) -> str:
        """Return the id of the thing that carries a tag."""
        return self.things.get(tag, tag)


@dataclass(frozen=True, slots=True)
class DeviceReport:
    """Who says something and when; makes the observations of one message.

    Attributes:
        source: id of the device.
        captured_at: when it was so [s, Unix time].
        received_at: when we heard of it [s, Unix time].
        placement: where the device stands, which tags are known.
        notes: facts that belong to all that the message says.
    """

    source: str
    captured_at: float
    received_at: float
    placement: Placement = Placement()
    notes: tuple[tuple[str, Fact], ...] = ()

    def itself(self, *facts: tuple[str, Fact | None]) -> Observation:
        """Return what the device says of itself; facts that are None are left out."""
        return self.of(self.source, None, *facts)

    def of(
        self, thing: str, position: Vec3 | None, *facts: tuple[str, Fact | None], inside: str = ""
    ) -> Observation:
        """Return what the device says of a thing."""
        known = tuple((name, value) for name, value in facts if value is not None)
        return Observation(
            thing,
            self.source,
            self.captured_at,
            self.received_at,
            position,
            inside=inside,
            facts=(*known, *self.notes),
        )


@dataclass(frozen=True, slots=True)
class DeviceKind:
    """One kind of device.

    Attributes:
        name: in topics.
        title: for people.
        state: keys of its state beside the common ones.
        heartbeat: it sends its state at least this often [s]; twice that without one counts as
            silence.
        observe: what a checked state says.
        events: word of an event on the wire, and what that is called in the room.
        event: keys of an event beside the common ones and "event".
    """

    name: str
    title: str
    state: JsonSpec
    heartbeat: float
    observe: Callable[[JsonRecord, DeviceReport], Iterable[Observation]]
    events: Mapping[str, str] = field(default_factory=dict)
    event: JsonSpec = field(default_factory=dict)

    def state_spec(self) -> JsonSpec:
        """Return all keys of a state."""
        return {**_COMMON_KEYS, **self.state}

    def event_spec(self) -> JsonSpec:
        """Return all keys of an event."""
        return {**_COMMON_KEYS, "event": ChoiceField(tuple(self.events)), **self.event}
