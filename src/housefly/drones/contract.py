"""The contract of a drone: what it can do, what it is told, and what it reports.

``Drone`` is what the pilot's shell flies, by way of ``remote_drone``; ``DroneDriver`` is what
``driver_server`` runs in the process that may die last, and what a driver implements. What a drone
complains of is ``messages.DroneFault``; what it can do is ``config.capabilities.Capabilities``.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol, runtime_checkable

from housefly.config.capabilities import Capabilities
from housefly.messages import Command, KnownMotion, Sighting, Telemetry, VideoFrame


class Drone(Protocol):
    """One drone; all calls belong to one asyncio loop."""

    @property
    def capabilities(self) -> Capabilities | None:
        """What it can do; None while its driver has not said so."""
        ...

    async def connect(self) -> None:
        """Open the wire and configure the drone; later it reconnects by itself.

        May be called again after a failure.

        Raises:
            LinkError: no answer in time.
        """
        ...

    def send(self, command: Command, motion: KnownMotion | None = None) -> None:
        """Hand over the command in force from now on; returns at once.

        Args:
            command: what the drone is to do.
            motion: how it moves, by which it is brought to rest should this be the last command;
                None says nothing new.
        """
        ...

    def send_pose(self, seen: Sighting) -> None:
        """Hand over where tracking saw the drone, for one that wants to know; returns at once.

        Its age is from ``captured_at`` to the moment at which it leaves for the drone. What no
        drone asked for (``capabilities.external_pose_rate``) is not sent.
        """
        ...

    @property
    def telemetry(self) -> Telemetry | None:
        """The newest report, or None before the first; what it does not measure is not made up."""
        ...

    @property
    def telemetry_rate_hz(self) -> float:
        """Reports per second over the last second."""
        ...

    @property
    def connected(self) -> bool:
        """Whether reports arrive."""
        ...

    @property
    def video_connected(self) -> bool:
        """Whether pictures arrive."""
        ...

    @property
    def problem(self) -> str:
        """What is wrong with drone or link, a text or words; "" for nothing."""
        ...

    def show_recording(self, records: bool) -> None:
        """Blink while the camera is recorded, where the drone can.

        To be said again every second: the light goes out by itself 1.5 s after the last time.
        """
        ...

    def on_video(self, handler: Callable[[VideoFrame], None]) -> None:
        """Call the handler with each picture from the first key frame on."""
        ...

    async def close(self) -> None:
        """Release the wire. Does not land: the pilot does that before."""
        ...


class DroneDriver(Drone, Protocol):
    """One drone on its own wire.

    The driver repeats the last command at the drone's own rate; a change of action leaves at once.
    A pilot that falls silent, is gone or comes late is its business, whatever the drone does then
    by itself (``capabilities.silence``): without a word for 0.25 s in flight it brakes and hovers,
    after 2 s it lands.
    """

    @property
    def capabilities(self) -> Capabilities:
        """What it can do, as far as is known now: a drone may tell it once it is connected."""
        ...

    def send(
        self,
        command: Command,
        motion: KnownMotion | None = None,
        issued_at: float | None = None,
    ) -> None:
        """Hand over the command in force from now on; returns at once.

        Args:
            command: what the drone is to do.
            motion: how it moves; None says nothing new.
            issued_at: when the pilot gave it [s]; now when None. What comes late or out of turn
                and moves the drone counts for nothing.
        """
        ...

    @property
    def firmware(self) -> str:
        """The version of its firmware as it reports it, or "" before that is known."""
        ...

    @property
    def notes(self) -> tuple[str, ...]:
        """What is not as it should be with the drone's settings, each a text or words."""
        ...

    def abandon(self) -> None:
        """Note that the pilot is gone: a flying drone brakes now, and lands soon."""
        ...

    def land_for_good(self) -> None:
        """Land now, and take no order any more but to cut the motors."""
        ...

    def on_report(self, handler: Callable[[], None]) -> None:
        """Call the handler after each report of the drone."""
        ...


@runtime_checkable
class CarriesDecks(Protocol):
    """A driver that looks for decks on its drone which tell it where it is."""

    @property
    def decks(self) -> tuple[str, ...]:
        """What was found when it connected, by name."""
        ...
