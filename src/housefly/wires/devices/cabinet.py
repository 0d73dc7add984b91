"""Intelligent cabinet: RFID antennas say which thing is in it, load cells where and how heavy."""

from __future__ import annotations

from housefly.wires.devices.contents import ITEMS, MOVED, contents
from housefly.wires.devices.fields import Flag, Number, Record
from housefly.wires.devices.kind import DeviceKind

CABINET = DeviceKind(
    "cabinet",
    "Intelligent cabinet",
    {
        "items": ITEMS,
        "load": Number(0.0, 500.0, "kg", required=False),
        "open": Flag(required=False),
    },
    heartbeat=30.0,
    observe=lambda state, says: contents(
        state, says, ("load", state.number_or_none("load")), ("open", opened(state))
    ),
    events={"taken": "object taken", "put": "object put"},
    event=MOVED,
)


def opened(state: Record) -> bool | None:
    """Return whether a door stands open, None when the device has no contact there."""
    return state.flag("open") if "open" in state.values else None
