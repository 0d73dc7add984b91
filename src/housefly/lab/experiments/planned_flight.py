"""From two places in a room to a flight plan: the way that the live pilot would plan and fly."""

from __future__ import annotations

from dataclasses import replace

from housefly.geometry import Vec2, Vec3
from housefly.lab.experiments.flight_plan import SETTLE, FlightPlan, Task
from housefly.messages.flight import OrderKind, OrderOutcome
from housefly.messages.sensing import Estimate
from housefly.pilot.behavior.mission import UNHEARD, Mission, Refused, TrackingTask
from housefly.pilot.behavior.navigator import Navigator
from housefly.pilot.behavior.way_planner import NOWHERE_TO_GO, planned_task


def planned_flight(
    navigator: Navigator,
    start: Vec3,
    yaw: float,
    goal: Vec2,
    duration: float,
    task: Task = Task.PATH,
    settle: float = SETTLE,
) -> FlightPlan | Refused:
    """Return the flight from a place to a goal, or why there is none.

    Args:
        navigator: knows the room; corners or a trajectory are its choice.
        start: where the drone stands in the air [m].
        yaw: its heading [rad].
        goal: [m].
        duration: of the flight, ``settle`` included [s].
        task: how the reference moves.
        settle: how long the drone hovers before [s].
    """
    standing = Estimate(0.0, start, (0.0, 0.0, 0.0), yaw, pose_age=0.0, position_std=0.0)
    vehicle = replace(UNHEARD, estimate=standing)
    planned = planned_task(
        navigator, Mission(OrderKind.GO, goal=goal), TrackingTask(), vehicle, coast_time=0.0
    )
    if planned is None or isinstance(planned, Refused):
        return planned or Refused(OrderOutcome.NO_WAY, NOWHERE_TO_GO)
    assert planned.path is not None
    return FlightPlan(
        task=task,
        waypoints=planned.path.waypoints,
        duration=duration,
        height=start[2],
        yaw=yaw,
        settle=settle,
        trajectory=planned.profile if navigator.in_space else None,
    )
