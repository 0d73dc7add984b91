"""What tracking is held against the drone by: how well they agree, and what the drone feels.

A drone that stands feels that somebody carries it; one whose reported attitude stands still leans
by what tracking sees; each report belongs to the moment at which the drone wrote it.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import inf, isfinite, nan

from housefly.clock import ClockOffset
from housefly.geometry import Quaternion, Vec2, Vec3, euler_from_quaternion
from housefly.messages.sensing import Telemetry
from housefly.numeric import wrapped
from housefly.pilot.estimation.onboard_odometry import OnboardReport

SETTLING_TIME = 1.0
"""After touchdown, and after the first report, the sensors settle this long [s]."""
REST_TIME = 2.0
"""Time constant of what counts as rest [s]."""
TILT_STIRRED, TURN_STIRRED = 0.03, 0.05
"""Changes of attitude that no drone at rest shows [rad]."""
ACCELERATION_STIRRED = 0.8
"""Change of an acceleration that no drone at rest shows [m/s^2]: eight times its noise."""
MEMORY = 2.0
"""Motion counts for poses that were believed up to this long before it ended [s]."""

STUCK_AFTER = 0.15
"""An attitude that is the same to the last bit for so long, while the speed changes, hangs [s]."""
SEEN_MAX = 0.15
"""An older sighting does not tell how the drone leans now [s]."""
LEARNED_TIME = 2.0
"""Time constant with which it is learned by what tracking and report differ anyway [s]."""
_STEP_MAX = 0.1

Attitude = tuple[float, float, float]

OFFSET_WINDOW = 1.0
"""The quickest report of so long before tells the offset of the drone's clock [s], as for poses."""
STANDS_AFTER = 1.0
"""A clock that has not moved for this long while reports come tells nothing [s]."""


@dataclass(frozen=True, slots=True)
class TrackingConsistency:
    """Tracking held against the drone's own report; nan where nothing can be said yet.

    Attributes:
        drift: how far the tracked way has left the onboard one since both agreed last [m].
        frame_error: angle between the tracked body frame and the one that the drone flies in [rad].
        mirrored: tracked motion or turns are the mirror image of onboard ones.
        height_error: tracked height minus onboard height [m].
        height_drift: the same in the air, less the steps of the floor since it was seen last [m].
        latency_error: how much older the poses are than their stamps say [s].
        refused_for: how long poses have been refused because onboard motion disagrees [s].
        flow_untold: in the air the drone does not tell its speed, or the same to the last bit.
        flow_wrong: that speed is neither what tracking sees nor how the drone leans.
    """

    drift: float = nan
    frame_error: float = nan
    mirrored: bool = False
    height_error: float = nan
    height_drift: float = nan
    latency_error: float = nan
    refused_for: float = 0.0
    flow_untold: bool = False
    flow_wrong: bool = False

    @property
    def flow_believed(self) -> bool:
        """Whether the drone's own hover, which flies by optical flow, can be left to itself."""
        return not (self.flow_untold or self.flow_wrong)


NOTHING_KNOWN = TrackingConsistency()


@dataclass(frozen=True, slots=True)
class CarryDetector:
    """What rest looks like, and when the drone last stirred.

    Attributes:
        at: of the last report [s], None before the first.
        settled_at: when stirring begins to count [s].
        attitude: phi, theta, psi at rest [rad].
        acceleration: at rest [m/s^2], None where it is not told.
        stirred_at: when the drone moved last [s].
        told: the drone tells its attitude; one that does not may be carried unnoticed.
    """

    at: float | None = None
    settled_at: float = 0.0
    attitude: Vec3 = (0.0, 0.0, 0.0)
    acceleration: Vec3 | None = None
    stirred_at: float = -inf
    told: bool = False

    def updated(self, telemetry: Telemetry, airborne: bool) -> CarryDetector:
        """Return the detector after a report."""
        at = telemetry.received_at
        attitude = (telemetry.phi, telemetry.theta, telemetry.psi)
        told = self.told or any(attitude)
        if airborne or self.at is None or at < self.settled_at:
            settled_at = self.settled_at
            if airborne or self.at is None:
                settled_at = at + SETTLING_TIME
            return CarryDetector(
                at, settled_at, attitude, telemetry.acceleration, self.stirred_at, told
            )
        stirred = self._is_stirred(attitude, telemetry.acceleration)
        share = min((at - self.at) / REST_TIME, 1.0)
        return replace(
            self,
            at=at,
            attitude=_towards(self.attitude, attitude, share),
            acceleration=_slowly(self.acceleration, telemetry.acceleration, share),
            stirred_at=at if stirred else self.stirred_at,
            told=told,
        )

    def _is_stirred(self, attitude: Vec3, acceleration: Vec3 | None) -> bool:
        phi, theta, psi = (
            abs(wrapped(a - b)) for a, b in zip(attitude, self.attitude, strict=True)
        )
        if max(phi, theta) > TILT_STIRRED or psi > TURN_STIRRED:
            return True
        if acceleration is None or self.acceleration is None:
            return False
        changes = (abs(a - b) for a, b in zip(acceleration, self.acceleration, strict=True))
        return max(changes) > ACCELERATION_STIRRED

    def stirred_since(self, at: float) -> bool:
        """Return whether the drone may have been moved since a time [s], or cannot tell."""
        return not self.told or self.stirred_at >= at - MEMORY


def _towards(rest: Vec3, now: Vec3, share: float) -> Vec3:
    x, y, z = (a + share * wrapped(b - a) for a, b in zip(rest, now, strict=True))
    return x, y, z


def _slowly(rest: Vec3 | None, now: Vec3 | None, share: float) -> Vec3 | None:
    if rest is None or now is None:
        return now
    x, y, z = (a + share * (b - a) for a, b in zip(rest, now, strict=True))
    return x, y, z


class LeanWatch:
    """Watches the attitude that one drone reports.

    Attributes:
        is_stuck: it stands still in the air.
    """

    def __init__(self) -> None:
        self._told: Attitude = (nan, nan, nan)
        self._speed: Vec2 = (nan, nan)
        self._told_since = inf
        self._changes = 0
        self._seen: Vec2 | None = None
        self._seen_at = -inf
        self._usual: Vec2 = (0.0, 0.0)
        self.is_stuck = False

    def feel(self, report: OnboardReport) -> None:
        """Take in a report."""
        told, speed = (report.theta, report.phi, report.psi), (report.forward, report.left)
        if told != self._told:
            self._told_since, self._changes = report.at, 0
        elif speed != self._speed:
            self._changes += 1
        self._told, self._speed = told, speed
        hangs = self._changes > 1 and report.at - self._told_since >= STUCK_AFTER
        self.is_stuck = report.airborne and hangs and any(told[:2])

    def see(self, at: float, orientation: Quaternion) -> None:
        """Take in how tracking saw it lean at a time [s]."""
        phi, theta, _ = euler_from_quaternion(orientation)
        if not self.is_stuck and isfinite(self._told[0]):
            share = min(max(at - self._seen_at, 0.0), _STEP_MAX) / LEARNED_TIME
            off = self._told[0] - theta - self._usual[0], self._told[1] - phi - self._usual[1]
            self._usual = self._usual[0] + share * off[0], self._usual[1] + share * off[1]
        self._seen, self._seen_at = (theta, phi), at

    def missing(self, now: float) -> Vec2 | None:
        """Return by how much more the drone has to be asked to lean, theta and phi [rad].

        None where its attitude is told, or nobody has seen it of late [s].
        """
        if not self.is_stuck or self._seen is None or now - self._seen_at > SEEN_MAX:
            return None
        theta, phi = self._seen
        return self._told[0] - theta - self._usual[0], self._told[1] - phi - self._usual[1]


class ReportClock:
    """Dates reports by the drone's own clock, as far as it tells it."""

    def __init__(self) -> None:
        self._offset = ClockOffset(OFFSET_WINDOW)
        self._drone_time = -inf
        self._moved_at = -inf

    def written_at(self, drone_time: float | None, received_at: float) -> float:
        """Return when a report was written [s], no later than it was received.

        Args:
            drone_time: by the drone's clock [s]; None or nan where it does not tell it.
            received_at: by ours [s].
        """
        if drone_time is None or not isfinite(drone_time):
            return received_at
        if drone_time < self._drone_time:  # it wrapped, or the drone started anew
            self._offset.reset()
        if drone_time != self._drone_time:
            self._drone_time, self._moved_at = drone_time, received_at
        elif received_at - self._moved_at > STANDS_AFTER:
            return received_at
        return drone_time + self._offset.least(received_at - drone_time, received_at)
