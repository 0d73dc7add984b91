"""Keeps our settings in the drone, and knows whether its limits are the site's.

They count as confirmed once they were written, acknowledged and read back equal; after a reboot of
the drone they do not until that was done again. A flying drone is not configured.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable

from housefly.config.limits import LimitsConfig
from housefly.drones.ardrone.handshake import Configurator
from housefly.drones.ardrone.settings import (
    is_needed_to_fly,
    maxima_in,
    maxima_of,
    setting_mismatches,
    wanted_settings,
)
from housefly.drones.ardrone.telemetry import NavdataLink
from housefly.errors import LinkError
from housefly.messages.sensing import AIRBORNE_STATUSES
from housefly.messages.stick import Maxima
from housefly.messages.words import UNSAID, Words, error_words
from housefly.wires.ardrone.navdata import StateBits

_PAUSE = 1.0
"""Pause before the drone is configured again after a failure [s]."""
_NOT_CONFIRMED = Words("the drone has not confirmed its limits yet")


class LimitsKeeper:
    """Writes the settings of a site into one drone.

    Attributes:
        texts: the drone's configuration as it reported it, by key; empty before the first time.
        maxima: what a full stick means now.
        problem: why it could not be configured; UNSAID for nothing.
    """

    def __init__(
        self,
        limits: LimitsConfig,
        configurator: Configurator,
        navdata: NavdataLink,
        *,
        full_navdata: bool,
    ) -> None:
        self.texts: dict[str, str] = {}
        self.maxima: Maxima = maxima_of(limits)
        self.problem = UNSAID
        self._limits, self._full_navdata = limits, full_navdata
        self._configurator, self._navdata = configurator, navdata
        self._mismatches: dict[str, Words] = {}
        self._is_done = False

    @property
    def confirmed(self) -> bool:
        """Whether the drone's limits are known to be ours."""
        packet = self._navdata.reports.packet
        rebooted = packet is not None and packet.has(StateBits.NAVDATA_BOOTSTRAP)
        return self._is_done and not rebooted

    @property
    def notes(self) -> tuple[Words, ...]:
        """What is not as it should be with the settings."""
        lacking = () if self._is_done else (self.problem or _NOT_CONFIRMED,)
        return (*lacking, *self._mismatches.values())

    async def write(self) -> None:
        """Write everything and read it back; raises LinkError when the drone does not answer."""
        self._is_done = False
        # each acknowledgement takes two reports; full ones come 5 ms apart, so this is quick even
        # where short ones follow
        await self._configurator.write("general:navdata_demo", False)
        await self._navdata.wait_for(lambda packet: not self._is_airborne(), None)
        await self._configurator.log_in()
        for name, value in wanted_settings(self._limits):
            await self._configurator.write(name, value)
        dump = await self._configurator.read()
        self.texts = dump.texts
        self.maxima = maxima_in(dump, maxima_of(self._limits))
        self._mismatches = setting_mismatches(dump, self._limits)
        self._is_done = not any(map(is_needed_to_fly, self._mismatches))
        self.problem = UNSAID
        if not self._full_navdata:
            await self._configurator.write("general:navdata_demo", True)

    async def keep(self, on_change: Callable[[], None]) -> None:
        """Write again after each reboot, and while the limits are not confirmed; runs for ever."""
        while True:
            await self._navdata.wait_for(
                lambda packet: packet.has(StateBits.NAVDATA_BOOTSTRAP),
                None if self._is_done else _PAUSE,
            )
            try:
                await self.write()
                on_change()
            except LinkError as error:
                self.problem = error_words(error)
                await asyncio.sleep(_PAUSE)

    def _is_airborne(self) -> bool:
        report = self._navdata.reports.telemetry
        return report is None or report.status in AIRBORNE_STATUSES
