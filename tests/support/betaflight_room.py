"""A simulated Betaflight on its real port in real time, tracked, and somebody at the sticks."""

from __future__ import annotations

from collections.abc import AsyncIterator
from contextlib import AbstractAsyncContextManager, asynccontextmanager

from driven_room import DrivenRoom, driven_rooms

from housefly.config.site import Site
from housefly.drones.betaflight.driver import Betaflight
from housefly.twin.betaflight.firmware import BetaflightFirmware
from housefly.twin.betaflight.server import BetaflightServer
from housefly.twin.link_filters import UNFILTERED, LinkFilters


class BetaflightRoom(DrivenRoom[BetaflightServer, Betaflight]):
    """The room of one Betaflight."""

    @property
    def firmware(self) -> BetaflightFirmware:
        firmware = self.drone.firmware
        assert isinstance(firmware, BetaflightFirmware)
        return firmware

    @property
    def is_ready(self) -> bool:
        report = self.driver.telemetry
        return super().is_ready and report is not None and report.configured


@asynccontextmanager
async def betaflight_room(
    address: str, filters: LinkFilters = UNFILTERED
) -> AsyncIterator[BetaflightRoom]:
    """Open a room with one drone, at an address."""
    site = Site(drone={"kind": "betaflight", "address": address})
    async with betaflight_rooms(site, filters) as (room,):
        yield room


def betaflight_rooms(
    site: Site, filters: LinkFilters = UNFILTERED
) -> AbstractAsyncContextManager[tuple[BetaflightRoom, ...]]:
    """Return one room with all drones of a site, each at its address and with its driver."""
    return driven_rooms(site, BetaflightRoom, BetaflightServer, Betaflight, filters)
