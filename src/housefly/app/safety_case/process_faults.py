"""Faults that happen to the parts of a running system: they are killed, or stand still."""

from __future__ import annotations

import signal
import time
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

import psutil

from housefly.record.truth import TRUTH_FILE, read_truth

_STOPPED_FOR = 3.0
"""How long a stopped process stands still [s]."""


@dataclass(frozen=True, slots=True)
class ProcessFault:
    """A signal that a part of the running system gets.

    Attributes:
        module: the part.
        signal: SIGKILL, or SIGSTOP for a few seconds.
    """

    module: str
    signal: signal.Signals

    def strike(self, launcher: int) -> None:
        """Send the signal to the part that a launcher started; nothing when there is none."""
        with suppress(psutil.NoSuchProcess):
            for part in psutil.Process(launcher).children(recursive=True):
                if self.module in part.cmdline():
                    self._strike(part)
                    return

    def _strike(self, part: psutil.Process) -> None:
        part.send_signal(self.signal)
        if self.signal is signal.SIGSTOP:
            time.sleep(_STOPPED_FOR)
            part.send_signal(signal.SIGCONT)


PROCESS_FAULTS = {
    "F24/killed": ProcessFault("housefly.app.pilot_main", signal.SIGKILL),
    "F24/stopped": ProcessFault("housefly.app.pilot_main", signal.SIGSTOP),
    "F25/driver_killed": ProcessFault("housefly.app.driver_main", signal.SIGKILL),
    "F25/driver_stopped": ProcessFault("housefly.app.driver_main", signal.SIGSTOP),
    "F30/hub_killed": ProcessFault("housefly.hub.process", signal.SIGKILL),
    "F30/hub_stopped": ProcessFault("housefly.hub.process", signal.SIGSTOP),
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
