"""Tracking is cut while a Betaflight hovers: what its wire would carry, in lock step."""

from __future__ import annotations

from itertools import pairwise
from math import hypot

import pytest

pytest.importorskip("mujoco")

from housefly.lab.lockstep.betaflight_wire import BetaflightWire
from housefly.lab.lockstep.simulation import Simulation
from housefly.messages import DroneStatus, Order, OrderKind
from housefly.sites.loaded_site import load_site
from housefly.twin.contracts import TwinDrone
from housefly.wires.betaflight.settings import FcSettings
from housefly.wires.betaflight.sticks import RadioSticks, radio_sticks_of

pytestmark = [pytest.mark.slow]

HOVERS_AT = 8.0
LEVEL_WITHIN, SINKS_WITHIN, DOWN_WITHIN = 0.3, 2.0, 12.0
"""Of the cut [s]."""


def test_it_is_level_within_a_third_of_a_second_sinks_within_two_and_lands_where_it_was() -> None:
    simulation = Simulation(load_site("bsen", drone__kind="betaflight", twin__video=False))
    room = simulation._loops[simulation.drones[0]].room
    wire, fc = room._wire, FcSettings()
    assert isinstance(wire, BetaflightWire)
    heard: list[tuple[float, RadioSticks, bool]] = []
    obey = wire.obey

    def listen(drone: TwinDrone, channels: tuple[int, ...]) -> None:
        roll, pitch, throttle, yaw, arm = channels[:5]
        heard.append(
            (simulation.now, radio_sticks_of((roll, pitch, yaw, throttle), fc), arm > 1500)
        )
        obey(drone, channels)

    wire.obey = listen  # type: ignore[method-assign]
    is_ordered, cut_at, place, fastest = False, None, (0.0, 0.0, 0.0), 0.0
    status, sinks_at = DroneStatus.LANDED, None
    while not (cut_at and status is DroneStatus.LANDED) and simulation.now < 40.0:
        simulation.advance()
        orders = ()
        if not is_ordered and simulation.now > 0.5:
            orders = (Order(OrderKind.TAKE_OFF, "", issued_at=simulation.now),)
            is_ordered = True
        step = simulation.step(simulation.inputs(*orders))
        assert step.inputs.telemetry is not None
        status, truth = step.inputs.telemetry.status, simulation.world.truth()
        if cut_at is None and simulation.now >= HOVERS_AT:
            cut_at, place = simulation.now, truth.pose.position
            simulation.inject("mocap:off")
        if cut_at is not None:
            fastest = max(fastest, -truth.velocity[2])
            if sinks_at is None and truth.velocity[2] < -0.15:
                sinks_at = simulation.now - cut_at
    assert cut_at is not None and status is DroneStatus.LANDED
    down_at = simulation.now - cut_at
    after = [(at - cut_at, sticks, arms) for at, sticks, arms in heard if at > cut_at]
    gaps = [later[0] - earlier[0] for earlier, later in pairwise(after)]
    leans = [max(abs(s.phi), abs(s.theta)) for at, s, _ in after if at > LEVEL_WITHIN]
    off_at = min(at for at, _, arms in after if not arms)
    x, y, z = simulation.world.truth().pose.position
    print(f"sinks {sinks_at:.2f} s, down {down_at:.2f} s, {fastest:.2f} m/s, off {off_at:.2f} s")
    assert max(gaps) < 0.1, "the stream is never ended by silence"
    assert max(leans) < 0.02
    assert sinks_at is not None and sinks_at < SINKS_WITHIN
    assert off_at < DOWN_WITHIN and down_at < DOWN_WITHIN
    assert fastest < 1.5 and z < 0.06
    assert hypot(x - place[0], y - place[1]) < 0.4
    assert simulation.contacts() == ()
