"""What a monitor sees of the mission, and what it proposes to do about it."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import NamedTuple, Protocol

from housefly.config.airframe import Airframe
from housefly.geometry import Vec2
from housefly.messages.event_code import EventCode
from housefly.messages.flight import Event, Phase, Severity
from housefly.messages.words import Words
from housefly.pilot.behavior.found_below import FoundBelow
from housefly.pilot.behavior.height_gap import SonarMonitor
from housefly.pilot.behavior.mission import (
    STAY,
    Mission,
    MissionState,
    Refused,
    TrackingTask,
    VehicleStatus,
)
from housefly.pilot.behavior.path_progress import TrajectorySetpoint

AIRBORNE_PHASES = frozenset({Phase.OUTBOUND, Phase.LOOKING, Phase.HOLDING, Phase.RETURNING})
"""Phases in which the pilot moves the drone."""


class MissionChange(Enum):
    """What a monitor may propose."""

    RETIME = "show when the way will be flown"
    HOLD = "come to rest and wait"
    GO_ON = "fly on along the same way"
    GO_AROUND = "fly another way to the same goal"
    DESCEND = "sink above where it lands, or rise again"
    LAND_ELSEWHERE = "fly to another place and land there"
    MAKE_WAY = "leave the place to somebody"
    GO_BACK = "return to the place that was left"
    MOVE = "follow a person's hand"
    LAND = "land here"


@dataclass(frozen=True, slots=True)
class Proposal:
    """The mission as a monitor wants it, and what people should know.

    Attributes:
        change: what the drone is to do; None to leave the mission as it is.
        reason: why, as a code; None without a change.
        task: what to track instead, None for the same as before.
        state: of the mission instead, None for the same as before.
        events: for people; none for what was told a moment ago.
    """

    change: MissionChange | None = None
    reason: EventCode | None = None
    task: TrackingTask | None = None
    state: MissionState | None = None
    events: tuple[Event, ...] = ()


NOTHING = Proposal()
"""Leave everything as it is."""


def news(code: EventCode, severity: Severity, text: Words, now: float) -> Proposal:
    """Return the proposal that only tells people something [s]."""
    return Proposal(events=(Event(now, severity, code, text),))


def landing_here(
    state: MissionState, reason: EventCode, severity: Severity, text: Words, now: float
) -> Proposal:
    """Return the proposal to land here, told as a text [s]."""
    return Proposal(
        MissionChange.LAND,
        reason,
        TrackingTask(),
        state.entering(Phase.LANDING, now, STAY),
        (Event(now, severity, reason, text),),
    )


class Look(NamedTuple):
    """What a monitor looks at in one step, beside the mission.

    Attributes:
        vehicle: status and place of the drone.
        target: what was tracked in the last step, None while nothing was.
        silent: a situation silences the monitor: it keeps count, and proposes nothing.
        rate: at which the time of a trajectory in space is to pass, 0 to 1.
        share: of the cruise speed that people leave, 0 to 1.
    """

    vehicle: VehicleStatus
    target: TrajectorySetpoint | None = None
    silent: bool = False
    rate: float = 1.0
    share: float = 1.0


class Monitor(Protocol):
    """Watches one thing that may change a mission."""

    def propose(self, look: Look) -> Proposal:
        """Look once, and return what to do about it."""
        ...


class MissionView(Protocol):
    """The mission as a monitor sees it: nothing here changes it."""

    @property
    def state(self) -> MissionState:
        """How far the mission has come."""
        ...

    @property
    def task(self) -> TrackingTask:
        """What the drone tracks."""
        ...

    @property
    def airframe(self) -> Airframe:
        """Of the drone."""
        ...

    @property
    def sonar(self) -> SonarMonitor:
        """Whether something stands below that only the drone's own sensor shows."""
        ...

    @property
    def found(self) -> FoundBelow:
        """Where that was so when a landing was tried."""
        ...

    @property
    def insists(self) -> bool:
        """Whether somebody has ordered a landing that waits to go on."""
        ...

    def fault_below(self, place: Vec2, vehicle: VehicleStatus) -> Words:
        """Return what the drone's own sensor shows below a landing at a place [m], or UNSAID."""
        ...

    def way(self, mission: Mission, vehicle: VehicleStatus) -> TrackingTask | Refused | None:
        """Return the task of flying to the goal of a mission; None when it has none."""
        ...

    def other_way(self, vehicle: VehicleStatus) -> TrackingTask | Refused:
        """Return a new task for the mission under way, from where the drone is."""
        ...

    def halted(self, vehicle: VehicleStatus) -> TrackingTask:
        """Return the task of coming to rest: on a trajectory in space along its own curve."""
        ...

    def held_here(self, vehicle: VehicleStatus) -> TrackingTask:
        """Return the task of holding the place where the drone comes to rest."""
        ...

    def kept_height(self, vehicle: VehicleStatus) -> float | None:
        """Return the height to keep where a trajectory in space ends early [m]; else None."""
        ...
