"""Bed on load cells: the load, and whether somebody lies in it."""

from __future__ import annotations

from housefly.messages import Observation
from housefly.wires.devices.fields import FlagField, JsonRecord, NumberField
from housefly.wires.devices.kind import DeviceKind, DeviceReport

_OCCUPIED_LOAD = 15.0
"""Load that counts as occupied, unless the bed says so itself [kg]."""


def _observe(state: JsonRecord, report: DeviceReport) -> list[Observation]:
    """Return the bed's observation."""
    load, occupied = state.number_or_none("load"), state.flag("occupied")
    if occupied is None and load is not None:
        occupied = load >= _OCCUPIED_LOAD
    return [report.about_device(("load", load), ("occupied", occupied))]


BED_KIND = DeviceKind(
    "bed",
    "Bed",
    {"load": NumberField(-5.0, 500.0, "kg"), "occupied": FlagField(required=False)},
    heartbeat=30.0,
    observe=_observe,
    events={"occupied": "bed occupied", "left": "bed left"},
)
