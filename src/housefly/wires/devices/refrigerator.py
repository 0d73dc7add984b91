"""Intelligent refrigerator: what is in it, whether its door is open, how cold it is."""

from __future__ import annotations

from housefly.wires.devices.container import CONTAINED_ITEM, CONTAINED_ITEMS, observe_contents
from housefly.wires.devices.fields import FlagField, IdField, NumberField
from housefly.wires.devices.kind import DeviceKind

REFRIGERATOR_KIND = DeviceKind(
    "refrigerator",
    "Intelligent refrigerator",
    {
        "open": FlagField(),
        "items": CONTAINED_ITEMS,
        "temperature_c": NumberField(-60.0, 60.0, "degrees Celsius", required=False),
    },
    heartbeat=30.0,
    observe=lambda state, report: observe_contents(
        state,
        report,
        ("open", state.flag("open")),
        ("temperature_c", state.number_or_none("temperature_c")),
    ),
    events={
        "opened": "door opened",
        "closed": "door closed",
        "taken": "object taken",
        "put": "object put",
    },
    event={"tag": IdField(required=False), "weight": CONTAINED_ITEM["weight"]},
)
