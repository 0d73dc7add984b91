"""Floor sensing: where people and things stand on the floor."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from housefly.messages import Observation
from housefly.wires.devices.fields import IdField, JsonRecord, JsonSpec, NumberField, RowsField
from housefly.wires.devices.kind import DeviceKind, DeviceReport

_DEFAULT_SIGMA = 0.05
"""One-sigma error of a position, unless the sensor gives it [m]."""

_SPOT: JsonSpec = {
    "id": IdField(required=False),
    "x": NumberField(-1000.0, 1000.0, "m"),
    "y": NumberField(-1000.0, 1000.0, "m"),
    "sigma": NumberField(0.001, 10.0, "m", required=False),
    "weight": NumberField(0.0, 500.0, "kg", required=False),
    "extent": NumberField(0.0, 3.0, "m", required=False),
}


def _observe(state: JsonRecord, report: DeviceReport) -> Iterator[Observation]:
    """Yield one observation of the sensor itself, and one per person and thing."""
    yield report.about_device(
        ("people", state.count("people")), ("objects", state.count("objects"))
    )
    for what, key in (("person", "people"), ("object", "objects")):
        for number, spot in enumerate(state.rows(key), start=1):
            yield _seen(spot, report, what, f"{report.source}-{what}-{number}")


def _seen(spot: JsonRecord, report: DeviceReport, what: str, nameless: str) -> Observation:
    thing = report.placement.thing(spot.word("id")) or nameless
    position = report.placement.world(spot.number("x"), spot.number("y"), 0.0)
    weight, extent = spot.number_or_none("weight"), spot.number_or_none("extent")
    seen = report.about(thing, position, ("kind", what), ("weight", weight), ("extent", extent))
    variance = (spot.number_or_none("sigma") or _DEFAULT_SIGMA) ** 2
    return replace(seen, covariance=(variance, 0.0, 0.0, variance, 0.0, variance))


FLOOR_KIND = DeviceKind(
    "floor",
    "Floor sensing",
    {"people": RowsField(_SPOT), "objects": RowsField(_SPOT, required=False)},
    heartbeat=1.0,
    observe=_observe,
)
