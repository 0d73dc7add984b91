"""Serves the page of ``housefly new NAME --page`` on this machine until Ctrl+C."""

from __future__ import annotations

import asyncio
import secrets
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

from housefly.app.new_site.opened_room import OpenedRoom
from housefly.app.run_folder import temporary_run_folder
from housefly.app.terminal import console
from housefly.messages.words import Words
from housefly.room.draft.model import DraftDrone, DraftTracking
from housefly.tracking.live_check import Heard
from housefly.web.console_port import listening
from housefly.web.new_site.draft_api import DraftApi, RoomOpener
from housefly.web.new_site.draft_service import DraftService
from housefly.web.new_site.server import create_new_site_app, new_site_session
from housefly.web.new_site.uploads import Uploads
from housefly.web.process import make_server

_HOST = "127.0.0.1"


def serve_new_page(folder: Path, port: int | None = None) -> int:
    """Serve the page for the site in a folder until Ctrl+C; returns the exit status.

    Args:
        folder: where the draft is kept and the site is written.
        port: TCP port on loopback; None takes a free one.

    Raises:
        ConfigError: the port is taken.
    """
    from housefly.app.new_site.live import check_drone, hear_tracking

    token = secrets.token_urlsafe(24)

    def announce(taken: int) -> None:
        console.print(
            f"draw {folder.name} at http://{_HOST}:{taken}/?token={token}\n"
            f"Every change is kept in {folder}; Ctrl+C ends the page.",
            markup=False,
            soft_wrap=True,
        )

    room = OpenedRoom()
    serving = serve_draft(
        folder, token, hear_tracking, check_drone, announce, room=room, port=port or 0
    )
    try:
        with suppress(KeyboardInterrupt):  # the server raises it again after it has ended
            asyncio.run(serving)
    finally:
        room.close()
    return 0


async def serve_draft(
    folder: Path,
    token: str,
    hear: Callable[[DraftTracking, float], Heard],
    check_drone: Callable[[DraftDrone], tuple[Words, ...]],
    announce: Callable[[int], None],
    *,
    room: RoomOpener,
    host: str = _HOST,
    port: int = 0,
) -> None:
    """Serve the page until cancelled or signalled.

    Args:
        folder: of the site.
        token: of the link that opens the page.
        hear: listens to a tracking system for so many seconds; blocks.
        check_drone: asks whether a drone answers; blocks.
        announce: is told the port, once browsers can connect.
        room: starts the simulated room of the site.
        host: loopback address.
        port: 0 takes a free one.
    """
    with listening(host, port) as listener, temporary_run_folder("new") as files:
        auth = new_site_session(token)
        api = DraftApi(DraftService(folder), Uploads(files), auth, hear, check_drone, room)
        announce(listener.getsockname()[1])
        app = create_new_site_app(api, auth, frozenset({host, "localhost"}))
        server = make_server(app)
        serving = asyncio.ensure_future(server.serve([listener]))
        try:
            await asyncio.shield(serving)
        except asyncio.CancelledError:
            server.should_exit = True
            await serving
            raise
