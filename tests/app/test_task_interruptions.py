"""A task of every kind of step, interrupted at random moments in the air; scored on the truth."""

from __future__ import annotations

import random
from collections.abc import Callable
from dataclasses import replace
from functools import cache

import pytest
from task_flights import premises, scene_of

from housefly.evidence.clip_values import StartClip
from housefly.geometry import distance
from housefly.lab.lockstep.task_flight import TaskFlight, TaskScript
from housefly.lab.lockstep.task_lockstep import fly_task_lockstep
from housefly.tasks.api.values import ReasonCode, TaskStage
from housefly.tasks.document.binding import bind
from housefly.tasks.document.document_parser import read_task
from housefly.tasks.document.task_document import BoundTask
from housefly.tasks.execution.values import StopClip
from housefly.twin.people.scene import Scene

MOMENTS = 50
EVERYTHING = """
name: everything
steps:
  - take_off
  - parallel:
      - look_at: tv
      - sequence: [{wait: 1 s}, {say: on the way}]
  - record: {subject: tv, before: 2 s}
    do:
      - snapshot: tv
      - ask: {question: "Enough?", wait: 3 s}
  - sweep: {views: 3, angle: 90 deg}
  - retry: 2
    do:
      - timeout: 90 s
        do: [go_to: sofa]
  - repeat: 2
    do: [wait: 1 s]
  - first_of:
      - look_at: the moon
      - follow: {person: anna, time: 8 s}
  - record: 1 s
  - if: {reply: {equals: yes}}
    then: [report: enough]
    else: [report: more]
  - return_home
on_cancel:
  - say: stopping
  - ask: {question: "Look at the sofa?", wait: 4 s, as: last}
  - look_at: sofa
  - return_home
"""
BRAKING_TIME = 4.0
"""A paused drone hovers after this [s]."""
RESTED = 0.02
"""Standing, nothing moves by more than this [m]."""


@cache
def everything() -> BoundTask:
    return bind(read_task(EVERYTHING), {})


@cache
def anna() -> Scene:
    """Return somebody who walks through the room."""
    steps = (
        {"do": "wait", "seconds": 40.0},
        {"do": "go", "to": [6.6, 4.1], "speed": 0.5},
        {"do": "wait", "seconds": 600.0},
    )
    return scene_of({"name": "anna", "start": [9.4, 4.2], "steps": list(steps)})


def fly(script: TaskScript) -> TaskFlight:
    quick = replace(script, reply_time=1.0)
    return fly_task_lockstep(
        premises(), everything(), quick, scene=anna(), pictures=False, watch_after=4.0
    )


@cache
def whole() -> TaskFlight:
    """Return the flight that nobody interrupts."""
    return fly(TaskScript())


def fault_of(flight: TaskFlight, script: TaskScript) -> str:
    """Return why a flight did not end in its defined state, or ""."""
    cancelled = script.cancel_at < flight.ended_at
    wanted = (TaskStage.CANCELLED, ReasonCode.CANCELLED) if cancelled else (
        TaskStage.DONE, ReasonCode.OK)  # fmt: skip
    if (flight.stage, flight.code) != wanted:
        return f"{flight.stage.value} {flight.code.value}: {flight.words}"
    if flight.contacts:
        return f"touched {flight.contacts}"
    if not flight.is_on_pad:
        return f"{flight.off_pad:.2f} m off the pad, stands: {flight.stands}"
    if flight.moved_after > RESTED:
        return f"moved by {flight.moved_after:.2f} m after the end"
    if len(flight.actions_of(StartClip)) != len(flight.actions_of(StopClip)):
        return "a clip stays open"
    return _drifted(flight, script)


def _drifted(flight: TaskFlight, script: TaskScript) -> str:
    """Return that a paused drone did not hover, or ""; a landing is not held up."""
    until = min(script.resume_at, script.cancel_at if script.cancel_at > script.pause_at else 1e9)
    still = [s for s in flight.samples if script.pause_at + BRAKING_TIME < s.at < until]
    lands = any(s.height < 0.6 for s in still)
    if not still or lands or still[0].at < (flight.airborne_at or 0.0) + 8.0:
        return ""
    moved = max(distance(s.place, still[0].place) for s in still)
    return f"a paused drone moved by {moved:.2f} m" if moved > 0.4 else ""


def _cancel(at: float, draw: random.Random) -> TaskScript:
    return TaskScript(cancel_at=at)


def _pause_and_go_on(at: float, draw: random.Random) -> TaskScript:
    return TaskScript(pause_at=at, resume_at=at + draw.uniform(0.5, 15.0))


def _pause_and_cancel(at: float, draw: random.Random) -> TaskScript:
    return TaskScript(pause_at=at, cancel_at=at + draw.uniform(0.05, 12.0))


def _cancel_twice(at: float, draw: random.Random) -> TaskScript:
    return TaskScript(cancel_at=at, cancel_again_at=at + draw.uniform(0.05, 12.0))


def _cancel_and_pause(at: float, draw: random.Random) -> TaskScript:
    pause = at + draw.uniform(0.05, 12.0)
    return TaskScript(cancel_at=at, pause_at=pause, resume_at=pause + draw.uniform(0.5, 8.0))


@pytest.mark.safety
def test_a_task_of_every_step_that_nobody_interrupts_is_done() -> None:
    assert fault_of(whole(), TaskScript()) == ""
    assert whole().clearance > 0.15


@pytest.mark.safety
@pytest.mark.timeout(3600)
@pytest.mark.parametrize(
    "interruption", [_cancel, _pause_and_go_on, _pause_and_cancel, _cancel_twice, _cancel_and_pause]
)
def test_interrupted_at_any_moment_it_ends_in_the_defined_state(
    interruption: Callable[[float, random.Random], TaskScript],
) -> None:
    draw = random.Random(interruption.__name__)
    failed = {}
    for _ in range(MOMENTS):
        script = interruption(draw.uniform(0.0, whole().ended_at), draw)
        if fault := fault_of(fly(script), script):
            failed[script] = fault
    assert failed == {}
