from __future__ import annotations

from itertools import product

import pytest

from housefly.messages import OrderKind, Phase
from housefly.pilot.behavior.mission_tables import ORDERS, SIGNALS, Response, Signal


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
