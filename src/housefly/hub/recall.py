"""What the store knows of the way of carried things and of who lay down, for beliefs made anew."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from housefly.geometry import Vec3
from housefly.hub.situations.kinds import SituationKind
from housefly.hub.store.store import Store
from housefly.hub.things.beliefs import Beliefs
from housefly.hub.things.world_model import WorldModel

_LONGEST_WAY = 7200.0
"""Of a longer way only the end is read [s]; before that the carrier counts as out of sight."""
_EVERY = 0.3
"""Time between two positions of a way [s]."""
_BEFORE = 60.0
"""The way is read from so long before [s]: who stood still then is kept from when they stopped."""
_STILL_EVERY = 1.0
"""The same while the carrier stands still [s]."""
_LONGEST_REST = 86_400.0
"""Who lay down longer ago is up again [s]."""


def recall(beliefs: Beliefs, world: WorldModel, store: Store, at: float) -> None:
    """Feed beliefs with what was kept up to a time [s, Unix time].

    Args:
        beliefs: that have seen the last observation of each source.
        world: of that time.
        store: where the ways are.
        at: the time.
    """
    for thing, carrying in tuple(beliefs.carried().items()):
        since = max(carrying.since, at - _LONGEST_WAY) - _BEFORE
        way = store.trajectory(carrying.carrier, since, at, every=_EVERY).tolist()
        beliefs.retrace(world, thing, _filled(way))
    rests = [
        event
        for kind in (SituationKind.PERSON_LYING, SituationKind.PERSON_LYING.ended)
        for event in store.events(at - _LONGEST_REST, at, kind=kind)
    ]
    for event in sorted(rests, key=lambda rest: rest.at):
        beliefs.note(event)


def _filled(way: Sequence[Sequence[float]]) -> Iterator[tuple[float, Vec3]]:
    """Yield times and places; who stood still is kept as begin and end, and was seen in between."""
    last, stood = float("-inf"), None
    for at, x, y, z in way:
        place = x, y, z
        while place == stood and at - last > _STILL_EVERY:
            last += _STILL_EVERY
            yield last, place
        last, stood = at, place
        yield at, place
