"""Intelligent cabinet: RFID antennas say which thing is in it, load cells where and how heavy."""

from __future__ import annotations

from housefly.wires.devices.container import CONTAINED_ITEMS, TAKEN_OR_PUT, observe_contents
from housefly.wires.devices.fields import FlagField, NumberField
from housefly.wires.devices.kind import DeviceKind

CABINET_KIND = DeviceKind(
    "cabinet",
    "Intelligent cabinet",
    {
        "items": CONTAINED_ITEMS,
        "load": NumberField(0.0, 500.0, "kg", required=False),
        "open": FlagField(required=False),
    },
    heartbeat=30.0,
    observe=lambda state, report: observe_contents(
        state, report, ("load", state.number_or_none("load")), ("open", state.flag("open"))
    ),
    events={"taken": "object taken", "put": "object put"},
    event=TAKEN_OR_PUT,
)
