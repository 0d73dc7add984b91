from __future__ import annotations

from itertools import product

import pytest

from housefly.messages import OrderKind, Phase
from housefly.pilot.behavior.mission import (
    ORDERS,
    SIGNALS,
    STAY,
    Mission,
    MissionState,
    Response,
    Signal,
)


def test_every_order_has_a_response_in_every_phase() -> None:
    assert set(ORDERS) == set(OrderKind)
    for kind, phase in product(OrderKind, Phase):
        assert isinstance(ORDERS[kind][phase], Response)


def test_every_signal_leads_somewhere_from_every_phase() -> None:
    assert set(SIGNALS) == set(Signal)
    for signal, phase in product(Signal, Phase):
        assert isinstance(SIGNALS[signal][phase], Phase)


@pytest.mark.parametrize("phase", Phase)
def test_land_stop_and_cut_pass_in_every_phase(phase: Phase) -> None:
    assert ORDERS[OrderKind.LAND][phase] is Response.LAND
    assert ORDERS[OrderKind.STOP][phase] is Response.STOP
    assert ORDERS[OrderKind.CUT][phase] is Response.CUT


@pytest.mark.parametrize("phase", Phase)
def test_an_emergency_ends_every_errand(phase: Phase) -> None:
    assert MissionState(phase).after(Signal.EMERGENCY, 1.0).phase is Phase.IDLE


@pytest.mark.parametrize("phase", [phase for phase in Phase if phase is not Phase.IDLE])
def test_a_forced_landing_wins_over_every_flying_phase(phase: Phase) -> None:
    assert MissionState(phase).after(Signal.FORCED_DOWN, 1.0).phase is Phase.LANDING


@pytest.mark.parametrize("signal", Signal)
def test_a_signal_that_changes_nothing_keeps_the_time_of_entry(signal: Signal) -> None:
    for phase in Phase:
        after = MissionState(phase, since=1.0).after(signal, 5.0)
        assert after.since == (1.0 if after.phase is phase else 5.0)


def test_no_signal_but_a_take_off_order_leaves_the_ground() -> None:
    airborne = {Phase.OUTBOUND, Phase.LOOKING, Phase.RETURNING, Phase.TAKING_OFF}
    assert not any(SIGNALS[signal][Phase.IDLE] in airborne for signal in Signal)


def test_only_a_landing_order_or_the_ground_ends_a_landing() -> None:
    for signal in Signal:
        assert SIGNALS[signal][Phase.LANDING] in (Phase.LANDING, Phase.IDLE)


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
