"""The live view's process: ``python -m housefly.foxglove.process --site FILE --bus ENDPOINT``.

It listens to the bus and tells nobody anything there: a viewer cannot fly, and its death changes
nothing of a flight.
"""

from __future__ import annotations

import argparse
import gc
import logging
import signal
import sys
from collections.abc import Sequence
from contextlib import ExitStack
from pathlib import Path
from types import FrameType

from housefly.bus.bus import Bus
from housefly.bus.zenoh_bus import ZenohBus
from housefly.config.process_log import log_line
from housefly.config.site import site_from_file
from housefly.errors import HouseflyError
from housefly.foxglove.camera_feed import CameraFeed
from housefly.foxglove.channels import channels_of
from housefly.foxglove.demand import Demand
from housefly.foxglove.drone_feed import DroneFeed
from housefly.foxglove.house_board import HouseBoard
from housefly.foxglove.live_server import LiveServer
from housefly.foxglove.origin_gate import OriginGate, hidden_address
from housefly.foxglove.room_feed import RoomFeed
from housefly.hub.wall_clock import WallClock
from housefly.sites.loaded_site import LoadedSite, open_site


class LiveView:
    """The channels of a site behind the gate at its port; use it as a context manager.

    Args:
        site: with room and map.
        bus: of the run.

    Attributes:
        port: where it listens.

    Raises:
        MissingPartError: without ``foxglove-sdk``.
        ConfigError: the address cannot be had.
    """

    def __init__(self, site: LoadedSite, bus: Bus) -> None:
        config = site.site.foxglove
        channels = channels_of(site.site)
        self._stack = ExitStack()
        self._demand: Demand | None = None
        self._server = LiveServer(
            f"Housefly {site.site.name}", hidden_address(), 0, channels, self._note
        )
        self._stack.callback(self._server.close)
        try:
            gate = OriginGate(
                config.host, config.port, (self._server.host, self._server.port), config.origins
            )
        except HouseflyError:
            self._stack.close()
            raise
        self._stack.callback(gate.close)
        self.port = gate.port
        wall, board = WallClock(), HouseBoard(bus)
        feeds = [*RoomFeed(bus, self._server, site, board, wall).feeds]
        for name in site.site.drone_names:
            own = site.for_drone(name)
            feeds += DroneFeed(bus, self._server, own, wall).feeds
            feeds += CameraFeed(bus, self._server, own.site, board, wall).feeds
        self._demand = Demand(feeds)

    def run(self) -> None:
        """Follow the viewers until ``end``."""
        assert self._demand is not None
        self._demand.run(self._server)

    def end(self) -> None:
        """Let ``run`` return; from any thread."""
        if self._demand is not None:
            self._demand.end()

    def close(self) -> None:
        """Leave every viewer."""
        self._stack.close()

    def _note(self, topic: str, has_come: bool) -> None:
        # Who comes before the feeds are there is found when they look.
        if self._demand is not None:
            self._demand.note(topic, has_come)


def main(arguments: Sequence[str] | None = None) -> int:
    """Serve the live view of a site until a signal arrives; returns the exit status."""
    parser = argparse.ArgumentParser(
        prog="python -m housefly.foxglove.process", description="Show a room live in Foxglove."
    )
    parser.add_argument("--site", type=Path, required=True, help="site file")
    parser.add_argument(
        "--bus", required=True, help="zenoh endpoint of the pilot, unixsock-stream/PATH"
    )
    options = parser.parse_args(arguments)
    logging.basicConfig(level=logging.INFO, format="%(asctime)s %(name)s %(message)s")
    signal.signal(signal.SIGTERM, _exit)
    try:
        site = open_site(site_from_file(options.site))
        with ZenohBus(connect=options.bus) as bus:
            view = LiveView(site, bus)
            gc.freeze()
            log_line(f"foxglove ready: ws://{site.site.foxglove.host}:{view.port}")
            try:
                view.run()
            finally:
                view.close()
    except HouseflyError as error:
        log_line(f"foxglove: {error}", sys.stderr)
        return 1
    return 0


def _exit(number: int, frame: FrameType | None) -> None:
    raise SystemExit(0)


if __name__ == "__main__":
    sys.exit(main())
