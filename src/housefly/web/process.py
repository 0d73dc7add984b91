"""The console's process: ``python -m housefly.web.process --site FILE --bus ENDPOINT``.

The launcher passes secrets in the environment, which other users of the machine cannot read: the
token of the first link, the key of the STOP path (hexadecimal; it signs the sessions too), and the
port of the STOP path.
"""

from __future__ import annotations

import argparse
import asyncio
import gc
import logging
import os
import secrets
import signal
import socket
import sys
from collections.abc import Sequence
from concurrent.futures import Future
from pathlib import Path
from types import FrameType

import uvicorn
from starlette.applications import Starlette

from housefly.bus.stop_sender import StopSender
from housefly.bus.zenoh_bus import ZenohBus
from housefly.config.environment import SECRET_VARIABLE, STOP_PORT_VARIABLE, TOKEN_VARIABLE
from housefly.config.site import Site, site_from_file
from housefly.config.state import edits_folder
from housefly.errors import ConfigError, HouseflyError
from housefly.room.edit_versions import EditVersions
from housefly.room.files import load_room
from housefly.web.audit_log import AuditLog
from housefly.web.connections import ConnectionLimiter, limited_protocol
from housefly.web.coverage_layer import coverage_view
from housefly.web.edit_service import EditService
from housefly.web.security import LOOPBACK_NAMES, check_bind
from housefly.web.server import create_app

_LOG = logging.getLogger(__name__)

_MAX_MESSAGE_SIZE = 16 * 1024
"""Largest message that a browser may send [bytes]."""
_PING_PERIOD = 10.0
"""A browser that neither reads nor answers for twice this long [s] is cut."""
_ACCEPTED_AT_ONCE = 8
"""Connections accepted in one turn of the loop; the rest waits, so that STOP does not."""
_BACKLOG = 512
"""Connections that may wait for it."""
_WILDCARD_ADDRESSES = frozenset({"0.0.0.0", "::"})


def main(arguments: Sequence[str] | None = None) -> int:
    """Serve the console until a signal arrives; returns the exit status."""
    options = _parser().parse_args(arguments)
    logging.basicConfig(level=logging.INFO, format="%(asctime)s %(name)s %(message)s")
    # uvicorn raises the signal again after it has ended; the bus must still close then.
    signal.signal(signal.SIGTERM, _exit)
    try:
        site = site_from_file(options.site)
        folder = options.site.parent
        serving = run_web(
            site,
            options.bus,
            options.host,
            options.port,
            insecure=options.insecure,
            names=options.name,
            folder=folder,
        )
        asyncio.run(serving)
    except HouseflyError as error:
        print(error, file=sys.stderr)
        return 1
    return 0


async def run_web(
    site: Site,
    endpoint: str,
    host: str | None = None,
    port: int | None = None,
    *,
    insecure: bool = False,
    names: Sequence[str] = (),
    folder: Path = Path(),
) -> None:
    """Serve the console of a site on its bus until cancelled or signalled.

    Args:
        site: says where to listen.
        endpoint: zenoh endpoint of the pilot.
        host: address to listen on instead of the site's.
        port: TCP port instead of the site's; 0 takes a free one.
        insecure: allow an address that other machines reach.
        names: further host names to answer to.
        folder: of the site file, for relative paths.

    Raises:
        ConfigError: the address is not allowed or taken, or a secret is missing.
    """
    host, port = host or site.web.host, site.web.port if port is None else port
    check_bind(host, insecure=insecure)
    if host in _WILDCARD_ADDRESSES and not names:
        raise ConfigError(
            "web.host",
            f"is {host!r}: say with --name under which names browsers will ask for the console",
        )
    token = os.environ.get(TOKEN_VARIABLE) or secrets.token_urlsafe(24)
    stop = _stop_sender()
    with _listening(host, port) as listener, ZenohBus(connect=endpoint) as bus:
        app = create_app(
            bus,
            token,
            lambda: stop.send().add_done_callback(_report_stop),
            hosts=LOOPBACK_NAMES | {host, *names},
            secret=os.environ.get(SECRET_VARIABLE, ""),
            drone_body=site.tracking.body,
            furniture=site.furniture,
            coverage=lambda: coverage_view(
                load_room(site.room.model, folder), site.map.flight_height
            ),
            edits=EditService(
                lambda: load_room(site.room.model, folder), site, EditVersions(edits_folder(site))
            ),
            audit=AuditLog(edits_folder(site).with_name("commands.jsonl")),
        )
        address = f"http://{f'[{host}]' if ':' in host else host}:{listener.getsockname()[1]}"
        # Later collections skip what lives for the whole run, so that nobody waits for them.
        gc.freeze()
        print(f"console ready: {address}/?token={token}", flush=True)
        await make_server(app).serve([listener])


def make_server(app: Starlette) -> uvicorn.Server:
    """Return the HTTP server; it exits within a second even while browsers are connected."""
    return _Server(
        uvicorn.Config(
            app,
            log_level="warning",
            access_log=False,
            server_header=False,
            http=limited_protocol(ConnectionLimiter()),
            ws="websockets-sansio",
            ws_max_size=_MAX_MESSAGE_SIZE,
            ws_ping_interval=_PING_PERIOD,
            ws_ping_timeout=_PING_PERIOD,
            backlog=_ACCEPTED_AT_ONCE,
            ws_per_message_deflate=False,
            timeout_graceful_shutdown=1,
        )
    )


class _Server(uvicorn.Server):
    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        await super().startup(sockets)
        for listener in sockets or ():
            listener.listen(_BACKLOG)  # asyncio takes one number for both


def _exit(number: int, frame: FrameType | None) -> None:
    raise SystemExit(0)


def _listening(host: str, port: int) -> socket.socket:
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    # Without the protocol asyncio leaves Nagle on, and every answer waits 40 ms for an
    # acknowledgement.
    listener = socket.socket(family, socket.SOCK_STREAM, socket.IPPROTO_TCP)
    try:
        listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        listener.bind((host, port))
        # Browsers that connect before the application is up wait instead of being refused.
        listener.listen()
    except OSError as error:
        listener.close()
        raise ConfigError(
            "web.port",
            f"cannot listen on {host} port {port} ({error.strerror}); choose another port",
        ) from error
    return listener


def _report_stop(outcome: Future[bool]) -> None:
    if not outcome.result():
        _LOG.warning("STOP was not acknowledged on its own path; it also went over the bus")


def _stop_sender() -> StopSender:
    try:
        return StopSender(
            "127.0.0.1", int(os.environ[STOP_PORT_VARIABLE]), os.environ[SECRET_VARIABLE]
        )
    except (KeyError, ValueError) as error:
        raise ConfigError(
            "environment", f"{error}: the console is started by `housefly run` or `housefly demo`"
        ) from error


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python -m housefly.web.process", description="Serve the console of one site."
    )
    parser.add_argument("--site", type=Path, required=True, help="site file")
    parser.add_argument(
        "--bus", required=True, help="zenoh endpoint of the pilot, unixsock-stream/PATH"
    )
    parser.add_argument("--host", help="address to listen on instead of the site's")
    parser.add_argument(
        "--port", type=int, help="TCP port instead of the site's; 0 takes a free one"
    )
    parser.add_argument(
        "--name",
        action="append",
        default=[],
        help="further host name to answer to; may be repeated",
    )
    parser.add_argument(
        "--insecure",
        action="store_true",
        help="allow an address that other machines reach, without encryption",
    )
    return parser


if __name__ == "__main__":
    sys.exit(main())
