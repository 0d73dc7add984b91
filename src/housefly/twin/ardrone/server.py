"""A simulated AR.Drone 2.0 on its real ports of an address: UDP 5554 and 5556, TCP 21, 5551, 5555,
5559.

Clients written for the real drone can fly it; docs/wires.md, section 3, lists those that did. The
server does not advance the world; its owner does.
"""

from __future__ import annotations

import contextlib

from housefly.errors import LinkError, WireError
from housefly.twin.address import check_address
from housefly.twin.ardrone.command_server import CommandServer
from housefly.twin.ardrone.config_store import ConfigStore
from housefly.twin.ardrone.control_server import ControlServer
from housefly.twin.ardrone.ftp_server import FtpServer
from housefly.twin.ardrone.link import Counters, Link
from housefly.twin.ardrone.navdata_server import NavdataServer
from housefly.twin.ardrone.navdata_writer import NavdataWriter
from housefly.twin.ardrone.video_server import PAVE_HEADER_SIZE, VideoServer
from housefly.twin.contracts import DroneCamera, EncodedPicture, TwinDrone
from housefly.twin.link_filters import UNFILTERED, LinkFilters
from housefly.wires.ardrone import at

_LED_KEY = "leds:leds_anim"


class ArDroneServer:
    """Serves one drone of the room; all calls belong to one asyncio loop.

    Args:
        drone: what flies.
        address: IP address whose ports are taken.
        pave_header_size: 64, or 68 as some firmware sends.
        tells_vertical_speed: whether to fill navdata's vz; the real drone leaves it at 0.
        beyond_loopback: allow an address that other machines can reach.
        filters: what stands between the client and the drone.

    Raises:
        ConfigError: an address that is not loopback, without ``beyond_loopback``.
    """

    def __init__(
        self,
        drone: TwinDrone,
        address: str = "127.0.0.1",
        *,
        pave_header_size: int = PAVE_HEADER_SIZE,
        tells_vertical_speed: bool = False,
        beyond_loopback: bool = False,
        filters: LinkFilters = UNFILTERED,
    ) -> None:
        check_address("drone.address", address, beyond_loopback)
        self._address = address
        self._drone = drone
        self._link = Link()
        self._writer = NavdataWriter(self._link, tells_vertical_speed)
        self._config = ConfigStore(self._apply)
        self._control = ControlServer(self._config.describe, self._link.counters)
        self._commands = CommandServer(
            drone, self._link, self._config, self._control.answer, filters.uplink
        )
        self._navdata = NavdataServer(drone, self._link, self._writer, filters)
        self._video = VideoServer(self._link.counters, pave_header_size)
        self._ftp = FtpServer()

    @property
    def counters(self) -> Counters:
        """What happened on the ports so far."""
        return self._link.counters

    @property
    def settings(self) -> ConfigStore:
        """The drone's configuration."""
        return self._config

    @property
    def camera(self) -> DroneCamera:
        """The camera whose pictures the client wants."""
        return self._config.camera

    @property
    def viewers(self) -> int:
        """How many clients watch the video."""
        return self._video.viewers

    async def start(self) -> None:
        """Open the ports; raises LinkError when one of them cannot be had."""
        self._drone.set_limits(self._config.limits)
        try:
            await self._commands.start(self._address)
            await self._navdata.start(self._address)
            await self._video.start(self._address)
            await self._control.start(self._address)
            await self._ftp.start(self._address)
        except OSError as error:
            await self.stop()
            raise LinkError(
                f"cannot serve an AR.Drone at {self._address}: {error.strerror or error}"
            ) from error

    async def stop(self) -> None:
        """Close the ports and every connection."""
        for port in (self._ftp, self._control, self._video, self._navdata, self._commands):
            await port.stop()

    def publish(self, picture: EncodedPicture) -> None:
        """Send a picture to the clients of the video port."""
        if self._config.video_enabled:
            self._video.publish(picture)

    def _apply(self, key: str) -> None:
        if key == _LED_KEY:
            self._play_leds(str(self._config.value(_LED_KEY)))
        if key == "general:navdata_demo":
            self._link.bootstrap = False
        self._writer.demo = self._config.demo
        self._writer.demo_options = self._config.demo_options
        self._drone.set_limits(self._config.limits)

    def _play_leds(self, text: str) -> None:
        """Play what the newer form of AT*LED says: animation, float bits of Hz, seconds."""
        with contextlib.suppress(ValueError, WireError):
            animation, frequency, seconds = map(int, text.split(","))
            self._drone.play_leds(animation, at.bits_to_float(frequency), seconds)
