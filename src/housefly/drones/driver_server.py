"""The driver's end of the socket to the pilot: commands in, reports and pictures out.

The socket lies in a folder that only this user can enter. One pilot at a time: another one is
turned away until the first is gone or has been silent for as long as the watchdog waits to land. A
pilot whose connection ends is gone: the drone brakes at once. A pilot that does not read loses
pictures and reports, never the newest ones after it reads again, and delays nothing.
"""

from __future__ import annotations

import asyncio
from pathlib import Path
from typing import TYPE_CHECKING

from housefly.bus.private_socket import check_private, is_own_user
from housefly.clock import Clock
from housefly.config.process_log import log_traceback
from housefly.drones.driver_messages import (
    DriverMessage,
    DriverStatus,
    LightOrder,
    MessageReader,
    PoseNews,
    TimedCommand,
    encode_driver_message,
)
from housefly.drones.failsafe import LAND_AFTER
from housefly.errors import LinkError, MissingPartError, WireError
from housefly.messages import Action, VideoFrame
from housefly.messages.sensing import AIRBORNE_STATUSES
from housefly.messages.words import literal

if TYPE_CHECKING:
    from housefly.drones.contract import DroneDriver

LANDING_TIMEOUT = 25.0
"""Longest time from the wish to end to the end, however long the drone takes to land [s]."""
_GOODBYE_TIME = 3.0
"""How long a pilot may stay after the drone is down [s]; it wants to hear that."""
_SETTLE_TIME = 0.5
"""How long the drone must be down [s]: a take-off sent just before may begin only now."""
_SILENCE_TIME = 2.0
"""How long a drone that was never heard is listened for [s]: it may be in the air."""
_STATUS_PERIOD = 0.25
_RECONNECT_PAUSE = 1.0
_REPORT_PERIOD = 0.008
"""Shortest time between two reports to the pilot [s]; it looks a hundred times a second."""
_BACKLOG_MAX = 16_384
_VIDEO_BACKLOG_MAX = 65_536
"""Bytes that may wait for a pilot that does not read, before more is thrown away."""


class DriverServer:
    """Runs one drone for whatever pilot connects, and brings it down in the end.

    Args:
        drone: its driver; not yet connected.
        path: of the socket.
        clock: for ages.
    """

    def __init__(self, drone: DroneDriver, path: Path, clock: Clock) -> None:
        self._drone, self._path, self._clock = drone, path, clock
        self._pilot: _PilotLink | None = None
        self._leaving = asyncio.Event()

    async def run(self) -> None:
        """Serve until ``leave`` was called and the drone is down; raises LinkError."""
        check_private(self._path.parent)
        server = await asyncio.get_running_loop().create_unix_server(
            lambda: _PilotLink(self), str(self._path)
        )
        self._drone.on_video(self._on_video)
        self._drone.on_report(self._on_report)
        tasks = [asyncio.create_task(work()) for work in (self._connect, self._tell_status)]
        try:
            await self._leaving.wait()
            await self._land()
        finally:
            for task in tasks:
                task.cancel()
            await asyncio.gather(*tasks, return_exceptions=True)
            server.close()
            if self._pilot is not None:
                self._pilot.close()
            await self._drone.close()

    def leave(self) -> None:
        """Land if necessary, then end; further calls change nothing."""
        self._drone.land_for_good()
        self._leaving.set()

    def admit(self, pilot: _PilotLink) -> bool:
        """Take a new pilot, unless there is one that lives."""
        present = self._pilot
        if present is not None and self._clock.now() - present.heard_at < LAND_AFTER:
            return False
        self._pilot = pilot
        if present is not None:
            present.close()
        report = self._drone.telemetry
        if report is not None:
            pilot.send(report, _BACKLOG_MAX)
        pilot.send(self._status(), _BACKLOG_MAX)
        return True

    def dismiss(self, pilot: _PilotLink) -> None:
        """Note that a connection ended."""
        if pilot is self._pilot:
            self._pilot = None
            self._drone.abandon()

    def hear(self, pilot: _PilotLink, messages: list[DriverMessage]) -> None:
        """Obey the newest of some commands, pass poses on, and show whether it is recorded.

        A hover that was said before it is obeyed first: it begins STOP, and the setpoint behind it
        leaves at once as a change of action does, not in its turn of the drone's stream.
        """
        if pilot is not self._pilot:
            return
        for message in messages:
            if isinstance(message, LightOrder):
                self._drone.show_recording(message.records)
            elif isinstance(message, PoseNews):
                self._drone.send_pose(message.seen)
        commands = [message for message in messages if isinstance(message, TimedCommand)]
        if not commands:
            return
        pilot.heard_at = self._clock.now()
        newest = max(reversed(commands), key=lambda timed: timed.issued_at)
        hovers = [timed for timed in commands if timed.command.action is Action.HOVER]
        for timed in (*hovers[-1:], newest):
            self._drone.send(timed.command, timed.motion, timed.issued_at)

    async def _connect(self) -> None:
        while True:
            try:
                await self._drone.connect()
            except (LinkError, MissingPartError):
                await asyncio.sleep(_RECONNECT_PAUSE)
            except Exception:
                log_traceback()
                await asyncio.sleep(_RECONNECT_PAUSE)
            else:
                return

    async def _tell_status(self) -> None:
        while True:
            if self._pilot is not None:
                self._pilot.send(self._status(), _BACKLOG_MAX)
            await asyncio.sleep(_STATUS_PERIOD)

    async def _land(self) -> None:
        """Wait until the drone is down, and the pilot has heard of it."""
        start, down_at = self._clock.now(), None
        while (now := self._clock.now()) - start < LANDING_TIMEOUT:
            report = self._drone.telemetry
            is_down = report is None or report.status not in AIRBORNE_STATUSES
            down_at = (down_at or now) if is_down else None
            settled = _SETTLE_TIME if report is not None else _SILENCE_TIME
            patience = settled if self._pilot is None else _GOODBYE_TIME
            if down_at is not None and now - down_at > patience:
                return
            await asyncio.sleep(0.02)

    def _status(self) -> DriverStatus:
        drone = self._drone
        return DriverStatus(
            drone.connected,
            drone.video_connected,
            drone.telemetry_rate_hz,
            literal(drone.problem),
            drone.capabilities,
        )

    def _on_report(self) -> None:
        pilot, now = self._pilot, self._clock.now()
        if pilot is None or now - pilot.told_at < _REPORT_PERIOD:
            return
        report = self._drone.telemetry
        if report is not None:
            pilot.told_at = now
            pilot.send(report, _BACKLOG_MAX)

    def _on_video(self, frame: VideoFrame) -> None:
        if self._pilot is not None:
            self._pilot.send(frame, _VIDEO_BACKLOG_MAX)


class _PilotLink(asyncio.Protocol):
    """One connection of a pilot.

    Attributes:
        heard_at: when its last command came [s].
        told_at: when it got its last report [s].
    """

    def __init__(self, server: DriverServer) -> None:
        self.heard_at = self.told_at = float("-inf")
        self._server = server
        self._reader = MessageReader()
        self._transport: asyncio.Transport | None = None

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        assert isinstance(transport, asyncio.Transport)
        self._transport = transport
        if not is_own_user(transport.get_extra_info("socket")) or not self._server.admit(self):
            transport.abort()

    def connection_lost(self, exc: Exception | None) -> None:
        self._transport = None
        self._server.dismiss(self)

    def data_received(self, data: bytes) -> None:
        try:
            self._server.hear(self, self._reader.feed(data))
        except WireError:
            self.close()

    def send(self, message: DriverMessage, backlog_max: int) -> None:
        """Send a message unless so many bytes wait already."""
        link = self._transport
        if link is None or link.is_closing():
            return
        if link.get_write_buffer_size() <= backlog_max:
            link.write(encode_driver_message(message))

    def close(self) -> None:
        if self._transport is not None:
            self._transport.abort()
