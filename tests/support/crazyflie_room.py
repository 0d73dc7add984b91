"""A simulated Crazyflie on its real port in real time, tracked, and somebody at the sticks."""

from __future__ import annotations

from collections.abc import AsyncIterator
from contextlib import AbstractAsyncContextManager, asynccontextmanager

from driven_room import DrivenRoom, driven_rooms

from housefly.config.site import Site
from housefly.drones.crazyflie.driver import Crazyflie
from housefly.twin.crazyflie.firmware import CrazyflieFirmware
from housefly.twin.crazyflie.server import CrazyflieServer
from housefly.twin.link_filters import UNFILTERED, LinkFilters


class CrazyflieRoom(DrivenRoom[CrazyflieServer, Crazyflie]):
    """The room of one Crazyflie."""

    @property
    def firmware(self) -> CrazyflieFirmware:
        firmware = self.drone.firmware
        assert isinstance(firmware, CrazyflieFirmware)
        return firmware


@asynccontextmanager
async def crazyflie_room(
    address: str,
    kind: str = "crazyflie",
    filters: LinkFilters = UNFILTERED,
    steered_by: str | None = None,
) -> AsyncIterator[CrazyflieRoom]:
    """Open a room with one drone, at an address."""
    site = Site(drone={"kind": kind, "address": address, "steered_by": steered_by})
    async with crazyflie_rooms(site, filters) as (room,):
        yield room


def crazyflie_rooms(
    site: Site, filters: LinkFilters = UNFILTERED
) -> AbstractAsyncContextManager[tuple[CrazyflieRoom, ...]]:
    """Return one room with all drones of a site, each at its address and with its driver."""
    return driven_rooms(site, CrazyflieRoom, CrazyflieServer, Crazyflie, filters)
