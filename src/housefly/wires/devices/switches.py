"""Devices with one contact or none: door contact, doorbell, motion detector."""

from __future__ import annotations

from housefly.wires.devices.fields import Flag
from housefly.wires.devices.kind import DeviceKind

DOOR = DeviceKind(
    "door",
    "Door contact",
    {"open": Flag()},
    heartbeat=60.0,
    observe=lambda state, says: [says.itself(("open", state.flag("open")))],
    events={"opened": "door opened", "closed": "door closed"},
)
DOORBELL = DeviceKind(
    "doorbell",
    "Doorbell",
    {},
    heartbeat=60.0,
    observe=lambda state, says: [says.itself()],
    events={"pressed": "bell pressed"},
)
MOTION = DeviceKind(
    "motion",
    "Motion detector",
    {"motion": Flag()},
    heartbeat=60.0,
    observe=lambda state, says: [says.itself(("motion", state.flag("motion")))],
    events={"motion": "motion seen"},
)
