"""Wishes from ROS at the desk: any text is answered, and nothing flies that may not."""

from __future__ import annotations

from math import inf, nan

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.bus.local import LocalBus
from housefly.bus.topics import HUB_QUERY, TASKS_QUERY, DroneTopics
from housefly.clock import RealClock
from housefly.config.ros2 import RosRequests
from housefly.messages import Order, OrderKind
from housefly.ros2.flight_desk import FlightDesk
from housefly.ros2.order_line import OrderLine
from housefly.ros2.ros_caller import node_caller

OFF, ASK, AUTO = "off", "ask", "auto"


def desk(
    requests: RosRequests, has_tasks: bool = True
) -> tuple[FlightDesk, list[str], list[Order]]:
    """Return a desk, what it asks the tasks, and the orders that it gives."""
    bus, asked, orders = LocalBus(), list[str](), list[Order]()

    def answer(text: str) -> str:
        asked.append(text)
        return '{"error": "busy", "code": "not_ready"}'

    bus.answer(TASKS_QUERY, answer)
    bus.answer(HUB_QUERY, lambda _: '{"things": []}')
    bus.subscribe(DroneTopics().order, orders.append)
    return _desk(bus, requests, has_tasks), asked, orders


def _desk(bus: LocalBus, requests: RosRequests, has_tasks: bool = True) -> FlightDesk:
    clock = RealClock()
    return FlightDesk(
        bus, OrderLine(bus, ("drone",), clock), node_caller(requests), has_tasks, clock
    )


@given(st.tuples(st.sampled_from([nan, inf, -inf, 1.0]), st.sampled_from([nan, inf])))
def test_a_goal_that_is_no_point_flies_nowhere(goal: tuple[float, float]) -> None:
    for requests in ("ask", "auto"):
        answering, asked, orders = desk(requests)  # type: ignore[arg-type]
        assert not answering.fly_to("drone", goal).success
        assert not asked and not orders


@pytest.mark.parametrize("requests", [OFF, ASK])
def test_without_trust_no_order_moves_the_drone_but_stop_land_and_home(
    requests: RosRequests,
) -> None:
    answering, _, orders = desk(requests)
    answering.take_off("drone")
    answering.fly_to("drone", (1.0, 1.0), 0.0)
    assert "auto" in answering.nudge("drone", (0.1, 0.0, 0.0))
    assert not orders
    answering.stop("drone")
    answering.land("drone")
    assert [one.kind for one in orders] == [OrderKind.STOP, OrderKind.LAND]


def test_without_services_nobody_can_be_asked_and_that_is_said() -> None:
    answering, asked, _ = desk("ask", has_tasks=False)
    assert "no services run here" in answering.request("visitor", {}).message
    assert not asked
