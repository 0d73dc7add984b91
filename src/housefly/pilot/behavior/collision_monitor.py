"""Looks ahead along the path in use, and stops the drone before what stands in the way.

flying ──blocked, near──► braking ──at rest──► a way around? ──yes──► flying
   └──blocked, far──► a way around? ──no──► waiting, asks again every 0.25 s

A drone that waits for too long comes home, then lands (``mission_signals``).
"""

from __future__ import annotations

from math import hypot, inf

from housefly.config.airframe import BrakingConstants
from housefly.messages.event_code import EventCode
from housefly.messages.flight import Event, OrderKind, Phase, Severity
from housefly.messages.words import Words, figure
from housefly.pilot.behavior.commander import Commander
from housefly.pilot.behavior.mission import VehicleStatus
from housefly.pilot.behavior.navigator import Navigator, PathBlock
from housefly.pilot.behavior.path_progress import TrajectorySetpoint

BRAKING_MARGIN = 0.3
"""Beyond its stopping distance the drone begins to brake this much earlier [m]."""
REST_SPEED = 0.1
"""The drone stands when slower than this [m/s] ..."""
REST_TIMEOUT = 1.5
"""... and is taken to stand this long after it began to brake [s]."""
REPLAN_PERIOD = 0.25
"""How often a drone looks for another way [s]."""
PATIENCE_MAX = 4.0
"""A drone whose new ways are blocked again at once waits longer each time, up to this [s]."""
RELAPSE_TIME = 2.0
"""A way that is blocked so soon after it was found was none [s]."""

ON_THE_WAY = (Phase.OUTBOUND, Phase.RETURNING)


class CollisionMonitor:
    """Watches the path of one commander."""

    def __init__(
        self, commander: Commander, navigator: Navigator, braking: BrakingConstants
    ) -> None:
        self._commander, self._braking = commander, braking
        self._navigator = navigator
        self._task = commander.task
        self._reported = False
        self._asked_at = self._resumed_at = self._told_at = -inf
        self._patience = 0.0

    def step(
        self, vehicle: VehicleStatus, target: TrajectorySetpoint | None, *, paused: bool = False
    ) -> list[Event]:
        """Look ahead once.

        Args:
            vehicle: status and place of the drone.
            target: what was tracked in the last step, None while nothing was.
            paused: the drone makes way for somebody.
        """
        commander = self._commander
        if commander.task is not self._task:
            is_same = (
                self._task.profile is not None and commander.task.profile is self._task.profile
            )
            self._task, target = commander.task, target if is_same else None
        state = commander.state
        if state.phase not in ON_THE_WAY or state.stopped or vehicle.estimate is None or paused:
            return []
        if commander.task.waiting:
            return self._wait(vehicle)
        block = self._block(vehicle, target)
        if block is None:
            return []
        if block.along > braking_distance(_speed(vehicle), self._braking):
            if vehicle.now - self._asked_at < REPLAN_PERIOD:
                return []
            self._asked_at = vehicle.now
            if self._commander.go_around(vehicle) is None:
                return self._tell_detour(block, vehicle)
        return self._stop_before(block, vehicle)

    def _stop_before(self, block: PathBlock, vehicle: VehicleStatus) -> list[Event]:
        is_relapse = vehicle.now - self._resumed_at < RELAPSE_TIME
        self._patience = min(PATIENCE_MAX, max(0.5, 2.0 * self._patience)) if is_relapse else 0.0
        reason = Words(
            "{thing} is in the way, {d} m ahead", thing=block.name, d=figure(block.along, ".1f")
        )
        self._commander.wait(reason, vehicle)
        self._asked_at, self._reported = vehicle.now, False
        text = Words("{why}: stopping", why=reason)
        return [Event(vehicle.now, Severity.WARNING, EventCode.WAY_BLOCKED, text)]

    def _tell_detour(self, block: PathBlock, vehicle: VehicleStatus) -> list[Event]:
        """Say that the drone goes around, once for many small changes of its way."""
        last, self._told_at = self._told_at, vehicle.now
        if vehicle.now - last < RELAPSE_TIME:
            return []
        text = Words("{thing} is in the way: going around", thing=block.name)
        return [Event(vehicle.now, Severity.INFO, EventCode.DETOUR, text)]

    def waits_instead(self, reason: Words, vehicle: VehicleStatus) -> bool:
        """Wait for the way that a new phase lacks, if only obstacles of now close it.

        Returns whether it waits.
        """
        commander, navigator = self._commander, self._navigator
        is_returning = commander.state.phase is Phase.RETURNING
        mission = navigator.home() if is_returning else commander.state.mission
        if mission.goal is None or vehicle.place is None:
            return False
        if not navigator.is_passing(vehicle.place, mission.goal):
            return False
        commander.wait(reason, vehicle, mission)
        self._asked_at, self._reported = vehicle.now, True
        return True

    def _block(self, vehicle: VehicleStatus, target: TrajectorySetpoint | None) -> PathBlock | None:
        path, place = self._commander.task.path, vehicle.place
        if path is None or not self._commander.task.is_following or place is None:
            return None
        waypoint = min(target.waypoint, len(path.waypoints) - 1) if target else 0
        return self._navigator.block(place, path, waypoint)

    def _wait(self, vehicle: VehicleStatus) -> list[Event]:
        task = self._commander.task
        standing = _speed(vehicle) < REST_SPEED or vehicle.now - task.since > REST_TIMEOUT
        asked_lately = self._reported and vehicle.now - self._asked_at < REPLAN_PERIOD
        if not standing or asked_lately or vehicle.now - task.since < self._patience:
            return []
        self._asked_at = vehicle.now
        refused = self._commander.go_around(vehicle)
        if refused is None:
            self._resumed_at = vehicle.now
            text = Words("there is a way: going on")
            return [Event(vehicle.now, Severity.INFO, EventCode.DETOUR, text)]
        if self._reported:
            return []
        self._reported = True
        why, more = task.waiting, refused.reason
        text = Words("{why}; no way on, waiting here: {more}", why=why, more=more)
        if self._commander.state.mission.kind is OrderKind.HOME:
            text = Words("{why}; no way home, waiting here: {more}", why=why, more=more)
        return [Event(vehicle.now, Severity.WARNING, EventCode.NO_WAY, text)]


def braking_distance(speed: float, braking: BrakingConstants) -> float:
    """Return how far ahead [m] a drone at this speed [m/s] begins to brake."""
    return braking.way_to_rest(speed) + BRAKING_MARGIN


def _speed(vehicle: VehicleStatus) -> float:
    return hypot(*vehicle.estimate.velocity[:2]) if vehicle.estimate else 0.0
