"""Kinds of devices: tables of their keys and events, and a function to make observations."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from math import cos, sin

from housefly.geometry import Vec3
from housefly.messages import Fact, Observation
from housefly.wires.devices.fields import ChoiceField, JsonRecord, JsonSpec, NumberField

_UNIX_TIME_MAX = 4.0e9
"""Latest Unix time accepted [s], year 2096."""

_COMMON_KEYS: JsonSpec = {
    "time": NumberField(0.0, _UNIX_TIME_MAX, "s (Unix time)", required=False),
    "battery": NumberField(0.0, 1.0, required=False),
}
"""Keys that every message may have."""


@dataclass(frozen=True, slots=True)
class Placement:
    """What is known of a device beforehand.

    Attributes:
        position: origin of its frame in the world [m].
        yaw: direction of its x axis in the world [rad].
        things: thing of each tag; an unlisted tag is the thing's own id.
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
    """One message of a device; makes its observations.

    Attributes:
        source: id of the device.
        captured_at: when the device measured it [s, Unix time].
        received_at: when it arrived [s, Unix time].
        placement: where the device stands, which tags are known.
        notes: facts that go with every observation.
    """

    source: str
    captured_at: float
    received_at: float
    placement: Placement = Placement()
    notes: tuple[tuple[str, Fact], ...] = ()

    def about_device(self, *facts: tuple[str, Fact | None]) -> Observation:
        """Return the device's observation of itself; facts that are None are left out."""
        return self.about(self.source, None, *facts)

    def about(
        self, thing: str, position: Vec3 | None, *facts: tuple[str, Fact | None], inside: str = ""
    ) -> Observation:
        """Return the device's observation of a thing."""
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
        heartbeat: longest time between two states [s]; twice that counts as silence.
        observe: makes the observations of a checked state.
        events: word of an event on the wire, and its kind in the room.
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
