"""The room as a rehearsal begins with it: on the ground, in the air, or on the way down."""

from __future__ import annotations

import pytest
from task_flights import premises

from housefly.lab.rehearsal.room_now import RoomNow, room_now
from housefly.messages import (
    Action,
    Command,
    DroneStatus,
    Estimate,
    Inputs,
    Outputs,
    Phase,
    PilotStep,
    Telemetry,
)
from housefly.tasks.execution.live_obstacles import LiveObstacles

THERE = (5.0, 2.0, 1.1)


def seen(status: DroneStatus, phase: Phase) -> RoomNow:
    loaded = premises()
    estimate = Estimate(9.9, THERE, (0.0, 0.0, 0.0), 0.4, 0.02, 0.01)
    inputs = Inputs(telemetry=Telemetry(9.9, status, 0.6))
    outputs = Outputs(Command(Action.FLY), phase=phase, estimate=estimate)
    live = LiveObstacles(loaded.site, loaded.room)
    return room_now(live, PilotStep(1, 9.9, inputs, outputs), 10.0, 1.7e9)


@pytest.mark.parametrize("phase", [Phase.HOLDING, Phase.OUTBOUND, Phase.LOOKING])
def test_a_drone_that_hovers_or_flies_out_is_rehearsed_from_the_air(phase: Phase) -> None:
    now = seen(DroneStatus.FLYING, phase)
    assert (now.drone, now.is_airborne, now.yaw, now.battery) == (THERE, True, 0.4, 0.6)


@pytest.mark.parametrize("phase", [Phase.RETURNING, Phase.LANDING])
def test_a_drone_on_its_way_down_is_rehearsed_from_its_pad(phase: Phase) -> None:
    now = seen(DroneStatus.FLYING, phase)
    assert (now.drone, now.is_airborne) == (None, False)


def test_a_drone_on_the_ground_is_rehearsed_from_where_it_stands() -> None:
    now = seen(DroneStatus.LANDED, Phase.IDLE)
    assert (now.drone, now.is_airborne) == (THERE, False)
