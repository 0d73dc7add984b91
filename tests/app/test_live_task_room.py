"""The room as a flying task sees it, and its memory as a flying task and a person ask it."""

from __future__ import annotations

import pytest
from task_flights import premises

from housefly.app.live_task_room import LiveTaskRoom
from housefly.bus.local import LocalBus
from housefly.bus.topics import HUB_QUERY
from housefly.errors import LinkError, TaskError, ThingError
from housefly.geometry import distance
from housefly.hub.api.json import refusal_to_json
from housefly.hub.api.questions import SensorsQuestion
from housefly.messages import Obstacle, ObstacleKind
from housefly.tasks.execution.live_obstacles import LiveObstacles


def test_somebody_whom_only_a_scanner_sees_has_a_viewpoint() -> None:
    loaded = premises()
    live = LiveObstacles(loaded.site, loaded.room)
    room = LiveTaskRoom(loaded, LocalBus(), live, lambda: 10.0)
    live.heard_obstacle(
        Obstacle("7", (8.6, 3.6), 0.3, seen_at=9.8, source="laser-1", kind=ObstacleKind.PERSON)
    )
    (who,) = room.people()
    view = room.viewpoint(who.id)
    assert view.look_at[:2] == pytest.approx((8.6, 3.6))
    assert distance(view.position, (8.6, 3.6)) > 0.8
    with pytest.raises(TaskError):
        room.viewpoint("laser-1/8")


def test_a_memory_that_was_too_slow_for_a_flight_is_still_asked_for_a_person() -> None:
    loaded, bus = premises(), LocalBus()
    room = LiveTaskRoom(loaded, bus, LiveObstacles(loaded.site, loaded.room), lambda: 10.0)
    with pytest.raises(LinkError):
        room.ask(SensorsQuestion())
    bus.answer(HUB_QUERY, lambda _: refusal_to_json(ThingError("it is back")))
    with pytest.raises(LinkError, match="does not answer"):
        room.ask(SensorsQuestion())
    with pytest.raises(ThingError, match="it is back"):
        room.ask(SensorsQuestion(), patience=5.0)
