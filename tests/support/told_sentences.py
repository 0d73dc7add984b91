"""Every sentence that the console's server says in English, by the tables that make them."""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from itertools import product
from math import inf
from pathlib import Path
from random import Random
from typing import NamedTuple

from fake_room import EXAMPLE_CHECKS, example_room
from gate_flight import AIRFRAME

from housefly.app.disk_space import DiskSpace
from housefly.config.limits import LimitsConfig
from housefly.hub.api.pilot_queries import PreflightView
from housefly.messages import (
    Action,
    Command,
    DroneFault,
    DroneStatus,
    Estimate,
    Inputs,
    Outputs,
    Phase,
    PilotStep,
    PreflightCheck,
    Reference,
    SafetyMode,
    Setpoint,
    Telemetry,
)
from housefly.messages.preflight import FrameCheckState, FramesKnown
from housefly.pilot.behavior.mission import UNHEARD, PeopleSilence
from housefly.pilot.behavior.preflight import PREFLIGHT_RULES, PreflightInputs
from housefly.pilot.estimation.consistency import TrackingConsistency
from housefly.pilot.safety.energy import EnergyBudget
from housefly.pilot.safety.inputs import GateInputs, Geofence
from housefly.pilot.safety.observer import FlightObservations
from housefly.pilot.safety.rule import RuleContext
from housefly.pilot.safety.rules import SAFETY_RULES
from housefly.web.status.console_knowledge import ConsoleKnowledge
from housefly.web.status.order_objections import check_in_words
from housefly.web.status.stop_latch import StopLatch
from housefly.web.status.verdict import console_verdict

LIMITS = LimitsConfig()
NOW = 100.0
_ROOM = example_room()
_PLACES = ((*_ROOM.home, 0.05), (3.4, 2.0, 0.05), (6.4, 1.0, 0.05))
"""On the pad, under the table, and elsewhere [m]."""
_ENERGY = EnergyBudget(500.0, 30.0, 45.0, 0.3, 0.2, 90.0)
_SEEN = FlightObservations(
    standing_height=0.05,
    start=(4.0, 2.0),
    tilt_asked=0.2,
    tilt_error=0.3,
    tilt_wrong_for=0.9,
    velocity_change=2.5,
    velocity_error=1.4,
    held_for=5.5,
    late_steps=4,
    landing_for=12.0,
    energy=_ENERGY,
)
_WRONG = TrackingConsistency(1.3, 0.6, True, 0.4, 0.25, 2.5)


class _Usage(NamedTuple):
    total: float
    free: float


def _disk(_: Path, free: float) -> _Usage:
    return _Usage(1000e9, free)


def safety_sentences() -> set[str]:
    """Return what each rule of the last gate says, with its values on both sides."""
    return {
        words
        for rule, height, age, blow in product(
            SAFETY_RULES, (0.4, 2.0), (3.2, inf), ((0.0, 0.0, 9.81), (40.0, 0.0, 9.81))
        )
        if (words := rule.words(_broken(height, age, blow)))
    }


def _broken(height: float, pose_age: float, blow: tuple[float, float, float]) -> RuleContext:
    position = (5.0, 2.0, height)
    told = Telemetry(
        0.0,
        DroneStatus.FLYING,
        0.12,
        height=1.05,
        acceleration=blow,
        faults=(DroneFault.MOTORS_PROBLEM, DroneFault.ULTRASOUND_DEAF),
    )
    now = GateInputs(
        now=NOW,
        status=DroneStatus.FLYING,
        battery=0.12,
        pose_age=pose_age,
        telemetry_age=3.5,
        position=position,
        stopped=False,
        cutting=False,
        velocity=(2.0, 0.0, 0.0),
        reference=Reference((2.0, 2.0, 1.1), (0.0, 0.0, 0.0), 0.0),
        flight_height=1.1,
        flown=Setpoint(),
        telemetry=told,
        consistency=_WRONG,
        late=0.7,
        home_time=20.0,
        silence=PeopleSilence(pose_age),
    )
    return RuleContext(now, _SEEN, LIMITS, Geofence((0.0, 0.0, 10.0, 5.0), 2.3), AIRFRAME)


def checks() -> list[PreflightCheck]:
    """Return every line of the list before a take-off, as it is when all is well and when not."""
    found = [rule.check(inputs) for rule in PREFLIGHT_RULES for inputs in _preflights()]
    for free in (500e9, 5e9):
        # Nobody writes into a program.
        kept = Path(sys.executable if free < 10e9 else tempfile.gettempdir())
        disks = DiskSpace([Path("/")], partial(_disk, free=free), [kept])
        disks.look()
        found += disks.checks()
    return [*found, *EXAMPLE_CHECKS]


def _preflights() -> Iterator[PreflightInputs]:
    limits = LIMITS
    for status, state in product(DroneStatus, FrameCheckState):
        told = Telemetry(0.0, status, 0.6, phi=0.4, configured=True)
        seen = Estimate(0.0, (1.8, 1.0, 0.05), (0.0, 0.0, 0.0), 0.0, 0.2, 0.004)
        vehicle = replace(UNHEARD, status=status, battery=0.6, telemetry=told)
        vehicle = replace(vehicle, telemetry_age=0.3, estimate=seen)
        words = "" if state is not FrameCheckState.WRONG else "found wrong"
        yield PreflightInputs(vehicle, limits, 0.8, 0.5, False, frames=FramesKnown(state, words))
    yield PreflightInputs(
        UNHEARD, limits, stopped=True, take_off_fault="Anna is too close", sees_people=False
    )
    for age in (3.2, inf):
        yield PreflightInputs(replace(UNHEARD, silence=PeopleSilence(age)), limits)
    stuck = replace(UNHEARD, battery=0.6, gauge_stuck=True)
    yield PreflightInputs(stuck, limits, take_off_fault="chair stands there")


def check_sentences() -> set[str]:
    """Return all that such a line shows."""
    return {
        words
        for one in checks()
        for words in (one.title, one.fault, one.value, one.limit, one.why, one.mend)
        if words
    }


def stop_sentences() -> set[str]:
    """Return what is said of a STOP on its way."""
    pressed = StopLatch().pressed("Anna", NOW)
    taken = pressed.acknowledged()
    views = [
        latch.view(now, airborne=airborne, pilot_is_heard=heard)
        for latch, now, airborne, heard in product(
            (pressed, taken), (NOW + 0.1, NOW + 9.0), (True, False, None), (True, False)
        )
    ]
    return {view.words for view in views}


def verdict_sentences(kinds: int = 20_000, seed: int = 7) -> set[str]:
    """Return what the verdict says of drawn kinds of knowledge, in every field that is words."""
    draw = Random(seed)
    reasons = sorted(safety_sentences())
    failing = sorted({one.code: one for one in checks() if not one.passed}.values(), key=str)
    found: set[str] = set()
    for _ in range(kinds):
        told = console_verdict(_knowledge(draw, reasons, failing))
        found |= {told.headline, told.detail, told.banner, told.place, told.if_contact_lost}
        found |= {words for one in told.reasons for words in (one.words, one.mend)}
        found |= {one.words for one in told.orders} | set(told.known)
    return found - {""}


def _knowledge(draw: Random, reasons: list[str], failing: list[PreflightCheck]) -> ConsoleKnowledge:
    step_age = draw.choice((0.01, 0.01, 0.01, 9.0))
    at = NOW - step_age
    pose_age, telemetry_age = draw.choice((0.02, 0.02, 0.7, 4.0)), draw.choice((0.03, 0.03, 9.0))
    place = draw.choice(_PLACES)
    seen = Estimate(at, place, (0.0, 0.0, 0.0), 0.0, pose_age, 0.004)
    status = draw.choice([*DroneStatus, DroneStatus.LANDED, DroneStatus.FLYING, None])
    told = Telemetry(at - telemetry_age, status, 0.8) if status else None
    out = Outputs(
        Command(Action.FLY),
        draw.choice((seen, seen, seen, None)),
        phase=draw.choice(list(Phase)),
        safety=draw.choice([*SafetyMode, SafetyMode.NOMINAL, SafetyMode.NOMINAL]),
        goal_name=draw.choice(("", "entrance", "(4.0, 2.0)")),
        reason=draw.choice(reasons),
    )
    step = PilotStep(7, at, Inputs((), told), out)
    wrong = draw.choice(failing)
    preflight = draw.choice(
        (PreflightView(True, EXAMPLE_CHECKS), PreflightView(), PreflightView(False, (wrong,)))
    )
    latch = draw.choice((StopLatch(), StopLatch().pressed("Anna", NOW - 9.0)))
    stop = draw.choice((latch, latch.acknowledged())).view(
        NOW, airborne=None, pilot_is_heard=step_age < 1.0
    )
    moved = draw.choice((None, None, "", "Anna"))
    known = ConsoleKnowledge(
        NOW, step, step_age, None, preflight, _ROOM, stop, 1, "Anna", hand_motion=moved
    )
    return known if draw.random() > 0.01 else replace(known, step=None)


def told_sentences() -> set[str]:
    """Return all of them."""
    broken = {check_in_words(one) for one in checks()}
    return safety_sentences() | check_sentences() | stop_sentences() | verdict_sentences() | broken
