"""A drone whose own loops land it is level at once when tracking is lost, and told to land."""

from __future__ import annotations

from dataclasses import dataclass
from math import dist, hypot

import pytest

from housefly.lab.lockstep.simulation import Simulation
from housefly.messages import Action, DroneStatus, Order, OrderKind, PilotStep, SafetyMode
from housefly.sites.loaded_site import load_site
from housefly.twin.contracts import GroundTruth

CUT_AT = 9.0
LEVEL = 0.02
"""Leans less than this [rad]: what noise makes of it."""


@dataclass
class Cut:
    """A flight to the entrance whose tracking ends, and what it truly did since."""

    steps: list[PilotStep]
    truths: list[GroundTruth]
    leans: list[float]
    contacts: int


def cut(kind: str, stop_at: float = 99.0) -> Cut:
    simulation = Simulation(load_site("bsen", drone__kind=kind))
    simulation.inject(f"mocap:off@{CUT_AT:g}s+60s")
    due = [(0.5, Order(OrderKind.GO, "entrance")), (stop_at, Order(OrderKind.STOP))]
    flown = Cut([], [], [], 0)
    while simulation.now < 18.0:
        simulation.advance()
        orders = [order for at, order in due if simulation.now >= at]
        due = [(at, order) for at, order in due if simulation.now < at]
        step = simulation.step(simulation.inputs(*orders))
        if simulation.now >= CUT_AT:
            onboard = simulation.world.onboard()
            flown.steps.append(step)
            flown.truths.append(simulation.world.truth())
            flown.leans.append(hypot(onboard.theta, onboard.phi))
    flown.contacts = len(simulation.contacts())
    return flown


@pytest.mark.parametrize("kind", ["px4", pytest.param("arducopter", marks=pytest.mark.interop)])
def test_in_hover_it_stays_level_and_is_told_to_land_within_a_second(kind: str) -> None:
    flown = cut(kind, stop_at=7.0)
    told = next(step for step in flown.steps if step.outputs.command.action is Action.LAND)
    assert told.now < CUT_AT + 1.0 and told.outputs.safety is SafetyMode.LAND
    airborne = [
        lean for lean, truth in zip(flown.leans, flown.truths, strict=True)
        if truth.at > CUT_AT + 0.3 and truth.pose.position[2] > 0.4
    ]  # fmt: skip
    assert len(airborne) > 100 and max(airborne) < LEVEL
    check_landed(flown, 0.15)


@pytest.mark.parametrize("kind", ["px4", pytest.param("arducopter", marks=pytest.mark.interop)])
def test_on_its_way_it_brakes_and_comes_down_where_it_stopped(kind: str) -> None:
    flown = cut(kind)
    assert hypot(*flown.truths[0].velocity[:2]) > 0.4, "nothing to brake"
    at_rest = next(truth for truth in flown.truths if hypot(*truth.velocity[:2]) < 0.1)
    assert at_rest.at < CUT_AT + 2.0
    check_landed(flown, 0.7)


def check_landed(flown: Cut, beside: float) -> None:
    """It stands, at most so far [m] from where it was when tracking ended, and touched nothing."""
    report, last = flown.steps[-1].inputs.telemetry, flown.truths[-1]
    assert report is not None and report.status is DroneStatus.LANDED and not flown.contacts
    assert dist(last.pose.position[:2], flown.truths[0].pose.position[:2]) < beside
    assert all(step.outputs.command.action is not Action.HOVER for step in flown.steps)
