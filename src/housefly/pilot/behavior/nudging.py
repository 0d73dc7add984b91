"""Moves a drone that holds its place by hand, for as long as somebody holds a key.

    nudge, ten times a second ──► motion that ends at rest ──free?──► flown
                                     │                      └─no──► slower, along a wall, or none
    no nudge for 0.3 s ──────────────┴──► brakes, hovers

Each motion brakes to rest by itself and is looked at as a whole, its stop included, before it is
flown: what is held is never more than the next 0.3 s.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import inf, nan

import numpy as np

from housefly.config.limits import LimitsConfig
from housefly.messages.event_code import EventCode
from housefly.messages.flight import Event, Order, OrderKind, Phase, Severity
from housefly.messages.order_fault import shown_name
from housefly.messages.words import UNSAID, Words
from housefly.numeric import FloatArray
from housefly.pilot.behavior.mission import STAY, TrackingTask, VehicleStatus
from housefly.pilot.behavior.navigator import Navigator
from housefly.pilot.behavior.proposal import NOTHING, Look, MissionChange, MissionView, Proposal
from housefly.pilot.behavior.trajectory_profile import trajectory_profile
from housefly.pilot.behavior.way_planner import departure_state
from housefly.pilot.planning.trajectory.held_motion import (
    held_limits,
    held_motion,
    held_velocity,
)
from housefly.pilot.planning.trajectory.kinematic_state import TICK

NUDGE_LIFETIME = 0.3
"""A nudge counts for this long from when it was given [s]; one that arrives older is nothing."""
PERIOD = 0.1
"""How often a motion under way is looked at again [s]."""
SHARES = (1.0, 0.7, 0.4, 0.2, 0.1)
"""Shares of the wanted speed that are tried, then the same along single axes: along a wall."""
QUIET_TIME = 2.0
"""It has ended when nobody has moved the drone for this long [s]."""
LIMIT_QUIET_TIME = 1.0
"""What limits it is told no more often than this [s]."""
_STILL = 1e-3
"""A slower reference stands [m/s]."""


@dataclass(frozen=True, slots=True, eq=False)
class HeldWish:
    """What somebody wants: a velocity [m/s], shape (3,), until a time [s]; and who."""

    velocity: FloatArray
    until: float
    sender: str


class NudgeMonitor:
    """Moves the reference by hand.

    Attributes:
        is_moving: the drone is on a motion by hand, so people slow that and not its time.
    """

    def __init__(self, mission: MissionView, navigator: Navigator, limits: LimitsConfig) -> None:
        self._mission, self._navigator = mission, navigator
        self._limits = held_limits(limits)
        self._wish: HeldWish | None = None
        self._task: TrackingTask | None = None
        self._is_braking = False
        self._asked_at = self._held_at = self._limited_at = -inf
        self._limited = b""
        self._told_of: str | None = None

    @property
    def is_moving(self) -> bool:
        """Whether the drone is on a motion by hand, or rests at its end."""
        return self._task is not None and self._mission.task is self._task

    def heard(self, order: Order, answer: Event, now: float) -> list[Event]:
        """Take in an order with the commander's answer; return what people should know of it."""
        if order.kind is not OrderKind.NUDGE:
            self._wish = None
            return [answer]
        if not abs(now - order.issued_at) <= NUDGE_LIFETIME:
            return []
        if answer.code is not EventCode.ORDER_ACCEPTED or order.velocity is None:
            self._wish = None
            return [answer]
        velocity = held_velocity(np.array(order.velocity), self._limits)
        until = min(now, order.issued_at) + NUDGE_LIFETIME
        self._wish = HeldWish(velocity, until, shown_name(order.sender))
        self._asked_at, self._held_at = -inf, now
        return []

    def propose(self, look: Look) -> Proposal:
        """Move the drone on, or let it come to rest; say what people should know."""
        if self._wish is None and self._told_of is None:
            return NOTHING
        vehicle, state = look.vehicle, self._mission.state
        is_ours = state.phase is Phase.HOLDING and not state.stopped and vehicle.estimate
        if not is_ours or vehicle.held or self._mission.task.waiting:
            self._wish = None
            return Proposal(events=self._ended(vehicle, at_once=True))
        wish = self._wish if self._wish and vehicle.now <= self._wish.until else None
        self._wish = wish
        if wish is not None:
            begun = self._begun(wish, vehicle)
            return self._hold(wish, vehicle, look.share, begun)
        was_moving = self.is_moving
        task = self._brake(vehicle)
        return self._moved(task, vehicle, self._ended(vehicle, at_once=not was_moving))

    def _hold(
        self, wish: HeldWish, vehicle: VehicleStatus, share: float, begun: tuple[Event, ...]
    ) -> Proposal:
        if vehicle.now - self._asked_at < PERIOD - 1e-6:
            return Proposal(events=begun)
        self._asked_at, why = vehicle.now, UNSAID
        task: TrackingTask | None
        for velocity in _tried(share * wish.velocity):
            rows = self._motion(velocity, wish.until - vehicle.now, vehicle)
            closed = self._navigator.closed(rows, vehicle.now)
            if not closed:
                task = self._flown(rows, vehicle)
                break
            why = why or closed
        else:
            task = self._brake(vehicle)
        return self._moved(task, vehicle, begun + self._tell_limit(why, wish, vehicle.now))

    def _moved(
        self, task: TrackingTask | None, vehicle: VehicleStatus, events: tuple[Event, ...]
    ) -> Proposal:
        """Propose a motion by hand; it counts as a fresh order to stay."""
        if task is None:
            return Proposal(events=events)
        state = self._mission.state.entering(Phase.HOLDING, vehicle.now, STAY)
        return Proposal(MissionChange.MOVE, EventCode.NUDGE_BEGAN, task, state, events)

    def _brake(self, vehicle: VehicleStatus) -> TrackingTask | None:
        """Return the task of coming to rest; None where the drone does so, or was not moved."""
        if not self.is_moving or self._is_braking:
            return None
        task = self._flown(self._motion(_NOTHING, 0.0, vehicle), vehicle)
        self._is_braking = True
        return task

    def _motion(self, velocity: FloatArray, held: float, vehicle: VehicleStatus) -> FloatArray:
        start = departure_state(
            self._mission.task, vehicle, self._mission.airframe.braking.coast_time
        )
        return held_motion(start, velocity, held, self._limits)

    def _flown(self, rows: FloatArray, vehicle: VehicleStatus) -> TrackingTask:
        """Return the task of flying a motion, with the heading that the drone has."""
        assert vehicle.estimate is not None
        yaw = vehicle.reference.yaw if vehicle.reference else vehicle.estimate.yaw
        x, y = rows[-1, :2].tolist()
        profile = trajectory_profile(rows, yaw, nan, np.full(len(rows), yaw))
        task = TrackingTask(profile, duration=TICK * (len(rows) - 1), hold=(x, y), hold_yaw=yaw)
        self._task, self._is_braking = task, False
        return task

    def _begun(self, wish: HeldWish, vehicle: VehicleStatus) -> tuple[Event, ...]:
        if self._told_of == wish.sender:
            return ()
        self._told_of = wish.sender
        text = Words("moved by hand")
        if wish.sender:
            text = Words("moved by hand by {who}", who=wish.sender)
        return (Event(vehicle.now, Severity.INFO, EventCode.NUDGE_BEGAN, text),)

    def _ended(self, vehicle: VehicleStatus, *, at_once: bool) -> tuple[Event, ...]:
        is_over = at_once or vehicle.now - self._held_at >= QUIET_TIME
        if not (self._told_of is not None and is_over):
            return ()
        self._told_of, self._limited, self._task = None, b"", None
        text = Words("moved by hand no longer")
        return (Event(vehicle.now, Severity.INFO, EventCode.NUDGE_ENDED, text),)

    def _tell_limit(self, why: Words, wish: HeldWish, now: float) -> tuple[Event, ...]:
        """Say what limits the motion when it begins to, and for another direction again."""
        if not why:
            self._limited = b""
            return ()
        direction = np.sign(wish.velocity).tobytes()
        if direction == self._limited or now - self._limited_at < LIMIT_QUIET_TIME:
            return ()
        self._limited, self._limited_at = direction, now
        text = Words("moved by hand: {why}", why=why)
        return (Event(now, Severity.INFO, EventCode.NUDGE_LIMITED, text),)


_NOTHING: FloatArray = np.zeros(3)


def _tried(velocity: FloatArray) -> Iterator[FloatArray]:
    """Yield the velocities to try, the best first: slower ones, then those along one axis."""
    yield from (share * velocity for share in SHARES)
    axes = [axis for axis in range(3) if abs(velocity[axis]) > _STILL]
    for axis in axes if len(axes) > 1 else ():
        along = np.zeros(3)
        along[axis] = velocity[axis]
        yield from (share * along for share in SHARES)
