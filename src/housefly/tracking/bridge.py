"""Client of all tracking systems that PyPI ``motioncapture`` reads, Qualisys among them.

The library tells no capture times: they are the times of arrival less ``tracking.latency``, so
    jitter on the way moves the drone;
systems with a client of their own are better read by that. It blocks for ever when data stop, even
while connecting with the interpreter's lock held. So it runs in a child process, which is ended and
started anew when it falls silent.
"""

from __future__ import annotations

import asyncio
import importlib.util
import json
import socket
import sys
from asyncio.subprocess import PIPE, Process
from collections.abc import Callable
from contextlib import suppress

from housefly.bus.reconnect import Trouble, reconnect_for_ever
from housefly.clock import Clock, RealClock
from housefly.config.site import TrackingConfig
from housefly.errors import LinkError, MissingPartError, WireError
from housefly.tracking.bridge_lines import BridgeLines
from housefly.tracking.contracts import Sink
from housefly.tracking.counts import FrameCounts

FRESH = 1.0
"""``connected`` means a new pose within this time [s]."""
SILENCE = 5.0
"""A child that says nothing for this long [s] is ended and started anew; starting takes a second.
"""


class BridgeTracker:
    """Starts the child, hands its frames to a sink as they arrive, and starts it anew for ever.

    Attributes:
        counts: frames and what was dropped.
    """

    def __init__(self, config: TrackingConfig, clock: Clock | None = None) -> None:
        self.counts = FrameCounts()
        self._config = config
        self._clock = clock or RealClock()
        self._frame_at = float("-inf")
        self._problem = f"not connected to {self._where} yet"

    @property
    def connected(self) -> bool:
        """Whether a new pose arrived within the last second."""
        return self._clock.now() - self._frame_at <= FRESH

    @property
    def problem(self) -> str:
        """Why no poses arrive, in words, or ""."""
        if self._problem or self.connected:
            return self._problem
        return (
            f"connected to {self._where}, but no new poses arrive; is the body seen, the system not"
            " paused?"
        )

    async def run(self, sink: Sink) -> None:
        """Read for ever; ends only when cancelled."""
        await reconnect_for_ever(
            lambda: self._session(sink), lambda: self.counts.frames, self._ended
        )

    def _ended(self, error: Trouble) -> None:
        if isinstance(error, WireError):
            self.counts.malformed += 1
            self._problem = f"the bridge to {self._where} talks nonsense ({error})"
        else:
            self._problem = str(error)

    @property
    def _where(self) -> str:
        return f"{self._config.bridge_system} at {self._config.address} (by motioncapture)"

    async def _session(self, sink: Sink) -> None:
        """Read one child to its end; raises LinkError, MissingPartError or WireError."""
        if importlib.util.find_spec("motioncapture") is None:
            raise MissingPartError("motioncapture", "pip install 'housefly[mocap]'")
        child = await asyncio.create_subprocess_exec(
            *(sys.executable, "-m", "housefly.tracking.bridge_child", self._config.bridge_system),
            json.dumps(settings_of(self._config)),
            stdin=PIPE,
            stdout=PIPE,
        )
        try:
            lines = BridgeLines(self._config.latency, self._config.y_up, self.counts)
            while True:
                line = await self._line(child)
                now = self._clock.now()
                sightings = lines.read(line, now)
                self._problem = ""
                if sightings is not None:
                    self._frame_at = now
                    sink(sightings)
        finally:
            with suppress(ProcessLookupError):
                child.kill()
            await child.wait()

    async def _line(self, child: Process) -> bytes:
        assert child.stdout is not None
        try:
            async with asyncio.timeout(SILENCE):
                line = await child.stdout.readline()
        except TimeoutError as error:
            raise LinkError(
                f"{self._where} is silent; is it there, streaming, and this body seen?"
            ) from error
        except ValueError as error:
            raise WireError("bridge line: longer than 64 kB") from error
        if not line:
            raise LinkError(f"the bridge to {self._where} ended")
        return line


def settings_of(config: TrackingConfig) -> dict[str, str]:
    """Return what ``motioncapture`` wants to know about a system."""
    more: Callable[[TrackingConfig], dict[str, str]] = _SETTINGS.get(
        config.bridge_system, lambda _: {}
    )
    return {"hostname": config.address} | more(config)


def _our_address(config: TrackingConfig) -> str:
    """Return our address on the way to the system; nothing is sent."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        try:
            probe.connect((config.address, config.natnet_port))
        except OSError as error:
            raise LinkError(f"{config.address} cannot be reached ({error.strerror})") from error
        return str(probe.getsockname()[0])


_SETTINGS: dict[str, Callable[[TrackingConfig], dict[str, str]]] = {
    "vicon": lambda config: {"hostname": f"{config.address}:{config.port}"},
    "optitrack": lambda config: {
        "port_command": str(config.natnet_port),
        "interface_ip": _our_address(config),
    },
    "vrpn": lambda config: {"hostname": f"{config.address}:{config.vrpn_port}"},
}
