"""What the console shows of the pilot: newest step, link, event log, trail. Fed by bus threads."""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from math import dist, hypot, inf

from housefly.bus.bus import Bus
from housefly.bus.topics import FRAME_TOPIC, DroneTopics
from housefly.clock import Clock
from housefly.config.airframe import Airframe
from housefly.config.drone import DroneConfig
from housefly.config.furniture import FurnitureConfig
from housefly.config.limits import LimitsConfig
from housefly.geometry import Vec2
from housefly.messages import (
    LinkStatus,
    OrderAnswer,
    Path,
    PilotStep,
    PlannedTrajectory,
    Severity,
    Sighting,
    TrackedFrame,
    TrajectoryPoint,
)
from housefly.messages.words import Words
from housefly.pilot.behavior.way_home import charge_for, usable_time
from housefly.room.tracked import footprint_of
from housefly.web.flights.flight_log_writer import FlightListener
from housefly.web.messages.server_messages import (
    EventView,
    LinkMessage,
    OtherBody,
    PathMessage,
    StateMessage,
)
from housefly.web.status.hand_motion import moved_by
from housefly.web.status.last_status import LastStatus
from housefly.web.status.stop_latch import StopLatch

_REFUSALS_KEPT = 100
_EVENTS_KEPT = 300
_TRAIL_KEPT = 600
_TRAIL_STEP = 0.04
"""Distance between two points of the trail [m]."""
_BODY_TIMEOUT = 2.0
"""Tracked bodies other than furniture leave the map when unseen for this long [s]."""
_BODIES_KEPT = 256
"""Tracked bodies beside the drone; of more, who was not seen for longest leaves the map."""


@dataclass(slots=True)
class _TrackedBody:
    body: OtherBody
    until: float


@dataclass(slots=True)
class StateFeed:
    """Collects what the pilot publishes; all methods are safe from any thread.

    Attributes:
        clock: the server's clock.
        drone_body: name of the drone among the tracked bodies; the map shows the others beside it.
        furniture: the tracked bodies that are furniture.
        keep_event: is told each line of the event log; must return at once.
        flights: hears each step, and keeps the flights.
        drone: the drone, or that there is none.
        limits: of the drone.
    """

    clock: Clock
    drone_body: str
    furniture: tuple[FurnitureConfig, ...] = ()
    keep_event: Callable[[EventView], None] = lambda event: None
    flights: FlightListener | None = None
    drone: DroneConfig = field(default_factory=DroneConfig)
    limits: LimitsConfig = field(default_factory=LimitsConfig)
    _lock: threading.Lock = field(default_factory=threading.Lock)
    _step: PilotStep | None = None
    _heard_at: float = 0.0
    _link: LinkMessage | None = None
    _events: deque[EventView] = field(default_factory=lambda: deque(maxlen=_EVENTS_KEPT))
    _event_number: int = 0
    _refusals: deque[OrderAnswer] = field(default_factory=lambda: deque(maxlen=_REFUSALS_KEPT))
    _trail: deque[Vec2] = field(default_factory=lambda: deque(maxlen=_TRAIL_KEPT))
    _others: dict[str, _TrackedBody] = field(default_factory=dict)
    _path: Path | None = None
    _path_number: int = 0
    _trajectory: tuple[TrajectoryPoint, ...] = ()
    _restarts: int = 0
    _hand_motion: str | None = None
    _last_status: LastStatus = field(default_factory=LastStatus)
    _stop: StopLatch = field(default_factory=StopLatch)

    def listen(self, bus: Bus) -> None:
        """Subscribe to the pilot; the bus closes the subscriptions."""
        topics = DroneTopics(self.drone.name)
        bus.subscribe(FRAME_TOPIC, self._on_frame)
        bus.subscribe(topics.step, self._on_step)
        bus.subscribe(topics.link, self._on_link)
        bus.subscribe(topics.trajectory, self._on_trajectory)

    def log_event(self, severity: Severity, code: str, text: Words) -> None:
        """Add a line of the console's own to the event log."""
        with self._lock:
            self._add_event(severity, code, text)

    def refusals(self) -> tuple[OrderAnswer, ...]:
        """Return which orders the pilot refused since the last call."""
        with self._lock:
            refusals = tuple(self._refusals)
            self._refusals.clear()
            return refusals

    def recall(self, missed: Sequence[EventView]) -> None:
        """Add lines that were missed, with the times at which they happened."""
        with self._lock:
            for one in missed:
                self._add_event(one.severity, one.code, one.text, one.at)

    def restore(self, events: Sequence[EventView], stop: StopLatch) -> None:
        """Go on with the event log and the STOP that an earlier console kept."""
        with self._lock:
            self._events.extend(events)
            self._event_number = events[-1].number if events else 0
            self._stop = stop

    @property
    def stop(self) -> StopLatch:
        """The STOP that holds."""
        with self._lock:
            return self._stop

    def change_stop(self, change: Callable[[StopLatch], StopLatch]) -> None:
        """Note what happened to STOP."""
        with self._lock:
            self._stop = change(self._stop)

    @property
    def step(self) -> PilotStep | None:
        """The newest step."""
        with self._lock:
            return self._step

    @property
    def age(self) -> float:
        """Time since the pilot was last heard [s]; infinite before the first step."""
        with self._lock:
            return self.clock.now() - self._heard_at if self._step else float("inf")

    @property
    def hand_motion(self) -> str | None:
        """Who moves the drone by hand, "" without a name; None while nobody does."""
        with self._lock:
            return self._hand_motion

    @property
    def last_status(self) -> LastStatus:
        """What the drone said last, also through a pilot before this one."""
        with self._lock:
            return self._last_status

    @property
    def restarts(self) -> int:
        """How often a pilot has started counting its steps from the beginning."""
        with self._lock:
            return self._restarts

    def events_after(self, number: int) -> tuple[EventView, ...]:
        """Return the lines of the event log that came after line ``number``."""
        with self._lock:
            return tuple(event for event in self._events if event.number > number)

    def trail(self) -> tuple[Vec2, ...]:
        """Return where the drone has flown, oldest first [m]."""
        with self._lock:
            return tuple(self._trail)

    def link(self) -> LinkMessage | None:
        """Return the newest link status."""
        with self._lock:
            return self._link

    def path(self) -> PathMessage:
        """Return the path in use."""
        with self._lock:
            if self._path is None:
                return PathMessage(self._path_number, (), 0.0)
            points = self._trajectory if self._is_planned_in_space() else ()
            return PathMessage(
                self._path_number,
                self._path.waypoints,
                self._path.length,
                tuple(point.position[2] for point in points),
                tuple(point.time for point in points),
                tuple(point.speed for point in points),
            )

    def state(self, home_s: float) -> StateMessage | None:
        """Return the newest step for the browser; ``home_s`` is the flight time home [s]."""
        with self._lock:
            if self._step is None:
                return None
            told = _state(
                self._step,
                self._heard_at,
                home_s,
                self._path_number,
                self._bodies(),
                self.drone.airframe,
                self.limits,
            )
            link = self._link.link if self._link else None
            return replace(told, height_std=link.height_std if link else None)

    def _bodies(self) -> tuple[OtherBody, ...]:
        now = self.clock.now()
        self._others = {name: one for name, one in self._others.items() if now < one.until}
        return tuple(shown.body for shown in self._others.values())

    def _see(self, sightings: Sequence[Sighting], now: float) -> None:
        """Keep where the bodies are; of too many the oldest go, those seen now by first come."""
        for sighting in sightings:
            if sighting.body != self.drone_body:
                self._others[sighting.body] = self._tracked_body(sighting, now)
        if len(self._others) > _BODIES_KEPT:
            newest = sorted(self._others, key=lambda one: self._others[one].until, reverse=True)
            for name in newest[_BODIES_KEPT:]:
                del self._others[name]

    def _tracked_body(self, sighting: Sighting, now: float) -> _TrackedBody:
        for piece in self.furniture:
            if piece.body == sighting.body:
                middle, yaw = footprint_of(piece, sighting.pose)
                body = OtherBody(piece.name, middle, (piece.length, piece.width), yaw)
                return _TrackedBody(body, inf if piece.model else now + piece.remembered)
        return _TrackedBody(
            OtherBody(sighting.body, sighting.pose.position[:2]), now + _BODY_TIMEOUT
        )

    def _on_frame(self, frame: TrackedFrame) -> None:
        with self._lock:
            self._see(frame.sightings, self.clock.now())

    def _on_step(self, step: PilotStep) -> None:
        now = self.clock.now()
        with self._lock:
            if self._step is not None and step.sequence < self._step.sequence:
                self._restarts += 1
                self._hand_motion = None
                self._stop = self._stop.pilot_restarted(now)
            word = self._last_status.after(step)
            if word.may_be_airborne and not self._last_status.may_be_airborne:
                self._trail.clear()
            self._last_status = word
            self._step, self._heard_at = step, now
            self._stop = self._stop.heard(step)
            self._hand_motion = moved_by(self._hand_motion, step)
            for event in step.outputs.events:
                self._add_event(event.severity, event.code, event.text)
            self._refusals.extend(one for one in step.outputs.answers if not one.is_taken)
            if step.outputs.path != self._path:
                self._path, self._path_number = step.outputs.path, self._path_number + 1
            estimate = step.outputs.estimate
            if estimate is not None and (
                not self._trail or dist(self._trail[-1], estimate.position[:2]) > _TRAIL_STEP
            ):
                self._trail.append(estimate.position[:2])
            number = self._path_number
        if self.flights is not None:
            self.flights.hear(step, number, self.path)

    def _on_trajectory(self, planned: PlannedTrajectory) -> None:
        """Keep what is planned in space; the path is sent anew as soon as both are known."""
        with self._lock:
            is_new = planned.points != self._trajectory
            self._trajectory = planned.points
            if is_new and self._is_planned_in_space():
                self._path_number += 1

    def _is_planned_in_space(self) -> bool:
        """Return whether what is known in space is the path in use."""
        path = self._path.waypoints if self._path else ()
        return bool(path) and tuple(point.position[:2] for point in self._trajectory) == path

    def _on_link(self, link: LinkStatus) -> None:
        with self._lock:
            self._link = LinkMessage(self.clock.now(), link)

    def _add_event(
        self, severity: Severity, code: str, text: Words, at: float | None = None
    ) -> None:
        self._event_number += 1
        when = self.clock.now() if at is None else at
        event = EventView(self._event_number, when, severity, code, text)
        self._events.append(event)
        self.keep_event(event)


def _state(
    step: PilotStep,
    heard_at: float,
    home_s: float,
    path: int,
    others: tuple[OtherBody, ...],
    airframe: Airframe,
    limits: LimitsConfig,
) -> StateMessage:
    telemetry, out = step.inputs.telemetry, step.outputs
    estimate = out.estimate
    return StateMessage(
        sequence=step.sequence,
        heard_at=heard_at,
        status=telemetry.status if telemetry else None,
        battery=telemetry.battery if telemetry else None,
        battery_return=charge_for(home_s, 1.0 / limits.flight_time, limits) - limits.battery_floor,
        flight_s=usable_time(telemetry.battery, home_s, limits) if telemetry else None,
        telemetry_age=step.now - telemetry.received_at if telemetry else None,
        faults=tuple(fault.value for fault in telemetry.faults) if telemetry else (),
        notes=telemetry.notes if telemetry else (),
        height=telemetry.height if telemetry else None,
        position=estimate.position if estimate else None,
        velocity=estimate.velocity if estimate else None,
        yaw=estimate.yaw if estimate else None,
        pose_age=estimate.pose_age if estimate else None,
        position_std=estimate.position_std if estimate else None,
        wanted=out.reference.position if out.reference else None,
        behavior=out.behavior,
        phase=out.phase,
        safety=out.safety,
        clears=out.clears,
        action=out.command.action,
        goal_name=out.goal_name,
        reason=out.reason,
        path=path,
        waypoint=out.waypoint,
        others=others,
        stopping_distance=(
            airframe.braking.way_to_rest(hypot(*estimate.velocity)) if estimate else None
        ),
    )
