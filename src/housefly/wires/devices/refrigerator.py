"""Intelligent refrigerator: what is in it, whether its door is open, how cold it is."""

from __future__ import annotations

from housefly.wires.devices.contents import ITEM, ITEMS, contents
from housefly.wires.devices.fields import Flag, Name, Number
from housefly.wires.devices.kind import DeviceKind

REFRIGERATOR = DeviceKind(
    "refrigerator",
    "Intelligent refrigerator",
    {
        "open": Flag(),
        "items": ITEMS,
        "temperature_c": Number(-60.0, 60.0, "degrees Celsius", required=False),
    },
    heartbeat=30.0,
    observe=lambda state, says: contents(
        state,
        says,
        ("open", state.flag("open")),
        ("temperature_c", state.number_or_none("temperature_c")),
    ),
    events={
        "opened": "door opened",
        "closed": "door closed",
        "taken": "object taken",
        "put": "object put",
    },
    event={"tag": Name(required=False), "weight": ITEM["weight"]},
)
