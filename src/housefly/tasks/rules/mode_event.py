"""The event that tells that the mode of the house was changed."""

from __future__ import annotations

from housefly.config.house_mode import HouseMode
from housefly.hub.api.told_events import TOLD_EVENT_SOURCE
from housefly.messages import RoomEvent

MODE_CHANGED = "mode changed"
_THING = "house"


def mode_event(mode: HouseMode, before: HouseMode, by: str, at: float) -> RoomEvent:
    """Return the event of a change at a time [Unix time, s]."""
    facts = (("mode", mode.value), ("before", before.value))
    return RoomEvent(MODE_CHANGED, _THING, at, TOLD_EVENT_SOURCE, by, facts=facts)


def mode_after(event: RoomEvent) -> HouseMode | None:
    """Return the mode that an event began, None if it began none."""
    return _mode(event, "mode")


def mode_before(event: RoomEvent) -> HouseMode | None:
    """Return the mode that an event ended, None if it ended none."""
    return _mode(event, "before")


def _mode(event: RoomEvent, name: str) -> HouseMode | None:
    # A device may call an event so; only the tasks know the mode.
    if event.kind != MODE_CHANGED or event.source != TOLD_EVENT_SOURCE:
        return None
    value = dict(event.facts).get(name)
    return next((mode for mode in HouseMode if mode.value == value), None)
