"""What a drone does, in the words of Home Assistant's vacuums."""

from __future__ import annotations

import json

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.homeassistant.drone_state import drone_states, shown_estimate, vacuum_state
from housefly.homeassistant.topics import HomeTopics
from housefly.messages import (
    Action,
    Command,
    DroneStatus,
    Estimate,
    Inputs,
    Outputs,
    Phase,
    PilotStep,
    SafetyMode,
    Telemetry,
)
from housefly.room.model import Place

WORDS = {"docked", "idle", "cleaning", "returning", "paused", "error"}
PAD = (1.0, 1.0)
PLACES = (
    Place("entrance", (6.0, 1.0), (7.0, 1.0, 1.0), "Entrance"),
    Place("home", (1.0, 1.0), (2.0, 1.0, 1.0), "Home"),
)


def estimate(x: float) -> Estimate:
    return Estimate(9.9, (x, 1.0, 0.9), (0.0, 0.0, 0.0), 0.5, 0.02, 0.01)


def step(
    phase: Phase = Phase.IDLE,
    safety: SafetyMode = SafetyMode.NOMINAL,
    x: float = 1.0,
    status: DroneStatus = DroneStatus.FLYING,
) -> PilotStep:
    out = Outputs(Command(Action.HOVER), estimate(x), phase=phase, safety=safety)
    return PilotStep(1, 10.0, Inputs(telemetry=Telemetry(9.9, status, 0.86)), out)


@given(st.sampled_from(Phase), st.sampled_from(SafetyMode), st.floats(-50.0, 50.0))
def test_every_state_of_a_drone_is_one_of_a_vacuum(
    phase: Phase, safety: SafetyMode, x: float
) -> None:
    assert vacuum_state(step(phase, safety, x), PAD) in WORDS


@given(st.sampled_from(SafetyMode), st.floats(-50.0, 50.0))
def test_what_flies_is_never_docked(safety: SafetyMode, x: float) -> None:
    for phase in set(Phase) - {Phase.IDLE}:
        assert vacuum_state(step(phase, safety, x), PAD) not in ("docked", "idle")


@pytest.mark.parametrize(
    ("told", "word"),
    [
        (step(), "docked"),
        (step(x=3.0), "idle"),
        (step(Phase.OUTBOUND), "cleaning"),
        (step(Phase.RETURNING), "returning"),
        (step(Phase.HOLDING), "paused"),
        (step(Phase.OUTBOUND, SafetyMode.STOPPED), "paused"),
        (step(Phase.OUTBOUND, SafetyMode.RETURN), "returning"),
        (step(Phase.OUTBOUND, SafetyMode.LAND), "error"),
        (step(status=DroneStatus.EMERGENCY), "error"),
    ],
)
def test_the_word_is_what_a_person_would_say(told: PilotStep, word: str) -> None:
    assert vacuum_state(told, PAD) == word


def test_place_and_battery_are_told_and_a_pilot_that_is_gone_is_not_there() -> None:
    topics = HomeTopics("home")
    found = drone_states("drone", step(x=6.5), estimate(6.5), PAD, PLACES, topics, is_heard=True)
    assert found[topics.state("drone-drone-place")] == b"Entrance"
    assert found[topics.state("drone-drone-battery")] == b"86"
    assert json.loads(found[topics.attributes("drone-drone-place")])["x"] == 6.5
    at_home = drone_states("drone", step(), estimate(1.0), PAD, PLACES, topics, is_heard=False)
    assert at_home[topics.state("drone-drone-place")] == b"pad", "home means the house there"
    assert at_home[topics.part_availability("drone-drone")] == b"offline"
    assert drone_states("drone", None, None, PAD, PLACES, topics, is_heard=False) == {
        topics.part_availability("drone-drone"): b"offline"
    }


@given(st.lists(st.floats(-0.04, 0.04), min_size=1, max_size=50))
def test_noise_of_who_stands_still_is_no_news(noise: list[float]) -> None:
    shown = first = shown_estimate(None, step(x=1.05))
    for error in noise:
        shown = shown_estimate(shown, step(x=1.05 + error))
    assert shown is first
    moved = shown_estimate(shown, step(x=1.2))
    assert moved is not None and moved.position[0] == 1.2
