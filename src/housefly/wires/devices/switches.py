"""Devices with one contact or none: door contact, doorbell, motion detector."""

from __future__ import annotations

from housefly.wires.devices.fields import FlagField
from housefly.wires.devices.kind import DeviceKind

DOOR_KIND = DeviceKind(
    "door",
    "Door contact",
    {"open": FlagField()},
    heartbeat=60.0,
    observe=lambda state, report: [report.about_device(("open", state.flag("open")))],
    events={"opened": "door opened", "closed": "door closed"},
)
DOORBELL_KIND = DeviceKind(
    "doorbell",
    "Doorbell",
    {},
    heartbeat=60.0,
    observe=lambda state, report: [report.about_device()],
    events={"pressed": "bell pressed"},
)
MOTION_KIND = DeviceKind(
    "motion",
    "Motion detector",
    {"motion": FlagField()},
    heartbeat=60.0,
    observe=lambda state, report: [report.about_device(("motion", state.flag("motion")))],
    events={"motion": "motion seen"},
)
