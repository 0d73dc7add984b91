"""What a drone driver offers to the pilot's shell."""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

from housefly.messages import Command, KnownMotion, Telemetry, VideoFrame


class Drone(Protocol):
    """One drone on its own wire; all calls belong to one asyncio loop.

    The driver repeats the last command at the drone's own rate. Without a ``send`` for 0.25 s in
    flight it brakes and hovers, after 2 s it lands. A change of action leaves at once.
    """

    async def connect(self) -> None:
        """Open the wire and configure the drone; later it reconnects by itself.

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

    @property
    def telemetry(self) -> Telemetry | None:
        """The newest report, or None before the first."""
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
        """What is wrong with drone or link, in words, or ""."""
        ...

    @property
    def has_light(self) -> bool:
        """Whether it can show the people around it that its camera is recorded."""
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
