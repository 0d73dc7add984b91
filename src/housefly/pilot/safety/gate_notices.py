"""What people are told of the last gate: each new trouble once, and its end when it has lasted."""

from __future__ import annotations

from housefly.messages import Event, SafetyMode, Severity
from housefly.pilot.safety.gate import GateVerdict

CLEAR_AFTER = 1.0
"""Trouble that returns sooner than this is the same trouble [s]: a lossy tracking system would fill
the log otherwise.
"""


class GateNotices:
    """Remembers the trouble told last."""

    def __init__(self) -> None:
        self._reported = ""
        self._clear_since: float | None = None

    def update(self, verdict: GateVerdict, now: float) -> tuple[Event, ...]:
        """Return the events of one verdict at a time [s]."""
        if verdict.code:
            self._clear_since = None
            if verdict.code == self._reported:
                return ()
            self._reported = verdict.code
            severity = (
                Severity.FAULT
                if verdict.mode in (SafetyMode.LAND, SafetyMode.CUT)
                else Severity.WARNING
            )
            return (Event(now, severity, verdict.code, verdict.reason),)
        self._clear_since = now if self._clear_since is None else self._clear_since
        if not self._reported or now - self._clear_since < CLEAR_AFTER:
            return ()
        self._reported = ""
        return (Event(now, Severity.INFO, "safety_clear", "nothing holds the drone back any more"),)
