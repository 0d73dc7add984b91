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

from dataclasses import replace
from math import inf

from housefly.config.limits import LimitsConfig
from housefly.geometry import Vec2, distance
from housefly.messages.event_code import EventCode
from housefly.messages.flight import Event, OrderKind, Phase, Severity
from housefly.messages.words import UNSAID, Words, figure
from housefly.pilot.behavior.braking import sink_height
from housefly.pilot.behavior.mission import (
    LANDING_PLACE,
    Mission,
    Refused,
    TrackingTask,
    VehicleStatus,
)
from housefly.pilot.behavior.mission_tables import SIGNALS, Signal
from housefly.pilot.behavior.navigator import Navigator
from housefly.pilot.behavior.proposal import (
    NOTHING,
    Look,
    MissionChange,
    MissionView,
    Proposal,
    news,
)

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
    """Lets landings happen, or holds them back.

    Args:
        mission: whose landings.
        navigator: who knows people and things.
        paper: whether the drone lands by itself where nobody comes, as in the paper.
        limits: down to where the pilot sinks itself.
    """

    def __init__(
        self,
        mission: MissionView,
        navigator: Navigator,
        paper: bool,
        limits: LimitsConfig,
    ) -> None:
        self._lowest, self._lead = limits.landing_height, limits.landing_lead
        self._mission, self._people = mission, navigator.people
        self._guided = navigator.sees_people or not paper
        self._ask_at = -inf
        self._unreachable: set[Vec2] = set()
        self._fault = self._told = UNSAID
        self._sinking: TrackingTask | None = None
        self._sonar_wrong = False

    def allowed(self, found: list[Signal], vehicle: VehicleStatus) -> tuple[list[Signal], Proposal]:
        """Return the signals without those that would land the drone onto somebody.

        Beside them how the drone sinks until then, or rises.
        """
        phase = self._mission.state.phase
        landing = [
            signal
            for signal in found
            if signal in _CHOSEN and SIGNALS[signal][phase] is Phase.LANDING
        ]
        if phase in (Phase.LANDING, Phase.TAKING_OFF, Phase.IDLE):
            self._sinking, self._fault = None, UNSAID
            return found, NOTHING
        if self._mission.task is not self._sinking:
            self._sinking = None
        if not landing and self._sinking is None:
            return found, NOTHING
        others = [signal for signal in found if signal not in landing]
        self._fault = self._column_fault(vehicle)
        if self._fault:
            return others, self._risen()
        if self._mission.sonar.found:
            return others, self._paused(vehicle)
        if self._sinking is None and not self._is_guided(vehicle):
            return found, NOTHING
        sunk = self._sunk(vehicle)
        if sunk is NOTHING:
            return [*others, *(landing or [Signal.ARRIVED_HOME])], NOTHING
        return others, sunk

    def propose(self, look: Look) -> Proposal:
        """Say what holds a landing back, and look for another place."""
        vehicle = look.vehicle
        events = self._tell_of_sonar(vehicle)
        if not self._fault:
            self._told = UNSAID
            return Proposal(events=events) if events else NOTHING
        fault, self._fault = self._fault, UNSAID
        if not self._told:
            text = Words("not landing: {why}", why=fault)
            event = Event(vehicle.now, Severity.WARNING, EventCode.LANDING_BLOCKED, text)
            events = (*events, event)
            self._told = fault
            self._ask_at = vehicle.now + self._patience(vehicle)
            self._unreachable.clear()
        if vehicle.now < self._ask_at:
            return Proposal(events=events)
        self._ask_at = vehicle.now + SPOT_PERIOD
        found = self._elsewhere(vehicle)
        return replace(found, events=events + found.events)

    def _tell_of_sonar(self, vehicle: VehicleStatus) -> tuple[Event, ...]:
        was_wrong, self._sonar_wrong = self._sonar_wrong, self._mission.sonar.is_wrong
        if was_wrong or not self._sonar_wrong:
            return ()
        return (Event(vehicle.now, Severity.WARNING, EventCode.SONAR_WRONG, _SONAR_WRONG),)

    def _patience(self, vehicle: VehicleStatus) -> float:
        """Return how long to wait for what is below to go away [s]."""
        if vehicle.place is None or vehicle.estimate is None:
            return SPOT_PERIOD
        if self._people.ground_fault(vehicle.place):
            return 0.0
        sonar = self._mission.sonar
        gap = vehicle.estimate.position[2] - sonar.found
        return OVERHEAD_PERIOD if sonar.is_sure(vehicle.now) and gap < OVERHEAD else SPOT_PERIOD

    def _column_fault(self, vehicle: VehicleStatus) -> Words:
        if vehicle.place is None:
            return UNSAID
        fault = self._people.landing_fault(vehicle.place, vehicle.now)
        fault = fault or self._people.ground_fault(vehicle.place)
        return fault or self._mission.fault_below(vehicle.place, vehicle)

    def _is_guided(self, vehicle: VehicleStatus) -> bool:
        """Return whether the pilot sinks itself."""
        if vehicle.place is None or vehicle.estimate is None or self._guided:
            return vehicle.place is not None and vehicle.estimate is not None
        near = self._people.separation(vehicle.place, (0.0, 0.0), vehicle.now, 0.0)
        return near.now < GUIDED_DISTANCE

    def _risen(self) -> Proposal:
        """Return to the usual height."""
        if self._sinking is None:
            return NOTHING
        task, self._sinking = replace(self._sinking, height=None), None
        return Proposal(MissionChange.DESCEND, EventCode.LANDING_BLOCKED, task)

    def _paused(self, vehicle: VehicleStatus) -> Proposal:
        """Sink no further until it is known whether something stands below."""
        if self._sinking is None or vehicle.estimate is None:
            return NOTHING
        self._sinking = replace(self._sinking, height=vehicle.estimate.position[2])
        return Proposal(MissionChange.DESCEND, EventCode.LANDING_BLOCKED, self._sinking)

    def _sunk(self, vehicle: VehicleStatus) -> Proposal:
        """Sink a little further; NOTHING when there is no way to go."""
        assert vehicle.estimate is not None
        x, y, z = vehicle.estimate.position
        if z <= self._lowest + 0.05 or self._is_on_floor(vehicle):
            return NOTHING
        mission, task = self._mission, self._sinking
        if task is None:
            goal, duration = mission.state.mission.goal, mission.task.duration
            is_there = goal is not None and distance(goal, (x, y)) < ON_GOAL
            spot = goal if goal is not None and is_there else (x, y)
            task = replace(mission.held_here(vehicle), hold=spot, duration=duration)
        self._sinking = replace(task, height=sink_height(z, self._lowest - self._lead))
        return Proposal(MissionChange.DESCEND, EventCode.ARRIVED_HOME, self._sinking)

    def _is_on_floor(self, vehicle: VehicleStatus) -> bool:
        """Return whether the drone may be as low as it says, and tracking too high."""
        is_told = vehicle.telemetry is not None and vehicle.telemetry.height < FLOOR_HEIGHT
        return is_told and self._mission.sonar.is_wrong

    def _elsewhere(self, vehicle: VehicleStatus) -> Proposal:
        place = vehicle.place
        if place is None:
            return NOTHING
        found = tuple(self._mission.found)
        spot = self._people.landing_spot(place, vehicle.now, found, self._unreachable)
        if spot is None:
            self._unreachable.clear()
            return self._nowhere(vehicle)
        mission = Mission(OrderKind.HOME, LANDING_PLACE, spot)
        way = self._mission.way(mission, vehicle)
        if isinstance(way, Refused):
            self._unreachable.add(spot)
            self._ask_at = vehicle.now + SPOT_RETRY
            return NOTHING
        text = Words("landing {d} m beside", d=figure(distance(place, spot), ".1f"))
        event = Event(vehicle.now, Severity.INFO, EventCode.LANDING_ELSEWHERE, text)
        state = self._mission.state.entering(mission.flying_phase, vehicle.now, mission)
        return Proposal(MissionChange.LAND_ELSEWHERE, event.code, way, state, (event,))

    def _nowhere(self, vehicle: VehicleStatus) -> Proposal:
        if self._told == _NOWHERE:
            return NOTHING
        self._told = _NOWHERE
        return news(EventCode.LANDING_BLOCKED, Severity.WARNING, _NOWHERE, vehicle.now)


_SONAR_WRONG = Words("the drone's sonar shows something everywhere: landing by the tracked height")
_NOWHERE = Words("no clear place to land within 2 m: waiting in the air")
