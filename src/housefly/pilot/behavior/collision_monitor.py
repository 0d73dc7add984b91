"""Looks ahead along the path in use, and stops the drone before what stands in the way.

flying ──blocked, near──► braking ──at rest──► a way around? ──yes──► flying
   └──blocked, far──► a way around? ──no──► waiting, asks again every 0.25 s

A drone that waits for too long comes home, then lands (``mission_signals``).
"""

from __future__ import annotations

from dataclasses import replace
from math import hypot, inf

from housefly.config.airframe import BrakingConstants
from housefly.messages.event_code import EventCode
from housefly.messages.flight import Event, OrderKind, Phase, Severity
from housefly.messages.obstacles import thing_called
from housefly.messages.words import Words, figure
from housefly.pilot.behavior.mission import Refused, TrackingTask, VehicleStatus
from housefly.pilot.behavior.navigator import Navigator, PathBlock
from housefly.pilot.behavior.path_progress import TrajectorySetpoint
from housefly.pilot.behavior.proposal import (
    NOTHING,
    Look,
    MissionChange,
    MissionView,
    Proposal,
    news,
)

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
    """Watches the path in use."""

    def __init__(
        self, mission: MissionView, navigator: Navigator, braking: BrakingConstants
    ) -> None:
        self._mission, self._braking = mission, braking
        self._navigator = navigator
        self._task = mission.task
        self._reported = False
        self._asked_at = self._resumed_at = self._told_at = -inf
        self._patience = 0.0

    def propose(self, look: Look) -> Proposal:
        """Look ahead once."""
        vehicle, target, state = look.vehicle, look.target, self._mission.state
        task, before = self._mission.task, self._task
        if task is not before:
            is_same = before.profile is not None and task.profile is before.profile
            self._task, target = task, target if is_same else None
        is_ours = state.phase in ON_THE_WAY and not state.stopped and not look.silent
        if not is_ours or vehicle.estimate is None:
            return NOTHING
        if task.waiting:
            return self._wait(vehicle)
        block = self._block(vehicle, target)
        if block is None:
            return NOTHING
        if block.along > braking_distance(_speed(vehicle), self._braking):
            if vehicle.now - self._asked_at < REPLAN_PERIOD:
                return NOTHING
            self._asked_at = vehicle.now
            way = self._mission.other_way(vehicle)
            if not isinstance(way, Refused):
                events = self._tell_detour(block, vehicle)
                return Proposal(MissionChange.GO_AROUND, EventCode.DETOUR, way, events=events)
        return self._stop_before(block, vehicle)

    def _stop_before(self, block: PathBlock, vehicle: VehicleStatus) -> Proposal:
        is_relapse = vehicle.now - self._resumed_at < RELAPSE_TIME
        self._patience = min(PATIENCE_MAX, max(0.5, 2.0 * self._patience)) if is_relapse else 0.0
        reason = Words(
            "{thing} is in the way, {d} m ahead",
            thing=thing_called(block.name),
            d=figure(block.along, ".1f"),
        )
        self._asked_at, self._reported = vehicle.now, False
        text = Words("{why}: stopping", why=reason)
        event = Event(vehicle.now, Severity.WARNING, EventCode.WAY_BLOCKED, text)
        return Proposal(
            MissionChange.HOLD, event.code, self._waiting(reason, vehicle), events=(event,)
        )

    def _waiting(self, why: Words, vehicle: VehicleStatus) -> TrackingTask:
        """Return the task of holding where the drone comes to rest until the way is free."""
        here, duration = self._mission.halted(vehicle), self._mission.task.duration
        return replace(here, waiting=why, since=vehicle.now, duration=duration)

    def _tell_detour(self, block: PathBlock, vehicle: VehicleStatus) -> tuple[Event, ...]:
        """Say that the drone goes around, once for many small changes of its way."""
        last, self._told_at = self._told_at, vehicle.now
        if vehicle.now - last < RELAPSE_TIME:
            return ()
        text = Words("{thing} is in the way: going around", thing=thing_called(block.name))
        return (Event(vehicle.now, Severity.INFO, EventCode.DETOUR, text),)

    def waiting_instead(self, reason: Words, vehicle: VehicleStatus) -> Proposal:
        """Wait for the way that a new phase lacks, if only obstacles of now close it."""
        navigator, state = self._navigator, self._mission.state
        mission = navigator.home() if state.phase is Phase.RETURNING else state.mission
        if mission.goal is None or vehicle.place is None:
            return NOTHING
        if not navigator.is_passing(vehicle.place, mission.goal):
            return NOTHING
        self._asked_at, self._reported = vehicle.now, True
        return Proposal(
            MissionChange.HOLD,
            EventCode.WAY_BLOCKED,
            self._waiting(reason, vehicle),
            state.entering(mission.flying_phase, vehicle.now, mission),
        )

    def _block(self, vehicle: VehicleStatus, target: TrajectorySetpoint | None) -> PathBlock | None:
        path, place = self._mission.task.path, vehicle.place
        if path is None or not self._mission.task.is_following or place is None:
            return None
        waypoint = min(target.waypoint, len(path.waypoints) - 1) if target else 0
        return self._navigator.block(place, path, waypoint)

    def _wait(self, vehicle: VehicleStatus) -> Proposal:
        task = self._mission.task
        standing = _speed(vehicle) < REST_SPEED or vehicle.now - task.since > REST_TIMEOUT
        asked_lately = self._reported and vehicle.now - self._asked_at < REPLAN_PERIOD
        if not standing or asked_lately or vehicle.now - task.since < self._patience:
            return NOTHING
        self._asked_at = vehicle.now
        way = self._mission.other_way(vehicle)
        if not isinstance(way, Refused):
            self._resumed_at = vehicle.now
            text = Words("there is a way: going on")
            event = Event(vehicle.now, Severity.INFO, EventCode.DETOUR, text)
            return Proposal(MissionChange.GO_AROUND, event.code, way, events=(event,))
        if self._reported:
            return NOTHING
        self._reported = True
        why, more = task.waiting, way.reason
        text = Words("{why}; no way on, waiting here: {more}", why=why, more=more)
        if self._mission.state.mission.kind is OrderKind.HOME:
            text = Words("{why}; no way home, waiting here: {more}", why=why, more=more)
        return news(EventCode.NO_WAY, Severity.WARNING, text, vehicle.now)


def braking_distance(speed: float, braking: BrakingConstants) -> float:
    """Return how far ahead [m] a drone at this speed [m/s] begins to brake."""
    return braking.way_to_rest(speed) + BRAKING_MARGIN


def _speed(vehicle: VehicleStatus) -> float:
    return hypot(*vehicle.estimate.velocity[:2]) if vehicle.estimate else 0.0
