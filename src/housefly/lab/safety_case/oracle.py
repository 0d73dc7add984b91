"""Judges a flight on the truth: contacts, fence, commands, motors, and whether it ends.

The numbers I1 to I10 are those of the fault matrix. What the pilot believed plays no part, except
for what a person was told.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from math import hypot, inf, isfinite

import numpy as np

from housefly.config.limits import LimitsConfig
from housefly.config.site import Site
from housefly.geometry import Vec2, Vec3, stopping_distance
from housefly.messages import (
    Action,
    DroneStatus,
    Phase,
    PilotStep,
    SafetyMode,
    SetpointForm,
    Severity,
)
from housefly.messages.steering import numbers_of
from housefly.pilot.safety.motion_rules import speed_bound
from housefly.record.places import distances_to_path
from housefly.room.model import Room
from housefly.twin.clearance import Clearance
from housefly.twin.contact_log import Contact
from housefly.twin.contracts import FlightState
from housefly.twin.solids import SolidKind
from housefly.twin.world import SimulatedWorld

STANDING = 0.12
"""A drone whose origin is lower than this stands on the floor [m] ..."""
STANDING_SLACK = 0.05
"""... and so does one with long legs, no more than this above where it stands [m]."""
FALL_HEIGHT = 0.3
"""Motors that stop above this let the drone fall [m]."""
HARD_LANDING = 1.5
"""A drone that comes down faster than this is damaged [m/s]."""
TAKE_OFF_RATE, TAKE_OFF_END = 0.4, 1.0
"""The drone's own take-off climbs so fast [m/s], and can be steered from this height on [m]."""
DODGE_TIME = 0.8
"""No drone gets out of the way of who walks straight at it within this [s]: half its hull and half
a body are 0.5 m, which take 0.7 s at its largest tilt, and 0.1 s pass before it moves.
"""
TOWARDS_SPEED = 0.1
"""A drone that moves faster than this at whom it touches flies into them [m/s]."""
THROWN_TIME = 3.0
"""What a drone that was walked into touches within this belongs to the blow [s]: thrown at 1.4 m/s,
it stands 0.9 m away after 2 s.
"""
STOOD_TIME = 20.0
"""Who has stood for so long has ended, whatever the pilot knows of it [s]."""
_LOOK_PERIOD = 0.05
"""How often clearances are taken [s]."""
_COMMAND_SLACK = 1e-9
_COMMAND_BOUNDS: dict[SetpointForm, Callable[[LimitsConfig], tuple[float, ...]]] = {
    SetpointForm.TILT_AND_CLIMB: lambda limits: (
        *(limits.tilt_max, limits.tilt_max, limits.full_climb, limits.yaw_rate_max),
    ),
    SetpointForm.VELOCITY: lambda limits: (
        *(speed_bound(limits), speed_bound(limits), limits.full_climb, limits.yaw_rate_max),
    ),
    SetpointForm.POSITION: lambda limits: (inf, inf, inf, limits.yaw_rate_max),
}
"""Of each number of a setpoint, by its form; where a place may be, I2 watches."""


@dataclass(slots=True)
class Oracle:
    """Watches one flight in the simulated room.

    Attributes:
        world: the simulated room.
        site, room: what is flown in.
        faulty_since: when the fault began [s]; infinite before.
        cannot_hover: whether it has to fall by its fault, which is not judged then.
        orders: how many were given that may make it take off.
        violations: what was broken, by invariant, in words.
        walked_into: who walked into a drone that could not have been steered away in time, in
            words, or "".
    """

    world: SimulatedWorld
    site: Site
    room: Room
    faulty_since: float = inf
    cannot_hover: bool = False
    orders: int = 1
    violations: dict[str, str] = field(default_factory=dict)
    walked_into: str = ""
    told_at: float | None = None
    told: str = ""
    deviation: float = 0.0
    room_clearance: float = inf
    person_clearance: float = inf
    top_speed: float = 0.0
    grounded_at: float | None = None
    _path: tuple[Vec2, ...] = ()
    _flown: list[Vec2] = field(default_factory=list)
    _bound_until: float | None = None
    _walked_into_at: float = inf
    _thrown: bool = False
    _cut_ordered: bool = False
    _take_offs: int = 0
    _was_airborne: bool = False
    _looked_at: float = -inf
    _height: float = 0.0

    @property
    def _standing(self) -> float:
        return max(STANDING, self.site.drone.airframe.body.standing_height + STANDING_SLACK)

    def watch(self, step: PilotStep) -> None:
        """Take in one step of the pilot and what the world did since the last."""
        truth, state = self.world.truth(), self.world.onboard().flight
        self._watch_words(step)
        self._watch_command(step)
        self._watch_motors(step, state, truth.pose.position[2])
        self._watch_place(truth.pose.position, truth.velocity, state)
        self._watch_take_off(step.now, state, truth.pose.position[2])
        self._watch_motion(state)
        self._watch_contacts()
        self._watch_clearance(step.now, state)
        if step.outputs.path is not None and step.outputs.path.waypoints != self._path:
            self._take_deviation()
            self._path = step.outputs.path.waypoints
        if state.airborne and step.now >= self.faulty_since and self._path:
            self._flown.append(truth.pose.position[:2])
        is_down = not state.airborne and truth.pose.position[2] < self._standing
        if not is_down:
            self.grounded_at = None
        elif self.grounded_at is None:
            self.grounded_at = step.now
        self._height = truth.pose.position[2]

    def _take_deviation(self) -> None:
        """How far the drone strayed from the path that ends here; all at once costs least."""
        if self._flown:
            away = distances_to_path(np.array(self._flown), self._path)
            self.deviation = max(self.deviation, float(away.max()))
            self._flown.clear()

    def _break(self, invariant: str, words: str) -> None:
        self.violations.setdefault(invariant, f"{invariant}: {words}")

    def _watch_words(self, step: PilotStep) -> None:
        """I7: when was a person told, and what."""
        if self.told_at is not None or step.now < self.faulty_since:
            return
        words = [e.text for e in step.outputs.events if e.severity is not Severity.INFO]
        words.extend(step.outputs.warnings)
        if step.outputs.safety not in (SafetyMode.NOMINAL, SafetyMode.STOPPED):
            words.append(step.outputs.reason)
        if words:
            self.told_at, self.told = step.now, words[0]

    def _watch_command(self, step: PilotStep) -> None:
        """I3: finite, and within the limits."""
        limits, command = self.site.limits, step.outputs.command
        asked = numbers_of(command.asked)
        if not all(map(isfinite, asked)):
            self._break("I3", "a command was not a number")
        bounds = _COMMAND_BOUNDS[command.form](limits)
        if any(abs(a) > b + _COMMAND_SLACK for a, b in zip(asked, bounds, strict=True)):
            self._break("I3", "a command was above its limit")
        self._cut_ordered |= step.outputs.command.action is Action.CUT

    def _watch_motors(self, step: PilotStep, state: FlightState, height: float) -> None:
        """I4: nobody cuts the motors of a flying drone, unless it tumbles."""
        if self._cut_ordered and height > FALL_HEIGHT and not self._tumbles():
            self._break("I4", f"the motors were cut at {height:.1f} m")

    def _tumbles(self) -> bool:
        onboard = self.world.onboard()
        return onboard.angles_out_of_range or onboard.flight is FlightState.EMERGENCY

    def _watch_place(self, position: Vec3, velocity: Vec3, state: FlightState) -> None:
        """I2: inside the room's fence by its stopping distance; and no fall."""
        speed = hypot(*velocity[:2])
        if self.world.now >= self.faulty_since and state.airborne:
            self.top_speed = max(self.top_speed, speed)
        x_min, y_min, x_max, y_max = self.room.bounds
        x, y, z = position
        outside = max(x_min - x, x - x_max, y_min - y, y - y_max, 0.0)
        if outside > stopping_distance(self.site.limits.speed, 1.0, 0.3):
            self._break("I2", f"{outside:.1f} m outside the room")
        falls = z < self._standing <= self._height and -velocity[2] > HARD_LANDING
        if falls and not self.cannot_hover:
            self._break("fall", f"came down at {-velocity[2]:.1f} m/s")

    def _watch_motion(self, state: FlightState) -> None:
        """I8: who has landed does not rise without another order."""
        self._take_offs += state.airborne and not self._was_airborne
        self._was_airborne = state.airborne
        if self._take_offs > self.orders:
            self._break("I8", "took off again without an order")

    def _watch_take_off(self, now: float, state: FlightState, height: float) -> None:
        """Note until when a fault finds a drone that nothing could steer out of the way."""
        if self._bound_until is not None or now < self.faulty_since:
            return
        left = max(0.0, TAKE_OFF_END - height) / TAKE_OFF_RATE
        is_bound = state is FlightState.TAKING_OFF
        self._bound_until = now + left + DODGE_TIME if is_bound else now

    def _watch_contacts(self) -> None:
        """I1: touches nothing but the floor while its motors turn.

        Whom a fault sends at a drone that is taking off, so late that no steering could have
        avoided them, walked into it, unless it moved at them: that is counted by itself, with the
        thing that the drone is thrown onto.
        """
        for contact in self.world.contact_log:
            if self._was_walked_into(contact):
                self.walked_into = f"{contact.name} at {contact.speed:.1f} m/s"
                self._walked_into_at = min(self._walked_into_at, contact.began_at)
            elif self._was_thrown(contact):
                self._thrown = True
            elif contact.motors_turned:
                what = f"{contact.kind.value} {contact.name}".strip()
                self._break("I1", f"touched {what} at {contact.speed:.1f} m/s")

    def _was_walked_into(self, contact: Contact) -> bool:
        return (
            contact.kind is SolidKind.PERSON
            and contact.motors_turned
            and not contact.from_above
            and contact.began_at < (self._bound_until or -inf)
            and contact.own_speed < TOWARDS_SPEED
        )

    def _was_thrown(self, contact: Contact) -> bool:
        since = contact.began_at - self._walked_into_at
        return contact.kind is not SolidKind.PERSON and 0.0 <= since < THROWN_TIME

    def _watch_clearance(self, now: float, state: FlightState) -> None:
        if not state.airborne or now - self._looked_at < _LOOK_PERIOD:
            return
        self._looked_at = now
        nearest = self.world.clearance(Clearance(self.room_clearance, self.person_clearance))
        self.room_clearance, self.person_clearance = nearest.solid, nearest.person

    def ended(self, step: PilotStep) -> bool:
        """Return whether the drone stands, idle, for a second; or for long, if nobody can tell."""
        stood = 0.0 if self.grounded_at is None else step.now - self.grounded_at
        telemetry = step.inputs.telemetry
        stands = telemetry is None or telemetry.status in (
            DroneStatus.LANDED,
            DroneStatus.EMERGENCY,
            DroneStatus.UNKNOWN,
        )
        is_idle = stands and step.outputs.phase is Phase.IDLE
        return stood > (1.0 if is_idle else STOOD_TIME)

    def conclude(self, step: PilotStep, expired: bool) -> str:
        """Return how the flight ended, in words; one that never ends is not safe."""
        self._take_deviation()
        state = self.world.onboard().flight
        if self.grounded_at is not None:
            is_idle = step.outputs.phase is Phase.IDLE
            return "stands on the floor" if is_idle else "stands on the floor, not idle"
        if not expired:
            return "harm was done"
        height = self.world.truth().pose.position[2]
        words = f"{step.outputs.phase.value} at {height:.1f} m: {step.outputs.reason or 'nominal'}"
        if state.airborne and height < FALL_HEIGHT:
            self._break("end", f"motors turn on the floor: {words}")
        elif state.airborne:
            self._break("end", f"never ended: {words}")
        elif not self._thrown:
            self._break("end", f"stands {height:.1f} m above the floor: {words}")
        return words
