"""How many seconds of flight the simulated world gives per second of one core, beside bare physics
of the same scene.
"""

from __future__ import annotations

import time
from collections.abc import Callable

import mujoco

from housefly.config.site import Site, changed
from housefly.messages.stick import Stick
from housefly.room.files import load_room
from housefly.room.model import Room
from housefly.twin.physics import Physics
from housefly.twin.simulated_body import CONTROL_PERIOD, PHYSICS_STEPS
from housefly.twin.world import SimulatedWorld

SECONDS = 20.0
STEP = 0.01


def per_second(fly: Callable[[], None]) -> float:
    """Return drone-seconds per second of processor time; the best of three, for other work on the
    machine only slows.
    """
    best = float("inf")
    for _ in range(3):
        start = time.process_time()
        fly()
        best = min(best, time.process_time() - start)
    return SECONDS / best


def bare_physics(room: Room) -> float:
    physics = Physics(Site(), room)
    steps = round(SECONDS / CONTROL_PERIOD) * PHYSICS_STEPS
    return per_second(lambda: mujoco.mj_step(physics.model, physics.data, steps))


def whole_world(room: Room, rate_hz: float) -> float:
    world = SimulatedWorld(changed(Site(), twin__mocap_rate_hz=rate_hz), room)
    world.request_take_off()
    advance(world, 6.0)
    world.set_stick(Stick(turn=0.3, hover=False))
    return per_second(lambda: advance(world, SECONDS))


def advance(world: SimulatedWorld, seconds: float) -> None:
    for _ in range(round(seconds / STEP)):
        world.keep_alive()
        world.advance(STEP)
        world.onboard()
        world.mocap_frames()


def main() -> None:
    room = load_room("bsen")
    rows = [("bare `mj_step`, no firmware, no tracking", bare_physics(room))]
    rows += [
        (f"whole world, tracking at {rate:.0f} Hz", whole_world(room, rate))
        for rate in (10.0, 100.0)
    ]
    print("### Lock-step world\n")
    print("| B-sen, 400 Hz physics | drone-seconds per core-second | share of bare physics |")
    print("|---|---|---|")
    for name, figure in rows:
        print(f"| {name} | {figure:.0f} | {figure / rows[0][1]:.0%} |")
    print(
        "\nThe simulated world (200 Hz firmware, sensors, battery, 18 cameras' rays) in flight on"
        " one core against MuJoCo alone on the same model in the same run; goal: at least 50 times"
        " real time."
    )


if __name__ == "__main__":
    main()
