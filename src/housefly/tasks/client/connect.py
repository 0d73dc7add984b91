"""Finds a running room and connects to it."""

from __future__ import annotations

from housefly.hub.client.discovery import RoomAddress, find
from housefly.tasks.client.house_client import HouseClient


def connect(site: str = "", *, address: str = "", key: str = "") -> HouseClient:
    """Connect to a room that runs on this machine, or to one at an address.

    Args:
        site: name of the site; "" for the room that was started last.
        address: of a console elsewhere, for example http://10.0.0.7:8080, with its ``key``: the
            room and its tasks are asked over HTTP then, with the same calls.
        key: bearer token of that run.

    Raises:
        LinkError: no room is running here, or that is no address.
    """
    return HouseClient(RoomAddress(site, address, key, 0) if address else find(site))
