"""The room that a command asks: the one that runs, or its memory when none does."""

from __future__ import annotations

from argparse import ArgumentParser
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, Protocol

from housefly.app.terminal import plain_console
from housefly.errors import LinkError

if TYPE_CHECKING:
    from housefly.hub.api.questions import Question


class AnsweringRoom(Protocol):
    """A running room or its memory."""

    def ask(self, question: Question) -> Any:
        """Return the answer."""
        ...


def add_asked_site(parser: ArgumentParser) -> None:
    """Add ``--site``."""
    parser.add_argument(
        "--site",
        default="bsen",
        metavar="SITE",
        help="asked when no room is running (default: bsen)",
    )


@contextmanager
def asked_room(site: str) -> Iterator[AnsweringRoom]:
    """Yield the room that runs, or its memory when none does."""
    from housefly.hub.client.discovery import find
    from housefly.hub.client.room_client import RoomClient

    try:
        place = find()
    except LinkError:
        from housefly.app.loaded_site import read_site, site_file
        from housefly.hub.offline import OfflineRoom

        plain_console.print("no room is running: this is what its memory holds", style="dim")
        with OfflineRoom(read_site(site), site_file(site).parent) as memory:
            yield memory
    else:
        with RoomClient(place.address, place.key, socket=place.socket) as client:
            yield client
