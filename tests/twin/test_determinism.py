"""A seed means a flight, bit for bit, however one looks at it."""

from __future__ import annotations

from collections.abc import Callable

from housefly.messages import Pose
from housefly.twin.world import SimulatedWorld
from housefly.wires.ardrone.conversions import Stick

MakeWorld = Callable[..., SimulatedWorld]


def errand(world: SimulatedWorld, look: bool) -> list[object]:
    told: list[object] = []
    world.flat_trim()
    world.request_take_off()
    for step in range(900):
        world.keep_alive()
        if step == 600:
            world.set_stick(Stick(forward=0.4, turn=0.2, hover=False))
        world.advance(0.01)
        told.extend(world.mocap_frames())
        if look:
            world.onboard()
            world.truth()
    return [*told, world.truth(), world.onboard()]


def test_the_same_seed_is_the_same_flight_bit_for_bit_whoever_looks(make_world: MakeWorld) -> None:
    values = {"twin__mocap_dropout": 0.1, "twin__seed": 5}
    assert errand(make_world(**values), look=False) == errand(make_world(**values), look=True)


def test_another_seed_is_another_flight(make_world: MakeWorld) -> None:
    assert (
        errand(make_world(twin__seed=1), look=False)[-2:]
        != errand(make_world(twin__seed=2), look=False)[-2:]
    )


def test_time_in_many_small_steps_is_the_same_flight(make_world: MakeWorld) -> None:
    def fly(steps: int) -> Pose:
        world = make_world()
        world.request_take_off()
        for _ in range(steps):
            world.advance(1.5 / steps)
        return world.truth().pose

    assert fly(1) == fly(7) == fly(1000)
