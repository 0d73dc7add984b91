"""Bed on load cells: how heavy is what lies in it, and whether that is somebody."""

from __future__ import annotations

from housefly.messages import Observation
from housefly.wires.devices.fields import Flag, Number, Record
from housefly.wires.devices.kind import DeviceKind, Says

SOMEBODY = 15.0
"""Load from which somebody lies there, where the bed does not say it [kg]."""


def observe(state: Record, says: Says) -> list[Observation]:
    """Return what the bed says of itself."""
    load = state.number("load")
    occupied = state.flag("occupied") if "occupied" in state.values else load >= SOMEBODY
    return [says.itself(("load", load), ("occupied", occupied))]


BED = DeviceKind(
    "bed",
    "Bed",
    {"load": Number(-5.0, 500.0, "kg"), "occupied": Flag(required=False)},
    heartbeat=30.0,
    observe=observe,
    events={"occupied": "bed occupied", "left": "bed left"},
)
