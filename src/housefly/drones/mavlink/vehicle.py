"""What a vehicle has told, as one report of ours. Pure."""

from __future__ import annotations

from housefly.bus.rate import Frequency
from housefly.drones.mavlink.refusals import Refusals
from housefly.geometry import Vec3, wrap_angle
from housefly.messages import DroneFault, DroneStatus, Telemetry
from housefly.messages.words import Words
from housefly.wires.mavlink.autopilots import Autopilot
from housefly.wires.mavlink.reports import (
    Answer,
    AttitudeReport,
    ChargeReport,
    Heartbeat,
    Landed,
    LandedReport,
    OriginReport,
    ParameterReport,
    Said,
    SystemState,
    VehicleReport,
)

HEARTBEAT_AGE_MAX = 3.0
"""Without a heartbeat, or a word of whether it flies, for longer its state is not known [s]: both
come each second at least.
"""
_LOW = 0.2
"""A charge below this is told as low, whatever the vehicle calls low."""
_TURN_RATE_MAX, _TURN_SLACK = 3.0, 0.05
"""It turns no faster than this [rad/s], and its heading is no rougher [rad]."""
_STATUS = {
    Landed.UNKNOWN: DroneStatus.UNKNOWN,
    Landed.ON_GROUND: DroneStatus.LANDED,
    Landed.IN_AIR: DroneStatus.FLYING,
    Landed.TAKING_OFF: DroneStatus.TAKING_OFF,
    Landed.LANDING: DroneStatus.LANDING,
}


class Vehicle:
    """Everything that one vehicle told.

    Args:
        autopilot: which one it should be.

    Attributes:
        autopilot: as given.
        mode, armed: by its newest heartbeat; -1 and False before.
        landed: by its own word.
        parameters: those that were asked for, by name.
        has_origin: its map has an origin.
        origin_at: when it said so last [s].
        refusals: what it refused.
        restarts: how often its clock went back: what was set may be lost.
        is_cut: its motors were cut by order; so until a reset, or until somebody arms it.
    """

    def __init__(self, autopilot: Autopilot) -> None:
        self.autopilot = autopilot
        self.mode, self.armed = -1, False
        self.landed = Landed.UNKNOWN
        self.parameters: dict[str, float] = {}
        self.has_origin = False
        self.origin_at = float("-inf")
        self.refusals = Refusals()
        self.restarts, self.is_cut = 0, False
        self._heartbeat_at = self._landed_at = float("-inf")
        self._found: int | None = None
        self._state = SystemState.UNKNOWN
        self._attitude: Vec3 = (0.0, 0.0, 0.0)
        self._time: float | None = None
        self._heading: float | None = None
        self._turned = 0.0
        self._charge: float | None = None
        self._motions = Frequency()

    def hear(self, report: VehicleReport, now: float) -> bool:
        """Take in a report that came now [s]; return whether the drone told how it moves."""
        match report:
            case Heartbeat():
                self._found, self._heartbeat_at = report.autopilot, now
                self.is_cut &= not (report.armed and not self.armed)
                self.mode, self.armed, self._state = report.mode, report.armed, report.state
            case AttitudeReport():
                self._move(report, now)
                return True
            case LandedReport():
                self.landed, self._landed_at = report.landed, now
            case ChargeReport():
                self._charge = self._charge if report.charge is None else report.charge
            case Answer():
                self.refusals.answered(report, now)
            case Said():
                self.refusals.said(report, now)
            case ParameterReport():
                by_bits = self.autopilot.counts_by_bits
                self.parameters[report.name] = report.by_bits if by_bits else report.value
            case OriginReport():
                self.has_origin, self.origin_at = True, now
        return False

    def _move(self, report: AttitudeReport, now: float) -> None:
        if self._time is not None and report.time < self._time - 1.0:
            self._forget()
        roll, pitch, heading = report.attitude
        if self._time is not None and self._heading is not None:
            turned = wrap_angle(heading - self._heading)
            # it takes its heading from our poses: what it takes over at once is no turn of its own
            may_turn = _TURN_RATE_MAX * abs(report.time - self._time) + _TURN_SLACK
            self._turned += turned if abs(turned) <= may_turn else 0.0
        self._attitude = roll, pitch, wrap_angle(self._turned)
        self._heading, self._time = heading, report.time
        self._motions.add(now)

    def _forget(self) -> None:
        """It started anew: what it was told, and what it told, count no more."""
        self.restarts += 1
        self.has_origin = False
        self.parameters.clear()

    def is_heard(self, now: float) -> bool:
        """Return whether its mode and arming are known now [s]."""
        return now - self._heartbeat_at < HEARTBEAT_AGE_MAX

    @property
    def is_another(self) -> bool:
        """Whether it is another autopilot than it should be."""
        return self._found is not None and self._found != self.autopilot.number

    @property
    def found(self) -> int | None:
        """The autopilot that answers, by its number; None before it does."""
        return self._found

    @property
    def knows_charge(self) -> bool:
        """Whether it ever told its charge."""
        return self._charge is not None

    def rate_hz(self, now: float) -> float:
        """Return how often it told how it moves in the second before now [s]."""
        return self._motions.rate_hz(now)

    def status(self, now: float) -> DroneStatus:
        """Return what it does now [s]."""
        if not self.is_heard(now) or now - self._landed_at > HEARTBEAT_AGE_MAX:
            return DroneStatus.UNKNOWN
        if self._state is SystemState.TERMINATED or (self.is_cut and not self.armed):
            return DroneStatus.EMERGENCY
        # motors that are off carry nothing, whatever its height says
        return _STATUS[self.landed] if self.armed else DroneStatus.LANDED

    def report(self, now: float, *, configured: bool, notes: tuple[Words, ...]) -> Telemetry | None:
        """Return the newest report, None before one came.

        Args:
            now: [s].
            configured: whether everything is set on it that must be.
            notes: what is not as it should be.
        """
        if self._time is None and not self.rate_hz(now):
            return None
        roll, pitch, heading = self._attitude
        charge = self._charge or 0.0
        return Telemetry(
            received_at=now,
            status=self.status(now),
            battery=charge,
            phi=roll,
            theta=pitch,
            psi=heading,
            faults=(DroneFault.BATTERY_LOW,) if charge < _LOW else (),
            configured=configured,
            notes=notes,
            drone_time=self._time,
        )
