"""What a drone does that loses its client in mid-flight: the room must know, because nothing of
ours can help then.
"""

from __future__ import annotations

from typing import Any

from housefly.twin.contracts import FlightState
from housefly.wires.ardrone.conversions import Stick


def test_a_drone_that_loses_its_client_flies_on_with_its_last_stick_for_two_seconds_then_brakes_and_lands(
    make_world: Any, hand: Any
) -> None:
    world = make_world()
    hand(world).hover()
    for _ in range(60):
        world.keep_alive()
        world.set_stick(Stick(forward=0.15, hover=False))
        world.advance(0.03)
    world.advance(1.9)
    assert world.onboard().flight is FlightState.FLYING
    assert world.truth().velocity[0] ** 2 + world.truth().velocity[1] ** 2 > 0.2**2
    world.advance(0.2)
    assert world.onboard().flight is FlightState.LANDING
    world.advance(8.0)
    assert world.onboard().flight is FlightState.LANDED
