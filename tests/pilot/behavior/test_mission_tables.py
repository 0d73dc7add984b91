from __future__ import annotations

from itertools import product
from math import isfinite

import pytest

from housefly.config.limits import LimitsConfig
from housefly.messages import OrderKind, Phase
from housefly.pilot.behavior.mission import MissionState, TrackingTask
from housefly.pilot.behavior.mission_signals import allowed_time
from housefly.pilot.behavior.mission_tables import ORDERS, SIGNALS, Response, Signal

LIMITS = LimitsConfig()


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


def test_no_signal_but_a_take_off_order_leaves_the_ground() -> None:
    airborne = {Phase.OUTBOUND, Phase.LOOKING, Phase.RETURNING, Phase.TAKING_OFF}
    assert not any(SIGNALS[signal][Phase.IDLE] in airborne for signal in Signal)


def test_only_a_landing_order_or_the_ground_ends_a_landing() -> None:
    for signal in Signal:
        assert SIGNALS[signal][Phase.LANDING] in (Phase.LANDING, Phase.IDLE)


def test_the_tables_are_total() -> None:
    orders = [ORDERS[kind][phase] for kind, phase in product(OrderKind, Phase)]
    targets = [SIGNALS[signal][phase] for signal, phase in product(Signal, Phase)]
    assert len(orders) == len(OrderKind) * len(Phase) == sum(map(len, ORDERS.values()))
    assert len(targets) == len(Signal) * len(Phase) == sum(map(len, SIGNALS.values()))


def test_every_phase_in_the_air_ends_by_itself_in_a_landing() -> None:
    for phase in set(Phase) - {Phase.IDLE, Phase.LANDING}:
        assert isfinite(allowed_time(MissionState(phase), TrackingTask(duration=20.0), LIMITS))
        steps = 0
        while phase is not Phase.LANDING:
            phase, steps = SIGNALS[Signal.OVERDUE][phase], steps + 1
            assert steps < len(Phase)


def test_a_return_leads_home_from_wherever_the_drone_flies() -> None:
    row = SIGNALS[Signal.RETURN_WANTED]
    flying = (Phase.OUTBOUND, Phase.LOOKING, Phase.HOLDING, Phase.RETURNING)
    assert {row[phase] for phase in flying} == {Phase.RETURNING}
    assert row[Phase.TAKING_OFF] is row[Phase.LANDING] is Phase.LANDING
    assert row[Phase.IDLE] is Phase.IDLE
