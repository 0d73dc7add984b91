"""Devices that measure one value: switch, power meter, thermometer, contact, level.

Keys and payloads are those of Zigbee2MQTT: ``state`` "ON" or "OFF", ``power`` in watts,
``temperature`` in degrees Celsius, ``contact`` true when closed.
"""

from __future__ import annotations

from housefly.wires.devices.fields import NumberField, WordField
from housefly.wires.devices.kind import DeviceKind
from housefly.wires.devices.words import ON_WORDS, OPEN_WORDS

_BATTERY_POWERED, _MAINS_POWERED = 300.0, 60.0
"""Heartbeats of devices that sleep between two states, and of those that need not [s]."""


def _meter(name: str, title: str, field: NumberField, fact: str, heartbeat: float) -> DeviceKind:
    """Return a kind that measures a number, under its own name in the payload."""
    return DeviceKind(
        name,
        title,
        {name: field},
        heartbeat=heartbeat,
        observe=lambda state, report: [report.about_device((fact, state.number(name)))],
    )


MEASURED_WORDS = {"switch": ON_WORDS, "contact": OPEN_WORDS}
"""What the kinds without a number may say, and whether that is on or open."""
MEASURED_ALLOWED = {
    "switch": '"ON" or "OFF", true or false',
    "contact": 'true or "closed", false or "open"',
}
_WATTS = NumberField(-100_000.0, 100_000.0, "W")
_CELSIUS = NumberField(-100.0, 1000.0, "degrees Celsius")
_KINDS = (
    DeviceKind(
        "switch",
        "Switch",
        {"state": WordField(ON_WORDS, MEASURED_ALLOWED["switch"])},
        heartbeat=_MAINS_POWERED,
        observe=lambda state, report: [report.about_device(("on", state.flag("state")))],
    ),
    _meter("power", "Power meter", _WATTS, "power", _MAINS_POWERED),
    _meter("temperature", "Thermometer", _CELSIUS, "temperature_c", _BATTERY_POWERED),
    DeviceKind(
        "contact",
        "Contact",
        {"contact": WordField(OPEN_WORDS, MEASURED_ALLOWED["contact"])},
        heartbeat=_MAINS_POWERED,
        observe=lambda state, report: [
            report.about_device(("open", state.flag("contact")), ("kind", "contact"))
        ],
    ),
    _meter(
        "level", "Level sensor", NumberField(0.0, 100.0, "%"), "level_percent", _BATTERY_POWERED
    ),
)
MEASURED_KINDS = {kind.name: kind for kind in _KINDS}
"""The kinds whose state is one value."""


def value_key(kind: str) -> str:
    """Return the key under which a kind has its value: "state", "power" ..."""
    return next(iter(MEASURED_KINDS[kind].state))
