"""Tracking is cut while a Tello hovers: what its wire would carry, in lock step, on the truth."""

from __future__ import annotations

from math import hypot

import pytest

pytest.importorskip("mujoco")

from housefly.lab.lockstep.simulation import Simulation
from housefly.messages import Action, Command, DroneStatus, Order, OrderKind
from housefly.sites.loaded_site import load_site
from housefly.twin.contracts import TwinDrone
from housefly.wires.tello.conversions import full_sticks_of, sticks_of

pytestmark = [pytest.mark.slow]

HOVERS_AT = 8.0
LEVEL_WITHIN, LAND_WITHIN = 0.3, 2.0
"""Of the cut [s]."""


def test_it_is_level_within_a_third_of_a_second_told_to_land_within_two_and_lands_where_it_was():
    loaded = load_site("bsen", drone__kind="tello", twin__video=False)
    full = full_sticks_of(loaded.site.drone.airframe.response)
    simulation = Simulation(loaded)
    room = simulation._loops[simulation.drones[0]].room
    heard: list[tuple[float, Command]] = []
    obey = room._wire.obey

    def listen(drone: TwinDrone, command: Command) -> None:
        heard.append((simulation.now, command))
        obey(drone, command)

    room._wire.obey = listen  # type: ignore[method-assign]
    order, cut_at, place, status = None, None, (0.0, 0.0, 0.0), DroneStatus.LANDED
    while not (cut_at and status is DroneStatus.LANDED) and simulation.now < 30.0:
        simulation.advance()
        orders = ()
        if order is None and simulation.now > 0.5:
            order = Order(OrderKind.TAKE_OFF, "", issued_at=simulation.now)
            orders = (order,)
        step = simulation.step(simulation.inputs(*orders))
        assert step.inputs.telemetry is not None
        status = step.inputs.telemetry.status
        if cut_at is None and simulation.now >= HOVERS_AT:
            cut_at, place = simulation.now, simulation.world.truth().pose.position
            simulation.inject("mocap:off")
    assert cut_at is not None and status is DroneStatus.LANDED
    after = [(at - cut_at, command) for at, command in heard if at > cut_at]
    flown = [
        (at, sticks_of(command.velocity, full))
        for at, command in after
        if command.action is Action.FLY and command.velocity is not None
    ]
    land_at = min(at for at, command in after if command.action is Action.LAND)
    assert all(
        max(abs(sticks.ahead), abs(sticks.right)) <= 2 for at, sticks in flown if at > LEVEL_WITHIN
    )
    assert land_at < LAND_WITHIN
    assert not any(at > land_at for at, _ in flown), "it is told nothing but to land from then on"
    x, y, _ = simulation.world.truth().pose.position
    assert hypot(x - place[0], y - place[1]) < 0.1
    assert simulation.contacts() == ()
