"""Where devices speak: ``housefly/<site>/<kind>/<id>/<channel>``."""

from __future__ import annotations

import re
from dataclasses import dataclass
from enum import Enum

from housefly.errors import WireError
from housefly.wires.devices.fields import NAME

ROOT = "housefly"
SITE = re.compile(r"[a-z0-9][a-z0-9_-]{0,39}")
_SHOWN = 100


class Channel(Enum):
    """What a device says: how it is now (retained), what just happened (not retained), whether it
    is there (its last will).
    """

    STATE = "state"
    EVENT = "event"
    AVAILABILITY = "availability"


@dataclass(frozen=True, slots=True)
class Address:
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
        """Return where the device speaks on this channel."""
        return f"{ROOT}/{self.site}/{self.kind}/{self.id}/{channel.value}"


def subscription(site: str) -> str:
    """Return the filter that hears every device of a site."""
    return f"{ROOT}/{site}/#"


def listener_topic(site: str) -> str:
    """Return where Housefly itself says whether it listens: "online" retained, "offline" as its
    last will.
    """
    return f"{ROOT}/{site}/listener/availability"


def parse_topic(topic: str) -> tuple[Address, Channel]:
    """Return who speaks and on which channel; raises WireError that names the topic and its scheme."""
    parts = topic.split("/")
    channels = {channel.value: channel for channel in Channel}
    if (
        len(parts) != 5
        or parts[0] != ROOT
        or not SITE.fullmatch(parts[1])
        or not NAME.fullmatch(parts[3])
    ):
        raise WireError(
            f"{shown(topic)} is not of the form {ROOT}/<site>/<kind>/<id>/<{'|'.join(channels)}>"
        )
    if parts[4] not in channels:
        raise WireError(f"{shown(topic)}: unknown channel; allowed: {', '.join(channels)}")
    return Address(parts[1], parts[2], parts[3]), channels[parts[4]]


def shown(topic: str) -> str:
    """Return a topic in printable characters, cut to a line."""
    text = ascii(topic)[1:-1]
    return text if len(text) <= _SHOWN else text[:_SHOWN] + "..."
