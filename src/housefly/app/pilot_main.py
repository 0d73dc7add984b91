"""The pilot process: ``python -m housefly.app.pilot_main``, started by the launcher."""

from __future__ import annotations

import asyncio
import gc
import signal
from collections.abc import Sequence
from contextlib import suppress

from housefly.app.origin_memory import OriginMemory
from housefly.app.pilot_shell import PilotShell
from housefly.app.priority import raise_priority
from housefly.app.runtime import Runtime, drone_argument, runtime_from_environment
from housefly.bus.stop import StopListener
from housefly.bus.zenoh_bus import ZenohBus
from housefly.clock import RealClock
from housefly.config.process_log import log_line
from housefly.drones.remote_drone import RemoteDrone
from housefly.pilot.assembly import warm_up
from housefly.sites.loaded_site import LoadedSite, open_site
from housefly.tracking.remote_tracker import RemoteTracker


def main(arguments: Sequence[str] | None = None) -> None:
    """Run the pilot of one drone until it has been asked to stop and the drone is down."""
    drone = drone_argument(arguments)
    runtime = runtime_from_environment()
    loaded = open_site(runtime.site().for_drone(drone))
    warm_up(loaded.site, loaded.room, loaded.grid)
    raise_priority()
    gc.collect()
    gc.freeze()
    with suppress(KeyboardInterrupt):
        asyncio.run(_run(runtime, loaded))


async def _run(runtime: Runtime, loaded: LoadedSite) -> None:
    site, clock = loaded.site, RealClock()
    with ZenohBus(connect=runtime.bus) as bus:
        name = site.drone.name
        drone = RemoteDrone(runtime.driver_socket(name), clock)
        origin = OriginMemory(site, runtime.sockets)
        tracker = RemoteTracker(runtime.tracking_socket, clock)
        shell = PilotShell(loaded, bus, tracker, drone, origin=origin)
        # The launcher starts no pilot before the last one is gone, so it alone shares the port.
        where = ("127.0.0.1", runtime.stop_ports[name])
        stop = StopListener(*where, runtime.secret, shell.stop, is_held=True)
        await stop.start()
        loop = asyncio.get_running_loop()
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            loop.add_signal_handler(number, shell.leave)
        log_line("pilot ready")
        try:
            await shell.run()
        finally:
            stop.close()


if __name__ == "__main__":
    main()
