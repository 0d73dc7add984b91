"""Small devices over MQTT: topics and JSON that a maker's microcontroller can send; pure codec,
both sides of the wire.
"""

from housefly.wires.devices.codec import (
    KINDS,
    LARGEST,
    ClockBounds,
    Delivered,
    Reading,
    decode,
    encode,
    kind_of,
)
from housefly.wires.devices.kind import DeviceKind, Placement
from housefly.wires.devices.topics import (
    Address,
    Channel,
    listener_topic,
    parse_topic,
    shown,
    subscription,
)

__all__ = [
    "KINDS",
    "LARGEST",
    "Address",
    "Channel",
    "ClockBounds",
    "Delivered",
    "DeviceKind",
    "Placement",
    "Reading",
    "decode",
    "encode",
    "kind_of",
    "listener_topic",
    "parse_topic",
    "shown",
    "subscription",
]
