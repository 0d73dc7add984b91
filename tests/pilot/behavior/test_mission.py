from __future__ import annotations

import pytest

from housefly.messages import OrderKind, Phase
from housefly.pilot.behavior.mission import STAY, Mission, MissionState


@pytest.mark.parametrize("phase", Phase)
def test_stop_latches_and_gives_up_what_was_under_way_but_a_landing_goes_on(phase: Phase) -> None:
    stopped = MissionState(phase, mission=Mission(OrderKind.GO, "sofa", (1.0, 1.0))).stopping(
        2.0, grounded=False
    )
    assert stopped.stopped and stopped.mission == STAY
    moving = {Phase.OUTBOUND, Phase.LOOKING, Phase.RETURNING}
    assert stopped.phase is (Phase.HOLDING if phase in moving else phase)


def test_stop_before_the_drone_left_the_ground_calls_the_take_off_off() -> None:
    assert MissionState(Phase.TAKING_OFF).stopping(1.0, grounded=True).phase is Phase.IDLE


def test_a_mission_looks_from_where_the_drone_is() -> None:
    assert Mission(look_at=(1.0, 5.0, 1.0)).arrival_yaw((1.0, 1.0)) == pytest.approx(
        1.5708, abs=1e-4
    )
    assert Mission(yaw=0.3).arrival_yaw((9.0, 9.0)) == 0.3
    assert STAY.arrival_yaw((0.0, 0.0)) is None
