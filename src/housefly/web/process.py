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
import ssl
import sys
from collections.abc import Sequence
from concurrent.futures import Future
from functools import partial
from pathlib import Path
from types import FrameType

import uvicorn
from starlette.applications import Starlette

from housefly.bus.bus import Bus
from housefly.bus.stop_sender import StopSender
from housefly.bus.topics import USE_EDITS_QUERY
from housefly.bus.zenoh_bus import ZenohBus
from housefly.config.environment import (
    SECRET_VARIABLE,
    STOP_PORTS_VARIABLE,
    TOKEN_VARIABLE,
    stop_ports_of_text,
)
from housefly.config.process_log import log_line
from housefly.config.site import Site, changed, site_from_file
from housefly.config.state import (
    clips_folder,
    edits_folder,
    flights_folder,
    users_file,
    webhook_key_file,
)
from housefly.errors import ConfigError, HouseflyError, LinkError
from housefly.evidence.clip_index import ClipIndex
from housefly.evidence.live_blanker import LiveBlanker
from housefly.room.edit_versions import EditVersions
from housefly.room.files import load_room
from housefly.sites.loaded_site import open_site
from housefly.web.access.audit_log import AuditLog
from housefly.web.access.exposure import checked_exposure, console_address, guest_address
from housefly.web.access.session import EndedSessions
from housefly.web.access.tls import authority_of
from housefly.web.access.users import UserBook
from housefly.web.access.webhook_key import webhook_key
from housefly.web.api.coverage_layer import coverage_view
from housefly.web.api.edit_service import EditService
from housefly.web.api.simulated_bell import SimulatedBell
from housefly.web.api.simulated_room import SimulatedRoom
from housefly.web.console_port import inherited_listener, listening
from housefly.web.http.connections import ConnectionLimiter, limited_protocol
from housefly.web.http.handshakes import HandshakeListener
from housefly.web.rosbridge.bridge_room import BridgeRoom
from housefly.web.server import ConsoleDrone, create_app
from housefly.web.status.console_memory import ConsoleMemory

_LOG = logging.getLogger(__name__)

_MAX_MESSAGE_SIZE = 16 * 1024
"""Largest message that a browser may send [bytes]."""
_PING_PERIOD = 10.0
"""A browser that neither reads nor answers for twice this long [s] is cut."""
_ACCEPTED_AT_ONCE = 8
"""Connections accepted in one turn of the loop; the rest waits, so that STOP does not."""
_USE_PATIENCE = 10.0
"""How long the launcher may check new edits [s]."""
_BACKLOG = 512
"""Connections that may wait for it."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Serve the console until a signal arrives; returns the exit status."""
    options = _parser().parse_args(arguments)
    logging.basicConfig(level=logging.INFO, format="%(asctime)s %(name)s %(message)s")
    # uvicorn raises the signal again after it has ended; the bus must still close then.
    signal.signal(signal.SIGTERM, _exit)
    try:
        site = site_from_file(options.site)
        folder = options.site.parent
        if options.port is not None:
            site = changed(site, web__port=options.port)
        asyncio.run(run_web(site, options.bus, folder, options.site, options.listener))
    except HouseflyError as error:
        log_line(str(error), sys.stderr)
        return 1
    return 0


async def run_web(
    site: Site,
    endpoint: str,
    folder: Path = Path(),
    site_file: Path | None = None,
    descriptor: int | None = None,
) -> None:
    """Serve the console of a site on its bus until cancelled or signalled.

    Args:
        site: says where to listen; port 0 takes a free one.
        endpoint: zenoh endpoint of the pilot.
        folder: of the site file, for relative paths.
        site_file: the run's own, which its launcher keeps as it is flown; None where there is
            none.
        descriptor: of the listening socket that its launcher holds; None opens one.

    Raises:
        ConfigError: the address is not allowed or taken, or a secret is missing.
    """
    exposure = checked_exposure(site)
    certificate = exposure.certificate
    token = os.environ.get(TOKEN_VARIABLE) or secrets.token_urlsafe(24)
    stop = _stop_senders()
    with _listener(site, descriptor) as listener, ZenohBus(connect=endpoint) as bus:
        site = changed(site, web__port=listener.getsockname()[1])
        drones = _drones(site, folder, stop)
        app = create_app(
            bus,
            token,
            drones[0].stop,
            hosts=exposure.names,
            secret=os.environ.get(SECRET_VARIABLE, ""),
            drone_body=drones[0].body,
            drone=drones[0].config,
            limits=drones[0].limits,
            beside=drones[1:],
            furniture=site.furniture,
            coverage=lambda: coverage_view(
                load_room(site.room.model, folder), site.map.flight_height
            ),
            edits=_edit_service(site, folder, bus, site_file),
            audit=AuditLog(edits_folder(site).with_name("commands.jsonl")),
            users=UserBook(users_file(site)),
            ended=EndedSessions(folder / "ended-sessions"),
            clips=_clip_index(site),
            hook_key=_hook_key(site),
            privacy=drones[0].privacy,
            bell=SimulatedBell(bus) if site.twin.enabled else None,
            simulation=SimulatedRoom(bus) if site.twin.enabled else None,
            memory=drones[0].memory,
            flights=drones[0].flights,
            rosbridge=_rosbridge(site, bus, site_file),
            site_name=site.name,
            guest_address=guest_address(site),
            authority=authority_of(site.web),
        )
        # Later collections skip what lives for the whole run, so that nobody waits for them.
        gc.freeze()
        log_line(f"console ready: {console_address(site)}")
        await make_server(app, certificate.context if certificate else None).serve([listener])


def make_server(app: Starlette, tls: ssl.SSLContext | None = None) -> uvicorn.Server:
    """Return the HTTP server; it exits within a second even while browsers are connected.

    Args:
        app: what it serves.
        tls: encrypts every connection; None for plain HTTP.
    """
    limiter = ConnectionLimiter()
    config = uvicorn.Config(
        app,
        log_level="warning",
        access_log=False,
        server_header=False,
        proxy_headers=False,  # anybody could write them, and with them another address
        http=limited_protocol(limiter),
        ws="websockets-sansio",
        ws_max_size=_MAX_MESSAGE_SIZE,
        ws_ping_interval=_PING_PERIOD,
        ws_ping_timeout=_PING_PERIOD,
        backlog=_ACCEPTED_AT_ONCE,
        ws_per_message_deflate=False,
        timeout_graceful_shutdown=1,
    )
    config.load()
    config.ssl = tls
    return _Server(config, limiter)


class _Server(uvicorn.Server):
    def __init__(self, config: uvicorn.Config, limiter: ConnectionLimiter) -> None:
        super().__init__(config)
        self._limiter = limiter

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        for listener in sockets or ():
            if isinstance(listener, HandshakeListener):
                self._limiter.on_connection = listener.finished
        await super().startup(sockets)
        for listener in sockets or ():
            listener.listen(_BACKLOG)  # asyncio takes one number for both


def _exit(number: int, frame: FrameType | None) -> None:
    raise SystemExit(0)


def _listener(site: Site, descriptor: int | None) -> HandshakeListener:
    if descriptor is None:
        return listening(site.web.host, site.web.port)
    return inherited_listener(descriptor)


def _drones(site: Site, folder: Path, stop: dict[str, StopSender]) -> tuple[ConsoleDrone, ...]:
    """Return the drones of a site, the one that is seen first in front; the only one for none.

    What the first keeps lies where that of the only one does, that of the others beside it.
    """
    names = site.drone_names or (site.drone.name,)
    found = []
    for number, name in enumerate(names):
        own, beside = site.for_drone(name), (name,) if number else ()
        if beside:
            folder.joinpath(name).mkdir(mode=0o700, exist_ok=True)
        found.append(
            ConsoleDrone(
                own.drone,
                own.tracking.body,
                partial(_sent, stop[name]),
                ConsoleMemory(folder.joinpath(*beside)),
                flights_folder(site).joinpath(*beside),
                LiveBlanker(site.tasks, own.drone.airframe.capabilities.camera),
                own.limits,
            )
        )
    return tuple(found)


def _sent(sender: StopSender) -> Future[bool]:
    return _reported(sender.send())


def _reported(sent: Future[bool]) -> Future[bool]:
    sent.add_done_callback(_report_stop)
    return sent


def _report_stop(outcome: Future[bool]) -> None:
    if not outcome.result():
        _LOG.warning("STOP was not acknowledged on its own path; it also went over the bus")


def _edit_service(site: Site, folder: Path, bus: Bus, site_file: Path | None) -> EditService:
    return EditService(
        lambda: load_room(site.room.model, folder),
        site,
        EditVersions(edits_folder(site)),
        in_force=lambda: (site_from_file(site_file) if site_file else site).edits,
        use=lambda number: _asked_to_use(bus, number),
    )


def _rosbridge(site: Site, bus: Bus, site_file: Path | None) -> BridgeRoom | None:
    """Return the room for rosbridge, by the site as its launcher flies it now."""
    if not site.rosbridge.enabled:
        return None
    return BridgeRoom(
        bus,
        lambda: open_site(site_from_file(site_file) if site_file else site),
        (lambda: site_file.stat().st_mtime_ns) if site_file else lambda: None,
        site.rosbridge.requests,
        site.rosbridge.origins,
    )


def _asked_to_use(bus: Bus, number: int) -> str:
    try:
        return bus.ask(USE_EDITS_QUERY, str(number), _USE_PATIENCE)
    except LinkError:
        return "nothing here can start the pilot again: it counts from the next start of Housefly"


def _clip_index(site: Site) -> ClipIndex | None:
    """Return the index of the clips, or None when there is none that can be read."""
    if not site.tasks.enabled:
        return None
    try:
        return ClipIndex(clips_folder(site), site.tasks)
    except HouseflyError as error:
        _LOG.error("no clips are shown: %s", error)
        return None


def _hook_key(site: Site) -> str:
    try:
        return webhook_key(webhook_key_file(site)) if site.tasks.enabled else ""
    except OSError as error:
        _LOG.error("no webhook is let in: its key cannot be kept: %s", error.strerror)
        return ""


def _stop_senders() -> dict[str, StopSender]:
    """Return a sender for each drone that is flown, by its name."""
    try:
        ports = stop_ports_of_text(os.environ[STOP_PORTS_VARIABLE])
        secret = os.environ[SECRET_VARIABLE]
        return {name: StopSender("127.0.0.1", port, secret) for name, port in ports.items()}
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
    parser.add_argument(
        "--port", type=int, help="TCP port instead of the site's; 0 takes a free one"
    )
    parser.add_argument(
        "--listener", type=int, help="file descriptor of a socket that listens, instead of its own"
    )
    return parser


if __name__ == "__main__":
    sys.exit(main())
