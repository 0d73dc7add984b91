"""What cabinets and refrigerators share: tagged things inside them, weighed where they stand."""

from __future__ import annotations

from collections.abc import Iterator

from housefly.messages import Fact, Observation
from housefly.wires.devices.fields import Name, Number, Record, Rows, Spec
from housefly.wires.devices.kind import Says

ITEM: Spec = {
    "tag": Name(),
    "weight": Number(0.0, 200.0, "kg", required=False),
    "shelf": Number(0, 50, "(number of the shelf)", required=False),
    "x": Number(-10.0, 10.0, "m", required=False),
    "y": Number(-10.0, 10.0, "m", required=False),
    "z": Number(-10.0, 10.0, "m", required=False),
}
ITEMS = Rows(ITEM)
MOVED: Spec = {"tag": Name(), "weight": Number(0.0, 200.0, "kg", required=False)}
"""Keys of the events "taken" and "put"."""


def contents(state: Record, says: Says, *facts: tuple[str, Fact | None]) -> Iterator[Observation]:
    """Yield what the container says of itself, with all that is in it, and one observation for each
    thing in it.
    """
    items = state.rows("items")
    named = ",".join(sorted(says.placement.thing(item.word("tag")) for item in items))
    yield says.itself(*facts, ("contents", named))
    for item in items:
        x, y, z = (item.number_or_none(axis) for axis in "xyz")
        position = says.placement.world(x, y, z or 0.0) if x is not None and y is not None else None
        weighed = ("weight", item.number_or_none("weight")), ("shelf", item.number_or_none("shelf"))
        yield says.of(
            says.placement.thing(item.word("tag")), position, *weighed, inside=says.source
        )
