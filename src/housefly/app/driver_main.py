"""The driver process: ``python -m housefly.app.driver_main``, started by the launcher.

It is the last to leave: told to end while the drone is in the air, it lands it first.
"""

from __future__ import annotations

import asyncio
import gc
import json
import signal
from collections.abc import Sequence
from contextlib import suppress

from housefly.app.priority import raise_priority
from housefly.app.runtime import Runtime, drone_argument, runtime_from_environment
from housefly.clock import RealClock
from housefly.config.drones import drone_in_tree
from housefly.config.limits import LimitsConfig
from housefly.drones import driver_of
from housefly.drones.driver_server import DriverServer


def main(arguments: Sequence[str] | None = None) -> None:
    """Run the driver of one drone until it has been asked to end and the drone is down."""
    name, runtime = drone_argument(arguments), runtime_from_environment()
    raise_priority()
    gc.collect()
    gc.freeze()
    with suppress(KeyboardInterrupt):
        asyncio.run(_run(runtime, name))


async def _run(runtime: Runtime, name: str) -> None:
    site, clock = json.loads(runtime.site_file.read_text(encoding="utf-8")), RealClock()
    drone, limits = drone_in_tree(site, name), LimitsConfig(**site["limits"])
    server = DriverServer(driver_of(drone, limits, clock), runtime.driver_socket(name), clock)
    loop = asyncio.get_running_loop()
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        loop.add_signal_handler(number, server.leave)
    await server.run()


if __name__ == "__main__":
    main()
