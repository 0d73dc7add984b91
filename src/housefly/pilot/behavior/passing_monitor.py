"""Gets a trajectory in space past people who walk: on, slower, after a wait, or another way.

Who stands is in the way as things are (``collision_monitor``); who comes too near all the same is
made way for (``separation_monitor``).
"""

from __future__ import annotations

from dataclasses import replace
from math import inf

from housefly.messages.event_code import EventCode
from housefly.messages.flight import Event, Severity
from housefly.messages.obstacles import called
from housefly.messages.words import UNSAID, Words
from housefly.pilot.behavior.collision_monitor import ON_THE_WAY, RELAPSE_TIME
from housefly.pilot.behavior.mission import TrackingTask, VehicleStatus
from housefly.pilot.behavior.navigator import Navigator
from housefly.pilot.behavior.path_profile import PathProfile
from housefly.pilot.behavior.proposal import NOTHING, Look, MissionChange, MissionView, Proposal
from housefly.pilot.behavior.trajectory_profile import SpacePath, retimed
from housefly.pilot.behavior.trajectory_progress import is_in_space
from housefly.pilot.planning.space.passage import Passage, first_passage
from housefly.pilot.planning.space.passing import EARLIER, GIVE, Passing, PassingChoice, passed
from housefly.pilot.planning.trajectory.kinematic_state import TICK
from housefly.pilot.planning.trajectory.time_scale import TRAJECTORY_START, TimeScale

PERIOD = 0.1
"""How often people are looked at [s]."""
AROUND_PERIOD = 0.5
"""How often another way is asked for [s]."""


class PassingMonitor:
    """Watches people who walk."""

    def __init__(self, mission: MissionView, navigator: Navigator) -> None:
        self._mission, self._navigator = mission, navigator
        self._passing = Passing()
        self._profile: PathProfile | None = None
        self._waits: TrackingTask | None = None
        self._since = self._ended_at = self._asked_at = self._around_at = -inf
        self._begun_at = 0.0

    @property
    def rate(self) -> float:
        """At which a trajectory's time is to pass, 0 to 1."""
        return self._passing.rate

    @property
    def is_waiting(self) -> bool:
        """Whether the drone waits on its trajectory for somebody to pass."""
        return self._waits is not None and self._mission.task is self._waits

    def propose(self, look: Look) -> Proposal:
        """Look at people once, and say what to do about them."""
        vehicle, task, state = look.vehicle, self._mission.task, self._mission.state
        is_flown = task.profile is not None and is_in_space(task.profile)
        is_ours = state.phase in ON_THE_WAY and not state.stopped and not look.silent
        if not (is_flown and is_ours and (task.is_following or self.is_waiting)):
            self._forget()
            return NOTHING
        is_new = task.profile is not self._profile
        if not is_new and vehicle.now - self._asked_at < PERIOD - 1e-6:
            return NOTHING
        self._asked_at, self._profile = vehicle.now, task.profile
        if is_new:
            self._passing = Passing(around_at=self._passing.around_at)
            self._around_at = self._begun_at = vehicle.now
        # The reference is that of the last step: on a new trajectory it is at its beginning.
        is_begun = not is_new and vehicle.reference is not None
        scale = vehicle.reference.scale if is_begun and vehicle.reference else TRAJECTORY_START
        return self._decide(task, scale, vehicle)

    def _forget(self) -> None:
        self._passing, self._profile, self._waits = Passing(), None, None

    def _decide(self, task: TrackingTask, scale: TimeScale, vehicle: VehicleStatus) -> Proposal:
        assert task.profile is not None
        people = self._navigator.people
        is_free = self._passing.choice is not PassingChoice.WAIT and self._passing.rate >= 1.0
        if is_free and not len(people.walking(vehicle.now)):
            return NOTHING
        choices = self._navigator.passages(scale, task.profile, task.comfort, vehicle.now)
        other = self._other_way(task, scale, choices, vehicle)
        arrival = inf if other is None else other.arrival
        before = self._passing
        self._passing = passed(before, choices, arrival, vehicle.now)
        if self._passing.choice is PassingChoice.AROUND and other is not None:
            return self._go_around(other, vehicle)
        proposal = NOTHING
        if self._passing.choice is PassingChoice.WAIT and not self.is_waiting:
            proposal = self._wait(task, vehicle)
        elif self._passing.choice is PassingChoice.GO_ON and self.is_waiting:
            proposal = self._go_on(task, vehicle)
        if (before.choice, before.rate) == (self._passing.choice, self._passing.rate):
            return proposal
        task = proposal.task or task
        return self._retimed(proposal, task, first_passage(choices, GIVE), scale, vehicle)

    def _other_way(
        self, task: TrackingTask, scale: TimeScale, choices: list[Passage], vehicle: VehicleStatus
    ) -> TrackingTask | None:
        """Return another way, asked for now and then while people hold this one up."""
        assert task.profile is not None
        left = TICK * (len(task.profile.motion) - 1) - scale.time
        lax = first_passage(choices, GIVE)
        is_held_up = lax is None or lax.arrival > left + EARLIER
        if not is_held_up or vehicle.now - self._around_at < AROUND_PERIOD:
            return None
        self._around_at = vehicle.now
        found = self._mission.other_way(vehicle)
        return found if isinstance(found, TrackingTask) else None

    def _retimed(
        self,
        proposal: Proposal,
        task: TrackingTask,
        passage: Passage | None,
        scale: TimeScale,
        vehicle: VehicleStatus,
    ) -> Proposal:
        """Show the times at which the way is passed from now on, where they are known."""
        path, profile = task.path, self._profile
        if passage is None or profile is None or not isinstance(path, SpacePath):
            return proposal
        begin = vehicle.now - self._begun_at + passage.wait
        task = replace(task, path=retimed(path, profile.marks, scale.time, begin, passage.rate))
        if self._waits is not None:
            self._waits = task
        change = proposal.change or MissionChange.RETIME
        return replace(proposal, change=change, task=task)

    def _go_around(self, other: TrackingTask, vehicle: VehicleStatus) -> Proposal:
        self._waits = None
        text = Words("{who} walks into the way: going around", who=self._name(vehicle))
        event = Event(vehicle.now, Severity.INFO, EventCode.DETOUR, text)
        return Proposal(MissionChange.GO_AROUND, event.code, other, events=(event,))

    def _wait(self, task: TrackingTask, vehicle: VehicleStatus) -> Proposal:
        is_relapse = vehicle.now - self._ended_at < RELAPSE_TIME
        self._since = self._since if is_relapse else vehicle.now
        text = Words("{who} walks into the way: waiting", who=self._name(vehicle))
        self._waits = replace(task, halted=True, waiting=text, since=self._since)
        event = Event(vehicle.now, Severity.INFO, EventCode.WAY_BLOCKED, text)
        events = () if is_relapse else (event,)
        return Proposal(MissionChange.HOLD, event.code, self._waits, events=events)

    def _go_on(self, task: TrackingTask, vehicle: VehicleStatus) -> Proposal:
        self._waits, self._ended_at = None, vehicle.now
        text = Words("the way is free: going on")
        event = Event(vehicle.now, Severity.INFO, EventCode.GOING_ON, text)
        moving = replace(task, halted=False, waiting=UNSAID)
        return Proposal(MissionChange.GO_ON, event.code, moving, events=(event,))

    def _name(self, vehicle: VehicleStatus) -> str:
        """Return who walks and is nearest."""
        if vehicle.place is None:
            return Words("somebody")
        near = self._navigator.people.separation(
            vehicle.place, (0.0, 0.0), vehicle.now, 0.0, walking=True
        )
        return called(near.name) or Words("somebody")
