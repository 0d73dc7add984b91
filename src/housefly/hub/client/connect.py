"""Finds a running room and connects to it."""

from __future__ import annotations

from housefly.hub.client.discovery import find
from housefly.hub.client.room_client import RoomClient


def connect(site: str = "", *, address: str = "", key: str = "") -> RoomClient:
    """Connect to a room that runs on this machine, or to one at an address.

    Args:
        site: name of the site; "" for the room that was started last.
        address: of a console elsewhere, for example http://10.0.0.7:8080, with its ``key``.
        key: bearer token of that run.

    Raises:
        LinkError: no room is running here.
    """
    if address:
        return RoomClient(address, key)
    place = find(site)
    return RoomClient(place.address, place.key, socket=place.socket)
