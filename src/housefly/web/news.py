"""What the console knows of the pilot: the newest step, the link, the event log, the trail. Fed by
the bus's threads.
"""

from __future__ import annotations

import threading
from collections import deque
from dataclasses import dataclass, field
from math import dist, inf

from housefly.bus.bus import Bus
from housefly.bus.topics import LINK, STEP
from housefly.clock import Clock
from housefly.config.furniture import FurnitureConfig
from housefly.geometry import Vec2
from housefly.messages import DroneStatus, LinkStatus, Path, PilotStep, Severity, Sighting
from housefly.room.tracked import footprint_of
from housefly.web.vocabulary import EventView, LinkNews, OtherBody, PathNews, State

ENDURANCE = 720.0
"""Flight time of a full battery [s]: an AR.Drone 2.0 is rated 12 minutes on 1000 mAh."""
EVENTS_KEPT = 300
TRAIL_KEPT = 600
TRAIL_STEP = 0.04
"""Distance between two points of the trail [m]."""
BODY_MEMORY = 2.0
"""Other tracked bodies than furniture vanish from the map when they were not seen for this long
[s].
"""


@dataclass(slots=True)
class _Seen:
    body: OtherBody
    until: float


@dataclass(slots=True)
class PilotNews:
    """The listener; all methods are safe from any thread.

    Attributes:
        clock: the server's clock.
        drone_body: name of the drone among the tracked bodies; the others are drawn as others.
        furniture: those of them that are furniture.
    """

    clock: Clock
    drone_body: str
    furniture: tuple[FurnitureConfig, ...] = ()
    _lock: threading.Lock = field(default_factory=threading.Lock)
    _step: PilotStep | None = None
    _heard_at: float = 0.0
    _link: LinkNews | None = None
    _events: deque[EventView] = field(default_factory=lambda: deque(maxlen=EVENTS_KEPT))
    _event_number: int = 0
    _trail: deque[Vec2] = field(default_factory=lambda: deque(maxlen=TRAIL_KEPT))
    _others: dict[str, _Seen] = field(default_factory=dict)
    _path: Path | None = None
    _path_number: int = 0
    _restarts: int = 0

    def listen(self, bus: Bus) -> None:
        """Subscribe to the pilot; the bus closes the subscriptions."""
        bus.subscribe(STEP, self._on_step)
        bus.subscribe(LINK, self._on_link)

    def note(self, severity: Severity, code: str, text: str) -> None:
        """Write a line of the console's own into the event log."""
        with self._lock:
            self._log(severity, code, text)

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
    def restarts(self) -> int:
        """How often a pilot has begun to count its steps anew."""
        with self._lock:
            return self._restarts

    def events_after(self, number: int) -> tuple[EventView, ...]:
        """Return the lines of the event log that came after line ``number``."""
        with self._lock:
            return tuple(event for event in self._events if event.number > number)

    def trail(self) -> tuple[Vec2, ...]:
        """Return where the drone has been, oldest first [m]."""
        with self._lock:
            return tuple(self._trail)

    def link(self) -> LinkNews | None:
        """Return the newest link status."""
        with self._lock:
            return self._link

    def path(self) -> PathNews:
        """Return the path in use."""
        with self._lock:
            way = self._path
            return PathNews(
                self._path_number, way.waypoints if way else (), way.length if way else 0.0
            )

    def state(self, home_s: float) -> State | None:
        """Return the newest step as the browser wants it; ``home_s`` is the flight time home [s]."""
        with self._lock:
            if self._step is None:
                return None
            return _state(self._step, self._heard_at, home_s, self._path_number, self._bodies())

    def _bodies(self) -> tuple[OtherBody, ...]:
        now = self.clock.now()
        return tuple(seen.body for seen in self._others.values() if now < seen.until)

    def _seen(self, sighting: Sighting, now: float) -> _Seen:
        for piece in self.furniture:
            if piece.body == sighting.body:
                middle, yaw = footprint_of(piece, sighting.pose)
                body = OtherBody(piece.name, middle, (piece.length, piece.width), yaw)
                return _Seen(body, inf if piece.model else now + piece.remembered)
        return _Seen(OtherBody(sighting.body, sighting.pose.position[:2]), now + BODY_MEMORY)

    def _on_step(self, step: PilotStep) -> None:
        now = self.clock.now()
        with self._lock:
            if self._step is not None and step.sequence < self._step.sequence:
                self._restarts += 1
            if on_the_ground(self._step) and not on_the_ground(step):
                self._trail.clear()
            self._step, self._heard_at = step, now
            for event in step.outputs.events:
                self._log(event.severity, event.code, event.text)
            for sighting in step.inputs.sightings:
                if sighting.body != self.drone_body:
                    self._others[sighting.body] = self._seen(sighting, now)
            if step.outputs.path != self._path:
                self._path, self._path_number = step.outputs.path, self._path_number + 1
            estimate = step.outputs.estimate
            if estimate is not None and (
                not self._trail or dist(self._trail[-1], estimate.position[:2]) > TRAIL_STEP
            ):
                self._trail.append(estimate.position[:2])

    def _on_link(self, link: LinkStatus) -> None:
        with self._lock:
            self._link = LinkNews(self.clock.now(), link)

    def _log(self, severity: Severity, code: str, text: str) -> None:
        self._event_number += 1
        self._events.append(EventView(self._event_number, self.clock.now(), severity, code, text))


def on_the_ground(step: PilotStep | None) -> bool:
    """Tell whether the drone says that it does not fly; a drone that is not heard counts as on the
    ground.
    """
    telemetry = step.inputs.telemetry if step else None
    return telemetry is None or telemetry.status in (
        DroneStatus.UNKNOWN,
        DroneStatus.LANDED,
        DroneStatus.EMERGENCY,
    )


def _state(
    step: PilotStep, heard_at: float, home_s: float, path: int, others: tuple[OtherBody, ...]
) -> State:
    telemetry, out = step.inputs.telemetry, step.outputs
    estimate = out.estimate
    return State(
        sequence=step.sequence,
        heard_at=heard_at,
        status=telemetry.status if telemetry else None,
        battery=telemetry.battery if telemetry else None,
        battery_return=home_s / ENDURANCE,
        flight_s=telemetry.battery * ENDURANCE if telemetry else None,
        telemetry_age=step.now - telemetry.received_at if telemetry else None,
        faults=telemetry.faults if telemetry else (),
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
        action=out.command.action,
        goal_name=out.goal_name,
        reason=out.reason,
        path=path,
        waypoint=out.waypoint,
        others=others,
    )
