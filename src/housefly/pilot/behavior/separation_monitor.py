"""Keeps the drone away from people: slower near them, out of their way before they arrive.

A drone that follows a path stops or goes around by ``collision_monitor``; what stands, waits, looks
or cannot stop in time makes way here. Whoever is cornered lands while there is time, else holds
still.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import inf

import numpy as np

from housefly.config.airframe import Airframe
from housefly.geometry import Vec2, distance
from housefly.messages.event_code import EventCode
from housefly.messages.flight import Event, Phase, Severity
from housefly.messages.obstacles import called
from housefly.messages.sensing import DroneStatus
from housefly.messages.words import Words
from housefly.numeric import FloatArray
from housefly.pilot.behavior.braking import EVASION_SPEED, REFERENCE_BRAKING
from housefly.pilot.behavior.mission import Refused, TrackingTask, VehicleStatus
from housefly.pilot.behavior.navigator import Navigator
from housefly.pilot.behavior.proposal import (
    AIRBORNE_PHASES,
    NOTHING,
    Look,
    MissionChange,
    MissionView,
    Proposal,
    landing_here,
    news,
)
from housefly.pilot.planning.people import SPEED_UNCERTAINTY, UNCERTAIN_TIME, speed_share
from housefly.pilot.planning.separation import STEP, Refuge, Separation, approach_speed
from housefly.pilot.planning.trajectory.kinematic_state import TICK
from housefly.pilot.planning.trajectory.time_scale import motion_at, scale_advanced

YIELD_HORIZON = 3.0
"""A standing drone makes way for who comes too near within this time [s] ..."""
CRUISE_HORIZON = 1.5
"""... one on its way within this [s]."""
YIELD_PERIOD = 0.1
"""How often it is asked who comes near [s]."""
CALM_TIME = 1.0
"""It goes back when nobody has come near for this long [s]."""
APPROACH = 0.1
"""Who comes nearer by less than this does not approach [m]."""
LEAD_TIME = 1.4
"""A place this far ahead at the wanted speed makes the drone fly at it [s]."""
CORNERED_DISTANCE = 0.25
"""The drone is cornered when even the best place lets somebody come nearer than this [m]."""
CORNERED_TIME = 0.1
"""It must be so for this long [s]."""
DECISION_MARGIN = 1.0
"""The drone lands no earlier than a landing takes, and this, before somebody reaches it [s]."""
TRAPPED_DOUBT = 0.3
"""On its way it must have had nowhere to go for so long before it lands [s]: at first sight nobody
is fast.
"""
TAKE_OFF_HEIGHT = 0.6
"""A take-off is given up for who comes near while the drone is lower than this [m]; it cannot be
steered, and higher up it is soon over.
"""
TAKE_OFF_HORIZON = 3.0
"""How far ahead a take-off looks for people [s]."""
TAKE_OFF_DOUBT = 0.2
"""Somebody comes for so long before a take-off is given up [s]: at first sight nobody is fast."""
ESCAPE_TIME = 0.5
"""A drone that has just taken off makes way within this [s]."""
LIKELY_DISTANCE = -SPEED_UNCERTAINTY * UNCERTAIN_TIME
"""On the likeliest way that somebody goes they touch the drone nearer than this [m]."""
QUIET_TIME = 3.0
"""Making way again so soon after the last time is not told again [s]."""
_GUIDED = frozenset({Phase.OUTBOUND, Phase.RETURNING})


_SAME = 0.1
"""A reference nearer to its trajectory than this is on it [m]."""


@dataclass(frozen=True, slots=True)
class Yielding:
    """How the drone makes way.

    Attributes:
        post: where it was, and comes back to [m].
        yaw: heading to keep [rad].
        refuge: where it goes [m].
        speed: the fastest to go there [m/s].
        name: for whom.
        phase: in which it began.
        threatened_at: when somebody last came near [s].
        cornered_at: since when there is nowhere to go [s]; infinite while there is.
    """

    post: Vec2
    yaw: float
    refuge: Vec2
    speed: float
    name: str
    phase: Phase
    threatened_at: float
    cornered_at: float = inf


class SeparationMonitor:
    """Watches people.

    Attributes:
        speed_factor: share of the cruise speed to fly at, 0 to 1.
    """

    def __init__(
        self, mission: MissionView, navigator: Navigator, airframe: Airframe, paper: bool
    ) -> None:
        self.speed_factor = 1.0
        self._mission, self._people, self._paper = mission, navigator.people, paper
        self._airframe = airframe
        self._touchdown_time = airframe.landing.touchdown_time
        self._decision_time = airframe.landing.touchdown_time + DECISION_MARGIN
        self._yielding: Yielding | None = None
        self._task: TrackingTask | None = None
        self._asked_at = self._told_at = self._ended_at = -inf
        self._coming_since = self._trapped_since = inf
        self._is_cornered_told = self._climbs_on = False

    @property
    def is_yielding(self) -> bool:
        """Whether the drone makes way now."""
        return self._yielding is not None and self._mission.task is self._task

    def propose(self, look: Look) -> Proposal:
        """Look at people once, and say what to do about them."""
        vehicle = look.vehicle
        place, state = vehicle.place, self._mission.state
        if place is None or (not len(self._people) and self._yielding is None):
            self.speed_factor = 1.0
            return NOTHING
        near = self._people.separation(place, (0.0, 0.0), vehicle.now, 0.0)
        self.speed_factor = self._factor(near.now)
        if state.phase is Phase.TAKING_OFF and not self._paper:
            return self._give_up_take_off(vehicle, place)
        is_ours = state.phase in AIRBORNE_PHASES and not state.stopped
        if not is_ours or self._paper or vehicle.landing_forced:
            self._yielding = None
            return NOTHING
        if vehicle.now - self._asked_at < YIELD_PERIOD - 1e-6:
            return NOTHING
        self._asked_at = vehicle.now
        if self._yielding is not None and not (
            self.is_yielding and self._yielding.phase is state.phase
        ):
            self._yielding = None
        threat = self._threat(vehicle, place, look.rate)
        if threat is not None:
            return self._make_way(threat, vehicle, place)
        return self._calm(vehicle, place) if self._yielding is not None else NOTHING

    def _give_up_take_off(self, vehicle: VehicleStatus, place: Vec2) -> Proposal:
        """Land a drone that has just left the floor when somebody walks up to it.

        Not where they would arrive before it stands, but late enough to be made way for in the
        air.
        """
        height = vehicle.estimate.position[2] if vehicle.estimate else TAKE_OFF_HEIGHT
        if height >= TAKE_OFF_HEIGHT or vehicle.status is DroneStatus.LANDED:
            return NOTHING
        found = self._comes_within(TAKE_OFF_HORIZON, vehicle, place)
        if found.closest >= self._people.config.min_distance:
            self._coming_since, self._climbs_on = inf, False
            return NOTHING
        self._coming_since = min(self._coming_since, vehicle.now)
        if self._climbs_on or vehicle.now - self._coming_since < TAKE_OFF_DOUBT:
            return NOTHING
        climb = self._airframe.take_off
        standing = climb.give_up_time + climb.give_up_time_per_height * height
        away = (climb.steerable_height - height) / climb.climb_rate + ESCAPE_TIME
        is_met = self._comes_within(standing, vehicle, place).closest < 0.0
        if is_met and self._comes_within(away, vehicle, place).closest > LIKELY_DISTANCE:
            self._climbs_on = True
            return NOTHING
        text = Words("{who} comes near: the take-off is given up", who=called(found.name))
        state, reason = self._mission.state, EventCode.TAKE_OFF_GIVEN_UP
        return landing_here(state, reason, Severity.WARNING, text, vehicle.now)

    def _comes_within(self, horizon: float, vehicle: VehicleStatus, place: Vec2) -> Separation:
        """Return how near who walks comes to a drone that stays, within a time [s]."""
        return self._people.separation(place, (0.0, 0.0), vehicle.now, horizon, walking=True)

    def _factor(self, distance_now: float) -> float:
        """Return the share of the cruise speed at a distance from people [m]."""
        config = self._people.config
        return speed_share(distance_now, config.slow_distance, config.comfort_distance)

    def _threat(self, vehicle: VehicleStatus, place: Vec2, rate: float) -> Separation | None:
        """Return who comes too near, or None."""
        config, task = self._people.config, self._mission.task
        following = task.is_following and self._mission.state.phase in _GUIDED
        if following and vehicle.estimate is not None:
            velocity = vehicle.estimate.velocity[:2]
            places = self._places_ahead(vehicle, min(self.speed_factor, rate))
            if places is None:
                found = self._people.separation(
                    place, velocity, vehicle.now, CRUISE_HORIZON, walking=True
                )
            else:
                found = self._people.separation_along(places, vehicle.now)
            if found.closest < config.min_distance:
                return found
            return self._trap(vehicle, place, velocity)
        found = self._people.separation(place, (0.0, 0.0), vehicle.now, YIELD_HORIZON)
        comes = found.closest < min(config.comfort_distance, found.now - APPROACH)
        if comes:
            return found
        is_close = found.now < config.min_distance
        return found if is_close and not self._people.is_still(found.name, vehicle.now) else None

    def _places_ahead(self, vehicle: VehicleStatus, wanted: float) -> FloatArray | None:
        """Return where a trajectory in space leads the drone [m], shape (n, 2).

        None where none is flown. Nearer to people it will be slower.

        Args:
            vehicle: where the drone is, and how far it has flown the trajectory.
            wanted: rate of the trajectory's time that is asked for now.
        """
        reference, profile = vehicle.reference, self._mission.task.profile
        place = vehicle.place
        if reference is None or profile is None or place is None or len(profile.motion) < 2:
            return None
        scale, rows, config = reference.scale, profile.motion, self._people.config
        people, places = self._people.walking(vehicle.now), []
        for n in range(round(CRUISE_HORIZON / STEP) + 1):
            here = motion_at(scale, rows, TICK)
            places.append((here.x, here.y))
            apart = people.nearest(places[-1], n * STEP) - self._people.hull
            share = speed_share(apart, config.slow_distance, config.comfort_distance)
            rate = min(wanted, share)
            scale = scale_advanced(scale, rows, TICK, rate, REFERENCE_BRAKING, STEP)
        target = (reference.target.x, reference.target.y)
        if distance(target, places[0]) > _SAME:
            return None  # the task is newer than the reference
        result: FloatArray = np.array(places) + (np.array(place) - np.array(target))
        return result

    def _trap(self, vehicle: VehicleStatus, place: Vec2, velocity: Vec2) -> Separation | None:
        """Return who reaches a drone on its way that could get nowhere, while it can still land.

        A second later it would be too late: in a dead end nobody is made way for.
        """
        found = self._comes_within(self._decision_time, vehicle, place)
        soon = self._comes_within(self._touchdown_time, vehicle, place).closest
        is_met = found.closest <= LIKELY_DISTANCE < soon
        if not is_met or self._refuge(vehicle, place, velocity)[0].separation >= CORNERED_DISTANCE:
            self._trapped_since = inf
            return None
        self._trapped_since = min(self._trapped_since, vehicle.now)
        return found if vehicle.now - self._trapped_since >= TRAPPED_DOUBT else None

    def _make_way(self, threat: Separation, vehicle: VehicleStatus, place: Vec2) -> Proposal:
        assert vehicle.estimate is not None
        before, now = self._yielding, vehicle.now
        vx, vy, _ = vehicle.estimate.velocity
        found, speed = self._refuge(vehicle, place, (vx, vy))
        cornered = found.separation < CORNERED_DISTANCE
        since = min(now, before.cornered_at) if before and cornered else now
        self._yielding = Yielding(
            post=before.post if before else self._post(place),
            yaw=before.yaw if before else self._yaw(vehicle, place),
            refuge=found.place,
            speed=speed,
            name=threat.name,
            phase=self._mission.state.phase,
            threatened_at=now,
            cornered_at=since if cornered else inf,
        )
        if not cornered or now - since < CORNERED_TIME:
            return self._go(vehicle, place, self._tell(vehicle))
        last = self._corner(vehicle, place)
        return self._go(vehicle, place, last.events) if last.task is None else last

    def _refuge(self, vehicle: VehicleStatus, place: Vec2, velocity: Vec2) -> tuple[Refuge, float]:
        """Return where to go and how fast [m/s]: no faster than usual where that is enough."""
        kept = self._yielding.refuge if self._yielding else None
        usual = self._people.config.yield_speed
        height = vehicle.estimate.position[2] if vehicle.estimate else None
        found = self._people.refuge(place, velocity, vehicle.now, usual, kept, height)
        if found.separation >= CORNERED_DISTANCE or usual >= EVASION_SPEED:
            return found, usual
        faster = self._people.refuge(place, velocity, vehicle.now, EVASION_SPEED, kept, height)
        is_better = faster.separation > found.separation
        return (faster, EVASION_SPEED) if is_better else (found, usual)

    def _go(self, vehicle: VehicleStatus, place: Vec2, events: tuple[Event, ...] = ()) -> Proposal:
        """Make for the refuge: as far ahead as makes the drone fly at the wanted speed."""
        yielding = self._yielding
        assert yielding is not None
        (x, y), (gx, gy) = place, yielding.refuge
        away = distance(place, yielding.refuge)
        speed = float(approach_speed(np.array(away), yielding.speed))
        share = speed * LEAD_TIME / max(away, 1e-6)
        why = Words("{who} comes near: making way", who=called(yielding.name))
        hold = (x + share * (gx - x), y + share * (gy - y))
        self._task = self._making_way(hold, yielding.yaw, why, vehicle)
        return Proposal(MissionChange.MAKE_WAY, EventCode.MAKING_WAY, self._task, events=events)

    def _making_way(
        self, hold: Vec2, yaw: float, why: Words, vehicle: VehicleStatus
    ) -> TrackingTask:
        """Return the task of making for a place out of somebody's way, in the phase under way.

        Args:
            hold: where to go [m].
            yaw: heading to keep [rad].
            why: in words, for people.
            vehicle: where the drone is.
        """
        before = self._mission.task
        return TrackingTask(
            duration=before.duration,
            hold=hold,
            hold_yaw=yaw,
            waiting=why,
            since=before.since if before.waiting else vehicle.now,
            height=self._mission.kept_height(vehicle),
        )

    def _calm(self, vehicle: VehicleStatus, place: Vec2) -> Proposal:
        """Go on to the refuge, then back when nobody is near any more."""
        yielding = self._yielding
        assert yielding is not None
        if vehicle.now - yielding.threatened_at < CALM_TIME:
            return self._go(vehicle, place)
        if yielding.phase in _GUIDED:
            why = self._mission.task.waiting
            task = self._making_way(place, yielding.yaw, why, vehicle)
            self._end(vehicle)
            return Proposal(MissionChange.MAKE_WAY, EventCode.MAKING_WAY, task)
        there = self._people.separation(yielding.post, (0.0, 0.0), vehicle.now, YIELD_HORIZON)
        if there.closest < self._people.config.comfort_distance + APPROACH:
            return self._go(vehicle, place)
        before, mission = self._mission.task, self._mission.state.mission
        back = self._mission.way(replace(mission, goal=yielding.post), vehicle)
        if isinstance(back, Refused):
            return NOTHING
        self._end(vehicle)
        text = Words("nobody comes near: going back")
        event = Event(vehicle.now, Severity.INFO, EventCode.GOING_BACK, text)
        back = back and replace(back, duration=before.duration)
        return Proposal(MissionChange.GO_BACK, event.code, back, events=(event,))

    def _end(self, vehicle: VehicleStatus) -> None:
        self._yielding, self._is_cornered_told = None, False
        self._ended_at = vehicle.now

    def _corner(self, vehicle: VehicleStatus, place: Vec2) -> Proposal:
        """Land while there is time, else hold still and say so."""
        assert self._yielding is not None
        name = called(self._yielding.name)
        still = (0.0, 0.0)
        soon = self._people.separation(place, still, vehicle.now, self._touchdown_time)
        later = self._people.separation(place, still, vehicle.now, self._decision_time)
        if later.closest > LIKELY_DISTANCE:
            return NOTHING
        if soon.closest > LIKELY_DISTANCE:
            self._yielding = None
            text = Words(
                "{who} comes near and there is no room to make way: landing here", who=name
            )
            state, reason = self._mission.state, EventCode.CORNERED_LANDING
            return landing_here(state, reason, Severity.WARNING, text, vehicle.now)
        if self._is_cornered_told:
            return NOTHING
        self._is_cornered_told = True
        text = Words("{who} comes near and there is no room to make way", who=name)
        return news(EventCode.CORNERED, Severity.WARNING, text, vehicle.now)

    def _tell(self, vehicle: VehicleStatus) -> tuple[Event, ...]:
        assert self._yielding is not None
        last = max(self._told_at, self._ended_at)
        self._told_at = vehicle.now
        if vehicle.now - last < QUIET_TIME:
            return ()
        text = Words("{who} comes near: making way", who=called(self._yielding.name))
        return (Event(vehicle.now, Severity.INFO, EventCode.MAKING_WAY, text),)

    def _post(self, place: Vec2) -> Vec2:
        """Return where the drone should be in this phase [m]."""
        task = self._mission.task
        if task.path is not None and task.is_following:
            return task.path.waypoints[-1]
        return task.hold or place

    def _yaw(self, vehicle: VehicleStatus, place: Vec2) -> float:
        state = self._mission.state
        wished = state.mission.arrival_yaw(place) if state.phase is Phase.LOOKING else None
        return vehicle.estimate.yaw if wished is None and vehicle.estimate else wished or 0.0
