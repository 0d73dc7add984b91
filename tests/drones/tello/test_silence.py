"""What leaves for a Tello once its pilot is silent, line by line, on a stepped clock."""

from __future__ import annotations

import pytest

from housefly.config.airframe import airframe_named
from housefly.drones.failsafe import HOVER_AFTER, LAND_AFTER, Failsafe
from housefly.drones.tello.talk import Talk
from housefly.messages import Action, DroneStatus, Telemetry, VelocitySetpoint
from housefly.messages.steering import Command, flying
from housefly.wires.tello.conversions import full_sticks_of
from housefly.wires.tello.lines import Line, Sticks, Word

AIRFRAME = airframe_named("tello")
FLYING = DroneStatus.FLYING
SILENT_AT = 5.0


def lines_after(silence_s: float, *, is_gone: bool = False) -> list[tuple[float, Line]]:
    """Return what leaves, and how long after the pilot's last command [s]."""
    failsafe = Failsafe(0.0, 0.2, AIRFRAME)
    talk = Talk(full_sticks_of(AIRFRAME.response))
    talk.sdk = "20"
    period, now, said = AIRFRAME.link.repeat_after, 0.0, []

    def turn(status: DroneStatus) -> None:
        report = Telemetry(now, status, 0.8, height=1.0)
        told = failsafe.decide(now, report)
        due = talk.lines(told, status, now, state_age=0.05, wants_pictures=False)
        said.extend((now - SILENT_AT, line) for line in due)

    turn(DroneStatus.LANDED)
    while now < SILENT_AT:
        now = min(now + period, SILENT_AT)
        failsafe.update(flying(VelocitySetpoint(forward=0.75)), now)
        turn(FLYING)
    if is_gone:
        failsafe.abandon()
    while now < SILENT_AT + silence_s:
        now += period
        turn(FLYING)
    return [(at, line) for at, line in said if at > 0.0]


def test_a_silent_pilot_means_centred_sticks_and_then_a_landing() -> None:
    lines = lines_after(4.0)
    ahead = [at for at, line in lines if line == Sticks(ahead=50)]
    centred = [at for at, line in lines if line == Sticks()]
    land = [at for at, line in lines if line is Word.LAND]
    assert max(ahead) <= HOVER_AFTER
    assert HOVER_AFTER < min(centred) < HOVER_AFTER + 0.05
    assert LAND_AFTER < min(land) < LAND_AFTER + 0.05
    assert max(centred) < min(land), "no stick disturbs the landing"
    assert len(land) == 4, "it is said again twice a second"


def test_a_pilot_that_is_gone_is_not_waited_for() -> None:
    lines = lines_after(3.0, is_gone=True)
    assert lines[0][1] == Sticks()
    assert Sticks(ahead=50) not in {line for _, line in lines}
    assert min(at for at, line in lines if line is Word.LAND) < LAND_AFTER + 0.05


@pytest.mark.parametrize("action", [Action.HOVER, Action.LAND, Action.CUT])
def test_every_order_that_stops_it_leaves_with_the_next_turn(action: Action) -> None:
    failsafe, talk = Failsafe(0.0, 0.2, AIRFRAME), Talk(full_sticks_of(AIRFRAME.response))
    failsafe.update(Command(action), 0.0)
    told = failsafe.decide(0.0, Telemetry(0.0, FLYING, 0.8))
    due = talk.lines(told, FLYING, 0.0, state_age=0.05, wants_pictures=False)
    wanted = {Action.HOVER: Sticks(), Action.LAND: Word.LAND, Action.CUT: Word.EMERGENCY}
    assert due[0] == wanted[action]
