"""The hub's process: ``python -m housefly.hub.process --site FILE --bus ENDPOINT [--socket PATH]``.

It listens to the pilot, runs the drivers of the room's sensors, stores what they report, and
answers on the bus. It may crash at any time: the flight goes on, and what was written is there
after a restart.
"""

from __future__ import annotations

import argparse
import asyncio
import contextlib
import gc
import logging
import os
import signal
import sys
from collections.abc import Callable, Sequence
from pathlib import Path

from housefly.bus.zenoh_bus import ZenohBus
from housefly.config.environment import ROOM_KEY_VARIABLE
from housefly.config.process_log import log_line
from housefly.config.site import Site, site_from_file
from housefly.errors import HouseflyError, LinkError
from housefly.hub.hub import Hub
from housefly.hub.query_server import QueryServer
from housefly.hub.store.lock import locked_store
from housefly.hub.store.open import store_address

_log = logging.getLogger(__name__)


async def _run_hub(
    site: Site, folder: Path, endpoint: str, path: Path | None = None, key: str = ""
) -> None:
    """Run the hub until SIGTERM, SIGINT or cancellation.

    Args:
        site: its sensors, and the address of its store.
        folder: of the site file, for relative paths.
        endpoint: of the bus.
        path: of the query server's socket for programs of this user; None for none.
        key: bearer token of the run.

    Raises:
        StoreError, ConfigError: it cannot start.
    """
    with locked_store(site), ZenohBus(connect=endpoint) as bus:
        hub = Hub(site, folder, bus)
        server = _open_query_server(hub.answer, key, path) if path and key else None
        working = asyncio.create_task(hub.run())
        for number in (signal.SIGTERM, signal.SIGINT):
            asyncio.get_running_loop().add_signal_handler(number, working.cancel)
        # Objects that live for the whole run need not be scanned by every collection.
        gc.freeze()
        log_line(f"hub ready: memory in {store_address(site)}")
        try:
            with contextlib.suppress(asyncio.CancelledError):
                await working
        finally:
            if server is not None:
                server.close()
            hub.close()


def _open_query_server(answer: Callable[[str], str], key: str, path: Path) -> QueryServer | None:
    """Open the query server; without it programs ask over HTTP."""
    try:
        return QueryServer(answer, key, path)
    except LinkError as error:
        _log.warning("%s", error)
        return None


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the hub of a site until stopped; returns the exit status."""
    parser = argparse.ArgumentParser(
        prog="python -m housefly.hub.process", description="Remember what the room tells."
    )
    parser.add_argument("--site", type=Path, required=True, help="site file")
    parser.add_argument(
        "--bus", required=True, help="zenoh endpoint of the pilot, unixsock-stream/PATH"
    )
    parser.add_argument(
        "--socket",
        type=Path,
        help=f"Unix socket for who asks, with the key in {ROOM_KEY_VARIABLE}",
    )
    options = parser.parse_args(arguments)
    logging.basicConfig(level=logging.INFO, format="%(asctime)s %(name)s %(message)s")
    try:
        key = os.environ.get(ROOM_KEY_VARIABLE, "")
        asyncio.run(
            _run_hub(
                site_from_file(options.site), options.site.parent, options.bus, options.socket, key
            )
        )
    except HouseflyError as error:
        log_line(f"hub: {error}", sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
