"""Tracking systems that tell untruths with fresh stamps, for flights in lock step."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from math import hypot, inf, pi

from branched import branched

from housefly.geometry import Vec2, quaternion_from_euler
from housefly.lab.lockstep.simulation import Simulation
from housefly.messages import (
    DroneStatus,
    Order,
    OrderKind,
    Outputs,
    Phase,
    Pose,
    Sighting,
    Telemetry,
)

BODY = "ardrone"
Lie = Callable[[Sighting], "Sighting | None"]
"""What the tracking system makes of a sighting; None hides the body."""


def moved(sighting: Sighting, x: float, y: float, z: float = 0.0, yaw: float = 0.0) -> Sighting:
    """Return a sighting shifted by x, y, z [m] and turned by yaw [rad] about its own place."""
    pose = sighting.pose
    place = (pose.position[0] + x, pose.position[1] + y, pose.position[2] + z)
    turned = quaternion_from_euler(0.0, 0.0, pose.yaw + yaw) if yaw else pose.orientation
    return replace(sighting, pose=Pose(place, turned))


def shifted(x: float, y: float, z: float = 0.0, since: float = -inf) -> Lie:
    """The origin lies elsewhere [m]."""
    return lambda s: moved(s, x, y, z) if s.captured_at >= since else s


def drifting(x: float, y: float, since: float) -> Lie:
    """The map drifts [m/s] since a time [s]."""
    return lambda s: moved(s, *(rate * max(0.0, s.captured_at - since) for rate in (x, y)))


def stepping(size: float, period: float, since: float) -> Lie:
    """The map jumps by a size [m] along y once a period [s]."""
    return lambda s: moved(s, 0.0, size * max(0.0, (s.captured_at - since) // period))


def misdefined(yaw: float) -> Lie:
    """The body is defined turned by an angle [rad]."""
    return lambda s: moved(s, 0.0, 0.0, 0.0, yaw)


def gap(start: float, seconds: float, x: float, y: float) -> Lie:
    """Nothing for a while, then a place shifted by (x, y) [m]."""

    def told(s: Sighting) -> Sighting | None:
        if s.captured_at < start:
            return s
        return None if s.captured_at < start + seconds else moved(s, x, y)

    return told


def mirrored(center: Vec2, axis: int = 0, heading: bool = True) -> Lie:
    """The map is mirrored about a point [m] along an axis (0 is x, 1 is y)."""

    def told(s: Sighting) -> Sighting:
        x, y, z = s.pose.position
        place = (2 * center[0] - x, y, z) if axis == 0 else (x, 2 * center[1] - y, z)
        yaw = (pi - s.pose.yaw if axis == 0 else -s.pose.yaw) if heading else s.pose.yaw
        return replace(s, pose=Pose(place, quaternion_from_euler(0.0, 0.0, yaw)))

    return told


def unstamped(seconds: float) -> Lie:
    """Poses are older than their stamps say [s]; the harness holds them back."""

    waiting: list[Sighting] = []

    def told(s: Sighting) -> Sighting | None:
        waiting.append(s)
        late: Sighting | None = None
        while waiting and waiting[0].captured_at <= s.captured_at - seconds:
            late = waiting.pop(0)
        return late and replace(late, captured_at=s.captured_at, received_at=s.received_at)

    return told


@dataclass
class LiedFlight:
    """A flight in lock step under a lie, scored on the truth.

    Attributes:
        sim: world and pilot.
        lie: what tracking makes of a sighting of the drone; None leaves it honest.
        since: what came before does not count [s].
        report: what becomes of the drone's own report.
        status: of the drone, by its own word.
        outputs: of the last step.
        told: time [s], code and words of each event.
        speed: highest true speed in the air [m/s].
        contacts: most points at which the drone touched something in the air.
        travelled: true way in the air [m].
        lied: distance between true and told place in the newest sighting [m].
        travelled_when_told, lied_when_told, lied_when_landing: the two when tracking was first
            said to be wrong, and when the landing began.
    """

    sim: Simulation
    lie: Lie | None = None
    since: float = 0.0
    report: Callable[[Telemetry], Telemetry] = field(default=lambda told: told)
    status: DroneStatus = DroneStatus.LANDED
    outputs: Outputs | None = None
    told: list[tuple[float, str, str]] = field(default_factory=list)
    speed: float = 0.0
    contacts: int = 0
    travelled: float = 0.0
    lied: float = 0.0
    travelled_when_told: float = inf
    lied_when_told: float = inf
    lied_when_landing: float = inf

    def step(self, *orders: Order) -> Outputs:
        """Run one round."""
        before = self.sim.now
        self.sim.advance()
        # A lie that is there from the start would keep it on its pad.
        inputs = replace(self.sim.inputs(*orders), origin_known=True)
        if inputs.telemetry is not None:
            report = self.report(inputs.telemetry)
            inputs, self.status = replace(inputs, telemetry=report), report.status
        if self.lie is not None:
            inputs = replace(inputs, sightings=self._told(inputs.sightings))
        self.outputs = self.sim.step(inputs).outputs
        self._score(self.sim.now - before)
        return self.outputs

    def _told(self, sightings: tuple[Sighting, ...]) -> tuple[Sighting, ...]:
        assert self.lie is not None
        told = []
        for sighting in sightings:
            made = self.lie(sighting) if sighting.body == BODY else sighting
            if made is None:
                continue
            if sighting.body == BODY:
                before, after = sighting.pose.position, made.pose.position
                self.lied = hypot(after[0] - before[0], after[1] - before[1])
            told.append(made)
        return tuple(told)

    def _score(self, elapsed: float) -> None:
        assert self.outputs is not None
        truth = self.sim.world.truth()
        height = truth.pose.position[2]
        airborne = self.status in (DroneStatus.FLYING, DroneStatus.TAKING_OFF, DroneStatus.LANDING)
        if self.sim.now >= self.since and airborne:
            vx, vy, _ = truth.velocity
            self.speed = max(self.speed, hypot(vx, vy))
            self.travelled += hypot(vx, vy) * elapsed
            if height > 0.15:
                self.contacts = max(self.contacts, truth.contacts)
        for event in self.outputs.events:
            self.told.append((self.sim.now, event.code, event.text))
            is_first = self.travelled_when_told == inf and self.sim.now >= self.since
            if is_first and event.code.startswith("tracking"):
                self.travelled_when_told, self.lied_when_told = self.travelled, self.lied
        if self.status is DroneStatus.LANDING and self.lied_when_landing == inf:
            self.lied_when_landing = self.lied

    def run(self, seconds: float) -> None:
        """Run for a while [s]."""
        end = self.sim.now + seconds
        while self.sim.now < end:
            self.step()

    def begin(self, place: str = "entrance") -> None:
        """Order a service, half a second after the start."""
        while self.sim.now < 0.5:
            self.step()
        self.step(Order(OrderKind.SERVICE, place=place, look_s=2.0))

    def lied_to(self, lie: Lie | None, since: float) -> LiedFlight:
        """Return the same flight, going on under a lie that begins later than now [s]."""
        assert self.lie is None and self.sim.now < since
        return replace(branched(self), lie=lie, since=since)

    def service(self, limit: float = 60.0) -> None:
        """Fly the service until the drone stands again, or for this long [s]."""
        if self.sim.now < 0.5:
            self.begin()
        flew = False
        while self.sim.now < limit:
            outputs = self.step()
            flew = flew or self.status is DroneStatus.FLYING
            if flew and self.status in (DroneStatus.LANDED, DroneStatus.EMERGENCY):
                break
            if not flew and self.sim.now > 12.0 and outputs.phase is Phase.IDLE:
                break

    @property
    def codes(self) -> tuple[str, ...]:
        """Codes of what was told."""
        return tuple(code for _, code, _ in self.told)
