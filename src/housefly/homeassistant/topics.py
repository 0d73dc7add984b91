"""MQTT topics that Home Assistant reads and writes: ``housefly-home/<site>/...``.

They are not below ``housefly/<site>``, where devices speak: a broker can give each client one of
the two trees, and the devices' driver is not handed pictures.
"""

from __future__ import annotations

import re
from dataclasses import dataclass

_ROOT = "housefly-home"
_PLAIN = re.compile(r"[^A-Za-z0-9-]")


def topic_key(name: str) -> str:
    """Return a name as part of a topic and of an id; two names never become one key."""
    return _PLAIN.sub(lambda match: "__" if match[0] == "_" else f"_{ord(match[0]):x}_", name)


@dataclass(frozen=True, slots=True)
class HomeTopics:
    """The topics of one site.

    Attributes:
        site: its name on MQTT.
        prefix: of discovery in Home Assistant.
    """

    site: str
    prefix: str = "homeassistant"

    @property
    def node(self) -> str:
        """How the ids of all that is of this site begin."""
        return f"housefly-{self.site}"

    @property
    def availability(self) -> str:
        """Whether Housefly is there: "online" retained, "offline" as last will."""
        return f"{_ROOT}/{self.site}/availability"

    def part_availability(self, key: str) -> str:
        """Return where it is said whether one drone or device is there; retained."""
        return f"{_ROOT}/{self.site}/availability/{key}"

    def state(self, key: str) -> str:
        """Return where the state of an entity is; retained."""
        return f"{_ROOT}/{self.site}/state/{key}"

    def attributes(self, key: str) -> str:
        """Return where the attributes of an entity are, as JSON; retained."""
        return f"{_ROOT}/{self.site}/attributes/{key}"

    def is_attributes(self, topic: str) -> bool:
        """Return whether a topic holds attributes."""
        return topic.startswith(self.attributes(""))

    def event(self, key: str) -> str:
        """Return where events of an entity are; never retained."""
        return f"{_ROOT}/{self.site}/event/{key}"

    def picture(self, key: str) -> str:
        """Return where the pictures of an entity are, as JPEG; never retained."""
        return f"{_ROOT}/{self.site}/picture/{key}"

    def drone_command(self, drone: str) -> str:
        """Return where a drone is told what to do."""
        return f"{_ROOT}/{self.site}/set/drone/{topic_key(drone)}"

    @property
    def answer_command(self) -> str:
        """Where a question of a task is answered."""
        return f"{_ROOT}/{self.site}/set/answer"

    @property
    def commands(self) -> str:
        """The topic filter of all commands."""
        return f"{_ROOT}/{self.site}/set/#"

    @property
    def birth(self) -> str:
        """Where Home Assistant says that it is there, or gone."""
        return f"{self.prefix}/status"

    def entity_config(self, component: str, key: str) -> str:
        """Return where one entity is announced; retained."""
        return f"{self.prefix}/{component}/{self.node}/{key}/config"

    def device_config(self, device: str) -> str:
        """Return where one device with all its entities is announced; retained."""
        return f"{self.prefix}/device/{self.node}-{device}/config"

    @property
    def announcements(self) -> tuple[str, str]:
        """Topic filters of all that may be announced of this site, in either form."""
        return f"{self.prefix}/+/{self.node}/+/config", f"{self.prefix}/device/+/config"

    def announced_key(self, topic: str) -> str:
        """Return the key of what of this site is announced on a topic, "" for all others."""
        match topic.removeprefix(f"{self.prefix}/").split("/"):
            case ["device", name, "config"] if name.startswith(f"{self.node}-"):
                return name.removeprefix(f"{self.node}-")
            case [_, self.node, key, "config"]:
                return key
        return ""
