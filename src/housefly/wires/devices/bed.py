"""Bed on load cells: how heavy is what lies in it, and whether that is somebody."""

from __future__ import annotations

from housefly.messages import Observation
from housefly.wires.devices.fields import FlagField, JsonRecord, NumberField
from housefly.wires.devices.kind import DeviceKind, DeviceReport

_OCCUPIED_LOAD = 15.0
"""Load from which somebody lies there, where the bed does not say it [kg]."""


def _observe(state: JsonRecord, says: DeviceReport) -> list[Observation]:
    """Return what the bed says of itself."""
    load = state.number("load")
    occupied = state.flag("occupied") if "occupied" in state.values else load >= _OCCUPIED_LOAD
    return [says.itself(("load", load), ("occupied", occupied))]


BED_KIND = DeviceKind(
    "bed",
    "Bed",
    {"load": NumberField(-5.0, 500.0, "kg"), "occupied": FlagField(required=False)},
    heartbeat=30.0,
    observe=_observe,
    events={"occupied": "bed occupied", "left": "bed left"},
)
