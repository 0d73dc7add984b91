"""The room that a command asks: the one that runs, or its memory when none does."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, Protocol

from housefly.app.commands.shared import add_instance_argument
from housefly.app.terminal import note_console
from housefly.errors import LinkError

if TYPE_CHECKING:
    from housefly.config.site import Site
    from housefly.hub.api.questions import Question
    from housefly.hub.client.discovery import RoomAddress

DEFAULT_SITE = "bsen"


class AnsweringRoom(Protocol):
    """A running room or its memory."""

    def ask(self, question: Question) -> Any:
        """Return the answer."""
        ...


def add_asked_site(parser: ArgumentParser) -> None:
    """Add ``--site`` and ``--instance``."""
    parser.add_argument(
        "--site",
        metavar="SITE",
        help="whose room, or memory when it does not run (default: the room started last, or"
        f" {DEFAULT_SITE})",
    )
    add_instance_argument(parser)


def found_room(options: Namespace) -> RoomAddress:
    """Return the running room that the options name; raises LinkError if there is none.

    Where several run and none is named, it is the one started last, and a note says so.
    """
    from housefly.hub.client.discovery import find, running

    if options.site or options.instance:
        return find(asked_site(options).name)
    place = find()
    others = ", ".join(other.site for other in running() if other.pid != place.pid)
    if others:
        note = f"asking {place.site}, started last; also running: {others} (--instance asks it)"
        note_console.print(note, style="dim", soft_wrap=True)
    return place


def asked_site(options: Namespace) -> Site:
    """Return the site that the options name, with what the demo adds to the shipped one."""
    from housefly.app.instance import site_of_instance
    from housefly.sites.loaded_site import read_site
    from housefly.twin.demo_site import remembered_site

    site = remembered_site(read_site(options.site or DEFAULT_SITE))
    return site_of_instance(site, options.instance or 1)


@contextmanager
def asked_room(options: Namespace) -> Iterator[AnsweringRoom]:
    """Yield the room that runs, or its memory when none does."""
    from housefly.hub.client.room_client import RoomClient

    try:
        place = found_room(options)
    except LinkError:
        with remembered_room(options) as memory:
            yield memory
    else:
        with RoomClient(place.address, place.key, socket=place.socket) as client:
            yield client


@contextmanager
def remembered_room(options: Namespace) -> Iterator[AnsweringRoom]:
    """Yield the memory of a site, and say that no room runs."""
    from housefly.hub.offline import OfflineRoom
    from housefly.sites.loaded_site import site_file

    site = asked_site(options)
    note_console.print(
        f"no room is running (start one with `housefly demo`); from the memory of {site.name}:",
        style="dim",
        soft_wrap=True,
    )
    with OfflineRoom(site, site_file(options.site or DEFAULT_SITE).parent) as memory:
        yield memory
