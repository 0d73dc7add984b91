"""One drone as entities: a vacuum by its words, battery, tracker, buttons, pictures."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from housefly.homeassistant.commands import DroneVerb
from housefly.homeassistant.entities import HomeDevice, HomeEntity
from housefly.homeassistant.topics import HomeTopics, topic_key
from housefly.room.model import Place

_PICTURE_OF = {"camera": ("Camera", "topic"), "image": ("Last picture", "image_topic")}
"""Name of each component with pictures, and how its topic is called."""


def drone_key(drone: str) -> str:
    """Return the key of a drone."""
    return f"drone-{topic_key(drone)}"


def picture_key(drone: str, component: str) -> str:
    """Return the key of a drone's "camera", or of the "image" that was kept last."""
    return f"{drone_key(drone)}-{component}"


def drone_entities(
    drone: str,
    places: Iterable[Place],
    topics: HomeTopics,
    *,
    may_ask: bool,
    has_pictures: bool,
) -> tuple[HomeEntity, ...]:
    """Return the entities of one drone; STOP is among them, whatever else may be asked."""
    key = drone_key(drone)
    device, command = HomeDevice(key, drone, "Drone"), topics.drone_command(drone)
    there = (topics.part_availability(key),)

    def entity(component: str, name: str | None, what: str, **settings: Any) -> HomeEntity:
        return HomeEntity(component, f"{key}-{what}", device, name, settings, there)

    def button(name: str, what: str, payload: str, **settings: Any) -> HomeEntity:
        # A button works also where nobody hears the drone: STOP is sent, whoever may hear it.
        pressed = {"command_topic": command, "payload_press": payload, **settings}
        return HomeEntity("button", f"{key}-{what}", device, name, pressed)

    flying = entity(
        "vacuum",
        None,
        "flight",
        state_topic=topics.state(key),
        json_attributes_topic=topics.attributes(key),
        **(_vacuum_commands(command) if may_ask else {"supported_features": ["status"]}),
    )
    told = [
        flying,
        entity(
            "sensor",
            "Battery",
            "battery",
            state_topic=topics.state(f"{key}-battery"),
            device_class="battery",
            unit_of_measurement="%",
            state_class="measurement",
        ),
        entity(
            "device_tracker",
            "Place",
            "place",
            state_topic=topics.state(f"{key}-place"),
            json_attributes_topic=topics.attributes(f"{key}-place"),
            source_type="gps",
        ),
        button("STOP", "stop", DroneVerb.STOP.value, icon="mdi:alert-octagon"),
    ]
    if may_ask:
        told.append(button("Land", "land", DroneVerb.LAND.value, icon="mdi:airplane-landing"))
        told += [
            button(
                f"Go to {place.title or place.name}",
                f"go-{topic_key(place.name)}",
                f"{DroneVerb.GO.value} {place.name}",
                icon="mdi:map-marker",
            )
            for place in places
        ]
    if has_pictures:
        told += [
            entity(
                component, name, component, **{named: topics.picture(picture_key(drone, component))}
            )
            for component, (name, named) in _PICTURE_OF.items()
        ]
    return tuple(told)


def _vacuum_commands(command: str) -> dict[str, Any]:
    return {
        "command_topic": command,
        "supported_features": ["start", "stop", "pause", "return_home", "status"],
        "payload_start": DroneVerb.START.value,
        "payload_stop": DroneVerb.HOVER.value,
        "payload_pause": DroneVerb.HOVER.value,
        "payload_return_to_base": DroneVerb.HOME.value,
    }
