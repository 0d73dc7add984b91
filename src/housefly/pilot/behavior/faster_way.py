"""Takes a faster way in flight when something that stood in the room is gone."""

from __future__ import annotations

from math import inf

from housefly.messages.event_code import EventCode
from housefly.messages.flight import Event, Severity
from housefly.messages.words import Words, figure
from housefly.pilot.behavior.collision_monitor import ON_THE_WAY
from housefly.pilot.behavior.mission import TrackingTask
from housefly.pilot.behavior.navigator import Navigator
from housefly.pilot.behavior.path_profile import PathProfile
from housefly.pilot.behavior.proposal import NOTHING, Look, MissionChange, MissionView, Proposal
from housefly.pilot.behavior.trajectory_progress import is_in_space
from housefly.pilot.planning.trajectory.kinematic_state import TICK

PERIOD = 1.0
"""How often a faster way is asked for [s]."""
EARLIER, EARLIER_SHARE = 1.0, 0.1
"""It must arrive so much earlier [s], and by this share of the time that is left."""


class FasterWayMonitor:
    """Watches for ways that open while a trajectory in space is flown."""

    def __init__(self, mission: MissionView, navigator: Navigator) -> None:
        self._mission, self._navigator = mission, navigator
        self._profile: PathProfile | None = None
        self._openings = 0
        self._asked_at = -inf

    def propose(self, look: Look) -> Proposal:
        """Look for a faster way, and take it."""
        vehicle, task, state = look.vehicle, self._mission.task, self._mission.state
        profile, self._profile = self._profile, task.profile
        if task.profile is None or task.profile is not profile or not is_in_space(profile):
            # A new way has been planned with what is known.
            self._openings = self._navigator.openings
            return NOTHING
        is_ours = state.phase in ON_THE_WAY and not state.stopped and not look.silent
        is_open = self._navigator.openings != self._openings
        if not (is_ours and is_open and task.is_following and vehicle.reference is not None):
            return NOTHING
        if vehicle.now - self._asked_at < PERIOD:
            return NOTHING
        self._asked_at, self._openings = vehicle.now, self._navigator.openings
        left = TICK * (len(profile.motion) - 1) - vehicle.reference.scale.time
        other = self._mission.other_way(vehicle)
        enough = left - max(EARLIER, EARLIER_SHARE * left)
        if not isinstance(other, TrackingTask) or other.arrival >= enough:
            return NOTHING
        text = Words(
            "a way has become free that is {n} s faster: taking it",
            n=figure(left - other.arrival, ".0f"),
        )
        event = Event(vehicle.now, Severity.INFO, EventCode.DETOUR, text)
        return Proposal(MissionChange.GO_AROUND, event.code, other, events=(event,))
