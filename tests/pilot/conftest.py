"""A closed loop for the pilot: the reduced-order drone with a small firmware, and a stamped, noisy,
lossy tracking system.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from dataclasses import dataclass, field
from itertools import groupby
from math import cos, floor, hypot, sin
from operator import is_

import numpy as np
import pytest
from branched import branched

from housefly.config.site import Site, changed
from housefly.geometry import Vec2, Vec3, distance, quaternion_from_euler
from housefly.messages import (
    Action,
    Behavior,
    Command,
    DroneFault,
    DroneStatus,
    Event,
    Inputs,
    Obstacle,
    Order,
    OrderKind,
    Outputs,
    Phase,
    Pose,
    Sighting,
    Telemetry,
)
from housefly.numeric import FloatArray
from housefly.pilot.assembly import make_pilot
from housefly.pilot.control.model import Constants, DroneState, drone_step
from housefly.room.grid import Cell, OccupancyGrid, build_grid
from housefly.room.model import Place, Room, Shape, Solid

TICK = 0.02
"""Time between two steps of the pilot [s]: half the steps of the shipped rate, the same flight."""
PHYSICS_TICK = 0.005
"""Time between two steps of the drone [s]."""
REPORT_PERIOD = 0.05
"""The drone tells about itself every so often, at the next step [s]."""
ENDURANCE = 720.0
"""How long a full battery lasts in the air [s]."""


def make_room() -> Room:
    """A hall of 12.5 m x 5 m with a wall stub in the way to the door."""
    block = Solid("block", "block", Shape.BOX, (6.0, 1.0, 1.0), (0.5, 2.0, 2.0))
    places = (
        Place("home", (2.0, 1.25), (4.0, 1.25, 1.0)),
        Place("entrance", (10.75, 1.25), (10.75, 0.0, 1.5), "Entrance"),
    )
    return Room("hall", (0.0, 0.0, 12.5, 5.0), 2.6, (block,), places, (), (2.0, 1.25))


def make_grid(resolution: float, keep: float) -> OccupancyGrid:
    """The map of the hall: the block at x 5.75..6.25, y 0..2, grown by ``keep`` [m]."""
    nx, ny = round(12.5 / resolution), round(5.0 / resolution)
    x = (np.arange(nx) + 0.5)[:, None] * resolution
    y = (np.arange(ny) + 0.5)[None, :] * resolution
    block = np.hypot(np.maximum(0.0, np.abs(x - 6.0) - 0.25), np.maximum(0.0, y - 2.0))
    walls = np.minimum(np.minimum(x, 12.5 - x), np.minimum(y, 5.0 - y))
    clearance = np.minimum(block, walls)
    cells = np.where(clearance < keep, Cell.INFLATED, Cell.FREE).astype(np.uint8)
    cells[block <= 0.0] = Cell.OCCUPIED
    return OccupancyGrid((0.0, 0.0), resolution, cells, clearance)


@dataclass
class Tracking:
    """How the tracking system misbehaves: rate [Hz], latency [s], noise [m], share of lost frames,
    gaps (from, to) [s].
    """

    rate_hz: float = 50.0
    latency: float = 0.02
    noise: float = 0.001
    loss: float = 0.0
    gaps: tuple[tuple[float, float], ...] = ()


@dataclass
class Score:
    """What a flight was worth, measured on the truth; ``flown`` has each place and its path."""

    flown: list[tuple[Vec2, tuple[Vec2, ...]]] = field(default_factory=list)
    switches: int = 0
    flown_s: float = 0.0

    @property
    def errors(self) -> list[float]:
        """Distances from the path while flying it [m]."""
        return [
            error
            for path, flown in groupby(self.flown, key=lambda one: one[1])
            for error in from_path(np.array([place for place, _ in flown]), path)
        ]

    @property
    def rms(self) -> float:
        """Root mean square distance from the path while flying it [m]."""
        return float(np.sqrt(np.mean(np.square(self.errors))))


_beginnings: dict[tuple[str, str], Flight] = {}
"""Flights by how they were made and how they began."""


class Flight:
    """One pilot, one drone, one clock."""

    def __init__(
        self,
        site: Site,
        tracking: Tracking | None = None,
        constants: Constants | None = None,
        wind: Vec2 = (0.0, 0.0),
        delay: float = 0.06,
        seed: int = 1,
        is_mapped: bool = False,
        tick: float = TICK,
    ) -> None:
        self.tick = tick
        self.site, self.room = site, make_room()
        self.grid = make_grid(0.5, 0.3) if site.mode == "paper" else make_grid(0.1, 0.5)
        if is_mapped:  # as the site says
            self.grid = build_grid(self.room, site)
        self.pilot = make_pilot(site, self.room, self.grid)
        self.tracking = tracking or Tracking()
        self.constants = constants or Constants()
        self.wind = wind
        self.random = np.random.default_rng(seed)
        self.now, self.frame, self.reports = 0.0, 0, 0
        self.body = DroneState(x=self.room.home[0], y=self.room.home[1], psi=self.room.home_yaw)
        self.status, self.since = DroneStatus.LANDED, 0.0
        self.battery = 0.9
        self.talks = True
        self.faults: tuple[DroneFault, ...] = ()
        self.notes: tuple[str, ...] = ()
        self.configured = True
        self.late = 0.0
        self.origin_known = False
        self.pending: deque[tuple[float, Command]] = deque()
        self.delay = delay
        self.command = Command(Action.IDLE)
        self.in_flight: list[Sighting] = []
        self.felt = np.random.default_rng(seed + 1000)
        self.past: deque[tuple[float, float, float]] = deque(maxlen=round(0.04 / tick) + 1)
        self.outputs: Outputs | None = None
        self.events: list[Event] = []
        self.phases: list[Phase] = []
        self.score = Score()
        self.heard = Telemetry(0.0, DroneStatus.LANDED, self.battery)
        self.around: Callable[[Flight], tuple[Obstacle, ...]] = lambda flight: ()
        self.made = ""
        self._fresh = self._state()

    # --- the drone ---

    def _firmware(self) -> None:
        action = self.command.action
        if action is Action.CUT and self.status is not DroneStatus.EMERGENCY:
            self._become(DroneStatus.EMERGENCY)
        elif action is Action.RESET and self.status is DroneStatus.EMERGENCY:
            self._become(DroneStatus.LANDED)
        elif action is Action.TAKE_OFF and self.status is DroneStatus.LANDED:
            self._become(DroneStatus.TAKING_OFF)
        elif self.status is DroneStatus.TAKING_OFF and self.now - self.since > 4.0:
            self._become(DroneStatus.FLYING)
        elif action is Action.LAND and self.status in (DroneStatus.FLYING, DroneStatus.TAKING_OFF):
            self._become(DroneStatus.LANDING)
        elif self.status is DroneStatus.LANDING and self.body.z <= 0.02:
            self._become(DroneStatus.LANDED)

    def _become(self, status: DroneStatus) -> None:
        self.status, self.since = status, self.now

    def _fly(self) -> None:
        while self.pending and self.pending[0][0] <= self.now + 1e-9:
            self.command = self.pending.popleft()[1]
        self._firmware()
        b, wind = self.body, self.wind
        wanted = (0.0, 0.0, 0.0, 0.0)
        if self.status is DroneStatus.FLYING and self.command.action is Action.FLY:
            s = self.command.setpoint
            wanted = (s.theta, s.phi, s.vz, s.yaw_rate)
        elif self.status in (DroneStatus.LANDED, DroneStatus.EMERGENCY):
            self.body = DroneState(x=b.x, y=b.y, z=max(0.0, b.z - 4.0 * self.tick), psi=b.psi)
            return
        else:
            climb = {DroneStatus.TAKING_OFF: 0.5 * (1.0 - b.z), DroneStatus.LANDING: -0.4}.get(
                self.status, 0.0
            )
            flow = self.random.normal(0.0, 0.02, 2).tolist()
            c, s = cos(b.psi), sin(b.psi)
            ax, ay = -0.8 * (b.vx + flow[0]) - wind[0], -0.8 * (b.vy + flow[1]) - wind[1]
            wanted = (0.1 * (c * ax + s * ay), -0.1 * (-s * ax + c * ay), climb * 1.5, 0.0)
        for _ in range(round(self.tick / PHYSICS_TICK)):
            self.body = drone_step(self.body, *wanted, wind, self.constants, PHYSICS_TICK)

        if self.status not in (DroneStatus.LANDED, DroneStatus.EMERGENCY):
            self.battery -= self.tick / ENDURANCE

    # --- the tracking system ---

    def _look(self) -> tuple[Sighting, ...]:
        t = self.tracking
        while self.frame / t.rate_hz <= self.now + 1e-9:
            at = self.frame / t.rate_hz
            self.frame += 1
            blind = any(a <= at < b for a, b in t.gaps) or self.random.random() < t.loss
            noise = self.random.normal(0.0, t.noise, 4).tolist()
            if blind:
                continue
            b = self.body
            position: Vec3 = (b.x + noise[0], b.y + noise[1], b.z + noise[2])
            pose = Pose(position, quaternion_from_euler(b.phi, b.theta, b.psi + 2.0 * noise[3]))
            self.in_flight.append(Sighting("ardrone", pose, at, at + t.latency))
        arrived = tuple(s for s in self.in_flight if s.received_at <= self.now + 1e-9)
        self.in_flight = [s for s in self.in_flight if s.received_at > self.now + 1e-9]
        return arrived

    # --- the drone's own report ---

    def _feel(self) -> None:
        b, c, s = self.body, cos(self.body.psi), sin(self.body.psi)
        ahead, left = c * b.vx + s * b.vy, c * b.vy - s * b.vx
        up_left = ahead * sin(b.theta) + b.vz * cos(b.theta)
        forward = ahead * cos(b.theta) - b.vz * sin(b.theta)
        self.past.append((forward, left * cos(b.phi) + up_left * sin(b.phi), b.z))

    def report(self) -> Telemetry:
        """Return what the drone tells now: noisy, speeds and height 40 ms late."""
        b, (forward, left, height) = self.body, self.past[0]
        noise = self.felt.normal(0.0, 0.02, 2).tolist()
        sonar = max(0.0, height + self.felt.normal(0.0, 0.01))
        return Telemetry(
            self.now,
            self.status,
            round(self.battery, 2),
            b.phi,
            b.theta,
            b.psi,
            sonar,
            (forward + noise[0], left + noise[1], 0.0),
            faults=self.faults,
            configured=self.configured,
            notes=self.notes,
        )

    # --- the loop ---

    def order(self, kind: OrderKind, **values: object) -> Order:
        """Return an order given now."""
        return Order(kind, issued_at=self.now, **values)  # type: ignore[arg-type]

    def step(self, *orders: Order) -> Outputs:
        """Run one tick of the loop."""
        self.now = round(self.now + self.tick, 6)
        self._fly()
        self._feel()
        reports = floor(self.now / REPORT_PERIOD + 1e-6)
        if self.talks and reports > self.reports:
            self.reports = reports
            self.heard = self.report()
        before = self.outputs.behavior if self.outputs else Behavior.HOVER
        self.outputs = self.pilot.step(
            self.now,
            Inputs(
                self._look(),
                self.heard,
                orders,
                self.around(self),
                self.late,
                origin_known=self.origin_known,
            ),
        )
        self.pending.append((self.now + self.delay, self.outputs.command))
        self.events.extend(self.outputs.events)
        if not self.phases or self.phases[-1] is not self.outputs.phase:
            self.phases.append(self.outputs.phase)
        if self.outputs.phase in (Phase.OUTBOUND, Phase.RETURNING):
            self._measure(before)
        return self.outputs

    def _measure(self, before: Behavior) -> None:
        assert self.outputs is not None
        self.score.flown_s += self.tick
        self.score.switches += self.outputs.behavior is not before
        if self.outputs.path is not None and len(self.outputs.path.waypoints) > 1:
            points = self.outputs.path.waypoints
            self.score.flown.append(((self.body.x, self.body.y), points))

    def run(self, seconds: float) -> Outputs:
        """Run for this long."""
        for _ in range(round(seconds / self.tick)):
            outputs = self.step()
        return outputs

    def until(self, done: Callable[[Outputs], bool], limit: float = 120.0) -> Outputs:
        """Run until something is true; fails when it does not become true in time."""
        end = self.now + limit
        while self.now < end:
            outputs = self.step()
            if done(outputs):
                return outputs
        raise AssertionError(
            f"did not happen within {limit} s; phase {outputs.phase}, events"
            f" {[e.text for e in self.events]}"
        )

    def service(self, limit: float = 150.0) -> Score:
        """Fly the whole service and return its score."""
        self.begin("service", lambda: self._service(limit))
        return self.score

    def _service(self, limit: float) -> Outputs:
        self.run(0.5)
        self.step(self.order(OrderKind.SERVICE, place="entrance", look_s=2.0))
        return self.until(
            lambda o: o.phase is Phase.IDLE and self.status is DroneStatus.LANDED, limit
        )

    def begin(self, name: str, fly: Callable[[], Outputs]) -> Outputs:
        """Fly the beginning of a flight, or go on from where another one came the same way."""
        key, now = (self.made, name), self._state()
        is_fresh = len(now) == len(self._fresh) and all(map(is_, now, self._fresh))
        if not self.made or not is_fresh:
            return fly()
        if key not in _beginnings:
            fly()
            _beginnings[key] = branched(self)
        vars(self).update(vars(branched(_beginnings[key])))
        assert self.outputs is not None
        return self.outputs

    def _state(self) -> list[object]:
        """Return what changes when it flies or when a test takes a hand in it."""
        kept = {key: value for key, value in vars(self).items() if key not in ("made", "_fresh")}
        parts = (kept, vars(self.tracking), vars(self.pilot))
        return [value for part in parts for value in part.values()]

    def take_off(self) -> Outputs:
        """Take off and hold."""
        return self.begin("take off", self._take_off)

    def _take_off(self) -> Outputs:
        self.run(0.5)
        self.step(self.order(OrderKind.TAKE_OFF))
        self.until(lambda o: o.phase is Phase.HOLDING, 10.0)
        return self.run(2.0)

    def hover(self, place: Vec2) -> Outputs:
        """Fly to a place [m] and hover there."""
        return self.begin(f"hover at {place}", lambda: self._hover(place))

    def _hover(self, place: Vec2) -> Outputs:
        self.run(0.5)
        self.step(self.order(OrderKind.GO, goal=place))
        self.until(lambda o: o.phase is Phase.HOLDING, 60.0)
        return self.run(1.0)

    def depart(self, seconds: float = 0.0) -> Outputs:
        """Leave for the entrance and fly this long on the path."""
        return self.begin(f"depart {seconds}", lambda: self._depart(seconds))

    def _depart(self, seconds: float) -> Outputs:
        self.run(0.5)
        self.step(self.order(OrderKind.GO, place="entrance"))
        outputs = self.until(lambda o: o.phase is Phase.OUTBOUND)
        return self.run(seconds) if seconds else outputs

    @property
    def home_error(self) -> float:
        """Distance from the pad [m]."""
        return distance((self.body.x, self.body.y), self.room.home)

    @property
    def speed(self) -> float:
        """Speed over the ground [m/s]."""
        return hypot(self.body.vx, self.body.vy)

    def told(self, code: str) -> bool:
        """Whether an event with this code was given."""
        return any(event.code == code for event in self.events)


def from_path(places: FloatArray, path: tuple[Vec2, ...]) -> list[float]:
    """Distances of places, shape (n, 2), from a line of waypoints [m]."""
    points = np.array(path)
    starts, ways = points[:-1], np.diff(points, axis=0)
    lengths = np.maximum((ways * ways).sum(axis=1), 1e-300)
    offsets = places[:, None] - starts
    shares = np.clip((offsets * ways).sum(axis=2) / lengths, 0.0, 1.0)
    return np.hypot(*np.moveaxis(offsets - shares[..., None] * ways, 2, 0)).min(axis=1).tolist()


@pytest.fixture
def fly(request: pytest.FixtureRequest) -> Callable[..., Flight]:
    """Return a maker of flights: ``fly(mode="paper", rate_hz=30, loss=0.2, ...)``; other names are
    dotted keys of the site.

    Flights made alike share how they begin, but for those of tests that patch what flies.
    """
    is_patched = "monkeypatch" in request.fixturenames

    def make(
        mode: str = "default",
        constants: Constants | None = None,
        wind: Vec2 = (0.0, 0.0),
        delay: float = 0.06,
        seed: int = 1,
        tracking: dict[str, object] | None = None,
        is_mapped: bool = False,
        tick: float = TICK,
        **keys: object,
    ) -> Flight:
        flight = Flight(
            changed(Site(), mode=mode, **keys),
            Tracking(**(tracking or {})),  # type: ignore[arg-type]
            constants,
            wind,
            delay,
            seed,
            is_mapped,
            tick,
        )
        if not is_patched:
            flight.made = repr(
                (mode, constants, wind, delay, seed, tracking, is_mapped, tick, keys)
            )
        return flight

    return make
