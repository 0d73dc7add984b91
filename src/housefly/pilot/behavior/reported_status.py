"""What the drone says it is doing, as far as it is believed.

A drone that ended its flight goes on saying so. One report that it stands or has cut its motors,
in the middle of a flight, is a damaged one: a mission that ended for it would tell untruths of a
drone that flies on. What it was told to do is believed at once: the command that cuts the motors is
a toggle, and not to be repeated.
"""

from __future__ import annotations

from dataclasses import dataclass

from housefly.messages.sensing import DroneStatus, Telemetry

_MID_FLIGHT = frozenset({DroneStatus.TAKING_OFF, DroneStatus.FLYING})
_ENDED = frozenset({DroneStatus.LANDED, DroneStatus.EMERGENCY})


@dataclass(frozen=True, slots=True)
class ReportedStatus:
    """The status that is believed.

    Attributes:
        status: what the drone does.
        unconfirmed_since: when the first report came that the flight has ended [s], while it is the
            only one; else None.
    """

    status: DroneStatus = DroneStatus.UNKNOWN
    unconfirmed_since: float | None = None

    def updated(self, telemetry: Telemetry, *, told_to_end: bool) -> ReportedStatus:
        """Return the status after a report; the end of a flight takes two in a row.

        Unless the drone was told to land, or to cut its motors. A report without a status says
        nothing new.
        """
        told, since = telemetry.status, self.unconfirmed_since
        if told is DroneStatus.UNKNOWN:
            return self
        is_first = since is None or telemetry.received_at <= since
        is_unexpected = told in _ENDED and self.status in _MID_FLIGHT and not told_to_end
        if is_first and is_unexpected:
            return ReportedStatus(self.status, telemetry.received_at)
        return ReportedStatus(told)
