"""Small devices over MQTT: topics and JSON that a microcontroller can send; pure codec."""

from housefly.wires.devices.codec import (
    KINDS,
    MAX_DEVICE_PAYLOAD,
    ClockBounds,
    Delivered,
    Reading,
    decode_reading,
    device_kind,
    encode_payload,
)
from housefly.wires.devices.kind import DeviceKind, Placement
from housefly.wires.devices.measured_topic import MeasuredTopic
from housefly.wires.devices.topics import (
    Channel,
    DeviceAddress,
    listener_topic,
    parse_topic,
    printable_topic,
    site_subscription,
    task_topic,
)

__all__ = [
    "KINDS",
    "MAX_DEVICE_PAYLOAD",
    "Channel",
    "ClockBounds",
    "Delivered",
    "DeviceAddress",
    "DeviceKind",
    "MeasuredTopic",
    "Placement",
    "Reading",
    "decode_reading",
    "device_kind",
    "encode_payload",
    "listener_topic",
    "parse_topic",
    "printable_topic",
    "site_subscription",
    "task_topic",
]
