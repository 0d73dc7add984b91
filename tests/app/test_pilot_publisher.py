"""What a pilot decides is told; what cannot be is noted."""

from __future__ import annotations

from housefly.app.pilot_publisher import PilotPublisher
from housefly.bus.local import LocalBus
from housefly.bus.topics import DroneTopics
from housefly.messages import (
    Action,
    Command,
    Inputs,
    Outputs,
    PilotStep,
    PlannedTrajectory,
    TrajectoryPoint,
)
from housefly.pilot.behavior.trajectory_profile import SpacePath

TOPICS = DroneTopics()


def test_what_is_planned_in_space_is_told_when_it_is_new_and_each_second() -> None:
    told: list[PlannedTrajectory] = []
    bus = LocalBus()
    bus.subscribe(TOPICS.trajectory, told.append)
    publisher = PilotPublisher(bus, TOPICS)
    way = ((1.0, 1.0), (2.0, 1.0))
    first = SpacePath(way, 1.0, 0.5, heights=(1.0, 1.2), times=(0.0, 2.0), speeds=(0.0, 0.5))
    other = SpacePath(way[::-1], 1.0, 0.5, heights=(1.0, 1.3), times=(0.0, 2.0), speeds=(0.0, 0.5))
    for number, (now, path) in enumerate(
        [(10.0, None), (10.1, first), (10.2, first), (10.5, other), (11.4, other), (11.6, other)]
    ):
        outputs = Outputs(Command(Action.HOVER), path=path)
        publisher.publish_step(PilotStep(number, now, Inputs(), outputs))
    assert [planned.at for planned in told] == [10.1, 10.5, 11.6]
    assert told[0].points == (
        TrajectoryPoint((1.0, 1.0, 1.0), 0.0, 0.0),
        TrajectoryPoint((2.0, 1.0, 1.2), 2.0, 0.5),
    )
    assert told[1].points[1].position == (1.0, 1.0, 1.3)
