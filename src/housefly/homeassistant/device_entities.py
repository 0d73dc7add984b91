"""The room's devices and sensors as entities, and what their reports are there."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass

from housefly.homeassistant.entities import HomeDevice, HomeEntity
from housefly.homeassistant.topics import HomeTopics, topic_key
from housefly.hub.api.answers import EventAnswer, SensorAnswer, SourceAnswer
from housefly.messages.world import Fact

UNKNOWN = "None"
"""The payload by which Home Assistant takes a state as unknown."""
RING = "press"
"""The type of the event of a doorbell."""
_RUNG = "bell pressed"


@dataclass(frozen=True, slots=True)
class _Shown:
    """How one fact of a device is shown: its component, name, class and unit."""

    fact: str
    component: str
    name: str
    device_class: str = ""
    unit: str = ""


_OPEN = _Shown("open", "binary_sensor", "Open", "opening")
_DOOR = _Shown("open", "binary_sensor", "Door", "door")
_TEMPERATURE = _Shown("temperature_c", "sensor", "Temperature", "temperature", "°C")
_LOAD = _Shown("load", "sensor", "Load", "weight", "kg")
_BATTERY = _Shown("battery", "sensor", "Battery", "battery", "%")
_FACTS: Mapping[str, tuple[_Shown, ...]] = {
    "door": (_DOOR,),
    "contact": (_OPEN,),
    "refrigerator": (_DOOR, _TEMPERATURE, _Shown("contents", "sensor", "Contents")),
    "cabinet": (_DOOR, _LOAD, _Shown("contents", "sensor", "Contents")),
    "bed": (_Shown("occupied", "binary_sensor", "Occupied", "occupancy"), _LOAD),
    "motion": (_Shown("motion", "binary_sensor", "Motion", "motion"),),
    "switch": (_Shown("on", "binary_sensor", "On", "power"),),
    "power": (_Shown("power", "sensor", "Power", "power", "W"),),
    "temperature": (_TEMPERATURE,),
    "level": (_Shown("level_percent", "sensor", "Level", "", "%"),),
    "floor": (_Shown("people", "sensor", "People"), _Shown("objects", "sensor", "Objects")),
    "doorbell": (),
}
"""What is shown of each kind of device; of any other kind, only whether it is heard."""
_TEXT_MAX = 255
"""Longest state that Home Assistant takes."""


def is_device(sensor: SensorAnswer) -> bool:
    """Return whether a sensor is a device whose reports are shown."""
    return sensor.kind in _FACTS


def device_key(sensor: str) -> str:
    """Return the key of a device or sensor of the room."""
    return f"device-{topic_key(sensor)}"


def device_entities(
    sensor: SensorAnswer, room: HomeDevice, topics: HomeTopics, *, has_battery: bool
) -> tuple[HomeEntity, ...]:
    """Return the entities of one sensor; a battery is among them once it has told of it."""
    key = device_key(sensor.sensor)
    if not is_device(sensor):
        settings = {
            "state_topic": topics.state(key),
            "device_class": "connectivity",
            "entity_category": "diagnostic",
        }
        return (HomeEntity("binary_sensor", key, room, sensor.title, settings),)
    device, there = HomeDevice(key, sensor.title, sensor.kind), (topics.part_availability(key),)
    shown = (*_FACTS[sensor.kind], *((_BATTERY,) if has_battery else ()))
    found = [
        HomeEntity(
            one.component,
            f"{key}-{topic_key(one.fact)}",
            device,
            one.name,
            {"state_topic": topics.state(f"{key}-{topic_key(one.fact)}"), **_class(one)},
            there,
        )
        for one in shown
    ]
    if sensor.kind == "doorbell":
        ringing = {
            "state_topic": topics.event(key),
            "event_types": [RING],
            "device_class": "doorbell",
        }
        # A bell may be silent for weeks, so it is there as long as Housefly is.
        found.append(HomeEntity("event", f"{key}-bell", device, "Bell", ringing))
    return tuple(found)


def device_states(
    sensor: SensorAnswer, source: SourceAnswer | None, topics: HomeTopics
) -> dict[str, bytes]:
    """Return what the topics of one sensor are to hold, from its health and its last report.

    A report that is not stood by, or that the broker kept from before, is no state.
    """
    key = device_key(sensor.sensor)
    if not is_device(sensor):
        return {topics.state(key): b"ON" if sensor.connected else b"OFF"}
    is_believed = source is not None and source.valid and source.facts.get("retained") is not True
    facts = source.facts if source is not None and is_believed else {}
    found = {topics.part_availability(key): b"online" if sensor.connected else b"offline"}
    for one in (*_FACTS[sensor.kind], _BATTERY):
        if one is not _BATTERY or "battery" in facts:
            value = facts.get(one.fact)
            found[topics.state(f"{key}-{topic_key(one.fact)}")] = _payload(value, one).encode()
    return found


def bell_message(event: EventAnswer, topics: HomeTopics) -> tuple[str, bytes] | None:
    """Return topic and payload of a bell that rings, None for any other event."""
    if event.kind != _RUNG:
        return None
    payload = json.dumps({"event_type": RING, "at": event.at}).encode()
    return topics.event(device_key(event.source)), payload


def _class(shown: _Shown) -> dict[str, str]:
    given = {"device_class": shown.device_class, "unit_of_measurement": shown.unit}
    measures = {"state_class": "measurement"} if shown.unit else {}
    return {name: value for name, value in given.items() if value} | measures


def _payload(value: Fact | None, shown: _Shown) -> str:
    if shown.component == "binary_sensor":
        return ("ON" if value else "OFF") if isinstance(value, bool) else UNKNOWN
    if isinstance(value, str) and not shown.unit:
        return value[:_TEXT_MAX] or "empty"
    if isinstance(value, bool) or not isinstance(value, int | float):
        return UNKNOWN
    return f"{100.0 * value:.0f}" if shown is _BATTERY else f"{round(value, 1):g}"
