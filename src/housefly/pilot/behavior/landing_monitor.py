"""Watches the column below the drone before it lands: free to the floor, or it waits or moves on.

    arrived ──column free──► sinks by the pilot ──low, still free──► the drone's own landing
       └──column blocked──► waits in the air; after a while tries another place within 2 m

Whoever has not moved for long counts as a thing here, beside which the drone may land: else a chair
that is taken for a person keeps it in the air.

The drone's own landing cannot be called back, and drifts with a draught. The pilot therefore sinks
to ``limits.landing_height`` itself, above its spot, and rises again when somebody comes. What the
safety gate lands is landed, and in mode paper the drone lands by itself where nobody is near.
"""

from __future__ import annotations

from math import inf

from housefly.config.limits import LimitsConfig
from housefly.geometry import Vec2, distance
from housefly.messages.event_code import EventCode
from housefly.messages.flight import Event, Phase, Severity
from housefly.messages.words import UNSAID, Words, figure
from housefly.pilot.behavior.braking import sink_height
from housefly.pilot.behavior.commander import Commander
from housefly.pilot.behavior.mission import TrackingTask, VehicleStatus
from housefly.pilot.behavior.mission_tables import SIGNALS, Signal
from housefly.pilot.behavior.navigator import Navigator

GUIDED_DISTANCE = 4.0
"""In mode paper the pilot sinks itself with somebody nearer than this [m]: the drone's own landing
takes 3 s.
"""
ON_GOAL = 0.3
"""A landing so near to its goal sinks above the goal, any other one where the drone is [m]."""
OVERHEAD, OVERHEAD_PERIOD = 0.5, 1.0
"""Above what is nearer below than this [m] the drone rises for so long [s], and leaves."""
FLOOR_HEIGHT = 0.1
"""Where tracking and the sonar never agree, the drone lands itself once either is so low [m]."""
SPOT_PERIOD = 3.0
"""How often another place to land is looked for [s] ..."""
SPOT_RETRY = 0.5
"""... and how soon the next one when no way leads to it [s]."""

_CHOSEN = frozenset({Signal.ARRIVED_HOME, Signal.BLOCKED, Signal.OVERDUE})
"""Signals that lead to a landing which can wait."""


class LandingMonitor:
    """Lets the landings of one commander happen, or holds them back.

    Args:
        commander: whose landings.
        navigator: who knows people and things.
        paper: whether the drone lands by itself where nobody comes, as in the paper.
        limits: down to where the pilot sinks itself.
    """

    def __init__(
        self,
        commander: Commander,
        navigator: Navigator,
        paper: bool,
        limits: LimitsConfig,
    ) -> None:
        self._lowest, self._lead = limits.landing_height, limits.landing_lead
        self._commander, self._people = commander, navigator.people
        self._guided = navigator.sees_people or not paper
        self._ask_at = -inf
        self._unreachable: set[Vec2] = set()
        self._fault = self._told = UNSAID
        self._sinking: TrackingTask | None = None
        self._sonar_wrong = False

    def allowed(self, found: list[Signal], vehicle: VehicleStatus) -> list[Signal]:
        """Return the signals without those that would land the drone onto somebody."""
        phase = self._commander.state.phase
        landing = [
            signal
            for signal in found
            if signal in _CHOSEN and SIGNALS[signal][phase] is Phase.LANDING
        ]
        if phase in (Phase.LANDING, Phase.TAKING_OFF, Phase.IDLE):
            self._sinking, self._fault = None, UNSAID
            return found
        if self._commander.task is not self._sinking:
            self._sinking = None
        if not landing and self._sinking is None:
            return found
        others = [signal for signal in found if signal not in landing]
        self._fault = self._column_fault(vehicle)
        if self._fault:
            self._rise()
            return others
        if self._commander.sonar.found:
            self._pause(vehicle)
            return others
        if self._sinking is None and not self._is_guided(vehicle):
            return found
        return others if self._sink(vehicle) else [*others, *(landing or [Signal.ARRIVED_HOME])]

    def step(self, vehicle: VehicleStatus) -> list[Event]:
        """Say what holds a landing back, and look for another place."""
        events = self._tell_of_sonar(vehicle)
        if not self._fault:
            self._told = UNSAID
            return events
        fault, self._fault = self._fault, UNSAID
        if not self._told:
            text = Words("not landing: {why}", why=fault)
            events.append(Event(vehicle.now, Severity.WARNING, EventCode.LANDING_BLOCKED, text))
            self._told = fault
            self._ask_at = vehicle.now + self._patience(vehicle)
            self._unreachable.clear()
        if vehicle.now >= self._ask_at:
            self._ask_at = vehicle.now + SPOT_PERIOD
            events.extend(self._elsewhere(vehicle))
        return events

    def _tell_of_sonar(self, vehicle: VehicleStatus) -> list[Event]:
        was_wrong, self._sonar_wrong = self._sonar_wrong, self._commander.sonar.is_wrong
        if was_wrong or not self._sonar_wrong:
            return []
        return [Event(vehicle.now, Severity.WARNING, EventCode.SONAR_WRONG, _SONAR_WRONG)]

    def _patience(self, vehicle: VehicleStatus) -> float:
        """Return how long to wait for what is below to go away [s]."""
        if vehicle.place is None or vehicle.estimate is None:
            return SPOT_PERIOD
        if self._people.ground_fault(vehicle.place):
            return 0.0
        sonar = self._commander.sonar
        gap = vehicle.estimate.position[2] - sonar.found
        return OVERHEAD_PERIOD if sonar.is_sure(vehicle.now) and gap < OVERHEAD else SPOT_PERIOD

    def _column_fault(self, vehicle: VehicleStatus) -> Words:
        if vehicle.place is None:
            return UNSAID
        fault = self._people.landing_fault(vehicle.place, vehicle.now)
        fault = fault or self._people.ground_fault(vehicle.place)
        return fault or self._commander.fault_below(vehicle.place, vehicle)

    def _is_guided(self, vehicle: VehicleStatus) -> bool:
        """Return whether the pilot sinks itself."""
        if vehicle.place is None or vehicle.estimate is None or self._guided:
            return vehicle.place is not None and vehicle.estimate is not None
        near = self._people.separation(vehicle.place, (0.0, 0.0), vehicle.now, 0.0)
        return near.now < GUIDED_DISTANCE

    def _rise(self) -> None:
        if self._sinking is not None:
            self._commander.descend_to(None)
            self._sinking = None

    def _pause(self, vehicle: VehicleStatus) -> None:
        """Sink no further until it is known whether something stands below."""
        if self._sinking is not None and vehicle.estimate is not None:
            self._commander.descend_to(vehicle.estimate.position[2])
            self._sinking = self._commander.task

    def _sink(self, vehicle: VehicleStatus) -> bool:
        """Sink a little further; return whether there is still a way to go."""
        assert vehicle.estimate is not None
        x, y, z = vehicle.estimate.position
        if z <= self._lowest + 0.05 or self._is_on_floor(vehicle):
            return False
        commander = self._commander
        if self._sinking is None:
            goal = commander.state.mission.goal
            is_there = goal is not None and distance(goal, (x, y)) < ON_GOAL
            commander.hold_at(goal if goal is not None and is_there else (x, y), vehicle)
        commander.descend_to(sink_height(z, self._lowest - self._lead))
        self._sinking = commander.task
        return True

    def _is_on_floor(self, vehicle: VehicleStatus) -> bool:
        """Return whether the drone may be as low as it says, and tracking too high."""
        is_told = vehicle.telemetry is not None and vehicle.telemetry.height < FLOOR_HEIGHT
        return is_told and self._commander.sonar.is_wrong

    def _elsewhere(self, vehicle: VehicleStatus) -> list[Event]:
        place = vehicle.place
        if place is None:
            return []
        found = tuple(self._commander.found)
        spot = self._people.landing_spot(place, vehicle.now, found, self._unreachable)
        if spot is None:
            self._unreachable.clear()
            return self._nowhere(vehicle)
        if self._commander.land_at(spot, vehicle) is not None:
            self._unreachable.add(spot)
            self._ask_at = vehicle.now + SPOT_RETRY
            return []
        text = Words("landing {d} m beside", d=figure(distance(place, spot), ".1f"))
        return [Event(vehicle.now, Severity.INFO, EventCode.LANDING_ELSEWHERE, text)]

    def _nowhere(self, vehicle: VehicleStatus) -> list[Event]:
        if self._told == _NOWHERE:
            return []
        self._told = _NOWHERE
        return [Event(vehicle.now, Severity.WARNING, EventCode.LANDING_BLOCKED, _NOWHERE)]


_SONAR_WRONG = Words("the drone's sonar shows something everywhere: landing by the tracked height")
_NOWHERE = Words("no clear place to land within 2 m: waiting in the air")
