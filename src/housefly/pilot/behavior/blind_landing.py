"""A landing without tracking that would come down on somebody: held, moved aside, let go.

    tracking lost ──floor below clear──► the drone's own landing
        └──the sonar shows something──► holds by optical flow, moves aside, looks again

The place is the last believed pose, carried on by the drone's own motion. It is good enough for
seconds to a minute, and says itself how far it may be off; where a wall may be that near, where the
drone does not tell how it moves, and where somebody insists, it lands as it is.
"""

from __future__ import annotations

from math import hypot, inf

from housefly.config.limits import LimitsConfig
from housefly.geometry import distance
from housefly.messages.event_code import EventCode
from housefly.messages.flight import Event, Severity
from housefly.messages.obstacles import called
from housefly.messages.sensing import DroneStatus
from housefly.messages.words import UNSAID, Words, figure
from housefly.pilot.behavior.braking import BESIDE_SPEED
from housefly.pilot.behavior.found_below import FORGOTTEN_AFTER
from housefly.pilot.behavior.mission import VehicleStatus
from housefly.pilot.behavior.navigator import Navigator
from housefly.pilot.behavior.proposal import NOTHING, Look, MissionView, Proposal
from housefly.pilot.behavior.steered_landing import LAND, SETTLED, BlindPlan, SteeredLanding
from housefly.pilot.estimation.dead_reckoning import ReckonedPose

FARTHEST = 2.0
"""It moves no farther aside at a time [m]."""
WALL_MARGIN, SIGMAS = 0.1, 3.0
"""The hull keeps this from walls [m], and so many deviations of the place."""
REST_SPEED = 0.12
"""It lands only when slower than this [m/s]."""
SETTLED_AFTER = 15.0
"""So long after it set off its spot counts as reached however near it is [s]."""
MOVES_MAX = 5
"""It moves aside no more often: the sonar may be wrong."""
CLEAR_TIME = 0.5
"""The floor below must have shown for so long before the drone lands [s]."""
GONE_AFTER = FORGOTTEN_AFTER + 0.3
"""So long after something showed last its place counts as taken all the same [s]."""
LOOK_PERIOD = 1.0
"""How often another place is looked for [s]."""
LOWEST = 1.0
"""It holds no lower than this: the sonar's beam is a cone [m]."""
NOWHERE = Words("no clear place to land within 2 m: holding by the drone's own motion")
_STEP = 0.1
"""Over so long the velocity of the setpoint is taken [s]."""
_UNTOLD = Words("the drone does not tell how it moves")


class BlindLanding:
    """Watches the floor below a drone that the gate holds, or lands, without tracking.

    Args:
        mission: whose drone; it knows what the sonar shows.
        navigator: who knows walls, people and things.
        paper: in mode paper the drone lands where it is.
        limits: how high to hold.
    """

    def __init__(
        self, mission: MissionView, navigator: Navigator, paper: bool, limits: LimitsConfig
    ) -> None:
        self._mission, self._people, self._paper = mission, navigator.people, paper
        self._highest = limits.height_max
        self._landing: SteeredLanding | None = None
        self._blocked_at = self._shown_at = self._look_at = -inf
        self._told = UNSAID
        self.plan = LAND

    def propose(self, look: Look) -> Proposal:
        """Look below once, and say what is done about it; ``plan`` says what the gate flies."""
        events = self._events(look.vehicle)
        return Proposal(events=tuple(events)) if events else NOTHING

    def _events(self, vehicle: VehicleStatus) -> list[Event]:
        here = vehicle.reckoned
        if self._paper or here is None or vehicle.status is not DroneStatus.FLYING:
            return self._end(vehicle, _UNTOLD)
        below = self._below(vehicle, here)
        fault = below or self._unsettled(vehicle, here)
        if not fault:
            return self._end(vehicle, UNSAID)
        if why := self._must_land(vehicle, here):
            return self._end(vehicle, why)
        events = self._tell(vehicle, fault)
        landing = self._landing or self._held(vehicle, here)
        if below and self._may_look(vehicle, here, landing):
            landing, moved = self._aside(vehicle, here, landing)
            events.extend(moved)
        self._landing = landing
        self.plan = self._planned(vehicle, here, landing, fault)
        return events

    def _below(self, vehicle: VehicleStatus, here: ReckonedPose) -> Words:
        """Return who or what stands below, in words, or UNSAID."""
        place = here.position[:2]
        near = self._people.separation(place, (0.0, 0.0), vehicle.now, 0.0)
        person = Words("{who} is below", who=called(near.name)) if near.now < 0.0 else UNSAID
        fault = person or self._mission.fault_below(place, vehicle)
        is_furniture = not fault and self._people.is_above_furniture(place, self._people.hull)
        if is_furniture:
            fault = Words("furniture stands below")
        if not fault and self._mission.sonar.found:
            fault = Words("looking below")
        if fault:
            self._blocked_at = vehicle.now
        if person or self._mission.sonar.found or is_furniture:
            self._shown_at = vehicle.now
        return fault

    def _unsettled(self, vehicle: VehicleStatus, here: ReckonedPose) -> Words:
        """Return why a drone with nothing below does not land yet, in words, or UNSAID."""
        if self._landing is None:
            return UNSAID
        if not self._is_there(vehicle, here, self._landing):
            return Words("moving aside")
        return Words("looking below") if vehicle.now - self._blocked_at < CLEAR_TIME else UNSAID

    @staticmethod
    def _is_there(vehicle: VehicleStatus, here: ReckonedPose, landing: SteeredLanding) -> bool:
        """Return whether the drone rests at its spot; where it never does, it is near enough."""
        if landing.moves and vehicle.now - landing.at < SETTLED_AFTER:
            is_off = distance(here.position[:2], landing.spot) > SETTLED
            if is_off or hypot(*here.velocity) > REST_SPEED:
                return False
        return landing.sinks(vehicle.now, here.position[:2])

    def _must_land(self, vehicle: VehicleStatus, here: ReckonedPose) -> Words:
        """Return why it cannot be held where it is, in words, or UNSAID."""
        if self._mission.insists:
            return Words("ordered to")
        if not vehicle.consistency.flow_believed:
            return Words("its own motion is in doubt")
        if self._landing is not None and self._landing.moves > MOVES_MAX:
            return Words("its sonar shows something everywhere")
        x, y, z = here.position
        spare = self._people.open_air((x, y), z) - self._people.hull
        is_near = spare < WALL_MARGIN + SIGMAS * here.deviation
        return Words("a wall may be near") if is_near else UNSAID

    def _held(self, vehicle: VehicleStatus, here: ReckonedPose) -> SteeredLanding:
        """Return the landing that stays where the drone is."""
        x, y, z = here.position
        height = min(max(z, LOWEST), max(self._highest, LOWEST))
        return SteeredLanding((x, y), height, vehicle.now, (x, y))

    def _may_look(
        self, vehicle: VehicleStatus, here: ReckonedPose, landing: SteeredLanding
    ) -> bool:
        """Return whether another place is to be looked for.

        The drone is landing, at rest and not stopped; what showed a moment ago may have gone.
        """
        if self._mission.state.stopped:
            return False
        since = vehicle.now - self._shown_at
        is_shown = since == 0.0 or since > GONE_AFTER
        is_due = vehicle.landing_waits and vehicle.now >= self._look_at
        return is_due and is_shown and self._is_there(vehicle, here, landing)

    def _aside(
        self, vehicle: VehicleStatus, here: ReckonedPose, landing: SteeredLanding
    ) -> tuple[SteeredLanding, list[Event]]:
        """Return the landing at another place, where there is one, and what is said."""
        self._look_at = vehicle.now + LOOK_PERIOD
        (x, y, z), found = here.position, (*self._mission.found, here.position[:2])
        spot = self._people.clear_floor((x, y), z, vehicle.now, FARTHEST, BESIDE_SPEED, found)
        if spot is None:
            return landing, self._nowhere(vehicle)
        text = Words(
            "moving {d} m aside by the drone's own motion, to land",
            d=figure(distance((x, y), spot), ".1f"),
        )
        event = Event(vehicle.now, Severity.INFO, EventCode.LANDING_ELSEWHERE, text)
        return landing.moved((x, y), vehicle.now, spot), [event]

    def _planned(
        self, vehicle: VehicleStatus, here: ReckonedPose, landing: SteeredLanding, fault: Words
    ) -> BlindPlan:
        target, later = landing.setpoint(vehicle.now), landing.setpoint(vehicle.now + _STEP)
        velocity = (later[0] - target[0]) / _STEP, (later[1] - target[1]) / _STEP
        may_sink = not self._mission.sonar.found
        return BlindPlan(fault, target, velocity, landing.height, here, may_sink)

    def _tell(self, vehicle: VehicleStatus, fault: Words) -> list[Event]:
        if self._told or not vehicle.landing_waits:
            return []
        self._told = fault
        text = Words("not landing: {why}. Press Land to land here all the same", why=fault)
        return [Event(vehicle.now, Severity.WARNING, EventCode.LANDING_BLOCKED, text)]

    def _nowhere(self, vehicle: VehicleStatus) -> list[Event]:
        if self._told == NOWHERE:
            return []
        self._told = NOWHERE
        return [Event(vehicle.now, Severity.WARNING, EventCode.LANDING_BLOCKED, NOWHERE)]

    def _end(self, vehicle: VehicleStatus, why: Words) -> list[Event]:
        """Let the drone land, or go on; told where the floor below is not what lets it."""
        was_told, self._told = self._told, UNSAID
        self.plan, self._landing, self._blocked_at = LAND, None, -inf
        is_flying = vehicle.status is DroneStatus.FLYING
        if not (why and was_told and vehicle.landing_forced and is_flying):
            return []
        text = Words("landing all the same: {why}", why=why)
        return [Event(vehicle.now, Severity.WARNING, EventCode.LANDING_INSISTED, text)]
