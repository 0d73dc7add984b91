from __future__ import annotations

from collections.abc import Callable
from typing import Any

from housefly.messages import OrderKind, Phase


def test_a_drone_too_close_to_a_wall_leaves_by_the_shortest_line_and_one_off_the_map_is_refused(
    fly: Callable[..., Any],
) -> None:
    flight = fly(map__planner="grid")
    flight.origin_known = True
    flight.body = flight.body._replace(y=0.3)
    assert not flight.grid.is_free(flight.grid.cell_of((flight.body.x, flight.body.y)))
    flight.run(0.5)
    outputs = flight.step(flight.order(OrderKind.GO, place="entrance"))
    assert outputs.phase is Phase.TAKING_OFF and outputs.path is not None
    first, second = outputs.path.waypoints[:2]
    assert abs(first[1] - 0.3) < 0.02 and flight.grid.is_free(flight.grid.cell_of(second))

    answer = flight.pilot.plan((10.75, 1.25), (-3.0, -3.0))
    assert answer.path is None and "outside the map" in answer.reason
