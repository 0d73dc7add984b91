"""What cabinets and refrigerators share: tagged things inside them, weighed where they stand."""

from __future__ import annotations

from collections.abc import Iterator

from housefly.messages import Fact, Observation
from housefly.wires.devices.fields import IdField, JsonRecord, JsonSpec, NumberField, RowsField
from housefly.wires.devices.kind import DeviceReport

CONTAINED_ITEM: JsonSpec = {
    "tag": IdField(),
    "weight": NumberField(0.0, 200.0, "kg", required=False),
    "shelf": NumberField(0, 50, "(number of the shelf)", required=False),
    "x": NumberField(-10.0, 10.0, "m", required=False),
    "y": NumberField(-10.0, 10.0, "m", required=False),
    "z": NumberField(-10.0, 10.0, "m", required=False),
}
CONTAINED_ITEMS = RowsField(CONTAINED_ITEM)
TAKEN_OR_PUT: JsonSpec = {"tag": IdField(), "weight": NumberField(0.0, 200.0, "kg", required=False)}
"""Keys of the events "taken" and "put"."""


def observe_contents(
    state: JsonRecord, report: DeviceReport, *facts: tuple[str, Fact | None]
) -> Iterator[Observation]:
    """Yield one observation of the container with all its contents, and one per thing in it.

    Where one thing was not understood, the others are there, and no list claims to be complete.
    """
    items = state.rows("items")
    named = ",".join(sorted(report.placement.thing(item.word("tag")) for item in items))
    all_named = None if "items" in state.incomplete else named
    yield report.about_device(*facts, ("contents", all_named))
    for item in items:
        x, y, z = (item.number_or_none(axis) for axis in "xyz")
        position = (
            report.placement.world(x, y, z or 0.0) if x is not None and y is not None else None
        )
        weighed = ("weight", item.number_or_none("weight")), ("shelf", item.number_or_none("shelf"))
        yield report.about(
            report.placement.thing(item.word("tag")), position, *weighed, inside=report.source
        )
