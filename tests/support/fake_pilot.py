"""A fake pilot for the console without room, drone or twin: ``python tests/support/fake_pilot.py``.

It answers the pilot's queries, obeys orders with the kinematics of a point, and publishes the same
topics, for work on the console, its tests and its benchmarks. It makes no decision of the real
pilot's, and it stays on this machine.
"""

from __future__ import annotations

import asyncio
import contextlib
import secrets
import threading
from dataclasses import dataclass, field
from math import atan2, hypot

import uvicorn
from fake_room import EXAMPLE_CHECKS, FAKE_PILOT_SPEED, example_room, plan_on

from housefly.bus.bus import Bus
from housefly.bus.local import LocalBus
from housefly.bus.topics import FRAME_TOPIC, DroneTopics
from housefly.clock import Clock, RealClock
from housefly.geometry import Vec2, wrap_angle
from housefly.hub.api.pilot_queries import PlanRequest, PreflightView, RoomView
from housefly.hub.api.pilot_queries_json import from_json, to_json
from housefly.messages import (
    Action,
    Behavior,
    Command,
    DroneStatus,
    Estimate,
    Event,
    EventCode,
    Inputs,
    LinkStatus,
    Order,
    OrderAnswer,
    OrderKind,
    OrderOutcome,
    Outputs,
    Path,
    Phase,
    PilotStep,
    PlanAnswer,
    Pose,
    PreflightCheck,
    Reference,
    SafetyMode,
    Severity,
    Sighting,
    Telemetry,
    TrackedFrame,
)
from housefly.messages.order_words import asked_words, refused_words
from housefly.messages.words import Words, literal
from housefly.web.server import create_app

TOPICS = DroneTopics()

_CLIMB_RATE = 0.6
_TURN_RATE = 1.2
_BATTERY_DRAIN = 1.0 / 720.0
_NUDGE_LIFETIME, _NUDGE_QUIET_TIME, _KEEP = 0.3, 2.0, 0.5


@dataclass(slots=True)
class FakePilot:
    """A point that flies where orders send it.

    Attributes:
        bus: where it publishes and answers.
        room: what it flies in.
        clock: its time.
        topics: of its drone.
        orders: every order it received, oldest first.
        checks: what its pre-flight checks find.
        telemetry_age: how long ago the drone was heard [s].
        connected: whether its wires are well.
        notes: what the drone notes of its settings and sensors.
        link_notes: what the pilot notes of its wires.
        nudge: the newest motion by hand.
    """

    bus: Bus
    room: RoomView
    clock: Clock = field(default_factory=RealClock)
    orders: list[Order] = field(default_factory=list)
    position: Vec2 = (0.0, 0.0)
    height: float = 0.0
    yaw: float = 0.0
    battery: float = 0.86
    status: DroneStatus = DroneStatus.LANDED
    phase: Phase = Phase.IDLE
    stopped: bool = False
    mission: Order | None = None
    path: Path | None = None
    waypoint: int = 0
    looking_until: float = 0.0
    pose_age: float = 0.024
    telemetry_age: float = 0.03
    connected: bool = True
    sequence: int = 0
    publishing: bool = True
    checks: tuple[PreflightCheck, ...] = EXAMPLE_CHECKS
    notes: tuple[str, ...] = ()
    link_notes: tuple[str, ...] = ()
    nudge: Order | None = None
    topics: DroneTopics = TOPICS
    _events: list[Event] = field(default_factory=list)
    _answers: list[OrderAnswer] = field(default_factory=list)
    _lock: threading.RLock = field(default_factory=threading.RLock)

    def __post_init__(self) -> None:
        self.position = self.room.home
        self.bus.subscribe(self.topics.order, self._obey)
        self.bus.answer(self.topics.preflight, lambda _: to_json(self._preflight()))
        self.bus.answer(self.topics.room, lambda _: to_json(self.room))
        self.bus.answer(
            self.topics.plan, lambda text: to_json(self._answer(from_json(PlanRequest, text)))
        )

    async def run(self, rate_hz: float = 100.0) -> None:
        """Fly in real time until cancelled."""
        while True:
            await asyncio.sleep(1.0 / rate_hz)
            self.advance(1.0 / rate_hz)
            if self.sequence % int(rate_hz / 2) == 0:
                self.publish_link()

    def publish_link(self) -> None:
        """Publish the status of the wires."""
        if self.publishing:
            self.bus.publish(
                self.topics.link,
                LinkStatus(
                    at=self.clock.now(),
                    tracking_connected=self.connected,
                    drone_connected=self.connected,
                    video_connected=self.connected,
                    tracking_rate_hz=100.0,
                    telemetry_rate_hz=15.0,
                    video_rate_hz=30.0,
                    loop_p50_s=1e-4,
                    loop_p99_s=4e-4,
                    loop_max_s=2e-3,
                    notes=tuple(map(literal, self.link_notes)),
                ),
            )

    def advance(self, dt: float) -> None:
        """Move by dt [s] and publish the step."""
        with self._lock:
            self._move(dt)
            step = self._step()
            self._events.clear()
            self._answers.clear()
        if self.publishing:
            self.bus.publish(FRAME_TOPIC, TrackedFrame(step.inputs.sightings))
            self.bus.publish(self.topics.step, step)

    def add_event(self, severity: Severity, code: str, text: str) -> None:
        """Add an event to the next step."""
        with self._lock:
            self._events.append(Event(self.clock.now(), severity, EventCode(code), literal(text)))

    def refuse(self, why: str) -> None:
        """Refuse the newest order after all, in the event log and as an answer."""
        with self._lock:
            order, words = self.orders[-1], literal(why)
            self._answers.append(OrderAnswer(order.id, OrderOutcome.UNAVAILABLE, words))
            self.add_event(
                Severity.WARNING, "order_refused", refused_words(asked_words(order), words)
            )

    # --- orders

    def _obey(self, order: Order) -> None:
        with self._lock:
            self.orders.append(order)
            if order.kind is OrderKind.NUDGE:
                self._take_nudge(order)
                return
            self.add_event(
                Severity.INFO,
                "order_accepted",
                f"{order.kind.value} {order.place} by {order.sender}",
            )
            flying = self.status in (DroneStatus.FLYING, DroneStatus.TAKING_OFF)
            match order.kind:
                case OrderKind.TAKE_OFF:
                    self._begin(DroneStatus.TAKING_OFF, Phase.TAKING_OFF)
                case OrderKind.GO | OrderKind.SERVICE:
                    self._set_out(order, flying)
                case OrderKind.HOME:
                    self._return()
                case OrderKind.LAND:
                    self._begin(DroneStatus.LANDING, Phase.LANDING)
                case OrderKind.HOVER:
                    self.path, self.mission, self.phase = None, None, Phase.HOLDING
                case OrderKind.STOP:
                    self.stopped = True
                case OrderKind.RESUME:
                    self.stopped, self.path, self.mission = False, None, None
                    self.phase = Phase.HOLDING if flying else Phase.IDLE
                case OrderKind.CUT:
                    self.status, self.path, self.mission, self.phase = (
                        DroneStatus.EMERGENCY,
                        None,
                        None,
                        Phase.IDLE,
                    )
                    self.add_event(Severity.FAULT, "cut", "Motors cut by order")
                case OrderKind.RESET:
                    self.status = DroneStatus.LANDED

    def _begin(self, status: DroneStatus, phase: Phase) -> None:
        self.status, self.phase = status, phase
        if phase is Phase.LANDING:
            self.path, self.mission = None, None

    def _set_out(self, order: Order, flying: bool) -> None:
        self.mission = order
        answer = self._answer(PlanRequest(order.place, order.goal))
        self.path, self.waypoint = answer.path, 1
        self.add_event(
            Severity.INFO,
            "going_on",
            f"Path of {answer.path.length:.1f} m planned" if answer.path else answer.reason,
        )
        if flying:
            self.phase = Phase.OUTBOUND
        else:
            self._begin(DroneStatus.TAKING_OFF, Phase.TAKING_OFF)

    def _return(self) -> None:
        answer = self._answer(PlanRequest(goal=self.room.home))
        self.path, self.waypoint, self.phase = answer.path, 1, Phase.RETURNING

    def _take_nudge(self, order: Order) -> None:
        """Move by hand; it is told when it begins."""
        if self.nudge is None or order.issued_at - self.nudge.issued_at > _NUDGE_QUIET_TIME:
            self.add_event(
                Severity.INFO, "nudge_began", Words("moved by hand by {who}", who=order.sender)
            )
        self.nudge = order

    # --- motion

    def _move(self, dt: float) -> None:
        if self.status in (DroneStatus.LANDED, DroneStatus.EMERGENCY):
            self.height = max(0.0, self.height - 3.0 * dt)
            return
        self.battery = max(0.0, self.battery - _BATTERY_DRAIN * dt)
        if self.status is DroneStatus.TAKING_OFF:
            self._climb(dt)
        elif self.status is DroneStatus.LANDING:
            self.height = max(0.0, self.height - _CLIMB_RATE * dt)
            if self.height == 0.0:
                self.status, self.phase = DroneStatus.LANDED, Phase.IDLE
                self.add_event(Severity.INFO, "grounded", "Landed")
        elif not self.stopped:
            self._follow(dt)

    def _climb(self, dt: float) -> None:
        self.height = min(self.room.flight_height, self.height + _CLIMB_RATE * dt)
        if self.height == self.room.flight_height:
            self.status = DroneStatus.FLYING
            self.phase = Phase.OUTBOUND if self.mission else Phase.HOLDING
            self.add_event(Severity.INFO, "airborne", "Airborne")

    def _follow(self, dt: float) -> None:
        if self.phase is Phase.HOLDING and self.nudge is not None:
            self._drift(self.nudge, dt)
        if self.phase is Phase.LOOKING and self.clock.now() > self.looking_until:
            self._return()
        if self.path is None or self.phase not in (Phase.OUTBOUND, Phase.RETURNING):
            return
        target = self.path.waypoints[min(self.waypoint, len(self.path.waypoints) - 1)]
        dx, dy = target[0] - self.position[0], target[1] - self.position[1]
        if (left := hypot(dx, dy)) > 1e-9:
            turn = wrap_angle(atan2(dy, dx) - self.yaw)
            self.yaw = wrap_angle(self.yaw + max(-_TURN_RATE * dt, min(_TURN_RATE * dt, turn)))
            stride = min(left, FAKE_PILOT_SPEED * dt)
            self.position = (
                self.position[0] + dx / left * stride,
                self.position[1] + dy / left * stride,
            )
        if left <= FAKE_PILOT_SPEED * dt:
            self.waypoint += 1
            if self.waypoint >= len(self.path.waypoints):
                self._arrive()

    def _drift(self, nudge: Order, dt: float) -> None:
        quiet = self.clock.now() - nudge.issued_at
        if quiet > _NUDGE_QUIET_TIME:
            self.nudge = None
            self.add_event(Severity.INFO, "nudge_ended", Words("moved by hand no longer"))
        if nudge.velocity is None or quiet > _NUDGE_LIFETIME:
            return
        vx, vy, vz = nudge.velocity
        x0, y0, x1, y1 = self.room.bounds
        x, y = self.position[0] + vx * dt, self.position[1] + vy * dt
        place = (min(max(x, x0 + _KEEP), x1 - _KEEP), min(max(y, y0 + _KEEP), y1 - _KEEP))
        if place != (x, y) and self.position != place:
            text = Words("moved by hand: {why}", why=Words("a wall or furniture is ahead"))
            self.add_event(Severity.INFO, "nudge_limited", text)
        self.position, self.height = place, max(0.4, min(2.0, self.height + vz * dt))

    def _arrive(self) -> None:
        self.path = None
        if self.phase is Phase.RETURNING:
            self._begin(DroneStatus.LANDING, Phase.LANDING)
        elif self.mission is not None and self.mission.kind is OrderKind.SERVICE:
            self.phase, self.looking_until = Phase.LOOKING, self.clock.now() + self.mission.look_s
            self.add_event(
                Severity.INFO, "arrived_to_look", f"Arrived at {self._goal_name()}, looking"
            )
        else:
            self.phase = Phase.HOLDING

    # --- what it publishes

    def _goal_name(self) -> str:
        if self.phase is Phase.RETURNING:
            return "Home"
        if self.mission is None:
            return ""
        named = [place.title for place in self.room.places if place.name == self.mission.place]
        return named[0] if named else "the chosen point"

    def _step(self) -> PilotStep:
        now = self.clock.now()
        self.sequence += 1
        x, y = self.position
        estimate = Estimate(
            now, (x, y, self.height), (0.0, 0.0, 0.0), self.yaw, self.pose_age, 0.004
        )
        sightings: tuple[Sighting, ...] = ()
        if self.room.visitor is not None:
            sightings = (Sighting("visitor", Pose((*self.room.visitor, 1.0)), now, now),)
        telemetry = Telemetry(
            now - self.telemetry_age,
            self.status,
            self.battery,
            height=self.height,
            notes=tuple(map(literal, self.notes)),
        )
        outputs = Outputs(
            Command(Action.FLY if self.status is DroneStatus.FLYING else Action.IDLE),
            estimate,
            Reference((x, y, self.room.flight_height), (0.0, 0.0, 0.0), self.yaw),
            (
                Behavior.PATH_TRACKING
                if self.path and self.status is DroneStatus.FLYING
                else Behavior.HOVER
            ),
            self.phase,
            SafetyMode.STOPPED if self.stopped else SafetyMode.NOMINAL,
            self._goal_name(),
            self.path,
            self.waypoint,
            literal("stopped until resume" if self.stopped else ""),
            tuple(self._events),
            answers=tuple(self._answers),
        )
        return PilotStep(self.sequence, now, Inputs(sightings, telemetry), outputs)

    def _preflight(self) -> PreflightView:
        return PreflightView(
            all(one.passed or not one.required for one in self.checks), self.checks
        )

    def _answer(self, request: PlanRequest) -> PlanAnswer:
        start = request.start or self.position
        goal = request.goal
        if request.place:
            goal = next(
                (place.viewpoint for place in self.room.places if place.name == request.place), None
            )
        if goal is None:
            return PlanAnswer(start, start, None, literal(f"no place called {request.place!r}"))
        return plan_on(self.room.grid, start, goal)


async def _serve(port: int = 8080) -> None:
    """Serve the console with a fake pilot until interrupted."""
    bus = LocalBus()
    pilot = FakePilot(bus, example_room())
    token = secrets.token_urlsafe(24)
    print(f"rehearsal: http://127.0.0.1:{port}/?token={token}", flush=True)
    flying = asyncio.create_task(pilot.run())
    config = uvicorn.Config(
        create_app(bus, token, lambda: None),
        port=port,
        log_level="warning",
        timeout_graceful_shutdown=1,
    )
    await uvicorn.Server(config).serve()
    flying.cancel()


if __name__ == "__main__":
    with contextlib.suppress(KeyboardInterrupt):
        asyncio.run(_serve())
