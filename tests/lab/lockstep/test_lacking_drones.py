"""A drone without hover, sonar, flow and camera of its own is flown by our setpoint alone."""

from __future__ import annotations

from collections.abc import Iterator
from math import dist, hypot

import pytest
from made_up_drones import BARE, known_made_up_drones

from housefly.config.airframe import Ability
from housefly.lab.lockstep.service import fly_lockstep
from housefly.lab.lockstep.simulation import Simulation
from housefly.messages import Action, DroneStatus, Order, OrderKind, PilotStep, SafetyMode
from housefly.sites.loaded_site import LoadedSite, load_site


@pytest.fixture(scope="module")
def loaded() -> Iterator[LoadedSite]:
    with known_made_up_drones():
        yield load_site("bsen", drone__kind=BARE)


def flown(
    loaded: LoadedSite, seconds: float, *faults: str, stop_at: float | None = None
) -> tuple[Simulation, list[PilotStep]]:
    """Send it to the entrance, and press STOP at a time [s]."""
    simulation, steps = Simulation(loaded), []
    simulation.inject(*faults)
    due = [(0.5, Order(OrderKind.GO, "entrance"))]
    due += [] if stop_at is None else [(stop_at, Order(OrderKind.STOP))]
    while simulation.now < seconds:
        simulation.advance()
        orders = [order for at, order in due if simulation.now >= at]
        due = [(at, order) for at, order in due if simulation.now < at]
        steps.append(simulation.step(simulation.inputs(*orders)))
    return simulation, steps


@pytest.mark.interop
def test_it_completes_the_service_and_is_never_told_to_hover(loaded: LoadedSite) -> None:
    assert loaded.site.drone.airframe.lacks == set(Ability) - {Ability.ATTITUDE, Ability.TILT}
    steps: list[PilotStep] = []
    assert fly_lockstep(loaded, Order(OrderKind.SERVICE, "entrance"), steps.append) == "completed"
    assert Action.HOVER not in {step.outputs.command.action for step in steps}
    telling = [step.inputs.telemetry for step in steps if step.inputs.telemetry]
    assert not any(report.height or any(report.velocity) for report in telling)


def test_where_tracking_is_lost_it_sinks_level_and_lands(loaded: LoadedSite) -> None:
    simulation, steps = flown(loaded, 24.0, "mocap:off@9s+60s")
    later = [step for step in steps if step.now > 9.5]
    assert SafetyMode.DESCEND in {step.outputs.safety for step in later}
    assert Action.HOVER not in {step.outputs.command.action for step in steps}
    report = steps[-1].inputs.telemetry
    assert report is not None and report.status is DroneStatus.LANDED
    assert simulation.world.truth().pose.position[2] < 0.1


def test_stopped_it_is_held_by_our_setpoint(loaded: LoadedSite) -> None:
    simulation, steps = flown(loaded, 14.0, stop_at=9.0)
    rest = simulation.world.truth()
    assert hypot(*rest.velocity[:2]) < 0.05 and rest.pose.position[2] > 0.8
    held = [step.outputs for step in steps if step.now > 9.1]
    assert {one.safety for one in held} == {SafetyMode.STOPPED}
    assert {one.command.action for one in held} == {Action.FLY}
    before = next(step.outputs.estimate for step in steps if step.now >= 9.0)
    assert before is not None and dist(rest.pose.position[:2], before.position[:2]) < 0.6
