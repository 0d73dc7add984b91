"""How busy this machine is: late measurements look like lost ones, and their cause is here."""

from __future__ import annotations

import os
import time
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from housefly.messages.preflight import PreflightCheck
from housefly.messages.words import UNSAID, Words, figure
from housefly.pilot.behavior.preflight import MACHINE_CHECK

_PER_CORE_MAX, _PER_CORE_BUSY = 2.0, 1.5
"""So many programs for each core are too many; so many, if some wait nearly all the time."""
_WAITING_MAX = 0.9
_LATENESS_MAX = 0.1
"""A loop that must be on time comes later than this only on a machine that is overloaded [s]."""
_PRESSURE = Path("/proc/pressure/cpu")
_PROBES, _PROBE_PERIOD = 40, 0.01


@dataclass(frozen=True, slots=True)
class MachineLoad:
    """How busy a machine is.

    Attributes:
        cores: of its processor.
        running: programs that run or wait for a core, averaged over a minute; 0 when unknown.
        waiting: share of the last ten seconds in which one of them waited; 0 when unknown.
        lateness: of a loop that wants to be on time, 99th percentile [s]; 0 when unknown.
    """

    cores: int
    running: float = 0.0
    waiting: float = 0.0
    lateness: float = 0.0

    @property
    def is_too_high(self) -> bool:
        """Whether a room may be late because of it."""
        per_core = self.running / self.cores
        crowded = per_core >= _PER_CORE_BUSY and self.waiting >= _WAITING_MAX
        return per_core >= _PER_CORE_MAX or crowded or self.lateness >= _LATENESS_MAX

    @property
    def words(self) -> Words:
        """The load in words."""
        n, k = figure(self.running, ".0f"), figure(self.cores)
        load = Words("load {n} on {k} core", n=n, k=k)
        if self.cores != 1:
            load = Words("load {n} on {k} cores", n=n, k=k)
        if self.lateness < _LATENESS_MAX:
            return load
        return Words("{why}, {d} ms late", why=load, d=figure(1000.0 * self.lateness, ".0f"))

    @property
    def note(self) -> Words:
        """That it is too high, in words, or UNSAID."""
        return _FAULT if self.is_too_high else UNSAID

    def check(self) -> PreflightCheck:
        """Return the line of the pre-flight list; it forbids nothing by itself."""
        return PreflightCheck(
            code=MACHINE_CHECK,
            title=Words("this machine keeps up"),
            fault=_FAULT,
            passed=not self.is_too_high,
            required=False,
            value=self.words,
            limit=Words("a load below {n}", n=figure(_PER_CORE_MAX * self.cores, ".0f")),
            why=Words("what comes late is refused, as if it had not come"),
            mend=OVERLOAD_REMEDY,
        )


_FAULT = Words("this computer is too busy")
OVERLOAD_REMEDY = Words("end other programs; the simulated picture costs most (twin.video = false)")


def machine_load(lateness: float = 0.0) -> MachineLoad:
    """Return how busy this machine is now.

    Args:
        lateness: of a loop of the caller, as above [s].
    """
    running = 0.0
    with suppress(OSError):
        running = os.getloadavg()[0]
    return MachineLoad(os.cpu_count() or 1, running, _waiting(), lateness)


def measured_lateness() -> float:
    """Return how late a short sleep ends here, 99th percentile [s]; takes half a second."""
    late = []
    for _ in range(_PROBES):
        due = time.monotonic() + _PROBE_PERIOD
        time.sleep(_PROBE_PERIOD)
        late.append(time.monotonic() - due)
    return sorted(late)[-2]


def _waiting() -> float:
    """Return the share of time in which a program waited for a core: Linux' pressure stall."""
    with suppress(OSError, ValueError):
        for line in _PRESSURE.read_text(encoding="ascii").splitlines():
            kind, *fields = line.split()
            named = dict(field.split("=") for field in fields)
            if kind == "some":
                return float(named.get("avg10", 0.0)) / 100.0
    return 0.0
