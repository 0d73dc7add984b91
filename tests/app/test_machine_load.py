"""Load is measured, and named as the likely cause of what comes late."""

from __future__ import annotations

from dataclasses import replace

import pytest

from housefly.app.machine_load import MachineLoad, machine_load, measured_lateness
from housefly.config.limits import LimitsConfig
from housefly.messages import DroneStatus
from housefly.messages.preflight import PreflightCheck
from housefly.pilot.behavior.mission import PeopleSilence, VehicleStatus
from housefly.pilot.behavior.preflight import PREFLIGHT_RULES, PreflightInputs, preflight_refusal


@pytest.mark.parametrize(
    ("load", "is_too_high"),
    [
        (MachineLoad(2), False),
        (MachineLoad(2, running=2.5, waiting=0.97), False),
        (MachineLoad(2, running=3.2, waiting=0.95), True),
        (MachineLoad(2, running=15.4, waiting=0.0), True),
        (MachineLoad(16, running=15.4, waiting=0.95), False),
        (MachineLoad(64, lateness=0.2), True),
    ],
)
def test_a_machine_is_overloaded_when_programs_wait_or_a_loop_comes_late(
    load: MachineLoad, is_too_high: bool
) -> None:
    assert load.is_too_high is is_too_high
    assert load.check().passed is not is_too_high and not load.check().required
    assert bool(load.note) is is_too_high


def test_this_machine_has_a_load() -> None:
    load = machine_load(lateness=0.15)
    assert load.cores >= 1 and load.running >= 0.0 and 0.0 <= load.waiting <= 1.0
    assert load.note == "this computer is too busy" and "150 ms late" in load.words
    assert 0.0 <= measured_lateness() < 5.0


def words(checks: tuple[PreflightCheck, ...]) -> str:
    refused = preflight_refusal(checks)
    assert refused is not None
    return refused.reason


def test_the_likely_cause_is_named_where_something_is_late_and_only_there() -> None:
    silence = PeopleSilence(age=57.04)
    vehicle = VehicleStatus(0.0, DroneStatus.LANDED, 1.0, 0.0, None, False, silence=silence)
    rules = {rule.code: rule for rule in PREFLIGHT_RULES}
    late = rules["sees_people"].check(PreflightInputs(vehicle, LimitsConfig()))
    low = replace(late, code="charge", mend="charge it")
    busy, idle = (MachineLoad(2, running).check() for running in (15.4, 0.3))
    assert words((late, idle)).endswith(
        "see `housefly sensors`: is each one on, in this network and uncovered?"
    )
    named = words((late, busy))
    assert "nothing usable for 57 s" in named
    assert "likely cause: this computer is too busy (load 15 on 2 cores)" in named
    assert words((low, busy)).endswith("charge it")
    assert preflight_refusal((busy,)) is None, "load alone forbids nothing"
