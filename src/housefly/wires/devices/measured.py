"""Devices that measure one value: switch, power meter, thermometer, contact, level.

Keys and payloads are those of Zigbee2MQTT: ``state`` "ON" or "OFF", ``power`` in watts,
``temperature`` in degrees Celsius, ``contact`` true when closed.
"""

from __future__ import annotations

from housefly.wires.devices.fields import NumberField, WordField
from housefly.wires.devices.kind import DeviceKind

ON_WORDS = {"on": True, "true": True, "1": True, "off": False, "false": False, "0": False}
"""What a switch may say, in any case; JSON's true and false and the numbers too."""
CLOSED_WORDS = {"true": True, "closed": True, "off": True, "false": False, "open": False,
                "on": False}  # fmt: skip
"""What a contact may say: true is closed as in Zigbee2MQTT, "ON" is open as in Home Assistant."""
_BATTERY_POWERED, _MAINS_POWERED = 300.0, 60.0
"""Heartbeats of devices that sleep between two states, and of those that need not [s]."""

SWITCH_KIND = DeviceKind(
    "switch",
    "Switch",
    {"state": WordField(ON_WORDS, '"ON" or "OFF", true or false')},
    heartbeat=_MAINS_POWERED,
    observe=lambda state, report: [report.about_device(("on", state.flag("state")))],
)
POWER_KIND = DeviceKind(
    "power",
    "Power meter",
    {"power": NumberField(-100_000.0, 100_000.0, "W")},
    heartbeat=_MAINS_POWERED,
    observe=lambda state, report: [report.about_device(("power", state.number("power")))],
)
TEMPERATURE_KIND = DeviceKind(
    "temperature",
    "Thermometer",
    {"temperature": NumberField(-100.0, 1000.0, "degrees Celsius")},
    heartbeat=_BATTERY_POWERED,
    observe=lambda state, report: [
        report.about_device(("temperature_c", state.number("temperature")))
    ],
)
CONTACT_KIND = DeviceKind(
    "contact",
    "Contact",
    {"contact": WordField(CLOSED_WORDS, 'true or "closed", false or "open"')},
    heartbeat=_MAINS_POWERED,
    observe=lambda state, report: [
        report.about_device(("open", not state.flag("contact")), ("kind", "contact"))
    ],
)
LEVEL_KIND = DeviceKind(
    "level",
    "Level sensor",
    {"level": NumberField(0.0, 100.0, "%")},
    heartbeat=_BATTERY_POWERED,
    observe=lambda state, report: [report.about_device(("level_percent", state.number("level")))],
)
MEASURED_KINDS = {
    kind.name: kind
    for kind in (SWITCH_KIND, POWER_KIND, TEMPERATURE_KIND, CONTACT_KIND, LEVEL_KIND)
}
"""The kinds whose state is one value."""


def value_key(kind: str) -> str:
    """Return the key under which a kind has its value: "state", "power" ..."""
    return next(iter(MEASURED_KINDS[kind].state))
