"""Fly the drone by hand, over its real wire.

Learns: our AR.Drone driver does not know whether a drone or the twin answers. Here the twin serves
    the real ports on a loopback
address of its own; put a real drone's address in its place and leave the twin out, and the rest
stays the same. Prints: what the drone says of itself, twice a second, while it takes off, flies
forward for a second, and lands.
"""

import asyncio
import sys

from housefly.app.loaded_site import open_site, read_site
from housefly.config.drone import DroneConfig
from housefly.config.limits import LimitsConfig
from housefly.config.site import changed
from housefly.drones.ardrone.driver import ArDrone
from housefly.messages import Action, Command, DroneStatus, Setpoint
from housefly.twin.process import run_twin

ADDRESS = sys.argv[1] if len(sys.argv) > 1 else "127.44.0.4"


def status(drone: ArDrone) -> DroneStatus:
    """Return the drone's own word."""
    return drone.telemetry.status if drone.telemetry else DroneStatus.UNKNOWN


async def command(drone: ArDrone, wanted: Command, seconds: float) -> None:
    """Keep a command in force for this long; the driver's watchdog hovers when nobody does."""
    for tick in range(round(seconds / 0.05)):
        drone.send(wanted)
        told = drone.telemetry
        if tick % 10 == 0 and told is not None:
            forward = told.velocity[0]
            print(
                f"{told.status.value:<10} {told.height:5.2f} m high, {forward:5.2f} m/s forward,"
                f" battery {told.battery:.0%}"
            )
        await asyncio.sleep(0.05)


async def main() -> None:
    """Start the twin, fly, land."""
    loaded = open_site(
        changed(
            read_site("bsen"), drone__address=ADDRESS, tracking__address=ADDRESS, twin__video=False
        )
    )
    twin = asyncio.create_task(run_twin(loaded.site, loaded.room))
    drone = ArDrone(DroneConfig(address=ADDRESS, has_video=False), LimitsConfig())
    await drone.connect()
    try:
        while status(drone) is not DroneStatus.FLYING:
            await command(drone, Command(Action.TAKE_OFF), 0.5)
        await command(drone, Command(Action.FLY, Setpoint(theta=0.05)), 1.0)
        await command(drone, Command(Action.HOVER), 2.0)
        while status(drone) is not DroneStatus.LANDED:
            await command(drone, Command(Action.LAND), 0.5)
    finally:
        await drone.close()
        twin.cancel()
        await asyncio.gather(twin, return_exceptions=True)


asyncio.run(main())
