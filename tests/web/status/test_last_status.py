from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.messages import (
    Action,
    Command,
    DroneStatus,
    Inputs,
    Outputs,
    Phase,
    PilotStep,
    Telemetry,
)
from housefly.messages.sensing import AIRBORNE_STATUSES
from housefly.web.status.last_status import LastStatus

DOWN = (DroneStatus.LANDED, DroneStatus.EMERGENCY)
FLOWN = LastStatus().after(
    PilotStep(
        1,
        90.0,
        Inputs((), Telemetry(90.0, DroneStatus.FLYING, 0.8)),
        Outputs(Command(Action.FLY), None, phase=Phase.LOOKING),
    )
)


def step(
    status: DroneStatus | None = None, age: float = 0.03, phase: Phase = Phase.IDLE
) -> PilotStep:
    told = Telemetry(100.0 - age, status, 0.8) if status else None
    return PilotStep(7, 100.0, Inputs((), told), Outputs(Command(Action.IDLE), None, phase=phase))


steps = st.builds(
    step,
    st.one_of(st.none(), st.sampled_from(DroneStatus)),
    st.sampled_from([0.03, 5.0]),
    st.sampled_from(Phase),
)


@given(st.lists(steps, max_size=8))
def test_a_drone_that_flew_is_reckoned_with_until_it_is_freshly_heard_to_stand(
    heard: list[PilotStep],
) -> None:
    word = FLOWN
    for one in heard:
        before, word = word, word.after(one)
        told = one.inputs.telemetry
        stands = told is not None and told.status in DOWN and told.received_at > 99.0
        is_idle = one.outputs.phase is Phase.IDLE
        if before.may_be_airborne and not (stands and is_idle):
            assert word.may_be_airborne
        if stands and is_idle:
            assert not word.may_be_airborne
        assert word.after(one) == word, "the same step again is no news"


@pytest.mark.parametrize("status", [None, DroneStatus.UNKNOWN])
def test_a_pilot_that_knows_nothing_changes_nothing(status: DroneStatus | None) -> None:
    assert FLOWN.after(step(status)) == FLOWN
    assert (FLOWN.at, FLOWN.status, FLOWN.phase) == (90.0, DroneStatus.FLYING, Phase.LOOKING)
    stood = LastStatus().after(step(DroneStatus.LANDED))
    assert stood.after(step(status)) == stood


def test_an_old_word_counts_where_there_is_no_other() -> None:
    old = step(DroneStatus.LANDED, age=5.0)
    assert LastStatus().after(old) == LastStatus(95.0, DroneStatus.LANDED)
    assert FLOWN.after(old).may_be_airborne


def test_a_take_off_that_was_ordered_is_remembered_over_the_end_of_its_pilot() -> None:
    taking_off = step(DroneStatus.LANDED, phase=Phase.TAKING_OFF)
    word = LastStatus().after(taking_off).after(step())
    assert word.may_be_airborne and word.status not in AIRBORNE_STATUSES


def test_of_a_drone_that_nobody_ever_heard_it_is_known_since_when() -> None:
    word = LastStatus().after(step())
    assert word == LastStatus(100.0)
    assert word.after(replace(step(), now=120.0)) == word
