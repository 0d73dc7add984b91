"""What the console's server knows at one moment, and what of it is still of the present."""

from __future__ import annotations

from dataclasses import dataclass, field
from math import dist, inf

from housefly.geometry import Vec2
from housefly.hub.api.pilot_queries import PreflightView, RoomView
from housefly.messages import (
    DroneStatus,
    Estimate,
    LinkStatus,
    Phase,
    PilotStep,
    SafetyMode,
    Telemetry,
)
from housefly.messages.sensing import AIRBORNE_STATUSES
from housefly.messages.words import Number, Words, figure
from housefly.pilot.behavior.origin import PAD_DISTANCE_MAX
from housefly.tasks.api.values import TaskLook
from housefly.web.messages.verdict_message import Standing, StopView
from housefly.web.status.last_status import TELEMETRY_AGE_MAX, LastStatus

PILOT_TIMEOUT = 2.0
"""A pilot that was not heard for longer may have ended [s]."""
_POSE_AGE_MAX = 0.5
"""An older place is not shown as the present [s]."""
_AT_TASK = (Phase.HOLDING, Phase.OUTBOUND)
"""What the pilot does while a task looks; who turns or follows flies."""
_LOW = 0.3
"""Nothing gets under, or caught in, what is lower than this [m]."""


@dataclass(frozen=True, slots=True)
class ConsoleKnowledge:
    """Everything that a verdict is made of.

    Attributes:
        now: on the server's clock, which is the pilot's too [s].
        step, step_age: the newest step of the pilot, and for how long it has been silent [s].
        link: health of its wires.
        preflight: what the pre-flight checks found.
        room: what it flies in.
        stop: the STOP that holds.
        pilot, control: number and name of who has control.
        task_subject: what the task that flies is about, as people call it, or "".
        task_look: what that task shows people now, or None.
        task_is_paused: whether it waits for a person to let it go on.
        unix: the moment ``now`` as Unix time [s].
        hand_motion: who moves the drone by hand, "" without a name; None while nobody does.
        told_last: what the drone said last, also through a pilot before this one.
        has_drone: whether there is a drone at all.
    """

    now: float
    step: PilotStep | None = None
    step_age: float = inf
    link: LinkStatus | None = None
    preflight: PreflightView = field(default_factory=PreflightView)
    room: RoomView | None = None
    stop: StopView = field(default_factory=StopView)
    pilot: int | None = None
    control: str = ""
    task_subject: str = ""
    task_look: TaskLook | None = None
    task_is_paused: bool = False
    unix: float = 0.0
    hand_motion: str | None = None
    told_last: LastStatus = field(default_factory=LastStatus)
    has_drone: bool = True

    @property
    def pilot_is_heard(self) -> bool:
        """Whether the step is of the present."""
        return self.step is not None and self.step_age <= PILOT_TIMEOUT

    @property
    def telemetry(self) -> Telemetry | None:
        """The drone's newest report that this pilot knows, however old."""
        return self.step.inputs.telemetry if self.step else None

    @property
    def telemetry_age(self) -> float:
        """Age of the drone's last word [s]; of a drone never heard, since when that is so."""
        told = self.telemetry
        if self.step is None:
            return inf
        if told is None or told.status is DroneStatus.UNKNOWN:
            return max(0.0, self.step.now - self.drone.at) + self.step_age
        return max(0.0, self.step.now - told.received_at) + self.step_age

    @property
    def drone_is_heard(self) -> bool:
        """Whether the drone's word is of the present."""
        limits = self.room.limits if self.room else {}
        longest = limits.get("telemetry_age", TELEMETRY_AGE_MAX)
        told = self.telemetry
        heard = told is not None and told.status is not DroneStatus.UNKNOWN
        return self.pilot_is_heard and heard and self.telemetry_age <= longest

    @property
    def drone(self) -> LastStatus:
        """What the drone said last, however long ago, and to whichever pilot."""
        return self.told_last.after(self.step) if self.step else self.told_last

    @property
    def last_status(self) -> DroneStatus:
        """What the drone said last that it does."""
        return self.drone.status

    @property
    def airborne(self) -> bool | None:
        """Whether it flies; None when nobody knows."""
        told = self.telemetry
        return told.status in AIRBORNE_STATUSES if told and self.drone_is_heard else None

    @property
    def may_be_airborne(self) -> bool:
        """Whether one must reckon with a drone in the air."""
        return self.drone.may_be_airborne if self.airborne is None else self.airborne

    @property
    def is_showing(self) -> bool:
        """Whether the drone holds its camera on something for people, and is not hurried on."""
        if self.step is None or not self.airborne:
            return False
        phase = self.step.outputs.phase
        return phase is Phase.LOOKING or (phase in _AT_TASK and self.task_look is not None)

    @property
    def is_cut(self) -> bool:
        """Whether its motors were cut, as far as was heard."""
        cutting = self.step is not None and self.step.outputs.safety is SafetyMode.CUT
        return cutting or self.last_status is DroneStatus.EMERGENCY

    @property
    def estimate(self) -> Estimate | None:
        """Where the drone was seen last, however long ago."""
        return self.step.outputs.estimate if self.step else None

    @property
    def pose_age(self) -> float:
        """For how long tracking has not seen the drone [s]."""
        return self.estimate.pose_age + self.step_age if self.estimate else inf

    @property
    def is_seen(self) -> bool:
        """Whether the drone's place is of the present."""
        return self.pilot_is_heard and self.pose_age <= _POSE_AGE_MAX

    @property
    def position(self) -> Vec2 | None:
        """Where it is, or None when nobody sees it now."""
        return self.estimate.position[:2] if self.estimate and self.is_seen else None

    @property
    def pad_distance(self) -> float | None:
        """How far it is from its pad [m], or None when that is not known."""
        if self.position is None or self.room is None:
            return None
        return dist(self.position, self.room.home)

    @property
    def standing(self) -> Standing:
        """Where the drone is."""
        if self.airborne is None:
            return Standing.UNKNOWN
        if self.airborne:
            return Standing.IN_AIR
        if self.pad_distance is None:
            return Standing.ON_GROUND
        return Standing.ON_PAD if self.pad_distance <= PAD_DISTANCE_MAX else Standing.OFF_PAD

    @property
    def caught_in(self) -> str:
        """Name of the furniture under, on or in which it stands, or ""."""
        place = self.position
        if place is None or self.room is None or self.airborne is not False:
            return ""
        standing = (one for one in self.room.outlines if not one.tracked and one.top > _LOW)
        return next((one.thing for one in standing if _inside(place, one.corners)), "")


def place_in_words(known: ConsoleKnowledge) -> Words:
    """Return where the drone is, in words."""
    match known.standing:
        case Standing.ON_PAD:
            return Words("on the pad")
        case Standing.OFF_PAD:
            return _off_pad(figure(known.pad_distance or 0.0, ".1f"), known.caught_in)
        case Standing.ON_GROUND:
            return Words("on the ground; {why}", why=last_seen(known))
        case Standing.IN_AIR if known.is_seen:
            return Words("in the air")
        case Standing.IN_AIR:
            return Words("in the air; {why}", why=last_seen(known))
        case Standing.UNKNOWN:
            return Words("not known")


def _off_pad(away: Number, thing: str) -> Words:
    if not thing:
        return Words("on the ground, {d} m from the pad", d=away)
    return Words("on the ground, {d} m from the pad, under, on or in {thing}", d=away, thing=thing)


def last_seen(known: ConsoleKnowledge) -> Words:
    """Return since when tracking has not seen "it", the drone, in words."""
    if known.estimate is None:
        return Words("tracking has not seen it yet")
    if known.pose_age < 1.0:
        return Words("tracking does not see it")
    return Words("tracking saw it last {n} s ago", n=figure(known.pose_age, ".0f"))


def drone_last_seen(known: ConsoleKnowledge) -> Words:
    """Return the same of "the drone"."""
    if known.estimate is None:
        return Words("tracking has not seen the drone yet")
    if known.pose_age < 1.0:
        return Words("tracking does not see the drone")
    return Words("tracking saw the drone last {n} s ago", n=figure(known.pose_age, ".0f"))


def _inside(point: Vec2, corners: tuple[Vec2, ...]) -> bool:
    """Return whether a point lies in a polygon: it crosses an odd number of edges on its right."""
    x, y = point
    odd = False
    x0, y0 = corners[-1]
    for x1, y1 in corners:
        if (y0 > y) != (y1 > y) and x < x0 + (y - y0) * (x1 - x0) / (y1 - y0):
            odd = not odd
        x0, y0 = x1, y1
    return odd
