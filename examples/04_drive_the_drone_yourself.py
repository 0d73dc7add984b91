"""Fly the drone by hand, over its real wire.

Needs: MuJoCo: the extra `twin`, which `make setup` brings; or a drone.
Learns: our AR.Drone driver does not know whether a drone or the twin answers. Here the twin serves
    the real ports on a loopback address of its own; put a real drone's address in its place and
    leave the twin out, and the rest stays the same.
Prints: what the drone says of itself, twice a second, while it takes off, flies forward for a
    second, and lands.
"""

import asyncio
import sys

import housefly
from housefly import Action, Command, DroneStatus

ADDRESS = sys.argv[1] if len(sys.argv) > 1 else "127.44.0.4"


def status(drone: housefly.ArDrone) -> DroneStatus:
    """Return the drone's own word."""
    return drone.telemetry.status if drone.telemetry else DroneStatus.UNKNOWN


async def command(drone: housefly.ArDrone, wanted: Command, seconds: float) -> None:
    """Keep a command in force for this long; the driver's watchdog hovers when nobody does."""
    for tick in range(round(seconds / 0.05)):
        drone.send(wanted)
        told = drone.telemetry
        if tick % 10 == 0 and told is not None:
            motion = f"{told.height:5.2f} m high, {told.velocity[0]:5.2f} m/s forward"
            print(f"{told.status.value:<10} {motion}, battery {told.battery:.0%}")
        await asyncio.sleep(0.05)


async def main() -> None:
    """Start the twin, fly, land."""
    wires = {"drone__address": ADDRESS, "tracking__address": ADDRESS}
    loaded = housefly.load_site("bsen", **wires, drone__has_video=False, twin__video=False)
    twin = asyncio.create_task(housefly.run_twin(loaded.site, loaded.room))
    drone = housefly.ArDrone(loaded.site.drone, loaded.site.limits)
    await drone.connect()
    try:
        while status(drone) is not DroneStatus.FLYING:
            await command(drone, Command(Action.TAKE_OFF), 0.5)
        await command(drone, Command(Action.FLY, housefly.Setpoint(theta=0.05)), 1.0)
        await command(drone, Command(Action.HOVER), 2.0)
        while status(drone) is not DroneStatus.LANDED:
            await command(drone, Command(Action.LAND), 0.5)
    finally:
        await drone.close()
        twin.cancel()
        await asyncio.gather(twin, return_exceptions=True)


asyncio.run(main())
