from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from housefly.config.airframe import airframe_named
from housefly.config.limits import LimitsConfig
from housefly.messages import Phase
from housefly.pilot.behavior.commander import Commander
from housefly.pilot.behavior.mission import Mission, MissionState
from housefly.pilot.behavior.mission_tables import Signal


def applied(state: MissionState, signal: Signal, now: float) -> MissionState:
    """Return the state of a commander after a signal, which needs no map."""
    nowhere: Any = SimpleNamespace(home=lambda: Mission(goal=(0.0, 0.0)))
    commander = Commander(LimitsConfig(), nowhere, airframe_named("ardrone"))
    commander._state = state
    assert commander.apply(signal, now) == (commander.state.phase is not state.phase)
    return commander.state


@pytest.mark.parametrize("phase", Phase)
def test_an_emergency_ends_every_mission(phase: Phase) -> None:
    assert applied(MissionState(phase), Signal.EMERGENCY, 1.0).phase is Phase.IDLE


@pytest.mark.parametrize("phase", [phase for phase in Phase if phase is not Phase.IDLE])
def test_a_forced_landing_wins_over_every_flying_phase(phase: Phase) -> None:
    assert applied(MissionState(phase), Signal.FORCED_DOWN, 1.0).phase is Phase.LANDING


@pytest.mark.parametrize("signal", Signal)
def test_a_signal_that_changes_nothing_keeps_the_time_of_entry(signal: Signal) -> None:
    for phase in Phase:
        after = applied(MissionState(phase, since=1.0), signal, 5.0)
        assert after.since == (1.0 if after.phase is phase else 5.0)
