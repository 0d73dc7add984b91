"""The console's server as one ASGI application.

/                the console (with ``?token=`` : exchanges a one-time link for a session)
/login, /logout  POST: a user's name and password for a session, and its end
/account         who one is, and the way out
/static/...      the built client
/service-worker.js  keeps the page's shell on a phone; ``/authority.crt``: whom a phone is to trust
/socket          WebSocket: state to the browser, orders from it
/stop            POST: STOP, for a browser whose socket is down, and programs; ``/land`` lands
/drones          the drones of the room; ``?drone=NAME`` picks one in all of these, STOP is for all
/video           WebSocket: the drone's H.264; ``/video.mjpeg`` the same as JPEG
/coverage        which parts of the room the tracking cameras see
/flights         flights that can be looked at again; ``/flights/{id}`` one of them
/api/v1/...      the room: where things are, what happened; the tasks: asked for, shown, ended
/edits           places and no-fly zones: shown, saved, undone, put into use
/bell            the doorbell of a simulated room; POST presses it
/rosbridge       WebSocket: rosbridge v2, where the site asks for it
/simulation      what else may be done to it: put back, charge, walk, fail; POST does it
"""

from __future__ import annotations

import asyncio
import logging
import secrets
import signal
from collections.abc import AsyncIterator, Callable, Mapping, Sequence
from contextlib import AbstractAsyncContextManager, asynccontextmanager, suppress
from dataclasses import dataclass, field
from pathlib import Path

from starlette.applications import Starlette
from starlette.middleware import Middleware

from housefly.bus.bus import Bus
from housefly.bus.topics import DroneTopics
from housefly.clock import Clock, RealClock
from housefly.config.drone import DroneConfig
from housefly.config.furniture import FurnitureConfig
from housefly.config.limits import LimitsConfig
from housefly.config.tracking import DRONE_BODY
from housefly.evidence.live_blanker import LiveBlanker
from housefly.web.access.audit_log import AuditLog
from housefly.web.access.logins import Logins
from housefly.web.access.page_routes import page_routes
from housefly.web.access.reading_pace import ReadingPace
from housefly.web.access.refused_changes import RefusedChanges
from housefly.web.access.role_guard import RoleGuard
from housefly.web.access.security import LOOPBACK_NAMES, HostGuard
from housefly.web.access.session import EndedSessions
from housefly.web.access.session_auth import SessionAuth, api_key
from housefly.web.access.session_pages import session_routes
from housefly.web.access.users import UserBook
from housefly.web.api.bell_routes import BellRoutes
from housefly.web.api.clip_files import ClipBook, ClipFiles
from housefly.web.api.coverage_layer import CoverageLayer, CoverageView
from housefly.web.api.coverage_routes import coverage_routes
from housefly.web.api.edit_service import EditService
from housefly.web.api.edits_api import EditsApi
from housefly.web.api.room_api import RoomApi
from housefly.web.api.simulated_bell import SimulatedBell
from housefly.web.api.simulated_room import SimulatedRoom
from housefly.web.api.simulation_routes import SimulationRoutes
from housefly.web.api.tasks_api import TasksApi
from housefly.web.camera.video import VideoRelay
from housefly.web.camera.video_routes import video_routes
from housefly.web.control.pilot_link import PilotLink
from housefly.web.flights.flight_book import FlightBook
from housefly.web.flights.flight_log_writer import FlightLogWriter
from housefly.web.flights.flight_routes import flight_routes
from housefly.web.messages.server_messages import EventView
from housefly.web.rosbridge.bridge_room import BridgeRoom
from housefly.web.rosbridge.routes import RosbridgeRoute
from housefly.web.sockets.broadcast import Broadcast
from housefly.web.sockets.console import Console
from housefly.web.sockets.console_routes import console_routes
from housefly.web.sockets.consoles import Consoles
from housefly.web.status.console_memory import ConsoleMemory
from housefly.web.status.state_feed import StateFeed
from housefly.web.status.task_feed import TaskFeed

_LOG = logging.getLogger(__name__)


@dataclass(frozen=True, slots=True)
class ConsoleDrone:
    """A drone as the console has it.

    Attributes:
        config: of the drone.
        body: its name among the tracked bodies.
        stop: sends STOP to it on its own path; as that of ``create_app``.
        memory: keeps control, STOP and the event log over a restart; None forgets them.
        flights: folder into which its flights are kept; None keeps none.
        privacy: blanks the privacy zones in its video; None where there are none.
        limits: of its flights.
    """

    config: DroneConfig
    body: str
    stop: Callable[[], object]
    memory: ConsoleMemory | None = None
    flights: Path | None = None
    privacy: LiveBlanker | None = None
    limits: LimitsConfig = field(default_factory=LimitsConfig)


def create_app(
    bus: Bus,
    token: str,
    stop: Callable[[], object],
    *,
    hosts: frozenset[str] = LOOPBACK_NAMES,
    secret: str = "",
    drone_body: str = DRONE_BODY,
    drone: DroneConfig | None = None,
    limits: LimitsConfig | None = None,
    furniture: tuple[FurnitureConfig, ...] = (),
    clock: Clock | None = None,
    coverage: Callable[[], CoverageView] | None = None,
    edits: EditService | None = None,
    audit: AuditLog | None = None,
    users: UserBook | None = None,
    ended: EndedSessions | None = None,
    clips: ClipBook | None = None,
    hook_key: str = "",
    privacy: LiveBlanker | None = None,
    bell: SimulatedBell | None = None,
    simulation: SimulatedRoom | None = None,
    memory: ConsoleMemory | None = None,
    flights: Path | None = None,
    site_name: str = "",
    guest_address: str = "",
    authority: bytes | None = None,
    beside: Sequence[ConsoleDrone] = (),
    rosbridge: BridgeRoom | None = None,
) -> Starlette:
    """Build the application.

    Args:
        bus: where the pilot is.
        token: one-time token of the first link.
        stop: sends STOP on its own path, past the bus; must return at once. A future that it
            returns tells whether the pilot acknowledged it.
        hosts: names that the server answers to.
        secret: key of the sessions; the same secret keeps browsers logged in over a restart. Empty
            makes a fresh one.
        drone_body: name of the drone among the tracked bodies.
        drone: the drone, or that there is none; None for the usual one.
        limits: of its flights; None for the usual ones.
        furniture: furniture that the tracking system sees.
        clock: the server's clock; real time by default.
        coverage: computes what the tracking cameras see, on a thread; None when nobody knows.
        audit: where every command is written down; None writes nothing.
        edits: where places and zones are edited; None where they are not.
        users: who may log in; None for nobody.
        ended: sessions that are over.
        clips: knows the clips and snapshots; None shows none.
        hook_key: bearer token of webhooks; "" lets none in.
        privacy: blanks the privacy zones in the video; None where there are none.
        bell: the doorbell of a simulated room; None where the room is real.
        simulation: the simulated room itself; likewise.
        memory: keeps control, STOP and the event log over a restart; None forgets them.
        flights: folder into which flights are kept, to be looked at again; None keeps none.
        site_name: of the site, for those.
        guest_address: where other machines open the console; "" where they cannot.
        authority: the certificate that they are to trust, in DER; None when there is none.
        beside: further drones; the one above is what a browser sees first.
        rosbridge: the room for clients of rosbridge; None serves them nothing.
    """
    clock = clock or RealClock()
    auth = SessionAuth(token, secret or secrets.token_urlsafe(32), users, ended, clock)
    logins = Logins(users, clock, audit) if users else None
    own, usual = drone or DroneConfig(), limits or LimitsConfig()
    first = ConsoleDrone(own, drone_body, stop, memory, flights, privacy, usual)
    drones = {one.config.name: one for one in (first, *beside)}
    board, closing = TaskFeed(bus, clock), list[Callable[[], None]]()

    def console_of(one: ConsoleDrone) -> Console:
        link = PilotLink(bus, DroneTopics(one.config.name), one.stop, clock)
        kept = FlightLogWriter(one.flights, site_name) if one.flights else None
        keep_event = one.memory.keep_event if one.memory else _forget
        feed = StateFeed(clock, one.body, furniture, keep_event, kept, one.config, one.limits)
        name = one.config.name if beside else ""
        console = Console(
            feed, link, auth, clock, audit, board, one.memory, guest_address, name, bool(simulation)
        )
        closing.extend([link.close, lambda: console.refusals.write_counted(at_the_end=True)])
        closing.extend(part.close for part in (one.memory, kept) if part is not None)
        return console

    consoles = Consoles({name: console_of(one) for name, one in drones.items()})
    relays = {
        name: VideoRelay(bus, one.privacy, board.mode, DroneTopics(name))
        for name, one in drones.items()
    }
    books = {name: FlightBook(one.flights) for name, one in drones.items() if one.flights}
    chosen = first.config.name
    layer = CoverageLayer(coverage) if coverage else None
    key = api_key(secret) if secret else ""
    room_api = RoomApi(bus, auth, key)
    tasks_api = TasksApi(
        bus,
        auth,
        clock,
        key=key,
        hook_key=hook_key,
        name_of=consoles.name_of_owner,
        audit=audit,
    )
    clip_routes = ClipFiles(clips, auth, key, consoles.name_of_owner, audit).routes()
    edits_api = EditsApi(edits, auth, consoles, lambda: consoles.restart_objection(board.message()))
    bell_routes = BellRoutes(bell, auth)
    simulation_routes = SimulationRoutes(simulation, auth, consoles.named)
    bridge = None
    if rosbridge is not None:
        bridge = RosbridgeRoute(
            rosbridge, auth, key, consoles.stop, consoles.name_of_owner, audit, clock
        )
        closing.append(bridge.close)
    closing += [room_api.close, edits_api.close, tasks_api.close, board.close, bell_routes.close]
    closing += [simulation_routes.close]
    closing += [layer.close] if layer else []
    closing += [audit.close] if audit else []
    closing += [clips.close] if clips else []
    closing += [logins.close] if logins else []
    return Starlette(
        routes=[
            *page_routes(auth, logins, authority, several_drones=bool(beside)),
            *session_routes(auth, logins, audit),
            *console_routes(consoles, auth, key),
            *video_routes({"": relays[chosen], **relays}, auth),
            *coverage_routes(layer, auth),
            *flight_routes({**({"": books[chosen]} if chosen in books else {}), **books}, auth),
            *room_api.routes([*tasks_api.routes(), *clip_routes]),
            *edits_api.routes(),
            *bell_routes.routes(),
            *simulation_routes.routes(),
            *(bridge.routes() if bridge else ()),
        ],
        middleware=[
            Middleware(HostGuard, hosts=hosts),
            Middleware(RefusedChanges, auth, consoles.name_of_owner, consoles.first.refusals),
            Middleware(ReadingPace, auth, clock),
            Middleware(RoleGuard, auth=auth),
        ],
        lifespan=_lifespan(bus, consoles, board, relays, closing, rosbridge),
    )


def _forget(event: EventView) -> None:
    pass


def _lifespan(
    bus: Bus,
    consoles: Consoles,
    board: TaskFeed,
    relays: Mapping[str, VideoRelay],
    closing: list[Callable[[], None]],
    rosbridge: BridgeRoom | None,
) -> Callable[[Starlette], AbstractAsyncContextManager[None]]:
    """Return what listens and broadcasts while the application runs, then calls ``closing``."""

    @asynccontextmanager
    async def running(app: Starlette) -> AsyncIterator[None]:
        for console in consoles.values():
            console.feed.listen(bus)
        board.listen()
        if rosbridge is not None:
            rosbridge.begin()
        for video in relays.values():
            video.listen(asyncio.get_running_loop())
        tasks = [asyncio.create_task(Broadcast(console).run()) for console in consoles.values()]
        for task in tasks:
            task.add_done_callback(_exit_on_failure)
        yield
        for task in tasks:
            task.cancel()
        for task in tasks:
            with suppress(asyncio.CancelledError):
                await task
        for close in closing:
            close()

    return running


def _exit_on_failure(task: asyncio.Task[None]) -> None:
    """End the process when broadcasting failed: a console with stale data must not stay up.

    The launcher starts a fresh one.
    """
    if not task.cancelled() and (error := task.exception()) is not None:
        _LOG.critical("the console cannot go on", exc_info=error)
        # The launcher blocks it, so that the console stays until the drone is down.
        signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGTERM})
        signal.raise_signal(signal.SIGTERM)
