"""What Home Assistant shows, as values, and the documents by which it discovers them."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any, Literal

from housefly.homeassistant.topics import HomeTopics

_ORIGIN = {"name": "Housefly"}
_MAKER = "Housefly"
ROOM_DEVICE = "room"
"""Key of the device under which everything else stands."""


@dataclass(frozen=True, slots=True)
class HomeDevice:
    """A device in Home Assistant: the room itself, a drone, a device of the room.

    Attributes:
        key: its id among those of the site.
        name: shown to people.
        model: what it is.
    """

    key: str
    name: str
    model: str


@dataclass(frozen=True, slots=True)
class HomeEntity:
    """One entity.

    Attributes:
        component: "sensor", "button" ...
        key: its id among those of the site.
        device: to which it belongs.
        name: shown behind that of the device; None where the device is what it shows.
        settings: topics, classes and units, as Home Assistant names them.
        available_with: topics that must all say "online".
    """

    component: str
    key: str
    device: HomeDevice
    name: str | None
    settings: Mapping[str, Any] = field(default_factory=dict)
    available_with: tuple[str, ...] = ()


def discovery_documents(
    entities: Iterable[HomeEntity],
    topics: HomeTopics,
    discovery: Literal["entity", "device"] = "entity",
) -> dict[str, bytes]:
    """Return the topics and payloads that announce entities, one each or one for each device."""
    if discovery == "entity":
        return {
            topics.entity_config(one.component, one.key): _json(
                {**_entity(one, topics), "device": _device(one.device, topics), "origin": _ORIGIN}
            )
            for one in entities
        }
    by_device: dict[HomeDevice, dict[str, Any]] = {}
    for one in entities:
        parts = by_device.setdefault(one.device, {})
        parts[one.key] = {"platform": one.component, **_entity(one, topics)}
    return {
        topics.device_config(device.key): _json(
            {"device": _device(device, topics), "origin": _ORIGIN, "components": parts}
        )
        for device, parts in by_device.items()
    }


def _entity(entity: HomeEntity, topics: HomeTopics) -> dict[str, Any]:
    available = (topics.availability, *entity.available_with)
    return {
        "name": entity.name,
        "unique_id": f"{topics.node}-{entity.key}",
        "availability": [{"topic": topic} for topic in available],
        "availability_mode": "all",
        **entity.settings,
    }


def _device(device: HomeDevice, topics: HomeTopics) -> dict[str, Any]:
    told = {
        "identifiers": [f"{topics.node}-{device.key}"],
        "name": device.name,
        "model": device.model,
        "manufacturer": _MAKER,
    }
    above = f"{topics.node}-{ROOM_DEVICE}"
    return told if device.key == ROOM_DEVICE else {**told, "via_device": above}


def _json(tree: Mapping[str, Any]) -> bytes:
    return json.dumps(tree, ensure_ascii=False, separators=(",", ":")).encode()
