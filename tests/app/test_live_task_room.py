"""The room as a flying task sees it: whom only a scanner sees can be flown to as well."""

from __future__ import annotations

import pytest
from task_flights import premises

from housefly.app.live_obstacles import LiveObstacles
from housefly.app.live_task_room import LiveTaskRoom
from housefly.bus.local import LocalBus
from housefly.errors import TaskError
from housefly.geometry import distance
from housefly.messages import Obstacle, ObstacleKind


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
