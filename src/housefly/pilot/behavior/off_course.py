"""Plans anew for a drone that was held, and has come to rest away from its reference.

The gate holds a drone that is far from where it should be. Where it then hovers, still and well
tracked, its reference would wait for it in vain, until it was landed for being held too long.
"""

from __future__ import annotations

from math import hypot

from housefly.config.limits import LimitsConfig
from housefly.geometry import distance
from housefly.messages.event_code import EventCode
from housefly.messages.flight import Event, Severity
from housefly.messages.words import Words
from housefly.pilot.behavior.collision_monitor import ON_THE_WAY
from housefly.pilot.behavior.mission import Refused, VehicleStatus
from housefly.pilot.behavior.path_progress import LAG_MAX, TrajectorySetpoint
from housefly.pilot.behavior.proposal import NOTHING, Look, MissionChange, MissionView, Proposal

REST_SPEED, REST_TIME = 0.2, 0.5
"""A drone slower than this [m/s] for this long [s] has nearly come to rest: its place is known."""


class OffCourseMonitor:
    """Watches a drone while the gate holds it; mode ``paper`` flies without."""

    def __init__(self, mission: MissionView, limits: LimitsConfig, paper: bool) -> None:
        self._mission = mission
        self._is_paper = paper
        self._pose_age_max = limits.pose_age_level
        self._rests_since: float | None = None

    def propose(self, look: Look) -> Proposal:
        """Plan anew once the drone rests off its course."""
        vehicle = look.vehicle
        if look.silent:
            return NOTHING
        if not self._is_resting_off_course(vehicle, look.target):
            self._rests_since = None
            return NOTHING
        if self._rests_since is None:
            self._rests_since = vehicle.now
        if vehicle.now - self._rests_since < REST_TIME:
            return NOTHING
        self._rests_since = None
        way = self._mission.other_way(vehicle)
        if isinstance(way, Refused):
            return NOTHING
        text = Words("came to rest off its course: going on from there")
        event = Event(vehicle.now, Severity.INFO, EventCode.OFF_COURSE, text)
        return Proposal(MissionChange.GO_AROUND, event.code, way, events=(event,))

    def _is_resting_off_course(
        self, vehicle: VehicleStatus, target: TrajectorySetpoint | None
    ) -> bool:
        state, task, estimate = self._mission.state, self._mission.task, vehicle.estimate
        is_on_way = state.phase in ON_THE_WAY and not state.stopped
        if target is None or estimate is None or self._is_paper or not is_on_way:
            return False
        is_held = vehicle.held and not vehicle.landing_forced and not task.waiting
        is_known = estimate.pose_age <= self._pose_age_max and not vehicle.consistency.refused_for
        off = distance((target.x, target.y), estimate.position[:2])
        is_still = hypot(*estimate.velocity[:2]) < REST_SPEED
        return is_held and is_known and is_still and off > LAG_MAX
