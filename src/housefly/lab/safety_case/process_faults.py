"""Faults that happen to the parts of a running system: they are killed, or stand still."""

from __future__ import annotations

import signal
import time
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

import psutil

from housefly.record.truth import TRUTH_FILE, read_truth


@dataclass(frozen=True, slots=True)
class ProcessFault:
    """A signal that parts of the running system get.

    Attributes:
        modules: the parts.
        number: SIGKILL, or SIGSTOP for a while.
        stopped_for: how long a stopped process stands still [s].
    """

    modules: tuple[str, ...]
    number: signal.Signals
    stopped_for: float = 3.0

    def strike(self, launcher: int) -> None:
        """Send the signal to the parts that a launcher started, as far as they are there."""
        with suppress(psutil.NoSuchProcess):
            parts = [
                part
                for part in psutil.Process(launcher).children(recursive=True)
                if not set(self.modules).isdisjoint(part.cmdline())
            ]
            _send(self.number, parts)
            if self.number is signal.SIGSTOP:
                time.sleep(self.stopped_for)
                _send(signal.SIGCONT, parts)


def _send(number: signal.Signals, parts: list[psutil.Process]) -> None:
    for part in parts:
        with suppress(psutil.NoSuchProcess):
            part.send_signal(number)


_PILOT, _DRIVER = "housefly.app.pilot_main", "housefly.app.driver_main"
_HUB, _ROOM = "housefly.hub.process", "housefly.app.room_main"
PROCESS_FAULTS = {
    "F24/killed": ProcessFault((_PILOT,), signal.SIGKILL),
    "F24/stopped": ProcessFault((_PILOT,), signal.SIGSTOP),
    "F25/driver_killed": ProcessFault((_DRIVER,), signal.SIGKILL),
    "F25/driver_stopped": ProcessFault((_DRIVER,), signal.SIGSTOP),
    "F30/hub_killed": ProcessFault((_HUB,), signal.SIGKILL),
    "F30/hub_stopped": ProcessFault((_HUB,), signal.SIGSTOP),
    "F32/stalled_0.3s": ProcessFault((_PILOT, _DRIVER), signal.SIGSTOP, 0.3),
    "F52/room_killed": ProcessFault((_ROOM,), signal.SIGKILL),
    "F52/room_stopped": ProcessFault((_ROOM,), signal.SIGSTOP),
    "F32/stalled_1s": ProcessFault((_PILOT, _DRIVER), signal.SIGSTOP, 1.0),
}
"""What happens to processes only; the rest of the matrix is made inside the simulated room."""


def wait_for_take_off(folder: Path, timeout: float) -> bool:
    """Return whether the drone of a flight with this record rose within a time [s]."""
    deadline = time.monotonic() + timeout
    while time.monotonic() < deadline:
        truth = read_truth(folder / TRUTH_FILE)
        if truth is not None and truth.airborne.any():
            return True
        time.sleep(0.2)
    return False
