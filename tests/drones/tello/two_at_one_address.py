"""Two simulated Tellos, both at 192.168.10.1, each behind a network interface of its own.

``unshare -rn python two_at_one_address.py``: everything happens in network namespaces that end with
it. Prints the charge of each by its driver's word, as JSON.
"""

from __future__ import annotations

import asyncio
import json
import subprocess
import sys

from housefly.clock import RealClock
from housefly.config.limits import LimitsConfig
from housefly.config.site import Site, changed
from housefly.drones.tello.driver import Tello
from housefly.room.files import load_room
from housefly.twin.real_time import RealTimeRunner
from housefly.twin.tello.server import TelloServer
from housefly.twin.world import SimulatedWorld

THERE, HERE = "192.168.10.1", "192.168.10.2"
"""Addresses of every Tello, and of its client."""
CHARGES = {"wifi0": 0.9, "wifi1": 0.6}


def ip(*words: str) -> None:
    """Say something to the kernel's network."""
    subprocess.run(["ip", *words], check=True)


async def serve(device: str, charge: float) -> None:
    """Be one drone, in a namespace of its own, once its device is there."""
    sys.stdin.readline()
    ip("addr", "add", f"{THERE}/24", "dev", device)
    ip("link", "set", device, "up")
    site = changed(Site(), drone__kind="tello", twin__battery=charge)
    world = SimulatedWorld(site, load_room(site.room.model))
    server = TelloServer(world, THERE, beyond_loopback=True)
    await server.start()
    print("up", flush=True)
    async with asyncio.timeout(60.0):
        await RealTimeRunner(world, RealClock()).run()


async def look() -> dict[str, float]:
    """Return the charge that each driver is told."""
    drones, told = [], {}
    try:
        for interface, charge in CHARGES.items():
            command = ["unshare", "-n", sys.executable, __file__, f"{interface}d", str(charge)]
            drone = subprocess.Popen(
                command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
            )
            drones.append(drone)
            assert drone.stdin is not None and drone.stdout is not None
            await asyncio.sleep(0.5)  # until it has left this namespace
            ip("link", "add", interface, "type", "veth", "peer", "name", f"{interface}d")
            ip("link", "set", f"{interface}d", "netns", str(drone.pid))
            ip("addr", "add", f"{HERE}/24", "dev", interface)
            ip("link", "set", interface, "up")
            drone.stdin.write("\n")
            drone.stdin.flush()
            assert await asyncio.to_thread(drone.stdout.readline) == "up\n"
        config = changed(Site(), drone__kind="tello", drone__address=THERE).drone
        drivers = {
            interface: Tello(config.model_copy(update={"interface": interface}), LimitsConfig())
            for interface in CHARGES
        }
        for driver in drivers.values():
            await driver.connect()
        await asyncio.sleep(1.0)
        for interface, driver in drivers.items():
            assert driver.telemetry is not None and driver.firmware == "SDK 20"
            told[interface] = driver.telemetry.battery
            await driver.close()
    finally:
        for drone in drones:
            drone.kill()
    return told


if __name__ == "__main__":
    if len(sys.argv) > 1:
        asyncio.run(serve(sys.argv[1], float(sys.argv[2])))
    else:
        print(json.dumps(asyncio.run(look())))
