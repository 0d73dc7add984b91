"""A room that knows where everything is flies a small drone on errands."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from housefly.hub.client.room_client import RoomClient


def connect(site: str = "", *, address: str = "", key: str = "") -> RoomClient:
    """Return a line to a room that runs on this machine, or to one at an address.

    Args:
        site: name of the site; "" takes the room that was started last.
        address: of a console elsewhere, for example http://10.0.0.7:8080, with its ``key``.
        key: bearer token of that run.

    Raises:
        LinkError: no room is running here.
    """
    from housefly.hub.client.room_client import RoomClient
    from housefly.hub.client.discovery import find

    if address:
        return RoomClient(address, key)
    place = find(site)
    return RoomClient(place.address, place.key, port=place.port)
