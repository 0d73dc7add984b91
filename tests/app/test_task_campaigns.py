"""Many flights of services: seeded visitor runs, cancel and pause at random moments."""

from __future__ import annotations

import random

import pytest
from task_flights import flown

from housefly.evidence.clip_values import StartClip
from housefly.lab.lockstep.task_flight import TaskFlight, TaskScript
from housefly.tasks.api.values import ReasonCode, TaskStage
from housefly.tasks.execution.values import StopClip
from scores.visitor_score import score_visitor

RUNS = 100
MOMENTS = 50
LAST_MOMENT = 55.0
"""By then a visitor flight is over [s]."""


def ended_well(flight: TaskFlight) -> bool:
    """Return whether the end is defined: a reason, the pad, nothing touched, no clip left open."""
    closed = len(flight.actions_of(StartClip)) == len(flight.actions_of(StopClip))
    ends = {
        TaskStage.DONE: ReasonCode.OK,
        TaskStage.CANCELLED: ReasonCode.CANCELLED,
    }
    told = ends.get(flight.stage) is flight.code
    return told and closed and flight.stands and flight.is_on_pad and not flight.contacts


@pytest.mark.safety
@pytest.mark.timeout(7200)
def test_every_seeded_visitor_run_ends_on_the_pad_with_the_visitor_in_its_clip() -> None:
    """``benchmarks/visitor.py --kept FILE`` flies the same runs, and goes on where it was ended."""
    scores = (score_visitor(seed) for seed in range(1, RUNS + 1))
    assert {score.seed: score.fault for score in scores if score.fault} == {}


@pytest.mark.safety
@pytest.mark.timeout(3600)
@pytest.mark.parametrize("what", ["cancel", "pause"])
def test_cancel_and_pause_at_random_moments_end_in_the_defined_state(what: str) -> None:
    moments = random.Random(f"moments of {what}")
    failed = {}
    for _ in range(MOMENTS):
        at = moments.uniform(0.0, LAST_MOMENT)
        lasting = moments.uniform(1.0, 30.0)
        script = (
            TaskScript(cancel_at=at, reply_time=4.0)
            if what == "cancel"
            else TaskScript(pause_at=at, resume_at=at + lasting, reply_time=4.0)
        )
        flight = flown("visitor", script)
        if not ended_well(flight) or (what == "pause" and flight.stage is not TaskStage.DONE):
            failed[round(at, 2)] = f"{flight.stage} {flight.code} {flight.words} {flight.contacts}"
    assert failed == {}
