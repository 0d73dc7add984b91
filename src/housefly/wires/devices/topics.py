"""MQTT topics of devices: ``housefly/<site>/<kind>/<id>/<channel>``."""

from __future__ import annotations

import re
from dataclasses import dataclass
from enum import Enum

from housefly.errors import WireError
from housefly.wires.devices.fields import ID_PATTERN

_ROOT = "housefly"
_SITE_NAME = re.compile(r"[a-z0-9][a-z0-9_-]{0,39}")
_SHOWN = 100


class Channel(Enum):
    """State (retained), events (not retained), and availability (the last will) of a device."""

    STATE = "state"
    EVENT = "event"
    AVAILABILITY = "availability"


@dataclass(frozen=True, slots=True)
class DeviceAddress:
    """One device of one site.

    Attributes:
        site: short lower-case name of the place.
        kind: name of the kind of device, as in ``KINDS``.
        id: of the device; unique in the site over all kinds, for it becomes the ``source`` of what
            the device says.
    """

    site: str
    kind: str
    id: str

    def topic(self, channel: Channel) -> str:
        """Return the topic of one of the device's channels."""
        return f"{_ROOT}/{self.site}/{self.kind}/{self.id}/{channel.value}"


def site_subscription(site: str) -> str:
    """Return the topic filter of all devices of a site."""
    return f"{_ROOT}/{site}/#"


def listener_topic(site: str) -> str:
    """Return the topic of Housefly's own availability: "online" retained, "offline" as will."""
    return f"{_ROOT}/{site}/listener/availability"


def task_topic(site: str, what: str) -> str:
    """Return a topic of the tasks: "request", "answer", "request/NAME"; no device is there."""
    return f"{_ROOT}/{site}/task/{what}"


def parse_topic(topic: str) -> tuple[DeviceAddress, Channel]:
    """Return the device and channel of a topic.

    Raises:
        WireError: naming the topic and the scheme.
    """
    parts = topic.split("/")
    channels = {channel.value: channel for channel in Channel}
    if (
        len(parts) != 5
        or parts[0] != _ROOT
        or not _SITE_NAME.fullmatch(parts[1])
        or not ID_PATTERN.fullmatch(parts[3])
    ):
        raise WireError(
            f"{printable_topic(topic)} is not of the form"
            f" {_ROOT}/<site>/<kind>/<id>/<{'|'.join(channels)}>"
        )
    if parts[4] not in channels:
        raise WireError(
            f"{printable_topic(topic)}: unknown channel; allowed: {', '.join(channels)}"
        )
    return DeviceAddress(parts[1], parts[2], parts[3]), channels[parts[4]]


def printable_topic(topic: str) -> str:
    """Return a topic in printable characters, cut to a line."""
    text = ascii(topic)[1:-1]
    return text if len(text) <= _SHOWN else text[:_SHOWN] + "..."
